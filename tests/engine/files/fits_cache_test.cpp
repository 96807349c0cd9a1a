#include "engine/files/fits_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "engine/files/product_file.h"
#include "engine/fits/fit_table.h"
#include "engine/sequence/product_finder.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

class FitsCacheTest : public testing::Test {
 protected:
  /// A product with threads, an overlap and thinned bodies.
  static AssembledProduct threaded() {
    AssembledProduct product = loadProduct(test::stepFile("fits.step"))->product;
    product.fits.on = true;
    product.fits.acceptedClash = 0.0005;
    return product;
  }

  std::vector<ObjectFits> found() {
    ThreadTeam team(0);
    return FitTable::find(product_, team, {})->objects();
  }

  static std::optional<std::vector<ObjectFits>> kept(const FitsCache& cache, const AssembledProduct& product,
                                                     const ContactLimits& limits = {}) {
    return cache.find(cache.keyOf(product, limits));
  }
  static void keep(FitsCache& cache, const AssembledProduct& product, const std::vector<ObjectFits>& objects) {
    cache.keep(cache.keyOf(product, {}), objects);
  }

  std::vector<fs::path> files() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder_.path())) all.push_back(entry.path());
    return all;
  }

  static void expectSame(const std::vector<Fit>& one, const std::vector<Fit>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Fit& a = one[i];
      const Fit& b = other[i];
      EXPECT_EQ(std::tie(a.body, a.kind, a.overlap, a.allowance, a.text, a.moving, a.yields, a.hollow),
                std::tie(b.body, b.kind, b.overlap, b.allowance, b.text, b.moving, b.yields, b.hollow));
      EXPECT_EQ(std::tie(a.pitch, a.turns, a.object, a.obstacle, a.role, a.cut, a.refused),
                std::tie(b.pitch, b.turns, b.object, b.obstacle, b.role, b.cut, b.refused));
      EXPECT_EQ(a.evidence.sum(), b.evidence.sum());
      EXPECT_EQ(a.core.has_value(), b.core.has_value());
      ASSERT_EQ(a.thread.has_value(), b.thread.has_value());
      if (a.thread) {
        EXPECT_EQ(a.thread->rule.assembled, b.thread->rule.assembled);
        EXPECT_EQ(a.thread->size, b.thread->size);
      }
      ASSERT_EQ(a.thinned == nullptr, b.thinned == nullptr);
      if (!a.thinned) continue;
      EXPECT_EQ(a.thinned->vertices, b.thinned->vertices);
      EXPECT_EQ(a.thinned->triangles, b.thinned->triangles);
      EXPECT_EQ(a.thinned->faceOf, b.thinned->faceOf);
    }
  }

  const test::TemporaryFolder folder_;
  AssembledProduct product_ = threaded();
  FitsCache cache_{folder_.path(), "1.0"};
};

TEST_F(FitsCacheTest, ReturnsWhatWasKept) {
  EXPECT_FALSE(kept(cache_, product_));
  const std::vector<ObjectFits> objects = found();
  ASSERT_TRUE(std::any_of(objects.begin(), objects.end(), [](const ObjectFits& each) {
    return std::any_of(each.allowed.begin(), each.allowed.end(), [](const Fit& fit) { return fit.thinned != nullptr; });
  }));
  keep(cache_, product_, objects);
  const auto again = kept(FitsCache(folder_.path(), "1.0"), product_);
  ASSERT_TRUE(again);
  ASSERT_EQ(again->size(), objects.size());
  for (std::size_t body = 0; body < objects.size(); ++body) {
    const ObjectFits& one = objects[body];
    const ObjectFits& other = (*again)[body];
    expectSame(one.allowed, other.allowed);
    expectSame(one.clashes, other.clashes);
    ASSERT_EQ(one.contacts.size(), other.contacts.size());
    for (std::size_t i = 0; i < one.contacts.size(); ++i) {
      EXPECT_EQ(one.contacts[i].kind, other.contacts[i].kind);
      EXPECT_EQ(one.contacts[i].gap, other.contacts[i].gap);
      ASSERT_EQ(one.contacts[i].axis.has_value(), other.contacts[i].axis.has_value());
      if (one.contacts[i].axis) {
        EXPECT_EQ(one.contacts[i].axis->radiusB, other.contacts[i].axis->radiusB);
      }
    }
    ASSERT_EQ(one.warnings.size(), other.warnings.size());
    for (std::size_t i = 0; i < one.warnings.size(); ++i) {
      EXPECT_EQ(toString(one.warnings[i]), toString(other.warnings[i]));
    }
  }
}

