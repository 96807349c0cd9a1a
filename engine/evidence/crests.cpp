#include "engine/evidence/crests.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "engine/geometry/circle_fit.h"

namespace glissade::evidence {
namespace {

/// How far crests go into a wall, as shares of the radius of the shaft.
constexpr double kLeastInto = 0.02;
constexpr double kMostInto = 0.3;
/// Crests are looked at as far as this from the middle of what is in the wall, by its radius: a thin sheet has less
/// than a turn, and a long hole has many.
constexpr double kLookedAt = 4.0;
constexpr std::size_t kFewestRings = 3;
/// The search for an axis of crests that is beside that of the wall.
constexpr int kRounds = 4;
constexpr std::size_t kFewestTips = 12;
/// Distances of rings may differ by this share.
constexpr double kEqualRings = 0.1;

/// How near to the axis of a wall vertices are that are in it, metres.
struct WallReach {
  double nearest = 0.0;
  double farthest = 0.0;

  explicit WallReach(const RoundFace& face) {
    const double shaft = face.isShaft ? face.radius : face.radius / (1.0 - kMostInto);
    nearest = face.isShaft ? (1.0 - kMostInto) * shaft : face.radius / (1.0 - kLeastInto);
    farthest = face.isShaft ? (1.0 - kLeastInto) * shaft : shaft;
  }

