#pragma once

#include <vector>

#include "engine/product/contact_report.h"
#include "engine/sequence/assembled_product.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// What each body is, by its shape (planes and cylinders about one axis) and its coaxial contacts; names do not count.
/// - screw: a shaft in a hole, with a wider head at one end
/// - nut: a hole on a shaft, through a prism of six equal sides, or of four
/// - washer: a flat ring that touches something
/// - pin: a shaft in a hole, without a head, not longer than ten diameters
std::vector<FastenerKind> fastenersOf(const AssembledProduct& product, const std::vector<Contact>& contacts);

/// Nuts leave before what they are on: shafts slip through nuts that are drawn as equal cylinders.
std::vector<OrderRule> fastenerRules(const std::vector<FastenerKind>& kinds, const std::vector<Contact>& contacts);

}  // namespace glissade
