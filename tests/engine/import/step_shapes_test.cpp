// Tests that shapes of a STEP file that OpenCASCADE leaves out are read, or named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/step_import.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/step_files/step_text.h"

namespace glissade {
namespace {

using test::StepText;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

StepProduct imported(const StepText& text) {
  const TemporaryFolder folder;
  auto product = importStep(folder.write("file.step", text.str()), 0.0);
  if (!product) {
    ADD_FAILURE() << toString(product.error()) << "\n" << text.str();
    return {};
  }
  return std::move(*product);
}

const Occurrence* partNamed(const StepProduct& product, const std::string& path) {
  const auto found = std::find_if(product.parts.begin(), product.parts.end(),
                                  [&](const Occurrence& part) { return part.path == path; });
  return found == product.parts.end() ? nullptr : &*found;
}

/// Expects a closed surface with this box in the frame of the file and this volume, in millimetres.
void expectBody(const StepProduct& product, const std::string& path, const Vector3& min, const Vector3& max,
                double volume) {
  SCOPED_TRACE(path);
  const Occurrence* part = partNamed(product, path);
  ASSERT_NE(part, nullptr);
  const Box3 box = boundingBox(*part->mesh, part->X_FP);
  constexpr double kNear = 1e-9;
  EXPECT_LT((box.min() - 1e-3 * min).norm(), kNear) << box.min().transpose();
  EXPECT_LT((box.max() - 1e-3 * max).norm(), kNear) << box.max().transpose();
  EXPECT_TRUE(isClosedSurface(*part->mesh));
  EXPECT_NEAR(1e9 * signedVolume(*part->mesh), volume, 1e-6 * volume);
}

/// Matches a message whose English text has this part.
auto says(const std::string& part) {
  return testing::ResultOf([](const Message& message) { return toString(message); }, HasSubstr(part));
}

auto missing(const std::string& product, const std::string& kind) {
  return AllOf(Field(&MissingShape::product, product), Field(&MissingShape::kind, kind));
}

StepText::Product assemblyIn(StepText& text) { return text.part("assembly", ""); }

/// OpenCASCADE makes an assembly of a product with a solid and curves, and calls the solid "SOLID".
TEST(StepShapes, ASolidBesideCurvesHasTheNameOfItsProduct) {
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  StepText::Product housing = text.part("housing 1", "");
  const std::string line = text.add("POLYLINE('',(" + text.point({0, 0, 0}) + "," + text.point({5, 0, 0}) + "," +
                                    text.point({5, 5, 0}) + "))");
  const std::string curves = text.add("GEOMETRIC_CURVE_SET('Sketch18',(" + line + "))");
  const auto also = [&](const std::string& representation) {
    text.add("SHAPE_REPRESENTATION_RELATIONSHIP('',''," + housing.representation + "," + representation + ")");
  };
  also(text.representation(text.box({0, 0, 0}, {10, 20, 30}), "FACETED_BREP_SHAPE_REPRESENTATION"));
  also(text.representation(curves, "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"));
  text.place(assembly, housing, {0, 0, 0});
  const StepProduct product = imported(text);
  ASSERT_EQ(product.parts.size(), 1U);
  ASSERT_FALSE(product.parts[0].names.empty());
  EXPECT_EQ(product.parts[0].names.back().product, "housing 1") << product.parts[0].path;
}

TEST(StepShapes, EveryKindWithoutABodyIsNamed) {
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  const std::string axis = text.axis({10, 10, 0});
  const std::string cylinder = text.add("RIGHT_CIRCULAR_CYLINDER(''," + axis + ",20.,8.)");
  const std::string sphere = text.add("SPHERE('',5.," + text.point({0, 0, 0}) + ")");
  const std::string block = text.add("BLOCK(''," + text.origin() + ",1.,2.,3.)");
  const std::string profile = text.add("RECTANGLE_PROFILE_DEF(.AREA.,$," + text.origin() + ",3.,4.)");
  const std::string up = text.direction({0, 0, 1});
  const std::string union_ = text.add("BOOLEAN_RESULT('',.UNION.," + block + "," + sphere + ")");
  const std::string extruded = text.add("EXTRUDED_AREA_SOLID(''," + profile + "," + text.origin() + "," + up + ",5.)");
  const std::vector<std::pair<std::string, std::string>> shapes{
      {"CSG_SOLID", text.add("CSG_SOLID(''," + cylinder + ")")},
      {"BOOLEAN_RESULT", union_},
      {"BLOCK", text.add("BLOCK(''," + text.origin() + ",1.,2.,3.)")},
      {"EXTRUDED_AREA_SOLID", extruded},
      {"REVOLVED_AREA_SOLID",
       text.add("REVOLVED_AREA_SOLID(''," + profile + "," + text.origin() + "," + axis + ",6.28)")},
      {"SOLID_REPLICA",
       text.add("SOLID_REPLICA(''," + extruded + "," +
                text.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('',$,$," + text.point({0, 0, 9}) + ",1.,$)") + ")")},
      {"HALF_SPACE_SOLID", text.add("HALF_SPACE_SOLID(''," + text.add("PLANE(''," + text.origin() + ")") + ",.T.)")},
      {"KIND_OF_TOMORROW", text.add("KIND_OF_TOMORROW('',1.)")}};
  std::vector<testing::Matcher<MissingShape>> expected;
  for (const auto& [kind, item] : shapes) {
    text.place(assembly, text.part("p_" + kind, item), {0, 0, 0});
    expected.push_back(AllOf(missing("p_" + kind, kind), Field(&MissingShape::entity, item),
                             Field(&MissingShape::reason, says("kind is not read"))));
  }
  text.place(assembly, text.part("nothing", ""), {0, 0, 0});
  expected.push_back(
      AllOf(missing("nothing", "PRODUCT_DEFINITION"), Field(&MissingShape::reason, says("no shape in the file"))));
  text.place(assembly, text.part("box", text.box({0, 0, 0}, {1, 2, 3})), {5, 0, 0});
  const StepProduct product = imported(text);
  EXPECT_THAT(product.missing, testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(product.parts.size(), 1);
  for (const MissingShape& shape : product.missing) {
    EXPECT_THAT(product.warnings,
                testing::Contains(AllOf(Field(&Diagnostic::location, says("'" + shape.product + "'")),
                                        Field(&Diagnostic::reason, says(shape.kind + " " + shape.entity)))));
  }
}

TEST(StepShapes, TessellatedShapesAreRead) {
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  const std::string kind = "TESSELLATED_SHAPE_REPRESENTATION";
  text.place(assembly, text.part("solid", text.tessellatedBox({0, 0, 0}, {20, 10, 5}), kind), {100, 0, 0});
  const std::string strips =
      text.add("TESSELLATED_SHELL('',(" + text.stripsAndFansOfBox({1, 1, 1}, {2, 3, 4}) + "),$)");
  text.place(assembly, text.part("shell", strips), {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const std::string inches = text.inches();
  const auto inch = text.part("inch", text.tessellatedBox({0, 0, 0}, {1, 1, 1}), kind, inches);
  text.place(assembly, inch, {0, 50, 0});
  text.place(assembly, inch, {0, 100, 0});
  const std::string set =
      text.add("TRIANGULATED_SURFACE_SET(''," + text.coordinates({0, 0, 0}, {1, 1, 1}) + ",8,(),(),((1,2,3),(2,4,3)))");
  text.place(assembly, text.part("sheet", set, kind), {0, 0, 0});
  text.place(assembly, text.part("box", text.box({0, 0, 0}, {1, 2, 3})), {-5, 0, 0});
  const StepProduct product = imported(text);
  EXPECT_THAT(product.missing, IsEmpty());
  EXPECT_EQ(product.parts.size(), 6);
  expectBody(product, "solid", {100, 0, 0}, {120, 10, 5}, 1000);
  // The part's z is the file's x, its x the file's y, its y the file's z.
  expectBody(product, "shell", {1, 1, 1}, {5, 3, 4}, 24);
  expectBody(product, "inch", {0, 50, 0}, {25.4, 75.4, 25.4}, 25.4 * 25.4 * 25.4);
  expectBody(product, "inch#2", {0, 100, 0}, {25.4, 125.4, 25.4}, 25.4 * 25.4 * 25.4);
  expectBody(product, "box", {-5, 0, 0}, {-4, 2, 3}, 6);
  ASSERT_NE(partNamed(product, "sheet"), nullptr);
  EXPECT_EQ(partNamed(product, "sheet")->mesh->triangles.size(), 2);
}

TEST(StepShapes, TessellatedShapesAreMovedMirroredAndScaled) {
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  const std::string kind = "TESSELLATED_SHAPE_REPRESENTATION";
  const std::string mapped = text.representation(text.tessellatedBox({1, 0, 0}, {2, 3, 4}), kind);
  const std::string map = text.add("REPRESENTATION_MAP(" + text.origin() + "," + mapped + ")");
  const std::string x = text.direction({-1, 0, 0});
  const std::string y = text.direction({0, 1, 0});
  const std::string z = text.direction({0, 0, 1});
  const std::string twice = text.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$," + x + "," + y + "," +
                                     text.point({0, 0, 10}) + ",2.," + z + ")");
  text.place(assembly, text.part("mirrored", text.add("MAPPED_ITEM(''," + map + "," + twice + ")")), {0, 0, 0});
  const std::string face = text.triangulatedBox(text.coordinates({0, 0, 0}, {1, 2, 3}));
  const std::string frame = text.placement({10, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const std::string moved = text.add("(GEOMETRIC_REPRESENTATION_ITEM()REPOSITIONED_TESSELLATED_ITEM(" + frame +
                                     ")REPRESENTATION_ITEM('')TESSELLATED_ITEM()TESSELLATED_SOLID((" + face + "),$))");
  text.place(assembly, text.part("moved", moved, kind), {0, 0, 0});
  const StepProduct product = imported(text);
  EXPECT_THAT(product.missing, IsEmpty());
  expectBody(product, "mirrored", {-6, 0, 10}, {-2, 6, 18}, 192);
  expectBody(product, "moved", {10, 0, 0}, {13, 1, 2}, 6);
}

TEST(StepShapes, AFileWithTrianglesAloneIsRead) {
  StepText text;
  text.part("cube", text.tessellatedBox({0, 0, 0}, {20, 20, 20}), "TESSELLATED_SHAPE_REPRESENTATION");
  const StepProduct product = imported(text);
  ASSERT_EQ(product.parts.size(), 1);
  EXPECT_EQ(product.parts.front().path, "cube");
  EXPECT_THAT(product.missing, IsEmpty());
  EXPECT_NEAR(signedVolume(*product.parts.front().mesh), 8e-6, 1e-12);
}

TEST(StepShapes, MoreTrianglesThanAListOfOpenCascadeMayHaveAreRead) {
  constexpr int kSide = 330;  // squares along a side
  constexpr int kRows = 3;    // rows of squares with a triangle each
  StepText text;
  std::string points;
  std::string triangles;
  for (int i = 0; i <= kSide; ++i) {
    for (int k = 0; k <= kSide; ++k) {
      points += (points.empty() ? "(" : ",(") + std::to_string(i) + ".," + std::to_string(k) + ".,0.)";
      if (i >= kRows || k == kSide) continue;
      const int corner = i * (kSide + 1) + k + 1;
      triangles += (triangles.empty() ? "(" : ",(") + std::to_string(corner) + "," +
                   std::to_string(corner + kSide + 1) + "," + std::to_string(corner + 1) + ")";
    }
  }
  const std::string list = text.add("COORDINATES_LIST('',1,(" + points + "))");
  text.part("field", text.add("TRIANGULATED_SURFACE_SET(''," + list + ",1,(),(),(" + triangles + "))"));
  const StepProduct product = imported(text);
  ASSERT_EQ(product.parts.size(), 1);
  EXPECT_EQ(product.parts.front().mesh->triangles.size(), kRows * kSide);
}

TEST(StepShapes, TrianglesBesideASolidAreNoSecondBody) {
  const std::string kind = "TESSELLATED_SHAPE_REPRESENTATION";
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  const std::string linkedSolid = text.box({0, 0, 0}, {1, 2, 3});
  const auto linked = text.part("linked", linkedSolid, "FACETED_BREP_SHAPE_REPRESENTATION");
  const std::string second = text.representation(text.tessellatedBox({0, 0, 0}, {1, 2, 3}, linkedSolid), kind);
  text.add("SHAPE_REPRESENTATION_RELATIONSHIP('',''," + linked.representation + "," + second + ")");
  text.place(assembly, linked, {0, 0, 0});
  const auto alike = text.part("alike", text.box({0, 0, 0}, {1, 2, 3}), "FACETED_BREP_SHAPE_REPRESENTATION");
  const std::string tessellated = text.tessellatedBox({0, 0, 0}, {1, 2, 3});
  text.add("SHAPE_REPRESENTATION_RELATIONSHIP('',''," + alike.representation + "," +
           text.representation(tessellated, kind) + ")");
  text.place(assembly, alike, {10, 0, 0});
  const auto other = text.part("other", text.box({0, 0, 0}, {1, 2, 3}), "FACETED_BREP_SHAPE_REPRESENTATION");
  text.add("SHAPE_REPRESENTATION_RELATIONSHIP('',''," + other.representation + "," +
           text.representation(text.tessellatedBox({5, 0, 0}, {1, 2, 3}), kind) + ")");
  text.place(assembly, other, {20, 0, 0});
  const StepProduct product = imported(text);
  EXPECT_THAT(product.missing, IsEmpty());
  EXPECT_EQ(product.parts.size(), 4);
  EXPECT_THAT(product.warnings, ElementsAre(AllOf(Field(&Diagnostic::location, says(tessellated)),
                                                  Field(&Diagnostic::reason, says("second representation")))));
}

TEST(StepShapes, TrianglesThatCannotBeReadAreNamed) {
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  const std::string list = text.coordinates({0, 0, 0}, {1, 1, 1});
  const std::string face = text.add("TRIANGULATED_FACE(''," + list + ",8,(),$,(),((1,2,9)))");
  text.place(assembly, text.part("broken", text.add("TESSELLATED_SOLID('',(" + face + "),$)")), {0, 0, 0});
  text.place(assembly, text.part("box", text.box({0, 0, 0}, {1, 2, 3})), {5, 0, 0});
  const StepProduct product = imported(text);
  EXPECT_EQ(product.parts.size(), 1);
  EXPECT_THAT(product.missing, ElementsAre(AllOf(missing("broken", "TESSELLATED_SOLID"),
                                                 Field(&MissingShape::reason, says("point 9")))));
}

TEST(StepShapes, ASolidOfNoProductIsABody) {
  StepText text;
  text.part("part", text.box({0, 0, 0}, {1, 2, 3}));
  const std::string alone = text.box({5, 0, 0}, {1, 1, 1});
  const std::string named = text.box({9, 0, 0}, {2, 2, 2}, "spare");
  text.representation(named, "FACETED_BREP_SHAPE_REPRESENTATION", text.inches());
  const StepProduct product = imported(text);
  EXPECT_THAT(product.missing, IsEmpty());
  expectBody(product, "part", {0, 0, 0}, {1, 2, 3}, 6);
  expectBody(product, "solid_" + alone.substr(1), {5, 0, 0}, {6, 1, 1}, 1);
  expectBody(product, "spare", {228.6, 0, 0}, {279.4, 50.8, 50.8}, 50.8 * 50.8 * 50.8);
  EXPECT_THAT(product.warnings,
              UnorderedElementsAre(
                  AllOf(Field(&Diagnostic::location, says(alone)), Field(&Diagnostic::reason, says("no product"))),
                  AllOf(Field(&Diagnostic::location, says(named)), Field(&Diagnostic::reason, says("no product")))));
}

TEST(StepShapes, ASphereWithACircleForItsSeamIsClosed) {
  for (const auto& [normal, first] : {std::pair<StepText::Triple, StepText::Triple>{{0, 1, 0}, {0, 0, -1}},
                                      {{0, 0, 1}, {1, 0, 0}},
                                      {{0.6, 0, 0.8}, {0, 1, 0}}}) {
    StepText text;
    text.part("ball", text.slitSphere(9.0, normal, first));
    const StepProduct product = imported(text);
    ASSERT_EQ(product.parts.size(), 1);
    EXPECT_THAT(product.warnings, IsEmpty());
    EXPECT_TRUE(isClosedSurface(*product.parts.front().mesh));
    const double volume = 4.0 / 3.0 * std::acos(-1.0) * 729.0;
    EXPECT_NEAR(1e9 * signedVolume(*product.parts.front().mesh), volume, 0.02 * volume);
  }
}

TEST(StepShapes, WhatIsPlacedTwiceIsCountedTwice) {
  StepText text;
  StepText::Product assembly = assemblyIn(text);
  StepText::Product inner = text.part("inner", "");
  const auto part =
      text.part("csg", text.add("CSG_SOLID(''," + text.add("SPHERE('',5.," + text.point({0, 0, 0}) + ")") + ")"));
  text.place(inner, part, {0, 0, 0});
  text.place(assembly, inner, {0, 0, 0});
  text.place(assembly, inner, {0, 9, 0});
  // A use without its placement, which OpenCASCADE drops.
  const auto box = text.part("box", text.box({0, 0, 0}, {1, 2, 3}));
  text.place(assembly, box, {5, 0, 0});
  text.add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('','',''," + assembly.definition + "," + box.definition + ",$)");
  const StepProduct product = imported(text);
  EXPECT_EQ(product.parts.size(), 1);
  EXPECT_THAT(product.missing, UnorderedElementsAre(missing("csg", "CSG_SOLID"),
                                                    AllOf(missing("box", "FACETED_BREP"),
                                                          Field(&MissingShape::reason, says("1 of its 2 places")))));
}

}  // namespace
}  // namespace glissade
