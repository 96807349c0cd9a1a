#include "engine/sequence/product_fits.h"

#include <algorithm>
#include <cmath>

#include "engine/fits/fit_refusals.h"

namespace glissade {
namespace {

std::vector<Vector3> axesOf(const std::vector<Contact>& contacts) {
  constexpr double kAlike = 1.0 - 1e-6;
  std::vector<Vector3> axes;
  for (const Contact& contact : contacts) {
    if (!contact.axis) continue;
    const Vector3& axis = contact.axis->direction;
    const bool known =
        std::any_of(axes.begin(), axes.end(), [&](const Vector3& other) { return std::abs(other.dot(axis)) > kAlike; });
    if (!known) axes.push_back(axis);
  }
  return axes;
}

/// The thinned mesh of the pair; null: the body is whole.
const MeshPtr* thinnedOf(const std::vector<Fit>& fits, std::size_t obstacle, bool yields) {
  const auto found = std::find_if(fits.begin(), fits.end(), [&](const Fit& fit) {
    return fit.obstacle == obstacle && fit.yields == yields && fit.thinned;
  });
  return found == fits.end() ? nullptr : &found->thinned;
}

}  // namespace

ProductFits::ProductFits(const AssembledProduct& product, FitTablePtr table) : table_(std::move(table)) {
  for (const RigidBody& body : product.bodies) whole_.push_back(body.mesh);
  for (const ObjectFits& object : table_->objects()) axes_.push_back(glissade::axesOf(object.contacts));
  for (const PairFit& pair : table_->pairs()) contacts_.push_back(pair.contact);
  for (const evidence::SnapWord& snap : product.snaps) {
    const auto hook = product.find(snap.hook);
    const auto edge = product.find(snap.edge);
    if (!hook || !edge) continue;
    bentWays_[{*hook, *edge}] = snap.direction;
    bentWays_[{*edge, *hook}] = -snap.direction;
  }
}

Result<ProductFits> ProductFits::find(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch) {
  auto table = product.fits.on ? FitTable::find(product, team, watch) : FitTable::whole(product);
  if (!table) return table.error();
  return ProductFits(product, std::make_shared<const FitTable>(std::move(*table)));
}

std::vector<Fit> ProductFits::fitsOf(const BodyGroup& group, const BodySet& present) const {
  const BodySet others = without(present, group);
  std::vector<Fit> fits;
  for (const std::size_t body : group) {
    for (const Fit& fit : fitsOf(body)) {
      if (others[fit.obstacle]) fits.push_back(fit);
    }
  }
  return fits;
}

const MeshPtr& ProductFits::obstacleFor(std::size_t body, std::size_t other) const {
  const MeshPtr* thinned = thinnedOf(fitsOf(body), other, true);
  return thinned != nullptr ? *thinned : whole_[other];
}

const MeshPtr& ProductFits::meshAgainst(std::size_t body, std::size_t other) const {
  const MeshPtr* thinned = thinnedOf(fitsOf(body), other, false);
  return thinned != nullptr ? *thinned : whole_[body];
}

const Fit* ProductFits::clashOf(std::size_t body, std::size_t other) const {
  const std::vector<Fit>& clashes = table_->objects()[body].clashes;
  const auto found =
      std::find_if(clashes.begin(), clashes.end(), [&](const Fit& fit) { return fit.obstacle == other; });
  return found == clashes.end() ? nullptr : &*found;
}

const Fit* ProductFits::acceptedClashOf(std::size_t body, std::size_t other) const {
  const std::vector<Fit>& fits = fitsOf(body);
  const auto found = std::find_if(fits.begin(), fits.end(),
                                  [&](const Fit& fit) { return fit.obstacle == other && isByAcceptedClash(fit); });
  return found == fits.end() ? nullptr : &*found;
}

bool ProductFits::areCompared(std::size_t body, std::size_t other) const {
  return table_->notCompared().count(std::minmax(body, other)) == 0;
}

const FitThread* ProductFits::threadOf(std::size_t body, std::size_t other) const {
  for (const Fit& fit : fitsOf(body)) {
    if (fit.obstacle == other && fit.thread) return &*fit.thread;
  }
  return nullptr;
}

const Vector3* ProductFits::bentWay(std::size_t body, std::size_t other) const {
  const auto way = bentWays_.find({body, other});
  return way == bentWays_.end() ? nullptr : &way->second;
}

bool ProductFits::isHooked(const BodyGroup& group, const BodySet& present) const {
  const std::vector<std::size_t> others = bodiesIn(without(present, group));
  return std::any_of(group.begin(), group.end(), [&](std::size_t body) {
    return std::any_of(others.begin(), others.end(),
                       [&](std::size_t other) { return bentWay(body, other) != nullptr; });
  });
}

bool ProductFits::isInThread(const BodyGroup& group, const BodySet& present) const {
  const std::vector<Fit> fits = fitsOf(group, present);
  return std::any_of(fits.begin(), fits.end(), [](const Fit& fit) { return fit.thread.has_value(); });
}

}  // namespace glissade
