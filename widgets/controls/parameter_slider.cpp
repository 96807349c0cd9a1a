#include "widgets/controls/parameter_slider.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

#include "engine/planning/contact/interaction_settings.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kSliderSteps = 1000;
/// Width of a field's borders and arrows, pixels.
constexpr int kNumberBorder = 30;
/// Thresholds of the default value, metres: below the first one, numbers need a thousandth of a micrometre; below the
/// second one, a thousandth of a millimetre.
/// Colour of tuned parameters: Okabe and Ito's orange, which nothing else in the panels has.
constexpr QRgb kTunedColour = 0xffe69f00;

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<int>(view.size())); }

}  // namespace

QString parameterLabel(const ParameterSpec& spec) { return engineText(spec.label); }

ParameterSlider::ParameterSlider(ParameterId id, QWidget* parent)
    : QWidget(parent),
      id_(id),
      shownPerUnit_(1.0),
      slider_(new QSlider(Qt::Horizontal, this)),
      number_(new QDoubleSpinBox(this)),
      tuning_(tunedSetting(id) != 0 ? makeTuningButton() : nullptr) {
  const ParameterSpec& spec = specOf(id);
  const QString symbol = spec.symbol.empty() ? QString() : text(spec.symbol) + QStringLiteral("  ");
  auto* label = new QLabel(symbol + parameterLabel(spec), this);
  label->setBuddy(number_);
  label->setWordWrap(true);  // long names do not widen the panel
  slider_->setRange(0, kSliderSteps);
  slider_->setAccessibleName(parameterLabel(spec));
  number_->setAccessibleName(parameterLabel(spec));
  number_->setDecimals(spec.integer ? 0 : 3);
  number_->setKeyboardTracking(false);
  number_->setAlignment(Qt::AlignRight);
  const QString help = engineText(spec.help);
  setToolTip(help);
  setWhatsThis(help);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setVerticalSpacing(2);
  layout->addWidget(label, 0, 0);
  if (tuning_ != nullptr) layout->addWidget(tuning_, 0, 1);
  layout->addWidget(number_, 0, 2);
  layout->addWidget(slider_, 1, 0, 1, 3);
  layout->setColumnStretch(0, 1);
  setObjectName(text(spec.key));
  setObjectRadius(1.0);
  setTuned(false, 0.0);
  connect(slider_, &QSlider::valueChanged, this, &ParameterSlider::sliderMoved);
  connect(number_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &ParameterSlider::numberEdited);
}

void ParameterSlider::setObjectRadius(double radius) {
  const QSignalBlocker blockNumber(number_);
  const double before = value();
  radius_ = radius;
  range_ = rangeOf(id_, radius);
  showUnit();
  logarithmic_ = range_.minimum > 0.0 && range_.maximum / range_.minimum > 100.0;
  number_->setRange(range_.minimum * shownPerUnit_, range_.maximum * shownPerUnit_);
  number_->setValue(before * shownPerUnit_);
  fitNumber();
  const double step = (range_.maximum - range_.minimum) * shownPerUnit_ / 100.0;
  number_->setSingleStep(specOf(id_).integer ? 1.0 : step);
}

/// Chooses a unit in which the default value is not shown as 0.
void ParameterSlider::showUnit() {
  const ParameterSpec& spec = specOf(id_);
  if (spec.unit != "m") return;
  const double usual = spec.scale == ParameterScale::ObjectRadius ? radius_ * spec.defaultValue : spec.defaultValue;
  const LengthField field = usualLengthField(usual);
  shownPerUnit_ = field.perMetre;
  number_->setDecimals(field.decimals);
  number_->setSuffix(QLatin1Char(' ') + field.unit);
}

/// Makes the field as wide as its longest number. In most units one width suffices for all fields, which are below each
/// other.
void ParameterSlider::fitNumber() {
  const QString longest = number_->textFromValue(number_->maximum()) + number_->suffix();
  const QFontMetrics metrics = number_->fontMetrics();
  const int usual = metrics.horizontalAdvance(QStringLiteral("00000.000 µm"));
  number_->setFixedWidth(std::max(usual, metrics.horizontalAdvance(longest)) + kNumberBorder);
}

void ParameterSlider::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) setObjectRadius(radius_);
}

void ParameterSlider::setValue(double value) {
  const QSignalBlocker blockSlider(slider_);
  const QSignalBlocker blockNumber(number_);
  slider_->setValue(toPosition(value));
  number_->setValue(value * shownPerUnit_);
}

double ParameterSlider::value() const { return number_->value() / shownPerUnit_; }

QToolButton* ParameterSlider::makeTuningButton() {
  auto* button = new QToolButton(this);
  button->setObjectName(QStringLiteral("tuning"));
  button->setText(tr("auto"));
  button->setAccessibleName(tr("The program sets %1").arg(parameterLabel(specOf(id_))));
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setStyleSheet(QStringLiteral("QToolButton { padding: 0px 5px; }"
                                       "QToolButton:checked { background: %1; color: black; }")
                            .arg(QColor(kTunedColour).name()));
  connect(button, &QToolButton::clicked, this, [this](bool tuned) {
    number_->clearFocus();
    emit tuningChosen(tuned);
  });
  return button;
}

void ParameterSlider::setTuned(bool tuned, double own) {
  if (tuning_ == nullptr) return;
  const QString yours = number_->textFromValue(own * shownPerUnit_) + number_->suffix();
  tuning_->setToolTip(tuned ? tr("The program sets this value while planning. Press here, or move the slider, to use "
                                 "your value again: %1")
                                  .arg(yours)
                            : tr("Let the program set this value while planning"));
  tuning_->setChecked(tuned);
  if (tuned_ == tuned) return;
  tuned_ = tuned;
  QPalette colours;
  if (tuned) colours.setColor(QPalette::Highlight, QColor(kTunedColour));
  slider_->setPalette(colours);
}

void ParameterSlider::setNumberReadOnly() {
  number_->setReadOnly(true);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFocusPolicy(Qt::NoFocus);
}

bool ParameterSlider::isBeingEdited() const {
  return slider_->isSliderDown() || number_->hasFocus() || (slider_->hasFocus() && !tuned_);
}

double ParameterSlider::fromPosition(int position) const {
  const double share = static_cast<double>(position) / kSliderSteps;
  const double value = logarithmic_ ? range_.minimum * std::pow(range_.maximum / range_.minimum, share)
                                    : range_.minimum + share * (range_.maximum - range_.minimum);
  return specOf(id_).integer ? std::round(value) : value;
}

int ParameterSlider::toPosition(double value) const {
  const double share = logarithmic_ ? std::log(value / range_.minimum) / std::log(range_.maximum / range_.minimum)
                                    : (value - range_.minimum) / (range_.maximum - range_.minimum);
  return static_cast<int>(std::lround(share * kSliderSteps));
}

void ParameterSlider::sliderMoved(int position) {
  const double chosen = fromPosition(position);
  const QSignalBlocker block(number_);
  number_->setValue(chosen * shownPerUnit_);
  emit valueChosen(chosen);
}

void ParameterSlider::numberEdited(double shown) {
  const QSignalBlocker block(slider_);
  slider_->setValue(toPosition(shown / shownPerUnit_));
  emit valueChosen(shown / shownPerUnit_);
}

}  // namespace glissade
