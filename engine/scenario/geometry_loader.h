#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What a geometry of this scenario is found under in a GeometryCache: equal where the same would be read.
std::string geometryKey(const Geometry& geometry, const Scenario& scenario, const std::string& folder);

/// Reads the geometry that a scenario names; what was read before, and what several bodies name, once.
/// Refers to the scenario.
class GeometryLoader {
 public:
  /// Assets are relative to `folder`; `file` is used in messages only. What is in `known` is not read again.
  GeometryLoader(const Scenario& scenario, std::string folder, std::string file, GeometryCache known);

  /// Errors are MalformedInput with the file that they are in.
  Result<LoadedGeometryPtr> load(const Geometry& geometry);

  /// What was asked for.
  GeometryCache& loaded() { return loaded_; }
  /// Files that have changed since the scenario was saved.
  Warnings& warnings() { return warnings_; }

 private:
  Result<LoadedGeometry> read(const Geometry& geometry);
  Result<std::string> fileOf(const Asset& asset);
  Result<LoadedGeometry> readMesh(const Asset& asset);
  Result<LoadedGeometry> readUrdf(const Asset& asset);

  const Scenario& scenario_;
  std::string folder_;
  std::string file_;
  GeometryCache known_;
  GeometryCache loaded_;
  Warnings warnings_;
};

/// The object as one mesh about its reference point.
TriangleMesh objectMesh(const ObjectDescription& object, const LoadedGeometry& geometry);

/// Bounding box of all parts, in their body's frame.
Box3 boxOf(const LoadedGeometry& geometry);

/// Takes file coordinates to ours: metres, z up.
TriangleMesh interpreted(const TriangleMesh& mesh, double unit, UpAxis up);

}  // namespace glissade
