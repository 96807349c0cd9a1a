#include "engine/operator/spacenav_protocol.h"

#include <algorithm>
#include <cstring>

namespace glissade::spacenav {
namespace {

constexpr std::int32_t kDeviceEvent = 3;
constexpr std::int32_t kLastEvent = 6;
constexpr std::uint32_t kTag = 0x7faa0000;
constexpr std::uint32_t kTagMask = 0xffff0000;
constexpr std::int32_t kNameRequest = 0x7faa2000;
/// Bytes of text in a packet, and parts of its last number: the bytes left, and whether it continues an earlier packet;
/// negative for failure.
constexpr std::size_t kChunk = 24;
constexpr std::int32_t kLengthMask = 0xffff;
constexpr std::int32_t kContinued = 0x10000;

}  // namespace

PacketKind kindOf(const Packet& packet) {
  const std::int32_t type = packet[0];
  if (type == kNameRequest) return PacketKind::Name;
  if ((static_cast<std::uint32_t>(type) & kTagMask) == kTag) return PacketKind::Other;
  if (type < 0 || type > kLastEvent) return PacketKind::Garbage;
  if (type == kDeviceEvent) return PacketKind::DeviceList;
  return type < kDeviceEvent ? PacketKind::Event : PacketKind::Other;
}

Packet nameRequest() { return {kNameRequest, 0, 0, 0, 0, 0, 0, 0}; }

std::optional<std::string> NameAssembler::add(const Packet& packet) {
  const std::int32_t status = packet[7];
  if (status < 0) return std::string();
  if ((status & kContinued) == 0) name_.clear();
  const auto left = static_cast<std::size_t>(status & kLengthMask);
  std::array<char, kChunk> text{};
  std::memcpy(text.data(), packet.data() + 1, text.size());
  const auto end = std::find(text.begin(), text.begin() + std::min(left, kChunk), '\0');
  name_.append(text.begin(), end);
  if (left > kChunk) return std::nullopt;
  return name_;
}

}  // namespace glissade::spacenav
