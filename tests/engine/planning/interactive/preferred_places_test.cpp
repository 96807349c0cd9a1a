#include "engine/planning/interactive/preferred_places.h"

#include <gtest/gtest.h>

#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/planning/interactive/hand_partner.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// Draws one configuration that no place holds.
class OneConfiguration final : public ConfigurationSampler {
 public:
  static Pose pose() { return Pose::translation({100.0, 0.0, 0.0}); }
  Pose draw(const Box3& /*tree*/) override { return pose(); }
};

class Preferences : public testing::Test {
 protected:
  Preferences() {
    const auto built = buildSceneKnowledge(problem, 1e-5);
    if (built) problem.scene.knowledge = *built;
  }

  const Place& place() const { return problem.scene.knowledge->environment->map.places.front(); }
  SemanticEditsPtr preferring(double preference) const {
    SemanticEdits edits;
    edits.places.push_back({place().anchor, {}, {{"preference", preference}}});
    return std::make_shared<const SemanticEdits>(edits);
  }
  /// Number of draws in the place, of a thousand by a sampler that the partner makes for a member.
  int drawnThere(const HandPartner& partner) const {
    const SamplingRegion region(problem.scene.knowledge->environment->map.grid, place().cells);
    const auto sampler = partner.sampler(std::make_unique<OneConfiguration>(), 1, false);
    int there = 0;
    for (int i = 0; i < 1000; ++i) {
      const Pose q = sampler->draw(problem.bounds);
      if (region.contains(q.position)) {
        ++there;
      } else {
        EXPECT_EQ(q, OneConfiguration::pose());
      }
    }
    return there;
  }

  Problem problem = windowProblem();
};

TEST_F(Preferences, MembersDrawFromThePlaceThatIsPreferredAsLongAsItIs) {
  ASSERT_TRUE(problem.scene.knowledge);
  HandPartner partner(problem, 1);
  TestHost host(problem);
  partner.takesTurn(host);
  EXPECT_EQ(drawnThere(partner), 0);
  host.edits = preferring(10.0);
  partner.takesTurn(host);
  EXPECT_NEAR(drawnThere(partner), 1000 * PreferredSampler::kShare, 60);
  host.edits = preferring(1.0);
  partner.takesTurn(host);
  EXPECT_EQ(drawnThere(partner), 0);
}

TEST_F(Preferences, WithoutKnowledgeOfThePlacesNoneIsPreferred) {
  ASSERT_TRUE(problem.scene.knowledge);
  Problem unknown = problem;
  unknown.scene.knowledge = nullptr;
  HandPartner partner(unknown, 1);
  TestHost host(unknown);
  host.edits = preferring(10.0);
  partner.takesTurn(host);
  EXPECT_EQ(drawnThere(partner), 0);
}

}  // namespace
}  // namespace glissade
