#pragma once

#include <QWidget>

#include <functional>

#include "engine/files/autosave.h"

namespace glissade {

/// Opens edits in the window. Returns false if that failed and the user has seen the reason.
using OpenEdits = std::function<bool(const UnsavedEdits&)>;

/// Asks about each set of edits that a killed program has left in the folder: open it, discard it, or ask again at the
/// next start. Nothing is opened without the user's answer, and no file of the user is written. Edits that their file
/// already holds are removed without a question.
void offerUnsavedEdits(const QString& folder, const OpenEdits& open, QWidget* parent);

}  // namespace glissade
