#include "widgets/openxr/picture_rate.h"

#include <algorithm>
#include <array>
#include <utility>

namespace glissade {
namespace {

constexpr std::array<EyeDetail, PictureRate::kSteps> kDetails{
    {{1.0, 2.0}, {2.0, 2.0}, {4.0, 2.0}, {8.0, 4.0}, {8.0, 12.0}}};
/// Tolerance for times of a runtime, which are not exact.
constexpr double kSlack = 1.05;
/// Intervals that are judged together. A single late picture, as after a stall, changes nothing.
constexpr int kLooked = 12;
constexpr int kMostLate = 3;
constexpr int kLongestPatience = 16 * PictureRate::kPatience;

bool isLate(PictureRate::Time interval, PictureRate::Time period) {
  using Seconds = std::chrono::duration<double>;
  return Seconds(interval).count() > kSlack * std::max(1.0 / PictureRate::kLeast, Seconds(period).count());
}

}  // namespace

EyeDetail PictureRate::detail() const { return kDetails[static_cast<std::size_t>(step_)]; }

void PictureRate::interrupt() {
  last_ = Time{-1};
  seen_ = late_ = punctual_ = 0;
}

void PictureRate::advance(Time shown, Time period) {
  const Time before = std::exchange(last_, shown);
  if (before < Time::zero()) return;
  const bool late = isLate(shown - before, period);
  ++seen_;
  late_ += late ? 1 : 0;
  punctual_ = late ? 0 : punctual_ + 1;
  if (late_ > kMostLate && step_ + 1 < kSteps) {
    if (isTrial_) patience_ = std::min(kLongestPatience, 2 * patience_);
    change(1);
  } else if (punctual_ >= patience_ && step_ > 0) {
    change(-1);
  } else if (seen_ == kLooked) {
    isTrial_ = isTrial_ && late_ > 0;
    seen_ = late_ = 0;
  }
}

void PictureRate::change(int by) {
  step_ += by;
  isTrial_ = by < 0;
  seen_ = late_ = punctual_ = 0;
}

}  // namespace glissade
