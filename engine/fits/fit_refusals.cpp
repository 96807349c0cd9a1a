#include "engine/fits/fit_refusals.h"

namespace glissade {

Message noRoom(double allowance) {
  return {GLISSADE_TEXT(
              "need an allowance of %1, which the local thickness or the shape of neither gives: it counts as a clash"),
          {Length{allowance}}};
}

Message noRoomBeside(double allowance, double opening) {
  return {GLISSADE_TEXT(
              "need an allowance of %1, which the local thickness or the shape of neither gives, and the surface of "
              "one is open %2 from the contact, so that what is inside it there is not known: it counts as a clash"),
          {Length{allowance}, Length{opening}}};
}

Message openOnBothSides(double opening, double othersOpening) {
  return {GLISSADE_TEXT("touch where neither can have an allowance: the surfaces are open %1 and %2 from the contact, "
                        "so that what is inside them there is not known"),
          {Length{opening}, Length{othersOpening}}};
}

bool isByAcceptedClash(const Allowance& allowance) {
  return allowance.kind == ContactKind::Clash || (allowance.hollow && allowance.kind != ContactKind::Thread);
}

Message adviceToCut(const Allowance& clash, const std::string& own, const std::string& other) {
  if (clash.hollow) {
    return {GLISSADE_TEXT("'%1' is cut, because its clash with '%2' (%3) is accepted; if '%2' is the one to cut, name "
                          "it (--cut \"%2\")"),
            {clash.yields ? other : own, clash.yields ? own : other, Depth{clash.overlap}}};
  }
  return {GLISSADE_TEXT("the clash of '%1' and '%2' (%3) is accepted, and they are thinned where they overlap; if one "
                        "is drawn through the other, name the one to cut (--cut \"%1\" or --cut \"%2\")"),
          {own, other, Depth{clash.overlap}}};
}

}  // namespace glissade
