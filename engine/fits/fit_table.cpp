#include "engine/fits/fit_table.h"

#include <algorithm>
#include <numeric>
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
/// a pair, so that one would wait for the other. With a deadline the smallest pairs come first, and the pairs that are
/// left are not compared.
void measurePairs(const AssembledProduct& product, evidence::PlacedBodies& placed, ThreadTeam& team,
                  const WorkWatch& watch, const std::optional<FitDeadlines>& deadlines, ContactReport& report) {
  const auto trianglesOf = [&](const Contact& contact) {
    return product.bodies[contact.a].mesh->triangles.size() + product.bodies[contact.b].mesh->triangles.size();
  };
  std::vector<std::size_t> order(report.contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    const std::size_t ofOne = trianglesOf(report.contacts[one]);
    const std::size_t ofOther = trianglesOf(report.contacts[other]);
    return deadlines ? ofOne < ofOther : ofOne > ofOther;
  });
  std::vector<char> isLeft(order.size(), 0);
  PartCount done(watch, order.size());
  team.run(order.size(), [&](std::size_t i) {
    if (watch.stop.stopRequested()) return;
    const Contact& contact = report.contacts[order[i]];
    const evidence::Body a = product.measured(contact.a);
    const evidence::Body b = product.measured(contact.b);
    isLeft[order[i]] = deadlines && deadlines->pairs.stopRequested();
    if (isLeft[order[i]] == 0) placed.measure({a, a.X_WB}, {b, b.X_WB}, watch.stop);
    done.add();
  });
  std::vector<Contact> measured;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (isLeft[i] == 0) measured.push_back(report.contacts[i]);
    if (isLeft[i] != 0) report.notCompared.emplace_back(report.contacts[i].a, report.contacts[i].b);
  }
  report.contacts = std::move(measured);
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
                                const ContactLimits& limits, const std::optional<FitDeadlines>& deadlines) {
  constexpr double kContactsShare = 0.5;  // shares of the work
  constexpr double kPairsShare = 0.9;
  const StopToken& stop = watch.stop;
  const WorkWatch forContacts = watch.part(0.0, kContactsShare);
  const std::optional<StopToken> enough = deadlines ? std::optional(deadlines->contacts) : std::nullopt;
  ContactReport report = findContacts(contactBodiesOf(product), limits, forContacts, team, enough);
  FitTools tools;
  // Each body that is taken thinner is asked about once or twice.
  tools.prepared = std::make_shared<PreparedBodies>(product.bodies, BoxCare::ForFewQueries);
  measurePairs(product, tools.placed, team, watch.part(kContactsShare, kPairsShare), deadlines, report);
  std::vector<Result<ObjectFits>> objects(product.bodies.size(), ObjectFits());
  PartCount done(watch.part(kPairsShare, 1.0), objects.size());
  team.run(objects.size(), [&](std::size_t body) {
    if (!stop.stopRequested()) {
      objects[body] = findObjectFits({product, body, {}, &report.contacts, limits, nullptr, &tools}, stop);
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
  FitTable table(product, std::move(found));
  table.notCompared_.insert(report.notCompared.begin(), report.notCompared.end());
  return table;
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
