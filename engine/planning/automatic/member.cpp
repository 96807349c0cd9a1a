#include "engine/planning/automatic/member.h"

#include <cmath>

#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/automatic/shrink_repair.h"

namespace glissade {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Largest distance between two configurations of the problem, in the metric.
double extentOf(const Problem& problem, double turnWeight) {
  return std::hypot(problem.bounds.diagonal().norm(), kPi * turnWeight * problem.world->objectRadius());
}

Member rrtConnect(std::string name, const Contender& contender, const Problem& problem, RrtConnect::Options options) {
  return {std::move(name), contender, [problem, options](std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<RrtConnect>(problem, seed, options,
                                                std::make_unique<UniformSampler>(problem, seed));
          }};
}

double env(const char* n, double d) {
  const char* v = getenv(n);
  return v ? atof(v) : d;
}

Member shrinkRepair(const Problem& problem) {
  const double r = problem.world->objectRadius();
  const RrtConnect::Options search{env("RANGE", 0.03) * extentOf(problem, env("ARM", 1)), env("DOMAIN", 0),
                                   env("ARM", 1), RrtConnect::Growth(int(env("GROW", 0)))};
  const auto worlds = std::make_shared<ErodedWorlds>(problem.world);
  return {"shrink-repair", {1.0, 0, Restart::Luby, 0}, [=](std::uint64_t seed) -> std::unique_ptr<Planner> {
            RandomStream stream(seed, "erosion");
            const double kErosions[] = {env("ER", 0.03), env("ER", 0.05), env("ER", 0.08)};
            const double erosion = kErosions[static_cast<std::size_t>(3.0 * stream.uniform())];
            const ShrinkRepair::Options options{erosion * r, 1e-3 * r, search, std::uint64_t(env("W1", 30000)),
                                                std::uint64_t(env("W2", 20000))};
            return std::make_unique<ShrinkRepair>(problem, seed, options, worlds);
          }};
}

}  // namespace

std::vector<Member> makeMembers(const Problem& problem) {
  std::vector<Member> members;
  const char* only = getenv("AUTO_ONLY");
  members.push_back(rrtConnect("x", {1.0, std::uint64_t(env("LIFE", 400000)), Restart::Luby, 0}, problem,
                               {env("RANGE", 0.03) * extentOf(problem, env("ARM", 1)), env("DOMAIN", 0), env("ARM", 1),
                                RrtConnect::Growth(int(env("GROW", 0)))}));
  members.push_back(shrinkRepair(problem));
  if (only) {
    std::vector<Member> m;
    for (auto& x : members)
      if (x.name == only) m.push_back(x);
    return m;
  }
  return members;
}

}  // namespace glissade
