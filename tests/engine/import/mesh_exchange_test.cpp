#include "engine/import/mesh_exchange.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

using testing::HasSubstr;

MeshReply triangle() { return {"", {0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}}; }

void expectRefused(const MeshReply& reply, const std::string& reason) {
  const Result<MeshReply> decoded = decodeMeshReply(encode(reply));
  ASSERT_FALSE(decoded.ok());
  EXPECT_EQ(decoded.error().kind, ErrorKind::MalformedInput);
  EXPECT_THAT(decoded.error().reason, HasSubstr(reason));
}

TEST(MeshExchange, RoundTrips) {
  const Result<MeshReply> decoded = decodeMeshReply(encode(triangle()));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->coordinates, triangle().coordinates);
  EXPECT_EQ(decoded->corners, triangle().corners);
}

TEST(MeshExchange, ChecksEveryNumber) {
  MeshReply reply = triangle();
  reply.coordinates[4] = std::numeric_limits<float>::quiet_NaN();
  expectRefused(reply, "not a number");
  reply.coordinates[4] = 1e30F;
  expectRefused(reply, "beyond all measure");
  reply = triangle();
  reply.corners[1] = 3;
  expectRefused(reply, "vertex that is not there");
  expectRefused({"", {}, {}}, "no triangles");
  expectRefused({"assimp says no", {}, {}}, "assimp says no");
}

TEST(MeshExchange, SurvivesAnyBytes) {
  RandomStream random(7, "mesh-exchange");
  const std::string good = encode(triangle());
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_FALSE(decodeMeshReply(good.substr(0, length)).ok()) << length;
  }
  EXPECT_FALSE(decodeMeshReply(good + "x").ok());
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = good;
    for (int k = 0; k < 3; ++k) bytes[random.bits() % bytes.size()] = static_cast<char>(random.bits());
    const Result<MeshReply> decoded = decodeMeshReply(bytes);
    EXPECT_TRUE(!decoded || decoded->coordinates.size() <= 9);
  }
}

}  // namespace
}  // namespace glissade
