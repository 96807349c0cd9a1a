#pragma once

#include <utility>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/fits/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// A part that two revisions of a product have, with a difference.
struct ChangedPart {
  std::size_t before = 0;  ///< index in the earlier revision
  std::size_t now = 0;     ///< index in the later revision
  /// Largest distance of the surface of one from that of the other, metres; 0: the shapes are the same. It is measured
  /// at the vertices, where the parts are assembled.
  double reshaped = 0.0;
  double moved = 0.0;   ///< distance of the middles of two parts of the same shape, metres
  double turned = 0.0;  ///< angle between two parts of the same shape, radians
};

/// The differences between two revisions of a product.
struct ProductChanges {
  std::vector<std::size_t> came{};                           ///< indices in the later revision
  std::vector<std::size_t> went{};                           ///< indices in the earlier revision
  std::vector<std::pair<std::size_t, std::size_t>> renamed;  ///< earlier and later: same shape and place, other names
  std::vector<ChangedPart> changed{};
  std::size_t unchanged = 0;  ///< number of parts that are as before

  bool none() const { return came.empty() && went.empty() && renamed.empty() && changed.empty(); }
};

/// The later revision with the ids of the earlier one, for bodies with other ids and the same names. A scenario has
/// other ids than the file that it was made of.
AssembledProduct withIdsOf(const AssembledProduct& before, AssembledProduct now);

/// Compares two revisions. Parts correspond by their ids; parts with other ids correspond if one has the shape and the
/// place of the other. Shapes are the same if their surfaces are nowhere farther apart than their triangles may be from
/// the surfaces of the file. Bodies have their frames at the centres of their boxes. After a stop the result is
/// useless.
ProductChanges changesBetween(const AssembledProduct& before, const AssembledProduct& now, const StopToken& stop = {});

/// The steps of a plan of an earlier revision that the later revision can carry out.
struct CarriedPlan {
  AssemblyPlan plan{};              ///< plan of the later revision, without proofs
  std::vector<std::size_t> from{};  ///< index of each step in the earlier plan
};

/// Carries the plan over to a product: motions of bodies that are gone are left out, steps without another motion, too,
/// and what others say about such bodies. Parts that came have no step. Paths are lengthened where they end inside of
/// the later revision.
CarriedPlan carriedTo(const AssembledProduct& product, const AssemblyPlan& plan);

}  // namespace glissade
