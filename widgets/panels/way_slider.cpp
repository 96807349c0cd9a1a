#include "widgets/panels/way_slider.h"

#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr int kWaySteps = 2000;
constexpr int kTickMilliseconds = 16;
/// At speed 1 the whole way passes in this time.
constexpr double kPlaySeconds = 12.0;

}  // namespace

WaySlider::WaySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, kWaySteps);
  setEnabled(false);
  timer_.setInterval(kTickMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &WaySlider::tick);
  connect(this, &QSlider::valueChanged, this, &WaySlider::showPosition);
}

void WaySlider::setWay(std::vector<Pose> way, const Se3Metric& metric) {
  setPlaying(false);
  way_ = std::move(way);
  arrival_.clear();
  for (std::size_t i = 0; i < way_.size(); ++i) {
    arrival_.push_back(i == 0 ? 0.0 : arrival_.back() + metric.distance(way_[i - 1], way_[i]));
  }
  setEnabled(way_.size() > 1);
  const QSignalBlocker block(this);
  setValue(0);
}

void WaySlider::setPlaying(bool playing) {
  if (playing && isEnabled()) {
    const int end = playback_.backwards ? 0 : kWaySteps;
    if (value() == end) setValue(kWaySteps - end);
    played_ = static_cast<double>(value()) / kWaySteps;
    clock_.start();
    timer_.start();
  } else if (timer_.isActive()) {
    timer_.stop();
    emit playbackEnded();
  }
}

void WaySlider::tick() {
  const double passed = static_cast<double>(clock_.restart()) / 1000.0 * playback_.speed / kPlaySeconds;
  if (std::lround(played_ * kWaySteps) != value()) played_ = static_cast<double>(value()) / kWaySteps;  // dragged
  played_ += playback_.backwards ? -passed : passed;
  const bool atEnd = played_ < 0.0 || played_ > 1.0;
  played_ = playback_.loop ? played_ - std::floor(played_) : std::clamp(played_, 0.0, 1.0);
  setValue(static_cast<int>(std::lround(played_ * kWaySteps)));
  if (atEnd && !playback_.loop) setPlaying(false);
}

double WaySlider::shareAt(std::size_t configuration, double at) const {
  if (configuration + 1 >= arrival_.size() || length() <= 0.0) return 0.0;
  const double from = arrival_[configuration];
  return (from + at * (arrival_[configuration + 1] - from)) / length();
}

void WaySlider::showAt(double share) {
  setPlaying(false);
  const int position = static_cast<int>(std::lround(share * kWaySteps));
  if (position == value()) showPosition(position);  // the slider would say nothing
  setValue(position);
}

void WaySlider::showPosition(int position) {
  if (way_.size() < 2) return;
  const double s = arrival_.back() * position / kWaySteps;
  const auto after = std::upper_bound(arrival_.begin() + 1, arrival_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - arrival_.begin());
  const double length = arrival_[i] - arrival_[i - 1];
  emit poseShown(interpolate(way_[i - 1], way_[i], length > 0.0 ? (s - arrival_[i - 1]) / length : 1.0),
                 static_cast<double>(position) / kWaySteps);
}

}  // namespace glissade
