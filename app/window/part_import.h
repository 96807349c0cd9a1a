#pragma once

#include <vector>

#include "app/window/workbench.h"
#include "widgets/editors/parts_dialog.h"

namespace glissade {

/// Brings part files in: as a scenario of their own, or into the one that is open. They are read in the
/// background.
class PartImport final : public QObject {
  Q_OBJECT

 public:
  explicit PartImport(const Workbench& bench);

  /// Asks how these files, and others, are to be taken.
  void ask(PartsDialog::Purpose purpose, const QStringList& files = {});
  /// What is in `read` is not read again.
  void take(PartsDialog::Purpose purpose, const std::vector<PartFile>& parts, const GeometryCache& read = {});

 signals:
  /// A scenario that is saved nowhere yet.
  void scenarioMade(const glissade::ScenarioPtr& scenario);
  void importFailed(const glissade::Diagnostic& why);

 private:
  BackgroundTask::Delivery makeScenario(const std::vector<PartFile>& parts, GeometryCache read, const StopToken& stop);
  void add(const std::vector<PartFile>& parts, const GeometryCache& read);

  const Workbench& bench_;
};

}  // namespace glissade
