#pragma once

#include <cmath>
#include <sstream>
#include <string>

namespace glissade {

/// "0.41 mm": three digits, for messages about fits.
inline std::string inMillimetres(double metres) {
  std::ostringstream text;
  text.precision(3);
  text << metres * 1e3 << " mm";
  return text.str();
}

/// "0.41mm": an option's value that is not below it, in hundredths.
inline std::string millimetresUp(double metres) {
  std::ostringstream text;
  text << std::ceil(metres * 1e5) / 1e2 << "mm";
  return text.str();
}

}  // namespace glissade
