#pragma once

#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/base/stop_token.h"
#include "engine/evidence/body.h"

namespace glissade::evidence {

/// Closed bodies of one shape in one place, such as a wheel that each of its rollers brings along.
struct PlaceCopies {
  std::size_t body = 0;               ///< index of the body that stands for all
  std::vector<std::size_t> copies{};  ///< indices of the others, ascending
};

/// The bodies whose surface is that of an earlier one, within the deflections of both. A turned body of a symmetric
/// shape is such a copy. `named`: ids of bodies that a plan names, which are no copies.
std::vector<PlaceCopies> placeCopiesIn(const std::vector<Body>& bodies, const std::vector<BodyId>& named,
                                       const StopToken& stop = {});

/// For each of so many bodies, whether it is a copy that another one stands for.
std::vector<bool> areCopies(const std::vector<PlaceCopies>& places, std::size_t bodies);

/// A warning for each body that stands for copies, with their names.
Warnings warningsOf(const std::vector<PlaceCopies>& places, const std::vector<Body>& bodies);

}  // namespace glissade::evidence
