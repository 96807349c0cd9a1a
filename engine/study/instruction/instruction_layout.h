#pragma once

#include <string>
#include <vector>

#include "engine/study/instruction/instruction_template.h"
#include "engine/study/instruction/work_instruction.h"

namespace glissade {

/// On a page, millimetres from its upper left corner.
struct PageRect {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;

  double area() const { return width * height; }
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

/// A text in a rectangle, wrapped at words.
struct PageText {
  enum class Align { Left, Right };
  PageRect rect;
  std::string text;
  double points = 0.0;
  bool bold = false;
  Align align = Align::Left;
  bool soft = false;    ///< grey
  bool marked = false;  ///< on a ground of the mark's colour
};

/// A picture of parts to fetch: a row of the parts list, or what a panel fetches.
struct PagePart {
  PageRect rect;
  std::vector<std::string> bodies;  ///< ids of what is drawn
};

/// The picture of a panel; of the finished product where there is none.
struct PagePicture {
  PageRect rect;
  std::optional<std::size_t> panel;  ///< index in WorkInstruction::panels
};

/// A page of an instruction, as it is painted.
struct InstructionPage {
  std::vector<PageText> texts;
  std::vector<PagePicture> pictures;
  std::vector<PagePart> parts;
  std::vector<PageRect> frames;  ///< of panels
  std::vector<PageRect> lines;   ///< of tables: filled, soft
  std::optional<PageRect> logo;
};

/// The smallest letters of a page, points.
inline constexpr double kLeastPoints = 9.0;

/// Cover, parts list, and the panels in their order: up to four on a page, a panel with a close-up as wide as the page
/// unless the product is tall.
/// On a page of panels, and on the cover, pictures take at least half of the page.
std::vector<InstructionPage> instructionPages(const WorkInstruction& instruction, const InstructionTemplate& look,
                                              Paper paper);

}  // namespace glissade
