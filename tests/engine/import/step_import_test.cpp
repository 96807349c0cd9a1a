#include "engine/import/step_import.h"

#include <numbers>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/geometry/mesh_audit.h"
#include "engine/import/part_solids.h"
#include "engine/import/step_deflection.h"
#include "tests/engine/support/mapped_step.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/step_files/step_text.h"

namespace glissade {
namespace {

using test::stepFile;
using test::stepText;
using testing::ElementsAre;

constexpr double kCubicMillimetre = 1e-9;

std::vector<Occurrence> partsOf(const std::string& name, double deflection = 0.0) {
  auto product = importStep(stepFile(name), deflection);
  EXPECT_TRUE(product) << toString(product.error());
  if (!product) return {};
  EXPECT_TRUE(product->warnings.empty()) << toString(product->warnings.front());
  return std::move(product->parts);
}

Occurrence onePart(const std::string& name, double deflection = 0.0) {
  const auto parts = partsOf(name, deflection);
  EXPECT_EQ(parts.size(), 1U);
  return parts.at(0);
}

std::vector<std::string> pathsOf(const std::vector<Occurrence>& parts) {
  std::vector<std::string> paths;
  for (const Occurrence& part : parts) paths.push_back(part.path);
  return paths;
}

Box3 boxInFile(const Occurrence& part) { return boundingBox(*part.mesh, part.X_FP); }

TEST(StepImport, SolidsAreClosedAndTheirOutsideIsOutside) {
  // Solids with their exact volumes, mm³.
  const double ball = 4.0 / 3.0 * std::numbers::pi * 25 * 25 * 25;
  const std::vector<std::pair<const char*, double>> solids{
      {"box.step", 100 * 50 * 20},
      {"cylinder.STP", std::numbers::pi * 10 * 10 * 40},
      {"ball.stp", ball},
      {"plate.step", 100 * 60 * 10 - std::numbers::pi * 8.5 * 8.5 * 10},
      {"boolean.step", 0.0}};
  for (const auto& [name, volume] : solids) {
    SCOPED_TRACE(name);
    const Occurrence part = onePart(name);
    const MeshAudit result = audit(*part.mesh);
    EXPECT_TRUE(result.closed());
    EXPECT_TRUE(result.consistentlyOriented);
    EXPECT_EQ(result.surfaces.size(), 1U);
    EXPECT_EQ(part.facesWithoutMesh, 0U);
    EXPECT_GT(result.volume, 0.0);
    if (volume == 0.0) continue;  // not known
    EXPECT_NEAR(result.volume, volume * kCubicMillimetre, 0.01 * volume * kCubicMillimetre);
  }
}

TEST(StepImport, TheFilesUnitIsHonoured) {
  EXPECT_TRUE(boxInFile(onePart("box.step")).sizes().isApprox(Vector3(0.1, 0.05, 0.02), 1e-9));
  EXPECT_THAT(stepText("inch.step"), testing::HasSubstr("INCH"));
  EXPECT_TRUE(boxInFile(onePart("inch.step")).sizes().isApprox(Vector3(0.0508, 0.0254, 0.0254), 1e-9));
  EXPECT_EQ(onePart("inch.step").unit, 0.0254);
  EXPECT_EQ(onePart("box.step").unit, 0.001);
}

TEST(StepImport, CommonVolumesAreThoseOfTheSolids) {
  test::StepText text;
  const auto block = text.part("block", text.box({0, 0, 0}, {20, 20, 20}), "FACETED_BREP_SHAPE_REPRESENTATION");
  const auto bar = text.part("bar", text.box({0, 0, 0}, {10, 8, 6}) + "," + text.box({0, 12, 0}, {10, 8, 6}),
                             "FACETED_BREP_SHAPE_REPRESENTATION");
  const auto empty = text.part("empty", "");
  auto assembly = text.product("assembly");
  text.define(assembly, text.representation(""));
  text.place(assembly, block, {0, 0, 0});
  text.place(assembly, bar, {19.25, 0, 0});            // 0.75 deep with both of its solids
  text.place(assembly, bar, {40, 0, 0});               // apart
  text.place(assembly, bar, {5, 5, 19.5}, {1, 0, 0});  // turned: its x is along z
  text.place(assembly, empty, {0, 0, 0});
  const test::TemporaryFolder folder;
  const std::string file = folder.write("overlaps.step", text.str());
  const auto volumes =
      commonVolumes(file, {{"block", "bar"}, {"bar#2", "block"}, {"bar#3", "block"}, {"block", "no such part"}});
  ASSERT_TRUE(volumes) << toString(volumes.error());
  ASSERT_EQ(volumes->size(), 4U);
  EXPECT_NEAR(volumes->at(0).value_or(0.0), 2 * 0.75 * 8 * 6 * kCubicMillimetre, 1e-15);
  EXPECT_EQ(volumes->at(1), 0.0);
  EXPECT_TRUE(volumes->at(2));
  EXPECT_FALSE(volumes->at(3)) << "a part that is not there has no volume";
}

/// fits.step with another name for its bolt.
Result<StepProduct> productWithBoltCalled(const std::string& name) {
  std::string text = stepText("fits.step");
  const std::string bolt = "'bolt'";
  for (std::size_t at = text.find(bolt); at != std::string::npos; at = text.find(bolt, at + 1)) {
    text.replace(at, bolt.size(), "'" + name + "'");
  }
  return importStep(FileContent{"names.step", text}, 0.0);
}

struct ForeignName {
  std::string bytes;
  std::string name;      ///< UTF-8
  std::string encoding;  ///< empty: the bytes are UTF-8
  bool isSure = true;
};

/// The standard permits ASCII with directives and, since its third edition, UTF-8; programs write other encodings, too.
TEST(StepImport, NamesAreReadInTheEncodingsThatProgramsWrite) {
  const std::vector<ForeignName> names{
      {"\\X2\\87BA9489\\X0\\", "\u87ba\u9489", ""},
      {"b\u00e9lt", "b\u00e9lt", ""},
      {"b\xE9lt", "b\u00e9lt", "Windows-1252"},
      {"\xDC"
       "bergr\xF6\xDF"
       "e",
       "\u00dcbergr\u00f6\u00dfe", "Windows-1252"},
      {"\xD8 20 \xB1 0.1", "\u00d8 20 \u00b1 0.1", "Windows-1252"},
      {"\xC2\xDD\xB6\xA4 M6", "\u87ba\u9489 M6", "GB18030"},
      {"\xB5\xE7\xBB\xFA\xD6\xE1", "\u7535\u673a\u8f74", "GB18030"},
      {"\x82\xCB\x82\xB6 M6", "\u306d\u3058 M6", "Shift JIS"},
      {"\x95\x5C\x83\x5C\x81\x5B", "\u8868\u30bd\u30fc", "Shift JIS"},  // with bytes that are backslashes
      {"\xCA\xEE\xF0\xEF\xF3\xF1", "\u00ca\u00ee\u00f0\u00ef\u00f3\u00f1", "Windows-1252", false}};  // Cyrillic
  for (const ForeignName& each : names) {
    SCOPED_TRACE(each.name);
    const auto product = productWithBoltCalled(each.bytes);
    ASSERT_TRUE(product) << toString(product.error());
    EXPECT_THAT(pathsOf(product->parts), testing::Contains(each.name));
    ASSERT_EQ(product->warnings.size(), each.encoding.empty() ? 0U : 1U);
    if (each.encoding.empty()) continue;
    EXPECT_THAT(toString(product->warnings[0].reason),
                testing::HasSubstr("read as " + each.encoding + ": '" + each.name + "'"));
    EXPECT_EQ(toString(product->warnings[0].reason).find("cannot be told") == std::string::npos, each.isSure);
  }
}

/// A program cuts a long name in UTF-8 within a character; such names say nothing of the encoding of the others.
TEST(StepImport, ANameThatIsCutIsNoOtherEncoding) {
  const auto product = productWithBoltCalled("\xE6\x9C");
  ASSERT_TRUE(product) << toString(product.error());
  EXPECT_TRUE(product->warnings.empty());
  EXPECT_THAT(pathsOf(product->parts), testing::Contains("\uFFFD"));
  std::string text = stepText("fits.step");
  const std::size_t name = text.find('\'', text.find("FILE_NAME"));
  text.replace(name + 1, text.find('\'', name + 1) - name - 1, "\xD7\xB0\xC5\xE4\xCC\xE5.STEP");
  text.replace(text.find("'bolt'"), 6, "'\xE4\xBB'");
  const auto headed = importStep(FileContent{"names.step", text}, 0.0);
  ASSERT_TRUE(headed) << toString(headed.error());
  ASSERT_EQ(headed->warnings.size(), 1U);
  EXPECT_THAT(toString(headed->warnings[0].reason), testing::HasSubstr("read as GB18030: '\u88c5\u914d\u4f53.STEP'"));
}

TEST(StepImport, ProductsOfAnAssemblyLieWhereItHasThem) {
  const auto parts = partsOf("unit.step");
  ASSERT_THAT(pathsOf(parts), ElementsAre("plate", "pin", "pin#2", "pump/housing", "pump/Läufer"));
  EXPECT_EQ(parts[1].mesh, parts[2].mesh) << "instances share their triangles";
  const Vector3 upright(0.016, 0.016, 0.04);
  EXPECT_TRUE(boxInFile(parts[1]).sizes().isApprox(upright, 5e-3));
  EXPECT_TRUE(boxInFile(parts[1]).center().isApprox(Vector3(0, 0, 0.01), 1e-3));
  EXPECT_TRUE(boxInFile(parts[2]).sizes().isApprox(Vector3(0.016, 0.04, 0.016), 5e-3)) << "turned";
  EXPECT_TRUE(boxInFile(parts[2]).center().isApprox(Vector3(0, 0.2, 0.008), 1e-3));
  EXPECT_TRUE(boxInFile(parts[4]).center().isApprox(Vector3(0.3, -0.05, 0.02), 1e-3)) << "in an assembly in it";
  for (const Occurrence& part : parts) EXPECT_TRUE(audit(*part.mesh).closed()) << part.path;
}

TEST(StepImport, ColoursAreTheFiles) {
  const auto parts = partsOf("unit.step");
  ASSERT_EQ(parts.size(), 5U);
  ASSERT_TRUE(parts[0].colour && parts[1].colour && parts[2].colour);
  EXPECT_THAT(*parts[0].colour, testing::Pointwise(testing::DoubleNear(1e-3), {0.8, 0.2, 0.1}));
  EXPECT_EQ(parts[1].colour, parts[2].colour);
  EXPECT_FALSE(parts[3].colour);
}

TEST(StepImport, SeveralSolidsOfAProductAreParts) {
  EXPECT_THAT(pathsOf(partsOf("two-solids.step")), ElementsAre("two/solid", "two/solid#2"));
}

/// The uses of unit.step, in the order of the file, with other names and designators.
std::string unitWithUses(const std::vector<std::pair<std::string, std::string>>& uses) {
  const std::string text = stepText("unit.step");
  const std::regex pattern("NEXT_ASSEMBLY_USAGE_OCCURRENCE\\('([^']*)','[^']*','',\\s*(#\\d+),\\s*(#\\d+),\\s*\\$\\)");
  std::string changed;
  auto from = text.cbegin();
  std::size_t number = 0;
  for (std::sregex_iterator use(text.begin(), text.end(), pattern), end; use != end; ++use) {
    const auto& [name, designator] = uses.at(number++);
    changed.append(from, text.cbegin() + use->position());
    changed += "NEXT_ASSEMBLY_USAGE_OCCURRENCE('" + use->str(1) + "','" + name + "',''," + use->str(2) + "," +
               use->str(3) + "," + (designator.empty() ? "$" : "'" + designator + "'") + ")";
    from = text.cbegin() + use->position() + use->length();
  }
  EXPECT_EQ(number, uses.size());
  return changed.append(from, text.cend());
}

TEST(StepImport, UsesKeepTheirNamesAndDesignatorsApart) {
  const auto product = importStep(
      FileContent{"uses.step", unitWithUses({{"h", ""}, {"x", "X1"}, {"M8/2", "X2"}, {"p", ""}, {"", ""}})}, 0.0);
  ASSERT_TRUE(product) << toString(product.error());
  EXPECT_THAT(pathsOf(product->parts), ElementsAre("plate", "pin", "pin#2", "pump/housing", "pump/L\u00e4ufer"))
      << "paths are made of the names of products";
  std::set<std::string> names;
  for (const Occurrence& part : product->parts) {
    if (part.names.empty()) continue;
    const NodeNames& own = part.names.back();
    names.insert(own.product + "|" + own.occurrence + "|" + own.designator);
  }
  EXPECT_THAT(names, testing::IsSupersetOf({std::string("pin|x|X1"), std::string("pin|M8/2|X2")}));
}

/// OpenCASCADE gives one name to products that share a shape, so that both were "stud" in earlier versions. A path of
/// an earlier version means one part: "stud" is the pin, and the stud keeps its number.
TEST(StepImport, AMappedProductHasItsOwnName) {
  const auto product = importStep(FileContent{"mapped.step", test::mappedStepText()}, 0.0);
  ASSERT_TRUE(product) << toString(product.error());
  EXPECT_THAT(pathsOf(product->parts), ElementsAre("plate", "pin", "stud#2", "pump/housing", "pump/L\u00e4ufer"));
  EXPECT_EQ(product->parts[1].formerPath, "stud");
  EXPECT_EQ(product->parts[2].names.back().product, "stud");
  EXPECT_EQ(product->parts[1].mesh, product->parts[2].mesh);
  EXPECT_TRUE(boxInFile(product->parts[2]).center().isApprox(Vector3(0, 0.2, 0.008), 1e-3));
}

TEST(StepImport, IgesAndBrepSolidsAreClosedAndHaveTheirVolumes) {
  const std::vector<double> volumes{100 * 60 * 10 - std::numbers::pi * 8.5 * 8.5 * 10, std::numbers::pi * 8 * 8 * 40,
                                    30 * 20 * 10};
  for (const auto& [name, unit] : {std::pair("surfaces.igs", 0.001), {"solids.iges", 0.0254}, {"solids.brep", 0.001}}) {
    SCOPED_TRACE(name);
    const auto parts = partsOf(name);
    ASSERT_EQ(parts.size(), volumes.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const MeshAudit result = audit(*parts[i].mesh);
      EXPECT_TRUE(result.closed() && result.consistentlyOriented);
      EXPECT_NEAR(result.volume, volumes[i] * kCubicMillimetre, 0.01 * volumes[i] * kCubicMillimetre);
      EXPECT_EQ(parts[i].unit, unit);
    }
    EXPECT_TRUE(boxInFile(parts[2]).center().isApprox(Vector3(0.1, 0, 0), 1e-6));
  }
  EXPECT_TRUE(audit(*onePart("shell.brep").mesh).closed());
}

TEST(StepImport, AnIgesSheetIsOpenAndThatIsSaid) {
  const auto product = importStep(stepFile("sheet.igs"), 0.0);
  ASSERT_TRUE(product) << toString(product.error());
  ASSERT_EQ(product->warnings.size(), 1U);
  EXPECT_EQ(toString(product->warnings[0].reason),
            "is no solid: its faces (1) bound nothing, 4 of their edges are open");
}

TEST(StepImport, ASheetIsAPartThatIsNotClosedAndThatIsSaid) {
  const auto product = importStep(stepFile("surface.step"), 0.0);
  ASSERT_TRUE(product);
  ASSERT_EQ(product->parts.size(), 1U);
  EXPECT_FALSE(audit(*product->parts[0].mesh).closed());
  EXPECT_EQ(product->parts[0].mesh->triangles.size(), 2U);
  ASSERT_EQ(product->warnings.size(), 1U);
  EXPECT_EQ(toString(product->warnings[0].reason),
            "is no solid: its faces (1) bound nothing, 4 of their edges are open");
}

TEST(StepImport, PartsWithoutAnInsideAndLonelyCurvesAreNamed) {
  const auto product = importStep(stepFile("odd-shapes.step"), 0.0);
  ASSERT_TRUE(product);
  std::vector<std::string> said;
  for (const Diagnostic& warning : product->warnings)
    said.push_back(toString(warning.location) + ": " + toString(warning.reason));
  EXPECT_THAT(said, testing::UnorderedElementsAre(
                        "part 'sheets': is no solid: its faces (2) bound nothing, 8 of their edges are open",
                        "part 'wired': has curves that lie on no face (3): they are left out",
                        "part 'flat': has no thickness: its faces enclose no volume"));
  EXPECT_EQ(product->parts.size(), 4U) << "a closed shell is no solid, but bounds one";
}

/// The assembly has the solids of its plate and its pin as its own shapes, too.
TEST(StepImport, SolidsBesideTheUsesOfAnAssemblyAreParts) {
  std::string text = stepText("unit.step");
  const std::string items = "SHAPE_REPRESENTATION('',(#11,#15,#19,#23,#27),";
  const auto at = text.find(items);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, items.size(), "SHAPE_REPRESENTATION('',(#11,#15,#19,#23,#27,#45,#478),");
  const test::TemporaryFolder folder;
  const auto product = importStep(folder.write("own.step", text), 0.0);
  ASSERT_TRUE(product) << toString(product.error());
  const std::size_t before = importStep(stepFile("unit.step"), 0.0)->parts.size();
  const auto parts = withPartsAsOne(product->parts, std::set<std::string>());
  EXPECT_EQ(parts.size(), before + 2U);
  for (const Occurrence& part : parts) EXPECT_FALSE(part.isSolidOfPart) << part.path;
}

/// A part that the surface sticks out of has both as bodies.
TEST(StepImport, SurfacesInsideASolidOfTheirPartAreLeftOut) {
  const auto product = importStep(stepFile("cosmetic-threads.step"), 0.0);
  ASSERT_TRUE(product);
  std::vector<std::string> paths;
  for (const Occurrence& part : withPartsAsOne(product->parts, std::set<std::string>())) paths.push_back(part.path);
  EXPECT_THAT(paths, testing::ElementsAre("covered", "covered#2", "bare/bare", "bare/surfaces"));
  std::vector<std::string> said;
  for (const Diagnostic& warning : product->warnings)
    said.push_back(toString(warning.location) + ": " + toString(warning.reason));
  const std::string covered = " has surfaces inside its solid (1 face), as cosmetic threads are: they are left out";
  EXPECT_THAT(said, testing::UnorderedElementsAre(
                        "part 'covered/surfaces':" + covered, "part 'covered#2/surfaces':" + covered,
                        "part 'bare/surfaces': is no solid: its faces (1) bound nothing, 2 of their edges are open"));
}

TEST(StepImport, DeflectionIsAtMostAThousandthOfTheDiagonalWithinLimitsUnlessSomebodySays) {
  EXPECT_EQ(usualDeflection(1e-3), 1e-5);
  EXPECT_EQ(usualDeflection(0.2), 2e-4);
  EXPECT_EQ(usualDeflection(100.0), 5e-4);
  const double plate = onePart("plate.step").deflection;
  EXPECT_LE(plate, usualDeflection(Vector3(0.1, 0.06, 0.01).norm()));
  EXPECT_GT(plate, 0.0);
  EXPECT_EQ(onePart("box.step").deflection, 0.0);
  std::size_t before = 0;
  for (const double deflection : {2e-3, 2e-4, 2e-5}) {
    const Occurrence ball = onePart("ball.stp", deflection);
    const TriangleMesh& mesh = *ball.mesh;
    EXPECT_LE(ball.deflection, 1.1 * deflection) << "OpenCASCADE does not keep it";
    EXPECT_GT(mesh.triangles.size(), before);
    before = mesh.triangles.size();
    for (const TriangleIndices& t : mesh.triangles) {
      const Vector3 centre = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
      ASSERT_NEAR(centre.norm(), 0.025, ball.deflection);
    }
  }
}

TEST(StepImport, SaysTheSameTwice) {
  const auto once = partsOf("unit.step");
  const auto again = partsOf("unit.step");
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].mesh->vertices, again[i].mesh->vertices);
    EXPECT_EQ(once[i].mesh->triangles, again[i].mesh->triangles);
  }
}

TEST(StepImport, IsStoppedAtOnce) {
  StopSource stop;
  stop.requestStop();
  const auto stopped = importStep(stepFile("unit.step"), 0.0, stop.token());
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
}

TEST(StepImport, EndingsInAnyCase) {
  for (const char* name : {"a.step", "a.STP", "a.Step", "a.p21", "a.IGS", "a.iges", "a.brep"})
    EXPECT_TRUE(isCadFile(name)) << name;
  for (const char* name : {"a.stl", "step", "a.step.stl"}) EXPECT_FALSE(isCadFile(name)) << name;
}

}  // namespace
}  // namespace glissade
