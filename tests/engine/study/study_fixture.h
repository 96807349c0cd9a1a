#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/engine/support/temporary_folder.h"

namespace glissade::test {

/// A scenario of two boxes.
inline std::string tinyScenario() {
  return R"({
    "format": "glissade-scenario", "version": 1, "name": "t",
    "bodies": [{"id": "wall", "geometry": {"box": [1, 1, 1]}}],
    "object": {"id": "cube", "geometry": {"box": [0.2, 0.2, 0.2]}},
    "start": {"position": [-1, 0, 0], "orientation": [0, 0, 0, 1]},
    "goal": {"position": [1, 0, 0], "orientation": [0, 0, 0, 1]},
    "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]},
    "planner": "birrt"})";
}

/// Two rows, one of them with a grid, two seeds; 2 x 1 + 2 x 2 = 6 runs.
inline nlohmann::json tinyStudy() {
  return nlohmann::json::parse(R"({
    "format": "glissade-study", "version": 1, "name": "tiny", "title": "A tiny study",
    "description": "d", "citation": "c",
    "paper": [{"key": "time_s", "title": "Time", "measure": "virtual_s", "statistic": "median", "over": "solved"},
              {"key": "success", "title": "Success", "measure": "success_rate"}],
    "scenarios": ["scenario.json"],
    "strategies": ["birrt"],
    "operators": ["none"],
    "limits": {"max_steps": 2000, "time_limit": 60, "memory_limit_mb": 4096},
    "seeds": {"first": 1, "count": 2},
    "rows": [
      {"label": "plain", "paper": {"time_s": 12.5, "success": "all", "note": "a, \"b\""}},
      {"label": "steps", "grid": {"extension_step": [0.01, 0.02]}}],
    "quick": {"seeds": [7], "rows": ["plain"], "limits": {"max_steps": 100}}})");
}

/// A folder with that study and its scenario.
class StudyFiles {
 public:
  explicit StudyFiles(const nlohmann::json& study = tinyStudy()) {
    folder.write("scenario.json", tinyScenario());
    file = folder.write("study.json", study.dump());
  }

  TemporaryFolder folder;
  std::string file;
};

}  // namespace glissade::test
