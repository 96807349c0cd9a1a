#include "widgets/paths/clearance_curve.h"

#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

constexpr int kPlotHeight = 72;
constexpr double kCurveGap = 4.0;
constexpr double kKeyStep = 0.01;
/// Metres; smaller distances are drawn at the bottom of the axis.
constexpr double kSmallestDrawn = 1e-9;
/// Ratio of the ends of the axis to the least and the largest distance.
constexpr double kMargin = 1.5;
/// Largest number of decades with a label.
constexpr int kMostLabels = 4;
/// Colours of the bodies, in Okabe and Ito's hues.
constexpr std::array<QRgb, 7> kColours{0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7,
                                       0xffe69f00, 0xff56b4e9, 0xff8c8c8c};

}  // namespace

ClearanceCurve::ClearanceCurve(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Clearance along the path"));
}

QSize ClearanceCurve::sizeHint() const {
  return {160, kPlotHeight + static_cast<int>(kCurveGap) + fontMetrics().height() + 2};
}

void ClearanceCurve::setProfile(std::shared_ptr<const ClearanceProfile> profile, const QStringList& bodies,
                                double required) {
  profile_ = std::move(profile);
  bodies_ = bodies;
  required_ = required;
  bodyOrder_.clear();
  least_ = required > 0.0 ? required : 1e-3;
  most_ = least_;
  for (std::size_t i = 0; profile_ && i < profile_->samples.size(); ++i) {
    const NearestObstacle& nearest = profile_->samples[i].nearest;
    if (nearest.body < 0) continue;
    least_ = std::min(least_, std::max(nearest.distance, kSmallestDrawn));
    most_ = std::max(most_, nearest.distance);
    if (std::find(bodyOrder_.begin(), bodyOrder_.end(), nearest.body) == bodyOrder_.end()) {
      bodyOrder_.push_back(nearest.body);
    }
  }
  least_ /= kMargin;
  most_ *= kMargin;
  if (underMouse()) QToolTip::hideText();  // it is about the earlier profile
  setPlace(place_);
}

void ClearanceCurve::setPlace(double share) {
  place_ = share;
  const bool isKnown = profile_ && !profile_->samples.empty();
  setAccessibleDescription(isKnown ? textOf(sampleAt(place_)) : QString());
  update();
}

PlotLengths ClearanceCurve::lengths() const { return PlotLengths(kMargin * least_); }

/// The lengths with a label: powers of ten of the unit, metres.
std::vector<double> ClearanceCurve::marks() const {
  const double unit = roundLengthUnit();
  const int first = static_cast<int>(std::ceil(std::log10(least_ / unit)));
  const int last = static_cast<int>(std::floor(std::log10(most_ / unit)));
  const int step = std::max(1, (last - first) / kMostLabels + 1);
  std::vector<double> marks;
  for (int decade = first; decade <= last; decade += step) marks.push_back(unit * std::pow(10.0, decade));
  return marks;
}

QRectF ClearanceCurve::plotArea() const {
  int widest = 0;
  for (const double metres : marks()) {
    widest = std::max(widest, fontMetrics().horizontalAdvance(lengths().mark(metres)));
  }
  const double left = widest + 2.0 * kCurveGap;
  const double top = fontMetrics().height() + kCurveGap;
  return {left, top, std::max(1.0, width() - left - 1.0), std::max(1.0, height() - top - 2.0)};
}

double ClearanceCurve::shareAt(double x) const {
  const QRectF area = plotArea();
  return std::clamp((x - area.left()) / area.width(), 0.0, 1.0);
}

double ClearanceCurve::yOf(double distance) const {
  const QRectF area = plotArea();
  const double height = std::log(std::clamp(distance, least_, most_) / least_) / std::log(most_ / least_);
  return area.bottom() - height * area.height();
}

const ClearanceSample& ClearanceCurve::sampleAt(double share) const {
  const auto& samples = profile_->samples;
  const auto after = std::lower_bound(samples.begin(), samples.end(), share,
                                      [](const ClearanceSample& sample, double at) { return sample.share < at; });
  if (after == samples.end()) return samples.back();
  const bool before = after != samples.begin() && share - std::prev(after)->share < after->share - share;
  return before ? *std::prev(after) : *after;
}

