#include "engine/sequence/line_balance.h"

#include <coin/Cbc_C_Interface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>

namespace glissade {
namespace {

constexpr std::size_t kMostStations = 50;
/// Binary variables of the largest integer program. Larger problems are divided in the order of the plan.
constexpr std::size_t kMostBinaries = 4'000;
constexpr const char* kMostNodes = "2000";
/// A cycle within this share of the shortest one is accepted: estimates of times are not more exact.
constexpr const char* kGoodEnough = "0.005";
constexpr double kHalf = 0.5;

LineBalance balanceOf(const LineTasks& tasks, std::vector<std::size_t> stationOf, std::size_t stations, double least) {
  LineBalance balance{std::move(stationOf), std::vector<double>(stations, 0.0), 0.0, least};
  for (std::size_t i = 0; i < tasks.seconds.size(); ++i) balance.load[balance.stationOf[i]] += tasks.seconds[i];
  balance.cycle = *std::max_element(balance.load.begin(), balance.load.end());
  balance.least = std::min(balance.least, balance.cycle);
  return balance;
}

/// Lower bound of the cycle: the longest task, and the total time divided by the number of stations.
double simpleBound(const LineTasks& tasks, std::size_t stations) {
  if (tasks.seconds.empty()) return 0.0;
  const double sum = std::accumulate(tasks.seconds.begin(), tasks.seconds.end(), 0.0);
  return std::max(*std::max_element(tasks.seconds.begin(), tasks.seconds.end()), sum / static_cast<double>(stations));
}

/// The best division that keeps the order of the tasks: each station does tasks that follow each other.
std::vector<std::size_t> dividedInOrder(const LineTasks& tasks, std::size_t stations) {
  const std::size_t count = tasks.seconds.size();
  std::vector<double> sums(count + 1, 0.0);
  for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + tasks.seconds[i];
  // cycle[s][n]: the best cycle of the first n tasks on the first s stations.
  std::vector<std::vector<double>> cycle(stations + 1, std::vector<double>(count + 1, sums[count]));
  std::vector<std::vector<std::size_t>> from(stations + 1, std::vector<std::size_t>(count + 1, 0));
  cycle[0].assign(count + 1, std::numeric_limits<double>::infinity());
  cycle[0][0] = 0.0;
  for (std::size_t s = 1; s <= stations; ++s) {
    for (std::size_t n = 0; n <= count; ++n) {
      cycle[s][n] = std::numeric_limits<double>::infinity();
      for (std::size_t first = 0; first <= n; ++first) {
        const double longest = std::max(cycle[s - 1][first], sums[n] - sums[first]);
        if (longest >= cycle[s][n]) continue;
        cycle[s][n] = longest;
        from[s][n] = first;
      }
    }
  }
  std::vector<std::size_t> stationOf(count, 0);
  std::size_t end = count;
  for (std::size_t s = stations; s > 0; --s) {
    for (std::size_t i = from[s][end]; i < end; ++i) stationOf[i] = s - 1;
    end = from[s][end];
  }
  return stationOf;
}

struct CbcDeleter {
  void operator()(Cbc_Model* model) const { Cbc_deleteModel(model); }
};

/// The integer program: a binary variable for each task at each station, and the cycle.
class Program {
 public:
  Program(const LineTasks& tasks, std::size_t stations, double least, double most)
      : tasks_(tasks), stations_(stations), cycle_(static_cast<int>(tasks.seconds.size() * stations)) {
    model_.reset(Cbc_newModel());
    Cbc_setParameter(model_.get(), "logLevel", "0");
    Cbc_setParameter(model_.get(), "maxNodes", kMostNodes);
    Cbc_setParameter(model_.get(), "ratioGap", kGoodEnough);
    for (int i = 0; i < cycle_; ++i) Cbc_addCol(model_.get(), "", 0.0, 1.0, 0.0, 1, 0, nullptr, nullptr);
    Cbc_addCol(model_.get(), "", least, most, 1.0, 0, 0, nullptr, nullptr);
    addRows();
  }

  /// Nothing if no division was found within the limits.
  std::optional<std::vector<std::size_t>> solve() {
    Cbc_solve(model_.get());
    if (Cbc_numberSavedSolutions(model_.get()) == 0) return std::nullopt;
    const double* values = Cbc_getColSolution(model_.get());
    std::vector<std::size_t> stationOf(tasks_.seconds.size(), 0);
    for (std::size_t i = 0; i < stationOf.size(); ++i) {
      for (std::size_t s = 0; s < stations_; ++s) {
        if (values[column(i, s)] > kHalf) stationOf[i] = s;
      }
    }
    return stationOf;
  }
  double bound() const { return Cbc_getBestPossibleObjValue(model_.get()); }

 private:
  int column(std::size_t task, std::size_t station) const { return static_cast<int>(task * stations_ + station); }

