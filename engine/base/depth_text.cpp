#include "engine/base/depth_text.h"

#include <cmath>
#include <sstream>

namespace glissade {

std::string depthInMillimetres(double metres) {
  constexpr int kDigits = 12;
  std::ostringstream text;
  text.precision(kDigits);
  text << std::round(metres * 1e6) / 1e3 << " mm";
  return text.str();
}

std::string depthAsOption(double metres) {
  std::string text = depthInMillimetres(metres);
  std::erase(text, ' ');
  return text;
}

}  // namespace glissade
