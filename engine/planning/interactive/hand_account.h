#pragma once

#include <cstdint>

namespace glissade {

/// What a hand may cost. A pure value: it counts work and steps, never seconds.
///
/// On a machine at full speed thousands of steps fall on each configuration that a hand shows (they are a twentieth of
/// the object's radius apart). There the hand is limited by work: a small share of all, and a credit for each
/// configuration. At the pace of the first paper a dozen steps fall on it. Steps are scarce there,
/// work is not, and alpha alone decides.
class HandAccount {
 public:
  static constexpr std::uint64_t kCredit = 2'000;  ///< for each configuration
  static constexpr double kShare = 0.02;

  struct Work {
    std::uint64_t all = 0;
    std::uint64_t hand = 0;  ///< the hand's turns, and the members' draws from its tube
  };

  /// Steps and work of a turn or a round.
  void charge(std::uint64_t steps, const Work& work) {
    work_.all += work.all;
    work_.hand += work.hand;
    sinceShown_ += steps;
  }
  /// So many configurations have been shown in all.
  void noteShown(std::uint64_t shown) {
    for (; shown_ < shown; ++shown_) {
      stepsPerShown_ += (static_cast<double>(sinceShown_) - stepsPerShown_) / kMemory;
      sinceShown_ = 0;
    }
  }
  bool stepsAreScarce() const { return stepsPerShown_ < kScarce && sinceShown_ < kMemory * kScarce; }
  bool covers() const {
    const double credit = static_cast<double>(kCredit) * static_cast<double>(shown_);
    return stepsAreScarce() || static_cast<double>(work_.hand) <= credit + kShare * static_cast<double>(work_.all);
  }
  const Work& work() const { return work_; }

 private:
  static constexpr double kScarce = 100.0;  ///< steps for a configuration
  static constexpr double kMemory = 10.0;   ///< configurations

  Work work_;
  std::uint64_t shown_ = 0;
  std::uint64_t sinceShown_ = 0;  ///< steps
  double stepsPerShown_ = kScarce;
};

}  // namespace glissade
