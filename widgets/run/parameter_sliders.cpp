#include "widgets/run/parameter_sliders.h"

#include <QVBoxLayout>

namespace glissade {

ParameterSliders::ParameterSliders(const std::vector<ParameterId>& ids, QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  for (const ParameterId id : ids) {
    auto* slider = new ParameterSlider(id, this);
    connect(slider, &ParameterSlider::valueChosen, this, [this, id](double value) {
      emit commanded(command::SetParameter{id, value});
    });
    connect(slider, &ParameterSlider::tuningChosen, this, [this, id](bool tuned) { chooseTuning(id, tuned); });
    sliders_.push_back(slider);
    layout->addWidget(slider);
  }
}

void ParameterSliders::setScenario(const LoadedScenario& scenario) {
  for (ParameterSlider* slider : sliders_) {
    slider->setObjectRadius(scenario.problem.world->objectRadius());
    slider->setValue(scenario.parameters[slider->id()]);
  }
}

void ParameterSliders::setSnapshot(const SessionSnapshot& snapshot) {
  tuned_ = snapshot.parameters.integer(ParameterId::Tuning);
  for (ParameterSlider* slider : sliders_) {
    const double own = snapshot.parameters[slider->id()];
    slider->setTuned((tuned_ & tunedSetting(slider->id())) != 0, own);
    if (!slider->isBeingEdited()) slider->setValue(valueInForce(snapshot, slider->id()));
  }
}

void ParameterSliders::showOnly(const std::set<ParameterId>& ids) {
  for (ParameterSlider* slider : sliders_) slider->setVisible(ids.count(slider->id()) != 0);
}

void ParameterSliders::chooseTuning(ParameterId id, bool tuned) {
  const int bit = tunedSetting(id);
  emit commanded(command::SetParameter{ParameterId::Tuning, static_cast<double>(tuned ? tuned_ | bit : tuned_ & ~bit)});
}

}  // namespace glissade
