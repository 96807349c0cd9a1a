#pragma once

#include <QTemporaryDir>

#include "app/window/workbench.h"
#include "engine/base/file_save.h"
#include "engine/study/study_report.h"

namespace glissade {

class SequenceController;

/// Writes the assembly plan that is shown, in the format of a file's ending: .json, .csv, .glb, .html, .pdf. Pictures
/// of a work instruction are taken in the 3D view, whose camera is as before afterwards.
class SequenceOutput final {
 public:
  SequenceOutput(const Workbench& bench, SequenceController& sequence) : bench_(bench), sequence_(sequence) {}

  /// Errors: Usage for another ending; those of writing.
  SaveResult write(const QString& file);

 private:
  std::string productName() const;
  Result<StudyReport> instruction(const QTemporaryDir& folder);
  Outcome takePictures(const QTemporaryDir& folder, std::string& exploded, std::vector<std::string>& steps);
  Outcome drawGraph(const QString& file) const;
  Outcome takePicture(const QString& file);

  const Workbench& bench_;
  SequenceController& sequence_;
};

}  // namespace glissade
