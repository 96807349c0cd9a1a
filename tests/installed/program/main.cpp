// A program outside of the tree: it plans, checks, takes a product apart and adds a planner.
#include <glissade/glissade.h>

#include <iostream>

namespace g = glissade;

int fail(const g::Diagnostic& why) {
  std::cerr << why.text() << "\n";
  return 1;
}

int main(int, char** argv) {
  const auto scenario = g::load<g::Scenario>(argv[1]);
  if (!scenario) return fail(scenario.error());
  const g::Run run = g::plan(*scenario, {.strategy = "birrt", .seed = 1});
  if (!run.path) return fail(run.path.error());
  const auto verdict = g::check(*scenario, *run.path);
  if (!verdict) return fail(verdict.error());
  std::cout << "path valid " << verdict->valid() << "\n";

  const auto product = g::load<g::Product>(argv[2]);
  if (!product) return fail(product.error());
  const auto plan = g::sequence(*product);
  if (!plan) return fail(plan.error());
  std::cout << "removed " << plan->removed() << " of " << plan->parts() << "\n";

  g::Planners planners;
  const auto straight = [](g::PlannerContext& context) {
    return std::vector{context.problem().start(), *context.problem().goal()};
  };
  if (const auto added = planners.add("straight", straight); !added) return fail(added.error());
  const auto cube = g::Mesh::box({0.1, 0.1, 0.1});
  const auto world = g::World::make({{"wall", "", *cube, {}}}, *cube);
  const auto problem = g::Problem::make(*world, {{-1, 0, 0.3}, {1, 0, 0, 0}}, g::Pose{{1, 0, 0.3}, {1, 0, 0, 0}});
  const g::Run own = g::plan(*problem, {.strategy = "straight", .planners = &planners});
  if (!own.path) return fail(own.path.error());
  std::cout << "own planner certified " << own.path->certificate().certified() << "\n";
  std::cout << "version " << g::libraryVersion() << "\n";
}
