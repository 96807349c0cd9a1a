#include "engine/import/xml_precheck.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glissade {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST(XmlPrecheck, CountsLinksAndTheirShapesOnly) {
  const auto facts = precheckXml(
      "<?xml version=\"1.0\"?>\n<!-- <geometry> </robot> -->\n<robot name='a>b'><link name=\"/>\"><visual><geometry/>"
      "</visual><collision ><geometry\n></geometry ></collision></link><link name=\"b\"/>"
      "<gazebo><geometry/><![CDATA[ </robot><geometry> ]]></gazebo></robot>",
      "r.urdf");
  ASSERT_TRUE(facts.ok()) << toString(facts.error());
  EXPECT_EQ(facts->geometries, 2U);
  EXPECT_EQ(facts->links, 2U);
}

/// Each text hid a depth of 50,000 elements from a scanner that only searches '<' and '>'.
TEST(XmlPrecheck, NothingHidesADepth) {
  const std::vector<std::string> hiding{
      "<a>",
      "<x a=\"/>\">",
      "<x a='/>'>",
      "<a b=\"</a>\">",
      "<a><![CDATA[</a>]]>",
      "<a><!-- </a> -->",
      "<a><!-- > </a> -->",
      "<a><?x </a>?>",
      "<a></b>",
      "<a/ >",
      "<a / b=\"\">",
      "< a>",
      "<a b=/>",
      "<a b=\"\"c=\"/>\">",
  };
  for (const std::string& text : hiding) {
    SCOPED_TRACE(text);
    const auto facts = precheckXml("<robot>" + repeated(text, 50'000), "deep.urdf");
    ASSERT_FALSE(facts.ok());
    EXPECT_EQ(facts.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(facts.error().location), "line 1");
    EXPECT_FALSE(facts.error().reason.empty());
  }
}

struct Refused {
  const char* what;
  std::string text;
  const char* reason;
};

TEST(XmlPrecheck, NamesWhatItRefuses) {
  const std::vector<Refused> table{
      {"depth", repeated("<a>", 101), "nested too deeply"},
      {"depth of empty elements", repeated("<a>", 100) + "<a/>", "nested too deeply"},
      {"elements", "<r>" + repeated("<a/>", 200'000) + "</r>", "more than 200000 elements"},
      {"attributes", "<r " + repeated("a=\"\" ", 1'000'000) + "/>", "more than 100 attributes"},
      {"a document type", "<!DOCTYPE r [<!ENTITY a \"b\">]><r/>", "document type"},
      {"a value with <", "<r a=\"<\"/>", "&lt;"},
      {"a value without quotes", "<r a=b/>", "not quoted"},
      {"an open value", "<r a=\"b/>", "does not end"},
      {"an open comment", "<r><!-- </r>", "comment that does not end"},
      {"a short comment", "<r><!--></r>", "comment that does not end"},
      {"an open section", "<r><![CDATA[ ]] ></r>", "CDATA section that does not end"},
      {"an instruction with >", "<?x a=\">\"?><r/>", "processing instruction"},
      {"an instruction of nothing", "<?><r/>", "processing instruction"},
      {"an open element", "<r><a></a>", "ends inside the element 'r'"},
      {"another end tag", "<r></s>", "not open"},
      {"an end tag too many", "<r></r></r>", "not open"},
      {"an open tag", "<r", "does not end"},
      {"nothing behind <", "<", "without a name"},
      {"a zero byte", std::string("<r>\0</r>", 8), "UTF-8"},
      {"invalid UTF-8", "<r>\xC3</r>", "UTF-8"},
  };
  for (const Refused& row : table) {
    SCOPED_TRACE(row.what);
    const auto facts = precheckXml(row.text, "r.urdf");
    ASSERT_FALSE(facts.ok());
    EXPECT_THAT(toString(facts.error().reason), testing::HasSubstr(row.reason));
    EXPECT_EQ(facts.error().file, "r.urdf");
  }
}

TEST(XmlPrecheck, LimitsThemselvesAreAccepted) {
  EXPECT_TRUE(precheckXml(repeated("<a>", 100) + repeated("</a>", 100), "r.urdf").ok());
  EXPECT_TRUE(precheckXml("<r " + repeated("a=\"\" ", 100) + "/>", "r.urdf").ok());
  EXPECT_TRUE(precheckXml("<r>" + repeated("<a/>", 199'999) + "</r>", "r.urdf").ok());
}

}  // namespace
}  // namespace glissade
