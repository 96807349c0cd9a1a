#pragma once

#include <optional>

#include "engine/base/result.h"
#include "engine/check/evidence_names.h"
#include "engine/evidence/placed_body.h"
#include "engine/evidence/thread.h"

namespace glissade::check {

/// The thread with the file's statements only.
Thread threadOf(const StatedThread& stated);

/// The axis of a thread, as a file states it and the meshes confirm it, or found from the meshes. Both bodies have
/// vertices on cylinders about it, within 10 micrometres, on a common range. `other` and `pitch` are not set. Errors
/// state why there is none.
Result<Thread> threadAxis(const PlacedBody& moving, const PlacedBody& other, const std::optional<StatedThread>& stated);

}  // namespace glissade::check
