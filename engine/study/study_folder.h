#pragma once

#include <map>
#include <string>

#include "engine/base/result.h"
#include "engine/base/work_watch.h"
#include "engine/study/run_result.h"
#include "engine/study/study_plan.h"

namespace glissade {

/// The results so far, in the order of cells and seeds.
using StudyResults = std::map<StudyRun, RunOutcome>;

/// A folder of results:
///
///     study.json   the study file, byte for byte
///     plan.json    the resolved study (StudyPlan): folders belong together when these are equal
///     runs/        one file a run, written when it has ended: a killed study loses no finished run
///     *.csv, summary.json   the tables (study_tables.h)
///     report.html  the page (study_page.h), with the pictures in pictures/
///     origin.txt   path of the study file, for opening its scenarios
///
/// Several processes may work in one folder.
class StudyFolder {
 public:
  /// Makes the folder, or continues one that was begun with the same plan. A folder of another study or version, or
  /// with other content, is a Usage error.
  static Result<StudyFolder> begin(const std::string& folder, const StudyPlan& plan, const std::string& studyText);
  /// Opens an existing folder of results; anything else is a MalformedInput error.
  static Result<StudyFolder> open(const std::string& folder);

  const std::string& path() const { return path_; }
  const StudyPlan& plan() const { return plan_; }
  const std::string& planText() const { return planText_; }
  const std::string& planSha256() const { return planSha256_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// All planned runs that have results. A file that cannot be read, or belongs to another plan, counts as not run and
  /// is named in a warning. After a stop, the runs read so far.
  StudyResults results(Warnings& warnings, const WorkWatch& watch = {}) const;
  /// Stores the path of the study file, for scenarioFile.
  Outcome noteStudyFile(const std::string& studyFile) const;
  /// The scenario of a cell, relative to the study file at the time of the run. Error: MalformedInput where that path
  /// is not known, or the scenario does not exist any more.
  Result<std::string> scenarioFile(const StudyCell& cell) const;
  Outcome save(const StudyRun& run, const RunOutcome& outcome) const;

 private:
  StudyFolder(std::string path, StudyPlan plan, std::string planText);

  std::string fileOf(const StudyRun& run) const;

  std::string path_;
  StudyPlan plan_;
  std::string planText_;
  std::string planSha256_;
};

/// The run of a file runs/cellN-seedM.json, in the folder of its study.
struct StudyRunFile {
  StudyFolder folder;
  StudyRun run;
  RunOutcome outcome;
};

/// True if the content of the file begins as that of a run.
bool isStudyRunFile(const std::string& file);
/// Opens the file of a run. MalformedInput: a file that is no run, or not in the folder of its study.
Result<StudyRunFile> openStudyRun(const std::string& file);

/// Unites the results of folders with the same plan in `out` (new, or of that plan) and writes its tables. Refused:
/// different plans; a run that two folders have with different results, unless one of them depends on the machine (then
/// the result of the folder named first is taken).
Result<StudyFolder> mergeStudies(const std::vector<std::string>& folders, const std::string& out, Warnings& warnings);

}  // namespace glissade
