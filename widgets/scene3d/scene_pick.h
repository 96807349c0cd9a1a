#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/geometry/plane_section.h"
#include "engine/places/topological_map.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {

/// A half line from the eye into the scene.
struct Ray {
  Vector3 origin;
  Vector3 direction;  ///< unit
};

/// The ray through a pixel; (x, y) in fractions of the view's height from its centre, y down.
Ray rayThrough(const CameraController& camera, double x, double y);

/// The first meeting of the ray with a body that is not hidden: index into `bodies`; nothing if it meets none. Parts on
/// the side of the normal of a plane of `sections` are cut away and do not count.
struct BodyHit {
  std::size_t body;
  double distance;
  std::size_t triangle;  ///< index in the body's mesh
};
std::optional<BodyHit> pickBody(const std::vector<RigidBody>& bodies, const Ray& ray,
                                const std::set<BodyId>& hidden = {}, const std::vector<Plane>& sections = {});

/// The place that a person means by pointing there: the narrowest of all places along the ray, up to the given
/// distance; kNoPlace if there is none. Rooms lie around everything, so that people point at holes.
int pickPlace(const TopologicalMap& map, const Ray& ray, double farthest);

}  // namespace glissade
