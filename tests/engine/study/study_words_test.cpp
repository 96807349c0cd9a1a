#include "engine/study/study_words.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "engine/base/file.h"
#include "engine/study/finding_check.h"
#include "engine/study/run_result.h"
#include "engine/study/study_reader.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

TEST(StudyWords, PutsArgumentsWhereTheLanguageHasThem) {
  const StudyWords english;
  const StudyWords french(Language::French);
  EXPECT_EQ(english(GLISSADE_TEXT("%1 of %2"), {"3", "4"}), "3 of 4");
  EXPECT_EQ(french(GLISSADE_TEXT("%1 of %2"), {"3", "4"}), "3 sur 4");
  EXPECT_EQ(english(std::string("success rate in %.")), "success rate in %.");
  EXPECT_EQ(french(GLISSADE_TEXT("%1 over %2"), {"%2", "x"}),
            "%2 selon x");  // placeholders within arguments are not replaced
}

TEST(StudyWords, WhatIsNotKnownStaysAsItIs) {
  const StudyWords french(Language::French);
  EXPECT_FALSE(hasFrench("My own finding."));
  EXPECT_EQ(french(std::string("My own finding.")), "My own finding.");
  EXPECT_EQ(languageOf("de"), std::nullopt);
  EXPECT_EQ(languageOf(code(Language::French)), Language::French);
}

/// All sentences of a study of the papers.
std::set<std::string> sentencesOf(const Study& study) {
  std::set<std::string> sentences{study.heading.title, study.heading.description};
  for (const Finding& finding : study.heading.findings) sentences.insert(finding.text);
  for (const PaperColumn& column : study.heading.paper) sentences.insert(column.title);
  for (const StudyCell& cell : study.cells) {
    const auto note = cell.paper.find("note");
    const auto* text = note == cell.paper.end() ? nullptr : std::get_if<std::string>(&note->second);
    if (text != nullptr) sentences.insert(*text);
  }
  return sentences;
}

TEST(StudyWords, ThePapersStudiesAreWhollyTranslated) {
  const std::filesystem::path folder = std::filesystem::path(test::sourceDirectory()) / "samples/studies";
  std::size_t studies = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const auto text = readFile(entry.path().string(), 1U << 20U);
    const auto study = parseStudy(*text, entry.path().string(), false);
    ASSERT_TRUE(study.ok()) << toString(study.error());
    ++studies;
    for (const std::string& sentence : sentencesOf(*study)) EXPECT_TRUE(hasFrench(sentence)) << sentence;
  }
  EXPECT_GE(studies, 7U);
  for (std::size_t i = 0; i < kRunStatusCount; ++i) {
    EXPECT_TRUE(hasFrench(kRunStatusNames.of(static_cast<RunStatus>(i))));
  }
  for (const Verdict verdict : {Verdict::Holds, Verdict::Refuted, Verdict::Open}) {
    EXPECT_TRUE(hasFrench(name(verdict)));
  }
}

}  // namespace
}  // namespace glissade
