#include "engine/sequence/holding.h"

#include <gtest/gtest.h>

#include "engine/sequence/motion_trial.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A base, a cover on it that a bolt and its nut clamp, and a block that touches nothing.
class HoldingTest : public testing::Test {
 protected:
  enum : std::size_t { kBase, kCover, kBolt, kNut, kApart, kBodies };

  static std::vector<RigidBody> blocks() {
    std::vector<RigidBody> bodies;
    for (const char* name : {"base", "cover", "bolt", "nut", "apart"}) {
      bodies.push_back(
          boxBody(name, {0.1, 0.1, 0.1}, Pose::translation({0.2 * static_cast<double>(bodies.size()), 0.0, 0.0})));
    }
    return bodies;
  }
  static Joints nutOnBolt() {
    Joint nut;
    nut.kind = JointKind::Nut;
    nut.body = kNut;
    nut.others = {kBolt};
    nut.clamped = {kBase, kCover};
    return {nut};
  }
  static std::vector<Contact> contacts() {
    std::vector<Contact> contacts(1);
    contacts[0].a = kBase;
    contacts[0].b = kCover;
    contacts[0].kind = ContactKind::Planar;
    return contacts;
  }
  static BodySet without(std::initializer_list<std::size_t> bodies) {
    BodySet remaining(kBodies, true);
    for (const std::size_t body : bodies) remaining[body] = false;
    return remaining;
  }

  AssembledProduct product_ = test::productOf(blocks());
  JointRules joints_{nutOnBolt(), product_, std::vector<FastenerKind>(kBodies, FastenerKind::None)};
  LiaisonGraph liaisons_{kBodies, contacts(), nutOnBolt()};
  ProductFits fits_ = test::fitsOf(product_);
  MotionTrial trial_{product_, fits_, 1, 0};
  SequenceQuestion question_{product_, {true, false, false, false, false}, 1, trial_};

  Holding holding() {
    question_.joints = &joints_;
    question_.liaisons = &liaisons_;
    return Holding(question_);
  }
};

TEST_F(HoldingTest, ABodyThatTouchesNothingThatRemainsIsInTheAir) {
  const Holding holding = this->holding();
  EXPECT_TRUE(holding.isInAir({kApart}, without({kApart})));
  EXPECT_FALSE(holding.isInAir({kCover}, without({kCover})));
  EXPECT_TRUE(holding.isInAir({kBolt}, without({kBolt, kNut}))) << "only its nut is joined to it";
  question_.liaisons = nullptr;
  EXPECT_FALSE(Holding(question_).isInAir({kApart}, without({kApart}))) << "nothing is known of contacts";
}

TEST_F(HoldingTest, ABodyOnOneThatNothingHoldsToTheBaseIsInTheAir) {
  std::vector<Contact> contacts = this->contacts();
  contacts.push_back(contacts.front());
  contacts.back().a = kBolt;
  contacts.back().b = kApart;
  liaisons_ = LiaisonGraph(kBodies, contacts, nutOnBolt());
  const Holding holding = this->holding();
  EXPECT_FALSE(holding.isInAir({kApart}, without({kApart})));
  EXPECT_FALSE(holding.isInAir({kBolt}, without({kBolt})));
  EXPECT_TRUE(holding.isInAir({kBolt}, without({kBolt, kNut}))) << "it touches a body that nothing holds";
}

TEST_F(HoldingTest, WithoutTheNutTheCoverAndTheBoltAreUnfastened) {
  const Holding holding = this->holding();
  EXPECT_EQ(holding.unfastened(without({})), 0U);
  EXPECT_EQ(holding.unfastened(without({kApart})), 0U) << "it was never fastened";
  EXPECT_EQ(holding.unfastened(without({kNut})), 2U);
  EXPECT_EQ(holding.unfastened(without({kNut, kBolt})), 1U);
  EXPECT_EQ(holding.unfastened(without({kNut, kBolt, kCover})), 0U);
}

TEST_F(HoldingTest, AStackIsOpenWhileAPartOfItRemains) {
  const Holding holding = this->holding();
  EXPECT_EQ(holding.openStacks(without({})), 0U);
  EXPECT_EQ(holding.openStacks(without({kNut})), 1U);
  EXPECT_EQ(holding.openStacks(without({kNut, kBolt})), 0U);
}

}  // namespace
}  // namespace glissade
