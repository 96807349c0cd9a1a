#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/sequence/fasteners.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// The volume of a tool that turns a fastener, including a swing of its handle by a sixth of a turn. In the tool's
/// frame the outer end of the head is at the origin, and z points outwards. Sizes follow the head's radius R:
/// - hex key: a leg as wide as a recess takes, 6 R long, and an arm of 14 R
/// - socket: a ring about the head that takes a bolt 4 R long, a bar, and an arm of 14 R at 10 R
/// - screwdriver: a blade of 10 R, and a handle of 15 R, at least 6 mm in radius
/// - open wrench: a jaw, a ring about the head as it turns, and an arm of 12 R beside it
/// Precondition: turnsHead(kind).
TriangleMesh toolShape(ToolKind kind, const FastenerHead& head);

/// An open wrench while it is brought on: its jaw is open, and its arm is at the beginning of the swing. Nothing for
/// the other tools: they are brought on with toolShape().
std::optional<TriangleMesh> enteringToolShape(ToolKind kind, const FastenerHead& head);

/// The translations that take the tool off until no part of it is about the head, in the tool's frame: along the axis,
/// and for an open wrench also to the side of its handle. Each, reversed, is a way to bring it on.
std::vector<Vector3> takeOffWays(ToolKind kind, const FastenerHead& head);

/// The part of a tool that a hand holds: a bar, in the tool's frame.
struct ToolHandle {
  Vector3 from;  ///< the end nearer to the head
  Vector3 to;
  double thickness = 0.0;
};
ToolHandle handleOf(ToolKind kind, const FastenerHead& head);

/// The tool without the swept volume: its handle lies along x unless it lies along the axis.
TriangleMesh toolAtRest(ToolKind kind, const FastenerHead& head);

/// The frame of a tool at the head of a body at X_WB, turned about the axis. A tool for a nut comes from the side to
/// which the nut leaves. `exit`: exit direction, world frame.
Pose toolFrame(const FastenerHead& head, const Pose& X_WB, const Vector3& exit, double turn);

/// Number of handle positions that are tried, evenly spaced about the axis.
int handlePositions(ToolKind kind);

}  // namespace glissade
