#include "app/cli/study_report.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "engine/study/study_summary.h"

namespace glissade::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::string duration(double seconds) {
  std::ostringstream text;
  if (seconds < 90.0) {
    text << std::lround(seconds) << " s";
  } else if (seconds < 5400.0) {
    text << std::lround(seconds / 60.0) << " min";
  } else {
    text << std::fixed << std::setprecision(1) << seconds / 3600.0 << " h";
  }
  return text.str();
}

const MeasureSummary& measureNamed(const CellSummary& summary, const std::string& name) {
  return *std::find_if(summary.measures.begin(), summary.measures.end(),
                       [&](const MeasureSummary& measure) { return measure.name == name; });
}

std::string median(const Distribution& distribution, int digits) {
  if (distribution.count == 0) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << distribution.median;
  return text.str();
}

/// Bytes that begin a character: what a terminal shows of UTF-8.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0), last_(Clock::now()) {}

void ProgressLine::show(const StudyProgress& progress) {
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000);
  const bool last = progress.done == progress.planned;
  if (shown_ && !last && Clock::now() - last_ < pause) return;
  shown_ = true;
  last_ = Clock::now();
  std::cerr << (terminal_ ? "\r\033[K" : "") << progress.done << " of " << progress.planned << " runs, "
            << progress.solved << " solved";
  if (progress.broken > 0) std::cerr << ", " << progress.broken << " ended by time, memory or a fault";
  if (!last && progress.secondsLeft >= 0.0) std::cerr << ", about " << duration(progress.secondsLeft) << " left";
  std::cerr << (terminal_ ? "" : "\n") << std::flush;
}

void ProgressLine::end() {
  if (terminal_ && shown_) std::cerr << "\n";
}

void printSummary(const StudyFolder& folder, Warnings& warnings) {
  const Study& study = folder.plan().study;
  const auto summaries = summarise(study, folder.results(warnings));
  std::size_t widest = 5;
  for (const StudyCell& cell : study.cells) widest = std::max(widest, width(cell.label));
  std::cout << study.heading.title << (study.quick ? " (quick)" : "") << "\nmedians of the solved runs\n\n"
            << std::string(widest, ' ') << "     solved   virtual s     nodes     edges    random\n";
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const CellSummary& summary = summaries[i];
    const auto show = [&](const char* measure, int digits) {
      return median(measureNamed(summary, measure).solved, digits);
    };
    const std::string& label = study.cells[i].label;
    std::cout << label << std::string(widest - width(label), ' ') << std::right << std::setw(5) << summary.solved()
              << " of " << std::left << std::setw(4) << summary.runs << std::right << std::setw(8)
              << show("virtual_s", 1) << std::setw(10) << show("nodes", 0) << std::setw(10) << show("edges", 0)
              << std::setw(10) << show("random_configurations", 0) << "\n";
  }
  std::cout << "\nsee " << folder.file("report.html") << " and summary.csv"
            << "\n";
}

}  // namespace glissade::cli
