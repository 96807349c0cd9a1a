#include "engine/import/step_composition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "engine/base/file.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/import/import_protocol.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/step_instances.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::partTwice;
using test::replaced;
using test::SecondPart;
using test::stepFile;
using test::stepText;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::array kSplit{"split.step", "split-plate.stp", "split-pin.stp", "split-housing.stp", "split-rotor.stp"};

std::vector<std::string> pathsOf(const StepProduct& product) {
  std::vector<std::string> paths;
  for (const Occurrence& part : product.parts) paths.push_back(part.path);
  return paths;
}

/// A product with its parts in separate files, in a temporary folder.
class SplitProduct : public testing::Test {
 protected:
  SplitProduct() {
    for (const char* name : kSplit) fs::copy_file(stepFile(name), folder / name);
  }
  Result<StepProduct> import() const { return importStep(folder / "split.step", 0.0); }
  void remove(const std::string& name) const { fs::remove(folder / name); }

  TemporaryFolder folder;
};

TEST_F(SplitProduct, IsReadWithItsFiles) {
  const auto product = import();
  ASSERT_TRUE(product.ok()) << toString(product.error());
  EXPECT_TRUE(product->warnings.empty()) << toString(product->warnings.front());
  ASSERT_THAT(pathsOf(*product), ElementsAre("plate", "pin", "pin#2", "pump/housing", "pump/rotor"));
  EXPECT_EQ(product->parts[1].mesh, product->parts[2].mesh) << "a file is read once";
  const auto middle = [&](std::size_t i) {
    return Vector3(boundingBox(*product->parts[i].mesh, product->parts[i].X_FP).center());
  };
  EXPECT_TRUE(middle(1).isApprox(Vector3(0, 0, 0.01), 1e-3));
  EXPECT_TRUE(middle(2).isApprox(Vector3(0, 0.2, 0.008), 1e-3));
  EXPECT_TRUE(middle(4).isApprox(Vector3(0.3, 0, -0.03), 1e-3))
      << "turned with its assembly: " << middle(4).transpose();
  for (const Occurrence& part : product->parts) EXPECT_TRUE(audit(*part.mesh).closed()) << part.path;
  std::vector<std::string> names;
  for (const StepPartFile& file : product->partFiles) {
    names.push_back(file.name);
    EXPECT_EQ(file.sha256, sha256(stepText(file.name)));
  }
  EXPECT_THAT(
      names, testing::UnorderedElementsAre("split-plate.stp", "split-pin.stp", "split-housing.stp", "split-rotor.stp"));
}

TEST_F(SplitProduct, WhatIsMissingIsToldAndTheRestLoads) {
  remove("split-pin.stp");
  const auto product = import();
  ASSERT_TRUE(product.ok()) << toString(product.error());
  EXPECT_THAT(pathsOf(*product), ElementsAre("plate", "pump/housing", "pump/rotor"));
  ASSERT_EQ(product->warnings.size(), 1U);
  EXPECT_EQ(toString(product->warnings[0].location), "part 'pin', 'pin#2'");
  EXPECT_THAT(toString(product->warnings[0].reason), HasSubstr("is missing, and certificates take it as free space"));
  EXPECT_THAT(toString(product->warnings[0].reason), HasSubstr("'split-pin.stp' is not there"));
  EXPECT_THAT(toString(product->warnings[0].reason), HasSubstr(folder.path()));
}

