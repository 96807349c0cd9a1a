#include "engine/fits/hollow_fit.h"

namespace glissade {

std::optional<HollowFit> hollowFitOf(const evidence::Placement& host, const evidence::Placement& guest,
                                     evidence::PlacedBodies& placed, ThinnableBodies& thinnable,
                                     const StopToken& stop) {
  const auto hollow = placed.hollowOf(host, guest, stop);
  if (!hollow) return std::nullopt;
  const evidence::PlacedBody& filling = placed.at(guest);
  const double room = evidence::hollowRoom(placed.at(host), filling);
  const double wall = evidence::wallDeflection(filling);
  const MeshPtr& whole = guest.body.mesh;
  for (const double surface : {wall, 0.0}) {  // a thin guest has room for the margin only
    HollowFit fit{hollow, {}, room - wall + surface, host.body.spacing + guest.body.spacing, surface};
    fit.guest = thinnable.thinned(whole, std::vector<double>(whole->triangles.size(), fit.room));
    if (fit.guest) return fit;
  }
  return std::nullopt;
}

}  // namespace glissade
