#include "engine/files/fits_json.h"

#include <cmath>

#include "engine/fits/contact_report.h"
#include "engine/model/body_id_json.h"

namespace glissade {
namespace {

constexpr EnumNames<bool, 2> kModeNames{{"off", "on"}};

constexpr FunctionFormat kFitKind{
    [](const JsonCursor& at) {
      const auto kind = kContactKindNames.find(at.text());
      if (!kind || *kind == ContactKind::Clearance) {
        at.fail(GLISSADE_TEXT("is not a kind of fit"),
                GLISSADE_TEXT("Give planar, cylindrical, thread, press, overlap, contact or clash."));
      }
      return *kind;
    },
    [](ContactKind kind) { return kContactKindNames.of(kind); },
    R"({"enum": ["planar", "cylindrical", "thread", "press", "overlap", "contact", "clash"]})"};

/// Throws JsonError where a pair that is no thread has values of threads, which would have no effect.
void demandThread(const FitEdit& edit, const JsonCursor& at, const char* key) {
  const auto found = at.find(key);
  if (!found || edit.kind == ContactKind::Thread) return;
  found->fail(GLISSADE_TEXT("has no effect, because the pair is not marked as a thread"),
              GLISSADE_TEXT("Add \"kind\": \"thread\", or remove it."));
}

void checkPair(const FitEdit& edit, const JsonCursor& at) {
  if (edit.a == edit.b) at.at("b").fail(GLISSADE_TEXT("is the same body as 'a'"));
  demandThread(edit, at, "pitch_m");
  if (at.has("turned") && edit.turned != edit.a && edit.turned != edit.b) {
    at.at("turned").fail(GLISSADE_TEXT("is neither of the two bodies"), GLISSADE_TEXT("Name the body that is turned."));
  }
  demandThread(edit, at, "turned");
}

bool isSamePair(const FitEdit& one, const FitEdit& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

void checkPairs(const FitSettings& fits, const JsonCursor& at) {
  for (std::size_t i = 0; i < fits.pairs.size(); ++i) {
    for (std::size_t earlier = 0; earlier < i; ++earlier) {
      if (!isSamePair(fits.pairs[earlier], fits.pairs[i])) continue;
      at.at("pairs").element(i).fail(GLISSADE_TEXT("is about a pair that was there before"),
                                     GLISSADE_TEXT("Remove one."));
    }
  }
}

}  // namespace

template <class Archive>
void describe(Archive& pair, Type<FitEdit> /*type*/) {
  pair.type("fit_edit");
  pair.required("a", &FitEdit::a, kBodyId, "Id of the object or of a rigid body, as 'glissade-cli fits' names them.");
  pair.required("b", &FitEdit::b, kBodyId);
  pair.optional("kind", &FitEdit::kind, kFitKind, "A pair that is called a thread here comes apart by turning only.");
  pair.optional("allowance", &FitEdit::allowance, kLengthOrZero, "Metres; 0: clearance is required.");
  pair.optional("accepted", &FitEdit::accepted, kBoolean, "A person accepts the clash.");
  pair.optional("pitch_m", &FitEdit::pitch, kPitch,
                "Only with kind thread: metres a turn; below 0: left-handed. Absent: the coarse pitch of ISO 261 for "
                "its radius.");
  pair.optional("turned", &FitEdit::turned, BodyIdFormat{kText},
                "Only with kind thread: id of the body that is turned while the other one is held. Absent: a nut that "
                "nothing holds is turned; else either.");
  pair.check(checkPair);
}

template <class Archive>
void describe(Archive& fits, Type<FitSettings> /*type*/) {
  fits.type("fits",
            "How the object is taken against bodies that it touches or overlaps where the product is assembled (start, "
            "or a goal that is a configuration). Absent: clearance is required of every pair.");
  fits.required("mode", &FitSettings::on, named(kModeNames),
                "on: the object is thinned by each fit's allowance against that body alone.");
  fits.optional("accept_clashes", &FitSettings::acceptedClash, kLengthOrZero,
                "Metres: clashes up to this overlap are accepted.");
  fits.optional("cut", &FitSettings::cut, listOf(kNonEmptyText),
                "Bodies that are cut in accepted clashes where it is not clear which of the two has the hole: ids, or "
                "the end of ids behind a /.");
  fits.optional("pairs", &FitSettings::pairs, kObjects<FitEdit>,
                "A person's statements about pairs, which override measurements.");
  fits.check(checkPairs);
}

template struct ObjectFormat<FitSettings>;

}  // namespace glissade
