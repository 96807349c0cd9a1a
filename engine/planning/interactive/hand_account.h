#pragma once

#include <cstdint>

namespace glissade {

/// What a hand may cost: a small share of all work, and a credit at the beginning and for each configuration that it
/// shows. A hand shows some ten of these a second (they are a twentieth of the object's radius apart), in which a
/// machine of today does some ten million units; so all of it stays about a tenth of the work. A pure value: it counts
/// work, never seconds.
class HandAccount {
 public:
  static constexpr std::uint64_t kFirstCredit = 500'000;
  static constexpr std::uint64_t kCredit = 60'000;  ///< for each configuration
  static constexpr double kShare = 0.03;

  void charge(std::uint64_t all, std::uint64_t hand) {
    all_ += all;
    hand_ += hand;
  }
  void credit(std::uint64_t shown) { credit_ = kFirstCredit + kCredit * shown; }
  bool covers() const {
    return static_cast<double>(hand_) <= static_cast<double>(credit_) + kShare * static_cast<double>(all_);
  }
  std::uint64_t all() const { return all_; }
  std::uint64_t hand() const { return hand_; }

 private:
  std::uint64_t all_ = 0;  ///< the hand's with it
  std::uint64_t hand_ = 0;
  std::uint64_t credit_ = kFirstCredit;
};

}  // namespace glissade
