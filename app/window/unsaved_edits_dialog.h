#pragma once

#include <QWidget>

#include <functional>

#include "engine/scenario/autosave.h"

namespace glissade {

/// Opens edits in the window. False: that cannot be done, and the user has seen why.
using OpenEdits = std::function<bool(const UnsavedEdits&)>;

/// Asks about each set of edits that a killed program has left in the folder: open them, discard them, or be asked
/// again at the next start. Nothing is opened without being asked for, and no file of the user is written. Edits
/// that their file holds already are removed without a question.
void offerUnsavedEdits(const QString& folder, const OpenEdits& open, QWidget* parent);

}  // namespace glissade
