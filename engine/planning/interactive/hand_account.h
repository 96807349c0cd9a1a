#pragma once

#include <cstdint>

namespace glissade {

/// What a hand may cost: a tenth of all work and what it is credited with at the beginning. A pure value: it counts
/// work, never seconds.
class HandAccount {
 public:
  /// Work that a hand may cost before anything else has been done: some tenths of a second.
  static constexpr std::uint64_t kCredit = 1'500'000;
  static constexpr double kShare = 0.07;

  void charge(std::uint64_t all, std::uint64_t hand) {
    all_ += all;
    hand_ += hand;
  }
  bool covers() const { return static_cast<double>(hand_) <= kCredit + kShare * static_cast<double>(all_); }
  std::uint64_t all() const { return all_; }
  std::uint64_t hand() const { return hand_; }

 private:
  std::uint64_t all_ = 0;  ///< the hand's with it
  std::uint64_t hand_ = 0;
};

}  // namespace glissade
