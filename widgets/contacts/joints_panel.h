#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSet>
#include <QWidget>

#include <memory>
#include <vector>

#include "widgets/contacts/joint_table.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/name_table.h"

namespace glissade {

using JointTablePtr = std::shared_ptr<const JointTable>;

/// The joints of the product: kind, body, the bodies that it is joined with, thread, state. Joints that a person has
/// dissolved stay in the table, so that this can be undone. The table can be sorted by every column and filtered by a
/// text. Several rows can be selected at once.
class JointsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit JointsPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Sets the table. Null: not searched yet, or not valid any more. Rows of the same joints stay selected.
  void setTable(const JointTablePtr& table);
  const JointTablePtr& table() const { return table_; }
  /// The selected rows, in the order of the table.
  std::vector<const JointRow*> chosen() const;
  /// Selects only the row of this body's joint of this kind. False if there is none.
  bool choose(JointKind kind, const BodyId& body);
  /// Goes to the first row about one of these bodies, which were selected elsewhere; emits no signal.
  void showBodies(const QSet<QString>& ids);

 signals:
  void chosenChanged();
  /// A row was double-clicked, or Enter was pressed on it.
  void activated();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void layOut(const ActionCatalogue& actions);
  void addRow(std::size_t index);
  void markRow(QTreeWidgetItem& item, const JointRow& row) const;
  const JointRow& rowOf(const QTreeWidgetItem& item) const;
  void chooseKeys(const std::vector<JointKey>& keys);
  void showDetails();

  JointTablePtr table_;
  QLineEdit* filter_;
  NameTable* rows_;
  QLabel* details_;
};

}  // namespace glissade
