#pragma once

#include "engine/sequence/assembly_plan.h"

namespace glissade::test {

/// A plan that uses every part of the format.
inline AssemblyPlan somePlan() {
  AssemblyPlan plan;
  plan.strategy = "greedy";
  plan.seed = 7;
  plan.bodies = {"plate", "nut", "bolt", "rod"};
  plan.staying = {"plate"};
  const Pose away{{0.1, 0.25, -3.0}, fromRollPitchYaw(0.1, 0.2, 0.3)};
  StepMotion nut{"nut",
                 {{Pose::identity(), Author::Computer}, {away, Author::Contact}},
                 "straight",
                 {0, 1e-6, 2e-6, 3e-6, "bolt"},
                 {{"bolt", ContactKind::Thread, 4e-4, 4.1e-4, Message("nut, 0.41 mm on the thread of bolt (thread)")}}};
  nut.allowances.front().evidence = {4e-4, 1e-5, 1e-9, 1e-6, 2e-5};
  nut.fastener = FastenerKind::Nut;
  nut.tool = {ToolKind::Socket, ToolAccess::Blocked, {"plate", "rod"}, {}, "bolt", ToolKind::HexKey};
  plan.bodies.insert(plan.bodies.end(), {"wheel", "bearing", "washer"});
  StepMotion washer{"washer", nut.path, "straight", nut.proof, {}};
  plan.steps.push_back({{nut, washer}, 1});
  StepMotion group{"wheel", {{Pose::identity(), Author::Computer}, {away, Author::Computer}}, "straight", {}, {}};
  group.proof.required = 1e-6;
  group.with = {"bearing"};
  group.allowances = {
      {"plate", ContactKind::Press, 0.0, 1e-5, Message("plate, 0.01 mm on bearing (press)"), "bearing", true}};
  group.falling = {"rod"};
  plan.steps.push_back({{group}, 2, {1}});
  plan.waiting = {{"rod", nut.path, "straight", nut.proof, {}}};
  plan.demands.before = {{"nut", "bolt"}};
  plan.demands.cost = "few-tools";
  plan.demands.places = {{{"wheel", "bearing"}, 2, true}};
  plan.demands.motions = {{{"nut"}, nut.path, "by hand"}};
  plan.demands.forbidden = {{"bolt", {0.0, 0.0, -1.0}}};
  plan.steps.back().violates = {{StepViolation::Rule::Before, {"bolt"}}, {StepViolation::Rule::Place, {}}};
  plan.deflection = 5e-5;
  plan.refusals = {{"bolt", 0, 0, {"nut", "plate"}}, {"bolt", 1, 1, {"plate"}}, {"rod", 0, 1, {}}};
  plan.refusals.push_back({"bolt", 2, 1, {"plate"}, {"rod"}});
  plan.stuck = {{"bolt", {"plate"}, Message("no motion was found")}, {"rod", {}}};
  plan.end = PlanEnd::Stuck;
  return plan;
}

}  // namespace glissade::test
