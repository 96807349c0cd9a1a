#pragma once

#include <map>
#include <vector>

#include "engine/product/object_fits.h"

namespace glissade {

/// A contact of the object, which is `b`, with an obstacle, and at which of the ends.
struct FoundContact {
  Contact contact;
  std::vector<Pose> at;
  Pose measuredAt{};  ///< the end that the contact was measured at
};

/// The same with its bodies exchanged.
ContactAxis exchanged(ContactAxis axis);

/// A cylinder of the one is in a cylinder of the other.
bool hasShaft(const Contact& contact);

/// The body where it is compared with others; its mesh is taken as it is.
ContactBody contactBody(const RigidBody& body, const Pose& X_WB);

/// The contacts of the question's object at the ends, by obstacle, each as it was measured where it is deepest. Pairs
/// of a hook and its edge, and those that a person calls a thread, need not touch.
///
/// Errors: as of findObjectFits().
Result<std::map<std::size_t, FoundContact>> findObjectContacts(const FitQuestion& question,
                                                               const std::vector<Pose>& ends,
                                                               ThinnableBodies& thinnable, const StopToken& stop);

}  // namespace glissade
