#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/plan_timing.h"
#include "engine/study/plan_words.h"
#include "engine/study/study_report.h"

namespace glissade {

/// What a work instruction is made of. Refers to its members for the time of the call.
struct InstructionContent {
  const AssemblyPlan& plan;
  const AssembledProduct& product;
  std::string name;                    ///< of the product
  double deviation = 0.0;              ///< as of ProductFile
  std::vector<StepCheck> checks;       ///< of each step; empty: not asked
  std::string explodedPicture;         ///< a PNG file; empty: none
  std::string graphPicture;            ///< a PNG file of planGraphSvg(); empty: none
  std::vector<std::string> pictures;   ///< a PNG file of each step of the plan; empty: none
  std::optional<PlanTiming> timing{};  ///< how long the work takes; nothing: not said
};

/// The work instruction as a report: cover, parts list, a page for each step in the order of assembly, how long they
/// take and how a line divides them, parts without a step. Precondition: the plan is about the product.
StudyReport workInstruction(const InstructionContent& content, const PlanWords& words);

}  // namespace glissade
