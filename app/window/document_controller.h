#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// Undo and redo, and what the document does in the background, as the window shows it.
class DocumentController final : public QObject {
  Q_OBJECT

 public:
  explicit DocumentController(const Workbench& bench);

 private:
  QString arranging() const;

  const Workbench& bench_;
};

}  // namespace glissade
