#include "widgets/sequence/plan_graph_view.h"

#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QSvgRenderer>
#include <QVBoxLayout>

#include <algorithm>

namespace glissade {
namespace {

constexpr double kMostSide = 12000.0;  ///< pixels

}  // namespace

GraphColours graphColours(const QPalette& palette) {
  GraphColours colours;
  colours.ink = palette.color(QPalette::WindowText).name().toStdString();
  colours.box = palette.color(QPalette::AlternateBase).name().toStdString();
  colours.ground = palette.color(QPalette::Window).name().toStdString();
  return colours;
}

QImage imageOfSvg(const std::string& svg, double scale) {
  QSvgRenderer renderer(QByteArray::fromStdString(svg));
  const QSizeF size = renderer.defaultSize();
  const double fitting = std::min(scale, kMostSide / std::max({1.0, size.width(), size.height()}));
  QImage image((size * fitting).toSize().expandedTo(QSize(1, 1)), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  renderer.render(&painter);
  return image;
}

PlanGraphView::PlanGraphView(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Precedence graph"));
  setObjectName(QStringLiteral("sequence-graph"));
  auto* picture = new QLabel(this);
  picture->setAccessibleName(tr("An arrow leads from a step to each step that has to come after it"));
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(picture);
  scroll->setAccessibleName(windowTitle());
  scroll->setAlignment(Qt::AlignCenter);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll);
  resize(900, 480);
}

void PlanGraphView::setPicture(const std::string& svg) {
  auto* picture = findChild<QLabel*>();
  QImage image = imageOfSvg(svg, devicePixelRatioF());
  image.setDevicePixelRatio(devicePixelRatioF());
  picture->setPixmap(QPixmap::fromImage(image));
  picture->adjustSize();
}

}  // namespace glissade
