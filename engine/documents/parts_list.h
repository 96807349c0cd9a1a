#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/documents/document_words.h"
#include "engine/fits/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Parts of one kind.
struct PartsListRow {
  std::string name;            ///< name without the number that distinguishes parts of the same name
  std::vector<BodyId> bodies;  ///< ids of all parts
  std::string designation{};   ///< designation of fasteners, from their joints; empty: none
  std::size_t count = 0;
  bool hasBase = false;         ///< one of them is in the base
  std::size_t withoutStep = 0;  ///< number of parts without a known step, except the base
  /// Steps that bring the parts, in the order of assembly, from 1; ascending, without duplicates.
  std::vector<std::size_t> steps{};
};

/// True if fasteners of this designation are one part, whatever their shapes: "M3x8", "DIN 934 M3". The designation of
/// a screw or a pin without its length names several parts.
bool namesOnePart(const std::string& designation);

/// The parts list of a plan. Fasteners of a designation that names one part are one row, and so are other parts of one
/// shape and name. A counter at the end of a name is ignored: "nut-1" and "nut-2" are the row "nut". Rows are in the
/// order of their first use in the assembly, then of their names. Precondition: the plan is about the product.
std::vector<PartsListRow> partsList(const AssemblyPlan& plan, const AssembledProduct& product);

/// The steps that bring the parts of a row: "base, 3, 7–9"; "no step" where one has none.
std::string stepsText(const PartsListRow& row, const DocumentWords& words);

}  // namespace glissade
