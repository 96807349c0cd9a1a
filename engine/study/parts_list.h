#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/product/assembled_product.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/study/study_words.h"

namespace glissade {

/// Parts of one kind.
struct PartsListRow {
  std::string name;                 ///< without the number that tells two of one name apart
  std::vector<std::string> bodies;  ///< ids of all
  std::string designation{};        ///< of fasteners, as their joints have it; empty: none
  std::size_t count = 0;
  bool hasBase = false;              ///< one of them stays
  std::size_t withoutStep = 0;       ///< parts of which no step is known, the base excepted
  std::vector<std::size_t> steps{};  ///< by which they come, in the order of assembly, from 1; ascending, each once
};

/// What a plan is made of: fasteners of one designation are one row, and so are other parts of one shape and name. A
/// counter at the end of a name does not tell parts apart: "nut-1" and "nut-2" are the row "nut".
/// Parts come first, fasteners by their designation behind them. Precondition: the plan is about the product.
std::vector<PartsListRow> partsList(const AssemblyPlan& plan, const AssembledProduct& product);

/// "base, 3, 7": by which steps the parts of a row come; a dash where one has no step.
std::string stepsText(const PartsListRow& row, const StudyWords& words);

}  // namespace glissade
