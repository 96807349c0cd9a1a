#include "widgets/product/placement_panel.h"

#include <QAction>
#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QToolTip>

#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;
constexpr int kSides = 12;  // margins of the panel, pixels
enum About { kFile, kMiddle, kReference, kPicked };
/// Largest coordinate, metres; products are smaller.
constexpr double kFarthest = 1000.0;
/// Finest difference that the fields show, metres; parts are placed less finely.
constexpr double kFinestPlace = 1e-5;

}  // namespace

PlacementPanel::PlacementPanel(QWidget* parent) : QWidget(parent), name_(new QLabel(this)), refused_(new QLabel(this)) {
  name_->setTextFormat(Qt::PlainText);
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  refused_->setTextFormat(Qt::PlainText);
  refused_->setObjectName(QStringLiteral("place-refused"));
  refused_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  refused_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(kSides / 2, 2, kSides / 2, 6);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(3);
  grid->addWidget(name_, 0, 0, 1, 6);
  grid->addWidget(refused_, 0, 0, 1, 6);  // in place of the title, so that the fields do not move
  for (int axis = 0; axis < 3; ++axis) {
    const QString letter(QLatin1Char("XYZ"[axis]));
    position_[axis] = addBox(QuantityBox::Quantity::Length, axis,
                             tr("Along the world's axis %1; a number may have a unit: 25.4 mm, 1 in").arg(letter));
    position_[axis]->setObjectName(QStringLiteral("place-") + letter.toLower());
    connect(position_[axis], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, axis] { takePosition(axis); });
  }
  // Tab goes through the fields in the order in which they are made.
  for (int axis = 0; axis < 3; ++axis) {
    const QString letter(QLatin1Char("XYZ"[axis]));
    turn_[axis] = addBox(QuantityBox::Quantity::Angle, axis,
                         tr("Turned about the world's axis %1, in degrees, or with a unit: 0.1 rad; first X, then Y, "
                            "then Z")
                             .arg(letter));
    turn_[axis]->setObjectName(QStringLiteral("turn-") + letter.toLower());
    turn_[axis]->setRange(-360.0, 360.0);
    connect(turn_[axis], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, axis] { takeTurn(axis); });
  }
  showUnit();
  about_ = makePoints();
  grid->addWidget(about_, 3, 0, 1, 4);
  show(QString(), std::nullopt);
}

QComboBox* PlacementPanel::makePoints() {
  auto* about = new QComboBox(this);
  about->setObjectName(QStringLiteral("place-about"));
  about->setAccessibleName(tr("Point whose coordinates are shown"));
  about->setToolTip(tr("The point whose coordinates are shown; a CAD system gives those of the origin of its file"));
  about->addItem(tr("Origin of the file"), kFile);
  about->addItem(tr("Middle"), kMiddle);
  about->addItem(tr("Reference point"), kReference);
  about->setItemData(kReference, tr("The point whose poses are in path files"), Qt::ToolTipRole);
  connect(about, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    showNumbers();
    emit pointChosen();
  });
  return about;
}

void PlacementPanel::addPickAction(QAction* action) {
  action->setIconText(tr("Pick"));  // the menu shows the whole text
  auto* pick = new QToolButton(this);
  pick->setObjectName(QStringLiteral("place-pick"));
  pick->setDefaultAction(action);
  pick->setToolButtonStyle(Qt::ToolButtonTextOnly);
  static_cast<QGridLayout*>(layout())->addWidget(pick, 3, 4, 1, 2);
}

/// Offers the picked frame as the last choice, if there is one.
void PlacementPanel::offerPicked() {
  const QSignalBlocker block(about_);
  const int at = about_->findData(kPicked);
  if (!points_.picked) {
    const bool wasChosen = at >= 0 && about_->currentIndex() == at;
    if (at >= 0) about_->removeItem(at);
    if (wasChosen) about_->setCurrentIndex(about_->findData(kFile));
  } else if (at < 0) {
    about_->addItem(tr("Picked face or axis"), kPicked);
  }
}

/// X_BF of the frame that the numbers describe.
Pose PlacementPanel::frame() const {
  switch (about_->currentData().toInt()) {
    case kFile: return Pose::translation(points_.fileOrigin);
    case kMiddle: return Pose::translation(points_.middle);
    case kPicked: return points_.picked.value_or(Pose::identity());
    default: return Pose::identity();
  }
}

QuantityBox* PlacementPanel::addBox(QuantityBox::Quantity quantity, int axis, const QString& tip) {
  const bool isLength = quantity == QuantityBox::Quantity::Length;
  const int row = isLength ? 1 : 2;
  auto* grid = static_cast<QGridLayout*>(layout());
  auto* box = new QuantityBox(quantity, this);
  box->setToolTip(tip);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  const QString letter(QLatin1Char("XYZ"[axis]));
  auto* text = new QLabel(isLength ? letter : QStringLiteral("∠") + letter, this);
  text->setBuddy(box);
  grid->addWidget(text, row, 2 * axis);
  grid->addWidget(box, row, 2 * axis + 1);
  grid->setColumnStretch(2 * axis + 1, 1);
  connect(box, &QuantityBox::refused, this,
          [this, quantity](const QString& written) { showRefused(quantity, written); });
  return box;
}

