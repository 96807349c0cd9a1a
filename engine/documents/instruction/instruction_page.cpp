#include "engine/documents/instruction/instruction_page.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr double kMillimetresOfPoint = 25.4 / 72.0;
constexpr double kLineHeight = 1.35;  // of the letters
constexpr double kBoldWidth = 0.66;   // of bold letters
constexpr double kDigitWidth = 0.72;  // of bold digits
constexpr double kLetterWidth = 0.6;  // of their height: wider than most are
constexpr double kTitlePoints = 24.0;
constexpr double kNumberPoints = 26.0;
constexpr double kRangePoints = 18.0;  // of "12–15"
constexpr double kWorkPoints = 12.0;
constexpr double kNotePoints = 10.0;
constexpr double kPartSize = 15.0;   // of a picture, millimetres
constexpr double kRowHeight = 17.0;  // of the parts list

double lineOf(double points) { return points * kMillimetresOfPoint * kLineHeight; }

std::size_t lettersOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

double shareOf(PartsColumn column) {
  switch (column) {
    case PartsColumn::Picture: return 0.6;
    case PartsColumn::Part: return 2.2;
    case PartsColumn::Designation: return 2.0;
    case PartsColumn::Count: return 0.7;
    case PartsColumn::Steps: break;
  }
  return 1.5;
}

}  // namespace

std::size_t linesOf(const std::string& text, double points, bool bold, double width) {
  const double letters = std::max(1.0, width / (points * kMillimetresOfPoint * (bold ? kBoldWidth : kLetterWidth)));
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(static_cast<double>(lettersOf(text)) / letters)));
}

PageMaker::PageMaker(const WorkInstruction& instruction, const InstructionTemplate& look, Paper paper)
    : instruction_(instruction), look_(look), size_(sizeOf(paper)), words_(instruction.language) {}

PageRect PageMaker::body() const {
  return {kMargin, kMargin + kHead, size_.width - 2.0 * kMargin, size_.height - 2.0 * kMargin - kHead - kFoot};
}

InstructionPage PageMaker::page() const {
  constexpr double kLogoWidth = 24.0;
  InstructionPage page;
  const double width = size_.width - 2.0 * kMargin;
  const double height = kHead - 2.0;
  double right = kMargin + width;
  if (!look_.logo.empty()) {
    right -= kLogoWidth;
    page.logo = PageRect{right, kMargin, kLogoWidth, height};
    right -= 2.0;
  }
  page.texts.push_back({{kMargin, kMargin, 0.6 * width, height}, instruction_.title, 10.0, true});
  if (!look_.company.empty()) {
    const double left = kMargin + 0.6 * width;
    page.texts.push_back(
        {{left, kMargin, right - left, height}, look_.company, 10.0, false, PageText::Align::Right, true});
  }
  return page;
}

void PageMaker::number(std::vector<InstructionPage>& pages) const {
  constexpr double kPageNumber = 24.0;
  const double top = size_.height - kMargin - kFoot + 1.0;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    pages[i].texts.push_back({{kMargin, top, size_.width - 2.0 * kMargin, kFoot - 1.0},
                              std::to_string(i + 1) + " / " + std::to_string(pages.size()),
                              kLeastPoints,
                              false,
                              PageText::Align::Right,
                              true});
    if (look_.document.empty()) continue;
    pages[i].texts.push_back({{kMargin, top, size_.width - 2.0 * kMargin - kPageNumber, kFoot - 1.0},
                              look_.document,
                              kLeastPoints,
                              false,
                              PageText::Align::Left,
                              true});
  }
}

