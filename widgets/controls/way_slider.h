#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/se3_metric.h"
#include "widgets/controls/play_slider.h"

namespace glissade {

/// A place on a path, as a slider that can play: the whole path is played in three to twelve seconds, and in twelve if
/// it is twenty-four radii of the object or longer.
class WaySlider final : public PlaySlider {
  Q_OBJECT

 public:
  explicit WaySlider(QWidget* parent);

  /// Sets the path and shows its first configuration; empty: there is none. Emits no signal.
  void setWay(std::vector<Pose> way, const Se3Metric& metric);
  /// Length in the metric, metres.
  double length() const { return arrival_.empty() ? 0.0 : arrival_.back(); }
  /// The share of the path before a place between a configuration and the next; `at` is in [0, 1].
  double shareAt(std::size_t configuration, double at) const;
  /// The pose of the object at this share of the metric length; nothing if there is no path.
  std::optional<Pose> poseAt(double share) const;

 signals:
  /// `share` of the path's metric length lies before the pose.
  void poseShown(const glissade::Pose& pose, double share);

 private:
  void showPose(double share);

  std::vector<Pose> way_;
  std::vector<double> arrival_;  ///< metric length from the start to each configuration
};

}  // namespace glissade
