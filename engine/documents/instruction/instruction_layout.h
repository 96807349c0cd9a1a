#pragma once

#include <string>
#include <vector>

#include "engine/documents/instruction/instruction_template.h"
#include "engine/documents/instruction/work_instruction.h"

namespace glissade {

/// A rectangle on a page, millimetres from the page's upper left corner.
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
  bool soft = false;    ///< printed in grey
  bool marked = false;  ///< printed on a background of the mark's colour
};

/// A picture of parts to fetch: for a row of the parts list, or for a panel.
struct PagePart {
  PageRect rect;
  std::vector<BodyId> bodies;  ///< ids of the drawn bodies
};

/// The picture of a panel, or of the finished product where `panel` is nothing.
struct PagePicture {
  PageRect rect;
  std::optional<std::size_t> panel;  ///< index in WorkInstruction::panels
};

/// A page of an instruction, ready for painting.
struct InstructionPage {
  std::vector<PageText> texts;
  std::vector<PagePicture> pictures;
  std::vector<PagePart> parts;
  std::vector<PageRect> frames;  ///< frames of panels
  std::vector<PageRect> lines;   ///< lines of tables: filled, in grey
  std::optional<PageRect> logo;
};

/// Size of the smallest letters on a page, points.
inline constexpr double kLeastPoints = 9.0;

/// Cover, parts list, and the panels in their order: up to four on a page. A panel with a close-up is as wide as the
/// page unless the product is tall. On the cover and on a page of panels, pictures take at least half of the page.
std::vector<InstructionPage> instructionPages(const WorkInstruction& instruction, const InstructionTemplate& look,
                                              Paper paper);

}  // namespace glissade
