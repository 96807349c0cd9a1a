#pragma once

#include <vector>

#include "engine/product/joint.h"
#include "engine/product/product_shapes.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// A tool, and the body that it turns: a nut is turned off its bolt, or held while its bolt is turned.
struct ToolUse {
  ToolKind kind = ToolKind::None;
  std::size_t turned = 0;

  bool operator==(const ToolUse&) const = default;
};

/// Of each body of a product: the tools that undo it, the preferred one first; none where it needs none.
using ToolChoices = std::vector<std::vector<ToolUse>>;

/// What is demanded; else the drive of the body's joint, and no tool for a bolt whose nut is turned; else by shape.
/// What turns the bolt comes after what turns its nut.
/// - a screw with a head of six or four sides, a nut: socket, open wrench
/// - a screw with a recess of six sides, or with a round head that is as high as a socket head: hex key
/// - another screw: screwdriver
/// `joints`: those that count. Errors, Usage: a tool that there is not.
Result<ToolChoices> chooseTools(const ProductShapes& shapes, const std::vector<FastenerKind>& kinds,
                                const Joints& joints, const SequenceDemands& demands);

}  // namespace glissade
