// Checks the places of the recipe "Add a member to the template of work instructions".
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "engine/documents/instruction/instruction_template.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

std::string projectText(const std::string& file) { return test::readWhole(test::sourceDirectory() + "/" + file); }

/// The members that the schema names.
std::set<std::string> templateMembers() {
  const auto schema = nlohmann::json::parse(projectText("resources/schema/instruction-template-1.schema.json"));
  std::set<std::string> members;
  for (const auto& [name, rules] : schema.at("properties").items()) members.insert(name);
  return members;
}

/// The members that a company changes.
std::set<std::string> ownMembers() {
  std::set<std::string> members = templateMembers();
  for (const char* ofEveryFormat : {"format", "version", "description"}) members.erase(ofEveryFormat);
  return members;
}

/// An unknown key is refused with a list of all keys.
TEST(InstructionTemplateRecipe, TheReaderHasExactlyTheMembersOfTheSchema) {
  const test::TemporaryFolder folder;
  const auto refused = readInstructionTemplate(folder.write("template.json", R"({"strange": 1})"));
  ASSERT_FALSE(refused.ok());
  const std::string advice = toString(refused.error().advice);
  std::istringstream words(advice.substr(advice.find(": ") + 2));
  std::set<std::string> known;
  for (std::string word; words >> word;) known.insert(word.substr(0, word.size() - 1));  // without "," or "."
  EXPECT_EQ(known, templateMembers());
}

TEST(InstructionTemplateRecipe, BothManualsShowEveryMember) {
  for (const std::string language : {"en", "fr"}) {
    const std::string page = projectText("resources/manual/" + language + "/sequences.md");
    for (const std::string& member : ownMembers()) {
      EXPECT_NE(page.find('"' + member + "\":"), std::string::npos) << language << ": " << member;
    }
  }
}

/// Language and paper are not drawn: the window takes them.
TEST(InstructionTemplateRecipe, PaperAndTabletUseEveryMemberThatIsDrawn) {
  for (const char* file : {"instruction_page.cpp", "instruction_html.cpp"}) {
    const std::string source = projectText("engine/documents/instruction/" + std::string(file));
    for (const std::string& member : ownMembers()) {
      if (member == "language" || member == "paper") continue;
      const bool uses =
          source.find("look." + member) != std::string::npos || source.find("look_." + member) != std::string::npos;
      EXPECT_TRUE(uses) << file << ": " << member;
    }
  }
}

}  // namespace
}  // namespace glissade
