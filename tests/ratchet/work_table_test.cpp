#include "tests/ratchet/work_table.h"

#include <gtest/gtest.h>

namespace glissade::ratchet {
namespace {

WorkRow row(const std::string& name, std::uint64_t pairs, const std::string& family = "plan") {
  WorkRow made{family, name};
  made.work[kPairs] = pairs;
  made.reason = "first record";
  return made;
}

std::vector<WorkRow> family(std::uint64_t pairs) {
  return {row("a", pairs), row("b", 2 * pairs), row("c", 3 * pairs), row("d", 4 * pairs)};
}

TEST(WorkTable, IsReadAsItWasWritten) {
  auto rows = family(1000);
  rows[1].work[kSize] = 17;
  rows[2].reason = "the sampler draws twice, because of this, and of that";
  const std::string text = writeTable(rows);
  const auto read = readTable(text, "work.csv");
  ASSERT_TRUE(read) << toString(read.error());
  EXPECT_EQ(writeTable(*read), text);
}

TEST(WorkTable, ARowWithoutAReasonIsRefused) {
  auto rows = family(1000);
  rows[2].reason.clear();
  const auto read = readTable(writeTable(rows), "work.csv");
  ASSERT_FALSE(read);
  EXPECT_EQ(toString(read.error().location), "line 4");
}

TEST(WorkTable, EqualAndSmallerWorkPass) {
  EXPECT_TRUE(risen(family(1000), family(1000)).empty());
  EXPECT_TRUE(risen(family(1000), family(100)).empty());
}

TEST(WorkTable, ASingleCaseMayRiseByHalf) {
  auto now = family(1000);
  now[0] = row("a", 1190);
  EXPECT_TRUE(risen(family(1000), now).empty());
  now[0] = row("a", 1510);
  EXPECT_EQ(risen(family(1000), now).size(), 2U);  // the case and its family
}

TEST(WorkTable, AFamilyMayNotRiseByMoreThanATwentieth) {
  EXPECT_TRUE(risen(family(1000), family(1049)).empty());
  const auto faults = risen(family(1000), family(1060));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0], "family plan: the geometric mean of pairs rose 1.06 times");
}

TEST(WorkTable, CasesAndMeasuresWithoutARecordAreNamed) {
  auto now = family(1000);
  now.push_back(row("new", 5));
  now[1].work[kSize] = 3;
  now[2].work[kPairs].reset();
  EXPECT_EQ(risen(family(1000), now).size(), 3U);
}

TEST(WorkTable, WhatWasNotCarriedOutIsNoFault) { EXPECT_TRUE(risen(family(1000), {row("a", 1000)}).empty()); }

TEST(WorkTable, RecordingReplacesWhatChangedAndKeepsTheOtherReasons) {
  auto now = family(1000);
  now[3] = row("d", 9000);
  now.push_back(row("e", 1));
  const auto rows = recorded(family(1000), now, "the bound is tighter");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].reason, "first record");
  EXPECT_EQ(rows[3].reason, "the bound is tighter");
  EXPECT_EQ(*rows[3].work[kPairs], 9000U);
}

}  // namespace
}  // namespace glissade::ratchet
