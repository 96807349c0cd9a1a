#pragma once

#include <string>

#include "engine/base/stop_token.h"
#include "engine/study/study_folder.h"

namespace glissade {

/// How a page is written.
struct PageOptions {
  std::string out;  ///< folder of the page and of the tables that it shows; empty: the folder of results
  std::string pdf;  ///< file of a PDF; empty: report.html or benchmarks.html in `out`
  Language language = Language::English;
};

/// Writes the tables of the results so far, and the page about them by samples/studies/report.py. Returns the file of
/// the page. Errors: a table or the page that cannot be written, Python or one of its modules that is not installed,
/// and Interrupted.
Result<std::string> writeStudyPage(const StudyFolder& folder, const PageOptions& options, Warnings& warnings,
                                   const StopToken& stop = {});

/// Writes the tables of the studies in a folder that packaging/benchmarks.sh filled, and the page about the folder by
/// samples/studies/benchmark_page.py. Returns the file of the page.
Result<std::string> writeBenchmarkPage(const std::string& folder, const PageOptions& options, Warnings& warnings,
                                       const StopToken& stop = {});

}  // namespace glissade
