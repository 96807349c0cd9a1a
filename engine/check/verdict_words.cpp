#include "engine/check/verdict_words.h"

#include "engine/base/depth_text.h"
#include "engine/base/quantity_text.h"

namespace glissade::check {

std::string pairInWords(const std::string& one, const std::string& other) {
  return "'" + one + "' and '" + other + "'";
}

std::string inWords(const Evidence& evidence) {
  const double measured = evidence.overlap + evidence.deflection + evidence.spacing + evidence.margin;
  const std::string person = "a person allows " + inMillimetres(evidence.byPerson);
  if (measured == 0.0) return evidence.byPerson > 0.0 ? person : "nothing";
  const std::string words = "overlap " + inMillimetres(evidence.overlap) + ", deflection " +
                            inMillimetres(evidence.deflection) + ", spacing " + inMillimetres(evidence.spacing) +
                            ", gap " + inMillimetres(evidence.margin);
  return evidence.byPerson > 0.0 ? words + ", as a person says of the pair " + inMillimetres(evidence.byPerson) : words;
}

std::string inWords(const AppliedAllowance& allowance) {
  if (allowance.screwHole) {
    return "'" + allowance.thinner + "' is taken without what its screw '" + allowance.against +
           "' fills: the file has no hole there";
  }
  if (allowance.hollow) {
    return "'" + allowance.thinner + "' is taken without what overlaps '" + allowance.against + "', up to " +
           depthInMillimetres(allowance.applied) + " deep: a clash that a person accepts";
  }
  std::string words = "'" + allowance.thinner + "' is taken " + inMillimetres(allowance.applied) +
                      " thinner against '" + allowance.against + "' (" + inWords(allowance.evidence) + ")";
  if (allowance.bend > 0.0) words += ", at the hook that a person lets bend by " + inMillimetres(allowance.bend);
  if (allowance.core) words += ", where its thread is taken away";
  if (allowance.thread) words += ", a thread with a pitch of " + inMillimetres(allowance.thread->pitch);
  return words;
}

std::string allowanceRefused(const AppliedAllowance& allowance, const std::string& reason) {
  const std::string pair = pairInWords(allowance.thinner, allowance.against);
  if (!allowance.stated) return pair + ": " + reason + ". Mend the parts, or accept the clash.";
  const std::string amount = inMillimetres(*allowance.stated);
  std::string words = "the file takes '" + allowance.thinner + "' ";
  words += allowance.hollow ? "without what overlaps '" + allowance.against + "', up to " + amount + " deep"
                            : amount + " thinner against '" + allowance.against + "'";
  words += ", and the judge finds reason for ";
  words += allowance.most > 0.0 ? inMillimetres(allowance.most) + " only (" + inWords(allowance.evidence) + ")"
                                : std::string("nothing");
  if (!reason.empty()) words += ": " + reason;
  return words + ". Plan again, or let a person allow it for this pair.";
}

}  // namespace glissade::check
