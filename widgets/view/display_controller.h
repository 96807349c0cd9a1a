#pragma once

#include <QObject>

#include "widgets/workbench/workbench.h"

namespace glissade {

/// Sets how obstacles are drawn: the display mode of the view, and display modes of single bodies. The scenario does
/// not keep them.
class DisplayController final : public QObject {
  Q_OBJECT

 public:
  explicit DisplayController(const Workbench& bench);

 private:
  void setMode(DisplayMode mode);
  /// Without a value the bodies have the mode of the view.
  void setModeOfSelected(std::optional<DisplayMode> mode);
  void checkAction();
  void enableActions();

  const Workbench& bench_;
};

}  // namespace glissade
