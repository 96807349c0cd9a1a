#pragma once

#include <QSlider>
#include <QTimer>
#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// A place on a way, as a slider that can play: the whole way passes in a fixed time.
class WaySlider final : public QSlider {
  Q_OBJECT

 public:
  explicit WaySlider(QWidget* parent);

  /// Its first configuration; empty: there is none. Says nothing.
  void setWay(std::vector<Pose> way, const Se3Metric& metric);
  void setPlaying(bool playing);
  /// In the metric, metres.
  double length() const { return arrival_.empty() ? 0.0 : arrival_.back(); }
  /// The share of the whole way that lies before a place on the way from one configuration to the next.
  double shareAt(std::size_t configuration, double at) const;
  void showAt(double share);

 signals:
  void poseShown(const glissade::Pose& pose);
  void playbackEnded();

 private:
  void showPosition(int position);
  void tick();

  std::vector<Pose> way_;
  std::vector<double> arrival_;  ///< metric length from the start to each configuration
  QTimer timer_;
};

}  // namespace glissade
