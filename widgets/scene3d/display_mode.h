#pragma once

namespace glissade {

/// How rigid bodies are drawn. It is a property of the view, independent of planning.
enum class DisplayMode {
  ShadedWithEdges,  ///< opaque surfaces and their feature edges
  Shaded,           ///< opaque surfaces only
  SeeThrough,       ///< transparent surfaces and all feature edges
  Wireframe         ///< feature edges only; hidden ones are dashed
};

}  // namespace glissade
