#pragma once

#include <QProcess>
#include <QSize>

#include <optional>

#include "widgets/film/film_writer.h"

namespace glissade {

/// Whether ffmpeg writes films with this ending ("mp4").
bool isFfmpegFilm(const QString& ending);

/// Sends the pictures to ffmpeg through a pipe. ffmpeg writes the film beside its final name; the file is renamed at
/// the end.
class FfmpegWriter final : public FilmWriter {
  Q_OBJECT

 public:
  /// `program`: file name of ffmpeg. The process starts with the first picture, which determines the size.
  FfmpegWriter(QString program, const QString& file);
  ~FfmpegWriter() override;

  bool isBusy() const override;
  void add(const QImage& picture) override;
  void close() override;
  void wait() override;

 private:
  void start(const QSize& size);
  void takeEnd();
  void end(const SaveResult& result);
  SaveResult refused(const QString& reason) const;

  QString program_;
  QString file_;
  QString unfinished_;  ///< the file that ffmpeg writes
  QProcess process_;
  std::optional<QSize> size_;
  bool ended_ = false;
};

}  // namespace glissade
