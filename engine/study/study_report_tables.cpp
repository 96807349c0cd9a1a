#include "engine/study/study_report_tables.h"

#include <algorithm>

#include "engine/study/cell_value.h"
#include "engine/study/finding_check.h"

namespace glissade::study_report {
namespace {

using Row = std::vector<std::string>;

std::string spreadText(const std::optional<CellValue>& value) {
  if (!value) return "–";
  return shortNumber(value->value) + " (" + shortNumber(value->low) + " – " + shortNumber(value->high) + ")";
}

std::string successText(const CellSummary& summary) {
  const Proportion& success = summary.success;
  if (summary.runs == 0) return "–";
  return percent(success.share) + " (" + percent(success.low) + " – " + percent(success.high) + ")";
}

std::string shareText(std::size_t part, std::size_t all, const StudyWords& words) {
  return words(GLISSADE_TEXT("%1 of %2"), {std::to_string(part), std::to_string(all)});
}

bool isSuccess(const PaperColumn& column) { return column.quantity.measure == "success_rate"; }

/// True if the paper has a value in this column for at least one cell.
bool isPrinted(const Study& study, const PaperColumn& column) {
  return std::any_of(study.cells.begin(), study.cells.end(),
                     [&](const StudyCell& cell) { return cell.paper.count(column.key) > 0; });
}

std::string noteOf(const StudyCell& cell) {
  const auto found = cell.paper.find("note");
  const auto* text = found == cell.paper.end() ? nullptr : std::get_if<std::string>(&found->second);
  return text == nullptr ? "" : *text;
}

}  // namespace

ReportTable paperTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words) {
  ReportTable table;
  table.caption = words(GLISSADE_TEXT(
      "Ours: median or mean as the column says, quartiles in brackets; success with Wilson's 95 % interval."));
  table.columns = {{words(GLISSADE_TEXT("Row"))},
                   {words(GLISSADE_TEXT("Solved")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Success")), ReportColumn::Kind::Number}};
  for (const PaperColumn& column : study.heading.paper) {
    const bool printed = isPrinted(study, column);
    const std::string title = words(column.title);
    if (printed) table.columns.push_back({words(GLISSADE_TEXT("%1, paper"), {title}), ReportColumn::Kind::Number});
    if (!isSuccess(column))
      table.columns.push_back(
          {printed ? words(GLISSADE_TEXT("%1, ours"), {title}) : title, ReportColumn::Kind::Number});
  }
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& cell = study.cells[i];
    Row row{cell.label, shareText(summaries[i].solved(), summaries[i].runs, words), successText(summaries[i])};
    for (const PaperColumn& column : study.heading.paper) {
      if (isPrinted(study, column)) row.push_back(paperText(cell, column));
      if (!isSuccess(column)) row.push_back(spreadText(valueOf(summaries[i], column.quantity)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable notesTable(const Study& study, const StudyWords& words) {
  ReportTable table;
  table.columns = {{words(GLISSADE_TEXT("Row"))}, {words(GLISSADE_TEXT("Note on the paper"))}};
  for (const StudyCell& cell : study.cells) {
    const std::string note = noteOf(cell);
    const Row row{cell.row, words(note)};
    if (!note.empty() && (table.rows.empty() || table.rows.back() != row)) table.rows.push_back(row);
  }
  return table;
}

ReportTable findingsTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words) {
  ReportTable table;
  table.caption = words(GLISSADE_TEXT(
      "Each compares every pair of cells that it speaks of; the numbers are of the pair that speaks most against it."));
  table.columns = {{words(GLISSADE_TEXT("Finding")), ReportColumn::Kind::Prose},
                   {words(GLISSADE_TEXT("Verdict")), ReportColumn::Kind::Verdict},
                   {words(GLISSADE_TEXT("Pairs")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Quantity"))},
                   {words(GLISSADE_TEXT("Numbers"))}};
  for (const Finding& finding : study.heading.findings) {
    const CheckedFinding checked = checkFinding(finding, study, summaries, words);
    table.rows.push_back({words(finding.text), words(std::string(name(checked.verdict))),
                          shareText(checked.agreeing, checked.compared, words), describe(finding.quantity, words),
                          checked.numbers});
  }
  return table;
}

ReportTable endingsTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words) {
  ReportTable table;
  table.columns = {{words(GLISSADE_TEXT("Row"))},
                   {words(GLISSADE_TEXT("Strategy"))},
                   {words(GLISSADE_TEXT("Operator"))},
                   {words(GLISSADE_TEXT("Planned")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Run")), ReportColumn::Kind::Number}};
  for (std::size_t s = 0; s < kRunStatusCount; ++s) {
    table.columns.push_back(
        {words(std::string(kRunStatusNames.of(static_cast<RunStatus>(s)))), ReportColumn::Kind::Number});
  }
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& cell = study.cells[i];
    Row row{cell.label, cell.strategy, cell.operatorName, std::to_string(summaries[i].planned),
            std::to_string(summaries[i].runs)};
    for (const std::size_t count : summaries[i].statuses) row.push_back(count == 0 ? "" : std::to_string(count));
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable timingTable(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words) {
  ReportTable table;
  table.caption = words(GLISSADE_TEXT("Median and quartiles over all runs."));
  table.columns = {{words(GLISSADE_TEXT("Row"))},
                   {words(GLISSADE_TEXT("Planning (s)")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Planning (CPU s)")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Process (s)")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Process (CPU s)")), ReportColumn::Kind::Number},
                   {words(GLISSADE_TEXT("Memory (MB)")), ReportColumn::Kind::Number}};
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const auto show = [&](const char* measure) {
      return spreadText(valueOf(summaries[i], {measure, "median", "all"}));
    };
    table.rows.push_back({study.cells[i].label, show("planning_s"), show("planning_cpu_s"), show("wall_s"),
                          show("cpu_s"), show("peak_memory_mb")});
  }
  return table;
}

}  // namespace glissade::study_report
