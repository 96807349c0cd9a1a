// Every exporter of the registry keeps the same contract.
#include "tests/engine/files/path_exporter_conformance.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>

#include "engine/files/path_reader.h"
#include "tests/engine/files/path_fixture.h"

namespace glissade {
namespace {

using test::readWhole;

/// While this object lives, no file can grow beyond a few bytes, as on a full disk.
class FullDisk {
 public:
  FullDisk() : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{16, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

class PathExporterConformance : public test::PathFixture, public testing::WithParamInterface<std::string> {
 protected:
  std::string fileNamed(const std::string& name) const { return folder_ / name + "." + exporter_.endings.front(); }
  std::string written(const std::string& name) const {
    const std::string file = fileNamed(name);
    const SaveResult saved = exporter_.write(path_, scenario_, provenance_, file);
    EXPECT_TRUE(saved.ok()) << toString(saved.why);
    return file;
  }
  std::ptrdiff_t filesInFolder() const {
    return std::distance(std::filesystem::directory_iterator(folder_.path()), std::filesystem::directory_iterator());
  }

  const PathExporterRegistry registry_ = pathExportersUnderTest().registry;
  const PathExporter exporter_ = *registry_.find(GetParam());
};

TEST_P(PathExporterConformance, IsKnownByItsEndings) {
  ASSERT_FALSE(exporter_.endings.empty());
  EXPECT_STRNE(exporter_.label.english, "");
  for (const std::string& ending : exporter_.endings) {
    const Result<PathExporter> found = registry_.forFile("folder.csv/a.b." + ending);
    ASSERT_TRUE(found.ok()) << ending;
    EXPECT_EQ(found->id, exporter_.id);
    EXPECT_THAT(toString(registry_.formats()), testing::HasSubstr("." + ending));
  }
}

TEST_P(PathExporterConformance, SameInputSameBytesAndNothingBesideThem) {
  const std::string first = readWhole(written("a"));
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(readWhole(written("b")), first);
  EXPECT_EQ(filesInFolder(), 2);
}

TEST_P(PathExporterConformance, ReadsBackAsItSays) {
  const Result<std::vector<PathPoint>> points = readPath(written("a"), registry_);
  ASSERT_EQ(points.ok(), exporter_.readBackError.has_value());
  EXPECT_EQ(toString(registry_.readableFormats()).find("." + exporter_.endings.front()) != std::string::npos,
            points.ok());
  if (!points) {
    EXPECT_EQ(points.error().kind, ErrorKind::MalformedInput);
    EXPECT_THAT(toString(points.error()), testing::HasSubstr(toString(registry_.readableFormats())));
    return;
  }
  ASSERT_EQ(points->size(), path_.points.size());
  for (std::size_t i = 0; i < points->size(); ++i) {
    const Pose& before = path_.points[i].q;
    const Pose& after = (*points)[i].q;
    EXPECT_LE((after.position - before.position).cwiseAbs().maxCoeff(), *exporter_.readBackError) << i;
    EXPECT_LE((after.orientation.coeffs() - before.orientation.coeffs()).cwiseAbs().maxCoeff(),
              *exporter_.readBackError)
        << i;
  }
}

TEST_P(PathExporterConformance, AFailedWriteLeavesTheOldFileAndSaysWhy) {
  const std::string file = folder_.write("a." + exporter_.endings.front(), "old");
  const SaveResult saved = [&] {
    const FullDisk disk;
    return exporter_.write(path_, scenario_, provenance_, file);
  }();
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.why.file, file);
  EXPECT_THAT(toString(saved.why.reason), testing::HasSubstr("cannot be saved"));
  EXPECT_EQ(readWhole(file), "old");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_P(PathExporterConformance, AFileThatCannotBeIsAnErrorWithItsReason) {
  const std::string file = fileNamed("missing/a");
  const SaveResult saved = exporter_.write(path_, scenario_, provenance_, file);
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.why.file, file);
  EXPECT_THAT(toString(saved.why.reason), testing::HasSubstr("No such file"));
  EXPECT_FALSE(saved.why.advice.empty());
}

/// The warnings of a save were lost.
TEST_P(PathExporterConformance, WhatASaveWarnsOfIsHandedOn) {
  const std::string file = folder_.write("a." + exporter_.endings.front(), "old");
  ASSERT_EQ(::link(file.c_str(), (file + ".link").c_str()), 0);
  const SaveResult saved = exporter_.write(path_, scenario_, provenance_, file);
  ASSERT_TRUE(saved.ok()) << toString(saved.why);
  ASSERT_EQ(saved.warnings.size(), 1U);
  EXPECT_THAT(toString(saved.warnings.front().reason), testing::HasSubstr("hard link"));
}

TEST_P(PathExporterConformance, AnEmptyPathIsRefused) {
  const std::string file = folder_.write("a." + exporter_.endings.front(), "old");
  const SaveResult saved = exporter_.write({}, scenario_, provenance_, file);
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.why.kind, ErrorKind::Usage);
  EXPECT_EQ(saved.why.file, file);
  EXPECT_THAT(toString(saved.why.reason), testing::HasSubstr("no configuration"));
  EXPECT_EQ(readWhole(file), "old");
}

TEST_P(PathExporterConformance, OneConfigurationIsAPath) {
  path_.points.resize(1);
  const Result<std::vector<PathPoint>> points = readPath(written("a"), registry_);
  if (exporter_.readBackError) {
    ASSERT_TRUE(points.ok());
    EXPECT_EQ(points->size(), 1U);
  }
}

TEST_P(PathExporterConformance, ManagesWithoutAScenarioWhereItSaysSo) {
  if (exporter_.needsScenario) return;
  const std::string file = fileNamed("without");
  ASSERT_TRUE(exporter_.write(path_, {}, {}, file).ok());
  EXPECT_EQ(readWhole(file), readWhole(written("with")));
}

TEST_P(PathExporterConformance, NamesMayBeAnyBytes) {
  scenario_.scenario.name = scenario_.obstacles[0].name = "\xE9\x01\"";
  scenario_.obstacles[0].id = "\xE9\x01\"";
  scenario_.object.name = "";
  written("a");
}

INSTANTIATE_TEST_SUITE_P(Registry, PathExporterConformance, testing::ValuesIn(pathExportersUnderTest().ids),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace glissade
