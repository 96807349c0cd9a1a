#pragma once

#include <malloc.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace glissade {

/// Number of open files of this process.
inline std::ptrdiff_t openFiles() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
}

/// Bytes that are allocated and not freed.
inline std::ptrdiff_t allocatedBytes() { return static_cast<std::ptrdiff_t>(mallinfo2().uordblks); }

/// Number of rounds of a stress test: GLISSADE_STRESS if set, else `usual`.
inline int stressRounds(int usual) {
  const char* wanted = std::getenv("GLISSADE_STRESS");
  return wanted != nullptr ? std::stoi(wanted) : usual;
}

}  // namespace glissade
