#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/base/message.h"

#include "engine/collision/thread_rule.h"
#include "engine/evidence/cut_shape.h"
#include "engine/evidence/evidence.h"
#include "engine/fits/allowance.h"
#include "engine/fits/contact_report.h"

namespace glissade {

/// A thread that comes apart by turning only.
struct FitThread {
  ThreadRule rule;   ///< its obstacle is that of the fit
  std::string size;  ///< size that the pitch was chosen for, as "M10"; empty if a person gave the pitch
};

/// An allowance as it is found, with the shape that it gives. The moving body is the object, the other one the
/// obstacle.
struct Fit : Allowance {
  enum class Role { Other, Shaft, Hole };  ///< role of the object if the two are coaxial

  std::size_t object = 0;  ///< index in the product
  std::size_t obstacle = 0;
  Role role = Role::Other;
  /// Set if a person marks the pair as a thread, or if the thread of the shaft is taken away.
  std::optional<FitThread> thread{};
  MeshPtr thinned{};  ///< the thinned body; null if it is whole
  /// Set if the clash is refused whether it is accepted or not: it is not clear which body is cut, or neither stays
  /// whole.
  std::optional<evidence::Cut> cut{};
  Message refused{};  ///< reason why nothing is allowed; empty: it is allowed
};

/// "screw taken 0.41 mm thinner in the tapped hole of plate (thread)", and the pitch of a known thread: "..., pitch 1.5
/// mm (ISO coarse, M10)". Takes the names of the object and the obstacle.
Message inWords(const Fit& fit, const std::string& object, const std::string& obstacle);

/// The words followed by ", 9.3 turns"; the words alone for no turns.
Message withTurns(Message words, double turns);

}  // namespace glissade
