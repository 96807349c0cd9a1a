#pragma once

#include <string>
#include <vector>

#include "engine/assembly/occurrence.h"
#include "engine/base/result.h"

namespace glissade {

/// The path of the part that an occurrence belongs to: the node above it where it is one of several solids, else its
/// own.
std::string partPathOf(const Occurrence& occurrence);

/// The occurrences with the solids of each part that is within a node (empty: all) as one. Shapes of a part that are no
/// closed solids stay beside it. Solids of one part stand beside each other. Equal parts share a mesh as before.
std::vector<Occurrence> withPartsAsOne(const std::vector<Occurrence>& solids, const std::string& node);

/// How a person, or a plan, wants the parts of a product's file.
struct PartChoice {
  std::vector<std::string> open{};  ///< names of parts that are taken as their solids (--open)
  /// Ids of a plan: parts of which it names solids are taken as these, and former paths that it names are taken.
  std::vector<std::string> planBodies{};
};

/// Each part as one, but for those that are chosen otherwise. `whole`: what a part is called that is all of its file.
/// Errors: Usage with --open as location, where a name means no part of several solids.
Result<std::vector<Occurrence>> chosenParts(const std::vector<Occurrence>& solids, const std::string& whole,
                                            const PartChoice& choice);

}  // namespace glissade
