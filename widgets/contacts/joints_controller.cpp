#include "widgets/contacts/joints_controller.h"

#include <algorithm>

#include "engine/files/product_file.h"
#include "engine/files/scenario_fits.h"
#include "engine/files/sequence_knowledge.h"
#include "widgets/contacts/joint_dialog.h"
#include "widgets/contacts/joint_draft.h"
#include "widgets/controls/body_id_text.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

Result<JointKind> kindIn(const std::string& word) {
  const auto kind = kJointKindNames.find(word);
  if (kind) return *kind;
  return wrongCommand("'" + word + "' is no kind of joint", "Say one of: " + kJointKindNames.listed() + ".");
}

/// The number of joints of this kind in the panel that count.
std::size_t countOf(const JointsPanel& panel, JointKind kind) {
  if (!panel.table()) return 0;
  const std::vector<JointRow>& rows = panel.table()->rows();
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [kind](const JointRow& row) { return row.counts() && row.key.kind == kind; }));
}

/// The state of the joint of a body; "none" if there is no such row.
std::string stateOf(const JointsPanel& panel, JointKind kind, const BodyId& body) {
  if (!panel.table()) return "none";
  for (const JointRow& row : panel.table()->rows()) {
    if (row.key.kind == kind && row.key.body == body) return kJointRowStateNames.of(row.state);
  }
  return "none";
}

/// Adds the script commands about joints. `joints` outlives the commands.
void addJointCommands(const Workbench& bench, JointsController& joints) {
  ScriptCommands& scripts = bench.scripts;
  JointsPanel& panel = *joints.panel();
  scripts.add("select-joint", 2, [&panel](const Words& words) -> Outcome {
    const auto kind = kindIn(words[0]);
    if (!kind) return kind.error();
    if (panel.choose(*kind, BodyId(words[1]))) return Done{};
    return wrongCommand("there is no " + words[0] + " of '" + words[1] + "'", "Find the joints first.");
  });
  scripts.add("make-joint", 1, [&joints](const Words& words) -> Outcome {
    const auto kind = kindIn(words[0]);
    if (!kind) return kind.error();
    const std::vector<std::size_t> bodies = joints.selectedBodies();
    if (bodies.empty()) return wrongCommand("no body is selected", "Find the joints, then select bodies.");
    Joint draft = draftJoint(joints.panel()->table()->product(), bodies);
    draft.kind = *kind;
    return joints.make(draft);
  });
  scripts.add("expect-joints", 2, [&panel](const Words& words) -> Outcome {
    const auto kind = kindIn(words[0]);
    if (!kind) return kind.error();
    const std::string number = std::to_string(countOf(panel, *kind));
    if (number == words[1]) return Done{};
    return unmetExpectation("there are " + number + " joints of the kind " + words[0] + ", not " + words[1]);
  });
  scripts.add("expect-joint", 3, [&panel](const Words& words) -> Outcome {
    const auto kind = kindIn(words[0]);
    if (!kind) return kind.error();
    const std::string state = stateOf(panel, *kind, BodyId(words[1]));
    if (state == words[2]) return Done{};
    return unmetExpectation("the " + words[0] + " of '" + words[1] + "' is " + state + ", not " + words[2]);
  });
}

bool canBeConfirmed(const JointRow& row) {
  return row.isFound && row.state != JointRowState::Confirmed && row.state != JointRowState::Refused;
}

bool canBePressedOut(const JointRow& row) {
  return row.key.kind == JointKind::Insert && row.isFound && row.counts() && row.state != JointRowState::PressedOut;
}

bool canBeOpened(const JointRow& row) { return row.key.kind == JointKind::Unit && row.isFound && row.counts(); }

bool counts(const JointRow& row) { return row.counts(); }

bool isStated(const JointRow& row) { return row.isStated(); }

/// The chosen rows as copies, because the table changes with the edit.
std::vector<JointRow> chosenIn(const JointsPanel& panel, bool (*fits)(const JointRow&)) {
  std::vector<JointRow> rows;
  for (const JointRow* row : panel.chosen()) {
    if (fits(*row)) rows.push_back(*row);
  }
  return rows;
}

bool isAnyChosen(const JointsPanel& panel, bool (*fits)(const JointRow&)) { return !chosenIn(panel, fits).empty(); }

/// Whether the bodies are the same. Edits of fits do not matter, because joints do not depend on them.
bool haveSameBodies(AssembledProduct one, const AssembledProduct& other) {
  one.fits = other.fits;
  return isSameProduct(one, other);
}

/// The reason why one more edit is refused after the change; nothing if none is.
std::optional<Diagnostic> newRefusal(const JointTable& before, const JointTable& after) {
  if (after.count(JointRowState::Refused) <= before.count(JointRowState::Refused)) return std::nullopt;
  return after.rows().back().refusal;
}

}  // namespace

