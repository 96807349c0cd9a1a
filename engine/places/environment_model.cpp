#include "engine/places/environment_model.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

Outcome check(const EnvironmentOptions& options, const Box3& workspace) {
  const auto refuse = [](const std::string& key, const Message& reason, const Message& advice) {
    return Diagnostic{ErrorKind::MalformedInput, "", "/environment/" + key, reason, advice};
  };
  const double side = workspace.isEmpty() ? 0.0 : workspace.sizes().maxCoeff();
  if (!(side > 0.0)) {
    return Diagnostic{ErrorKind::MalformedInput, "", "/workspace", GLISSADE_TEXT("is flat"),
                      GLISSADE_TEXT("Give it a size.")};
  }
  const double finest = side / (1 << Octree::kDeepest);
  // The negation refuses NaN, too.
  if (!(options.cellSize >= 0.0) || (options.cellSize > 0.0 && options.cellSize < finest * (1.0 - 1e-9))) {
    return refuse("cell_size", GLISSADE_TEXT("is too small for this workspace"),
                  {GLISSADE_TEXT("Give 0, or at least %1."), {std::to_string(finest)}});
  }
  if (!(options.memory >= 1.0 && options.memory <= 4096.0)) {
    return refuse("memory", GLISSADE_TEXT("is out of range"), GLISSADE_TEXT("Give 1 to 4096 MiB."));
  }
  if (options.topologyLevel < 2 || options.topologyLevel > 8) {
    return refuse("topology_level", GLISSADE_TEXT("is out of range"), GLISSADE_TEXT("Give 2 to 8."));
  }
  const PlaceIdentifierRegistry registry = makePlaceIdentifierRegistry();
  if (registry.find(options.identifier) != nullptr) return Done{};
  std::string known;
  for (const auto& entry : registry.entries()) known += (known.empty() ? "" : ", ") + entry.id;
  return refuse("places", {GLISSADE_TEXT("names no way to find places: '%1'"), {options.identifier}},
                {GLISSADE_TEXT("Give one of %1."), {known}});
}

FreeSpace freeSpaceOf(const EnvironmentModel& model) {
  return freeSpaceOf(*model.octree, std::min(model.options.topologyLevel, model.octree->depth()));
}

/// Completes a model with known places by the data that mobile bodies determine.
void addMobileBodies(EnvironmentModel& model, const StopToken& stop) {
  model.clearance = distanceTransform(model.space, true, stop);
  model.cluttered.assign(model.map.places.size(), false);
  for (std::size_t cell = 0; cell < model.map.placeOf.size(); ++cell) {
    const int place = model.map.placeOf[cell];
    if (place != kNoPlace && model.space.kinds[cell] == CellKind::Mobile) {
      model.cluttered[static_cast<std::size_t>(place)] = true;
    }
  }
}

}  // namespace

Diagnostic environmentInterrupted() {
  return {ErrorKind::Interrupted, "", "", GLISSADE_TEXT("the environment model was not finished"),
          GLISSADE_TEXT("Start it again.")};
}

Result<EnvironmentModelPtr> buildEnvironment(const std::vector<RigidBody>& bodies, const Box3& workspace,
                                             const EnvironmentOptions& options, const StopToken& stop) {
  const Outcome sound = check(options, workspace);
  if (!sound) return sound.error();
  auto model = std::make_shared<EnvironmentModel>();
  model->options = options;
  const OctreeResolution resolution{options.cellSize, static_cast<std::size_t>(options.memory * (1U << 20))};
  model->octree = std::make_shared<const Octree>(bodies, workspace, resolution, stop);
  model->space = freeSpaceOf(*model);
  for (const RigidBody& body : bodies) {
    if (body.mobility == Mobility::Static) append(model->statics_W, transformed(*body.mesh, body.X_WB));
  }
  if (stop.stopRequested()) return environmentInterrupted();
  const std::vector<double> clearance = distanceTransform(model->space, false, stop);
  const std::vector<Passage> passages = findPassages(model->space, stop);
  if (stop.stopRequested()) return environmentInterrupted();
  const PlaceIdentifierRegistry registry = makePlaceIdentifierRegistry();
  const PlaceLabels labels = registry.find(options.identifier)->identify({model->space, clearance, passages, stop});
  if (stop.stopRequested()) return environmentInterrupted();
  model->map = makeTopologicalMap(model->space, labels, clearance, passages, model->statics_W, stop);
  if (stop.stopRequested()) return environmentInterrupted();
  addMobileBodies(*model, stop);
  if (stop.stopRequested()) return environmentInterrupted();
  return EnvironmentModelPtr(std::move(model));
}

Result<EnvironmentModelPtr> updateEnvironment(const EnvironmentModel& before, const std::vector<RigidBody>& bodies,
                                              const Box3& workspace, const EnvironmentOptions& options,
                                              const StopToken& stop) {
  const Box3& known = before.octree->workspace();
  const bool sameSpace = known.min() == workspace.min() && known.max() == workspace.max();
  auto octree = options == before.options && sameSpace ? before.octree->withMobileBodiesAt(bodies) : std::nullopt;
  if (!octree) return buildEnvironment(bodies, workspace, options, stop);
  auto model = std::make_shared<EnvironmentModel>(before);
  model->octree = std::make_shared<const Octree>(std::move(*octree));
  model->space = freeSpaceOf(*model);
  addMobileBodies(*model, stop);
  if (stop.stopRequested()) return environmentInterrupted();
  return EnvironmentModelPtr(std::move(model));
}

}  // namespace glissade
