#include "engine/files/kept_path.h"

#include <gtest/gtest.h>

#include "engine/files/kept_path_proof.h"
#include "engine/files/same_problem.h"
#include "tests/engine/files/path_fixture.h"

namespace glissade {
namespace {

class KeptPathTest : public test::PathFixture {
 protected:
  /// The path of the fixture leads from the start to the goal of its scenario.
  void SetUp() override {
    PathFixture::SetUp();
    Scenario scenario = scenario_.scenario;
    scenario.start = path_.points.front().q;
    scenario.goal = path_.points.back().q;
    scenario_ = *loadGeometry(scenario, folder_.path(), "boxes.json");
  }
  KeptPath kept(const std::string& name) const { return keptPath(name, path_, provenance_, true, scenario_); }
  static Scenario with(Scenario scenario, const KeptPath& path) {
    scenario.paths.push_back(std::make_shared<const KeptPath>(path));
    return scenario;
  }
};

TEST_F(KeptPathTest, ComeBackFromAFileBitByBit) {
  KeptPath first = kept("Path 1");
  first.pinned = true;
  first.allowances = {{"wall", ContactKind::Contact, 0.0, 1.0 / 3000.0}};
  first.points[1].segmentAuthor = Author::Operator;
  const Scenario before = with(with(scenario_.scenario, first), kept("été \"2\""));
  const auto after = parseScenario(writeScenario(before), "boxes.json");
  ASSERT_TRUE(after.ok()) << toString(after.error());
  ASSERT_EQ(after->paths.size(), 2U);
  const KeptPath& read = *after->paths[0];
  EXPECT_EQ(after->paths[1]->name, "été \"2\"");
  EXPECT_TRUE(hasPoints(read, first.points));
  EXPECT_EQ(read.points[1].segmentAuthor, Author::Operator);
  EXPECT_EQ(read.points[1].author, Author::Contact);
  ASSERT_EQ(read.allowances.size(), 1U);
  EXPECT_EQ(read.allowances.front().body, "wall");
  EXPECT_EQ(read.allowances.front().allowance, 1.0 / 3000.0);
  EXPECT_EQ(read.provenance.planner, "birrt");
  EXPECT_EQ(read.provenance.seed, 7U);
  EXPECT_EQ(read.clearance, first.clearance);
  EXPECT_EQ(read.provedClearance, first.provedClearance);
  EXPECT_EQ(read.requiredClearance, first.requiredClearance);
  EXPECT_TRUE(read.pinned && read.smoothed);
  EXPECT_EQ(writeScenario(*after), writeScenario(before));
}

TEST_F(KeptPathTest, AreNoPartOfTheProblem) {
  EXPECT_EQ(problemSha256(with(scenario_.scenario, kept("a"))), problemSha256(scenario_.scenario));
}

TEST_F(KeptPathTest, AreRefusedWithTheirPlaceWhereTheyAreWrong) {
  const std::string good = writeScenario(with(with(scenario_.scenario, kept("a")), kept("b")));
  const auto refused = [&good](const std::string& what, const std::string& by, const std::string& place) {
    std::string text = good;
    const std::size_t at = text.rfind(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
    const auto read = parseScenario(text, "boxes.json");
    ASSERT_FALSE(read.ok()) << by;
    EXPECT_NE(toString(read.error()).find(place), std::string::npos) << toString(read.error());
  };
  refused("\"name\": \"b\"", "\"name\": \"a\"", "/paths/1/name");
  refused("\"name\": \"b\"", "\"name\": \"\"", "/paths/1/name");
  refused("\"author\": \"operator\"", "\"author\": \"nobody\"", "/paths/1/configurations/2/author");
  refused("\"required_clearance\": ", "\"required_clearance\": -", "/paths/1/required_clearance");
  refused("\"smoothed\": true", "\"smoothed\": 1", "/paths/1/smoothed");
}

TEST_F(KeptPathTest, AreProvedAgainOrSayWhatIsInTheWay) {
  const KeptPathProof proof = proveAgain(kept("a"), scenario_);
  EXPECT_EQ(proof.state, KeptPathState::Holds);
  ASSERT_NE(proof.path, nullptr);
  EXPECT_EQ(proof.path->certificate.status, CertificateStatus::Certified);

  Scenario moved = scenario_.scenario;
  moved.bodies.front().pose.position = path_.points[1].q.position;
  const auto blocked = loadGeometry(moved, folder_.path(), "boxes.json");
  ASSERT_TRUE(blocked.ok());
  const KeptPathProof blockedProof = proveAgain(kept("a"), *blocked);
  EXPECT_EQ(blockedProof.state, KeptPathState::Blocked);
  EXPECT_EQ(blockedProof.blockedBy, moved.bodies.front().id);

  Scenario elsewhere = scenario_.scenario;
  elsewhere.start.position.x() -= 0.01;
  EXPECT_EQ(proveAgain(kept("a"), *loadGeometry(elsewhere, folder_.path(), "b.json")).state, KeptPathState::OtherEnds);

  KeptPath other = kept("a");
  other.object = "another";
  EXPECT_EQ(proveAgain(other, scenario_).state, KeptPathState::OtherObject);

  StopSource stop;
  stop.requestStop();
  EXPECT_EQ(proveAgain(kept("a"), scenario_, WorkWatch(stop.token(), {})).state, KeptPathState::Unknown);
}

TEST_F(KeptPathTest, GetNamesThatAreFree) {
  KeptPaths paths;
  for (const char* expected : {"p", "p 2", "p 3"}) {
    const std::string name = freePathName(paths, "p");
    EXPECT_EQ(name, expected);
    paths.push_back(std::make_shared<const KeptPath>(kept(name)));
  }
}

}  // namespace
}  // namespace glissade
