#include "widgets/devices/value_slider.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>

#include <cmath>

namespace glissade {
namespace {

/// A position of the slider is a hundredth.
constexpr double kPerUnit = 100.0;
constexpr int kStep = 5;

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

}  // namespace glissade
