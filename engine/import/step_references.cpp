#include "engine/import/step_references.h"

#include <algorithm>
#include <utility>

namespace glissade {

void StepReferences::beginEntity(std::uint64_t id, std::size_t at, std::string_view type) {
  constexpr std::size_t kLongestType = 60;
  entities_.push_back({id, at, references_.size(), type.substr(0, kLongestType)});
}

void StepReferences::refer(std::uint64_t id) {
  if (!entities_.empty()) references_.push_back(id);
}

std::optional<StepReferences::Fault> StepReferences::fault() {
  if (auto twice = duplicate()) return twice;
  if (auto missing = resolve()) return missing;
  return circle();
}

std::size_t StepReferences::endOfReferences(std::size_t entity) const {
  return entity + 1 < entities_.size() ? entities_[entity + 1].references : references_.size();
}

std::string StepReferences::shown(std::size_t entity) const {
  const Entity& shown = entities_[entity];
  return "#" + std::to_string(shown.id) + (shown.type.empty() ? "" : "=" + std::string(shown.type));
}

std::optional<StepReferences::Fault> StepReferences::duplicate() const {
  std::vector<std::pair<std::uint64_t, std::size_t>> ids;  // with positions in the text
  ids.reserve(entities_.size());
  for (const Entity& entity : entities_) ids.emplace_back(entity.id, entity.at);
  std::sort(ids.begin(), ids.end());
  const auto twice =
      std::adjacent_find(ids.begin(), ids.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == ids.end()) return std::nullopt;
  return Fault{(twice + 1)->second, {GLISSADE_TEXT("#%1 is there twice"), {twice->first}}};
}

/// Replaces the ids by indices of entities.
std::optional<StepReferences::Fault> StepReferences::resolve() {
  std::vector<std::pair<std::uint64_t, std::size_t>> ids;  // with indices of entities
  ids.reserve(entities_.size());
  for (std::size_t i = 0; i < entities_.size(); ++i) ids.emplace_back(entities_[i].id, i);
  std::sort(ids.begin(), ids.end());
  for (std::size_t i = 0; i < entities_.size(); ++i) {
    for (std::size_t k = entities_[i].references; k < endOfReferences(i); ++k) {
      const auto found = std::lower_bound(ids.begin(), ids.end(), std::pair(references_[k], std::size_t{0}));
      if (found == ids.end() || found->first != references_[k]) {
        return Fault{entities_[i].at,
                     {GLISSADE_TEXT("%1 refers to #%2, which is not in the file"), {shown(i), references_[k]}}};
      }
      references_[k] = found->second;
    }
  }
  return std::nullopt;
}

/// Searches a circle of references, depth first, with an explicit stack.
std::optional<StepReferences::Fault> StepReferences::circle() const {
  enum class Seen : std::uint8_t { No, OnTheWay, Done };
  std::vector<Seen> seen(entities_.size(), Seen::No);
  std::vector<std::pair<std::size_t, std::size_t>> way;  // entities, and their next references
  const auto enter = [&](std::size_t entity) {
    seen[entity] = Seen::OnTheWay;
    const bool mayContainItself = entities_[entity].type == "REPRESENTATION";
    way.emplace_back(entity, mayContainItself ? endOfReferences(entity) : entities_[entity].references);
  };
  for (std::size_t root = 0; root < entities_.size(); ++root) {
    if (seen[root] == Seen::No) enter(root);
    while (!way.empty()) {
      const std::size_t entity = way.back().first;
      if (way.back().second == endOfReferences(entity)) {
        seen[entity] = Seen::Done;
        way.pop_back();
        continue;
      }
      const std::size_t next = references_[way.back().second++];
      if (seen[next] == Seen::OnTheWay) {
        return Fault{entities_[entity].at,
                     {GLISSADE_TEXT("%1 refers to %2, which refers back to it"), {shown(entity), shown(next)}}};
      }
      if (seen[next] == Seen::No) enter(next);
    }
  }
  return std::nullopt;
}

}  // namespace glissade
