#include "widgets/controls/length_text.h"

#include <QApplication>
#include <QLocale>
#include <QWidget>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "engine/base/length_units.h"

namespace glissade {
namespace {

constexpr int kSignificantDigits = 3;
constexpr int kMostDecimals = 9;
/// Metres. A field that shows smaller differences is in micrometres if the unit is fitting.
constexpr double kFinestInMillimetres = 1e-7;
constexpr double kRounding = 1e-9;

struct UnitEntry {
  const char* name;
  double metres;
};

constexpr UnitEntry kMetre{"m", 1.0};
constexpr UnitEntry kMillimetre{"mm", 1e-3};
constexpr UnitEntry kMicrometre{"µm", 1e-6};
constexpr UnitEntry kInchEntry{"in", kInch};

std::atomic<LengthUnit>& chosenUnit() {
  static std::atomic<LengthUnit> unit{LengthUnit::Fitting};
  return unit;
}

/// The unit of a length of this size. Lengths below `smallestInMillimetres` are in micrometres if the unit is fitting.
UnitEntry unitFor(double metres, double smallestInMillimetres) {
  switch (chosenUnit().load()) {
    case LengthUnit::Millimetres: return kMillimetre;
    case LengthUnit::Inches: return kInchEntry;
    case LengthUnit::Metres: return kMetre;
    case LengthUnit::Fitting: break;
  }
  if (metres >= 1.0) return kMetre;
  return metres >= smallestInMillimetres ? kMillimetre : kMicrometre;
}

/// Number of decimals that leaves the significant digits of a number below 1,000.
int decimalsOf(double value) {
  constexpr double kRoundsUp = 1.0 + 0.5e-3;  // 9.996 is written as 10.0
  const int before = static_cast<int>(std::floor(std::log10(value * kRoundsUp))) + 1;
  return std::clamp(kSignificantDigits - before, 0, kMostDecimals);
}

QString nameOf(const UnitEntry& unit) { return QString::fromUtf8(unit.name); }

QString textIn(const UnitEntry& unit, double metres) {
  if (!std::isfinite(metres)) return QStringLiteral("∞");
  constexpr double kLeast = 0.5e-9;  // smaller values have only zeros
  const double value = std::abs(metres / unit.metres) < kLeast ? 0.0 : metres / unit.metres;
  const int decimals = value == 0.0 ? 0 : decimalsOf(std::abs(value));
  return QLocale().toString(value, 'f', decimals) + QLatin1Char(' ') + nameOf(unit);
}

}  // namespace

LengthUnit lengthUnit() { return chosenUnit().load(); }

void setLengthUnit(LengthUnit unit) { chosenUnit().store(unit); }

double roundLengthUnit() { return lengthUnit() == LengthUnit::Inches ? kInch : 1.0; }

void announceLengthUnit() {
  for (QWidget* widget : QApplication::allWidgets()) {
    QEvent event(QEvent::LocaleChange);
    QCoreApplication::sendEvent(widget, &event);
  }
}

QString lengthText(double metres) {
  constexpr double kSmallestInMillimetres = 1e-5;
  const double size = std::abs(metres);
  if (size == 0.0) return textIn(unitFor(kMillimetre.metres, 0.0), metres);
  return textIn(unitFor(size, kSmallestInMillimetres), metres);
}

QString columnLengthText(double metres) {
  if (chosenUnit().load() != LengthUnit::Fitting) return lengthText(metres);
  return textIn(kMillimetre, metres);
}

LengthField lengthField(double finest) {
  const UnitEntry unit = unitFor(finest, kFinestInMillimetres);
  const int decimals = static_cast<int>(std::ceil(-std::log10(finest / unit.metres) - kRounding));
  return {nameOf(unit), 1.0 / unit.metres, std::clamp(decimals, 0, kMostDecimals)};
}

QString countText(std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

}  // namespace glissade
