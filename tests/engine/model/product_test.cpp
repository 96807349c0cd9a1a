#include "engine/model/product.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "engine/base/random_stream.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

/// A product with bodies of these paths, which are also their ids.
Product productOfPaths(const std::vector<std::string>& paths) {
  std::vector<ProductBody> bodies;
  for (const std::string& path : paths) bodies.push_back({BodyId(path), {path}});
  return Product(bodies);
}

std::set<std::string> idsNamed(const Product& product, const std::string& name) {
  std::set<std::string> ids;
  for (const std::size_t node : product.named(name)) ids.insert(product.nodes()[node].id);
  return ids;
}

std::vector<std::string> idsOf(const Product& product) {
  std::vector<std::string> ids;
  for (const Product::Node& node : product.nodes()) ids.push_back(node.id);
  return ids;
}

std::string parentOf(const Product& product, const std::string& id) {
  const auto node = product.find(id);
  EXPECT_TRUE(node) << id;
  const auto parent = node ? product.nodes()[*node].parent : std::nullopt;
  return parent ? product.nodes()[*parent].id : "";
}

using Ids = std::vector<std::string>;
using Bodies = std::vector<BodyId>;

TEST(Product, HasAssembliesAboveTheirBodies) {
  const Product product = productOfPaths({"pump/cover/screw", "plate", "pump/cover/screw#2", "pump/housing"});
  EXPECT_EQ(idsOf(product),
            (Ids{"pump", "pump/cover", "pump/cover/screw", "plate", "pump/cover/screw#2", "pump/housing"}));
  EXPECT_FALSE(product.nodes()[0].parent || product.nodes()[3].parent) << "at the top";
  EXPECT_EQ(product.nodes()[1].names.product, "cover");
  EXPECT_EQ(product.bodiesBelow(0), (Bodies{"pump/cover/screw", "pump/cover/screw#2", "pump/housing"}));
  EXPECT_EQ(product.bodiesBelow(1), (Bodies{"pump/cover/screw", "pump/cover/screw#2"}));
  EXPECT_EQ(product.bodiesBelow(3), (Bodies{"plate"}));
}

TEST(Product, ANameMeansNodesByTheirEnds) {
  const Product product = productOfPaths({"pump/cover/screw", "motor/cover/screw", "motor/screw"});
  EXPECT_EQ(idsNamed(product, "cover"), (std::set<std::string>{"motor/cover", "pump/cover"}));
  EXPECT_EQ(idsNamed(product, "motor/screw"), (std::set<std::string>{"motor/screw"}));
  EXPECT_EQ(idsNamed(product, "cover/screw"), (std::set<std::string>{"motor/cover/screw", "pump/cover/screw"}));
  EXPECT_TRUE(product.named("crew").empty());
  EXPECT_TRUE(product.named("").empty());
}

/// "M3/6" cannot be a step of a path.
TEST(Product, NodesHaveTheNamesOfTheirFile) {
  const Product product({{"a_b/M3_6", {"a_b/M3_6", productNames({"a/b", "M3/6"})}},
                         {"a_b/part", {"a_b/part", productNames({"a/b", ""})}}});
  EXPECT_EQ(product.nodes()[0].names.product, "a/b");
  EXPECT_EQ(product.nodes()[1].names.product, "M3/6");
  EXPECT_EQ(product.shownNames(), (Ids{"a/b", "M3/6", "part"})) << "an empty name shows nothing";
  EXPECT_EQ(idsNamed(product, "M3/6"), (std::set<std::string>{"a_b/M3_6"}));
  EXPECT_EQ(idsNamed(product, "a/b"), (std::set<std::string>{"a_b"}));
  EXPECT_EQ(idsNamed(product, "a/b/M3/6"), (std::set<std::string>{"a_b/M3_6"}));
}

TEST(Product, SiblingsOfOneNameAreNumbered) {
  const Product product({{"pin", {"pin", productNames({"pin"})}},
                         {"pin#2", {"pin#2", productNames({"pin"})}},
                         {"nut#2", {"nut#2", productNames({"nut"})}}});
  EXPECT_EQ(product.shownNames(), (Ids{"pin", "pin#2", "nut"}));
  EXPECT_EQ(idsNamed(product, "pin"), (std::set<std::string>{"pin"}));
}

/// Bodies "board/C", "board/C#2", … of a product "C" with these names of uses.
Product boardOf(const std::vector<NodeNames>& uses) {
  std::vector<ProductBody> bodies;
  for (const NodeNames& use : uses) {
    const std::string number = bodies.empty() ? "" : "#" + std::to_string(bodies.size() + 1);
    bodies.push_back({BodyId("board/C" + number), {"board/C" + number, {{"board"}, use}}});
  }
  return Product(bodies);
}

