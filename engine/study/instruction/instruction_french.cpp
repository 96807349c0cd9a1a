#include "engine/study/instruction/instruction_french.h"

namespace glissade {

const std::map<std::string_view, std::string_view>& instructionFrench() {
  static const std::map<std::string_view, std::string_view> french{
      {"Work instruction", "Gamme de montage"},
      {"%1 parts, %2 steps", "%1 pièces, %2 étapes"},
      {"Tools: %1", "Outils : %1"},
      {"Start", "Début"},
      {"Previous", "Précédent"},
      {"Next", "Suivant"},
      {"Put %1 on the bench.", "Poser %1 sur l'établi."},
      {"Put these parts on the bench.", "Poser ces pièces sur l'établi."},
      {"subassembly %1", "sous-ensemble %1"},
      {"Needs support: %1", "À soutenir : %1"},
      {"Start all by hand, then tighten crosswise.", "Tout engager à la main, puis serrer en croix."},
      {"Hold while you turn it over: %1", "À tenir pendant le retournement : %1"},
      {"Screw in %1.", "Visser %1."},
      {"Screw on %1.", "Visser %1."},
      {"Press in %1.", "Emmancher %1."},
      {"Push in %1.", "Enfoncer %1."},
      {"Snap in %1.", "Clipser %1."},
      {"Lay on %1.", "Poser %1."},
      {"Turn in %1.", "Mettre %1 en tournant."},
      {"Insert %1.", "Insérer %1."},
      {"Place %1.", "Placer %1."},
      {"Turn the product over.", "Retourner le produit."},
      {"Turn the product by half a turn.", "Tourner le produit d'un demi-tour."},
      {"Turn the product over and by half a turn.", "Retourner le produit et le tourner d'un demi-tour."},
      {"Turn the product to the left.", "Tourner le produit vers la gauche."},
      {"Turn the product to the right.", "Tourner le produit vers la droite."},
      {"Turn the product over and to the left.", "Retourner le produit et le tourner vers la gauche."},
      {"Turn the product over and to the right.", "Retourner le produit et le tourner vers la droite."},
  };
  return french;
}

}  // namespace glissade
