#include "engine/sequence/fasteners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "engine/geometry/range.h"
#include "engine/product/surface_regions.h"

namespace glissade {
namespace {

constexpr std::array<const char*, 5> kFastenerNames{"none", "screw", "nut", "washer", "pin"};

/// Cosine of directions that are one, and share of a length that is none.
constexpr double kParallel = 1.0 - 1e-4;
constexpr double kSameLength = 0.02;
/// The middle of a fastener is on its axis, up to this share of its radius.
constexpr double kOffAxis = 0.15;
/// Head radius by shaft radius.
constexpr double kLeastHead = 1.25;
constexpr double kMostHead = 3.5;
/// A head is no longer than this share of the screw.
constexpr double kHeadShare = 0.6;
/// Height by outer diameter.
constexpr double kMostWasher = 0.25;
constexpr double kMostNut = 1.3;
/// Outer radius by hole radius.
constexpr double kMostRing = 4.0;
/// Length by radius.
constexpr double kLeastPin = 3.0;
constexpr double kMostPin = 20.0;

/// A body about one of its axes.
struct TurnedShape {
  double height = 0.0;
  double radius = 0.0;       ///< of the farthest vertex
  double shaft = 0.0;        ///< radius of the longest coaxial shaft; 0: none
  double widestShaft = 0.0;  ///< radius of the widest one
  double through = 0.0;      ///< radius of the narrowest coaxial hole that goes through most of it; 0: none
  double low = 0.0;          ///< along the axis, from its point
  double high = 0.0;
  double headLow = 0.0;  ///< of what is wider than the shaft
  double headHigh = 0.0;
  double headLength = 0.0;
  bool headAtEnd = false;
  int sides = 0;        ///< of a prism about the axis
  int socketSides = 0;  ///< of a hole that is a prism about the axis
};

double offAxis(const Vector3& point, const CylinderRegion& axis) {
  const Vector3 way = point - axis.point;
  return (way - axis.direction * axis.direction.dot(way)).norm();
}

bool isCoaxial(const CylinderRegion& one, const CylinderRegion& axis) {
  return std::abs(one.direction.dot(axis.direction)) > kParallel &&
         offAxis(one.point, axis) < kSameLength * axis.radius;
}

/// Sides of a prism: the planes along the axis, where all are equally far from it, or, of four, each two of them.
/// `outer`: 1 of a prism, -1 of a hole.
int sidesAbout(const SurfaceRegions& regions, const CylinderRegion& axis, double outer) {
  std::vector<double> distances;
  for (const PlaneRegion& plane : regions.planes) {
    if (std::abs(plane.normal.dot(axis.direction)) > 1e-3) continue;
    const double distance = outer * (plane.offset - plane.normal.dot(axis.point));
    if (distance > 0.0) distances.push_back(distance);
  }
  if (distances.empty()) return 0;
  std::sort(distances.begin(), distances.end());
  const double first = distances.front();
  const auto alike = [&](double one, double other) { return std::abs(one - other) < kSameLength * first; };
  const bool equal = alike(distances.back(), first);
  const bool rectangle =
      distances.size() == 4 && alike(distances[0], distances[1]) && alike(distances[2], distances[3]);
  return equal || rectangle ? static_cast<int>(distances.size()) : 0;
}

/// The head of a countersunk screw begins where its cone leaves the shaft, although only its rim is wider there.
void takeCountersunkHeads(const SurfaceRegions& regions, const CylinderRegion& axis, double shaft, Range& head) {
  for (const RoundRegion& round : regions.rounds) {
    const SurfaceFace& cone = round.surface;
    if (cone.kind != SurfaceFace::Kind::Cone || !round.shaft) continue;
    if (std::abs(cone.axis.dot(axis.direction)) < kParallel || offAxis(cone.point, axis) > kSameLength * axis.radius) {
      continue;
    }
    if (coneRadiusAt(cone, round.high) < kLeastHead * shaft) continue;
    for (const double height : {round.low, round.high}) {
      head.take(axis.direction.dot(cone.point + height * cone.axis - axis.point));
    }
  }
}

TurnedShape shapeAbout(const TriangleMesh& mesh, const SurfaceRegions& regions, const CylinderRegion& axis) {
  TurnedShape shape;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vector3& vertex : mesh.vertices) {
    const double at = axis.direction.dot(vertex - axis.point);
    low = std::min(low, at);
    high = std::max(high, at);
    shape.radius = std::max(shape.radius, offAxis(vertex, axis));
  }
  shape.height = high - low;
  double longest = 0.0;
  for (const CylinderRegion& cylinder : regions.cylinders) {
    if (!isCoaxial(cylinder, axis)) continue;
    const double length = cylinder.high - cylinder.low;
    if (cylinder.shaft) {
      shape.widestShaft = std::max(shape.widestShaft, cylinder.radius);
      if (length > longest) shape.shaft = cylinder.radius;
      longest = std::max(longest, length);
    } else if (length > 0.5 * shape.height && (shape.through == 0.0 || cylinder.radius < shape.through)) {
      shape.through = cylinder.radius;
    }
  }
  Range head;
  for (const Vector3& vertex : mesh.vertices) {
    if (shape.shaft == 0.0 || offAxis(vertex, axis) < 0.5 * (1.0 + kLeastHead) * shape.shaft) continue;
    head.take(axis.direction.dot(vertex - axis.point));
  }
  if (shape.shaft > 0.0) takeCountersunkHeads(regions, axis, shape.shaft, head);
  if (head.low > head.high) head = {high, low};
  shape.headLength = std::max(0.0, head.high - head.low);
  const double slack = kSameLength * shape.height;
  shape.headAtEnd = head.low - low < slack || high - head.high < slack;
  shape.low = low;
  shape.high = high;
  shape.headLow = head.low;
  shape.headHigh = head.high;
  shape.sides = sidesAbout(regions, axis, 1.0);
  shape.socketSides = sidesAbout(regions, axis, -1.0);
  return shape;
}

/// What a shape may be, before its contacts are asked.
FastenerKind kindOf(const TurnedShape& shape) {
  const double flatness = shape.height / (2.0 * shape.radius);
  if (shape.through > 0.0) {
    if (shape.radius > kMostRing * shape.through) return FastenerKind::None;
    if ((shape.sides == 6 || shape.sides == 4) && flatness <= kMostNut) return FastenerKind::Nut;
    const bool round = shape.widestShaft > (1.0 - kSameLength) * shape.radius;
    return round && flatness <= kMostWasher ? FastenerKind::Washer : FastenerKind::None;
  }
  if (shape.shaft == 0.0) return FastenerKind::None;
  const double head = shape.radius / shape.shaft;
  if (head >= kLeastHead && head <= kMostHead && shape.headAtEnd && shape.headLength <= kHeadShare * shape.height) {
    return FastenerKind::Screw;
  }
  const double length = shape.height / shape.shaft;
  return head < 1.0 + kSameLength && length >= kLeastPin && length <= kMostPin ? FastenerKind::Pin : FastenerKind::None;
}

/// A shape, and the axis that it is about.
struct AboutAxis {
  CylinderRegion axis;
  TurnedShape shape;
  FastenerKind kind = FastenerKind::None;
};

/// About any axis of a cylinder through its middle: the first that makes a fastener of it.
std::optional<AboutAxis> fastenerShape(const TriangleMesh& raw) {
  const TriangleMesh mesh = welded(raw);
  const SurfaceRegions regions = findSurfaceRegions(mesh);
  const Vector3 middle = boundingBox(mesh).center();
  std::vector<const CylinderRegion*> tried;
  for (const CylinderRegion& axis : regions.cylinders) {
    const bool known =
        std::any_of(tried.begin(), tried.end(), [&](const auto* other) { return isCoaxial(axis, *other); });
    if (known) continue;
    tried.push_back(&axis);
    const TurnedShape shape = shapeAbout(mesh, regions, axis);
    if (offAxis(middle, axis) > kOffAxis * shape.radius) continue;
    const FastenerKind kind = kindOf(shape);
    if (kind != FastenerKind::None) return AboutAxis{axis, shape, kind};
  }
  return std::nullopt;
}

FastenerKind kindByShape(const TriangleMesh& mesh) {
  const auto about = fastenerShape(mesh);
  return about ? about->kind : FastenerKind::None;
}

/// What a body's contacts say of it.
struct Role {
  bool touches = false;
  bool shaft = false;
  bool hole = false;
};

std::vector<Role> rolesOf(std::size_t bodies, const std::vector<Contact>& contacts) {
  std::vector<Role> roles(bodies);
  for (const Contact& contact : contacts) {
    if (contact.kind == ContactKind::Clearance) continue;
    for (const bool isA : {true, false}) {
      Role& role = roles[isA ? contact.a : contact.b];
      role.touches = true;
      if (!contact.axis) continue;
      const bool shaft = contact.axis->shaftIsA == isA;
      role.shaft = role.shaft || shaft;
      role.hole = role.hole || !shaft;
    }
  }
  return roles;
}

bool confirms(const Role& role, FastenerKind shape) {
  switch (shape) {
    case FastenerKind::Screw:
    case FastenerKind::Pin: return role.shaft;
    case FastenerKind::Nut: return role.hole;
    case FastenerKind::Washer: return role.touches;
    case FastenerKind::None: break;
  }
  return false;
}

}  // namespace

