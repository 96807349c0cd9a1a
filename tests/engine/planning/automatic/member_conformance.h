#pragma once

#include <gtest/gtest.h>

#include "engine/planning/automatic/member.h"
#include "engine/planning/path_certificate.h"
#include "tests/engine/support/test_host.h"

namespace glissade {

/// Tests that a member delivers a certified path from start to goal or states why not. True if there is a path.
inline bool deliversOrSaysWhyNot(const Member& member, const Problem& problem) {
  TestHost host(problem);
  const auto planner = member.make(3, 1);
  if (!planner->solve(host)) {
    EXPECT_TRUE(planner->failure()) << member.name;
    return false;
  }
  const auto way = planner->path()->configurations();
  EXPECT_EQ(way.front(), problem.start) << member.name;
  EXPECT_EQ(way.back(), std::get<Pose>(problem.goal)) << member.name;
  EXPECT_EQ(certifyPath(*problem.world->makeQuery(), way, host.values[ParameterId::RequiredClearance]).status,
            CertificateStatus::Certified)
      << member.name;
  return true;
}

}  // namespace glissade
