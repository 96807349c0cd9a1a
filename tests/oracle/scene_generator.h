#pragma once

#include <cstdint>
#include <string>

namespace glissade::oracle {

/// Writes scene number `index` of a seed into the folder: `scenario.json` and its mesh files. Sizes go from
/// 1e-6 to 1e6 m; the kinds are clutter, windows in thin walls, slots and round holes with tight clearances,
/// bodies that share planes, hollow bodies with the object in the cavity, and turns by half a circle. Mesh files
/// are text and binary STL, OBJ and GLB. Returns the scene's kind and size in words.
std::string writeScene(const std::string& folder, std::uint64_t seed, std::uint64_t index);

}  // namespace glissade::oracle
