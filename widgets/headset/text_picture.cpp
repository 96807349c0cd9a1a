#include "widgets/headset/text_picture.h"

#include <QFontMetrics>
#include <QGuiApplication>
#include <QPainter>

#include "widgets/headset/headset_page.h"

namespace glissade {

FlatPicturePtr flatPicture(const QImage& image) {
  auto picture = std::make_shared<FlatPicture>();
  picture->width = image.width();
  picture->height = image.height();
  picture->rgba.assign(image.constBits(),
                       image.constBits() + image.sizeInBytes());  // rows of 4-byte pixels have no padding
  return picture;
}

FlatPicturePtr textPicture(const QString& text, const QPalette& palette, bool strong) {
  constexpr QSize kBorder(20, 10);
  constexpr double kRound = 8.0;
  QFont font = QGuiApplication::font();
  font.setPixelSize(HeadsetPage::kTextPixels);
  const QSize size = QFontMetrics(font).size(0, text) + kBorder;
  QImage image(size, QImage::Format_RGBA8888_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette.color(strong ? QPalette::Highlight : QPalette::Base));
  painter.drawRoundedRect(image.rect(), kRound, kRound);
  painter.setPen(palette.color(strong ? QPalette::HighlightedText : QPalette::Text));
  painter.setFont(font);
  painter.drawText(image.rect(), Qt::AlignCenter, text);
  painter.end();
  return flatPicture(image);
}

}  // namespace glissade