TEST_F(SplitProduct, WithoutAnyOfItsFilesSaysWhichAndWhere) {
  for (std::size_t i = 1; i < kSplit.size(); ++i) remove(kSplit[i]);
  const auto product = import();
  ASSERT_FALSE(product.ok());
  EXPECT_EQ(product.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(product.error().file, folder / "split.step");
  for (std::size_t i = 1; i < kSplit.size(); ++i) EXPECT_THAT(toString(product.error().reason), HasSubstr(kSplit[i]));
  EXPECT_THAT(toString(product.error().reason), HasSubstr("looked for in '" + folder.path() + "'"));
  EXPECT_FALSE(product.error().advice.empty());
}

TEST_F(SplitProduct, AFileThatCannotBeReadIsNamed) {
  const std::string pin = stepText("split-pin.stp");
  for (int i = 1; i < 8; ++i) {
    folder.write("split-pin.stp", pin.substr(0, pin.size() * static_cast<std::size_t>(i) / 8));
    const auto cut = import();
    ASSERT_FALSE(cut.ok());
    EXPECT_EQ(cut.error().file, folder / "split-pin.stp");
    EXPECT_THAT(toString(cut.error().reason), HasSubstr("cut off"));
  }
  folder.write("split-pin.stp", "solid a\n");
  const auto mesh = import();
  ASSERT_FALSE(mesh.ok());
  EXPECT_THAT(toString(mesh.error().reason), HasSubstr("not a STEP file"));
}

TEST_F(SplitProduct, OfTruncatedTextNeverReachesThisProcess) {
  const std::string good = stepText("split.step");
  for (int i = 1; i < 12; ++i) {
    const std::string some = good.substr(0, good.size() * static_cast<std::size_t>(i) / 12);
    folder.write("split.step", some + "\nENDSEC;\nEND-ISO-10303-21;\n");
    const auto product = import();
    if (product) {
      EXPECT_FALSE(product->parts.empty());
    } else {
      EXPECT_EQ(product.error().kind, ErrorKind::MalformedInput) << toString(product.error());
    }
  }
}

TEST_F(SplitProduct, NothingOutsideItsFolderIsRead) {
  const TemporaryFolder elsewhere;
  fs::rename(folder / "split-pin.stp", elsewhere / "split-pin.stp");
  const std::string product = stepText("split.step");
  const std::string upwards = "../" + fs::path(elsewhere.path()).filename().string() + "/split-pin.stp";
  folder.write("split.step", replaced(product, "'split-pin.stp'", "'" + upwards + "'"));
  const auto up = import();
  ASSERT_TRUE(up.ok()) << toString(up.error());
  ASSERT_EQ(up->warnings.size(), 1U);
  EXPECT_THAT(toString(up->warnings[0].reason), HasSubstr("is outside"));

  folder.write("split.step", product);
  fs::create_symlink(elsewhere / "split-pin.stp", folder / "split-pin.stp");
  const auto linked = import();
  ASSERT_TRUE(linked.ok()) << toString(linked.error());
  EXPECT_EQ(linked->parts.size(), 3U);
  EXPECT_THAT(toString(linked->warnings.at(0).reason), HasSubstr("is outside"));
}

TEST_F(SplitProduct, NamesOfAnotherMachineAreLookedForBesideTheFile) {
  const std::string product = stepText("split.step");
  for (const std::string before : {"E:\\\\Public\\\\s1\\\\", "/home/someone/"}) {
    folder.write("split.step", replaced(product, "'split-pin.stp'", "'" + before + "split-pin.stp'"));
    const auto read = import();
    ASSERT_TRUE(read.ok()) << toString(read.error());
    EXPECT_EQ(read->parts.size(), 5U) << before;
  }
  fs::create_directory(folder / "parts");
  fs::rename(folder / "split-pin.stp", folder / "parts/split-pin.stp");
  folder.write("split.step", replaced(product, "'split-pin.stp'", "'.\\\\parts\\\\split-pin.stp'"));
  const auto below = import();
  ASSERT_TRUE(below.ok()) << toString(below.error());
  EXPECT_EQ(below->parts.size(), 5U);
}

/// Files that exist by name only, with their content.
class ComposedFiles : public testing::Test {
 protected:
  StepAnswer& add(const std::string& name) {
    folder.write(name, name);
    return answers_[folder / name];
  }
  static Occurrence part(const std::string& path) {
    return {path, std::make_shared<const TriangleMesh>(makeBox(Vector3(1, 1, 1))), {}, {}, 0.0, 0};
  }
  static StepExternal use(const std::string& path, const std::string& file) { return {path, Pose::identity(), file}; }
  Result<StepProduct> compose(const std::string& name) {
    return composeStepProduct({folder / name, name}, [&](const FileContent& content) -> Result<StepAnswer> {
      ++reads_;
      return answers_.at(content.file);
    });
  }
  void expectRefused(const std::string& name, const std::string& reason) {
    const auto product = compose(name);
    ASSERT_FALSE(product.ok());
    EXPECT_EQ(product.error().kind, ErrorKind::MalformedInput);
    EXPECT_THAT(toString(product.error().reason), HasSubstr(reason));
  }

  TemporaryFolder folder;
  std::map<std::string, StepAnswer> answers_;
  int reads_ = 0;
};

TEST_F(ComposedFiles, PlacesOfFilesInFilesAreComposed) {
  const Pose shift = Pose::translation(Vector3(1, 2, 3));
  const Pose turn{Vector3(0, 0, 1), fromRollPitchYaw(0.3, -0.2, 1.0)};
  Occurrence bolt = part("");
  bolt.X_FP = turn;
  StepAnswer& inner = add("sub/inner.stp");
  inner.rootName = "a name that the user of the file knows better";
  inner.parts = {bolt};
  add("sub/outer.stp").externals = {{"inner", turn, "inner.stp"}};
  add("top.stp").externals = {{"outer", shift, "sub/outer.stp"}};
  const auto product = compose("top.stp");
  ASSERT_TRUE(product.ok()) << toString(product.error());
  ASSERT_EQ(product->parts.size(), 1U);
  EXPECT_EQ(product->parts[0].path, "outer/inner");
  const Vector3 p(0.4, -0.7, 2.0);
  EXPECT_TRUE((product->parts[0].X_FP * p).isApprox(shift * (turn * (turn * p)), 1e-12));
  EXPECT_EQ(product->partFiles.back().name, "sub/inner.stp") << "found beside the file that names it";
}

TEST_F(ComposedFiles, CirclesAreRefused) {
  StepAnswer& a = add("a.stp");
  a.parts = {part("own")};
  a.externals = {use("a", "a.stp")};
  expectRefused("a.stp", "holds this file itself");
  add("b.stp").externals = {use("c", "c.stp")};
  add("c.stp").externals = {use("b", "b.stp")};
  expectRefused("b.stp", "holds this file itself");
}

TEST_F(ComposedFiles, EachFileIsReadOnceAndItsUsesAreBounded) {
  constexpr int kLevels = 30;
  for (int i = 0; i < kLevels; ++i) {
    const std::string next = std::to_string(i + 1) + ".stp";
    add(std::to_string(i) + ".stp").externals = {use("a", next), use("b", next)};
  }
  add(std::to_string(kLevels) + ".stp").parts = {part("p")};
  expectRefused("0.stp", "more than");  // two to the power of thirty parts
  EXPECT_EQ(reads_, kLevels + 1);
}

TEST_F(ComposedFiles, UsesOfFilesThatAreMissingAreBounded) {
  constexpr int kLevels = 30;
  for (int i = 0; i < kLevels; ++i) {
    const std::string next = std::to_string(i + 1) + ".stp";
    add(std::to_string(i) + ".stp").externals = {use("a", next), use("b", next)};
  }
  expectRefused("0.stp", "more than");
}

TEST_F(ComposedFiles, DepthAndNumberAreBounded) {
  for (int i = 0; i <= import_protocol::kDeepestAssembly; ++i) {
    add(std::to_string(i) + ".stp").externals = {use("a", std::to_string(i + 1) + ".stp")};
  }
  add(std::to_string(import_protocol::kDeepestAssembly + 1) + ".stp").parts = {part("p")};
  expectRefused("0.stp", "nested too deeply");
  StepAnswer& top = add("top.stp");
  for (std::uint32_t i = 0; i <= import_protocol::kMostFiles; ++i) {
    const std::string name = "n" + std::to_string(i) + ".stp";
    add(name).parts = {part("p")};
    top.externals.push_back(use(std::to_string(i), name));
  }
  expectRefused("top.stp", "names more than 1000 files");
}

TEST_F(ComposedFiles, ManyMissingFilesAreCounted) {
  StepAnswer& top = add("top.stp");
  top.parts = {part("own")};
  for (int i = 0; i < 50; ++i) top.externals.push_back(use(std::to_string(i), std::to_string(i) + ".CATPart"));
  const auto product = compose("top.stp");
  ASSERT_TRUE(product.ok()) << toString(product.error());
  ASSERT_EQ(product->warnings.size(), 21U);
  EXPECT_THAT(toString(product->warnings.back().reason), HasSubstr("30 more files"));
}

Box3 placedBox(const Occurrence& part) { return boundingBox(*part.mesh, part.X_FP); }

/// Expects that the triangles are in the planes of their faces, with the same orientation.
void expectPlanes(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.faces.size(), 6U);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const SurfaceFace& face = mesh.faces[mesh.faceOf[t]];
    EXPECT_EQ(face.kind, SurfaceFace::Kind::Plane);
    EXPECT_TRUE(faceNormal(mesh, mesh.triangles[t]).isApprox(face.axis, 1e-12));
    EXPECT_NEAR(face.axis.dot(mesh.vertices[mesh.triangles[t][0]] - face.point), 0.0, 1e-15);
  }
}

