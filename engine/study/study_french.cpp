#include "engine/study/study_french.h"

namespace glissade {

const std::map<std::string_view, std::string_view>& studyFrench() {
  static const std::map<std::string_view, std::string_view> french{
      // Reports and plots.
      {"After: %1.", "D'après : %1."},
      {"What was run", "Ce qui a été calculé"},
      {"Results", "Résultats"},
      {"The paper's table, and ours", "Le tableau de l'article, et le nôtre"},
      {"Findings", "Constats"},
      {"Plots", "Courbes"},
      {"How runs ended", "Comment les essais se sont terminés"},
      {"Time on the machine", "Temps sur la machine"},
      {"Seconds and memory are those of the machines that carried out the runs; they differ from machine to machine, "
       "and of what stands above only what names them depends on them. This report was written on %1.",
       "Les secondes et la mémoire sont celles des machines qui ont fait les essais ; elles diffèrent d'une machine à "
       "l'autre, et de ce qui précède seul ce qui les nomme en dépend. Ce rapport a été écrit sur : %1."},
      {"Study", "Étude"},
      {"Runs", "Essais"},
      {"%1, quick size", "%1, taille rapide"},
      {"%1, full size", "%1, taille complète"},
      {"%1 of %2, %3 of them solved, in %4 cells", "%1 sur %2, dont %3 résolus, en %4 cellules"},
      {"Scenarios", "Scénarios"},
      {"Strategies", "Stratégies"},
      {"Operators", "Opérateurs"},
      {"Study file, SHA-256", "Fichier de l'étude, SHA-256"},
      {"Plan, SHA-256", "Plan, SHA-256"},
      {"Typical roadmaps", "Graphes typiques"},
      {"How to repeat it", "Comment le refaire"},
      {"The whole study, from the folder of its file:", "Toute l'étude, depuis le dossier de son fichier :"},
      {"The first run of each cell, from the same folder; the others differ in their --seed only:",
       "Le premier essai de chaque cellule, depuis le même dossier ; les autres n'en diffèrent que par --seed :"},
      {"Ours: median or mean as the column says, quartiles in brackets; success with Wilson's 95 % interval.",
       "Le nôtre : médiane ou moyenne selon la colonne, quartiles entre parenthèses ; réussite avec l'intervalle de "
       "Wilson à 95 %."},
      {"Row", "Ligne"},
      {"Solved", "Résolus"},
      {"Success", "Réussite"},
      {"%1, paper", "%1, article"},
      {"%1, ours", "%1, Glissade"},
      {"%1 of %2", "%1 sur %2"},
      {"Note on the paper", "Remarque sur l'article"},
      {"Each compares every pair of cells that it speaks of; the numbers are of the pair that speaks most against it.",
       "Chacun compare toutes les paires de cellules dont il parle ; les nombres sont ceux de la paire qui le "
       "contredit le plus."},
      {"Finding", "Constat"},
      {"Verdict", "Verdict"},
      {"Pairs", "Paires"},
      {"Quantity", "Grandeur"},
      {"Numbers", "Nombres"},
      {"Strategy", "Stratégie"},
      {"Operator", "Opérateur"},
      {"Planned", "Prévus"},
      {"Run", "Faits"},
      {"solved", "résolu"},
      {"no-path", "sans chemin"},
      {"limit-reached", "limite atteinte"},
      {"in-collision", "en collision"},
      {"error", "erreur"},
      {"time", "temps"},
      {"memory", "mémoire"},
      {"crashed", "interrompu"},
      {"Median and quartiles over all runs.", "Médiane et quartiles de tous les essais."},
      {"Planning (s)", "Planification (s)"},
      {"Process (s)", "Processus (s)"},
      {"Planning (CPU s)", "Planification (s de processeur)"},
      {"Process (CPU s)", "Processus (s de processeur)"},
      {", OMPL's edges looked at every %1 %", ", arêtes d'OMPL regardées tous les %1 %"},
      {"Memory (MB)", "Mémoire (Mo)"},
      {"holds", "tient"},
      {"does not hold", "ne tient pas"},
      {"open", "en suspens"},
      {"%1 has not been run", "%1 n'a pas été calculé"},
      {"%1 was never solved", "%1 n'a jamais été résolu"},
      {"%1: %2; wanted below %3", "%1 : %2 ; voulu sous %3"},
      {"%1: %2; wanted above %3", "%1 : %2 ; voulu au-dessus de %3"},
      {"%1: %2 against %3: %4", "%1 : %2 contre %3 : %4"},
      {"%1, %2 times; wanted below %3", "%1, %2 fois ; voulu sous %3"},
      {"%1, %2 times; wanted above %3", "%1, %2 fois ; voulu au-dessus de %3"},
      {"Its rows are not part of this size of the study", "Ses lignes ne font pas partie de cette taille de l'étude"},
      {"success rate", "taux de réussite"},
      {"median of %1 over the solved runs", "médiane de « %1 » sur les essais résolus"},
      {"median of %1 over all runs", "médiane de « %1 » sur tous les essais"},
      {"mean of %1 over the solved runs", "moyenne de « %1 » sur les essais résolus"},
      {"mean of %1 over all runs", "moyenne de « %1 » sur tous les essais"},
      {"virtual s", "temps virtuel (s)"},
      {"nodes", "nœuds"},
      {"edges", "arêtes"},
      {"random configurations", "configurations aléatoires"},
      {"%1 over %2", "%1 selon %2"},
      {"%1 over scenario and strategy", "%1 selon le scénario et la stratégie"},
      {"%1, with Wilson's 95 % interval.", "%1, avec l'intervalle de Wilson à 95 %."},
      {"%1, with quartiles.", "%1, avec les quartiles."},
      {"Above each bar: success rate in %.", "Au-dessus de chaque barre : taux de réussite en %."},
      {"Not on this axis: %1.", "Hors de cet axe : %1."},
      {"%1: %2 (%3 to %4), %5 of %6 solved", "%1 : %2 (%3 à %4), %5 sur %6 résolus"},
      {"%1, paper: %2", "%1, article : %2"},
      {"paper", "article"},
      {"Scenario", "Scénario"},
      {"Virtual time (s)", "Temps virtuel (s)"},
      {"Authority", "Autorité"},
      {"Contact samples", "Échantillons de contact"},
      {"Contact distance", "Distance de contact"},
      // The papers' studies.
      {"Table I: influence of α without contact, environment 1",
       "Tableau I : influence de α sans contact, environnement 1"},
      {"Table II: influence of α with contact, environment 1",
       "Tableau II : influence de α avec contact, environnement 1"},
      {"Table III: influence of the number of contact samples N, environment 1",
       "Tableau III : influence du nombre N d'échantillons de contact, environnement 1"},
      {"Table IV: influence of the contact distance d, environment 1",
       "Tableau IV : influence de la distance de contact d, environnement 1"},
      {"Table V: influence of α with contact, environment 2",
       "Tableau V : influence de α avec contact, environnement 2"},
      {"Figure 14: strategies on the shape game", "Figure 14 : stratégies sur le jeu de formes"},
      {"Figure 14 on the roomier shape game", "Figure 14 sur le jeu de formes plus large"},
      {"Time (s)", "Temps (s)"},
      {"Nodes", "Nœuds"},
      {"Edges", "Arêtes"},
      {"Success rate", "Taux de réussite"},
      {"Random configurations", "Configurations aléatoires"},
      {"Random configurations (mean)", "Configurations aléatoires (moyenne)"},
      {"Any operator beats none by more than ten times in nodes.",
       "Un opérateur quel qu'il soit fait mieux que personne, de plus de dix fois en nœuds."},
      {"Any operator beats none by more than fifty times in time.",
       "Un opérateur quel qu'il soit fait mieux que personne, de plus de cinquante fois en temps."},
      {"Any operator beats none by more than a hundred times in time.",
       "Un opérateur quel qu'il soit fait mieux que personne, de plus de cent fois en temps."},
      {"Small α is slow without contact: α = 0.3 to 0.1 take more than twice the time of α = 0.95 to 0.4.",
       "Sans contact un petit α est lent : α = 0.3 à 0.1 prennent plus de deux fois le temps de α = 0.95 à 0.4."},
      {"α = 0.95 is the fastest row.", "α = 0.95 est la ligne la plus rapide."},
      {"With contact small α is fast: α = 0.2 to 0.01 need fewer nodes than α = 0.8 and 0.5.",
       "Avec contact un petit α est rapide : α = 0.2 à 0.01 demandent moins de nœuds que α = 0.8 et 0.5."},
      {"α = 0.08 is the fastest row.", "α = 0.08 est la ligne la plus rapide."},
      {"With contact even the operator alone, α = 0, finds a path every time.",
       "Avec contact même l'opérateur seul, α = 0, trouve un chemin à chaque fois."},
      {"N has little influence on environment 1: within a factor of four in time.",
       "N a peu d'influence sur l'environnement 1 : moins d'un facteur quatre en temps."},
      {"N has little influence on environment 1: within a factor of two in nodes.",
       "N a peu d'influence sur l'environnement 1 : moins d'un facteur deux en nœuds."},
      {"N = 5 is the fastest row.", "N = 5 est la ligne la plus rapide."},
      {"d has little influence on environment 1: within a factor of two in time.",
       "d a peu d'influence sur l'environnement 1 : moins d'un facteur deux en temps."},
      {"d has little influence on environment 1: within a factor of 1.2 in nodes.",
       "d a peu d'influence sur l'environnement 1 : moins d'un facteur 1.2 en nœuds."},
      {"The BiRRT alone finds no path.", "Le BiRRT seul ne trouve pas de chemin."},
      {"Contact beats no contact at equal α = 0.5 by more than ten times in time.",
       "À α = 0.5 égal, le contact fait mieux que son absence de plus de dix fois en temps."},
      {"Contact beats no contact at equal α = 0.5 in nodes.",
       "À α = 0.5 égal, le contact fait mieux que son absence en nœuds."},
      {"Extremes of α are worse: α = 0.98, 0.95 and 0.05 take longer than any between.",
       "Les extrêmes de α sont moins bons : α = 0.98, 0.95 et 0.05 prennent plus de temps que tous les autres entre "
       "eux."},
      {"α = 0, the operator alone, finds no path.", "α = 0, l'opérateur seul, ne trouve pas de chemin."},
      {"G fails on the pentagon and the star.", "G échoue sur le pentagone et l'étoile."},
      {"G succeeds on the circle, the square and the triangle.", "G réussit sur le cercle, le carré et le triangle."},
      {"GT fails where the nearest hole does not fit: circle, square, star.",
       "GT échoue là où le trou le plus proche ne convient pas : cercle, carré, étoile."},
      {"GTS1 fails on the star, which has no hole of its shape.",
       "GTS1 échoue sur l'étoile, qui n'a pas de trou de sa forme."},
      {"GTS2 succeeds most often of the paper's four on the star.",
       "GTS2 est celle des quatre de l'article qui réussit le plus souvent sur l'étoile."},
      {"GTS2 needs less than a tenth of G's random configurations on the square, the triangle, the pentagon and the "
       "star.",
       "GTS2 demande moins d'un dixième des configurations aléatoires de G sur le carré, le triangle, le pentagone et "
       "l'étoile."},
      {"Our GTS needs fewer random configurations than any of the paper's.",
       "Notre GTS demande moins de configurations aléatoires que toutes celles de l'article."},
      {"α is the share of the computer; α = 1 is the plain BiRRT, without any operator. Lockstep at 40 planner steps a "
       "second of the operator's time, as fast as the paper's planner with him.",
       "α est la part de l'ordinateur ; α = 1 est le BiRRT simple, sans aucun opérateur. Pas à pas, 40 pas du "
       "planificateur par seconde de l'opérateur : l'allure du planificateur de l'article avec lui."},
      {"As table I, with contact sampling near obstacles (N = 10, d = 0.15 m). Lockstep at 40 planner steps a second "
       "of the operator's time, as fast as the paper's planner with him.",
       "Comme le tableau I, avec échantillonnage au contact près des obstacles (N = 10, d = 0.15 m). Pas à pas, 40 pas "
       "du planificateur par seconde de l'opérateur : l'allure du planificateur de l'article avec lui."},
      {"α = 0.2, d = 0.15 m. Lockstep at 40 planner steps a second of the operator's time, as fast as the paper's "
       "planner with him.",
       "α = 0.2, d = 0.15 m. Pas à pas, 40 pas du planificateur par seconde de l'opérateur : l'allure du planificateur "
       "de l'article avec lui."},
      {"α = 0.2, N = 5. Lockstep at 40 planner steps a second of the operator's time, as fast as the paper's planner "
       "with him.",
       "α = 0.2, N = 5. Pas à pas, 40 pas du planificateur par seconde de l'opérateur : l'allure du planificateur de "
       "l'article avec lui."},
      {"N = 10, d = 0.15 m; with what section III.G says of the plain BiRRT, of no contact and of α = 0. Lockstep at "
       "40 planner steps a second of the operator's time, as fast as the paper's planner with him.",
       "N = 10, d = 0.15 m ; avec ce que dit la section III.G du BiRRT simple, de l'absence de contact et de α = 0. "
       "Pas à pas, 40 pas du planificateur par seconde de l'opérateur : l'allure du planificateur de l'article avec "
       "lui."},
      {"Preset \"tight\", the limits of section 6.1: 100,000 random configurations a topological step, 2,000 a border, "
       "1,000,000 for G. GTS is ours: computed compatibility, scores, a loop.",
       "Variante « tight », limites de la section 6.1 : 100 000 configurations aléatoires par étape topologique, 2 000 "
       "par frontière, 1 000 000 pour G. GTS est la nôtre : compatibilité calculée, notes, boucle."},
      {"Preset \"paper-like\": wider holes, as the drawings of the paper suggest. The limits of section 6.1.",
       "Variante « paper-like » : trous plus larges, comme le suggèrent les dessins de l'article. Limites de la "
       "section 6.1."},
      {"printed as 2h45m", "imprimé « 2h45m »"},
      {"edges as printed; violates edges=2*nodes-2 (2566 expected); 1074 equals the alpha=0.08 row of Table II, so "
       "probably a copy error",
       "arêtes telles qu'imprimées ; contredit arêtes = 2·nœuds − 2 (2566 attendues) ; 1074 est la ligne α = 0.08 du "
       "tableau II, donc sans doute une erreur de copie"},
      {"fastest row", "ligne la plus rapide"},
      {"printed as 2h45m; same run as Table I (alpha=1 never enters contact)",
       "imprimé « 2h45m » ; même essai qu'au tableau I (α = 1 n'entre jamais en contact)"},
      {"one edge pair short of 2*nodes-2 (3456)", "une paire d'arêtes de moins que 2·nœuds − 2 (3456)"},
      {"section III.G", "section III.G"},
      {"odd edge count as printed (4050 expected)", "nombre impair d'arêtes, tel qu'imprimé (4050 attendues)"},
      {"pentagon hole, narrow", "trou pentagonal, étroit"},
      {"mostly pentagon hole", "le plus souvent le trou pentagonal"},
      {"triangular hole, not the larger passage (text)", "trou triangulaire, non le passage plus large (texte)"},
      {"mainly pentagon hole", "surtout le trou pentagonal"},
      {"none", "aucun"},
      {"pentagon hole, large", "trou pentagonal, large"},
      {"pentagon hole, largest", "trou pentagonal, le plus large"},
      {"triangular hole (not compatible)", "trou triangulaire (non compatible)"},
      {"square hole, large (semantic)", "trou carré, large (sémantique)"},
      {"round hole, large (semantic)", "trou rond, large (sémantique)"},
      {"square hole, large", "trou carré, large"},
      // The automatic planner, tuning, public problems.
      {"Five rigid-body problems of OMPL.app, which are not part of Glissade: they are looked for in "
       "shared/problems/omplapp beside its folder. OMPL's planners run as OMPL's users run them: its metric and "
       "defaults, collisions by FCL, edges looked at every 1 % or 0.1 % of the extent, the range its default (20 % of "
       "the extent), 3 % or 1 %. Our certificate judges their paths; one that it refuses (not-certified) is not "
       "solved. Seconds are of the processor, but auto, which plans in lanes, is held to what one waits; over all "
       "runs: one that was not solved counts with the time it had.",
       "Cinq problèmes de corps rigides d'OMPL.app, qui ne font pas partie de Glissade : on les cherche dans "
       "shared/problems/omplapp à côté de son dossier. Les planificateurs d'OMPL tournent comme chez leurs "
       "utilisateurs : métrique et valeurs par défaut d'OMPL, collisions par FCL, arêtes regardées tous les 1 % ou 0,1 "
       "% de l'étendue, portée par défaut (20 % de l'étendue), 3 % ou 1 %. Notre certificat juge leurs chemins ; celui "
       "qu'il refuse (non certifié) n'est pas résolu. Les secondes sont celles du processeur, mais auto, qui planifie "
       "sur plusieurs voies, est jugé au temps d'attente ; sur tous les essais : un essai non résolu compte avec le "
       "temps qu'il a eu."},
      {"Problems nobody here wrote: auto beside OMPL's planners",
       "Des problèmes que personne ici n'a écrits : auto à côté des planificateurs d'OMPL"},
      {"auto solves 18 of 20 runs of bugtrap at least.", "auto résout au moins 18 essais sur 20 de bugtrap."},
      {"auto solves every run of Easy, cubicles, Twistycool and alpha-1.5, with a certified path.",
       "auto résout tous les essais d'Easy, cubicles, Twistycool et alpha-1.5, avec un chemin certifié."},
      {"auto takes a fifth of the time of OMPL's best at 0.1 %.",
       "auto prend un cinquième du temps du meilleur d'OMPL à 0,1 %."},
      {"Automatic tuning of α, N and d against fixed settings",
       "Réglage automatique de α, N et d face à des réglages fixes"},
      {"Tuned runs are solved at least nine tenths as often as with the best fixed setting.",
       "Les essais réglés automatiquement sont résolus au moins neuf fois sur dix par rapport au meilleur réglage "
       "fixe."},
      {"Tuned α, N and d are within 15 % of the best fixed setting in median steps, without knowing it.",
       "α, N et d réglés automatiquement sont à moins de 15 % du meilleur réglage fixe en pas médians, sans le "
       "connaître."},
      {"α, N and d set themselves from what computer, operator and contact earned lately, against the best of a coarse "
       "grid of fixed settings, the same seeds for all. Lockstep at 40 planner steps a second of the operator's time.",
       "α, N et d se règlent d'après ce que l'ordinateur, l'opérateur et le contact ont apporté récemment, face au "
       "meilleur d'une grille grossière de réglages fixes, avec les mêmes graines pour tous. Pas à pas, à 40 pas du "
       "planificateur par seconde du temps de l'opérateur."},
      {"BiRRT alone, one run: 2 h 45 (paper 1, table I)", "BiRRT seul, un essai : 2 h 45 (article 1, tableau I)"},
      {"BiRRT alone: nothing in a night; a person with contact: 61 s (paper 1, table V)",
       "BiRRT seul : rien en une nuit ; une personne avec contact : 61 s (article 1, tableau V)"},
      {"Environment 1: a median of 0.2 s at most.", "Environnement 1 : une médiane de 0,2 s au plus."},
      {"Environment 2: a median of 3 s at most.", "Environnement 2 : une médiane de 3 s au plus."},
      {"Environments 1 and 2: faster than our BiRRT and than OMPL's planners.",
       "Environnements 1 et 2 : plus rapide que notre BiRRT et que les planificateurs d'OMPL."},
      {"Strategy auto, nobody at the device, beside what else is there: our BiRRT, GTS on the pump, and OMPL as it is "
       "(edges looked at every 0.1 % of the extent). Seconds are of the processor, but what is asked of auto alone and "
       "beside GTS is what one waits; over all runs: one that was not solved counts with the time it had. A path of "
       "OMPL's counts as solved where our certificate holds.",
       "Stratégie auto, personne au dispositif, à côté de ce qui existe : notre BiRRT, GTS sur la pompe, et OMPL tel "
       "quel (arêtes regardées tous les 0,1 % de l'étendue). Les secondes sont celles du processeur, mais ce qui est "
       "demandé à auto seul et à côté de GTS est le temps d'attente ; sur tous les essais : un essai non résolu compte "
       "avec le temps qu'il a eu. Un chemin d'OMPL compte comme résolu là où notre certificat tient."},
      {"The automatic planner on our samples", "Le planificateur automatique sur nos exemples"},
      {"The pump: ten times faster than GTS.", "La pompe : dix fois plus rapide que GTS."},
      {"auto solves every run, with a certified path.", "auto résout tous les essais, avec un chemin certifié."},
      {"not-certified", "non certifié"},
  };
  return french;
}

}  // namespace glissade
