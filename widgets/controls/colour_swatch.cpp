#include "widgets/controls/colour_swatch.h"

#include <QIconEngine>
#include <QPainter>
#include <QPixmap>

namespace glissade {
namespace {

class SwatchEngine : public QIconEngine {
 public:
  explicit SwatchEngine(const QColor& colour) : colour_(colour) {}

  void paint(QPainter* painter, const QRect& square, QIcon::Mode /*mode*/, QIcon::State /*state*/) override {
    painter->fillRect(square.adjusted(1, 1, -1, -1), colour_);
    painter->setPen(Qt::gray);  // the frame of a swatch that has the colour of the ground
    painter->drawRect(square.adjusted(1, 1, -2, -2));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new SwatchEngine(colour_); }

 private:
  QColor colour_;
};

}  // namespace

QIcon colourSwatch(const QColor& colour) { return QIcon(new SwatchEngine(colour)); }

}  // namespace glissade
