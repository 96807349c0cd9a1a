#include "widgets/devices/axis_row.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Positions of the slider per unit.
constexpr double kPerUnit = 100.0;
constexpr int kStep = 5;

/// The part of `area` from its middle to this share of its half width.
QRectF barOf(const QRectF& area, double share) {
  const double middle = area.center().x();
  const double end = middle + 0.5 * area.width() * std::clamp(share, -1.0, 1.0);
  return {QPointF(std::min(middle, end), area.top()), QPointF(std::max(middle, end), area.bottom())};
}

}  // namespace

ValueSlider::ValueSlider(const ShapingRange& range, const QString& name, QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal, this)), text_(new QLabel(this)) {
  slider_->setRange(static_cast<int>(std::lround(range.lowest * kPerUnit)),
                    static_cast<int>(std::lround(range.highest * kPerUnit)));
  slider_->setSingleStep(kStep);
  slider_->setPageStep(4 * kStep);
  slider_->setAccessibleName(name);
  slider_->setToolTip(name);
  slider_->setMinimumWidth(56);
  text_->setFixedWidth(text_->fontMetrics().horizontalAdvance(QStringLiteral("0.00")) + 4);
  text_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setFocusProxy(slider_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(slider_, 1);
  layout->addWidget(text_);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    value_ = position / kPerUnit;
    showText();
    emit valueChosen(value_);
  });
}

void ValueSlider::setValue(double value) {
  const QSignalBlocker block(slider_);
  slider_->setValue(static_cast<int>(std::lround(value * kPerUnit)));
  value_ = value;
  showText();
}

void ValueSlider::showText() { text_->setText(QLocale().toString(value_, 'f', 2)); }

AxisBar::AxisBar(QWidget* parent) : QWidget(parent) {
  setToolTip(tr("Thin: as the device reports it. Thick: after shaping. Hatched: the dead zone."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void AxisBar::setValues(double raw, double shaped) {
  if (raw == raw_ && shaped == shaped_) return;
  raw_ = raw;
  shaped_ = shaped;
  update();
}

void AxisBar::setDeadZone(double deadZone) {
  deadZone_ = deadZone;
  update();
}

void AxisBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QRectF area = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(palette().color(QPalette::Mid));
  painter.setBrush(palette().base());
  painter.drawRect(area);
  const QRectF thin(area.left(), area.top() + 2.0, area.width(), 0.25 * area.height());
  const QRectF thick(area.left(), thin.bottom() + 2.0, area.width(), area.bottom() - thin.bottom() - 4.0);
  painter.fillRect(barOf(area, deadZone_).united(barOf(area, -deadZone_)),
                   QBrush(palette().color(QPalette::PlaceholderText), Qt::BDiagPattern));
  painter.fillRect(barOf(thin, raw_), palette().color(QPalette::Text));
  painter.fillRect(barOf(thick, shaped_), palette().color(QPalette::Highlight));
  painter.drawLine(QPointF(area.center().x(), area.top()), QPointF(area.center().x(), area.bottom()));
}

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
