#include "engine/planning/automatic/member.h"

#include <cmath>

#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/automatic/shrink_repair.h"

namespace glissade {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Largest distance between two configurations of the problem, in the metric.
double extentOf(const Problem& problem) {
  return std::hypot(problem.bounds.diagonal().norm(), kPi * problem.world->objectRadius());
}

Member rrtConnect(std::string name, const Contender& contender, const Problem& problem, double range, double domain) {
  const RrtConnect::Options options{range * extentOf(problem), domain};
  return {std::move(name), contender, [problem, options](std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<RrtConnect>(problem, options, std::make_unique<UniformSampler>(problem, seed));
          }};
}

Member shrinkRepair(const Problem& problem) {
  const double r = problem.world->objectRadius();
  const double range = 0.03 * extentOf(problem);
  const auto worlds = std::make_shared<ErodedWorlds>(problem.world);
  return {"shrink-repair", {1.0, 0, Restart::Luby, 0}, [=](std::uint64_t seed) -> std::unique_ptr<Planner> {
            RandomStream stream(seed, "erosion");
            constexpr double kErosions[] = {0.03, 0.05, 0.08};
            const double erosion = kErosions[static_cast<std::size_t>(3.0 * stream.uniform())];
            const ShrinkRepair::Options options{erosion * r, 1e-3 * r, range, 30'000, 20'000};
            return std::make_unique<ShrinkRepair>(problem, seed, options, worlds);
          }};
}

}  // namespace

std::vector<Member> makeMembers(const Problem& problem) {
  std::vector<Member> members;
  const char* only = getenv("AUTO_ONLY");
  members.push_back(rrtConnect("rrt-connect", {1.0, 400'000, Restart::Luby, 0}, problem, 0.03, 0.0));
  members.push_back(shrinkRepair(problem));
  members.push_back(rrtConnect("dynamic-domain", {1.0, 200'000, Restart::Doubling, 0}, problem, 0.01, 10.0));
  if (only) {
    std::vector<Member> m;
    for (auto& x : members)
      if (x.name == only) m.push_back(x);
    return m;
  }
  return members;
}

}  // namespace glissade
