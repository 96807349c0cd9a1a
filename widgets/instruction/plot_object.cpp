#include "widgets/instruction/plot_object.h"

#include <QSvgRenderer>
#include <QTextDocument>

namespace glissade {

QSizeF PlotObject::intrinsicSize(QTextDocument* document, int, const QTextFormat& format) {
  const QSizeF size = QSvgRenderer(format.property(kSvg).toByteArray()).defaultSize();
  const double width = document->pageSize().width();
  return {width, width * size.height() / size.width()};
}

void PlotObject::drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int, const QTextFormat& format) {
  QSvgRenderer(format.property(kSvg).toByteArray()).render(painter, place);
}

}  // namespace glissade
