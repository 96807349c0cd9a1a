#pragma once

#include <string>
#include <vector>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// A joint of a screw, a nut or a flexible body, as a file states it. Bodies by id, lengths in metres.
struct StatedJoint {
  std::string kind;
  std::string body;
  std::vector<std::string> others;
  std::vector<std::string> clamped{};
  Point point{0.0, 0.0, 0.0};
  Point direction{0.0, 0.0, 1.0};
  double pitch = 0.0;   ///< a turn; below 0: left-handed; 0: no thread
  double travel = 0.0;  ///< until the thread is free

  bool isScrewed() const { return kind == "screw" || kind == "nut" || kind == "thread"; }
};

/// A step of a plan: who leaves, and where the frame of the step is.
struct StatedStep {
  std::vector<std::string> bodies;
  std::vector<Placement> path;
  bool certified = true;
  std::vector<std::string> threads{};  ///< bodies that its fits call its threads
};

/// A plan, or a line of a group that is taken apart by itself.
struct StatedLine {
  std::size_t step = 0;             ///< from 1, by which it has left; 0: the plan
  std::vector<std::string> bodies;  ///< of all
  std::vector<std::string> staying;
  std::vector<StatedStep> steps;
  std::vector<std::string> stuck;
  std::vector<StatedLine> lines;
};

/// What a plan does that a fitter would refuse, for people; empty: nothing.
/// - a thread opens: on all of the way until it is free the step turns about its axis by its pitch, no point of the
///   axis is off it by more than two hundredths of the pitch
/// - a body leaves from another one that its own allowances call a thread, without a turn
/// - a body leaves that a closed joint clamps
/// - a screw or a nut leaves after what it clamps, although its thread was closed then
/// - a body is there twice, or not at all: each leaves once, stays, or is stuck
/// - a step without a proof that is of no flexible body
std::vector<std::string> violationsOf(const StatedLine& plan, const std::vector<StatedJoint>& joints);

/// Of files as `glissade-cli sequence --out` and `glissade-cli joints --json` write them. `suggested`: joints that
/// nobody has confirmed count, too. Throws std::runtime_error.
StatedLine readStatedPlan(const std::string& file);
std::vector<StatedJoint> readStatedJoints(const std::string& file, bool suggested);

}  // namespace glissade::oracle
