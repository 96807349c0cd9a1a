#include "engine/check/plan_demands.h"

#include <algorithm>

#include "engine/check/kept_directions.h"
#include "engine/model/body_choice.h"

namespace glissade::check {
namespace {

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

/// Names the body of the step that moves in a direction forbidden to it, for people; empty: none.
Message againstDirections(const Step& step, const Group& group, const Present& there, const Product& product,
                          const Demands& demands) {
  for (const auto& [name, direction] : demands.forbidden) {
    for (const std::size_t body : bodiesNamed(product, name)) {
      if (!contains(group, body) || step.path.empty()) continue;
      const Body& own = product.bodies[body];
      ForbiddenMotion forbidden{own, direction, {}};
      for (const std::size_t other : touching(product, body)) {
        if (there[other] && !contains(group, other)) forbidden.beside.push_back(&product.bodies[other]);
      }
      std::vector<Pose> ofBody;
      const Pose X_PB = inverse(step.path.front().q) * own.X_WB;
      for (const Point& point : step.path) ofBody.push_back(point.q * X_PB);
      if (keepsOut(forbidden, ofBody)) continue;
      return {GLISSADE_TEXT("'%1' moves in a direction that is ruled out for it before it is clear of what it touched"),
              {own.name}};
    }
  }
  return {};
}

bool says(const Step& step, const std::string& rule, const BodyId& id) {
  return std::any_of(step.violates.begin(), step.violates.end(), [&](const StatedViolation& each) {
    const auto& ids = each.bodies;
    return each.rule == rule && (id.empty() || std::find(ids.begin(), ids.end(), id) != ids.end());
  });
}

/// The name of the first body.
const std::string& nameOf(const Group& group, const Product& product) { return product.bodies[group.front()].name; }

bool isSameMotion(const std::vector<Pose>& demanded, const std::vector<Point>& path) {
  return std::equal(demanded.begin(), demanded.end(), path.begin(), path.end(),
                    [](const Pose& q, const Point& point) { return q == point.q; });
}

}  // namespace

Group bodiesNamed(const Product& product, const std::string& name) {
  std::vector<BodyId> ids;
  for (const Body& body : product.bodies) ids.push_back(body.id);
  return bodiesMeant(ids, name, product.tree);
}

BrokenDemands brokenDemands(const Step& step, const Group& group, const Present& there, std::size_t number,
                            const Product& product, const Demands& demands) {
  BrokenDemands broken;
  const auto refuse = [&](const Message& why) {
    if (broken.refused.empty()) broken.refused = why;
  };
  if (const Message wrong = againstDirections(step, group, there, product, demands); !wrong.empty()) refuse(wrong);
  for (const auto& [first, then] : demands.before) {
    const Group later = bodiesNamed(product, then);
    if (std::none_of(later.begin(), later.end(), [&](std::size_t body) { return contains(group, body); })) continue;
    for (const std::size_t body : bodiesNamed(product, first)) {
      if (!there[body] || contains(group, body)) continue;
      const std::string& name = product.bodies[body].name;
      if (says(step, "before", product.bodies[body].id)) {
        broken.givenUp.push_back(leavesBefore(nameOf(group, product), name));
      } else {
        refuse(
            {GLISSADE_TEXT(
                 "a constraint states that '%1' is removed before, and the step does not state that this is given up"),
             {name}});
      }
    }
  }
  for (const auto& names : demands.together) {
    const Group together = bodiesOf(names, product);
    const bool some =
        std::any_of(together.begin(), together.end(), [&](std::size_t body) { return contains(group, body); });
    const bool all = std::all_of(together.begin(), together.end(),
                                 [&](std::size_t body) { return contains(group, body) || !there[body]; });
    if (some && !all) refuse(GLISSADE_TEXT("a constraint removes it together with others, which stay behind"));
  }
  for (const Demands::Place& demanded : demands.places) {
    if (bodiesOf(demanded.bodies, product) != group || demanded.place == number) continue;
    if (says(step, "place", "")) {
      broken.givenUp.push_back(leavesAs(nameOf(group, product), number, demanded.place));
    } else {
      refuse({GLISSADE_TEXT("a constraint states number %1, and it is number %2 of the removal"),
              {demanded.place, number}});
    }
  }
  for (const Demands::Motion& demanded : demands.motions) {
    if (bodiesOf(demanded.bodies, product) != group) continue;
    if (!isSameMotion(demanded.path, step.path)) refuse(GLISSADE_TEXT("a constraint states another motion for it"));
  }
  return broken;
}

}  // namespace glissade::check
