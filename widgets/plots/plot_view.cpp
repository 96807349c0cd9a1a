#include "widgets/plots/plot_view.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>
#include <QtMath>

#include <qwt_interval_symbol.h>
#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_histogram.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include <algorithm>
#include <set>

namespace glissade {
namespace {

constexpr double kReach = 14.0;    ///< pixels within which the pointer finds a point
constexpr double kMargin = 0.025;  ///< of an axis

/// Labels where the plot's scale has them.
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

/// `margin` keeps points at the ends of an axis whole.
QwtScaleDiv divisionOf(const PlotScale& scale, double margin) {
  QList<double> minor;
  QList<double> major;
  for (const PlotTick& tick : scale.ticks()) (tick.label.empty() ? minor : major).append(tick.position);
  return QwtScaleDiv(-margin, 1.0 + margin, minor, {}, major);
}

/// The engine's words; names of strategies and titles of a study's columns stay as they are.
QString translated(const std::string& words) { return QCoreApplication::translate("Plots", words.c_str()); }

QwtSymbol::Style symbolOf(const PlotSeries& series) {
  if (series.ofPaper) return QwtSymbol::Diamond;
  constexpr QwtSymbol::Style kStyles[] = {QwtSymbol::Ellipse, QwtSymbol::Rect, QwtSymbol::UTriangle};
  return kStyles[series.style % 3];
}

}  // namespace

PlotView::PlotView(const Plot& plot, QWidget* parent) : QWidget(parent), plot_(plot), view_(new QwtPlot(this)) {
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
  std::set<std::string> named;
  for (const PlotSeries& series : plot_.series) addSeries(series, named.insert(series.name).second);
  view_->replot();
}

void PlotView::addAxes() {
  const double margin = plot_.kind == PlotKind::Lines ? kMargin : 0.0;
  const auto axis = [this, margin](int id, const PlotScale& scale) {
    view_->setAxisScaleDraw(id, new TickLabels(scale.ticks()));
    view_->setAxisScaleDiv(id, divisionOf(scale, margin));
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
