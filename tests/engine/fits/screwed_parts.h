#pragma once

#include "engine/fits/fitted_world.h"
#include "engine/fits/object_fits.h"
#include "tests/engine/fits/ring.h"

namespace glissade::test {

inline constexpr double kBoltRadius = 0.005;
inline constexpr double kBoltLength = 0.03;
inline constexpr double kNutLength = 0.008;
inline constexpr double kCoarsePitch = 0.0015;  ///< pitch of M10

inline RigidBody partAt(const std::string& id, TriangleMesh mesh, const Pose& X_WB) {
  RigidBody body;
  body.id = BodyId(id);
  body.name = id;
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  body.X_WB = X_WB;
  return body;
}

/// A hexagonal nut about z, with a cylinder as its thread.
inline TriangleMesh hexNut(double bore = kBoltRadius) {
  constexpr double kAcross = 0.008;  // distance of a flat from the axis
  TriangleMesh mesh = makeRing(bore, 1.0, kNutLength, 48);
  for (Vector3& vertex : mesh.vertices) {
    if (vertex.head<2>().norm() < 0.5) continue;
    const double sixth = 3.14159265358979323846 / 3.0;
    const double angle = std::atan2(vertex.y(), vertex.x());
    const double fromFlat = angle - (std::floor(angle / sixth + 1e-9) + 0.5) * sixth;
    vertex.head<2>() *= kAcross / std::cos(fromFlat);
  }
  return mesh;
}

/// A bolt without a head.
inline TriangleMesh plainBolt() { return makeRing(0.0, kBoltRadius, kBoltLength, 40); }

/// Fits that mark the pair "nut", "bolt" as a thread.
inline FitSettings markedThread() {
  FitSettings settings;
  settings.on = true;
  settings.pairs.push_back({"nut", "bolt", ContactKind::Thread, {}, false});
  return settings;
}

/// A product with the object as its last body; all triangles are exact.
inline AssembledProduct productOf(std::vector<RigidBody> obstacles, const RigidBody& object, FitSettings settings) {
  AssembledProduct product;
  product.bodies = std::move(obstacles);
  product.bodies.push_back(object);
  product.deflections.assign(product.bodies.size(), 0.0);
  product.fits = std::move(settings);
  return product;
}

/// The object among the obstacles at the start, with its fits.
struct FittedParts {
  AssembledProduct product;  ///< the object is the last body
  ObjectFits fits;
  CollisionWorldPtr world;
};

inline Result<FittedParts> fitted(const std::vector<RigidBody>& obstacles, const RigidBody& object,
                                  const std::vector<Pose>& ends, const FitSettings& settings) {
  FittedParts parts;
  parts.product = productOf(obstacles, object, settings);
  auto fits = findObjectFits({parts.product, obstacles.size(), ends});
  if (!fits) return fits.error();
  parts.fits = std::move(*fits);
  parts.world = withFits(CollisionWorld::build(obstacles, object.mesh), object.mesh, parts.fits.allowed);
  return parts;
}

}  // namespace glissade::test
