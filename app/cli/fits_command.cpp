#include "app/cli/commands.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/interrupt.h"
#include "app/cli/text_cells.h"
#include "engine/base/number_text.h"
#include "engine/base/version_text.h"
#include "engine/check/plain_overlaps.h"
#include "engine/files/fits_cache.h"
#include "engine/files/part_files.h"
#include "engine/files/product_file.h"
#include "engine/fits/alternatives.h"
#include "engine/fits/fit_table.h"
#include "engine/import/missing_shapes_json.h"
#include "engine/import/step_import.h"
#include "engine/sequence/product_finder.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CatalogueText kBothThinner = GLISSADE_TEXT("both by %1");

Json coordinates(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

/// The allowances with which one body of the pair moves past the other.
Json toJson(const PairWay& way, const BodyId& moving, const BodyId& other) {
  Json json{{"moving", moving}, {"thinner", Json::array()}};
  for (const Fit& fit : way.taken) {
    if (!fit.thinned) continue;
    json["thinner"].push_back({{"body", fit.yields ? other : moving}, {"allowance_m", fit.allowance}});
    if (fit.hollow) json["thinner"].back()["hollow"] = true;
  }
  if (!way.refused.empty()) json["refused"] = toString(way.refused);
  return json;
}

Json toJson(const PairFit& row) {
  const Contact& contact = row.contact;
  Json json{{"a", row.a},
            {"b", row.b},
            {"a_name", row.shown[0]},
            {"b_name", row.shown[1]},
            {"kind", kContactKindNames.of(contact.kind)},
            {"gap_m", contact.gap},
            {"overlap_m", contact.overlap},
            {"uncertainty_m", contact.uncertainty},
            {"thinner", row.thinner()},
            {"allowance_m", row.way().allowance()},
            {"status", kFitStatusNames.of(row.status())},
            {"ways", {toJson(row.ways[0], row.a, row.b), toJson(row.ways[1], row.b, row.a)}}};
  if (contact.isPlainOverlap) json["plain_overlap"] = true;
  if (contact.axis) {
    json["axis"] = {{"point", coordinates(contact.axis->point)},
                    {"direction", coordinates(contact.axis->direction)},
                    {"radius_a", contact.axis->radiusA},
                    {"radius_b", contact.axis->radiusB}};
    if (contact.axis->conical) json["axis"]["conical"] = true;
  }
  return json;
}

std::size_t plainOverlapsIn(const std::vector<PairFit>& rows) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const PairFit& row) { return row.contact.isPlainOverlap; }));
}

/// Whether the overlap of the pair is an error of modelling, or may be one.
bool isOverlap(const PairFit& row) { return row.contact.isPlainOverlap || row.status() == FitStatus::Clash; }

/// Cubic metres that the solids of the file have in common, for each row that isOverlap(); nothing for other rows, and
/// if the file has no solids.
using Volumes = std::vector<std::optional<double>>;

Volumes commonVolumesOf(const std::vector<PairFit>& rows, const FitsOptions& options, const StopToken& stop) {
  Volumes volumes(rows.size());
  const std::string path = usualPart(options.file).path;
  if (!isCadFile(path)) return volumes;
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const PairFit& row : rows) {
    if (isOverlap(row)) pairs.emplace_back(row.a.text(), row.b.text());
  }
  const auto found = commonVolumes(path, pairs, stop);
  if (!found) {
    Diagnostic why = found.error();
    why.reason = {GLISSADE_TEXT("the volumes that solids have in common are not known: %1"), {why.reason}};
    reportWarnings({why}, options.console);
    return volumes;
  }
  auto next = found->begin();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (isOverlap(rows[i])) volumes[i] = *next++;
  }
  return volumes;
}

