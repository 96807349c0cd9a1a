#include "engine/import/open_faces.h"

#include <gmock/gmock.h>

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A tetrahedron whose faces have vertices of their own.
struct Tetrahedron {
  Tetrahedron() {
    const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int sides[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    for (const auto& side : sides) {
      for (const int corner : side) {
        indices.push_back(static_cast<std::uint32_t>(vertices.size() / 3));
        vertices.insert(vertices.end(), corners[corner], corners[corner] + 3);
      }
      faces.emplace_back().triangles = 1;
    }
  }

  std::set<std::string> open() const { return openFaces({vertices, indices, faces, entities}); }

  std::vector<double> vertices{};
  std::vector<std::uint32_t> indices{};
  std::vector<import_protocol::Face> faces{};
  std::vector<std::string> entities{"#17", "#25", "#33", "#41"};
};

TEST(OpenFaces, AClosedSurfaceHasNone) { EXPECT_THAT(Tetrahedron().open(), IsEmpty()); }

TEST(OpenFaces, TheNeighboursOfAFaceWithoutTrianglesAreNamed) {
  Tetrahedron solid;
  solid.indices.resize(9);
  solid.faces[3].triangles = 0;
  EXPECT_THAT(solid.open(), ElementsAre("#17", "#25", "#33"));
}

/// The vertex of one face is beside the edge that it shares with two others.
TEST(OpenFaces, FacesThatDoNotMeetAtAnEdgeAreNamed) {
  Tetrahedron solid;
  solid.vertices[3 * 1 + 2] += 1e-6;
  EXPECT_THAT(solid.open(), ElementsAre("#17", "#33", "#41"));
}

TEST(OpenFaces, AFaceThatIsTurnedOverIsNamedWithItsNeighbours) {
  Tetrahedron solid;
  std::swap(solid.indices[0], solid.indices[1]);
  EXPECT_THAT(solid.open(), ElementsAre("#17", "#25", "#33", "#41"));
}

}  // namespace
}  // namespace glissade
