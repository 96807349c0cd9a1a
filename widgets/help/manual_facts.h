#pragma once

#include <QString>

#include <vector>

namespace glissade {

/// An action of the window, in the language of the window.
struct ManualAction {
  QString id;
  QString text;
  QString menu;  ///< "View > Layers"; empty if no menu has the action
  QString keys;  ///< empty: none
  QString tip;
};

struct ManualPanel {
  QString id;  ///< object name of its dock
  QString title;
  QString keys;
};

/// Facts about the window, which the manual takes from the window itself.
struct ManualFacts {
  QString language;  ///< "en" or "fr"
  std::vector<ManualAction> actions;
  std::vector<ManualPanel> panels;
  QString steeringRows;  ///< rows of an HTML table: keys and their effects
};

}  // namespace glissade
