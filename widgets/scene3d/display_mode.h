#pragma once

namespace glissade {

/// How rigid bodies are drawn. A property of the view: planning does not know it.
enum class DisplayMode {
  ShadedWithEdges,  ///< opaque surfaces and their feature edges
  Shaded,           ///< opaque surfaces only
  SeeThrough,       ///< transparent surfaces and all feature edges
  Wireframe         ///< feature edges only; hidden ones are dashed
};

}  // namespace glissade