InstructionPage PageMaker::cover() const {
  constexpr double kTitle = 34.0;  // millimetres
  constexpr double kLine = 4.5;
  constexpr double kFacts = 24.0;
  InstructionPage made = page();
  const PageRect area = body();
  made.texts.erase(made.texts.begin());  // the title is larger, below
  made.texts.push_back(
      {{area.x, area.y + 2.0, area.width, 14.0}, instruction_.title, kTitlePoints, true, PageText::Align::Left});
  made.texts.push_back({{area.x, area.y + 17.0, area.width, 10.0},
                        instruction_.imprint.empty()
                            ? say(GLISSADE_TEXT("Work instruction"))
                            : say(GLISSADE_TEXT("Work instruction")) + " · " + instruction_.imprint,
                        14.0,
                        false,
                        PageText::Align::Left,
                        true});
  if (!instruction_.incomplete.empty()) {
    made.texts.push_back({{area.x, area.y + 25.0, area.width, 8.0},
                          instruction_.incomplete,
                          kNotePoints,
                          true,
                          PageText::Align::Left,
                          false,
                          true});
  }
  double head = kTitle;
  for (const std::string& statement : instruction_.statements) {
    const double height = kLine * static_cast<double>(linesOf(statement, kNotePoints, false, area.width)) + 2.0;
    made.texts.push_back({{area.x, area.y + head, area.width, height}, statement, kNotePoints});
    head += height;
  }
  made.pictures.push_back({{area.x, area.y + head, area.width, area.height - head - kFacts}, std::nullopt});
  const double top = area.bottom() - kFacts + 3.0;
  made.texts.push_back({{area.x, top, area.width, 8.0}, extentText(instruction_, words_), kWorkPoints, true});
  std::string tools;
  for (const std::string& tool : instruction_.tools) tools += (tools.empty() ? "" : " · ") + tool;
  if (!tools.empty()) {
    made.texts.push_back(
        {{area.x, top + 8.0, area.width, 13.0}, say(GLISSADE_TEXT("Tools: %1"), {tools}), kNotePoints});
  }
  return made;
}

std::string PageMaker::cell(PartsColumn column, const PartsListRow& row) const {
  switch (column) {
    case PartsColumn::Picture: return {};
    case PartsColumn::Part: return row.name;
    case PartsColumn::Designation: return row.designation.empty() ? "–" : row.designation;
    case PartsColumn::Count: return std::to_string(row.count) + "×";
    case PartsColumn::Steps: return stepsText(row, words_);
  }
  return {};
}

std::vector<InstructionPage> PageMaker::partsPages() const {
  const PageRect area = body();
  double whole = 0.0;
  for (const PartsColumn column : look_.columns) whole += shareOf(column);
  std::vector<InstructionPage> pages;
  double y = area.bottom();
  for (const PartsListRow& row : instruction_.parts) {
    if (y + kRowHeight > area.bottom()) {
      pages.push_back(page());
      pages.back().texts.push_back({{area.x, area.y, area.width, 9.0}, say(GLISSADE_TEXT("Parts list")), 15.0, true});
      y = area.y + 11.0;
      double x = area.x;
      for (const PartsColumn column : look_.columns) {
        const double width = area.width * shareOf(column) / whole;
        pages.back().texts.push_back({{x, y, width - 2.0, 6.0}, titleOf(column, words_), kLeastPoints, true});
        x += width;
      }
      y += 7.0;
    }
    InstructionPage& made = pages.back();
    made.lines.push_back({area.x, y, area.width, 0.25});
    double x = area.x;
    for (const PartsColumn column : look_.columns) {
      const double width = area.width * shareOf(column) / whole;
      if (column == PartsColumn::Picture) {
        made.parts.push_back({{x, y + 1.0, std::min(kPartSize, width), kPartSize}, {row.bodies.front()}});
      } else {
        made.texts.push_back({{x, y + 1.0, width - 2.0, kRowHeight - 2.0},
                              cell(column, row),
                              column == PartsColumn::Count ? kWorkPoints : kNotePoints,
                              column == PartsColumn::Count});
      }
      x += width;
    }
    y += kRowHeight;
  }
  return pages;
}

