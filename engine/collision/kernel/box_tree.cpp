#include "engine/collision/kernel/box_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/thread_team.h"

namespace glissade {
namespace {

constexpr std::size_t kBins = 16;
/// Largest number of triangles of a tree whose boxes are fitted by fitBox(); larger trees use fitBoxQuickly().
constexpr std::size_t kMostFittedWithCare = 200'000;
/// Largest number of triangles of a tree that one thread builds.
constexpr std::size_t kMostOfOneThread = 20'000;

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
  /// Surface times count: the expected cost of a search in it.
  double cost() const {
    if (count == 0) return 0.0;
    const Vector3 s = box.sizes();
    return (s.x() * s.y() + s.y() * s.z() + s.z() * s.x()) * static_cast<double>(count);
  }
};

/// The best cut of a part.
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

/// A run of triangles with its box, while the tree is built.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
  OrientedBox box;

  std::size_t size() const { return last - first; }
};

/// Builds a tree, or a part of it, over a range of triangles, which it sorts into the order of the leaves. Several
/// builders may work at the same time on different ranges.
class TreeBuilder {
 public:
  TreeBuilder(std::vector<OwnedTriangle>& triangles, const Vector3& centre, std::size_t mostInALeaf, BoxCare care)
      : triangles_(triangles),
        centre_(centre),
        mostInALeaf_(mostInALeaf),
        care_(triangles.size() <= kMostFittedWithCare ? care : BoxCare::ForFewQueries) {}

  Part partOf(std::size_t first, std::size_t last);
  std::vector<Part> divided(const Part& whole);
  void build(const Part& whole) { fillNode(made_.addNode(), {whole}); }
  /// Builds the tree in several threads. Precondition: `whole` is no leaf.
  void buildInThreads(const Part& whole);

  BoxTreeNodes takeNodes() && { return std::move(made_); }

 private:
  void fillNode(std::uint32_t node, const std::vector<Part>& parts);
  Cut bestCut(const Part& part);
  std::size_t split(const Part& part, const Cut& cut);
  void setBoxes(std::uint32_t node, const std::vector<Part>& parts);
  void setBox(BoxTree::Box box, const Part& part);
  std::int32_t addLeaf(const Part& part);

  std::vector<OwnedTriangle>& triangles_;
  const Vector3& centre_;
  std::size_t mostInALeaf_;
  BoxCare care_;
  BoxTreeNodes made_;
  // Corners of the present part; a member, because allocation takes time.
  std::vector<const Triangle*> corners_;
  std::vector<Extent> extents_;
  std::vector<OwnedTriangle> behind_;
};

Part TreeBuilder::partOf(std::size_t first, std::size_t last) {
  corners_.clear();
  for (std::size_t i = first; i < last; ++i) corners_.push_back(&triangles_[i].corners);
  return {first, last, care_ == BoxCare::ForManyQueries ? fitBox(corners_) : fitBoxQuickly(corners_)};
}

void TreeBuilder::fillNode(std::uint32_t node, const std::vector<Part>& parts) {
  setBoxes(node, parts);
  for (std::size_t lane = 0; lane < parts.size(); ++lane) {
    const std::size_t box = std::size_t{node} * lanes::kWidth + lane;
    if (parts[lane].size() <= mostInALeaf_) {
      made_.child[box] = addLeaf(parts[lane]);
      continue;
    }
    const std::uint32_t below = made_.addNode();
    made_.child[box] = static_cast<std::int32_t>(below);
    fillNode(below, divided(parts[lane]));
  }
}

