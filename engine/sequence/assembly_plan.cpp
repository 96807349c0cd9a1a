#include "engine/sequence/assembly_plan.h"

namespace glissade {

std::size_t AssemblyPlan::removed() const {
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) count += 1 + step.with.size();
  return count;
}

std::size_t AssemblyPlan::removedWithoutProof() const {
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) count += step.certified ? 0 : 1 + step.with.size();
  return count;
}

}  // namespace glissade
