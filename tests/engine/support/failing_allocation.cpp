#include "tests/engine/support/failing_allocation.h"

#include <pthread.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> armed{false};
std::atomic<bool> inThisThread{false};
std::atomic<pthread_t> owner{};
std::atomic<std::uint64_t> called{0};
std::atomic<std::uint64_t> firstFailure{0};
std::atomic<std::uint64_t> failures{0};

bool fails() {
  if (!armed || (owner == pthread_self()) != inThisThread) return false;
  const std::uint64_t number = ++called;
  return number >= firstFailure && number - firstFailure < failures;
}

void* allocate(std::size_t size) {
  if (fails()) throw std::bad_alloc();
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace glissade::test {

FailingAllocation::FailingAllocation(Where where, std::uint64_t first, std::uint64_t count) {
  owner = pthread_self();
  inThisThread = where == Where::ThisThread;
  called = 0;
  firstFailure = first;
  failures = count;
  armed = true;
}

FailingAllocation::~FailingAllocation() { armed = false; }

std::uint64_t FailingAllocation::calls() const { return called; }

}  // namespace glissade::test
