#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/window/film_writer.h"
#include "app/window/work_controller.h"

namespace glissade {

/// Pixels of a film.
inline constexpr QSize kFilmPicture(1280, 720);

/// What a film shows.
struct FilmSubject {
  double seconds = 0.0;              ///< at the speed that is chosen for playing
  std::function<void(double)> show;  ///< the scene at a share of the time, in [0, 1]
  std::function<void()> restore;     ///< the scene as it was before
};

/// Films the 3D view, seen as it is seen in the window: a picture at each turn of the event loop, with its share in the
/// status bar, where it is cancelled, too. The window itself is drawn once a second meanwhile: drawing it with every
/// picture would double the time. In scripts all of it is done at once. GUI thread.
class FilmJob final : public QObject {
  Q_OBJECT

 public:
  /// `picture`: of the scene as it is. `scene`: the widget that shows it.
  FilmJob(WorkController& work, std::function<QImage()> picture, QWidget& scene)
      : work_(work), takenOf_(std::move(picture)), scene_(scene) {}

  using Finished = std::function<void(const SaveResult&)>;
  /// A film that is under way is cancelled. Errors: those of makeFilmWriter() and of writing, and Interrupted.
  void start(FilmSubject subject, const QString& file, Finished finished);
  /// The film has no file then.
  void cancel();
  bool isFilming() const { return writer_ != nullptr; }

 private:
  void takePictures();
  void takePicture();
  void showInWindow(bool shown);
  void end(const SaveResult& result);

  WorkController& work_;
  std::function<QImage()> takenOf_;
  QWidget& scene_;
  QImage picture_;                      ///< the one taken last
  std::optional<double> pictureShare_;  ///< what it shows; nothing: none was taken
  QElapsedTimer sinceSeen_;             ///< since the window showed what is filmed
  FilmSubject subject_;
  Finished finished_;
  std::unique_ptr<FilmWriter> writer_;
  QString file_;
  int taken_ = 0;
  int pictures_ = 0;
};

}  // namespace glissade
