#include <glissade/assembly_plan.h>

#include <nlohmann/json.hpp>

#include "engine/api/values.h"
#include "engine/files/plan_file.h"

namespace glissade::api {
namespace {

Motion publicMotion(const StepMotion& motion) {
  std::vector<Pose> path;
  for (const PathPoint& point : motion.path) path.push_back(publicPose(point.q));
  return {textsOf(motion.bodies()),   motion.method, std::move(path), motion.certified, motion.proof.minClearance,
          motion.proof.nearest.text()};
}

Step publicStep(const AssemblyStep& step) {
  std::vector<Motion> motions;
  for (const StepMotion& motion : step.motions) motions.push_back(publicMotion(motion));
  return {textsOf(step.bodies()), std::move(motions), step.after};
}

PlanEnd publicEnd(glissade::PlanEnd end) {
  switch (end) {
    case glissade::PlanEnd::Complete: return PlanEnd::Complete;
    case glissade::PlanEnd::Stuck: return PlanEnd::Stuck;
    case glissade::PlanEnd::TimeLimit: return PlanEnd::TimeLimit;
    case glissade::PlanEnd::Interrupted: break;
  }
  return PlanEnd::Interrupted;
}

}  // namespace

std::vector<Step> AssemblyPlan::steps() const {
  std::vector<Step> all;
  for (const AssemblyStep& step : impl().plan.steps) all.push_back(publicStep(step));
  return all;
}

PlanEnd AssemblyPlan::end() const { return publicEnd(impl().plan.end); }
std::size_t AssemblyPlan::parts() const { return impl().plan.parts(); }
std::size_t AssemblyPlan::removed() const { return impl().plan.removed(); }
std::vector<std::string> AssemblyPlan::staying() const { return textsOf(impl().plan.staying); }

std::vector<StuckBody> AssemblyPlan::stuck() const {
  std::vector<StuckBody> all;
  for (const glissade::StuckBody& body : impl().plan.stuck) {
    all.push_back({body.body.text(), textsOf(body.blockedBy), toString(body.reason)});
  }
  return all;
}

std::string AssemblyPlan::json(const std::string& product) const {
  // Names come from files and can hold invalid UTF-8.
  return planJson(impl().plan, product).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Outcome AssemblyPlan::save(const std::string& file, const std::string& product) const {
  return attempt<Done>("saving a plan", [&]() -> Outcome {
    const auto saved = savePlan(impl().plan, product, file);
    return saved ? Outcome(Done{}) : Outcome(publicDiagnostic(saved.error()));
  });
}

}  // namespace glissade::api
