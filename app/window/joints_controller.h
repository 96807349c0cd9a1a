#pragma once

#include "app/window/workbench.h"
#include "widgets/panels/joints_panel.h"

namespace glissade {

/// The joints of the product that is open: found on demand in the background, shown in a panel, and edited by what a
/// person says of them. Edits are undoable and kept by the scenario; the assembly plan follows them.
class JointsController final : public QObject {
  Q_OBJECT

 public:
  explicit JointsController(const Workbench& bench);

  JointsPanel* panel() const { return panel_; }
  /// Ids of the bodies that are selected, in the order of the product.
  std::vector<std::size_t> selectedBodies() const;
  /// Makes this joint, in place of what a person said of the same one. Refused, before anything changes, where it
  /// cannot be.
  Outcome make(const Joint& joint);

 private:
  /// What was found holds for these bodies and classes.
  struct Found {
    AssembledProduct arranged;  ///< as bodiesOf() has it, to see whether it changes
    ProductPtr product;
    std::vector<std::string> classes;
    std::shared_ptr<const Joints> joints;
  };

  /// What becomes of a person's words.
  using JointChange = std::function<std::vector<JointEdit>(std::vector<JointEdit>)>;

  void connectActions();
  void followDocument(Changes what);
  bool isOfFound(Changes what) const;
  void find();
  void take(const Found& found);
  void showFound();
  void showChosen();
  void isolateChosen();
  /// Puts a word in place of what a person said of those of the chosen joints that it fits.
  void sayOfChosen(const QString& text, JointEdit::Word word, bool (*fits)(const JointRow&));
  /// As they are.
  void confirm(const QString& text, const std::vector<JointRow>& rows);
  void dissolveChosen();
  void takeChosenAsFound();
  void confirmSuggested();
  void askForNew();
  void askForChosen();
  Outcome apply(const QString& text, const JointChange& change);
  void applyOrTell(const QString& text, const JointChange& change);
  void enableActions();

  const Workbench& bench_;
  JointsPanel* panel_;
  std::optional<Found> found_;
  BackgroundTask task_;  ///< of its own: fits are looked for at the same time where bodies have moved
};

}  // namespace glissade
