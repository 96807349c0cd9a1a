#include "engine/collision/kernel/box_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

constexpr std::size_t kBins = 16;

/// Smallest float not below the value.
float roundedUp(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

/// Centre and extents of a triangle in the frame of a box.
struct Extent {
  Vector3 low;
  Vector3 high;
};

Extent extentIn(const OrientedBox& box, const Triangle& triangle) {
  const Vector3 a = box.axes.transpose() * (triangle[0] - box.centre);
  const Vector3 b = box.axes.transpose() * (triangle[1] - box.centre);
  const Vector3 c = box.axes.transpose() * (triangle[2] - box.centre);
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

struct Bin {
  Box3 box;
  std::size_t count = 0;

  void merge(const Bin& other) {
    box.extend(other.box);
    count += other.count;
  }
  /// Surface times count: what it costs to look into it.
  double cost() const {
    if (count == 0) return 0.0;
    const Vector3 s = box.sizes();
    return (s.x() * s.y() + s.y() * s.z() + s.z() * s.x()) * static_cast<double>(count);
  }
};

/// Where a box is best cut.
struct Cut {
  int axis = -1;
  double at = 0.0;
  double cost = std::numeric_limits<double>::infinity();
};

void tryAxis(const OrientedBox& box, const std::vector<Extent>& extents, int axis, Cut& best) {
  const double width = 2.0 * box.half[axis] / static_cast<double>(kBins);
  if (width <= 0.0) return;
  std::array<Bin, kBins> bins;
  for (const Extent& extent : extents) {
    const double middle = 0.5 * (extent.low[axis] + extent.high[axis]) + box.half[axis];
    Bin& bin = bins[static_cast<std::size_t>(std::clamp(middle / width, 0.0, kBins - 1.0))];
    bin.box.extend(extent.low).extend(extent.high);
    ++bin.count;
  }
  std::array<double, kBins> left{};
  Bin sum;
  for (std::size_t i = 0; i < kBins; ++i) {
    sum.merge(bins[i]);
    left[i] = sum.count == extents.size() ? std::numeric_limits<double>::infinity() : sum.cost();
  }
  sum = Bin();
  for (std::size_t i = kBins - 1; i > 0; --i) {
    sum.merge(bins[i]);
    if (sum.count == extents.size()) return;
    const double cost = left[i - 1] + sum.cost();
    if (sum.count > 0 && cost < best.cost) best = {axis, static_cast<double>(i) * width - box.half[axis], cost};
  }
}

}  // namespace

/// A run of triangles with its box, while the tree is built.
struct BoxTree::Part {
  std::size_t first = 0;
  std::size_t last = 0;
  OrientedBox box;

  Part(const std::vector<OwnedTriangle>& triangles, std::size_t from, std::size_t to) : first(from), last(to) {
    std::vector<const Triangle*> corners;
    corners.reserve(to - from);
    for (std::size_t i = from; i < to; ++i) corners.push_back(&triangles[i].corners);
    box = fitBox(corners);
  }
  std::size_t size() const { return last - first; }
};

BoxTree::BoxTree(std::vector<OwnedTriangle> all, std::size_t mostInALeaf)
    : triangles(std::move(all)), mostInALeaf_(mostInALeaf) {
  if (empty()) return;
  Box3 box;
  for (const OwnedTriangle& triangle : triangles) {
    for (const Vector3& corner : triangle.corners) box.extend(corner);
  }
  centre = box.center();
  for (const OwnedTriangle& triangle : triangles) {
    for (const Vector3& corner : triangle.corners) reach = std::max(reach, (corner - centre).norm());
  }
  fillNode(addNode(), {Part(triangles, 0, triangles.size())});
}

std::uint32_t BoxTree::addNode() {
  nodes.emplace_back();
  counts.push_back(0);
  child.resize(child.size() + lanes::kWidth, -1);
  radius.resize(child.size(), 0.0F);
  lowestBody.resize(child.size(), 0);
  return static_cast<std::uint32_t>(nodes.size() - 1);
}

void BoxTree::fillNode(std::uint32_t node, std::vector<Part> parts) {
  counts[node] = static_cast<std::uint32_t>(parts.size());
  const std::size_t first = std::size_t{node} * lanes::kWidth;
  for (std::size_t lane = 0; lane < lanes::kWidth; ++lane) {
    // Lanes without a box repeat the last one: their arithmetic stays finite, their answers are not read.
    setBox(static_cast<Box>(first + lane), parts[std::min(lane, parts.size() - 1)]);
  }
  for (std::size_t lane = 0; lane < parts.size(); ++lane) {
    const Part& part = parts[lane];
    const std::size_t box = first + lane;
    if (part.size() <= mostInALeaf_) {
      child[box] = addLeaf(part);
      continue;
    }
    const std::uint32_t below = addNode();
    child[box] = static_cast<std::int32_t>(below);
    fillNode(below, divided(part));
  }
}

/// Cuts the part with the largest surface again and again until there are eight.
std::vector<BoxTree::Part> BoxTree::divided(const Part& whole) {
  std::vector<Part> parts{whole};
  while (parts.size() < lanes::kWidth) {
    auto widest = parts.end();
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      if (part->size() <= mostInALeaf_) continue;
      if (widest == parts.end() || part->box.surface() > widest->box.surface()) widest = part;
    }
    if (widest == parts.end()) break;
    const Part part = *widest;
    std::vector<Extent> extents;
    for (std::size_t i = part.first; i < part.last; ++i) extents.push_back(extentIn(part.box, triangles[i].corners));
    Cut cut;
    for (int axis = 0; axis < 3; ++axis) tryAxis(part.box, extents, axis, cut);
    const auto begin = triangles.begin() + static_cast<std::ptrdiff_t>(part.first);
    auto middle = begin + static_cast<std::ptrdiff_t>(part.size() / 2);
    if (cut.axis >= 0) {
      middle = std::stable_partition(begin, begin + static_cast<std::ptrdiff_t>(part.size()),
                                     [&](const OwnedTriangle& triangle) {
                                       const Extent extent = extentIn(part.box, triangle.corners);
                                       return 0.5 * (extent.low[cut.axis] + extent.high[cut.axis]) < cut.at;
                                     });
    }
    auto split = static_cast<std::size_t>(middle - triangles.begin());
    if (split == part.first || split == part.last) split = part.first + part.size() / 2;
    *widest = Part(triangles, part.first, split);
    parts.emplace_back(triangles, split, part.last);
  }
  return parts;
}

