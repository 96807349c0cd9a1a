#include "engine/fits/judged_threads.h"

#include <algorithm>

#include "engine/fits/assembled_product.h"
#include "engine/fits/fit_words.h"

namespace glissade {

JudgedThreads::JudgedThreads(const AssembledProduct& product, evidence::PartingWords partings)
    : product_(product), words_(wordsOf(product.fits)) {
  words_.partings = std::move(partings);
}

/// True if the judge permits a pull: for meshes without stated faces, by a person's statement, and for a hollow pair
/// that the evidence would refuse without an accepted clash.
bool JudgedThreads::mayBePulled(std::size_t body, std::size_t other, const std::vector<Fit>& fits) {
  const evidence::Body own = product_.measured(body);
  const evidence::Body obstacle = product_.measured(other);
  if (own.mesh->faces.empty() || obstacle.mesh->faces.empty()) return true;
  if (!words_.partingOf(own.id, obstacle.id).empty()) return true;
  const auto isCut = [](const Fit& fit) { return fit.hollow && fit.kind != ContactKind::Thread; };
  if (std::none_of(fits.begin(), fits.end(), isCut)) return false;
  evidence::FitWords strict = words_;
  strict.acceptedClash = 0.0;
  return !placed_.boundsOf({own, own.X_WB}, {obstacle, obstacle.X_WB}, strict, nullptr, {}).refused().empty();
}

std::vector<evidence::CommonThread> JudgedThreads::of(std::size_t body, std::size_t other, const std::vector<Fit>& fits,
                                                      const StopToken& stop) {
  double overlap = 0.0;
  bool isCalledThread = false;
  bool makesHole = false;
  bool isThinned = false;
  for (const Fit& fit : fits) {
    if (fit.thread) return {};
    makesHole = makesHole || (fit.hollow && fit.kind == ContactKind::Thread);
    overlap = std::max(overlap, fit.evidence.overlap);
    isCalledThread = isCalledThread || fit.kind == ContactKind::Thread;
    isThinned = isThinned || fit.thinned != nullptr;
  }
  if ((!isCalledThread && !isThinned) || mayBePulled(body, other, fits)) return {};
  const evidence::Body own = product_.measured(body);
  const evidence::Body obstacle = product_.measured(other);
  std::optional<evidence::ScrewInSolid> screw;
  if (makesHole) screw = evidence::screwInSolid({own, own.X_WB}, {obstacle, obstacle.X_WB}, placed_, stop);
  if (makesHole && !screw) screw = evidence::screwInSolid({obstacle, obstacle.X_WB}, {own, own.X_WB}, placed_, stop);
  return evidence::commonThreads({placed_.at({own, own.X_WB}), placed_.at({obstacle, obstacle.X_WB}), overlap,
                                  isCalledThread, screw ? &*screw : nullptr, own.name, obstacle.name},
                                 stop);
}

}  // namespace glissade
