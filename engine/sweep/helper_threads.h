#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

namespace glissade {

/// Number of threads, besides the calling one, that work on a swept volume.
inline std::size_t helperThreads() {
  constexpr std::size_t kMostThreads = 8;
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads) - 1;
}

}  // namespace glissade
