#include "engine/sequence/assemblies_there.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "engine/sequence/stuck_reasons.h"

namespace glissade {

std::vector<BodyGroup> assembliesThere(const SequenceQuestion& question, const BodySet& present) {
  const Product& tree = question.product.tree;
  std::map<std::string, std::size_t> numbers;
  for (const std::size_t body : bodiesIn(present)) numbers.emplace(question.product.bodies[body].id, body);
  std::set<BodyGroup> assemblies;
  for (std::size_t node = 0; node < tree.nodes().size(); ++node) {
    if (tree.nodes()[node].children.empty()) continue;
    BodyGroup bodies;
    for (const std::string& id : tree.bodiesBelow(node)) {
      if (const auto there = numbers.find(id); there != numbers.end()) bodies.push_back(there->second);
    }
    std::sort(bodies.begin(), bodies.end());
    const bool whole = std::all_of(bodies.begin(), bodies.end(), [&](std::size_t body) {
      const BodyGroup unit = unitOf(body, question.rules);
      return std::includes(bodies.begin(), bodies.end(), unit.begin(), unit.end());
    });
    if (whole && bodies.size() > 1) assemblies.insert(std::move(bodies));
  }
  std::vector<BodyGroup> groups(assemblies.begin(), assemblies.end());
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return groups;
}

}  // namespace glissade
