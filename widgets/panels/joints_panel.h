#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSet>
#include <QWidget>

#include <memory>
#include <vector>

#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/joint_table.h"
#include "widgets/panels/name_table.h"

namespace glissade {

using JointTablePtr = std::shared_ptr<const JointTable>;

/// The joints of the product: kind, body, what it is joined with, thread, who says so. Joints that a person has
/// dissolved stay in the table, so that this can be taken back. The table can be sorted by every column and filtered by
/// a text. Several rows can be chosen at once.
class JointsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit JointsPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Null: not looked for yet, or not any more. Rows of the same joints stay chosen.
  void setTable(const JointTablePtr& table);
  const JointTablePtr& table() const { return table_; }
  /// The chosen rows, in the order of the table.
  std::vector<const JointRow*> chosen() const;
  /// Makes the row of this body's joint of this kind the only chosen one. False: there is none.
  bool choose(JointKind kind, const std::string& body);
  /// Goes to the first row about one of these bodies, which were chosen elsewhere; emits nothing about it.
  void showBodies(const QSet<QString>& ids);

 signals:
  void chosenChanged();
  /// Double click or Enter on a row.
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
