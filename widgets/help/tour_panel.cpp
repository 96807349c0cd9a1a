#include "widgets/help/tour_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kTourMargin = 12;
constexpr int kWidestTour = 380;
constexpr int kFrameWidth = 3;
constexpr double kTourTitleScale = 1.15;

}  // namespace

TourPanel::TourPanel(QWidget* scene)
    : QFrame(scene),
      where_(new QLabel(this)),
      title_(new QLabel(this)),
      text_(new QLabel(this)),
      doIt_(addButton(tr("Do it for me"), &TourPanel::stepRequested)),
      back_(addButton(tr("Back"), &TourPanel::back)),
      next_(addButton(tr("Next"), &TourPanel::next)),
      end_(addButton(tr("End"), &TourPanel::end)) {
  setObjectName(QStringLiteral("tour"));
  setAutoFillBackground(true);
  // A click beside the buttons does not reach the scene.
  setAttribute(Qt::WA_NoMousePropagation);
  QFont font = title_->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * kTourTitleScale);
  title_->setFont(font);
  where_->setForegroundRole(QPalette::PlaceholderText);
  for (QLabel* label : {title_, text_}) label->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  end_->setToolTip(tr("End the tour (Esc)"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(6);
  for (QToolButton* button : {doIt_, back_, next_, end_}) buttons->addWidget(button);
  buttons->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 10);
  column->setSpacing(6);
  for (QLabel* label : {where_, title_, text_}) column->addWidget(label);
  column->addLayout(buttons);
  scene->installEventFilter(this);
  hide();
}

QToolButton* TourPanel::addButton(const QString& text, void (TourPanel::*clicked)()) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, clicked);
  return button;
}

void TourPanel::showStep(int number, int count, const QString& title, const QString& text) {
  where_->setText(tr("Tour: step %1 of %2").arg(number).arg(count));
  title_->setText(title);
  text_->setText(text);
  setAccessibleName(where_->text() + QStringLiteral(". ") + title);
  setAccessibleDescription(text);
  back_->setEnabled(number > 1);
  next_->setText(number < count ? tr("Next") : tr("Finish"));
  show();
  place();
}

void TourPanel::setDone(bool done) {
  doIt_->setEnabled(!done);
  doIt_->setText(done ? tr("✓ Done") : tr("Do it for me"));
}

/// Places the panel in the lower right corner of the scene, as high as its text. The axes and the first sample are at
/// the left.
void TourPanel::place() {
  const QWidget& scene = *parentWidget();
  const int width = std::min(kWidestTour, scene.width() - 2 * kTourMargin);
  const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
  setGeometry(scene.width() - kTourMargin - width, std::max(0, scene.height() - kTourMargin - height), width, height);
  raise();
}

bool TourPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

TourFrame::TourFrame(QWidget* window) : QWidget(window) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void TourFrame::mark(const QRect& part) {
  setVisible(!part.isEmpty());
  setGeometry(part.adjusted(-kFrameWidth, -kFrameWidth, kFrameWidth, kFrameWidth));
  raise();
}

void TourFrame::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Highlight), kFrameWidth));
  const double inset = kFrameWidth / 2.0;
  painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), 4.0, 4.0);
}

}  // namespace glissade
