#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/model/body_id.h"

namespace glissade {

/// The relation of a pair of bodies that are near each other in the assembled configuration.
enum class ContactKind {
  Clearance,    ///< apart; listed if a clearance is requested
  Planar,       ///< planes coincide
  Cylindrical,  ///< a shaft has the radius of its hole
  Thread,       ///< coaxial, the shaft clearly thicker than the hole: a thread drawn as a cylinder
  Press,        ///< coaxial, the shaft slightly thicker than the hole
  Overlap,      ///< any other overlap that is as designed
  Contact,      ///< any other contact
  Clash         ///< an overlap too large to be as designed
};

inline constexpr EnumNames<ContactKind, 8> kContactKindNames{
    {"clearance", "planar", "cylindrical", "thread", "press", "overlap", "contact", "clash"}};

/// A person's statement about the fit of two bodies, named by id.
struct FitEdit {
  BodyId a;
  BodyId b;
  std::optional<ContactKind> kind;
  std::optional<double> allowance;  ///< metres, >= 0; 0: clearance is required
  bool accepted = false;            ///< a clash that the person accepts
  std::optional<double> pitch{};    ///< pitch of a thread, metres, not 0; below 0: left-handed
  BodyId turned{};  ///< id of the body that is turned in a thread while the other one is held; empty: not stated
};

/// How a scenario treats bodies that touch or overlap in its assembled configuration.
struct FitSettings {
  bool on = false;             ///< false: each pair has to keep the clearance
  double acceptedClash = 0.0;  ///< metres: clashes up to this overlap are accepted
  std::vector<FitEdit> pairs;  ///< statements of a person, which override measurements
  /// Bodies that are cut in accepted clashes if it is not clear which of the two is: ids, or the ends of ids behind a
  /// "/".
  std::vector<std::string> cut{};
};

}  // namespace glissade
