#pragma once

#include <vector>

#include "engine/base/message.h"
#include "engine/fits/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Times of the work of a person, seconds, and the limits between its cases. The user can edit each of them. The
/// defaults are estimates of the size of the tables for manual assembly in Boothroyd, Dewhurst and Knight, Product
/// Design for Manufacture and Assembly (2011), chapter 3. None was measured on an assembly line.
struct WorkTimes {
  double smallBelow = 0.006;   ///< metres, longest side of a small part
  double largeAbove = 0.3;     ///< metres, longest side of a large part
  double twoHandsAbove = 4.5;  ///< kg: heavier parts are handled as large ones
  double aidAbove = 15.0;      ///< kg: heavier parts need a lifting aid

  double fetch = 1.95;      ///< a part
  double fetchSmall = 2.7;  ///< a small part
  double fetchLarge = 3.0;  ///< a large part, with both hands
  double fetchWithAid = 9.0;

  double place = 1.5;         ///< along a straight motion, without alignment
  double placeAligned = 2.5;  ///< into a fit
  double placeLed = 5.5;      ///< along a motion with turns
  double press = 5.0;         ///< an insert, a dowel or a bearing into its seat
  double lay = 8.0;           ///< a belt, a cable or a seal

  double startThread = 3.0;
  double turn = 0.35;       ///< a turn of a powered tool
  double turnByHand = 1.0;  ///< a turn without a tool, or with an open wrench
  double toolChange = 2.9;
  double hold = 2.0;  ///< each body that has to be held during the step

  bool operator==(const WorkTimes&) const = default;
};

/// A value of the table, with its name in files.
struct WorkTimeRow {
  const char* id;  ///< "fetch_small_s"
  double WorkTimes::*value;
  double most;  ///< largest value that a file may give; the least is 0
  CatalogueText meaning;
};

/// All rows, in the order in which they are shown.
const std::vector<WorkTimeRow>& workTimeRows();

/// True if the value of this row is not the default.
bool isEdited(const WorkTimes& times, const WorkTimeRow& row);
/// Number of values that are not the default.
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

/// Times of each step of the plan, in its order, when the plan is carried out as assembly. The tool is changed if the
/// step that is carried out before used another one. Precondition: the plan belongs to the product.
std::vector<StepTime> stepTimes(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& times);

}  // namespace glissade
