#include "engine/documents/path_report.h"

#include <gtest/gtest.h>

#include "engine/base/quantity_text.h"
#include "engine/documents/plan_words.h"
#include "engine/documents/report_html.h"
#include "engine/planning/path_certificate.h"
#include "tests/engine/support/loaded_scenario.h"

namespace glissade {
namespace {

class PathReport : public testing::Test {
 protected:
  PathReport() {
    Scenario scenario;
    scenario.name = "Shelf & box";
    scenario.object.first().name = "box";
    scenario.object.first().geometry = BoxGeometry{{0.1, 0.1, 0.1}};
    BodyDescription shelf;
    shelf.id = "shelf";
    shelf.name = "shelf";
    shelf.geometry = BoxGeometry{{1.0, 0.02, 1.0}};
    shelf.pose = Pose::translation({0.0, 0.1, 0.0});
    scenario.bodies.push_back(shelf);
    scenario.goal = Pose::translation({0.5, 0.0, 0.0});
    scenario.workspace = Box3(Vector3::Constant(-2.0), Vector3::Constant(2.0));
    loaded_ = test::loadedFrom(scenario);
    path_.points = {PathPoint{Pose::identity()}, PathPoint{Pose::translation({0.5, 0.0, 0.0})}};
    const auto query = loaded_.problem.world->makeQuery();
    path_.certificate = certifyPath(*query, path_.points, loaded_.parameters);
    profile_ = clearanceProfile(*query, path_.configurations(), loaded_.problem.metric(), 300);
  }

  std::string page(Language language) const {
    const DocumentWords words(language);
    const auto html = reportHtml(pathReport({path_, loaded_, {"auto", 7}, &profile_}, words, inMillimetres));
    EXPECT_TRUE(html.ok());
    return *html;
  }

  LoadedScenario loaded_;
  Path path_;
  ClearanceProfile profile_;
};

TEST_F(PathReport, SaysWhatIsProvedAndWhoIsNear) {
  const std::string text = page(Language::English);
  for (const char* part :
       {"Shelf &amp; box", "Certificate", "40 mm to shelf", "auto", "500 mm", "Clearance along the path"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST_F(PathReport, IsWhollyFrench) {
  const std::string text = page(Language::French);
  for (const char* part : {"Certificat", "Jeu certifié", "Jeu le long du chemin", "Pièce manipulée"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  for (const ParameterSpec& spec : parameterTable()) {
    EXPECT_TRUE(hasFrench(spec.label.english)) << spec.label.english;
  }
  for (const char* part : {"Certificate", "Clearance", "Parameters", "Length"}) {
    EXPECT_EQ(text.find(part), std::string::npos) << part;
  }
}

TEST_F(PathReport, ACurveHasFewPointsAndTheSmallestClearance) {
  const Report report = pathReport({path_, loaded_, {}, &profile_}, DocumentWords(), inMillimetres);
  const ReportDrawing* drawing = nullptr;
  for (const ReportBlock& block : report.blocks) {
    if (const auto* found = std::get_if<ReportDrawing>(&block)) drawing = found;
  }
  ASSERT_NE(drawing, nullptr);
  std::size_t points = 0;
  for (std::size_t at = drawing->svg.find("<circle"); at != std::string::npos;
       at = drawing->svg.find("<circle", at + 1))
    ++points;
  EXPECT_LT(points, 130U);
  const std::string least = inMillimetres(path_.certificate.minClearance);
  EXPECT_NE(drawing->svg.find("<title>" + least + " to shelf</title>"), std::string::npos) << least;
}

}  // namespace
}  // namespace glissade
