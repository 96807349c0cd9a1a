#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/import/asset.h"
#include "engine/import/file_content.h"
#include "engine/import/mesh_import.h"
#include "engine/model/body_id.h"

namespace glissade {

/// The id of the asset that contains a geometry; null for primitives.
const std::string* assetOf(const Geometry& geometry);

/// Key of a geometry in a GeometryCache: equal for geometries that would be read alike.
std::string geometryKey(const Geometry& geometry, const std::vector<Asset>& assets, const std::string& folder);

/// Reads the geometry that bodies name. Geometry that was read before, or that several bodies name, is read once.
/// Refers to the assets and to `known`.
class GeometryLoader {
 public:
  /// Assets are relative to `folder`; `file` is used in messages only. Geometry in `known` (or null) is not read again.
  GeometryLoader(const std::vector<Asset>& assets, std::string folder, std::string file, const GeometryCache* known,
                 StopToken stop = {});

  /// Announces geometries for load(): small mesh files among them are read many at a time. Errors are left to load().
  void expect(const std::vector<const Geometry*>& geometries);

  /// Errors are MalformedInput with the file that contains them, or Interrupted after a stop.
  Result<LoadedGeometryPtr> load(const Geometry& geometry);

  /// Writes into the assets the hashes of the bytes that their geometry was read from.
  void noteHashes(std::vector<Asset>& assets) const;

  /// The geometries that were loaded.
  GeometryCache& loaded() { return loaded_; }
  /// Small mesh files without unit and axis, by keys of a GeometryCache: another unit or axis needs no reading.
  const GeometryCache& files() const { return files_; }
  /// Files that have changed since the scenario was saved, and losses during reading.
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
  std::map<std::string, std::string> hashes_;  ///< hash of the content of each asset, by id
  Warnings warnings_;
};

/// The id of a part of a body: "body/part", or the only name if one of them has none.
BodyId partId(const BodyId& bodyId, const Occurrence& part);

/// Warns of each part with missing faces, which are free space for the planner.
void warnOfMissingFaces(const LoadedGeometry& geometry, const BodyId& bodyId, const std::string& file,
                        Warnings& warnings);

/// Each shape of the files that is no body, once. For a file of which `named` contains single parts, each other part
/// also counts. `named`: the geometries of all bodies of a scenario, including bodies that are left out.
MissingShapes missingShapesOf(const GeometryCache& read, const std::vector<const Geometry*>& named,
                              const std::vector<Asset>& assets, const std::string& folder);

/// All parts as one mesh about a point of the geometry's frame.
TriangleMesh wholeMesh(const LoadedGeometry& geometry, const Vector3& reference);

/// Bounding box of all parts, in their body's frame.
Box3 boxOf(const LoadedGeometry& geometry);

/// Turns the axis that is up in a file to z.
Pose uprightPose(UpAxis up);
/// Converts file coordinates to metres with z up.
TriangleMesh interpreted(TriangleMesh mesh, double unit, UpAxis up);

}  // namespace glissade
