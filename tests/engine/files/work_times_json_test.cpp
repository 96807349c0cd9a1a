#include "engine/files/work_times_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/file_save.h"

namespace glissade {
namespace {

std::string fileWith(const std::string& content) {
  const std::string file = testing::TempDir() + "/work_times.json";
  EXPECT_TRUE(saveFile(file, content));
  return file;
}

std::string tableWith(const std::string& times) {
  return R"({"format": "glissade-work-times", "version": 1, "times": )" + times + "}";
}

TEST(WorkTimesJson, ASavedTableIsReadAgain) {
  WorkTimes times;
  times.fetch = 4.25;
  times.aidAbove = 12.0;
  const std::string file = testing::TempDir() + "/saved_times.json";
  ASSERT_TRUE(saveWorkTimes(times, file));
  const auto read = readWorkTimes(file);
  ASSERT_TRUE(read) << toString(read.error());
  EXPECT_EQ(*read, times);
}

TEST(WorkTimesJson, WhatAFileLeavesOutKeepsItsDefault) {
  const auto read = readWorkTimes(fileWith(tableWith(R"({"hold_s": 3})")));
  ASSERT_TRUE(read) << toString(read.error());
  WorkTimes expected;
  expected.hold = 3.0;
  EXPECT_EQ(*read, expected);
}

TEST(WorkTimesJson, ValuesAreFromZeroToTheMostOfTheirRow) {
  for (const WorkTimeRow& row : workTimeRows()) {
    EXPECT_TRUE(checkWorkTime(row, 0.0)) << row.id;
    EXPECT_TRUE(checkWorkTime(row, row.most)) << row.id;
    for (const double wrong : {-0.001, row.most * 1.001, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
      EXPECT_FALSE(checkWorkTime(row, wrong)) << row.id << " " << wrong;
    }
  }
}

TEST(WorkTimesJson, TheReaderSaysWhatIsWrongAndWhere) {
  const auto late = readWorkTimes(fileWith(tableWith(R"({"fetch_s": 3601})")));
  ASSERT_FALSE(late);
  EXPECT_EQ(toString(late.error().location), "/times/fetch_s");
  EXPECT_EQ(toString(late.error().reason), "is not from 0 to 3600");
  const auto unknown = readWorkTimes(fileWith(tableWith(R"({"sing_s": 1})")));
  ASSERT_FALSE(unknown);
  EXPECT_EQ(toString(unknown.error().location), "/times/sing_s");
}

}  // namespace
}  // namespace glissade
