#include "engine/places/octree.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/mesh_audit.h"
#include "engine/places/changed_boxes.h"

namespace glissade {

Octree::Octree(const std::vector<RigidBody>& bodies, const Box3& workspace, const OctreeResolution& resolution,
               const StopToken& stop)
    : frame_(CellFrame::covering(workspace)), workspace_(workspace) {
  for (const RigidBody& body : bodies) {
    bodies_.push_back({body.mesh, body.mobility, isClosedSurface(*body.mesh), body.X_WB, {}});
  }
  const auto rebuild = [&](int depth) {
    depth_ = depth;
    nodes_.assign(1, Node{});
    spareChildren_.clear();
    clutters_.clear();
    clutterIds_.clear();
    intern(Clutter{});
    addAll(stop);
  };
  if (resolution.cellSize > 0.0) {
    rebuild(std::clamp(static_cast<int>(std::ceil(std::log2(frame_.side / resolution.cellSize) - 1e-9)), 1, kDeepest));
  } else {
    // One more level takes about four times the memory, because cells are split along surfaces.
    rebuild(4);
    while (!stop.stopRequested() && depth_ < kDeepest && 4 * nodes_.size() * sizeof(Node) <= resolution.memory)
      rebuild(depth_ + 1);
  }
}

void Octree::addAll(const StopToken& stop) {
  for (std::size_t i = 0; i < bodies_.size() && !stop.stopRequested(); ++i) {
    bodies_[i].cells = coverage(bodies_[i], stop);
    edit(i, bodies_[i].cells, Edit::Add);
  }
}

CellRuns Octree::coverage(const Occupant& body, const StopToken& stop) const {
  return coverageOf(transformed(*body.mesh, body.X_WB), body.closed, frame_, depth_, stop);
}

CellRuns Octree::coverageAt(const Occupant& body, const Pose& X_WB) const {
  const TriangleMesh before_W = transformed(*body.mesh, body.X_WB);
  const TriangleMesh after_W = transformed(*body.mesh, X_WB);
  return coverageAfterMotion(after_W, body.closed, frame_, depth_, body.cells, changedBoxes(before_W, after_W));
}

Octree::Change Octree::moveBody(std::size_t body, const Pose& X_WB) {
  CellRuns now = coverageAt(bodies_[body], X_WB);
  bodies_[body].X_WB = X_WB;
  const CellRuns left = difference(bodies_[body].cells, now);
  const CellRuns entered = difference(now, bodies_[body].cells);
  edit(body, left, Edit::Remove);
  edit(body, entered, Edit::Add);
  bodies_[body].cells = std::move(now);
  return {cellCount(left), cellCount(entered)};
}

std::optional<Octree> Octree::withMobileBodiesAt(const std::vector<RigidBody>& bodies) const {
  const auto samePlaceOrMobile = [](const Occupant& known, const RigidBody& body) {
    return known.mesh == body.mesh && known.mobility == body.mobility &&
           (known.mobility == Mobility::Mobile || known.X_WB == body.X_WB);
  };
  if (!std::equal(bodies_.begin(), bodies_.end(), bodies.begin(), bodies.end(), samePlaceOrMobile)) return std::nullopt;
  Octree moved = *this;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies_[i].X_WB != bodies[i].X_WB) moved.moveBody(i, bodies[i].X_WB);
  }
  return moved;
}

void Octree::edit(std::size_t body, const CellRuns& cells, Edit edit) {
  editedBody_ = body;
  editing_ = edit;
  editedClutter_.clear();
  auto run = cells.begin();
  if (run != cells.end()) editNode(0, 0, 0, run, cells.end());
}

/// Applies the edit to the part of a subtree that the runs cover; `run` advances to the first run that reaches beyond
/// the subtree.
void Octree::editNode(std::size_t node, std::uint64_t begin, int level, CellRuns::const_iterator& run,
                      CellRuns::const_iterator end) {
  const std::uint64_t nodeEnd = begin + finestCellsIn(level, depth_);
  while (run != end && run->end <= begin) ++run;
  if (run == end || run->begin >= nodeEnd) return;
  const bool covered = run->begin <= begin && run->end >= nodeEnd;
  if (nodes_[node].firstChild < 0) {
    if (covered) {
      nodes_[node].clutter = edited(nodes_[node].clutter);
      return;
    }
    split(node);
  }
  const auto first = static_cast<std::size_t>(nodes_[node].firstChild);
  const std::uint64_t step = finestCellsIn(level + 1, depth_);
  for (std::size_t child = 0; child < 8; ++child) editNode(first + child, begin + child * step, level + 1, run, end);
  mergeIfUniform(node);
}

