#pragma once

#include <QWidget>

#include "engine/study/plot.h"

class QwtPlot;

namespace glissade {

/// A plot of a study, drawn by Qwt in the colours of the palette: the same scales, ticks and intervals
/// as the report's. The pointer over a point shows what it says; a click picks its cell.
class PlotView final : public QWidget {
  Q_OBJECT

 public:
  explicit PlotView(const Plot& plot, QWidget* parent = nullptr);

 signals:
  void cellPicked(int cell);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void draw();
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
};

}  // namespace glissade
