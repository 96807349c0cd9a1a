#include "widgets/panels/arrange_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <numbers>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

constexpr int kArrangeMargin = 10;
constexpr int kWidestBar = 700;
constexpr int kFieldBorder = 14;
constexpr double kUsualStep = 1e-3;  // metres
constexpr double kUsualDegrees = 15.0;
constexpr double kLeastStep = 1e-5;  // metres: the last digit that is shown
constexpr double kMostMetres = 1e3;
constexpr double kLeastDegrees = 1e-2;
constexpr double kMostDegrees = 180.0;
constexpr double kRadian = 180.0 / std::numbers::pi;  // degrees

QToolButton* actionButton(QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

ArrangeBar::ArrangeBar(const ActionCatalogue& actions, QWidget* scene)
    : QFrame(scene), top_(new QBoxLayout(QBoxLayout::LeftToRight)), item_(new QLabel(this)), keys_(new QLabel(this)) {
  setObjectName(QStringLiteral("arrange-bar"));
  setAccessibleName(tr("Arranging"));
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  item_->setTextFormat(Qt::PlainText);
  item_->setObjectName(QStringLiteral("arranged-item"));
  QFont bold = item_->font();
  bold.setBold(true);
  item_->setFont(bold);
  item_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  distance_ = addStep(QuantityBox::Quantity::Length, tr("Step of distances"));
  showUnit();
  angle_ = addStep(QuantityBox::Quantity::Angle, tr("Step of angles"));
  angle_->setRange(kLeastDegrees, kMostDegrees);
  angle_->setSuffix(QStringLiteral("°"));
  angle_->setFixedWidth(angle_->fontMetrics().horizontalAdvance(QStringLiteral("000.00°")) + kFieldBorder);
  setSteps(kUsualStep, kUsualDegrees / kRadian);
  keys_->setTextFormat(Qt::PlainText);
  keys_->setWordWrap(true);
  keys_->setAlignment(Qt::AlignTop);
  showKeys();
  top_->setSpacing(4);
  top_->addWidget(item_, 1);
  top_->addLayout(makeControls(actions));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 6, 8, 6);
  column->setSpacing(4);
  column->addLayout(top_);
  column->addWidget(keys_);
  scene->installEventFilter(this);
  showItem(QString());
  hide();
}

QLayout* ArrangeBar::makeControls(const ActionCatalogue& actions) {
  auto* controls = new QHBoxLayout;
  controls->setSpacing(6);
  QAction* features = actions[QLatin1String("assembly.snap-features")];
  features->setIconText(tr("To faces"));  // the menu shows the whole text
  controls->addWidget(actionButton(features, this));
  controls->addWidget(actionButton(actions[QLatin1String("assembly.snap")], this));
  controls->addWidget(distance_);
  controls->addWidget(angle_);
  controls->addWidget(actionButton(actions[QLatin1String("assembly.align")], this));
  controls->addWidget(actionButton(actions[QLatin1String("assembly.flip")], this));
  controls->addStretch();
  auto* done = new QToolButton(this);
  done->setText(QStringLiteral("✕"));
  done->setAutoRaise(true);
  done->setFocusPolicy(Qt::TabFocus);
  done->setToolTip(tr("End arranging (Esc)"));
  done->setAccessibleName(tr("End arranging"));
  connect(done, &QToolButton::clicked, this, &ArrangeBar::left);
  controls->addWidget(done);
  return controls;
}

QuantityBox* ArrangeBar::addStep(QuantityBox::Quantity quantity, const QString& name) {
  auto* box = new QuantityBox(quantity, this);
  box->setAccessibleName(name);
  box->setToolTip(tr("%1, in any unit: 25.4 mm, 1 in, 30 deg").arg(name));
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
    showKeys();
    emit stepsChanged();
  });
  connect(box, &QuantityBox::refused, this, [this](const QString& text) {
    keys_->setText(QStringLiteral("⚠ ") + tr("“%1” is no step. Write 10, 25.4 mm, 1 in or 30 deg.").arg(text));
  });
  return box;
}

/// The number stays in metres, whatever unit it is shown in.
void ArrangeBar::showUnit() {
  const LengthField field = lengthField(kLeastStep);
  const double metres = distance_->value() / perMetre_;
  const QSignalBlocker block(distance_);
  perMetre_ = field.perMetre;
  distance_->setUnit(1.0 / field.perMetre, field.decimals);
  distance_->setRange(kLeastStep * perMetre_, kMostMetres * perMetre_);
  distance_->setSuffix(QLatin1Char(' ') + field.unit);
  const QString widest = distance_->locale().toString(0.0, 'f', field.decimals) + distance_->suffix();
  distance_->setFixedWidth(distance_->fontMetrics().horizontalAdvance(QStringLiteral("000") + widest) + kFieldBorder);
  setDistance(metres);
}

void ArrangeBar::setDistance(double metres) { distance_->setValue(metres * perMetre_); }

void ArrangeBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() != QEvent::LocaleChange) return;
  showUnit();
  if (isVisible()) fit();
}

void ArrangeBar::showKeys() {
  keys_->setText(
      tr("Drag an arrow, a square or a ring; Ctrl suspends snapping. Drag the body itself, with Ctrl to turn it. "
         "Arrow keys and Page Up/Down move by a step, with Shift they turn. Esc ends arranging."));
}

void ArrangeBar::showSnap(const QString& what) {
  if (what == snap_) return;
  snap_ = what;
  if (what.isEmpty()) {
    showKeys();
  } else {
    keys_->setText(tr("Snapped: %1. Ctrl suspends snapping.").arg(what));
  }
}

void ArrangeBar::showItem(const QString& name) {
  item_->setText(name.isEmpty() ? tr("Arranging: click a body, the start or the goal") : tr("Arranging %1").arg(name));
  item_->setToolTip(item_->text());
  if (isVisible()) fit();
}

void ArrangeBar::setSteps(double metres, double radians) {
  setDistance(metres);
  angle_->setValue(radians * kRadian);
}

double ArrangeBar::distanceStep() const { return distance_->value() / perMetre_; }

double ArrangeBar::angleStep() const { return angle_->value() / kRadian; }

/// In the middle of the lower border. What is arranged stands above the buttons where it has no room beside them.
void ArrangeBar::fit() {
  const QSize scene = parentWidget()->size();
  const int width = std::min(kWidestBar, scene.width() - 2 * kArrangeMargin);
  const QMargins margins = layout()->contentsMargins();
  const int needed = item_->sizeHint().width() + top_->itemAt(1)->sizeHint().width() + 2 * top_->spacing();
  const bool beside = needed <= width - margins.left() - margins.right();
  top_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  setFixedWidth(width);
  // A shorter text in the place of the keys moves no button.
  if (snap_.isEmpty()) keys_->setMinimumHeight(keys_->heightForWidth(width - margins.left() - margins.right()));
  layout()->activate();
  const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
  setGeometry((scene.width() - width) / 2, scene.height() - height - kArrangeMargin, width, height);
  emit covered(height + kArrangeMargin);
}

void ArrangeBar::showEvent(QShowEvent* event) {
  fit();
  raise();
  QFrame::showEvent(event);
}

void ArrangeBar::hideEvent(QHideEvent* event) {
  emit covered(0);
  QFrame::hideEvent(event);
}

bool ArrangeBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) fit();
  return QFrame::eventFilter(watched, event);
}

void ArrangeBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) {
    QFrame::keyPressEvent(event);
    return;
  }
  emit left();
}

}  // namespace glissade
