#pragma once

#include <QAction>
#include <QString>

namespace glissade {

/// The menus that lead from the menu bar to the action, in the language of the window: "View > Layers". Empty where the
/// menu bar does not have it.
QString menuPath(const QAction& action);

}  // namespace glissade
