#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glissade {

/// The median, over steps, of a whole number from 0 to a small maximum. Its size does not grow.
class StepMedian {
 public:
  explicit StepMedian(std::size_t maximum) : steps_(maximum + 1, 0) {}

  /// One more step with this value. Precondition: at most the maximum.
  void add(std::size_t value) {
    ++steps_[value];
    ++total_;
  }
  /// The lower one of two in the middle; 0 where nothing was added.
  std::size_t value() const {
    std::size_t value = 0;
    for (std::uint64_t below = steps_[0]; 2 * below < total_; below += steps_[value]) ++value;
    return value;
  }

 private:
  std::vector<std::uint64_t> steps_;  ///< by value
  std::uint64_t total_ = 0;
};

}  // namespace glissade
