#include "widgets/plots/plot_view.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtMath>

#include <qwt_interval_symbol.h>
#include <qwt_legend.h>
#include <qwt_picker_machine.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_histogram.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_picker.h>
#include <qwt_plot_renderer.h>
#include <qwt_scale_draw.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/file.h"
#include "engine/study/study_words.h"
#include "widgets/controls/picture_file.h"
#include "widgets/controls/window_language.h"

namespace glissade {
namespace {

constexpr double kReach = 14.0;     ///< pixels within which the pointer finds a point
constexpr double kMargin = 0.025;   ///< share of an axis that keeps points at its ends whole
constexpr int kLeastBand = 6;       ///< pixels
constexpr double kSmallest = 0.01;  ///< least part of an axis
constexpr double kZoomStep = 1.25;
constexpr double kPanStep = 0.1;  ///< share of the part that is shown
constexpr int kSavedScale = 2;    ///< pixels of a saved picture for each pixel on screen

/// A scale with labels at the plot's ticks.
class TickLabels final : public QwtScaleDraw {
 public:
  explicit TickLabels(const std::vector<PlotTick>& ticks) : ticks_(ticks) {}

  QwtText label(double value) const override {
    for (const PlotTick& tick : ticks_) {
      if (qAbs(tick.position - value) < 1e-9) return QString::fromStdString(tick.label);
    }
    return {};
  }

 private:
  std::vector<PlotTick> ticks_;
};

QwtScaleDiv divisionOf(const std::vector<PlotTick>& ticks, double from, double to) {
  QList<double> minor;
  QList<double> major;
  for (const PlotTick& tick : ticks) (tick.label.empty() ? minor : major).append(tick.position);
  return QwtScaleDiv(from, to, minor, {}, major);
}

/// Draws the rectangle that will be shown; a click draws none.
class ZoomBand final : public QwtPlotPicker {
 public:
  explicit ZoomBand(QWidget* canvas)
      : QwtPlotPicker(QwtPlot::xBottom, QwtPlot::yLeft, QwtPicker::RectRubberBand, QwtPicker::AlwaysOff, canvas) {
    setStateMachine(new QwtPickerDragRectMachine);
    for (const KeyPatternCode key : {KeyLeft, KeyRight, KeyUp, KeyDown}) setKeyPattern(key, 0);  // see steer()
  }

