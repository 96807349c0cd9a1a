#pragma once

#include <cstdint>

namespace glissade::import_protocol {

// What the importing process writes to its standard output: one header, then for kMesh
// `vertices` x 3 floats, 3 floats of vertex mean, `triangles` x 3 indices; for kError `vertices`
// bytes of text.
inline constexpr std::uint32_t kMagic = 0x474c494d;
inline constexpr std::uint32_t kMesh = 1;
inline constexpr std::uint32_t kError = 2;

struct Header {
  std::uint32_t magic = kMagic;
  std::uint32_t kind = kError;
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
};

/// Address space of the importing process, bytes.
inline constexpr std::uint64_t kMostMemory = 450ULL << 20;
/// Processor time of the importing process, seconds.
inline constexpr std::uint64_t kMostSeconds = 4;
/// Largest mesh file, bytes.
inline constexpr std::uint64_t kMostBytes = 100ULL << 20;
/// Largest number of vertices or triangles taken over.
inline constexpr std::uint32_t kMostElements = 8U << 20;

}  // namespace glissade::import_protocol
