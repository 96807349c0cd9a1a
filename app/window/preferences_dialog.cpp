#include "app/window/preferences_dialog.h"

#include <QColorDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/controls/colour_swatch.h"
#include "widgets/scene3d/navigation_style.h"

namespace glissade {
namespace {

QColor toQt(const Colour& colour) { return QColor::fromRgbF(colour[0], colour[1], colour[2]); }

}  // namespace

ColourButton::ColourButton(const QString& name, const std::optional<Colour>& colour, QWidget* parent)
    : QToolButton(parent), name_(name) {
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setFocusPolicy(Qt::StrongFocus);
  setColour(colour);
  connect(this, &QToolButton::clicked, this, [this] { ask(); });
}

void ColourButton::setColour(const std::optional<Colour>& colour) {
  colour_ = colour;
  setIcon(colour ? colourSwatch(toQt(*colour)) : QIcon());
  setText(colour ? toQt(*colour).name() : tr("Follow theme"));
  setAccessibleName(name_ + QStringLiteral(": ") + text());
}

void ColourButton::ask() {
  auto* dialog = new QColorDialog(colour_ ? toQt(*colour_) : QColor(Qt::gray), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(name_);
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& chosen) {
    setColour(Colour{chosen.redF(), chosen.greenF(), chosen.blueF()});
  });
  dialog->open();
}

QString languageOf(const QString& asked, const Preferences& preferences, const QString& desktop) {
  for (const QString& language : {asked, preferences.language, desktop}) {
    if (language == QLatin1String("en") || language == QLatin1String("fr")) return language;
  }
  return QStringLiteral("en");
}

PreferencesDialog::PreferencesDialog(const ActionCatalogue& actions, const Preferences& present, QWidget* parent)
    : QDialog(parent),
      actions_(actions),
      language_(new QComboBox(this)),
      font_(new QDoubleSpinBox(this)),
      theme_(new QComboBox(this)),
      navigation_(new QComboBox(this)),
      unit_(new QComboBox(this)),
      autosave_(new QSpinBox(this)) {
  setWindowTitle(tr("Preferences"));
  setObjectName(QStringLiteral("preferences"));
  fill(present);
  auto* form = new QFormLayout;
  form->addRow(tr("&Language"), language_);
  auto* next = new QLabel(tr("Another language is used from the next start on."), this);
  next->setForegroundRole(QPalette::PlaceholderText);
  form->addRow(QString(), next);
  form->addRow(tr("&Theme"), theme_);
  form->addRow(tr("Font &size"), font_);
  form->addRow(tr("L&engths"), unit_);
  form->addRow(tr("&Navigation"), navigation_);
  form->addRow(tr("Save &unsaved edits every"), autosave_);
  addColours(*form, present.colours);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addStretch();
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PreferencesDialog::fill(const Preferences& present) {
  language_->addItem(tr("Follow system"), QString());
  // Each name is in its own language, so that a person who cannot read the present language finds the other.
  language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
  language_->addItem(QStringLiteral("Français"), QStringLiteral("fr"));
  language_->setCurrentIndex(std::max(0, language_->findData(present.language)));
  font_->setRange(kLeastFontPoints, kMostFontPoints);
  font_->setSingleStep(0.5);
  font_->setDecimals(1);
  font_->setSuffix(tr(" pt"));
  font_->setValue(present.fontPoints);
  unit_->addItem(tr("Follow product"));
  unit_->setItemData(0, tr("Unit of the product's file; else millimetres, or metres in a workspace of 2 m or more"),
                     Qt::ToolTipRole);
  unit_->addItem(tr("Millimetres"), static_cast<int>(LengthUnit::Millimetres));
  unit_->addItem(tr("Inches"), static_cast<int>(LengthUnit::Inches));
  unit_->addItem(tr("Metres"), static_cast<int>(LengthUnit::Metres));
  if (present.lengthUnit) unit_->setCurrentIndex(unit_->findData(static_cast<int>(*present.lengthUnit)));
  autosave_->setRange(kLeastAutosaveSeconds, kMostAutosaveSeconds);
  autosave_->setSuffix(tr(" s"));
  autosave_->setValue(present.autosaveSeconds);
  autosave_->setToolTip(tr("What is not saved is written into the program's data folder, to be offered after a crash"));
  theme_->addItem(tr("Follow system"), static_cast<int>(ThemeChoice::Desktop));
  theme_->addItem(tr("Light"), static_cast<int>(ThemeChoice::Light));
  theme_->addItem(tr("Dark"), static_cast<int>(ThemeChoice::Dark));
  theme_->setItemData(0, tr("Light or dark, as the system was when the program started"), Qt::ToolTipRole);
  theme_->setCurrentIndex(theme_->findData(static_cast<int>(present.theme)));
  for (const NavigationStyleEntry& entry : kNavigationStyles) {
    const QAction* action = actions_[QLatin1String(entry.action)];
    navigation_->addItem(withoutMnemonic(action->text()), QLatin1String(entry.action));
    navigation_->setItemData(navigation_->count() - 1, action->statusTip(), Qt::ToolTipRole);
    if (action->isChecked()) navigation_->setCurrentIndex(navigation_->count() - 1);
  }
}

void PreferencesDialog::addColours(QFormLayout& form, const SceneColours& present) {
  const auto add = [this, &form](const QString& label, const std::optional<Colour>& colour) {
    auto* button = new ColourButton(withoutMnemonic(label), colour, this);
    form.addRow(label, button);
    return button;
  };
  background_ = add(tr("&Background of the scene"), present.background);
  path_ = add(tr("&Path and selection"), present.path);
  start_ = add(tr("Start and &its tree"), present.start);
  goal_ = add(tr("&Goal and its tree"), present.goal);
  auto* reset = new QPushButton(tr("&Reset the colours"), this);
  reset->setToolTip(tr("Use the colours of the theme again: they are distinct to people with colour blindness"));
  reset->setAutoDefault(false);
  form.addRow(QString(), reset);
  connect(reset, &QPushButton::clicked, this, [this] {
    for (ColourButton* button : {background_, path_, start_, goal_}) button->setColour(std::nullopt);
  });
}

Preferences PreferencesDialog::preferences() const {
  const QVariant unit = unit_->currentData();
  return {language_->currentData().toString(),
          font_->value(),
          unit.isValid() ? std::optional(static_cast<LengthUnit>(unit.toInt())) : std::nullopt,
          autosave_->value(),
          {background_->colour(), path_->colour(), start_->colour(), goal_->colour()},
          static_cast<ThemeChoice>(theme_->currentData().toInt())};
}

void PreferencesDialog::accept() {
  actions_[navigation_->currentData().toString()]->setChecked(true);
  QDialog::accept();
}

}  // namespace glissade
