#include "engine/files/same_problem.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/files/run_record.h"
#include "engine/files/scenario_file.h"

namespace glissade {
namespace {

/// The problem with names, the tree and joints, which records of earlier programs include.
Scenario problemWithNames(const Scenario& scenario) {
  Scenario problem = scenario;
  setSemanticEdits({}, problem);
  const Scenario usual;
  problem.name = problem.description = "";
  problem.wayPoints.clear();
  problem.planner = usual.planner;
  problem.parameters.clear();
  problem.seed = usual.seed;
  problem.paths.clear();
  problem.forbiddenRegions.clear();
  problem.plan.reset();
  problem.leftOut.clear();
  problem.sequence = {};
  for (Asset& asset : problem.assets) {
    asset.path = std::filesystem::path(asset.path).filename().string();  // the scenario may have been saved elsewhere
    asset.sha256.clear();  // the hashes of the assets that were used are compared separately
  }
  return problem;
}

bool allowSame(const Fit& a, const Fit& b) {
  const auto pitch = [](const Fit& fit) { return fit.thread ? fit.thread->rule.pitch : 0.0; };
  return a.object == b.object && a.obstacle == b.obstacle && a.allowance == b.allowance && pitch(a) == pitch(b);
}

}  // namespace

std::string problemSha256(const Scenario& scenario) {
  Scenario problem = problemWithNames(scenario);
  for (std::vector<BodyDescription>* bodies : {&problem.object.bodies, &problem.bodies}) {
    for (BodyDescription& body : *bodies) body.name.clear();
  }
  problem.nodes.clear();
  problem.joints.clear();
  return sha256(scenarioText(problem));
}

bool isSameProblem(const LoadedScenario& a, const LoadedScenario& b) {
  const std::vector<Fit>& before = a.fits.allowed;
  const std::vector<Fit>& after = b.fits.allowed;
  return a.fitsPending == b.fitsPending && a.problemSha256 == b.problemSha256 &&
         std::equal(before.begin(), before.end(), after.begin(), after.end(), allowSame);
}

bool isRecordOf(const RunRecord& record, const LoadedScenario& scenario) {
  return record.problemSha256 == scenario.problemSha256 ||
         record.problemSha256 == sha256(scenarioText(problemWithNames(scenario.scenario)));
}

}  // namespace glissade
