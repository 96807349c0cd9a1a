#pragma once

#include <QElapsedTimer>
#include <QSlider>
#include <QTimer>
#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// How a way is played.
struct Playback {
  double speed = 1.0;  ///< 1: the whole way passes in twelve seconds
  bool loop = false;   ///< begins again at the end
  bool backwards = false;
};

/// A place on a way, as a slider that can play. Playing follows the clock: a slow machine shows fewer pictures of the
/// same motion.
class WaySlider final : public QSlider {
  Q_OBJECT

 public:
  explicit WaySlider(QWidget* parent);

  /// Its first configuration; empty: there is none. Says nothing.
  void setWay(std::vector<Pose> way, const Se3Metric& metric);
  void setPlaying(bool playing);
  void setPlayback(const Playback& playback) { playback_ = playback; }
  /// In the metric, metres.
  double length() const { return arrival_.empty() ? 0.0 : arrival_.back(); }
  /// The share of the whole way that lies before a place on the way from one configuration to the next.
  double shareAt(std::size_t configuration, double at) const;
  void showAt(double share);

 signals:
  /// `share` of the way's metric length lies before the pose.
  void poseShown(const glissade::Pose& pose, double share);
  void playbackEnded();

 private:
  void showPosition(int position);
  void tick();

  std::vector<Pose> way_;
  std::vector<double> arrival_;  ///< metric length from the start to each configuration
  QTimer timer_;
  QElapsedTimer clock_;
  Playback playback_;
  double played_ = 0.0;  ///< the place that playing has reached, in [0, 1]
};

}  // namespace glissade
