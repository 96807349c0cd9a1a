#include "engine/check/verdict_words.h"

#include <sstream>

namespace glissade::check {

Message pairInWords(const std::string& one, const std::string& other) {
  return {GLISSADE_TEXT("'%1' and '%2'"), {one, other}};
}

Message namesInWords(const std::vector<std::string>& names) {
  std::vector<Message> quoted;
  for (const std::string& name : names) quoted.push_back({GLISSADE_TEXT("'%1'"), {name}});
  return joined(quoted, ", ");
}

Message inWords(const Evidence& evidence) {
  const Length person{evidence.byPerson};
  if (evidence.overlap + evidence.deflection + evidence.spacing + evidence.margin == 0.0) {
    return evidence.byPerson > 0.0 ? Message{GLISSADE_TEXT("the user allows %1"), {person}} : GLISSADE_TEXT("nothing");
  }
  const Length overlap{evidence.overlap};
  const Length deflection{evidence.deflection};
  const Length spacing{evidence.spacing};
  const Length margin{evidence.margin};
  if (evidence.byPerson > 0.0) {
    return {GLISSADE_TEXT("overlap %1, mesh tolerance %2, spacing %3, gap %4, user-defined for the pair %5"),
            {overlap, deflection, spacing, margin, person}};
  }
  return {GLISSADE_TEXT("overlap %1, mesh tolerance %2, spacing %3, gap %4"), {overlap, deflection, spacing, margin}};
}

Message inWords(const AppliedAllowance& allowance) {
  if (allowance.screwHole) {
    return {GLISSADE_TEXT("'%1' without what its screw '%2' fills: the file has no tapped hole there"),
            {allowance.thinner, allowance.against}};
  }
  if (allowance.hollow) {
    return {GLISSADE_TEXT("'%1' without what overlaps '%2', up to %3 deep: a clash that the user accepts"),
            {allowance.thinner, allowance.against, Depth{allowance.applied}}};
  }
  Message words{GLISSADE_TEXT("'%1', %2 on '%3' (%4)"),
                {allowance.thinner, Length{allowance.applied}, allowance.against, inWords(allowance.evidence)}};
  if (allowance.bend > 0.0) {
    words = {GLISSADE_TEXT("%1, at the hook, which the user lets bend by %2"), {words, Length{allowance.bend}}};
  }
  if (allowance.core) words = {GLISSADE_TEXT("%1, where its thread is taken away"), {words}};
  if (allowance.thread) {
    words = {GLISSADE_TEXT("%1, a thread with a pitch of %2"), {words, Length{allowance.thread->pitch}}};
  }
  return words;
}

namespace {

/// The allowance that the file states, without the judgement.
Message claimInWords(const AppliedAllowance& allowance) {
  const Length amount{*allowance.stated};
  if (allowance.hollow) {
    return {GLISSADE_TEXT("the file states '%1' without what overlaps '%2', up to %3 deep"),
            {allowance.thinner, allowance.against, amount}};
  }
  return {GLISSADE_TEXT("the file states an allowance of %2 of '%1' on '%3'"),
          {allowance.thinner, amount, allowance.against}};
}

}  // namespace

Message allowanceRefused(const AppliedAllowance& allowance, const Message& reason) {
  if (!allowance.stated) {
    return {GLISSADE_TEXT("%1: %2. Mend the parts, or accept the clash."),
            {pairInWords(allowance.thinner, allowance.against), reason}};
  }
  const Message claim = claimInWords(allowance);
  Message words{GLISSADE_TEXT("%1, and the independent check finds reason for nothing"), {claim}};
  if (allowance.most > 0.0) {
    words = {GLISSADE_TEXT("%1, and the independent check finds reason for %2 only (%3)"),
             {claim, Length{allowance.most}, inWords(allowance.evidence)}};
  }
  if (!reason.empty()) words = {GLISSADE_TEXT("%1: %2"), {words, reason}};
  return {GLISSADE_TEXT("%1. Plan again, or allow it for this pair."), {words}};
}

}  // namespace glissade::check
