#pragma once

#include <vector>

#include "engine/fits/joint.h"
#include "engine/fits/product_shapes.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// A tool, and the body that it turns: the nut, or the bolt while the nut is held.
struct ToolUse {
  ToolKind kind = ToolKind::None;
  std::size_t turned = 0;

  bool operator==(const ToolUse&) const = default;
};

/// For each body of a product, the tools that undo it, the preferred one first; empty: it needs none. A step needs a
/// tool only if it opens a joint of the body (makeStep()).
using ToolChoices = std::vector<std::vector<ToolUse>>;

/// Chooses by demand; else by the drive of the body's joint; else by shape. Tools for the bolt come after those for its
/// nut.
/// - a screw with a head of six or four sides, a nut: socket, open wrench
/// - a screw with a recess of six sides, or with a round head that is as high as a socket head: hex key
/// - another screw: screwdriver
/// `joints`: those that count. Errors, Usage: an unknown tool.
Result<ToolChoices> chooseTools(const ProductShapes& shapes, const std::vector<FastenerKind>& kinds,
                                const Joints& joints, const SequenceDemands& demands);

}  // namespace glissade