/// In a row, each with its count; with its name below where it has room.
void PageMaker::addFetched(const std::vector<FetchedPart>& parts, const PageRect& rect, InstructionPage& page) const {
  if (parts.empty()) return;
  const double cell = rect.width / static_cast<double>(parts.size());
  const double size = std::min({kPartSize, rect.height, 0.6 * cell});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double x = rect.x + static_cast<double>(i) * cell;
    page.parts.push_back({{x, rect.y, size, size}, parts[i].bodies});
    const PageRect beside{x + size + 1.5, rect.y, cell - size - 2.0, lineOf(kWorkPoints)};
    page.texts.push_back({beside, std::to_string(parts[i].count) + "×", kWorkPoints, true});
    const PageRect below{beside.x, beside.bottom(), beside.width, rect.height - beside.height};
    const double needed =
        lineOf(kLeastPoints) * static_cast<double>(linesOf(parts[i].name, kLeastPoints, false, below.width));
    if (needed > below.height) continue;  // the sentence has it
    page.texts.push_back({below, parts[i].name, kLeastPoints, false, PageText::Align::Left, true});
  }
}

void PageMaker::addPanel(std::size_t index, const PageRect& frame, InstructionPage& page) const {
  constexpr double kInside = 2.0;
  const InstructionPanel& panel = instruction_.panels[index];
  const bool isWide = frame.width > 0.75 * body().width;
  const PageRect inside{frame.x + kInside, frame.y + kInside, frame.width - 2.0 * kInside,
                        frame.height - 2.0 * kInside};
  const std::string number = panel.number.empty() ? say(GLISSADE_TEXT("Start")) : panel.number;
  const bool isLong = lettersOf(number) > 3;
  const double numberPoints = isLong ? kRangePoints : kNumberPoints;
  const double numberWidth =
      std::max(isLong ? 22.0 : 15.0,
               static_cast<double>(lettersOf(number)) * numberPoints * kMillimetresOfPoint * kDigitWidth + 2.0);
  page.frames.push_back(frame);
  page.texts.push_back({{inside.x, inside.y, numberWidth, 11.0}, number, numberPoints, true});
  const double fetchedHeight = kPartSize + 1.0;
  const double fetchedWidth = isWide ? 0.4 * inside.width : inside.width;
  const double textWidth = inside.width - numberWidth - (isWide ? fetchedWidth : 0.0) - 1.0;
  double y = inside.y + 0.5;
  const auto add = [&](const std::string& text, double points, bool bold, bool marked) {
    const double height = lineOf(points) * static_cast<double>(linesOf(text, points, bold, textWidth));
    page.texts.push_back(
        {{inside.x + numberWidth, y, textWidth, height}, text, points, bold, PageText::Align::Left, false, marked});
    y += height + 0.4;
  };
  if (!panel.turn.empty()) add(panel.turn, kNotePoints, true, true);
  const bool isLongWork = linesOf(panel.work, kWorkPoints, true, textWidth) > 2;
  add(panel.work, isLongWork ? kNotePoints : kWorkPoints, true, false);
  if (!panel.tool.empty()) add(panel.tool, kNotePoints, false, false);
  for (const std::string& note : panel.notes) add(note, kLeastPoints, false, false);
  if (!panel.subassembly.empty()) {
    add(say(GLISSADE_TEXT("Subassembly for step %1"), {panel.subassembly}), kLeastPoints, false, false);
    page.texts.back().soft = true;
  }
  double top = std::max(y, inside.y + 12.0);
  const PageRect fetched{isWide ? inside.right() - fetchedWidth : inside.x, isWide ? inside.y : top, fetchedWidth,
                         fetchedHeight};
  addFetched(panel.fetched, fetched, page);
  top = std::max(top, fetched.bottom()) + 0.5;
  page.pictures.push_back({{frame.x + 0.5, top, frame.width - 1.0, frame.bottom() - top - 0.5}, index});
}

}  // namespace glissade
