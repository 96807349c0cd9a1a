#include "engine/check/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace glissade::check {
namespace {

constexpr double kShare = 0.01;
constexpr double kLeastDepth = 1e-7;
constexpr std::size_t kMostCells = 40'000;
/// Triangles that may be near a part of the surface when it is looked at as a whole.
constexpr std::size_t kMostNear = 200;
constexpr double kSameNormal = 0.999;

/// A part of a triangle of the other surface.
struct Cell {
  Triangle corners;
  double atMost;  ///< depth of its points

  bool operator<(const Cell& other) const { return atMost < other.atMost; }
};

double sizeOf(const Triangle& t, const Vector3& middle) {
  return std::max({(t[0] - middle).norm(), (t[1] - middle).norm(), (t[2] - middle).norm()});
}

class DepthSearch {
 public:
  DepthSearch(const PlacedBody& body, const PlacedBody& other) : body_(body), other_(other) {
    overlap_.depths.assign(body.regions.count, 0.0);
  }

  Overlap search(const StopToken& stop) {
    std::priority_queue<Cell> open;
    other_.tree.visit(body_.tree.box(), [&](std::uint32_t t) {
      const Triangle& triangle = other_.tree.triangles()[t];
      if (isOutside(triangle)) return true;
      const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
      const double depth = meet(middle).first;
      for (const Vector3& corner : triangle) meet(corner);
      open.push({triangle, depth + sizeOf(triangle, middle)});
      return !stop.stopRequested();
    });
    for (std::size_t cells = 0; !open.empty() && cells < kMostCells && !stop.stopRequested(); ++cells) {
      const Cell cell = open.top();
      open.pop();
      const double enough = enoughFor(cell.corners);
      if (cell.atMost <= enough || isWithin(cell.corners, enough)) continue;
      for (const Triangle& part : quarters(cell.corners)) {
        const Vector3 middle = (part[0] + part[1] + part[2]) / 3.0;
        const double atMost = std::min(cell.atMost, meet(middle).first + sizeOf(part, middle));
        if (atMost > kLeastDepth && !isOutside(part)) open.push({part, atMost});
      }
    }
    for (double& depth : overlap_.depths) {
      if (depth > 0.0) depth += std::max(kShare * depth, kLeastDepth);
    }
    if (overlap_.deepest > 0.0) findThickness();
    return std::move(overlap_);
  }

 private:
  /// Depth of a point (below 0: it is outside) and the region that it is below.
  std::pair<double, std::uint32_t> meet(const Vector3& p) {
    const TriangleTree::Nearest nearest = body_.tree.nearest(p, std::numeric_limits<double>::infinity());
    const std::uint32_t region = body_.regions.of[nearest.triangle];
    if (!body_.contains(p)) return {-nearest.distance, region};
    double& depth = overlap_.depths[region];
    depth = std::max(depth, nearest.distance);
    if (nearest.distance > overlap_.deepest) {
      overlap_.deepest = nearest.distance;
      deepest_ = p;
      triangle_ = nearest.triangle;
    }
    return {nearest.distance, region};
  }

  /// What need not be known better below the regions next to the part.
  double enoughFor(const Triangle& part) {
    double least = std::numeric_limits<double>::infinity();
    const Vector3 middle = (part[0] + part[1] + part[2]) / 3.0;
    for (const Vector3& p : {part[0], part[1], part[2], middle}) {
      least = std::min(least, overlap_.depths[meet(p).second]);
    }
    return least + std::max(kShare * least, kLeastDepth);
  }

  /// No point of the part is inside.
  bool isOutside(const Triangle& part) const {
    Box3 box(part[0]);
    box.extend(part[1]);
    box.extend(part[2]);
    bool meets = false;
    body_.tree.visit(box, [&](std::uint32_t t) {
      meets = trianglesMeet(part, body_.tree.triangles()[t]);
      return !meets;
    });
    return !meets && !body_.contains(part[0]);
  }

  /// No point of the part is deeper than this: moved by so much, against the nearest face or against the mean of those
  /// that are near, it is outside.
  bool isWithin(const Triangle& part, double depth) const {
    const Vector3 middle = (part[0] + part[1] + part[2]) / 3.0;
    const auto nearest = body_.tree.nearest(middle, std::numeric_limits<double>::infinity());
    if (isOutsideWhenMoved(part, depth * body_.normals[nearest.triangle])) return true;
    const Vector3 mean = meanNormalNear(part, depth);
    return mean.norm() > 0.1 && isOutsideWhenMoved(part, depth * mean.normalized());
  }

  bool isOutsideWhenMoved(const Triangle& part, const Vector3& way) const {
    return isOutside({part[0] + way, part[1] + way, part[2] + way});
  }

  /// The sum of the different normals within the depth of the part; zero where there are very many triangles.
  Vector3 meanNormalNear(const Triangle& part, double depth) const {
    Box3 box(part[0] - Vector3::Constant(depth), part[0] + Vector3::Constant(depth));
    for (const Vector3& p : part) {
      box.extend(p - Vector3::Constant(depth));
      box.extend(p + Vector3::Constant(depth));
    }
    std::vector<Vector3> normals;
    std::size_t count = 0;
    body_.tree.visit(box, [&](std::uint32_t t) {
      const Vector3& normal = body_.normals[t];
      const bool known = std::any_of(normals.begin(), normals.end(),
                                     [&](const Vector3& each) { return each.dot(normal) > kSameNormal; });
      if (!known) normals.push_back(normal);
      return ++count <= kMostNear;
    });
    Vector3 sum = Vector3::Zero();
    for (const Vector3& normal : normals) sum += normal;
    return count > kMostNear ? Vector3(Vector3::Zero()) : sum;
  }

  static std::array<Triangle, 4> quarters(const Triangle& t) {
    const Vector3 ab = 0.5 * (t[0] + t[1]);
    const Vector3 bc = 0.5 * (t[1] + t[2]);
    const Vector3 ca = 0.5 * (t[2] + t[0]);
    return {{{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}}};
  }

  void findThickness() {
    const Vector3 inwards = -body_.normals[triangle_];
    const Vector3 surface = nearestPoint(body_.tree.triangles()[triangle_], deepest_);
    overlap_.thickness = body_.tree.firstHit(surface, inwards, 1e-9 * body_.tree.box().diagonal().norm());
  }

  const PlacedBody& body_;
  const PlacedBody& other_;
  Overlap overlap_;
  Vector3 deepest_ = Vector3::Zero();
  std::uint32_t triangle_ = 0;
};

}  // namespace

Overlap overlapIn(const PlacedBody& body, const PlacedBody& other, const StopToken& stop) {
  if (!body.interior || !body.tree.box().intersects(other.tree.box())) {
    return {std::vector<double>(body.regions.count, 0.0), 0.0, 0.0};
  }
  return DepthSearch(body, other).search(stop);
}

}  // namespace glissade::check
