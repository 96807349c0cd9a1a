#include "engine/sequence/contact_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

/// Pieces of triangles are no longer than this share of the common box.
constexpr double kPieceShare = 1.0 / 16.0;
constexpr std::size_t kMostPieces = 4000;
/// Normals with a larger cosine count as one direction.
constexpr double kSameNormal = 0.5;
/// Two surfaces face each other if the cosine of their normals is below this.
constexpr double kFacing = -0.5;
/// Number of directions in the tangent plane for each of which the outermost point is kept.
constexpr int kOutermost = 6;
/// If the normals have more directions than this, only the two points that are farthest apart are kept of each
/// direction.
constexpr std::size_t kFewDirections = 2;

Vector3 unitNormal(const Triangle& triangle) {
  const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double length = normal.norm();
  return length > 0.0 ? Vector3(normal / length) : Vector3(Vector3::Zero());
}

Box3 boxAroundTriangle(const Triangle& triangle) {
  Box3 box(triangle[0]);
  box.extend(triangle[1]);
  box.extend(triangle[2]);
  return box;
}

class PointSearch {
 public:
  PointSearch(const TriangleTree& b, const Box3& common, double distance)
      : b_(b), common_(common), distance_(distance), longest_(kPieceShare * common.diagonal().norm()) {}

  void search(const Triangle& triangle) {
    const Vector3 normal = unitNormal(triangle);
    if (!normal.isZero(0.0)) divide(triangle, normal);
  }

  const std::vector<ContactPoint>& points() const { return points_; }

 private:
  /// Halves the piece at its longest edge until pieces are small.
  void divide(const Triangle& piece, const Vector3& normal) {
    if (!common_.intersects(boxAroundTriangle(piece)) || ++pieces_ > kMostPieces) return;
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (edge(piece, i) > edge(piece, longest)) longest = i;
    }
    if (edge(piece, longest) <= longest_) {
      for (const Vector3& corner : piece) take(corner, normal);
      return;
    }
    const Vector3& from = piece[longest];
    const Vector3& to = piece[(longest + 1) % 3];
    const Vector3& other = piece[(longest + 2) % 3];
    const Vector3 middle = 0.5 * (from + to);
    divide({from, middle, other}, normal);
    divide({middle, to, other}, normal);
  }

  static double edge(const Triangle& piece, std::size_t i) { return (piece[(i + 1) % 3] - piece[i]).norm(); }

  void take(const Vector3& point, const Vector3& normal) {
    const auto nearest = b_.nearest(point, distance_);
    if (nearest.distance >= distance_) return;
    if (normal.dot(unitNormal(b_.triangles()[nearest.triangle])) > kFacing) return;
    points_.push_back({point, normal});
  }

  const TriangleTree& b_;
  Box3 common_;
  double distance_;
  double longest_;
  std::size_t pieces_ = 0;
  std::vector<ContactPoint> points_;
};

std::vector<const ContactPoint*> farthestTwo(const std::vector<const ContactPoint*>& points) {
  std::vector<const ContactPoint*> two{points.front()};
  double most = 0.0;
  for (const ContactPoint* one : points) {
    for (const ContactPoint* other : points) {
      const double apart = (one->point - other->point).norm();
      if (apart <= most) continue;
      most = apart;
      two = {one, other};
    }
  }
  return two;
}

/// Adds the outermost points among points whose normals have one direction.
void addOutermost(const std::vector<const ContactPoint*>& points, bool onlyTwo, std::vector<ContactPoint>& kept) {
  const Vector3 normal = points.front()->normal;
  const Vector3 along = normal.unitOrthogonal();
  const Vector3 across = normal.cross(along);
  std::vector<const ContactPoint*> chosen;
  for (int i = 0; i < kOutermost; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / kOutermost + 0.1;
    const Vector3 direction = std::cos(angle) * along + std::sin(angle) * across;
    const auto outermost = std::max_element(points.begin(), points.end(), [&](const auto* one, const auto* other) {
      return one->point.dot(direction) < other->point.dot(direction);
    });
    if (std::find(chosen.begin(), chosen.end(), *outermost) == chosen.end()) chosen.push_back(*outermost);
  }
  if (onlyTwo) chosen = farthestTwo(chosen);
  for (const ContactPoint* point : chosen) kept.push_back(*point);
}

}  // namespace

std::vector<ContactPoint> contactPoints(const TriangleTree& a, const TriangleTree& b, double distance) {
  const Vector3 margin = Vector3::Constant(distance);
  const Box3 common = Box3(a.box().min() - margin, a.box().max() + margin)
                          .intersection(Box3(b.box().min() - margin, b.box().max() + margin));
  if (common.isEmpty()) return {};
  PointSearch search(b, common, distance);
  a.visit(common, [&](std::uint32_t triangle) {
    search.search(a.triangles()[triangle]);
    return true;
  });
  std::vector<std::vector<const ContactPoint*>> directions;
  for (const ContactPoint& point : search.points()) {
    const auto same = std::find_if(directions.begin(), directions.end(), [&](const auto& points) {
      return points.front()->normal.dot(point.normal) > kSameNormal;
    });
    if (same != directions.end()) {
      same->push_back(&point);
    } else {
      directions.push_back({&point});
    }
  }
  std::vector<ContactPoint> kept;
  for (const auto& points : directions) addOutermost(points, directions.size() > kFewDirections, kept);
  return kept;
}

}  // namespace glissade
