#include <glissade/planners.h>

#include <algorithm>

#include "engine/api/values.h"
#include "engine/planning/planner.h"

namespace glissade::api {

PlannerContext::~PlannerContext() = default;

Outcome Planners::add(const std::string& id, PlannerFunction search) {
  if (id.empty()) return wrongArgument("id", "is empty");
  if (!search) return wrongArgument("search", "is no function");
  const std::vector<std::string> known = ids();
  if (std::find(known.begin(), known.end(), id) != known.end()) {
    return wrongArgument("id", "is the id of another planner: " + id);
  }
  added_.push_back({id, std::move(search)});
  return Done{};
}

std::vector<std::string> Planners::ids() const {
  std::vector<std::string> all = idsOf(makePlannerRegistry());
  for (const Entry& entry : added_) all.push_back(entry.id);
  return all;
}

}  // namespace glissade::api
