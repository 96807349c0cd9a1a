#pragma once

#include <QImage>
#include <QObject>
#include <QString>

#include <memory>

#include "engine/base/file_save.h"

namespace glissade {

/// Pictures of a film in one second.
inline constexpr int kFilmRate = 25;

/// Takes the pictures of a film one after the other. It is used on the GUI thread. An object that is destroyed early
/// leaves no film.
class FilmWriter : public QObject {
  Q_OBJECT

 public:
  /// Whether pictures still wait in memory; ready() announces that the next one may come.
  virtual bool isBusy() const = 0;
  /// Adds a picture. All pictures are scaled to the size of the first one.
  virtual void add(const QImage& picture) = 0;
  /// Ends the film; ended() follows.
  virtual void close() = 0;
  /// Returns after the next ready() or ended(). Scripts use it because they have no event loop.
  virtual void wait() = 0;

 signals:
  void ready();
  /// The film has ended. It can end before close() if no more pictures can be written.
  void ended(const glissade::SaveResult& result);
};

/// Whether films are written in the format of the file's ending: .mp4, .webm, or .png (a series of numbered pictures).
bool isFilm(const QString& file);
/// The filter of a file dialog. Without ffmpeg it offers only series of pictures.
QString filmFilter(bool withFfmpeg = true);
/// Why ffmpeg cannot be used, or nothing if it is installed. The message names no file yet.
std::optional<Diagnostic> whyNoFfmpeg();

/// Makes the writer for the file's ending. ffmpeg makes MP4 (H.264) and WebM (VP9) in its own process, and the file
/// appears only when it is complete. Errors: Usage for another ending, and if ffmpeg is needed and not installed.
Result<std::unique_ptr<FilmWriter>> makeFilmWriter(const QString& file);

}  // namespace glissade
