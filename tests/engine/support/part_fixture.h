#pragma once

#include <string>

#include "engine/geometry/primitives.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade::test {

inline std::string toObj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  for (const Vector3& v : mesh.vertices) text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

/// The part files of a product, in millimetres: an open-topped tray with a block in it, far from the
/// origin of the assembly.
class TrayProduct {
 public:
  const Vector3 centre{2000.0, -3000.0, 500.0};  ///< of the tray, mm
  const Vector3 blockSize{60.0, 40.0, 30.0};

  TrayProduct() : tray(folder.write("tray.obj", toObj(trayMesh()))), block(writeBlock("block.obj", Vector3::Zero())) {}

  /// A block as the one in the tray, so far from there.
  std::string writeBlock(const std::string& name, const Vector3& offset) const {
    return folder.write(name, toObj(transformed(makeBox(blockSize), Pose::translation(centre + offset))));
  }

  TemporaryFolder folder;
  const std::string tray;
  const std::string block;

 private:
  TriangleMesh trayMesh() const {
    TriangleMesh mesh;
    const auto add = [&](const Vector3& size, const Vector3& offset) {
      append(mesh, transformed(makeBox(size), Pose::translation(centre + offset)));
    };
    add({110, 90, 5}, {0, 0, -25});
    for (const double side : {-1.0, 1.0}) {
      add({5, 80, 60}, {side * 52.5, 0, 7.5});
      add({110, 5, 60}, {0, side * 42.5, 7.5});
    }
    return mesh;
  }
};

}  // namespace glissade::test
