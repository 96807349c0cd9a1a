#pragma once

#include <vector>

#include "tests/engine/study/study_fixture.h"

namespace glissade::test {

/// A fault in an otherwise valid study.
struct BrokenStudy {
  const char* patch;  ///< JSON Patch (RFC 6902) of tinyStudy()
  const char* place;  ///< place that the reader must report
  const char* reason;
  bool schemaSees = true;  ///< false: a JSON schema cannot express it
};

inline std::string broken(const BrokenStudy& row) { return tinyStudy().patch(nlohmann::json::parse(row.patch)).dump(); }

inline const std::vector<BrokenStudy>& brokenStudies() {
  static const std::vector<BrokenStudy> kRows{
      {R"([{"op": "replace", "path": "", "value": []}])", "/", "not an object"},
      {R"([{"op": "replace", "path": "/format", "value": "glissade-scenario"}])", "/format", "glissade-study"},
      {R"([{"op": "replace", "path": "/version", "value": 2}])", "/version", "is not 1"},
      {R"([{"op": "remove", "path": "/name"}])", "/name", "missing"},
      {R"([{"op": "add", "path": "/seed", "value": 1}])", "/seed", "unknown key"},
      {R"([{"op": "replace", "path": "/scenarios", "value": "scenario.json"}])", "/scenarios", "not a list"},
      {R"([{"op": "replace", "path": "/scenarios", "value": []}])", "/scenarios", "empty"},
      {R"([{"op": "remove", "path": "/scenarios"}])", "/rows/0", "no scenario", false},
      {R"([{"op": "remove", "path": "/strategies"}])", "/rows/0", "no strategy", false},
      {R"([{"op": "replace", "path": "/strategies/0", "value": "warp"}])", "/strategies/0", "strategy 'warp'", false},
      {R"([{"op": "add", "path": "/strategies/1", "value": "birrt"}])", "/strategies/1", "a second time"},
      {R"([{"op": "replace", "path": "/operators/0", "value": "ghost"}])", "/operators/0", "operator 'ghost'"},
      {R"([{"op": "replace", "path": "/operators/0", "value": "hand"}])", "/operators/0", "operator 'hand'"},
      {R"([{"op": "add", "path": "/parameters", "value": {"speed": 1}}])", "/parameters/speed", "not a parameter"},
      {R"([{"op": "add", "path": "/parameters", "value": {"alpha": "1"}}])", "/parameters/alpha", "not a number"},
      {R"([{"op": "add", "path": "/parameters", "value": {"max_steps": 1}}])", "/parameters/max_steps", "is a limit"},
      {R"([{"op": "add", "path": "/parameters", "value": [1]}])", "/parameters", "not an object"},
      {R"([{"op": "add", "path": "/grid", "value": {"alpha": [0.1, 0.1]}}])", "/grid/alpha/1", "a second time"},
      {R"([{"op": "add", "path": "/grid", "value": {"alpha": 0.1}}])", "/grid/alpha", "not a list"},
      {R"([{"op": "add", "path": "/limits/days", "value": 1}])", "/limits/days", "unknown key"},
      {R"([{"op": "replace", "path": "/limits/memory_limit_mb", "value": -1}])", "/limits/memory_limit_mb", "whole"},
      {R"([{"op": "replace", "path": "/limits", "value": {}}])", "/rows/0", "for ever", false},
      {R"([{"op": "remove", "path": "/seeds"}])", "/rows/0", "no seeds", false},
      {R"([{"op": "replace", "path": "/seeds/count", "value": 0}])", "/seeds/count", "is not from 1"},
      {R"([{"op": "replace", "path": "/seeds", "value": [1, 2, 1]}])", "/seeds/2", "a second time"},
      {R"([{"op": "replace", "path": "/seeds", "value": [-1]}])", "/seeds/0", "whole number"},
      {R"([{"op": "add", "path": "/rows/0/seeds", "value": {"first": 1, "count": 9000000}},
           {"op": "add", "path": "/rows/1/seeds", "value": {"first": 1, "count": 9000000}}])",
       "/rows/1", "too many runs", false},
      {R"([{"op": "replace", "path": "/limits/memory_limit_mb", "value": 9223372036854775807}])",
       "/limits/memory_limit_mb", "is beyond", false},
      {R"([{"op": "replace", "path": "/rows", "value": []}])", "/rows", "empty"},
      {R"([{"op": "replace", "path": "/rows/1/label", "value": "plain"}])", "/rows/1/label", "a second time", false},
      {R"([{"op": "remove", "path": "/rows/0/label"}])", "/rows/0/label", "missing"},
      {R"([{"op": "add", "path": "/rows/0/alpha", "value": 1}])", "/rows/0/alpha", "unknown key"},
      {R"([{"op": "add", "path": "/rows/0/paper/speed", "value": 1}])", "/rows/0/paper/speed", "column 'speed'", false},
      {R"([{"op": "replace", "path": "/rows/0/paper/time_s", "value": []}])", "/rows/0/paper/time_s", "not a number"},
      {R"([{"op": "replace", "path": "/paper/0/measure", "value": "speed"}])", "/paper/0/measure", "'speed'", false},
      {R"([{"op": "replace", "path": "/paper/0/statistic", "value": "mode"}])", "/paper/0/statistic", "'mode'"},
      {R"([{"op": "remove", "path": "/paper/0/over"}])", "/paper/0/over", "missing", false},
      {R"([{"op": "replace", "path": "/quick/rows/0", "value": "fast"}])", "/quick/rows/0", "row 'fast'", false},
      {R"([{"op": "add", "path": "/quick/grid", "value": {}}])", "/quick/grid", "unknown key"},
      {R"([{"op": "add", "path": "/findings", "value": [{"text": "t"}]}])", "/findings/0/measure", "missing"},
      {R"([{"op": "add", "path": "/findings", "value": [{"text": "t", "measure": "success_rate", "cells": {},
            "is": "like", "than": 1}]}])",
       "/findings/0/is", "is not one of"},
      {R"([{"op": "add", "path": "/findings", "value": [{"text": "t", "measure": "success_rate", "cells": {},
            "is": "above", "than": "a"}]}])",
       "/findings/0/than", "not an object"},
      {R"([{"op": "add", "path": "/findings", "value": [{"text": "t", "measure": "success_rate",
            "cells": {"rows": ["none"]}, "is": "above", "than": 0.5}]}])",
       "/findings/0/cells/rows/0", "row 'none'", false},
  };
  return kRows;
}

}  // namespace glissade::test
