#include "widgets/controls/quantity_box.h"

#include <QKeyEvent>
#include <numbers>

#include "engine/base/quantity_text.h"

namespace glissade {
namespace {

constexpr double kMetresInMillimetre = 1e-3;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kKeptDecimals = 10;
constexpr int kShownDecimals = 2;

}  // namespace

QuantityBox::QuantityBox(Quantity quantity, QWidget* parent)
    : QDoubleSpinBox(parent),
      quantity_(quantity),
      unit_(quantity == Quantity::Length ? kMetresInMillimetre : kDegree),
      decimals_(kShownDecimals) {
  setDecimals(kKeptDecimals);
  setKeyboardTracking(false);  // a number takes effect when its typing ends
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setAlignment(Qt::AlignRight);
}

void QuantityBox::setUnit(double unit, int decimals) {
  unit_ = unit;
  decimals_ = decimals;
}

/// The text without the unit that the box shows.
QString QuantityBox::bare(const QString& text) const {
  return !suffix().isEmpty() && text.endsWith(suffix()) ? text.chopped(suffix().size()) : text;
}

std::optional<double> QuantityBox::quantityOf(const QString& text) const {
  QString plain = bare(text);
  plain.replace(locale().decimalPoint(), QLatin1Char('.'));
  plain.replace(locale().negativeSign(), QLatin1Char('-'));
  const std::string written = plain.toStdString();
  const auto read = quantity_ == Quantity::Length ? toMetres(written, unit_) : toRadians(written, unit_);
  if (!read) return std::nullopt;
  return *read / unit_;
}

/// If the text is the displayed one, the value keeps all its digits.
double QuantityBox::valueFromText(const QString& text) const {
  if (bare(text) == textFromValue(value())) return value();
  return quantityOf(text).value_or(value());
}

QString QuantityBox::textFromValue(double value) const {
  QString text = locale().toString(value, 'f', decimals_);
  return text.remove(locale().groupSeparator());
}

QValidator::State QuantityBox::validate(QString& text, int& /*position*/) const {
  const auto read = quantityOf(text);
  return read && *read >= minimum() && *read <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

bool QuantityBox::event(QEvent* event) {
  const auto* key = event->type() == QEvent::ShortcutOverride ? static_cast<QKeyEvent*>(event) : nullptr;
  if (key == nullptr || !(key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
    return QDoubleSpinBox::event(event);
  }
  event->ignore();
  return true;
}

void QuantityBox::fixup(QString& text) const {
  emit refused(bare(text).trimmed());
  text = prefix() + textFromValue(value()) + suffix();
}

}  // namespace glissade
