<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Open a scenario or an OMPL.app problem</source>
        <translation>Ouvrir un scénario ou un problème OMPL.app</translation>
    </message>
    <message>
        <source>&amp;Export path...</source>
        <translation>&amp;Exporter le chemin...</translation>
    </message>
    <message>
        <source>Save the certified path as CSV, JSON or OMPL columns</source>
        <translation>Enregistrer le chemin certifié en CSV, JSON ou colonnes OMPL</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Leave Glissade</source>
        <translation>Quitter Glissade</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Démarrer</translation>
    </message>
    <message>
        <source>Plan with a fresh roadmap and the current seed</source>
        <translation>Planifier avec un nouveau graphe et la graine courante</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Hold the planner, or let it go on</source>
        <translation>Suspendre le planificateur, ou le laisser continuer</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>End the run; what was found stays shown</source>
        <translation>Terminer ; ce qui a été trouvé reste affiché</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Redémarrer</translation>
    </message>
    <message>
        <source>Stop and start again with the same seed</source>
        <translation>Arrêter et redémarrer avec la même graine</translation>
    </message>
    <message>
        <source>Restart with a &amp;new seed</source>
        <translation>Redémarrer, &amp;nouvelle graine</translation>
    </message>
    <message>
        <source>Stop and start again with the next seed</source>
        <translation>Arrêter et redémarrer avec la graine suivante</translation>
    </message>
    <message>
        <source>&amp;Object to the start</source>
        <translation>&amp;Objet au départ</translation>
    </message>
    <message>
        <source>Put the object in your hand back to the start</source>
        <translation>Remettre l'objet tenu en main au départ</translation>
    </message>
    <message>
        <source>&amp;Play the path</source>
        <translation>&amp;Jouer le chemin</translation>
    </message>
    <message>
        <source>Move the object along the path, or hold it</source>
        <translation>Déplacer l'objet le long du chemin, ou l'arrêter</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Cadrer</translation>
    </message>
    <message>
        <source>Show everything, direction kept</source>
        <translation>Tout montrer, direction conservée</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrique</translation>
    </message>
    <message>
        <source>Look from a corner</source>
        <translation>Regarder depuis un coin</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>&amp;Avant</translation>
    </message>
    <message>
        <source>Look along y</source>
        <translation>Regarder selon y</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>A&amp;rrière</translation>
    </message>
    <message>
        <source>Look against y</source>
        <translation>Regarder contre y</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>Look along x</source>
        <translation>Regarder selon x</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>Look against x</source>
        <translation>Regarder contre x</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Dess&amp;us</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Regarder vers le bas</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Dess&amp;ous</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Regarder vers le haut</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Thème &amp;sombre</translation>
    </message>
    <message>
        <source>Light figures on a dark ground</source>
        <translation>Figures claires sur fond sombre</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstacles</translation>
    </message>
    <message>
        <source>Show the obstacles</source>
        <translation>Montrer les obstacles</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Show the object in your hand</source>
        <translation>Montrer l'objet tenu en main</translation>
    </message>
    <message>
        <source>Start and goal</source>
        <translation>Départ et but</translation>
    </message>
    <message>
        <source>Show start and goal as ghosts</source>
        <translation>Montrer départ et but en transparence</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Espace de travail</translation>
    </message>
    <message>
        <source>Show the bounds of the reference point</source>
        <translation>Montrer les bornes du point de référence</translation>
    </message>
    <message>
        <source>Roadmap</source>
        <translation>Graphe</translation>
    </message>
    <message>
        <source>Show the trees</source>
        <translation>Montrer les arbres</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Show the path</source>
        <translation>Montrer le chemin</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Show the nearest obstacle and the tangent plane</source>
        <translation>Montrer l'obstacle le plus proche et le plan tangent</translation>
    </message>
    <message>
        <source>&amp;Keys and shortcuts</source>
        <translation>&amp;Touches et raccourcis</translation>
    </message>
    <message>
        <source>How to steer, and all shortcuts</source>
        <translation>Comment piloter, et tous les raccourcis</translation>
    </message>
    <message>
        <source>&amp;About Glissade</source>
        <translation>À &amp;propos de Glissade</translation>
    </message>
    <message>
        <source>Version, licence and the papers</source>
        <translation>Version, licence et articles</translation>
    </message>
