#include "engine/collision/kernel/lanes.h"

#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {

std::vector<const LaneFunctions*> available() {
  std::vector<const LaneFunctions*> result{&portable()};
#ifdef __x86_64__
  result.push_back(&sse2());
  if (__builtin_cpu_supports("avx2")) result.push_back(&avx2());
#endif
  return result;
}

const LaneFunctions& best() { return *available().back(); }

}  // namespace glissade::lanes
