#include "widgets/run/counts_panel.h"

#include <QEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>

#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kStripHeight = 34;
constexpr int kStripGap = 4;
constexpr int kStrips = 3;
constexpr double kLabelGap = 4.0;
/// Metres; smaller clearances are drawn at the bottom of the axis.
constexpr double kLeastClearance = 1e-7;
constexpr QRgb kNodesColour = 0xff0072b2;
constexpr QRgb kAuthorityColour = 0xffd55e00;
constexpr QRgb kClearanceColour = 0xff009e73;

/// The least of 1, 2 or 5 times a power of ten that is not below the value.
double roundUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1.0))));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * decade) return step * decade;
  }
  return 10.0 * decade;
}

/// The name with places at which a line may break, so that a narrow label shows the whole of it.
QString breakable(const QString& name) {
  constexpr int kLongestWord = 12;
  QString text;
  int letters = 0;
  for (const QChar letter : name) {
    text += letter;
    letters = letter.isLetterOrNumber() ? letters + 1 : 0;
    if (letters % kLongestWord == 0) text += QChar(0x200B);  // zero-width space
  }
  return text;
}

QString secondsText(double seconds) { return QLocale().toString(seconds, 'f', 1) + QStringLiteral(" s"); }

}  // namespace

struct RunCurves::Curve {
  QString title;
  QString now;
  QString lowest;  ///< labels of the axis
  QString highest;
  QRgb colour;
  /// Height in the plot from 0 at the bottom to 1 at the top; nothing: not known.
  std::function<std::optional<double>(const RunSample&)> height;
};

RunCurves::RunCurves(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Nodes, computer share and clearance over the time of planning"));
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
  return {tr("Nodes"),         countText(static_cast<std::uint64_t>(now)),
          QStringLiteral("0"), countText(static_cast<std::uint64_t>(most)),
          kNodesColour,        [most](const RunSample& sample) { return std::optional<double>(sample.nodes / most); }};
}

RunCurves::Curve RunCurves::authorityCurve() const {
  return {tr("Computer share α"), QLocale().toString(history_.samples().back().authority, 'f', 2),
          QStringLiteral("0"),    QStringLiteral("1"),
          kAuthorityColour,       [](const RunSample& sample) { return std::optional<double>(sample.authority); }};
}

/// The curve of clearance, on a logarithmic axis of whole decades.
RunCurves::Curve RunCurves::clearanceCurve() const {
  double least = 1.0;
  double most = kLeastClearance;
  for (const RunSample& sample : history_.samples()) {
    if (!sample.clearance || *sample.clearance <= 0.0) continue;  // such clearances are drawn at the bottom
    least = std::min(least, std::max(*sample.clearance, kLeastClearance));
    most = std::max(most, *sample.clearance);
  }
  const double unit = roundLengthUnit();
  const double bottom = std::floor(std::log10(std::min(least, most) / unit));
  const double top = std::max(bottom + 1.0, std::ceil(std::log10(most / unit)));
  const PlotLengths lengths(unit * std::pow(10.0, bottom));
  const std::optional<double>& now = history_.samples().back().clearance;
  return {tr("Distance to the nearest obstacle"),
          !now         ? QStringLiteral("–")
          : *now > 0.0 ? lengths.text(*now)
                       : tr("in collision"),
          lengths.mark(unit * std::pow(10.0, bottom)),
          lengths.mark(unit * std::pow(10.0, top)),
          kClearanceColour,
          [unit, bottom, top](const RunSample& sample) {
            if (!sample.clearance) return std::optional<double>();
            const double decades = std::log10(std::max(*sample.clearance, kLeastClearance) / unit) - bottom;
            return std::optional<double>(std::clamp(decades / (top - bottom), 0.0, 1.0));
          }};
}

