#pragma once

#include "engine/base/parameters.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/sequence/product_fits.h"

namespace glissade {

/// What a body moves in while others are there.
struct MotionWorld {
  CollisionWorldPtr world;
  std::vector<std::size_t> bodies;  ///< index in the product of each obstacle of the world
};

/// Composed of bodies that are prepared; the moving body is thinned as its fits allow, and
/// leaves threads by turning only.
MotionWorld motionWorld(const AssembledProduct& product, const ProductFits& fits, PreparedBodies& prepared,
                        std::size_t body, const BodySet& present);

/// The obstacle that is this body of the product: the inverse of MotionWorld::bodies, which has it.
std::size_t obstacleOf(std::size_t body, const std::vector<std::size_t>& bodies);

/// The parameters of motions of a body: the defaults for its size, one lane.
ParameterValues motionParameters(const RigidBody& body);

/// Obstacles of a motion world become bodies of the product.
void nameByProduct(MotionCertificate& certificate, const std::vector<std::size_t>& bodies);

}  // namespace glissade
