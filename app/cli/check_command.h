#pragma once

#include <optional>
#include <string>

#include "app/cli/report.h"
#include "engine/scenario/fit_options.h"

namespace glissade::cli {

struct CheckOptions {
  std::string scenario;
  std::string path;
  std::optional<double> requiredClearance;  ///< metres; the scenario's where absent
  FitOptions fits;
  std::vector<std::string> without{};  ///< bodies and assemblies of a plan's product that are left out
  bool trustPlan = false;              ///< what a plan states itself counts as a person's word
  std::vector<std::string> open{};     ///< parts of several solids that are taken as their solids
  bool edges = false;                  ///< certificates of every edge
  double timeLimit = 0.0;              ///< seconds; 0: none
  Format format = Format::Text;
};

/// glissade-cli check: judges a path or an assembly plan (engine/check). Exit code 0 valid, 1 invalid or
/// incomplete, 5 where the time limit left it undecided, 6 valid but for flexible bodies, of whose motions nothing is
/// proved, 7 valid only under conditions that the plan states itself, 130 interrupted.
int runCheck(const CheckOptions& options);

}  // namespace glissade::cli
