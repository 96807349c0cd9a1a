#include "engine/planning/smoothing/shortcuts.h"

#include <gtest/gtest.h>

#include "engine/planning/path_certificate.h"
#include "engine/planning/planner.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

double lengthOf(const Path& path, const Problem& problem) {
  double sum = 0.0;
  for (const double part : path.lengthByAuthor(problem.metric())) sum += part;
  return sum;
}

Path plannedThroughTheWindow(const Problem& problem, std::uint64_t seed, const char* planner = "birrt") {
  TestHost host(problem, 200000);
  const auto made = makePlannerRegistry().find(planner)->make(problem, seed);
  if (!made->solve(host)) throw std::runtime_error("no path");
  return *made->path();
}

std::vector<Pose> posesOf(const Path& path) { return path.configurations(); }

TEST(Shortcuts, ShortenAndKeepTheCertificate) {
  const Problem problem = windowProblem();
  const ParameterValues parameters(problem.world->objectRadius());
  const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
  double before = 0.0;
  double after = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Path path = plannedThroughTheWindow(problem, seed);
    const Path shorter = withShortcuts(path, problem, parameters, seed, 200);
    EXPECT_LE(lengthOf(shorter, problem), lengthOf(path, problem) * (1.0 + 1e-12));
    EXPECT_EQ(shorter.points.front().q, path.points.front().q);
    EXPECT_EQ(shorter.points.back().q, path.points.back().q);
    EXPECT_EQ(shorter.certificate.status, CertificateStatus::Certified);
    EXPECT_EQ(shorter.certificate.edges.size() + 1, shorter.points.size());
    EXPECT_EQ(judge.check(posesOf(shorter), demandsOf(shorter.points, parameters)).status,
              CertificateStatus::Certified);
    before += lengthOf(path, problem);
    after += lengthOf(shorter, problem);
  }
  EXPECT_LT(after, 0.9 * before);
}

TEST(Shortcuts, TheSameSeedGivesTheSamePathAndNoAttemptsOnlyLeaveOut) {
  const Problem problem = windowProblem();
  const ParameterValues parameters(problem.world->objectRadius());
  const Path path = plannedThroughTheWindow(problem, 3);
  EXPECT_EQ(posesOf(withShortcuts(path, problem, parameters, 9, 100)),
            posesOf(withShortcuts(path, problem, parameters, 9, 100)));
  EXPECT_NE(posesOf(withShortcuts(path, problem, parameters, 9, 100)),
            posesOf(withShortcuts(path, problem, parameters, 10, 100)));
}

TEST(Shortcuts, AStopGivesThePathBack) {
  const Problem problem = windowProblem();
  const Path path = plannedThroughTheWindow(problem, 3);
  StopSource source;
  source.requestStop();
  EXPECT_EQ(posesOf(withShortcuts(path, problem, ParameterValues(0.35), 1, 100, source.token())), posesOf(path));
}

TEST(Shortcuts, KeepALargerRequirement) {
  const Problem problem = windowProblem();
  ParameterValues parameters(problem.world->objectRadius());
  ASSERT_TRUE(parameters.set(ParameterId::RequiredClearance, 0.03).ok());
  Path path;
  for (const Pose& q : {problem.start, Pose::translation({-0.7, -0.1, 0.1}), Pose::translation({0.7, 0.1, -0.1}),
                        std::get<Pose>(problem.goal)}) {
    path.points.push_back({q});
  }
  path.certificate = certifyPath(*problem.world->makeQuery(), path.points, parameters);
  ASSERT_EQ(path.certificate.status, CertificateStatus::Certified);
  const Path shorter = withShortcuts(path, problem, parameters, 1, 300);
  EXPECT_LT(lengthOf(shorter, problem), lengthOf(path, problem));
  EXPECT_GE(shorter.certificate.provedClearance, 0.03);
}

