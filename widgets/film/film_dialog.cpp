#include "widgets/film/film_dialog.h"

#include "widgets/film/film_writer.h"
#include "widgets/workbench/proposed_file.h"

namespace glissade {

QString chooseFilmFile(const Workbench& bench, const QString& title, const QString& what) {
  const auto missing = whyNoFfmpeg();
  if (missing) bench.messages.showError(title, *missing);
  const QString name = what + (missing ? QStringLiteral(".png") : QStringLiteral(".mp4"));
  return bench.dialogs.save(FilePurpose::Film, title, proposedFile(*bench.document.scenario(), name),
                            filmFilter(!missing));
}

}  // namespace glissade
