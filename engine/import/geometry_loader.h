#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/import/asset.h"
#include "engine/import/file_content.h"
#include "engine/import/mesh_import.h"

namespace glissade {

/// The id of the asset that a geometry is read from; null for primitives.
const std::string* assetOf(const Geometry& geometry);

/// What a geometry of these assets is found under in a GeometryCache: equal where the same would be read.
std::string geometryKey(const Geometry& geometry, const std::vector<Asset>& assets, const std::string& folder);

/// Reads the geometry that bodies name; what was read before, and what several bodies name, once. Refers to the assets
/// and to what is known.
class GeometryLoader {
 public:
  /// Assets are relative to `folder`; `file` is used in messages only. What is in `known` (null: nothing) is not read
  /// again.
  GeometryLoader(const std::vector<Asset>& assets, std::string folder, std::string file, const GeometryCache* known,
                 StopToken stop = {});

  /// These will be asked for: small mesh files among them are read many at a time. Errors are left to load().
  void expect(const std::vector<const Geometry*>& geometries);

  /// Errors are MalformedInput with the file that they are in, or Interrupted where it was stopped.
  Result<LoadedGeometryPtr> load(const Geometry& geometry);

  /// Writes into the assets the hashes of the bytes that their geometry was read from.
  void noteHashes(std::vector<Asset>& assets) const;

  /// What was asked for.
  GeometryCache& loaded() { return loaded_; }
  /// Small mesh files as they are, by keys of a GeometryCache: another unit or axis of one needs no reading.
  const GeometryCache& files() const { return files_; }
  /// Files that have changed since the scenario was saved, and what was lost in reading one.
  Warnings& warnings() { return warnings_; }

 private:
  Result<LoadedGeometry> read(const Geometry& geometry);
  Result<FileContent> readAsset(const Asset& asset);
  void noteHash(const Asset& asset, const std::string& file, const std::string& hash);
  Result<LoadedGeometry> readMesh(const Asset& asset, bool groups);
  Result<ImportedMesh> importFile(const Asset& asset);
  Result<LoadedGeometry> readUrdf(const Asset& asset);
  Result<LoadedGeometry> readStep(const Asset& asset);
  Result<LoadedGeometry> partOf(const std::string& asset, const std::string& part, const Geometry& wholeFile,
                                bool asOne);
  void takeWarnings(const LoadedGeometry& geometry);
  void keepWholeFileOf(const Geometry& geometry);
  Outcome checkOwnUnit(const Asset& asset, const std::string& kind) const;

  const std::vector<Asset>& assets_;
  std::string folder_;
  std::string file_;
  const GeometryCache* known_;
  StopToken stop_;
  GeometryCache loaded_;
  GeometryCache files_;
  std::map<std::string, std::string> hashes_;  ///< by asset's id, of what was read
  Warnings warnings_;
};

/// The id of a part of a body: "body/part"; that of the other one where one of them has no name.
std::string partId(const std::string& bodyId, const Occurrence& part);

/// What of a STEP file is not there is free space to the planner: a warning for each part that lacks something.
void warnOfMissingFaces(const LoadedGeometry& geometry, const std::string& bodyId, const std::string& file,
                        Warnings& warnings);

/// Each shape of all files that were read and that is no body, once. Of files of which `named` has single parts, that
/// is each other part, too. `named`: the geometries of all bodies of a scenario, with those that it leaves out.
MissingShapes missingShapesOf(const GeometryCache& read, const std::vector<const Geometry*>& named,
                              const std::vector<Asset>& assets, const std::string& folder);

/// All parts as one mesh about a point of the geometry's frame.
TriangleMesh wholeMesh(const LoadedGeometry& geometry, const Vector3& reference);

/// Bounding box of all parts, in their body's frame.
Box3 boxOf(const LoadedGeometry& geometry);

/// Takes file coordinates to ours: metres, z up.
TriangleMesh interpreted(TriangleMesh mesh, double unit, UpAxis up);

}  // namespace glissade
