#include <glissade/path.h>

#include "engine/api/values.h"
#include "engine/files/path_exporter.h"

namespace glissade::api {

Result<Path> Path::make(const std::vector<Pose>& configurations) {
  if (const auto fault = faultOfPoses(configurations, "configurations")) return *fault;
  glissade::Path path;
  for (const Pose& q : configurations) path.points.push_back({enginePose(q)});
  return publicPath(std::move(path), {}, nullptr);
}

const std::vector<Pose>& Path::configurations() const { return impl().configurations; }
const Certificate& Path::certificate() const { return impl().certificate; }
double Path::length() const { return impl().path.length(); }
double Path::rotation() const { return impl().path.rotation(); }

Outcome Path::save(const std::string& file, const Scenario& scenario) const {
  return attempt<Done>("saving a path", [&]() -> Outcome {
    const auto exporter = pathExporterFor(file);
    if (!exporter) return publicDiagnostic(exporter.error());
    const SaveResult saved = exporter->write(impl().path, *scenario.impl().loaded, impl().provenance, file);
    return saved ? Outcome(Done{}) : Outcome(publicDiagnostic(saved.why));
  });
}

}  // namespace glissade::api
