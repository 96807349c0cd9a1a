#include "app/window/preferences_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/scene3d/navigation_style.h"

namespace glissade {
namespace {

QString textOf(const QAction& action) { return action.text().remove(QLatin1Char('&')); }

}  // namespace

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
      navigation_(new QComboBox(this)) {
  setWindowTitle(tr("Preferences"));
  setObjectName(QStringLiteral("preferences"));
  fill(present);
  auto* form = new QFormLayout;
  form->addRow(tr("&Language"), language_);
  auto* next = new QLabel(tr("Another language is used from the next start on."), this);
  next->setForegroundRole(QPalette::PlaceholderText);
  form->addRow(QString(), next);
  form->addRow(tr("&Theme"), theme_);
  form->addRow(tr("&Size of texts"), font_);
  form->addRow(tr("&Navigation"), navigation_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addStretch();
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PreferencesDialog::fill(const Preferences& present) {
  language_->addItem(tr("As the desktop"), QString());
  // Each in its own language, so that whoever cannot read this one finds the other.
  language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
  language_->addItem(QStringLiteral("Français"), QStringLiteral("fr"));
  language_->setCurrentIndex(std::max(0, language_->findData(present.language)));
  font_->setRange(kLeastFontPoints, kMostFontPoints);
  font_->setSingleStep(0.5);
  font_->setDecimals(1);
  font_->setSuffix(tr(" pt"));
  font_->setValue(present.fontPoints);
  theme_->addItems({tr("Light"), tr("Dark")});
  theme_->setCurrentIndex(actions_["view.dark"]->isChecked() ? 1 : 0);
  for (const NavigationStyleEntry& entry : kNavigationStyles) {
    const QAction* action = actions_[QLatin1String(entry.action)];
    navigation_->addItem(textOf(*action), QLatin1String(entry.action));
    navigation_->setItemData(navigation_->count() - 1, action->statusTip(), Qt::ToolTipRole);
    if (action->isChecked()) navigation_->setCurrentIndex(navigation_->count() - 1);
  }
}

Preferences PreferencesDialog::preferences() const { return {language_->currentData().toString(), font_->value()}; }

void PreferencesDialog::accept() {
  actions_["view.dark"]->setChecked(theme_->currentIndex() == 1);
  actions_[navigation_->currentData().toString()]->setChecked(true);
  QDialog::accept();
}

}  // namespace glissade
