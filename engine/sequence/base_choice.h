#pragma once

#include "engine/fits/joint.h"
#include "engine/fits/liaison_graph.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"

namespace glissade {

/// The body of the set on which the others are built if no person fixes one as base: it is large, touches many bodies
/// of the set, and stands on the ground, the lowest plane along gravity (zero: there is no ground). Bodies that
/// touch nothing, fasteners, guests and flexible bodies are no bases unless there is nothing else. The first one of
/// equal bodies. Precondition: the set has a body. `fasteners`: kind of each body; empty: not known.
std::size_t baseOf(const AssembledProduct& product, const BodySet& among, const LiaisonGraph& graph,
                   const Joints& joints, const std::vector<FastenerKind>& fasteners, const Vector3& gravity);

}  // namespace glissade
