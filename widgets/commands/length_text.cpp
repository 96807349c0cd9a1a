#include "widgets/commands/length_text.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

constexpr int kSignificantDigits = 3;

struct LengthUnit {
  const char* name;
  double metres;
  double from;  ///< the smallest length, in metres, that is written in this unit
};

constexpr std::array<LengthUnit, 3> kUnits{{{"m", 1.0, 1.0}, {"mm", 1e-3, 1e-5}, {"µm", 1e-6, 0.0}}};

/// Decimals that leave the significant digits of a number below 1,000.
int decimalsOf(double value) {
  const int before = static_cast<int>(std::floor(std::log10(value))) + 1;
  return std::clamp(kSignificantDigits - before, 0, 6);
}

}  // namespace

QString lengthText(double metres) {
  const double size = std::abs(metres);
  if (size == 0.0) return QLocale().toString(0) + QStringLiteral(" mm");
  if (!std::isfinite(size)) return QStringLiteral("∞");
  const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                 [size](const LengthUnit& candidate) { return size >= candidate.from; });
  const double value = metres / unit->metres;
  return QLocale().toString(value, 'f', decimalsOf(std::abs(value))) + QLatin1Char(' ') + QString::fromUtf8(unit->name);
}

}  // namespace glissade
