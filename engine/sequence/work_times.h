#pragma once

#include <vector>

#include "engine/product/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Seconds that the work of a person takes, and the limits between its cases. A person can edit each of them. The
/// defaults are estimates: handling and insertion are of the size of the tables for manual assembly in Boothroyd,
/// Dewhurst and Knight, Product Design for Manufacture and Assembly (2011), chapter 3. None was measured at a line.
struct WorkTimes {
  double smallBelow = 0.006;   ///< metres, longest side of a small part
  double largeAbove = 0.3;     ///< metres, longest side of a large part
  double twoHandsAbove = 4.5;  ///< kg: heavier parts are handled as large ones
  double aidAbove = 15.0;      ///< kg: heavier parts need a lifting aid

  double fetch = 1.95;      ///< a part
  double fetchSmall = 2.7;  ///< a small part
  double fetchLarge = 3.0;  ///< a large part, with both hands
  double fetchWithAid = 9.0;

  double place = 1.5;         ///< along a straight way, nothing to be aligned
  double placeAligned = 2.5;  ///< into a fit
  double placeLed = 5.5;      ///< along a way with turns
  double press = 5.0;         ///< an insert, a dowel or a bearing into its seat
  double lay = 8.0;           ///< a belt, a cable or a seal

  double startThread = 3.0;
  double turn = 0.35;       ///< a turn of a powered tool
  double turnByHand = 1.0;  ///< a turn without a tool, or with an open wrench
  double toolChange = 2.9;
  double hold = 2.0;  ///< each body that has to be held meanwhile

  bool operator==(const WorkTimes&) const = default;
};

/// A value of the table, as files and people name it.
struct WorkTimeRow {
  const char* id;  ///< "fetch_small_s"
  double WorkTimes::*value;
  double most;  ///< what a file may give, from 0 on
  const char* meaning;
};

/// All of them, in the order in which they are shown.
const std::vector<WorkTimeRow>& workTimeRows();

/// The value of this row is not the default.
bool isEdited(const WorkTimes& times, const WorkTimeRow& row);
/// How many values are not.
std::size_t editedCount(const WorkTimes& times);

/// Seconds of one step.
struct StepTime {
  double fetch = 0.0;
  double place = 0.0;
  double turn = 0.0;
  double tool = 0.0;
  double hold = 0.0;

  double total() const { return fetch + place + turn + tool + hold; }
};

/// Of each step of the plan, in its order, as it is carried out in assembly. A tool is changed where the step that is
/// carried out before used another one. Precondition: the plan is about the product.
std::vector<StepTime> stepTimes(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& times);

}  // namespace glissade