TEST(Shortcuts, OfTheComputerLeaveTheWayOfAHandAndItsContacts) {
  const Problem problem = windowProblem();
  const ParameterValues parameters(problem.world->objectRadius());
  const auto at = [](double x, double y, double z, Author author) {
    return PathPoint{Pose::translation({x, y, z}), author, author};
  };
  constexpr auto kComputer = Author::Computer;
  constexpr auto kHand = Author::Operator;
  Path path;
  path.points = {{problem.start},
                 at(-1.2, -0.4, 0.0, kComputer),
                 at(-1.0, 0.4, 0.0, kComputer),
                 at(-0.8, 0.0, 0.0, kComputer),
                 at(-0.6, 0.1, 0.0, kHand),
                 at(-0.6, -0.1, 0.0, kHand),
                 at(-0.5, 0.0, 0.0, Author::Contact),
                 at(0.8, 0.0, 0.0, kComputer),
                 at(1.0, 0.5, 0.0, kComputer),
                 {std::get<Pose>(problem.goal)}};
  path.certificate = certifyPath(*problem.world->makeQuery(), path.points, parameters);
  ASSERT_EQ(path.certificate.status, CertificateStatus::Certified);
  const Path shorter = withShortcutsOfComputer(path, problem, parameters, 1, 300);
  EXPECT_EQ(shorter.certificate.status, CertificateStatus::Certified);
  EXPECT_EQ(shorter.certificate.edges.size() + 1, shorter.points.size());
  const auto before = path.lengthByAuthor(problem.metric());
  const auto after = shorter.lengthByAuthor(problem.metric());
  EXPECT_LT(after[0], 0.9 * before[0]);
  EXPECT_EQ(after[1], before[1]);
  EXPECT_EQ(after[2], before[2]);
  const auto kept = std::search(shorter.points.begin(), shorter.points.end(), path.points.begin() + 3,
                                path.points.begin() + 7, [](const PathPoint& a, const PathPoint& b) {
                                  return a.q == b.q && a.author == b.author && a.segmentAuthor == b.segmentAuthor;
                                });
  EXPECT_NE(kept, shorter.points.end());
}

TEST(PathCertificate, SlidingEdgesAreHeldToTheContactGap) {
  const Problem problem = windowProblem();
  ParameterValues parameters(problem.world->objectRadius());
  const double gap = parameters[ParameterId::ContactGap];
  // The cube slides down the wall's near side (x = -0.1); its face is at x + 0.2.
  const double touching = -0.1 - 0.2 - gap;
  const std::vector<PathPoint> points{{Pose::translation({-1.5, -1.0, 0.0})},
                                      {Pose::translation({touching, -1.0, 0.0}), Author::Contact, Author::Contact},
                                      {Pose::translation({touching, -1.2, 0.5}), Author::Contact, Author::Contact},
                                      {Pose::translation({-1.5, -1.2, 0.5})},
                                      {Pose::translation({-1.5, 1.0, 0.5})}};
  ASSERT_TRUE(parameters.set(ParameterId::RequiredClearance, 10.0 * gap).ok());
  const MotionCertificate certificate = certifyPath(*problem.world->makeQuery(), points, parameters);
  EXPECT_EQ(certificate.status, CertificateStatus::Certified);
  ASSERT_EQ(certificate.edges.size(), 4U);
  EXPECT_EQ(certificate.slidingEdges(), 3U);
  EXPECT_EQ(certificate.tolerance, 10.0 * gap);
  EXPECT_DOUBLE_EQ(certificate.edges[1].demand.clearance, 0.5 * gap);
  EXPECT_NEAR(certificate.edges[1].minClearance, gap, 1e-9);
  EXPECT_GE(certificate.edges[1].provedClearance, 0.5 * gap);
  EXPECT_FALSE(certificate.edges[3].demand.sliding);
  EXPECT_GE(certificate.edges[3].provedClearance, 10.0 * gap);
  std::vector<PathPoint> unmarked = points;
  for (PathPoint& point : unmarked) point.author = Author::Computer;
  EXPECT_EQ(certifyPath(*problem.world->makeQuery(), unmarked, parameters).status, CertificateStatus::Violated);
}

TEST(PathCertificate, OfOneConfigurationAndOfNone) {
  const Problem problem = windowProblem();
  const ParameterValues parameters(problem.world->objectRadius());
  const auto query = problem.world->makeQuery();
  EXPECT_EQ(certifyPath(*query, {PathPoint{problem.start}}, parameters).status, CertificateStatus::Certified);
  EXPECT_EQ(certifyPath(*query, std::vector<PathPoint>{}, parameters).status, CertificateStatus::Undecided);
  EXPECT_EQ(certifyPath(*query, std::vector<Pose>{}, 1e-5).status, CertificateStatus::Undecided);
}

TEST(PathCertificate, EveryPlannerKeepsALargerRequirement) {
  const Problem problem = windowProblem();
  for (const char* planner : {"birrt", "g", "contact-birrt", "auto", "gts"}) {
    TestHost host(problem, 200000);
    ASSERT_TRUE(host.values.set(ParameterId::RequiredClearance, 0.01).ok());
    const auto made = makePlannerRegistry().find(planner)->make(problem, 2);
    ASSERT_TRUE(made->solve(host)) << planner;
    EXPECT_GE(made->path()->certificate.provedClearance, 0.01) << planner;
    EXPECT_EQ(made->path()->certificate.edges.size() + 1, made->path()->points.size()) << planner;
  }
}

}  // namespace
}  // namespace glissade
