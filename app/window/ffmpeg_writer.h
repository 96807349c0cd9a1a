#pragma once

#include <QProcess>
#include <QSize>

#include <optional>

#include "app/window/film_writer.h"

namespace glissade {

/// Whether ffmpeg is asked for films of this ending ("mp4").
bool isFfmpegFilm(const QString& ending);

/// Gives the pictures to ffmpeg through a pipe. The film is written beside its file and renamed at the end.
class FfmpegWriter final : public FilmWriter {
  Q_OBJECT

 public:
  /// `program`: of ffmpeg. The process starts with the first picture, which gives the size.
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
  QString unfinished_;  ///< what ffmpeg writes
  QProcess process_;
  std::optional<QSize> size_;
  bool ended_ = false;
};

}  // namespace glissade
