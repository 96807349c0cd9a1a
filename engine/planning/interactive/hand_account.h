#pragma once

#include <cstdint>

namespace glissade {

/// Limits the work that is spent on a hand. A pure value: it counts work and steps, never seconds.
///
/// On a machine at full speed thousands of steps pass for each configuration that a hand shows (they are a twentieth of
/// the object's radius apart). The hand is then limited by work: a small share of all, and a credit for each
/// configuration. At the pace of paper 1 a dozen steps pass for each configuration. Steps are then scarce and work is
/// not, so that alpha alone decides.
class HandAccount {
 public:
  static constexpr std::uint64_t kCredit = 2'000;  ///< work for each configuration
  static constexpr double kShare = 0.02;

  struct Work {
    std::uint64_t all = 0;
    std::uint64_t hand = 0;  ///< work of the hand's turns, and of the members' draws from its tube
  };

  /// Adds the steps and the work of a turn or a round.
  void charge(std::uint64_t steps, const Work& work) {
    work_.all += work.all;
    work_.hand += work.hand;
    sinceShown_ += steps;
  }
  /// Sets the number of configurations that have been shown in all.
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
  static constexpr double kScarce = 100.0;  ///< steps per configuration below which steps are scarce
  static constexpr double kMemory = 10.0;   ///< number of configurations over which the mean is taken

  Work work_;
  std::uint64_t shown_ = 0;
  std::uint64_t sinceShown_ = 0;  ///< steps since the last shown configuration
  double stepsPerShown_ = kScarce;
};

}  // namespace glissade
