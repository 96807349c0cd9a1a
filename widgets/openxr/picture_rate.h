#pragma once

#include <chrono>

namespace glissade {

/// Accuracy of the drawing for the eyes.
struct EyeDetail {
  double tolerance = 1.0;  ///< largest error in pixels of the coarser arrays of large meshes
  double leastBody = 2.0;  ///< pixels; smaller bodies are not drawn
};

/// Makes the scene simpler while there are fewer than 72 pictures a second, and finer again when there is time. It uses
/// the times for which the runtime wants pictures, and has no clock of its own. Far and small bodies become simpler
/// first, because their errors are the fewest pixels.
class PictureRate {
 public:
  using Time = std::chrono::nanoseconds;  ///< time of the runtime

  static constexpr double kLeast = 72.0;  ///< pictures a second
  static constexpr int kSteps = 5;        ///< number of steps of detail
  /// Pictures in time before a finer step is tried: two seconds at 90 Hz. After a trial that failed, the number is
  /// doubled, so that the scene does not alternate.
  static constexpr int kPatience = 180;

  /// A picture is wanted for the time `shown`, which is later than the one before. `period`: of the display, which may
  /// have fewer than 72 pictures a second.
  void advance(Time shown, Time period);
  /// Nothing was shown for a while: the measurements are forgotten, and the detail stays.
  void interrupt();
  /// The step of detail; 0 is the finest.
  int step() const { return step_; }
  EyeDetail detail() const;

 private:
  void change(int by);

  Time last_{-1};  ///< time of the last picture; negative: none
  int step_ = 0;
  int seen_ = 0;              ///< intervals that are judged together
  int late_ = 0;              ///< late intervals among those
  int punctual_ = 0;          ///< successive intervals in time
  int patience_ = kPatience;  ///< intervals in time before a finer step is tried
  bool isTrial_ = false;      ///< the step has become finer, and it is not known yet whether pictures are in time
};

}  // namespace glissade
