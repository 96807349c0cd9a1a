#include "widgets/panels/way_slider.h"

#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr int kPositions = 2000;
constexpr int kTickMilliseconds = 16;
/// The whole way plays in this time.
constexpr double kPlaySeconds = 12.0;

}  // namespace

WaySlider::WaySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, kPositions);
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
    if (value() == kPositions) setValue(0);
    timer_.start();
  } else if (timer_.isActive()) {
    timer_.stop();
    emit playbackEnded();
  }
}

void WaySlider::tick() {
  const int step = std::max(1, static_cast<int>(kPositions * kTickMilliseconds / (1000.0 * kPlaySeconds)));
  setValue(value() + step);
  if (value() == kPositions) setPlaying(false);
}

double WaySlider::shareAt(std::size_t configuration, double at) const {
  if (configuration + 1 >= arrival_.size() || length() <= 0.0) return 0.0;
  const double from = arrival_[configuration];
  return (from + at * (arrival_[configuration + 1] - from)) / length();
}

void WaySlider::showAt(double share) {
  setPlaying(false);
  const int position = static_cast<int>(std::lround(share * kPositions));
  if (position == value()) showPosition(position);  // the slider would say nothing
  setValue(position);
}

void WaySlider::showPosition(int position) {
  if (way_.size() < 2) return;
  const double s = arrival_.back() * position / kPositions;
  const auto after = std::upper_bound(arrival_.begin() + 1, arrival_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - arrival_.begin());
  const double length = arrival_[i] - arrival_[i - 1];
  emit poseShown(interpolate(way_[i - 1], way_[i], length > 0.0 ? (s - arrival_[i - 1]) / length : 1.0));
}

}  // namespace glissade
