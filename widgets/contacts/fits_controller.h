#pragma once

#include "widgets/contacts/fits_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The fits of the open product: found on demand in the background, shown in a panel, and edited by a person, pair by
/// pair. Edits are undoable and kept in the scenario.
class FitsController final : public QObject {
  Q_OBJECT

 public:
  explicit FitsController(const Workbench& bench);

  FitsPanel* panel() const { return panel_; }

 private:
  void followDocument(Changes what);
  void find();
  void showChosen();
  void isolateChosen();
  /// Changes the person's edit of the chosen pair.
  void editChosen(const QString& text, const std::function<void(FitEdit&)>& change);
  void enableActions();
  void addCommands();

  const Workbench& bench_;
  FitsPanel* panel_;
};

}  // namespace glissade
