#include "engine/files/path_glb.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/random_stream.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/files/glb_content.h"
#include "tests/engine/files/path_fixture.h"

namespace glissade {
namespace {

using test::GlbContent;
using Elements = std::vector<std::vector<float>>;

/// The point in glTF's frame, in which the world's z is y.
Vector3 yUp(const Vector3& p_W) { return {p_W.x(), p_W.z(), -p_W.y()}; }

class PathGlb : public test::PathFixture {
 protected:
  std::string bytes() const {
    const Result<std::string> content = pathAsGlb(path_, scenario_, provenance_);
    EXPECT_TRUE(content.ok()) << toString(content.error());
    return *content;
  }
};

/// Plays the file's one animation by section 3.11 and appendix C of the specification.
class Player {
 public:
  explicit Player(const GlbContent& glb) {
    const auto& animation = glb.json["animations"][0];
    for (const auto& channel : animation["channels"]) {
      const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      EXPECT_EQ(sampler["interpolation"], "LINEAR");
      times_ = glb.elements(sampler["input"]);
      (channel["target"]["path"] == "rotation" ? rotations_ : translations_) = glb.elements(sampler["output"]);
    }
  }

  double duration() const { return static_cast<double>(times_.back()[0]); }

  Pose at(double time) const {
    std::size_t next = 1;
    while (next + 1 < times_.size() && static_cast<double>(times_[next][0]) < time) ++next;
    const double from = times_[next - 1][0];
    const double t = (time - from) / (static_cast<double>(times_[next][0]) - from);
    Pose q;
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      q.position[i] = (1.0 - t) * translations_[next - 1][row] + t * translations_[next][row];
    }
    q.orientation = spherical(quaternion(next - 1), quaternion(next), t);
    return q;
  }

 private:
  Quaternion quaternion(std::size_t i) const {
    const std::vector<float>& v = rotations_[i];
    return Quaternion(v[3], v[0], v[1], v[2]);
  }

  static Quaternion spherical(const Quaternion& a, const Quaternion& b, double t) {
    const double cosine = std::min(1.0, std::abs(a.dot(b)));
    const double angle = std::acos(cosine);
    if (angle < 1e-7) return a;
    const double sign = a.dot(b) < 0.0 ? -1.0 : 1.0;
    Quaternion q;
    q.coeffs() = (std::sin(angle * (1.0 - t)) * a.coeffs() + sign * std::sin(angle * t) * b.coeffs()) / std::sin(angle);
    return q.normalized();
  }

