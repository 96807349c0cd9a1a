#include "engine/import/import_limits.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace glissade {
namespace {

constexpr std::uint64_t kMebibyte = 1ULL << 20;
constexpr std::uint64_t kGibibyte = 1ULL << 30;

}  // namespace

std::uint64_t availableMemory() {
  std::ifstream facts("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  while (facts >> name >> kibibytes) {
    if (name == "MemAvailable:") return kibibytes * 1024;
    facts.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return 2 * kGibibyte;
}

std::uint64_t mostFileBytes(std::uint64_t available) {
  return std::clamp(available / 16, 200 * kMebibyte, 4 * kGibibyte);
}

import_protocol::Limits meshLimits(std::uint64_t fileBytes, std::uint64_t available) {
  constexpr std::uint64_t kFloor = 450 * kMebibyte;
  constexpr std::uint64_t kBytesASecond = 10 * kMebibyte;  // bytes of text; binary files take a tenth of the time
  import_protocol::Limits limits{};
  limits.memory = std::min(kFloor + 16 * fileBytes, std::max(kFloor, available / 2));
  limits.seconds = 4 + fileBytes / kBytesASecond;
  limits.bytes = mostFileBytes(available);
  limits.patience = std::chrono::seconds(30 + 2 * limits.seconds);  // the processor may be busy with other work
  return limits;
}

Message sizeInWords(std::uint64_t bytes) {
  if (bytes < kMebibyte) return {GLISSADE_TEXT("%1 bytes"), {bytes}};
  return {GLISSADE_TEXT("%1 MiB"), {(bytes + kMebibyte - 1) / kMebibyte}};
}

}  // namespace glissade
