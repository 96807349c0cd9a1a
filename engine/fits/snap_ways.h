#pragma once

#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/fits/assembled_product.h"

namespace glissade {

/// A direction in which a body leaves the bodies that it is hooked into while its hooks bend.
struct SnapWay {
  Vector3 direction;  ///< unit, world frame
  double bend = 0.0;  ///< metres; 0: the body leaves without a bend
};

/// The directions of the world's axes in which the body leaves while its hooks bend within their limits, each with the
/// least bend. A hook bends where the judge permits it (check/hook.h), and is thinned as in fits. After a stop some may
/// be missing.
std::vector<SnapWay> snapWays(const AssembledProduct& product, std::size_t body, const std::vector<std::size_t>& edges,
                              const StopToken& stop);

/// The least bend with which the body leaves in this direction, metres; nothing if its hooks do not bend so far, or
/// after a stop.
std::optional<double> leastBend(const AssembledProduct& product, std::size_t body,
                                const std::vector<std::size_t>& edges, const Vector3& direction, const StopToken& stop);

/// True if the judge counts the bend of a hook of either body on the path: see evidence::goesAlong(). `path`:
/// configurations of the body; `way`: its exit direction, unit, world frame.
bool keepsToWay(const Vector3& way, const RigidBody& body, const std::vector<Pose>& path, const RigidBody& other);

}  // namespace glissade
