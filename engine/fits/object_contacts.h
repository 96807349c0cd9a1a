#pragma once

#include <map>
#include <vector>

#include "engine/fits/object_fits.h"

namespace glissade {

/// A contact of the object, which is `b`, with an obstacle, and the ends at which it exists.
struct FoundContact {
  Contact contact;
  std::vector<Pose> at;
  Pose measuredAt{};  ///< end at which the contact was measured
};

/// The axis with its bodies exchanged.
ContactAxis exchanged(ContactAxis axis);

/// True if a cylinder of one body is in a cylinder of the other.
bool hasShaft(const Contact& contact);

/// The body for a comparison with others; its mesh is not thinned.
ContactBody contactBody(const RigidBody& body, const Pose& X_WB);

/// The contacts of the question's object at the ends, by obstacle, each measured at the end where it is deepest. Pairs
/// of a hook and its edge, and those that a person calls a thread, need not touch.
///
/// Errors: see findObjectFits().
Result<std::map<std::size_t, FoundContact>> findObjectContacts(const FitQuestion& question,
                                                               const std::vector<Pose>& ends,
                                                               ThinnableBodies& thinnable, const StopToken& stop);

}  // namespace glissade