  bool holds(const Vector3& vertex, const RoundFace& face) const {
    const Vector3 arm = vertex - face.point;
    const double height = arm.dot(face.axis);
    const double square = arm.squaredNorm() - height * height;
    return height >= face.low && height <= face.high && square >= nearest * nearest && square <= farthest * farthest;
  }
};

/// The vertices that go farthest into the wall, one for each part of the turn.
std::vector<Vector3> tipsOf(const std::vector<Vector3>& into, const RoundFace& face) {
  constexpr std::size_t kParts = 24;
  const double outwards = face.isShaft ? -1.0 : 1.0;
  const Vector3 u = face.axis.unitOrthogonal();
  const Vector3 v = face.axis.cross(u);
  std::vector<std::optional<Vector3>> tips(kParts);
  for (const Vector3& vertex : into) {
    const Vector3 arm = vertex - face.point;
    const double turn = std::atan2(arm.dot(v), arm.dot(u)) / (2.0 * std::numbers::pi) + 0.5;
    std::optional<Vector3>& tip = tips[std::min(kParts - 1, static_cast<std::size_t>(turn * kParts))];
    const auto reach = [&](const Vector3& p) { return outwards * (p - face.point).cross(face.axis).norm(); };
    if (!tip || reach(vertex) > reach(*tip)) tip = vertex;
  }
  std::vector<Vector3> found;
  for (const auto& tip : tips) {
    if (tip) found.push_back(*tip);
  }
  return found;
}

/// A face about the middle of the circle through points, seen along its axis; itself where there is no such circle.
RoundFace aboutMiddleOf(const std::vector<Vector3>& points, RoundFace face) {
  if (const auto circle = fitCircle(points, face.axis)) {
    const Vector3 way = circle->middle - face.point;
    face.point += way - way.dot(face.axis) * face.axis;
  }
  return face;
}

/// Heights of the vertices that are nearer to the axis than crests, and not by half; ascending.
std::vector<double> heightsOfGrooves(double radius, const RoundFace& face, const TriangleMesh& body) {
  constexpr double kDeepest = 0.5;
  std::vector<double> heights;
  for (const Vector3& vertex : body.vertices) {
    const Vector3 arm = vertex - face.point;
    const double height = arm.dot(face.axis);
    const double square = arm.squaredNorm() - height * height;
    const double least = radius - 2.0 * vertexTolerance(radius);
    if (square < least * least && square > kDeepest * kDeepest * radius * radius) heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Three rings or more at equal distances, each around the axis, with grooves between them. `crests`: by their heights.
bool areRings(const std::vector<Around>& crests, const std::vector<double>& grooves) {
  std::vector<double> middles;
  for (auto first = crests.begin(); first != crests.end();) {
    auto last = first;
    for (auto next = first + 1; next != crests.end(); last = next++) {
      const auto groove = std::upper_bound(grooves.begin(), grooves.end(), last->height + kOnCylinder);
      if (groove != grooves.end() && *groove < next->height - kOnCylinder) break;
    }
    if (!areAround({first, last + 1})) return false;
    middles.push_back(0.5 * (first->height + last->height));
    first = last + 1;
  }
  if (middles.size() < kFewestRings) return false;
  const double distance = (middles.back() - middles.front()) / static_cast<double>(middles.size() - 1);
  for (std::size_t i = 1; i < middles.size(); ++i) {
    if (std::abs(middles[i] - middles[i - 1] - distance) > kEqualRings * distance) return false;
  }
  return true;
}

/// The vertices as near to the axis of the face as crests about an axis beside it can be.
TriangleMesh nearAxis(const RoundFace& face, const TriangleMesh& body) {
  constexpr double kFarthest = 2.0;
  const double most = kFarthest * kFarthest * face.radius * face.radius;
  TriangleMesh near;
  for (const Vector3& vertex : body.vertices) {
    if ((vertex - face.point).cross(face.axis).squaredNorm() <= most) near.vertices.push_back(vertex);
  }
  return near;
}

/// The vertices at this distance from the axis of the face.
TriangleMesh atRadius(double radius, const RoundFace& face, const TriangleMesh& body) {
  TriangleMesh found;
  for (const Vector3& vertex : body.vertices) {
    const Vector3 arm = vertex - face.point;
    const double height = arm.dot(face.axis);
    const double distance = std::sqrt(std::max(0.0, arm.squaredNorm() - height * height));
    if (std::abs(distance - radius) <= vertexTolerance(radius)) found.vertices.push_back(vertex);
  }
  return found;
}

/// The crests of this radius about the axis of the face.
std::optional<DrawnCrests> crestsOf(double radius, const RoundFace& face, const TriangleMesh& body) {
  DrawnCrests drawn{face.point, radius, face.high, face.low};
  std::vector<Around> crests;
  for (const Around& each : aroundOf(atRadius(radius, face, body), face.point, face.axis)) {
    drawn.low = std::min(drawn.low, each.height);
    drawn.high = std::max(drawn.high, each.height);
    crests.push_back(each);
  }
  const double middle = 0.5 * (std::max(drawn.low, face.low) + std::min(drawn.high, face.high));
  std::erase_if(crests, [&](const Around& each) { return std::abs(each.height - middle) > kLookedAt * face.radius; });
  std::sort(crests.begin(), crests.end(), [](const Around& a, const Around& b) { return a.height < b.height; });
  if (!areAround(crests)) return std::nullopt;
  if (const auto helix = helixOf(crests, 2.0 * face.radius)) {
    drawn.lead = helix->lead;
    return drawn;
  }
  if (face.isShaft || !areRings(crests, heightsOfGrooves(radius, face, body))) return std::nullopt;
  return drawn;
}

}  // namespace

std::optional<DrawnCrests> crestsInto(const RoundFace& face, const TriangleMesh& body, const StopToken& stop) {
  const WallReach reach(face);
  const TriangleMesh near = nearAxis(face, body);
  std::vector<Vector3> into;
  std::copy_if(near.vertices.begin(), near.vertices.end(), std::back_inserter(into),
               [&](const Vector3& vertex) { return reach.holds(vertex, face); });
  if (into.empty()) return std::nullopt;
  RoundFace about = face;
  // Screws are placed beside the axes of their holes. The first tips show about where, the next ones exactly.
  for (int round = 0; round < kRounds && !stop.stopRequested(); ++round) {
    const std::vector<Vector3> tips = tipsOf(into, about);
    std::vector<double> radii;
    for (const Vector3& tip : tips) radii.push_back((tip - about.point).cross(about.axis).norm());
    std::sort(radii.begin(), radii.end());
    const double radius = face.isShaft ? radii.front() : radii.back();
    if (auto drawn = crestsOf(radius, about, near)) return drawn;
    about = aboutMiddleOf(tips, about);
    const double beside = (about.point - face.point).norm();
    if (tips.size() < kFewestTips || beside > std::abs(radius - face.radius)) break;
  }
  return std::nullopt;
}

}  // namespace glissade::evidence
