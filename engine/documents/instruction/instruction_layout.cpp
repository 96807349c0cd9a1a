#include "engine/documents/instruction/instruction_layout.h"

#include <algorithm>

#include "engine/documents/instruction/instruction_page.h"

namespace glissade {
namespace {

constexpr std::size_t kMostKindsInHalf = 4;  // most kinds of fetched parts in a panel of half width
constexpr std::size_t kMostLettersInHalf = 110;

/// Largest ratio of width to height of a product for which a close-up fits into half of the width.
constexpr double kTall = 0.5;

/// True if the panel takes the whole width, because it does not fit beside another panel.
bool isWide(const InstructionPanel& panel) {
  std::size_t letters = panel.work.size() + panel.tool.size() + panel.turn.size();
  for (const std::string& note : panel.notes) letters += note.size();
  return (panel.closeUp && panel.aspect > kTall) || panel.fetched.size() > kMostKindsInHalf ||
         letters > kMostLettersInHalf;
}

/// Rows of panels: one wide panel, or two.
std::vector<std::vector<std::size_t>> rowsOf(const std::vector<InstructionPanel>& panels) {
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const bool joins = !rows.empty() && rows.back().size() == 1 && !isWide(panels[i]) &&
                       !isWide(panels[rows.back().front()]) &&
                       panels[rows.back().front()].subassembly == panels[i].subassembly;
    if (joins) {
      rows.back().push_back(i);
    } else {
      rows.push_back({i});
    }
  }
  return rows;
}

void addRow(const std::vector<std::size_t>& panels, const PageRect& rect, const PageMaker& maker,
            InstructionPage& page) {
  const auto count = static_cast<double>(panels.size());
  const double width = (rect.width - (count - 1.0) * PageMaker::kGap) / count;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double x = rect.x + static_cast<double>(i) * (width + PageMaker::kGap);
    maker.addPanel(panels[i], {x, rect.y, width, rect.height}, page);
  }
}

}  // namespace

std::vector<InstructionPage> instructionPages(const WorkInstruction& instruction, const InstructionTemplate& look,
                                              Paper paper) {
  constexpr std::size_t kRows = 2;
  const PageMaker maker(instruction, look, paper);
  std::vector<InstructionPage> pages{maker.cover()};
  for (InstructionPage& page : maker.partsPages()) pages.push_back(std::move(page));
  const auto rows = rowsOf(instruction.panels);
  const PageRect area = maker.body();
  for (std::size_t first = 0; first < rows.size(); first += kRows) {
    const std::size_t count = std::min(kRows, rows.size() - first);
    const double height =
        (area.height - (static_cast<double>(count) - 1.0) * PageMaker::kGap) / static_cast<double>(count);
    pages.push_back(maker.page());
    for (std::size_t i = 0; i < count; ++i) {
      const double y = area.y + static_cast<double>(i) * (height + PageMaker::kGap);
      addRow(rows[first + i], {area.x, y, area.width, height}, maker, pages.back());
    }
  }
  maker.number(pages);
  return pages;
}

}  // namespace glissade
