#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>

#include <functional>
#include <vector>

#include "engine/base/result.h"
#include "widgets/controls/quantity_box.h"
#include "widgets/document/sequence_planner.h"

namespace glissade {

/// Asks for a joint of some bodies: its kind, the body that leaves, and, if the kind needs them, direction, thread,
/// clamped bodies and bend. If the joint is refused, the dialog stays open and shows the reason.
class JointDialog final : public QDialog {
  Q_OBJECT

 public:
  using Accept = std::function<Outcome(const Joint& joint)>;
  /// `draft`: a joint of this product; a person can choose among its body, its other bodies and the bodies that it
  /// clamps.
  JointDialog(ProductPtr product, const Joint& draft, Accept accept, QWidget* parent = nullptr);

  void accept() override;

 private:
  void layOut();
  QComboBox* addCombo(const char* name);
  QuantityBox* addLength(const char* name, double least, double most);
  double lengthIn(const QuantityBox& box) const { return box.value() / perMetre_; }
  void addKinds();
  void addBodies();
  void showDraft();
  void showDirections();
  void showClamped();
  void draftAgain();
  void enable();
  JointKind kind() const { return static_cast<JointKind>(kind_->currentData().toInt()); }
  Joint joint() const;
  void refuse(const QString& why);

  ProductPtr product_;
  std::vector<std::size_t> bodies_;
  Joint draft_;
  Accept accept_;
  double perMetre_ = 1e3;  ///< the number that fields show for a metre
  QComboBox* kind_;
  QComboBox* body_;
  QListWidget* clamped_;
  QComboBox* direction_;
  QuantityBox* diameter_;
  QuantityBox* pitch_;
  QCheckBox* leftHanded_;
  QuantityBox* engaged_;
  QuantityBox* bend_;
  QLineEdit* designation_;
  QFormLayout* form_;
  QLabel* refusal_;
};

}  // namespace glissade
