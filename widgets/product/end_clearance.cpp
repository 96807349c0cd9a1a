#include "widgets/product/end_clearance.h"

#include "engine/files/scenario_fits.h"
#include "engine/planning/automatic/move_to_clearance.h"

namespace glissade {

Result<std::vector<MovedEnd>> endsMovedClear(const LoadedScenario& scenario, double required, const StopToken& stop) {
  std::vector<MovedEnd> moved;
  for (const AssemblyItem::Kind end : {AssemblyItem::Kind::Start, AssemblyItem::Kind::Goal}) {
    const AssemblyItem item{end, {}};
    const auto before = poseOf(scenario.scenario, item);
    if (!before) continue;
    const auto clear = moveToClearance(wholeWorld(scenario), *before, required, stop);
    if (!clear) {
      Diagnostic why = clear.error();
      why.location = end == AssemblyItem::Kind::Start ? GLISSADE_TEXT("start") : GLISSADE_TEXT("goal");
      return why;
    }
    if (*clear != *before) moved.push_back({item, *clear, (clear->position - before->position).norm()});
  }
  return moved;
}

}  // namespace glissade
