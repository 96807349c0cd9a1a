#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/check/path.h"
#include "engine/check/product.h"
#include "engine/model/body_id.h"

namespace glissade::check {

/// A rule that a step says it breaks, and the bodies that the rule concerns.
struct StatedViolation {
  std::string rule;
  std::vector<BodyId> bodies;  ///< ids
};

/// A joint that a step says comes apart by it. An empty member: the plan does not state it.
struct StatedJoint {
  std::string kind;
  BodyId body;                 ///< id
  std::vector<BodyId> others;  ///< ids
  std::string drive{};         ///< "hex", "hex_socket", ...; empty: none
  bool isNamed = false;        ///< it has a designation
  std::optional<double> diameter{};
  std::optional<double> pitch{};  ///< metres a turn; below 0: left-handed
  std::optional<double> turns{};
  std::optional<double> bend{};
  std::optional<double> driveSize{};

  bool isScrewed() const { return kind == "screw" || kind == "nut" || kind == "thread"; }
};

/// The proof that a step states for its motion.
struct StatedProof {
  /// The bodies: those that are there after this number of steps and the earlier motions of the own step.
  std::size_t afterSteps = 0;
  std::optional<double> required{};
  std::optional<double> provedClearance{};
  std::optional<double> minClearance{};
  BodyId nearest{};  ///< id; empty: none
};

/// A motion of a step as a plan states it, with what is of the whole step.
struct Step {
  std::vector<BodyId> bodies;  ///< ids of the bodies that leave
  std::vector<Point> path;
  std::vector<std::size_t> after;  ///< steps that have to be carried out before, from 1
  std::vector<StatedAllowance> allowances;
  std::vector<StatedViolation> violates;
  bool certified = true;  ///< the step says that it is certified
  bool flexible = false;  ///< the step says that its one body is flexible, so that its motion is not proved
  std::vector<StatedJoint> joints{};
  std::optional<StatedProof> proof{};
  bool unit = false;  ///< the step says that its bodies are one unit
  std::optional<std::uint64_t> wave{};
  std::optional<std::uint64_t> task{};
  std::size_t number = 1;  ///< number of the step in its list, from 1
  std::size_t motion = 0;  ///< number of the motion in a step of several, from 1; 0: the step has one
};

/// The disassembly of a group that has left, in a frame of the group: only its bodies are there.
struct Line {
  std::size_t step = 0;  ///< number, from 1, of the step by which the group has left, in the plan or in the line above
  std::vector<BodyId> bodies;   ///< ids
  std::vector<BodyId> staying;  ///< ids
  std::vector<Step> steps;      ///< all motions of its steps, in their order
  std::vector<Line> lines;      ///< lines of groups that leave this group
};

/// An assembly plan as its file states it; no statement of it is trusted.
struct Plan {
  std::vector<BodyId> bodies;   ///< ids
  std::vector<BodyId> staying;  ///< ids
  std::vector<Step> steps;      ///< all motions of its steps, in their order
  std::string end;              ///< "complete", "stuck", "time_limit" or "interrupted"
  Demands demands{};
  std::vector<SnapWord> snaps{};  ///< bends of which the plan says that a person has confirmed them
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
