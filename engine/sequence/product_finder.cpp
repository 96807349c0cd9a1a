#include "engine/sequence/product_finder.h"

#include <algorithm>

#include "engine/fits/joint_edits.h"
#include "engine/fits/joint_finder.h"
#include "engine/sequence/joint_rules.h"

namespace glissade {
namespace {

/// Tables with and without the bends of joints, or with a person's last edit and before it.
constexpr std::size_t kMostRemembered = 2;

template <class Known>
void remember(Known known, std::deque<Known>& all) {
  all.push_front(std::move(known));
  if (all.size() > kMostRemembered) all.pop_back();
}

/// Whether the bodies are the same. Joints do not depend on edits of fits, and on no bend.
bool haveSameBodies(AssembledProduct one, const AssembledProduct& other) {
  one.fits = other.fits;
  one.snaps = other.snaps;
  return isSameProduct(one, other);
}

}  // namespace

Result<FitTablePtr> ProductFinder::fits(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch,
                                        const std::optional<ContactLimits>& limits,
                                        const std::optional<FitDeadlines>& deadlines) {
  const std::lock_guard lock(fitsMutex_);
  const auto known = std::find_if(fits_.begin(), fits_.end(), [&](const KnownFits& each) {
    return each.limits == limits && isSameProduct(each.product, product);
  });
  if (known != fits_.end()) return known->table;
  auto table = limits ? found(product, *limits, team, watch, deadlines) : FitTable::whole(product);
  if (!table) return table.error();
  auto shared = std::make_shared<const FitTable>(std::move(*table));
  if (shared->notCompared().empty()) remember({product, limits, shared}, fits_);
  return shared;
}

Result<FitTable> ProductFinder::found(const AssembledProduct& product, const ContactLimits& limits, ThreadTeam& team,
                                      const WorkWatch& watch, const std::optional<FitDeadlines>& deadlines) {
  if (!store_) return FitTable::find(product, team, watch, limits, deadlines);
  const std::string key = store_->keyOf(product, limits);
  if (auto kept = store_->find(key)) return FitTable::of(product, std::move(*kept));
  auto table = FitTable::find(product, team, watch, limits, deadlines);
  if (table && table->notCompared().empty()) store_->keep(key, table->objects());
  return table;
}

JointsPtr ProductFinder::joints(const AssembledProduct& product, const std::vector<std::string>& classes,
                                const StopToken& stop) {
  const std::lock_guard lock(jointsMutex_);
  const auto known = std::find_if(joints_.begin(), joints_.end(), [&](const KnownJoints& each) {
    return each.classes == classes && haveSameBodies(each.product, product);
  });
  if (known != joints_.end()) return known->joints;
  auto joints = std::make_shared<const Joints>(findJoints(product, stop, classes));
  if (stop.stopRequested()) return nullptr;
  remember({product, classes, std::move(joints)}, joints_);
  return joints_.front().joints;
}

Result<ProductFindings> ProductFinder::findings(const AssembledProduct& product,
                                                const std::vector<std::string>& classes, const SequenceDemands& demands,
                                                ThreadTeam& team, const WorkWatch& watch,
                                                const std::optional<FitDeadlines>& deadlines) {
  Joints counting;
  if (demands.jointUse != JointUse::Off) {
    // After a stop there are no joints, because a person's edit may be about a joint that was not found.
    const JointsPtr found = joints(product, classes, watch.stop);
    auto joints = found ? applied(*found, demands.joints, product) : Result<Joints>(Joints());
    if (!joints) return joints.error();
    counting = std::move(*joints);
  }
  AssembledProduct bent = product;
  bent.snaps = bendsOf(countingJoints(counting, demands.jointUse), product);
  const auto table =
      fits(bent, team, watch, product.fits.on ? std::make_optional<ContactLimits>() : std::nullopt, deadlines);
  if (!table) return table.error();
  return ProductFindings{std::move(counting), ProductFits(bent, *table)};
}

}  // namespace glissade
