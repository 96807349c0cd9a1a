#include "widgets/run/interaction_panel.h"

#include <QAbstractItemView>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "engine/operator/device_registry.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/run/strategy_use.h"

namespace glissade {
namespace {

QString text(const std::string& value) { return QString::fromStdString(value); }

void select(QComboBox& box, const std::string& id) {
  const QSignalBlocker block(box);
  box.setCurrentIndex(box.findData(text(id)));
}

/// All live parameters, except those with a box or a button of their own.
std::vector<ParameterId> steeringParameters() {
  std::vector<ParameterId> ids;
  for (const ParameterSpec& spec : parameterTable()) {
    const bool hasOwn = spec.id == ParameterId::Tuning || spec.id == ParameterId::Pace;
    if (spec.live && !hasOwn) ids.push_back(spec.id);
  }
  return ids;
}

QComboBox* makeBox(QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

}  // namespace

InteractionPanel::InteractionPanel(QWidget* parent)
    : QWidget(parent),
      planner_(makeBox(this)),
      about_(new QLabel(this)),
      device_(makeBox(this)),
      pace_(new PaceBox(this)),
      seed_(new SeedBox(this)),
      authorityTitle_(new QLabel(tr("Computer share now"), this)),
      authority_(new QLabel(this)),
      replayed_(new QLabel(tr("Replayed: as it was at this step"), this)),
      sliders_(new ParameterSliders(steeringParameters(), this)) {
  fillStrategies();
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::PlainText);
  about_->setForegroundRole(QPalette::PlaceholderText);
  about_->setObjectName(QStringLiteral("about-strategy"));
  const DeviceRegistry devices = makeDeviceRegistry();
  for (const DeviceEntry& entry : devices.entries()) {
    device_->addItem(engineText(entry.label), text(entry.id));
    device_->setItemData(device_->count() - 1, engineText(entry.description), Qt::ToolTipRole);
  }
  planner_->setObjectName(QStringLiteral("strategy"));
  planner_->setToolTip(tr("The strategy of the next run"));
  planner_->setAccessibleName(tr("Strategy"));
  device_->setToolTip(tr("Who holds the object"));
  device_->setAccessibleName(tr("Operator"));
  seed_->setToolTip(tr("Same scenario, seed and inputs: same roadmap"));
  authority_->setObjectName(QStringLiteral("authority"));
  authority_->setToolTip(tr("Whose configuration was tried last"));

  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(tr("Strategy"), planner_);
  form->addRow(about_);
  form->addRow(tr("Operator"), device_);
  form->addRow(tr("Pace"), pace_);
  form->addRow(tr("Seed"), seed_);
  form->addRow(authorityTitle_, authority_);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  layout->addLayout(form);
  replayed_->setObjectName(QStringLiteral("replayed"));
  replayed_->setStyleSheet(QStringLiteral("QLabel { background: #b3500a; color: white; padding: 2px 6px; }"));
  replayed_->hide();
  layout->addWidget(replayed_);
  connect(sliders_, &ParameterSliders::commanded, this, &InteractionPanel::commanded);
  layout->addWidget(sliders_);
  layout->addStretch();
  connect(pace_, &PaceBox::paceChosen, this, [this](double pace) {
    emit commanded(command::SetParameter{ParameterId::Pace, pace});
  });
  connect(planner_, QOverload<int>::of(&QComboBox::activated), this, &InteractionPanel::chooseStrategy);
  connect(device_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit deviceChosen(device_->currentData().toString()); });
  connect(seed_, &SeedBox::seedChosen, this, [this](quint64 seed) { emit commanded(command::SetSeed{seed}); });
}

/// Lists the main strategies, and a row that shows the others.
void InteractionPanel::fillStrategies() {
  addStrategies(true);
  planner_->insertSeparator(planner_->count());
  advancedRow_ = planner_->count();
  planner_->addItem(tr("Advanced…"));
  planner_->setItemData(advancedRow_, tr("Shows all strategies"), Qt::ToolTipRole);
}

void InteractionPanel::addStrategies(bool main) {
  for (const PlannerEntry& entry : planners_.entries()) {
    if (isMainStrategy(entry.id) != main) continue;
    planner_->addItem(engineText(entry.label), text(entry.id));
    planner_->setItemData(planner_->count() - 1, engineText(entry.description), Qt::ToolTipRole);
  }
  planner_->view()->setMinimumWidth(planner_->view()->sizeHintForColumn(0) + 24);
  planner_->setMaxVisibleItems(planner_->count() + 1);
}

void InteractionPanel::showAdvanced() {
  if (planner_->count() > advancedRow_ + 1) return;
  planner_->setItemText(advancedRow_, tr("Advanced"));
  planner_->setItemData(advancedRow_, {}, Qt::ToolTipRole);
  static_cast<QStandardItemModel*>(planner_->model())->item(advancedRow_)->setFlags(Qt::NoItemFlags);
  addStrategies(false);
}

void InteractionPanel::chooseStrategy() {
  if (planner_->currentIndex() != advancedRow_) {
    emit commanded(command::SetPlanner{planner_->currentData().toString().toStdString()});
    return;
  }
  showAdvanced();
  select(*planner_, shownStrategy_);
  planner_->showPopup();
}

void InteractionPanel::showUse() {
  const std::string strategy = planner_->currentData().toString().toStdString();
  const std::string device = device_->currentData().toString().toStdString();
  if (strategy + "/" + device == shownUse_) return;
  shownUse_ = strategy + "/" + device;
  const PlannerEntry* entry = planners_.find(strategy);
  if (entry == nullptr) return;
  about_->setText(engineText(entry->description));
  sliders_->showOnly(parametersInUse(*entry, device));
  authorityTitle_->setVisible(entry->usesOperator);
  authority_->setVisible(entry->usesOperator);
}

void InteractionPanel::setScenario(const LoadedScenario& scenario) { sliders_->setScenario(scenario); }

void InteractionPanel::setSnapshot(const SessionSnapshot& snapshot) {
  shownStrategy_ = snapshot.plannerId;
  if (!isMainStrategy(shownStrategy_)) showAdvanced();
  select(*planner_, shownStrategy_);
  pace_->setPace(snapshot.parameters[ParameterId::Pace]);
  showUse();
  if (!seed_->hasFocus()) seed_->setSeed(snapshot.seed);
  sliders_->setSnapshot(snapshot);
  if (snapshot.state != SessionState::Planning) {
    authority_->setText(QStringLiteral("–"));
  } else if (snapshot.authority == Author::Computer) {
    authority_->setText(tr("computer"));
  } else {
    authority_->setText(snapshot.authority == Author::Operator ? tr("operator") : tr("operator, in contact"));
  }
}

void InteractionPanel::setReplayed(bool replayed) {
  replayed_->setVisible(replayed);
  sliders_->setEnabled(!replayed);
  planner_->setEnabled(!replayed);
  device_->setEnabled(!replayed);
  seed_->setEnabled(!replayed);
  pace_->setEnabled(!replayed);
}

void InteractionPanel::setDevice(const std::string& deviceId) {
  select(*device_, deviceId);
  showUse();
}

}  // namespace glissade
