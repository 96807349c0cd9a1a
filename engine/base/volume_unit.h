#pragma once

namespace glissade {

/// A unit of volume, and its number per cubic metre.
struct VolumeUnit {
  const char* name;
  double perCubicMetre;
};

/// The unit for a volume (cubic metres) that gives few digits before the decimal point.
inline VolumeUnit volumeUnitFor(double cubicMetres) {
  if (cubicMetres < 1e-6) return {"mm³", 1e9};
  if (cubicMetres < 1e-3) return {"cm³", 1e6};
  if (cubicMetres < 1.0) return {"dm³", 1e3};
  return {"m³", 1.0};
}

}  // namespace glissade
