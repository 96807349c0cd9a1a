#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glissade {

/// Rule for the length of a contender's lives. The numbers are multiples of the first life.
enum class Restart {
  Never,    ///< one life without end
  Luby,     ///< 1 1 2 1 1 2 4 ...: within a logarithm of the best fixed length, whatever the
            ///< distribution (M. Luby, A. Sinclair, D. Zuckerman, "Optimal speedup of Las Vegas
            ///< algorithms", 1993)
  Doubling  ///< 1 2 4 8 ...
};

/// The i-th term (from 1) of Luby's sequence.
std::uint64_t lubyTerm(std::uint64_t i);

/// A planner that competes for machine time.
struct Contender {
  double share = 1.0;           ///< first share of the work, relative to the others' shares; > 0
  std::uint64_t patience = 0;   ///< work without a path until the share is halved; 0: the share stays
  std::uint64_t firstLife = 0;  ///< work until the first restart; 0: the contender ends its lives itself
  Restart restart = Restart::Never;
  std::uint64_t entry = 0;  ///< work of all contenders before its first turn
};

/// Length of a contender's life by its number (from 1), in work; the largest integer where it has no end.
std::uint64_t lifeLength(const Contender& contender, std::uint64_t life);

/// Deals work out among contenders: the next turn goes to the contender with the least work relative to its share. When
/// a contender's patience is used up, its share is halved and its patience doubled, since a planner that has failed so
/// far is less likely to solve the problem. A contender that makes progress gets more than its first share. A pure
/// value: no clock, no randomness, so that the same charges give the same turns.
class Portfolio {
 public:
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

  explicit Portfolio(const std::vector<Contender>& contenders);

  /// The contender that has the next turn, the first among equals; kNobody once all are retired.
  std::size_t next() const;
  /// The contenders of the next `turns` simultaneous turns: those that would get them one after the other if each turn
  /// cost `work`. A contender with a single life gets at most one of them. Only the first turn may let a contender
  /// enter early.
  std::vector<std::size_t> next(std::size_t turns, std::uint64_t work) const;
  /// Adds the cost of a turn to a contender.
  void charge(std::size_t contender, std::uint64_t work);
  /// A contender has made progress: its share becomes four times its first share, and its patience is reset.
  void reward(std::size_t contender);
  /// Ends the contender's turns.
  void retire(std::size_t contender);

  std::uint64_t work(std::size_t contender) const { return states_[contender].work; }

 private:
  struct State {
    Contender contender;
    double share;              ///< present share
    std::uint64_t lossAt;      ///< work at which the share is halved next
    std::uint64_t patience;    ///< work between that halving and the following one
    std::uint64_t work = 0;    ///< work in all lives
    double virtualWork = 0.0;  ///< work divided by share; the contender with the least has the next turn
    bool entered = false;      ///< a contender with an entry has entered
    bool retired = false;
  };

  void enter(State& late);
  static void debit(State& state, std::uint64_t work);

  std::vector<State> states_;
  std::uint64_t total_ = 0;
};

}  // namespace glissade
