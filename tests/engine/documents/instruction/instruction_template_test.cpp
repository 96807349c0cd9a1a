#include "engine/documents/instruction/instruction_template.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

class InstructionTemplates : public ::testing::Test {
 protected:
  Result<InstructionTemplate> read(const std::string& members) {
    write("template.json", R"({"format": "glissade-instruction-template", "version": 1)" + members + "}");
    return readInstructionTemplate(path("template.json"));
  }
  void write(const std::string& name, const std::string& content) { std::ofstream(path(name)) << content; }
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }

  test::TemporaryFolder folder_;
};

TEST_F(InstructionTemplates, WhatIsLeftOutIsAsUsual) {
  const auto made = read("");
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(*made, InstructionTemplate());
  EXPECT_EQ(made->columns.size(), 5U);
}

TEST_F(InstructionTemplates, EveryMemberIsRead) {
  write("logo.png", "\x89PNG\r\n\x1a\n");
  const auto made =
      read(R"(, "company": "Muster", "document": "WI-012", "logo": "logo.png", "columns": ["count", "part"],
                             "language": "fr", "paper": "Letter")");
  ASSERT_TRUE(made.ok()) << toString(made.error().reason);
  EXPECT_EQ(made->company, "Muster");
  EXPECT_EQ(made->document, "WI-012");
  EXPECT_EQ(made->logo, std::filesystem::absolute(path("logo.png")).string());
  EXPECT_EQ(made->columns, (std::vector<PartsColumn>{PartsColumn::Count, PartsColumn::Part}));
  EXPECT_EQ(made->language, Language::French);
  EXPECT_EQ(made->paper, Paper::Letter);
}

TEST_F(InstructionTemplates, AnErrorNamesThePlaceAndWhatToDo) {
  write("text.png", "text");
  for (const auto& [members, place] :
       std::vector<std::pair<std::string, std::string>>{{R"(, "colour": "red")", "/colour"},
                                                        {R"(, "company": "")", "/company"},
                                                        {R"(, "columns": [])", "/columns"},
                                                        {R"(, "columns": ["part", "price"])", "/columns/1"},
                                                        {R"(, "columns": ["part", "part"])", "/columns/1"},
                                                        {R"(, "language": "de")", "/language"},
                                                        {R"(, "paper": "A3")", "/paper"},
                                                        {R"(, "logo": "/etc/hostname")", "/logo"},
                                                        {R"(, "logo": "../logo.png")", "/logo"},
                                                        {R"(, "logo": "text.png")", "/logo"}}) {
    const auto made = read(members);
    ASSERT_FALSE(made.ok()) << members;
    EXPECT_EQ(made.error().kind, ErrorKind::MalformedInput) << members;
    EXPECT_EQ(toString(made.error().location), place) << members;
    EXPECT_FALSE(made.error().reason.empty());
    EXPECT_FALSE(made.error().advice.empty()) << members;
  }
  EXPECT_FALSE(read(R"(, "logo": "gone.png")").ok());
  EXPECT_FALSE(readInstructionTemplate(path("gone.json")).ok());
}

}  // namespace
}  // namespace glissade
