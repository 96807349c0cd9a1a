#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/thread_team.h"
#include "engine/base/work_watch.h"
#include "engine/fits/fit_settings.h"
#include "engine/model/body_id.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// A body at its place in the product.
struct ContactBody {
  BodyId id;
  MeshPtr mesh;
  Pose X_WB;
  double deflection = 0.0;  ///< largest deviation of the mesh from its surface, metres; 0: not known
};

/// Common axis of a shaft and its hole, or of a cone and the surface around it, world frame.
struct ContactAxis {
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
  double radiusA = 0.0;
  double radiusB = 0.0;
  bool shaftIsA = true;  ///< `a` is the shaft, `b` the hole
  bool conical = false;  ///< the pair are cones; the radii are those at the middle of their common part
};

/// Two bodies that are near each other in the assembled configuration.
struct Contact {
  std::size_t a = 0;  ///< index of the body, below `b`
  std::size_t b = 0;
  ContactKind kind = ContactKind::Contact;
  double gap = 0.0;          ///< metres; 0 if the bodies touch or overlap
  double overlap = 0.0;      ///< metres, see engine/fits/README.md; 0 if the bodies do not overlap
  double uncertainty = 0.0;  ///< largest error of gap and overlap by tessellation, metres
  double deviation = 0.0;    ///< deviation of the near triangles from the surfaces, both bodies together, metres
  double thickness = 0.0;    ///< thickness at the deepest point, of the thicker body, metres
  std::optional<ContactAxis> axis;
  bool isPlainOverlap =
      false;  ///< see evidence::PairBounds::isPlainOverlap; false for a clash that nobody has accepted
};

struct ContactReport {
  std::vector<Contact> contacts;                                   ///< ordered by a, then by b
  std::vector<std::pair<std::size_t, std::size_t>> notCompared{};  ///< pairs left after `enough`
};

/// Limits of the reported pairs, and of overlaps that are clashes.
struct ContactLimits {
  double clearanceUpTo = 0.0;         ///< metres: pairs with a gap up to this are listed too
  double clashOverlap = 1e-3;         ///< metres
  double clashThickness = 0.2;        ///< share of the local thickness
  std::optional<std::size_t> only{};  ///< only pairs with this body

  friend bool operator==(const ContactLimits&, const ContactLimits&) = default;
};

/// Every pair of bodies that touch, overlap or are within the requested clearance, from their meshes. Stated or fitted
/// surfaces (findSurfaceRegions()) are compared exactly, other near surfaces by their triangles. Overlaps are found
/// between closed meshes only. The threads of the team share the work. After a stop the report is incomplete. `enough`:
/// once it is requested, no other pair is begun; pairs of few triangles come first then.
ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits, const WorkWatch& watch,
                           ThreadTeam& team, const std::optional<StopToken>& enough = {});
/// On the calling thread alone.
ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits = {},
                           const WorkWatch& watch = {});

}  // namespace glissade
