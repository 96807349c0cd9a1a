#pragma once

#include <QImage>
#include <QObject>
#include <QString>

#include <memory>

#include "engine/base/file_save.h"

namespace glissade {

/// Pictures of a film in one second.
inline constexpr int kFilmRate = 25;

/// Takes the pictures of a film one after the other. GUI thread; an object that is destroyed early leaves no film.
class FilmWriter : public QObject {
  Q_OBJECT

 public:
  /// Pictures wait in memory that were not taken over yet: ready() says when the next one may come.
  virtual bool isBusy() const = 0;
  /// Of the size of the first one; others are scaled.
  virtual void add(const QImage& picture) = 0;
  /// No picture comes any more: ended() follows.
  virtual void close() = 0;
  /// Returns after the next ready() or ended(). For scripts, which have no event loop.
  virtual void wait() = 0;

 signals:
  void ready();
  /// Also before close(), where no more pictures can be taken.
  void ended(const glissade::SaveResult& result);
};

/// Whether films are written in the format of the file's ending: .mp4, .webm, or .png (a numbered picture each).
bool isFilm(const QString& file);
/// The filter of a file dialog. Without ffmpeg: of series of pictures alone.
QString filmFilter(bool withFfmpeg = true);
/// Nothing where ffmpeg is installed. What it says is about no file yet.
std::optional<Diagnostic> whyNoFfmpeg();

/// MP4 (H.264) and WebM (VP9) are made by ffmpeg in a process of its own. The file is there as a whole or not at all.
/// Errors: Usage for another ending, and where ffmpeg is not installed.
Result<std::unique_ptr<FilmWriter>> makeFilmWriter(const QString& file);

}  // namespace glissade