/// `linear`: linear part of the expected transformation.
void expectSecondBox(const SecondPart& second, const Eigen::Matrix3d& linear) {
  const TemporaryFolder folder;
  const auto product = importStep(folder.write("two.step", partTwice(second, "box.step")), 0.0);
  ASSERT_TRUE(product.ok()) << toString(product.error());
  ASSERT_EQ(product->parts.size(), 2U);
  const Box3 first(Vector3(-0.05, -0.025, -0.01), Vector3(0.05, 0.025, 0.01));
  Box3 expected;
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner = first.corner(static_cast<Box3::CornerType>(i)) - Vector3(0.01, 0.02, 0.005);
    expected.extend(Vector3(0.007, -0.003, 0.1) + linear * corner);
  }
  const std::size_t other = placedBox(product->parts[0]).isApprox(first, 1e-9) ? 1 : 0;
  EXPECT_TRUE(placedBox(product->parts[1 - other]).isApprox(first, 1e-9));
  const Box3 read = placedBox(product->parts[other]);
  EXPECT_TRUE(read.isApprox(expected, 1e-9)) << read.min().transpose() << " to " << read.max().transpose();
  expectPlanes(*product->parts[other].mesh);
  const MeshAudit worth = audit(*product->parts[other].mesh);
  EXPECT_TRUE(worth.closed() && worth.consistentlyOriented);
  EXPECT_NEAR(worth.volume, expected.volume(), 1e-9 * expected.volume()) << "below zero: inside out";
}

