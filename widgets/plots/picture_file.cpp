#include "widgets/plots/picture_file.h"

#include <QBuffer>
#include <QFileInfo>

namespace glissade {

SaveResult savePicture(const QImage& picture, const QString& file) {
  const std::string name = file.toStdString();
  QBuffer content;
  content.open(QIODevice::WriteOnly);
  if (!picture.save(&content, QFileInfo(file).suffix().toLatin1().constData())) {
    return notSaved({ErrorKind::Usage, name, "", "the picture cannot be written in this format",
                     "Choose a name that ends in .png or .jpg."});
  }
  return saveFile(name, content.data().toStdString());
}

}  // namespace glissade
