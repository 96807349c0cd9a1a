#include "engine/planning/nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace glissade {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Most configurations in a leaf. A fuller leaf is split, unless all are equal.
constexpr std::size_t kMostInALeaf = 32;
/// Single precision rounds seven coordinates, their differences, squares, sums and the series below by less
/// than this share of the largest coordinate, or of the distance.
constexpr double kRounding = 32.0 * std::numeric_limits<float>::epsilon();

/// Four numbers of a box or a point.
using Four = float __attribute__((vector_size(16)));

template <class Point>
Four fourOf(const Point& point, std::size_t first) {
  Four four;
  std::memcpy(&four, point.data() + first, sizeof four);
  return four;
}

float sum(Four four) { return (four[0] + four[1]) + (four[2] + four[3]); }

/// Squared distances of four coordinates from intervals; 0 inside.
template <class Point>
float squaredOutside(const Point& p, const Point& low, const Point& high, std::size_t first) {
  const Four below = fourOf(low, first) - fourOf(p, first);
  const Four above = fourOf(p, first) - fourOf(high, first);
  const Four farther = below > above ? below : above;
  const Four outside = farther > Four{} ? farther : Four{};
  return sum(outside * outside);
}

}  // namespace

/// State of one query.
struct NearestNeighbours::Search {
  const Pose& q;
  Point point;      ///< q with one sign of its quaternion
  double scale;     ///< largest coordinate in the computation
  float curvature;  ///< 1 / (4 r)^2
  std::size_t best = std::numeric_limits<std::size_t>::max();
  double squared = std::numeric_limits<double>::infinity();
  double distance = 0.0;
  float limit = kInfinity;  ///< squared distance in single precision beyond which no configuration can be the nearest

  /// A lower bound of the squared metric from the squared chord (times 2 r) and the squared translation: the angle is 4
  /// asin(chord / 2), and asin(x)^2 = x^2 + x^4 / 3 + 8 x^6 / 45 + ...
  float bound(float chord, float way) const {
    const float x = chord * curvature;
    return chord * (1.0F + x * (1.0F / 3.0F + x * (8.0F / 45.0F))) + way;
  }

  void consider(std::size_t entry, double away) {
    const double awaySquared = away * away;
    if (awaySquared > squared || (awaySquared == squared && entry > best)) return;
    best = entry;
    squared = awaySquared;
    distance = away;
    const double reach = away * (1.0 + kRounding) + kRounding * scale;
    limit = std::nextafter(static_cast<float>(reach * reach), kInfinity);
  }
};

NearestNeighbours::Point NearestNeighbours::pointOf(const Pose& q) const {
  const Vector3 p = q.position - origin_;
  const auto& r = q.orientation.coeffs();
  const double weight = std::copysign(2.0 * metric_.radius(), r[3]);
  const auto single = [](double value) { return static_cast<float>(value); };
  return {single(weight * r[0]), single(weight * r[1]), single(weight * r[2]), single(weight * r[3]),
          single(p.x()),         single(p.y()),         single(p.z()),         0.0F};
}

void NearestNeighbours::add(std::uint32_t index, const Pose& q) {
  if (nodes_.empty()) {
    origin_ = q.position;
    nodes_.emplace_back();
  }
  const auto entry = static_cast<std::uint32_t>(poses_.size());
  indices_.resize(poses_.size());  // an addition that ran out of memory may have left one more
  indices_.push_back(index);
  poses_.push_back(q);
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
  addToLeaf(nodes_[node], entry, point);
  if (nodes_[node].count > kMostInALeaf) splitLeaf(node);
}

void NearestNeighbours::addToLeaf(Node& leaf, std::uint32_t entry, const Point& point) {
  const std::size_t lane = leaf.count % kLanes;
  if (lane == 0) {
    leaf.packets.emplace_back();
    for (auto& axis : leaf.packets.back().at) axis.fill(kInfinity);
  }
  Packet& packet = leaf.packets.back();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    packet.at[axis][lane] = point[axis];
    leaf.low[axis] = std::min(leaf.low[axis], point[axis]);
    leaf.high[axis] = std::max(leaf.high[axis], point[axis]);
  }
  packet.entry[lane] = entry;
  ++leaf.count;
}