</context>
<context>
    <name>Devices</name>
    <message>
        <source>Keyboard and 6D mouse</source>
        <translation>Clavier et souris 6D</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
    </message>
    <message>
        <source>Simulated expert</source>
        <translation>Expert simulé</translation>
    </message>
    <message>
        <source>Simulated operator</source>
        <translation>Opérateur simulé</translation>
    </message>
    <message>
        <source>Simulated novice</source>
        <translation>Novice simulé</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Authority</source>
        <translation>Autorité</translation>
    </message>
    <message>
        <source>Contact samples</source>
        <translation>Échantillons de contact</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Distance de contact</translation>
    </message>
    <message>
        <source>Contact disc</source>
        <translation>Disque de contact</translation>
    </message>
    <message>
        <source>The computer&apos;s share of the iterations: 1 is the automatic planner alone, 0 the operator alone.</source>
        <translation>La part de l'ordinateur dans les itérations : 1 est le planificateur seul, 0 l'opérateur seul.</translation>
    </message>
    <message>
        <source>Samples shot on the tangent plane each time contact mode is entered.</source>
        <translation>Échantillons tirés sur le plan tangent à chaque entrée en mode contact.</translation>
    </message>
    <message>
        <source>Closer than this to the nearest obstacle, contact mode begins.</source>
        <translation>Plus près que cela de l'obstacle le plus proche, le mode contact commence.</translation>
    </message>
    <message>
        <source>Radius of the disc on the tangent plane in which contact samples are shot.</source>
        <translation>Rayon du disque du plan tangent dans lequel les échantillons de contact sont tirés.</translation>
    </message>
</context>
<context>
    <name>Planners</name>
    <message>
        <source>Interactive BiRRT with contact</source>
        <translation>BiRRT interactif avec contact</translation>
    </message>
    <message>
        <source>Interactive BiRRT</source>
        <translation>BiRRT interactif</translation>
    </message>
    <message>
        <source>BiRRT</source>
        <translation>BiRRT</translation>
    </message>
    <message>
        <source>Interactive BiRRT, contact first</source>
        <translation>BiRRT interactif, contact d'abord</translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>Ready. Press Start (F5), or take the object with the keys over the view.</source>
        <translation>Prêt. Appuyez sur Démarrer (F5), ou prenez l'objet avec les touches sur la vue.</translation>
    </message>
    <message>
        <source>Planning: sampling on the nearest obstacle&apos;s tangent plane</source>
        <translation>Planification : échantillonnage sur le plan tangent de l'obstacle le plus proche</translation>
    </message>
    <message>
        <source>Planning: two trees grow</source>
        <translation>Planification : deux arbres poussent</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Solved: the path is certified free of penetration</source>
        <translation>Résolu : le chemin est certifié sans pénétration</translation>
    </message>
    <message>
        <source>Stopped: what was found stays shown</source>
        <translation>Arrêté : ce qui a été trouvé reste affiché</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
