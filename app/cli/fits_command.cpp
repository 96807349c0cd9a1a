#include "app/cli/fits_command.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/base/number_text.h"
#include "engine/scenario/part_files.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;
using Bodies = std::vector<ContactBody>;

Result<Bodies> bodiesOfParts(const std::string& file, const StopToken& stop) {
  GeometryCache read;
  const auto geometry = readPart(usualPart(file), read, stop);
  if (!geometry) return geometry.error();
  Bodies bodies;
  for (const GeometryPart& part : (*geometry)->parts) {
    bodies.push_back({part.name.empty() ? file : part.name, part.mesh, part.X_BP, part.deflection});
  }
  return bodies;
}

/// The obstacles, and the object at its start.
Result<Bodies> bodiesOfScenario(const std::string& file, const StopToken& stop) {
  const auto loaded = loadScenario(file, stop);
  if (!loaded) return loaded.error();
  reportWarnings(loaded->warnings);
  const auto deflectionOf = [&](const std::string& id) {
    const auto known = loaded->deflections.find(id);
    return known == loaded->deflections.end() ? 0.0 : known->second;
  };
  Bodies bodies;
  for (const RigidBody& body : loaded->obstacles) {
    bodies.push_back({body.id, body.mesh, body.X_WB, deflectionOf(body.id)});
  }
  bodies.push_back({loaded->object.id, loaded->object.mesh, loaded->object.X_WB, deflectionOf(loaded->object.id)});
  return bodies;
}

const char* statusOf(const Contact& contact) {
  if (contact.kind == ContactKind::Clearance) return "clear";
  return contact.kind == ContactKind::Clash ? "clash" : "allowed";
}

std::map<std::string, int> countsOf(const ContactReport& report) {
  std::map<std::string, int> counts;
  for (const Contact& contact : report.contacts) ++counts[kindName(contact.kind)];
  return counts;
}

Json coordinates(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json toJson(const Contact& contact, const Bodies& bodies) {
  Json json{{"a", bodies[contact.a].id},
            {"b", bodies[contact.b].id},
            {"kind", kindName(contact.kind)},
            {"gap_m", contact.gap},
            {"overlap_m", contact.overlap},
            {"uncertainty_m", contact.uncertainty},
            {"allowance_m", usualAllowance(contact)},
            {"status", statusOf(contact)}};
  if (contact.axis) {
    json["axis"] = {{"point", coordinates(contact.axis->point)},
                    {"direction", coordinates(contact.axis->direction)},
                    {"radius_a", contact.axis->radiusA},
                    {"radius_b", contact.axis->radiusB}};
  }
  return json;
}

void printJson(const ContactReport& report, const Bodies& bodies) {
  Json json{{"pairs", Json::array()}, {"counts", Json::object()}};
  for (const Contact& contact : report.contacts) json["pairs"].push_back(toJson(contact, bodies));
  for (const auto& [kind, count] : countsOf(report)) json["counts"][kind] = count;
  // Names come from files.
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

void printCsv(const ContactReport& report, const Bodies& bodies) {
  std::cout << "a,b,kind,gap_m,overlap_m,uncertainty_m,allowance_m,status\n";
  for (const Contact& contact : report.contacts) {
    std::cout << quoted(bodies[contact.a].id) << "," << quoted(bodies[contact.b].id) << "," << kindName(contact.kind)
              << "," << toText(contact.gap) << "," << toText(contact.overlap) << "," << toText(contact.uncertainty)
              << "," << toText(usualAllowance(contact)) << "," << statusOf(contact) << "\n";
  }
}

void printTable(const ContactReport& report, const Bodies& bodies) {
  std::size_t width = 1;
  for (const Contact& contact : report.contacts) width = std::max(width, bodies[contact.a].id.size());
  std::cout << std::left << std::fixed << std::setprecision(3);
  for (const Contact& contact : report.contacts) {
    const bool overlaps = contact.overlap > 0.0;
    std::cout << std::setw(12) << kindName(contact.kind) << (overlaps ? "overlap " : "gap     ") << std::right
              << std::setw(8) << 1e3 * (overlaps ? contact.overlap : contact.gap) << " mm";
    if (contact.uncertainty > 0.0) {
      std::cout << " +- " << 1e3 * contact.uncertainty;
    } else {
      std::cout << "         ";
    }
    std::cout << "  " << std::left << std::setw(static_cast<int>(width)) << bodies[contact.a].id << "  "
              << bodies[contact.b].id << "\n";
  }
  std::cout << report.contacts.size() << " pairs of " << bodies.size() << " bodies";
  const char* separator = ": ";
  for (const auto& [kind, count] : countsOf(report)) {
    std::cout << separator << count << " " << kind;
    separator = ", ";
  }
  std::cout << "\n";
}

Outcome checkLimits(const ContactLimits& limits) {
  for (const auto& [option, value] :
       {std::pair{"--clearance-up-to", limits.clearanceUpTo}, std::pair{"--clash-above", limits.clashOverlap}}) {
    if (value >= 0.0) continue;
    return Diagnostic{ErrorKind::Usage, "", option, "is below zero", "Give a length, as 0.5mm."};
  }
  return Done{};
}

}  // namespace

int runFits(const FitsOptions& options) {
  if (const Outcome sound = checkLimits(options.limits); !sound) return reportError(sound.error(), options.format);
  const Interrupt interrupt;
  const bool parts = isPartFile(usualPart(options.file).path);
  const auto bodies =
      parts ? bodiesOfParts(options.file, interrupt.token()) : bodiesOfScenario(options.file, interrupt.token());
  if (!bodies) return reportError(bodies.error(), options.format);
  const ContactReport report = findContacts(*bodies, options.limits, interrupt.token());
  if (interrupt.requested()) {
    return reportError({ErrorKind::Interrupted, options.file, "", "was interrupted", "Start again."}, options.format);
  }
  if (options.format == Format::Json) {
    printJson(report, *bodies);
  } else if (options.csv) {
    printCsv(report, *bodies);
  } else {
    printTable(report, *bodies);
  }
  return 0;
}

}  // namespace glissade::cli
