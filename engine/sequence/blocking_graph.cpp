#include "engine/sequence/blocking_graph.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace glissade {

namespace {

/// Searches groups of a limited number of bodies. A body that is in no such group is stored, because every body that it
/// blocks is in none either.
class GroupSearch {
 public:
  GroupSearch(const BodySet& staying, const BlockingGraph::Edges& edges, const std::vector<BodyGroup>& units,
              std::size_t most)
      : edges_(edges),
        units_(units),
        most_(most),
        unitOf_(staying.size(), units.size()),
        stuck_(staying.size(), false) {
    for (std::size_t unit = 0; unit < units.size(); ++unit) {
      for (const std::size_t body : units[unit]) unitOf_[body] = unit;
      if (std::any_of(units[unit].begin(), units[unit].end(), [&](std::size_t body) { return staying[body]; })) {
        setStuck(unit);
      }
    }
  }

  /// The smallest group that contains the unit; empty if there is none.
  BodyGroup smallestWith(std::size_t unit) {
    BodyGroup group = reachedFrom(unit);
    if (group.empty()) setStuck(unit);
    return group;
  }

 private:
  void setStuck(std::size_t unit) {
    for (const std::size_t body : units_[unit]) stuck_[body] = true;
  }

  BodyGroup reachedFrom(std::size_t first) const {
    std::set<std::size_t> reached{first};
    std::vector<std::size_t> open{first};
    BodyGroup group;
    while (!open.empty()) {
      const BodyGroup& unit = units_[open.back()];
      open.pop_back();
      group.insert(group.end(), unit.begin(), unit.end());
      if (group.size() > most_ || std::any_of(unit.begin(), unit.end(), [&](auto b) { return isHeld(b); })) return {};
      for (const std::size_t body : unit) {
        for (const std::size_t blocker : edges_.candidates(body)) {
          const std::size_t its = unitOf_[blocker];
          if (its == units_.size() || reached.count(its) != 0 || !edges_.blocks(blocker, body)) continue;
          reached.insert(its);
          open.push_back(its);
          if (reached.size() > most_) return {};
        }
      }
    }
    std::sort(group.begin(), group.end());
    return group;
  }

  bool isHeld(std::size_t body) const {
    if (stuck_[body]) return true;
    const std::vector<std::size_t>& candidates = edges_.candidates(body);
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](std::size_t blocker) { return stuck_[blocker] && edges_.blocks(blocker, body); });
  }

  const BlockingGraph::Edges& edges_;
  const std::vector<BodyGroup>& units_;
  std::size_t most_;
  std::vector<std::size_t> unitOf_;  ///< index of the unit of each body; the number of units if the body is absent
  BodySet stuck_;                    ///< bodies that are in no group
};

}  // namespace

std::vector<BodyGroup> BlockingGraph::groups(const std::vector<BodyGroup>& units, std::size_t most) const {
  GroupSearch search(staying_, edges_, units, most);
  std::vector<BodyGroup> found;
  for (std::size_t unit = 0; unit < units.size(); ++unit) {
    BodyGroup group = search.smallestWith(unit);
    if (group.size() > units[unit].size()) found.push_back(std::move(group));
  }
  return found;
}

std::vector<BodyGroup> smallestDisjoint(std::vector<BodyGroup> groups,
                                        const std::function<double(const BodyGroup&)>& volume) {
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  std::stable_sort(groups.begin(), groups.end(), [&](const BodyGroup& a, const BodyGroup& b) {
    return std::tuple(a.size(), volume(a)) < std::tuple(b.size(), volume(b));
  });
  std::set<std::size_t> taken;
  std::vector<BodyGroup> chosen;
  for (BodyGroup& group : groups) {
    if (std::any_of(group.begin(), group.end(), [&](std::size_t body) { return taken.count(body) != 0; })) continue;
    taken.insert(group.begin(), group.end());
    chosen.push_back(std::move(group));
  }
  return chosen;
}

}  // namespace glissade
