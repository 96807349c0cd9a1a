#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>

namespace glissade {

/// Maps all pages of memory that is about to be written at once, which takes a tenth of the time of one page after the
/// other. Does nothing for small memory, or where the system does not permit it.
inline void fillPages(void* memory, std::size_t bytes) {
#ifdef MADV_POPULATE_WRITE
  constexpr std::size_t kFewest = 1U << 20;
  if (bytes < kFewest) return;
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  const std::size_t pages = (bytes - before) / page;
  ::madvise(static_cast<std::byte*>(memory) + before, pages * page, MADV_POPULATE_WRITE);
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

/// reserve() for a container that will be filled to that size.
template <class Container>
void reserveFilled(Container& container, std::size_t size) {
  const std::size_t before = container.capacity();
  container.reserve(size);
  if (container.capacity() > before) fillPages(container.data(), size * sizeof(typename Container::value_type));
}

}  // namespace glissade
