#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/import/import_protocol.h"
#include "engine/import/step_import.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::replaced;
using test::stepText;
using test::TemporaryFolder;
using testing::HasSubstr;

void expectRefused(const Result<StepProduct>& parts, const std::string& file, const std::string& reason) {
  ASSERT_FALSE(parts.ok());
  EXPECT_EQ(parts.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(parts.error().file, file);
  EXPECT_THAT(toString(parts.error().reason), HasSubstr(reason));
  EXPECT_FALSE(parts.error().advice.empty());
}

/// Expects an error, or usable parts; no content may have another result.
void expectSane(const std::string& file) {
  const auto product = importStep(file, 0.0);
  if (!product) {
    EXPECT_EQ(product.error().kind, ErrorKind::MalformedInput) << toString(product.error());
    return;
  }
  EXPECT_FALSE(product->parts.empty());
  for (const Occurrence& part : product->parts) {
    EXPECT_FALSE(part.mesh->empty());
    EXPECT_TRUE(boundingBox(*part.mesh, part.X_FP).max().allFinite());
  }
}

TEST(MalformedStep, GivesOneClearMessage) {
  const TemporaryFolder folder;
  const std::string box = stepText("box.step");
  const std::string end = "END-ISO-10303-21;";
  const std::vector<std::tuple<const char*, std::string, const char*>> table{
      {"empty.step", "", "not a STEP file"},
      {"pointer.step", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "Git LFS pointer"},
      {"mesh.stp", "solid a\nfacet normal 0 0 1\n", "not a STEP file"},
      {"zip.step", std::string("PK\x03\x04") + std::string(100, '\0'), "not a STEP file"},
      {"cut.step", box.substr(0, box.size() / 2), "cut off"},
      {"house.stp", replaced(box, "AUTOMOTIVE_DESIGN", "IFC4"), "building model"},
      {"header.step", box.substr(0, box.find("DATA;")) + end, "not sound STEP text"},
      {"nothing.step", box.substr(0, box.find("DATA;")) + "DATA;\nENDSEC;\n" + end, "no product"},
      {"noise.step", "ISO-10303-21;\n" + std::string(2000, '\x7f') + end, "not sound STEP text"},
      {"edge.step", stepText("edge.step"), "neither a solid nor a face"},
      {"huge.step", replaced(box, "50.", "5.E300"), "neither"},
      {"large.step", replaced(box, "50.", "5.E15"), "not finite, or too large"},
  };
  for (const auto& [name, content, reason] : table) {
    SCOPED_TRACE(name);
    const std::string file = folder.write(name, content);
    expectRefused(importStep(file, 0.0), file, reason);
  }
  expectRefused(importStep(folder / "gone.step", 0.0), folder / "gone.step", "No such file");
}

/// The text without the line that contains `what`.
std::string withoutLine(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what);
  const std::size_t begin = text.rfind('\n', at) + 1;
  return text.substr(0, begin) + text.substr(text.find('\n', at) + 1);
}