void BoxTree::setBox(Box box, const Part& part) {
  lanes::BoxLanes& node = nodes[nodeAround(box)];
  const std::size_t lane = laneOf(box);
  Vector3 middle;
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    node.centre[i][lane] = static_cast<float>(part.box.centre[i] - centre[i]);
    middle[i] = node.centre[i][lane];
    for (int k = 0; k < 3; ++k) {
      node.axis[k][i][lane] = static_cast<float>(part.box.axes(i, k));
      axes(i, k) = node.axis[k][i][lane];
    }
  }
  // Extents about the rounded centre along the rounded axes: nothing sticks out of what is stored.
  Vector3 half = Vector3::Zero();
  double farthest = 0.0;
  int lowest = std::numeric_limits<int>::max();
  for (std::size_t i = part.first; i < part.last; ++i) {
    lowest = std::min(lowest, triangles[i].body);
    for (const Vector3& corner : triangles[i].corners) {
      const Vector3 p = (corner - centre) - middle;
      half = half.cwiseMax((axes.transpose() * p).cwiseAbs());
      farthest = std::max(farthest, p.norm());
    }
  }
  for (int k = 0; k < 3; ++k) node.half[k][lane] = roundedUp(half[k]);
  radius[box] = roundedUp(farthest);
  lowestBody[box] = lowest;
}

std::int32_t BoxTree::addLeaf(const Part& part) {
  Leaf leaf;
  leaf.first = static_cast<std::uint32_t>(part.first);
  leaf.count = static_cast<std::uint32_t>(part.size());
  for (int i = 0; i < 3; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t k = 0; k < lanes::kLeafTriangles; ++k) {
        const Triangle& triangle = triangles[part.first + std::min(k, part.size() - 1)].corners;
        leaf.lanes.coordinate[i][corner * lanes::kLeafTriangles + k] =
            static_cast<float>(triangle[corner][i] - centre[i]);
      }
    }
  }
  leaves.push_back(leaf);
  return -static_cast<std::int32_t>(leaves.size());
}

}  // namespace glissade
