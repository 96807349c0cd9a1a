#pragma once

#include <QObject>
#include <QTextFormat>
#include <QTextObjectInterface>

namespace glissade {

/// An SVG in a text document. It is as wide as the page, and one character of the text.
class PlotObject final : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  static constexpr int kType = QTextFormat::UserObject + 1;   ///< type of the character's format
  static constexpr int kSvg = QTextFormat::UserProperty + 1;  ///< the format's property that holds the SVG

  QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
  void drawObject(QPainter* painter, const QRectF& place, QTextDocument* document, int position,
                  const QTextFormat& format) override;
};

}  // namespace glissade
