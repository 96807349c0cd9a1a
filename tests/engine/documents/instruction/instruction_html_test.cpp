#include "engine/documents/instruction/instruction_html.h"

#include <gtest/gtest.h>

#include "engine/documents/instruction/instruction_viewer.h"
#include "tests/engine/documents/instruction/instructed_products.h"

namespace glissade {
namespace {

std::size_t countOf(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

std::string pageOf(const WorkInstruction& instruction, const InstructionScene* scene,
                   const InstructionTemplate& look = {}) {
  InstructionPictures pictures;
  pictures.finished = "finished";
  pictures.panels.resize(instruction.panels.size(), "panel");
  const auto page = instructionHtml(instruction, look, pictures, scene);
  EXPECT_TRUE(page.ok());
  return page ? *page : std::string();
}

TEST(InstructionHtml, HasASectionForEachPanelAndNothingOfTheNetwork) {
  const WorkInstruction instruction = test::instructed(test::blocksOnABase(6));
  const std::string page = pageOf(instruction, nullptr);
  EXPECT_EQ(countOf("<section", page), instruction.panels.size() + 2U) << "cover and parts list";
  EXPECT_EQ(countOf("data-from=", page), 6U) << "the start is no step";
  EXPECT_EQ(countOf("http://", page) + countOf("https://", page), 0U);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("id=\"scene\""), std::string::npos);
}

TEST(InstructionHtml, StepsOfATaskArePlayedTogether) {
  auto made = test::blocksOnABase(4);
  made.plan.steps[1].task = made.plan.steps[2].task = 1;
  const std::string page = pageOf(test::instructed(made), nullptr);
  EXPECT_NE(page.find("data-from=\"2\" data-to=\"3\""), std::string::npos);
}

TEST(InstructionHtml, AScriptEndsWhereItIsToEnd) {
  const InstructionScene scene{"glTF", "var end = '</script>';"};
  const std::string page = pageOf(test::instructed(test::blocksOnABase(1)), &scene);
  EXPECT_EQ(countOf("<script", page), countOf("</script>", page));
  EXPECT_NE(page.find("\"steps\":[0,1]"), std::string::npos) << "the base is there, the block comes by step 1";
}

TEST(InstructionHtml, StepsWithinASubassemblyHaveTheirMotionsInThe3dView) {
  auto made = test::blocksOnABase(2);
  AssemblyStep group = made.plan.steps[1];
  group.only().with = {"block1"};
  made.plan.lines.push_back({1, {"block0", "block1"}, {"block0"}, {made.plan.steps[0]}});
  made.plan.steps = {group};
  const InstructionScene scene{"glTF", ""};
  const std::string page = pageOf(test::instructed(made), &scene);
  EXPECT_EQ(countOf("data-line=\"2\"", page), 1U);
  EXPECT_NE(page.find("\"lines\":{\"2\":{\"moves\":[{\"bodies\":[2],\"poses\":[[0.0,0.0,1.0,"), std::string::npos);
  EXPECT_NE(page.find("\"present\":[1]"), std::string::npos);
}

TEST(InstructionHtml, IsInTheLanguageOfTheInstruction) {
  const std::string page = pageOf(test::instructed(test::blocksOnABase(1), Language::French), nullptr);
  EXPECT_NE(page.find("<html lang=\"fr\">"), std::string::npos);
  EXPECT_NE(page.find("Suivant"), std::string::npos);
  EXPECT_EQ(page.find("Next"), std::string::npos);
}

TEST(InstructionHtml, ALogoThatIsGoneIsAnError) {
  InstructionTemplate look;
  look.logo = "/gone/logo.png";
  const WorkInstruction instruction = test::instructed(test::blocksOnABase(1));
  InstructionPictures pictures;
  pictures.panels.resize(instruction.panels.size());
  EXPECT_FALSE(instructionHtml(instruction, look, pictures, nullptr).ok());
}

TEST(InstructionViewer, WithoutTheLibraryItSaysWhichPackageHasIt) {
  const auto scene = instructionScene("glTF", "/gone");
  ASSERT_FALSE(scene.ok());
  EXPECT_NE(toString(scene.error().advice).find("libjs-three"), std::string::npos);
}

}  // namespace
}  // namespace glissade
