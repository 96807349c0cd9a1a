#include "engine/evidence/crests.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "engine/geometry/circle_fit.h"

namespace glissade::evidence {
namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;
/// Radians: vertices that are around an axis leave no wider gap.
constexpr double kWidestGap = 0.28 * kWholeTurn;
/// The crests of a helix leave this share of a turn free of crests at least; a flat crest takes an eighth.
constexpr double kLeastFree = 0.5;
/// The pitch may be off by this share of it.
constexpr double kPitchOff = 0.03;
/// How far crests go into a wall, as shares of the radius of the shaft.
constexpr double kLeastInto = 0.02;
constexpr double kMostInto = 0.3;
/// Pitches of threads, in diameters of the wall.
constexpr double kLeastPitch = 0.04;
constexpr double kMostPitch = 0.6;
/// Crests are looked at as far as this from the middle of what is in the wall, by its radius: a thin sheet has less
/// than a turn, and a long hole has many.
constexpr double kLookedAt = 4.0;
constexpr std::size_t kFewestRings = 3;
/// The search for an axis of crests that is beside that of the wall.
constexpr int kRounds = 4;
constexpr std::size_t kFewestTips = 12;
/// Distances of rings may differ by this share.
constexpr double kEqualRings = 0.1;

/// The widest gap between angles, radians; a whole turn where there are none.
double widestGap(std::vector<double> angles) {
  if (angles.empty()) return kWholeTurn;
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + kWholeTurn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest;
}

double phaseOf(const Around& crest, double pitch) { return crest.angle - kWholeTurn * crest.height / pitch; }

struct Mean {
  double height = 0.0;
  double phase = 0.0;   ///< radians
  double length = 0.0;  ///< of the mean of unit vectors: 1 where all have one phase
};

Mean meanOf(const Around* first, const Around* last, double pitch) {
  Mean mean;
  double x = 0.0;
  double y = 0.0;
  const auto count = static_cast<double>(last - first);
  for (const Around* each = first; each != last; ++each) {
    mean.height += each->height / count;
    x += std::cos(phaseOf(*each, pitch)) / count;
    y += std::sin(phaseOf(*each, pitch)) / count;
  }
  mean.phase = std::atan2(y, x);
  mean.length = std::hypot(x, y);
  return mean;
}

/// The crests are so many that no pitch suits them by chance, and no half of a turn is without one.
bool isUnbroken(const std::vector<Around>& crests, double pitch) {
  constexpr std::size_t kFewest = 24;
  constexpr double kLongestGap = 0.5;
  for (std::size_t i = 1; i < crests.size(); ++i) {
    if (crests[i].height - crests[i - 1].height > kLongestGap * std::abs(pitch)) return false;
  }
  return crests.size() >= kFewest;
}

/// True if crests at one height are around the axis, as at the rim of a cylinder: no turn back puts them on one side.
bool haveRim(const std::vector<Around>& crests) {
  constexpr double kOneHeight = 1e-6;
  for (auto first = crests.begin(); first != crests.end();) {
    const auto last =
        std::find_if(first, crests.end(), [&](const Around& each) { return each.height - first->height > kOneHeight; });
    if (areAround({first, last})) return true;
    first = last;
  }
  return false;
}

/// Some of the crests, in equal steps of their order: there are up to 1500 trials of a pitch, and each looks at them
/// all.
std::vector<Around> someOf(const std::vector<Around>& crests) {
  constexpr std::size_t kMostTried = 480;
  const std::size_t step = (crests.size() + kMostTried - 1) / kMostTried;
  std::vector<Around> some;
  for (std::size_t i = 0; i < crests.size(); i += step) some.push_back(crests[i]);
  return some;
}

/// The pitch of the helix that the crests are, by trial: the largest of those that put them at one side of the axis
/// best. Between two trials a crest turns by less than an eighth of a turn.
std::optional<double> pitchOfHelix(const std::vector<Around>& crests, double diameter) {
  constexpr double kBetter = 1.01;
  constexpr double kLeastLength = 0.6;
  if (haveRim(crests) || !isUnbroken(crests, (1.0 + kPitchOff) * kMostPitch * diameter)) return std::nullopt;
  const std::vector<Around> tried = someOf(crests);
  const double span = crests.back().height - crests.front().height;
  double best = 0.0;
  double longest = kLeastLength;
  for (double pitch = kMostPitch * diameter; pitch >= kLeastPitch * diameter;
       pitch -= 0.125 * pitch * std::min(1.0, pitch / span)) {
    for (const double hand : {pitch, -pitch}) {
      const double length = meanOf(tried.data(), tried.data() + tried.size(), hand).length;
      if (length <= kBetter * longest) continue;
      longest = length;
      best = hand;
    }
  }
  if (best == 0.0) return std::nullopt;
  // The turn from the lower half to the upper one shows what the trial is off.
  const Around* middle = crests.data() + crests.size() / 2;
  const Mean lower = meanOf(crests.data(), middle, best);
  const Mean upper = meanOf(middle, crests.data() + crests.size(), best);
  const double drift = std::remainder(upper.phase - lower.phase, kWholeTurn) / (upper.height - lower.height);
  const double exact = kWholeTurn / (kWholeTurn / best + drift);
  return areHelix(crests, exact) && isUnbroken(crests, exact) ? std::optional(exact) : std::nullopt;
}

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
    const double turn = std::atan2(arm.dot(v), arm.dot(u)) / kWholeTurn + 0.5;
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
  if (const auto pitch = pitchOfHelix(crests, 2.0 * face.radius)) {
    drawn.pitch = *pitch;
    return drawn;
  }
  if (face.isShaft || !areRings(crests, heightsOfGrooves(radius, face, body))) return std::nullopt;
  return drawn;
}

}  // namespace

