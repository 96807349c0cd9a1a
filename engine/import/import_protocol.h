#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace glissade::import_protocol {

// What an importing process writes to its standard output: one header, then
// for kMesh a MeshFacts, `vertices` x 3 doubles, `triangles` x 3 indices, the bytes of its warnings (a line each),
// the bytes of its groups (a line each: number of triangles, blank, name);
// for kAssembly an AssemblyCounts; the bytes of the root's name; every shape as a Shape, its vertices x 3 doubles
// (millimetres), its triangles x 3 indices, its faces as a Face each; every part as a Part, the bytes of its path below
// the root (UTF-8), the bytes of the names of its steps as the file has them (a line each: product, tab, occurrence,
// tab, designator; none where they are the steps), the bytes of its former path; every use of another file as an
// ExternalPart, the bytes of its path, of its names, of the file's name; the bytes of its notes (a line each: kind,
// tab, where, tab, what; of a shape that is missing: kind, tab, product, tab, entity, tab, its kind, tab, why; kinds
// below); for kError (the file cannot be read) and kNotConfined (the process cannot give up its rights, and has read
// nothing) `vertices` bytes of text: the location in the file (may be empty), a line feed, the reason.
//
// With kVolumesOf as its argument, glissade-import-step writes kVolumes: `vertices` doubles, cubic millimetres, not a
// number where a volume is not known.
//
// With kSeveral as its argument, glissade-import reads several files, each as a SmallFile and its bytes, and writes a
// message (kMesh or kError) of each in the same order.
inline constexpr const char* kSeveral = "several";
inline constexpr const char* kVolumesOf = "volumes";
inline constexpr std::uint32_t kMagic = 0x474c494d;
inline constexpr std::uint32_t kMesh = 1;
inline constexpr std::uint32_t kError = 2;
inline constexpr std::uint32_t kAssembly = 3;
inline constexpr std::uint32_t kNotConfined = 4;
inline constexpr std::uint32_t kVolumes = 5;
/// Kinds of notes: something is missing; a face got new triangles; the volume of a part with such a face is doubtful; a
/// part has no inside; curves are left out; a shape is missing; a shape belongs to no product; a second representation
/// is left out; names are in an encoding that was told, or that was not.
inline constexpr char kLossLine = 'L';
inline constexpr char kHealedLine = 'H';
inline constexpr char kVolumeLine = 'V';
inline constexpr char kShapeLine = 'S';
inline constexpr char kCurveLine = 'C';
inline constexpr char kMissingLine = 'M';
inline constexpr char kOrphanLine = 'O';
inline constexpr char kSecondLine = '2';
inline constexpr char kForeignNamesLine = 'N';
inline constexpr char kDoubtfulNamesLine = 'D';
/// Metres: the unit of every length in an assembly.
inline constexpr double kMillimetre = 0.001;

struct Header {
  std::uint32_t magic = kMagic;
  std::uint32_t kind = kError;
  std::uint32_t vertices = 0;   ///< kAssembly: of all shapes together
  std::uint32_t triangles = 0;  ///< likewise
};

struct SmallFile {
  std::uint64_t bytes = 0;
  char ending[8] = {};  ///< as of the file's name, filled up with zeros
};

struct MeshFacts {
  double vertexMean[3] = {0.0, 0.0, 0.0};
  double coordinateSpacing = 0.0;
  std::uint32_t warningBytes = 0;
  std::uint32_t groupBytes = 0;
};

struct AssemblyCounts {
  std::uint32_t shapes = 0;
  std::uint32_t parts = 0;
  std::uint32_t noteBytes = 0;
  std::uint32_t externalParts = 0;
  std::uint32_t rootNameBytes = 0;  ///< of the one product of the file that is no assembly; else 0
  std::uint32_t unused = 0;
  double unit = kMillimetre;  ///< metres: that in which the file states lengths
};

