#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/import/urdf_import.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// Meshes of what a scenario describes. Reads each asset once. Private to this room.
class GeometryLoader {
 public:
  /// Assets are relative to `folder`; `file` is the scenario's name in messages.
  GeometryLoader(const Scenario& scenario, std::string folder, std::string file);

  /// One body for each link of a URDF file, else one body. `fallback` colours what has no colour.
  Result<std::vector<RigidBody>> bodies(const BodyDescription& description, const Colour& fallback);
  /// All geometry as one mesh in the object's frame; X_WB is identity.
  Result<RigidBody> object(const ObjectDescription& description, const Colour& fallback);

  /// Contents that differ from the hash in the scenario.
  const Warnings& warnings() const { return warnings_; }

 private:
  struct Part {
    std::string link;  ///< empty where the geometry is no URDF file
    MeshPtr mesh;
    Pose X_BodyPart;
    std::optional<Colour> colour;
  };
  Result<std::vector<Part>> parts(const Geometry& geometry);
  Result<ImportedMesh> mesh(const std::string& assetId);
  Result<UrdfModel> urdf(const std::string& assetId);
  Result<std::string> locate(const Asset& asset) const;
  void compareHash(const Asset& asset, const std::string& sha256);
  Diagnostic atAsset(const Asset& asset, const std::string& key, const Diagnostic& problem) const;
  const Asset& assetOf(const std::string& id) const;

  const Scenario& scenario_;
  std::string folder_;
  std::string file_;
  std::map<std::string, ImportedMesh> meshes_;
  std::map<std::string, UrdfModel> models_;
  Warnings warnings_;
};

}  // namespace glissade