QRectF RunCurves::plotBelow(double top) const {
  int widest = fontMetrics().horizontalAdvance(lengthText(1.11e-5));  // a usual label, so that plots seldom shift
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

/// Paints the common time axis below the last strip.
void RunCurves::paintTimes(QPainter& painter) const {
  const double line = fontMetrics().height();
  const QRectF plot = plotBelow(0.0);
  const QRectF axis(plot.left(), height() - line, plot.width(), line);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(axis, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("0 s"));
  painter.drawText(axis, Qt::AlignHCenter | Qt::AlignVCenter, tr("Duration of the run"));
  painter.drawText(axis, Qt::AlignRight | Qt::AlignVCenter, secondsText(history_.samples().back().seconds));
}

CountsPanel::CountsPanel(QWidget* parent) : QWidget(parent), layout_(new QFormLayout(this)) {
  layout_->setVerticalSpacing(3);
  curves_ = new RunCurves(this);
  layout_->addRow(curves_);
  comparison_ = new QLabel(this);
  comparison_->setObjectName(QStringLiteral("paper-comparison"));
  comparison_->setTextFormat(Qt::RichText);
  comparison_->setWordWrap(true);
  comparison_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  comparison_->hide();
  layout_->addRow(comparison_);
  iterations_ = addRow(tr("Iterations"), tr("Passes of the paper's loop"));
  nodes_ = addRow(tr("Nodes"), tr("Nodes of the roadmap"));
  authors_ = new AuthorBar(this);
  layout_->addRow(authors_);
  hand_ = new QLabel(this);
  hand_->setObjectName(QStringLiteral("hand-report"));
  hand_->setWordWrap(true);
  hand_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  hand_->hide();
  layout_->addRow(hand_);
  edges_ = addRow(tr("Edges, both directions"), tr("Each edge counts twice, as in the papers' tables"));
  random_ = addRow(tr("Random configurations"), tr("Drawn by the computer, kept or not"));
  operator_ = addRow(tr("Operator configurations"), tr("Where the operator held the object"));
  contact_ = addRow(tr("Contact configurations"), tr("Drawn on tangent planes, kept or not"));
  duration_ = addRow(tr("Duration of the run"), tr("Includes the person's time; pauses do not count"));
  time_ = addRow(tr("Processor time"), tr("Time in which the computer planned; the processors' times are added"));
  pace_ = addRow(tr("Steps per second of the run"), tr("Planner steps in a second of the duration, in which a person "
                                                       "steers; Pace limits them"));
  mode_ = addRow(tr("Contact mode"), tr("On while contact samples are drawn"));
  nearest_ = addRow(tr("Nearest obstacle"), tr("Of the object in the operator's hand"));
  nearest_->setWordWrap(true);  // long names do not widen the panel
  layout_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  distance_ = addRow(tr("Distance"), tr("To the nearest obstacle"));
}

QLabel* CountsPanel::addRow(const QString& label, const QString& tip) {
  auto* value = new QLabel(QStringLiteral("–"), this);
  value->setAlignment(Qt::AlignRight);
  value->setToolTip(tip);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout_->addRow(label, value);
  return value;
}

void CountsPanel::setSnapshot(const SessionSnapshot& snapshot, const LoadedScenario& scenario, SessionClock clock) {
  const PlannerCounts& counts = snapshot.counts;
  iterations_->setText(countText(counts.iterations));
  nodes_->setText(countText(counts.nodes));
  PerAuthor<double> shares{};
  PerAuthor<QString> numbers;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = static_cast<double>(snapshot.nodesByAuthor[i]);
    numbers[i] = countText(snapshot.nodesByAuthor[i]);
  }
  authors_->setShares(shares, numbers);
  edges_->setText(countText(counts.edges));
  random_->setText(countText(counts.randomConfigurations));
  operator_->setText(countText(counts.operatorConfigurations));
  contact_->setText(countText(counts.contactConfigurations));
  const double seconds = snapshot.virtualSeconds;
  duration_->setText(secondsText(seconds));
  time_->setText(clock == SessionClock::RealTime ? secondsText(snapshot.planningCpuSeconds) : QStringLiteral("–"));
  pace_->setText(seconds > 0.0 ? countText(static_cast<std::uint64_t>(static_cast<double>(counts.steps) / seconds))
                               : QStringLiteral("–"));
  const NearestObstacle& nearest = snapshot.device.nearest;
  const bool known = nearest.body >= 0;
  curves_->add(snapshot.run, {seconds, static_cast<double>(counts.nodes), valueInForce(snapshot, ParameterId::Alpha),
                              known ? std::optional<double>(nearest.distance) : std::nullopt});
  mode_->setText(snapshot.contactMode ? tr("on") : tr("off"));
  nearest_->setText(
      known ? breakable(QString::fromStdString(scenario.obstacles[static_cast<std::size_t>(nearest.body)].shown()))
            : QStringLiteral("–"));
  shownDistance_ = known ? std::optional<double>(nearest.distance) : std::nullopt;
  showDistance();
  hand_->setVisible(snapshot.hand.has_value());
  if (snapshot.hand) hand_->setText(handText(*snapshot.hand, snapshot.path != nullptr));
}

void CountsPanel::setComparison(const QString& html) {
  comparison_->setText(html);
  comparison_->setVisible(!html.isEmpty());
}

QString CountsPanel::handText(const HandReport& hand, bool found) {
  QString text = tr("Your hand showed %1 configurations. In collision: %2; moved to contact: %3.")
                     .arg(countText(hand.shown), countText(hand.collided), countText(hand.movedToContact));
  if (!found) return text;
  text += QLatin1Char('\n') +
          (hand.joined ? tr("Your way joined start and goal.") : tr("The computer joined start and goal."));
  const QString share = QLocale().toString(100.0 * hand.followed, 'f', 0);
  return text + QLatin1Char('\n') + tr("The path follows your way for %1 % of its length.").arg(share);
}

void CountsPanel::showDistance() {
  distance_->setText(!shownDistance_         ? QStringLiteral("–")
                     : *shownDistance_ > 0.0 ? lengthText(*shownDistance_)
                                             : tr("in collision"));
}

/// Writes lengths again when their unit has changed.
void CountsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LocaleChange) return;
  showDistance();
  curves_->update();
}

}  // namespace glissade
