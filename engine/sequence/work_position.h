#pragma once

#include <optional>

#include "engine/fits/joint.h"
#include "engine/fits/liaison_graph.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"

namespace glissade {

/// The body on which the others are built, and how the product lies meanwhile.
struct WorkPosition {
  std::size_t base = 0;
  Vector3 up = Vector3::UnitZ();  ///< upward direction of the work place, unit, frame of the product
};

/// Knowledge about a product from which the position of the work is chosen.
struct PositionQuestion {
  const AssembledProduct& product;
  const LiaisonGraph& graph;
  const Joints& joints;
  const std::vector<FastenerKind>& fasteners;  ///< kind of each body; empty: not known
  BodySet among;                               ///< bodies that are there; at least one
  BodySet bases{};              ///< bodies that a person fixes as base, all of them there; empty: none is fixed
  std::optional<Vector3> up{};  ///< upward direction that a person states, any length
};

/// The base and the upward direction, unless a person states them. The base is large where it rests, touches many
/// bodies of the set, and stands on the ground, the lowest plane. It rests on a large part of its surface, its centre
/// is above that part, and most of the other bodies are above it. Directions are those of the axes of the file, and
/// both normals of the base's largest plane; +z, then +y, of nearly equal ones. Bodies that touch nothing, fasteners,
/// guests and flexible bodies are no bases unless there is nothing else. The first one of equal bodies.
WorkPosition workPosition(const PositionQuestion& question);

}  // namespace glissade
