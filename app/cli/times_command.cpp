#include "app/cli/commands.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/text_cells.h"
#include "engine/documents/plan_timing.h"
#include "engine/documents/plan_words.h"
#include "engine/files/plan_file.h"
#include "engine/files/product_file.h"
#include "engine/files/work_times_json.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CatalogueText kEstimates = GLISSADE_TEXT(
    "the times are estimates and were not measured; --write-table writes the table, --table reads an edited one");

const AssemblyStep& stepOf(const AssemblyPlan& plan, std::size_t task) {
  return plan.steps[plan.steps.size() - 1 - task];
}

void printTable(const PlanTiming& timing, const AssemblyPlan& plan, const AssembledProduct& product,
                const Console& console) {
  console.print(GLISSADE_TEXT("step  seconds   fetch   place    turn    tool    hold  parts"));
  for (std::size_t i = 0; i < timing.times.size(); ++i) {
    const StepTime& time = timing.times[i];
    std::cout << toRight(std::to_string(i + 1), 4) << toRight(fixedDigits(time.total(), 1), 9);
    for (const double part : {time.fetch, time.place, time.turn, time.tool, time.hold}) {
      std::cout << toRight(fixedDigits(part, 1), 8);
    }
    std::cout << "  " << nameOfStep(stepOf(plan, i), product) << "\n";
  }
}

/// Prints how the steps are divided over the stations of a line.
void printLine(const LineBalance& line, const PlanTiming& timing, const Console& console) {
  console.print({GLISSADE_TEXT("%1 {1|station|stations}: cycle time %2 s (minimum %3 s), utilization %4 %"),
                 {line.load.size(), fixedDigits(line.cycle, 1), fixedDigits(line.least, 1),
                  fixedDigits(100.0 * line.efficiency(), 1)}});
  for (std::size_t s = 0; s < line.load.size(); ++s) {
    console.print({GLISSADE_TEXT("  station %1: %2 s, steps %3"),
                   {s + 1, fixedDigits(line.load[s], 1), numbersText(timing.stepsAt(s))}});
  }
}

void printText(const PlanTiming& timing, const AssemblyPlan& plan, const AssembledProduct& product,
               const Console& console) {
  printTable(timing, plan, product, console);
  console.print({GLISSADE_TEXT("one person: %1 s"), {fixedDigits(timing.sum(), 1)}});
  console.print({GLISSADE_TEXT("critical path: %1 s, steps %2"),
                 {fixedDigits(timing.chainSeconds(), 1), numbersText(timing.chain)}});
  if (timing.line) printLine(*timing.line, timing, console);
  console.print(kEstimates);
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
  json["note"] = kEstimates.english;
  return json;
}

}  // namespace

int runTimes(const TimesOptions& options) {
  const auto plan = readPlan(options.plan);
  if (!plan) return reportError(plan.error(), options.console);
  const auto loaded = loadProduct(options.product, {}, plan->deflection, {{}, plan->bodies});
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  if (const Outcome same = checkSameBodies(*plan, loaded->product, options.plan); !same) {
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
    error.location = "--" + toString(error.location);
    return reportError(error, options.console);
  }
  if (options.console.json) {
    std::cout << toJson(*timing, *plan).dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  } else {
    printText(*timing, *plan, loaded->product, options.console);
  }
  return 0;
}

}  // namespace glissade::cli