void printPairs(const std::vector<PairFit>& rows, const Volumes& volumes, const MissingShapes& missing) {
  Json json{{"pairs", Json::array()}, {"counts", Json::object()}, {"missing_shapes", missingShapesJson(missing)}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    json["pairs"].push_back(toJson(rows[i]));
    if (volumes[i]) json["pairs"].back()["common_volume_m3"] = *volumes[i];
  }
  for (const auto& [kind, count] : countsByKind(rows)) json["counts"][kind] = count;
  json["plain_overlaps"] = plainOverlapsIn(rows);
  // Names come from files and can hold invalid UTF-8.
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// Prints bodies by their names in the file, and the names of the assemblies that hold them.
void printCsv(const std::vector<PairFit>& rows, const Product& tree) {
  const std::vector<std::string> paths = tree.shownPaths();
  const auto nameOf = [&](const BodyId& id) {
    const auto node = tree.find(id.text());
    return node ? paths[*node] : id.text();
  };
  std::cout << "a,b,kind,gap_m,overlap_m,uncertainty_m,allowance_m,status,thinner,refused\n";
  for (const PairFit& row : rows) {
    const Contact& contact = row.contact;
    std::vector<std::string> thinner;
    for (const BodyId& id : row.thinner()) thinner.push_back(nameOf(id));
    std::cout << quoted(nameOf(row.a)) << "," << quoted(nameOf(row.b)) << "," << kContactKindNames.of(contact.kind)
              << "," << toText(contact.gap) << "," << toText(contact.overlap) << "," << toText(contact.uncertainty)
              << "," << toText(row.way().allowance()) << "," << kFitStatusNames.of(row.status()) << ","
              << quoted(joined(thinner)) << "," << quoted(toString(row.way().refused)) << "\n";
  }
}

/// "a by 0.0130 mm", "both by ...", "clash" or nothing.
Message thinnerInWords(const PairFit& row) {
  if (row.status() == FitStatus::Clash) return GLISSADE_TEXT("clash");
  const std::vector<BodyId> thinner = row.thinner();
  if (thinner.empty()) return {};
  const auto& taken = row.way().taken;
  if (std::any_of(taken.begin(), taken.end(), [](const Fit& fit) { return fit.hollow; })) {
    return GLISSADE_TEXT("without overlap");
  }
  const Length allowance{row.way().allowance()};
  if (thinner.size() > 1) return {kBothThinner, {allowance}};
  return {thinner.front() == row.a ? GLISSADE_TEXT("a by %1") : GLISSADE_TEXT("b by %1"), {allowance}};
}

/// "12.997 mm3"
std::string inCubicMillimetres(double volume) {
  constexpr double kCubicMillimetre = 1e-9;
  return fixedDigits(volume / kCubicMillimetre, 3) + " mm3";
}

/// Prints the common volumes, the deepest overlap first.
void printVolumes(const std::vector<PairFit>& rows, const Volumes& volumes, const Console& console) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (volumes[i]) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return rows[one].contact.overlap > rows[other].contact.overlap;
  });
  if (!order.empty()) console.print(GLISSADE_TEXT("common volumes of the solids in the file:"));
  for (const std::size_t i : order) {
    console.print(
        {GLISSADE_TEXT("  '%1' and '%2': %3, %4 deep"),
         {rows[i].shown[0], rows[i].shown[1], inCubicMillimetres(*volumes[i]), Length{rows[i].contact.overlap}}});
  }
}

/// "overlap   0.021 mm +- 0.005", or the gap.
std::string depthCell(const Contact& contact, const Console& console) {
  const std::string overlap = console.text(GLISSADE_TEXT("overlap"));
  const std::string gap = console.text(GLISSADE_TEXT("gap"));
  const bool overlaps = contact.overlap > 0.0;
  const std::string uncertainty =
      contact.uncertainty > 0.0 ? " +- " + fixedDigits(1e3 * contact.uncertainty, 3) : std::string(9, ' ');
  return toLeft(overlaps ? overlap : gap, std::max(widthOf(overlap), widthOf(gap)) + 1) +
         toRight(fixedDigits(1e3 * (overlaps ? contact.overlap : contact.gap), 3), 8) + " mm" + uncertainty;
}

void printCounts(const std::vector<PairFit>& rows, std::size_t bodies, const Console& console) {
  std::vector<Message> counts;
  for (const auto& [kind, count] : countsByKind(rows)) {
    counts.push_back({CatalogueText{"%1 %2"}, {count, CatalogueText{kind.c_str()}}});
  }
  const Message pairs{GLISSADE_TEXT("%1 {1|pair|pairs} of %2 {2|body|bodies}"), {rows.size(), bodies}};
  console.print(counts.empty() ? pairs : Message{GLISSADE_TEXT("%1: %2"), {pairs, glissade::joined(counts, ", ")}});
}

