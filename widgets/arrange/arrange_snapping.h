#pragma once

#include <memory>

#include "engine/fits/feature_snap.h"
#include "widgets/workbench/arranged_item.h"
#include "widgets/workbench/feature_store.h"

namespace glissade {

/// Lets the dragged item snap to planes and axes of the other bodies that are drawn. Bodies whose features are not
/// found yet are left out.
class ArrangeSnapping {
 public:
  ArrangeSnapping(const WorkbenchDocument& document, const SceneView& view, FeatureStore& features)
      : document_(document), view_(view), features_(features) {}

  void setOn(bool on) { on_ = on; }
  bool isOn() const { return on_; }
  /// Finds the features of the scenario in the background.
  void prepare() { features_.prepareAll(); }

  /// Begins a drag. The item is where the scenario has it.
  void begin(const AssemblyItem& item);
  void end() { snapper_.reset(); }
  /// Snaps as FeatureSnapper::snap(); returns the shift itself if there is nothing to snap to.
  FeatureSnap snap(const Vector3& shift, const std::vector<Vector3>& freedom, double reach) const;
  /// The features that meet, drawn at the shifted item.
  MeasurePicture pictureOf(const FeatureSnap& snap) const;
  /// The features that meet, as text for people.
  QString textOf(const FeatureSnap& snap) const;

 private:
  /// The body of a feature.
  struct Owner {
    QString name;
    MeshFeaturesPtr features;
    Pose X_WB;
  };
  /// The features of bodies with their owners, in the world.
  struct Side {
    std::vector<SnapFeature> features;
    std::vector<Owner> owners;  ///< per feature
    void add(const QString& name, const MeshFeaturesPtr& found, const Pose& X_WB);
  };

  const WorkbenchDocument& document_;
  const SceneView& view_;
  FeatureStore& features_;
  bool on_ = true;
  Side moving_;
  Side fixed_;
  std::unique_ptr<const FeatureSnapper> snapper_;
};

}  // namespace glissade
