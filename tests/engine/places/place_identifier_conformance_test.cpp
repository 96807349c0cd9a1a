// Every place identifier keeps the same contract.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/places/place_identifier.h"
#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

std::vector<std::string> identifierIds() {
  std::vector<std::string> ids;
  const PlaceIdentifierRegistry registry = makePlaceIdentifierRegistry();
  for (const PlaceIdentifierEntry& entry : registry.entries()) ids.push_back(entry.id);
  return ids;
}

/// Input of an identifier, with the data that it refers to.
struct Input {
  FreeSpace space;
  std::vector<double> clearance;
  std::vector<Passage> passages;

  Input(const std::vector<RigidBody>& bodies, const Box3& workspace, int level)
      : space(freeSpaceOf(Octree(bodies, workspace, {workspace.sizes().maxCoeff() / (1 << level), 0}), level)),
        clearance(distanceTransform(space)),
        passages(findPassages(space)) {}
};

std::vector<Input> worlds() {
  std::vector<Input> all;
  all.emplace_back(std::vector<RigidBody>{}, test::twoRooms(), 5);
  all.emplace_back(test::wallWithAHole(), test::twoRooms(), 6);
  RandomStream stream(12, "worlds");
  const Box3 cube(Vector3::Zero(), Vector3::Ones());
  for (int count : {1, 5, 12}) all.emplace_back(test::randomBodies(stream, count), cube, 5);
  all.emplace_back(std::vector<RigidBody>{boxBody("all", Vector3::Constant(3), Pose::identity())}, cube, 4);
  return all;
}

class PlaceIdentifierConformance : public testing::TestWithParam<std::string> {
 protected:
  PlaceLabels identify(const Input& input) const {
    return makePlaceIdentifierRegistry().find(GetParam())->identify({input.space, input.clearance, input.passages});
  }
};

TEST_P(PlaceIdentifierConformance, EveryOpenCellHasALabelAndNoOther) {
  for (const Input& input : worlds()) {
    const PlaceLabels labels = identify(input);
    ASSERT_EQ(labels.size(), input.space.grid.size());
    for (std::size_t cell = 0; cell < labels.size(); ++cell) {
      EXPECT_EQ(labels[cell] != kNoPlace, input.space.open(cell));
    }
  }
}

TEST_P(PlaceIdentifierConformance, LabelsHaveNoGapsAndBeginWithThePassages) {
  int passages = 0;
  for (const Input& input : worlds()) {
    const PlaceLabels labels = identify(input);
    std::set<int> used(labels.begin(), labels.end());
    used.erase(kNoPlace);
    int next = 0;
    for (const int label : used) EXPECT_EQ(label, next++);
    for (std::size_t i = 0; i < input.passages.size(); ++i) {
      std::vector<std::size_t> own;
      for (std::size_t cell = 0; cell < labels.size(); ++cell) {
        if (labels[cell] == static_cast<int>(i)) own.push_back(cell);
      }
      EXPECT_EQ(own, input.passages[i].cells);
      ++passages;
    }
  }
  EXPECT_GT(passages, 0);
}

TEST_P(PlaceIdentifierConformance, PlacesHangTogether) {
  for (const Input& input : worlds()) {
    const PlaceLabels labels = identify(input);
    std::vector<bool> seen(labels.size(), false);
    std::map<int, int> parts;
    for (std::size_t seed = 0; seed < labels.size(); ++seed) {
      if (labels[seed] == kNoPlace || seen[seed]) continue;
      ++parts[labels[seed]];
      std::vector<std::size_t> front{seed};
      seen[seed] = true;
      while (!front.empty()) {
        const std::size_t cell = front.back();
        front.pop_back();
        input.space.grid.forEachNeighbour(cell, [&](std::size_t next) {
          if (seen[next] || labels[next] != labels[seed]) return;
          seen[next] = true;
          front.push_back(next);
        });
      }
    }
    for (const auto& [label, count] : parts) EXPECT_EQ(count, 1) << "place " << label;
  }
}

TEST_P(PlaceIdentifierConformance, SameInputSameLabels) {
  for (const Input& input : worlds()) EXPECT_EQ(identify(input), identify(input));
}

TEST_P(PlaceIdentifierConformance, TwoRoomsJoinedByAHoleAreThreePlaces) {
  const Input input(test::wallWithAHole(), test::twoRooms(), 6);
  ASSERT_EQ(input.passages.size(), 1U);
  EXPECT_EQ(input.passages[0].axis, 0);
  EXPECT_GE(input.passages[0].contraction, 8.0);
  const PlaceLabels labels = identify(input);
  EXPECT_EQ(*std::max_element(labels.begin(), labels.end()), 2);
  const auto labelAt = [&](double x) { return labels[*input.space.grid.find(Vector3(x, 0.5, 0.5))]; };
  EXPECT_EQ(labelAt(1.0), 0);
  EXPECT_NE(labelAt(0.5), labelAt(1.5));
  EXPECT_NE(labelAt(0.5), labelAt(1.0));
}

TEST_P(PlaceIdentifierConformance, OneRoomIsOnePlaceAndNoRoomIsNone) {
  const std::vector<Input> all = worlds();
  const PlaceLabels room = identify(all.front());
  EXPECT_EQ(*std::max_element(room.begin(), room.end()), 0);
  const PlaceLabels none = identify(all.back());
  EXPECT_EQ(*std::max_element(none.begin(), none.end()), kNoPlace);
}

std::string testName(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Registry, PlaceIdentifierConformance, testing::ValuesIn(identifierIds()), testName);

}  // namespace
}  // namespace glissade
