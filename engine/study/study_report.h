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
  bool newPage = false;  ///< begins a new page on paper
};
struct ReportText {
  std::string text;
};
struct ReportColumn {
  enum class Kind {
    Text,
    Number,  ///< aligned to the right
    Prose,   ///< whole sentences
    Verdict  ///< verdict of a finding
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
/// Commands, one per line, as typed.
struct ReportCommands {
  std::vector<std::string> lines;
};
using ReportBlock = std::variant<ReportHeading, ReportText, ReportTable, Plot, ReportPicture, ReportCommands>;

/// A study's report as a value, before it becomes a page (report_html.h) or a PDF (in the window).
struct StudyReport {
  std::string title;
  std::vector<ReportBlock> blocks;
  Language language = Language::English;
};

/// The report of a folder of results: settings, the paper's table beside that of the study, the findings, plots,
/// pictures (DIR/pictures/*.png, with their .txt as captions), the ends of the runs, the commands that repeat the
/// study, and last the data that depend on the machine. The sections before the last are the same on all machines.
StudyReport reportOf(const StudyFolder& folder, Warnings& warnings, Language language = Language::English);

/// Writes DIR/report.html into `out`.
Outcome writeReport(const StudyFolder& folder, const std::string& out, Warnings& warnings,
                    Language language = Language::English);

}  // namespace glissade
