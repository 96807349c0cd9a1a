#include "engine/planning/nearest_neighbours.h"

#include <cmath>
#include <limits>

namespace glissade {

void NearestNeighbours::add(std::uint32_t index, const Pose& q) {
  x_.push_back(q.position.x());
  y_.push_back(q.position.y());
  z_.push_back(q.position.z());
  qx_.push_back(q.orientation.x());
  qy_.push_back(q.orientation.y());
  qz_.push_back(q.orientation.z());
  qw_.push_back(q.orientation.w());
  indices_.push_back(index);
}

std::optional<NearestNeighbours::Neighbour> NearestNeighbours::nearest(const Pose& q) const {
  const double radiusSquared = metric_.radius() * metric_.radius();
  // Below rounding a node may only win by really being nearer.
  constexpr double kSlack = 1.0 + 1e-12;
  double best = std::numeric_limits<double>::infinity();
  std::optional<Neighbour> result;
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    const double dx = x_[i] - q.position.x();
    const double dy = y_[i] - q.position.y();
    const double dz = z_[i] - q.position.z();
    const double dot = std::abs(qx_[i] * q.orientation.x() + qy_[i] * q.orientation.y() + qz_[i] * q.orientation.z() +
                                qw_[i] * q.orientation.w());
    // angle >= 2 * chord on the unit sphere of quaternions, so angle^2 >= 8 (1 - |dot|).
    const double lowerBound = dx * dx + dy * dy + dz * dz + radiusSquared * 8.0 * (1.0 - dot);
    if (lowerBound >= best * kSlack) continue;
    const Pose node{{x_[i], y_[i], z_[i]}, Quaternion(qw_[i], qx_[i], qy_[i], qz_[i])};
    const double distance = metric_.distance(node, q);
    if (distance * distance < best) {
      best = distance * distance;
      result = Neighbour{indices_[i], distance};
    }
  }
  return result;
}

}  // namespace glissade
