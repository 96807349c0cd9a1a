#include "widgets/paths/path_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

#include "engine/base/whole_percents.h"
#include "engine/files/scenario_fits.h"
#include "engine/planning/path_bounds.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

/// Range of the ghosts' distance, metres.
constexpr double kLeastGhostDistance = 1e-5;
constexpr double kMostGhostDistance = 1e4;

/// Speeds of playing: 1 shows the whole path in the seconds of WaySlider.
constexpr std::array<double, 6> kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

/// The name of a body, escaped for rich text.
QString nameOf(int body, const LoadedScenario& scenario) {
  return QString::fromStdString(scenario.obstacles[static_cast<std::size_t>(body)].shown()).toHtmlEscaped();
}

QString allowanceText(const Fit& fit, const std::vector<PathPoint>& points, const LoadedScenario& scenario) {
  const QString body = nameOf(static_cast<int>(fit.obstacle), scenario);
  const QString length = lengthText(fit.allowance);
  if (fit.hollow && fit.kind == ContactKind::Thread)
    return PathPanel::tr("no tapped hole in the file, with %1").arg(body);
  if (fit.hollow) return PathPanel::tr("accepted clash with %1, %2 deep").arg(body, length);
  QString text = fit.yields ? PathPanel::tr("Allowance: %2 on %1, which gives way").arg(body, length)
                            : PathPanel::tr("Allowance: %1 on %2").arg(length, body);
  if (fit.evidence.byPerson > 0.0) text += PathPanel::tr(", user-defined");
  if (!fit.thread) return text;
  const double turns = turnsOn(points, scenario, fit);
  return text + QStringLiteral(" ") +
         PathPanel::tr("(thread), pitch %1, %2 turns")
             .arg(lengthText(std::abs(fit.thread->rule.pitch)), number(turns, 1));
}

QString certificateText(const Path& path, const LoadedScenario& scenario) {
  const MotionCertificate& certificate = path.certificate;
  const int body = certificate.nearest.body;
  const QString what =
      body < 0 ? PathPanel::tr("nothing near")
               : PathPanel::tr("clearance %1 to %2").arg(lengthText(certificate.minClearance), nameOf(body, scenario));
  QString held = PathPanel::tr("certified %1, required %2")
                     .arg(lengthText(certificate.provedClearance), lengthText(certificate.tolerance));
  if (body < 0) held = PathPanel::tr("required %1").arg(lengthText(certificate.tolerance));
  if (const std::size_t sliding = certificate.slidingEdges(); sliding > 0) {
    held += QStringLiteral("; ") +
            PathPanel::tr("%n of %1 edges slide", "", static_cast<int>(sliding)).arg(certificate.edges.size());
  }
  QString text =
      QStringLiteral("<b>✓ %1</b><br>%2<br>%3").arg(PathPanel::tr("Certified free of penetration"), what, held);
  for (const Fit& fit : scenario.fits.allowed) {
    text += QStringLiteral("<br>") + allowanceText(fit, path.points, scenario);
  }
  if (const MissingShapes& missing = scenario.missing; !missing.empty()) {
    text += QStringLiteral("<br>⚠ ") + PathPanel::tr("without shapes that were not read, of which nothing is known: %1")
                                           .arg(QString::fromStdString(listOf(missing)).toHtmlEscaped());
  }
  if (certificate.forbiddenMargin > 0.0) {
    text += QStringLiteral("<br>") +
            PathPanel::tr("%1 or more from forbidden places").arg(lengthText(certificate.forbiddenMargin));
  }
  if (const double deviation = surfaceDeviation(scenario); deviation > 0.0) {
    text += QStringLiteral("<br>") + PathPanel::tr("CAD accuracy ± %1").arg(lengthText(deviation));
  }
  if (const double spacing = coordinateSpacing(scenario); spacing > 0.0) {
    text += QStringLiteral("<br>") +
            PathPanel::tr("of 32-bit coordinates, which may be %1 nearer").arg(lengthText(spacing));
  }
  return text;
}

/// Shows buttons without their texts, which would widen the panel.
void showIconsOnly(const QHBoxLayout& row) {
  for (int i = 0; i < row.count(); ++i) {
    auto* button = qobject_cast<QToolButton*>(row.itemAt(i)->widget());
    if (button == nullptr) continue;
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setMinimumWidth(2 * button->iconSize().width());  // icons are set later
  }
}

double shareOf(const BlockedEdge& blocked, const WaySlider& slider) { return slider.shareAt(blocked.edge, blocked.at); }

