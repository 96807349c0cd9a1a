#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/documents/plan_timing.h"
#include "engine/documents/plan_words.h"
#include "engine/documents/report.h"
#include "engine/model/missing_shape.h"

namespace glissade {

/// A text for each step of a plan or of a group, and the texts of its groups.
struct LineTexts {
  std::vector<std::string> steps{};
  std::vector<LineTexts> lines{};  ///< groups in the order of AssemblyPlan::lines
};

/// Content of the report of a plan. The references must be valid during the call.
struct PlanReportContent {
  const AssemblyPlan& plan;
  const AssembledProduct& product;
  std::string name;                       ///< name of the product
  double deviation = 0.0;                 ///< as in ProductFile
  MissingShapes missing{};                ///< as in ProductFile
  std::vector<StepCheck> checks{};        ///< check of each step; empty: not checked
  std::vector<std::string> conditions{};  ///< conditions of the check, in the language of the report
  std::string explodedPicture{};          ///< path of a PNG file; empty: none
  std::string graphPicture{};             ///< path of a PNG file of planGraphSvg(); empty: none
  std::vector<std::string> pictures{};    ///< a PNG file for each task (taskRanges()); empty: none
  std::optional<PlanTiming> timing{};     ///< duration of the work; nothing: not stated
  LineTexts access{};                     ///< access of a hand for each step; without steps: not checked
};

/// The report of a plan for an engineer: cover, parts list, a page for each task in the order of assembly with its
/// motions, clearances, allowances and checks, the times of the steps and their division among a line's stations, and
/// parts without a step. The numbers of steps are those of the work instruction. Precondition: the plan is about the
/// product.
Report planReport(const PlanReportContent& content, const PlanWords& words);

}  // namespace glissade
