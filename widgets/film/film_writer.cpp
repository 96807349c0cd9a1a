#include "widgets/film/film_writer.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include "widgets/controls/picture_file.h"
#include "widgets/film/ffmpeg_writer.h"

namespace glissade {
namespace {

QString endingOf(const QString& file) { return QFileInfo(file).suffix().toLower(); }

/// Writes a series of numbered pictures: film.png becomes film-0001.png and so on.
class PictureSeries final : public FilmWriter {
 public:
  explicit PictureSeries(const QString& file) : file_(file) {}

  bool isBusy() const override { return false; }

  void add(const QImage& picture) override {
    const SaveResult saved = savePicture(picture, nextFile());
    if (!saved) emit ended(saved);
  }

  void close() override { emit ended({SaveStatus::Saved, {}, {}, {}}); }
  void wait() override {}

 private:
  QString nextFile() {
    const QFileInfo info(file_);
    const QString number = QStringLiteral("-%1.").arg(++pictures_, 4, 10, QLatin1Char('0'));
    return info.path() + QLatin1Char('/') + info.completeBaseName() + number + info.suffix();
  }

  QString file_;
  int pictures_ = 0;
};

QString ffmpeg() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

}  // namespace

bool isFilm(const QString& file) {
  const QString ending = endingOf(file);
  return ending == QLatin1String("png") || isFfmpegFilm(ending);
}

QString filmFilter(bool withFfmpeg) {
  const QString pictures = QCoreApplication::translate("FilmWriter", "Series of pictures (*.png)");
  if (!withFfmpeg) return pictures;
  return QCoreApplication::translate("FilmWriter", "Film (*.mp4);;Film (*.webm)") + QStringLiteral(";;") + pictures;
}

std::optional<Diagnostic> whyNoFfmpeg() {
  if (!ffmpeg().isEmpty()) return std::nullopt;
  return Diagnostic{
      ErrorKind::Usage, "", "", GLISSADE_TEXT("ffmpeg is needed for films, and is not installed"),
      GLISSADE_TEXT("Install the package ffmpeg, or give a name that ends with .png for a series of pictures.")};
}

Result<std::unique_ptr<FilmWriter>> makeFilmWriter(const QString& file) {
  if (!isFilm(file)) {
    return Diagnostic{ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("films are not written in this format"),
                      GLISSADE_TEXT("Choose one of: .mp4, .webm, .png.")};
  }
  if (!isFfmpegFilm(endingOf(file))) return std::unique_ptr<FilmWriter>(std::make_unique<PictureSeries>(file));
  if (auto missing = whyNoFfmpeg()) {
    missing->file = file.toStdString();
    return *missing;
  }
  return std::unique_ptr<FilmWriter>(std::make_unique<FfmpegWriter>(ffmpeg(), file));
}

}  // namespace glissade
