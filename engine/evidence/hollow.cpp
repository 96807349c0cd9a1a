#include "engine/evidence/hollow.h"

#include <algorithm>

#include "engine/evidence/evidence.h"
#include "engine/evidence/surface_cut.h"

namespace glissade::evidence {
namespace {

void add(const Polygon& piece, bool turned, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), piece.begin(), piece.end());
  for (std::uint32_t i = 2; i < piece.size(); ++i) {
    const std::uint32_t a = first + i - 1;
    const std::uint32_t b = first + i;
    mesh.triangles.push_back(turned ? TriangleIndices{first, b, a} : TriangleIndices{first, a, b});
  }
}

}  // namespace

std::optional<TriangleMesh> hollowed(const PlacedBody& body, const PlacedBody& guest, const StopToken& stop) {
  if (!body.interior || !guest.interior || !body.tree.box().intersects(guest.tree.box())) return std::nullopt;
  TriangleMesh left;
  bool isCut = false;
  const auto keepOutside = [&](const CutPiece& piece) {
    isCut = isCut || piece.side == Side::Inside;
    if (piece.side != Side::Inside) add(piece.polygon, false, left);
  };
  const auto addWall = [&](const CutPiece& piece) {
    isCut = isCut || piece.side == Side::Inside;
    if (piece.side == Side::Inside) add(piece.polygon, true, left);
  };
  if (!cutSurface(body, guest, keepOutside, stop) || !cutSurface(guest, body, addWall, stop)) return std::nullopt;
  if (!isCut || left.empty()) return std::nullopt;
  return welded(left);
}

double wallDeflection(const PlacedBody& guest) { return 2.0 * guest.largestDeflection; }

double hollowRoom(const PlacedBody& body, const PlacedBody& guest) {
  return wallDeflection(guest) + body.spacing + guest.spacing +
         assembledMargin(std::max({body.radius, body.halfDiagonal, guest.radius, guest.halfDiagonal}));
}

}  // namespace glissade::evidence
