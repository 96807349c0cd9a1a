#include "engine/planning/nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
/// A leaf with more configurations is split, if they differ.
constexpr std::size_t kMostInALeaf = 32;
/// Single precision rounds seven coordinates, their differences, squares and sum by less than this
/// share of the largest coordinate, or of the distance.
constexpr double kRounding = 16.0 * std::numeric_limits<float>::epsilon();

template <class Point>
float squaredToBox(const Point& p, const Point& low, const Point& high) {
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < p.size(); ++axis) {
    const float outside = std::max(0.0F, std::max(low[axis] - p[axis], p[axis] - high[axis]));
    sum += outside * outside;
  }
  return sum;
}

}  // namespace

/// What one question has found so far.
struct NearestNeighbours::Search {
  const Pose& q;
  Point point;   ///< of q with one sign of its quaternion
  double scale;  ///< largest coordinate that has a part in it
  std::size_t best = std::numeric_limits<std::size_t>::max();
  double squared = std::numeric_limits<double>::infinity();
  double distance = 0.0;
  float limit = kFar;  ///< what is farther, squared and in single precision, cannot be the nearest

  void consider(std::size_t place, double away) {
    const double awaySquared = away * away;
    if (awaySquared > squared || (awaySquared == squared && place > best)) return;
    best = place;
    squared = awaySquared;
    distance = away;
    const double reach = away * (1.0 + kRounding) + kRounding * scale;
    limit = std::nextafter(static_cast<float>(reach * reach), kFar);
  }
};

NearestNeighbours::Point NearestNeighbours::pointOf(const Pose& q) const {
  const Vector3 p = q.position - origin_;
  const auto& r = q.orientation.coeffs();
  const double weight = 2.0 * metric_.radius();
  const auto single = [](double value) { return static_cast<float>(value); };
  return {single(p.x()),         single(p.y()),         single(p.z()),        single(weight * r[0]),
          single(weight * r[1]), single(weight * r[2]), single(weight * r[3])};
}

void NearestNeighbours::add(std::uint32_t index, const Pose& q) {
  if (nodes_.empty()) {
    origin_ = q.position;
    nodes_.emplace_back();
    nodes_.front().low.fill(kFar);
    nodes_.front().high.fill(-kFar);
  }
  const auto place = static_cast<std::uint32_t>(poses_.size());
  poses_.push_back(q);
  indices_.push_back(index);
  const Point point = pointOf(q);
  for (const float value : point) scale_ = std::max(scale_, static_cast<double>(std::abs(value)));
  std::uint32_t node = 0;
  while (nodes_[node].children != 0) {
    Node& inner = nodes_[node];
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      inner.low[axis] = std::min(inner.low[axis], point[axis]);
      inner.high[axis] = std::max(inner.high[axis], point[axis]);
    }
    node = inner.children + (point[inner.axis] < inner.split ? 0U : 1U);
  }
  addToLeaf(node, place, point);
  if (nodes_[node].count > kMostInALeaf) splitLeaf(node);
}

void NearestNeighbours::addToLeaf(std::uint32_t node, std::uint32_t place, const Point& point) {
  Node& leaf = nodes_[node];
  const std::size_t lane = leaf.count % kLanes;
  if (lane == 0) {
    leaf.packets.emplace_back();
    for (auto& axis : leaf.packets.back().at) axis.fill(kFar);
  }
  Packet& packet = leaf.packets.back();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    packet.at[axis][lane] = point[axis];
    leaf.low[axis] = std::min(leaf.low[axis], point[axis]);
    leaf.high[axis] = std::max(leaf.high[axis], point[axis]);
  }
  packet.place[lane] = place;
  ++leaf.count;
}

/// At the middle of the widest axis. Configurations that are all alike stay together.
void NearestNeighbours::splitLeaf(std::uint32_t node) {
  std::size_t axis = 0;
  const auto width = [&](std::size_t a) { return nodes_[node].high[a] - nodes_[node].low[a]; };
  for (std::size_t a = 1; a < kAxes; ++a) {
    if (width(a) > width(axis)) axis = a;
  }
  const float split = nodes_[node].low[axis] + 0.5F * width(axis);
  if (!(nodes_[node].low[axis] < split && split <= nodes_[node].high[axis])) return;
  const std::vector<Packet> packets = std::move(nodes_[node].packets);
  const std::size_t count = nodes_[node].count;
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  for (std::uint32_t child = children; child < children + 2; ++child) {
    nodes_[child].low.fill(kFar);
    nodes_[child].high.fill(-kFar);
  }
  nodes_[node].children = children;
  nodes_[node].axis = axis;
  nodes_[node].split = split;
  nodes_[node].packets = {};
  nodes_[node].count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Packet& packet = packets[i / kLanes];
    Point point;
    for (std::size_t a = 0; a < kAxes; ++a) point[a] = packet.at[a][i % kLanes];
    addToLeaf(children + (point[axis] < split ? 0U : 1U), packet.place[i % kLanes], point);
  }
}

void NearestNeighbours::look(const Packet& packet, Search& search) const {
  std::array<float, kLanes> squared{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float offset = packet.at[axis][lane] - search.point[axis];
      squared[lane] += offset * offset;
    }
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (squared[lane] == kFar || squared[lane] > search.limit) continue;
    const std::uint32_t place = packet.place[lane];
    search.consider(place, metric_.distance(poses_[place], search.q));
  }
}

void NearestNeighbours::visit(std::uint32_t at, Search& search) const {
  const Node& node = nodes_[at];
  if (node.children == 0) {
    for (const Packet& packet : node.packets) look(packet, search);
    return;
  }
  const auto away = [&](std::uint32_t child) {
    return squaredToBox(search.point, nodes_[child].low, nodes_[child].high);
  };
  std::uint32_t first = node.children;
  std::uint32_t second = node.children + 1;
  float toFirst = away(first);
  float toSecond = away(second);
  if (toSecond < toFirst) {
    std::swap(first, second);
    std::swap(toFirst, toSecond);
  }
  if (toFirst <= search.limit) visit(first, search);
  if (toSecond <= search.limit) visit(second, search);
}

std::optional<NearestNeighbours::Neighbour> NearestNeighbours::nearest(const Pose& q) const {
  if (nodes_.empty()) return std::nullopt;
  Search search{q, pointOf(q), scale_};
  for (const float value : search.point) search.scale = std::max(search.scale, static_cast<double>(std::abs(value)));
  visit(0, search);
  for (std::size_t axis = 3; axis < kAxes; ++axis) search.point[axis] = -search.point[axis];
  visit(0, search);
  return Neighbour{indices_[search.best], search.distance};
}

}  // namespace glissade
