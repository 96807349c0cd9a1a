#pragma once

#include <cstdint>

namespace glissade::test {

/// Makes operator new throw std::bad_alloc at chosen calls while it lives. A program that uses it links
/// failing_allocation.cpp, which replaces operator new. At most one lives at a time.
class FailingAllocation {
 public:
  enum class Where { ThisThread, OtherThreads };

  /// The calls with the numbers `first` (counted from now on, from 1) to `first + count - 1` fail.
  FailingAllocation(Where where, std::uint64_t first, std::uint64_t count = 1);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// Calls there so far.
  std::uint64_t calls() const;
};

}  // namespace glissade::test
