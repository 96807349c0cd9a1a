#pragma once

#include "widgets/contacts/joints_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The joints of the open product: found on demand in the background, shown in a panel, and edited by a person. Edits
/// are undoable and kept in the scenario; the assembly plan follows them.
class JointsController final : public QObject {
  Q_OBJECT

 public:
  explicit JointsController(const Workbench& bench);

  JointsPanel* panel() const { return panel_; }
  /// Indices of the selected bodies, in the order of the product.
  std::vector<std::size_t> selectedBodies() const;
  /// Makes this joint and replaces the person's earlier edit of it. If the joint is impossible, nothing changes and the
  /// error says why.
  Outcome make(const Joint& joint);

 private:
  /// The joints that were found, with the bodies and classes for which they hold.
  struct Found {
    AssembledProduct arranged;  ///< from bodiesOf(); compared to detect changes
    ProductPtr product;
    std::vector<std::string> classes;
    JointsPtr joints;
  };

  /// A change of the person's edits.
  using JointChange = std::function<std::vector<JointEdit>(std::vector<JointEdit>)>;

  void connectActions();
  void followDocument(Changes what);
  bool isOfFoundJoints(Changes what) const;
  void find();
  void take(const Found& found);
  void showFound();
  void showChosen();
  void isolateChosen();
  /// Replaces the person's edit of each chosen joint for which `fits` is true.
  void stateForChosen(const QString& text, JointEdit::Word word, bool (*fits)(const JointRow&));
  /// Confirms joints as they are.
  void confirm(const QString& text, const std::vector<JointRow>& rows);
  void dissolveChosen();
  void takeChosenAsFound();
  void confirmSuggested();
  void askForNew();
  void askForChosen();
  Outcome apply(const QString& text, const JointChange& change);
  void applyOrReport(const QString& text, const JointChange& change);
  void enableActions();

  const Workbench& bench_;
  JointsPanel* panel_;
  std::optional<Found> found_;
  BackgroundTask
      task_;  ///< separate from the window's task, because fits may be searched at the same time after bodies moved
};

}  // namespace glissade
