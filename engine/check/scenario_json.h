#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/json_reader.h"
#include "engine/base/parameters.h"
#include "engine/check/product.h"
#include "engine/import/asset.h"

namespace glissade::check {

/// The part of a scenario file that a judge needs, before geometry is read.
struct StatedScenario {
  struct StatedBody {
    BodyId id;
    std::string name;
    Geometry geometry;
    Pose pose;
  };
  std::vector<Asset> assets;
  std::vector<StatedBody> bodies;
  std::vector<StatedBody>
      object;  ///< at least one; poses of the later ones are in the frame of the first one's geometry
  std::vector<StatedBody> leftOut;     ///< bodies that are absent
  std::vector<NodeDescription> nodes;  ///< nodes of the product's tree: names, and the assemblies that contain them
  Pose start;                          ///< pose of the object's reference point
  bool centreOnVertexMean = false;
  Vector3 referencePoint = Vector3::Zero();  ///< in the frame of the first body's geometry
  std::optional<Pose> goal;
  Box3 workspace;
  std::map<ParameterId, double> parameters;
  FitWords fits;
  Demands demands;
  JointWords joints;
  std::vector<ForbiddenRegion> forbidden;
  bool forbidsPlaces = false;  ///< an edit of a place forbids it
};

/// Errors are thrown as JsonError.
StatedScenario readStatedScenario(const JsonCursor& root);

}  // namespace glissade::check
