#pragma once

#include <QElapsedTimer>
#include <QSlider>
#include <QTimer>

namespace glissade {

/// The settings of playing.
struct Playback {
  double speed = 1.0;  ///< 1: the whole is played in the slider's seconds
  bool loop = false;   ///< begins again at the end
  bool backwards = false;
};

/// A share of something that can be played, in [0, 1]. Playing follows the clock: a slow machine shows fewer pictures
/// of the same motion.
class PlaySlider : public QSlider {
  Q_OBJECT

 public:
  /// A slider with this many places, which are played in `seconds` at speed 1.
  PlaySlider(int places, double seconds, QWidget* parent);

  void setPlaying(bool playing);
  void setPlayback(const Playback& playback) { playback_ = playback; }
  void setSeconds(double seconds) { seconds_ = seconds; }
  /// Seconds in which the whole is played.
  double playedSeconds() const { return seconds_ / playback_.speed; }
  /// The share that playing shows when a share of playedSeconds() has passed.
  double playedShare(double share) const { return playback_.backwards ? 1.0 - share : share; }
  double share() const { return static_cast<double>(value()) / maximum(); }
  /// Emits shareShown(), also if this share is shown already.
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
  double played_ = 0.0;  ///< the share that playing has reached
};

}  // namespace glissade
