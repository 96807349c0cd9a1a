#pragma once

#include <QMainWindow>
#include <QPointer>

#include "app/window/workbench.h"
#include "widgets/manual/manual_browser.h"

namespace glissade {

/// What the manual takes from the window: actions with their menus and keys, and panels, in its language.
ManualFacts manualFacts(const QMainWindow& window, const ActionCatalogue& actions);

/// Help > Manual, and the section of the panel that has the focus.
class ManualController final : public QObject {
  Q_OBJECT

 public:
  explicit ManualController(const Workbench& bench);

 private:
  /// Empty: where it was, or its first page.
  void open(const QString& page, const QString& anchor);
  void openForPanel();
  void addCommands();

  const Workbench& bench_;
  QPointer<ManualBrowser> browser_;
};

}  // namespace glissade
