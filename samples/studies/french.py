"""French of the texts of the pages, and of the studies in this folder."""

FRENCH = {
    # Ends of runs, verdicts and measures.
    "solved": "résolu",
    "no-path": "sans chemin",
    "not-certified": "non certifié",
    "limit-reached": "limite atteinte",
    "in-collision": "en collision",
    "error": "erreur",
    "time": "temps",
    "memory": "mémoire",
    "crashed": "interrompu",
    "holds": "vérifié",
    "open": "en suspens",
    "does not hold": "réfuté",
    "nodes": "nœuds",
    "paper": "article",
    "edges": "arêtes",
    "success rate": "taux de réussite",
    "virtual s": "temps virtuel (s)",
    "random configurations": "configurations aléatoires",
    # Texts of the page.
    ("A run can be seen again in the window: Plan > Studies > Open run of a study, with its file. This command "
     "does the same for the first run:"):
        ("Un essai peut être revu dans la fenêtre : Étude > Ouvrir un essai d'une étude, avec son "
         "fichier. Cette commande fait de même pour le premier essai :"),
    "{0} (runs: {1})": "{0} (essais\u00a0: {1})",
    "{0} has no seconds for {1} of {2} cells.": "{0} n'a pas de durées pour {1} cellules sur {2}.",
    "{0} has {1} of {2} runs.": "{0} contient {1} essais sur {2}.",
    "Lines of {0} that cannot be read and are left out: {1}.": "Lignes de {0} illisibles et omises\u00a0: {1}.",
    ("Seconds and memory depend on the machine that carried out the run. Of the sections above, only "
     "findings and plots in seconds depend on it. This report was written on {0}."):
        ("Les secondes et la mémoire dépendent de la machine qui a fait l'essai. Parmi les sections "
         "précédentes, seuls les constats et les courbes en secondes en dépendent. Ce rapport a été "
         "écrit sur\u00a0: {0}."),
    "Row": "Ligne",
    "Run": "Faits",
    "Ending": "Fin",
    "File": "Fichier",
    "Seed": "Graine",
    ", OMPL's edges looked at every {0} %": ", arêtes d'OMPL regardées tous les {0} %",
    "Above each bar: success rate in %.": "Au-dessus de chaque barre\u00a0: taux de réussite en %.",
    "After: {0}.": "D'après\u00a0: {0}.",
    "Each compares every pair of cells that it speaks of; the numbers are of the pair that speaks most against it.":
        ("Chacun compare toutes les paires de cellules dont il parle\u00a0; les nombres sont ceux de la paire"
         " qui le contredit le plus."),
    "Finding": "Constat",
    "Findings": "Constats",
    "How runs ended": "Comment les essais se sont terminés",
    "How to repeat it": "Comment le refaire",
    "Its rows are not part of this size of the study": "Ses lignes ne font pas partie de cette taille de l'étude",
    "Median and quartiles over all runs.": "Médiane et quartiles de tous les essais.",
    "Memory (MB)": "Mémoire (Mo)",
    "Not on this axis: {0}.": "Hors de cet axe\u00a0: {0}.",
    "Note on the paper": "Remarque sur l'article",
    "Numbers": "Nombres",
    "Operator": "Opérateur",
    "Operators": "Opérateurs",
    "Ours: median or mean as the column says, quartiles in brackets; success with Wilson's 95 % interval.":
        ("Le nôtre\u00a0: médiane ou moyenne selon la colonne, quartiles entre parenthèses\u00a0; réussite avec "
         "l'intervalle de Wilson à 95 %."),
    "Pairs": "Paires",
    "Plan, SHA-256": "Plan, SHA-256",
    "Planned": "Prévus",
    "Planning (CPU s)": "Planification (s de processeur)",
    "Planning (s)": "Planification (s)",
    "Plots": "Courbes",
    "Process (CPU s)": "Processus (s de processeur)",
    "Process (s)": "Processus (s)",
    "Quantity": "Grandeur",
    "Results": "Résultats",
    "Runs": "Essais",
    "Scenarios": "Scénarios",
    "Solved": "Résolus",
    "Strategies": "Stratégies",
    "Strategy": "Stratégie",
    "Study": "Étude",
    "Study file, SHA-256": "Fichier de l'étude, SHA-256",
    "Success": "Réussite",
    "The first run of each cell, from the same folder; the others differ in their --seed only:":
        ("Le premier essai de chaque cellule, depuis le même dossier\u00a0; les autres n'en diffèrent que par"
         " --seed\u00a0:"),
    "The paper's table, and ours": "Le tableau de l'article, et le nôtre",
    "The whole study, from the folder of its file:": "Toute l'étude, depuis le dossier de son fichier\u00a0:",
    "Time on the machine": "Temps sur la machine",
    "Typical roadmaps": "Graphes typiques",
    "Verdict": "Verdict",
    "What was run": "Ce qui a été calculé",
    "mean of {0} over all runs": "moyenne de «\u00a0{0}\u00a0» sur tous les essais",
    "mean of {0} over the solved runs": "moyenne de «\u00a0{0}\u00a0» sur les essais résolus",
    "median of {0} over all runs": "médiane de «\u00a0{0}\u00a0» sur tous les essais",
    "median of {0} over the solved runs": "médiane de «\u00a0{0}\u00a0» sur les essais résolus",
    "none": "aucun",
    "{0} has not been run": "{0} n'a pas été calculé",
    "{0} of {1}": "{0} sur {1}",
    "{0} of {1}, {2} of them solved, in {3} cells": "{0} sur {1}, dont {2} résolus, en {3} cellules",
    "{0} over scenario and strategy": "{0} selon le scénario et la stratégie",
    "{0} over {1}": "{0} selon {1}",
    "{0} was never solved": "{0} n'a jamais été résolu",
    "{0}, full size": "{0}, taille complète",
    "{0}, ours": "{0}, Glissade",
    "{0}, paper": "{0}, article",
    "{0}, paper: {1}": "{0}, article\u00a0: {1}",
    "{0}, quick size": "{0}, taille rapide",
    "{0}, with Wilson's 95 % interval.": "{0}, avec l'intervalle de Wilson à 95 %.",
    "{0}, with quartiles.": "{0}, avec les quartiles.",
    "{0}, {1} times; wanted above {2}": "{0}, {1} fois\u00a0; voulu au-dessus de {2}",
    "{0}, {1} times; wanted below {2}": "{0}, {1} fois\u00a0; voulu sous {2}",
    "{0}: {1} ({2} to {3}), {4} of {5} solved": "{0}\u00a0: {1} ({2} à {3}), {4} sur {5} résolus",
    "{0}: {1} against {2}: {3}": "{0}\u00a0: {1} contre {2}\u00a0: {3}",
    "{0}: {1}; wanted above {2}": "{0}\u00a0: {1}\u00a0; voulu au-dessus de {2}",
    "{0}: {1}; wanted below {2}": "{0}\u00a0: {1}\u00a0; voulu sous {2}",
    # Parameters.
    "Authority": "Autorité",
    "Contact samples": "Échantillons de contact",
    "Contact distance": "Distance de contact",
    "Contact disc": "Disque de contact",
    "Contact gap": "Écart au contact",
    "Required clearance": "Jeu exigé",
    "Growth step": "Pas de croissance",
    "Extension step": "Pas d'extension",
    "Steps per second": "Pas par seconde",
    "Step limit": "Limite de pas",
    "Sample limit": "Limite d'échantillons",
    "Time limit": "Limite de temps",
    "Samples of strategy G": "Échantillons de la stratégie G",
    "Samples a step": "Échantillons par étape",
    "Samples a border": "Échantillons par frontière",
    "Coarse paths": "Chemins grossiers",
    "Smoothing": "Lissage",
    "Repulsion": "Répulsion",
    "Attraction": "Attraction",
    "OMPL's range": "Portée d'OMPL",
    "OMPL's resolution": "Résolution d'OMPL",
    "Automatic tuning": "Réglage automatique",
    "Planners side by side": "Planificateurs en parallèle",
    "Pace": "Cadence",
    # Titles, findings and notes of the studies.
    "Virtual time (s)": "Temps virtuel (s)",
    "Table I: influence of α without contact, environment 1":
        "Tableau I\u00a0: influence de α sans contact, environnement 1",
    "Table II: influence of α with contact, environment 1":
        "Tableau II\u00a0: influence de α avec contact, environnement 1",
    "Table III: influence of the number of contact samples N, environment 1":
        "Tableau III\u00a0: influence du nombre N d'échantillons de contact, environnement 1",
    "Table IV: influence of the contact distance d, environment 1":
        "Tableau IV\u00a0: influence de la distance de contact d, environnement 1",
    "Table V: influence of α with contact, environment 2":
        "Tableau V\u00a0: influence de α avec contact, environnement 2",
    "Figure 14: strategies on the shape game": "Figure 14\u00a0: stratégies sur le jeu de formes",
    "Figure 14 on the roomier shape game": "Figure 14 sur le jeu de formes plus large",
    "Time (s)": "Temps (s)",
    "Nodes": "Nœuds",
    "Edges": "Arêtes",
    "Success rate": "Taux de réussite",
    "Random configurations": "Configurations aléatoires",
    "Random configurations (mean)": "Configurations aléatoires (moyenne)",
    "Any operator beats none by more than ten times in nodes.":
        "Un opérateur quel qu'il soit fait mieux que personne, de plus de dix fois en nœuds.",
    "Any operator beats none by more than fifty times in time.":
        "Un opérateur quel qu'il soit fait mieux que personne, de plus de cinquante fois en temps.",
    "Any operator beats none by more than a hundred times in time.":
        "Un opérateur quel qu'il soit fait mieux que personne, de plus de cent fois en temps.",
    "Small α is slow without contact: α = 0.3 to 0.1 take more than twice the time of α = 0.95 to 0.4.":
        "Sans contact un petit α est lent\u00a0: α = 0.3 à 0.1 prennent plus de deux fois le temps de α = 0.95 à 0.4.",
    "α = 0.95 is the fastest row.": "α = 0.95 est la ligne la plus rapide.",
    "With contact small α is fast: α = 0.2 to 0.01 need fewer nodes than α = 0.8 and 0.5.":
        "Avec contact un petit α est rapide\u00a0: α = 0.2 à 0.01 demandent moins de nœuds que α = 0.8 et 0.5.",
    "α = 0.08 is the fastest row.": "α = 0.08 est la ligne la plus rapide.",
    "With contact even the operator alone, α = 0, finds a path every time.":
        "Avec contact même l'opérateur seul, α = 0, trouve un chemin à chaque fois.",
    "N has little influence on environment 1: within a factor of four in time.":
        "N a peu d'influence sur l'environnement 1\u00a0: moins d'un facteur quatre en temps.",
    "N has little influence on environment 1: within a factor of two in nodes.":
        "N a peu d'influence sur l'environnement 1\u00a0: moins d'un facteur deux en nœuds.",
    "N = 5 is the fastest row.": "N = 5 est la ligne la plus rapide.",
    "d has little influence on environment 1: within a factor of two in time.":
        "d a peu d'influence sur l'environnement 1\u00a0: moins d'un facteur deux en temps.",
    "d has little influence on environment 1: within a factor of 1.2 in nodes.":
        "d a peu d'influence sur l'environnement 1\u00a0: moins d'un facteur 1.2 en nœuds.",
    "The BiRRT alone finds no path.": "Le BiRRT seul ne trouve pas de chemin.",
    "Contact beats no contact at equal α = 0.5 by more than ten times in time.":
        "À α = 0.5 égal, le contact fait mieux que son absence de plus de dix fois en temps.",
    "Contact beats no contact at equal α = 0.5 in nodes.":
        "À α = 0.5 égal, le contact fait mieux que son absence en nœuds.",
    "Extremes of α are worse: α = 0.98, 0.95 and 0.05 take longer than any between.":
        ("Les extrêmes de α sont moins bons\u00a0: α = 0.98, 0.95 et 0.05 prennent plus de temps que tous les"
         " autres entre eux."),
    "α = 0, the operator alone, finds no path.": "α = 0, l'opérateur seul, ne trouve pas de chemin.",
    "G fails on the pentagon and the star.": "G échoue sur le pentagone et l'étoile.",
    "G succeeds on the circle, the square and the triangle.": "G réussit sur le cercle, le carré et le triangle.",
    "GT fails where the nearest hole does not fit: circle, square, star.":
        "GT échoue là où le trou le plus proche ne convient pas\u00a0: cercle, carré, étoile.",
    "GTS1 fails on the star, which has no hole of its shape.":
        "GTS1 échoue sur l'étoile, qui n'a pas de trou de sa forme.",
    "GTS2 succeeds most often of the paper's four on the star.":
        "GTS2 est celle des quatre de l'article qui réussit le plus souvent sur l'étoile.",
    ("GTS2 needs less than a tenth of G's random configurations on the square, the triangle, the "
     "pentagon and the star."):
        ("GTS2 demande moins d'un dixième des configurations aléatoires de G sur le carré, le triangle, "
         "le pentagone et l'étoile."),
    "Our GTS needs fewer random configurations than any of the paper's.":
        "Notre GTS demande moins de configurations aléatoires que toutes celles de l'article.",
    ("α is the share of the computer; α = 1 is the plain BiRRT, without any operator. Lockstep at 40 "
     "planner steps a second of the operator's time, as fast as the paper's planner with him."):
        ("α est la part de l'ordinateur\u00a0; α = 1 est le BiRRT simple, sans aucun opérateur. Pas à pas, 40"
         " pas du planificateur par seconde de l'opérateur\u00a0: l'allure du planificateur de l'article avec"
         " lui."),
    ("As table I, with contact sampling near obstacles (N = 10, d = 0.15 m). Lockstep at 40 planner "
     "steps a second of the operator's time, as fast as the paper's planner with him."):
        ("Comme le tableau I, avec échantillonnage au contact près des obstacles (N = 10, d = 0.15 m). "
         "Pas à pas, 40 pas du planificateur par seconde de l'opérateur\u00a0: l'allure du planificateur de "
         "l'article avec lui."),
    ("α = 0.2, d = 0.15 m. Lockstep at 40 planner steps a second of the operator's time, as fast as the "
     "paper's planner with him."):
        ("α = 0.2, d = 0.15 m. Pas à pas, 40 pas du planificateur par seconde de l'opérateur\u00a0: l'allure "
         "du planificateur de l'article avec lui."),
    ("α = 0.2, N = 5. Lockstep at 40 planner steps a second of the operator's time, as fast as the "
     "paper's planner with him."):
        ("α = 0.2, N = 5. Pas à pas, 40 pas du planificateur par seconde de l'opérateur\u00a0: l'allure du "
         "planificateur de l'article avec lui."),
    ("N = 10, d = 0.15 m; with what section III.G says of the plain BiRRT, of no contact and of α = 0. "
     "Lockstep at 40 planner steps a second of the operator's time, as fast as the paper's planner with "
     "him."):
        ("N = 10, d = 0.15 m\u00a0; avec ce que dit la section III.G du BiRRT simple, de l'absence de contact"
         " et de α = 0. Pas à pas, 40 pas du planificateur par seconde de l'opérateur\u00a0: l'allure du "
         "planificateur de l'article avec lui."),
    ("Preset \"tight\", the limits of section 6.1: 100,000 random configurations a topological step, 2,000"
     " a border, 1,000,000 for G. GTS is ours: computed compatibility, scores, a loop."):
        ("Variante «\u00a0tight », limites de la section 6.1\u00a0: 100 000 configurations aléatoires par étape "
         "topologique, 2 000 par frontière, 1 000 000 pour G. GTS est la nôtre\u00a0: compatibilité calculée,"
         " notes, boucle."),
    "Preset \"paper-like\": wider holes, as the drawings of the paper suggest. The limits of section 6.1.":
        ("Variante «\u00a0paper-like\u00a0»\u00a0: trous plus larges, comme le suggèrent les dessins de l'article. "
         "Limites de la section 6.1."),
    "printed as 2h45m": "imprimé «\u00a02h45m\u00a0»",
    ("edges as printed; violates edges=2*nodes-2 (2566 expected); 1074 equals the alpha=0.08 row of "
     "Table II, so probably a copy error"):
        ("arêtes telles qu'imprimées\u00a0; contredit arêtes = 2·nœuds − 2 (2566 attendues)\u00a0; 1074 est la "
         "ligne α = 0.08 du tableau II, donc sans doute une erreur de copie"),
    "fastest row": "ligne la plus rapide",
    "printed as 2h45m; same run as Table I (alpha=1 never enters contact)":
        "imprimé «\u00a02h45m\u00a0»\u00a0; même essai qu'au tableau I (α = 1 n'entre jamais en contact)",
    "one edge pair short of 2*nodes-2 (3456)": "une paire d'arêtes de moins que 2·nœuds − 2 (3456)",
    "section III.G": "section III.G",
    "odd edge count as printed (4050 expected)": "nombre impair d'arêtes, tel qu'imprimé (4050 attendues)",
    "pentagon hole, narrow": "trou pentagonal, étroit",
    "mostly pentagon hole": "le plus souvent le trou pentagonal",
    "triangular hole, not the larger passage (text)": "trou triangulaire, non le passage plus large (texte)",
    "mainly pentagon hole": "surtout le trou pentagonal",
    "pentagon hole, large": "trou pentagonal, large",
    "pentagon hole, largest": "trou pentagonal, le plus large",
    "triangular hole (not compatible)": "trou triangulaire (non compatible)",
    "square hole, large (semantic)": "trou carré, large (sémantique)",
    "round hole, large (semantic)": "trou rond, large (sémantique)",
    "square hole, large": "trou carré, large",
    ("Five rigid-body problems of OMPL.app, which are not part of Glissade: they are looked for in "
     "shared/problems/omplapp beside its folder. OMPL's planners run as OMPL's users run them: its "
     "metric and defaults, collisions by FCL, edges looked at every 1 % or 0.1 % of the extent, the "
     "range its default (20 % of the extent), 3 % or 1 %. Our certificate judges their paths; one that "
     "it refuses (not-certified) is not solved. Seconds are of the processor, but auto, which plans in "
     "lanes, is held to what one waits; over all runs: one that was not solved counts with the time it "
     "had."):
        ("Cinq problèmes de corps rigides d'OMPL.app, qui ne font pas partie de Glissade\u00a0: on les "
         "cherche dans shared/problems/omplapp à côté de son dossier. Les planificateurs d'OMPL tournent"
         " comme chez leurs utilisateurs\u00a0: métrique et valeurs par défaut d'OMPL, collisions par FCL, "
         "arêtes regardées tous les 1 % ou 0,1 % de l'étendue, portée par défaut (20 % de l'étendue), 3 "
         "% ou 1 %. Notre certificat juge leurs chemins\u00a0; celui qu'il refuse (non certifié) n'est pas "
         "résolu. Les secondes sont celles du processeur, mais auto, qui planifie sur plusieurs voies, "
         "est jugé au temps d'attente\u00a0; sur tous les essais\u00a0: un essai non résolu compte avec le temps "
         "qu'il a eu."),
    "Problems nobody here wrote: auto beside OMPL's planners":
        "Des problèmes que personne ici n'a écrits\u00a0: auto à côté des planificateurs d'OMPL",
    "Problems of our own making: auto beside OMPL's planners":
        "Des problèmes que nous avons faits : auto à côté des planificateurs d'OMPL",
    ("Spirals, mazes, furniture in rooms and twisted tubes, as generate-made-problems writes them; "
     "generator and seeds were fixed before the first run. OMPL's planners run as OMPL's users run them:"
     " its metric and defaults, collisions by FCL, edges looked at every 0.1 % of the extent, the range "
     "its default (20 % of the extent), 3 % or 1 %. Our certificate judges their paths; one that it "
     "refuses (not-certified) is not solved. Seconds are of the processor; over all runs: one that was "
     "not solved counts with the time it had."):
        ("Spirales, labyrinthes, meubles dans des pièces et tubes tordus, tels que generate-made-"
         "problems les écrit ; le générateur et les graines ont été fixés avant le premier essai. Les "
         "planificateurs d'OMPL tournent comme chez leurs utilisateurs : métrique et valeurs par défaut "
         "d'OMPL, collisions par FCL, arêtes regardées tous les 0,1 % de l'étendue, portée par défaut "
         "(20 % de l'étendue), 3 % ou 1 %. Notre certificat juge leurs chemins ; celui qu'il refuse (non"
         " certifié) n'est pas résolu. Les secondes sont celles du processeur ; sur tous les essais : un"
         " essai non résolu compte avec le temps qu'il a eu."),
    "auto takes a quarter of the processor time of OMPL's best.":
        "auto prend un quart du temps de processeur du meilleur d'OMPL.",
    "RRT-Connect, range 3 %": "RRT-Connect, portée 3 %",
    "RRT-Connect, range 1 %": "RRT-Connect, portée 1 %",
    "auto solves 18 of 20 runs of bugtrap at least.": "auto résout au moins 18 essais sur 20 de bugtrap.",
    "auto solves every run of Easy, cubicles, Twistycool and alpha-1.5, with a certified path.":
        "auto résout tous les essais d'Easy, cubicles, Twistycool et alpha-1.5, avec un chemin certifié.",
    "auto takes a fifth of the time of OMPL's best at 0.1 %.":
        "auto prend un cinquième du temps du meilleur d'OMPL à 0,1 %.",
    "Automatic tuning of α, N and d against fixed settings":
        "Réglage automatique de α, N et d face à des réglages fixes",
    "Tuned runs are solved at least nine tenths as often as with the best fixed setting.":
        ("Les essais réglés automatiquement sont résolus au moins neuf fois sur dix par rapport au "
         "meilleur réglage fixe."),
    "Tuned α, N and d are within 15 % of the best fixed setting in median steps, without knowing it.":
        ("α, N et d réglés automatiquement sont à moins de 15 % du meilleur réglage fixe en pas médians,"
         " sans le connaître."),
    ("α, N and d set themselves from what computer, operator and contact earned lately, against the best"
     " of a coarse grid of fixed settings, the same seeds for all. Lockstep at 40 planner steps a second"
     " of the operator's time."):
        ("α, N et d se règlent d'après ce que l'ordinateur, l'opérateur et le contact ont apporté "
         "récemment, face au meilleur d'une grille grossière de réglages fixes, avec les mêmes graines "
         "pour tous. Pas à pas, à 40 pas du planificateur par seconde du temps de l'opérateur."),
    "BiRRT alone, one run: 2 h 45 (paper 1, table I)": "BiRRT seul, un essai\u00a0: 2 h 45 (article 1, tableau I)",
    "BiRRT alone: nothing in a night; a person with contact: 61 s (paper 1, table V)":
        "BiRRT seul\u00a0: rien en une nuit\u00a0; une personne avec contact\u00a0: 61 s (article 1, tableau V)",
    "Environment 1: a median of 0.2 s at most.": "Environnement 1\u00a0: une médiane de 0,2 s au plus.",
    "Environment 2: a median of 3 s at most.": "Environnement 2\u00a0: une médiane de 3 s au plus.",
    "Environments 1 and 2: faster than our BiRRT and than OMPL's planners.":
        "Environnements 1 et 2\u00a0: plus rapide que notre BiRRT et que les planificateurs d'OMPL.",
    ("Strategy auto without an operator, beside other planners: our BiRRT, GTS on the pump, and "
     "unmodified OMPL (edges looked at every 0.1 % of the extent). Seconds are of the processor, but "
     "what is asked of auto alone and beside GTS is what one waits; over all runs: one that was not "
     "solved counts with the time it had. A path of OMPL's counts as solved where our certificate holds."):
        ("Stratégie auto sans opérateur, à côté d'autres planificateurs\u00a0: notre BiRRT, GTS sur la pompe,"
         " et OMPL non modifié (arêtes regardées tous les 0,1 % de l'étendue). Les secondes sont celles "
         "du processeur, mais ce qui est demandé à auto seul et à côté de GTS est le temps d'attente\u00a0; "
         "sur tous les essais\u00a0: un essai non résolu compte avec le temps qu'il a eu. Un chemin d'OMPL "
         "compte comme résolu là où notre certificat tient."),
    "The automatic planner on our samples": "Le planificateur automatique sur nos exemples",
    "The pump: ten times faster than GTS.": "La pompe\u00a0: dix fois plus rapide que GTS.",
    "auto solves every run, with a certified path.": "auto résout tous les essais, avec un chemin certifié.",
    "Scenario": "Scénario",
    "Success rate (%)": "Taux de succès (%)",
    "Authority α": "Autorité α",
    "Contact samples N": "Échantillons de contact N",
    "Contact distance d (m)": "Distance de contact d (m)",
}
