#include "widgets/workbench/scenario_pictures.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

#include "widgets/controls/picture_file.h"

namespace glissade {
namespace {

/// A picture takes about 30 kB.
constexpr int kMostPictures = 40;

QFileInfoList picturesIn(const QString& folder) {
  return QDir(folder).entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
}

}  // namespace

QImage smallScenePicture(SceneWidget& scene, const QSize& size) {
  // Takes the picture from the widget, without its overlays: a new picture of a large product in full detail takes
  // seconds.
  QImage whole(scene.widget()->size().expandedTo(QSize(1, 1)), QImage::Format_RGB32);
  scene.widget()->render(&whole, QPoint(), QRegion(), QWidget::RenderFlags());
  const QSize part = size.scaled(whole.size(), Qt::KeepAspectRatio);
  const QPoint corner((whole.width() - part.width()) / 2, (whole.height() - part.height()) / 2);
  return whole.copy(QRect(corner, part)).scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

QString ScenarioPictures::pathOf(const QString& scenarioFile) const {
  const QByteArray path = QFileInfo(scenarioFile).absoluteFilePath().toUtf8();
  const QByteArray hash = QCryptographicHash::hash(path, QCryptographicHash::Sha256).toHex();
  return QStringLiteral("%1/%2.png").arg(folder_, QString::fromLatin1(hash));
}

void ScenarioPictures::keep(const QString& scenarioFile, const QImage& picture) const {
  if (picture.isNull() || !QDir().mkpath(folder_)) return;
  (void)savePicture(picture.convertToFormat(QImage::Format_RGB32), pathOf(scenarioFile));
  removeOldest();
}

QImage ScenarioPictures::find(const QString& scenarioFile) const { return QImage(pathOf(scenarioFile)); }

void ScenarioPictures::removeAll() const {
  for (const QFileInfo& picture : picturesIn(folder_)) QFile::remove(picture.filePath());
}

void ScenarioPictures::removeOldest() const {
  const QFileInfoList pictures = picturesIn(folder_);
  for (int i = kMostPictures; i < pictures.size(); ++i) QFile::remove(pictures[i].filePath());
}

}  // namespace glissade
