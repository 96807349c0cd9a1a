#include "engine/product/fit_refusals.h"

#include "engine/base/quantity_text.h"

namespace glissade {

std::string noRoom(double allowance) {
  return "fit so that one of them would have to be taken " + inMillimetres(allowance) +
         " thinner, which the local thickness or the shape of neither gives: it counts as a clash";
}

std::string noRoomBeside(double allowance, double opening) {
  return "fit so that one of them would have to be taken " + inMillimetres(allowance) +
         " thinner, which the local thickness or the shape of neither gives, and the surface of one is open " +
         inMillimetres(opening) +
         " from the contact, so that what is inside it there is not known: it counts as a clash";
}

std::string openOnBothSides(double opening, double othersOpening) {
  return "touch where neither can be taken thinner: the surfaces are open " + inMillimetres(opening) + " and " +
         inMillimetres(othersOpening) + " from the contact, so that what is inside them there is not known";
}

}  // namespace glissade
