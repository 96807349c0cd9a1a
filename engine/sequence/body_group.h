#pragma once

#include <vector>

#include "engine/fits/assembled_product.h"

namespace glissade {

/// Bodies of a product that are there: one entry for each body.
using BodySet = std::vector<bool>;

/// Bodies that move as one rigid body: indices, ascending, at least one. The first one names the group.
using BodyGroup = std::vector<std::size_t>;

/// Indices of the bodies that are in the set, ascending.
std::vector<std::size_t> bodiesIn(const BodySet& set);

/// The set without the bodies of the group.
BodySet without(BodySet set, const BodyGroup& group);

/// The bounding box of the bodies of the set where they are assembled; empty if the set is empty.
Box3 boxOf(const AssembledProduct& product, const BodySet& set);

/// The body whose bounding box in its own frame has the largest volume; the first one of equal bodies.
/// Precondition: the product has a body.
std::size_t largestBody(const AssembledProduct& product);

/// Volume of the body's bounding box in its own frame, cubic metres.
double boxVolume(const RigidBody& body);
/// Sum of the box volumes of the bodies, cubic metres.
double boxVolume(const AssembledProduct& product, const BodyGroup& group);

}  // namespace glissade
