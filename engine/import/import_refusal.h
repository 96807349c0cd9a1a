#pragma once

#include "engine/base/message.h"

namespace glissade {

/// The reason why an importing process gives no body of a file. It is thrown where the file is read, and is written as
/// the process's message.
struct ImportRefusal {
  Message reason;
};

}  // namespace glissade
