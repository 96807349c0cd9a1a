#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/assembly/missing_shape.h"
#include "engine/assembly/occurrence.h"
#include "engine/base/diagnostic.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/formats/mesh_content.h"

namespace glissade {

enum class UpAxis { Y, Z };

/// A file that geometry comes from.
struct Asset {
  std::string id;
  std::string path;  ///< relative to the scenario's folder or absolute, '/' separated; assetFile() finds it
  /// Of the content that was loaded, or when the scenario was saved; empty: unknown. Where a STEP file names others for
  /// its parts, of their contents, too.
  std::string sha256;
  double unit = 1.0;  ///< metres per unit of the file (the chosen interpretation)
  UpAxis up = UpAxis::Z;
  double deflection = 0.0;  ///< metres that triangles may be off a STEP surface; 0: by the size of each part
  bool closeHoles = false;  ///< of a mesh: planar holes are closed
};

/// A mesh file as one body; of an OBJ file one of its groups ("part"), or all of them (`groups`, `part` empty): bodies
/// "<body id>/<group>", or the one compound object.
struct MeshGeometry {
  std::string asset;
  bool groups = false;
  std::string part{};
};
/// All links (fixed joints) of a URDF file: bodies "<body id>/<link>", or the one compound object.
struct UrdfGeometry {
  std::string asset;
};
/// A part of a STEP file where its assembly has it, an assembly in it ("pump" has "pump/rotor"), or (empty)
/// all of it: bodies "<body id>/<part>" where it is several, or the one compound object.
struct StepGeometry {
  std::string asset;
  std::string part;
  bool asOne = false;  ///< each product of several solids is one part; else its solids are parts
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

/// What a geometry names, as read. The frame F of its parts is that of the body.
struct LoadedGeometry {
  std::vector<Occurrence> parts;
  Vector3 vertexMean = Vector3::Zero();  ///< of a mesh file's vertices, as imported, in the body's frame
  /// Of the bytes that it was read from, and of the files that a STEP file names; empty for primitives.
  std::string sha256;
  Warnings warnings;               ///< what was lost, left out or added in reading it
  std::vector<GroupRun> groups{};  ///< of a mesh file as it is (GeometryLoader::files())
  MissingShapes missing{};         ///< of the whole file; there is a warning of each
};
using LoadedGeometryPtr = std::shared_ptr<const LoadedGeometry>;
/// By what was asked for: a file and how it is interpreted, or a primitive's sizes.
using GeometryCache = std::map<std::string, LoadedGeometryPtr>;

}  // namespace glissade
