#pragma once

#include "tests/engine/files/broken_scenarios.h"

namespace glissade::test {

/// Faults in the statements of a scenario about its places, bodies and rules.
inline const std::vector<BrokenScenario>& brokenSemantics() {
  static const std::vector<BrokenScenario> kRows{
      // environment
      {R"([{"op": "replace", "path": "/environment/places", "value": "voronoi"}])", "/environment/places",
       "no way to find places"},
      {R"([{"op": "replace", "path": "/environment/topology_level", "value": 9}])", "/environment/topology_level",
       "out of range"},
      {R"([{"op": "replace", "path": "/environment/topology_level", "value": 2.5}])", "/environment/topology_level",
       "whole number"},
      {R"([{"op": "replace", "path": "/environment/memory", "value": 0}])", "/environment/memory", "above zero"},
      {R"([{"op": "replace", "path": "/environment/cell_size", "value": -0.1}])", "/environment/cell_size",
       "below zero"},
      {R"([{"op": "add", "path": "/environment/depth", "value": 1}])", "/environment/depth", "unknown key"},
      // definitions of attributes
      {R"([{"op": "replace", "path": "/attributes/0/type", "value": "real"}])", "/attributes/0/type",
       "is not one of: bool"},
      {R"([{"op": "replace", "path": "/attributes/0/of", "value": "border"}])", "/attributes/0/of",
       "is not one of: place"},
      {R"([{"op": "replace", "path": "/attributes/0/name", "value": "Weight"}])", "/attributes", "not a word"},
      {R"([{"op": "replace", "path": "/attributes/2/name", "value": "weight"}])", "/attributes", "already", false},
      {R"([{"op": "replace", "path": "/attributes/1/name", "value": "complexity"}])", "/attributes", "already", false},
      {R"([{"op": "remove", "path": "/attributes/1/choices"}])", "/attributes", "no choices", false},
      {R"([{"op": "replace", "path": "/attributes/1/initial", "value": "fair"}])", "/attributes",
       "not one of its choices", false},
      {R"([{"op": "replace", "path": "/attributes/0/minimum", "value": 5000}])", "/attributes", "above its maximum",
       false},
      {R"([{"op": "remove", "path": "/attributes/0/of"}])", "/attributes/0/of", "missing"},
      // values
      {R"([{"op": "add", "path": "/places/0/attributes/colour", "value": "red"}])", "/places/0/attributes/colour",
       "not a defined attribute", false},
      {R"([{"op": "add", "path": "/places/0/attributes/weight", "value": 1}])", "/places/0/attributes/weight",
       "not a defined attribute", false},  // an attribute of bodies only
      {R"([{"op": "replace", "path": "/places/1/attributes/forbidden", "value": 1}])", "/places/1/attributes/forbidden",
       "neither true nor false", false},
      {R"([{"op": "replace", "path": "/places/0/attributes/compatibility", "value": 2}])",
       "/places/0/attributes/compatibility", "out of range", false},
      {R"([{"op": "add", "path": "/places/0/attributes/visits", "value": 1.5}])", "/places/0/attributes/visits",
       "whole number", false},
      {R"([{"op": "replace", "path": "/places/0/attributes/quality", "value": "fair"}])",
       "/places/0/attributes/quality", "choices", false},
      {R"([{"op": "replace", "path": "/places/0/at/1", "value": "left"}])", "/places/0/at/1", "not a number"},
      {R"([{"op": "remove", "path": "/places/0/at"}])", "/places/0/at", "missing"},
      {R"([{"op": "replace", "path": "/bodies/1/attributes/weight", "value": "heavy"}])", "/bodies/1/attributes/weight",
       "not a number", false},
      {R"([{"op": "replace", "path": "/object/attributes/weight", "value": -1}])", "/object/attributes/weight",
       "out of range", false},
      {R"([{"op": "replace", "path": "/milestones/0/pose/orientation/0", "value": 2}])",
       "/milestones/0/pose/orientation", "unit quaternion"},
      {R"([{"op": "remove", "path": "/milestones/0/at"}])", "/milestones/0/at", "missing"},
      // nodes of the product
      {R"([{"op": "replace", "path": "/product/0/id", "value": "pumpe"}])", "/product/0/id",
       "neither a body nor an assembly", false},
      {R"([{"op": "replace", "path": "/product/1/id", "value": "pump"}])", "/product/1/id", "a second time", false},
      {R"([{"op": "add", "path": "/product/2/attributes", "value": {"weight": 1}}])", "/product/2/attributes",
       "about a body", false},
      {R"([{"op": "replace", "path": "/product/2/in", "value": "pin"}])", "/product/1/id",
       "neither a body nor an assembly", false},
      {R"([{"op": "replace", "path": "/product/0/attributes/weight", "value": "heavy"}])",
       "/product/0/attributes/weight", "not a number", false},
      {R"([{"op": "add", "path": "/product/0/body", "value": "pump"}])", "/product/0/body", "unknown key"},
      // rules
      {R"([{"op": "replace", "path": "/rules/edge", "value": "distance * place.speed"}])", "/rules/edge, column 12",
       "'place.speed' is unknown", false},
      {R"([{"op": "replace", "path": "/rules/node", "value": "distance"}])", "/rules/node, column 1",
       "'distance' is unknown", false},
      {R"([{"op": "replace", "path": "/rules/node", "value": "1 +"}])", "/rules/node, column 4", "ends too early",
       false},
      {R"([{"op": "replace", "path": "/rules/node", "value": ""}])", "/rules/node", "empty"},
      {R"([{"op": "replace", "path": "/rules/fine/0/when", "value": "(1"}])", "/rules/fine/0/when, column 3",
       "')' is missing", false},
      {R"([{"op": "replace", "path": "/rules/fine/0/local", "value": "prm"}])", "/rules/fine/0/local",
       "no local planner 'prm'", false},
      {R"([{"op": "remove", "path": "/rules/fine/1"}])", "/rules/fine", "no last rule", false},
      {R"([{"op": "replace", "path": "/rules/fine", "value": []}])", "/rules/fine", "is empty"},
      {R"([{"op": "replace", "path": "/rules/loop", "value": "yes"}])", "/rules/loop", "neither true nor false"},
      {R"([{"op": "remove", "path": "/rules/fine"}])", "/rules/fine", "missing"},
  };
  return kRows;
}

}  // namespace glissade::test
