#include "widgets/contacts/joint_dialog.h"

#include <gtest/gtest.h>

#include "tests/widgets/contacts/joint_parts.h"
#include "widgets/contacts/joint_draft.h"

namespace glissade {
namespace {

class JointDialogTest : public ::testing::Test {
 protected:
  JointDialogTest()
      : product(test::screwedProduct()), dialog(product, draftJoint(*product, {0, 1, 2}), [this](const Joint& joint) {
          given = joint;
          return answer;
        }) {}

  template <class Field>
  Field& field(const char* name) {
    return *dialog.findChild<Field*>(QLatin1String(name));
  }
  void chooseKind(JointKind kind) {
    auto& kinds = field<QComboBox>("kind");
    kinds.setCurrentIndex(kinds.findData(static_cast<int>(kind)));
  }

  ProductPtr product;
  Outcome answer = Done{};
  std::optional<Joint> given;
  JointDialog dialog;
};

TEST_F(JointDialogTest, TheSmallestBodyLeavesAndItsShapeSaysTheRest) {
  dialog.accept();
  ASSERT_TRUE(given);
  EXPECT_EQ(given->kind, JointKind::Screw);
  EXPECT_EQ(given->body, 1U);
  EXPECT_EQ(given->others, (std::vector<std::size_t>{0, 2}));
  EXPECT_GT(given->direction.z(), 0.999) << "it leaves on the side of its head";
  EXPECT_NEAR(given->thread->diameter, 0.005, 1e-5);
  EXPECT_NEAR(given->thread->pitch, 0.0008, 1e-9);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST_F(JointDialogTest, OnlyTheFieldsOfTheKindAreShown) {
  EXPECT_FALSE(field<QuantityBox>("pitch").isHidden());
  EXPECT_FALSE(field<QListWidget>("clamped").isHidden());
  EXPECT_TRUE(field<QuantityBox>("bend").isHidden());
  chooseKind(JointKind::Snap);
  EXPECT_TRUE(field<QuantityBox>("pitch").isHidden());
  EXPECT_FALSE(field<QuantityBox>("bend").isHidden());
  EXPECT_FALSE(field<QComboBox>("direction").isHidden());
  chooseKind(JointKind::Permanent);
  EXPECT_TRUE(field<QComboBox>("direction").isHidden());
}

TEST_F(JointDialogTest, WhatIsGivenIsTaken) {
  field<QListWidget>("clamped").item(0)->setCheckState(Qt::Checked);
  field<QuantityBox>("pitch").setValue(0.5);
  dialog.findChild<QCheckBox*>()->setChecked(true);
  field<QComboBox>("direction").setCurrentIndex(1);
  field<QLineEdit>("designation").setText(QStringLiteral(" DIN 912 M5x20 "));
  dialog.accept();
  ASSERT_TRUE(given);
  EXPECT_EQ(given->clamped, std::vector<std::size_t>{0});
  EXPECT_EQ(given->others, std::vector<std::size_t>{2});
  EXPECT_NEAR(given->thread->pitch, -0.0005, 1e-9);
  EXPECT_LT(given->direction.z(), -0.999);
  EXPECT_EQ(given->designation, "DIN 912 M5x20");
}

TEST_F(JointDialogTest, ARefusalIsSaidAndTheDialogStays) {
  answer = Diagnostic{ErrorKind::Usage, "", "", Message("it has one body only"), Message("Give another one.")};
  dialog.accept();
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  EXPECT_TRUE(field<QLabel>("refusal").text().startsWith(QStringLiteral("It has one body only.")));
}

TEST_F(JointDialogTest, AThreadIsInOneOfTheBodies) {
  for (const int row : {0, 1}) field<QListWidget>("clamped").item(row)->setCheckState(Qt::Checked);
  dialog.accept();
  EXPECT_FALSE(given);
  EXPECT_TRUE(field<QLabel>("refusal").text().contains(QStringLiteral("Uncheck")));
}

TEST_F(JointDialogTest, AnotherBodyThatLeavesHasItsOwnAxis) {
  auto& bodies = field<QComboBox>("body");
  bodies.setCurrentIndex(bodies.findData(static_cast<qulonglong>(0)));
  dialog.accept();
  ASSERT_TRUE(given);
  EXPECT_EQ(given->body, 0U);
  EXPECT_EQ(given->others, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(given->kind, JointKind::Screw) << "the kind is the person's";
}

TEST(JointDraft, AWordHasNothingThatItsKindHasNoUseFor) {
  const ProductPtr product = test::screwedProduct();
  Joint joint = test::screwJoint();
  joint.bend = 0.001;
  const JointEdit screw = editForJoint(joint, *product);
  EXPECT_TRUE(screw.made->thread->isPitchStated);
  EXPECT_EQ(screw.made->bend, 0.0);
  EXPECT_EQ(screw.clamped, std::vector<BodyId>{"plate"});
  joint.kind = JointKind::Permanent;
  const JointEdit permanent = editForJoint(joint, *product);
  EXPECT_FALSE(permanent.made->thread);
  EXPECT_EQ(permanent.key.others, (std::vector<BodyId>{"block", "plate"}));
  EXPECT_TRUE(permanent.clamped.empty());
}

}  // namespace
}  // namespace glissade
