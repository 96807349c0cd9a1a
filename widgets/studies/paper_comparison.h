#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/study/study.h"
#include "widgets/controls/background_task.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The settings that the tables of the papers vary.
inline constexpr std::array kVariedSettings{ParameterId::Alpha, ParameterId::ContactSamples,
                                            ParameterId::ContactDistance};

/// Puts a run in a paper's environment beside the paper's numbers: the row of the present settings, and the numbers of
/// the run once it has a path. They are in the studies of the folder "studies" beside that of the scenario, with the
/// spread that the studies had here.
class PaperComparison final : public QObject {
  Q_OBJECT

 public:
  explicit PaperComparison(const Workbench& bench);

 signals:
  /// The rows of the tables that have the settings of the run, as HTML; empty: none.
  void compared(const QString& html);

 private:
  /// The scenario, the run and the settings that choose the shown rows.
  struct Compared {
    std::string scenarioFile{};
    std::uint64_t run = 0;  ///< the run whose numbers are shown; 0: none has a path
    std::string strategy{};
    std::array<double, kVariedSettings.size()> settings{};

    bool operator==(const Compared&) const = default;
  };

  void followRun();
  Compared present() const;
  void readStudies();
  void show();

  const Workbench& bench_;
  BackgroundTask reading_;
  std::vector<Study> studies_;  ///< studies that name a paper and the scenario of compared_
  Compared compared_;
};

}  // namespace glissade
