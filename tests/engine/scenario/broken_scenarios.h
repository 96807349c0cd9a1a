#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/scenario/scenario_io.h"
#include "tests/engine/scenario/scenario_fixture.h"

namespace glissade::test {

/// A fault in an otherwise sound file.
struct BrokenScenario {
  const char* patch;  ///< JSON Patch (RFC 6902) of fullScenario()
  const char* place;  ///< where the reader must see it
  const char* reason;
  bool schemaSees = true;  ///< false: a JSON schema cannot express it
};

inline std::string broken(const BrokenScenario& row) {
  const auto sound = nlohmann::json::parse(writeScenario(fullScenario()));
  return sound.patch(nlohmann::json::parse(row.patch)).dump();
}

inline const std::vector<BrokenScenario>& brokenScenarios() {
  static const std::vector<BrokenScenario> kRows{
      {R"([{"op": "replace", "path": "", "value": []}])", "/", "not an object"},
      {R"([{"op": "replace", "path": "/format", "value": "gltf"}])", "/format", "not a scenario"},
      {R"([{"op": "remove", "path": "/format"}])", "/", "'format' is missing"},
      {R"([{"op": "replace", "path": "/version", "value": 2}])", "/version", "newer Glissade"},
      {R"([{"op": "replace", "path": "/version", "value": 0}])", "/version", "no version 0"},
      {R"([{"op": "replace", "path": "/version", "value": "1"}])", "/version", "not a whole number"},
      {R"([{"op": "add", "path": "/colour", "value": 1}])", "/colour", "'colour' is unknown"},
      {R"([{"op": "add", "path": "/bodies/1/pose/angle", "value": 1}])", "/bodies/1/pose/angle", "unknown"},
      {R"([{"op": "remove", "path": "/start"}])", "/", "'start' is missing"},
      {R"([{"op": "replace", "path": "/start/position/1", "value": null}])", "/start/position/1", "not a number"},
      {R"([{"op": "replace", "path": "/start/position", "value": [1, 2]}])", "/start/position", "not 3 elements"},
      {R"([{"op": "replace", "path": "/start/orientation/3", "value": 2}])", "/start/orientation", "length 1"},
      {R"([{"op": "replace", "path": "/start/orientation/3", "value": 0.5}])", "/start/orientation", "length 1", false},
      {R"([{"op": "replace", "path": "/start/position/0", "value": 99}])", "/start", "outside the workspace", false},
      {R"([{"op": "replace", "path": "/way_points/1/position/0", "value": 99}])", "/way_points/1", "outside", false},
      {R"([{"op": "replace", "path": "/goal", "value": "in"}])", "/goal", "not known"},
      {R"([{"op": "replace", "path": "/workspace/min/0", "value": 50}])", "/workspace", "below", false},
      {R"([{"op": "replace", "path": "/bodies/1/id", "value": "wall"}])", "/bodies/1/id", "twice", false},
      {R"([{"op": "replace", "path": "/object/id", "value": "wall"}])", "/object/id", "twice", false},
      {R"([{"op": "replace", "path": "/assets/1/id", "value": "part"}])", "/assets/1/id", "twice", false},
      {R"([{"op": "replace", "path": "/bodies/1/id", "value": "a/b"}])", "/bodies/1/id", "'/'"},
      {R"([{"op": "replace", "path": "/bodies/1/id", "value": ""}])", "/bodies/1/id", "empty"},
      {R"([{"op": "replace", "path": "/bodies/1/mobility", "value": "fixed"}])", "/bodies/1/mobility", "not known"},
      {R"([{"op": "replace", "path": "/bodies/1/geometry/asset", "value": "gone"}])", "/bodies/1/geometry/asset",
       "no asset", false},
      {R"([{"op": "replace", "path": "/bodies/1/geometry/type", "value": "step"}])", "/bodies/1/geometry/type",
       "not known"},
      {R"([{"op": "replace", "path": "/bodies/0/geometry/size/1", "value": -1}])", "/bodies/0/geometry/size/1",
       "positive"},
      {R"([{"op": "replace", "path": "/bodies/1/colour/0", "value": 1.5}])", "/bodies/1/colour/0", "between 0 and 1"},
      {R"([{"op": "add", "path": "/bodies/1/attributes/x", "value": []}])", "/bodies/1/attributes/x", "attribute"},
      {R"([{"op": "add", "path": "/object/centre_on_vertex_mean", "value": true}])", "/object/centre_on_vertex_mean",
       "only a mesh", false},
      {R"([{"op": "replace", "path": "/assets/0/path", "value": "/etc/passwd"}])", "/assets/0/path", "leaves"},
      {R"([{"op": "replace", "path": "/assets/0/path", "value": "a/../../b.stl"}])", "/assets/0/path", "leaves"},
      {R"([{"op": "replace", "path": "/assets/0/path", "value": "a\\b.stl"}])", "/assets/0/path", "leaves"},
      {R"([{"op": "replace", "path": "/assets/0/unit", "value": 0}])", "/assets/0/unit", "positive"},
      {R"([{"op": "replace", "path": "/assets/0/up", "value": "x"}])", "/assets/0/up", "not known"},
      {R"([{"op": "replace", "path": "/assets/0/sha256", "value": "abc"}])", "/assets/0/sha256", "64"},
      {R"([{"op": "add", "path": "/parameters/speed", "value": 1}])", "/parameters/speed", "no parameter"},
      {R"([{"op": "replace", "path": "/parameters/alpha", "value": "high"}])", "/parameters/alpha", "not a number"},
      {R"([{"op": "replace", "path": "/seed", "value": -1}])", "/seed", "whole number"},
      {R"([{"op": "replace", "path": "/seed", "value": 1.5}])", "/seed", "whole number"},
      {R"([{"op": "replace", "path": "/planner", "value": ""}])", "/planner", "empty"},
  };
  return kRows;
}

}  // namespace glissade::test
