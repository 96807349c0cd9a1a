#pragma once

#include <QRectF>
#include <QWidget>

#include "engine/base/file_save.h"
#include "engine/study/plot.h"

class QwtPlot;

namespace glissade {

/// A plot of a study, drawn by Qwt in the colours of the palette: the same scales, ticks and intervals
/// as the report's. The pointer over a point shows what it says; a click picks its cell. A rubber band,
/// the wheel or + and - show a part of it, the arrow keys move that, Esc shows the whole again.
class PlotView final : public QWidget {
  Q_OBJECT

 public:
  explicit PlotView(const Plot& plot, QWidget* parent = nullptr);

  /// The part that is shown; both axes go from 0 to 1, y up. Kept within the plot, and not too small.
  void zoom(const QRectF& part);
  void zoomOut();
  bool isZoomed() const { return part_ != whole(); }
  /// As it is seen, PNG or SVG by the ending of the name. False: it cannot be written.
  SaveResult save(const QString& file) const;
  void copy() const;

 signals:
  void cellPicked(int cell);
  void zoomChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QRectF whole() const;
  bool steer(int key);
  void zoomAbout(double factor, const QPointF& centre);
  QPointF placeAt(const QPointF& pixel) const;
  QImage image() const;
  void draw();
  void showAxes();
  void addAxes();
  void addSeries(const PlotSeries& series, bool inLegend);
  void addBars(const PlotSeries& series, bool inLegend);
  void addPoints(const PlotSeries& series, bool inLegend);
  void addIntervals(const PlotSeries& series);
  QColor colourOf(const PlotSeries& series) const;
  /// Where a point is: both axes go from 0 to 1.
  QPointF placeOf(const PlotSeries& series, const PlotPoint& point) const;
  /// The nearest point within reach of the pointer; null: none.
  const PlotPoint* pointAt(const QPoint& pixel) const;

  Plot plot_;
  QwtPlot* view_;
  QRectF part_;
};

}  // namespace glissade
