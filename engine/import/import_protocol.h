#pragma once

#include <chrono>
#include <cstdint>

namespace glissade::import_protocol {

// What an importing process writes to its standard output: one header, then
// for kMesh `vertices` x 3 floats, 3 floats of vertex mean, `triangles` x 3 indices;
// for kAssembly an AssemblyCounts; every shape as a Shape, its vertices x 3 doubles (millimetres), its
// triangles x 3 indices; every part as a Part, the bytes of its path (UTF-8);
// for kError `vertices` bytes of text.
inline constexpr std::uint32_t kMagic = 0x474c494d;
inline constexpr std::uint32_t kMesh = 1;
inline constexpr std::uint32_t kError = 2;
inline constexpr std::uint32_t kAssembly = 3;

struct Header {
  std::uint32_t magic = kMagic;
  std::uint32_t kind = kError;
  std::uint32_t vertices = 0;   ///< kAssembly: of all shapes together
  std::uint32_t triangles = 0;  ///< likewise
};

struct AssemblyCounts {
  std::uint32_t shapes = 0;
  std::uint32_t parts = 0;
};

struct Shape {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t faces = 0;
  std::uint32_t facesWithoutMesh = 0;
  double deflection = 0.0;  ///< millimetres
};

/// A shape where the assembly has it.
struct Part {
  std::uint32_t shape = 0;
  std::uint32_t hasColour = 0;
  double position[3] = {0.0, 0.0, 0.0};          ///< millimetres
  double orientation[4] = {0.0, 0.0, 0.0, 1.0};  ///< x y z w
  double colour[3] = {0.0, 0.0, 0.0};            ///< sRGB
  std::uint32_t pathBytes = 0;
  std::uint32_t unused = 0;
};

/// What an importing process may use, and the largest file that it is given.
struct Limits {
  std::uint64_t memory;                ///< address space, bytes
  std::uint64_t seconds;               ///< of the processor
  std::uint64_t bytes;                 ///< of the file
  std::chrono::milliseconds patience;  ///< until it is killed
};
inline constexpr Limits kMeshLimits{450ULL << 20, 4, 100ULL << 20, std::chrono::milliseconds(4500)};
/// Curved surfaces have to be computed, and a STEP file takes more than ten times its size in memory.
inline constexpr Limits kStepLimits{4ULL << 30, 120, 200ULL << 20, std::chrono::milliseconds(240'000)};

/// Largest number of vertices or triangles taken over.
inline constexpr std::uint32_t kMostElements = 8U << 20;
/// Largest number of parts taken over.
inline constexpr std::uint32_t kMostParts = 10'000;

}  // namespace glissade::import_protocol
