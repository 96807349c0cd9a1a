#include "engine/check/plan_demands.h"

#include <algorithm>
#include <cmath>

#include "engine/assembly/body_choice.h"

namespace glissade::check {
namespace {

/// Cosine of 30 degrees: what is nearer to a forbidden direction is forbidden.
constexpr double kForbiddenCosine = 0.866;
/// Metres that nothing has moved by.
constexpr double kStandsStill = 1e-7;

bool contains(const Group& group, std::size_t body) { return std::binary_search(group.begin(), group.end(), body); }

Group bodiesOf(const std::vector<std::string>& names, const Product& product) {
  Group all;
  for (const std::string& name : names) {
    const Group some = bodiesNamed(product, name);
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// From the first to the last position; up where nothing has moved.
Vector3 exitOf(const std::vector<Point>& path) {
  const Vector3 way = path.back().q.position - path.front().q.position;
  return way.norm() > kStandsStill ? Vector3(way.normalized()) : Vector3(Vector3::UnitZ());
}

bool says(const Step& step, const std::string& rule, const std::string& id) {
  return std::any_of(step.violates.begin(), step.violates.end(), [&](const StatedViolation& each) {
    const auto& ids = each.bodies;
    return each.rule == rule && (id.empty() || std::find(ids.begin(), ids.end(), id) != ids.end());
  });
}

bool isSameMotion(const std::vector<Pose>& demanded, const std::vector<Point>& path) {
  return std::equal(demanded.begin(), demanded.end(), path.begin(), path.end(),
                    [](const Pose& q, const Point& point) { return q == point.q; });
}

}  // namespace

Group bodiesNamed(const Product& product, const std::string& name) {
  std::vector<std::string> ids;
  for (const Body& body : product.bodies) ids.push_back(body.id);
  return bodiesMeant(ids, name, product.tree);
}

std::string againstDemands(const Step& step, const Group& group, const Present& there, std::size_t number,
                           const Product& product, const Demands& demands) {
  const Vector3 exit = exitOf(step.path);
  for (const auto& [name, direction] : demands.forbidden) {
    const Group named = bodiesNamed(product, name);
    const bool concerns =
        std::any_of(named.begin(), named.end(), [&](std::size_t body) { return contains(group, body); });
    if (concerns && direction.normalized().dot(exit) > kForbiddenCosine) {
      return "it leaves in a direction that is forbidden";
    }
  }
  for (const auto& [first, then] : demands.before) {
    const Group later = bodiesNamed(product, then);
    if (std::none_of(later.begin(), later.end(), [&](std::size_t body) { return contains(group, body); })) continue;
    for (const std::size_t body : bodiesNamed(product, first)) {
      if (!there[body] || contains(group, body) || says(step, "before", product.bodies[body].id)) continue;
      return "'" + product.bodies[body].name +
             "' is demanded to leave before, and the step does not say that it does not";
    }
  }
  for (const auto& names : demands.together) {
    const Group together = bodiesOf(names, product);
    const bool some =
        std::any_of(together.begin(), together.end(), [&](std::size_t body) { return contains(group, body); });
    const bool all = std::all_of(together.begin(), together.end(),
                                 [&](std::size_t body) { return contains(group, body) || !there[body]; });
    if (some && !all) return "it is demanded to leave together with others, which stay behind";
  }
  for (const Demands::Place& demanded : demands.places) {
    if (bodiesOf(demanded.bodies, product) != group || demanded.place == number || says(step, "place", "")) continue;
    return "it is demanded as step " + std::to_string(demanded.place);
  }
  for (const Demands::Motion& demanded : demands.motions) {
    if (bodiesOf(demanded.bodies, product) != group) continue;
    if (!isSameMotion(demanded.path, step.path)) return "another motion is demanded of it";
  }
  return {};
}

}  // namespace glissade::check