/// Splits a leaf at the middle of its widest axis. A leaf whose configurations are all equal is not split. Out of
/// memory the leaf stays as it is.
void NearestNeighbours::splitLeaf(std::uint32_t node) {
  const Node& leaf = nodes_[node];
  std::size_t axis = 0;
  const auto width = [&](std::size_t a) { return leaf.high[a] - leaf.low[a]; };
  for (std::size_t a = 1; a < kAxes; ++a) {
    if (width(a) > width(axis)) axis = a;
  }
  const float split = leaf.low[axis] + 0.5F * width(axis);
  if (!(leaf.low[axis] < split && split <= leaf.high[axis])) return;
  std::array<Node, 2> halves;
  for (std::size_t i = 0; i < leaf.count; ++i) {
    const Packet& packet = leaf.packets[i / kLanes];
    Point point{};
    for (std::size_t a = 0; a < kAxes; ++a) point[a] = packet.at[a][i % kLanes];
    addToLeaf(halves[point[axis] < split ? 0U : 1U], packet.entry[i % kLanes], point);
  }
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  std::move(halves.begin(), halves.end(), nodes_.end() - 2);
  Node& inner = nodes_[node];
  inner.children = children;
  inner.axis = axis;
  inner.split = split;
  inner.packets = std::vector<Packet>();
  inner.count = 0;
}

void NearestNeighbours::look(const Packet& packet, Search& search) const {
  std::array<float, kLanes> chord{};
  std::array<float, kLanes> way{};
  const auto addAxis = [&](std::size_t axis, std::array<float, kLanes>& squared) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float offset = packet.at[axis][lane] - search.point[axis];
      squared[lane] += offset * offset;
    }
  };
  for (std::size_t axis = 0; axis < kOrientationAxes; ++axis) addAxis(axis, chord);
  for (std::size_t axis = kOrientationAxes; axis < kAxes; ++axis) addAxis(axis, way);
  std::array<float, kLanes> bound;
  for (std::size_t lane = 0; lane < kLanes; ++lane) bound[lane] = search.bound(chord[lane], way[lane]);
  const auto consider = [&](std::size_t lane) {
    const std::uint32_t entry = packet.entry[lane];
    search.consider(entry, metric_.distance(poses_[entry], search.q));
  };
  // The candidate with the least bound comes first, so that few others have to be evaluated.
  const auto first = static_cast<std::size_t>(std::min_element(bound.begin(), bound.end()) - bound.begin());
  if (bound[first] > search.limit) return;
  consider(first);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lane != first && bound[lane] != kInfinity && bound[lane] <= search.limit) consider(lane);
  }
}

void NearestNeighbours::visit(std::uint32_t at, Search& search) const {
  const Node& node = nodes_[at];
  if (node.children == 0) {
    for (const Packet& packet : node.packets) look(packet, search);
    return;
  }
  const auto away = [&](std::uint32_t child) {
    const Node& box = nodes_[child];
    return search.bound(squaredOutside(search.point, box.low, box.high, 0),
                        squaredOutside(search.point, box.low, box.high, kOrientationAxes));
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
  const double r = metric_.radius();
  Search search{q, pointOf(q), scale_, r > 0.0 ? static_cast<float>(1.0 / (16.0 * r * r)) : 0.0F};
  for (const float value : search.point) search.scale = std::max(search.scale, static_cast<double>(std::abs(value)));
  visit(0, search);
  for (std::size_t axis = 0; axis < kOrientationAxes; ++axis) search.point[axis] = -search.point[axis];
  visit(0, search);
  return Neighbour{indices_[search.best], search.distance};
}

}  // namespace glissade
