#include "engine/study/study_folder.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "engine/base/file.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPlanBytes = 1U << 30;
constexpr std::size_t kMostRunBytes = 1U << 20;

std::string planFile(const std::string& folder) { return folder + "/plan.json"; }

/// True if the folder is missing or holds only temporary files of an interrupted writer (base/file.h).
bool isEmptyOrMissing(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().find(".saving-") == std::string::npos) return false;
  }
  return !fs::exists(folder, ignored) || fs::is_directory(folder, ignored);
}

Outcome makeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return Done{};
  return Diagnostic{ErrorKind::Usage,
                    folder,
                    "",
                    {GLISSADE_TEXT("cannot be made: %1"), {error.message()}},
                    GLISSADE_TEXT("Choose another --out.")};
}

Diagnostic belongsToAnother(const std::string& folder) {
  return {
      ErrorKind::Usage, folder, "plan.json",
      GLISSADE_TEXT(
          "holds results of another study, of another version of it or of Glissade, or of its other size (--quick)"),
      GLISSADE_TEXT("Choose another --out, or remove that folder.")};
}

/// Writes the files of a new folder. The plan comes first, because a folder with a plan is accepted as a study folder.
Outcome layOut(const std::string& folder, const std::string& studyText, const std::string& planText) {
  const auto there = readFile(planFile(folder), kMostPlanBytes);
  if (there && *there != planText) return belongsToAnother(folder);
  if (!there && !isEmptyOrMissing(folder)) {
    return Diagnostic{ErrorKind::Usage, folder, "", GLISSADE_TEXT("is not a folder of study results"),
                      GLISSADE_TEXT("Choose a new folder as --out.")};
  }
  const Outcome made = makeFolder(folder);
  if (!made) return made;
  const Outcome planned = there ? Outcome(Done{}) : writeFileAtomically(planFile(folder), planText);
  if (!planned) return planned;
  const std::string copy = folder + "/study.json";
  const Outcome copied = fs::exists(copy) ? Outcome(Done{}) : writeFileAtomically(copy, studyText);
  return copied ? makeFolder(folder + "/runs") : copied;
}

}  // namespace

Result<StudyFolder> StudyFolder::begin(const std::string& folder, const StudyPlan& plan, const std::string& studyText) {
  const std::string planText = writePlan(plan);
  const Outcome ready = layOut(folder, studyText, planText);
  if (!ready) return ready.error();
  return StudyFolder(folder, plan, planText);
}

StudyFolder::StudyFolder(std::string path, StudyPlan plan, std::string planText)
    : path_(std::move(path)), plan_(std::move(plan)), planText_(std::move(planText)), planSha256_(sha256(planText_)) {}

Result<StudyFolder> StudyFolder::open(const std::string& folder) {
  const auto text = readFile(planFile(folder), kMostPlanBytes);
  if (!text) return text.error();
  auto plan = readPlan(*text, planFile(folder));
  if (!plan) return plan.error();
  return StudyFolder(folder, std::move(*plan), *text);
}

std::string StudyFolder::fileOf(const StudyRun& run) const {
  return path_ + "/runs/cell" + std::to_string(run.cell + 1) + "-seed" + std::to_string(run.seed) + ".json";
}

StudyResults StudyFolder::results(Warnings& warnings, const WorkWatch& watch) const {
  StudyResults results;
  const std::vector<StudyRun> planned = runsOf(plan_.study, {});
  std::size_t looked = 0;
  for (const StudyRun& run : planned) {
    if (watch.stop.stopRequested()) return results;
    watch.report(static_cast<double>(looked++) / static_cast<double>(planned.size()));
    const std::string file = fileOf(run);
    if (!fs::exists(file)) continue;
    const auto text = readFile(file, kMostRunBytes);
    const auto row = text ? readRunRow(*text, file) : Result<RunRow>(text.error());
    if (!row) {
      warnings.push_back(row.error());
    } else if (row->plan != planSha256_ || row->cell != run.cell + 1 || row->seed != run.seed) {
      warnings.push_back(
          {ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("is of another plan"), GLISSADE_TEXT("It is left out.")});
    } else {
      results.emplace(run, row->outcome);
    }
  }
  return results;
}

Outcome StudyFolder::noteStudyFile(const std::string& studyFile) const {
  std::error_code error;
  const std::string absolute = fs::absolute(studyFile, error).lexically_normal().string();
  return writeFileAtomically(file("origin.txt"), (error ? studyFile : absolute) + "\n");
}

Result<std::string> StudyFolder::scenarioFile(const StudyCell& cell) const {
  const auto origin = readFile(file("origin.txt"), kMostRunBytes);
  if (!origin) return origin.error();
  const std::string found = scenarioFileOf(origin->substr(0, origin->find('\n')), cell);
  std::error_code ignored;
  if (fs::exists(found, ignored)) return found;
  return Diagnostic{
      ErrorKind::MalformedInput,
      found,
      "",
      GLISSADE_TEXT("the scenario of the study is no longer there"),
      {GLISSADE_TEXT("Put it back, or write the place of the study file into %1."), {file("origin.txt")}}};
}

Outcome StudyFolder::save(const StudyRun& run, const RunOutcome& outcome) const {
  return writeFileAtomically(fileOf(run), writeRunRow({planSha256_, run.cell + 1, run.seed, outcome}));
}

bool isStudyRunFile(const std::string& file) {
  std::array<char, 64> beginning{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), beginning.size());
  const std::string_view text(beginning.data(), static_cast<std::size_t>(stream.gcount()));
  return text.find("\"glissade-study-run\"") != std::string_view::npos;
}

Result<StudyRunFile> openStudyRun(const std::string& file) {
  const auto text = readFile(file, kMostRunBytes);
  if (!text) return text.error();
  const auto row = readRunRow(*text, file);
  if (!row) return row.error();
  auto folder = StudyFolder::open(fs::absolute(file).parent_path().parent_path().string());
  if (!folder) return folder.error();
  if (row->plan != folder->planSha256() || row->cell < 1 || row->cell > folder->plan().study.cells.size()) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("is of another plan"),
                      GLISSADE_TEXT("Choose a run in the folder of its study.")};
  }
  const StudyRun run{row->cell - 1, row->seed};
  return StudyRunFile{std::move(*folder), run, row->outcome};
}

}  // namespace glissade