QString refusalText(const PathExamination& refused, const WaySlider& slider, const LoadedScenario& scenario) {
  QStringList why;
  if (!refused.ends.start) why << PathPanel::tr("It no longer starts at the start pose.");
  if (!refused.ends.goal) why << PathPanel::tr("It no longer ends at the goal pose.");
  if (const auto outside = firstOutside(refused.path.points, scenario.problem)) {
    why << PathPanel::tr("It leaves the workspace at configuration %1.").arg(*outside + 1);
  } else if (!refused.blocked.empty()) {
    const BlockedEdge& first = refused.blocked.front();
    const int body = first.nearest.body;
    why << PathPanel::tr("%n of %1 edges are blocked, the first at %2 % by %3.", "",
                         static_cast<int>(refused.blocked.size()))
               .arg(std::max<std::size_t>(1, refused.path.points.size() - 1))
               .arg(number(100.0 * shareOf(first, slider), 0), body == kForbiddenPlace
                                                                   ? PathPanel::tr("a forbidden place")
                                                               : body < 0 ? PathPanel::tr("nothing near")
                                                                          : nameOf(body, scenario));
  }
  return QStringLiteral("<b>✗ %1</b><br>%2").arg(PathPanel::tr("This path is no longer valid"), why.join("<br>"));
}

}  // namespace

GhostRow::GhostRow(QWidget* parent)
    : QWidget(parent),
      by_(new QComboBox(this)),
      number_(new QSpinBox(this)),
      distance_(new QuantityBox(QuantityBox::Quantity::Length, this)) {
  // The items are in the order of PathSpacing::By.
  by_->addItems({tr("none"), tr("number"), tr("every")});
  by_->setObjectName(QStringLiteral("ghosts"));
  by_->setAccessibleName(tr("Ghosts of the object along the path"));
  by_->setToolTip(
      tr("Draw the object along the path: not at all, at a number of places, or every so many millimetres"));
  number_->setRange(1, kMostPathPoses);
  number_->setAccessibleName(tr("Number of ghosts"));
  number_->setToolTip(tr("Number of ghosts between start and goal"));
  distance_->setAccessibleName(tr("Spacing of ghosts"));
  distance_->setToolTip(tr("Spacing of ghosts, in any unit: 25.4 mm, 1 in. Turns count as far as they move the object. "
                           "At most %1 are drawn.")
                            .arg(kMostPathPoses));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Ghosts"), this));
  row->addWidget(by_);
  row->addWidget(number_);
  row->addWidget(distance_);
  row->addStretch();
  connectWidgets();
  showUnit();
}

void GhostRow::connectWidgets() {
  connect(by_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    PathSpacing spacing = spacing_;
    spacing.by = static_cast<PathSpacing::By>(index);
    setSpacing(spacing);
  });
  connect(number_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int number) {
    PathSpacing spacing = spacing_;
    spacing.number = number;
    setSpacing(spacing);
  });
  connect(distance_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    PathSpacing spacing = spacing_;
    spacing.distance = value / perMetre_;
    setSpacing(spacing);
  });
}

void GhostRow::setSpacing(const PathSpacing& spacing) {
  spacing_ = spacing;
  showSpacing();
  emit changed(spacing_);
}

void GhostRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) showUnit();
}

void GhostRow::showUnit() {
  const LengthField field = lengthField(kLeastGhostDistance);
  perMetre_ = field.perMetre;
  const QSignalBlocker block(distance_);
  distance_->setUnit(1.0 / perMetre_, field.decimals);
  distance_->setSuffix(QLatin1Char(' ') + field.unit);
  distance_->setRange(kLeastGhostDistance * perMetre_, kMostGhostDistance * perMetre_);
  distance_->setFixedWidth(distance_->fontMetrics().horizontalAdvance(QStringLiteral("00000.00 mm ")) + 12);
  showSpacing();
}

void GhostRow::showSpacing() {
  const QSignalBlocker blockBy(by_);
  const QSignalBlocker blockNumber(number_);
  const QSignalBlocker blockDistance(distance_);
  by_->setCurrentIndex(static_cast<int>(spacing_.by));
  number_->setValue(spacing_.number);
  distance_->setValue(perMetre_ * spacing_.distance);
  number_->setVisible(spacing_.by == PathSpacing::By::Number);
  distance_->setVisible(spacing_.by == PathSpacing::By::Distance);
}

PathPanel::PathPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      certificate_(new QLabel(this)),
      figures_(new QLabel(this)),
      sharesTitle_(new QWidget(this)),
      shares_(new AuthorBar(this)),
      curve_(new ClearanceCurve(this)),
      slider_(new WaySlider(this)),
      speed_(new QComboBox(this)),
      ghosts_(new GhostRow(this)) {
  for (QLabel* label : {certificate_, figures_}) label->setWordWrap(true);
  certificate_->setObjectName(QStringLiteral("certificate"));
  slider_->setAccessibleName(tr("Place on the path"));
  slider_->setToolTip(tr("Place on the path"));
  auto* row =
      makeActionRow(actions, {"path.play", "path.first-blocked", "path.tightest", "path.smooth", "file.export"}, this);
  showIconsOnly(*row);
  row->insertWidget(1, slider_, 1);
  auto* title = makeActionRow(actions, {"view.path-authors"}, sharesTitle_);
  title->setContentsMargins(0, 0, 0, 0);
  title->insertWidget(0, new QLabel(tr("Length by author"), sharesTitle_));
  title->insertStretch(1);
  sharesTitle_->setLayout(title);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(certificate_);
  layout->addLayout(row);
  layout->addWidget(curve_);
  layout->addLayout(makePlaybackRow(actions));
  layout->addWidget(ghosts_);
  layout->addWidget(figures_);
  layout->addWidget(sharesTitle_);
  layout->addWidget(shares_);
  layout->addStretch();
  connect(slider_, &WaySlider::poseShown, this, [this](const Pose& pose, double share) {
    curve_->setPlace(share);
    emit poseShown(pose);
  });
  connect(curve_, &ClearanceCurve::placeChosen, slider_, &WaySlider::showAt);
  curve_->hide();
  connect(slider_, &WaySlider::playbackEnded, this, &PathPanel::playbackEnded);
  certificate_->setText(tr("No path yet."));
}

