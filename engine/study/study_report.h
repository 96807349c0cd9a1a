#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/study/plot.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_words.h"

namespace glissade {

struct ReportHeading {
  std::string text;
  int level = 2;
  bool newPage = false;  ///< on paper
};
struct ReportText {
  std::string text;
};
struct ReportColumn {
  enum class Kind {
    Text,
    Number,  ///< aligned to the right
    Prose,   ///< whole sentences
    Verdict  ///< of findings
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
  std::string file;  ///< a PNG
  std::string caption;
  double share = 0.46;  ///< of the width of a page of paper
};
/// Commands, a line each, as typed.
struct ReportCommands {
  std::vector<std::string> lines;
};
using ReportBlock = std::variant<ReportHeading, ReportText, ReportTable, Plot, ReportPicture, ReportCommands>;

/// A study's report as a value, before it becomes a page (report_html.h) or a PDF (the window's room).
struct StudyReport {
  std::string title;
  std::vector<ReportBlock> blocks;
  Language language = Language::English;
};

/// Everything a folder of results has to say: what was run, the paper's table with ours beside it, the
/// findings, plots, pictures (DIR/pictures/*.png, with their .txt as captions), how runs ended, the commands
/// that repeat it, and last what depends on the machine. Up to that last section it is the same wherever
/// it is made.
StudyReport reportOf(const StudyFolder& folder, Warnings& warnings, Language language = Language::English);

/// Writes DIR/report.html into `out`.
Outcome writeReport(const StudyFolder& folder, const std::string& out, Warnings& warnings,
                    Language language = Language::English);

}  // namespace glissade
