#pragma once

#include <QWidget>

#include "engine/base/file_save.h"

namespace glissade {

/// The user's answer if the file's content differs from the opened one.
enum class ConflictAnswer { KeepMine, TakeTheirs, SaveAs, Cancel };

/// Asks in a dialog. `refused`: ChangedByOthers or RemovedByOthers. A removed file has no other version to take.
ConflictAnswer askAboutConflict(const SaveResult& refused, QWidget* parent);

}  // namespace glissade
