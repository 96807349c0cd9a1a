#include "engine/base/memory_use.h"

#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace glissade {

double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  if (!(file >> size >> resident)) return 0.0;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

double residentMegabytesAfterTrim() {
  malloc_trim(0);
  return residentMegabytes();
}

void giveFreedMemoryBack() {
  constexpr int kPools = 4;
  constexpr int kKept = 1 << 20;  // bytes that are kept at the end of a pool
  mallopt(M_ARENA_MAX, kPools);
  mallopt(M_TRIM_THRESHOLD, kKept);
  mallopt(M_MMAP_THRESHOLD, kKept);
}

double allocatedMegabytes() {
  const struct mallinfo2 used = mallinfo2();
  return static_cast<double>(used.uordblks + used.hblkhd) / (1024.0 * 1024.0);
}

}  // namespace glissade
