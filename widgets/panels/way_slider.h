#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/se3_metric.h"
#include "widgets/panels/play_slider.h"

namespace glissade {

/// A place on a way, as a slider that can play: the whole way passes in three to twelve
/// seconds, in twelve where it is twenty-four radii of the object or longer.
class WaySlider final : public PlaySlider {
  Q_OBJECT

 public:
  explicit WaySlider(QWidget* parent);

  /// Its first configuration; empty: there is none. Says nothing.
  void setWay(std::vector<Pose> way, const Se3Metric& metric);
  /// In the metric, metres.
  double length() const { return arrival_.empty() ? 0.0 : arrival_.back(); }
  /// The share of the whole way that lies before a place on the way from one configuration to the next.
  double shareAt(std::size_t configuration, double at) const;
  /// Where the object is once this share of the metric length is done; nothing where there is no way.
  std::optional<Pose> poseAt(double share) const;

 signals:
  /// `share` of the way's metric length lies before the pose.
  void poseShown(const glissade::Pose& pose, double share);

 private:
  void showPose(double share);

  std::vector<Pose> way_;
  std::vector<double> arrival_;  ///< metric length from the start to each configuration
};

}  // namespace glissade
