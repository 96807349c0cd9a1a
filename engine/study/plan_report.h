#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/plan_timing.h"
#include "engine/study/plan_words.h"
#include "engine/study/study_report.h"

namespace glissade {

/// A text for each step of a plan, or of a group that is taken apart, and those of its groups.
struct LineTexts {
  std::vector<std::string> steps{};
  std::vector<LineTexts> lines{};  ///< in the order of AssemblyPlan::lines
};

/// What the report of a plan is made of. Refers to its members for the time of the call.
struct PlanReportContent {
  const AssemblyPlan& plan;
  const AssembledProduct& product;
  std::string name;                       ///< of the product
  double deviation = 0.0;                 ///< as of ProductFile
  MissingShapes missing{};                ///< as of ProductFile
  std::vector<StepCheck> checks{};        ///< of each step; empty: not asked
  std::vector<std::string> conditions{};  ///< of the check, in the language of the report
  std::string explodedPicture{};          ///< a PNG file; empty: none
  std::string graphPicture{};             ///< a PNG file of planGraphSvg(); empty: none
  std::vector<std::string> pictures{};    ///< a PNG file of each task (taskRanges()); empty: none
  std::optional<PlanTiming> timing{};     ///< how long the work takes; nothing: not said
  LineTexts access{};                     ///< whether a hand gets there; without steps: not asked
};

/// What an engineer reads of a plan: cover, parts list, a page for each task in the order of assembly with its motions,
/// clearances, allowances and checks, how long the steps take and how a line divides them, parts without a step. The
/// numbers of steps are those of the work instruction. Precondition: the plan is about the product.
StudyReport planReport(const PlanReportContent& content, const PlanWords& words);

}  // namespace glissade
