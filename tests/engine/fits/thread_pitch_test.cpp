#include "engine/fits/thread_pitch.h"

#include <gtest/gtest.h>

#include "engine/evidence/pulled_thread.h"

namespace glissade {
namespace {

TEST(ThreadPitch, IsTheCoarseOneOfTheNearestSize) {
  for (const auto& [radius, pitch, size] :
       {std::tuple(0.005, 0.0015, "M10"), std::tuple(0.0025, 0.0008, "M5"), std::tuple(0.00302, 0.001, "M6"),
        std::tuple(0.01, 0.0025, "M20"), std::tuple(1e-5, 0.00025, "M1"), std::tuple(0.5, 0.006, "M64"),
        std::tuple(0.0127, 0.0254 / 8, "1"), std::tuple(0.003175, 0.0254 / 20, "1/4")}) {
    EXPECT_DOUBLE_EQ(coarsePitch(radius).pitch, pitch) << radius;
    EXPECT_EQ(coarsePitch(radius).size, size);
  }
}

TEST(ThreadPitch, ANominalSizeIsThatOfTheDiameterToAFewPercent) {
  EXPECT_EQ(nominalSize(0.009997), "M10");
  EXPECT_EQ(nominalSize(0.00255), "M2.5");
  EXPECT_EQ(nominalSize(0.0053), "") << "between M5 and M6";
  EXPECT_EQ(nominalSize(0.2), "");
}

/// The hole is the core of the thread: 0.541 pitches deep by ISO 68-1.
TEST(ThreadPitch, IsAFineOneWhereTheDepthIs) {
  for (const auto& [radius, pitch, drawn] :
       {std::tuple(0.003, 0.001, 0.001), std::tuple(0.029, 0.0015, 0.0015), std::tuple(0.005, 0.00125, 0.00125),
        std::tuple(0.01, 0.0025, 0.0025), std::tuple(0.01, 0.001, 0.001)}) {
    EXPECT_DOUBLE_EQ(pitchOfDepth(radius, 0.541 * drawn), pitch) << radius;
  }
  EXPECT_DOUBLE_EQ(pitchOfDepth(0.003, 0.00005), 0.001) << "of no thread";
  EXPECT_TRUE(isThreadDepth(0.029, 0.541 * 0.0015)) << "M58x1.5";
  for (const auto& [diameter, pitch] : {std::pair(58.0, 2.0), std::pair(120.0, 2.0), std::pair(80.0, 1.5),
                                        std::pair(200.0, 6.0), std::pair(25.0, 1.0), std::pair(16.0, 2.0)}) {
    for (const double depth : {0.5, 0.5413, 0.6134}) {  // tap drill, core of the nut, core of the bolt: ISO 68-1
      EXPECT_DOUBLE_EQ(pitchOfDepth(0.5e-3 * diameter, 1e-3 * depth * pitch), 1e-3 * pitch) << diameter;
      EXPECT_TRUE(isThreadDepth(0.5e-3 * diameter, 1e-3 * depth * pitch)) << diameter << " x " << pitch;
    }
  }
}

TEST(ThreadPitch, WhatIsThickerByLessThanTheFinestThreadIsPressedIn) {
  EXPECT_TRUE(isThreadDepth(0.003, 0.0005)) << "M6 in its tap drill";
  EXPECT_TRUE(isThreadDepth(0.005, 0.0005)) << "M10x1 in its tap drill";
  EXPECT_TRUE(isThreadDepth(0.015, 0.0006)) << "M30x1";
  EXPECT_FALSE(isThreadDepth(0.0024, 0.000075)) << "a horn on the shaft of a servo";
  EXPECT_FALSE(isThreadDepth(0.005, 0.0001)) << "2 % of the radius";
  EXPECT_FALSE(isThreadDepth(0.03, 0.0003)) << "a bearing in a housing of plastic";
}

TEST(ThreadPitch, OfNoScrewAThreadHasTheDepthOfTheStandard) {
  for (const auto& [diameter, pitch] : {std::pair(3.0, 0.5), std::pair(5.0, 0.8), std::pair(10.0, 1.5)}) {
    const double radius = 0.5e-3 * diameter;
    for (const double depth : {0.32, 0.5, 0.5413, 0.6134})
      EXPECT_TRUE(evidence::hasDepthOfThread(radius, 1e-3 * depth * pitch)) << diameter << ", " << depth;
    EXPECT_FALSE(evidence::hasDepthOfThread(radius, 0.19e-3 * pitch)) << diameter;
  }
  EXPECT_TRUE(evidence::hasDepthOfThread(0.029, 0.541 * 0.0015)) << "M58x1.5";
}

/// The hole of a screw in plastic has no standard depth, and says nothing of the pitch.
TEST(ThreadPitch, OfAHoleIsAFineOneWhereTheCoreIsThatOfTheStandard) {
  EXPECT_DOUBLE_EQ(pitchOfHole(0.012, 0.012 - 0.541266 * 0.002), 0.002) << "M24x2";
  EXPECT_DOUBLE_EQ(pitchOfHole(0.05, 0.05 - 0.541266 * 0.003), 0.003) << "M100x3";
  EXPECT_DOUBLE_EQ(pitchOfHole(0.012, 0.012 - 0.541266 * 0.003), 0.003) << "M24";
  EXPECT_DOUBLE_EQ(pitchOfHole(0.0015, 0.0013), 0.0005) << "M3 in a hole of 2.6 mm";
  EXPECT_DOUBLE_EQ(pitchOfHole(0.0015, 0.0016), 0.0005) << "M3 in a wide hole";
}

/// A clash of more than a millimetre is the core of a thread only if the pitch is the coarse one, or the depth is that
/// of the standard.
TEST(ThreadPitch, ADeepOverlapHasACoarsePitchOrTheStandardDepth) {
  EXPECT_TRUE(evidence::isCoreOfThread(0.010, 0.00135)) << "M20 in the core of its nut";
  EXPECT_TRUE(evidence::isCoreOfThread(0.032, 0.00325)) << "M64";
  EXPECT_TRUE(evidence::isCoreOfThread(0.0127, 0.00172)) << "1 inch, 8 threads";
  EXPECT_FALSE(evidence::isCoreOfThread(0.030, 0.0020)) << "a peg of 60 mm in a hole of 56 mm";
  EXPECT_FALSE(evidence::isCoreOfThread(0.060, 0.0020)) << "a peg of 120 mm in a hole of 116 mm";
  EXPECT_TRUE(evidence::isCoreOfThread(0.060, 0.541266 * 0.002)) << "M120x2 in the core of its nut";
  EXPECT_FALSE(evidence::isCoreOfThread(0.010, 0.0020)) << "M20 has no such pitch";
}

}  // namespace
}  // namespace glissade
