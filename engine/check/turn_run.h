#pragma once

#include <vector>

#include "engine/check/turn.h"

namespace glissade::check {

/// The rise of the edges from `first` to `last` as one motion that turns about an axis from its first configuration.
/// `reach`: largest distance of a vertex from the origin of the moving frame.
Rise riseOf(const std::vector<Pose>& path, std::size_t first, std::size_t last, const Vector3& point,
            const Vector3& axis, double reach);

}  // namespace glissade::check
