#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/product/contact_report.h"

namespace glissade {

/// A product whose bodies may leave one by one. The origin of the frame B of each body is the middle of its
/// bounding box. Bodies of the same geometry share their mesh. Immutable while a sequence is planned.
struct AssembledProduct {
  std::vector<RigidBody> bodies;    ///< X_WB is the assembled configuration
  std::vector<double> deflections;  ///< as of ContactBody, of each body
  FitSettings fits;

  /// Nothing where no body has this id.
  std::optional<std::size_t> indexOf(const std::string& id) const;
};

/// Body by body the same ids, meshes, places and fits.
bool isSameProduct(const AssembledProduct& a, const AssembledProduct& b);

/// The bodies as findContacts() takes them, in their order.
std::vector<ContactBody> contactBodiesOf(const AssembledProduct& product);

/// Which bodies of a product are there: one entry each.
using BodySet = std::vector<bool>;

/// Bodies that move as one rigid body: indices, ascending, at least one. The first one names the group.
using BodyGroup = std::vector<std::size_t>;

/// Indices of the bodies that are in the set, ascending.
std::vector<std::size_t> bodiesIn(const BodySet& set);

/// The same bodies, each about the middle of its bounding box; meshes that were shared still are.
std::vector<RigidBody> aboutTheirMiddles(std::vector<RigidBody> bodies);

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
