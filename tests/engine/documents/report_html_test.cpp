#include "engine/documents/report_html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(ReportHtml, DrawingsHaveTheColoursOfThePage) {
  const Report report{"R", {ReportDrawing{"d", "Title", "", "<svg><path fill=\"#1d2329\" stroke=\"#ffffff\"/></svg>"}}};
  const auto html = reportHtml(report);
  ASSERT_TRUE(html.ok());
  EXPECT_THAT(*html, testing::HasSubstr("<path fill=\"var(--ink, #1d2329)\" stroke=\"var(--ground, #ffffff)\"/>"));
}

TEST(Base64, KnowsTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace glissade
