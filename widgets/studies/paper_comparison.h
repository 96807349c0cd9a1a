#pragma once

#include <string>
#include <vector>

#include "engine/study/study.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Puts a solved run of a paper's environment beside the paper's numbers. They are in the studies of the folder
/// "studies" beside that of the scenario, with the spread that the studies had here.
class PaperComparison final : public QObject {
  Q_OBJECT

 public:
  explicit PaperComparison(const Workbench& bench);

 signals:
  /// The rows of the tables that have the settings of the run, as HTML; empty: none.
  void compared(const QString& html);

 private:
  void followRun(const SnapshotPtr& snapshot);
  const std::vector<Study>& studiesOf(const std::string& scenarioFile);

  const Workbench& bench_;
  std::string scenarioFile_;       ///< file to which studies_ belongs
  std::vector<Study> studies_;     ///< studies that name a paper and this scenario
  std::uint64_t comparedRun_ = 0;  ///< run that is compared; 0: none
};

}  // namespace glissade
