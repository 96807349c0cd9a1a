#include "engine/files/fits_json.h"

#include <cmath>

#include "engine/base/limits.h"
#include "engine/fits/contact_report.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

double readAllowance(const JsonCursor& at) {
  const double value = at.coordinate();
  if (value < 0.0) at.fail(GLISSADE_TEXT("is below zero"), GLISSADE_TEXT("Give metres, 0 or more."));
  return value;
}

ContactKind readKind(const JsonCursor& at) {
  const auto kind = kContactKindNames.find(at.text());
  if (!kind || *kind == ContactKind::Clearance) {
    at.fail(GLISSADE_TEXT("is not a kind of fit"),
            GLISSADE_TEXT("Give planar, cylindrical, thread, press, overlap, contact or clash."));
  }
  return *kind;
}

/// Throws JsonError where a pair that is no thread has values of threads, which would have no effect.
void demandThread(const JsonCursor& at, const FitEdit& pair) {
  if (pair.kind == ContactKind::Thread) return;
  at.fail(GLISSADE_TEXT("has no effect, because the pair is not marked as a thread"),
          GLISSADE_TEXT("Add \"kind\": \"thread\", or remove it."));
}

double readPitch(const JsonCursor& at, const FitEdit& pair) {
  const double value = at.number();
  // Bounds of the pitch. Smaller pitches are not made; larger ones are no threads but straight motions.
  constexpr double kLeastPitch = 1e-5;
  constexpr double kMostPitch = 1.0;
  if (!(std::abs(value) >= kLeastPitch && std::abs(value) <= kMostPitch)) {
    at.fail(GLISSADE_TEXT("is not a pitch"),
            GLISSADE_TEXT("Give metres a turn, from 0.00001 to 1; below zero for a left-handed thread."));
  }
  demandThread(at, pair);
  return value;
}

std::string readTurned(const JsonCursor& at, const FitEdit& pair) {
  std::string id = at.text();
  if (id != pair.a && id != pair.b)
    at.fail(GLISSADE_TEXT("is neither of the two bodies"), GLISSADE_TEXT("Name the body that is turned."));
  demandThread(at, pair);
  return id;
}

FitEdit readPair(const JsonCursor& at) {
  at.allowOnly({"a", "b", "kind", "allowance", "accepted", "pitch_m", "turned"});
  FitEdit edit;
  edit.a = at.at("a").nonEmptyText();
  edit.b = at.at("b").nonEmptyText();
  if (edit.a == edit.b) at.at("b").fail(GLISSADE_TEXT("is the same body as 'a'"));
  if (const auto kind = at.find("kind")) edit.kind = readKind(*kind);
  if (const auto allowance = at.find("allowance")) edit.allowance = readAllowance(*allowance);
  if (const auto accepted = at.find("accepted")) edit.accepted = accepted->boolean();
  if (const auto pitch = at.find("pitch_m")) edit.pitch = readPitch(*pitch, edit);
  if (const auto turned = at.find("turned")) edit.turned = readTurned(*turned, edit);
  return edit;
}

bool isSamePair(const FitEdit& one, const FitEdit& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

Json toJson(const FitEdit& edit) {
  Json json{{"a", edit.a}, {"b", edit.b}};
  if (edit.kind) json["kind"] = kContactKindNames.of(*edit.kind);
  if (edit.allowance) json["allowance"] = *edit.allowance;
  if (edit.accepted) json["accepted"] = true;
  if (edit.pitch) json["pitch_m"] = *edit.pitch;
  if (!edit.turned.empty()) json["turned"] = edit.turned;
  return json;
}

}  // namespace

FitSettings readFits(const JsonCursor& at) {
  at.allowOnly({"mode", "accept_clashes", "cut", "pairs"});
  FitSettings fits;
  const std::string mode = at.at("mode").text();
  if (mode != "on" && mode != "off") at.at("mode").fail(GLISSADE_TEXT("is neither \"on\" nor \"off\""));
  fits.on = mode == "on";
  if (const auto clash = at.find("accept_clashes")) fits.acceptedClash = readAllowance(*clash);
  const auto cut = at.find("cut");
  for (std::size_t i = 0; cut && i < cut->sizeUpTo(limits::kMostBodies); ++i) {
    fits.cut.push_back(cut->element(i).nonEmptyText());
  }
  const auto pairs = at.find("pairs");
  for (std::size_t i = 0; pairs && i < pairs->sizeUpTo(limits::kMostBodies); ++i) {
    const FitEdit edit = readPair(pairs->element(i));
    for (const FitEdit& earlier : fits.pairs) {
      if (isSamePair(earlier, edit))
        pairs->element(i).fail(GLISSADE_TEXT("is about a pair that was there before"), GLISSADE_TEXT("Remove one."));
    }
    fits.pairs.push_back(edit);
  }
  return fits;
}

void addFits(const FitSettings& fits, Json& json) {
  if (!fits.on && fits.acceptedClash == 0.0 && fits.pairs.empty() && fits.cut.empty()) return;
  Json section{{"mode", fits.on ? "on" : "off"}};
  if (fits.acceptedClash > 0.0) section["accept_clashes"] = fits.acceptedClash;
  if (!fits.cut.empty()) section["cut"] = fits.cut;
  if (!fits.pairs.empty()) section["pairs"] = Json::array();
  for (const FitEdit& edit : fits.pairs) section["pairs"].push_back(toJson(edit));
  json["fits"] = std::move(section);
}

}  // namespace glissade