void PlacementPanel::showRefused(QuantityBox::Quantity quantity, const QString& text) {
  const bool isLength = quantity == QuantityBox::Quantity::Length;
  const QString what =
      isLength ? tr("“%1” is not a length. Nothing has moved.") : tr("“%1” is not an angle. Nothing has moved.");
  const QString why =
      isLength ? tr("“%1” is not a length up to 1 km. Write 12.5, 25.4 mm, 1 in or 0.5\". Nothing has moved.")
               : tr("“%1” is not an angle up to 360°. Write 30, 30 deg or 0.1 rad. Nothing has moved.");
  const QString line = QStringLiteral("⚠ ") + what.arg(text);
  name_->hide();
  refused_->show();
  refused_->setText(refused_->fontMetrics().elidedText(line, Qt::ElideRight, contentsRect().width() - kSides));
  refused_->setToolTip(why.arg(text));
  refused_->setAccessibleName(why.arg(text));
  QToolTip::showText(refused_->mapToGlobal(QPoint(0, refused_->height())), why.arg(text), refused_);
}

void PlacementPanel::hideRefused() {
  refused_->hide();
  name_->show();
}

std::optional<Pose> PlacementPanel::chosenFrame() const {
  return about_->currentData().toInt() == kPicked ? points_.picked : std::nullopt;
}

void PlacementPanel::show(const QString& name, const std::optional<Pose>& X_WB, const PlacementPoints& points) {
  const bool isNew = points.picked && points.picked != points_.picked;
  points_ = points;
  X_WB_ = X_WB.value_or(Pose::identity());
  offerPicked();
  if (isNew) {
    const QSignalBlocker block(about_);
    about_->setCurrentIndex(about_->findData(kPicked));
  }
  isPlaced_ = X_WB.has_value();
  placedName_ = name;
  showTitle();
  about_->setEnabled(X_WB.has_value());
  for (int axis = 0; axis < 3; ++axis) {
    position_[axis]->setEnabled(X_WB.has_value());
    turn_[axis]->setEnabled(X_WB.has_value());
  }
  showNumbers();
}

void PlacementPanel::showTitle() {
  const QString unit = lengthField(kFinestPlace).unit;
  const QString title = !isPlaced_              ? tr("Placement: select one body, start or goal")
                        : placedName_.isEmpty() ? tr("Placement, %1 and °").arg(unit)
                                                : tr("Placement of %1, %2 and °").arg(placedName_, unit);
  name_->setText(name_->fontMetrics().elidedText(title, Qt::ElideMiddle, width() - kSides));
  name_->setToolTip(name_->text() == title ? QString() : title);
}

void PlacementPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showTitle();
}

void PlacementPanel::showUnit() {
  const LengthField field = lengthField(kFinestPlace);
  perMetre_ = field.perMetre;
  for (QuantityBox* box : position_) {
    const QSignalBlocker block(box);
    box->setUnit(1.0 / field.perMetre, field.decimals);
    box->setRange(-kFarthest * perMetre_, kFarthest * perMetre_);
  }
}

void PlacementPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LocaleChange) return;
  showUnit();
  showTitle();
  showNumbers();
}

void PlacementPanel::showNumbers() {
  hideRefused();
  const Vector3 at = X_WB_ * frame().position;
  rollPitchYaw_ = rollPitchYawOf(X_WB_.orientation * frame().orientation);
  for (int axis = 0; axis < 3; ++axis) {
    const QSignalBlocker blockPosition(position_[axis]);
    const QSignalBlocker blockTurn(turn_[axis]);
    position_[axis]->setValue(perMetre_ * at[axis]);
    turn_[axis]->setValue(kDegrees * rollPitchYaw_[axis]);
  }
}

void PlacementPanel::takePosition(int axis) {
  hideRefused();
  const double turned = (X_WB_.orientation * frame().position)[axis];
  X_WB_.position[axis] = position_[axis]->value() / perMetre_ - turned;
  emit placed(X_WB_);
}

void PlacementPanel::takeTurn(int axis) {
  hideRefused();
  rollPitchYaw_[axis] = turn_[axis]->value() / kDegrees;
  const Pose own = frame();
  const Vector3 stays = X_WB_ * own.position;
  const Quaternion turned = fromRollPitchYaw(rollPitchYaw_.x(), rollPitchYaw_.y(), rollPitchYaw_.z());
  X_WB_.orientation = turned * own.orientation.conjugate();
  if (!own.position.isZero(0.0)) X_WB_.position = stays - X_WB_.orientation * own.position;
  emit placed(X_WB_);
}

}  // namespace glissade
