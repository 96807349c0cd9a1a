#include "widgets/studies/picture_file.h"

#include <QBuffer>
#include <QFileInfo>

namespace glissade {

SaveResult savePicture(const QImage& picture, const QString& file, const char* format) {
  const std::string name = file.toStdString();
  QBuffer content;
  content.open(QIODevice::WriteOnly);
  const QByteArray ending = QFileInfo(file).suffix().toLatin1();
  if (!picture.save(&content, format != nullptr ? format : ending.constData())) {
    return notSaved({ErrorKind::Usage, name, "", GLISSADE_TEXT("the picture cannot be written in this format"),
                     GLISSADE_TEXT("Choose a name that ends in .png or .jpg.")});
  }
  return saveFile(name, content.data().toStdString());
}

}  // namespace glissade
