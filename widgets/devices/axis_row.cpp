#include "widgets/devices/axis_row.h"

#include <QEvent>
#include <QLabel>
#include <QSignalBlocker>

namespace glissade {

AxisRow::AxisRow(const QString& name, QGridLayout& grid, int row, QWidget* parent)
    : QObject(parent),
      name_(name),
      bar_(new AxisBar(parent)),
      inverted_(new QCheckBox(parent)),
      source_(new QComboBox(parent)) {
  grid.addWidget(new QLabel(name, parent), row, 0);
  grid.addWidget(bar_, row, 1);
  addSlider(deadZone_, kDeadZoneRange, tr("Dead zone"), &AxisShaping::deadZone, grid, row, 2, parent);
  addSlider(gain_, kGainRange, tr("Gain"), &AxisShaping::gain, grid, row, 3, parent);
  addSlider(exponent_, kExponentRange, tr("Curve"), &AxisShaping::exponent, grid, row, 4, parent);
  inverted_->setToolTip(tr("Turns the direction round"));
  inverted_->setAccessibleName(tr("Inverted"));
  for (const QString& source :
       {tr("shift x"), tr("shift y"), tr("shift z"), tr("turn x"), tr("turn y"), tr("turn z")}) {
    source_->addItem(source);
  }
  source_->setToolTip(tr("The device's axis that drives this one"));
  grid.addWidget(inverted_, row, 5, Qt::AlignCenter);
  grid.addWidget(source_, row, 6);
  for (QWidget* editor : {static_cast<QWidget*>(inverted_), static_cast<QWidget*>(source_)})
    editor->installEventFilter(this);
  connect(inverted_, &QCheckBox::toggled, this, [this](bool inverted) {
    shaping_.inverted = inverted;
    emit changed();
  });
  connect(source_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int source) {
    shaping_.source = static_cast<std::size_t>(source);
    emit changed();
  });
}

void AxisRow::addSlider(ValueSlider*& slider, const ShapingRange& range, const QString& name,
                        double AxisShaping::*value, QGridLayout& grid, int row, int column, QWidget* parent) {
  slider = new ValueSlider(range, name, parent);
  slider->slider()->installEventFilter(this);
  grid.addWidget(slider, row, column);
  connect(slider, &ValueSlider::valueChosen, this, [this, value](double chosen) {
    shaping_.*value = chosen;
    bar_->setDeadZone(shaping_.deadZone);
    emit changed();
  });
}

void AxisRow::addHeader(QGridLayout& grid, QWidget* parent) {
  int column = 0;
  for (const QString& title :
       {tr("Axis"), tr("Device, motion"), tr("Dead zone"), tr("Gain"), tr("Curve"), tr("Invert"), tr("Driven by")}) {
    grid.addWidget(new QLabel(title, parent), 0, column++);
  }
}

void AxisRow::setShaping(const AxisShaping& shaping) {
  shaping_ = shaping;
  const QSignalBlocker blockInverted(inverted_);
  const QSignalBlocker blockSource(source_);
  deadZone_->setValue(shaping.deadZone);
  gain_->setValue(shaping.gain);
  exponent_->setValue(shaping.exponent);
  inverted_->setChecked(shaping.inverted);
  source_->setCurrentIndex(static_cast<int>(shaping.source));
  bar_->setDeadZone(shaping.deadZone);
}

bool AxisRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn) emit entered();
  return QObject::eventFilter(watched, event);
}

}  // namespace glissade
