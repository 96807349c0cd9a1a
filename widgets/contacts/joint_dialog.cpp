#include "widgets/contacts/joint_dialog.h"

#include <QDialogButtonBox>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/contacts/joint_draft.h"
#include "widgets/contacts/joint_texts.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr double kFinest = 1e-5;  ///< metres: finest difference that fields show
constexpr int kShownBodies = 4;   ///< clamped bodies that are visible without scrolling
constexpr int kLeastWidth = 360;  ///< pixels

/// A direction that can be selected besides the proposed one and its opposite.
struct AxisDirection {
  const char* name;
  int axis;
  double sign;

  Vector3 vector() const { return sign * Vector3::Unit(axis); }
};

constexpr std::array<AxisDirection, 6> kAxes{
    {{"+X", 0, 1.0}, {"−X", 0, -1.0}, {"+Y", 1, 1.0}, {"−Y", 1, -1.0}, {"+Z", 2, 1.0}, {"−Z", 2, -1.0}}};

QString directionText(const Vector3& direction) {
  QStringList numbers;
  for (int i = 0; i < 3; ++i) {
    const double rounded = std::round(100.0 * direction[i]) / 100.0;
    numbers << QLocale().toString(rounded == 0.0 ? 0.0 : rounded);
  }
  return numbers.join(QStringLiteral("; "));
}

bool leavesAlong(JointKind kind) {
  return isScrewed(kind) || kind == JointKind::Pin || kind == JointKind::Insert || kind == JointKind::Snap;
}

void setRowShown(QFormLayout& form, QWidget* field, bool shown) {
  field->setVisible(shown);
  if (QWidget* label = form.labelForField(field)) label->setVisible(shown);
}

}  // namespace

JointDialog::JointDialog(ProductPtr product, const Joint& draft, Accept accept, QWidget* parent)
    : QDialog(parent),
      product_(std::move(product)),
      draft_(draft),
      accept_(std::move(accept)),
      kind_(addCombo("kind")),
      body_(addCombo("body")),
      clamped_(new QListWidget(this)),
      direction_(addCombo("direction")),
      diameter_(addLength("diameter", 1e-4, 1.0)),
      pitch_(addLength("pitch", 1e-5, 1.0)),
      leftHanded_(new QCheckBox(tr("Left-handed"), this)),
      engaged_(addLength("engaged", 1e-5, 10.0)),
      bend_(addLength("bend", 0.0, 1.0)),
      designation_(new QLineEdit(this)),
      form_(new QFormLayout),
      refusal_(new QLabel(this)) {
  setObjectName(QStringLiteral("joint"));
  setWindowTitle(tr("Joint"));
  bodies_.push_back(draft.body);
  bodies_.insert(bodies_.end(), draft.others.begin(), draft.others.end());
  bodies_.insert(bodies_.end(), draft.clamped.begin(), draft.clamped.end());
  std::sort(bodies_.begin(), bodies_.end());
  addKinds();
  addBodies();
  layOut();
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &JointDialog::enable);
  connect(body_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &JointDialog::draftAgain);
  showDraft();
}

QComboBox* JointDialog::addCombo(const char* name) {
  auto* combo = new QComboBox(this);
  combo->setObjectName(QLatin1String(name));
  combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  return combo;
}

QuantityBox* JointDialog::addLength(const char* name, double least, double most) {
  const LengthField field = lengthField(kFinest);
  perMetre_ = field.perMetre;
  auto* box = new QuantityBox(QuantityBox::Quantity::Length, this);
  box->setObjectName(QLatin1String(name));
  box->setUnit(1.0 / field.perMetre, field.decimals);
  box->setSuffix(QLatin1Char(' ') + field.unit);
  box->setRange(least * perMetre_, most * perMetre_);
  return box;
}

void JointDialog::addKinds() {
  for (std::size_t i = 0; i < kJointKindNames.names.size(); ++i) {
    const auto kind = static_cast<JointKind>(i);
    // A flexible joint needs only one body.
    if (bodies_.size() > 1 || kind == JointKind::Flexible) kind_->addItem(jointKindText(kind), static_cast<int>(i));
  }
  kind_->setCurrentIndex(std::max(0, kind_->findData(static_cast<int>(draft_.kind))));
}

void JointDialog::addBodies() {
  for (const std::size_t body : bodies_) {
    body_->addItem(QString::fromStdString(product_->bodies[body].shown()), static_cast<qulonglong>(body));
  }
  body_->setCurrentIndex(body_->findData(static_cast<qulonglong>(draft_.body)));
}

