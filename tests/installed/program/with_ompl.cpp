// A program outside of the tree: RRT-Connect of OMPL on Glissade's world. The judge checks its path.
#include <glissade/ompl.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

#include <iostream>

namespace g = glissade;

int main() {
  ompl::RNG::setSeed(1);
  const auto cube = g::Mesh::box({0.1, 0.1, 0.1});
  const auto world = g::World::make({{"wall", "", *g::Mesh::box({0.2, 2, 2}), {}}}, *cube);
  const g::Pose start{{-1, 0, 0}, g::Quaternion::Identity()};
  const g::Pose goal{{1, 0, 0}, g::Quaternion::Identity()};
  const auto problem = g::Problem::make(*world, start, goal, g::Box{{-2, -2, -2}, {2, 2, 2}});

  ompl::geometric::SimpleSetup setup(g::spaceInformationOf(*problem));
  ompl::base::ScopedState<ompl::base::SE3StateSpace> from(setup.getStateSpace());
  ompl::base::ScopedState<ompl::base::SE3StateSpace> to(setup.getStateSpace());
  g::setPose(from.get(), problem->start());
  g::setPose(to.get(), *problem->goal());
  setup.setStartAndGoalStates(from, to);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
  if (!setup.solve(30.0)) return 1;
  const auto path = g::Path::make(g::configurationsOf(setup.getSolutionPath()));
  const auto verdict = g::check(*problem, *path);
  std::cout << "path of OMPL valid " << verdict->valid() << "\n";
}
