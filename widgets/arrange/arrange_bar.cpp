#include "widgets/arrange/arrange_bar.h"

#include <QEvent>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <numbers>

#include "widgets/controls/flow_layout.h"
#include "widgets/controls/length_text.h"

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
    : QFrame(scene), grid_(new QGridLayout(this)), item_(new QLabel(this)), keys_(new QLabel(this)) {
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
  controls_ = makeControls(actions);
  grid_->setContentsMargins(10, 6, 8, 6);
  grid_->setSpacing(4);
  grid_->setColumnStretch(0, 1);
  grid_->addWidget(item_, 0, 0);
  grid_->addWidget(makeEndButton(), 0, 2);
  grid_->addWidget(keys_, 2, 0, 1, 3);
  scene->installEventFilter(this);
  showItem(QString());
  hide();
}

QWidget* ArrangeBar::makeControls(const ActionCatalogue& actions) {
  auto* controls = new QWidget(this);
  auto* flow = new FlowLayout;
  controls->setLayout(flow);
  QAction* features = actions[QLatin1String("assembly.snap-features")];
  features->setIconText(tr("To faces"));  // the menu shows the whole text
  flow->addWidget(actionButton(features, controls));
  flow->addWidget(actionButton(actions[QLatin1String("assembly.snap")], controls));
  flow->addWidget(distance_);
  flow->addWidget(angle_);
  flow->addWidget(actionButton(actions[QLatin1String("assembly.align")], controls));
  flow->addWidget(actionButton(actions[QLatin1String("assembly.flip")], controls));
  return controls;
}

QToolButton* ArrangeBar::makeEndButton() {
  auto* done = new QToolButton(this);
  done->setText(QStringLiteral("✕"));
  done->setAutoRaise(true);
  done->setFocusPolicy(Qt::TabFocus);
  done->setToolTip(tr("End arranging (Esc)"));
  done->setAccessibleName(tr("End arranging"));
  connect(done, &QToolButton::clicked, this, &ArrangeBar::left);
  return done;
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
    keys_->setText(QStringLiteral("⚠ ") + tr("“%1” is not a step. Write 10, 25.4 mm, 1 in or 30 deg.").arg(text));
  });
  return box;
}

/// Changes the unit of the field; the distance in metres stays.
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

/// Places the bar in the middle of the lower border. The buttons stand below the item's name if there is no room beside
/// it, in as many rows as they need.
void ArrangeBar::fit() {
  const QSize scene = parentWidget()->size();
  const int width = std::min(kWidestBar, scene.width() - 2 * kArrangeMargin);
  const QMargins margins = layout()->contentsMargins();
  const int inner = width - margins.left() - margins.right();
  const int high = controls_->findChild<QToolButton*>()->sizeHint().height();
  for (QuantityBox* box : {distance_, angle_}) box->setFixedHeight(high);
  const QSize row = controls_->layout()->sizeHint();
  const int end = grid_->itemAtPosition(0, 2)->sizeHint().width();
  const bool beside = item_->sizeHint().width() + row.width() + end + 2 * grid_->spacing() <= inner;
  grid_->removeWidget(controls_);
  if (beside) {
    grid_->addWidget(controls_, 0, 1);
  } else {
    grid_->addWidget(controls_, 1, 0, 1, 3);
  }
  const int room = beside ? row.width() : inner;
  controls_->layout()->setGeometry(QRect(0, 0, room, 0));  // computes the height of the rows
  controls_->setFixedSize(room, controls_->layout()->minimumSize().height());
  setFixedWidth(width);
  // The keys keep their height, so that a shorter text in their place moves no button.
  if (snap_.isEmpty()) keys_->setMinimumHeight(keys_->heightForWidth(inner));
  layout()->activate();
  const int height = layout()->totalHeightForWidth(width);
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
