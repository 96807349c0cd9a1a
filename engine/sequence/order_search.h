#pragma once

#include <functional>
#include <vector>

#include "engine/base/stop_token.h"

namespace glissade {

/// An order of steps that is looked for.
struct OrderQuestion {
  /// Steps that have to be carried out before each one, by index.
  std::vector<std::vector<std::size_t>> after;
  /// What a step costs (>= 0) behind another one, or as the first one (nothing), when `done` have been carried out.
  std::function<double(std::size_t step, const std::size_t* last, const std::vector<bool>& done)> cost;
  /// No more than `cost`, and found more quickly: where it exceeds another step's cost, `cost` is not asked. Null: it
  /// is always asked.
  std::function<double(std::size_t step, const std::size_t* last, const std::vector<bool>& done)> atLeast{};
  std::size_t mostExpansions = 2000;
  double leastGain = 1e-9;  ///< by which an order with a run of steps at another place has to cost less
  /// Steps that keep their index in the order; empty: none. Where some do, `after` has to allow for the order 0, 1, ...
  std::vector<bool> fixed{};
};

/// Best first over costs: states are the steps carried out and the last one of them, and those of the least cost, with
/// the mean cost of a step for each that is missing, are expanded first. Begins with the order that always takes the
/// cheapest step (or with 0, 1, ..., where that leads nowhere because of fixed steps), so there is an order whenever
/// the search ends. Then runs of steps are moved to other places while the order costs less so. Precondition: `after`
/// has no circle.
std::vector<std::size_t> cheapestOrder(const OrderQuestion& question, const StopToken& stop);

/// What an order costs.
double costOf(const std::vector<std::size_t>& order, const OrderQuestion& question);

}  // namespace glissade
