#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "app/window/workbench.h"
#include "engine/product/snap_features.h"
#include "widgets/bridge/background_task.h"

namespace glissade {

/// What people point at on a mesh, and what bodies snap to.
struct MeshFeatures {
  explicit MeshFeatures(const MeshPtr& mesh) : measurable(mesh), snap(findSnapFeatures(measurable)) {}

  MeasurableMesh measurable;
  std::vector<SnapFeature> snap;
};
using MeshFeaturesPtr = std::shared_ptr<const MeshFeatures>;

/// The pointer means vertices and edges within this.
inline constexpr double kFeaturePixels = 9.0;

/// The features of the meshes of the open scenario, found once each, in the background. GUI thread.
class FeatureStore final : public QObject {
  Q_OBJECT

 public:
  explicit FeatureStore(const Workbench& bench);

  /// Null: they are not known yet.
  MeshFeaturesPtr find(const MeshPtr& mesh) const;
  /// Finds those of one mesh and calls `then`, unless another request comes, or cancel().
  void prepare(const MeshPtr& mesh, const std::function<void()>& then);
  void cancel() { request_.cancel(); }
  /// Finds those of all bodies, one mesh after the other.
  void prepareAll();

 private:
  std::vector<MeshPtr> unknownMeshes() const;

  const Workbench& bench_;
  std::map<MeshPtr, MeshFeaturesPtr> known_;
  bool all_ = false;  ///< those of all bodies are asked for
  BackgroundTask request_;
  BackgroundTask round_;
};

}  // namespace glissade
