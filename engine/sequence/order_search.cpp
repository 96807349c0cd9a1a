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

/// The number of the step at `place` of the order, see OrderQuestion::numbers.
std::size_t numberAt(std::size_t place, const std::vector<std::size_t>& order, const OrderQuestion& question) {
  std::size_t number = 1;
  for (std::size_t i = 1; i <= place; ++i) {
    number += question.continues && question.continues(order[i], order[i - 1]) ? 0 : 1;
  }
  return number;
}

/// True if the step at `place` has the number that it keeps, and takes none from another step.
bool keepsNumbers(std::size_t place, const std::vector<std::size_t>& order, const OrderQuestion& question) {
  if (question.numbers.empty()) return true;
  const std::size_t step = order[place];
  const std::size_t number = numberAt(place, order, question);
  if (question.numbers[step] != 0) return number == question.numbers[step];
  const bool continues = place > 0 && question.continues && question.continues(step, order[place - 1]);
  return continues || std::find(question.numbers.begin(), question.numbers.end(), number) == question.numbers.end();
}

bool mayFollow(std::size_t step, const std::vector<std::size_t>& order, const CarriedOut& done,
               const OrderQuestion& question) {
  const auto& after = question.after[step];
  if (done[step] || std::any_of(after.begin(), after.end(), [&](std::size_t earlier) { return !done[earlier]; })) {
    return false;
  }
  if (question.numbers.empty()) return true;
  std::vector<std::size_t> longer = order;
  longer.push_back(step);
  return keepsNumbers(order.size(), longer, question);
}

const std::size_t* lastOf(const std::vector<std::size_t>& order) { return order.empty() ? nullptr : &order.back(); }

