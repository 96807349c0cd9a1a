#pragma once

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

}  // namespace glissade