void PathPanel::setPath(const std::shared_ptr<const Path>& path, const std::shared_ptr<const PathExamination>& refused,
                        const LoadedScenario& scenario) {
  if (path == path_ && refused == refused_) return;
  path_ = path;
  refused_ = refused;
  const Path* shown = path ? path.get() : refused ? &refused->path : nullptr;
  const Se3Metric metric = scenario.problem.metric();
  slider_->setWay(shown != nullptr ? shown->configurations() : std::vector<Pose>(), metric);
  figures_->setVisible(shown != nullptr);
  sharesTitle_->setVisible(shown != nullptr);
  shares_->setVisible(shown != nullptr);
  curve_->setVisible(path != nullptr);
  curve_->setProfile(nullptr, {}, 0.0);
  curve_->setPlace(slider_->share());
  emit poseShown(std::nullopt);
  showTexts(scenario);
}

void PathPanel::showTexts(const LoadedScenario& scenario) {
  const Path* shown = path_ ? path_.get() : refused_ ? &refused_->path : nullptr;
  if (path_) certificate_->setText(certificateText(*path_, scenario));
  if (refused_) certificate_->setText(refusalText(*refused_, *slider_, scenario));
  if (shown != nullptr) {
    showFigures(*shown, scenario.problem.metric());
  } else {
    certificate_->setText(tr("No path yet."));
  }
}

void PathPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) emit lengthUnitChanged();
}

void PathPanel::showFigures(const Path& path, const Se3Metric& metric) {
  figures_->setText(tr("%1 configurations, %2, %3°")
                        .arg(path.points.size())
                        .arg(lengthText(path.length()), number(path.rotation() * 180.0 / std::acos(-1.0), 0)));
  const PerAuthor<double> lengths = path.lengthByAuthor(metric);
  const std::array percents = wholePercents(lengths);
  PerAuthor<QString> texts;
  for (std::size_t i = 0; i < lengths.size(); ++i) texts[i] = number(percents[i], 0) + QStringLiteral(" %");
  shares_->setShares(lengths, texts);
}

void PathPanel::showFirstBlocked() {
  if (refused_ && !refused_->blocked.empty()) slider_->showAt(shareOf(refused_->blocked.front(), *slider_));
}

void PathPanel::setProfile(const std::shared_ptr<const ClearanceProfile>& profile, const LoadedScenario& scenario) {
  QStringList bodies;
  for (const RigidBody& body : scenario.obstacles) bodies << QString::fromStdString(body.shown());
  curve_->setProfile(profile, bodies, path_ ? path_->certificate.tolerance : 0.0);
}

void PathPanel::showTightest() {
  const auto& profile = curve_->profile();
  if (!profile || !profile->tightest()) return;
  slider_->showAt(profile->samples[*profile->tightest()].share);
}

/// The row of speed, loop and direction.
QHBoxLayout* PathPanel::makePlaybackRow(const ActionCatalogue& actions) {
  speed_->setAccessibleName(tr("Speed of playing"));
  speed_->setToolTip(tr("Speed of playing"));
  for (const double speed : kSpeeds) speed_->addItem(QLocale().toString(speed) + QStringLiteral("×"), speed);
  speed_->setCurrentIndex(speed_->findData(1.0));
  QAction* loop = actions["path.loop"];
  QAction* backwards = actions["path.backwards"];
  const auto apply = [this, loop, backwards] {
    slider_->setPlayback({speed_->currentData().toDouble(), loop->isChecked(), backwards->isChecked()});
  };
  connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, apply);
  for (QAction* action : {loop, backwards}) connect(action, &QAction::toggled, this, apply);
  auto* row = makeActionRow(actions, {"path.loop", "path.backwards"}, this);
  showIconsOnly(*row);
  row->insertWidget(0, speed_);
  row->insertWidget(0, new QLabel(tr("Speed"), this));
  return row;
}

void PathPanel::setPlaying(bool playing) { slider_->setPlaying(playing); }

}  // namespace glissade
