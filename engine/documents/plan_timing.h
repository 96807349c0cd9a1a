#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/sequence/line_balance.h"
#include "engine/sequence/work_times.h"

namespace glissade {

/// Times of an assembly plan for people. Steps are in the order of assembly, numbered from 0.
struct PlanTiming {
  std::vector<StepTime> times;
  LineTasks tasks;
  std::vector<std::size_t> chain;     ///< chain of dependent steps with the longest time
  std::optional<LineBalance> line{};  ///< balance of the line, if a number of stations is given
  std::size_t edited = 0;             ///< number of table values that differ from their defaults

  double sum() const;           ///< Sum of all steps, seconds of one person.
  double chainSeconds() const;  ///< Time of the chain, seconds.
  /// Steps of a station, ascending. Precondition: line.
  std::vector<std::size_t> stepsAt(std::size_t station) const;
};

/// Computes the times. Errors are those of balanceLine(). Precondition: the plan is about the product.
Result<PlanTiming> planTiming(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& table,
                              std::optional<std::size_t> stations = std::nullopt);

/// Step numbers for people, from 1: "1, 2, 7".
std::string numbersText(const std::vector<std::size_t>& steps);

}  // namespace glissade
