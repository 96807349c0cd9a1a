#include "engine/base/utf8.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(Utf8, KnowsWhatIsOneCharacter) {
  EXPECT_EQ(utf8LengthAt("a", 0), 1U);
  EXPECT_EQ(utf8LengthAt("xä", 1), 2U);
  EXPECT_EQ(utf8LengthAt("€", 0), 3U);
  EXPECT_EQ(utf8LengthAt("\xF0\x9F\x94\xA7", 0), 4U);
  EXPECT_TRUE(isUtf8("Läufer €"));
  EXPECT_TRUE(isUtf8(""));
}

TEST(Utf8, RefusesWhatIsNone) {
  for (const char* bad : {"\x80", "\xC0\xAF", "\xE2\x82", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                          "\xF4\x90\x80\x80", "\xFF", "a\xC3"}) {
    EXPECT_FALSE(isUtf8(bad)) << bad;
  }
}

}  // namespace
}  // namespace glissade
