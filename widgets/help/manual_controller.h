#pragma once

#include <QMainWindow>
#include <QPointer>

#include "widgets/help/manual_browser.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The facts that the manual takes from the window: actions with their menus and keys, and panels, in the window's
/// language.
ManualFacts manualFacts(const QMainWindow& window, const ActionCatalogue& actions);

/// Opens the manual, also at the section of the panel that has the focus.
class ManualController final : public QObject {
  Q_OBJECT

 public:
  explicit ManualController(const Workbench& bench);

 private:
  /// Opens a page. An empty name opens the page that was shown last, or the first page.
  void open(const QString& page, const QString& anchor);
  void openForPanel();
  void addCommands();

  const Workbench& bench_;
  QPointer<ManualBrowser> browser_;
};

}  // namespace glissade
