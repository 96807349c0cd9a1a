#include "widgets/run/interaction_panel.h"

#include <QFormLayout>
#include <QVBoxLayout>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/run/strategy_use.h"

namespace glissade {
namespace {

QString text(const std::string& value) { return QString::fromStdString(value); }

/// All live parameters, except those with a box or a button of their own.
std::vector<ParameterId> steeringParameters() {
  std::vector<ParameterId> ids;
  for (const ParameterSpec& spec : parameterTable()) {
    const bool hasOwn = spec.id == ParameterId::Tuning || spec.id == ParameterId::Pace;
    if (spec.live && !hasOwn) ids.push_back(spec.id);
  }
  return ids;
}

std::vector<ResearchBox::Entry> strategies(const PlannerRegistry& planners) {
  std::vector<ResearchBox::Entry> entries;
  for (const PlannerEntry& entry : planners.entries()) {
    entries.push_back(
        {text(entry.id), engineText(entry.label), engineText(entry.description), !isMainStrategy(entry.id)});
  }
  return entries;
}

std::vector<ResearchBox::Entry> operators(const DeviceRegistry& devices) {
  std::vector<ResearchBox::Entry> entries;
  for (const DeviceEntry& entry : devices.entries()) {
    entries.push_back({text(entry.id), engineText(entry.label), engineText(entry.description), entry.id != kAnyDevice});
  }
  return entries;
}

}  // namespace

InteractionPanel::InteractionPanel(QWidget* parent)
    : QWidget(parent),
      planner_(new ResearchBox(strategies(planners_), this)),
      about_(new QLabel(this)),
      device_(new ResearchBox(operators(devices_), this)),
      pace_(new PaceBox(this)),
      seed_(new SeedBox(this)),
      authorityTitle_(new QLabel(tr("Tried last"), this)),
      authority_(new QLabel(this)),
      replayed_(new QLabel(tr("Replayed: as it was at this step"), this)),
      sliders_(new ParameterSliders(steeringParameters(), this)) {
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::PlainText);
  about_->setForegroundRole(QPalette::PlaceholderText);
  about_->setObjectName(QStringLiteral("about-strategy"));
  planner_->setObjectName(QStringLiteral("strategy"));
  planner_->setToolTip(tr("The strategy of the next run"));
  planner_->setAccessibleName(tr("Strategy"));
  device_->setObjectName(QStringLiteral("operator"));
  device_->setToolTip(tr("Who holds the object"));
  device_->setAccessibleName(tr("Operator"));
  seed_->setToolTip(tr("Same scenario, seed and inputs: same roadmap"));
  authority_->setObjectName(QStringLiteral("authority"));
  authority_->setToolTip(tr("Whose configuration was tried last"));

  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setLabelAlignment(Qt::AlignLeft);
  auto* strategy = new QLabel(tr("Strategy"), this);
  strategy->setBuddy(planner_);
  form->addRow(strategy);  // on a row of its own, because names of strategies are long
  form->addRow(planner_);
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
  connect(planner_, &ResearchBox::entryChosen, this,
          [this](const QString& id) { emit commanded(command::SetPlanner{id.toStdString()}); });
  connect(device_, &ResearchBox::entryChosen, this, &InteractionPanel::deviceChosen);
  connect(device_, &ResearchBox::popupDue, this, &InteractionPanel::showMissingDevices);
  connect(seed_, &SeedBox::seedChosen, this, [this](quint64 seed) { emit commanded(command::SetSeed{seed}); });
}

void InteractionPanel::showMissingDevices() {
  if (!hand_) return;
  for (const DeviceEntry& entry : devices_.entries()) {
    device_->setReason(text(entry.id), entry.connected(*hand_) ? QString() : tr("not connected"));
  }
}

void InteractionPanel::showUse() {
  const std::string strategy = planner_->chosen().toStdString();
  const std::string device = device_->chosen().toStdString();
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
  planner_->setChosen(text(snapshot.plannerId));
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
  device_->setChosen(text(deviceId));
  showMissingDevices();
  showUse();
}

}  // namespace glissade
