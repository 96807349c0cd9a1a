#include "widgets/workbench/editor_in_use.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QLineEdit>
#include <QPointer>

namespace glissade {

void commitEditorInUse() {
  const QPointer<QWidget> editor = QApplication::focusWidget();
  if (qobject_cast<QLineEdit*>(editor) == nullptr && qobject_cast<QAbstractSpinBox*>(editor) == nullptr) return;
  editor->clearFocus();
  if (editor && editor->isVisible()) editor->setFocus();
}

void commitBefore(const ActionCatalogue& actions) {
  for (const ActionSpec& spec : actions.specs()) {
    QObject::connect(actions[QLatin1String(spec.id)], &QAction::triggered, &commitEditorInUse);
  }
}

}  // namespace glissade