TEST(Product, UsesAreShownByTheirNamesThenTheirDesignators) {
  const Product product =
      boardOf({{"C", "left", "C1"}, {"C", "", "C2"}, {"C", "NAUO3", ""}, {"C", "left", ""}, {"C", "C_5", "C_5"}});
  EXPECT_EQ(product.shownNames(), (Ids{"board", "left", "C2", "C", "left#2", "C#2"}));
  EXPECT_EQ(product.labels({"board/C", "board/C#4"}), (Ids{"left", "left#2"}));
  EXPECT_EQ(idsNamed(product, "left#2"), (std::set<std::string>{"board/C#4"}));
  EXPECT_EQ(idsNamed(product, "board/C2"), (std::set<std::string>{"board/C#2"}));
  EXPECT_EQ(idsNamed(product, "C1"), (std::set<std::string>{"board/C"})) << "by what is not shown, too";
  EXPECT_EQ(idsNamed(product, "C"), (std::set<std::string>{"board/C#3"})) << "as it is shown";
  EXPECT_EQ(idsNamed(product, "board/C#4"), (std::set<std::string>{"board/C#4"})) << "by its id";
  EXPECT_EQ(idsNamed(product, "#5"), (std::set<std::string>{"board/C#5"})) << "by its number";
  EXPECT_TRUE(product.named("#6").empty() || product.named("#0").empty());
}

TEST(Product, LabelsAreTheShortestEndsThatNoOtherHas) {
  const Product product({{"a/x", {"a/x", productNames({"a", "1/4-20"})}},
                         {"b/x", {"b/x", productNames({"b", "1/4-20"})}},
                         {"b/y", {"b/y", productNames({"b", "nut"})}}});
  EXPECT_EQ(product.labels({"a/x", "b/x", "b/y"}), (Ids{"a/1/4-20", "b/1/4-20", "nut"}));
  EXPECT_EQ(product.labels({"a/x", "b/y"}), (Ids{"1/4-20", "nut"}));
}

/// Each label is an end of its own path and of no other, and no shorter end is.
TEST(Product, LabelsOfRandomTrees) {
  RandomStream random(1, "trees");
  const auto word = [&] { return std::string(1, static_cast<char>('a' + static_cast<int>(random.uniform(0.0, 3.0)))); };
  for (int round = 0; round < 200; ++round) {
    std::set<std::string> paths;
    const int count = 1 + static_cast<int>(random.uniform(0.0, 12.0));
    for (int i = 0; i < count; ++i) {
      std::string path = word();
      for (int depth = static_cast<int>(random.uniform(0.0, 5.0)); depth > 0; --depth) path = joinedPath(path, word());
      paths.insert(path);
    }
    std::erase_if(paths, [&](const std::string& path) {
      return std::any_of(paths.begin(), paths.end(),
                         [&](const auto& other) { return other != path && isWithin(other, path); });
    });
    const Ids all(paths.begin(), paths.end());
    const Ids labels = productOfPaths(all).labels(all);
    EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_TRUE(endsInPath(all[i], labels[i]));
      const auto matches = [&](const std::string& end) {
        return std::count_if(all.begin(), all.end(), [&](const std::string& path) { return endsInPath(path, end); });
      };
      if (labels[i] != all[i]) {
        EXPECT_EQ(matches(labels[i]), 1) << labels[i];
      }
      const Ids above = assembliesAbove(labels[i]);
      if (!above.empty()) {
        EXPECT_GT(matches(pathWithin(labels[i], above.front())), 1) << labels[i];
      }
    }
  }
}

/// The ids of a scenario's bodies need not be paths.
TEST(Product, BodiesHaveIdsOfTheirOwnAndPartsBelowThem) {
  const Product product(
      {{"rod.nut", {"rod/nut"}}, {"stand", {"stand"}, {{"bar"}, {"foot/pad"}}}, {"one", {"x"}, {{""}}}});
  EXPECT_EQ(idsOf(product), (Ids{"rod", "rod.nut", "stand", "stand/bar", "stand/foot", "stand/foot/pad", "one"}));
  EXPECT_TRUE(product.nodes()[0].isAssembly);
  EXPECT_FALSE(product.nodes()[2].isAssembly) << "a body, of several rigid bodies";
  EXPECT_EQ(product.bodiesBelow(2), (Bodies{"stand/bar", "stand/foot/pad"}));
  EXPECT_EQ(product.bodiesBelow(6), (Bodies{"one"}));
  EXPECT_EQ(bodiesMeant(product, "rod"), (Bodies{"rod.nut"}));
  EXPECT_EQ(bodiesMeant(product, "nut"), (Bodies{"rod.nut"}));
}

TEST(Product, AnAssemblyThatIsCalledAsABodyHasAnotherId) {
  const Product product({{"pump", {"pump"}, {{"rotor"}}}, {"pump.rotor", {"pump/rotor"}}});
  EXPECT_EQ(idsOf(product), (Ids{"pump", "pump/rotor", "pump#2", "pump.rotor"}));
  EXPECT_EQ(parentOf(product, "pump.rotor"), "pump#2");
}

