#include "engine/fits/key_sizes.h"

#include <array>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kOneInch = 25.4e-3;
/// Share by which a key may exceed its modelled recess: CAD models have nominal sizes, and meshes of round corners.
constexpr double kTight = 0.012;
/// A key that is smaller than its recess by a larger share turns in it.
constexpr double kLoose = 0.04;

constexpr std::array kKeyRows{0.7, 0.9, 1.3,  1.5,  2.0,  2.5,  3.0,  4.0, 5.0,
                              6.0, 8.0, 10.0, 12.0, 14.0, 17.0, 19.0, 22.0};
constexpr std::array kWrenches{2.5,  3.0,  3.2,  4.0,  4.5,  5.0,  5.5,  6.0,  7.0,  8.0,  9.0,  10.0, 11.0,
                               12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0, 20.0, 21.0, 22.0, 24.0, 27.0,
                               30.0, 32.0, 34.0, 36.0, 41.0, 46.0, 50.0, 55.0, 60.0, 65.0, 70.0, 75.0};

struct InchSize {
  double inches;
  const char* name;
};
constexpr std::array kInchSizes{
    InchSize{1.0 / 16, "1/16"}, InchSize{5.0 / 64, "5/64"}, InchSize{3.0 / 32, "3/32"}, InchSize{7.0 / 64, "7/64"},
    InchSize{1.0 / 8, "1/8"},   InchSize{9.0 / 64, "9/64"}, InchSize{5.0 / 32, "5/32"}, InchSize{3.0 / 16, "3/16"},
    InchSize{7.0 / 32, "7/32"}, InchSize{1.0 / 4, "1/4"},   InchSize{5.0 / 16, "5/16"}, InchSize{11.0 / 32, "11/32"},
    InchSize{3.0 / 8, "3/8"},   InchSize{7.0 / 16, "7/16"}, InchSize{1.0 / 2, "1/2"},   InchSize{9.0 / 16, "9/16"},
    InchSize{5.0 / 8, "5/8"},   InchSize{3.0 / 4, "3/4"},   InchSize{7.0 / 8, "7/8"},   InchSize{15.0 / 16, "15/16"}};

/// Clearance of a key as a share of the hexagon; infinity if it does not fit or would turn.
double looseness(DriveKind drive, double across, double key) {
  const double gap = drive == DriveKind::HexSocket ? across - key : key - across;
  const bool fits = gap >= -kTight * across && gap <= kLoose * across;
  return fits ? std::abs(gap) / across : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<KeySize> keyFor(DriveKind drive, double across) {
  if (drive != DriveKind::HexSocket && drive != DriveKind::HexOutside) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  std::optional<KeySize> best;
  const auto offer = [&](double key, const char* inches) {
    const double loose = looseness(drive, across, key);
    if (loose >= least) return;
    least = loose;
    best = {key, inches};
  };
  if (drive == DriveKind::HexSocket) {
    for (const double key : kKeyRows) offer(kMillimetre * key, "");
  } else {
    for (const double wrench : kWrenches) offer(kMillimetre * wrench, "");
  }
  if (best) return best;
  for (const InchSize& size : kInchSizes) offer(kOneInch * size.inches, size.name);
  return best;
}

}  // namespace glissade
