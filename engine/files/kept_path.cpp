#include "engine/files/kept_path.h"

#include <algorithm>

#include "engine/files/kept_path_proof.h"
#include "engine/files/scenario.h"
#include "engine/files/scenario_bodies.h"
#include "engine/planning/coarse/prohibitions.h"

namespace glissade {
namespace {

KeptPathProof proofOf(PathExamination examination, const LoadedScenario& scenario) {
  KeptPathProof proof;
  if (!examination.complete) return proof;
  if (!examination.blocked.empty()) {
    const int body = examination.blocked.front().nearest.body;
    proof.state = KeptPathState::Blocked;
    proof.blockedBy = body < 0 ? BodyId() : scenario.obstacles[static_cast<std::size_t>(body)].id;
    return proof;
  }
  proof.state = examination.holds() ? KeptPathState::Holds : KeptPathState::OtherEnds;
  proof.path = std::make_shared<const Path>(std::move(examination.path));
  return proof;
}

}  // namespace

KeptPath keptPath(const std::string& name, const Path& path, const PathProvenance& provenance, bool smoothed,
                  const LoadedScenario& scenario) {
  KeptPath kept;
  kept.name = name;
  kept.object = idOf(scenario.scenario.object);
  kept.provenance = provenance;
  kept.smoothed = smoothed;
  kept.requiredClearance = path.certificate.tolerance;
  if (path.certificate.nearest.body >= 0) kept.clearance = path.certificate.minClearance;
  kept.provedClearance = path.certificate.provedClearance;
  for (const Fit& fit : scenario.fits.allowed) {
    if (fit.allowance > 0.0) kept.allowances.push_back(static_cast<const Allowance&>(fit));
  }
  kept.problemSha256 = scenario.problemSha256;
  kept.points = path.points;
  return kept;
}

bool hasPoints(const KeptPath& kept, const std::vector<PathPoint>& points) {
  return std::equal(kept.points.begin(), kept.points.end(), points.begin(), points.end(),
                    [](const PathPoint& a, const PathPoint& b) { return a.q == b.q; });
}

std::string freePathName(const KeptPaths& paths, const std::string& stem) {
  const auto taken = [&paths](const std::string& name) {
    return std::any_of(paths.begin(), paths.end(), [&name](const KeptPathPtr& path) { return path->name == name; });
  };
  std::string name = stem;
  for (int number = 2; taken(name); ++number) name = stem + " " + std::to_string(number);
  return name;
}

KeptPathProof proveAgain(const KeptPath& kept, const LoadedScenario& scenario, const WorkWatch& watch) {
  KeptPathProof proof;
  if (kept.object != idOf(scenario.scenario.object)) {
    proof.state = KeptPathState::OtherObject;
    return proof;
  }
  ParameterValues parameters = scenario.parameters;
  // set() fails for an object of another size, whose range does not contain the value. The scenario's own clearance
  // applies then.
  (void)parameters.set(ParameterId::RequiredClearance, kept.requiredClearance);
  const auto problem = keepingOut(scenario.problem, watch.stop);
  if (!problem) return proof;
  return proofOf(examinePath(withUnitRotations(kept.points), *problem, parameters, watch), scenario);
}

}  // namespace glissade