  Elements times_, translations_, rotations_;
};

TEST_F(PathGlb, PlaysThePathsOwnConfigurations) {
  const Player player{GlbContent(bytes())};
  const Se3Metric metric = scenario_.problem.metric();
  double length = 0.0;
  for (const double part : path_.lengthByAuthor(metric)) length += part;
  const auto poseAfter = [&](double way) {
    std::size_t i = 1;
    for (; i + 1 < path_.points.size(); ++i) {
      const double edge = metric.distance(path_.points[i - 1].q, path_.points[i].q);
      if (way <= edge) break;
      way -= edge;
    }
    const Pose& from = path_.points[i - 1].q;
    const Pose& to = path_.points[i].q;
    return interpolate(from, to, way / metric.distance(from, to));
  };
  EXPECT_NEAR(player.duration(), 10.0, 1e-5);
  RandomStream stream(1, "times");
  for (int i = 0; i < 1000; ++i) {
    const double time = stream.uniform(0.0, 10.0);
    const Pose expected = poseAfter(length * time / 10.0);
    const Pose q = player.at(time);
    EXPECT_LT((q.position - expected.position).norm(), 1e-6) << time;
    EXPECT_LT(angleBetween(q.orientation, expected.orientation), 1e-6) << time;
  }
}

TEST_F(PathGlb, OurImporterFindsEveryVertexWhereItIsAtTheStart) {
  scenario_.obstacles[0].X_WB = {{0.5, 1.0, 2.0}, fromRollPitchYaw(0.1, 0.2, 0.3)};
  path_.points.front().q = {{-3.0, 0.5, 1.0}, fromRollPitchYaw(-0.3, 0.2, 0.1)};
  const std::string file = folder_.write("a.glb", bytes());
  const Result<ImportedMesh> imported = importMesh(file);
  ASSERT_TRUE(imported.ok()) << toString(imported.error());
  std::vector<Vector3> expected;
  std::size_t triangles = 0;
  RigidBody object = scenario_.object;
  object.X_WB = path_.points.front().q;
  for (const RigidBody& body : {scenario_.obstacles[0], object}) {
    for (const Vector3& vertex : body.mesh->vertices) expected.push_back(yUp(body.X_WB * vertex));
    triangles += body.mesh->triangles.size();
  }
  EXPECT_EQ(imported->mesh.triangles.size(), triangles);
  const auto isIn = [](const Vector3& p, const std::vector<Vector3>& points) {
    return std::any_of(points.begin(), points.end(), [&](const Vector3& other) { return p.isApprox(other, 1e-6); });
  };
  for (const Vector3& vertex : imported->mesh.vertices) EXPECT_TRUE(isIn(vertex, expected)) << vertex.transpose();
  for (const Vector3& vertex : expected) EXPECT_TRUE(isIn(vertex, imported->mesh.vertices)) << vertex.transpose();
}

TEST_F(PathGlb, EveryBodyIsANodeOfItsNameAndColour) {
  scenario_.obstacles[0].colour = {1.0, 0.5, 0.0};
  const GlbContent glb(bytes());
  const auto& nodes = glb.json["nodes"];
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], std::vector<int>{0});
  EXPECT_EQ(nodes[0]["children"], (std::vector<int>{1, 2}));
  EXPECT_EQ(nodes[1]["name"], "The wall");
  EXPECT_EQ(nodes[2]["name"], "Brick");
  const auto materialOf = [&](int node) {
    const auto& primitive = glb.json["meshes"][nodes[node]["mesh"].get<std::size_t>()]["primitives"][0];
    return glb.json["materials"][primitive["material"].get<std::size_t>()];
  };
  const std::vector<double> colour = materialOf(1)["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(colour[0], 1.0, 1e-9);
  EXPECT_NEAR(colour[1], 0.2140411, 1e-6);  // IEC 61966-2-1
  EXPECT_NEAR(colour[2], 0.0, 1e-9);
  EXPECT_EQ(materialOf(1)["alphaMode"], "BLEND");
  EXPECT_FALSE(materialOf(2).contains("alphaMode"));
  for (const auto& channel : glb.json["animations"][0]["channels"]) EXPECT_EQ(channel["target"]["node"], 2);
}

TEST_F(PathGlb, NumbersHaveTheirBoundsAndNormalsTheirFaces) {
  const GlbContent glb(bytes());
  for (std::size_t i = 0; i < glb.json["accessors"].size(); ++i) {
    const Elements elements = glb.elements(i);
    for (std::size_t row = 0; row < elements[0].size(); ++row) {
      const auto byRow = [row](const auto& a, const auto& b) { return a[row] < b[row]; };
      const auto [least, most] = std::minmax_element(elements.begin(), elements.end(), byRow);
      EXPECT_EQ(glb.json["accessors"][i]["min"][row].get<float>(), (*least)[row]);
      EXPECT_EQ(glb.json["accessors"][i]["max"][row].get<float>(), (*most)[row]);
    }
  }
  const auto& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
  const Elements corners = glb.elements(attributes["POSITION"]);
  const Elements normals = glb.elements(attributes["NORMAL"]);
  ASSERT_EQ(corners.size(), 36U);
  ASSERT_EQ(normals.size(), 36U);
  std::set<std::vector<float>> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    float outwards = 0.0F;
    for (std::size_t row = 0; row < 3; ++row) outwards += corners[i][row] * normals[i][row];
    EXPECT_GT(outwards, 0.4F) << "a box of 1 x 4 x 1 about its centre";
    EXPECT_EQ(normals[i], normals[i / 3 * 3]) << "flat";
    sides.insert(normals[i]);
  }
  EXPECT_EQ(sides.size(), 6U);
}

TEST_F(PathGlb, TellsWhereThePathIsFrom) {
  const GlbContent glb(bytes());
  EXPECT_THAT(glb.json["asset"]["generator"].get<std::string>(), testing::StartsWith("Glissade "));
  const auto& extras = glb.json["scenes"][0]["extras"];
  EXPECT_EQ(extras["planner"], "birrt");
  EXPECT_EQ(extras["seed"], 7);
  EXPECT_EQ(extras["certificate"]["status"], "certified");
  EXPECT_GT(extras["certificate"]["min_clearance_m"], 0.0);
}

TEST_F(PathGlb, WhatSinglePrecisionDoesNotHoldIsAnError) {
  path_.points[1].q.position.x() = 1e39;
  const Result<std::string> content = pathAsGlb(path_, scenario_, provenance_);
  ASSERT_FALSE(content.ok());
  EXPECT_EQ(content.error().kind, ErrorKind::MalformedInput);
}

}  // namespace
}  // namespace glissade
