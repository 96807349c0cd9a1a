#pragma once

#include <string>

namespace glissade {

/// A number for people with at least three significant digits and separated thousands: "27 600", "0.152", "14.5".
std::string shortNumber(double value);

}  // namespace glissade
