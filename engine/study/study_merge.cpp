#include "engine/base/file.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_reader.h"
#include "engine/study/study_tables.h"

namespace glissade {
namespace {

/// Adds the results of a folder. A run that is known already must have the same result, unless one of the results
/// depends on the machine.
Outcome unite(const StudyFolder& folder, StudyResults& all, Warnings& warnings) {
  for (const auto& [run, outcome] : folder.results(warnings)) {
    const auto [entry, isNew] = all.emplace(run, outcome);
    const RunResult& known = entry->second.result;
    if (isNew || known == outcome.result) continue;
    if (dependsOnMachine(known.status) || dependsOnMachine(outcome.result.status)) continue;
    return Diagnostic{
        ErrorKind::MalformedInput, folder.path(),
        "cell " + std::to_string(run.cell + 1) + ", seed " + std::to_string(run.seed),
        GLISSADE_TEXT("has another result than a folder named before it"),
        GLISSADE_TEXT("The same run must end the same everywhere: look for different builds of Glissade.")};
  }
  return Done{};
}

}  // namespace

Result<StudyFolder> mergeStudies(const std::vector<std::string>& folders, const std::string& out, Warnings& warnings) {
  const auto first = StudyFolder::open(folders.front());
  if (!first) return first.error();
  StudyResults all;
  for (const std::string& path : folders) {
    const auto folder = StudyFolder::open(path);
    if (!folder) return folder.error();
    if (folder->planText() != first->planText()) {
      return Diagnostic{ErrorKind::MalformedInput,
                        path,
                        "plan.json",
                        {GLISSADE_TEXT("is of another study, version or size than %1"), {first->path()}},
                        GLISSADE_TEXT("Merge folders of one study, made by one version of Glissade.")};
    }
    const Outcome united = unite(*folder, all, warnings);
    if (!united) return united.error();
  }
  const auto studyText = readFile(first->file("study.json"), kMostStudyBytes);
  if (!studyText) return studyText.error();
  auto merged = StudyFolder::begin(out, first->plan(), *studyText);
  if (!merged) return merged.error();
  const auto origin = readFile(first->file("origin.txt"), kMostStudyBytes);
  if (origin) {
    const Outcome noted = merged->noteStudyFile(origin->substr(0, origin->find('\n')));
    if (!noted) return noted.error();
  }
  for (const auto& [run, outcome] : all) {
    const Outcome saved = merged->save(run, outcome);
    if (!saved) return saved.error();
  }
  const Outcome written = writeTables(*merged, out, warnings);
  if (!written) return written.error();
  return merged;
}

}  // namespace glissade
