#include "engine/sequence/accepted_clashes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/fits/fit_refusals.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {
namespace {

/// Accepted clashes, each pair once.
class ClashesByPair {
 public:
  void add(const StepMotion& motion) {
    for (const Allowance& allowance : motion.allowances) {
      if (!isByAcceptedClash(allowance)) continue;
      const BodyId& moving = allowance.moving.empty() ? motion.body : allowance.moving;
      const auto pair = std::minmax(moving, allowance.body);
      AcceptedClash& clash = byPair_.try_emplace(pair, AcceptedClash{pair.first, pair.second}).first->second;
      clash.depth = std::max(clash.depth, allowance.overlap);
      if (allowance.hollow) clash.cut = allowance.yields ? allowance.body : moving;
    }
  }

  std::vector<AcceptedClash> all() const {
    std::vector<AcceptedClash> clashes;
    for (const auto& [pair, clash] : byPair_) clashes.push_back(clash);
    return clashes;
  }

 private:
  std::map<std::pair<BodyId, BodyId>, AcceptedClash> byPair_;
};

}  // namespace

std::vector<AcceptedClash> acceptedClashesOf(const StepMotion& motion) {
  ClashesByPair clashes;
  clashes.add(motion);
  return clashes.all();
}

std::vector<AcceptedClash> acceptedClashesOf(const AssemblyPlan& plan) {
  ClashesByPair clashes;
  for (const StepMotion* motion : allMotionsOf(plan)) clashes.add(*motion);
  return clashes.all();
}

Message inWords(const AcceptedClash& clash, const AssembledProduct& product) {
  const Message pair{GLISSADE_TEXT("'%1' and '%2', %3"),
                     {product.body(clash.a).shown(), product.body(clash.b).shown(), Depth{clash.depth}}};
  if (clash.cut.empty()) return {GLISSADE_TEXT("%1: both are taken thinner"), {pair}};
  return {GLISSADE_TEXT("%1: '%2' is cut"), {pair, product.body(clash.cut).shown()}};
}

}  // namespace glissade
