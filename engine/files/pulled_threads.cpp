#include "engine/files/pulled_threads.h"

#include <map>

#include "engine/files/scenario_fits.h"
#include "engine/fits/fit_words.h"
#include "engine/fits/judged_threads.h"

namespace glissade {
namespace {

/// The object, which is the last body, and the bodies that it fits.
struct ObjectInFits {
  AssembledProduct product;
  std::vector<std::vector<Fit>> fits{};  ///< with each other body
};

ObjectInFits objectInFits(const LoadedScenario& scenario) {
  std::map<std::size_t, std::vector<Fit>> byObstacle;
  for (const Fit& fit : scenario.fits.allowed) byObstacle[fit.obstacle].push_back(fit);
  const AssembledProduct all = objectAndOthers(scenario);
  ObjectInFits found{all};
  found.product.bodies.clear();
  found.product.deflections.clear();
  found.product.spacings.clear();
  const auto add = [&](std::size_t body) {
    found.product.bodies.push_back(all.bodies[body]);
    found.product.deflections.push_back(all.deflections[body]);
    found.product.spacings.push_back(all.spacings[body]);
  };
  for (auto& [obstacle, fits] : byObstacle) {
    add(obstacle);
    found.fits.push_back(std::move(fits));
  }
  add(all.bodies.size() - 1);
  return found;
}

}  // namespace

std::vector<Message> pulledThreadsOf(const LoadedScenario& scenario, const std::vector<PathPoint>& path,
                                     const StopToken& stop) {
  const SequenceDemands& demands = scenario.scenario.sequence;
  if (scenario.fits.allowed.empty() || demands.jointUse == JointUse::Off) return {};
  const ObjectInFits found = objectInFits(scenario);
  const AssembledProduct& product = found.product;
  const std::size_t object = product.bodies.size() - 1;
  const std::vector<Pose> configurations = configurationsOf(path);
  std::vector<JointEdit> edits = scenario.scenario.joints;
  edits.insert(edits.end(), demands.joints.begin(), demands.joints.end());
  JudgedThreads judged(product, partingsOf(edits));
  std::vector<Message> pulled;
  for (std::size_t other = 0; other < object; ++other) {
    const Message thread = evidence::pulledThread(judged.of(object, other, found.fits[other], stop), configurations);
    if (thread.empty()) continue;
    pulled.push_back({GLISSADE_TEXT("not for assembly: the path pulls '%1' through the thread of '%2' without a turn "
                                    "(%3)"),
                      {product.bodies[object].shown(), product.bodies[other].shown(), thread}});
  }
  return pulled;
}

}  // namespace glissade
