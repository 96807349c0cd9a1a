#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/sequence/line_balance.h"
#include "engine/sequence/work_times.h"

namespace glissade {

/// How long an assembly plan takes people. Steps are in the order of assembly, numbered from 0.
struct PlanTiming {
  std::vector<StepTime> times;
  LineTasks tasks;
  std::vector<std::size_t> chain;     ///< the steps that take longest one after the other
  std::optional<LineBalance> line{};  ///< where a number of stations was asked for
  std::size_t edited = 0;             ///< values of the table that differ from their defaults

  double sum() const;           ///< seconds of one person
  double chainSeconds() const;  ///< of the chain
  /// Steps of a station, ascending. Precondition: line.
  std::vector<std::size_t> stepsAt(std::size_t station) const;
};

/// Errors: as of balanceLine(). Precondition: the plan is about the product.
Result<PlanTiming> planTiming(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& table,
                              std::optional<std::size_t> stations = std::nullopt);

/// "1, 2, 7": numbers for people, from 1.
std::string numbersText(const std::vector<std::size_t>& steps);

}  // namespace glissade
