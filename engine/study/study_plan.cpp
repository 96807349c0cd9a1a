#include "engine/study/study_plan.h"

#include <glissade/version.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/files/scenario_file.h"
#include "engine/study/study_reader.h"

namespace glissade {
namespace {

/// Data of a scenario that cells need.
struct KnownScenario {
  std::string sha256;
  ParameterValues parameters{1.0};
};

Result<KnownScenario> look(const std::string& file, Warnings& warnings) {
  auto loaded = loadScenario(file);
  if (!loaded) return loaded.error();
  warnings.insert(warnings.end(), loaded->warnings.begin(), loaded->warnings.end());
  return KnownScenario{sha256(scenarioText(loaded->scenario)), loaded->parameters};
}

Outcome resolve(StudyCell& cell, const KnownScenario& known, const std::string& studyFile) {
  cell.scenarioSha256 = known.sha256;
  ParameterValues values = known.parameters;
  for (const auto& [id, value] : cell.settings) {
    const Outcome set = values.set(id, value);
    if (!set) {
      const std::string location =
          (cell.location.empty() ? "/" : cell.location) + ": " + toString(set.error().location);
      return Diagnostic{ErrorKind::MalformedInput, studyFile, location, set.error().reason, set.error().advice};
    }
  }
  for (const ParameterSpec& spec : parameterTable()) cell.parameters[spec.id] = values[spec.id];
  return Done{};
}

}  // namespace

Result<StudyPlan> planStudy(const std::string& studyFile, bool quick, Warnings& warnings) {
  const auto text = readFile(studyFile, kMostStudyBytes);
  if (!text) return text.error();
  auto study = parseStudy(*text, studyFile, quick);
  if (!study) return study.error();
  std::map<std::string, KnownScenario> known;
  for (StudyCell& cell : study->cells) {
    auto found = known.find(cell.scenario);
    if (found == known.end()) {
      auto seen = look(scenarioFileOf(studyFile, cell), warnings);
      if (!seen) return seen.error();
      found = known.emplace(cell.scenario, *seen).first;
    }
    const Outcome resolved = resolve(cell, found->second, studyFile);
    if (!resolved) return resolved.error();
  }
  return StudyPlan{std::move(*study), sha256(*text), kVersion};
}

std::vector<StudyRun> runsOf(const Study& study, const Shard& shard) {
  struct Place {
    std::size_t seedIndex;
    StudyRun run;
  };
  std::vector<Place> places;
  std::size_t counted = 0;
  for (std::size_t cell = 0; cell < study.cells.size(); ++cell) {
    const auto& seeds = study.cells[cell].seeds;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (counted++ % shard.count == shard.index - 1) places.push_back({i, {cell, seeds[i]}});
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.seedIndex < b.seedIndex; });
  std::vector<StudyRun> runs;
  runs.reserve(places.size());
  for (const Place& place : places) runs.push_back(place.run);
  return runs;
}

std::string scenarioFileOf(const std::string& studyFile, const StudyCell& cell) {
  return (std::filesystem::path(folderOf(studyFile)) / cell.scenario).lexically_normal().string();
}

bool isSequence(const StudyCell& cell) { return cell.strategy.starts_with(kSequencePrefix); }

std::vector<std::string> planArguments(const StudyCell& cell, std::uint64_t seed, const std::string& scenarioFile) {
  if (isSequence(cell)) {
    return {"sequence", scenarioFile,         "--strategy",   cell.strategy.substr(kSequencePrefix.size()),
            "--seed",   std::to_string(seed), "--time-limit", toText(cell.settings.at(ParameterId::TimeLimit)),
            "--json"};
  }
  std::vector<std::string> arguments{"plan",       scenarioFile,      "--strategy", cell.strategy,
                                     "--operator", cell.operatorName, "--seed",     std::to_string(seed)};
  for (const auto& [id, value] : cell.settings) {
    arguments.emplace_back(specOf(id).option);
    arguments.push_back(toText(value));
  }
  arguments.emplace_back("--json");
  return arguments;
}

}  // namespace glissade
