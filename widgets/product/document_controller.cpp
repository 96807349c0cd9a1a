#include "widgets/product/document_controller.h"

namespace glissade {

DocumentController::DocumentController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  const QUndoStack& undo = bench.document.undoStack();
  bench.onAction("edit.undo", this, [this] { bench_.document.undo(); });
  bench.onAction("edit.redo", this, [this] { bench_.document.redo(); });
  connect(&undo, &QUndoStack::canUndoChanged, bench.actions["edit.undo"], &QAction::setEnabled);
  connect(&undo, &QUndoStack::canRedoChanged, bench.actions["edit.redo"], &QAction::setEnabled);
  for (const char* id : {"edit.undo", "edit.redo"}) bench.enable(id, false);
  bench.work.show(
      bench.document.arranging(), [this] { return arranging(); }, [this] { bench_.document.cancelEdits(); });
  connect(&bench.document, &WorkbenchDocument::changedForSession, &bench.work, [this](Changes what) {
    if (what & (Change::Scenario | Change::Arrangement)) bench_.work.cancel();
  });
}

QString DocumentController::arranging() const {
  if (bench_.document.isEditing()) return tr("Arranging the product");
  return bench_.document.scenario()->fitsPending ? tr("Finding the fits") : tr("Preparing the bodies");
}

}  // namespace glissade
