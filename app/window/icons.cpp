#include "app/window/icons.h"

#include <QFile>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

/// The icons are in a static library, so the linker keeps them only if they are named. The macro stands outside of
/// namespaces.
static void takeIcons() { Q_INIT_RESOURCE(icons); }

namespace glissade {
namespace {

/// The colour of the lines and areas in the files.
constexpr const char* kDrawn = "#000";

/// The drawing of the file in a colour.
QIcon iconOf(QByteArray drawing, const QColor& colour) {
  QSvgRenderer renderer(drawing.replace(kDrawn, colour.name().toLatin1()));
  QIcon icon;
  for (const int size : {16, 24, 32, 48}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace

void applyIcons(const ActionCatalogue& actions, const QColor& colour) {
  takeIcons();
  for (const ActionSpec& spec : actions.specs()) {
    const QString id = QLatin1String(spec.id);
    QFile file(QStringLiteral(":/icons/%1.svg").arg(id));
    if (file.open(QIODevice::ReadOnly)) actions[id]->setIcon(iconOf(file.readAll(), colour));
  }
}

}  // namespace glissade