/// The steps that may follow, each with its least cost; the cheapest first, ties by index.
std::vector<std::pair<double, std::size_t>> mayComeNext(const std::vector<std::size_t>& order, const CarriedOut& done,
                                                        const OrderQuestion& question) {
  std::vector<std::pair<double, std::size_t>> steps;
  for (std::size_t step = 0; step < done.size(); ++step) {
    if (!mayFollow(step, order, done, question)) continue;
    steps.emplace_back(question.atLeast ? question.atLeast(step, lastOf(order), done) : 0.0, step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

/// Completes the order: always the cheapest step, the first one of equal ones. The result is shorter if no step may
/// follow.
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

/// The steps that may be the last ones of those that are left: no other one of them has to come after them.
std::vector<std::size_t> mayComeLast(const CarriedOut& left, const OrderQuestion& question) {
  std::vector<bool> isNeeded(left.size(), false);
  for (std::size_t step = 0; step < left.size(); ++step) {
    if (!left[step]) continue;
    for (const std::size_t earlier : question.after[step]) isNeeded[earlier] = true;
  }
  std::vector<std::size_t> steps;
  for (std::size_t step = 0; step < left.size(); ++step) {
    if (left[step] && !isNeeded[step]) steps.push_back(step);
  }
  return steps;
}

/// Builds the order from its end: always the step that costs least together with the step that follows it. It finds
/// what grows from the base in the order of assembly, which an order that begins with the cheapest removals does not.
std::vector<std::size_t> completedFromTheEnd(const OrderQuestion& question) {
  CarriedOut left(question.after.size(), true);
  std::vector<std::size_t> fromTheEnd;
  while (fromTheEnd.size() < left.size()) {
    std::size_t cheapest = left.size();
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t step : mayComeLast(left, question)) {
      const double ofNext = fromTheEnd.empty() ? 0.0 : question.cost(fromTheEnd.back(), &step, left);
      left[step] = false;
      const double cost = ofNext + question.cost(step, nullptr, left);
      left[step] = true;
      if (cost >= least) continue;
      least = cost;
      cheapest = step;
    }
    left[cheapest] = false;
    fromTheEnd.push_back(cheapest);
  }
  std::reverse(fromTheEnd.begin(), fromTheEnd.end());
  return fromTheEnd;
}

struct Node {
  double estimate;
  std::size_t number;  ///< nodes with equal estimates are expanded in this order
  double cost;         ///< cost without the last step's cost until that is known
  bool isCostKnown;
  std::vector<std::size_t> order;
  CarriedOut done;

  bool operator<(const Node& other) const {
    return std::pair(other.estimate, other.number) < std::pair(estimate, number);
  }
};

/// The search of cheapestOrder(). The cost of a step is computed only when its state is expanded.
class OrderSearch {
 public:
  OrderSearch(const OrderQuestion& question, const StopToken& stop)
      : question_(question), stop_(stop), steps_(question.after.size()) {
    best_ = completed({}, CarriedOut(steps_, false), question);
    if (best_.size() < steps_) {
      best_.resize(steps_);
      std::iota(best_.begin(), best_.end(), std::size_t{0});
    }
    least_ = costOf(best_, question);
    if (question.numbers.empty()) takeIfLess(completedFromTheEnd(question));
    mean_ = steps_ == 0 ? 0.0 : least_ / static_cast<double>(steps_);
    open_.push({least_, number_++, 0.0, true, {}, CarriedOut(steps_, false)});
  }

  std::vector<std::size_t> run() {
    for (std::size_t expansions = 0; expansions < question_.mostExpansions && !open_.empty();) {
      if (stop_.stopRequested()) break;
      Node node = open_.top();
      open_.pop();
      if (!node.isCostKnown) {
        addCost(std::move(node));
        continue;
      }
      ++expansions;
      if (node.cost >= least_) continue;
      if (node.order.size() == steps_) {
        best_ = std::move(node.order);
        least_ = node.cost;
      } else {
        expand(node);
      }
    }
    return std::move(best_);
  }

 private:
  void takeIfLess(std::vector<std::size_t> order) {
    const double cost = costOf(order, question_);
    if (cost >= least_) return;
    least_ = cost;
    best_ = std::move(order);
  }

  double estimateOf(double cost, std::size_t carriedOut) const {
    return cost + mean_ * static_cast<double>(steps_ - carriedOut);
  }

  void expand(const Node& node) {
    for (std::size_t step = 0; step < steps_; ++step) {
      if (!mayFollow(step, node.order, node.done, question_)) continue;
      const double atLeast = question_.atLeast ? question_.atLeast(step, lastOf(node.order), node.done) : 0.0;
      if (node.cost + atLeast >= least_) continue;
      Node next{0.0, number_++, node.cost, false, node.order, node.done};
      next.order.push_back(step);
      next.done[step] = true;
      next.estimate = estimateOf(node.cost + atLeast, next.order.size());
      open_.push(std::move(next));
    }
  }

  /// Adds the cost of the last step. A state that was reached at less or the same cost is dropped.
  void addCost(Node node) {
    const std::size_t step = node.order.back();
    node.order.pop_back();
    node.done[step] = false;
    node.cost += question_.cost(step, lastOf(node.order), node.done);
    node.order.push_back(step);
    node.done[step] = true;
    if (node.cost >= least_) return;
    const auto [at, isNew] = known_.try_emplace({node.done, step}, node.cost);
    if (!isNew && at->second <= node.cost) return;
    at->second = node.cost;
    node.isCostKnown = true;
    node.estimate = estimateOf(node.cost, node.order.size());
    open_.push(std::move(node));
  }

  const OrderQuestion& question_;
  const StopToken& stop_;
  std::size_t steps_;
  std::vector<std::size_t> best_;
  double least_ = 0.0;  ///< cost of the best order
  double mean_ = 0.0;   ///< mean cost of a step
  std::priority_queue<Node> open_;
  std::map<std::pair<CarriedOut, std::size_t>, double> known_;  ///< cost of states
  std::size_t number_ = 0;
};

/// Moves runs of steps to other places while this reduces the cost (I. Or, 1976). A move changes only the costs between
/// the two places.
class RunMover {
 public:
  RunMover(std::vector<std::size_t> order, const OrderQuestion& question, const StopToken& stop)
      : question_(question), stop_(stop), order_(std::move(order)) {}

  /// Asks all moves in turn, until each of them was asked after the last one that reduced the cost.
  std::vector<std::size_t> run() {
    const std::size_t count = order_.size();
    const std::size_t longest = std::min(kMostMoved, count - 1);
    const std::size_t moves = longest * count * count;
    for (std::size_t next = 0, without = 0; without < moves; next = (next + 1) % moves, ++without) {
      if (asked_ >= kMostAsked || stop_.stopRequested()) break;
      const std::size_t length = 1 + next / (count * count);
      const std::size_t from = next / count % count;
      const std::size_t to = next % count;
      const bool isMove = to != from && from + length <= count && to + length <= count;
      if (isMove && move(from, length, to)) without = 0;
    }
    return std::move(order_);
  }

 private:
  /// Moves the run to this place; true if the order costs less.
  bool move(std::size_t from, std::size_t length, std::size_t to) {
    std::vector<std::size_t> moved = order_;
    const auto at = [&](std::size_t place) { return moved.begin() + static_cast<std::ptrdiff_t>(place); };
    if (from < to) {
      std::rotate(at(from), at(from + length), at(to + length));
    } else {
      std::rotate(at(to), at(from), at(from + length));
    }
    const std::size_t first = std::min(from, to);
    const std::size_t end = std::min(std::max(from, to) + length + 1, order_.size());
    if (!isAllowed(moved, first, end)) return false;
    if (!costsLess(moved, first, end, costBetween(order_, first, end, question_.cost) - question_.leastGain))
      return false;
    order_ = std::move(moved);
    return true;
  }

  CarriedOut doneBefore(const std::vector<std::size_t>& order, std::size_t place) const {
    CarriedOut done(order.size(), false);
    for (std::size_t i = 0; i < place; ++i) done[order[i]] = true;
    return done;
  }

  /// The order is new from `first` to `end`. Numbers may change up to the end of the order.
  bool isAllowed(const std::vector<std::size_t>& order, std::size_t first, std::size_t end) const {
    CarriedOut done = doneBefore(order, first);
    for (std::size_t place = first; place < end; ++place) {
      const auto& after = question_.after[order[place]];
      if (std::any_of(after.begin(), after.end(), [&](std::size_t earlier) { return !done[earlier]; })) return false;
      done[order[place]] = true;
    }
    for (std::size_t place = first; place < order.size() && !question_.numbers.empty(); ++place) {
      if (!keepsNumbers(place, order, question_)) return false;
    }
    return true;
  }

  /// True if the steps between the places cost less than the limit. Bounds of all steps are added first; then one
  /// after the other is replaced by the cost of its step, while the sum is below the limit.
  bool costsLess(const std::vector<std::size_t>& order, std::size_t first, std::size_t end, double limit) {
    if (!question_.atLeast) return costBetween(order, first, end, question_.cost) < limit;
    double sum = costBetween(order, first, end, question_.atLeast);
    CarriedOut done = doneBefore(order, first);
    for (std::size_t place = first; place < end && sum < limit; ++place) {
      const std::size_t* last = place == 0 ? nullptr : &order[place - 1];
      sum += question_.cost(order[place], last, done) - question_.atLeast(order[place], last, done);
      done[order[place]] = true;
      ++asked_;
    }
    return sum < limit;
  }

  template <class Cost>
  double costBetween(const std::vector<std::size_t>& order, std::size_t first, std::size_t end, const Cost& cost) {
    CarriedOut done = doneBefore(order, first);
    double sum = 0.0;
    for (std::size_t place = first; place < end; ++place) {
      sum += cost(order[place], place == 0 ? nullptr : &order[place - 1], done);
      done[order[place]] = true;
      ++asked_;
    }
    return sum;
  }

  static constexpr std::size_t kMostMoved = 12;
  static constexpr std::size_t kMostAsked = 50000;

  const OrderQuestion& question_;
  const StopToken& stop_;
  std::vector<std::size_t> order_;
  std::size_t asked_ = 0;  ///< number of computed costs
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
  std::vector<std::size_t> order = OrderSearch(question, stop).run();
  return order.size() < 2 ? order : RunMover(std::move(order), question, stop).run();
}

}  // namespace glissade
