#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/check/path.h"
#include "engine/check/product.h"

namespace glissade::check {

/// A rule that a step says it does not keep, and the bodies that it is about.
struct StatedViolation {
  std::string rule;
  std::vector<std::string> bodies;  ///< ids
};

/// A joint that a step says comes apart by it. Nothing: the plan does not state the number.
struct StatedJoint {
  std::string kind;
  std::string body;                 ///< id
  std::vector<std::string> others;  ///< ids
  std::string drive{};              ///< "hex", "hex_socket", ...; empty: none
  bool isNamed = false;             ///< a designation says what it is
  std::optional<double> diameter{};
  std::optional<double> pitch{};  ///< metres a turn; below 0: left-handed
  std::optional<double> turns{};
  std::optional<double> bend{};
  std::optional<double> driveSize{};

  bool isScrewed() const { return kind == "screw" || kind == "nut" || kind == "thread"; }
};

/// What a step says was proved of its motion.
struct StatedProof {
  std::size_t afterSteps = 0;  ///< against those that are there after so many steps
  std::optional<double> required{};
  std::optional<double> provedClearance{};
  std::optional<double> minClearance{};
  std::string nearest{};  ///< id; empty: none
};

/// A step as a plan states it.
struct Step {
  std::vector<std::string> bodies;  ///< ids of those that leave
  std::vector<Point> path;
  std::vector<std::size_t> after;  ///< steps that have to be carried out before, from 1
  std::vector<StatedAllowance> allowances;
  std::vector<StatedViolation> violates;
  bool certified = true;  ///< what the step says of itself
  bool flexible = false;  ///< it says so of its one body, of whose motion nothing is proved
  std::vector<StatedJoint> joints{};
  std::optional<StatedProof> proof{};
  bool unit = false;  ///< it says that its bodies are one unit
  std::optional<std::uint64_t> wave{};
  std::optional<std::uint64_t> task{};
};

/// A group that has left, taken apart in a frame of its own: nothing but its bodies is there.
struct Line {
  std::size_t step = 0;              ///< by which it has left, from 1, of the plan or of the line above it
  std::vector<std::string> bodies;   ///< ids
  std::vector<std::string> staying;  ///< ids
  std::vector<Step> steps;
  std::vector<Line> lines;  ///< of its groups
};

/// An assembly plan as its file states it. Nothing is taken for true.
struct Plan {
  std::vector<std::string> bodies;   ///< ids
  std::vector<std::string> staying;  ///< ids
  std::vector<Step> steps;
  std::string end;  ///< "complete", "stuck", "time_limit" or "interrupted"
  Demands demands{};
  std::vector<SnapWord> snaps{};  ///< bends that it says a person has confirmed
  PartingWords partings{};
  JointWords joints{};
  double deflection = 0.0;  ///< metres; 0: not stated
  std::optional<std::uint64_t> parts{};
  std::optional<std::uint64_t> removed{};
  std::optional<std::uint64_t> apart{};
  std::optional<bool> certified{};
  std::vector<Line> lines{};
};

}  // namespace glissade::check
