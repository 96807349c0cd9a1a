#include "widgets/contacts/joint_table.h"

#include <gtest/gtest.h>

#include "tests/widgets/contacts/joint_parts.h"
#include "widgets/contacts/joint_draft.h"

namespace glissade {
namespace {

using test::rowOf;
using test::screwedTable;
using Word = JointEdit::Word;

JointEdit said(const JointTable& table, const BodyId& body, Word word) { return {rowOf(table, body).key, word}; }

TEST(JointTable, HasWhatIsFoundAndWhoSaysSo) {
  const auto table = screwedTable();
  ASSERT_EQ(table->rows().size(), 3U);
  EXPECT_EQ(rowOf(*table, "screw").state, JointRowState::Recognised);
  EXPECT_EQ(rowOf(*table, "plate").state, JointRowState::Suggested);
  EXPECT_EQ(table->count(JointRowState::Suggested), 1U);
  EXPECT_FALSE(rowOf(*table, "screw").isStated());
}

TEST(JointTable, ADissolvedJointStaysAsItWasFound) {
  const auto found = screwedTable();
  const JointTable table = found->with({said(*found, "screw", Word::Dissolved)});
  ASSERT_EQ(table.rows().size(), 3U);
  EXPECT_EQ(rowOf(table, "screw").state, JointRowState::Dissolved);
  EXPECT_FALSE(rowOf(table, "screw").counts());
  EXPECT_EQ(rowOf(table, "screw").joint.clamped.size(), 1U);
}

TEST(JointTable, AnInsertThatIsPressedOutKeepsItsRow) {
  const auto found = screwedTable();
  const JointTable table = found->with({said(*found, "pin", Word::PressedOut)});
  EXPECT_EQ(rowOf(table, "pin").state, JointRowState::PressedOut);
  EXPECT_EQ(rowOf(table, "pin").key.kind, JointKind::Insert);
  EXPECT_EQ(rowOf(table, "pin").joint.kind, JointKind::Pin);
  EXPECT_TRUE(rowOf(table, "pin").isFound);
}

/// A scenario may have edits of bodies that are gone.
TEST(JointTable, AWordThatCannotBeIsARowWithTheReasonAndTheOthersCount) {
  const auto found = screwedTable();
  const JointTable table =
      found->with({{{JointKind::Screw, "nobody", {"block"}}, Word::Dissolved}, said(*found, "plate", Word::Confirmed)});
  ASSERT_EQ(table.rows().size(), 4U);
  EXPECT_EQ(table.rows().back().state, JointRowState::Refused);
  ASSERT_TRUE(table.rows().back().refusal);
  EXPECT_NE(toString(table.rows().back().refusal->reason).find("nobody"), std::string::npos);
  EXPECT_EQ(rowOf(table, "plate").state, JointRowState::Confirmed);
  EXPECT_EQ(table.shown("nobody"), QStringLiteral("nobody"));
}

TEST(JointTable, AWordTakesThePlaceOfTheOneBefore) {
  const auto table = screwedTable();
  const JointKey key{JointKind::Unit, "plate", {"block"}};
  auto words = withEdit({}, {key, Word::Confirmed});
  words = withEdit(words, {key, Word::Opened});
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words[0].word, Word::Opened);
  EXPECT_TRUE(withoutEdit(words, key).empty());
  EXPECT_TRUE(isSameJoint({JointKind::Unit, "a", {"b", "c"}}, {JointKind::Unit, "a", {"c", "b"}}));
}

TEST(JointTable, WhatOnlyAPersonHasMadeNeedsNoWordToGo) {
  const auto found = screwedTable();
  const JointEdit made = editForJoint(test::pinJoint(JointKind::Permanent), found->product());
  const JointTable table = found->with({made});
  ASSERT_EQ(table.rows().size(), 4U);
  const auto row = std::find_if(table.rows().begin(), table.rows().end(),
                                [](const JointRow& each) { return each.key.kind == JointKind::Permanent; });
  ASSERT_NE(row, table.rows().end());
  EXPECT_EQ(row->state, JointRowState::Made);
  EXPECT_FALSE(row->isFound);
  EXPECT_TRUE(withoutJoint(table.said(), *row).empty());
  const auto dissolved = withoutJoint(table.said(), rowOf(table, "screw"));
  ASSERT_EQ(dissolved.size(), 2U);
  EXPECT_EQ(dissolved[1].word, Word::Dissolved);
}

}  // namespace
}  // namespace glissade
