#pragma once

#include <QTimer>

#include <vector>

#include "app/window/workbench.h"
#include "widgets/headset/headset_tools.h"

namespace glissade {

/// The texts in the scene of the headset: the labels of the window's scene, and how far the nearest obstacle is, at the
/// hand that holds the object. They are painted again when they say something else.
class HeadsetTexts final : public QObject {
  Q_OBJECT

 public:
  HeadsetTexts(const Workbench& bench, HeadsetToolsPtr tools);

  /// Nobody reads them while it is off, as at first.
  void setOn(bool on);
  /// Shown at the hand while it does not hold the object; empty: nothing is.
  void setHint(const QString& hint);

 private:
  void showLabels();
  void showNote();
  /// A hand, the object.
  bool holds() const;

  const Workbench& bench_;
  HeadsetToolsPtr tools_;
  QTimer timer_;  ///< labels change with layers, language and measurements, which say so to nobody
  std::vector<SceneLabel> labels_;
  QString note_;
  QString hint_;
};

}  // namespace glissade
