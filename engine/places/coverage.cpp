#include "engine/places/coverage.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/geometry/cube_intersector.h"
#include "engine/places/inside_columns.h"
#include "engine/places/unchanged_cells.h"

namespace glissade {
namespace {

/// Traverses the octree along a surface, in Z order.
class SurfaceWalk {
  using Change = UnchangedCells::Change;
  /// Deepest level at which a stop is checked. Deeper cells take little time.
  static constexpr int kStopLevel = 6;
  static constexpr std::array<Change, 8> kUnknown{Change::Wholly, Change::Wholly, Change::Wholly, Change::Wholly,
                                                  Change::Wholly, Change::Wholly, Change::Wholly, Change::Wholly};

 public:
  /// Visits only cells in the boxes.
  SurfaceWalk(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth,
              const std::vector<Box3>& boxes, const StopToken& stop = {})
      : frame_(frame), depth_(depth), stop_(stop) {
    triangles_.reserve(mesh_W.triangles.size());
    for (const auto& [a, b, c] : mesh_W.triangles) {
      triangles_.push_back(CubeIntersector({mesh_W.vertices[a], mesh_W.vertices[b], mesh_W.vertices[c]}));
    }
    if (closed) columns_.emplace(mesh_W, frame, depth, boxes);
    candidates_.resize(static_cast<std::size_t>(depth) + 1);
  }

  /// Cells that `unchanged` knows are not visited.
  CellRuns run(UnchangedCells* unchanged = nullptr) {
    unchanged_ = unchanged;
    auto& all = candidates_.front();
    const Vector3 centre = frame_.box(Cell{}).center();
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (triangles_[i].enters(centre, frame_.side / 2.0)) all.push_back(i);
    }
    visit(Cell{}, 0);
    return std::move(occupied_);
  }

 private:
  /// `begin` is the cell's first finest cell. Precondition: candidates_[level] are the triangles that enter it.
  void visit(const Cell& cell, std::uint64_t begin) {
    if (cell.level <= kStopLevel && stop_.stopRequested()) return;
    const std::uint64_t step = finestCellsIn(cell.level + 1, depth_);
    if (candidates_[static_cast<std::size_t>(cell.level)].empty()) {
      if (inside(cell)) addRun(occupied_, {begin, begin + 8 * step});
      return;
    }
    const auto changes = unchanged_ ? unchanged_->changesIn(cell) : kUnknown;
    for (std::uint32_t child = 0; child < 8; ++child) {
      const Cell part{cell.level + 1,
                      {2 * cell.index[0] + (child >> 2U & 1U), 2 * cell.index[1] + (child >> 1U & 1U),
                       2 * cell.index[2] + (child & 1U)}};
      const CellRun cells{begin + child * step, begin + (child + 1) * step};
      if (changes[child] == Change::None) {
        unchanged_->copy(cells, occupied_);
      } else if (part.level == depth_) {
        if (crossed(part) || inside(part)) addRun(occupied_, cells);
      } else {
        UnchangedCells* const known =
            std::exchange(unchanged_, changes[child] == Change::Partly ? unchanged_ : nullptr);
        findCandidates(part);
        visit(part, cells.begin);
        unchanged_ = known;
      }
    }
  }

  void findCandidates(const Cell& cell) {
    const double half = frame_.cellSize(cell.level) / 2.0;
    const Vector3 centre = centreOf(cell, half);
    auto& entering = candidates_[static_cast<std::size_t>(cell.level)];
    entering.clear();
    for (const std::uint32_t i : candidates_[static_cast<std::size_t>(cell.level) - 1]) {
      if (triangles_[i].enters(centre, half)) entering.push_back(i);
    }
  }

  /// True if the surface crosses a finest cell.
  bool crossed(const Cell& cell) const {
    const double half = frame_.cellSize(cell.level) / 2.0;
    const Vector3 centre = centreOf(cell, half);
    const auto& candidates = candidates_[static_cast<std::size_t>(cell.level) - 1];
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](std::uint32_t i) { return triangles_[i].enters(centre, half); });
  }

  /// True if a cell that the surface does not cross is inside the solid.
  bool inside(const Cell& cell) const {
    if (!columns_) return false;
    if (unchanged_) return columns_->inside(unchanged_->changedCellIn(cell));
    const unsigned shift = static_cast<unsigned>(depth_ - cell.level);
    return columns_->inside({cell.index[0] << shift, cell.index[1] << shift, cell.index[2] << shift});
  }

  Vector3 centreOf(const Cell& cell, double half) const {
    return frame_.origin + half * (2.0 * Vector3(cell.index[0], cell.index[1], cell.index[2]) + Vector3::Ones());
  }

  CellFrame frame_;
  int depth_;
  StopToken stop_;
  std::vector<CubeIntersector> triangles_;
  std::optional<InsideColumns> columns_;
  std::vector<std::vector<std::uint32_t>> candidates_;  ///< triangles in the visited cell, by level
  UnchangedCells* unchanged_ = nullptr;                 ///< null: every cell is visited
  CellRuns occupied_;
};

}  // namespace

void addRun(CellRuns& runs, const CellRun& run) {
  if (!runs.empty() && runs.back().end == run.begin) {
    runs.back().end = run.end;
  } else {
    runs.push_back(run);
  }
}

CellRuns coverageOf(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth, const StopToken& stop) {
  return SurfaceWalk(mesh_W, closed, frame, depth, {boundingBox(mesh_W)}, stop).run();
}

CellRuns coverageAfterMotion(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth,
                             const CellRuns& before, const std::vector<Box3>& changed) {
  UnchangedCells unchanged(before, changed, frame, depth);
  if (!unchanged.anyChanged()) return before;
  return SurfaceWalk(mesh_W, closed, frame, depth, changed).run(&unchanged);
}

CellRuns difference(const CellRuns& a, const CellRuns& b) {
  CellRuns result;
  auto cut = b.begin();
  for (CellRun run : a) {
    while (cut != b.end() && cut->end <= run.begin) ++cut;
    for (auto next = cut; next != b.end() && next->begin < run.end; ++next) {
      if (next->begin > run.begin) result.push_back({run.begin, next->begin});
      run.begin = std::min(run.end, next->end);
    }
    if (run.begin < run.end) result.push_back(run);
  }
  return result;
}

std::uint64_t cellCount(const CellRuns& runs) {
  std::uint64_t count = 0;
  for (const CellRun& run : runs) count += run.end - run.begin;
  return count;
}

}  // namespace glissade
