#include "engine/documents/times_section.h"

#include <iomanip>
#include <sstream>

#include "engine/documents/line_chart.h"

namespace glissade {
namespace {

void addLine(const PlanTiming& timing, const DocumentWords& words, Report& report) {
  const LineBalance& line = *timing.line;
  report.blocks.emplace_back(
      ReportHeading{words(GLISSADE_TEXT("Line of %1 {1|station|stations}"), {std::to_string(line.load.size())}), 3});
  report.blocks.emplace_back(ReportText{words(GLISSADE_TEXT("Cycle time %1. Minimum %2."),
                                              {secondsText(line.cycle, words), secondsText(line.least, words)})});
  ReportTable table{"",
                    {{words(GLISSADE_TEXT("Station")), ReportColumn::Kind::Number},
                     {words(GLISSADE_TEXT("Time")), ReportColumn::Kind::Number},
                     {words(GLISSADE_TEXT("Steps")), ReportColumn::Kind::Prose}},
                    {}};
  for (std::size_t s = 0; s < line.load.size(); ++s) {
    table.rows.push_back({std::to_string(s + 1), secondsText(line.load[s], words), numbersText(timing.stepsAt(s))});
  }
  report.blocks.emplace_back(std::move(table));
  report.blocks.emplace_back(
      ReportDrawing{"station_load", words(GLISSADE_TEXT("Work of each station")), "", lineChartSvg(timing, words)});
}

/// The source of the times.
std::string sourceText(const PlanTiming& timing, const DocumentWords& words) {
  if (timing.edited == 0) {
    return words(GLISSADE_TEXT(
        "The times are estimates of the size of tables for manual assembly (Boothroyd, Dewhurst and Knight 2011). They "
        "were not measured."));
  }
  return words(
      GLISSADE_TEXT(
          "The times follow an edited table. %1 of its %2 values were edited. The others are estimates of the size of "
          "tables for manual assembly (Boothroyd, Dewhurst and Knight 2011) and were not measured."),
      {std::to_string(timing.edited), std::to_string(workTimeRows().size())});
}

}  // namespace

std::string secondsText(double seconds, const DocumentWords& words) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << seconds;
  return words(GLISSADE_TEXT("%1 s"), {text.str()});
}

void addTimesSection(const PlanTiming& timing, const DocumentWords& words, Report& report) {
  report.blocks.emplace_back(ReportHeading{words(GLISSADE_TEXT("Times")), 2, true});
  report.blocks.emplace_back(ReportText{sourceText(timing, words)});
  report.blocks.emplace_back(
      ReportTable{"",
                  {{"", ReportColumn::Kind::Text}, {"", ReportColumn::Kind::Prose}},
                  {{words(GLISSADE_TEXT("One person")), secondsText(timing.sum(), words)},
                   {words(GLISSADE_TEXT("Critical path")), secondsText(timing.chainSeconds(), words)},
                   {words(GLISSADE_TEXT("Steps of the critical path")), numbersText(timing.chain)}}});
  if (timing.line) addLine(timing, words, report);
}

}  // namespace glissade
