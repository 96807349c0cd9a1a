#include "engine/sequence/order_search.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>

namespace glissade {
namespace {

using CarriedOut = std::vector<bool>;

bool mayFollow(std::size_t step, const CarriedOut& done, const OrderQuestion& question) {
  if (done[step]) return false;
  if (!question.fixed.empty()) {
    const auto place = static_cast<std::size_t>(std::count(done.begin(), done.end(), true));
    if ((question.fixed[place] || question.fixed[step]) && step != place) return false;
  }
  const auto& after = question.after[step];
  return std::all_of(after.begin(), after.end(), [&](std::size_t earlier) { return done[earlier]; });
}

const std::size_t* lastOf(const std::vector<std::size_t>& order) { return order.empty() ? nullptr : &order.back(); }

/// The steps that may follow, each with what it costs at least; the cheapest first, of equal ones the first.
std::vector<std::pair<double, std::size_t>> mayComeNext(const std::vector<std::size_t>& order, const CarriedOut& done,
                                                        const OrderQuestion& question) {
  std::vector<std::pair<double, std::size_t>> steps;
  for (std::size_t step = 0; step < done.size(); ++step) {
    if (!mayFollow(step, done, question)) continue;
    steps.emplace_back(question.atLeast ? question.atLeast(step, lastOf(order), done) : 0.0, step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

/// Always the cheapest step, the first one of equal ones. Shorter where no step may follow.
std::vector<std::size_t> completed(std::vector<std::size_t> order, CarriedOut done, const OrderQuestion& question) {
  while (order.size() < done.size()) {
    std::size_t cheapest = done.size();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [atLeast, step] : mayComeNext(order, done, question)) {
      if (atLeast > least) break;
      const double cost = question.cost(step, lastOf(order), done);
      if (cheapest != done.size() && std::pair(cost, step) >= std::pair(least, cheapest)) continue;
      least = cost;
      cheapest = step;
    }
    if (cheapest == done.size()) return order;
    done[cheapest] = true;
    order.push_back(cheapest);
  }
  return order;
}

struct Node {
  double estimate;
  std::size_t number;  ///< of equal ones the first
  double cost;
  std::vector<std::size_t> order;
  CarriedOut done;

  bool operator<(const Node& other) const {
    return std::pair(other.estimate, other.number) < std::pair(estimate, number);
  }
};

}  // namespace

double costOf(const std::vector<std::size_t>& order, const OrderQuestion& question) {
  CarriedOut done(order.size(), false);
  double cost = 0.0;
  const std::size_t* last = nullptr;
  for (const std::size_t& step : order) {
    cost += question.cost(step, last, done);
    done[step] = true;
    last = &step;
  }
  return cost;
}

std::vector<std::size_t> cheapestOrder(const OrderQuestion& question, const StopToken& stop) {
  const std::size_t steps = question.after.size();
  std::vector<std::size_t> best = completed({}, CarriedOut(steps, false), question);
  if (best.size() < steps) {
    best.resize(steps);
    std::iota(best.begin(), best.end(), std::size_t{0});
  }
  double least = costOf(best, question);
  const double mean = steps == 0 ? 0.0 : least / static_cast<double>(steps);
  std::priority_queue<Node> open;
  std::map<std::pair<CarriedOut, std::size_t>, double> known;
  std::size_t number = 0;
  open.push({least, number++, 0.0, {}, CarriedOut(steps, false)});
  for (std::size_t expansions = 0; expansions < question.mostExpansions && !open.empty(); ++expansions) {
    if (stop.stopRequested()) break;
    const Node node = open.top();
    open.pop();
    if (node.cost >= least) continue;
    if (node.order.size() == steps) {
      best = node.order;
      least = node.cost;
      continue;
    }
    for (std::size_t step = 0; step < steps; ++step) {
      if (!mayFollow(step, node.done, question)) continue;
      Node next{0.0, number, node.cost + question.cost(step, lastOf(node.order), node.done), node.order, node.done};
      next.order.push_back(step);
      next.done[step] = true;
      if (next.cost >= least) continue;
      const auto [at, isNew] = known.try_emplace({next.done, step}, next.cost);
      if (!isNew && at->second <= next.cost) continue;
      at->second = next.cost;
      next.estimate = next.cost + mean * static_cast<double>(steps - next.order.size());
      ++number;
      open.push(std::move(next));
    }
  }
  return best;
}

}  // namespace glissade
