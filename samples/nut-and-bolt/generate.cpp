// Writes the nut and the bolt of this sample.
//
// usage: generate-nut-and-bolt FOLDER
#include <iostream>
#include <string>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "samples/nut-and-bolt/shapes.h"

namespace {

using namespace glissade;

std::string objText(const TriangleMesh& mesh) {
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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: generate-nut-and-bolt FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  for (const auto& [name, mesh] :
       {std::pair("bolt.obj", nut_and_bolt::bolt()), std::pair("nut.obj", nut_and_bolt::nut())}) {
    if (const auto saved = writeFileAtomically(folder + "/" + name, objText(mesh)); !saved) {
      std::cerr << toString(saved.error()) << "\n";
      return 1;
    }
  }
  return 0;
}