void printTable(const std::vector<PairFit>& rows, const Volumes& volumes, std::size_t bodies, const Console& console) {
  const std::string thinnerTitle = console.text(GLISSADE_TEXT("allowance"));
  const std::string depthTitle = console.text(GLISSADE_TEXT("gap or overlap"));
  const std::size_t depthWidth = std::max(widthOf(depthCell({}, console)), widthOf(depthTitle));
  // As wide as a usual text is; rare long ones do not widen the table.
  const std::size_t thinnerWidth =
      std::max(widthOf(thinnerTitle), widthOf(console.text({kBothThinner, {"0.0123 mm"}})));
  std::size_t nameWidth = 1;
  std::size_t kindWidth = 12;
  for (const PairFit& row : rows) {
    nameWidth = std::max(nameWidth, widthOf(row.shown[0]));
    kindWidth = std::max(kindWidth, widthOf(console.text(CatalogueText{kContactKindNames.of(row.contact.kind)})) + 1);
  }
  const auto print = [&](const std::string& kind, const std::string& depth, const std::string& thinner,
                         const std::string& a, const std::string& b) {
    std::cout << toLeft(kind, kindWidth) << toLeft(depth, depthWidth) << "  " << toLeft(thinner, thinnerWidth) << "  "
              << toLeft(a, nameWidth) << "  " << b << "\n";
  };
  print(console.text(GLISSADE_TEXT("kind")), depthTitle, thinnerTitle, "a", "b");
  for (const PairFit& row : rows) {
    print(console.text(CatalogueText{kContactKindNames.of(row.contact.kind)}), depthCell(row.contact, console),
          console.text(thinnerInWords(row)), row.shown[0], row.shown[1]);
  }
  printCounts(rows, bodies, console);
  if (const std::size_t plain = plainOverlapsIn(rows); plain > 0) console.print(check::plainOverlapsInWords(plain));
  printVolumes(rows, volumes, console);
}

Outcome checkLimits(const ContactLimits& limits) {
  for (const auto& [option, value] :
       {std::pair{"--clearance-up-to", limits.clearanceUpTo}, std::pair{"--clash-above", limits.clashOverlap}}) {
    if (value >= 0.0) continue;
    return Diagnostic{ErrorKind::Usage, "", option, GLISSADE_TEXT("is below zero"),
                      GLISSADE_TEXT("Give a length, as 0.5mm.")};
  }
  return Done{};
}

}  // namespace

int runFits(const FitsOptions& options) {
  if (const Outcome sound = checkLimits(options.limits); !sound) return reportError(sound.error(), options.console);
  const Interrupt interrupt;
  auto loaded = readProduct(options.file, interrupt.token(), options.deflection, {options.open, {}});
  if (!loaded) return reportError(loaded.error(), options.console);
  if (const Outcome left = leaveOut(options.without, *loaded); !left) return reportError(left.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  AssembledProduct product = loaded->product;
  options.fits.applyTo(product.fits);
  product.bodies = aboutTheirMiddles(std::move(product.bodies));
  ThreadTeam team(options.lanes - 1);
  const auto found =
      ProductFinder(usersFitsCache(versionText())).fits(product, team, interrupt.token(), options.limits);
  if (!found) {
    Diagnostic why = found.error();
    why.file = options.file;
    return reportError(why, options.console);
  }
  const FitTable& table = **found;
  const std::vector<PairFit>& rows = table.pairs();
  // A clash that is accepted and refused all the same needs words.
  const bool accepts = product.fits.acceptedClash > 0.0;
  reportWarnings(accepts ? table.warnings() : warningsOfPlainOverlaps(rows), options.console);
  reportWarnings(warningsOf(findAlternatives(product.bodies, interrupt.token()), product.bodies), options.console);
  const Volumes volumes = options.csv ? Volumes(rows.size()) : commonVolumesOf(rows, options, interrupt.token());
  if (options.console.json) {
    printPairs(rows, volumes, loaded->missing);
  } else if (options.csv) {
    printCsv(rows, product.tree);
  } else {
    printTable(rows, volumes, product.bodies.size(), options.console);
  }
  return 0;
}

}  // namespace glissade::cli
