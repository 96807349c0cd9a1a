#include "app/window/icons.h"

#include <QIcon>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace glissade {
namespace {

/// Draws an icon on a 16 x 16 grid.
using Drawing = std::function<void(QPainter&)>;

QIcon draw(const Drawing& drawing, const QColor& colour) {
  QIcon icon;
  for (const int size : {16, 24, 32, 48}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(size / 16.0, size / 16.0);
    painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    drawing(painter);
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

void fill(QPainter& painter, const QPolygonF& shape) {
  QPainterPath path;
  path.addPolygon(shape);
  painter.fillPath(path, painter.pen().color());
}

void paintStep(QPainter& painter) {
  fill(painter, QPolygonF({{3, 2}, {11, 8}, {3, 14}}));
  painter.fillRect(QRectF(11, 2.5, 2.5, 11), painter.pen().color());
}

void paintStepBack(QPainter& painter) {
  fill(painter, QPolygonF({{13, 2}, {5, 8}, {13, 14}}));
  painter.fillRect(QRectF(2.5, 2.5, 2.5, 11), painter.pen().color());
}

void arrow(QPainter& painter, QPointF from, QPointF to) {
  painter.drawLine(from, to);
  const QPointF along = (to - from) / 3.0;
  const QPointF across(-along.y(), along.x());
  painter.drawLine(to, to - along + across);
  painter.drawLine(to, to - along - across);
}

/// Draws a cube seen from a corner, with one face filled.
void cube(QPainter& painter, const QPolygonF& face) {
  fill(painter, face);
  painter.drawPolygon(QPolygonF({{8, 1.5}, {14, 4.5}, {14, 11.5}, {8, 14.5}, {2, 11.5}, {2, 4.5}}));
  painter.drawPolyline(QPolygonF({{2, 4.5}, {8, 7.5}, {14, 4.5}}));
  painter.drawLine(QPointF(8, 7.5), QPointF(8, 14.5));
}

/// Draws a cube seen from inside, with one of its far faces filled.
void openCube(QPainter& painter, const QPolygonF& face) {
  fill(painter, face);
  painter.drawPolygon(QPolygonF({{8, 1.5}, {14, 4.5}, {14, 11.5}, {8, 14.5}, {2, 11.5}, {2, 4.5}}));
  painter.drawPolyline(QPolygonF({{2, 11.5}, {8, 8.5}, {14, 11.5}}));
  painter.drawLine(QPointF(8, 1.5), QPointF(8, 8.5));
}

/// Draws a disc in the colour of the pen.
void ball(QPainter& painter, double opacity) {
  QPainterPath disc;
  disc.addEllipse(QRectF(2, 2, 12, 12));
  QColor colour = painter.pen().color();
  colour.setAlphaF(opacity);
  painter.fillPath(disc, colour);
}

std::vector<std::pair<const char*, Drawing>> drawings() {
  return {
      {"file.new",
       [](QPainter& p) {
         cube(p, {});
         p.setCompositionMode(QPainter::CompositionMode_Source);
         p.fillRect(QRectF(8.5, 8.5, 7.5, 7.5), Qt::transparent);
         p.setCompositionMode(QPainter::CompositionMode_SourceOver);
         p.drawLine(QPointF(12.5, 9.5), QPointF(12.5, 15.5));
         p.drawLine(QPointF(9.5, 12.5), QPointF(15.5, 12.5));
       }},
      {"file.open",
       [](QPainter& p) {
         p.drawPolygon(QPolygonF({{1.5, 13}, {1.5, 3}, {6, 3}, {7.5, 5}, {14.5, 5}, {14.5, 13}}));
       }},
      {"file.export",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{2, 9}, {2, 14}, {14, 14}, {14, 9}}));
         arrow(p, {8, 10}, {8, 2});
       }},
      {"file.save",
       [](QPainter& p) {
         p.drawPolygon(QPolygonF({{2, 2}, {11.5, 2}, {14, 4.5}, {14, 14}, {2, 14}}));
         p.drawRect(QRectF(5, 2, 5, 3.5));
         p.fillRect(QRectF(4.5, 8.5, 7, 5.5), p.pen().color());
       }},
      {"edit.undo",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{6, 2.5}, {2.5, 6}, {6, 9.5}}));
         p.drawLine(QPointF(2.5, 6), QPointF(10, 6));
         p.drawArc(QRectF(6, 6, 7.5, 7.5), -90 * 16, 180 * 16);
       }},
      {"edit.redo",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{10, 2.5}, {13.5, 6}, {10, 9.5}}));
         p.drawLine(QPointF(13.5, 6), QPointF(6, 6));
         p.drawArc(QRectF(2.5, 6, 7.5, 7.5), 90 * 16, 180 * 16);
       }},
      {"environment.build",
       [](QPainter& p) {
         p.drawRect(QRectF(2, 2, 12, 12));
         p.drawLine(QPointF(8, 2), QPointF(8, 14));
         p.drawLine(QPointF(2, 8), QPointF(14, 8));
         p.fillRect(QRectF(8, 2, 6, 6), p.pen().color());
       }},
      {"help.tour",
       [](QPainter& p) {
         p.drawLine(QPointF(4, 2), QPointF(4, 14.5));
         fill(p, QPolygonF({{4, 2.5}, {13.5, 5.5}, {4, 8.5}}));
       }},
      {"run.start",
       [](QPainter& p) {
         fill(p, QPolygonF({{4, 2}, {14, 8}, {4, 14}}));
       }},
      {"run.pause",
       [](QPainter& p) {
         p.fillRect(QRectF(3.5, 2.5, 3, 11), p.pen().color());
         p.fillRect(QRectF(9.5, 2.5, 3, 11), p.pen().color());
       }},
      {"run.stop", [](QPainter& p) { p.fillRect(QRectF(3, 3, 10, 10), p.pen().color()); }},
      {"run.restart-new-seed",
       [](QPainter& p) {
         p.drawArc(QRectF(2.5, 2.5, 11, 11), 60 * 16, 290 * 16);
         fill(p, QPolygonF({{9.5, 0.5}, {14, 3}, {9.5, 6}}));
       }},
      {"path.play",
       [](QPainter& p) {
         fill(p, QPolygonF({{4, 2}, {14, 8}, {4, 14}}));
       }},
      {"path.first-blocked",
       [](QPainter& p) {
         p.drawLine(QPointF(1, 8), QPointF(6, 8));
         p.fillRect(QRectF(7, 1.5, 2, 13), p.pen().color());
         p.drawLine(QPointF(11, 5.5), QPointF(15, 10.5));
         p.drawLine(QPointF(15, 5.5), QPointF(11, 10.5));
       }},
      {"path.tightest",
       [](QPainter& p) {
         p.drawArc(QRectF(-2, -7.5, 20, 14), 200 * 16, 140 * 16);
         p.drawArc(QRectF(-2, 9.5, 20, 14), 20 * 16, 140 * 16);
         p.drawLine(QPointF(1, 8), QPointF(15, 8));
       }},
      {"path.loop",
       [](QPainter& p) {
         p.drawArc(QRectF(2.5, 2.5, 11, 11), 60 * 16, 290 * 16);
         fill(p, QPolygonF({{9.5, 0.5}, {14, 3}, {9.5, 6}}));
       }},
      {"path.backwards",
       [](QPainter& p) {
         fill(p, QPolygonF({{12, 2}, {2, 8}, {12, 14}}));
       }},
      {"path.smooth",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{2, 13}, {5, 4}, {9, 10}, {14, 3}}));
         p.drawArc(QRectF(2, 3, 24, 20), 90 * 16, 90 * 16);
       }},
      {"replay.play",
       [](QPainter& p) {
         fill(p, QPolygonF({{4, 2}, {14, 8}, {4, 14}}));
       }},
      {"replay.step", paintStep},
      {"replay.step-back", paintStepBack},
      {"replay.to-start",
       [](QPainter& p) {
         fill(p, QPolygonF({{14, 2}, {8.5, 8}, {14, 14}}));
         fill(p, QPolygonF({{9, 2}, {3.5, 8}, {9, 14}}));
         p.fillRect(QRectF(1.5, 2.5, 2, 11), p.pen().color());
       }},
      {"replay.close",
       [](QPainter& p) {
         p.drawLine(QPointF(3.5, 3.5), QPointF(12.5, 12.5));
         p.drawLine(QPointF(12.5, 3.5), QPointF(3.5, 12.5));
       }},
      {"sequence.play",
       [](QPainter& p) {
         fill(p, QPolygonF({{4, 2}, {14, 8}, {4, 14}}));
       }},
      {"sequence.previous-step", paintStepBack},
      {"sequence.next-step", paintStep},
      {"sequence.resume",
       [](QPainter& p) {
         p.fillRect(QRectF(2.5, 2.5, 2.5, 11), p.pen().color());
         fill(p, QPolygonF({{6.5, 2}, {14, 8}, {6.5, 14}}));
       }},
      {"sequence.graph",
       [](QPainter& p) {
         p.drawRect(QRectF(1.5, 2, 4.5, 4));
         p.drawRect(QRectF(1.5, 10, 4.5, 4));
         p.drawRect(QRectF(10.5, 6, 4, 4));
         p.drawLine(QPointF(6, 4), QPointF(10.5, 7));
         p.drawLine(QPointF(6, 12), QPointF(10.5, 9));
       }},
      {"sequence.open",
       [](QPainter& p) {
         p.drawPolygon(QPolygonF({{1.5, 13}, {1.5, 3}, {6, 3}, {7.5, 5}, {14.5, 5}, {14.5, 13}}));
       }},
      {"sequence.export",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{2, 9}, {2, 14}, {14, 14}, {14, 9}}));
         arrow(p, {8, 10}, {8, 2});
       }},
      {"sequence.assembly-order",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{2, 8}, {2, 14}, {14, 14}, {14, 8}}));
         p.drawRect(QRectF(5.5, 9, 5, 5));
         arrow(p, {8, 1}, {8, 7});
       }},
      {"sequence.aside",
       [](QPainter& p) {
         p.drawRect(QRectF(1.5, 7, 6, 7));
         fill(p, QPolygonF({{10, 9}, {14.5, 9}, {14.5, 14}, {10, 14}}));
         p.drawPolyline(QPolygonF({{4.5, 5}, {4.5, 2}, {12, 2}, {12, 6}}));
       }},
      {"view.fit",
       [](QPainter& p) {
         for (const auto& [x, y, dx, dy] : {std::tuple{2, 2, 1, 1}, {14, 2, -1, 1}, {14, 14, -1, -1}, {2, 14, 1, -1}}) {
           p.drawPolyline(QPolygonF({QPointF(x, y + 4 * dy), QPointF(x, y), QPointF(x + 4 * dx, y)}));
         }
         p.fillRect(QRectF(6, 6, 4, 4), p.pen().color());
       }},
      {"view.isometric", [](QPainter& p) { cube(p, {}); }},
      {"paths.keep",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{4, 14}, {4, 2}, {12, 2}, {12, 14}, {8, 10.5}, {4, 14}}));
       }},
      {"paths.open",
       [](QPainter& p) {
         p.drawPolyline(QPolygonF({{2, 13}, {5, 5}, {10, 11}}));
         arrow(p, {10, 11}, {14, 3});
       }},
      {"paths.compare",
       [](QPainter& p) {
         p.drawRect(QRectF(2, 3, 5, 10));
         p.drawRect(QRectF(9, 3, 5, 10));
         p.drawLine(QPointF(3.5, 6), QPointF(5.5, 6));
         p.drawLine(QPointF(10.5, 9), QPointF(12.5, 9));
       }},
      {"paths.rename",
       [](QPainter& p) {
         p.drawPolygon(QPolygonF({{2, 14}, {3, 10.5}, {11, 2.5}, {13.5, 5}, {5.5, 13}}));
         p.drawLine(QPointF(9, 4.5), QPointF(11.5, 7));
       }},
      {"paths.pin",
       [](QPainter& p) {
         p.drawPolygon(QPolygonF({{8, 1.5},
                                  {9.9, 5.9},
                                  {14.5, 6.3},
                                  {11, 9.4},
                                  {12, 14},
                                  {8, 11.6},
                                  {4, 14},
                                  {5, 9.4},
                                  {1.5, 6.3},
                                  {6.1, 5.9}}));
       }},
      {"paths.remove",
       [](QPainter& p) {
         p.drawLine(QPointF(2.5, 4), QPointF(13.5, 4));
         p.drawLine(QPointF(6, 2), QPointF(10, 2));
         p.drawPolyline(QPolygonF({{4, 4}, {4.8, 14}, {11.2, 14}, {12, 4}}));
       }},
      {"log.copy",
       [](QPainter& p) {
         p.drawRect(QRectF(2, 5, 8, 9));
         p.drawPolyline(QPolygonF({{6, 5}, {6, 2}, {14, 2}, {14, 11}, {10, 11}}));
       }},
      {"view.front",
       [](QPainter& p) {
         cube(p, QPolygonF({{14, 4.5}, {8, 7.5}, {8, 14.5}, {14, 11.5}}));
       }},
      {"view.left",
       [](QPainter& p) {
         cube(p, QPolygonF({{2, 4.5}, {8, 7.5}, {8, 14.5}, {2, 11.5}}));
       }},
      {"view.top",
       [](QPainter& p) {
         cube(p, QPolygonF({{8, 1.5}, {14, 4.5}, {8, 7.5}, {2, 4.5}}));
       }},
      {"view.back",
       [](QPainter& p) {
         openCube(p, QPolygonF({{8, 1.5}, {2, 4.5}, {2, 11.5}, {8, 8.5}}));
       }},
      {"view.right",
       [](QPainter& p) {
         openCube(p, QPolygonF({{8, 1.5}, {14, 4.5}, {14, 11.5}, {8, 8.5}}));
       }},
      {"view.bottom",
       [](QPainter& p) {
         openCube(p, QPolygonF({{2, 11.5}, {8, 8.5}, {14, 11.5}, {8, 14.5}}));
       }},
      {"display.shaded-edges",
       [](QPainter& p) {
         ball(p, 0.35);
         p.drawEllipse(QRectF(2, 2, 12, 12));
       }},
      {"display.shaded", [](QPainter& p) { ball(p, 0.8); }},
      {"display.see-through",
       [](QPainter& p) {
         ball(p, 0.12);
         p.drawEllipse(QRectF(2, 2, 12, 12));
         p.drawEllipse(QRectF(5.5, 2, 5, 12));
       }},
      {"display.wireframe",
       [](QPainter& p) {
         p.drawEllipse(QRectF(2, 2, 12, 12));
         p.drawEllipse(QRectF(5.5, 2, 5, 12));
         p.drawEllipse(QRectF(2, 5.5, 12, 5));
       }},
  };
}

}  // namespace

void applyIcons(const ActionCatalogue& actions, const QColor& colour) {
  for (const auto& [id, drawing] : drawings()) actions[QLatin1String(id)]->setIcon(draw(drawing, colour));
}

}  // namespace glissade
