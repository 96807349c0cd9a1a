#pragma once

#include "engine/geometry/triangle_mesh.h"
#include "engine/sequence/fasteners.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// The volume of a tool that turns a fastener, with what its handle sweeps: a sixth of a turn. In the tool's frame the
/// outer end of the head is at the origin, and z points outwards. Sizes follow the head's radius R:
/// - hex key: a leg as wide as a recess takes, 6 R long, and an arm of 14 R
/// - socket: a ring about the head that takes a bolt 4 R long, a bar, and an arm of 14 R at 10 R
/// - screwdriver: a blade of 10 R, and a handle of 15 R, at least 6 mm in radius
/// - open wrench: a jaw about the head, and an arm of 12 R beside it
/// Precondition: not None.
TriangleMesh toolShape(ToolKind kind, const FastenerHead& head);

/// How far the tool is taken off along z until nothing of it is about the head, metres; 0: it comes from the side.
double takeOffLength(ToolKind kind, const FastenerHead& head);

/// How many positions of the handle are tried, evenly about the axis.
int handlePositions(ToolKind kind);

}  // namespace glissade
