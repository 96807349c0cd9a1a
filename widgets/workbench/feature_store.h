#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "engine/fits/snap_features.h"
#include "widgets/controls/background_task.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The features of a mesh that people measure and that bodies snap to.
struct MeshFeatures {
  explicit MeshFeatures(const MeshPtr& mesh) : measurable(mesh), snap(findSnapFeatures(measurable)) {}

  MeasurableMesh measurable;
  std::vector<SnapFeature> snap;
};
using MeshFeaturesPtr = std::shared_ptr<const MeshFeatures>;

/// The pointer selects vertices and edges within this distance.
inline constexpr double kFeaturePixels = 9.0;

/// Finds the features of each mesh of the open scenario once, in the background. It is used on the GUI thread.
class FeatureStore final : public QObject {
  Q_OBJECT

 public:
  explicit FeatureStore(const Workbench& bench);

  /// The features of a mesh; null until they are found.
  MeshFeaturesPtr find(const MeshPtr& mesh) const;
  /// Finds the features of one mesh and calls `then`, unless another request or cancel() comes before.
  void prepare(const MeshPtr& mesh, const std::function<void()>& then);
  void cancel() { request_.cancel(); }
  /// Finds the features of all bodies, one mesh after the other.
  void prepareAll();

 private:
  std::vector<MeshPtr> unknownMeshes() const;

  const Workbench& bench_;
  std::map<MeshPtr, MeshFeaturesPtr> known_;
  bool all_ = false;  ///< the features of all bodies are requested
  BackgroundTask request_;
  BackgroundTask round_;
};

}  // namespace glissade
