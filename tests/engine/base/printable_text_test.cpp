#include "engine/base/printable_text.h"

#include <gtest/gtest.h>

#include "engine/base/diagnostic.h"
#include "engine/base/random_stream.h"
#include "engine/base/utf8.h"

namespace glissade {
namespace {

const std::string kReplaced = "\xEF\xBF\xBD";

TEST(PrintableText, KeepsWhatCanBeShown) {
  for (const std::string text :
       {"", "plain", "Läufer €", "two\nlines\tand a tab", "\xF0\x9F\x94\xA7", "\xD7\x90\xE2\x80\x8F"}) {
    EXPECT_EQ(printableText(text), text);
  }
}

TEST(PrintableText, ReplacesEveryInvalidByte) {
  EXPECT_EQ(printableText("a\xFF\xFE"
                          "b"),
            "a" + kReplaced + kReplaced + "b");
  EXPECT_EQ(printableText("\xC3"), kReplaced);
  EXPECT_EQ(printableText("\xED\xA0\x80"), kReplaced + kReplaced + kReplaced);  // a surrogate
}

TEST(PrintableText, ReplacesControlCharactersAndReordering) {
  EXPECT_EQ(printableText("\x1b[31m"), kReplaced + "[31m");
  EXPECT_EQ(printableText("a\rb"), "a" + kReplaced + "b");
  EXPECT_EQ(printableText(std::string("a\0b", 3)), "a" + kReplaced + "b");
  EXPECT_EQ(printableText("\x7f"), kReplaced);
  EXPECT_EQ(printableText("\xC2\x9B"
                          "31m"),
            kReplaced + "31m");  // CSI of C1
  for (const std::string reordering : {"\u202a", "\u202e", "\u2066", "\u2069", "\u2028", "\u2029"}) {
    EXPECT_EQ(printableText(reordering), kReplaced);
  }
}

TEST(PrintableText, OneLineHasNoLineFeedAndNoTab) {
  EXPECT_EQ(printableLine("a\nb\tc"), "a" + kReplaced + "b" + kReplaced + "c");
}

TEST(PrintableText, AnyBytesBecomeValidAndStayAsTheyAreFromThenOn) {
  RandomStream random(7, "printable text");
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(static_cast<std::size_t>(random.uniform(0.0, 12.0)), ' ');
    for (char& byte : bytes) byte = static_cast<char>(random.bits());
    const std::string shown = printableText(bytes);
    EXPECT_TRUE(isUtf8(shown));
    EXPECT_EQ(printableText(shown), shown);
    EXPECT_EQ(printableLine(shown).find_first_of("\n\t\x1b\x7f"), std::string::npos);
  }
}

TEST(PrintableText, ADiagnosticShowsNoControlCharacterOfAFile) {
  const std::string text = toString(Diagnostic{ErrorKind::MalformedInput, "a\nb\xFF.csv", "\x1b]0;x\x07",
                                               Message("holds '\x1b[2J'"), Message("Mend\x9b.")});
  EXPECT_TRUE(isUtf8(text));
  EXPECT_EQ(text.find_first_of("\n\x1b\x07"), std::string::npos);
}

}  // namespace
}  // namespace glissade
