#pragma once

#include <vector>

#include "app/window/work_controller.h"
#include "widgets/editors/parts_dialog.h"
#include "widgets/model/assembly_document.h"

namespace glissade {

/// Brings part files in: as a scenario of their own, or into the one that is open. They are read in the
/// background. Part of the main window.
class PartImport final : public QObject {
  Q_OBJECT

 public:
  PartImport(AssemblyDocument& document, WorkController& work, QWidget* window);

  /// Asks how these files, and others, are to be taken.
  void ask(PartsDialog::Purpose purpose, const QStringList& files = {});
  /// What is in `read` is not read again.
  void take(PartsDialog::Purpose purpose, const std::vector<PartFile>& parts, const GeometryCache& read = {});

 signals:
  /// A scenario that is saved nowhere yet.
  void made(const glissade::ScenarioPtr& scenario);
  void failed(const glissade::Diagnostic& why);

 private:
  BackgroundTask::Delivery makeScenario(const std::vector<PartFile>& parts, GeometryCache read, const StopToken& stop);
  void add(const std::vector<PartFile>& parts, const GeometryCache& read);

  AssemblyDocument& document_;
  WorkController& work_;
  QWidget* window_;
};

}  // namespace glissade
