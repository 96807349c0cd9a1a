#pragma once

#include <QWidget>

#include "engine/base/file_save.h"

namespace glissade {

/// What the user wants where a file does not hold any more what was opened.
enum class ConflictAnswer { KeepMine, TakeTheirs, SaveAs, Cancel };

/// Asks in a dialog. `refused` is ChangedByOthers or RemovedByOthers; a removed file has no version to take.
ConflictAnswer askAboutConflict(const SaveResult& refused, QWidget* parent);

}  // namespace glissade
