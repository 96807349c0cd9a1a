#pragma once

#include <QString>

namespace glissade {

/// A length in the unit that fits it (µm, mm or m) with three significant digits, as the user's language writes
/// numbers: "3.21 µm", "0.150 mm", "24.0 mm", "1.52 m". Every length that people read is written by this function, so
/// that two texts of one length never differ.
QString lengthText(double metres);

}  // namespace glissade
