#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/import/file_content.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// The id of the asset that a geometry is read from; null for primitives.
const std::string* assetOf(const Geometry& geometry);

/// What a geometry of this scenario is found under in a GeometryCache: equal where the same would be read.
std::string geometryKey(const Geometry& geometry, const Scenario& scenario, const std::string& folder);

/// Reads the geometry that a scenario names; what was read before, and what several bodies name, once.
/// Refers to the scenario.
class GeometryLoader {
 public:
  /// Assets are relative to `folder`; `file` is used in messages only. What is in `known` is not read again.
  GeometryLoader(const Scenario& scenario, std::string folder, std::string file, GeometryCache known,
                 StopToken stop = {});

  /// Errors are MalformedInput with the file that they are in, or Interrupted where it was stopped.
  Result<LoadedGeometryPtr> load(const Geometry& geometry);

  /// Writes into the scenario's assets the hashes of the bytes that their geometry was read from.
  void noteHashes(Scenario& scenario) const;

  /// What was asked for.
  GeometryCache& loaded() { return loaded_; }
  /// Files that have changed since the scenario was saved, and what was lost in reading one.
  Warnings& warnings() { return warnings_; }

 private:
  Result<LoadedGeometry> read(const Geometry& geometry);
  Result<FileContent> readAsset(const Asset& asset);
  void noteHash(const Asset& asset, const std::string& file, const std::string& hash);
  Result<LoadedGeometry> readMesh(const Asset& asset);
  Result<LoadedGeometry> readUrdf(const Asset& asset);
  Result<LoadedGeometry> readStep(const Asset& asset);
  Result<LoadedGeometry> partOf(const StepGeometry& step);
  void takeWarnings(const LoadedGeometry& geometry);
  Outcome checkOwnUnit(const Asset& asset, const std::string& kind) const;

  const Scenario& scenario_;
  std::string folder_;
  std::string file_;
  GeometryCache known_;
  StopToken stop_;
  GeometryCache loaded_;
  std::map<std::string, std::string> hashes_;  ///< by asset's id, of what was read
  Warnings warnings_;
};

/// The id of a part of a body: "body/part"; that of the other one where one of them has no name.
std::string partId(const std::string& bodyId, const GeometryPart& part);

/// What of a STEP file is not there is free space to the planner: a warning for each part that lacks something.
void warnOfMissingFaces(const LoadedGeometry& geometry, const std::string& bodyId, const std::string& file,
                        Warnings& warnings);

/// Puts the reference point of an object where it turns best: a mesh file's into the mean of its vertices, a
/// STEP part's into the middle of its box; elsewhere it is the origin.
void chooseReferencePoint(ObjectDescription& object, const LoadedGeometry& geometry);
/// In the geometry's frame.
Vector3 referencePointOf(const ObjectDescription& object, const LoadedGeometry& geometry);

/// The object as one mesh about its reference point.
TriangleMesh objectMesh(const ObjectDescription& object, const LoadedGeometry& geometry);

/// Bounding box of all parts, in their body's frame.
Box3 boxOf(const LoadedGeometry& geometry);

/// Takes file coordinates to ours: metres, z up.
TriangleMesh interpreted(TriangleMesh mesh, double unit, UpAxis up);

}  // namespace glissade
