#include "engine/fits/fit_table.h"

#include <algorithm>
#include <tuple>

#include "engine/base/part_count.h"
#include "engine/fits/giving_way.h"

namespace glissade {
namespace {

PairWay wayOf(const ObjectFits& object, std::size_t obstacle) {
  PairWay way;
  for (const Fit& fit : object.allowed) {
    if (fit.obstacle == obstacle) way.taken.push_back(fit);
  }
  for (const Fit& clash : object.clashes) {
    if (clash.obstacle == obstacle) way.refused = clash.refused;
  }
  return way;
}

const Diagnostic* warningOf(const ObjectFits& object, std::size_t obstacle) {
  for (std::size_t i = 0; i < object.clashes.size(); ++i) {
    if (object.clashes[i].obstacle == obstacle) return &object.warnings[i];
  }
  return nullptr;
}

/// A pair through which no motion passes is a clash, unless it is a thread or a press fit.
void callClash(PairFit& pair) {
  ContactKind& kind = pair.contact.kind;
  if (pair.status() != FitStatus::Clash || kind == ContactKind::Thread || kind == ContactKind::Press) return;
  kind = ContactKind::Clash;
  pair.contact.isPlainOverlap = false;
}

/// Measures each pair once, the pairs with the most triangles first. Bodies that are asked about at the same time share
/// a pair, so that one would wait for the other.
void measurePairs(const AssembledProduct& product, const std::vector<Contact>& contacts, evidence::PlacedBodies& placed,
                  ThreadTeam& team, const WorkWatch& watch) {
  const auto trianglesOf = [&](const Contact& contact) {
    return product.bodies[contact.a].mesh->triangles.size() + product.bodies[contact.b].mesh->triangles.size();
  };
  std::vector<const Contact*> pairs;
  for (const Contact& contact : contacts) pairs.push_back(&contact);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const Contact* one, const Contact* other) { return trianglesOf(*one) > trianglesOf(*other); });
  PartCount done(watch, pairs.size());
  team.run(pairs.size(), [&](std::size_t i) {
    if (watch.stop.stopRequested()) return;
    const evidence::Body a = product.measured(pairs[i]->a);
    const evidence::Body b = product.measured(pairs[i]->b);
    placed.measure({a, a.X_WB}, {b, b.X_WB}, watch.stop);
    done.add();
  });
}

}  // namespace

double PairWay::allowance() const {
  double most = 0.0;
  for (const Fit& fit : taken) most = std::max(most, fit.allowance);
  return most;
}

FitStatus PairFit::status() const {
  if (!way().refused.empty()) return FitStatus::Clash;
  if (contact.kind == ContactKind::Clearance) return FitStatus::Clear;
  return contact.kind == ContactKind::Clash ? FitStatus::Accepted : FitStatus::Allowed;
}

std::vector<BodyId> PairFit::thinner() const {
  std::vector<BodyId> ids;
  for (const Fit& fit : way().taken) {
    if (fit.thinned) ids.push_back(fit.yields == givesWayFirstIsA ? b : a);
  }
  return ids;
}

Result<FitTable> FitTable::find(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch,
                                const ContactLimits& limits) {
  constexpr double kContactsShare = 0.5;  // shares of the work
  constexpr double kPairsShare = 0.9;
  const StopToken& stop = watch.stop;
  const WorkWatch forContacts = watch.part(0.0, kContactsShare);
  const std::vector<Contact> contacts = findContacts(contactBodiesOf(product), limits, forContacts, team).contacts;
  FitTools tools;
  // Each body that is taken thinner is asked about once or twice.
  tools.prepared = std::make_shared<PreparedBodies>(product.bodies, BoxCare::ForFewQueries);
  measurePairs(product, contacts, tools.placed, team, watch.part(kContactsShare, kPairsShare));
  std::vector<Result<ObjectFits>> objects(product.bodies.size(), ObjectFits());
  PartCount done(watch.part(kPairsShare, 1.0), objects.size());
  team.run(objects.size(), [&](std::size_t body) {
    if (!stop.stopRequested()) {
      objects[body] = findObjectFits({product, body, {}, &contacts, limits, nullptr, &tools}, stop);
      done.add();
    }
  });
  if (stop.stopRequested()) {
    return Diagnostic{ErrorKind::Interrupted, "", "", GLISSADE_TEXT("was stopped while fits were searched"),
                      GLISSADE_TEXT("Start again.")};
  }
  std::vector<ObjectFits> found;
  for (Result<ObjectFits>& object : objects) {
    if (!object) return object.error();
    found.push_back(std::move(*object));
  }
  return FitTable(product, std::move(found));
}

