#pragma once

#include <optional>
#include <vector>

#include "engine/fits/contact_report.h"
#include "engine/fits/product_shapes.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// The kind of each body by its shape (fastener_shape.h), its contacts, and its name where these leave it open:
/// - screw: it has a drive, the head of a cap screw or the name of a screw, whatever it touches; or it is a shaft in a
/// thread, in a nut or in a countersink
/// - nut: on a shaft, with the width of a nut (evidence/nut_size.h) or with the name of a nut
/// - washer: a flat ring that touches something
/// - pin: a shaft in a hole, without a head, not longer than ten diameters
std::vector<FastenerKind> fastenersOf(const ProductShapes& shapes, const std::vector<Contact>& contacts);

/// The place where a tool engages a fastener, in the body's frame.
struct FastenerHead {
  Vector3 end = Vector3::Zero();        ///< on the axis, at the outer end of the head
  Vector3 outwards = Vector3::UnitZ();  ///< unit, along the axis
  double radius = 0.0;                  ///< distance of the farthest vertex from the axis
  double height = 0.0;
  double shaft = 0.0;  ///< radius of the shaft of a screw, or of the hole of a nut
  int sides = 0;       ///< sides of a prismatic head; 0: the head is round
  DriveKind drive = DriveKind::None;
  bool bothEnds = false;  ///< a tool meets a nut at either end
};

/// The head of a screw or a nut; nothing if the mesh does not have such a shape. `shape`: turnedShapeOf() the mesh.
std::optional<FastenerHead> headOf(const TriangleMesh& mesh, const TurnedShape& shape);
/// Computes the shape first.
std::optional<FastenerHead> headOf(const TriangleMesh& mesh);

/// Nuts leave before the shafts that they are on: shafts would slip through nuts that are drawn as equal cylinders.
std::vector<OrderRule> fastenerRules(const std::vector<FastenerKind>& kinds, const std::vector<Contact>& contacts);

}  // namespace glissade