void TreeBuilder::buildInThreads(const Part& whole) {
  setBoxes(made_.addNode(), {whole});
  const std::uint32_t top = made_.addNode();
  made_.child[0] = static_cast<std::int32_t>(top);
  const std::vector<Part> parts = divided(whole);
  setBoxes(top, parts);
  std::vector<BoxTreeNodes> below(parts.size());
  ThreadTeam team(usableCores() - 1);
  team.run(parts.size(), [&](std::size_t lane) {
    if (parts[lane].size() <= mostInALeaf_) return;
    TreeBuilder builder(triangles_, centre_, mostInALeaf_, care_);
    builder.fillNode(builder.made_.addNode(), builder.divided(parts[lane]));
    below[lane] = std::move(builder).takeNodes();
  });
  for (std::size_t lane = 0; lane < parts.size(); ++lane) {
    const bool leaf = parts[lane].size() <= mostInALeaf_;
    const auto next = static_cast<std::int32_t>(made_.nodes.size());
    made_.child[std::size_t{top} * lanes::kWidth + lane] = leaf ? addLeaf(parts[lane]) : next;
    made_.append(below[lane]);
    below[lane] = {};
  }
}

/// Sets the boxes of a node. Lanes without a box repeat the last one, so that their arithmetic stays finite; their
/// answers are not read.
void TreeBuilder::setBoxes(std::uint32_t node, const std::vector<Part>& parts) {
  made_.counts[node] = static_cast<std::uint32_t>(parts.size());
  const auto first = static_cast<BoxTree::Box>(node * lanes::kWidth);
  for (std::size_t lane = 0; lane < parts.size(); ++lane) setBox(first + static_cast<BoxTree::Box>(lane), parts[lane]);
  lanes::BoxLanes& boxes = made_.nodes[node];
  const std::size_t last = parts.size() - 1;
  for (std::size_t lane = parts.size(); lane < lanes::kWidth; ++lane) {
    for (int i = 0; i < 3; ++i) {
      boxes.centre[i][lane] = boxes.centre[i][last];
      boxes.half[i][lane] = boxes.half[i][last];
      for (int k = 0; k < 3; ++k) boxes.axis[k][i][lane] = boxes.axis[k][i][last];
    }
    made_.radius[first + lane] = made_.radius[first + last];
    made_.lowestBody[first + lane] = made_.lowestBody[first + last];
  }
}

/// Divides the part with the largest surface repeatedly until there are eight.
std::vector<Part> TreeBuilder::divided(const Part& whole) {
  std::vector<Part> parts{whole};
  while (parts.size() < lanes::kWidth) {
    auto widest = parts.end();
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      if (part->size() <= mostInALeaf_) continue;
      if (widest == parts.end() || part->box.surface() > widest->box.surface()) widest = part;
    }
    if (widest == parts.end()) break;
    const Part part = *widest;
    const std::size_t middle = split(part, bestCut(part));
    *widest = partOf(part.first, middle);
    parts.push_back(partOf(middle, part.last));
  }
  return parts;
}

/// The best cut of a part. Leaves the extents of the part in `extents_`.
Cut TreeBuilder::bestCut(const Part& part) {
  extents_.clear();
  for (std::size_t i = part.first; i < part.last; ++i) extents_.push_back(extentIn(part.box, triangles_[i].corners));
  Cut cut;
  for (int axis = 0; axis < 3; ++axis) tryAxis(part.box, extents_, axis, cut);
  return cut;
}

/// Moves the triangles before the cut to the front, in their order, and returns the index of the first one behind it.
std::size_t TreeBuilder::split(const Part& part, const Cut& cut) {
  const std::size_t half = part.first + part.size() / 2;
  if (cut.axis < 0) return half;
  behind_.clear();
  std::size_t next = part.first;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const Extent& extent = extents_[i - part.first];
    if (0.5 * (extent.low[cut.axis] + extent.high[cut.axis]) < cut.at) {
      triangles_[next++] = triangles_[i];
    } else {
      behind_.push_back(triangles_[i]);
    }
  }
  std::copy(behind_.begin(), behind_.end(), triangles_.begin() + static_cast<std::ptrdiff_t>(next));
  return next == part.first || next == part.last ? half : next;
}

