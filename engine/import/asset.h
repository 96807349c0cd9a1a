#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/base/enum_names.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/formats/mesh_content.h"
#include "engine/model/missing_shape.h"
#include "engine/model/occurrence.h"

namespace glissade {

enum class UpAxis { Y, Z };
inline constexpr EnumNames<UpAxis, 2> kUpAxisNames{{"y", "z"}};

/// A file that contains geometry.
struct Asset {
  std::string id;
  std::string path;  ///< relative to the scenario's folder, or absolute, with '/' as separator; see assetFile()
  /// Hash of the loaded content, or of the content when the scenario was saved; empty: unknown. If a STEP file names
  /// other files for its parts, their contents are included.
  std::string sha256;
  double unit = 1.0;  ///< metres per unit of the file (the chosen interpretation)
  UpAxis up = UpAxis::Z;
  double deflection = 0.0;  ///< deflection of triangles from a STEP surface, metres; 0: chosen by the size of each part
  bool closeHoles = false;  ///< planar holes of a mesh are closed
};

/// A mesh file as one body; one group of an OBJ file (`part`); or all groups (`groups`, `part` empty): bodies "<body
/// id>/<group>", or the one compound object.
struct MeshGeometry {
  std::string asset;
  bool groups = false;
  std::string part{};
};
/// All links (fixed joints) of a URDF file: bodies "<body id>/<link>", or the one compound object.
struct UrdfGeometry {
  std::string asset;
};
/// A part of a STEP file at its place in the assembly, an assembly ("pump" contains "pump/rotor"), or the whole file
/// (empty): bodies "<body id>/<part>" if there are several, or the one compound object.
struct StepGeometry {
  std::string asset;
  std::string part;
  bool asOne = false;  ///< each product with several solids is one part; else its solids are parts
};
struct BoxGeometry {
  Vector3 size;
};
struct CylinderGeometry {
  double radius;
  double length;
};
struct SphereGeometry {
  double radius;
};
using Geometry = std::variant<MeshGeometry, UrdfGeometry, StepGeometry, BoxGeometry, CylinderGeometry, SphereGeometry>;

/// The geometry that was read. The frame F of its parts is that of the body.
struct LoadedGeometry {
  std::vector<Occurrence> parts;
  Vector3 vertexMean = Vector3::Zero();  ///< mean of a mesh file's vertices, as imported, in the body's frame
  /// Hash of the bytes that were read, and of the files that a STEP file names; empty for primitives.
  std::string sha256;
  Warnings warnings;               ///< losses, omissions and additions during reading
  std::vector<GroupRun> groups{};  ///< groups of a mesh file without changes (GeometryLoader::files())
  MissingShapes missing{};         ///< missing shapes of the whole file; each has a warning
};
using LoadedGeometryPtr = std::shared_ptr<const LoadedGeometry>;
/// Keyed by a file and its interpretation, or by the sizes of a primitive.
using GeometryCache = std::map<std::string, LoadedGeometryPtr>;

}  // namespace glissade
