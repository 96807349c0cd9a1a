#include "widgets/panels/path_panel.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr int kPositions = 2000;
constexpr int kTickMilliseconds = 16;
/// The whole path plays in this time.
constexpr double kPlaySeconds = 12.0;

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

}  // namespace

PathPanel::PathPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      certificate_(new QLabel(this)),
      figures_(new QLabel(this)),
      sharesTitle_(new QWidget(this)),
      shares_(new AuthorBar(this)),
      slider_(new QSlider(Qt::Horizontal, this)) {
  for (QLabel* label : {certificate_, figures_}) label->setWordWrap(true);
  certificate_->setObjectName(QStringLiteral("certificate"));
  slider_->setRange(0, kPositions);
  slider_->setAccessibleName(tr("Place on the path"));
  slider_->setToolTip(tr("Place on the path"));
  auto* row = new QHBoxLayout;
  for (const char* id : {"path.play", "file.export"}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions[QLatin1String(id)]);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row->addWidget(button);
  }
  auto* smooth = new QToolButton(this);
  smooth->setDefaultAction(actions[QStringLiteral("path.smooth")]);
  smooth->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  smooth->setFocusPolicy(Qt::TabFocus);
  smooth->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* title = makeActionRow(actions, {"view.path-authors"}, sharesTitle_);
  title->setContentsMargins(0, 0, 0, 0);
  title->insertWidget(0, new QLabel(tr("Length by author"), sharesTitle_));
  title->insertStretch(1);
  sharesTitle_->setLayout(title);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(certificate_);
  layout->addWidget(figures_);
  layout->addWidget(sharesTitle_);
  layout->addWidget(shares_);
  layout->addWidget(slider_);
  layout->addLayout(row);
  layout->addWidget(smooth);
  layout->addStretch();
  timer_.setInterval(kTickMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &PathPanel::tick);
  connect(slider_, &QSlider::valueChanged, this, &PathPanel::showAt);
  slider_->setEnabled(false);
  certificate_->setText(tr("No path yet."));
}

void PathPanel::setPath(const std::shared_ptr<const Path>& path, const LoadedScenario& scenario) {
  if (path == path_) return;
  path_ = path;
  setPlaying(false);
  slider_->setEnabled(path != nullptr);
  figures_->setVisible(path != nullptr);
  sharesTitle_->setVisible(path != nullptr);
  shares_->setVisible(path != nullptr);
  if (!path) {
    certificate_->setText(tr("No path yet."));
    emit poseShown(std::nullopt);
    return;
  }
  const Se3Metric metric = scenario.problem.metric();
  arrival_.assign(1, 0.0);
  for (std::size_t i = 1; i < path->points.size(); ++i) {
    arrival_.push_back(arrival_.back() + metric.distance(path->points[i - 1].q, path->points[i].q));
  }
  const MotionCertificate& certificate = path->certificate;
  const int body = certificate.nearest.body;
  const QString what = body < 0
                           ? tr("nothing near")
                           : tr("clearance %1 mm to %2")
                                 .arg(number(certificate.minClearance * 1e3, 2),
                                      QString::fromStdString(scenario.obstacles[static_cast<std::size_t>(body)].name));
  QString held = tr("proved %1 mm, required %2 mm")
                     .arg(number(certificate.provedClearance * 1e3, 3), number(certificate.tolerance * 1e3, 3));
  if (body < 0) held = tr("required %1 mm").arg(number(certificate.tolerance * 1e3, 3));
  if (const std::size_t sliding = certificate.slidingEdges(); sliding > 0) {
    held += QStringLiteral("; ") + tr("%1 of %2 edges slide").arg(sliding).arg(certificate.edges.size());
  }
  certificate_->setText(QStringLiteral("<b>✓ %1</b><br>%2<br>%3").arg(tr("Certified free of penetration"), what, held));
  figures_->setText(tr("%1 configurations, %2 m, %3°")
                        .arg(path->points.size())
                        .arg(number(path->length(), 2), number(path->rotation() * 180.0 / std::acos(-1.0), 0)));
  const PerAuthor<double> lengths = path->lengthByAuthor(metric);
  PerAuthor<QString> percents;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double share = arrival_.back() > 0.0 ? lengths[i] / arrival_.back() : 0.0;
    percents[i] = number(100.0 * share, 0) + QStringLiteral(" %");
  }
  shares_->setShares(lengths, percents);
  const QSignalBlocker block(slider_);
  slider_->setValue(0);
}

void PathPanel::setPlaying(bool playing) {
  if (playing && path_) {
    if (slider_->value() == kPositions) slider_->setValue(0);
    timer_.start();
  } else if (timer_.isActive()) {
    timer_.stop();
    emit playbackEnded();
  }
}

void PathPanel::tick() {
  const int step = std::max(1, static_cast<int>(kPositions * kTickMilliseconds / (1000.0 * kPlaySeconds)));
  slider_->setValue(slider_->value() + step);
  if (slider_->value() == kPositions) setPlaying(false);
}

void PathPanel::showAt(int position) {
  if (!path_) return;
  const double s = arrival_.back() * position / kPositions;
  const auto after = std::upper_bound(arrival_.begin(), arrival_.end(), s);
  const auto i = static_cast<std::size_t>(std::min<std::ptrdiff_t>(std::distance(arrival_.begin(), after),
                                                                   static_cast<std::ptrdiff_t>(arrival_.size()) - 1));
  const double length = arrival_[i] - arrival_[i - 1];
  const double t = length > 0.0 ? (s - arrival_[i - 1]) / length : 1.0;
  emit poseShown(interpolate(path_->points[i - 1].q, path_->points[i].q, t));
}

}  // namespace glissade
