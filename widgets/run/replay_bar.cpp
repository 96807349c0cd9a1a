#include "widgets/run/replay_bar.h"

#include <QLocale>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kReplaySteps = 100000;

}  // namespace

ReplayBar::ReplayBar(const ActionCatalogue& actions, QWidget* parent)
    : QToolBar(tr("Replay"), parent),
      speed_(new QComboBox(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      place_(new QLabel(this)),
      verdict_(new QLabel(this)) {
  setObjectName(QStringLiteral("replay"));
  setMovable(false);
  auto* mark = new QLabel(tr("REPLAY"), this);
  mark->setStyleSheet(
      QStringLiteral("QLabel { background: #b3500a; color: white; font-weight: bold; padding: 2px 6px; }"));
  mark->setToolTip(tr("What you see was recorded: nothing can be steered until the replay is closed"));
  addWidget(mark);
  for (const char* id : {"replay.to-start", "replay.step-back", "replay.play", "replay.step"}) {
    addAction(actions[QLatin1String(id)]);
  }
  speed_->addItem(QStringLiteral("1×"), 1.0);
  speed_->addItem(QStringLiteral("2×"), 2.0);
  speed_->addItem(QStringLiteral("8×"), 8.0);
  speed_->addItem(tr("max"), 0.0);
  speed_->setToolTip(tr("Times the pace of the recorded run"));
  speed_->setAccessibleName(tr("Speed of the replay"));
  addWidget(speed_);
  slider_->setRange(0, kReplaySteps);
  slider_->setMinimumWidth(120);
  slider_->setToolTip(tr("Step of the run"));
  slider_->setAccessibleName(tr("Step of the run"));
  addWidget(slider_);
  place_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("000,000 / 000,000   0000.0 s")));
  place_->setAlignment(Qt::AlignCenter);
  addWidget(place_);
  verdict_->setObjectName(QStringLiteral("verdict"));
  addWidget(verdict_);
  addAction(actions[QLatin1String("replay.again")]);
  addAction(actions[QLatin1String("replay.close")]);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    emit stepChosen(static_cast<quint64>(std::llround(static_cast<double>(steps_) * position / kReplaySteps)));
  });
}

void ReplayBar::setPlace(std::uint64_t step, std::uint64_t steps, double seconds) {
  steps_ = steps;
  const QSignalBlocker block(slider_);
  const double share = static_cast<double>(step) / static_cast<double>(std::max<std::uint64_t>(steps, 1));
  slider_->setValue(static_cast<int>(std::lround(kReplaySteps * share)));
  place_->setText(
      QStringLiteral("%1 / %2   %3 s").arg(countText(step), countText(steps), QLocale().toString(seconds, 'f', 1)));
}

void ReplayBar::setVerdict(const QString& verdict, const QString& tip, bool alarming) {
  verdict_->setText(verdict);
  verdict_->setToolTip(tip);
  verdict_->setForegroundRole(alarming ? QPalette::BrightText : QPalette::WindowText);
  QFont font = place_->font();
  font.setBold(alarming);
  verdict_->setFont(font);
}

double ReplayBar::speed() const { return speed_->currentData().toDouble(); }

}  // namespace glissade
