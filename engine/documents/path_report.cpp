#include "engine/documents/path_report.h"

#include <glissade/version.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/number_text.h"
#include "engine/documents/line_plot.h"
#include "engine/documents/short_number.h"
#include "engine/files/product_name.h"
#include "engine/files/scenario_fits.h"

namespace glissade {
namespace {

/// Number of points of the plot, which have markers.
constexpr std::size_t kPlotPoints = 80;
constexpr double kMillimetres = 1e3;
constexpr double kDegrees = 180.0 / std::numbers::pi;

class PathReportComposer {
 public:
  PathReportComposer(const PathReportContent& content, const DocumentWords& words,
                     const std::function<std::string(double)>& length)
      : content_(content), words_(words), length_(length) {}

  Report compose() {
    report_.language = words_.language();
    report_.title = words_(GLISSADE_TEXT("Report of a path: %1"), {nameOfProduct(content_.scenario)});
    addProblem();
    addCertificate();
    if (!content_.overview.file.empty()) report_.blocks.emplace_back(content_.overview);
    addCurve();
    addParameters();
    addParts();
    return std::move(report_);
  }

 private:
  void heading(CatalogueText text, bool newPage = false) {
    report_.blocks.emplace_back(ReportHeading{words_(text), 2, newPage});
  }

  void facts(std::vector<std::vector<std::string>> rows) {
    report_.blocks.emplace_back(
        ReportTable{"", {{"", ReportColumn::Kind::Text}, {"", ReportColumn::Kind::Prose}}, std::move(rows)});
  }

  std::string nameOf(int body) const {
    return body < 0 ? "–" : content_.scenario.obstacles[static_cast<std::size_t>(body)].shown();
  }

  void addProblem() {
    const LoadedScenario& scenario = content_.scenario;
    std::vector<std::vector<std::string>> rows{
        {words_(GLISSADE_TEXT("Scenario")), nameOfProduct(scenario)},
        {words_(GLISSADE_TEXT("Moving part")), scenario.object.shown()},
        {words_(GLISSADE_TEXT("Other parts")), std::to_string(scenario.obstacles.size())}};
    if (!content_.provenance.planner.empty()) {
      rows.push_back({words_(GLISSADE_TEXT("Strategy")), content_.provenance.planner});
      rows.push_back({words_(GLISSADE_TEXT("Seed")), std::to_string(content_.provenance.seed)});
    }
    rows.push_back({words_(GLISSADE_TEXT("Length")), length_(content_.path.length())});
    rows.push_back(
        {words_(GLISSADE_TEXT("Turns")), toText(std::round(10.0 * kDegrees * content_.path.rotation()) / 10.0) + "°"});
    rows.push_back({words_(GLISSADE_TEXT("Configurations")), std::to_string(content_.path.points.size())});
    rows.push_back({words_(GLISSADE_TEXT("Program")), std::string("Glissade ") + kVersion});
    facts(std::move(rows));
  }

  void addCertificate() {
    const MotionCertificate& certificate = content_.path.certificate;
    heading(GLISSADE_TEXT("Certificate"));
    report_.blocks.emplace_back(ReportText{
        words_(GLISSADE_TEXT("The path is certified free of penetration: the part keeps the required clearance from "
                             "all other parts at every time of the motion, not only at samples."))});
    const bool isNear = certificate.nearest.body >= 0;
    std::vector<std::vector<std::string>> rows{
        {words_(GLISSADE_TEXT("Required clearance")), length_(certificate.tolerance)}};
    if (isNear) {
      rows.push_back({words_(GLISSADE_TEXT("Certified clearance")), length_(certificate.provedClearance)});
      const NearestObstacle least = smallestMet();
      rows.push_back({words_(GLISSADE_TEXT("Smallest clearance met")),
                      words_(GLISSADE_TEXT("%1 to %2"), {length_(least.distance), nameOf(least.body)})});
    }
    if (const std::size_t sliding = certificate.slidingEdges(); sliding > 0) {
      rows.push_back(
          {words_(GLISSADE_TEXT("Edges that slide")),
           words_(GLISSADE_TEXT("%1 of %2"), {std::to_string(sliding), std::to_string(certificate.edges.size())})});
    }
    if (certificate.forbiddenMargin > 0.0) {
      rows.push_back({words_(GLISSADE_TEXT("Forbidden places")),
                      words_(GLISSADE_TEXT("the path keeps %1 from them"), {length_(certificate.forbiddenMargin)})});
    }
    for (const Message& allowance : allowancesInWords(content_.scenario, content_.path.points)) {
      rows.push_back({words_(GLISSADE_TEXT("Allowance")), toString(allowance, words_.language())});
    }
    if (const MissingShapes& missing = content_.scenario.missing; !missing.empty()) {
      rows.push_back({words_(GLISSADE_TEXT("Not known")),
                      words_(GLISSADE_TEXT("where these shapes of the file are: %1"), {listOf(missing)})});
    }
    if (const double deviation = surfaceDeviation(content_.scenario); deviation > 0.0) {
      rows.push_back({words_(GLISSADE_TEXT("CAD accuracy")), words_(GLISSADE_TEXT("± %1"), {length_(deviation)})});
    }
    if (const double spacing = coordinateSpacing(content_.scenario); spacing > 0.0) {
      rows.push_back({words_(GLISSADE_TEXT("32-bit coordinates")),
                      words_(GLISSADE_TEXT("surfaces may be %1 nearer"), {length_(spacing)})});
    }
    facts(std::move(rows));
  }

