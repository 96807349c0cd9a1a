#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

/// Shows undo and redo, and the background work of the document.
class DocumentController final : public QObject {
  Q_OBJECT

 public:
  explicit DocumentController(const Workbench& bench);

 private:
  QString arranging() const;

  const Workbench& bench_;
};

}  // namespace glissade
