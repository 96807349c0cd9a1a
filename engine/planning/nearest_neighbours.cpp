#include "engine/planning/nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
/// The grid is laid anew each time there are this many times more configurations.
constexpr std::size_t kGrowth = 4;
constexpr double kNodesPerCell = 6.0;
constexpr int kMostCells = 64;  // along an axis

}  // namespace

void NearestNeighbours::add(std::uint32_t index, const Pose& q) {
  x_.push_back(q.position.x());
  y_.push_back(q.position.y());
  z_.push_back(q.position.z());
  qx_.push_back(q.orientation.x());
  qy_.push_back(q.orientation.y());
  qz_.push_back(q.orientation.z());
  qw_.push_back(q.orientation.w());
  indices_.push_back(index);
  if (indices_.size() == nextBuild_) {
    buildGrid();
  } else if (!grid_.empty()) {
    cell(cellOf(x_.back(), y_.back(), z_.back())).push_back(static_cast<std::uint32_t>(indices_.size() - 1));
  }
}

/// Configurations outside the box that there was when the grid was laid go to the cells at its rim.
NearestNeighbours::GridIndex NearestNeighbours::cellOf(double x, double y, double z) const {
  const Vector3 scaled = (Vector3(x, y, z) - least_) / edge_;
  GridIndex c{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    c[a] = static_cast<int>(std::clamp(std::floor(scaled[axis]), 0.0, counts_[a] - 1.0));
  }
  return c;
}

void NearestNeighbours::buildGrid() {
  Box3 box;
  for (std::size_t i = 0; i < indices_.size(); ++i) box.extend(Vector3(x_[i], y_[i], z_[i]));
  const Vector3 sizes = box.sizes().cwiseMax(1e-3 * box.sizes().maxCoeff()).cwiseMax(1e-9);
  edge_ = std::cbrt(sizes.prod() * kNodesPerCell / static_cast<double>(indices_.size()));
  edge_ = std::max(edge_, sizes.maxCoeff() / kMostCells);
  least_ = box.min();
  for (int axis = 0; axis < 3; ++axis) {
    counts_[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::ceil(sizes[axis] / edge_)));
  }
  grid_.assign(flat({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 1, {});
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    cell(cellOf(x_[i], y_[i], z_[i])).push_back(static_cast<std::uint32_t>(i));
  }
  nextBuild_ *= kGrowth;
}

void NearestNeighbours::consider(std::size_t i, const Pose& q, Best& best) const {
  // Below rounding a node may only win by really being nearer.
  constexpr double kSlack = 1.0 + 1e-12;
  const double dx = x_[i] - q.position.x();
  const double dy = y_[i] - q.position.y();
  const double dz = z_[i] - q.position.z();
  const double dot = std::abs(qx_[i] * q.orientation.x() + qy_[i] * q.orientation.y() + qz_[i] * q.orientation.z() +
                              qw_[i] * q.orientation.w());
  // angle >= 2 * chord on the unit sphere of quaternions, so angle^2 >= 8 (1 - |dot|).
  const double lowerBound = dx * dx + dy * dy + dz * dz + metric_.radius() * metric_.radius() * 8.0 * (1.0 - dot);
  if (lowerBound > best.squared * kSlack) return;
  const Pose node{{x_[i], y_[i], z_[i]}, Quaternion(qw_[i], qx_[i], qy_[i], qz_[i])};
  const double distance = metric_.distance(node, q);
  const double squared = distance * distance;
  if (squared < best.squared || (squared == best.squared && i < best.at)) best = {i, squared, distance};
}

/// Ring after ring of cells about that of q. A cell k rings away is at least k - 1 edges away.
void NearestNeighbours::searchGrid(const Pose& q, Best& best) const {
  const GridIndex centre = cellOf(q.position.x(), q.position.y(), q.position.z());
  const int farthest = *std::max_element(counts_.begin(), counts_.end());
  for (int ring = 0; ring <= farthest; ++ring) {
    const double least = std::max(0, ring - 1) * edge_;
    if (least * least > best.squared) return;
    const auto low = [&](std::size_t a) { return std::max(0, centre[a] - ring); };
    const auto high = [&](std::size_t a) { return std::min(counts_[a] - 1, centre[a] + ring); };
    for (int x = low(0); x <= high(0); ++x) {
      for (int y = low(1); y <= high(1); ++y) {
        const bool rim = std::abs(x - centre[0]) == ring || std::abs(y - centre[1]) == ring;
        // Inside the ring only the two cells at its ends are new.
        for (int z = rim ? low(2) : centre[2] - ring; z <= high(2); z += rim || ring == 0 ? 1 : 2 * ring) {
          if (z < 0) continue;
          for (const std::uint32_t i : grid_[flat({x, y, z})]) consider(i, q, best);
        }
      }
    }
  }
}

std::optional<NearestNeighbours::Neighbour> NearestNeighbours::nearest(const Pose& q) const {
  Best best{kNone, std::numeric_limits<double>::infinity(), 0.0};
  if (grid_.empty()) {
    for (std::size_t i = 0; i < indices_.size(); ++i) consider(i, q, best);
  } else {
    searchGrid(q, best);
  }
  if (best.at == kNone) return std::nullopt;
  return Neighbour{indices_[best.at], best.distance};
}

}  // namespace glissade
