#pragma once

#include <vector>

#include "engine/product/assembled_product.h"

namespace glissade {

/// Which bodies of a product are there: one entry each.
using BodySet = std::vector<bool>;

/// Bodies that move as one rigid body: indices, ascending, at least one. The first one names the group.
using BodyGroup = std::vector<std::size_t>;

/// Indices of the bodies that are in the set, ascending.
std::vector<std::size_t> bodiesIn(const BodySet& set);

/// The set without the bodies of the group.
BodySet without(BodySet set, const BodyGroup& group);

/// The bounding box of the bodies where they are assembled; empty where there is none.
Box3 boxOf(const AssembledProduct& product, const BodySet& set);

/// The body whose bounding box, in its own frame, has the largest volume; of equal ones the first.
/// Precondition: there is a body.
std::size_t largestBody(const AssembledProduct& product);

/// Volume of the body's bounding box in its own frame, cubic metres.
double boxVolume(const RigidBody& body);
/// The sum of those of the bodies.
double boxVolume(const AssembledProduct& product, const BodyGroup& group);

}  // namespace glissade
