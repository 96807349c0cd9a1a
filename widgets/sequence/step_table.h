#pragma once

#include <QTreeWidget>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/access/plan_access.h"
#include "engine/documents/plan_words.h"
#include "engine/sequence/step_view.h"
#include "widgets/document/sequence_planner.h"

namespace glissade {

using PlanAccessPtr = std::shared_ptr<const PlanAccess>;

/// An assembly plan, with everything that the panel shows of it.
struct ShownPlan {
  ProductPtr product;  ///< null: there is no product
  PlanPtr plan;        ///< null: not planned yet
  bool growing = false;
  std::map<BodyId, double> foundAfter;  ///< see GrownPlan; without motions that were not found here
  PlanCheck check{};                    ///< result of the independent check
  PlanAccessPtr access{};               ///< access of a hand to each step; null: not analysed
  PlanPtr before{};                     ///< the earlier plan, which is shown grey while `plan` grows; null: none
  std::vector<HeldByBase> held{};       ///< why bodies stay with the base; empty: none does, or it is not known
  bool isWaiting = false;               ///< planning begins once the edits have settled
  std::vector<Viewpoint> views{};       ///< how the product lies in each step; empty: not known
};

/// Steps of an assembly plan, two lines for each row, and stuck parts with the whole reason. Steps can be dragged to
/// another row.
class StepTable final : public QTreeWidget {
  Q_OBJECT

 public:
  using IconOf = std::function<QIcon(const RigidBody&)>;

  StepTable(IconOf iconOf, QWidget* parent);

  void show(const ShownPlan& shown, PlanOrder order);
  /// Takes pictures that were drawn meanwhile.
  void takeIcons();
  /// The step (its index in the plan), or the stuck part (its id), of a row.
  static std::optional<std::size_t> stepOf(const QTreeWidgetItem* row);
  static BodyId stuckOf(const QTreeWidgetItem* row);
  QTreeWidgetItem* rowOf(std::size_t step) const;
  /// The texts of all columns of the step's row; empty if there is none.
  QString textOf(std::size_t step) const;
  /// The steps of the selected rows, in the order of removal.
  std::vector<std::size_t> selectedSteps() const;
  /// The current row was dropped at this place.
  void dropAt(const QPoint& place);
  QString nameOf(const BodyId& id) const;
  QString shortNames(const std::vector<BodyId>& ids) const;

 signals:
  /// A person has dragged a step to the place of another one; indices in the plan.
  void stepDragged(int from, int to);

 protected:
  void changeEvent(QEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addStep(std::size_t place);
  QString turnBefore(std::size_t place) const;
  void showSupport(QTreeWidgetItem& row, const AssemblyStep& step) const;
  void showGaps(QTreeWidgetItem& row, std::size_t step) const;
  double foundAfter(const AssemblyStep& step) const;
  void addStuck(const StuckBody& stuck);
  void addEarlier(std::size_t step);
  void fitColumns();
  void wrapTexts();
  QStringList unreachedInside(std::size_t step) const;
  void addUnreached(const SubassemblyLine& line, const LineAccess& access, QStringList& texts) const;
  void setIcon(QTreeWidgetItem& row, const BodyId& bodyId);
  QString allNames(const std::vector<BodyId>& ids) const;

  IconOf iconOf_;
  ShownPlan shown_;
  PlanOrder order_ = PlanOrder::Assembly;
};

/// The words for plans in the language of the window.
PlanWords windowPlanWords();

}  // namespace glissade
