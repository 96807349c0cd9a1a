#include "engine/api/outside_sampler.h"

#include <utility>

#include "engine/api/values.h"

namespace glissade::api {

ConfigurationSource sourceOf(SamplerFunction sampler, const Problem& problem) {
  return [sampler = std::move(sampler), problem](std::uint64_t seed) -> ConfigurationDraw {
    DrawFunction draw = sampler(problem, seed);
    if (!draw) throw OutsideFault("the sampler made no function");
    return [draw = std::move(draw), bounds = problem.impl().problem.bounds] {
      const Pose drawn = draw();
      if (const auto fault = faultOfPose(drawn, "the sampler's pose")) throw OutsideFault(fault->text());
      if (!bounds.contains(glissade::Vector3(drawn.position))) {
        throw OutsideFault("the sampler's pose: is outside of the bounds");
      }
      return enginePose(drawn);
    };
  };
}

}  // namespace glissade::api
