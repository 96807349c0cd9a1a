#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/evidence/thread.h"
#include "engine/fits/assembled_product.h"
#include "engine/fits/fit.h"

namespace glissade {

/// An assembled threaded pair, and a person's statement about it.
struct ThreadQuestion {
  const AssembledProduct& product;
  std::size_t object;  ///< index of the moving body
  Contact contact;     ///< with the axis; the object is `b`
  Pose measuredAt;     ///< configuration of the object in which the axis was found
  std::vector<Pose> ends;
  const FitEdit* edit = nullptr;  ///< null: there is no statement
};

/// The thread with its pitch: a person's, else the coarse pitch of its diameter. A shaft is not turned out of a loose
/// nut unless a person says so. It is assembled in the ends that have the object on the same axis.
FitThread fitThreadOf(const ThreadQuestion& question, const StopToken& stop);

/// The thread as plans and paths state it.
evidence::StatedThread statedThread(const ThreadRule& rule);

}  // namespace glissade