</context>
<context>
    <name>glissade::CountsPanel</name>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Passes of the paper&apos;s loop</source>
        <translation>Passages dans la boucle de l'article</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Nodes of the roadmap</source>
        <translation>Nœuds du graphe</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Both directions, as the papers count</source>
        <translation>Dans les deux sens, comme les articles</translation>
    </message>
    <message>
        <source>Random configurations</source>
        <translation>Configurations aléatoires</translation>
    </message>
    <message>
        <source>Drawn by the computer, kept or not</source>
        <translation>Tirées par l'ordinateur, gardées ou non</translation>
    </message>
    <message>
        <source>Operator configurations</source>
        <translation>Configurations de l'opérateur</translation>
    </message>
    <message>
        <source>Where the operator held the object</source>
        <translation>Là où l'opérateur tenait l'objet</translation>
    </message>
    <message>
        <source>Contact configurations</source>
        <translation>Configurations de contact</translation>
    </message>
    <message>
        <source>Shot on tangent planes, kept or not</source>
        <translation>Tirées sur les plans tangents, gardées ou non</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Of planning; pauses do not count</source>
        <translation>De planification ; les pauses ne comptent pas</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>Pas par seconde</translation>
    </message>
    <message>
        <source>Planner steps in a second</source>
        <translation>Pas du planificateur en une seconde</translation>
    </message>
    <message>
        <source>Contact mode</source>
        <translation>Mode contact</translation>
    </message>
    <message>
        <source>On while contact samples are shot</source>
        <translation>Actif pendant le tir des échantillons de contact</translation>
    </message>
    <message>
        <source>Nearest obstacle</source>
        <translation>Obstacle le plus proche</translation>
    </message>
    <message>
        <source>Of the object in the operator&apos;s hand</source>
        <translation>De l'objet tenu par l'opérateur</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>To the nearest obstacle</source>
        <translation>À l'obstacle le plus proche</translation>
    </message>
    <message>
        <source>on</source>
        <translation>actif</translation>
    </message>
    <message>
        <source>off</source>
        <translation>inactif</translation>
    </message>
    <message>
        <source>in collision</source>
        <translation>en collision</translation>
    </message>
</context>
<context>
    <name>glissade::InteractionPanel</name>
    <message>
        <source>The planner of the next run</source>
        <translation>Le planificateur du prochain calcul</translation>
    </message>
    <message>
        <source>Who holds the object</source>
        <translation>Qui tient l'objet</translation>
    </message>
    <message>
        <source>Same scenario, seed and inputs: same roadmap</source>
        <translation>Mêmes scénario, graine et entrées : même graphe</translation>
    </message>
    <message>
        <source>Whose configuration was tried last</source>
        <translation>De qui vient la dernière configuration essayée</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planificateur</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Authority now</source>
        <translation>Autorité actuelle</translation>
    </message>
    <message>
        <source>computer</source>
        <translation>ordinateur</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>opérateur</translation>
    </message>
    <message>
        <source>operator, in contact</source>
        <translation>opérateur, en contact</translation>
    </message>
</context>
<context>
    <name>glissade::KeyboardSteering</name>
    <message>
        <source>left, right</source>
        <translation>gauche, droite</translation>
    </message>
    <message>
        <source>up, down</source>
        <translation>haut, bas</translation>
    </message>
    <message>
        <source>away from you, towards you</source>
        <translation>loin de vous, vers vous</translation>
    </message>
    <message>
        <source>turn left, turn right</source>
        <translation>tourner à gauche, à droite</translation>
    </message>
    <message>
        <source>tip back, tip forward</source>
        <translation>basculer en arrière, en avant</translation>
    </message>
    <message>
        <source>roll left, roll right</source>
        <translation>rouler à gauche, à droite</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>a quarter of the speed</source>
        <translation>un quart de la vitesse</translation>
    </message>
