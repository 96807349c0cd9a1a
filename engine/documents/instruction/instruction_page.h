#pragma once

#include "engine/base/message.h"
#include "engine/documents/instruction/instruction_layout.h"

namespace glissade {

/// Measures of a page, millimetres, and the pieces that pages have in common.
class PageMaker {
 public:
  PageMaker(const WorkInstruction& instruction, const InstructionTemplate& look, Paper paper);

  static constexpr double kMargin = 10.0;
  static constexpr double kHead = 9.0;
  static constexpr double kFoot = 6.0;
  static constexpr double kGap = 4.0;

  /// A page with its head: title, company, logo.
  InstructionPage page() const;
  /// The area of a page's contents.
  PageRect body() const;
  /// A panel with its number, its texts, what is fetched, and its picture.
  void addPanel(std::size_t panel, const PageRect& frame, InstructionPage& page) const;
  /// Numbers in the feet.
  void number(std::vector<InstructionPage>& pages) const;
  InstructionPage cover() const;
  /// The pages of the parts list.
  std::vector<InstructionPage> partsPages() const;

 private:
  std::string say(CatalogueText text, std::initializer_list<MessageArgument> arguments = {}) const {
    return words_(text, arguments);
  }
  /// The text of a row in a column of the parts list.
  std::string cell(PartsColumn column, const PartsListRow& row) const;
  void addFetched(const std::vector<FetchedPart>& parts, const PageRect& rect, InstructionPage& page) const;

  const WorkInstruction& instruction_;
  const InstructionTemplate& look_;
  PaperSize size_;
  DocumentWords words_;
};

/// How many lines a text takes in letters of that size, by the mean width of letters. Millimetres.
std::size_t linesOf(const std::string& text, double points, bool bold, double width);

}  // namespace glissade
