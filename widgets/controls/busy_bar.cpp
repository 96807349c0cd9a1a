#include "widgets/controls/busy_bar.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace glissade {
namespace {

constexpr int kPatienceMilliseconds = 250;
constexpr int kTickMilliseconds = 1000;
constexpr int kProgressSteps = 1000;
constexpr int kWidth = 140;

}  // namespace

BusyBar::BusyBar(QAction* cancel, QWidget* parent)
    : QWidget(parent), what_(new QLabel(this)), progress_(new QProgressBar(this)), seconds_(new QLabel(this)) {
  setObjectName(QStringLiteral("busy"));
  progress_->setRange(0, kProgressSteps);
  progress_->setFixedWidth(kWidth);
  // The bar is no higher than the text beside it, so that the status bar does not grow.
  const int height = fontMetrics().height() + 4;
  progress_->setMaximumHeight(height);
  auto* button = new QToolButton(this);
  button->setDefaultAction(cancel);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setMaximumHeight(height);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(what_);
  layout->addWidget(progress_);
  layout->addWidget(seconds_);
  layout->addWidget(button);
  patience_.setSingleShot(true);
  patience_.setInterval(kPatienceMilliseconds);
  connect(&patience_, &QTimer::timeout, this, &QWidget::show);
  tick_.setInterval(kTickMilliseconds);
  connect(&tick_, &QTimer::timeout, this, &BusyBar::showElapsed);
  hide();
}

void BusyBar::begin(const QString& what, const QElapsedTimer& since) {
  what_->setText(what);
  progress_->setAccessibleName(what);
  progress_->setValue(0);
  clock_ = since;
  tick_.start();
  showElapsed();
  patience_.start();
}

void BusyBar::setShare(double share) { progress_->setValue(static_cast<int>(kProgressSteps * share)); }

void BusyBar::showElapsed() { seconds_->setText(tr("%1 s").arg(clock_.elapsed() / kTickMilliseconds)); }

void BusyBar::end() {
  tick_.stop();
  patience_.stop();
  hide();
}

}  // namespace glissade
