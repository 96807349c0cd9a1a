#include "app/cli/commands.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/interrupt.h"
#include "engine/product/joint_edits.h"
#include "engine/product/joint_finder.h"
#include "engine/scenario/joints_json.h"
#include "engine/scenario/product_file.h"

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

std::string rounded(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

/// "5 mm x 0.8 mm, 9.6 mm engaged"
std::string threadInWords(const JointThread& thread) {
  return rounded(1e3 * thread.diameter, 3) + " x " + rounded(1e3 * thread.pitch, 3) + " mm, " +
         rounded(1e3 * thread.engaged, 3) + " mm engaged";
}

std::string driveInWords(const Joint& joint) {
  if (joint.drive == DriveKind::None) return {};
  return std::string(kDriveNames.of(joint.drive)) +
         (joint.driveSize > 0.0 ? " " + rounded(1e3 * joint.driveSize, 3) + " mm" : "");
}

Cells cellsOf(const Joint& joint, const AssembledProduct& product) {
  return {kJointKindNames.of(joint.kind),
          kJointStateNames.of(joint.state) + std::string(joint.isDoubtful ? " (?)" : ""),
          product.bodies[joint.body].shown(),
          shownOf(joint.others, product),
          shownOf(joint.clamped, product),
          joint.thread ? threadInWords(*joint.thread) : "",
          joint.thread ? rounded(joint.thread->turns(), 3) : "",
          driveInWords(joint),
          joined(joint.evidence, "; ")};
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

/// The number of UTF-8 characters, not of bytes.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void printTable(const Joints& joints, const AssembledProduct& product) {
  std::vector<Cells> rows{{"kind", "state", "body", "in or on", "clamps", "thread", "turns", "drive", "evidence"}};
  for (const Joint& joint : joints) rows.push_back(cellsOf(joint, product));
  std::array<std::size_t, 9> widths{};
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], widthOf(row[i]));
  }
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line += std::string(widths[i] - widthOf(row[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << "\n";
  }
  std::cout << joints.size() << " joints of " << product.bodies.size() << " bodies";
  const char* separator = ": ";
  for (const auto& [kind, count] : countsOf(joints)) {
    std::cout << separator << count << " " << kind;
    separator = ", ";
  }
  std::cout << "\n";
  const auto holes = screwHoles(joints);
  const auto doubtful = std::count_if(joints.begin(), joints.end(), [](const Joint& one) { return one.isDoubtful; });
  if (holes > 0)
    std::cout << "screws in bodies without a hole in the file, each of which makes its own: " << holes << "\n";
  if (doubtful > 0)
    std::cout << "joints whose evidence contradicts itself, for a person to decide (?): " << doubtful << "\n";
}

void printJoints(const Joints& joints, const AssembledProduct& product) {
  Json json{{"format", "glissade-joints"}, {"version", 1}, {"joints", Json::array()}, {"counts", Json::object()}};
  for (const Joint& joint : joints) json["joints"].push_back(toJson(joint, product));
  for (const auto& [kind, count] : countsOf(joints)) json["counts"][kind] = count;
  json["screw_holes"] = screwHoles(joints);
  printJson(json);
}

/// The joints that were found, changed as the scenario says.
Result<Joints> jointsOf(const ProductFile& loaded, bool confirmsSuggested, const StopToken& stop) {
  Joints found = findJoints(loaded.product, stop, loaded.classes);
  if (stop.stopRequested()) return Diagnostic{ErrorKind::Interrupted, "", "", "was interrupted", ""};
  auto joints = applied(std::move(found), loaded.joints, loaded.product);
  if (!joints || !confirmsSuggested) return joints;
  const auto confirmations = confirmationsOf(*joints, loaded.product);
  return applied(std::move(*joints), confirmations, loaded.product);
}

}  // namespace

int runJoints(const JointsOptions& options) {
  const Interrupt interrupt;
  auto loaded = readProduct(options.file, interrupt.token(), options.deflection, {options.open, {}});
  if (!loaded) return reportError(loaded.error(), options.format);
  if (const Outcome left = leaveOut(options.without, *loaded); !left) return reportError(left.error(), options.format);
  reportWarnings(loaded->warnings);
  loaded->product.bodies = aboutTheirMiddles(std::move(loaded->product.bodies));
  const auto joints = jointsOf(*loaded, options.confirmsSuggested, interrupt.token());
  if (!joints) {
    Diagnostic why = joints.error();
    why.file = options.file;
    return reportError(why, options.format);
  }
  if (options.format == Format::Json) {
    printJoints(*joints, loaded->product);
  } else {
    printTable(*joints, loaded->product);
  }
  return 0;
}

}  // namespace glissade::cli
