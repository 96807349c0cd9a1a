#pragma once

#include <QTimer>

#include <vector>

#include "widgets/openxr/headset_tools.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The texts in the scene of the headset: the labels of the window's scene, and the distance to the nearest obstacle
/// beside the hand that holds the object. They are painted again only when they change.
class HeadsetTexts final : public QObject {
  Q_OBJECT

 public:
  HeadsetTexts(const Workbench& bench, HeadsetToolsPtr tools);

  /// Turns the texts on or off. They are off at first and while the headset is off.
  void setOn(bool on);
  /// Sets the text at the hand while it does not hold the object; empty: none.
  void setHint(const QString& hint);

 private:
  void showLabels();
  void showNote();
  /// Whether a hand holds the object.
  bool holds() const;

  const Workbench& bench_;
  HeadsetToolsPtr tools_;
  QTimer timer_;  ///< polls, because labels change with layers, language and measurements without a signal
  std::vector<SceneLabel> labels_;
  QString note_;
  QString hint_;
};

}  // namespace glissade
