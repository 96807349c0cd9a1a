#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/base/thread_team.h"

namespace glissade::api {

/// Number of helping threads for an option `threads`, where 0 means one thread for each core.
inline std::size_t helpersOf(std::size_t threads) {
  constexpr std::size_t kMostThreads = 1024;
  return (threads == 0 ? usableCores() : std::min(threads, kMostThreads)) - 1;
}

}  // namespace glissade::api