QString ClearanceCurve::textOf(const ClearanceSample& sample) const {
  if (sample.nearest.body < 0) return tr("nothing near");
  return tr("%1 to %2").arg(lengths().text(sample.nearest.distance), bodies_.value(sample.nearest.body));
}

QColor ClearanceCurve::colourOf(int body) const {
  const auto found = std::find(bodyOrder_.begin(), bodyOrder_.end(), body);
  return QColor(kColours[static_cast<std::size_t>(found - bodyOrder_.begin()) % kColours.size()]);
}

void ClearanceCurve::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = plotArea();
  painter.fillRect(area, palette().color(QPalette::Base));
  if (!profile_ || profile_->samples.empty()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(area, Qt::AlignCenter, tr("measuring the clearance"));
    return;
  }
  paintGrid(painter);
  paintCurve(painter);
  const ClearanceSample& here = sampleAt(place_);
  const double x = area.left() + place_ * area.width();
  painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
  painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  painter.setBrush(colourOf(here.nearest.body));
  if (here.nearest.body >= 0) painter.drawEllipse(QPointF(x, yOf(here.nearest.distance)), 3.5, 3.5);
  const QString text = fontMetrics().elidedText(textOf(here), Qt::ElideMiddle, width());
  painter.drawText(QRectF(0.0, 0.0, width(), fontMetrics().height()), Qt::AlignLeft | Qt::AlignVCenter, text);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void ClearanceCurve::paintGrid(QPainter& painter) const {
  const QRectF area = plotArea();
  QColor grid = palette().color(QPalette::Text);
  grid.setAlphaF(0.15);
  for (const double metres : marks()) {
    const double y = yOf(metres);
    painter.setPen(QPen(grid, 1.0));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(palette().color(QPalette::Text));
    const double half = 0.5 * fontMetrics().height();
    const double top = std::clamp(y - half, area.top() - 0.5 * half, area.bottom() - 2.0 * half + 2.0);
    painter.drawText(QRectF(0.0, top, area.left() - kCurveGap, 2.0 * half), Qt::AlignRight | Qt::AlignVCenter,
                     lengths().mark(metres));
  }
  if (required_ <= 0.0) return;
  painter.setPen(QPen(palette().color(QPalette::Text), 1.0, Qt::DashLine));
  const double y = yOf(required_);
  painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
}

void ClearanceCurve::paintCurve(QPainter& painter) const {
  const QRectF area = plotArea();
  const auto& samples = profile_->samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].nearest.body < 0 || samples[i - 1].nearest.body < 0) continue;
    painter.setPen(QPen(colourOf(samples[i].nearest.body), 2.0));
    const auto point = [&](const ClearanceSample& sample) {
      return QPointF(area.left() + sample.share * area.width(), yOf(sample.nearest.distance));
    };
    painter.drawLine(point(samples[i - 1]), point(samples[i]));
  }
}

void ClearanceCurve::mousePressEvent(QMouseEvent* event) {
  if (profile_ && event->button() == Qt::LeftButton) emit placeChosen(shareAt(event->localPos().x()));
}

void ClearanceCurve::mouseMoveEvent(QMouseEvent* event) {
  if (!profile_ || profile_->samples.empty()) return;
  const double share = shareAt(event->localPos().x());
  if (event->buttons() & Qt::LeftButton) emit placeChosen(share);
  QToolTip::showText(event->globalPos(), textOf(sampleAt(share)), this);
}

void ClearanceCurve::keyPressEvent(QKeyEvent* event) {
  const double by = event->key() == Qt::Key_Left ? -kKeyStep : event->key() == Qt::Key_Right ? kKeyStep : 0.0;
  if (by == 0.0 || !profile_) return QWidget::keyPressEvent(event);
  emit placeChosen(std::clamp(place_ + by, 0.0, 1.0));
}

void ClearanceCurve::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) setPlace(place_);
}

}  // namespace glissade
