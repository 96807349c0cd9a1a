#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/report.h"
#include "engine/scenario/fit_options.h"

namespace glissade::cli {

struct SequenceOptions {
  std::string file;                    ///< a scenario, or a part file as usualPart() takes it
  std::string strategy;                ///< empty: kUsualStrategy, or that of the plan that is resumed
  std::optional<std::uint64_t> seed;   ///< 1, or that of the plan that is resumed
  double timeLimit = 0.0;              ///< seconds; 0: none
  std::size_t lanes = 1;               ///< threads; they do not change the plan
  std::vector<std::string> staying;    ///< ids or ends of ids; empty: the largest body
  std::vector<std::string> together;   ///< demands: names with commas between them
  std::vector<std::string> before;     ///< demands: "first,then"
  std::vector<std::string> places;     ///< demands: "3,name" or "3,name,name"
  std::vector<std::string> forbidden;  ///< demands: "name,-z" or "name,0,0,-1"
  std::vector<double> gravity;         ///< its direction; empty: the scenario's, or down
  std::string joints;                  ///< as of jointUseName(); empty: the scenario's
  std::string cost;                    ///< of best-first: a preset or an expression; empty: the scenario's
  std::vector<std::string> without{};  ///< bodies and assemblies that are left out
  std::vector<std::string> open{};     ///< parts of several solids that are taken as their solids
  double deflection = 0.0;             ///< metres, of STEP files; 0: by the size of each part
  std::string out;                     ///< plan file to write; empty: none
  double saveEvery = 5.0;              ///< seconds after which the plan so far is written
  std::string resume;                  ///< plan file to go on from; empty: none
  FitOptions fits;
  Format format = Format::Text;
};

/// glissade-cli sequence: in which order the parts of a product leave, with certified motions. Exit code 0 all parts
/// but those that stay leave, alone or as units, 6 all do and flexible bodies without a proof, 1 some are stuck, or
/// leave in groups that are not taken apart, 5 time limit, 130 interrupted; the plan so far is written always.
int runSequence(const SequenceOptions& options);

}  // namespace glissade::cli
