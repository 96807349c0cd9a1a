#pragma once

#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::samples {

/// Coordinates are rounded to 10 nm, so that the file does not depend on the compiler.
inline std::string objText(const TriangleMesh& mesh) {
  std::string text = "# metres, z up\n";
  const auto rounded = [](double value) { return toText(std::round(value * 1e8) / 1e8); };
  for (const Vector3& v : mesh.vertices) {
    text += "v " + rounded(v.x()) + " " + rounded(v.y()) + " " + rounded(v.z()) + "\n";
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  }
  return text;
}

/// Writes each mesh as FOLDER/NAME. Returns the exit code of the program.
inline int writeParts(const std::string& folder, const std::vector<std::pair<std::string, TriangleMesh>>& parts) {
  for (const auto& [name, mesh] : parts) {
    if (const auto saved = writeFileAtomically(folder + "/" + name, objText(mesh)); !saved) {
      std::cerr << toString(saved.error()) << "\n";
      return 1;
    }
  }
  return 0;
}

}  // namespace glissade::samples
