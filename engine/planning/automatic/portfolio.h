#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glissade {

/// How long the lives of a contender are, in units of its first one.
enum class Restart {
  Never,    ///< one life without end
  Luby,     ///< 1 1 2 1 1 2 4 ...: within a logarithm of the best fixed length, whatever the
            ///< distribution (M. Luby, A. Sinclair, D. Zuckerman, "Optimal speedup of Las Vegas
            ///< algorithms", 1993)
  Doubling  ///< 1 2 4 8 ...
};

/// The i-th term (from 1) of Luby's sequence.
std::uint64_t lubyTerm(std::uint64_t i);

/// One who wants machine time.
struct Contender {
  double share = 1.0;           ///< at first, of the work, relative to the others' shares; > 0
  std::uint64_t patience = 0;   ///< work without a path until the share is halved; 0: it stays
  std::uint64_t firstLife = 0;  ///< work until the first restart; 0: it ends its lives itself
  Restart restart = Restart::Never;
  std::uint64_t entry = 0;  ///< work of all before it first has a turn
};

/// Work of a contender's life, by its number from 1; the largest number where it has no end.
std::uint64_t lifeLength(const Contender& contender, std::uint64_t life);

/// Deals work out among contenders: the turn is the one's who has had least for his share. Patience that
/// is used up halves the share and doubles the patience, since what has failed so far is less likely to be
/// what the problem needs; whoever gets on has more than at first. A pure value: no clock, no randomness, so that the
/// same charges give the same turns.
class Portfolio {
 public:
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

  explicit Portfolio(const std::vector<Contender>& contenders);

  /// Whose turn it is, the first among equals; kNobody once all are retired.
  std::size_t next() const;
  /// Whose turns these are, at the same time: those that would be dealt one after the other if each cost
  /// `work`. Who has but one life has one of them; nobody enters early for them.
  std::vector<std::size_t> next(std::size_t turns, std::uint64_t work) const;
  /// What the turn has cost.
  void charge(std::size_t contender, std::uint64_t work);
  /// It has got on: its share is four times what it was at first, its patience the same as then.
  void encourage(std::size_t contender);
  /// No more turns.
  void retire(std::size_t contender);

  std::uint64_t work(std::size_t contender) const { return states_[contender].work; }

 private:
  struct State {
    Contender contender;
    double share;              ///< at present
    std::uint64_t lossAt;      ///< work at which it is halved next
    std::uint64_t patience;    ///< from there to the next but one
    std::uint64_t work = 0;    ///< in all lives
    double virtualWork = 0.0;  ///< work by share: the least has the turn
    bool entered = false;      ///< of one with an entry
    bool retired = false;
  };

  void enter(State& late);
  static void debit(State& state, std::uint64_t work);

  std::vector<State> states_;
  std::uint64_t total_ = 0;
};

}  // namespace glissade