TEST(MalformedStep, IgesAndBrepGiveOneClearMessage) {
  const TemporaryFolder folder;
  const std::string iges = stepText("surfaces.igs");
  const std::string brep = stepText("solids.brep");
  const std::vector<std::tuple<const char*, std::string, const char*>> table{
      {"empty.igs", "", "cannot be read as IGES"},
      {"step.igs", stepText("box.step"), "cannot be read as IGES: column 73"},
      {"cut.igs", iges.substr(0, iges.rfind('\n', iges.size() / 2)), "cut off"},
      {"gap.igs", withoutLine(iges, "D0000133"), "its line 138 is not numbered as it should be (D133)"},
      {"number.igs", test::replaced(iges, "D0000133", "D0000633"), "its line 138 is not numbered as it should be"},
      {"end.igs", test::replaced(iges, "D0000227", "       "), "of no section"},
      {"cut.brep", brep.substr(0, brep.size() / 2), "it is not sound BREP text"},
      {"words.brep", test::replaced(brep, "TShapes", "Shapes"), "it is not sound BREP text"},
      {"mesh.brep", "solid a\n", "not a BREP file"},
      {"binary.brep", "Open CASCADE Topology V4 (c)\n", "binary BREP file"},
  };
  for (const auto& [name, content, reason] : table) {
    SCOPED_TRACE(name);
    const std::string file = folder.write(name, content);
    expectRefused(importStep(file, 0.0), file, reason);
  }
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

/// The box, with one more entity to which nothing refers.
std::string boxWith(const std::string& entity) {
  return replaced(stepText("box.step"), "ENDSEC;\nEND-ISO", "#900000=" + entity + ";\nENDSEC;\nEND-ISO");
}

/// The id of the first entity whose text begins with `beginning`.
std::string idOf(const std::string& text, const std::string& beginning) {
  const std::size_t at = text.find(beginning);
  const std::size_t begin = text.rfind('#', at);
  return text.substr(begin, text.find_first_of(" =", begin) - begin);
}

/// OpenCASCADE leaves out objects of missing entities: this box had five faces, and only a warning.
TEST(MalformedStep, AReferenceToNothingIsRefusedWithItsEntity) {
  const TemporaryFolder folder;
  const std::string box = stepText("box.step");
  for (const std::string entity :
       {"CLOSED_SHELL('',(", "ADVANCED_FACE('',(", "EDGE_LOOP('',(", "CARTESIAN_POINT('',"}) {
    SCOPED_TRACE(entity);
    std::string text = box;
    const std::string id = idOf(text, entity);
    const bool list = entity.back() == '(';
    const std::size_t at = text.find(entity) + entity.size();
    text.replace(at, list ? 1 : 0, list ? "#9999" : "#99999999,");
    const std::string file = folder.write("a.step", text);
    expectRefused(importStep(file, 0.0), file, id + "=" + entity.substr(0, entity.find('(')) + " refers to #9999");
    expectRefused(importStep(file, 0.0), file, "which is not in the file");
    expectRefused(importStep(file, 0.0), file, "line ");
  }
}

TEST(MalformedStep, AnEntityThatIsThereTwiceIsRefused) {
  const TemporaryFolder folder;
  const std::string box = stepText("box.step");
  const std::string id = idOf(box, "CLOSED_SHELL");
  const std::string file =
      folder.write("a.step", replaced(box, "ENDSEC;\nEND-ISO", id + "=CLOSED_SHELL('',());\nENDSEC;\nEND-ISO"));
  expectRefused(importStep(file, 0.0), file, id + " is there twice");
}

TEST(MalformedStep, EntitiesThatReferToEachOtherAreRefused) {
  const TemporaryFolder folder;
  const std::vector<std::pair<const char*, const char*>> circles{
      {"#900000=X(#900000);", "#900000=X refers to #900000=X"},
      {"#900000=X(1,(#900001));#900001=(Y(#900002)Z());#900002=W($,#900000);", "which refers back to it"}};
  for (const auto& [entities, reason] : circles) {
    SCOPED_TRACE(entities);
    const std::string file = folder.write(
        "a.step", replaced(stepText("box.step"), "ENDSEC;\nEND-ISO", std::string(entities) + "\nENDSEC;\nEND-ISO"));
    expectRefused(importStep(file, 0.0), file, reason);
  }
  // In a valid public file, a representation is among its own items.
  const std::string itself = "#900000=REPRESENTATION('',(#900000),$);";
  const auto sound = importStep(
      folder.write("b.step", replaced(stepText("box.step"), "ENDSEC;\nEND-ISO", itself + "\nENDSEC;\nEND-ISO")), 0.0);
  EXPECT_TRUE(sound.ok()) << toString(sound.error());
}

/// An existing entity that cannot be made is a warning that names it.
TEST(MalformedStep, AFaceThatIsLostIsToldWithItsEntityAndItsConsequence) {
  const TemporaryFolder folder;
  const std::string box = stepText("box.step");
  const std::string shell = idOf(box, "CLOSED_SHELL");
  const std::string face = idOf(box, "ADVANCED_FACE");
  const std::string point = idOf(box, "CARTESIAN_POINT");
  struct Loss {
    std::string text;
    std::string entity;
    std::string reason;
  };
  std::string noFace = box;
  const std::size_t first = noFace.find("CLOSED_SHELL('',(#") + 17;
  noFace.replace(first, noFace.find(',', first) - first, point);
  std::string noSurface = box;
  noSurface.replace(noSurface.find(" PLANE("), std::string(" PLANE(").size(), " UNKNOWN_SURFACE(");
  for (const Loss& loss : {Loss{noFace, shell, "number 1 of its faces is not a face"},
                           Loss{noSurface, shell, "its face " + face + " could not be made"}}) {
    SCOPED_TRACE(loss.reason);
    const auto product = importStep(folder.write("a.step", loss.text), 0.0);
    ASSERT_TRUE(product.ok()) << toString(product.error());
    ASSERT_EQ(product->parts.size(), 1U);
    EXPECT_EQ(product->parts.front().facesWithoutMesh, 1U);
    ASSERT_EQ(product->warnings.size(), 1U);
    const Diagnostic& warning = product->warnings.front();
    EXPECT_EQ(toString(warning.location), loss.entity);
    EXPECT_THAT(toString(warning.reason), HasSubstr(loss.reason));
    EXPECT_THAT(toString(warning.reason), HasSubstr("not closed"));
    EXPECT_THAT(toString(warning.reason), HasSubstr("certificates take what is missing as free space"));
  }
}

/// OpenCASCADE 7.6 crashes on a question about the faces of such a shell.
TEST(MalformedStep, AnOrientedShellThatNamesNoShellIsNamed) {
  const TemporaryFolder folder;
  const std::string box = stepText("box.step");
  const std::string shell = "#900000=ORIENTED_CLOSED_SHELL(''," + idOf(box, "CLOSED_SHELL") + ",.F.);";
  const std::string file = folder.write("a.step", replaced(box, "ENDSEC;\nEND-ISO", shell + "\nENDSEC;\nEND-ISO"));
  expectRefused(importStep(file, 0.0), file, "#900000: it is oriented and names no shell");
}

/// OpenCASCADE 7.6 crashes on a face without its loop, with names of solids and without.
TEST(MalformedStep, ACrashOfTheLibraryIsOneClearMessage) {
  const TemporaryFolder folder;
  std::string text = stepText("box.step");
  text.replace(text.find(" EDGE_LOOP("), std::string(" EDGE_LOOP(").size(), " UNKNOWN_LOOP(");
  const std::string file = folder.write("a.step", text);
  const auto product = importStep(file, 0.0);
  if (!product) {
    expectRefused(product, file, "was not read: the library that reads this format crashed on it");
  } else {
    EXPECT_FALSE(product->warnings.empty()) << "another version";
  }
}

/// OpenCASCADE would compute without end on each of these, or overflow its stack.
TEST(MalformedStep, WhatHangsOpenCascadeIsRefusedBeforeItWithItsLine) {
  const TemporaryFolder folder;
  const std::string box = stepText("box.step");
  const std::string digits(400, '1');
  const std::vector<std::pair<std::string, const char*>> table{
      {replaced(box, "50.", "nan"), "is not a finite number"},
      {replaced(box, "50.", "inf"), "is not a finite number"},
      {boxWith("X(1., nan )"), "'nan' is not a value"},
      {replaced(box, "50.", "-Infinity"), "is not a finite number"},
      {replaced(box, "50.", "1.#INF"), "is not a finite number"},
      {replaced(box, "50.", "1.E400"), "is not a finite number"},
      {replaced(box, "50.", std::string(320, '9') + ".E-5"), "is not a finite number"},
      {replaced(box, "50.", digits), "a number has 401 characters"},
      {replaced(box, "50.", "0." + digits), "a number has 403 characters"},
      {boxWith("X(" + std::string(1'000'000, '(') + std::string(1'000'000, ')') + ")"), "more than 100 deep"},
      {boxWith("X(" + repeated("A(", 10'000) + "1" + repeated(")", 10'000) + ")"), "more than 100 deep"},
      {boxWith("CLOSED_SHELL('',(#1" + repeated(",#1", 1'000'000) + "))"), "more than 100000 values"},
  };
  for (const auto& [content, reason] : table) {
    SCOPED_TRACE(reason);
    const std::string file = folder.write("a.step", content);
    expectRefused(importStep(file, 0.0), file, reason);
    expectRefused(importStep(file, 0.0), file, "line ");
  }
}

TEST(MalformedStep, WhatIsUnusualButSoundIsRead) {
  const TemporaryFolder folder;
  for (const std::string value : {"+5.", "5.e-1", "1.E-400", "5.E+100", ".T.", "$", "*", "'nan, (inf) ''#'",
                                  "(nan(1.))", "\"0FF\"", "/* nan, ((( */ 5.", "((((5.))))", "(((('/*'))))"}) {
    SCOPED_TRACE(value);
    EXPECT_TRUE(importStep(folder.write("a.step", boxWith("UNKNOWN('', (1.," + value + " , 2.))")), 0.0).ok());
  }
}

TEST(MalformedStep, LimitsGrowWithTheFileUpToTheirMaximum) {
  namespace protocol = import_protocol;
  EXPECT_EQ(protocol::stepLimitsFor(0).memory, 2ULL << 30U);
  EXPECT_EQ(protocol::stepLimitsFor(0).seconds, 30U);
  EXPECT_EQ(protocol::stepLimitsFor(20U << 20U).seconds, 70U);
  EXPECT_EQ(protocol::stepLimitsFor(200U << 20U).memory, protocol::kStepLimits.memory);
  EXPECT_EQ(protocol::stepLimitsFor(200U << 20U).seconds, protocol::kStepLimits.seconds);
}

/// OpenCASCADE's time grows with the square of a list's length.
TEST(MalformedStep, WhatTakesLongIsStopped) {
  const TemporaryFolder folder;
  const std::string file = folder.write("long.step", boxWith("CLOSED_SHELL('',(#1" + repeated(",#1", 90'000) + "))"));
  const auto soon = StopToken::Clock::now() + std::chrono::milliseconds(300);
  const auto stopped = importStep(file, 0.0, StopToken().withDeadline(soon));
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
}

TEST(MalformedStep, TruncatedFilesNeverReachThisProcess) {
  const TemporaryFolder folder;
  const std::string good = stepText("unit.step");
  for (int i = 1; i < 12; ++i) {
    const std::string some = good.substr(0, good.size() * static_cast<std::size_t>(i) / 12);
    expectRefused(importStep(folder.write("a.step", some), 0.0), folder / "a.step", "");
    expectSane(folder.write("a.step", some + "\nENDSEC;\nEND-ISO-10303-21;\n"));
  }
}

TEST(MalformedStep, DamagedFilesNeverReachThisProcess) {
  const TemporaryFolder folder;
  RandomStream random(3, "damage");
  for (int i = 0; i < 100; ++i) {
    std::string content = stepText(i % 2 == 0 ? "cylinder.STP" : "unit.step");
    for (int k = 0; k < 4; ++k) {
      // Half of the changes write a digit, which keeps the syntax and changes a value.
      const char damage = static_cast<char>(k % 2 == 0 ? '0' + random.bits() % 10 : random.bits());
      content[random.bits() % content.size()] = damage;
    }
    SCOPED_TRACE(i);
    expectSane(folder.write("a.step", content));
  }
}

TEST(MalformedStep, AnAssemblyOfItselfHasAnEnd) {
  const TemporaryFolder folder;
  // Any product that is used as a part of the unit is the unit.
  std::string text = stepText("unit.step");
  const std::size_t use = text.find("NEXT_ASSEMBLY_USAGE_OCCURRENCE");
  const std::size_t parent = text.find(",#", use);
  const std::size_t child = text.find(",#", parent + 1);
  const std::size_t end = text.find(',', child + 1);
  ASSERT_NE(end, std::string::npos);
  text.replace(child, end - child, text.substr(parent, child - parent));
  expectSane(folder.write("a.step", text));
}

}  // namespace
}  // namespace glissade
