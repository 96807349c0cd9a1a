#pragma once

#include <glissade/problem.h>

#include <cstdint>
#include <functional>

namespace glissade::api {

/// Draws one configuration. It belongs to one planner, on that planner's thread.
using DrawFunction = std::function<Pose()>;

/// A sampler: makes the draws of one planner. Everything random has to come from the seed. Strategies of several
/// planners call it on several threads. Multi-layer strategies draw in their places themselves. A pose that is invalid
/// or outside of the problem's bounds ends the run, as an exception does.
using SamplerFunction = std::function<DrawFunction(const Problem& problem, std::uint64_t seed)>;

}  // namespace glissade::api
