#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/path.h"
#include "engine/product/assembled_product.h"
#include "engine/product/fit.h"

namespace glissade {

/// A threaded pair where it is assembled, and what a person says of it.
struct ThreadQuestion {
  const AssembledProduct& product;
  std::size_t object;  ///< index of the body that moves
  Contact contact;     ///< with the axis; the object is `b`
  Pose measuredAt;     ///< the object's configuration that the axis was found in
  std::vector<Pose> ends;
  const FitEdit* edit = nullptr;  ///< null: nothing is said
};

/// The thread with its pitch: a person's, else the coarse pitch of its diameter. A shaft is not turned out of a loose
/// nut, unless a person says so. It is assembled in the ends that have the object on the same axis.
FitThread fitThreadOf(const ThreadQuestion& question, const StopToken& stop);

/// As a plan or a path states it.
check::StatedThread statedThread(const ThreadRule& rule);

}  // namespace glissade
