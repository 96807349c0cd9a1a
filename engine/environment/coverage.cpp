#include "engine/environment/coverage.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/environment/inside_columns.h"
#include "engine/environment/unchanged_cells.h"
#include "engine/geometry/cube_intersector.h"

namespace glissade {
namespace {

/// Goes down the octree along a surface, in Z order.
class SurfaceWalk {
  using Change = UnchangedCells::Change;
  /// Deeper than this a stop is not looked at: the cells are done in a moment.
  static constexpr int kStopLevel = 6;

 public:
  SurfaceWalk(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth, const StopToken& stop)
      : frame_(frame), depth_(depth), stop_(stop) {
    triangles_.reserve(mesh_W.triangles.size());
    for (const auto& [a, b, c] : mesh_W.triangles) {
      triangles_.push_back(CubeIntersector({mesh_W.vertices[a], mesh_W.vertices[b], mesh_W.vertices[c]}));
    }
    if (closed) columns_.emplace(mesh_W, frame, depth);
    candidates_.resize(static_cast<std::size_t>(depth) + 1);
  }

  /// Cells that `unchanged` knows are not looked at.
  CellRuns run(UnchangedCells* unchanged = nullptr) {
    unchanged_ = unchanged;
    auto& all = candidates_.front();
    all.resize(triangles_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    const Box3 root = frame_.box(Cell{});
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](std::uint32_t i) { return !triangles_[i].enters(root.center(), frame_.side / 2.0); }),
              all.end());
    visit(Cell{});
    return std::move(occupied_);
  }

 private:
  /// Precondition: candidates_[level] are the triangles that enter the cell.
  void visit(const Cell& cell) {
    if (cell.level <= kStopLevel && stop_.stopRequested()) return;
    const auto& entering = candidates_[static_cast<std::size_t>(cell.level)];
    if (entering.empty()) {
      const unsigned shift = static_cast<unsigned>(depth_ - cell.level);
      const std::array<std::uint32_t, 3> finest{cell.index[0] << shift, cell.index[1] << shift, cell.index[2] << shift};
      if (columns_ && columns_->inside(finest)) occupy(cell);
    } else if (cell.level == depth_) {
      occupy(cell);
    } else {
      for (std::uint32_t child = 0; child < 8; ++child) visitChild(cell, child);
    }
  }

  void visitChild(const Cell& cell, std::uint32_t child) {
    Cell part{cell.level + 1,
              {2 * cell.index[0] + (child >> 2U & 1U), 2 * cell.index[1] + (child >> 1U & 1U),
               2 * cell.index[2] + (child & 1U)}};
    const Change change = unchanged_ ? unchanged_->changeOf(part) : Change::Wholly;
    if (change == Change::None) {
      unchanged_->copy(finest(part), occupied_);
      return;
    }
    const double half = frame_.cellSize(part.level) / 2.0;
    const Vector3 centre =
        frame_.origin + half * (2.0 * Vector3(part.index[0], part.index[1], part.index[2]) + Vector3::Ones());
    auto& entering = candidates_[static_cast<std::size_t>(part.level)];
    entering.clear();
    for (const std::uint32_t i : candidates_[static_cast<std::size_t>(cell.level)]) {
      if (triangles_[i].enters(centre, half)) entering.push_back(i);
    }
    UnchangedCells* const known = std::exchange(unchanged_, change == Change::Partly ? unchanged_ : nullptr);
    visit(part);
    unchanged_ = known;
  }

  CellRun finest(const Cell& cell) const {
    const unsigned shift = static_cast<unsigned>(depth_ - cell.level);
    const std::uint64_t begin = mortonCode({cell.index[0] << shift, cell.index[1] << shift, cell.index[2] << shift});
    return {begin, begin + finestCellsIn(cell.level, depth_)};
  }

  void occupy(const Cell& cell) { addRun(occupied_, finest(cell)); }

  CellFrame frame_;
  int depth_;
  StopToken stop_;
  std::vector<CubeIntersector> triangles_;
  std::optional<InsideColumns> columns_;
  std::vector<std::vector<std::uint32_t>> candidates_;  ///< per level, of the cell being visited
  UnchangedCells* unchanged_ = nullptr;                 ///< null where every cell is to be looked at
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
  return SurfaceWalk(mesh_W, closed, frame, depth, stop).run();
}

CellRuns coverageAfterMotion(const TriangleMesh& mesh_W, bool closed, const CellFrame& frame, int depth,
                             const CellRuns& before, const std::vector<Box3>& changed) {
  UnchangedCells unchanged(before, changed, frame, depth);
  return SurfaceWalk(mesh_W, closed, frame, depth, {}).run(&unchanged);
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
