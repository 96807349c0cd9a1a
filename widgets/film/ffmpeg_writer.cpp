#include "widgets/film/ffmpeg_writer.h"

#include <QFile>
#include <QFileInfo>

#include <cstring>
#include <filesystem>
#include <system_error>

namespace glissade {
namespace {

/// Number of pictures that may wait for ffmpeg.
constexpr qint64 kMostWaiting = 4;

struct Format {
  QString ending;
  QStringList codec;
};

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {QStringLiteral("mp4"),
       {"-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"}},
      {QStringLiteral("webm"),
       {"-c:v", "libvpx-vp9", "-crf", "32", "-b:v", "0", "-row-mt", "1", "-pix_fmt", "yuv420p", "-f", "webm"}}};
  return all;
}

const Format* formatOf(const QString& ending) {
  for (const Format& format : formats()) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

/// The largest size with even numbers of pixels, as codecs need it.
QSize evenSize(const QSize& size) { return {size.width() / 2 * 2, size.height() / 2 * 2}; }

/// The pixels in rows of blue, green, red and an unused byte.
QByteArray bytesOf(const QImage& picture) {
  const QImage rows = picture.convertToFormat(QImage::Format_RGB32);
  const int width = 4 * rows.width();
  QByteArray bytes(width * rows.height(), Qt::Uninitialized);
  for (int y = 0; y < rows.height(); ++y) {
    std::memcpy(bytes.data() + static_cast<std::ptrdiff_t>(y) * width, rows.constScanLine(y),
                static_cast<std::size_t>(width));
  }
  return bytes;
}

}  // namespace

bool isFfmpegFilm(const QString& ending) { return formatOf(ending) != nullptr; }

FfmpegWriter::FfmpegWriter(QString program, const QString& file)
    : program_(std::move(program)), file_(file), unfinished_(file + QStringLiteral(".part")) {
  connect(&process_, &QProcess::bytesWritten, this, [this] {
    if (!isBusy()) emit ready();
  });
  connect(&process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this, [this] { takeEnd(); });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) end(refused(process_.errorString()));
  });
}

FfmpegWriter::~FfmpegWriter() {
  process_.disconnect(this);
  if (process_.state() != QProcess::NotRunning) {
    process_.kill();
    process_.waitForFinished();
  }
  if (size_ && !ended_) QFile::remove(unfinished_);
}

bool FfmpegWriter::isBusy() const {
  return size_ && process_.bytesToWrite() > kMostWaiting * 4 * size_->width() * size_->height();
}

void FfmpegWriter::add(const QImage& picture) {
  if (ended_) return;
  if (!size_) start(evenSize(picture.size()));
  process_.write(bytesOf(picture.scaled(*size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)));
}

void FfmpegWriter::start(const QSize& size) {
  size_ = size;
  const QString pixels = QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
  QStringList arguments{"-hide_banner", "-loglevel", "error", "-y",   "-f", "rawvideo",
                        "-pix_fmt",     "bgr0",      "-s",    pixels, "-r", QString::number(kFilmRate),
                        "-i",           "pipe:0",    "-an"};
  arguments += formatOf(QFileInfo(file_).suffix().toLower())->codec;
  // The prefix "file:" makes ffmpeg take a name with a leading hyphen or a colon as a file.
  arguments << QStringLiteral("file:") + unfinished_;
  process_.start(program_, arguments);
}

void FfmpegWriter::close() {
  if (!ended_) process_.closeWriteChannel();
}

void FfmpegWriter::wait() {
  if (process_.bytesToWrite() > 0) {
    process_.waitForBytesWritten(-1);
  } else {
    process_.waitForFinished(-1);
  }
}

void FfmpegWriter::takeEnd() {
  if (ended_) return;
  if (process_.exitStatus() != QProcess::NormalExit || process_.exitCode() != 0) {
    const QString said = QString::fromUtf8(process_.readAllStandardError()).section(QLatin1Char('\n'), 0, 0).trimmed();
    return end(refused(said.isEmpty() ? QStringLiteral("it ended without a message") : said));
  }
  std::error_code error;
  std::filesystem::rename(unfinished_.toStdString(), file_.toStdString(), error);
  if (error) return end(refused(QString::fromStdString(error.message())));
  end({SaveStatus::Saved, {}, {}, {}});
}

void FfmpegWriter::end(const SaveResult& result) {
  if (ended_) return;
  ended_ = true;
  if (!result) QFile::remove(unfinished_);
  emit ended(result);
}

SaveResult FfmpegWriter::refused(const QString& reason) const {
  return notSaved(
      {ErrorKind::Usage,
       file_.toStdString(),
       "",
       {GLISSADE_TEXT("ffmpeg could not write the film: %1"), {reason.toStdString()}},
       GLISSADE_TEXT("Check the folder, its free space, and that ffmpeg has the codecs libx264 and libvpx-vp9.")});
}

}  // namespace glissade
