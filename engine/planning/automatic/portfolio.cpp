#include "engine/planning/automatic/portfolio.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// Factor of the share after each use of the patience, and the smallest share.
constexpr double kLossOfShare = 0.5;
constexpr double kLeastShare = 0.25;
/// Factor of the first share for a contender that makes progress.
constexpr double kGain = 4.0;

}  // namespace

std::uint64_t lubyTerm(std::uint64_t i) {
  for (;;) {
    std::uint64_t power = 1;  // the least power of two above i
    while (power <= i) power <<= 1U;
    if (power == i + 1) return power >> 1U;
    i -= (power >> 1U) - 1;
  }
}

std::uint64_t lifeLength(const Contender& contender, std::uint64_t life) {
  constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();
  if (contender.firstLife == 0) return kNoEnd;
  switch (contender.restart) {
    case Restart::Never: break;
    case Restart::Luby: return contender.firstLife * lubyTerm(life);
    case Restart::Doubling: return contender.firstLife << std::min<std::uint64_t>(life - 1, 40);
  }
  return kNoEnd;
}

Portfolio::Portfolio(const std::vector<Contender>& contenders) {
  for (const Contender& contender : contenders) {
    states_.push_back({contender, contender.share, contender.patience, contender.patience});
  }
}

std::size_t Portfolio::next() const {
  std::size_t best = kNobody;
  std::size_t first = kNobody;  // contender to enter if no other is present
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const State& state = states_[i];
    if (state.retired) continue;
    if (state.contender.entry > total_) {
      if (first == kNobody || state.contender.entry < states_[first].contender.entry) first = i;
    } else if (best == kNobody || state.virtualWork < states_[best].virtualWork) {
      best = i;
    }
  }
  return best != kNobody ? best : first;
}

std::vector<std::size_t> Portfolio::next(std::size_t turns, std::uint64_t work) const {
  std::vector<std::size_t> dealt;
  if (turns == 1) {  // a single slot deals at every step and needs no look ahead
    if (const std::size_t who = next(); who != kNobody) dealt.push_back(who);
    return dealt;
  }
  Portfolio trial = *this;
  while (dealt.size() < turns) {
    const std::size_t who = trial.next();
    if (who == kNobody) break;
    State& state = trial.states_[who];
    if (!dealt.empty() && state.contender.entry > total_) break;
    dealt.push_back(who);
    if (state.contender.restart == Restart::Never) state.retired = true;
    debit(state, work);
  }
  return dealt;
}

/// A contender that enters late continues from the least work by share of the others, so that it does not catch up on
/// the work that it missed.
void Portfolio::enter(State& late) {
  late.entered = true;
  double least = std::numeric_limits<double>::infinity();
  for (const State& state : states_) {
    const bool present = !state.retired && (state.contender.entry == 0 || state.entered) && &state != &late;
    if (present) least = std::min(least, state.virtualWork);
  }
  if (std::isfinite(least)) late.virtualWork = std::max(late.virtualWork, least);
}

void Portfolio::charge(std::size_t contender, std::uint64_t work) {
  total_ += work;
  for (State& state : states_) {
    if (!state.entered && state.contender.entry > 0 && state.contender.entry <= total_) enter(state);
  }
  debit(states_[contender], work);
}

void Portfolio::debit(State& state, std::uint64_t work) {
  state.work += work;
  state.virtualWork += static_cast<double>(work) / state.share;
  while (state.patience > 0 && state.work >= state.lossAt) {
    state.lossAt += state.patience;
    state.patience *= 2;
    const double least = std::min(kLeastShare, state.contender.share);
    state.share = std::max(least, kLossOfShare * state.share);
  }
}

void Portfolio::reward(std::size_t contender) {
  State& state = states_[contender];
  state.share = kGain * state.contender.share;
  state.patience = state.contender.patience;
  state.lossAt = state.work + state.patience;
}

void Portfolio::retire(std::size_t contender) { states_[contender].retired = true; }

}  // namespace glissade
