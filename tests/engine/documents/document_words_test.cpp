#include "engine/documents/document_words.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(DocumentWords, PutsArgumentsWhereTheLanguageHasThem) {
  const DocumentWords english;
  const DocumentWords french(Language::French);
  EXPECT_EQ(english(GLISSADE_TEXT("%1 of %2"), {"3", "4"}), "3 of 4");
  EXPECT_EQ(french(GLISSADE_TEXT("%1 of %2"), {"3", "4"}), "3 sur 4");
  EXPECT_EQ(english(std::string("success rate in %.")), "success rate in %.");
  EXPECT_EQ(french(GLISSADE_TEXT("Step %1: %2"), {"%2", "x"}),
            "Étape %2 : x");  // placeholders within arguments are not replaced
}

TEST(DocumentWords, WhatIsNotKnownStaysAsItIs) {
  const DocumentWords french(Language::French);
  EXPECT_FALSE(hasFrench("My own finding."));
  EXPECT_EQ(french(std::string("My own finding.")), "My own finding.");
  EXPECT_EQ(languageOf("de"), std::nullopt);
  EXPECT_EQ(languageOf(code(Language::French)), Language::French);
}

}  // namespace
}  // namespace glissade
