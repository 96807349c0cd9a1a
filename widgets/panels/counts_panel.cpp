#include "widgets/panels/counts_panel.h"

#include <QEvent>
#include <QLocale>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

QString count(std::uint64_t value) { return QLocale().toString(static_cast<qulonglong>(value)); }

}  // namespace

CountsPanel::CountsPanel(QWidget* parent) : QWidget(parent), layout_(new QFormLayout(this)) {
  layout_->setVerticalSpacing(3);
  curves_ = new RunCurves(this);
  layout_->addRow(curves_);
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
  edges_ = addRow(tr("Edges"), tr("Both directions, as the papers count"));
  random_ = addRow(tr("Random configurations"), tr("Drawn by the computer, kept or not"));
  operator_ = addRow(tr("Operator configurations"), tr("Where the operator held the object"));
  contact_ = addRow(tr("Contact configurations"), tr("Shot on tangent planes, kept or not"));
  time_ = addRow(tr("Computing time"), tr("Of planning; pauses do not count"));
  pace_ = addRow(tr("Steps per second"), tr("Planner steps in a second"));
  mode_ = addRow(tr("Contact mode"), tr("On while contact samples are shot"));
  nearest_ = addRow(tr("Nearest obstacle"), tr("Of the object in the operator's hand"));
  nearest_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // no name widens the panel
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

void CountsPanel::setSnapshot(const SessionSnapshot& snapshot, const LoadedScenario& scenario) {
  const PlannerCounts& counts = snapshot.counts;
  iterations_->setText(count(counts.iterations));
  nodes_->setText(count(counts.nodes));
  PerAuthor<double> shares{};
  PerAuthor<QString> numbers;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = static_cast<double>(snapshot.nodesByAuthor[i]);
    numbers[i] = count(snapshot.nodesByAuthor[i]);
  }
  authors_->setShares(shares, numbers);
  edges_->setText(count(counts.edges));
  random_->setText(count(counts.randomConfigurations));
  operator_->setText(count(counts.operatorConfigurations));
  contact_->setText(count(counts.contactConfigurations));
  time_->setText(QLocale().toString(snapshot.virtualSeconds, 'f', 1) + QStringLiteral(" s"));
  const double seconds = snapshot.virtualSeconds;
  pace_->setText(seconds > 0.0 ? count(static_cast<std::uint64_t>(static_cast<double>(counts.steps) / seconds))
                               : QStringLiteral("–"));
  const NearestObstacle& nearest = snapshot.device.nearest;
  const bool known = nearest.body >= 0;
  curves_->add(snapshot.run, {seconds, static_cast<double>(counts.nodes), valueInForce(snapshot, ParameterId::Alpha),
                              known ? std::optional<double>(nearest.distance) : std::nullopt});
  mode_->setText(snapshot.contactMode ? tr("on") : tr("off"));
  nearest_->setText(known ? QString::fromStdString(scenario.obstacles[static_cast<std::size_t>(nearest.body)].shown())
                          : QStringLiteral("–"));
  nearest_->setToolTip(known ? nearest_->text() : QString());
  shownDistance_ = known ? std::optional<double>(nearest.distance) : std::nullopt;
  showDistance();
  hand_->setVisible(snapshot.hand.has_value());
  if (snapshot.hand) hand_->setText(handText(*snapshot.hand, snapshot.path != nullptr));
}

QString CountsPanel::handText(const HandReport& hand, bool found) {
  QString text = tr("Your hand showed %1 configurations. In collision: %2; moved to contact: %3.")
                     .arg(count(hand.shown), count(hand.collided), count(hand.movedToContact));
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

/// Another unit of lengths was chosen.
void CountsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LocaleChange) return;
  showDistance();
  curves_->update();
}

}  // namespace glissade
