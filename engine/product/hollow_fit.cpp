#include "engine/product/hollow_fit.h"

namespace glissade {

std::optional<HollowFit> hollowFitOf(const check::Placement& host, const check::Placement& guest,
                                     const std::optional<check::ScrewInSolid>& screw, check::PlacedBodies& placed,
                                     ThinnableBodies& thinnable, const StopToken& stop) {
  const auto hollow = placed.hollowOf(host, guest, stop);
  if (!hollow) return std::nullopt;
  HollowFit fit{MeshPtr(hollow, &hollow->mesh), {}, hollow->depth, 0.0, host.body.spacing + guest.body.spacing};
  fit.room = check::hollowRoom(placed.at(host), placed.at(guest));
  if (screw) {
    fit.surface = screw->room - fit.room;
    fit.room = screw->room;
  }
  const MeshPtr& whole = guest.body.mesh;
  fit.guest = thinnable.thinned(whole, std::vector<double>(whole->triangles.size(), fit.room));
  return fit.guest ? std::optional(fit) : std::nullopt;
}

}  // namespace glissade
