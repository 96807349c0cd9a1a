#include "widgets/controls/play_slider.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr int kFrameMilliseconds = 16;

}  // namespace

PlaySlider::PlaySlider(int places, double seconds, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), seconds_(seconds) {
  setRange(0, places);
  setEnabled(false);
  timer_.setInterval(kFrameMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &PlaySlider::tick);
  connect(this, &QSlider::valueChanged, this, [this] { emit shareShown(share()); });
}

void PlaySlider::setPlaying(bool playing) {
  if (playing && isEnabled()) {
    const int end = playback_.backwards ? 0 : maximum();
    if (value() == end) setValue(maximum() - end);
    played_ = share();
    clock_.start();
    timer_.start();
  } else if (timer_.isActive()) {
    timer_.stop();
    emit playbackEnded();
  }
}

void PlaySlider::tick() {
  const double passed = static_cast<double>(clock_.restart()) / 1000.0 * playback_.speed / seconds_;
  if (std::lround(played_ * maximum()) != value()) played_ = share();  // the slider was dragged
  played_ += playback_.backwards ? -passed : passed;
  const bool atEnd = played_ < 0.0 || played_ > 1.0;
  played_ = playback_.loop ? played_ - std::floor(played_) : std::clamp(played_, 0.0, 1.0);
  setValue(static_cast<int>(std::lround(played_ * maximum())));
  if (atEnd && !playback_.loop) setPlaying(false);
}

void PlaySlider::showAt(double share) {
  setPlaying(false);
  const int place = static_cast<int>(std::lround(share * maximum()));
  if (place == value()) emit shareShown(this->share());  // the slider emits no signal for an equal value
  setValue(place);
}

}  // namespace glissade