Octree::ClutterId Octree::edited(ClutterId clutter) {
  const auto known = editedClutter_.find(clutter);
  if (known != editedClutter_.end()) return known->second;
  Clutter changed = clutters_[clutter];
  auto& list = bodies_[editedBody_].mobility == Mobility::Static ? changed.staticBodies : changed.mobileBodies;
  const int body = static_cast<int>(editedBody_);
  const auto place = std::lower_bound(list.begin(), list.end(), body);
  const bool listed = place != list.end() && *place == body;
  if (editing_ == Edit::Add && !listed) list.insert(place, body);
  if (editing_ == Edit::Remove && listed) list.erase(place);
  const ClutterId id = intern(changed);
  editedClutter_[clutter] = id;
  return id;
}

Octree::ClutterId Octree::intern(const Clutter& clutter) {
  const auto [entry, isNew] =
      clutterIds_.try_emplace({clutter.staticBodies, clutter.mobileBodies}, static_cast<ClutterId>(clutters_.size()));
  if (isNew) clutters_.push_back(clutter);
  return entry->second;
}

void Octree::split(std::size_t node) {
  std::int32_t first = 0;
  if (spareChildren_.empty()) {
    first = static_cast<std::int32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 8);
  } else {
    first = spareChildren_.back();
    spareChildren_.pop_back();
  }
  for (std::int32_t child = first; child < first + 8; ++child) {
    nodes_[static_cast<std::size_t>(child)] = {-1, nodes_[node].clutter};
  }
  nodes_[node].firstChild = first;
}

void Octree::mergeIfUniform(std::size_t node) {
  const auto first = static_cast<std::size_t>(nodes_[node].firstChild);
  for (std::size_t child = first; child < first + 8; ++child) {
    if (nodes_[child].firstChild >= 0 || nodes_[child].clutter != nodes_[first].clutter) return;
  }
  nodes_[node].clutter = nodes_[first].clutter;
  spareChildren_.push_back(nodes_[node].firstChild);
  nodes_[node].firstChild = -1;
}

void Octree::visitLeaves(std::size_t node, const Cell& cell, const std::function<void(const Leaf&)>& visit) const {
  if (nodes_[node].firstChild < 0) {
    const Clutter& clutter = clutters_[nodes_[node].clutter];
    visit({cell, clutter.kind(), clutter});
    return;
  }
  for (std::uint32_t child = 0; child < 8; ++child) {
    const Cell part{cell.level + 1,
                    {2 * cell.index[0] + (child >> 2U & 1U), 2 * cell.index[1] + (child >> 1U & 1U),
                     2 * cell.index[2] + (child & 1U)}};
    visitLeaves(static_cast<std::size_t>(nodes_[node].firstChild) + child, part, visit);
  }
}

void Octree::forEachLeaf(const std::function<void(const Leaf&)>& visit) const { visitLeaves(0, Cell{}, visit); }

const Clutter& Octree::clutterAt(const std::array<std::uint32_t, 3>& finest) const {
  std::size_t node = 0;
  for (int level = 1; nodes_[node].firstChild >= 0; ++level) {
    const unsigned shift = static_cast<unsigned>(depth_ - level);
    const std::uint32_t child =
        (finest[0] >> shift & 1U) << 2U | (finest[1] >> shift & 1U) << 1U | (finest[2] >> shift & 1U);
    node = static_cast<std::size_t>(nodes_[node].firstChild) + child;
  }
  return clutters_[nodes_[node].clutter];
}

std::size_t Octree::leafCount() const {
  const std::size_t groups = (nodes_.size() - 1) / 8 - spareChildren_.size();
  return 7 * groups + 1;
}

std::array<std::size_t, 3> Octree::leafCounts() const {
  std::array<std::size_t, 3> counts{0, 0, 0};
  forEachLeaf([&](const Leaf& leaf) { ++counts[static_cast<std::size_t>(leaf.kind)]; });
  return counts;
}

bool operator==(const Octree& a, const Octree& b) {
  if (a.depth_ != b.depth_ || a.leafCount() != b.leafCount()) return false;
  const std::function<bool(std::size_t, std::size_t)> same = [&](std::size_t p, std::size_t q) {
    const Octree::Node& u = a.nodes_[p];
    const Octree::Node& v = b.nodes_[q];
    if ((u.firstChild < 0) != (v.firstChild < 0)) return false;
    if (u.firstChild < 0) return a.clutters_[u.clutter] == b.clutters_[v.clutter];
    for (std::size_t child = 0; child < 8; ++child) {
      if (!same(static_cast<std::size_t>(u.firstChild) + child, static_cast<std::size_t>(v.firstChild) + child)) {
        return false;
      }
    }
    return true;
  };
  return same(0, 0);
}

}  // namespace glissade
