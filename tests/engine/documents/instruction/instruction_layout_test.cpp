#include "engine/documents/instruction/instruction_layout.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/engine/documents/instruction/instructed_products.h"

namespace glissade {
namespace {

/// Panels of all kinds in turn: short, long, with turns, notes, many parts and close-ups.
WorkInstruction someInstruction(std::size_t panels) {
  WorkInstruction instruction = test::instructed(test::blocksOnABase(panels));
  for (std::size_t i = 0; i < instruction.panels.size(); ++i) {
    InstructionPanel& panel = instruction.panels[i];
    panel.closeUp = i % 5 == 3;
    if (i % 3 == 1) panel.tool = "Hex key 2.5";
    if (i % 7 == 2) panel.turn = "Turn the product over and by half a turn.";
    if (i % 4 == 2) panel.notes = {"Needs support: rod, 2 × a bracket with a long name, plate"};
    if (i % 6 == 5) panel.fetched.resize(5, panel.fetched.front());
  }
  return instruction;
}

TEST(InstructionLayout, EachPanelIsOnOnePageInItsOrder) {
  for (std::size_t count = 1; count < 24; ++count) {
    const WorkInstruction instruction = someInstruction(count);
    std::vector<std::size_t> order;
    for (const InstructionPage& page : instructionPages(instruction, {}, Paper::A4)) {
      for (const PagePicture& picture : page.pictures) {
        if (picture.panel) order.push_back(*picture.panel);
      }
    }
    ASSERT_EQ(order.size(), instruction.panels.size());
    for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  }
}

TEST(InstructionLayout, PicturesTakeHalfOfAPageAndNoLettersAreSmall) {
  for (const Paper paper : {Paper::A4, Paper::Letter}) {
    const PaperSize size = sizeOf(paper);
    for (std::size_t count = 1; count < 24; ++count) {
      std::size_t number = 0;
      for (const InstructionPage& page : instructionPages(someInstruction(count), {}, paper)) {
        ++number;
        double shown = 0.0;
        for (const PagePicture& picture : page.pictures) shown += picture.rect.area();
        if (!page.pictures.empty()) {
          EXPECT_GE(shown, 0.5 * size.width * size.height) << name(paper) << ", " << count << ", page " << number;
        }
        for (const PageText& text : page.texts) EXPECT_GE(text.points, kLeastPoints) << text.text;
      }
    }
  }
}

TEST(InstructionLayout, NothingLeavesThePageAndPicturesDoNotOverlap) {
  constexpr double kMargin = 9.0;
  for (const Paper paper : {Paper::A4, Paper::Letter}) {
    const PaperSize size = sizeOf(paper);
    for (const InstructionPage& page : instructionPages(someInstruction(23), {}, paper)) {
      std::vector<PageRect> rects;
      for (const PageText& text : page.texts) rects.push_back(text.rect);
      for (const PagePart& part : page.parts) rects.push_back(part.rect);
      for (const PagePicture& picture : page.pictures) {
        for (const PageRect& other : rects) {
          const bool apart = other.right() <= picture.rect.x + 1e-9 || other.x >= picture.rect.right() - 1e-9 ||
                             other.bottom() <= picture.rect.y + 1e-9 || other.y >= picture.rect.bottom() - 1e-9;
          EXPECT_TRUE(apart) << other.x << " " << other.y << " " << other.width << " " << other.height;
        }
        rects.push_back(picture.rect);
      }
      for (const PageRect& rect : rects) {
        EXPECT_GE(rect.x, kMargin);
        EXPECT_LE(rect.right(), size.width - kMargin);
        EXPECT_LE(rect.bottom(), size.height - kMargin);
      }
    }
  }
}

TEST(InstructionLayout, ACloseUpOfATallProductSharesARow) {
  WorkInstruction instruction = test::instructed(test::blocksOnABase(4));
  const auto pagesOf = [&](double aspect) {
    for (InstructionPanel& panel : instruction.panels) {
      panel.closeUp = true;
      panel.aspect = aspect;
    }
    return instructionPages(instruction, {}, Paper::A4).size();
  };
  EXPECT_EQ(pagesOf(1.5), 5U) << "cover, list, five panels two on a page";
  EXPECT_EQ(pagesOf(0.3), 4U);
}

TEST(InstructionLayout, ThePartsListHasTheColumnsOfTheTemplate) {
  InstructionTemplate look;
  look.columns = {PartsColumn::Count, PartsColumn::Part};
  const auto pages = instructionPages(test::instructed(test::blocksOnABase(40)), look, Paper::A4);
  std::set<std::string> texts;
  std::size_t rows = 0;
  for (const InstructionPage& page : pages) {
    EXPECT_TRUE(page.pictures.empty() || page.lines.empty()) << "pages of the list have no panels";
    rows += page.lines.size();
    for (const PageText& text : page.texts) texts.insert(text.text);
  }
  EXPECT_EQ(rows, 41U) << "base, and blocks that have names of their own";
  EXPECT_EQ(texts.count("Count"), 1U);
  EXPECT_EQ(texts.count("Designation"), 0U);
}

TEST(InstructionLayout, TheHeadHasTheCompany) {
  InstructionTemplate look;
  look.company = "Muster GmbH";
  look.logo = "/logo.png";
  for (const InstructionPage& page : instructionPages(someInstruction(9), look, Paper::Letter)) {
    EXPECT_TRUE(page.logo.has_value());
    EXPECT_TRUE(std::any_of(page.texts.begin(), page.texts.end(),
                            [](const PageText& text) { return text.text == "Muster GmbH"; }));
  }
}

TEST(InstructionLayout, TheFootHasTheNumberOfTheDocumentBesideThatOfThePage) {
  InstructionTemplate look;
  look.document = "WI-012, revision B";
  for (const InstructionPage& page : instructionPages(someInstruction(9), look, Paper::A4)) {
    const auto foot = std::find_if(page.texts.begin(), page.texts.end(),
                                   [](const PageText& text) { return text.text == "WI-012, revision B"; });
    ASSERT_NE(foot, page.texts.end());
    EXPECT_GE(foot->points, kLeastPoints);
    EXPECT_GT(foot->rect.y, 0.9 * sizeOf(Paper::A4).height);
  }
}

}  // namespace
}  // namespace glissade
