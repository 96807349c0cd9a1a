#pragma once

#include <QString>

#include <vector>

namespace glissade {

/// An action as the window has it, in the language of the window.
struct ManualAction {
  QString id;
  QString text;
  QString menu;  ///< "View > Layers"; empty where no menu has it
  QString keys;  ///< empty: none
  QString tip;
};

struct ManualPanel {
  QString id;  ///< object name of its dock
  QString title;
  QString keys;
};

/// What the manual says about the window is taken from the window itself.
struct ManualFacts {
  QString language;  ///< "en" or "fr"
  std::vector<ManualAction> actions;
  std::vector<ManualPanel> panels;
  QString steeringRows;  ///< of an HTML table: keys, what they do
};

}  // namespace glissade