 protected:
  bool accept(QPolygon& corners) const override {
    const QRect box = corners.boundingRect();
    return box.width() > kLeastBand && box.height() > kLeastBand;
  }
};

/// The engine's text in the user's language; names of strategies and titles of a study's columns stay as they are.
QString translated(const std::string& words) { return QString::fromStdString(StudyWords(windowLanguage())(words)); }

QwtSymbol::Style symbolOf(const PlotSeries& series) {
  if (series.ofPaper) return QwtSymbol::Diamond;
  constexpr QwtSymbol::Style kStyles[] = {QwtSymbol::Ellipse, QwtSymbol::Rect, QwtSymbol::UTriangle};
  return kStyles[series.style % 3];
}

}  // namespace

PlotView::PlotView(const Plot& plot, QWidget* parent)
    : QWidget(parent), plot_(plot), view_(new QwtPlot(this)), part_(whole()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  auto* canvas = new QwtPlotCanvas(view_);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setObjectName(QStringLiteral("canvas"));
  canvas->setMouseTracking(true);
  canvas->installEventFilter(this);
  view_->setCanvas(canvas);
  view_->plotLayout()->setAlignCanvasToScales(true);
  canvas->setFocusPolicy(Qt::StrongFocus);
  auto* band = new ZoomBand(canvas);
  band->setRubberBandPen(palette().color(QPalette::Highlight));
  connect(band, QOverload<const QRectF&>::of(&QwtPlotPicker::selected), this, &PlotView::zoom);
  view_->insertLegend(new QwtLegend, QwtPlot::BottomLegend);
  setAccessibleName(QString::fromStdString(plot.title));
  draw();
}

QColor PlotView::colourOf(const PlotSeries& series) const {
  if (series.ofPaper) return palette().color(QPalette::Text);
  return QColor(QLatin1String(kPlotColours[series.style % kPlotStyleCount]));
}

QPointF PlotView::placeOf(const PlotSeries& series, const PlotPoint& point) const {
  return {plot_.x.position(point.x) + series.offset, std::clamp(plot_.y.position(point.y), 0.0, 1.0)};
}

void PlotView::draw() {
  view_->detachItems();
  view_->setCanvasBackground(palette().color(QPalette::Base));
  addAxes();
  showAxes();
  std::set<std::string> named;
  for (const PlotSeries& series : plot_.series) addSeries(series, named.insert(series.name).second);
  view_->replot();
}

void PlotView::addAxes() {
  const auto axis = [this](int id, const PlotScale& scale) {
    QwtText title(translated(scale.title()));
    title.setFont(font());
    view_->setAxisTitle(id, title);
    view_->setAxisFont(id, font());
  };
  axis(QwtPlot::xBottom, plot_.x);
  axis(QwtPlot::yLeft, plot_.y);
  auto* grid = new QwtPlotGrid;
  grid->enableX(false);
  grid->setMajorPen(palette().color(QPalette::Button), 1.0);
  grid->attach(view_);
}

void PlotView::showAxes() {
  const auto show = [this](int id, const PlotScale& scale, double from, double to) {
    const std::vector<PlotTick> ticks = scale.ticksWithin(from, to);
    view_->setAxisScaleDraw(id, new TickLabels(ticks));
    view_->setAxisScaleDiv(id, divisionOf(ticks, from, to));
  };
  show(QwtPlot::xBottom, plot_.x, part_.left(), part_.right());
  show(QwtPlot::yLeft, plot_.y, part_.top(), part_.bottom());
}

QRectF PlotView::whole() const {
  const double margin = plot_.kind == PlotKind::Lines ? kMargin : 0.0;
  return {-margin, -margin, 1.0 + 2.0 * margin, 1.0 + 2.0 * margin};
}

void PlotView::zoom(const QRectF& part) {
  const QRectF all = whole();
  QRectF requested = part.normalized();
  requested.setSize(
      {std::clamp(requested.width(), kSmallest, all.width()), std::clamp(requested.height(), kSmallest, all.height())});
  requested.moveLeft(std::max(all.left(), std::min(requested.left(), all.right() - requested.width())));
  requested.moveTop(std::max(all.top(), std::min(requested.top(), all.bottom() - requested.height())));
  if (requested == part_) return;
  part_ = requested;
  showAxes();
  view_->replot();
  emit zoomChanged();
}

void PlotView::zoomOut() { zoom(whole()); }

void PlotView::zoomAbout(double factor, const QPointF& centre) {
  const QPointF from = centre + (part_.topLeft() - centre) / factor;
  zoom({from, part_.size() / factor});
}

/// Zooms or moves the part that is shown; false if the key has no effect.
bool PlotView::steer(int key) {
  const QPointF step(kPanStep * part_.width(), kPanStep * part_.height());
  switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomAbout(kZoomStep, part_.center()); return true;
    case Qt::Key_Minus: zoomAbout(1.0 / kZoomStep, part_.center()); return true;
    case Qt::Key_Left: zoom(part_.translated(-step.x(), 0.0)); return true;
    case Qt::Key_Right: zoom(part_.translated(step.x(), 0.0)); return true;
    case Qt::Key_Up: zoom(part_.translated(0.0, step.y())); return true;
    case Qt::Key_Down: zoom(part_.translated(0.0, -step.y())); return true;
    case Qt::Key_Escape:
    case Qt::Key_Home: zoomOut(); return true;
    default: return false;
  }
}

QPointF PlotView::placeAt(const QPointF& pixel) const {
  return {view_->invTransform(QwtPlot::xBottom, pixel.x()), view_->invTransform(QwtPlot::yLeft, pixel.y())};
}

QImage PlotView::image() const {
  QImage picture(view_->size() * kSavedScale, QImage::Format_RGB32);
  picture.setDevicePixelRatio(kSavedScale);
  picture.fill(palette().color(QPalette::Window));
  view_->render(&picture);
  return picture;
}

SaveResult PlotView::save(const QString& file) const {
  if (!file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) return savePicture(image(), file);
  constexpr double kMillimetresAPixel = 25.4 / 96.0;
  constexpr std::size_t kMostBytes = 256U << 20;
  const QTemporaryDir folder;  // Qwt writes SVG only into files
  const QString drawn = folder.filePath(QStringLiteral("plot.svg"));
  QwtPlotRenderer().renderDocument(view_, drawn, QStringLiteral("svg"), QSizeF(view_->size()) * kMillimetresAPixel, 96);
  const auto content = readFile(drawn.toStdString(), kMostBytes);
  if (!content) return notSaved(content.error());
  return saveFile(file.toStdString(), *content);
}

void PlotView::copy() const { QGuiApplication::clipboard()->setImage(image()); }

void PlotView::addSeries(const PlotSeries& series, bool inLegend) {
  if (plot_.kind == PlotKind::Bars && !series.ofPaper) {
    addBars(series, inLegend);
    addIntervals(series);
  } else {
    addIntervals(series);
    addPoints(series, inLegend);
  }
}

