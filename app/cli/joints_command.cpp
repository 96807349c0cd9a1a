#include "app/cli/commands.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "app/cli/text_cells.h"
#include "engine/files/joints_json.h"
#include "engine/files/product_file.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::array<std::string, 9>;

std::string joined(const std::vector<std::string>& texts, const char* separator) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : separator) + text;
  return all;
}

std::string shownOf(const std::vector<std::size_t>& bodies, const AssembledProduct& product) {
  std::vector<std::string> names;
  for (const std::size_t body : bodies) names.push_back(product.bodies[body].shown());
  return joined(names, ", ");
}

/// "5 mm x 0.8 mm, 9.6 mm engaged"
Message threadInWords(const JointThread& thread) {
  return {GLISSADE_TEXT("%1 x %2 mm, %3 mm engaged"),
          {rounded(1e3 * thread.diameter, 3), rounded(1e3 * thread.pitch, 3), rounded(1e3 * thread.engaged, 3)}};
}

std::string driveInWords(const Joint& joint) {
  if (joint.drive == DriveKind::None) return {};
  return std::string(kDriveNames.of(joint.drive)) +
         (joint.driveSize > 0.0 ? " " + rounded(1e3 * joint.driveSize, 3) + " mm" : "");
}

CatalogueText kindText(JointKind kind) {
  switch (kind) {
    case JointKind::Screw: return GLISSADE_TEXT("screw");
    case JointKind::Nut: return GLISSADE_TEXT("nut");
    case JointKind::Thread: return GLISSADE_TEXT("thread");
    case JointKind::Insert: return GLISSADE_TEXT("insert");
    case JointKind::Pin: return GLISSADE_TEXT("pin");
    case JointKind::Snap: return GLISSADE_TEXT("snap");
    case JointKind::Flexible: return GLISSADE_TEXT("flexible");
    case JointKind::Permanent: return GLISSADE_TEXT("permanent");
    case JointKind::Unit: break;
  }
  return GLISSADE_TEXT("unit");
}

CatalogueText stateText(JointState state) {
  switch (state) {
    case JointState::Recognised: return GLISSADE_TEXT("recognised");
    case JointState::Suggested: return GLISSADE_TEXT("suggested");
    case JointState::Confirmed: break;
  }
  return GLISSADE_TEXT("confirmed");
}

Cells cellsOf(const Joint& joint, const AssembledProduct& product, const Console& console) {
  return {console.text(kindText(joint.kind)),
          console.text(stateText(joint.state)) + (joint.isDoubtful ? " (?)" : ""),
          product.bodies[joint.body].shown(),
          shownOf(joint.others, product),
          shownOf(joint.clamped, product),
          joint.thread ? console.text(threadInWords(*joint.thread)) : "",
          joint.thread ? rounded(joint.thread->turns(), 3) : "",
          driveInWords(joint),
          console.text(joined(joint.evidence, "; "))};
}

/// The titles of the columns.
Cells titles(const Console& console) {
  constexpr std::array<CatalogueText, 9> kTitles{
      GLISSADE_TEXT("kind"),     GLISSADE_TEXT("state"),  GLISSADE_TEXT("body"),
      GLISSADE_TEXT("in or on"), GLISSADE_TEXT("clamps"), GLISSADE_TEXT("thread"),
      GLISSADE_TEXT("turns"),    GLISSADE_TEXT("drive"),  GLISSADE_TEXT("evidence")};
  Cells cells;
  std::transform(kTitles.begin(), kTitles.end(), cells.begin(),
                 [&console](const CatalogueText& title) { return console.text(title); });
  return cells;
}

std::map<std::string, int> countsOf(const Joints& joints) {
  std::map<std::string, int> counts;
  for (const Joint& joint : joints) ++counts[kJointKindNames.of(joint.kind)];
  return counts;
}

/// The number of screws in bodies that have no hole for them in the file.
auto screwHoles(const Joints& joints) {
  return std::count_if(joints.begin(), joints.end(), [](const Joint& joint) { return joint.makesHole; });
}

void printCounts(const Joints& joints, const AssembledProduct& product, const Console& console) {
  std::vector<Message> counts;
  for (const auto& [kind, count] : countsOf(joints)) {
    counts.push_back({CatalogueText{"%1 %2"}, {count, CatalogueText{kind.c_str()}}});
  }
  const Message all{GLISSADE_TEXT("%1 {1|joint|joints} of %2 {2|body|bodies}"), {joints.size(), product.bodies.size()}};
  console.print(counts.empty() ? all : Message{GLISSADE_TEXT("%1: %2"), {all, joined(counts, ", ")}});
  const auto holes = screwHoles(joints);
  const auto doubtful = std::count_if(joints.begin(), joints.end(), [](const Joint& one) { return one.isDoubtful; });
  if (holes > 0) {
    console.print({GLISSADE_TEXT("screws in bodies without a tapped hole in the file, each of which makes its own: %1"),
                   {holes}});
  }
  if (doubtful > 0) {
    console.print(
        {GLISSADE_TEXT("joints whose evidence contradicts itself, for the user to decide (?): %1"), {doubtful}});
  }
}

void printTable(const Joints& joints, const AssembledProduct& product, const Console& console) {
  std::vector<Cells> rows{titles(console)};
  for (const Joint& joint : joints) rows.push_back(cellsOf(joint, product, console));
  std::array<std::size_t, 9> widths{};
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], widthOf(row[i]));
  }
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += toLeft(row[i], widths[i] + 2);
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << "\n";
  }
  printCounts(joints, product, console);
}

void printJoints(const Joints& joints, const AssembledProduct& product) {
  Json json{{"format", "glissade-joints"}, {"version", 1}, {"joints", Json::array()}, {"counts", Json::object()}};
  for (const Joint& joint : joints) json["joints"].push_back(toJson(joint, product));
  for (const auto& [kind, count] : countsOf(joints)) json["counts"][kind] = count;
  json["screw_holes"] = screwHoles(joints);
  printJson(json);
}

}  // namespace

int runJoints(const JointsOptions& options) {
  const Interrupt interrupt;
  auto loaded = readProduct(options.file, interrupt.token(), options.deflection, {options.open, {}});
  if (!loaded) return reportError(loaded.error(), options.console);
  if (const Outcome left = leaveOut(options.without, *loaded); !left) return reportError(left.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  loaded->product.bodies = aboutTheirMiddles(std::move(loaded->product.bodies));
  const auto joints = jointsOf(*loaded, options.confirmsSuggested, interrupt.token());
  if (!joints) {
    Diagnostic why = joints.error();
    why.file = options.file;
    return reportError(why, options.console);
  }
  if (options.console.json) {
    printJoints(*joints, loaded->product);
  } else {
    printTable(*joints, loaded->product, options.console);
  }
  return 0;
}

}  // namespace glissade::cli
