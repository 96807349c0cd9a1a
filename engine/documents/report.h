#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/base/message.h"

namespace glissade {

struct ReportHeading {
  std::string text;
  int level = 2;
  bool newPage = false;  ///< begins a new page on paper
};
struct ReportText {
  std::string text;
};
struct ReportColumn {
  enum class Kind {
    Text,
    Number,  ///< aligned to the right
    Prose    ///< whole sentences
  };
  std::string title;
  Kind kind = Kind::Text;
};
struct ReportTable {
  std::string caption;
  std::vector<ReportColumn> columns;
  std::vector<std::vector<std::string>> rows;
};
struct ReportPicture {
  std::string file;  ///< path of a PNG file
  std::string caption;
  double share = 0.46;  ///< share of the width of a page
};
/// A drawing of lines and texts.
struct ReportDrawing {
  std::string name;  ///< short name for ids: "clearance"
  std::string title;
  std::string caption;
  std::string svg;
};
using ReportBlock = std::variant<ReportHeading, ReportText, ReportTable, ReportDrawing, ReportPicture>;

/// A report of a path or a plan as a value, before it becomes a page (report_html.h) or a PDF (in the window).
struct Report {
  std::string title;
  std::vector<ReportBlock> blocks;
  Language language = Language::English;
};

}  // namespace glissade
