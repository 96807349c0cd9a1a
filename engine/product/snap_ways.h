#pragma once

#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/product/assembled_product.h"

namespace glissade {

/// A way on which a body leaves what it is hooked into while its hooks bend.
struct SnapWay {
  Vector3 direction;  ///< unit, world frame
  double bend = 0.0;  ///< metres; 0: nothing is in the way
};

/// Of the six ways along the axes of the world, those on which the body leaves while its hooks bend by no more than
/// hooks do, each with the least bend. A hook bends where the judge says so (check/hook.h), and is taken thinner as in
/// fits. After a stop some may be missing.
std::vector<SnapWay> snapWays(const AssembledProduct& product, std::size_t body, const std::vector<std::size_t>& edges,
                              const StopToken& stop);

/// The judge counts the bend of a hook of either body on the path: check::goesAlong(). `path`: configurations of the
/// body; `way`: unit, world frame, in which it leaves.
bool keepsToWay(const Vector3& way, const RigidBody& body, const std::vector<Pose>& path, const RigidBody& other);

}  // namespace glissade
