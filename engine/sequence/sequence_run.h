#pragma once

#include <cstdint>
#include <string>

#include "engine/base/result.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// The strategy where nobody chooses one.
inline constexpr const char* kUsualStrategy = "best-first";

/// What is asked for when the sequence of a product is planned.
struct SequenceRequest {
  BodySet staying;                        ///< bodies that are not to leave
  std::string strategy = kUsualStrategy;  ///< id of the registry
  std::uint64_t seed = 1;
  SequenceDemands demands{};
  const AssemblyPlan* resumed = nullptr;  ///< as in SequenceQuestion
  /// A plan of the same product with other demands: before a motion is searched, its motion is tried. Or null.
  const AssemblyPlan* known = nullptr;
  /// Of this product, with what a person says of them; null: they are found, where the demands use them.
  const Joints* joints = nullptr;
};

/// Plans with all that is known of the product: its fits, its joints, its fasteners, what stands, and the demands. What
/// is one body with one that stays, stays too. The host is told of plans that can be saved and resumed: each of their
/// steps demands all earlier ones. Errors: an unknown strategy, demands that name no body or contradict each other,
/// words about joints that are not there.
Result<AssemblyPlan> planSequence(const AssembledProduct& product, const ProductFits& fits,
                                  const SequenceRequest& request, SequenceHost& host);

}  // namespace glissade
