#pragma once

#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// What a pair of bodies that are near in the assembled configuration is to each other.
enum class ContactKind {
  Clearance,    ///< apart; listed where a clearance is asked for
  Planar,       ///< planes coincide
  Cylindrical,  ///< a shaft has the radius of its hole
  Thread,       ///< coaxial, the shaft clearly thicker than the hole: a thread drawn as a cylinder
  Press,        ///< coaxial, the shaft slightly thicker than the hole
  Overlap,      ///< any other overlap that is as designed
  Contact,      ///< any other that touches
  Clash         ///< an overlap too large to be as designed
};

/// What a person says about the fit of two bodies, named by id.
struct FitEdit {
  std::string a;
  std::string b;
  std::optional<ContactKind> kind;
  std::optional<double> allowance;  ///< metres, >= 0; 0: clearance is required
  bool accepted = false;            ///< a clash that does not stop the work
  std::optional<double> pitch{};    ///< of a thread, metres, not 0; below 0: left-handed
  std::string turned{};  ///< of a thread: id of the body that is turned while the other one is held; empty: not said
};

/// How a scenario treats bodies that touch or overlap in its assembled configuration.
struct FitSettings {
  bool on = false;             ///< false: clearance is required of every pair
  double acceptedClash = 0.0;  ///< metres: clashes up to this overlap are accepted
  std::vector<FitEdit> pairs;  ///< what a person says, before what is measured
  /// Bodies that are cut in accepted clashes where it is not clear which of the two is: ids, or what follows a "/" in
  /// them.
  std::vector<std::string> cut{};
};

}  // namespace glissade
