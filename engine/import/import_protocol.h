#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace glissade::import_protocol {

// Output of an importing process: a header, followed by data that depend on its kind.
// kMesh: a MeshFacts, `vertices` x 3 doubles, `triangles` x 3 indices, the bytes of its warnings (a line each: a
// message), the bytes of its groups (a line each: number of triangles, blank, name). kAssembly: an AssemblyCounts; the
// bytes of the root's name; every shape as a Shape, its vertices x 3 doubles (millimetres), its triangles x 3 indices,
// its faces as a Face each; every part as a Part, the bytes of its path below the root (UTF-8), the bytes of the names
// of its steps as the file states them (a line each: product, tab, occurrence, tab, designator; none if they equal the
// steps), the bytes of its former path; every use of another file as an ExternalPart, the bytes of its path, of its
// names, of the file's name; the bytes of its notes, a line of JSON each:
// {"kind": kind below, "place": message, "text": message}; for a missing shape: {"kind": "M", "product": text,
// "entity": text, "shape": its kind, "text": message, its reason}.
// kError (the file cannot be read) and kNotConfined (the process cannot give up its rights, and has read nothing):
// `vertices` bytes of JSON: {"location": message, "reason": message}.
// A message is JSON as in base/message_json.h. Each of its texts names each argument at most once.
//
// With kVolumesOf as its argument, glissade-import-step writes kVolumes: `vertices` doubles, cubic millimetres; not a
// number for an unknown volume.
//
// With kSeveral as its argument, glissade-import reads several files, each as a SmallFile and its bytes, and writes a
// message (kMesh or kError) for each in the same order.
inline constexpr const char* kSeveral = "several";
inline constexpr const char* kVolumesOf = "volumes";
inline constexpr std::uint32_t kMagic = 0x474c494d;
inline constexpr std::uint32_t kMesh = 1;
inline constexpr std::uint32_t kError = 2;
inline constexpr std::uint32_t kAssembly = 3;
inline constexpr std::uint32_t kNotConfined = 4;
inline constexpr std::uint32_t kVolumes = 5;
/// Kinds of notes: a loss; a face with new triangles; a part with such a face and a doubtful volume; a part without an
/// inside; curves that are left out; a missing shape; a shape without a product; a second representation that is left
/// out; names in a certain or an uncertain foreign encoding.
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
  std::uint32_t vertices = 0;   ///< for kAssembly: sum over all shapes
  std::uint32_t triangles = 0;  ///< for kAssembly: sum over all shapes
};

struct SmallFile {
  std::uint64_t bytes = 0;
  char ending[8] = {};  ///< ending of the file's name, padded with zeros
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
  std::uint32_t rootNameBytes = 0;  ///< for the only product of the file if that is no assembly; else 0
  std::uint32_t unused = 0;
  double unit = kMillimetre;  ///< metres: unit in which the file states lengths
};

struct Shape {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t faces = 0;  ///< number of faces with triangles; 0: the triangles belong to no face
  std::uint32_t facesWithoutMesh = 0;
};

/// A SurfaceFace in millimetres. The triangles of a shape are in the order of its faces.
struct Face {
  std::uint32_t kind = 0;
  std::uint32_t triangles = 0;
  double point[3] = {0.0, 0.0, 0.0};
  double axis[3] = {0.0, 0.0, 1.0};
  double radius = 0.0;
  double second = 0.0;
  double deflection = 0.0;
};

/// A shape at its place in the assembly.
struct Part {
  std::uint32_t shape = 0;
  std::uint32_t hasColour = 0;
  double position[3] = {0.0, 0.0, 0.0};          ///< millimetres
  double orientation[4] = {0.0, 0.0, 0.0, 1.0};  ///< x y z w
  double colour[3] = {0.0, 0.0, 0.0};            ///< sRGB
  std::uint32_t pathBytes = 0;
  std::uint32_t namesBytes = 0;
  std::uint32_t formerPathBytes = 0;  ///< 0: equal to the path
  std::uint32_t isSolidOfPart = 0;    ///< the node above has several solids
};

/// A product that the file places and that is in another file.
struct ExternalPart {
  double position[3] = {0.0, 0.0, 0.0};          ///< millimetres
  double orientation[4] = {0.0, 0.0, 0.0, 1.0};  ///< x y z w
  std::uint32_t pathBytes = 0;
  std::uint32_t namesBytes = 0;
  std::uint32_t fileBytes = 0;
  std::uint32_t unused = 0;
};

/// Limits of an importing process, and of the file that it gets.
struct Limits {
  std::uint64_t memory;                ///< address space, bytes
  std::uint64_t seconds;               ///< processor time
  std::uint64_t bytes;                 ///< size of the file
  std::chrono::milliseconds patience;  ///< time until the process is killed
};
/// Limits for any mesh file; import_limits.h has the limits for a file on a machine.
inline constexpr Limits kMeshLimits{64ULL << 30, 500, 4ULL << 30, std::chrono::milliseconds(1'000'000)};
/// Limits for STEP files: curved surfaces have to be computed, and a file takes more than ten times its size in memory.
inline constexpr Limits kStepLimits{4ULL << 30, 120, 200ULL << 20, std::chrono::milliseconds(1'200'000)};

/// Limits for a STEP file of this size: 2 GB and 30 s of the processor, more for a large file, never more than
/// kStepLimits. Products of 2.5 MB were measured to take 75 MB and 2 s. The clock time may be ten times the processor
/// time, because the processor may be busy with other work.
constexpr Limits stepLimitsFor(std::uint64_t fileBytes) {
  const std::uint64_t memory = std::min<std::uint64_t>(kStepLimits.memory, (std::uint64_t{2} << 30) + 20 * fileBytes);
  const std::uint64_t seconds = std::min<std::uint64_t>(kStepLimits.seconds, 30 + 2 * (fileBytes >> 20));
  return {memory, seconds, kStepLimits.bytes, std::chrono::seconds(10 * seconds)};
}

/// Largest number of vertices or triangles that are accepted.
inline constexpr std::uint32_t kMostElements = 64U << 20;
/// Largest number of faces, over all shapes.
inline constexpr std::uint32_t kMostFaces = 1U << 20;
/// Metres: the largest radius and coordinate of a face.
inline constexpr double kLargestFace = 1e9;
/// Largest number of parts that are accepted.
inline constexpr std::uint32_t kMostParts = 10'000;
/// Largest number of files of a product.
inline constexpr std::uint32_t kMostFiles = 1'000;
/// Largest number of occurrences of assemblies and parts: without it, assemblies that use each other twice at every
/// level would take unlimited time.
inline constexpr std::uint32_t kMostOccurrences = 100'000;
/// Deepest nesting of assemblies, and of files.
inline constexpr int kDeepestAssembly = 64;

}  // namespace glissade::import_protocol
