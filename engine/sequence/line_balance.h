#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/result.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Tasks of a line: their seconds, and of each the tasks that have to be done before. Tasks are numbered in an order
/// that keeps this: each one only names tasks with lower numbers.
struct LineTasks {
  std::vector<double> seconds;
  std::vector<std::vector<std::size_t>> before;
};

/// The steps of a plan as tasks of assembly: task 0 is the last step of the removal. `seconds`: of each step.
LineTasks lineTasks(const AssemblyPlan& plan, const std::vector<double>& seconds);

/// A division of tasks over stations, one person each. The product passes them in order.
struct LineBalance {
  std::vector<std::size_t> stationOf;  ///< of each task, from 0
  std::vector<double> load;            ///< seconds of each station
  double cycle = 0.0;                  ///< seconds, the largest load
  double least = 0.0;                  ///< seconds: no division has a shorter cycle

  /// Share of the line's time in which people work.
  double efficiency() const;
};

/// The division with the shortest cycle, or one whose distance from it is known (`least`): the simple assembly line
/// balancing problem of type 2 (Scholl, Balancing and Sequencing of Assembly Lines, 1999), an integer program that CBC
/// solves within a number of nodes. The same tasks give the same division on every machine. Errors, Usage: no station,
/// or more than 50; a task before itself or a later one; seconds below 0.
Result<LineBalance> balanceLine(const LineTasks& tasks, std::size_t stations);

/// Numbers of the tasks of the chain that takes longest, in order: no number of people carries out the work faster.
std::vector<std::size_t> longestChain(const LineTasks& tasks);

}  // namespace glissade