/// OpenCASCADE 7.6 would give the part untransformed, and a path past it would be proved.
TEST(StepMirror, AnInstanceIsMirroredAndScaledAsTheFileSays) {
  const auto matrix = [](const Vector3& x, const Vector3& y, const Vector3& z) {
    Eigen::Matrix3d columns;
    columns << x, y, z;
    return columns;
  };
  const Vector3 x = Vector3::UnitX();
  const Vector3 y = Vector3::UnitY();
  const Vector3 z = Vector3::UnitZ();
  expectSecondBox({}, matrix(x, y, z));
  SecondPart mirrored;
  mirrored.y = "0.,-1.,0.";
  expectSecondBox(mirrored, matrix(x, -y, z));
  SecondPart scaled;
  scaled.scale = "2.";
  expectSecondBox(scaled, 2.0 * matrix(x, y, z));
  SecondPart turned;
  turned.x = "0.,0.,-1.";
  turned.y = "-1.,0.,0.";
  turned.z = "0.,-1.,0.";
  turned.scale = "0.5";
  expectSecondBox(turned, 0.5 * matrix(-z, -x, -y));
  // The axes of the mapping are y, z and x of the box. They are mapped to x, -y and z.
  SecondPart mapped;
  mapped.y = "0.,-1.,0.";
  mapped.mappedX = "0.,1.,0.";
  mapped.mappedZ = "1.,0.,0.";
  expectSecondBox(mapped, matrix(z, x, -y));
}

TEST(StepMirror, WhatIsNoMirrorAndNoScaleIsRefusedWithItsEntity) {
  const TemporaryFolder folder;
  const auto reasonOf = [&](const std::string& text) {
    const auto product = importStep(folder.write("refused.step", text), 0.0);
    return product ? std::string("was read") : toString(product.error().reason);
  };
  for (const char* scale : {"0.", "-1.", "1.E9"}) {
    SecondPart impossible;
    impossible.scale = scale;
    EXPECT_THAT(reasonOf(partTwice(impossible, "box.step")), HasSubstr("#900007 scales a part")) << scale;
  }
  SecondPart mirrored;
  mirrored.y = "0.,-1.,0.";
  const std::string unused =
      replaced(partTwice(mirrored, "box.step"), "MAPPED_ITEM('',#900019,#900007)", "MAPPED_ITEM('',#900019,#900010)");
  EXPECT_THAT(reasonOf(unused), HasSubstr("#900007 mirrors a part"));
  EXPECT_THAT(
      reasonOf(replaced(partTwice(mirrored, "box.step"), "REPRESENTATION_MAP(#900018", "REPRESENTATION_MAP(#900015")),
      HasSubstr("#900007 mirrors a part"));
}

}  // namespace
}  // namespace glissade
