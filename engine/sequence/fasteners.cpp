#include "engine/sequence/fasteners.h"

#include <algorithm>
#include <array>

#include "engine/fits/nut_on_shaft.h"

namespace glissade {
namespace {

/// Largest ratio of height to outer diameter of a washer.
constexpr double kMostWasher = 0.25;
/// Largest ratio of outer radius to hole radius of a washer.
constexpr double kMostRing = 4.0;
/// Limits of the ratio of length to radius of a pin.
constexpr double kLeastPin = 3.0;
constexpr double kMostPin = 20.0;

/// The kind that the shape permits, before the contacts are examined.
FastenerKind kindOf(const TurnedShape& shape) {
  switch (shape.kind) {
    case TurnedKind::Screw:
    case TurnedKind::SetScrew: return FastenerKind::Screw;
    case TurnedKind::Nut: return FastenerKind::Nut;
    case TurnedKind::Ring: {
      const bool isFlat = shape.length() <= kMostWasher * 2.0 * shape.outer && shape.outer <= kMostRing * shape.hole;
      return isFlat ? FastenerKind::Washer : FastenerKind::None;
    }
    case TurnedKind::Rod: {
      const double length = shape.length() / shape.shaft;
      return length >= kLeastPin && length <= kMostPin ? FastenerKind::Pin : FastenerKind::None;
    }
  }
  return FastenerKind::None;
}

/// Roles of a body in its contacts.
struct Role {
  bool touches = false;
  bool shaft = false;
  bool hole = false;
  bool screwed = false;  ///< a shaft in a thread or in a nut, or a cone in a countersink
};

std::vector<Role> rolesOf(const std::vector<bool>& isNutByShape, const std::vector<Contact>& contacts) {
  std::vector<Role> roles(isNutByShape.size());
  for (const Contact& contact : contacts) {
    if (contact.kind == ContactKind::Clearance) continue;
    for (const bool isA : {true, false}) {
      Role& role = roles[isA ? contact.a : contact.b];
      role.touches = true;
      if (!contact.axis) continue;
      const bool shaft = contact.axis->shaftIsA == isA;
      role.shaft = role.shaft || shaft;
      role.hole = role.hole || !shaft;
      const bool isThread =
          contact.kind == ContactKind::Thread || contact.axis->conical || isNutByShape[isA ? contact.b : contact.a];
      role.screwed = role.screwed || (shaft && isThread);
    }
  }
  return roles;
}

/// Decides by shape and contacts, and by the name where these leave the kind open.
bool confirms(const ProductShapes& shapes, const Designations& said, std::size_t body, const Role& role,
              FastenerKind kind) {
  switch (kind) {
    case FastenerKind::Screw: return isScrewByItself(shapes, said, body) || (role.shaft && role.screwed);
    case FastenerKind::Pin: return role.shaft;
    case FastenerKind::Nut: return role.hole && isNut(shapes, said, body);
    case FastenerKind::Washer: return role.touches;
    case FastenerKind::None: break;
  }
  return false;
}

/// Radius of the vertex farthest from the axis, among vertices at this height or above.
double radiusAbove(const TriangleMesh& mesh, const AxisLine& axis, double low) {
  double radius = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    if (axis.heightOf(vertex) >= low) radius = std::max(radius, axis.distanceOf(vertex));
  }
  return radius;
}

}  // namespace

std::vector<FastenerKind> fastenersOf(const ProductShapes& shapes, const std::vector<Contact>& contacts) {
  const Designations said = designationsOf(shapes.product());
  std::vector<bool> isNutByShape;
  for (std::size_t body = 0; body < shapes.size(); ++body) isNutByShape.push_back(isNut(shapes, said, body));
  const std::vector<Role> roles = rolesOf(isNutByShape, contacts);
  std::vector<FastenerKind> kinds(shapes.size(), FastenerKind::None);
  for (std::size_t body = 0; body < shapes.size(); ++body) {
    const TurnedShape* shape = roles[body].touches ? shapes.turned(body) : nullptr;
    const FastenerKind kind = shape != nullptr ? kindOf(*shape) : FastenerKind::None;
    if (confirms(shapes, said, body, roles[body], kind)) kinds[body] = kind;
  }
  return kinds;
}

std::optional<FastenerHead> headOf(const TriangleMesh& mesh, const TurnedShape& shape) {
  const FastenerKind kind = kindOf(shape);
  if (kind != FastenerKind::Screw && kind != FastenerKind::Nut) return std::nullopt;
  FastenerHead head;
  head.bothEnds = kind == FastenerKind::Nut;
  head.end = shape.axis.point + shape.high * shape.axis.direction;
  head.outwards = shape.axis.direction;
  head.radius = radiusAbove(mesh, shape.axis, head.bothEnds ? shape.low : shape.headLow);
  head.height = head.bothEnds ? shape.length() : shape.high - shape.headLow;
  head.shaft = head.bothEnds ? shape.hole : shape.shaft;
  head.sides = shape.sides;
  head.drive = shape.drive.kind;
  return head;
}

std::optional<FastenerHead> headOf(const TriangleMesh& mesh) {
  const auto shape = turnedShapeOf(mesh, AxialMesh(mesh));
  return shape ? headOf(mesh, *shape) : std::nullopt;
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
