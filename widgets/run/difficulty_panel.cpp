#include "widgets/run/difficulty_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kRowRole = Qt::UserRole;

QString bodyName(int body, const LoadedScenario& scenario) {
  if (body < 0) return QStringLiteral("–");
  return QString::fromStdString(scenario.obstacles[static_cast<std::size_t>(body)].shown());
}

}  // namespace

DifficultyPanel::DifficultyPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent), summary_(new QLabel(this)), rows_(new QTreeWidget(this)), slider_(new WaySlider(this)) {
  summary_->setWordWrap(true);
  rows_->setObjectName(QStringLiteral("difficulty-rows"));
  rows_->setAccessibleName(tr("Reasons why there is no path"));
  rows_->setHeaderLabels({tr("Where"), tr("How much"), tr("Nearest body")});
  rows_->setRootIsDecorated(false);
  rows_->setUniformRowHeights(true);
  rows_->setAlternatingRowColors(true);
  rows_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  rows_->header()->setStretchLastSection(true);
  slider_->setAccessibleName(tr("Place on the path of least penetration"));
  slider_->setToolTip(tr("Place on the path of least penetration"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(summary_);
  layout->addWidget(rows_, 1);
  layout->addWidget(slider_);
  layout->addLayout(makeActionFlow(actions, {"difficulty.find", "difficulty.play", "assist.go"}, this));
  connect(rows_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item != nullptr) choose(rows_->indexOfTopLevelItem(item));
  });
  connect(slider_, &WaySlider::poseShown, this, [this](const Pose& pose, double /*share*/) { emit poseShown(pose); });
  connect(slider_, &WaySlider::playbackEnded, this, &DifficultyPanel::playbackEnded);
  summary_->setText(tr("Not analysed yet."));
}

void DifficultyPanel::setDifficulty(const DifficultyPtr& difficulty, const HelpPlacesPtr& help,
                                    const LoadedScenario& scenario) {
  {
    const QSignalBlocker block(rows_);
    rows_->clear();
    places_.clear();
    if (difficulty) describe(*difficulty, scenario);
    firstHelp_ = rows_->topLevelItemCount();
    if (help) offer(*help, scenario);
  }
  const bool way = difficulty && difficulty->leastPenetration;
  slider_->setWay(way ? difficulty->leastPenetration->way : std::vector<Pose>(), scenario.problem.metric());
  if (!difficulty) summary_->setText(tr("Not analysed yet."));
  emit poseShown(std::nullopt);
}

void DifficultyPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) emit lengthUnitChanged();
}

void DifficultyPanel::describe(const Difficulty& difficulty, const LoadedScenario& scenario) {
  if (const auto& least = difficulty.leastPenetration) {
    summary_->setText(tr("There is a path if the object may overlap <b>%2</b> by <b>%1</b>.")
                          .arg(lengthText(least->depth), bodyName(least->body, scenario).toHtmlEscaped()));
    addRow("least", tr("Least penetration"), lengthText(least->depth), least->body, least->q, scenario);
  } else {
    summary_->setText(tr("No path was found, even for an object as thin as its thickness allows."));
  }
  if (const auto& tightest = difficulty.tightest) {
    addRow("tightest", tr("Tightest passage reached"), lengthText(tightest->clearance), tightest->body, tightest->q,
           scenario);
  }
  if (const auto& frontier = difficulty.frontier) {
    addRow("frontier", tr("Distance between the trees"), lengthText(frontier->distance), frontier->body,
           frontier->body < 0 ? frontier->fromStart : frontier->blockedAt, scenario);
  }
}

void DifficultyPanel::offer(const std::vector<HelpPlace>& help, const LoadedScenario& scenario) {
  if (!help.empty()) summary_->setText(summary_->text() + QLatin1Char(' ') + tr("Your hand may find the path."));
  for (std::size_t i = 0; i < help.size(); ++i) {
    const double radius = scenario.problem.world->objectRadius();
    QString lacking = help[i].lacking ? lengthText(*help[i].lacking) : tr("closed");
    if (isOpen(help[i], radius)) lacking = tr("open");
    const std::string id = "help-" + std::to_string(i + 1);
    addRow(id.c_str(), tr("Place to help %1").arg(i + 1), lacking, help[i].body, help[i].fromStart, scenario);
  }
}

void DifficultyPanel::choose(int row) {
  emit poseShown(places_[static_cast<std::size_t>(row)]);
  if (row >= firstHelp_) emit helpChosen(static_cast<std::size_t>(row - firstHelp_));
}

bool DifficultyPanel::showPart(const QString& id) {
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    if (rows_->topLevelItem(i)->data(0, kRowRole) != id) continue;
    rows_->setCurrentItem(rows_->topLevelItem(i));
    return true;
  }
  return false;
}

void DifficultyPanel::addRow(const char* id, const QString& what, const QString& amount, int body, const Pose& q,
                             const LoadedScenario& scenario) {
  const QString other = bodyName(body, scenario);
  auto* item = new QTreeWidgetItem(rows_, {what, amount, other});
  item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  item->setData(0, kRowRole, QString::fromLatin1(id));
  item->setToolTip(2, other);
  item->setToolTip(0, tr("Shows the object there"));
  places_.push_back(q);
}

}  // namespace glissade
