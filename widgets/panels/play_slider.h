#pragma once

#include <QElapsedTimer>
#include <QSlider>
#include <QTimer>

namespace glissade {

/// How a slider plays.
struct Playback {
  double speed = 1.0;  ///< 1: the whole passes in the slider's seconds
  bool loop = false;   ///< begins again at the end
  bool backwards = false;
};

/// A share of something that can be played, in [0, 1]. Playing follows the clock: a slow machine shows fewer pictures
/// of the same motion.
class PlaySlider : public QSlider {
  Q_OBJECT

 public:
  /// So many places, and seconds in which all of them pass at speed 1.
  PlaySlider(int places, double seconds, QWidget* parent);

  void setPlaying(bool playing);
  void setPlayback(const Playback& playback) { playback_ = playback; }
  void setSeconds(double seconds) { seconds_ = seconds; }
  /// In which playing passes all of it.
  double playedSeconds() const { return seconds_ / playback_.speed; }
  /// What playing shows when a share of that time has passed.
  double playedShare(double share) const { return playback_.backwards ? 1.0 - share : share; }
  double share() const { return static_cast<double>(value()) / maximum(); }
  /// Says shareShown(), also where it is there already.
  void showAt(double share);

 signals:
  void shareShown(double share);
  void playbackEnded();

 private:
  void tick();

  QTimer timer_;
  QElapsedTimer clock_;
  Playback playback_;
  double seconds_;
  double played_ = 0.0;  ///< the place that playing has reached, in [0, 1]
};

}  // namespace glissade