struct Shape {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t faces = 0;  ///< that have triangles; 0: the triangles stand for none
  std::uint32_t facesWithoutMesh = 0;
};

/// As SurfaceFace, in millimetres. The triangles of a shape come in the order of its faces.
struct Face {
  std::uint32_t kind = 0;
  std::uint32_t triangles = 0;
  double point[3] = {0.0, 0.0, 0.0};
  double axis[3] = {0.0, 0.0, 1.0};
  double radius = 0.0;
  double second = 0.0;
  double deflection = 0.0;
};

/// A shape where the assembly has it.
struct Part {
  std::uint32_t shape = 0;
  std::uint32_t hasColour = 0;
  double position[3] = {0.0, 0.0, 0.0};          ///< millimetres
  double orientation[4] = {0.0, 0.0, 0.0, 1.0};  ///< x y z w
  double colour[3] = {0.0, 0.0, 0.0};            ///< sRGB
  std::uint32_t pathBytes = 0;
  std::uint32_t namesBytes = 0;
  std::uint32_t formerPathBytes = 0;  ///< 0: the same
  std::uint32_t isSolidOfPart = 0;    ///< of several solids of the node above it
};

/// A product that the file places and another file has.
struct ExternalPart {
  double position[3] = {0.0, 0.0, 0.0};          ///< millimetres
  double orientation[4] = {0.0, 0.0, 0.0, 1.0};  ///< x y z w
  std::uint32_t pathBytes = 0;
  std::uint32_t namesBytes = 0;
  std::uint32_t fileBytes = 0;
  std::uint32_t unused = 0;
};

/// What an importing process may use, and the largest file that it is given.
struct Limits {
  std::uint64_t memory;                ///< address space, bytes
  std::uint64_t seconds;               ///< of the processor
  std::uint64_t bytes;                 ///< of the file
  std::chrono::milliseconds patience;  ///< until it is killed
};
/// The most that any mesh file may take; import_limits.h has the limits of a file on a machine.
inline constexpr Limits kMeshLimits{64ULL << 30, 500, 4ULL << 30, std::chrono::milliseconds(1'000'000)};
/// Curved surfaces have to be computed, and a STEP file takes more than ten times its size in memory.
inline constexpr Limits kStepLimits{4ULL << 30, 120, 200ULL << 20, std::chrono::milliseconds(1'200'000)};

/// Of a STEP file of this size: 2 GB and 30 s of the processor, more for a large file, never more than
/// kStepLimits. Products of 2.5 MB were measured to take 75 MB and 2 s. The processor may be busy with other work, so
/// that the clock may show ten times as much.
constexpr Limits stepLimitsFor(std::uint64_t fileBytes) {
  const std::uint64_t memory = std::min<std::uint64_t>(kStepLimits.memory, (std::uint64_t{2} << 30) + 20 * fileBytes);
  const std::uint64_t seconds = std::min<std::uint64_t>(kStepLimits.seconds, 30 + 2 * (fileBytes >> 20));
  return {memory, seconds, kStepLimits.bytes, std::chrono::seconds(10 * seconds)};
}

/// Largest number of vertices or triangles taken over.
inline constexpr std::uint32_t kMostElements = 64U << 20;
/// Largest number of faces, of all shapes together.
inline constexpr std::uint32_t kMostFaces = 1U << 20;
/// Metres: the largest radius and coordinate of a face.
inline constexpr double kLargestFace = 1e9;
/// Largest number of parts taken over.
inline constexpr std::uint32_t kMostParts = 10'000;
/// Largest number of files that a product may be in.
inline constexpr std::uint32_t kMostFiles = 1'000;
/// Most occurrences of assemblies and parts: assemblies that use each other twice at every level would take time
/// without end.
inline constexpr std::uint32_t kMostOccurrences = 100'000;
/// Deepest nesting of assemblies, and of files.
inline constexpr int kDeepestAssembly = 64;

}  // namespace glissade::import_protocol
