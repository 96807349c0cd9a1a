#pragma once

#include <vector>

#include "engine/fits/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// A pair that overlaps where it is assembled and that leaves because the clash is accepted.
struct AcceptedClash {
  BodyId a;  ///< id, the lesser one
  BodyId b;
  double depth = 0.0;  ///< metres
  BodyId cut{};        ///< id of the body that is taken without what overlaps; empty: both are only taken thinner

  bool operator==(const AcceptedClash&) const = default;
};

/// The accepted clashes that the motion needs, by pair.
std::vector<AcceptedClash> acceptedClashesOf(const StepMotion& motion);

/// The accepted clashes that the motions of the plan and of its lines need, each pair once, by pair.
std::vector<AcceptedClash> acceptedClashesOf(const AssemblyPlan& plan);

/// "'A' and 'B', 0.5 mm: 'A' is cut". Precondition: the clash is of this product.
Message inWords(const AcceptedClash& clash, const AssembledProduct& product);

}  // namespace glissade
