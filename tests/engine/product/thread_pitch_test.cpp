#include "engine/product/thread_pitch.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(ThreadPitch, IsTheCoarseOneOfTheNearestSize) {
  for (const auto& [radius, pitch, size] :
       {std::tuple(0.005, 0.0015, "M10"), std::tuple(0.0025, 0.0008, "M5"), std::tuple(0.00302, 0.001, "M6"),
        std::tuple(0.01, 0.0025, "M20"), std::tuple(1e-5, 0.00025, "M1"), std::tuple(0.5, 0.006, "M64")}) {
    EXPECT_DOUBLE_EQ(isoCoarsePitch(radius).pitch, pitch) << radius;
    EXPECT_EQ(isoCoarsePitch(radius).size, size);
  }
}

TEST(ThreadPitch, ANominalSizeIsThatOfTheDiameterToAFewPercent) {
  EXPECT_EQ(nominalSize(0.009997), "M10");
  EXPECT_EQ(nominalSize(0.00255), "M2.5");
  EXPECT_EQ(nominalSize(0.0053), "") << "between M5 and M6";
  EXPECT_EQ(nominalSize(0.2), "");
}

}  // namespace
}  // namespace glissade
