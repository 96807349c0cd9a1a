#include "widgets/controls/length_text.h"

#include <QApplication>
#include <QLocale>
#include <QWidget>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/base/length_units.h"

namespace glissade {
namespace {

constexpr int kSignificantDigits = 3;
constexpr double kRounding = 1e-9;

/// A unit, and the one in which lengths are written that would need more than `decimals` here.
struct UnitEntry {
  const char* name;
  double metres;
  int decimals;
  const UnitEntry* smaller;
};

constexpr UnitEntry kMicrometre{"µm", 1e-6, 9, nullptr};
constexpr UnitEntry kMillimetre{"mm", 1e-3, 4, &kMicrometre};
constexpr UnitEntry kMetre{"m", 1.0, 5, &kMillimetre};
constexpr UnitEntry kMicroinch{"µin", 1e-6 * kInch, 9, nullptr};
constexpr UnitEntry kInchEntry{"in", kInch, 5, &kMicroinch};

std::atomic<LengthUnit>& chosenUnit() {
  static std::atomic<LengthUnit> unit{LengthUnit::Millimetres};
  return unit;
}

std::optional<LengthUnit>& preferredUnit() {
  static std::optional<LengthUnit> unit;
  return unit;
}

const UnitEntry& entryOf(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Millimetres: return kMillimetre;
    case LengthUnit::Inches: return kInchEntry;
    case LengthUnit::Metres: break;
  }
  return kMetre;
}

/// Number of decimals that leaves the significant digits of a number below 1,000.
int decimalsOf(double value) {
  if (value == 0.0 || !std::isfinite(value)) return 0;
  constexpr double kRoundsUp = 1.0 + 0.5e-3;  // 9.996 is written as 10.0
  const int before = static_cast<int>(std::floor(std::log10(value * kRoundsUp))) + 1;
  return std::max(kSignificantDigits - before, 0);
}

/// Number of decimals that shows a difference of `number`.
int decimalsFor(double number) { return std::max(0, static_cast<int>(std::ceil(-std::log10(number) - kRounding))); }

/// The unit in which `decimals(number)` are not too many for a length.
template <class Decimals>
const UnitEntry& fittingUnit(double metres, Decimals decimals, LengthUnit largest = lengthUnit()) {
  const UnitEntry* unit = &entryOf(largest);
  while (unit->smaller != nullptr && decimals(metres / unit->metres) > unit->decimals) unit = unit->smaller;
  return *unit;
}

QString nameOf(const UnitEntry& unit) { return QString::fromUtf8(unit.name); }

QString numberIn(const UnitEntry& unit, double metres, int decimals) {
  if (!std::isfinite(metres)) return QStringLiteral("∞");
  const double size = std::abs(metres) / unit.metres;
  const bool isNegative = metres < 0.0 && size * std::pow(10.0, decimals) >= 0.5;  // what is written as 0 has no sign
  return (isNegative ? QStringLiteral("−") : QString()) + QLocale().toString(size, 'f', decimals);
}

QString withUnit(const QString& number, const UnitEntry& unit) { return number + QLatin1Char(' ') + nameOf(unit); }

}  // namespace

LengthUnit lengthUnit() { return chosenUnit().load(); }

void setLengthUnit(LengthUnit unit) { chosenUnit().store(unit); }

void setPreferredLengthUnit(std::optional<LengthUnit> unit) { preferredUnit() = unit; }

LengthUnit lengthUnitFor(double unitOfFile) {
  const bool isInches = unitOfFile == kInch || unitOfFile == kFoot;
  return preferredUnit().value_or(isInches ? LengthUnit::Inches : LengthUnit::Millimetres);
}

double roundLengthUnit() { return lengthUnit() == LengthUnit::Inches ? kInch : 1.0; }

void announceLengthUnit() {
  for (QWidget* widget : QApplication::allWidgets()) {
    QEvent event(QEvent::LocaleChange);
    QCoreApplication::sendEvent(widget, &event);
  }
}

QString lengthText(double metres) { return lengthsText({metres}, {}); }

QString lengthsText(const std::vector<double>& metres, const QString& separator, LengthUnit largestUnit) {
  constexpr double kLeast = 0.5e-15;  // metres; smaller lengths would be written as 0 µm
  double largest = 0.0;
  for (const double each : metres) largest = std::max(largest, std::abs(each) < kLeast ? 0.0 : std::abs(each));
  const UnitEntry& unit = fittingUnit(largest, decimalsOf, largestUnit);
  const int decimals = std::min(decimalsOf(largest / unit.metres), unit.decimals);
  QStringList numbers;
  for (const double each : metres) numbers << numberIn(unit, largest == 0.0 ? 0.0 : each, decimals);
  return std::isfinite(largest) ? withUnit(numbers.join(separator), unit) : numbers.join(separator);
}

QString columnLengthText(double metres) {
  const UnitEntry& unit = lengthUnit() == LengthUnit::Inches ? kInchEntry : kMillimetre;
  const double value = std::abs(metres) / unit.metres;
  if (!std::isfinite(value)) return lengthText(metres);
  const double finest = std::pow(10.0, -unit.decimals);
  if (value == 0.0 || value >= finest / 2.0) {
    return withUnit(numberIn(unit, metres, std::min(decimalsOf(value), unit.decimals)), unit);
  }
  const double limit = std::copysign(finest * unit.metres, metres);
  return QLatin1Char(metres < 0.0 ? '>' : '<') + withUnit(numberIn(unit, limit, unit.decimals), unit);
}

PlotLengths::PlotLengths(double least) {
  constexpr double kLeastNumber = 0.001;
  const UnitEntry* unit = &entryOf(lengthUnit());
  while (unit->smaller != nullptr && least < kLeastNumber * (1.0 - kRounding) * unit->metres) unit = unit->smaller;
  unit_ = nameOf(*unit);
  metres_ = unit->metres;
}

QString PlotLengths::text(double metres) const {
  constexpr int kMostDecimals = 4;
  return written(metres, std::min(decimalsOf(metres / metres_), kMostDecimals));
}

QString PlotLengths::mark(double metres) const { return written(metres, decimalsFor(metres / metres_)); }

QString PlotLengths::written(double metres, int decimals) const {
  return QLocale().toString(metres / metres_, 'f', decimals) + QLatin1Char(' ') + unit_;
}

LengthField lengthField(double finest) {
  const UnitEntry& unit = fittingUnit(finest, decimalsFor);
  return {nameOf(unit), 1.0 / unit.metres, std::min(decimalsFor(finest / unit.metres), unit.decimals)};
}

LengthField usualLengthField(double usual) {
  const UnitEntry& unit = fittingUnit(usual, decimalsOf);
  return {nameOf(unit), 1.0 / unit.metres, std::min(decimalsOf(usual / unit.metres) + 1, unit.decimals)};
}

QString countText(std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

}  // namespace glissade
