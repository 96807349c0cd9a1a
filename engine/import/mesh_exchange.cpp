#include "engine/import/mesh_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace glissade {
namespace {

struct Header {
  std::array<char, 8> magic;
  std::uint64_t errorBytes;
  std::uint64_t coordinates;
  std::uint64_t corners;
};
constexpr std::array<char, 8> kMagic{'g', 'l', 'i', 'm', 'e', 's', 'h', '1'};

template <class T>
void appendArray(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
std::vector<T> takeArray(std::string_view& bytes, std::size_t count) {
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}

Diagnostic malformed(const std::string& reason) {
  return {ErrorKind::MalformedInput, "", "", reason,
          "Check the file in the program that wrote it and export it again."};
}

bool countsFit(const Header& header, std::size_t bytes) {
  const std::size_t most = bytes / sizeof(float);  // also keeps the sum below from overflowing
  if (header.errorBytes > bytes || header.coordinates > most || header.corners > most) return false;
  const std::size_t needed = header.errorBytes + (header.coordinates + header.corners) * sizeof(float);
  return needed == bytes && header.coordinates % 3 == 0 && header.corners % 3 == 0;
}

}  // namespace

std::string encode(const MeshReply& reply) {
  const Header header{kMagic, reply.error.size(), reply.coordinates.size(), reply.corners.size()};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes += reply.error;
  appendArray(bytes, reply.coordinates);
  appendArray(bytes, reply.corners);
  return bytes;
}

Result<MeshReply> decodeMeshReply(std::string_view bytes) {
  Header header{};
  if (bytes.size() < sizeof header) return malformed("the file could not be imported");
  std::memcpy(&header, bytes.data(), sizeof header);
  bytes.remove_prefix(sizeof header);
  if (header.magic != kMagic || !countsFit(header, bytes.size())) return malformed("the file could not be imported");

  MeshReply reply;
  reply.error = bytes.substr(0, header.errorBytes);
  bytes.remove_prefix(header.errorBytes);
  if (!reply.error.empty()) return malformed(reply.error);
  reply.coordinates = takeArray<float>(bytes, header.coordinates);
  reply.corners = takeArray<std::uint32_t>(bytes, header.corners);

  const auto sane = [](float x) { return std::isfinite(x) && std::abs(x) <= kLargestCoordinate; };
  if (!std::all_of(reply.coordinates.begin(), reply.coordinates.end(), sane)) {
    return malformed("a vertex has a coordinate that is not a number or beyond all measure");
  }
  const std::size_t vertices = reply.coordinates.size() / 3;
  const auto inRange = [&](std::uint32_t corner) { return corner < vertices; };
  if (!std::all_of(reply.corners.begin(), reply.corners.end(), inRange)) {
    return malformed("a triangle refers to a vertex that is not there");
  }
  if (reply.corners.empty()) return malformed("the file holds no triangles");
  return reply;
}

}  // namespace glissade
