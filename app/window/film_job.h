#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/window/film_writer.h"
#include "app/window/work_controller.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {

/// Pixels of a film.
inline constexpr QSize kFilmPicture(1280, 720);

/// What a film shows.
struct FilmSubject {
  double seconds = 0.0;              ///< at the speed that is chosen for playing
  std::function<void(double)> show;  ///< the scene at a share of the time, in [0, 1]; panels stay as they are
  std::function<void()> restore;     ///< the scene as the window has it, after each picture
};

/// Films the 3D view from where the camera was at the beginning: a picture at each turn of the event loop, with its
/// share in the status bar, where it is cancelled, too. A person goes on working meanwhile, at another place of the way
/// and from another eye. What is hidden, cut or selected is so in the film, too. In scripts all of it is done at once.
/// GUI thread.
class FilmJob final : public QObject {
  Q_OBJECT

 public:
  /// `picture`: of the scene as it is. `camera`: that it is seen with.
  FilmJob(WorkController& work, std::function<QImage()> picture, CameraController& camera)
      : work_(work), takenOf_(std::move(picture)), camera_(camera) {}

  using Finished = std::function<void(const SaveResult&)>;
  /// A film that is under way is cancelled. Errors: those of makeFilmWriter() and of writing, and Interrupted.
  void start(FilmSubject subject, const QString& file, Finished finished);
  /// The film has no file then.
  void cancel();
  bool isFilming() const { return writer_ != nullptr; }

 private:
  void takePictures();
  void takePicture();
  void end(const SaveResult& result);

  WorkController& work_;
  std::function<QImage()> takenOf_;
  CameraController& camera_;
  std::optional<CameraController> filming_;  ///< the camera of the film
  QImage picture_;                           ///< the one taken last
  std::optional<double> pictureShare_;       ///< what it shows; nothing: none was taken
  FilmSubject subject_;
  Finished finished_;
  std::unique_ptr<FilmWriter> writer_;
  QString file_;
  int taken_ = 0;
  int pictures_ = 0;
};

}  // namespace glissade