  void addRow(const std::vector<int>& columns, const std::vector<double>& values, char sense, double right) {
    Cbc_addRow(model_.get(), "", static_cast<int>(columns.size()), columns.data(), values.data(), sense, right);
  }

  void addRows() {
    for (std::size_t i = 0; i < tasks_.seconds.size(); ++i) {
      std::vector<int> columns;
      for (std::size_t s = 0; s < stations_; ++s) columns.push_back(column(i, s));
      addRow(columns, std::vector<double>(stations_, 1.0), 'E', 1.0);
      for (const std::size_t earlier : tasks_.before[i]) addOrder(earlier, i);
    }
    for (std::size_t s = 0; s < stations_; ++s) {
      std::vector<int> columns{cycle_};
      std::vector<double> values{-1.0};
      for (std::size_t i = 0; i < tasks_.seconds.size(); ++i) {
        columns.push_back(column(i, s));
        values.push_back(tasks_.seconds[i]);
      }
      addRow(columns, values, 'L', 0.0);
    }
  }

  /// If the later task is at one of the first stations, so is the earlier one.
  void addOrder(std::size_t earlier, std::size_t later) {
    std::vector<int> columns;
    std::vector<double> values;
    for (std::size_t s = 0; s + 1 < stations_; ++s) {
      columns.push_back(column(later, s));
      values.push_back(1.0);
      columns.push_back(column(earlier, s));
      values.push_back(-1.0);
      addRow(columns, values, 'L', 0.0);
    }
  }

  const LineTasks& tasks_;
  std::size_t stations_;
  int cycle_;  ///< column of the cycle
  std::unique_ptr<Cbc_Model, CbcDeleter> model_;
};

Outcome checked(const LineTasks& tasks, std::size_t stations) {
  if (stations == 0 || stations > kMostStations) {
    return Diagnostic{ErrorKind::Usage,
                      "",
                      "stations",
                      {GLISSADE_TEXT("is not from 1 to %1"), {kMostStations}},
                      GLISSADE_TEXT("Give a number of stations in this range.")};
  }
  for (std::size_t i = 0; i < tasks.seconds.size(); ++i) {
    if (!(tasks.seconds[i] >= 0.0) || !std::isfinite(tasks.seconds[i])) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "seconds",
                        {GLISSADE_TEXT("of task %1 are below 0, or no number"), {i + 1}},
                        GLISSADE_TEXT("Give finite seconds, 0 or more.")};
    }
    for (const std::size_t earlier : tasks.before[i]) {
      if (earlier < i) continue;
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "before",
                        {GLISSADE_TEXT("names task %1, which is no earlier one, for task %2"), {earlier + 1, i + 1}},
                        GLISSADE_TEXT("Number the tasks in an order that can be carried out.")};
    }
  }
  return Done{};
}

}  // namespace

LineTasks lineTasks(const AssemblyPlan& plan, const std::vector<double>& seconds) {
  const std::size_t count = plan.steps.size();
  LineTasks tasks{{seconds.rbegin(), seconds.rend()}, std::vector<std::vector<std::size_t>>(count)};
  for (std::size_t step = 0; step < count; ++step) {
    for (const std::size_t earlier : plan.steps[step].after) {
      tasks.before[count - earlier].push_back(count - 1 - step);
    }
  }
  return tasks;
}

double LineBalance::efficiency() const {
  const double sum = std::accumulate(load.begin(), load.end(), 0.0);
  return cycle > 0.0 ? sum / (cycle * static_cast<double>(load.size())) : 1.0;
}

Result<LineBalance> balanceLine(const LineTasks& tasks, std::size_t stations) {
  if (const Outcome fine = checked(tasks, stations); !fine) return fine.error();
  const double least = simpleBound(tasks, stations);
  LineBalance best = balanceOf(tasks, dividedInOrder(tasks, stations), stations, least);
  const bool isSmall = tasks.seconds.size() * stations <= kMostBinaries;
  if (!isSmall || best.cycle <= least) return best;
  Program program(tasks, stations, least, best.cycle);
  const auto found = program.solve();
  best.least = std::clamp(program.bound(), least, best.cycle);
  if (!found) return best;
  LineBalance better = balanceOf(tasks, *found, stations, best.least);
  return better.cycle < best.cycle ? better : best;
}

std::vector<std::size_t> longestChain(const LineTasks& tasks) {
  const std::size_t count = tasks.seconds.size();
  std::vector<double> until(count, 0.0);
  std::vector<std::size_t> comesFrom(count, count);
  std::size_t last = count;
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t earlier : tasks.before[i]) {
      if (comesFrom[i] == count || until[earlier] > until[comesFrom[i]]) comesFrom[i] = earlier;
    }
    until[i] = tasks.seconds[i] + (comesFrom[i] == count ? 0.0 : until[comesFrom[i]]);
    if (last == count || until[i] > until[last]) last = i;
  }
  std::vector<std::size_t> chain;
  for (; last != count; last = comesFrom[last]) chain.push_back(last);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace glissade
