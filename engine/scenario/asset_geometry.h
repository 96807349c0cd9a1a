#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// One rigid part of a body's or the object's geometry.
struct GeometryPart {
  std::string name;  ///< of the URDF link; empty where there is only one part
  TriangleMesh mesh;
  Pose X_BP;
  std::optional<Colour> colour;
  Vector3 vertexMean = Vector3::Zero();  ///< of a mesh file's vertices as imported, in P
};

/// Imports the geometry that a scenario names. The scenario outlives it.
class GeometryLoader {
 public:
  /// `file` is the scenario's, for messages only; assets are relative to `folder`.
  GeometryLoader(const Scenario& scenario, std::string folder, std::string file);

  Result<std::vector<GeometryPart>> load(const Geometry& geometry);

  /// Of all files loaded so far.
  Warnings& warnings() { return warnings_; }

 private:
  const Asset& assetById(const std::string& id) const;
  Result<std::string> fileOf(const Asset& asset);
  Result<std::vector<GeometryPart>> loadMesh(const std::string& id);
  Result<std::vector<GeometryPart>> loadUrdf(const std::string& id);

  const Scenario& scenario_;
  std::string folder_;
  std::string file_;
  Warnings warnings_;
};

/// The object as one mesh about its reference point.
TriangleMesh objectMesh(const ObjectDescription& object, const std::vector<GeometryPart>& parts);

/// Bounding box of all parts, in their body's frame.
Box3 boxOf(const std::vector<GeometryPart>& parts);

/// Takes file coordinates to ours: metres, z up.
TriangleMesh interpreted(const TriangleMesh& mesh, double unit, UpAxis up);

}  // namespace glissade
