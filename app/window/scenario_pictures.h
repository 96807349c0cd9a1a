#pragma once

#include <QImage>
#include <QString>

#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Pixels of the small pictures of scenarios: samples and recent files.
constexpr QSize kScenarioPictureSize(264, 176);

/// The middle of the scene as it is seen, cut and scaled to the size.
QImage smallScenePicture(SceneWidget& scene, const QSize& size = kScenarioPictureSize);

/// Small pictures of scenario files, kept in a folder of the user's cache under a hash of each file's path. The oldest
/// are removed where there are many.
class ScenarioPictures {
 public:
  explicit ScenarioPictures(const QString& folder) : folder_(folder) {}

  /// Nothing happens where the folder cannot be written: a picture can be made again.
  void keep(const QString& scenarioFile, const QImage& picture) const;
  /// Null where none is kept.
  QImage find(const QString& scenarioFile) const;
  void removeAll() const;

 private:
  QString pathOf(const QString& scenarioFile) const;
  void removeOldest() const;

  QString folder_;
};

}  // namespace glissade
