#include "app/cli/times_command.h"

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/scenario/plan_file.h"
#include "engine/scenario/product_file.h"
#include "engine/scenario/work_times_json.h"
#include "engine/sequence/line_balance.h"
#include "engine/study/plan_words.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kEstimates =
    "the times are estimates and were not measured; --write-table writes the table, --table reads an edited one";

/// What is said of a plan; steps in the order of assembly.
struct Timing {
  const AssemblyPlan& plan;
  const AssembledProduct& product;
  std::vector<StepTime> times;  ///< of each step
  LineTasks tasks;
  std::vector<std::size_t> chain;
  std::optional<LineBalance> line;

  std::string nameOf(std::size_t task) const { return nameOfStep(plan.steps[plan.steps.size() - 1 - task], product); }
  double sum() const { return std::accumulate(tasks.seconds.begin(), tasks.seconds.end(), 0.0); }
  double chainSeconds() const {
    double seconds = 0.0;
    for (const std::size_t task : chain) seconds += tasks.seconds[task];
    return seconds;
  }
  /// Steps of a station, from 1.
  std::vector<std::size_t> stepsAt(std::size_t station) const {
    std::vector<std::size_t> steps;
    for (std::size_t i = 0; i < line->stationOf.size(); ++i) {
      if (line->stationOf[i] == station) steps.push_back(i + 1);
    }
    return steps;
  }
};

Timing timingOf(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& table) {
  std::vector<StepTime> times = stepTimes(plan, product, table);
  std::vector<double> seconds;
  for (const StepTime& time : times) seconds.push_back(time.total());
  LineTasks tasks = lineTasks(plan, seconds);
  std::vector<std::size_t> chain = longestChain(tasks);
  return {plan, product, {times.rbegin(), times.rend()}, std::move(tasks), std::move(chain), std::nullopt};
}

std::string listed(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (const std::size_t number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
}

void printText(const Timing& timing) {
  std::cout << std::fixed << std::setprecision(1);
  std::cout << "step  seconds   fetch   place    turn    tool    hold  parts\n";
  for (std::size_t i = 0; i < timing.times.size(); ++i) {
    const StepTime& time = timing.times[i];
    std::cout << std::setw(4) << i + 1 << std::setw(9) << time.total();
    for (const double part : {time.fetch, time.place, time.turn, time.tool, time.hold}) {
      std::cout << std::setw(8) << part;
    }
    std::cout << "  " << timing.nameOf(i) << "\n";
  }
  std::vector<std::size_t> chain;
  for (const std::size_t task : timing.chain) chain.push_back(task + 1);
  std::cout << "one person: " << timing.sum() << " s\n";
  std::cout << "longest chain: " << timing.chainSeconds() << " s, steps " << listed(chain) << "\n";
  if (timing.line) {
    const LineBalance& line = *timing.line;
    std::cout << line.load.size() << " stations: a product every " << line.cycle << " s (no division is faster than "
              << line.least << " s), people work " << 100.0 * line.efficiency() << " % of the time\n";
    for (std::size_t s = 0; s < line.load.size(); ++s) {
      std::cout << "  station " << s + 1 << ": " << line.load[s] << " s, steps " << listed(timing.stepsAt(s)) << "\n";
    }
  }
  std::cout << kEstimates << "\n";
}

Json toJson(const Timing& timing) {
  Json json{{"steps", Json::array()}};
  for (std::size_t i = 0; i < timing.times.size(); ++i) {
    const StepTime& time = timing.times[i];
    json["steps"].push_back({{"bodies", timing.plan.steps[timing.plan.steps.size() - 1 - i].bodies()},
                             {"seconds", time.total()},
                             {"fetch_s", time.fetch},
                             {"place_s", time.place},
                             {"turn_s", time.turn},
                             {"tool_s", time.tool},
                             {"hold_s", time.hold}});
    Json after = Json::array();
    for (const std::size_t earlier : timing.tasks.before[i]) after.push_back(earlier + 1);
    json["steps"].back()["after"] = after;
  }
  json["sum_s"] = timing.sum();
  json["longest_chain"] = {{"seconds", timing.chainSeconds()}, {"steps", Json::array()}};
  for (const std::size_t task : timing.chain) json["longest_chain"]["steps"].push_back(task + 1);
  if (timing.line) {
    json["line"] = {{"cycle_s", timing.line->cycle},
                    {"least_cycle_s", timing.line->least},
                    {"efficiency", timing.line->efficiency()},
                    {"stations", Json::array()}};
    for (std::size_t s = 0; s < timing.line->load.size(); ++s) {
      json["line"]["stations"].push_back({{"seconds", timing.line->load[s]}, {"steps", timing.stepsAt(s)}});
    }
  }
  json["note"] = kEstimates;
  return json;
}

}  // namespace

int runTimes(const TimesOptions& options) {
  const auto plan = readPlan(options.plan);
  if (!plan) return reportError(plan.error(), options.format);
  const auto loaded = loadProduct(options.product, {}, plan->deflection);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  std::vector<std::string> ids;
  for (const RigidBody& body : loaded->product.bodies) ids.push_back(body.id);
  if (const Outcome same = checkSameBodies(*plan, ids, options.plan); !same) {
    return reportError(same.error(), options.format);
  }
  const Result<WorkTimes> table = options.table.empty() ? WorkTimes() : readWorkTimes(options.table);
  if (!table) return reportError(table.error(), options.format);
  if (!options.writeTable.empty()) {
    if (const Outcome saved = saveWorkTimes(*table, options.writeTable); !saved) {
      return reportError(saved.error(), options.format);
    }
  }
  Timing timing = timingOf(*plan, loaded->product, *table);
  if (options.stations) {
    auto line = balanceLine(timing.tasks, *options.stations);
    if (!line) {
      Diagnostic error = line.error();
      error.location = "--" + error.location;
      return reportError(error, options.format);
    }
    timing.line = *std::move(line);
  }
  if (options.format == Format::Json) {
    std::cout << toJson(timing).dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  } else {
    printText(timing);
  }
  return 0;
}

}  // namespace glissade::cli