std::vector<Around> aroundOf(const TriangleMesh& mesh, const Vector3& point, const Vector3& axis) {
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  std::vector<Around> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) {
    const Vector3 arm = vertex - point;
    const double x = arm.dot(u);
    const double y = arm.dot(v);
    vertices.push_back({std::hypot(x, y), arm.dot(axis), std::atan2(y, x)});
  }
  return vertices;
}

bool areAround(const std::vector<Around>& vertices) {
  std::vector<double> angles;
  for (const Around& vertex : vertices) angles.push_back(vertex.angle);
  return widestGap(std::move(angles)) <= kWidestGap;
}

bool areHelix(const std::vector<Around>& crests, double pitch) {
  std::vector<double> phases;
  for (const Around& crest : crests) phases.push_back(std::remainder(phaseOf(crest, pitch), kWholeTurn));
  if (widestGap(std::move(phases)) < kLeastFree * kWholeTurn) return false;
  if (crests.back().height - crests.front().height < std::abs(pitch)) return false;
  const Around* middle = crests.data() + crests.size() / 2;
  const Mean lower = meanOf(crests.data(), middle, pitch);
  const Mean upper = meanOf(middle, crests.data() + crests.size(), pitch);
  const double drift = std::abs(std::remainder(upper.phase - lower.phase, kWholeTurn)) / kWholeTurn * std::abs(pitch);
  return drift <= kPitchOff * (upper.height - lower.height);
}

std::optional<DrawnCrests> crestsInto(const RoundFace& face, const TriangleMesh& body, const StopToken& stop) {
  const WallReach reach(face);
  std::vector<Vector3> into;
  std::copy_if(body.vertices.begin(), body.vertices.end(), std::back_inserter(into),
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
    if (auto drawn = crestsOf(radius, about, body)) return drawn;
    about = aboutMiddleOf(tips, about);
    const double beside = (about.point - face.point).norm();
    if (tips.size() < kFewestTips || beside > std::abs(radius - face.radius)) break;
  }
  return std::nullopt;
}

}  // namespace glissade::evidence