TEST(Product, WhatIsSaidGoesBeforePaths) {
  const std::vector<ProductBody> bodies{{"a.nut", {"a/nut"}}, {"b", {"b/c"}}, {"d", {"d"}}};
  const Product product(bodies, {{"a", "A / 1", std::nullopt, {{"class", std::string("screw")}}},
                                 {"unit", "Unit", ""},
                                 {"b", std::nullopt, "unit"},
                                 {"d", "D", "a"}});
  EXPECT_EQ(product.nodes()[*product.find("a")].names.product, "A / 1");
  EXPECT_EQ(product.nodes()[*product.find("a")].attributes.size(), 1U);
  EXPECT_EQ(parentOf(product, "b"), "unit");
  EXPECT_EQ(product.nodes()[*product.find("unit")].names.product, "Unit");
  EXPECT_EQ(parentOf(product, "d"), "a");
  EXPECT_EQ(product.bodiesBelow(*product.find("a")), (Bodies{"a.nut", "d"}));
}

TEST(Product, AssembliesThatHoldEachOtherEnd) {
  const Product product({{"nut", {"a/b/nut"}}}, {{"a", std::nullopt, "a/b"}, {"a/b", std::nullopt, "a"}});
  for (const char* id : {"a", "a/b", "nut"}) EXPECT_TRUE(product.find(id)) << id;
  for (std::size_t i = 0; i < product.nodes().size(); ++i) {
    const auto parent = product.nodes()[i].parent;
    EXPECT_TRUE(!parent || *parent < i) << "parents come first";
  }
}

/// Two bodies with one path, and a body below another one, as other programs name them.
TEST(Product, EachBodyIsANodeOfItsOwn) {
  const Product product({{"1", {"a"}}, {"2", {"a"}}, {"3", {"a/b"}}, {"4", {""}}});
  for (const char* id : {"1", "2", "3", "4"}) {
    ASSERT_TRUE(product.find(id)) << id;
    EXPECT_FALSE(product.nodes()[*product.find(id)].isAssembly);
  }
  EXPECT_EQ(parentOf(product, "3"), "a");
}

TEST(Product, ItsUnitIsThatOfMostBodies) {
  const auto in = [](const char* path, double unit) { return TreePlace{path, {}, unit}; };
  EXPECT_EQ(Product().lengthUnit(), 0.0);
  EXPECT_EQ(Product({{"1", in("a", 0.001)}, {"2", in("b", 0.0254)}, {"3", {"c"}, {in("d", 0.0254)}}}).lengthUnit(),
            0.0254);
  const Product equal({{"1", in("a", 0.001)}, {"2", in("b", 0.0254)}, {"3", {"c"}}, {"4", {"d"}}});
  EXPECT_EQ(equal.lengthUnit(), 0.001) << "the first of equally many";
}

/// Compares with the definition: a body is below a node if its path is within the node's.
TEST(Product, BodiesOfANodeAreThoseWithinItsPath) {
  RandomStream random(1, "trees");
  for (int round = 0; round < 200; ++round) {
    std::vector<std::string> paths;
    for (int body = 0; body < 12; ++body) {
      std::string path = "part" + std::to_string(body);
      for (int level = 0; level < 3 && random.uniform() < 0.6; ++level) {
        path = std::string(1, static_cast<char>('a' + static_cast<int>(random.uniform(0.0, 2.999)))) + "/" + path;
      }
      paths.push_back(path);
    }
    const Product product = productOfPaths(paths);
    for (std::size_t node = 0; node < product.nodes().size(); ++node) {
      std::set<BodyId> within;
      for (const std::string& path : paths) {
        if (isWithin(path, product.nodes()[node].path)) within.insert(BodyId(path));
      }
      const Bodies below = product.bodiesBelow(node);
      EXPECT_EQ(std::set<BodyId>(below.begin(), below.end()), within) << product.nodes()[node].path;
      for (const std::size_t child : product.nodes()[node].children) {
        EXPECT_EQ(product.nodes()[child].parent, node);
      }
    }
  }
}

/// A tree with 40 levels and 10,000 bodies of one name; the limit of the time is for a slow machine.
TEST(Product, LargeAndDeepTreesAreQuick) {
  std::string above;
  for (int level = 0; level < 40; ++level) above = joinedPath(above, "level" + std::to_string(level));
  std::vector<ProductBody> bodies;
  for (int i = 0; i < 10'000; ++i) {
    const std::string path = joinedPath(above, i == 0 ? "pin" : "pin#" + std::to_string(i + 1));
    bodies.push_back({BodyId(path), {path}});
  }
  const auto begin = std::chrono::steady_clock::now();
  const Product product(bodies);
  ASSERT_EQ(product.nodes().size(), 10'040U);
  EXPECT_EQ(product.bodiesBelow(0).size(), 10'000U);
  EXPECT_EQ(product.shownNames().size(), 10'040U);
  EXPECT_EQ(bodiesMeant(product, "level39").size(), 10'000U);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

}  // namespace
}  // namespace glissade
