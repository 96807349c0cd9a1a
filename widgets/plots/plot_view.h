#pragma once

#include <QRectF>
#include <QWidget>

#include "engine/base/file_save.h"
#include "engine/study/plot.h"

class QwtPlot;

namespace glissade {

/// A plot of a study, drawn by Qwt in the colours of the palette: the same scales, ticks and intervals as the report's.
/// The pointer over a point shows the point's text; a click selects its cell. A rubber band, the wheel or + and - show
/// a part of it, the arrow keys move that part, Esc shows the whole again.
class PlotView final : public QWidget {
  Q_OBJECT

 public:
  explicit PlotView(const Plot& plot, QWidget* parent = nullptr);

  /// Shows this part; both axes go from 0 to 1, y up. It is kept within the plot and above a least size.
  void zoom(const QRectF& part);
  void zoomOut();
  bool isZoomed() const { return part_ != whole(); }
  /// Saves the plot as it is shown, as PNG or SVG by the extension of the name.
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
  /// The place of a point; both axes go from 0 to 1.
  QPointF placeOf(const PlotSeries& series, const PlotPoint& point) const;
  /// The nearest point within reach of the pointer; null if there is none.
  const PlotPoint* pointAt(const QPoint& pixel) const;

  Plot plot_;
  QwtPlot* view_;
  QRectF part_;
};

}  // namespace glissade
