#include "engine/sequence/standing.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>

#include "engine/geometry/triangle_tree.h"
#include "engine/sequence/contact_points.h"
#include "engine/sequence/solid_mass.h"

namespace glissade {
namespace {

/// Rounding of files, in addition to the deflection of tessellation, metres.
constexpr double kTouching = 2e-5;

bool isBonded(const Contact& contact, const std::vector<FastenerKind>& fasteners) {
  if (contact.kind == ContactKind::Thread || contact.kind == ContactKind::Press) return true;
  const bool overlaps = contact.kind == ContactKind::Overlap || contact.kind == ContactKind::Clash;
  if (overlaps && contact.overlap > 0.0) return true;
  if (!contact.axis || contact.axis->conical) return false;
  return fasteners[contact.axis->shaftIsA ? contact.b : contact.a] == FastenerKind::Nut;
}

}  // namespace

Standing::Standing(const AssembledProduct& product, const Bodies& bodies, ThreadTeam& team)
    : touchesOf_(product.bodies.size()), gravity_(bodies.gravity.normalized()) {
  std::vector<std::unique_ptr<TriangleTree>> trees(product.bodies.size());
  bodies_.resize(product.bodies.size());
  team.run(bodies_.size(), [&](std::size_t body) {
    const TriangleMesh placed = transformed(*product.bodies[body].mesh, product.bodies[body].X_WB);
    const SolidMass mass = solidMass(placed);
    const double known = bodies.masses.empty() ? 0.0 : bodies.masses[body];
    bodies_[body] = {known > 0.0 ? known : mass.volume * bodies.densities[body], mass.centre,
                     0.5 * boundingBox(placed).diagonal().norm(), bodies.staying[body]};
    trees[body] = std::make_unique<TriangleTree>(placed);
  });
  std::vector<std::vector<SupportPoint>> found(bodies.contacts.size());
  team.run(bodies.contacts.size(), [&](std::size_t i) {
    const Contact& contact = bodies.contacts[i];
    if (contact.kind == ContactKind::Clearance) return;
    const bool bonded = isBonded(contact, bodies.fasteners);
    const double reach = contact.overlap + contact.deviation + kTouching;
    if (bonded) {
      const Box3 common = trees[contact.a]->box().intersection(trees[contact.b]->box());
      const Vector3 between = 0.5 * (bodies_[contact.a].centre + bodies_[contact.b].centre);
      found[i].push_back({contact.a, contact.b, common.isEmpty() ? between : common.center(), Vector3::UnitZ(), true});
      return;
    }
    for (const ContactPoint& at : contactPoints(*trees[contact.a], *trees[contact.b], reach)) {
      found[i].push_back({contact.a, contact.b, at.point, at.normal, false});
    }
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].empty()) continue;
    const Contact& contact = bodies.contacts[i];
    for (const std::size_t body : {contact.a, contact.b}) touchesOf_[body].push_back(touches_.size());
    touches_.push_back({contact.a, contact.b, std::move(found[i])});
  }
}

BodyGroup Standing::newlyFalling(const BodySet& present, const BodyGroup& group) {
  const BodySet rest = without(present, group);
  BodyGroup seeds;
  for (const std::size_t body : group) {
    for (const std::size_t touch : touchesOf_[body]) {
      const std::size_t other = touches_[touch].a == body ? touches_[touch].b : touches_[touch].a;
      if (rest[other] && !bodies_[other].fixed) seeds.push_back(other);
    }
  }
  const BodyGroup before = fallingWith(present, seeds);
  const BodyGroup after = fallingWith(rest, seeds);
  BodyGroup newly;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(newly));
  return newly;
}

BodyGroup Standing::falling(const BodySet& present) {
  BodyGroup seeds;
  for (const std::size_t body : bodiesIn(present)) {
    if (!bodies_[body].fixed) seeds.push_back(body);
  }
  return fallingWith(present, seeds);
}

/// The falling bodies among all bodies that are connected to one of the seeds; ascending.
BodyGroup Standing::fallingWith(const BodySet& present, const BodyGroup& seeds) {
  BodySet open = present;
  std::set<std::size_t> falling;
  for (const std::size_t seed : seeds) {
    if (!open[seed]) continue;
    const BodyGroup connected = connectedTo(seed, present);
    open = without(open, connected);
    const BodyGroup& own = fallingOf(connected, present);
    falling.insert(own.begin(), own.end());
  }
  return {falling.begin(), falling.end()};
}

/// Bodies connected by contacts; a path of contacts does not pass through a held body. Ascending.
BodyGroup Standing::connectedTo(std::size_t seed, const BodySet& present) const {
  std::set<std::size_t> reached{seed};
  std::vector<std::size_t> open{seed};
  while (!open.empty()) {
    const std::size_t body = open.back();
    open.pop_back();
    for (const std::size_t touch : touchesOf_[body]) {
      for (const std::size_t other : {touches_[touch].a, touches_[touch].b}) {
        if (present[other] && !bodies_[other].fixed && reached.insert(other).second) open.push_back(other);
      }
    }
  }
  return {reached.begin(), reached.end()};
}

const BodyGroup& Standing::fallingOf(const BodyGroup& connected, const BodySet& present) {
  std::set<std::size_t> used;
  std::set<std::size_t> holding;
  for (const std::size_t body : connected) {
    for (const std::size_t touch : touchesOf_[body]) {
      if (!present[touches_[touch].a] || !present[touches_[touch].b]) continue;
      used.insert(touch);
      for (const std::size_t other : {touches_[touch].a, touches_[touch].b}) {
        if (bodies_[other].fixed) holding.insert(other);
      }
    }
  }
  const std::pair key{connected, BodyGroup(holding.begin(), holding.end())};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  BodyGroup all = connected;
  all.insert(all.end(), holding.begin(), holding.end());
  std::map<std::size_t, std::size_t> place;
  std::vector<SupportedBody> bodies;
  for (const std::size_t body : all) {
    place[body] = bodies.size();
    bodies.push_back(bodies_[body]);
  }
  std::vector<SupportPoint> points;
  for (const std::size_t touch : used) {
    for (SupportPoint point : touches_[touch].points) {
      point.a = place[point.a];
      point.b = place[point.b];
      points.push_back(point);
    }
  }
  const std::vector<bool> out = outOfEquilibrium(bodies, points, gravity_, kFriction);
  BodyGroup falling;
  for (std::size_t i = 0; i < connected.size(); ++i) {
    if (out[i]) falling.push_back(connected[i]);
  }
  return known_.try_emplace(key, std::move(falling)).first->second;
}

std::vector<double> massesOf(const SequenceDemands& demands, const AssembledProduct& product) {
  std::vector<double> masses(product.bodies.size(), 0.0);
  for (const auto& [name, mass] : demands.masses) {
    for (const std::size_t body : bodiesNamed(product, name)) masses[body] = mass;
  }
  return masses;
}

std::vector<double> densitiesOf(const SequenceDemands& demands, const AssembledProduct& product) {
  std::vector<double> densities(product.bodies.size(), kUsualDensity);
  for (const auto& [name, density] : demands.densities) {
    for (const std::size_t body : bodiesNamed(product, name)) densities[body] = density;
  }
  return densities;
}

}  // namespace glissade
