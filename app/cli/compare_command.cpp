#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "engine/files/compared_plan.h"
#include "engine/files/plan_file.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

void printPlan(const ComparedPlan& plan, const Console& console) {
  for (const Message& line : inWords(plan)) console.print(line);
  if (plan.holds()) return;
  console.print(
      GLISSADE_TEXT("Plan again with 'glissade-cli sequence NEW --reuse PLAN --out FILE': motions of steps "
                    "that hold are taken over."));
}

Json toJson(const ProductChanges& changes, const AssembledProduct& before, const AssembledProduct& now) {
  Json json{{"unchanged", changes.unchanged},
            {"came", Json::array()},
            {"went", Json::array()},
            {"renamed", Json::array()},
            {"changed", Json::array()}};
  for (const std::size_t body : changes.came) json["came"].push_back(now.bodies[body].id);
  for (const std::size_t body : changes.went) json["went"].push_back(before.bodies[body].id);
  for (const auto& [earlier, later] : changes.renamed) {
    json["renamed"].push_back({{"before", before.bodies[earlier].id}, {"now", now.bodies[later].id}});
  }
  for (const ChangedPart& part : changes.changed) {
    json["changed"].push_back({{"body", now.bodies[part.now].id},
                               {"reshaped_m", part.reshaped},
                               {"moved_m", part.moved},
                               {"turned_rad", part.turned}});
  }
  return json;
}

void addPlan(const ComparedPlan& plan, Json& json) {
  json["steps"] = Json::array();
  for (const ComparedStep& step : plan.steps) {
    json["steps"].push_back({{"number", step.number}, {"bodies", step.bodies}, {"holds", step.holds}});
    if (!step.gone.empty()) json["steps"].back()["gone"] = step.gone;
    if (!step.holds) json["steps"].back()["reason"] = toString(step.why);
  }
  json["without_step"] = plan.withoutStep;
}

}  // namespace

int runCompare(const CompareOptions& options) {
  const Interrupt interrupt;
  const StopToken stop = interrupt.token();
  std::optional<AssemblyPlan> plan;
  if (!options.plan.empty()) {
    auto read = readPlan(options.plan);
    if (!read) return reportError(read.error(), options.console);
    plan = std::move(*read);
  }
  const double deflection = plan ? plan->deflection : 0.0;
  const PartChoice choice{{}, plan ? plan->bodies : std::vector<BodyId>()};
  const auto before = loadProduct(options.before, stop, deflection, choice);
  if (!before) return reportError(before.error(), options.console);
  auto now = loadProduct(options.now, stop, deflection, choice);
  if (!now) return reportError(now.error(), options.console);
  if (plan) {
    if (const Outcome same = checkSameBodies(*plan, before->product, options.plan); !same)
      return reportError(same.error(), options.console);
  }
  reportWarnings(now->warnings, options.console);
  now->product = withIdsOf(before->product, std::move(now->product));
  const ProductChanges changes = changesBetween(before->product, now->product, stop);
  std::optional<ComparedPlan> compared;
  if (plan) compared = comparePlan(*plan, before->product, *now, changes, stop);
  if (interrupt.requested()) return exitCode(ErrorKind::Interrupted);
  if (options.console.json) {
    Json json = toJson(changes, before->product, now->product);
    if (compared) addPlan(*compared, json);
    printJson(json);
  } else {
    for (const Message& line : inWords(changes, before->product, now->product)) options.console.print(line);
    if (compared) printPlan(*compared, options.console);
  }
  const bool same = compared ? compared->holds() : changes.none();
  return same ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
