// Findings: read strictly and written back. samples/studies checks them against results.
#include <gtest/gtest.h>

#include "engine/study/study_plan.h"
#include "engine/study/study_reader.h"
#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using Json = nlohmann::json;

Json finding() {
  return Json::parse(R"({"text": "People beat none", "measure": "nodes", "statistic": "median", "over": "solved",
    "cells": {"rows": ["steps"]}, "is": "below", "than": {"rows": ["plain"]}, "factor": 0.1})");
}

Result<Study> parse(const Json& finding, bool quick = false) {
  Json study = test::tinyStudy();
  study["findings"] = nlohmann::json::array({finding});
  return parseStudy(study.dump(), "study.json", quick);
}

TEST(Finding, IsReadAndWrittenBack) {
  const test::StudyFiles files([] {
    Json study = test::tinyStudy();
    study["findings"] = nlohmann::json::array({finding()});
    return study;
  }());
  Warnings warnings;
  const auto plan = planStudy(files.file, false, warnings);
  ASSERT_TRUE(plan.ok()) << toString(plan.error().reason);
  const auto again = readPlan(writePlan(*plan), "plan.json");
  ASSERT_TRUE(again.ok()) << toString(again.error().reason);
  ASSERT_EQ(again->study.heading.findings.size(), 1U);
  EXPECT_EQ(again->study.heading.findings.front().text, "People beat none");
  EXPECT_EQ(again->study.heading.findings.front().factor, 0.1);
  EXPECT_EQ(writePlan(*again), writePlan(*plan));
}

TEST(Finding, WhatCannotBeMeantIsRefusedAtItsPlace) {
  const auto expectRefused = [](const char* pointer, const Json& value, const std::string& place) {
    Json broken = finding();
    broken[Json::json_pointer(pointer)] = value;
    const auto study = parse(broken);
    ASSERT_FALSE(study.ok()) << pointer;
    EXPECT_EQ(toString(study.error().location), "/findings/0" + place);
  };
  expectRefused("/measure", "noses", "/measure");
  expectRefused("/is", "beside", "/is");
  expectRefused("/cells/rows", {"nowhere"}, "/cells/rows/0");
  expectRefused("/than/rows", {"nowhere"}, "/than/rows/0");
  expectRefused("/than/strategies", {"magic"}, "/than/strategies/0");
  expectRefused("/cells/rows", Json::array(), "/cells/rows");
  expectRefused("/factor", -1, "/factor");
  expectRefused("/than", 3, "/factor");
  expectRefused("/pair_by", {"weather"}, "/pair_by/0");
  expectRefused("/more", 1, "/more");
}

TEST(Finding, NamesOfRowsThatQuickLeavesOutAreKnown) {
  const auto study = parse(finding(), true);
  ASSERT_TRUE(study.ok()) << toString(study.error().reason);
}

}  // namespace
}  // namespace glissade
