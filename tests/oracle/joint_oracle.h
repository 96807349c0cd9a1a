#pragma once

#include <string>
#include <vector>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// A joint of a screw, a nut or a flexible body, as a file states it. Bodies are given by id, lengths in metres.
struct StatedJoint {
  std::string kind;
  std::string body;
  std::vector<std::string> others;
  std::vector<std::string> clamped{};
  Point point{0.0, 0.0, 0.0};
  Point direction{0.0, 0.0, 1.0};
  double pitch = 0.0;   ///< advance per turn; below 0: left-handed; 0: no thread
  double travel = 0.0;  ///< length until the thread is free

  bool isScrewed() const { return kind == "screw" || kind == "nut" || kind == "thread"; }
};

/// A motion of a step of a plan: the bodies that leave, and the frame of the motion.
struct StatedStep {
  std::vector<std::string> bodies;
  std::vector<Placement> path;
  bool certified = true;
  std::vector<std::string> threads{};  ///< bodies that its fits state as its threads
  bool continues = false;              ///< it is of the step of the motion before it
};

/// A plan, or the line of a group that is disassembled by itself.
struct StatedLine {
  std::size_t step = 0;             ///< step by which the group has left, from 1; 0: the plan
  std::vector<std::string> bodies;  ///< all bodies
  std::vector<std::string> staying;
  std::vector<StatedStep> steps;  ///< the motions of all steps
  std::vector<std::string> stuck;
  std::vector<StatedLine> lines;
};

/// The violations for which an assembler would refuse a plan, as texts; empty: none.
/// - a thread opens, unless the step turns about its axis by its pitch on the whole motion until it is free, and no
///   point of the axis is off it by more than two hundredths of the pitch
/// - a body leaves without a turn from another body although its own allowances state a thread between them
/// - a body leaves that a closed joint clamps
/// - a screw or a nut leaves after the bodies that it clamps, although its thread was closed then
/// - a body is there twice, or not at all: each leaves once, stays, or is stuck
/// - a step of no flexible body has no proof
std::vector<std::string> violationsOf(const StatedLine& plan, const std::vector<StatedJoint>& joints);

/// Both read the files that `glissade-cli sequence --out` and `glissade-cli joints --json` write. `suggested`:
/// unconfirmed joints count too. They throw std::runtime_error.
StatedLine readStatedPlan(const std::string& file);
std::vector<StatedJoint> readStatedJoints(const std::string& file, bool suggested);

}  // namespace glissade::oracle
