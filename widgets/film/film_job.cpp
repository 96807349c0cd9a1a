#include "widgets/film/film_job.h"

#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glissade {
namespace {

/// Seconds for which the first and the last picture are repeated.
constexpr double kStanding = 0.6;

}  // namespace

void FilmJob::start(FilmSubject subject, const QString& file, Finished finished) {
  cancel();
  auto writer = makeFilmWriter(file);
  if (!writer) return finished(notSaved(writer.error()));
  subject_ = std::move(subject);
  finished_ = std::move(finished);
  file_ = file;
  writer_ = std::move(*writer);
  taken_ = 0;
  pictures_ = 1 + static_cast<int>(std::lround(kFilmRate * (subject_.seconds + 2.0 * kStanding)));
  connect(writer_.get(), &FilmWriter::ended, this, &FilmJob::end);
  connect(writer_.get(), &FilmWriter::ready, this, &FilmJob::takePictures);
  pictureShare_.reset();
  filming_ = camera_;
  work_.beginOther(
      *this, tr("Making the film"), [this] { cancel(); }, WorkController::Loss::Asked);
  takePictures();
}

void FilmJob::cancel() {
  if (!writer_) return;
  end(notSaved({ErrorKind::Interrupted, file_.toStdString(), "", GLISSADE_TEXT("the film was cancelled"),
                GLISSADE_TEXT("Start it again.")}));
}

/// Takes one picture now, and the next ones at later turns of the event loop.
void FilmJob::takePictures() {
  do {
    if (!writer_) return;
    if (writer_->isBusy()) {
      if (!work_.isAtOnce()) return;  // the writer's ready() calls this again
      writer_->wait();
    } else if (taken_ < pictures_) {
      takePicture();
      if (writer_ && taken_ == pictures_) writer_->close();
    } else if (work_.isAtOnce()) {
      writer_->wait();
    } else {
      return;
    }
  } while (work_.isAtOnce());
  if (writer_) QTimer::singleShot(0, writer_.get(), [this] { takePictures(); });
}

void FilmJob::takePicture() {
  const double second = static_cast<double>(taken_) / kFilmRate - kStanding;
  const double share = std::clamp(second / std::max(subject_.seconds, 1.0 / kFilmRate), 0.0, 1.0);
  if (pictureShare_ != share) {
    const CameraController ofTheWindow = std::exchange(camera_, *filming_);
    subject_.show(share);
    picture_ = takenOf_();
    filming_ = std::exchange(camera_, ofTheWindow);  // the motion may have moved a camera that follows the object
    subject_.restore();
    pictureShare_ = share;
  }
  ++taken_;
  work_.showShare(*this, static_cast<double>(taken_) / pictures_);
  writer_->add(picture_);
}

void FilmJob::end(const SaveResult& result) {
  if (!writer_) return;
  // The writer may be calling this function, so it is deleted later.
  writer_->disconnect(this);
  writer_.release()->deleteLater();
  work_.endOther(*this);
  picture_ = {};
  std::exchange(finished_, nullptr)(result);
}

}  // namespace glissade