</context>
<context>
    <name>glissade::MainWindow</name>
    <message>
        <source>&lt;h2&gt;Glissade&lt;/h2&gt;&lt;p&gt;Open a scenario (Ctrl+O), or drop one here.&lt;/p&gt;&lt;p&gt;The folder &lt;i&gt;samples&lt;/i&gt; holds the papers&apos; environments.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;Glissade&lt;/h2&gt;&lt;p&gt;Ouvrez un scénario (Ctrl+O), ou déposez-en un ici.&lt;/p&gt;&lt;p&gt;Le dossier &lt;i&gt;samples&lt;/i&gt; contient les environnements des articles.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No scenario is open.</source>
        <translation>Aucun scénario n'est ouvert.</translation>
    </message>
    <message>
        <source>Interaction</source>
        <translation>Interaction</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Calcul</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Couches</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>The scenario cannot be opened</source>
        <translation>Le scénario ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>The scenario was opened, with a warning</source>
        <translation>Le scénario est ouvert, avec un avertissement</translation>
    </message>
    <message>
        <source>Open a scenario</source>
        <translation>Ouvrir un scénario</translation>
    </message>
    <message>
        <source>Scenarios (*.json *.cfg);;All files (*)</source>
        <translation>Scénarios (*.json *.cfg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Export the path</source>
        <translation>Exporter le chemin</translation>
    </message>
    <message>
        <source>Table (*.csv);;With provenance (*.json);;OMPL columns (*.path)</source>
        <translation>Tableau (*.csv);;Avec provenance (*.json);;Colonnes OMPL (*.path)</translation>
    </message>
    <message>
        <source>The path cannot be saved</source>
        <translation>Le chemin ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Keys and shortcuts</source>
        <translation>Touches et raccourcis</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Pilotage</translation>
    </message>
    <message>
        <source>While the 3D view has the focus; directions are those of the view.</source>
        <translation>Quand la vue 3D a le focus ; les directions sont celles de la vue.</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>About Glissade</source>
        <translation>À propos de Glissade</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Glissade %1&lt;/h3&gt;&lt;p&gt;A workbench for virtual assembly: certified motions, found by a planner and a person together.&lt;/p&gt;&lt;p&gt;N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, &lt;i&gt;Tuning Interaction in Motion Planning with Contact&lt;/i&gt;, IEEE RO-MAN 2016.&lt;/p&gt;&lt;p&gt;S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, &lt;i&gt;Multi-layer path planning control for the simulation of manipulation tasks&lt;/i&gt;, RCIM 57, 2019.&lt;/p&gt;&lt;p&gt;BSD 3-Clause licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Glissade %1&lt;/h3&gt;&lt;p&gt;Un établi pour l'assemblage virtuel : des mouvements certifiés, trouvés ensemble par un planificateur et une personne.&lt;/p&gt;&lt;p&gt;N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, &lt;i&gt;Tuning Interaction in Motion Planning with Contact&lt;/i&gt;, IEEE RO-MAN 2016.&lt;/p&gt;&lt;p&gt;S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, &lt;i&gt;Multi-layer path planning control for the simulation of manipulation tasks&lt;/i&gt;, RCIM 57, 2019.&lt;/p&gt;&lt;p&gt;Licence BSD à 3 clauses.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>glissade::PathPanel</name>
    <message>
        <source>Place on the path</source>
        <translation>Position sur le chemin</translation>
    </message>
    <message>
        <source>No path yet.</source>
        <translation>Pas encore de chemin.</translation>
    </message>
    <message>
        <source>nothing near</source>
        <translation>rien à proximité</translation>
    </message>
    <message>
        <source>clearance %1 mm to %2</source>
        <translation>jeu de %1 mm avec %2</translation>
    </message>
    <message>
        <source>Certified free of penetration</source>
        <translation>Certifié sans pénétration</translation>
    </message>
    <message>
        <source>%1 configurations, %2 m, %3°</source>
        <translation>%1 configurations, %2 m, %3°</translation>
    </message>
    <message>
        <source>by computer %1, operator %2, contact %3</source>
        <translation>ordinateur %1, opérateur %2, contact %3</translation>
    </message>
</context>
<context>
    <name>glissade::ScenePanel</name>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>déplacé</translation>
    </message>
    <message>
        <source>start  %1</source>
        <translation>départ  %1</translation>
    </message>
    <message>
        <source>goal  %1</source>
        <translation>but  %1</translation>
    </message>
    <message>
        <source>out</source>
        <translation>dehors</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstacles</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>mobile</source>
        <translation>mobile</translation>
    </message>
</context>
</TS>
