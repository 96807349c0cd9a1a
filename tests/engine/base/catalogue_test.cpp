// Every text that GLISSADE_TEXT marks has a French translation, with the same placeholders.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "engine/base/french_texts.h"
#include "engine/base/message.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The content of a C++ string literal.
std::string withoutEscapes(const std::string& literal) {
  std::string text;
  for (std::size_t i = 0; i < literal.size(); ++i) {
    if (literal[i] != '\\' || i + 1 == literal.size()) {
      text += literal[i];
    } else {
      ++i;
      text += literal[i] == 'n' ? '\n' : literal[i];
    }
  }
  return text;
}

/// The texts that a source marks. Literals that follow each other are one text.
std::set<std::string> textsIn(const std::string& source) {
  static const std::regex literal(R"re(\s*"((?:[^"\\]|\\.)*)")re");
  const std::string macro = "GLISSADE_TEXT(";
  std::set<std::string> texts;
  for (std::size_t at = source.find(macro); at != std::string::npos; at = source.find(macro, at + 1)) {
    std::string text;
    auto from = source.begin() + static_cast<std::ptrdiff_t>(at + macro.size());
    std::smatch match;
    while (std::regex_search(from, source.end(), match, literal, std::regex_constants::match_continuous)) {
      text += withoutEscapes(match[1]);
      from = match[0].second;
    }
    if (!text.empty()) texts.insert(text);
  }
  return texts;
}

/// The placeholders of a text, without order.
std::multiset<char> placeholdersOf(std::string_view text) {
  std::multiset<char> found;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '%' && text[i + 1] >= '1' && text[i + 1] <= '9') found.insert(text[i + 1]);
  }
  return found;
}

TEST(Catalogue, EveryTextHasFrench) {
  const fs::path root = test::sourceDirectory();
  std::size_t found = 0;
  for (const char* folder : {"engine", "app", "widgets"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      for (const std::string& text : textsIn(contentOf(entry.path()))) {
        ++found;
        EXPECT_TRUE(hasFrench(text)) << entry.path().filename() << ": \"" << text
                                     << "\" has no French: run packaging/translations.sh, then translate it";
      }
    }
  }
  EXPECT_GT(found, 1000U) << "the sources are read as if they had few texts";
}

TEST(Catalogue, FrenchHasThePlaceholdersOfEnglish) {
  for (const FrenchText& text : frenchTexts()) {
    EXPECT_EQ(placeholdersOf(text.french), placeholdersOf(text.english)) << text.english;
    EXPECT_FALSE(text.french.empty()) << text.english;
  }
}

/// True if each "{" begins two forms of a word for a number that the text shows.
bool hasWholeForms(std::string text) {
  static const std::regex forms(R"re(\{([1-9])\|([^{}|]+)\|([^{}|]+)\})re");
  std::smatch match;
  const std::string whole = text;
  while (std::regex_search(text, match, forms)) {
    if (whole.find("%" + match[1].str()) == std::string::npos) return false;
    text = match.prefix().str() + match.suffix().str();
  }
  return text.find('|') == std::string::npos || text.find('{') == std::string::npos;
}

TEST(Catalogue, FormsOfWordsBelongToShownNumbers) {
  std::size_t found = 0;
  for (const FrenchText& text : frenchTexts()) {
    EXPECT_TRUE(hasWholeForms(std::string(text.english))) << text.english;
    EXPECT_TRUE(hasWholeForms(std::string(text.french))) << text.french;
    if (text.english.find('|') != std::string_view::npos) ++found;
  }
  EXPECT_GT(found, 20U);
  EXPECT_FALSE(hasWholeForms("%1 {2|part|parts}"));
  EXPECT_FALSE(hasWholeForms("%1 {1|part}"));
}

TEST(Catalogue, TextsAreReadFromSources) {
  EXPECT_EQ(textsIn(R"(f(GLISSADE_TEXT("a \"b\" "
                "c"), {x}, GLISSADE_TEXT("d"));)"),
            (std::set<std::string>{"a \"b\" c", "d"}));
}

}  // namespace
}  // namespace glissade
