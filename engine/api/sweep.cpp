#include "engine/api/values.h"
#include "engine/sweep/swept_volume.h"

namespace glissade::api {

Result<SweptVolume> sweep(const Mesh& body, const std::vector<Pose>& poses, const SweepOptions& options) {
  if (const auto fault = faultOfPoses(poses, "poses")) return *fault;
  // The negation refuses NaN, too.
  if (options.bound && !(*options.bound > 0.0)) return wrongArgument("bound", "is not above 0");
  return attempt<SweptVolume>("making a swept volume", [&]() -> Result<SweptVolume> {
    std::vector<glissade::Pose> path;
    for (const Pose& pose : poses) path.push_back(enginePose(pose));
    const WorkWatch watch(options.stop, options.progress);
    const TriangleMesh& mesh = *body.impl().mesh;
    auto made = options.bound ? sweptVolume(mesh, path, *options.bound, watch) : usualSweptVolume(mesh, path, watch);
    if (!made) return publicDiagnostic(made.error());
    auto surface = std::make_shared<const TriangleMesh>(std::move(made->surface_W));
    return SweptVolume{valueOf<Mesh>({std::move(surface)}), made->bound, made->volume, made->excess};
  });
}

}  // namespace glissade::api