JointsController::JointsController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), panel_(new JointsPanel(bench.actions, &bench.window)) {
  connect(panel_, &JointsPanel::chosenChanged, this, &JointsController::showChosen);
  connect(panel_, &JointsPanel::activated, this, &JointsController::isolateChosen);
  connect(&bench.document, &WorkbenchDocument::changed, this, &JointsController::followDocument);
  connect(&bench.document.semantics(), &SemanticDocument::selectionChanged, this, [this] {
    panel_->showBodies(bench_.document.semantics().selectedBodies());
    enableActions();
  });
  connect(&task_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  bench.work.show(
      task_, [] { return tr("Looking for joints"); }, [this] { task_.cancel(); });
  connectActions();
  enableActions();
  addJointCommands(bench, *this);
}

void JointsController::connectActions() {
  bench_.onAction("joints.find", this, [this] {
    bench_.actions["panel.joints"]->trigger();
    find();
  });
  bench_.onAction("joints.isolate", this, [this] { isolateChosen(); });
  bench_.onAction("joints.confirm", this, [this] { confirm(tr("confirm joints"), chosenIn(*panel_, canBeConfirmed)); });
  bench_.onAction("joints.confirm-all", this, [this] { confirmSuggested(); });
  bench_.onAction("joints.dissolve", this, [this] { dissolveChosen(); });
  bench_.onAction("joints.press-out", this,
                  [this] { stateForChosen(tr("press inserts out"), JointEdit::Word::PressedOut, canBePressedOut); });
  bench_.onAction("joints.open", this,
                  [this] { stateForChosen(tr("open units"), JointEdit::Word::Opened, canBeOpened); });
  bench_.onAction("joints.as-found", this, [this] { takeChosenAsFound(); });
  bench_.onAction("joints.make", this, [this] { askForNew(); });
  bench_.onAction("joints.change", this, [this] { askForChosen(); });
}

/// Removes the found joints after another scenario. Finds them again if bodies or classes have changed.
void JointsController::followDocument(Changes what) {
  if (what & Change::Scenario) {
    task_.cancel();
    found_.reset();
    panel_->setTable(nullptr);
  } else if (found_ && (what & (Change::Arrangement | Change::Semantics | Change::Joints))) {
    if (isOfFoundJoints(what)) {
      if (what & (Change::Arrangement | Change::Joints)) showFound();
    } else {
      found_.reset();
      panel_->setTable(nullptr);
      find();
    }
  }
  enableActions();
}

bool JointsController::isOfFoundJoints(Changes what) const {
  if (classesOf(*bench_.document.edits(), found_->product->bodies) != found_->classes) return false;
  return !(what & Change::Arrangement) || haveSameBodies(bodiesOf(*bench_.document.scenario()), found_->arranged);
}

void JointsController::find() {
  const ScenarioPtr scenario = bench_.document.scenario();
  if (!scenario) return;
  const auto edits = bench_.document.edits();
  const auto work = [this, scenario, edits,
                     finder = bench_.finder](const WorkWatch& watch) -> BackgroundTask::Delivery {
    Found found{bodiesOf(*scenario), std::make_shared<const AssembledProduct>(productOf(*scenario)), {}, {}};
    found.classes = classesOf(*edits, found.product->bodies);
    found.joints = finder->joints(*found.product, found.classes, watch.stop);
    if (!found.joints) return [] {};
    return [this, found = std::move(found)] { take(found); };
  };
  task_.start(GLISSADE_TEXT("looking for joints"), work, bench_.work.isAtOnce());
}

/// Takes the found joints, unless bodies have moved during the search.
void JointsController::take(const Found& found) {
  found_ = found;
  if (isOfFoundJoints(Change::Arrangement)) {
    showFound();
    enableActions();
  } else {
    found_.reset();
    find();
  }
}

void JointsController::showFound() {
  const std::vector<JointEdit>& said = bench_.document.scenario()->scenario.joints;
  panel_->setTable(std::make_shared<const JointTable>(found_->product, found_->joints, said));
}

/// Selects all bodies of the chosen joints, so that the view and the tree mark them.
void JointsController::showChosen() {
  enableActions();
  SemanticSelection selection;
  for (const JointRow* row : panel_->chosen()) {
    const AssembledProduct& product = panel_->table()->product();
    selection.bodies.insert(toQString(row->key.body));
    for (const BodyId& id : row->key.others) selection.bodies.insert(toQString(id));
    for (const std::size_t body : row->joint.clamped) {
      selection.bodies.insert(toQString(product.bodies[body].id));
    }
  }
  if (!selection.bodies.isEmpty()) bench_.document.semantics().select(selection);
}

void JointsController::isolateChosen() {
  if (panel_->chosen().empty()) return;
  showChosen();
  if (bench_.actions["body.isolate"]->isEnabled()) bench_.actions["body.isolate"]->trigger();
}

void JointsController::stateForChosen(const QString& text, JointEdit::Word word, bool (*fits)(const JointRow&)) {
  applyOrReport(text, [rows = chosenIn(*panel_, fits), word](std::vector<JointEdit> said) {
    for (const JointRow& row : rows) said = withEdit(std::move(said), {row.key, word});
    return said;
  });
}

void JointsController::confirm(const QString& text, const std::vector<JointRow>& rows) {
  if (!panel_->table()) return;
  std::vector<JointEdit> words;
  for (const JointRow& row : rows) words.push_back(confirmationOf(row.joint, panel_->table()->product()));
  applyOrReport(text, [words](std::vector<JointEdit> said) {
    for (const JointEdit& word : words) said = withEdit(std::move(said), word);
    return said;
  });
}

void JointsController::dissolveChosen() {
  applyOrReport(tr("dissolve joints"), [rows = chosenIn(*panel_, counts)](std::vector<JointEdit> said) {
    for (const JointRow& row : rows) said = withoutJoint(std::move(said), row);
    return said;
  });
}

void JointsController::takeChosenAsFound() {
  applyOrReport(tr("take joints as found"), [rows = chosenIn(*panel_, isStated)](std::vector<JointEdit> said) {
    for (const JointRow& row : rows) said = withoutEdit(std::move(said), row.key);
    return said;
  });
}

void JointsController::confirmSuggested() {
  if (!panel_->table()) return;
  std::vector<JointRow> suggested;
  for (const JointRow& row : panel_->table()->rows()) {
    if (row.state == JointRowState::Suggested) suggested.push_back(row);
  }
  confirm(tr("confirm all suggested joints"), suggested);
}

std::vector<std::size_t> JointsController::selectedBodies() const {
  std::vector<std::size_t> bodies;
  if (!panel_->table()) return bodies;
  for (const QString& id : bench_.document.semantics().selectedBodies()) {
    if (const auto body = panel_->table()->product().find(toBodyId(id))) bodies.push_back(*body);
  }
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

Outcome JointsController::make(const Joint& joint) {
  const JointEdit word = editForJoint(joint, panel_->table()->product());
  return apply(tr("make a joint"), [word](std::vector<JointEdit> said) { return withEdit(std::move(said), word); });
}

void JointsController::askForNew() {
  const std::vector<std::size_t> bodies = selectedBodies();
  if (bodies.empty()) return;
  const ProductPtr product = found_->product;
  JointDialog dialog(
      product, draftJoint(*product, bodies), [this](const Joint& joint) { return make(joint); }, &bench_.window);
  dialog.exec();
}

/// Asks for changes of the chosen joint. If its kind or its bodies change, the earlier joint is dissolved.
void JointsController::askForChosen() {
  const std::vector<JointRow> rows = chosenIn(*panel_, counts);
  if (rows.size() != 1) return;
  const ProductPtr product = found_->product;
  const auto accept = [this, product, row = rows.front()](const Joint& joint) {
    const JointEdit word = editForJoint(joint, *product);
    return apply(tr("change a joint"), [word, row](std::vector<JointEdit> said) {
      if (!isSameJoint(word.key, row.key)) said = withoutJoint(std::move(said), row);
      return withEdit(std::move(said), word);
    });
  };
  JointDialog dialog(product, rows.front().joint, accept, &bench_.window);
  dialog.exec();
}

/// Applies a change of the edits. If it makes an edit invalid, nothing changes and the error says why.
Outcome JointsController::apply(const QString& text, const JointChange& change) {
  const JointTablePtr table = panel_->table();
  if (!table) return Done{};
  const std::vector<JointEdit> said = change(table->said());
  if (said == table->said()) return Done{};
  if (const auto why = newRefusal(*table, table->with(said))) return *why;
  bench_.document.setJoints(text, said);
  return Done{};
}

void JointsController::applyOrReport(const QString& text, const JointChange& change) {
  if (const Outcome applied = apply(text, change); !applied) {
    bench_.messages.showError(tr("The joint cannot be changed"), applied.error());
  }
}

void JointsController::enableActions() {
  const JointTablePtr& table = panel_->table();
  bench_.enable("joints.find", bench_.document.scenario() != nullptr);
  bench_.enable("joints.isolate", !panel_->chosen().empty());
  bench_.enable("joints.confirm", isAnyChosen(*panel_, canBeConfirmed));
  bench_.enable("joints.confirm-all", table && table->count(JointRowState::Suggested) > 0);
  bench_.enable("joints.dissolve", isAnyChosen(*panel_, counts));
  bench_.enable("joints.press-out", isAnyChosen(*panel_, canBePressedOut));
  bench_.enable("joints.open", isAnyChosen(*panel_, canBeOpened));
  bench_.enable("joints.as-found", isAnyChosen(*panel_, isStated));
  bench_.enable("joints.change", chosenIn(*panel_, counts).size() == 1);
  bench_.enable("joints.make", !selectedBodies().empty());
}

}  // namespace glissade
