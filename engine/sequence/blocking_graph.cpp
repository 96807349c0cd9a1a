#include "engine/sequence/blocking_graph.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace glissade {

std::vector<BodyGroup> BlockingGraph::groups(const std::vector<BodyGroup>& units, std::size_t most) const {
  std::vector<std::size_t> unitOf(blockers_.size(), units.size());
  for (std::size_t unit = 0; unit < units.size(); ++unit) {
    for (const std::size_t body : units[unit]) unitOf[body] = unit;
  }
  std::vector<BodyGroup> found;
  for (std::size_t unit = 0; unit < units.size(); ++unit) {
    BodyGroup group = smallestWith(unit, units, unitOf, most);
    if (group.size() > units[unit].size()) found.push_back(std::move(group));
  }
  return found;
}

/// All that can be reached from the unit; empty where that is too much, or has a body that stays.
BodyGroup BlockingGraph::smallestWith(std::size_t unit, const std::vector<BodyGroup>& units,
                                      const std::vector<std::size_t>& unitOf, std::size_t most) const {
  std::set<std::size_t> reached{unit};
  std::vector<std::size_t> open{unit};
  BodyGroup group;
  while (!open.empty()) {
    const std::size_t next = open.back();
    open.pop_back();
    for (const std::size_t body : units[next]) {
      if (stays_[body] || group.size() == most) return {};
      group.push_back(body);
      for (const std::size_t blocker : blockers_[body]) {
        if (reached.insert(unitOf[blocker]).second) open.push_back(unitOf[blocker]);
      }
    }
  }
  std::sort(group.begin(), group.end());
  return group;
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