void PlotView::addBars(const PlotSeries& series, bool inLegend) {
  QVector<QwtIntervalSample> bars;
  for (const PlotPoint& point : series.points) {
    const QPointF place = placeOf(series, point);
    const double half = 0.45 * plot_.barWidth;
    bars.append({place.y(), place.x() - half, place.x() + half});
    if (point.mark.empty()) continue;
    auto* mark = new QwtPlotMarker;
    QwtText text(QString::fromStdString(point.mark));
    QFont small = font();
    small.setPointSizeF(0.75 * small.pointSizeF());
    text.setFont(small);
    text.setColor(palette().color(QPalette::Text));
    mark->setLabel(text);
    mark->setLabelAlignment(Qt::AlignTop);
    mark->setValue(place.x(), std::clamp(plot_.y.position(std::max(point.high, point.y)), 0.0, 1.0));
    mark->attach(view_);
  }
  auto* histogram = new QwtPlotHistogram(translated(series.name));
  histogram->setBrush(colourOf(series));
  histogram->setPen(QPen(Qt::NoPen));
  histogram->setSamples(bars);
  histogram->setItemAttribute(QwtPlotItem::Legend, inLegend);
  histogram->attach(view_);
}

void PlotView::addPoints(const PlotSeries& series, bool inLegend) {
  QPolygonF points;
  for (const PlotPoint& point : series.points) points << placeOf(series, point);
  const QColor colour = colourOf(series);
  auto* curve = new QwtPlotCurve(translated(series.name));
  curve->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve->setPen(colour, series.ofPaper ? 1.4 : 1.8, series.ofPaper ? Qt::DashLine : Qt::SolidLine);
  if (plot_.kind == PlotKind::Bars) curve->setStyle(QwtPlotCurve::NoCurve);
  const QPen rim(palette().color(QPalette::Base), 1.0);
  curve->setSymbol(new QwtSymbol(symbolOf(series), colour, rim, series.ofPaper ? QSize(11, 11) : QSize(9, 9)));
  curve->setLegendAttribute(QwtPlotCurve::LegendShowLine, plot_.kind == PlotKind::Lines);
  curve->setLegendAttribute(QwtPlotCurve::LegendShowSymbol, true);
  curve->setLegendIconSize({26, 12});
  curve->setSamples(points);
  curve->setItemAttribute(QwtPlotItem::Legend, inLegend);
  curve->attach(view_);
}

void PlotView::addIntervals(const PlotSeries& series) {
  QVector<QwtIntervalSample> samples;
  for (const PlotPoint& point : series.points) {
    if (point.low == point.high) continue;
    const auto at = [&](double value) { return std::clamp(plot_.y.position(value), 0.0, 1.0); };
    samples.append({placeOf(series, point).x(), at(point.low), at(point.high)});
  }
  if (samples.isEmpty()) return;
  auto* bars = new QwtIntervalSymbol(QwtIntervalSymbol::Bar);
  bars->setWidth(7);
  bars->setPen(plot_.kind == PlotKind::Bars ? palette().color(QPalette::Text) : colourOf(series), 1.3);
  auto* intervals = new QwtPlotIntervalCurve;
  intervals->setStyle(QwtPlotIntervalCurve::NoCurve);
  intervals->setSymbol(bars);
  intervals->setSamples(samples);
  intervals->setItemAttribute(QwtPlotItem::Legend, false);
  intervals->attach(view_);
}

const PlotPoint* PlotView::pointAt(const QPoint& pixel) const {
  const PlotPoint* nearest = nullptr;
  double least = kReach;
  for (const PlotSeries& series : plot_.series) {
    for (const PlotPoint& point : series.points) {
      const QPointF place = placeOf(series, point);
      const double dx = view_->transform(QwtPlot::xBottom, place.x()) - pixel.x();
      const double dy = view_->transform(QwtPlot::yLeft, place.y()) - pixel.y();
      const double distance = std::hypot(dx, dy);
      if (distance >= least) continue;
      least = distance;
      nearest = &point;
    }
  }
  return nearest;
}

bool PlotView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && steer(static_cast<QKeyEvent*>(event)->key())) return true;
  if (event->type() == QEvent::Wheel) {
    const auto* wheel = static_cast<QWheelEvent*>(event);
    constexpr double kNotch = 120.0;
    zoomAbout(std::pow(kZoomStep, wheel->angleDelta().y() / kNotch), placeAt(wheel->position()));
    return true;
  }
  if (event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonPress) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const PlotPoint* point = pointAt(mouse->pos());
    if (event->type() == QEvent::MouseButtonPress) {
      if (point != nullptr && point->cell) emit cellPicked(static_cast<int>(*point->cell));
    } else if (point != nullptr) {
      QToolTip::showText(mouse->globalPos(), QString::fromStdString(point->says), this);
    } else {
      QToolTip::hideText();
    }
  }
  return QWidget::eventFilter(watched, event);
}

void PlotView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw();
  QWidget::changeEvent(event);
}

}  // namespace glissade
