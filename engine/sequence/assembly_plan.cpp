#include "engine/sequence/assembly_plan.h"

namespace glissade {
namespace {

std::size_t withoutProof(const std::vector<AssemblyStep>& steps) {
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) count += step.certified ? 0 : 1 + step.with.size();
  return count;
}

std::size_t withoutProof(const std::vector<SubassemblyLine>& lines) {
  std::size_t count = 0;
  for (const SubassemblyLine& line : lines) count += withoutProof(line.steps) + withoutProof(line.lines);
  return count;
}

}  // namespace

std::size_t AssemblyPlan::removed() const {
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) count += 1 + step.with.size();
  return count;
}

std::size_t AssemblyPlan::removedWithoutProof() const { return withoutProof(steps) + withoutProof(lines); }

}  // namespace glissade
