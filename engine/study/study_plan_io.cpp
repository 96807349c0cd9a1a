#include "engine/study/study_json.h"
#include "engine/study/study_plan.h"

namespace glissade {
namespace {

/// Adds the parameters that were added after the study was run. Their defaults give the former behaviour. Parameters
/// that depend on the object existed from the beginning.
void completeParameters(StudyCell& cell, const JsonCursor& at) {
  for (const ParameterSpec& spec : parameterTable()) {
    if (cell.parameters.count(spec.id) != 0) continue;
    if (spec.scale != ParameterScale::Absolute) at.at("parameters").fail({GLISSADE_TEXT("has no '%1'"), {spec.key}});
    cell.parameters[spec.id] = spec.defaultValue;
  }
}

}  // namespace

template <class Archive>
void describe(Archive& cell, Type<StudyCell> /*type*/) {
  cell.type("cell");
  cell.required("label", &StudyCell::label, kText);
  cell.required("row", &StudyCell::row, kText);
  cell.required("scenario", &StudyCell::scenario, kNonEmptyText);
  cell.required("scenario_sha256", &StudyCell::scenarioSha256, kText);
  cell.required("strategy", &StudyCell::strategy, kNonEmptyText);
  cell.required("operator", &StudyCell::operatorName, kNonEmptyText);
  cell.required("settings", &StudyCell::settings, study_json::ParameterNumbersFormat());
  cell.required("parameters", &StudyCell::parameters, study_json::ParameterNumbersFormat());
  cell.check(completeParameters);
  cell.required("memory_limit_mb", &StudyCell::memoryLimitMb, kCount);
  cell.required("seeds", &StudyCell::seeds, listOf(kCount, 1, kAnyNumber));
  cell.required("paper", &StudyCell::paper, study_json::PaperFormat());
}

template <class Archive>
void describe(Archive& study, Type<Study> /*type*/) {
  study.type("cells_of_study");
  study.required("quick", &Study::quick, kBoolean);
  study.embed(&Study::heading);
  study.required("cells", &Study::cells, listOf(kObject<StudyCell>, 1, kAnyNumber));
}

template <class Archive>
void describe(Archive& plan, Type<StudyPlan> /*type*/) {
  plan.type("study_plan");
  plan.constant("format", "glissade-study-plan");
  plan.constant("version", 1);
  plan.required("glissade", &StudyPlan::version, kText);
  plan.required("study_sha256", &StudyPlan::studySha256, kText);
  plan.embed(&StudyPlan::study);
}

std::string writePlan(const StudyPlan& plan) { return jsonText(writeDescribed(plan), 1) + "\n"; }

Result<StudyPlan> readPlan(const std::string& text, const std::string& file) {
  return readJson(text, file, readDescribed<StudyPlan>);
}

}  // namespace glissade
