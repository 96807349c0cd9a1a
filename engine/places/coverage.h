#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/places/cell.h"

namespace glissade {

/// Finest cells [begin, end) on the Z-order curve.
struct CellRun {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  friend bool operator==(const CellRun&, const CellRun&) = default;
};
/// Ascending, disjoint and not adjacent runs, so that equal sets of cells are equal lists.
using CellRuns = std::vector<CellRun>;

/// Appends cells that come after all existing ones.
void addRun(CellRuns& runs, const CellRun& run);

/// The finest cells (at `depth`) that a body occupies: those that its surface crosses, and if `closed`, those inside
/// its solid. A cell that the surface merely touches is not occupied. `mesh_W` is in world coordinates; parts outside
/// the root cube are ignored. Unfinished after a stop.
CellRuns coverageOf(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth,
                    const StopToken& stop = {});

/// coverageOf() after a motion: `before` outside the `changed` boxes (changedBoxes()), computed anew inside them.
CellRuns coverageAfterMotion(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth,
                             const CellRuns& before, const std::vector<Box3>& changed);

/// The cells of a that are not in b.
CellRuns difference(const CellRuns& a, const CellRuns& b);

std::uint64_t cellCount(const CellRuns& runs);

}  // namespace glissade
