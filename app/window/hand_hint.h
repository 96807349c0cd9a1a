#pragma once

#include "app/window/scene_hint.h"
#include "app/window/workbench.h"

namespace glissade {

/// The line over the scene for a person who steers: what the search asks of the hand, and the keys while a run goes on
/// by hand.
class HandHint final : public QObject {
  Q_OBJECT

 public:
  explicit HandHint(const Workbench& bench);

  /// Empty: nothing is asked.
  void ask(const QString& text);

 private:
  void write();
  QString keys() const;

  const Workbench& bench_;
  SceneHint* hint_;
  QString asked_;
  QString shown_;
};

}  // namespace glissade
