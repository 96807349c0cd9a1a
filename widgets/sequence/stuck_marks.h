#pragma once

#include "widgets/document/semantic_document.h"
#include "widgets/sequence/sequence_panel.h"

namespace glissade {

/// Selects a stuck part that is chosen in the panel together with the bodies that block it, so that the view marks
/// them. The selection ends when a step is chosen.
class StuckMarks final : public QObject {
  Q_OBJECT

 public:
  StuckMarks(SemanticDocument& semantics, SequencePanel& panel);

 private:
  void show(const QString& bodyId);
  void clear();

  SemanticDocument& semantics_;
  SequencePanel& panel_;
  SemanticSelection marked_;  ///< the selection that this object made
};

}  // namespace glissade
