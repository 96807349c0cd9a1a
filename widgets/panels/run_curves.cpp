#include "widgets/panels/run_curves.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

constexpr int kStripHeight = 34;
constexpr int kStripGap = 4;
constexpr int kStrips = 3;
constexpr double kLabelGap = 4.0;
/// Clearances below are drawn at the bottom of the axis, metres.
constexpr double kLeastClearance = 1e-7;
constexpr QRgb kNodesColour = 0xff0072b2;
constexpr QRgb kAuthorityColour = 0xffd55e00;
constexpr QRgb kClearanceColour = 0xff009e73;

/// 1, 2 or 5 times a power of ten, not below the value.
double roundUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1.0))));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * decade) return step * decade;
  }
  return 10.0 * decade;
}

QString countText(double value) { return QLocale().toString(static_cast<qulonglong>(value)); }

}  // namespace

struct RunCurves::Curve {
  QString title;
  QString now;
  QString lowest;  ///< labels of the axis
  QString highest;
  QRgb colour;
  /// From 0 at the bottom to 1 at the top; nothing: not known.
  std::function<std::optional<double>(const RunSample&)> height;
};

RunCurves::RunCurves(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Nodes, authority and clearance over the time of planning"));
  setToolTip(
      tr("Nodes of the roadmap, the computer's share α, and the distance of the object in the operator's hand to the "
         "nearest obstacle, over the time of planning"));
  hide();
}

QSize RunCurves::sizeHint() const {
  const int line = fontMetrics().height();
  return {160, kStrips * (line + kStripHeight + kStripGap) + line};
}

void RunCurves::add(std::uint64_t run, const RunSample& sample) {
  history_.add(run, sample);
  setVisible(run > 0);
  if (!isVisible()) return;
  setAccessibleDescription(QStringList({nodesCurve().now, authorityCurve().now, clearanceCurve().now}).join(", "));
  update();
}

RunCurves::Curve RunCurves::nodesCurve() const {
  const double now = history_.samples().back().nodes;
  const double most = roundUp(std::max(now, 10.0));
  return {tr("Nodes"),         countText(now),
          QStringLiteral("0"), countText(most),
          kNodesColour,        [most](const RunSample& sample) { return std::optional<double>(sample.nodes / most); }};
}

RunCurves::Curve RunCurves::authorityCurve() const {
  return {tr("Authority α"),   QLocale().toString(history_.samples().back().authority, 'f', 2),
          QStringLiteral("0"), QStringLiteral("1"),
          kAuthorityColour,    [](const RunSample& sample) { return std::optional<double>(sample.authority); }};
}

/// On a logarithmic axis of whole decades.
RunCurves::Curve RunCurves::clearanceCurve() const {
  double least = 1.0;
  double most = kLeastClearance;
  for (const RunSample& sample : history_.samples()) {
    if (!sample.clearance || *sample.clearance <= 0.0) continue;  // drawn at the bottom
    least = std::min(least, std::max(*sample.clearance, kLeastClearance));
    most = std::max(most, *sample.clearance);
  }
  const double bottom = std::floor(std::log10(std::min(least, most)));
  const double top = std::max(bottom + 1.0, std::ceil(std::log10(most)));
  const std::optional<double>& now = history_.samples().back().clearance;
  return {tr("Distance to the nearest obstacle"),
          !now         ? QStringLiteral("–")
          : *now > 0.0 ? lengthText(*now)
                       : tr("in collision"),
          lengthText(std::pow(10.0, bottom)),
          lengthText(std::pow(10.0, top)),
          kClearanceColour,
          [bottom, top](const RunSample& sample) {
            if (!sample.clearance) return std::optional<double>();
            const double decades = std::log10(std::max(*sample.clearance, kLeastClearance)) - bottom;
            return std::optional<double>(std::clamp(decades / (top - bottom), 0.0, 1.0));
          }};
}

QRectF RunCurves::plotBelow(double top) const {
  int widest = fontMetrics().horizontalAdvance(lengthText(1.11e-5));  // usual ones, so that plots seldom shift
  for (const Curve& curve : {nodesCurve(), authorityCurve(), clearanceCurve()}) {
    for (const QString& label : {curve.lowest, curve.highest}) {
      widest = std::max(widest, fontMetrics().horizontalAdvance(label));
    }
  }
  const double left = widest + kLabelGap;
  return {left, top + fontMetrics().height(), std::max(1.0, width() - left - 1.0), kStripHeight};
}

void RunCurves::paintEvent(QPaintEvent* /*event*/) {
  if (history_.samples().empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  double top = 0.0;
  for (const Curve& curve : {nodesCurve(), authorityCurve(), clearanceCurve()}) {
    paintCurve(painter, curve, top);
    top += fontMetrics().height() + kStripHeight + kStripGap;
  }
  paintTimes(painter);
}

void RunCurves::paintCurve(QPainter& painter, const Curve& curve, double top) const {
  const QRectF plot = plotBelow(top);
  const double line = fontMetrics().height();
  painter.setPen(palette().color(QPalette::WindowText));
  const QRectF head(0.0, top, width(), line);
  painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, curve.now);
  const int room = width() - fontMetrics().horizontalAdvance(curve.now + QStringLiteral("  "));
  painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, fontMetrics().elidedText(curve.title, Qt::ElideRight, room));
  const QRectF labels(0.0, plot.top(), plot.left() - kLabelGap, plot.height());
  painter.drawText(labels, Qt::AlignRight | Qt::AlignTop, curve.highest);
  painter.drawText(labels, Qt::AlignRight | Qt::AlignBottom, curve.lowest);
  painter.fillRect(plot, palette().color(QPalette::Base));
  const double whole = std::max(history_.samples().back().seconds, 1e-9);
  QPolygonF part;
  painter.setPen(QPen(QColor(curve.colour), 1.6));
  for (const RunSample& sample : history_.samples()) {
    const std::optional<double> height = curve.height(sample);
    if (height) {
      part << QPointF(plot.left() + plot.width() * sample.seconds / whole, plot.bottom() - *height * plot.height());
    } else {
      painter.drawPolyline(part);
      part.clear();
    }
  }
  painter.drawPolyline(part);
}

/// Below the last strip: the axis that all of them share.
void RunCurves::paintTimes(QPainter& painter) const {
  const double line = fontMetrics().height();
  const QRectF plot = plotBelow(0.0);
  const QRectF axis(plot.left(), height() - line, plot.width(), line);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(axis, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("0 s"));
  painter.drawText(axis, Qt::AlignHCenter | Qt::AlignVCenter, tr("Computing time"));
  painter.drawText(axis, Qt::AlignRight | Qt::AlignVCenter,
                   QLocale().toString(history_.samples().back().seconds, 'f', 1) + QStringLiteral(" s"));
}

}  // namespace glissade