FitTable FitTable::of(const AssembledProduct& product, std::vector<ObjectFits> objects) {
  return {product, std::move(objects)};
}

FitTable FitTable::whole(const AssembledProduct& product) {
  return {product, std::vector<ObjectFits>(product.bodies.size())};
}

FitTable::FitTable(const AssembledProduct& product, std::vector<ObjectFits> objects)
    : objects_(std::move(objects)), prepared_(std::make_shared<PreparedBodies>(product.bodies)) {
  addPairs(product);
}

void FitTable::addPairs(const AssembledProduct& product) {
  for (std::size_t body = 0; body < objects_.size(); ++body) {
    for (const Contact& contact : objects_[body].contacts) {
      if (contact.a > contact.b) continue;
      const RigidBody& a = product.bodies[contact.a];
      const RigidBody& b = product.bodies[contact.b];
      pairs_.push_back({a.id,
                        b.id,
                        {a.shown(), b.shown()},
                        contact,
                        {wayOf(objects_[contact.a], contact.b), wayOf(objects_[contact.b], contact.a)},
                        givesWayFirst(a, b)});
      callClash(pairs_.back());
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const PairFit& one, const PairFit& other) {
    return std::tie(one.contact.a, one.contact.b) < std::tie(other.contact.a, other.contact.b);
  });
  std::vector<PairFit> unwarned;
  for (const PairFit& pair : pairs_) {
    const Diagnostic* ofA = warningOf(objects_[pair.contact.a], pair.contact.b);
    const Diagnostic* ofB = warningOf(objects_[pair.contact.b], pair.contact.a);
    if (const Diagnostic* warning = ofA != nullptr ? ofA : ofB) {
      warnings_.push_back(*warning);
    } else {
      unwarned.push_back(pair);
    }
  }
  const Warnings overlaps = warningsOfPlainOverlaps(unwarned);
  warnings_.insert(warnings_.end(), overlaps.begin(), overlaps.end());
}

Warnings warningsOfPlainOverlaps(const std::vector<PairFit>& fits) {
  constexpr std::size_t kListed = 8;
  Warnings warnings;
  std::size_t more = 0;
  for (const PairFit& fit : fits) {
    if (!fit.contact.isPlainOverlap) continue;
    if (warnings.size() == kListed) {
      ++more;
      continue;
    }
    warnings.push_back(
        {ErrorKind::InCollision,
         "",
         {GLISSADE_TEXT("'%1' and '%2'"), {fit.shown[0], fit.shown[1]}},
         {GLISSADE_TEXT("overlap by %1 without being a fit, a thread or a press"), {Depth{fit.contact.overlap}}},
         GLISSADE_TEXT("Mend the parts, or say what kind of fit they are.")});
  }
  if (more > 0) {
    warnings.push_back({ErrorKind::InCollision,
                        "",
                        "",
                        {GLISSADE_TEXT("%1 more {1|pair overlaps|pairs overlap} in the same way"), {more}},
                        GLISSADE_TEXT("See 'glissade-cli fits' for all of them.")});
  }
  return warnings;
}

std::map<std::string, int> countsByKind(const std::vector<PairFit>& fits) {
  std::map<std::string, int> counts;
  for (const PairFit& fit : fits) ++counts[kContactKindNames.of(fit.contact.kind)];
  return counts;
}

}  // namespace glissade
