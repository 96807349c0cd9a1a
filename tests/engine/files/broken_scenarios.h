#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"

namespace glissade::test {

/// A fault in an otherwise valid file.
struct BrokenScenario {
  const char* patch;  ///< JSON Patch (RFC 6902) of fullScenario()
  const char* place;  ///< place that the reader must report
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
      {R"([{"op": "replace", "path": "/format", "value": "gltf"}])", "/format", "is not \"glissade-scenario\""},
      {R"([{"op": "remove", "path": "/format"}])", "/format", "missing"},
      {R"([{"op": "replace", "path": "/version", "value": 2}])", "/version", "version 2"},
      {R"([{"op": "replace", "path": "/version", "value": 0}])", "/version", "version 0"},
      {R"([{"op": "replace", "path": "/version", "value": "1"}])", "/version", "not a whole number"},
      {R"([{"op": "replace", "path": "/fits/mode", "value": "auto"}])", "/fits/mode", "is not one of: off, on"},
      {R"([{"op": "remove", "path": "/fits/mode"}])", "/fits/mode", "missing"},
      {R"([{"op": "replace", "path": "/fits/accept_clashes", "value": -0.001}])", "/fits/accept_clashes", "below zero"},
      {R"([{"op": "replace", "path": "/fits/pairs/0/allowance", "value": -1e-6}])", "/fits/pairs/0/allowance",
       "below zero"},
      {R"([{"op": "replace", "path": "/fits/pairs/0/kind", "value": "glue"}])", "/fits/pairs/0/kind",
       "not a kind of fit"},
      {R"([{"op": "add", "path": "/fits/pairs/0/pitch_m", "value": 0}])", "/fits/pairs/0/pitch_m", "not a pitch",
       false},
      {R"([{"op": "add", "path": "/fits/pairs/0/pitch_m", "value": -1e-6}])", "/fits/pairs/0/pitch_m", "not a pitch",
       false},
      {R"([{"op": "add", "path": "/fits/pairs/0/pitch_m", "value": "1.5 mm"}])", "/fits/pairs/0/pitch_m", "number"},
      {R"([{"op": "add", "path": "/fits/pairs/1/pitch_m", "value": 0.001}])", "/fits/pairs/1/pitch_m",
       "not marked as a thread", false},
      {R"([{"op": "add", "path": "/fits/pairs/1/turned", "value": "wall"}])", "/fits/pairs/1/turned",
       "not marked as a thread", false},
      {R"([{"op": "add", "path": "/fits/pairs/0/turned", "value": "nobody"}])", "/fits/pairs/0/turned", "neither",
       false},
      {R"([{"op": "add", "path": "/fits/pairs/0/turned", "value": 1}])", "/fits/pairs/0/turned", "text"},
      {R"([{"op": "replace", "path": "/fits/pairs/0/b", "value": "object"}])", "/fits/pairs/0/b", "same body", false},
      {R"([{"op": "replace", "path": "/fits/pairs/1", "value": {"a": "wall", "b": "object"}}])", "/fits/pairs/1",
       "was there before", false},
      {R"([{"op": "add", "path": "/fits/depth", "value": 1}])", "/fits/depth", "unknown key"},
      {R"([{"op": "replace", "path": "/joints", "value": {}}])", "/joints", "not a list"},
      {R"([{"op": "replace", "path": "/joints/0/kind", "value": "rivet"}])", "/joints/0/kind", "is not one of: screw"},
      {R"([{"op": "replace", "path": "/joints/0/word", "value": "loosened"}])", "/joints/0/word",
       "is not one of: confirmed"},
      {R"([{"op": "remove", "path": "/joints/0/word"}])", "/joints/0/word", "missing"},
      {R"([{"op": "replace", "path": "/joints/0/body", "value": ""}])", "/joints/0/body", "empty"},
      {R"([{"op": "add", "path": "/joints/0/made/depth", "value": 1}])", "/joints/0/made/depth", "unknown key"},
      {R"([{"op": "add", "path": "/joints/0/made/bend_m", "value": -0.001}])", "/joints/0/made/bend_m", "below zero"},
      {R"([{"op": "add", "path": "/joints/0/made/drive", "value": "torx"}])", "/joints/0/made/drive",
       "is not one of: none"},
      {R"([{"op": "replace", "path": "/joints/0/made/direction", "value": [0, 0, 0]}])", "/joints/0/made/direction",
       "no length", false},
      {R"([{"op": "replace", "path": "/joints/0/made/thread/pitch_m", "value": 0}])", "/joints/0/made/thread/pitch_m",
       "not a pitch", false},
      {R"([{"op": "remove", "path": "/joints/0/made/thread/engaged_m"}])", "/joints/0/made/thread/engaged_m",
       "missing"},
      {R"([{"op": "add", "path": "/joints/1/made", "value": {}}])", "/joints/1/made", "no effect", false},
      {R"([{"op": "add", "path": "/joints/-", "value": {"kind": "unit", "body": "object", "others": ["part"],
        "word": "confirmed"}}])",
       "/joints/3", "was there before", false},
      {R"([{"op": "add", "path": "/sequence/after", "value": []}])", "/sequence/after", "unknown key"},
      {R"([{"op": "replace", "path": "/sequence/together/0", "value": ["wall"]}])", "/sequence/together/0",
       "fewer than 2 entries"},
      {R"([{"op": "replace", "path": "/sequence/before/0", "value": ["a", "b", "c"]}])", "/sequence/before/0",
       "two texts"},
      {R"([{"op": "replace", "path": "/sequence/gravity", "value": [0, 0, 0]}])", "/sequence/gravity", "no direction",
       false},
      {R"([{"op": "replace", "path": "/sequence/gravity", "value": [0, 1]}])", "/sequence/gravity", "three numbers"},
      {R"([{"op": "replace", "path": "/sequence/densities/0/density", "value": 0}])", "/sequence/densities/0/density",
       ""},
      {R"([{"op": "add", "path": "/colour", "value": 1}])", "/colour", "unknown key"},
      {R"([{"op": "add", "path": "/bodies/1/pose/angle", "value": 1}])", "/bodies/1/pose/angle", "unknown"},
      {R"([{"op": "remove", "path": "/start"}])", "/start", "missing"},
      {R"([{"op": "replace", "path": "/start/position/1", "value": null}])", "/start/position/1", "not a number"},
      {R"([{"op": "replace", "path": "/start/position", "value": [1, 2]}])", "/start/position", "three numbers"},
      {R"([{"op": "replace", "path": "/start/orientation/3", "value": 2}])", "/start/orientation", "unit quaternion"},
      {R"([{"op": "replace", "path": "/start/orientation/3", "value": 0.5}])", "/start/orientation", "unit quaternion",
       false},
      {R"([{"op": "replace", "path": "/start/position/1", "value": 1e12}])", "/start/position/1", "beyond 1e9 m",
       false},
      {R"([{"op": "replace", "path": "/workspace/max/2", "value": 1e19}])", "/workspace/max/2", "beyond 1e9 m", false},
      {R"([{"op": "replace", "path": "/object/reference_point", "value": [0, -2e9, 0]}])", "/object/reference_point/1",
       "beyond 1e9 m", false},
      {R"([{"op": "replace", "path": "/assets/0/unit", "value": 1e10}])", "/assets/0/unit", "1e-12 m to 1e9 m", false},
      {R"([{"op": "replace", "path": "/bodies/0/geometry/box/1", "value": 1e-13}])", "/bodies/0/geometry/box",
       "below 1e-12 m", false},
      {R"([{"op": "replace", "path": "/assets/0/path", "value": "a\u0000b"}])", "/assets/0/path", "zero byte", false},
      {R"([{"op": "replace", "path": "/goal", "value": "in"}])", "/goal", "neither"},
      {R"([{"op": "replace", "path": "/workspace/min/0", "value": 50}])", "/workspace", "above", false},
      {R"([{"op": "replace", "path": "/bodies/1/id", "value": "wall"}])", "/bodies/1/id", "a second time", false},
      {R"([{"op": "replace", "path": "/object/id", "value": "wall"}])", "/object/id", "a second time", false},
      {R"([{"op": "replace", "path": "/assets/1/id", "value": "part"}])", "/assets/1/id", "a second time", false},
      {R"([{"op": "replace", "path": "/bodies/1/id", "value": "a/b"}])", "/bodies/1/id", "'/'"},
      {R"([{"op": "replace", "path": "/bodies/1/id", "value": ""}])", "/bodies/1/id", "empty"},
      {R"([{"op": "replace", "path": "/bodies/1/mobility", "value": "fixed"}])", "/bodies/1/mobility",
       "is not one of: static"},
      {R"([{"op": "replace", "path": "/bodies/1/geometry/mesh", "value": "gone"}])", "/bodies/1/geometry/mesh",
       "not in /assets", false},
      {R"([{"op": "add", "path": "/bodies/1/geometry/iges", "value": "x"}])", "/bodies/1/geometry/iges", "unknown key"},
      {R"([{"op": "remove", "path": "/bodies/3/geometry/step/asset"}])", "/bodies/3/geometry/step/asset", "missing"},
      {R"([{"op": "replace", "path": "/bodies/3/geometry/step/asset", "value": "gone"}])",
       "/bodies/3/geometry/step/asset", "not in /assets", false},
      {R"([{"op": "replace", "path": "/bodies/3/geometry/step/part", "value": ""}])", "/bodies/3/geometry/step/part",
       "empty"},
      {R"([{"op": "replace", "path": "/bodies/3/geometry/step", "value": "product"}])", "/bodies/3/geometry/step",
       "not an object"},
      {R"([{"op": "replace", "path": "/assets/2/deflection", "value": 0}])", "/assets/2/deflection", "above zero"},
      {R"([{"op": "replace", "path": "/object/reference_point", "value": [1, 2]}])", "/object/reference_point",
       "three numbers"},
      {R"([{"op": "replace", "path": "/object/geometry", "value": {"mesh": "part"}},
           {"op": "add", "path": "/object/centre_on_vertex_mean", "value": true}])",
       "/object/reference_point", "said twice", false},
      {R"([{"op": "replace", "path": "/bodies/0/geometry/box/1", "value": -1}])", "/bodies/0/geometry/box",
       "above zero"},
      {R"([{"op": "replace", "path": "/bodies/1/colour/0", "value": 1.5}])", "/bodies/1/colour", "not a colour"},
      {R"([{"op": "add", "path": "/bodies/1/attributes/x", "value": []}])", "/bodies/1/attributes/x", "not a number"},
      {R"([{"op": "add", "path": "/object/centre_on_vertex_mean", "value": true}])", "/object/centre_on_vertex_mean",
       "mesh files only", false},
      {R"([{"op": "replace", "path": "/assets/0/unit", "value": 0}])", "/assets/0/unit", "above zero"},
      {R"([{"op": "replace", "path": "/assets/0/up_axis", "value": "x"}])", "/assets/0/up_axis", "is not one of: y, z"},
      {R"([{"op": "add", "path": "/parameters/speed", "value": 1}])", "/parameters/speed", "not a parameter"},
      {R"([{"op": "replace", "path": "/parameters/alpha", "value": "high"}])", "/parameters/alpha", "not a number"},
      {R"([{"op": "replace", "path": "/plan", "value": []}])", "/plan", "not an object"},
      {R"([{"op": "remove", "path": "/plan/steps"}])", "/plan/steps", "missing"},
      {R"([{"op": "replace", "path": "/plan/steps/0/motions/0/bodies/0", "value": "nobody"}])",
       "/plan/steps/0/motions/0/bodies/0", "none of the plan's bodies", false},
      {R"([{"op": "replace", "path": "/seed", "value": -1}])", "/seed", "whole number"},
      {R"([{"op": "replace", "path": "/seed", "value": 1.5}])", "/seed", "whole number"},
      {R"([{"op": "replace", "path": "/planner", "value": ""}])", "/planner", "empty"},
  };
  return kRows;
}

}  // namespace glissade::test
