#include "engine/sequence/demanded_steps.h"

#include <algorithm>
#include <optional>
#include <set>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

bool isAlike(const PathPoint& a, const PathPoint& b) {
  return a.q == b.q && a.author == b.author && a.segmentAuthor == b.segmentAuthor;
}

std::vector<std::string> inOrder(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  return names;
}

bool areSame(const std::vector<std::string>& a, const std::vector<std::string>& b) { return inOrder(a) == inOrder(b); }

}  // namespace

bool operator==(const DemandedMotion& a, const DemandedMotion& b) {
  return a.bodies == b.bodies && a.method == b.method &&
         std::equal(a.path.begin(), a.path.end(), b.path.begin(), b.path.end(), isAlike);
}

bool isForbidden(const Vector3& direction, const std::vector<Vector3>& forbidden) {
  const double length = direction.norm();
  return length > 0.0 && std::any_of(forbidden.begin(), forbidden.end(), [&](const Vector3& each) {
           return each.dot(direction) >= tolerance::kForbiddenCone * length;
         });
}

std::vector<std::size_t> movedOrder(std::size_t to, std::size_t from, const std::vector<bool>& isLocked) {
  // The steps that are not locked, in their new order; each then takes the next place that no locked step has.
  std::vector<std::size_t> loose;
  std::size_t before = 0;
  for (std::size_t step = 0; step < isLocked.size(); ++step) {
    if (step == from || isLocked[step]) continue;
    const bool isBefore = to > from ? step <= to : step < to;
    before += isBefore ? 1 : 0;
    loose.push_back(step);
  }
  loose.insert(loose.begin() + static_cast<std::ptrdiff_t>(before), from);
  auto next = loose.begin();
  std::vector<std::size_t> order;
  for (std::size_t place = 0; place < isLocked.size(); ++place) {
    order.push_back(isLocked[place] && place != from ? place : *next++);
  }
  return order;
}

std::vector<bool> lockedSteps(const std::vector<std::vector<std::string>>& steps,
                              const std::vector<DemandedPlace>& places) {
  std::vector<bool> locked;
  for (const auto& step : steps) {
    locked.push_back(std::any_of(places.begin(), places.end(), [&](const DemandedPlace& place) {
      return place.locked && areSame(step, place.bodies);
    }));
  }
  return locked;
}

std::vector<DemandedPlace> movedTo(std::size_t to, std::size_t from, const std::vector<std::vector<std::string>>& steps,
                                   const std::vector<DemandedPlace>& places) {
  std::vector<std::optional<DemandedPlace>> demandOf(steps.size());
  std::vector<DemandedPlace> elsewhere;  // places of steps that the plan does not have
  for (const DemandedPlace& place : places) {
    const auto step =
        std::find_if(steps.begin(), steps.end(), [&](const auto& each) { return areSame(each, place.bodies); });
    if (step == steps.end()) {
      elsewhere.push_back(place);
    } else {
      demandOf[static_cast<std::size_t>(step - steps.begin())] = place;
    }
  }
  const std::vector<bool> locked = lockedSteps(steps, places);
  demandOf[from] = DemandedPlace{steps[from], from + 1, locked[from]};
  const std::vector<std::size_t> order = movedOrder(to, from, locked);
  for (std::size_t place = 0; place < order.size(); ++place) {
    std::optional<DemandedPlace>& demand = demandOf[order[place]];
    if (demand && (order[place] == from || !demand->locked)) demand->place = place + 1;
  }
  std::vector<DemandedPlace> all;
  std::set<std::size_t> taken;
  for (const auto& demand : demandOf) {
    if (!demand) continue;
    all.push_back(*demand);
    taken.insert(demand->place);
  }
  for (DemandedPlace& place : elsewhere) {
    while (!taken.insert(place.place).second) ++place.place;
    all.push_back(std::move(place));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  return all;
}

}  // namespace glissade
