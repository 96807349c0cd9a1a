#pragma once

#include <vector>

#include "widgets/product/parts_dialog.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Imports part files as a new scenario or into the open one. They are read in the background.
class PartImport final : public QObject {
  Q_OBJECT

 public:
  explicit PartImport(const Workbench& bench);

  /// Asks how to import these files; the person can add other files.
  void ask(PartsDialog::Purpose purpose, const QStringList& files = {});
  /// Imports parts. Files whose geometry is in `read` are not read again.
  void take(PartsDialog::Purpose purpose, const std::vector<PartFile>& parts, const GeometryCache& read = {});

 signals:
  /// A scenario was made that is not saved yet.
  void scenarioMade(const glissade::ScenarioPtr& scenario);
  void importFailed(const glissade::Diagnostic& why);

 private:
  BackgroundTask::Delivery makeScenario(const std::vector<PartFile>& parts, GeometryCache read, const StopToken& stop);
  void add(const std::vector<PartFile>& parts, const GeometryCache& read);

  const Workbench& bench_;
};

}  // namespace glissade
