#include "engine/places/edit_binding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace glissade {
namespace {

const Place& placeOf(const TopologicalMap& map, int place) { return map.places[static_cast<std::size_t>(place)]; }

double distanceTo(const CellGrid& grid, const std::vector<std::size_t>& cells, const Vector3& p_W) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t cell : cells) least = std::min(least, grid.box(cell).squaredExteriorDistance(p_W));
  return std::sqrt(least);
}

Diagnostic warning(const char* list, std::size_t index, const Message& reason, const Message& advice) {
  return {ErrorKind::MalformedInput, "", std::string("/") + list + "/" + std::to_string(index), reason, advice};
}

/// Warns of edits of a place that has another edit already.
void warnOfSecondEdits(const std::vector<int>& bound, Warnings& warnings) {
  std::map<int, std::size_t> firstOf;
  for (std::size_t i = 0; i < bound.size(); ++i) {
    if (bound[i] == kNoPlace) continue;
    const auto [first, fresh] = firstOf.emplace(bound[i], i);
    if (fresh) continue;
    warnings.push_back(warning("places", i, {GLISSADE_TEXT("edits the same place as /places/%1"), {first->second}},
                               GLISSADE_TEXT("Merge the two edits: where they differ, the later one applies.")));
  }
}

/// Warns of names that another place has, too.
void warnOfSharedNames(const TopologicalMap& map, const SemanticEdits& edits, const std::vector<int>& bound,
                       Warnings& warnings) {
  std::map<std::string, int> placeNamed;
  for (std::size_t place = 0; place < map.places.size(); ++place) {
    const int number = static_cast<int>(place);
    const auto namesIt = [&](std::size_t edit) { return bound[edit] == number && !edits.places[edit].name.empty(); };
    bool renamed = false;
    for (std::size_t edit = 0; edit < bound.size(); ++edit) renamed = renamed || namesIt(edit);
    if (!renamed) placeNamed[map.places[place].name] = number;
  }
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const std::string& name = edits.places[i].name;
    if (bound[i] == kNoPlace || name.empty()) continue;
    if (placeNamed.emplace(name, bound[i]).first->second == bound[i]) continue;
    warnings.push_back(warning("places", i,
                               {GLISSADE_TEXT("has the name '%1', which another place has already"), {name}},
                               GLISSADE_TEXT("Choose another name.")));
  }
}

}  // namespace

int boundPlace(const TopologicalMap& map, const Vector3& at) {
  const int place = map.placeNear(at);
  if (place == kNoPlace || map.placeAt(at) == place) return place;
  const Place& nearest = placeOf(map, place);
  return distanceTo(map.grid, nearest.cells, at) <= nearest.narrowness / 2.0 ? place : kNoPlace;
}

std::vector<int> boundBorders(const TopologicalMap& map, const Vector3& at) {
  std::vector<int> holding;
  const auto cell = map.grid.find(at);
  for (std::size_t i = 0; cell && i < map.borders.size(); ++i) {
    const auto& cells = map.borders[i].cells;
    if (std::binary_search(cells.begin(), cells.end(), *cell)) holding.push_back(static_cast<int>(i));
  }
  if (!holding.empty()) return holding;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < map.borders.size(); ++i) {
    const Border& border = map.borders[i];
    const double distance = distanceTo(map.grid, border.cells, at);
    const double width = std::min(placeOf(map, border.placeA).narrowness, placeOf(map, border.placeB).narrowness);
    if (distance > width / 2.0 || distance >= least) continue;
    least = distance;
    holding = {static_cast<int>(i)};
  }
  return holding;
}

SemanticEdits withoutStrays(const TopologicalMap& map, SemanticEdits edits) {
  const auto isStrayPlace = [&](const PlaceEdit& edit) { return boundPlace(map, edit.at) == kNoPlace; };
  const auto isStrayMilestone = [&](const MilestoneEdit& edit) { return boundBorders(map, edit.at).empty(); };
  edits.places.erase(std::remove_if(edits.places.begin(), edits.places.end(), isStrayPlace), edits.places.end());
  edits.milestones.erase(std::remove_if(edits.milestones.begin(), edits.milestones.end(), isStrayMilestone),
                         edits.milestones.end());
  return edits;
}

Warnings editWarnings(const TopologicalMap& map, const SemanticEdits& edits) {
  Warnings warnings;
  std::vector<int> bound;
  for (std::size_t i = 0; i < edits.places.size(); ++i) {
    const Vector3& at = edits.places[i].at;
    bound.push_back(boundPlace(map, at));
    if (bound[i] == kNoPlace) {
      warnings.push_back(warning("places", i,
                                 GLISSADE_TEXT("lies in no place and near none, so the edit has no effect"),
                                 GLISSADE_TEXT("Move its \"at\" into the place that it is about.")));
    } else if (map.placeAt(at) == kNoPlace) {
      warnings.push_back(warning(
          "places", i,
          {GLISSADE_TEXT("lies in no place; the edit applies to the nearest place, %1"), {placeOf(map, bound[i]).name}},
          GLISSADE_TEXT("Edit that place once more, or move its \"at\" into the place that it is about.")));
    }
  }
  warnOfSecondEdits(bound, warnings);
  warnOfSharedNames(map, edits, bound, warnings);
  for (std::size_t i = 0; i < edits.milestones.size(); ++i) {
    if (!boundBorders(map, edits.milestones[i].at).empty()) continue;
    warnings.push_back(warning(
        "milestones", i, GLISSADE_TEXT("lies in no border of two places and near none, so the edit has no effect"),
        GLISSADE_TEXT("Move its \"at\" to where the two places meet.")));
  }
  return warnings;
}

}  // namespace glissade
