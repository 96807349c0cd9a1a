// Findings: read strictly, written back, and checked against results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/study/finding_check.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_reader.h"
#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

Json finding() {
  return Json::parse(R"({"text": "People beat none", "measure": "nodes", "statistic": "median", "over": "solved",
    "cells": {"rows": ["steps"]}, "is": "below", "than": {"rows": ["plain"]}, "factor": 0.1})");
}

Result<Study> parse(const Json& finding, bool quick = false) {
  Json study = test::tinyStudy();
  study["findings"] = {finding};
  return parseStudy(study.dump(), "study.json", quick);
}

/// Solved runs with these numbers of nodes, for each cell.
std::vector<CellSummary> summariesOf(const std::vector<std::vector<double>>& nodes) {
  std::vector<CellSummary> summaries;
  for (const auto& sample : nodes) {
    CellSummary summary;
    summary.planned = summary.runs = 4;
    summary.statuses[static_cast<std::size_t>(RunStatus::Solved)] = sample.size();
    summary.success = wilson95(sample.size(), summary.runs);
    summary.measures = {{"nodes", distributionOf(sample), distributionOf(sample)}};
    summaries.push_back(summary);
  }
  return summaries;
}

CheckedFinding checked(const Json& finding, const std::vector<std::vector<double>>& nodes) {
  const auto study = parse(finding);
  return checkFinding(study->heading.findings.front(), *study, summariesOf(nodes));
}

TEST(Finding, IsReadAndWrittenBack) {
  const test::StudyFiles files([] {
    Json study = test::tinyStudy();
    study["findings"] = {finding()};
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
  const CheckedFinding result = checkFinding(study->heading.findings.front(), *study, summariesOf({{5, 6}}));
  EXPECT_EQ(result.verdict, Verdict::Open);
  EXPECT_EQ(result.compared, 0U);
}

TEST(Finding, HoldsWhenEveryPairDoes) {
  const CheckedFinding result = checked(finding(), {{1000, 1000}, {90, 90}, {50, 50}});
  EXPECT_EQ(result.verdict, Verdict::Holds);
  EXPECT_EQ(result.compared, 2U);
  EXPECT_EQ(result.agreeing, 2U);
  EXPECT_THAT(result.numbers, HasSubstr("90 against plain: 1000, 0.09 times"));
}

TEST(Finding, IsRefutedByOnePairAndNamesIt) {
  const CheckedFinding result = checked(finding(), {{1000, 1000}, {90, 90}, {120, 120}});
  EXPECT_EQ(result.verdict, Verdict::Refuted);
  EXPECT_EQ(result.agreeing, 1U);
  EXPECT_THAT(result.numbers, HasSubstr("0.12 times; wanted below 0.1"));
}

TEST(Finding, StaysOpenWhereARowWasNeverSolved) {
  const CheckedFinding result = checked(finding(), {{}, {90}, {50}});
  EXPECT_EQ(result.verdict, Verdict::Open);
  EXPECT_THAT(result.numbers, HasSubstr("plain was never solved"));
}

TEST(Finding, ComparesWithANumber) {
  Json share = Json::parse(R"({"text": "t", "measure": "success_rate", "cells": {"rows": ["plain"]},
                               "is": "above", "than": 0.6})");
  EXPECT_EQ(checked(share, {{1, 1, 1}, {1}, {1}}).verdict, Verdict::Holds);
  EXPECT_EQ(checked(share, {{1, 1}, {1}, {1}}).verdict, Verdict::Refuted);
}

}  // namespace
}  // namespace glissade
