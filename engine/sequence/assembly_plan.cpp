#include "engine/sequence/assembly_plan.h"

#include <algorithm>
#include <array>

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

Message methodInWords(const std::string& method) {
  constexpr std::array<CatalogueText, 5> kMethods{GLISSADE_TEXT("straight"), GLISSADE_TEXT("two lines"),
                                                  GLISSADE_TEXT("turned"), GLISSADE_TEXT("by hand"),
                                                  GLISSADE_TEXT("flexible")};
  const auto* known =
      std::find_if(kMethods.begin(), kMethods.end(), [&](const CatalogueText& each) { return method == each.english; });
  return known != kMethods.end() ? Message(*known) : Message(method);
}

std::size_t AssemblyPlan::removed() const {
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) count += 1 + step.with.size();
  return count;
}

std::size_t AssemblyPlan::removedWithoutProof() const { return withoutProof(steps) + withoutProof(lines); }

}  // namespace glissade
