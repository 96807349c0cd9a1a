#include "widgets/panels/interaction_panel.h"

#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "engine/operator/device_registry.h"

namespace glissade {
namespace {

QString text(const std::string& value) { return QString::fromStdString(value); }

void select(QComboBox& box, const std::string& id) {
  const QSignalBlocker block(box);
  box.setCurrentIndex(box.findData(text(id)));
}

QComboBox* makeBox(QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

}  // namespace

InteractionPanel::InteractionPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      planner_(makeBox(this)),
      device_(makeBox(this)),
      seed_(new SeedBox(this)),
      authority_(new QLabel(this)),
      replayed_(new QLabel(tr("Replayed: as it was at this step"), this)) {
  const PlannerRegistry planners = makePlannerRegistry();
  for (const PlannerEntry& entry : planners.entries()) {
    planner_->addItem(QCoreApplication::translate("Planners", entry.label.c_str()), text(entry.id));
    planner_->setItemData(planner_->count() - 1, text(entry.description), Qt::ToolTipRole);
  }
  const DeviceRegistry devices = makeDeviceRegistry();
  for (const DeviceEntry& entry : devices.entries()) {
    device_->addItem(QCoreApplication::translate("Devices", entry.label.c_str()), text(entry.id));
    device_->setItemData(device_->count() - 1, text(entry.description), Qt::ToolTipRole);
  }
  planner_->setToolTip(tr("The strategy of the next run"));
  device_->setToolTip(tr("Who holds the object"));
  seed_->setToolTip(tr("Same scenario, seed and inputs: same roadmap"));
  authority_->setObjectName(QStringLiteral("authority"));
  authority_->setToolTip(tr("Whose configuration was tried last"));

  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(tr("Strategy"), planner_);
  form->addRow(tr("Operator"), device_);
  form->addRow(tr("Seed"), seed_);
  form->addRow(tr("Authority now"), authority_);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(10);
  layout->addWidget(makeButtons(actions));
  layout->addLayout(form);
  replayed_->setObjectName(QStringLiteral("replayed"));
  replayed_->setStyleSheet(QStringLiteral("QLabel { background: #b3500a; color: white; padding: 2px 6px; }"));
  replayed_->hide();
  layout->addWidget(replayed_);
  for (const ParameterSpec& spec : parameterTable()) {
    if (!spec.live || spec.id == ParameterId::Tuning) continue;  // the sliders' own buttons
    auto* slider = new ParameterSlider(spec.id, this);
    connect(slider, &ParameterSlider::valueChosen, this, [this, id = spec.id](double value) {
      emit commanded(command::SetParameter{id, value});
    });
    connect(slider, &ParameterSlider::tuningChosen, this,
            [this, id = spec.id](bool tuned) { chooseTuning(id, tuned); });
    sliders_.push_back(slider);
    layout->addWidget(slider);
  }
  layout->addStretch();
  connect(planner_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit commanded(command::SetPlanner{planner_->currentData().toString().toStdString()}); });
  connect(device_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit deviceChosen(device_->currentData().toString()); });
  connect(seed_, &SeedBox::seedChosen, this, [this](quint64 seed) { emit commanded(command::SetSeed{seed}); });
}

QWidget* InteractionPanel::makeButtons(const ActionCatalogue& actions) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const char* id : {"run.start", "run.pause", "run.stop"}) {
    auto* button = new QToolButton(row);
    button->setDefaultAction(actions[QLatin1String(id)]);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(button);
  }
  return row;
}

void InteractionPanel::setScenario(const LoadedScenario& scenario) {
  for (ParameterSlider* slider : sliders_) {
    slider->setObjectRadius(scenario.problem.world->objectRadius());
    slider->setValue(scenario.parameters[slider->id()]);
  }
}

void InteractionPanel::setSnapshot(const SessionSnapshot& snapshot) {
  select(*planner_, snapshot.plannerId);
  if (!seed_->hasFocus()) seed_->setSeed(snapshot.seed);
  tuned_ = snapshot.parameters.integer(ParameterId::Tuning);
  for (ParameterSlider* slider : sliders_) {
    const double own = snapshot.parameters[slider->id()];
    slider->setTuned((tuned_ & tunedSetting(slider->id())) != 0, own);
    if (!slider->isBeingEdited()) slider->setValue(valueInForce(snapshot, slider->id()));
  }
  if (snapshot.state != SessionState::Planning) {
    authority_->setText(QStringLiteral("–"));
  } else if (snapshot.authority == Author::Computer) {
    authority_->setText(tr("computer"));
  } else {
    authority_->setText(snapshot.authority == Author::Operator ? tr("operator") : tr("operator, in contact"));
  }
}

void InteractionPanel::chooseTuning(ParameterId id, bool tuned) {
  const int bit = tunedSetting(id);
  emit commanded(command::SetParameter{ParameterId::Tuning, static_cast<double>(tuned ? tuned_ | bit : tuned_ & ~bit)});
}

void InteractionPanel::setReplayed(bool replayed) {
  replayed_->setVisible(replayed);
  for (ParameterSlider* slider : sliders_) slider->setEnabled(!replayed);
  planner_->setEnabled(!replayed);
  device_->setEnabled(!replayed);
  seed_->setEnabled(!replayed);
}

void InteractionPanel::setDevice(const std::string& deviceId) { select(*device_, deviceId); }

}  // namespace glissade
