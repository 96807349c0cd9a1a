#pragma once

#include <cstdint>
#include <string>

#include "engine/base/result.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/sequence_strategy.h"
#include "engine/sequence/step_order.h"

namespace glissade {

/// The default strategy.
inline constexpr const char* kUsualStrategy = "best-first";

/// A request for a plan of a product.
struct SequenceRequest {
  BodySet staying;                        ///< bodies that are not to leave
  std::string strategy = kUsualStrategy;  ///< id in the registry
  std::uint64_t seed = 1;
  SequenceDemands demands{};
  const AssemblyPlan* resumed = nullptr;  ///< see SequenceQuestion::resumed
  /// A plan of the same product with other demands: its motions are tried before new ones are searched. Or null.
  const AssemblyPlan* known = nullptr;
  /// Joints of this product, with a person's edits; null: they are found if the demands use them.
  const Joints* joints = nullptr;
};

/// Plans with the fits, joints and fasteners of the product, the support of its bodies and the demands. A body that is
/// bonded to a body that stays also stays. The host receives plans that can be saved and resumed; each of their steps
/// demands all earlier ones. Errors: an unknown strategy, demands that name no body or contradict each other, edits of
/// joints that do not exist.
Result<AssemblyPlan> planSequence(const AssembledProduct& product, const ProductFits& fits,
                                  const SequenceRequest& request, SequenceHost& host);

/// The plan with its steps in another order, see withOrder(). `request.resumed`: the plan; `request.demands`: those
/// with the new places. Errors as planSequence(), and Interrupted after a stop.
Result<std::variant<AssemblyPlan, OrderConflict>> planWithOrder(const AssembledProduct& product,
                                                                const ProductFits& fits, const SequenceRequest& request,
                                                                const std::vector<std::size_t>& order,
                                                                SequenceHost& host);

}  // namespace glissade
