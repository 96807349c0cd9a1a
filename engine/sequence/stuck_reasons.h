#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// A group whose removal was tried and refused.
struct Refusal {
  std::vector<std::size_t> blockedBy;
  std::size_t afterSteps = 0;  ///< number of steps that had been carried out before the trial
};
using Refusals = std::map<BodyGroup, std::map<int, Refusal>>;  ///< refusals of each group by effort

/// The body with those that leave together with it by a person's demand or a joint; itself alone if there are none.
BodyGroup unitOf(std::size_t body, const OrderRules& rules);

/// Explains, for people, why bodies did not leave. Refers to all arguments. `stop`: of the search; a search that it has
/// stopped has not tried every motion.
class StuckReasons {
 public:
  StuckReasons(const SequenceQuestion& question, const BodySet& present, const Refusals& refusals,
               const StopToken& stop)
      : question_(question), present_(present), refusals_(refusals), stop_(stop) {}

  /// `holding`: bodies that are demanded to leave before it; `blocking`: bodies that block its motion.
  Message of(std::size_t body, const std::vector<std::size_t>& holding, const std::set<std::size_t>& blocking) const;

 private:
  const std::string& name(std::size_t body) const { return question_.product.bodies[body].shown(); }
  Message withoutAdvice(std::size_t body, const std::vector<std::size_t>& holding,
                        const std::set<std::size_t>& blocking) const;
  Message aboutSolids(std::size_t body) const;
  Message ofJoints(const BodyGroup& unit) const;
  Message ofSnaps(const BodyGroup& unit) const;
  Message ofBend(const Joint& snap, bool hasHook) const;
  Message asSnap(const BodyGroup& unit, std::size_t other) const;
  Message ofTurns(const BodyGroup& unit) const;
  Message ofClashes(const BodyGroup& unit) const;
  Message ofRefusedClash(std::size_t body, const Fit& clash) const;
  Message ofCuts(const BodyGroup& unit, const std::set<std::size_t>& blocking) const;
  bool isCaged(const BodyGroup& unit, const std::set<std::size_t>& blocking) const;
  bool isBlockedBy(const BodyGroup& unit, const BodyGroup& others) const;
  Message ofStuckBlocker(const BodyGroup& unit) const;
  bool isBlockedDirectlyBy(const BodyGroup& unit, std::size_t other) const;
  Message ofOneAlone(const BodyGroup& unit, const std::set<std::size_t>& blocking) const;
  bool blocksAlone(const BodyGroup& unit, std::size_t other) const;
  bool holdEachOther(std::size_t body, std::size_t other) const;

  const SequenceQuestion& question_;
  const BodySet& present_;
  const Refusals& refusals_;
  const StopToken& stop_;
};

}  // namespace glissade
