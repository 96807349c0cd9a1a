#pragma once

#include <chrono>

namespace glissade {

/// How exactly the eyes see the scene.
struct EyeDetail {
  double tolerance = 1.0;  ///< pixels that what is drawn may be off: of the coarser arrays of large meshes
  double leastBody = 2.0;  ///< pixels: smaller bodies are not drawn
};

/// Makes the scene simpler while there are fewer than 72 pictures a second, and finer again when there is time. It goes
/// by the times for which the runtime wants pictures, and has no clock of its own. What is far or small becomes simpler
/// first, because its error is the fewest pixels.
class PictureRate {
 public:
  using Time = std::chrono::nanoseconds;  ///< of the runtime

  static constexpr double kLeast = 72.0;  ///< pictures a second
  static constexpr int kSteps = 5;        ///< of detail
  /// Pictures in time before a finer step is tried: two seconds at 90 Hz. Where it was too much, twice as many the next
  /// time, so that the scene does not change to and fro.
  static constexpr int kPatience = 180;

  /// A picture is wanted for this time, which is later than the one before. `period`: of the display, which may have
  /// fewer pictures than these.
  void advance(Time shown, Time period);
  /// Nothing was shown for a while: what was measured does not count. The detail stays.
  void interrupt();
  /// 0 is the finest.
  int step() const { return step_; }
  EyeDetail detail() const;

 private:
  void change(int by);

  Time last_{-1};  ///< negative: none
  int step_ = 0;
  int seen_ = 0;              ///< intervals that are looked at together
  int late_ = 0;              ///< of them
  int punctual_ = 0;          ///< one after the other
  int patience_ = kPatience;  ///< so many of these before a finer step is tried
  bool isTrial_ = false;      ///< the step has become finer, and it is not known yet whether there is time for it
};

}  // namespace glissade
