#include "engine/planning/automatic/assembly_sampler.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr double kKeptShare = 0.25;  ///< share of the orientations that are those of the start or the goal
constexpr double kMargin = 0.5;      ///< margin about the tree's box, in radii of the object

}  // namespace

AssemblySampler::AssemblySampler(const Problem& problem, std::uint64_t seed, double nearShare)
    : uniform_(problem, seed),
      stream_(seed, "assembly"),
      bounds_(problem.bounds),
      orientations_{problem.start.orientation},
      nearShare_(problem.region ? 0.0 : nearShare),
      margin_(kMargin * problem.world->objectRadius()) {
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) orientations_.push_back(goal->orientation);
}

Pose AssemblySampler::draw(const Box3& tree) {
  Pose q = uniform_.draw(tree);
  if (drawn_ < kUniform) {
    ++drawn_;
    return q;
  }
  if (stream_.uniform() < nearShare_) q.position = near(tree);
  const double kept = stream_.uniform() / kKeptShare;
  if (kept < 1.0)
    q.orientation = orientations_[static_cast<std::size_t>(kept * static_cast<double>(orientations_.size()))];
  return q;
}

Vector3 AssemblySampler::near(const Box3& tree) {
  Vector3 position;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::max(bounds_.min()[axis], tree.min()[axis] - margin_);
    const double high = std::min(bounds_.max()[axis], tree.max()[axis] + margin_);
    position[axis] = stream_.uniform(low, high);
  }
  return position;
}

}  // namespace glissade