void JointDialog::layOut() {
  setMinimumWidth(kLeastWidth);
  clamped_->setObjectName(QStringLiteral("clamped"));
  clamped_->setAccessibleName(tr("Clamps"));
  clamped_->setFixedHeight(kShownBodies * (clamped_->fontMetrics().height() + 4));
  designation_->setObjectName(QStringLiteral("designation"));
  designation_->setPlaceholderText(QStringLiteral("ISO 4762 M3x8"));
  refusal_->setObjectName(QStringLiteral("refusal"));
  refusal_->setTextFormat(Qt::PlainText);
  refusal_->setWordWrap(true);
  form_->addRow(tr("Kind"), kind_);
  form_->addRow(tr("Removed body"), body_);
  form_->addRow(tr("Clamps"), clamped_);
  form_->addRow(tr("Removed along"), direction_);
  form_->addRow(tr("Thread diameter"), diameter_);
  form_->addRow(tr("Pitch"), pitch_);
  form_->addRow(QString(), leftHanded_);
  form_->addRow(tr("Engaged length"), engaged_);
  form_->addRow(tr("Bend of the hook"), bend_);
  form_->addRow(tr("Designation"), designation_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form_);
  layout->addWidget(refusal_);
  layout->addWidget(buttons);
}

void JointDialog::showDraft() {
  const JointThread thread = draft_.thread.value_or(JointThread{});
  diameter_->setValue(thread.diameter * perMetre_);
  pitch_->setValue(std::abs(thread.pitch) * perMetre_);
  leftHanded_->setChecked(thread.pitch < 0.0);
  engaged_->setValue(thread.engaged * perMetre_);
  bend_->setValue(draft_.bend * perMetre_);
  designation_->setText(QString::fromStdString(draft_.designation));
  showDirections();
  showClamped();
  enable();
}

void JointDialog::showDirections() {
  direction_->clear();
  direction_->addItem(tr("proposed (%1)").arg(directionText(draft_.direction)));
  direction_->addItem(tr("opposite (%1)").arg(directionText(-draft_.direction)));
  for (const AxisDirection& axis : kAxes) direction_->addItem(QString::fromUtf8(axis.name));
}

/// Bodies that are not checked hold the thread.
void JointDialog::showClamped() {
  clamped_->clear();
  for (const std::size_t body : bodies_) {
    if (body == draft_.body) continue;
    auto* item = new QListWidgetItem(QString::fromStdString(product_->bodies[body].shown()), clamped_);
    item->setData(Qt::UserRole, static_cast<qulonglong>(body));
    const bool isClamped = std::count(draft_.clamped.begin(), draft_.clamped.end(), body) > 0;
    item->setCheckState(isClamped ? Qt::Checked : Qt::Unchecked);
  }
}

/// Proposes axis and thread for another body that leaves. The kind stays as selected.
void JointDialog::draftAgain() {
  draft_ = draftJoint(*product_, bodies_, static_cast<std::size_t>(body_->currentData().toULongLong()));
  showDraft();
}

void JointDialog::enable() {
  const bool turns = isScrewed(kind());
  setRowShown(*form_, clamped_, turns && bodies_.size() > 2);
  setRowShown(*form_, direction_, leavesAlong(kind()));
  for (QWidget* field : {static_cast<QWidget*>(diameter_), static_cast<QWidget*>(pitch_),
                         static_cast<QWidget*>(leftHanded_), static_cast<QWidget*>(engaged_)}) {
    setRowShown(*form_, field, turns);
  }
  setRowShown(*form_, bend_, kind() == JointKind::Snap);
  setRowShown(*form_, designation_, turns || kind() == JointKind::Insert || kind() == JointKind::Pin);
  layout()->activate();  // gives the room of hidden fields back
  adjustSize();
}

Joint JointDialog::joint() const {
  Joint joint = draft_;
  joint.kind = kind();
  joint.others.clear();
  joint.clamped.clear();
  for (int i = 0; i < clamped_->count(); ++i) {
    const auto body = static_cast<std::size_t>(clamped_->item(i)->data(Qt::UserRole).toULongLong());
    const bool isClamped = isScrewed(joint.kind) && clamped_->item(i)->checkState() == Qt::Checked;
    (isClamped ? joint.clamped : joint.others).push_back(body);
  }
  const int direction = direction_->currentIndex();
  if (direction == 1) joint.direction = -draft_.direction;
  if (direction > 1) joint.direction = kAxes[static_cast<std::size_t>(direction - 2)].vector();
  JointThread thread = draft_.thread.value_or(JointThread{});
  thread.diameter = lengthIn(*diameter_);
  thread.pitch = lengthIn(*pitch_) * (leftHanded_->isChecked() ? -1.0 : 1.0);
  thread.engaged = lengthIn(*engaged_);
  joint.thread = thread;
  joint.bend = lengthIn(*bend_);
  joint.designation = designation_->isHidden() ? std::string() : designation_->text().trimmed().toStdString();
  return joint;
}

void JointDialog::accept() {
  const Joint given = joint();
  if (isScrewed(given.kind) && given.others.empty()) {
    refuse(tr("All other bodies are clamped. Uncheck the one that the thread is in."));
  } else if (const Outcome accepted = accept_(given); !accepted) {
    refuse(diagnosticText(accepted.error()));
  } else {
    QDialog::accept();
  }
}

void JointDialog::refuse(const QString& why) {
  refusal_->setText(why);
  // A label that wraps does not request its height.
  refusal_->setMinimumHeight(refusal_->heightForWidth(std::max(refusal_->width(), kLeastWidth / 2)));
  adjustSize();
}

}  // namespace glissade
