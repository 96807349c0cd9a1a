#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "widgets/film/film_writer.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/workbench/work_controller.h"

namespace glissade {

/// Size of a film's pictures in pixels.
inline constexpr QSize kFilmPicture(1280, 720);

/// The motion that a film shows.
struct FilmSubject {
  double seconds = 0.0;              ///< duration at the chosen playing speed
  std::function<void(double)> show;  ///< shows the scene at a share of the time, in [0, 1]; panels do not change
  std::function<void()> restore;     ///< shows the window's scene again, after each picture
};

/// Films the 3D view from the camera that the window had at the start of the film. It takes one picture at each turn of
/// the event loop, and shows its progress in the status bar, where it can be cancelled. The person can go on working,
/// at another place of the motion and with another camera. Hidden, cut and selected bodies are so in the film too. In
/// scripts the film is made at once. It is used on the GUI thread.
class FilmJob final : public QObject {
  Q_OBJECT

 public:
  /// `picture`: takes a picture of the scene. `camera`: the camera of that picture.
  FilmJob(WorkController& work, std::function<QImage()> picture, CameraController& camera)
      : work_(work), takenOf_(std::move(picture)), camera_(camera) {}

  using Finished = std::function<void(const SaveResult&)>;
  /// Starts a film and cancels a running one. Errors: those of makeFilmWriter() and of writing, and Interrupted.
  void start(FilmSubject subject, const QString& file, Finished finished);
  /// Cancels the film, which leaves no file.
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
  QImage picture_;                           ///< the last picture
  std::optional<double> pictureShare_;       ///< share of the motion in picture_; nothing: no picture was taken
  FilmSubject subject_;
  Finished finished_;
  std::unique_ptr<FilmWriter> writer_;
  QString file_;
  int taken_ = 0;
  int pictures_ = 0;
};

}  // namespace glissade