/// Each of these could change a fit or a message about it.
TEST_F(FitsCacheTest, FindsNothingForAnotherQuestion) {
  keep(cache_, product_, found());
  ASSERT_TRUE(kept(cache_, product_));
  EXPECT_FALSE(kept(FitsCache(folder_.path(), "1.1"), product_));
  ContactLimits wide;
  wide.clearanceUpTo = 0.001;
  EXPECT_FALSE(kept(cache_, product_, wide));
  const auto changed = [&](auto change) {
    AssembledProduct other = product_;
    change(other);
    return !kept(cache_, other);
  };
  EXPECT_TRUE(changed([](AssembledProduct& other) { other.bodies[0].X_WB.position.x() += 1e-9; }));
  EXPECT_TRUE(changed([](AssembledProduct& other) { other.bodies[1].name += "2"; }));
  EXPECT_TRUE(changed([](AssembledProduct& other) { other.bodies[1].label = "renamed"; }));
  EXPECT_TRUE(changed([](AssembledProduct& other) { other.fits.acceptedClash = 0.001; }));
  EXPECT_TRUE(changed([](AssembledProduct& other) { other.fits.cut = {other.bodies[0].id.text()}; }));
  EXPECT_TRUE(changed([](AssembledProduct& other) { other.deflections[0] += 1e-6; }));
  EXPECT_TRUE(changed([](AssembledProduct& other) {
    TriangleMesh mesh = *other.bodies[0].mesh;
    ASSERT_FALSE(mesh.faces.empty());
    mesh.faces[0].radius += 1e-6;
    other.bodies[0].mesh = std::make_shared<TriangleMesh>(std::move(mesh));
  }));
}

TEST_F(FitsCacheTest, ReadsNoDamagedFile) {
  keep(cache_, product_, found());
  const std::string file = files().at(0).string();
  const auto bytes = static_cast<long>(fs::file_size(file));
  for (const long at : {0L, 64L, bytes / 2, bytes - 1}) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(at);
    const char before = static_cast<char>(stream.get());
    stream.seekp(at);
    stream.put(static_cast<char>(before ^ 1));
    stream.close();
    EXPECT_FALSE(kept(cache_, product_)) << "byte " << at;
    std::fstream mend(file, std::ios::in | std::ios::out | std::ios::binary);
    mend.seekp(at);
    mend.put(before);
  }
  EXPECT_TRUE(kept(cache_, product_));
  fs::resize_file(file, 10);
  EXPECT_FALSE(kept(cache_, product_));
}

TEST_F(FitsCacheTest, RemovesTheLeastRecentlyUsedFile) {
  const std::vector<ObjectFits> objects = found();
  keep(cache_, product_, objects);
  const fs::path first = files().at(0);
  const std::size_t bytes = fs::file_size(first);
  fs::last_write_time(first, fs::file_time_type::clock::now() - std::chrono::hours(1));
  AssembledProduct renamed = product_;
  renamed.bodies[0].name = "renamed";
  FitsCache small(folder_.path(), "1.0", bytes * 3 / 2);
  keep(small, renamed, objects);
  EXPECT_EQ(files().size(), 1U);
  EXPECT_TRUE(kept(small, renamed));
  EXPECT_FALSE(kept(small, product_));
}

TEST_F(FitsCacheTest, AFinderDoesNotFindKeptFitsAgain) {
  ThreadTeam team(0);
  keep(cache_, product_, std::vector<ObjectFits>(product_.bodies.size()));
  ProductFinder finder(std::make_unique<FitsCache>(folder_.path(), "1.0"));
  EXPECT_TRUE((*finder.fits(product_, team, {}))->pairs().empty()) << "the kept table, which has no pair";
  product_.fits.acceptedClash = 0.0;
  EXPECT_FALSE((*finder.fits(product_, team, {}))->pairs().empty());
  EXPECT_TRUE(kept(cache_, product_));
}

/// The version of changed sources says nothing about their results.
TEST(UsersFitsCache, IsOffForChangedSources) {
  EXPECT_EQ(usersFitsCache("0.1.0 (1a2b3c4-dirty)"), nullptr);
  EXPECT_NE(usersFitsCache("0.1.0 (1a2b3c4)"), nullptr);
}

}  // namespace
}  // namespace glissade
