#include "widgets/controls/way_slider.h"

#include <QSignalBlocker>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kWayPlaces = 2000;
/// Bounds of the time of the whole path at speed 1, and seconds for each radius of the object.
constexpr double kLeastSeconds = 3.0;
constexpr double kMostSeconds = 12.0;
constexpr double kSecondsPerRadius = 0.5;

}  // namespace

WaySlider::WaySlider(QWidget* parent) : PlaySlider(kWayPlaces, kMostSeconds, parent) {
  connect(this, &PlaySlider::shareShown, this, &WaySlider::showPose);
}

void WaySlider::setWay(std::vector<Pose> way, const Se3Metric& metric) {
  setPlaying(false);
  way_ = std::move(way);
  arrival_.clear();
  for (std::size_t i = 0; i < way_.size(); ++i) {
    arrival_.push_back(i == 0 ? 0.0 : arrival_.back() + metric.distance(way_[i - 1], way_[i]));
  }
  setSeconds(std::clamp(kSecondsPerRadius * length() / metric.radius(), kLeastSeconds, kMostSeconds));
  setEnabled(way_.size() > 1);
  const QSignalBlocker block(this);
  setValue(0);
}

double WaySlider::shareAt(std::size_t configuration, double at) const {
  if (configuration + 1 >= arrival_.size() || length() <= 0.0) return 0.0;
  const double from = arrival_[configuration];
  return (from + at * (arrival_[configuration + 1] - from)) / length();
}

std::optional<Pose> WaySlider::poseAt(double share) const {
  if (way_.size() < 2) return std::nullopt;
  const double s = arrival_.back() * share;
  const auto after = std::upper_bound(arrival_.begin() + 1, arrival_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - arrival_.begin());
  const double length = arrival_[i] - arrival_[i - 1];
  return interpolate(way_[i - 1], way_[i], length > 0.0 ? (s - arrival_[i - 1]) / length : 1.0);
}

void WaySlider::showPose(double share) {
  if (const auto pose = poseAt(share)) emit poseShown(*pose, share);
}

}  // namespace glissade
