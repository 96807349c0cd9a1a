#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/result.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Tasks of an assembly line: their seconds, and for each task the tasks that have to be done before. Each task names
/// only tasks with lower numbers.
struct LineTasks {
  std::vector<double> seconds;
  std::vector<std::vector<std::size_t>> before;
};

/// The steps of a plan as tasks of assembly: task 0 is the last step of the removal. `seconds`: one entry for each
/// step.
LineTasks lineTasks(const AssemblyPlan& plan, const std::vector<double>& seconds);

/// A division of tasks over stations, one person each. The product passes them in order.
struct LineBalance {
  std::vector<std::size_t> stationOf;  ///< station of each task, from 0
  std::vector<double> load;            ///< seconds of each station
  double cycle = 0.0;                  ///< seconds, the largest load
  double least = 0.0;                  ///< seconds, lower bound of the cycle

  /// Share of the stations' time in which people work.
  double efficiency() const;
};

/// A division with the shortest cycle, or one whose distance from it is bounded by `least`: the simple assembly line
/// balancing problem of type 2 (Scholl, Balancing and Sequencing of Assembly Lines, 1999), an integer program that CBC
/// solves within a limit of nodes. The same tasks give the same division on every machine. Errors, Usage: no station,
/// or more than 50; a task before itself or a later one; negative seconds.
Result<LineBalance> balanceLine(const LineTasks& tasks, std::size_t stations);

/// The tasks of the chain that takes longest, in order. The work takes at least this long with any number of people.
std::vector<std::size_t> longestChain(const LineTasks& tasks);

}  // namespace glissade