void TreeBuilder::setBox(BoxTree::Box box, const Part& part) {
  lanes::BoxLanes& node = made_.nodes[BoxTree::nodeAround(box)];
  const std::size_t lane = BoxTree::laneOf(box);
  Vector3 middle;
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    node.centre[i][lane] = static_cast<float>(part.box.centre[i] - centre_[i]);
    middle[i] = node.centre[i][lane];
    for (int k = 0; k < 3; ++k) {
      node.axis[k][i][lane] = static_cast<float>(part.box.axes(i, k));
      axes(i, k) = node.axis[k][i][lane];
    }
  }
  // The extents are computed about the rounded centre along the rounded axes, so that the stored box contains all
  // triangles.
  Vector3 half = Vector3::Zero();
  double farthest = 0.0;
  int lowest = std::numeric_limits<int>::max();
  for (std::size_t i = part.first; i < part.last; ++i) {
    lowest = std::min(lowest, triangles_[i].body);
    for (const Vector3& corner : triangles_[i].corners) {
      const Vector3 p = (corner - centre_) - middle;
      half = half.cwiseMax((axes.transpose() * p).cwiseAbs());
      farthest = std::max(farthest, p.norm());
    }
  }
  for (int k = 0; k < 3; ++k) node.half[k][lane] = roundedUp(half[k]);
  made_.radius[box] = roundedUp(farthest);
  made_.lowestBody[box] = lowest;
}

std::int32_t TreeBuilder::addLeaf(const Part& part) {
  BoxTreeNodes::Leaf leaf;
  leaf.first = static_cast<std::uint32_t>(part.first);
  leaf.count = static_cast<std::uint32_t>(part.size());
  for (int i = 0; i < 3; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t k = 0; k < lanes::kLeafTriangles; ++k) {
        const Triangle& triangle = triangles_[part.first + std::min(k, part.size() - 1)].corners;
        leaf.lanes.coordinate[i][corner * lanes::kLeafTriangles + k] =
            static_cast<float>(triangle[corner][i] - centre_[i]);
      }
    }
  }
  made_.leaves.push_back(leaf);
  return -static_cast<std::int32_t>(made_.leaves.size());
}

}  // namespace

std::uint32_t BoxTreeNodes::addNode() {
  nodes.emplace_back();
  counts.push_back(0);
  child.resize(child.size() + lanes::kWidth, -1);
  radius.resize(child.size(), 0.0F);
  lowestBody.resize(child.size(), 0);
  return static_cast<std::uint32_t>(nodes.size() - 1);
}

void BoxTreeNodes::append(const BoxTreeNodes& part) {
  const auto nodesBefore = static_cast<std::int32_t>(nodes.size());
  const auto leavesBefore = static_cast<std::int32_t>(leaves.size());
  for (const std::int32_t below : part.child) {
    child.push_back(below < 0 ? below - leavesBefore : below + nodesBefore);
  }
  const auto addAll = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  addAll(nodes, part.nodes);
  addAll(counts, part.counts);
  addAll(leaves, part.leaves);
  addAll(radius, part.radius);
  addAll(lowestBody, part.lowestBody);
}

BoxTree::BoxTree(std::vector<OwnedTriangle> all, std::size_t mostInALeaf, BoxCare care) : triangles(std::move(all)) {
  if (empty()) return;
  Box3 box;
  for (const OwnedTriangle& triangle : triangles) {
    for (const Vector3& corner : triangle.corners) box.extend(corner);
  }
  centre = box.center();
  for (const OwnedTriangle& triangle : triangles) {
    for (const Vector3& corner : triangle.corners) reach = std::max(reach, (corner - centre).norm());
  }
  TreeBuilder builder(triangles, centre, mostInALeaf, care);
  const Part whole = builder.partOf(0, triangles.size());
  if (triangles.size() <= kMostOfOneThread) {
    builder.build(whole);
  } else {
    builder.buildInThreads(whole);
  }
  static_cast<BoxTreeNodes&>(*this) = std::move(builder).takeNodes();
}

}  // namespace glissade