const char* fastenerName(FastenerKind kind) { return kFastenerNames[static_cast<std::size_t>(kind)]; }

std::optional<FastenerKind> fastenerByName(const std::string& name) {
  const auto found = std::find(kFastenerNames.begin(), kFastenerNames.end(), name);
  if (found == kFastenerNames.end()) return std::nullopt;
  return static_cast<FastenerKind>(found - kFastenerNames.begin());
}

std::vector<FastenerKind> fastenersOf(const AssembledProduct& product, const std::vector<Contact>& contacts) {
  const std::vector<Role> roles = rolesOf(product.bodies.size(), contacts);
  std::map<MeshPtr, FastenerKind> shapes;
  std::vector<FastenerKind> kinds;
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    const MeshPtr& mesh = product.bodies[body].mesh;
    if (shapes.count(mesh) == 0) shapes[mesh] = kindByShape(*mesh);
    kinds.push_back(confirms(roles[body], shapes[mesh]) ? shapes[mesh] : FastenerKind::None);
  }
  return kinds;
}

std::optional<FastenerHead> headOf(const TriangleMesh& mesh, FastenerKind kind) {
  const auto about = fastenerShape(mesh);
  if (!about || about->kind != kind) return std::nullopt;
  const TurnedShape& shape = about->shape;
  FastenerHead head;
  head.radius = shape.radius;
  head.sides = shape.sides;
  head.socketSides = shape.socketSides;
  head.bothEnds = kind == FastenerKind::Nut;
  head.shaft = head.bothEnds ? shape.through : shape.shaft;
  head.height = head.bothEnds ? shape.height : shape.headLength;
  const bool atHigh = head.bothEnds || shape.high - shape.headHigh < shape.headLow - shape.low;
  head.outwards = atHigh ? about->axis.direction : Vector3(-about->axis.direction);
  head.end = about->axis.point + (atHigh ? shape.high : shape.low) * about->axis.direction;
  return head;
}

std::vector<OrderRule> fastenerRules(const std::vector<FastenerKind>& kinds, const std::vector<Contact>& contacts) {
  std::vector<OrderRule> rules;
  for (const Contact& contact : contacts) {
    if (!contact.axis || contact.axis->conical) continue;
    const std::size_t shaft = contact.axis->shaftIsA ? contact.a : contact.b;
    const std::size_t hole = contact.axis->shaftIsA ? contact.b : contact.a;
    if (kinds[hole] == FastenerKind::Nut) rules.push_back({hole, shaft, false});
  }
  return rules;
}

}  // namespace glissade
