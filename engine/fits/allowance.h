#pragma once

#include <optional>
#include <string>

#include "engine/base/message.h"
#include "engine/evidence/evidence.h"
#include "engine/evidence/thread.h"
#include "engine/fits/fit_settings.h"
#include "engine/model/body_id.h"

namespace glissade {

/// The amount by which one body of a pair is taken thinner against the other one while one of them moves. The finder of
/// fits, plans, kept paths and the window have this one struct. A file states the allowance for the judge
/// (check::StatedAllowance), and a person edits it (FitEdit).
struct Allowance {
  BodyId body{};  ///< id of the other body
  ContactKind kind = ContactKind::Contact;
  double overlap = 0.0;  ///< measured overlap, metres
  /// Metres at the face that moves farthest; for a refused clash, the allowance that it would need.
  double allowance = 0.0;
  Message text{};       ///< description, with names; empty: not described
  BodyId moving{};      ///< id of the moving body; empty: the object, or the first body of a step
  bool yields = false;  ///< the other body is taken thinner, not the moving one
  bool hollow = false;  ///< the volume that the other body of the pair fills is taken away
  std::optional<evidence::StatedThread> core{};  ///< thread of the body, taken away against the other body
  double pitch = 0.0;  ///< pitch of a thread that comes apart by turning only, metres a turn; 0: none
  double turns = 0.0;  ///< turns of the body in the thread, right-handed about the direction in which it leaves
  evidence::Evidence evidence{};  ///< evidence for the largest allowance of the pair; all zero: the file does not say
};

}  // namespace glissade
