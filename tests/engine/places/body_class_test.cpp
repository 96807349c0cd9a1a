#include "engine/places/body_class.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

std::vector<BodyClass> someClasses() {
  BodyClass fastener{"fastener"};
  fastener.attributes = {{"mass", 0.1}, {"fragile", false}};
  BodyClass screw{"screw", "fastener", "Screw", "screw"};
  BodyClass socket{"socket_head", "screw"};
  socket.attributes = {{"needs_tool", std::string("hex_key")}, {"mass", 0.2}};
  return {fastener, screw, socket};
}

TEST(BodyClasses, HaveWhatTheirParentsHaveAndWhatTheySayThemselves) {
  const auto classes = BodyClasses::of(someClasses());
  ASSERT_TRUE(classes.ok());
  const Attributes attributes = classes->attributesOf("socket_head");
  EXPECT_EQ(attributes.at("mass"), AttributeValue(0.2));
  EXPECT_EQ(attributes.at("fragile"), AttributeValue(false));
  EXPECT_EQ(attributes.at("needs_tool"), AttributeValue(std::string("hex_key")));
  EXPECT_EQ(classes->fastenerOf("socket_head"), "screw");
  EXPECT_EQ(classes->fastenerOf("fastener"), "");
  EXPECT_EQ(classes->find("bolt"), nullptr);
}

TEST(BodyClasses, ALaterClassTakesThePlaceOfAnEarlierOne) {
  std::vector<BodyClass> all = someClasses();
  all.push_back({"screw", "", "Our screw", "pin"});
  const auto classes = BodyClasses::of(all);
  ASSERT_TRUE(classes.ok());
  EXPECT_EQ(classes->all().size(), 3U);
  EXPECT_EQ(classes->fastenerOf("socket_head"), "pin");
  EXPECT_EQ(classes->attributesOf("socket_head").count("fragile"), 0U);
}

TEST(BodyClasses, RefuseUnknownParentsAndCircles) {
  const auto unknown = BodyClasses::of({{"screw", "fastener"}});
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(toString(unknown.error().reason).find("'fastener'"), std::string::npos);
  const auto circle = BodyClasses::of({{"a", "b"}, {"b", "c"}, {"c", "a"}});
  ASSERT_FALSE(circle.ok());
  EXPECT_NE(toString(circle.error().reason).find("cycle"), std::string::npos);
}

}  // namespace
}  // namespace glissade
