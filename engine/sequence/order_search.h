#pragma once

#include <functional>
#include <vector>

#include "engine/base/stop_token.h"

namespace glissade {

/// A search for the cheapest order of steps.
struct OrderQuestion {
  /// For each step, the indices of the steps that have to be carried out before it.
  std::vector<std::vector<std::size_t>> after;
  /// Cost (>= 0) of a step after the step `last` (null: it is the first one), when the steps of `done` have been
  /// carried out.
  std::function<double(std::size_t step, const std::size_t* last, const std::vector<bool>& done)> cost;
  /// A lower bound of `cost` that is computed more quickly: if it exceeds another step's cost, `cost` is not called.
  /// Null: `cost` is always called.
  std::function<double(std::size_t step, const std::size_t* last, const std::vector<bool>& done)> atLeast{};
  std::size_t mostExpansions = 2000;
  double leastGain = 1e-9;  ///< least reduction of the cost for which a run of steps is moved
  /// True if `step` counts as one with the step before it. Null: each step counts.
  std::function<bool(std::size_t step, std::size_t before)> continues{};
  /// For each step, the number that it keeps, from 1, by the count of `continues`; 0: any. Empty: all have any. If some
  /// keep theirs, the order 0, 1, ... has to be one in which they have it, and `after` has to permit it.
  std::vector<std::size_t> numbers{};
};

/// Best-first search over costs. A state consists of the steps carried out and the last one of them. States with the
/// least cost, plus the mean cost of a step for each missing step, are expanded first. The search begins with the
/// cheaper of two orders: the one that always takes the cheapest step (or 0, 1, ... if kept numbers make that order
/// impossible), and the one that is built so from its end. So there is always a result. Finally runs of steps are moved
/// to other places while that reduces the cost. Precondition: `after` has no circle.
std::vector<std::size_t> cheapestOrder(const OrderQuestion& question, const StopToken& stop);

double costOf(const std::vector<std::size_t>& order, const OrderQuestion& question);

}  // namespace glissade
