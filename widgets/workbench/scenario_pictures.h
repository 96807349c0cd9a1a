#pragma once

#include <QImage>
#include <QString>

#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Size of the small pictures of scenarios (samples and recent files), pixels.
constexpr QSize kScenarioPictureSize(264, 176);

/// The middle of the scene as the window shows it, cut and scaled to the size.
QImage smallScenePicture(SceneWidget& scene, const QSize& size = kScenarioPictureSize);

/// Small pictures of scenario files. They are kept in a folder of the user's cache under a hash of the file's path. If
/// there are many, the oldest are removed.
class ScenarioPictures {
 public:
  explicit ScenarioPictures(const QString& folder) : folder_(folder) {}

  /// Keeps a picture. If the folder cannot be written, nothing happens, because a picture can be made again.
  void keep(const QString& scenarioFile, const QImage& picture) const;
  /// The kept picture; null if there is none.
  QImage find(const QString& scenarioFile) const;
  void removeAll() const;

 private:
  QString pathOf(const QString& scenarioFile) const;
  void removeOldest() const;

  QString folder_;
};

}  // namespace glissade
