#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/environment/rigid_body.h"
#include "engine/product/fit_settings.h"

namespace glissade {

/// A body where the product has it.
struct ContactBody {
  std::string id;
  MeshPtr mesh;
  Pose X_WB;
  double deflection = 0.0;  ///< metres that the mesh may be off the surface that it stands for; 0: not known
};

/// Common axis of a shaft and its hole, or of a cone and what it lies in, world frame.
struct ContactAxis {
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
  double radiusA = 0.0;
  double radiusB = 0.0;
  bool shaftIsA = true;  ///< `a` is the shaft, `b` the hole
  bool conical = false;  ///< of cones: their radii in the middle of what they share
};

/// Two bodies that are near in the assembled configuration.
struct Contact {
  std::size_t a = 0;  ///< index of the body, below `b`
  std::size_t b = 0;
  ContactKind kind = ContactKind::Contact;
  double gap = 0.0;          ///< metres; 0 where they touch or overlap
  double overlap = 0.0;      ///< metres, see engine/product/README.md; 0 where they do not overlap
  double uncertainty = 0.0;  ///< metres that tessellation may have falsified gap and overlap by
  double deviation = 0.0;    ///< metres that the triangles near each other may be off the surfaces, of both bodies
  double thickness = 0.0;    ///< of the thicker of the two at the deepest point, metres; 0 where nothing overlaps
  std::optional<ContactAxis> axis;
  bool isPlainOverlap = false;  ///< as of check::PairBounds; a clash that nobody accepted is none
};

struct ContactReport {
  std::vector<Contact> contacts;  ///< by a, then by b
};

/// What is reported, and from where on an overlap is a clash.
struct ContactLimits {
  double clearanceUpTo = 0.0;         ///< metres: pairs with a gap up to this are listed too
  double clashOverlap = 1e-3;         ///< metres
  double clashThickness = 0.2;        ///< share of the local thickness
  std::optional<std::size_t> only{};  ///< pairs with this body
};

/// Every pair of bodies that touch, overlap or are nearer than the clearance asked for, from their meshes: surfaces
/// that are stated or fitted (findSurfaceRegions()) are compared exactly, what else is near is measured on the
/// triangles. Overlaps are found between closed meshes only. After a stop the report is incomplete.
ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits = {},
                           const WorkWatch& watch = {});

/// "planar", "thread", ...
const char* kindName(ContactKind kind);
std::optional<ContactKind> kindByName(const std::string& name);

}  // namespace glissade