  /// The smaller one of the distances in the certificate and in the profile, because either may have found a smaller
  /// one.
  NearestObstacle smallestMet() const {
    NearestObstacle least = content_.path.certificate.nearest;
    least.distance = content_.path.certificate.minClearance;
    const auto tightest = content_.profile != nullptr ? content_.profile->tightest() : std::nullopt;
    if (tightest && content_.profile->samples[*tightest].nearest.distance < least.distance) {
      least = content_.profile->samples[*tightest].nearest;
    }
    return least;
  }

  /// Adds every n-th sample, and the tightest.
  void addCurve() {
    if (content_.profile == nullptr || content_.profile->samples.empty()) return;
    const std::vector<ClearanceSample>& samples = content_.profile->samples;
    const std::size_t tightest = *content_.profile->tightest();
    const std::size_t step = std::max<std::size_t>(1, samples.size() / kPlotPoints);
    LinePlot plot;
    std::vector<double> clearances;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i % step != 0 && i != tightest) continue;
      const double clearance = kMillimetres * samples[i].nearest.distance;
      clearances.push_back(clearance);
      plot.points.push_back(
          {100.0 * samples[i].share, clearance,
           words_(GLISSADE_TEXT("%1 to %2"), {length_(samples[i].nearest.distance), nameOf(samples[i].nearest.body)})});
    }
    heading(GLISSADE_TEXT("Clearance along the path"), true);
    if (!content_.tightest.file.empty()) report_.blocks.emplace_back(content_.tightest);
    plot.title = words_(GLISSADE_TEXT("Clearance along the path"));
    plot.x = PlotScale::percentages(words_(GLISSADE_TEXT("share of the path, %")));
    plot.y = PlotScale::fitting(words_(GLISSADE_TEXT("clearance, mm")), clearances);
    report_.blocks.emplace_back(ReportDrawing{
        "clearance", plot.title,
        words_(GLISSADE_TEXT(
                   "Distances of triangles to the nearest part at places of the path; the smallest is %1 to %2."),
               {length_(samples[tightest].nearest.distance), nameOf(samples[tightest].nearest.body)}),
        svgOf(plot)});
  }

  void addParameters() {
    heading(GLISSADE_TEXT("Parameters"), true);
    ReportTable table{"",
                      {{words_(GLISSADE_TEXT("Parameter")), ReportColumn::Kind::Text},
                       {words_(GLISSADE_TEXT("Value")), ReportColumn::Kind::Number}},
                      {}};
    for (const ParameterSpec& spec : parameterTable()) {
      const double value = content_.scenario.parameters[spec.id];
      const std::string unit = spec.unit.empty() ? "" : " " + std::string(spec.unit);
      table.rows.push_back({words_(spec.label), spec.unit == "m" ? length_(value) : shortNumber(value) + unit});
    }
    report_.blocks.emplace_back(std::move(table));
  }

  /// Adds the files with the hashes of their content.
  void addParts() {
    heading(GLISSADE_TEXT("Files"));
    ReportTable table{"",
                      {{words_(GLISSADE_TEXT("File")), ReportColumn::Kind::Prose},
                       {words_(GLISSADE_TEXT("SHA-256")), ReportColumn::Kind::Prose}},
                      {}};
    for (const Asset& asset : content_.scenario.scenario.assets) table.rows.push_back({asset.path, asset.sha256});
    if (table.rows.empty()) {
      report_.blocks.emplace_back(
          ReportText{words_(GLISSADE_TEXT("All parts are boxes, cylinders and spheres of the scenario."))});
      return;
    }
    report_.blocks.emplace_back(std::move(table));
  }

  const PathReportContent& content_;
  const DocumentWords& words_;
  const std::function<std::string(double)>& length_;
  Report report_;
};

}  // namespace

Report pathReport(const PathReportContent& content, const DocumentWords& words,
                  const std::function<std::string(double metres)>& length) {
  return PathReportComposer(content, words, length).compose();
}

}  // namespace glissade
