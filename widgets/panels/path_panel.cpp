#include "widgets/panels/path_panel.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace glissade {
namespace {

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

}  // namespace

PathPanel::PathPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      certificate_(new QLabel(this)),
      figures_(new QLabel(this)),
      sharesTitle_(new QWidget(this)),
      shares_(new AuthorBar(this)),
      slider_(new WaySlider(this)) {
  for (QLabel* label : {certificate_, figures_}) label->setWordWrap(true);
  certificate_->setObjectName(QStringLiteral("certificate"));
  slider_->setAccessibleName(tr("Place on the path"));
  slider_->setToolTip(tr("Place on the path"));
  auto* row = makeActionRow(actions, {"path.play", "path.smooth", "file.export"}, this);
  for (int i = 0; i < row->count(); ++i) {
    if (auto* button = qobject_cast<QToolButton*>(row->itemAt(i)->widget())) {
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
      button->setMinimumWidth(2 * button->iconSize().width());  // icons come later, and texts would widen the panel
    }
  }
  row->insertWidget(1, slider_, 1);
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
  layout->addLayout(row);
  layout->addStretch();
  connect(slider_, &WaySlider::poseShown, this, [this](const Pose& pose) { emit poseShown(pose); });
  connect(slider_, &WaySlider::playbackEnded, this, &PathPanel::playbackEnded);
  certificate_->setText(tr("No path yet."));
}

void PathPanel::setPath(const std::shared_ptr<const Path>& path, const LoadedScenario& scenario) {
  if (path == path_) return;
  path_ = path;
  const Se3Metric metric = scenario.problem.metric();
  slider_->setWay(path ? path->configurations() : std::vector<Pose>(), metric);
  figures_->setVisible(path != nullptr);
  sharesTitle_->setVisible(path != nullptr);
  shares_->setVisible(path != nullptr);
  if (!path) {
    certificate_->setText(tr("No path yet."));
    emit poseShown(std::nullopt);
    return;
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
    const double share = slider_->length() > 0.0 ? lengths[i] / slider_->length() : 0.0;
    percents[i] = number(100.0 * share, 0) + QStringLiteral(" %");
  }
  shares_->setShares(lengths, percents);
}

void PathPanel::setPlaying(bool playing) { slider_->setPlaying(playing); }

}  // namespace glissade
