#pragma once

#include <utility>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/pulled_thread.h"
#include "engine/fits/joint.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// Bodies that are screwed together although neither is a screw or a nut by its shape: a nozzle and its heater block, a
/// pipe and its fitting. A shaft of one body is thicker than the coaxial hole of the other around it by the depth of a
/// thread (evidence::hasDepthOfThread()). `known`: joints that were found before; pairs that these join are left out,
/// unless by an insert that is only suggested. Ordered by body.
Joints findThreadedParts(const ProductShapes& shapes, const Joints& known, const StopToken& stop);

/// The joint of a pair with these threads (evidence::commonThreads()); the thread that is engaged longest counts.
/// `pair`: the moving body and the other body.
Joint jointOfThread(const ProductShapes& shapes, const std::pair<std::size_t, std::size_t>& pair,
                    const std::vector<evidence::CommonThread>& threads);

}  // namespace glissade
