// A library that is preloaded into a program and counts the program's requests to the heap. The counts are two numbers
// of 64 bits, allocations and largest sum of live bytes, in the file that GLISSADE_HEAP_REPORT names. The file is
// mapped before main() begins, so that counting continues after a process has given up its rights.
#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

// The heap functions of glibc under the names for programs with their own malloc.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}
// NOLINTEND(bugprone-reserved-identifier)

namespace {

struct Counts {
  std::atomic<std::uint64_t> allocations{0};
  std::atomic<std::uint64_t> peak{0};
};

Counts beforeStart;
std::atomic<Counts*> counts{&beforeStart};
std::atomic<std::uint64_t> live{0};

void* taken(void* block) {
  if (block == nullptr) return nullptr;
  Counts& into = *counts.load(std::memory_order_relaxed);
  into.allocations.fetch_add(1, std::memory_order_relaxed);
  const std::size_t size = malloc_usable_size(block);
  const std::uint64_t now = live.fetch_add(size, std::memory_order_relaxed) + size;
  std::uint64_t before = into.peak.load(std::memory_order_relaxed);
  while (now > before && !into.peak.compare_exchange_weak(before, now, std::memory_order_relaxed)) {
  }
  return block;
}

__attribute__((constructor)) void mapReport() {
  const char* file = std::getenv("GLISSADE_HEAP_REPORT");
  if (file == nullptr) return;
  const int report = ::open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (report < 0 || ::ftruncate(report, sizeof(Counts)) != 0) return;
  void* mapped = ::mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED, report, 0);
  ::close(report);
  if (mapped != MAP_FAILED) counts = static_cast<Counts*>(mapped);
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return taken(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) { return taken(__libc_calloc(count, size)); }
void* memalign(std::size_t alignment, std::size_t size) { return taken(__libc_memalign(alignment, size)); }
void* aligned_alloc(std::size_t alignment, std::size_t size) { return taken(__libc_memalign(alignment, size)); }

void* realloc(void* block, std::size_t size) {
  const std::size_t before = block == nullptr ? 0 : malloc_usable_size(block);
  void* moved = __libc_realloc(block, size);
  if (moved == nullptr && size > 0) return nullptr;
  live.fetch_sub(before, std::memory_order_relaxed);
  return taken(moved);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = taken(__libc_memalign(alignment, size));
  return *block == nullptr ? ENOMEM : 0;
}

void free(void* block) {
  if (block == nullptr) return;
  live.fetch_sub(malloc_usable_size(block), std::memory_order_relaxed);
  __libc_free(block);
}

}  // extern "C"
