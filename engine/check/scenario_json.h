#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/check/product.h"
#include "engine/import/asset.h"
#include "engine/import/json_reader.h"

namespace glissade::check {

/// What a scenario file says that a judge needs, before geometry is read.
struct StatedScenario {
  struct StatedBody {
    std::string id;
    std::string name;
    Geometry geometry;
    Pose pose;
  };
  std::vector<Asset> assets;
  std::vector<StatedBody> bodies;
  StatedBody object;  ///< its pose is the start
  bool centreOnVertexMean = false;
  Vector3 referencePoint = Vector3::Zero();
  std::optional<Pose> goal;
  Box3 workspace;
  std::map<ParameterId, double> parameters;
  FitWords fits;
  Demands demands;
  std::vector<ForbiddenRegion> forbidden;
};

/// Throws JsonError.
StatedScenario readStatedScenario(const JsonCursor& root);

}  // namespace glissade::check
