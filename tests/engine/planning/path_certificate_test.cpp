#include "engine/planning/path_certificate.h"

#include <gtest/gtest.h>

#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(PathCertificate, TheFirstRefusedEdgeIsTheFirstThatCannotBeProvedByAdvancingOnDistances) {
  const Problem problem = windowProblem();
  const TestHost host(problem);
  const auto query = problem.world->makeQuery();
  RandomStream stream(1, "paths");
  int refusals = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<PathPoint> points{{problem.start, Author::Computer}};
    for (int k = 0; k < 3; ++k) {
      Pose next = points.back().q;
      next.position += randomPose(stream, 1.5).position;
      points.push_back({next, Author::Computer});
    }
    const MotionCertificate certificate = certifyPath(*query, points, host.values);
    const auto refused = firstRefusedEdge(*query, points, host.values);
    const double required = host.values[ParameterId::RequiredClearance];
    std::size_t expected = 0;
    while (expected + 1 < points.size() &&
           certifyMotion(*query, points[expected].q, points[expected + 1].q, required).status ==
               CertificateStatus::Certified) {
      ++expected;
    }
    ASSERT_EQ(refused.has_value(), expected + 1 < points.size()) << i;
    ASSERT_EQ(refused.has_value(), certificate.status != CertificateStatus::Certified) << i;
    if (!refused) continue;
    ++refusals;
    EXPECT_EQ(refused->edge, expected) << i;
    EXPECT_EQ(certificate.edge, expected) << i;
  }
  EXPECT_GT(refusals, 20);
  EXPECT_LT(refusals, 180);
}

}  // namespace
}  // namespace glissade
