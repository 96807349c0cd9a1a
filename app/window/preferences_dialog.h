#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>

#include "app/window/colour_button.h"
#include "app/window/preferences.h"
#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// What a user chooses for all scenarios. Navigation is an action: the dialog sets it when it is accepted.
class PreferencesDialog final : public QDialog {
  Q_OBJECT

 public:
  PreferencesDialog(const ActionCatalogue& actions, const Preferences& present, QWidget* parent);

  Preferences preferences() const;
  void accept() override;

 private:
  void fill(const Preferences& present);
  void addColours(QFormLayout& form, const SceneColours& present);

  const ActionCatalogue& actions_;
  QComboBox* language_;
  QDoubleSpinBox* font_;
  QComboBox* theme_;
  QComboBox* navigation_;
  QComboBox* unit_;
  QSpinBox* autosave_;
  ColourButton* background_ = nullptr;
  ColourButton* path_ = nullptr;
  ColourButton* start_ = nullptr;
  ColourButton* goal_ = nullptr;
};

}  // namespace glissade
