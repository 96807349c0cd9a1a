#pragma once

#include "engine/fits/liaison_graph.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// Bodies that may lie beside the product, ascending: they touch no body, are joined to none, and their boxes are apart
/// from those of all other bodies by more than a hundredth of the product's size. A part that is drawn with play is
/// none. None where no contact is known.
BodyGroup isolatedBodies(const AssembledProduct& product, const LiaisonGraph& graph);

}  // namespace glissade
