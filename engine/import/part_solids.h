#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/model/body_id.h"
#include "engine/model/occurrence.h"

namespace glissade {

/// The path of the part that contains an occurrence: the node above it if the part has several solids, else the
/// occurrence's path.
std::string partPathOf(const Occurrence& occurrence);

/// The occurrences, with the solids of each part within a node (empty: all) joined. Shapes of a part that are no closed
/// solids remain separate; beside them, the joined solids have the name of the part. Precondition: the solids of one
/// part are adjacent. Equal parts still share a mesh.
std::vector<Occurrence> withPartsAsOne(const std::vector<Occurrence>& solids, const std::string& node);
/// As before, but for the parts with these paths, which remain their solids.
std::vector<Occurrence> withPartsAsOne(const std::vector<Occurrence>& solids, const std::set<std::string>& opened);

/// The choice of parts and solids of a product's file, by a person or a plan.
struct PartChoice {
  std::vector<std::string> open{};  ///< names of parts that are replaced by their solids (--open)
  /// Ids of a plan: parts whose solids it names are replaced by the solids, and former paths that it names are used.
  std::vector<BodyId> planBodies{};
};

/// True if these are several solids, all of one part.
bool areSolidsOfOnePart(const std::vector<Occurrence>& shapes);

/// Each part as one occurrence, except those with another choice, and the only part of a file, which is its solids.
/// `whole`: name of a part that is the whole file.
/// Errors: Usage with --open as location for a name of no part with several solids.
Result<std::vector<Occurrence>> chosenParts(const std::vector<Occurrence>& solids, const std::string& whole,
                                            const PartChoice& choice);

}  // namespace glissade
