#include "widgets/panels/ghost_row.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

/// Metres.
constexpr double kLeastGhostDistance = 1e-5;
constexpr double kMostGhostDistance = 1e4;

}  // namespace

GhostRow::GhostRow(QWidget* parent)
    : QWidget(parent),
      by_(new QComboBox(this)),
      number_(new QSpinBox(this)),
      distance_(new QuantityBox(QuantityBox::Quantity::Length, this)) {
  // In the order of PathSpacing::By.
  by_->addItems({tr("none"), tr("number"), tr("every")});
  by_->setObjectName(QStringLiteral("ghosts"));
  by_->setAccessibleName(tr("Ghosts of the object along the path"));
  by_->setToolTip(
      tr("Draw the object along the path: not at all, at a number of places, or every so many millimetres"));
  number_->setRange(1, kMostPathPoses);
  number_->setAccessibleName(tr("Number of ghosts"));
  number_->setToolTip(tr("Number of ghosts between start and goal"));
  distance_->setAccessibleName(tr("Spacing of ghosts"));
  distance_->setToolTip(tr("Spacing of ghosts, in any unit: 25.4 mm, 1 in. Turns count as far as they move the object. "
                           "At most %1 are drawn.")
                            .arg(kMostPathPoses));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Ghosts"), this));
  row->addWidget(by_);
  row->addWidget(number_);
  row->addWidget(distance_);
  row->addStretch();
  connectWidgets();
  showUnit();
}

void GhostRow::connectWidgets() {
  connect(by_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    PathSpacing spacing = spacing_;
    spacing.by = static_cast<PathSpacing::By>(index);
    setSpacing(spacing);
  });
  connect(number_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int number) {
    PathSpacing spacing = spacing_;
    spacing.number = number;
    setSpacing(spacing);
  });
  connect(distance_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    PathSpacing spacing = spacing_;
    spacing.distance = value / perMetre_;
    setSpacing(spacing);
  });
}

void GhostRow::setSpacing(const PathSpacing& spacing) {
  spacing_ = spacing;
  showSpacing();
  emit changed(spacing_);
}

void GhostRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) showUnit();
}

void GhostRow::showUnit() {
  const LengthField field = lengthField(kLeastGhostDistance);
  perMetre_ = field.perMetre;
  const QSignalBlocker block(distance_);
  distance_->setUnit(1.0 / perMetre_, field.decimals);
  distance_->setSuffix(QLatin1Char(' ') + field.unit);
  distance_->setRange(kLeastGhostDistance * perMetre_, kMostGhostDistance * perMetre_);
  distance_->setFixedWidth(distance_->fontMetrics().horizontalAdvance(QStringLiteral("00000.00 mm ")) + 12);
  showSpacing();
}

void GhostRow::showSpacing() {
  const QSignalBlocker blockBy(by_);
  const QSignalBlocker blockNumber(number_);
  const QSignalBlocker blockDistance(distance_);
  by_->setCurrentIndex(static_cast<int>(spacing_.by));
  number_->setValue(spacing_.number);
  distance_->setValue(perMetre_ * spacing_.distance);
  number_->setVisible(spacing_.by == PathSpacing::By::Number);
  distance_->setVisible(spacing_.by == PathSpacing::By::Distance);
}

}  // namespace glissade
