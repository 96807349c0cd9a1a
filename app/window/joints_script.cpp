#include "app/window/joints_script.h"

#include <algorithm>

#include "app/window/joints_controller.h"
#include "widgets/panels/joint_draft.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

Result<JointKind> kindIn(const std::string& word) {
  const auto kind = jointByName(word);
  if (kind) return *kind;
  return wrongCommand("'" + word + "' is no kind of joint",
                      "Say screw, nut, thread, insert, pin, snap, flexible, permanent or unit.");
}

/// Those that count, of this kind as the panel shows it.
std::size_t countOf(const JointsPanel& panel, JointKind kind) {
  if (!panel.table()) return 0;
  const std::vector<JointRow>& rows = panel.table()->rows();
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [kind](const JointRow& row) { return row.counts() && row.key.kind == kind; }));
}

/// "none": there is no row of the body.
std::string stateOf(const JointsPanel& panel, JointKind kind, const std::string& body) {
  if (!panel.table()) return "none";
  for (const JointRow& row : panel.table()->rows()) {
    if (row.key.kind == kind && row.key.body == body) return jointRowStateName(row.state);
  }
  return "none";
}

}  // namespace

void addJointCommands(const Workbench& bench, JointsController& joints) {
  ScriptCommands& scripts = bench.scripts;
  JointsPanel& panel = *joints.panel();
  scripts.add("select-joint", 2, [&panel](const Words& words) -> Outcome {
    const auto kind = kindIn(words[0]);
    if (!kind) return kind.error();
    if (panel.choose(*kind, words[1])) return Done{};
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
    const std::string state = stateOf(panel, *kind, words[1]);
    if (state == words[2]) return Done{};
    return unmetExpectation("the " + words[0] + " of '" + words[1] + "' is " + state + ", not " + words[2]);
  });
}

}  // namespace glissade
