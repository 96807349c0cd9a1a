#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QToolButton>

#include <optional>

#include "engine/places/rigid_body.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/workbench/preferences.h"

namespace glissade {

/// A button that shows the chosen colour, or that none is chosen, and asks for another one.
class ColourButton final : public QToolButton {
  Q_OBJECT

 public:
  ColourButton(const QString& name, const std::optional<Colour>& colour, QWidget* parent);

  /// Without a value the theme's colour is used.
  const std::optional<Colour>& colour() const { return colour_; }
  void setColour(const std::optional<Colour>& colour);

 private:
  void ask();

  QString name_;
  std::optional<Colour> colour_;
};

/// A user's choices for all scenarios. Navigation is an action, which the dialog sets when it is accepted.
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
