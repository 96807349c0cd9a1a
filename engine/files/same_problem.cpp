#include "engine/files/same_problem.h"

#include <algorithm>

#include "engine/files/run_record.h"

namespace glissade {
namespace {

std::string problemWithoutNames(Scenario scenario) {
  for (std::vector<BodyDescription>* bodies : {&scenario.object.bodies, &scenario.bodies}) {
    for (BodyDescription& body : *bodies) body.name.clear();
  }
  return problemSha256(scenario);
}

bool allowSame(const Fit& a, const Fit& b) {
  const auto pitch = [](const Fit& fit) { return fit.thread ? fit.thread->rule.pitch : 0.0; };
  return a.object == b.object && a.obstacle == b.obstacle && a.allowance == b.allowance && pitch(a) == pitch(b);
}

}  // namespace

bool isSameProblem(const LoadedScenario& a, const LoadedScenario& b) {
  if (&a == &b) return true;
  const std::vector<Fit>& before = a.fits.allowed;
  const std::vector<Fit>& after = b.fits.allowed;
  return a.fitsPending == b.fitsPending &&
         std::equal(before.begin(), before.end(), after.begin(), after.end(), allowSame) &&
         problemWithoutNames(a.scenario) == problemWithoutNames(b.scenario);
}

}  // namespace glissade
