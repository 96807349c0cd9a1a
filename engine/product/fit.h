#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/check/evidence.h"
#include "engine/collision/thread_rule.h"
#include "engine/product/contact_report.h"

namespace glissade {

/// A thread that comes apart by turning only.
struct FitThread {
  ThreadRule rule;   ///< its obstacle is that of the fit
  std::string size;  ///< that the pitch was taken for, as "M10"; empty where a person gave it
};

/// How one body of a pair is taken while the moving one, the object, moves past the other one, the obstacle.
struct Fit {
  enum class Role { Other, Shaft, Hole };  ///< the object's, where the two are coaxial

  std::size_t obstacle = 0;  ///< index in the product
  ContactKind kind = ContactKind::Contact;
  Role role = Role::Other;
  double overlap = 0.0;  ///< as measured, metres
  /// Metres by which the body is taken thinner, of the face that moves farthest; of a refused clash, what it would
  /// take.
  double allowance = 0.0;
  check::Evidence evidence{};  ///< for the largest allowance that may be taken
  /// Where a person has marked the pair as a thread, or the thread of the shaft is taken away.
  std::optional<FitThread> thread{};
  bool core = false;      ///< the shaft's thread is taken away (core_fit.h)
  bool hollow = false;    ///< what the other body of the pair fills is taken away (check/hollow.h)
  MeshPtr thinned{};      ///< the body taken so; null where it is whole
  bool yields = false;    ///< the obstacle is taken thinner, not the object
  std::string refused{};  ///< why nothing is allowed, for people; empty: it is
};

/// "screw taken 0.41 mm thinner in the tapped hole of plate (thread)"; with the pitch, where the thread is known:
/// "..., pitch 1.5 mm (ISO coarse, M10)". Names of the object and of the obstacle.
std::string inWords(const Fit& fit, const std::string& object, const std::string& obstacle);

/// ", 9.3 turns", to be added to the words; nothing where there are none.
std::string turnsInWords(double turns);

}  // namespace glissade
