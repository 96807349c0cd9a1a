#include "app/cli/commands.h"

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "engine/scenario/plan_file.h"
#include "engine/scenario/product_file.h"
#include "engine/scenario/work_times_json.h"
#include "engine/study/plan_timing.h"
#include "engine/study/plan_words.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kEstimates =
    "the times are estimates and were not measured; --write-table writes the table, --table reads an edited one";

const AssemblyStep& stepOf(const AssemblyPlan& plan, std::size_t task) {
  return plan.steps[plan.steps.size() - 1 - task];
}

void printText(const PlanTiming& timing, const AssemblyPlan& plan, const AssembledProduct& product) {
  std::cout << std::fixed << std::setprecision(1);
  std::cout << "step  seconds   fetch   place    turn    tool    hold  parts\n";
  for (std::size_t i = 0; i < timing.times.size(); ++i) {
    const StepTime& time = timing.times[i];
    std::cout << std::setw(4) << i + 1 << std::setw(9) << time.total();
    for (const double part : {time.fetch, time.place, time.turn, time.tool, time.hold}) {
      std::cout << std::setw(8) << part;
    }
    std::cout << "  " << nameOfStep(stepOf(plan, i), product) << "\n";
  }
  std::cout << "one person: " << timing.sum() << " s\n";
  std::cout << "longest chain: " << timing.chainSeconds() << " s, steps " << numbersText(timing.chain) << "\n";
  if (timing.line) {
    const LineBalance& line = *timing.line;
    std::cout << line.load.size() << " stations: a product every " << line.cycle << " s (no division is faster than "
              << line.least << " s), people work " << 100.0 * line.efficiency() << " % of the time\n";
    for (std::size_t s = 0; s < line.load.size(); ++s) {
      std::cout << "  station " << s + 1 << ": " << line.load[s] << " s, steps " << numbersText(timing.stepsAt(s))
                << "\n";
    }
  }
  std::cout << kEstimates << "\n";
}

Json numbersJson(const std::vector<std::size_t>& steps) {
  Json json = Json::array();
  for (const std::size_t step : steps) json.push_back(step + 1);
  return json;
}

Json toJson(const PlanTiming& timing, const AssemblyPlan& plan) {
  Json json{{"steps", Json::array()}};
  for (std::size_t i = 0; i < timing.times.size(); ++i) {
    const StepTime& time = timing.times[i];
    json["steps"].push_back({{"bodies", stepOf(plan, i).bodies()},
                             {"seconds", time.total()},
                             {"fetch_s", time.fetch},
                             {"place_s", time.place},
                             {"turn_s", time.turn},
                             {"tool_s", time.tool},
                             {"hold_s", time.hold}});
    json["steps"].back()["after"] = numbersJson(timing.tasks.before[i]);
  }
  json["sum_s"] = timing.sum();
  json["longest_chain"] = {{"seconds", timing.chainSeconds()}, {"steps", numbersJson(timing.chain)}};
  if (timing.line) {
    json["line"] = {{"cycle_s", timing.line->cycle},
                    {"least_cycle_s", timing.line->least},
                    {"efficiency", timing.line->efficiency()},
                    {"stations", Json::array()}};
    for (std::size_t s = 0; s < timing.line->load.size(); ++s) {
      json["line"]["stations"].push_back(
          {{"seconds", timing.line->load[s]}, {"steps", numbersJson(timing.stepsAt(s))}});
    }
  }
  json["note"] = kEstimates;
  return json;
}

}  // namespace

int runTimes(const TimesOptions& options) {
  const auto plan = readPlan(options.plan);
  if (!plan) return reportError(plan.error(), options.console);
  const auto loaded = loadProduct(options.product, {}, plan->deflection, {{}, plan->bodies});
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings);
  std::vector<std::string> ids;
  for (const RigidBody& body : loaded->product.bodies) ids.push_back(body.id);
  if (const Outcome same = checkSameBodies(*plan, ids, options.plan); !same) {
    return reportError(same.error(), options.console);
  }
  const Result<WorkTimes> table = options.table.empty() ? WorkTimes() : readWorkTimes(options.table);
  if (!table) return reportError(table.error(), options.console);
  if (!options.writeTable.empty()) {
    if (const Outcome saved = saveWorkTimes(*table, options.writeTable); !saved) {
      return reportError(saved.error(), options.console);
    }
  }
  const auto timing = planTiming(*plan, loaded->product, *table, options.stations);
  if (!timing) {
    Diagnostic error = timing.error();
    error.location = "--" + error.location;
    return reportError(error, options.console);
  }
  if (options.console.json) {
    std::cout << toJson(*timing, *plan).dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  } else {
    printText(*timing, *plan, loaded->product);
  }
  return 0;
}

}  // namespace glissade::cli
