#include "engine/assembly/product_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/assembly/body_path.h"
#include "engine/base/random_stream.h"

namespace glissade {
namespace {

std::set<std::string> pathsNamed(const ProductTree& tree, const std::string& name) {
  std::set<std::string> paths;
  for (const std::size_t node : tree.named(name)) paths.insert(tree.nodes()[node].path);
  return paths;
}

TEST(ProductTree, HasAssembliesAboveTheirBodies) {
  const ProductTree tree({"pump/cover/screw", "plate", "pump/cover/screw#2", "pump/housing"});
  std::vector<std::string> paths;
  for (const ProductTree::Node& node : tree.nodes()) paths.push_back(node.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"pump", "pump/cover", "pump/cover/screw", "plate", "pump/cover/screw#2",
                                             "pump/housing"}));
  EXPECT_FALSE(tree.nodes()[0].parent || tree.nodes()[3].parent) << "at the top";
  EXPECT_EQ(tree.nodes()[1].name, "cover");
  EXPECT_EQ(tree.bodiesOf(0), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(tree.bodiesOf(1), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(tree.bodiesOf(3), (std::vector<std::size_t>{1}));
}

TEST(ProductTree, ANameMeansNodesByTheirEnds) {
  const ProductTree tree({"pump/cover/screw", "motor/cover/screw", "motor/screw"});
  EXPECT_EQ(pathsNamed(tree, "cover"), (std::set<std::string>{"motor/cover", "pump/cover"}));
  EXPECT_EQ(pathsNamed(tree, "motor/screw"), (std::set<std::string>{"motor/screw"}));
  EXPECT_EQ(pathsNamed(tree, "cover/screw"), (std::set<std::string>{"motor/cover/screw", "pump/cover/screw"}));
  EXPECT_TRUE(tree.named("crew").empty());
  EXPECT_TRUE(tree.named("").empty());
}

/// Two bodies of one path, and a body below another one, as other programs name them.
TEST(ProductTree, EachBodyIsANodeOfItsOwn) {
  const ProductTree tree({"a", "a", "a/b", ""});
  std::multiset<std::size_t> bodies;
  for (const ProductTree::Node& node : tree.nodes()) {
    if (node.body) bodies.insert(*node.body);
  }
  EXPECT_EQ(bodies, (std::multiset<std::size_t>{0, 1, 2, 3}));
}

/// Against the definition: a body is below a node where its path is within the node's.
TEST(ProductTree, BodiesOfANodeAreThoseWithinItsPath) {
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
    const ProductTree tree(paths);
    for (std::size_t node = 0; node < tree.nodes().size(); ++node) {
      std::vector<std::size_t> within;
      for (std::size_t body = 0; body < paths.size(); ++body) {
        if (isWithin(paths[body], tree.nodes()[node].path)) within.push_back(body);
      }
      EXPECT_EQ(tree.bodiesOf(node), within) << tree.nodes()[node].path;
      for (const std::size_t child : tree.nodes()[node].children) EXPECT_EQ(tree.nodes()[child].parent, node);
    }
  }
}

}  // namespace
}  // namespace glissade
