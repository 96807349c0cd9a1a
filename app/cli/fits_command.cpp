#include "app/cli/fits_command.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/base/number_text.h"
#include "engine/product/product_fits.h"
#include "engine/scenario/product_file.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json toJson(const PairFit& row) {
  const Contact& contact = row.contact;
  Json json{{"a", row.a},
            {"b", row.b},
            {"kind", kindName(row.decision.kind)},
            {"gap_m", contact.gap},
            {"overlap_m", contact.overlap},
            {"uncertainty_m", contact.uncertainty},
            {"allowance_m", row.allowance()},
            {"status", statusName(row.status())}};
  if (contact.axis) {
    json["axis"] = {{"point", coordinates(contact.axis->point)},
                    {"direction", coordinates(contact.axis->direction)},
                    {"radius_a", contact.axis->radiusA},
                    {"radius_b", contact.axis->radiusB}};
  }
  return json;
}

void printPairs(const std::vector<PairFit>& rows) {
  Json json{{"pairs", Json::array()}, {"counts", Json::object()}};
  for (const PairFit& row : rows) json["pairs"].push_back(toJson(row));
  for (const auto& [kind, count] : countsByKind(rows)) json["counts"][kind] = count;
  // Names come from files.
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

void printCsv(const std::vector<PairFit>& rows) {
  std::cout << "a,b,kind,gap_m,overlap_m,uncertainty_m,allowance_m,status\n";
  for (const PairFit& row : rows) {
    const Contact& contact = row.contact;
    std::cout << quoted(row.a) << "," << quoted(row.b) << "," << kindName(row.decision.kind) << ","
              << toText(contact.gap) << "," << toText(contact.overlap) << "," << toText(contact.uncertainty) << ","
              << toText(row.allowance()) << "," << statusName(row.status()) << "\n";
  }
}

void printTable(const std::vector<PairFit>& rows, std::size_t bodies) {
  std::size_t width = 1;
  for (const PairFit& row : rows) width = std::max(width, row.a.size());
  std::cout << std::left << std::fixed << std::setprecision(3);
  for (const PairFit& row : rows) {
    const Contact& contact = row.contact;
    const bool overlaps = contact.overlap > 0.0;
    std::cout << std::setw(12) << kindName(row.decision.kind) << (overlaps ? "overlap " : "gap     ") << std::right
              << std::setw(8) << 1e3 * (overlaps ? contact.overlap : contact.gap) << " mm";
    if (contact.uncertainty > 0.0) {
      std::cout << " +- " << 1e3 * contact.uncertainty;
    } else {
      std::cout << "         ";
    }
    std::cout << "  " << std::left << std::setw(static_cast<int>(width)) << row.a << "  " << row.b << "\n";
  }
  std::cout << rows.size() << " pairs of " << bodies << " bodies";
  const char* separator = ": ";
  for (const auto& [kind, count] : countsByKind(rows)) {
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
  const auto loaded = readProduct(options.file, interrupt.token(), options.deflection);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  const AssembledProduct& product = loaded->product;
  const std::vector<PairFit> rows =
      findProductFits(contactBodiesOf(product), product.fits, options.limits, interrupt.token());
  if (interrupt.requested()) {
    return reportError({ErrorKind::Interrupted, options.file, "", "was interrupted", "Start again."}, options.format);
  }
  if (options.format == Format::Json) {
    printPairs(rows);
  } else if (options.csv) {
    printCsv(rows);
  } else {
    printTable(rows, product.bodies.size());
  }
  return 0;
}

}  // namespace glissade::cli
