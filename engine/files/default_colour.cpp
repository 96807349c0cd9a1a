#include "engine/files/default_colour.h"

#include <array>
#include <cstdint>

namespace glissade {
namespace {

/// Colours of similar lightness and low saturation. Strong colours are for marked, found or planned bodies, and cream
/// is for an object whose file has no colour.
constexpr std::array<Colour, 10> kQuiet{{{0.62, 0.66, 0.73},
                                         {0.72, 0.60, 0.55},
                                         {0.58, 0.69, 0.66},
                                         {0.72, 0.61, 0.64},
                                         {0.66, 0.69, 0.57},
                                         {0.64, 0.62, 0.74},
                                         {0.57, 0.67, 0.75},
                                         {0.52, 0.60, 0.68},
                                         {0.68, 0.68, 0.68},
                                         {0.60, 0.72, 0.60}}};

/// The name without the number at its end.
std::string partOf(const std::string& bodyName) {
  const std::size_t last = bodyName.find_last_not_of("0123456789#-_.() ");
  return last == std::string::npos ? bodyName : bodyName.substr(0, last + 1);
}

/// FNV-1a, because it gives the same value on every machine.
std::uint32_t hashOf(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
  return hash;
}

}  // namespace

Colour defaultColour(const std::string& bodyName) { return kQuiet[hashOf(partOf(bodyName)) % kQuiet.size()]; }

}  // namespace glissade
