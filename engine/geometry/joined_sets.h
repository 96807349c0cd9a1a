#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace glissade {

/// The numbers from 0 to a count, which are joined to sets (union-find with halved ways).
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0U); }

  /// The number that stands for the set.
  std::uint32_t of(std::uint32_t one) {
    while (above_[one] != one) one = above_[one] = above_[above_[one]];
    return one;
  }
  /// The set of both numbers has the number of the other one.
  void join(std::uint32_t one, std::uint32_t other) { above_[of(one)] = of(other); }

  /// of(), for each number.
  std::vector<std::uint32_t> all() && {
    for (std::uint32_t& each : above_) each = of(each);
    return std::move(above_);
  }

  /// The sets of two numbers or more, each ascending, ordered by their first number.
  std::vector<std::vector<std::size_t>> several() && {
    std::vector<std::vector<std::size_t>> members(above_.size());
    for (std::uint32_t each = 0; each < above_.size(); ++each) members[of(each)].push_back(each);
    std::erase_if(members, [](const std::vector<std::size_t>& set) { return set.size() < 2; });
    std::sort(members.begin(), members.end());
    return members;
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace glissade
