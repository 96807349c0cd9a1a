#include "engine/study/study_report.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/study/machine.h"
#include "engine/study/repeat_command.h"
#include "engine/study/report_html.h"
#include "engine/study/study_plots.h"
#include "engine/study/study_report_tables.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCaptionBytes = 1U << 14;

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

ReportTable whatWasRun(const StudyFolder& folder, const std::vector<CellSummary>& summaries, const StudyWords& words) {
  const Study& study = folder.plan().study;
  std::set<std::string> scenarios;
  std::set<std::string> strategies;
  std::set<std::string> operators;
  for (const StudyCell& cell : study.cells) {
    scenarios.insert(cell.scenario);
    strategies.insert(cell.strategy);
    operators.insert(cell.operatorName);
  }
  std::size_t planned = 0;
  std::size_t run = 0;
  std::size_t solved = 0;
  for (const CellSummary& summary : summaries) {
    planned += summary.planned;
    run += summary.runs;
    solved += summary.solved();
  }
  ReportTable table;
  table.columns = {{""}, {""}};
  table.rows = {
      {words(GLISSADE_TEXT("Study")),
       words(study.quick ? GLISSADE_TEXT("%1, quick size") : GLISSADE_TEXT("%1, full size"), {study.heading.name})},
      {words(GLISSADE_TEXT("Runs")), words(GLISSADE_TEXT("%1 of %2, %3 of them solved, in %4 {4|cell|cells}"),
                                           {std::to_string(run), std::to_string(planned), std::to_string(solved),
                                            std::to_string(study.cells.size())})},
      {words(GLISSADE_TEXT("Scenarios")), joined(scenarios)},
      {words(GLISSADE_TEXT("Strategies")), joined(strategies)},
      {words(GLISSADE_TEXT("Operators")), joined(operators)},
      {"Glissade", folder.plan().version},
      {words(GLISSADE_TEXT("Study file, SHA-256")), folder.plan().studySha256},
      {words(GLISSADE_TEXT("Plan, SHA-256")), folder.planSha256()}};
  return table;
}

void addPictures(const StudyFolder& folder, const StudyWords& words, StudyReport& report) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder.file("pictures"), ignored)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  }
  if (files.empty()) return;
  std::sort(files.begin(), files.end());
  report.blocks.emplace_back(ReportHeading{words(GLISSADE_TEXT("Typical roadmaps"))});
  for (const fs::path& file : files) {
    const auto caption = readFile(fs::path(file).replace_extension(".txt").string(), kMostCaptionBytes);
    report.blocks.emplace_back(ReportPicture{file.string(), caption ? *caption : file.stem().string()});
  }
}

void addCommands(const Study& study, const StudyWords& words, StudyReport& report) {
  const std::string quick = study.quick ? " --quick" : "";
  const std::string out = " --out out/" + shellWord(study.heading.name);
  report.blocks.emplace_back(ReportHeading{words(GLISSADE_TEXT("How to repeat it"))});
  report.blocks.emplace_back(ReportText{words(GLISSADE_TEXT("The whole study, from the folder of its file:"))});
  report.blocks.emplace_back(
      ReportCommands{{"glissade-cli study " + shellWord(study.heading.name + ".json") + out + quick + " --jobs 2",
                      "glissade-offscreen --study-pictures out/" + shellWord(study.heading.name),
                      "glissade-cli report out/" + shellWord(study.heading.name)}});
  report.blocks.emplace_back(ReportText{words(
      GLISSADE_TEXT("The first run of each cell, from the same folder; the others differ in their --seed only:"))});
  ReportCommands commands;
  for (const StudyCell& cell : study.cells) {
    commands.lines.push_back("# " + cell.label);
    commands.lines.push_back(repeatCommand(cell, cell.seeds.front()));
  }
  report.blocks.emplace_back(std::move(commands));
}

}  // namespace

StudyReport reportOf(const StudyFolder& folder, Warnings& warnings, Language language) {
  const StudyWords words(language);
  const Study& study = folder.plan().study;
  const StudyHeading& heading = study.heading;
  const auto summaries = summarise(study, folder.results(warnings));
  StudyReport report{words(heading.title), {}, language};
  const auto add = [&report](auto block) { report.blocks.emplace_back(std::move(block)); };
  if (!heading.description.empty()) add(ReportText{words(heading.description)});
  if (!heading.citation.empty()) add(ReportText{words(GLISSADE_TEXT("After: %1."), {heading.citation})});
  add(ReportHeading{words(GLISSADE_TEXT("What was run"))});
  add(whatWasRun(folder, summaries, words));
  add(ReportHeading{
      words(heading.paper.empty() ? GLISSADE_TEXT("Results") : GLISSADE_TEXT("The paper's table, and ours"))});
  add(study_report::paperTable(study, summaries, words));
  ReportTable notes = study_report::notesTable(study, words);
  if (!notes.rows.empty()) add(std::move(notes));
  if (!heading.findings.empty()) {
    add(ReportHeading{words(GLISSADE_TEXT("Findings"))});
    add(study_report::findingsTable(study, summaries, words));
  }
  add(ReportHeading{words(GLISSADE_TEXT("Plots"))});
  for (Plot& plot : plotsOf(study, summaries, words)) add(std::move(plot));
  addPictures(folder, words, report);
  add(ReportHeading{words(GLISSADE_TEXT("How runs ended"))});
  add(study_report::endingsTable(study, summaries, words));
  addCommands(study, words, report);
  add(ReportHeading{words(GLISSADE_TEXT("Time on the machine"))});
  add(ReportText{words(
      GLISSADE_TEXT("Seconds and memory are those of the machines that carried out the runs; they differ from "
                    "machine to machine, and of what stands above only what names them depends on them. This report "
                    "was written on %1."),
      {describeMachine()})});
  add(study_report::timingTable(study, summaries, words));
  return report;
}

Outcome writeReport(const StudyFolder& folder, const std::string& out, Warnings& warnings, Language language) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) {
    return Diagnostic{ErrorKind::Usage,
                      out,
                      "",
                      {GLISSADE_TEXT("cannot be made: %1"), {error.message()}},
                      GLISSADE_TEXT("Choose another --out.")};
  }
  const auto page = reportHtml(reportOf(folder, warnings, language));
  if (!page) return page.error();
  return saveFile(out + "/report.html", *page, warnings);
}

}  // namespace glissade
