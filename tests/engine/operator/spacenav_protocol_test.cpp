#include "engine/operator/spacenav_protocol.h"

#include <gtest/gtest.h>

#include <climits>
#include <cstring>

namespace glissade::spacenav {
namespace {

Packet namePacket(const std::string& text, int left, bool continued) {
  Packet packet = nameRequest();
  std::memcpy(packet.data() + 1, text.data(), std::min<std::size_t>(text.size(), 24));
  packet[7] = left | (continued ? 0x10000 : 0);
  return packet;
}

TEST(SpacenavProtocol, KnowsEveryKindOfPacket) {
  for (const int type : {0, 1, 2}) EXPECT_EQ(kindOf({type}), PacketKind::Event);
  EXPECT_EQ(kindOf({3}), PacketKind::DeviceList);
  for (const int type : {4, 5, 6, 0x7faa1003}) EXPECT_EQ(kindOf({type}), PacketKind::Other);
  EXPECT_EQ(kindOf(nameRequest()), PacketKind::Name);
  for (const int type : {-1, 7, INT_MIN, INT_MAX, 0x25004a25}) EXPECT_EQ(kindOf({type}), PacketKind::Garbage);
}

TEST(SpacenavProtocol, PutsLongNamesTogether) {
  NameAssembler name;
  EXPECT_EQ(name.add(namePacket("SpaceMouse", 10, false)), "SpaceMouse");
  EXPECT_EQ(name.add(namePacket("3Dconnexion SpaceMouse P", 32, false)), std::nullopt);
  EXPECT_EQ(name.add(namePacket("ro Wired", 8, true)), "3Dconnexion SpaceMouse Pro Wired");
  EXPECT_EQ(name.add(namePacket("", -1, false)), "");
}

}  // namespace
}  // namespace glissade::spacenav
