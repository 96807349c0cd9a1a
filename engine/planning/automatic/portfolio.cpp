#include "engine/planning/automatic/portfolio.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// What patience used up leaves of one's share, down to the least.
constexpr double kLossOfShare = 0.5;
constexpr double kLeastShare = 0.25;
/// Of the first share, for one that gets on.
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

Portfolio::Portfolio(std::vector<Contender> contenders) {
  for (const Contender& contender : contenders) {
    states_.push_back({contender, contender.share, contender.patience, contender.patience});
  }
}

std::size_t Portfolio::next() const {
  std::size_t best = kNobody;
  std::size_t first = kNobody;  // to enter, if nobody else is there
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const State& state = states_[i];
    if (state.retired) continue;
    if (state.contender.entry > elapsed_) {
      if (first == kNobody || state.contender.entry < states_[first].contender.entry) first = i;
    } else if (best == kNobody || state.virtualWork < states_[best].virtualWork) {
      best = i;
    }
  }
  return best != kNobody ? best : first;
}

std::vector<std::size_t> Portfolio::next(std::size_t turns) const {
  const std::size_t first = next();
  if (first == kNobody || turns < 2) return std::vector<std::size_t>(first == kNobody ? 0 : 1, first);
  std::vector<std::size_t> dealt;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (i == first || (!states_[i].retired && states_[i].contender.entry <= elapsed_)) dealt.push_back(i);
  }
  std::stable_sort(dealt.begin(), dealt.end(),
                   [&](std::size_t a, std::size_t b) { return states_[a].virtualWork < states_[b].virtualWork; });
  dealt.resize(std::min(dealt.size(), turns));
  return dealt;
}

/// Whoever comes late is dealt as much as the others from now on; what they have had is theirs.
void Portfolio::enter(State& late) {
  late.entered = true;
  double least = std::numeric_limits<double>::infinity();
  for (const State& state : states_) {
    const bool present = !state.retired && (state.contender.entry == 0 || state.entered) && &state != &late;
    if (present) least = std::min(least, state.virtualWork);
  }
  if (std::isfinite(least)) late.virtualWork = std::max(late.virtualWork, least);
}

void Portfolio::charge(const std::vector<Turn>& turns) {
  std::uint64_t longest = 0;
  for (const Turn& turn : turns) longest = std::max(longest, turn.work);
  elapsed_ += longest;
  for (State& state : states_) {
    if (!state.entered && state.contender.entry > 0 && state.contender.entry <= elapsed_) enter(state);
  }
  for (const Turn& turn : turns) debit(states_[turn.contender], turn.work);
}

void Portfolio::debit(State& state, std::uint64_t work) {
  state.work += work;
  state.lifeWork += work;
  state.virtualWork += static_cast<double>(work) / state.share;
  while (state.patience > 0 && state.work >= state.lossAt) {
    state.lossAt += state.patience;
    state.patience *= 2;
    const double least = std::min(kLeastShare, state.contender.share);
    state.share = std::max(least, kLossOfShare * state.share);
  }
}

void Portfolio::encourage(std::size_t contender) {
  State& state = states_[contender];
  state.share = kGain * state.contender.share;
  state.patience = state.contender.patience;
  state.lossAt = state.work + state.patience;
}

bool Portfolio::lifeIsOver(std::size_t contender) const {
  const State& state = states_[contender];
  std::uint64_t length = state.contender.firstLife;
  if (length == 0) return false;
  switch (state.contender.restart) {
    case Restart::Never: return false;
    case Restart::Luby: length *= lubyTerm(state.life); break;
    case Restart::Doubling: length <<= std::min<std::uint64_t>(state.life - 1, 40); break;
  }
  return state.lifeWork >= length;
}

void Portfolio::restart(std::size_t contender) {
  ++states_[contender].life;
  states_[contender].lifeWork = 0;
}

void Portfolio::retire(std::size_t contender) { states_[contender].retired = true; }

}  // namespace glissade
