#pragma once

#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// Accepts each clash by the depth that is advised for it, metres: no product has one as deep.
inline constexpr double kAdvisedClashes = 1e9;

/// The options of the command line about all fits. They have priority over the file.
struct FitOptions {
  std::optional<bool> on{};
  std::optional<double> acceptedClash{};  ///< metres; turns fits on unless they are turned off
  /// Bodies that are cut in accepted clashes: ids, or the ends of ids behind a "/".
  std::vector<std::string> cut{};

  /// `fits`: the settings of a scenario, or the words that the judge reads.
  template <class Fits>
  void applyTo(Fits& fits) const {
    if (acceptedClash) {
      fits.acceptedClash = *acceptedClash;
      fits.on = true;
    }
    if (on) fits.on = *on;
    fits.cut.insert(fits.cut.end(), cut.begin(), cut.end());
  }
};

}  // namespace glissade
