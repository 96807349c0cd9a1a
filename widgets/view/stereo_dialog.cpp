#include "widgets/view/stereo_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>

namespace glissade {
namespace {

constexpr double kMillimetre = 1e-3;

}  // namespace

StereoDialog::StereoDialog(const ActionCatalogue& actions, const StereoSettings& present, QWidget* parent)
    : QDialog(parent),
      mode_(new QComboBox(this)),
      swapped_(new QCheckBox(tr("&Swap the eyes"), this)),
      width_(makeLength(kLeastScreen.width, kMostScreen.width, 1.0, tr("Of the whole screen, measured with a ruler"))),
      distance_(makeLength(kLeastScreen.distance, kMostScreen.distance, 10.0, tr("From the eyes to the screen"))),
      separation_(makeLength(kLeastScreen.eyeSeparation, kMostScreen.eyeSeparation, 0.5,
                             tr("From pupil to pupil; 63 mm is the mean of adults"))),
      convergence_(new QComboBox(this)),
      display_(new QComboBox(this)),
      size_(new QLabel(this)) {
  setWindowTitle(tr("Stereo and screen"));
  setObjectName(QStringLiteral("stereo-dialog"));
  fill(actions);
  auto* form = new QFormLayout;
  form->addRow(tr("&Mode"), mode_);
  form->addRow(QString(), swapped_);
  form->addRow(tr("&Width of the screen"), width_);
  form->addRow(QString(), size_);
  form->addRow(tr("&Distance of the eyes"), distance_);
  form->addRow(tr("Separa&tion of the eyes"), separation_);
  form->addRow(tr("In the &plane of the screen"), convergence_);
  form->addRow(tr("&Full screen on"), display_);
  size_->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addStretch();
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setSettings(present);
  for (QComboBox* box : {mode_, convergence_, display_})
    connect(box, QOverload<int>::of(&QComboBox::activated), this, &StereoDialog::announce);
  for (QDoubleSpinBox* box : {width_, distance_, separation_})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &StereoDialog::announce);
  connect(swapped_, &QCheckBox::toggled, this, &StereoDialog::announce);
}

/// Makes a box for a length: metres inside, shown in millimetres.
QDoubleSpinBox* StereoDialog::makeLength(double least, double most, double step, const QString& tip) {
  auto* box = new QDoubleSpinBox(this);
  box->setRange(least / kMillimetre, most / kMillimetre);
  box->setSingleStep(step);
  box->setDecimals(1);
  box->setSuffix(tr(" mm"));
  box->setToolTip(tip);
  return box;
}

void StereoDialog::fill(const ActionCatalogue& actions) {
  for (const StereoModeEntry& entry : kStereoModes) {
    const QAction* action = actions[QLatin1String(entry.action)];
    mode_->addItem(withoutMnemonic(action->text()), static_cast<int>(entry.mode));
    mode_->setItemData(mode_->count() - 1, action->toolTip(), Qt::ToolTipRole);
    auto* items = qobject_cast<QStandardItemModel*>(mode_->model());
    items->item(mode_->count() - 1)->setEnabled(action->isEnabled());
  }
  convergence_->addItem(tr("the middle of the view"));
  convergence_->addItem(tr("the object"));
  convergence_->addItem(tr("what the pointer rests on"));
  convergence_->setToolTip(tr("What neither stands out of the screen nor lies behind it"));
  display_->addItem(tr("the display of the window"), QString());
  for (const QScreen* screen : QGuiApplication::screens()) {
    const QSize size = screen->geometry().size();
    display_->addItem(QStringLiteral("%1 (%2 × %3)").arg(screen->name()).arg(size.width()).arg(size.height()),
                      screen->name());
  }
}

void StereoDialog::setSettings(const StereoSettings& present) {
  const QSignalBlocker blocks[]{QSignalBlocker(swapped_), QSignalBlocker(width_), QSignalBlocker(distance_),
                                QSignalBlocker(separation_)};
  mode_->setCurrentIndex(mode_->findData(static_cast<int>(present.mode)));
  swapped_->setChecked(present.swapped);
  width_->setValue(present.screen.width / kMillimetre);
  distance_->setValue(present.screen.distance / kMillimetre);
  separation_->setValue(present.screen.eyeSeparation / kMillimetre);
  convergence_->setCurrentIndex(static_cast<int>(present.convergence));
  display_->setCurrentIndex(std::max(0, display_->findData(present.display)));
}

void StereoDialog::showPictureSize(const QSizeF& metres) {
  size_->setText(tr("The scene is then %L1 × %L2 mm large.")
                     .arg(metres.width() / kMillimetre, 0, 'f', 0)
                     .arg(metres.height() / kMillimetre, 0, 'f', 0));
}

StereoSettings StereoDialog::settings() const {
  return {static_cast<StereoMode>(mode_->currentData().toInt()),
          swapped_->isChecked(),
          static_cast<Convergence>(convergence_->currentIndex()),
          {width_->value() * kMillimetre, distance_->value() * kMillimetre, separation_->value() * kMillimetre},
          display_->currentData().toString()};
}

void StereoDialog::announce() { emit changed(settings()); }

}  // namespace glissade
