#include "engine/geometry/cube_intersector.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

using Triangle = std::array<Vector3, 3>;

constexpr int kSamples = 60;  // samples along an edge

/// The least Chebyshev distance of the triangle's sampled points from `centre`.
double nearestSample(const Triangle& t, const Vector3& centre) {
  double least = 1e300;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; i + j <= kSamples; ++j) {
      const double a = static_cast<double>(i) / kSamples;
      const double b = static_cast<double>(j) / kSamples;
      const Vector3 p = t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
      least = std::min(least, (p - centre).lpNorm<Eigen::Infinity>());
    }
  }
  return least;
}

double longestEdge(const Triangle& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

Vector3 randomPoint(RandomStream& stream, double reach) {
  return {stream.uniform(-reach, reach), stream.uniform(-reach, reach), stream.uniform(-reach, reach)};
}

TEST(CubeIntersector, AgreesWithSampledPoints) {
  RandomStream stream(1, "triangles");
  int entering = 0;
  int apart = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector3 centre = randomPoint(stream, 1.0);
    const double half = stream.uniform(0.05, 0.6);
    const double reach = trial % 2 == 0 ? 1.0 : 0.3;  // long ones that pass through, and small ones
    const Vector3 about = centre + randomPoint(stream, 1.5 * half);
    const Triangle t{about + randomPoint(stream, reach), about + randomPoint(stream, reach),
                     about + randomPoint(stream, reach)};
    const double nearest = nearestSample(t, centre);
    const bool enters = CubeIntersector(t).enters(centre, half);
    if (nearest < half * (1.0 - 1e-6)) {
      EXPECT_TRUE(enters) << "trial " << trial;
    }
    // Every point of the triangle has a sample nearer than one sampling step.
    if (nearest > half + longestEdge(t) / kSamples) {
      EXPECT_FALSE(enters) << "trial " << trial;
    }
    ++(enters ? entering : apart);
  }
  EXPECT_GT(entering, 500);
  EXPECT_GT(apart, 500);
}

TEST(CubeIntersector, OnlyTheInteriorCounts) {
  const Vector3 centre(0.5, 0.5, 0.5);
  const Triangle onAFace{Vector3(1, -1, -1), Vector3(1, 3, -1), Vector3(1, 0.5, 3)};
  const Triangle onAnEdge{Vector3(1, 1, -1), Vector3(1, 1, 2), Vector3(2, 2, 0.5)};
  const Triangle onACorner{Vector3(1, 1, 1), Vector3(2, 1, 1), Vector3(1, 2, 2)};
  const Triangle acrossACorner{Vector3(3, 0, 0), Vector3(0, 3, 0), Vector3(0, 0, 3)};  // in the plane x + y + z = 3
  for (const Triangle& touching : {onAFace, onAnEdge, onACorner, acrossACorner}) {
    EXPECT_FALSE(CubeIntersector(touching).enters(centre, 0.5));
    EXPECT_TRUE(CubeIntersector(touching).enters(centre, 0.5 + 1e-6));
  }
}

TEST(CubeIntersector, ATriangleMayLieInsideOrRoundTheCube) {
  const Triangle tiny{Vector3(0.5, 0.5, 0.5), Vector3(0.51, 0.5, 0.5), Vector3(0.5, 0.51, 0.5)};
  const Triangle huge{Vector3(-100, -100, 0.5), Vector3(100, -100, 0.5), Vector3(0, 200, 0.5)};
  EXPECT_TRUE(CubeIntersector(tiny).enters(Vector3::Constant(0.5), 0.5));
  EXPECT_TRUE(CubeIntersector(huge).enters(Vector3::Constant(0.5), 0.5));
  EXPECT_FALSE(CubeIntersector(huge).enters(Vector3(0.5, 0.5, 1.5), 0.5));
}

}  // namespace
}  // namespace glissade
