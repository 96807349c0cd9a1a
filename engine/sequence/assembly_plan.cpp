#include "engine/sequence/assembly_plan.h"

#include <algorithm>
#include <array>

#include "engine/sequence/plan_bodies.h"

namespace glissade {
Message methodInWords(const std::string& method) {
  constexpr std::array<CatalogueText, 5> kMethods{GLISSADE_TEXT("straight"), GLISSADE_TEXT("two lines"),
                                                  GLISSADE_TEXT("turned"), GLISSADE_TEXT("by hand"),
                                                  GLISSADE_TEXT("flexible")};
  const auto* known =
      std::find_if(kMethods.begin(), kMethods.end(), [&](const CatalogueText& each) { return method == each.english; });
  return known != kMethods.end() ? Message(*known) : Message(method);
}

std::vector<BodyId> AssemblyStep::bodies() const {
  std::vector<BodyId> all;
  for (const StepMotion& motion : motions) {
    all.push_back(motion.body);
    all.insert(all.end(), motion.with.begin(), motion.with.end());
  }
  return all;
}

const StepMotion& AssemblyStep::opening() const {
  const auto opening = std::find_if(motions.begin(), motions.end(),
                                    [](const StepMotion& each) { return each.tool.kind != ToolKind::None; });
  return opening == motions.end() ? motions.front() : *opening;
}

std::vector<BodyId> AssemblyStep::falling() const {
  std::vector<BodyId> known = bodies();
  const std::size_t own = known.size();
  for (const StepMotion& motion : motions) {
    for (const BodyId& id : motion.falling) {
      if (std::find(known.begin(), known.end(), id) == known.end()) known.push_back(id);
    }
  }
  return {known.begin() + static_cast<std::ptrdiff_t>(own), known.end()};
}

std::size_t AssemblyPlan::removed() const {
  std::size_t count = 0;
  for (const AssemblyStep& step : steps) count += step.bodies().size();
  return count;
}

std::size_t AssemblyPlan::removedWithoutProof() const {
  std::size_t count = 0;
  for (const StepMotion* motion : allMotionsOf(*this)) count += motion->certified ? 0 : 1 + motion->with.size();
  return count;
}

}  // namespace glissade
