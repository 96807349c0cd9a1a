<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>Actions</name>
    <message>
        <source>Forbid</source>
        <translation>Interdire</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Préférer</translation>
    </message>
    <message>
        <source>Milestone</source>
        <translation>Jalon</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Rename...</source>
        <translation>Renommer...</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Section panel</source>
        <translation>Panneau Coupe</translation>
    </message>
    <message>
        <source>Bring the section planes to the front</source>
        <translation>Mettre les plans de coupe au premier plan</translation>
    </message>
    <message>
        <source>Begin again when the path was played to its end</source>
        <translation>Recommencer quand le chemin a été joué jusqu&apos;au bout</translation>
    </message>
    <message>
        <source>Play the path from its goal to its start</source>
        <translation>Jouer le chemin du but vers le départ</translation>
    </message>
    <message>
        <source>Tigh&amp;test place</source>
        <translation>Passage le plus &amp;étroit</translation>
    </message>
    <message>
        <source>Show the object at the place of the smallest clearance</source>
        <translation>Montrer l&apos;objet là où le jeu est le plus petit</translation>
    </message>
    <message>
        <source>&amp;Keep the roadmap</source>
        <translation>&amp;Garder le graphe</translation>
    </message>
    <message>
        <source>Draw the roadmap in full, not faint, while a path is shown</source>
        <translation>Dessiner le graphe en entier, sans l&apos;estomper, pendant qu&apos;un chemin est affiché</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>Left orbits, middle or Shift + left pans, right zooms</source>
        <translation>Gauche : tourner ; milieu ou Maj + gauche : déplacer ; droit : zoomer</translation>
    </message>
    <message>
        <source>&amp;CAD</source>
        <translation>&amp;CAO</translation>
    </message>
    <message>
        <source>Middle orbits, Ctrl + middle pans, Shift + middle zooms</source>
        <translation>Milieu : tourner ; Ctrl + milieu : déplacer ; Maj + milieu : zoomer</translation>
    </message>
    <message>
        <source>&amp;Blender</source>
        <translation>&amp;Blender</translation>
    </message>
    <message>
        <source>Middle orbits, Shift + middle pans, Ctrl + middle zooms</source>
        <translation>Milieu : tourner ; Maj + milieu : déplacer ; Ctrl + milieu : zoomer</translation>
    </message>
    <message>
        <source>FreeCAD &amp;gesture</source>
        <translation>&amp;Gestes de FreeCAD</translation>
    </message>
    <message>
        <source>Left orbits, right pans, both roll</source>
        <translation>Gauche : tourner ; droit : déplacer ; les deux : incliner</translation>
    </message>
    <message>
        <source>&amp;Trackball</source>
        <translation>&amp;Trackball</translation>
    </message>
    <message>
        <source>As standard, but the horizon does not stay level</source>
        <translation>Comme standard, mais l&apos;horizon ne reste pas horizontal</translation>
    </message>
    <message>
        <source>Shaded with &amp;edges</source>
        <translation>Ombré avec &amp;arêtes</translation>
    </message>
    <message>
        <source>Draw bodies opaque, with their edges</source>
        <translation>Dessiner les corps opaques, avec leurs arêtes</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>&amp;Ombré</translation>
    </message>
    <message>
        <source>Draw bodies opaque, without edges</source>
        <translation>Dessiner les corps opaques, sans arêtes</translation>
    </message>
    <message>
        <source>See-&amp;through</source>
        <translation>&amp;Transparent</translation>
    </message>
    <message>
        <source>Draw bodies transparent, with all their edges</source>
        <translation>Dessiner les corps transparents, avec toutes leurs arêtes</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Fil de fer</translation>
    </message>
    <message>
        <source>Draw only the edges of bodies; hidden edges are dashed</source>
        <translation>Ne dessiner que les arêtes des corps ; les arêtes cachées sont en tirets</translation>
    </message>
    <message>
        <source>Selected: shaded with edges</source>
        <translation>Sélection : ombrée avec arêtes</translation>
    </message>
    <message>
        <source>Draw the selected bodies opaque, with their edges</source>
        <translation>Dessiner les corps sélectionnés opaques, avec leurs arêtes</translation>
    </message>
    <message>
        <source>Selected: shaded</source>
        <translation>Sélection : ombrée</translation>
    </message>
    <message>
        <source>Draw the selected bodies opaque, without edges</source>
        <translation>Dessiner les corps sélectionnés opaques, sans arêtes</translation>
    </message>
    <message>
        <source>Selected: see-through</source>
        <translation>Sélection : transparente</translation>
    </message>
    <message>
        <source>Draw the selected bodies transparent, with all their edges</source>
        <translation>Dessiner les corps sélectionnés transparents, avec toutes leurs arêtes</translation>
    </message>
    <message>
        <source>Selected: wireframe</source>
        <translation>Sélection : fil de fer</translation>
    </message>
    <message>
        <source>Draw only the edges of the selected bodies</source>
        <translation>Ne dessiner que les arêtes des corps sélectionnés</translation>
    </message>
    <message>
        <source>Selected: as the view</source>
        <translation>Sélection : comme la vue</translation>
    </message>
    <message>
        <source>Draw the selected bodies in the display mode of the view again</source>
        <translation>Redonner aux corps sélectionnés le mode d&apos;affichage de la vue</translation>
    </message>
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
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
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
        <source>S&amp;top</source>
        <translation>&amp;Arrêter</translation>
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
        <source>&amp;Play the path</source>
        <translation>&amp;Jouer le chemin</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Cadrer</translation>
    </message>
    <message>
        <source>Show the bodies, the ends and the path, direction kept</source>
        <translation>Montrer les corps, les extrémités et le chemin, sans changer de direction</translation>
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
        <translation>Montrer l&apos;obstacle le plus proche et le plan tangent</translation>
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
        <source>&amp;Change shortcuts...</source>
        <translation>&amp;Changer les raccourcis...</translation>
    </message>
    <message>
        <source>Give commands other shortcuts</source>
        <translation>Donner d&apos;autres raccourcis aux commandes</translation>
    </message>
    <message>
        <source>&amp;About Glissade</source>
        <translation>À &amp;propos de Glissade</translation>
    </message>
    <message>
        <source>Version, licence and the papers</source>
        <translation>Version, licence et articles</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Enregi&amp;strer</translation>
    </message>
    <message>
        <source>Save the scenario with its attributes, strategy and parameters</source>
        <translation>Enregistrer le scénario avec ses attributs, sa stratégie et ses paramètres</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous...</translation>
    </message>
    <message>
        <source>Save the scenario under another name</source>
        <translation>Enregistrer le scénario sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Ann&amp;uler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Find &amp;places</source>
        <translation>Trouver les &amp;lieux</translation>
    </message>
    <message>
        <source>Build the environment model: octree, places, borders, compatibility</source>
        <translation>Construire le modèle de l&apos;environnement : octree, lieux, frontières, compatibilité</translation>
    </message>
    <message>
        <source>&amp;Add attribute...</source>
        <translation>&amp;Ajouter un attribut...</translation>
    </message>
    <message>
        <source>Define an attribute of your own on places or bodies</source>
        <translation>Définir un attribut à vous sur les lieux ou les corps</translation>
    </message>
    <message>
        <source>Rename the attribute of the current row, where it is your own</source>
        <translation>Renommer l&apos;attribut de la ligne courante, s&apos;il est à vous</translation>
    </message>
    <message>
        <source>Remove the attribute of the current row, where it is your own</source>
        <translation>Supprimer l&apos;attribut de la ligne courante, s&apos;il est à vous</translation>
    </message>
    <message>
        <source>Let no path lead through the selected places, or allow it again</source>
        <translation>Ne laisser passer aucun chemin par les lieux choisis, ou le permettre à nouveau</translation>
    </message>
    <message>
        <source>Free cells</source>
        <translation>Cellules libres</translation>
    </message>
    <message>
        <source>Show the octree&apos;s free cells, the coarsest first</source>
        <translation>Montrer les cellules libres de l&apos;octree, les plus grandes d&apos;abord</translation>
    </message>
    <message>
        <source>Cells with mobile bodies</source>
        <translation>Cellules à corps mobiles</translation>
    </message>
    <message>
        <source>Show the cells that only mobile bodies clutter</source>
        <translation>Montrer les cellules que seuls des corps mobiles encombrent</translation>
    </message>
    <message>
        <source>Cells with static bodies</source>
        <translation>Cellules à corps statiques</translation>
    </message>
    <message>
        <source>Show the cells that static bodies clutter</source>
        <translation>Montrer les cellules que des corps statiques encombrent</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lieux</translation>
    </message>
    <message>
        <source>Show the places, coloured by complexity; click to select</source>
        <translation>Montrer les lieux, colorés selon leur complexité ; cliquer pour choisir</translation>
    </message>
    <message>
        <source>Borders</source>
        <translation>Frontières</translation>
    </message>
    <message>
        <source>Show where places meet</source>
        <translation>Montrer où les lieux se touchent</translation>
    </message>
    <message>
        <source>Topological graph</source>
        <translation>Graphe topologique</translation>
    </message>
    <message>
        <source>Show the topological graph with its costs</source>
        <translation>Montrer le graphe topologique avec ses coûts</translation>
    </message>
    <message>
        <source>Coarse path</source>
        <translation>Chemin grossier</translation>
    </message>
    <message>
        <source>Show the cheapest way through the graph</source>
        <translation>Montrer le chemin le moins coûteux dans le graphe</translation>
    </message>
    <message>
        <source>Milestones</source>
        <translation>Jalons</translation>
    </message>
    <message>
        <source>Region of a step</source>
        <translation>Région d&apos;une étape</translation>
    </message>
    <message>
        <source>Show where the local planner of the chosen step searches</source>
        <translation>Montrer où cherche le planificateur local de l&apos;étape choisie</translation>
    </message>
    <message>
        <source>Scene panel</source>
        <translation>Panneau Scène</translation>
    </message>
    <message>
        <source>Bring the list of bodies to the front</source>
        <translation>Mettre la liste des corps au premier plan</translation>
    </message>
    <message>
        <source>Semantics panel</source>
        <translation>Panneau Sémantique</translation>
    </message>
    <message>
        <source>Bring the editor of semantic attributes to the front</source>
        <translation>Mettre l&apos;éditeur des attributs sémantiques au premier plan</translation>
    </message>
    <message>
        <source>Run panel</source>
        <translation>Panneau Calcul</translation>
    </message>
    <message>
        <source>Bring the figures of the run to the front</source>
        <translation>Mettre les chiffres du calcul au premier plan</translation>
    </message>
    <message>
        <source>Plan panel</source>
        <translation>Panneau Plan</translation>
    </message>
    <message>
        <source>Bring the topological steps to the front</source>
        <translation>Mettre les étapes topologiques au premier plan</translation>
    </message>
    <message>
        <source>Path panel</source>
        <translation>Panneau Chemin</translation>
    </message>
    <message>
        <source>Bring the path and its certificate to the front</source>
        <translation>Mettre le chemin et son certificat au premier plan</translation>
    </message>
    <message>
        <source>Fi&amp;ner cells</source>
        <translation>Cellules plus fi&amp;nes</translation>
    </message>
    <message>
        <source>Show the octree&apos;s cells one level deeper</source>
        <translation>Montrer les cellules de l&apos;octree un niveau plus bas</translation>
    </message>
    <message>
        <source>&amp;Coarser cells</source>
        <translation>Cellules plus &amp;grosses</translation>
    </message>
    <message>
        <source>Show the octree&apos;s cells one level less deep</source>
        <translation>Montrer les cellules de l&apos;octree un niveau plus haut</translation>
    </message>
    <message>
        <source>Show the configurations to pass through; drag one to move it, Ctrl+drag to turn it</source>
        <translation>Montrer les configurations de passage ; faire glisser pour en déplacer une, Ctrl + glisser pour la tourner</translation>
    </message>
    <message>
        <source>Steer the &amp;camera</source>
        <translation>Diriger la &amp;caméra</translation>
    </message>
    <message>
        <source>Keys, 6D mouse and gamepad move the camera, or the object again</source>
        <translation>Clavier, souris 6D et manette déplacent la caméra, ou de nouveau l&apos;objet</translation>
    </message>
    <message>
        <source>&amp;Devices...</source>
        <translation>&amp;Périphériques...</translation>
    </message>
    <message>
        <source>Calibrate 6D mouse, keys and gamepad: live axes, curves, presets, buttons</source>
        <translation>Étalonner souris 6D, clavier et manette : axes en direct, courbes, préréglages, boutons</translation>
    </message>
    <message>
        <source>Save &amp;recording...</source>
        <translation>Sauvegarder l&apos;en&amp;registrement...</translation>
    </message>
    <message>
        <source>Save what was done in the last run, to replay it bit by bit</source>
        <translation>Enregistrer ce qui a été fait au dernier calcul, pour le rejouer au bit près</translation>
    </message>
    <message>
        <source>Open re&amp;cording...</source>
        <translation>Ouvrir un en&amp;registrement...</translation>
    </message>
    <message>
        <source>Replay a recorded run</source>
        <translation>Rejouer un calcul enregistré</translation>
    </message>
    <message>
        <source>Replay the &amp;last run</source>
        <translation>Re&amp;jouer le dernier calcul</translation>
    </message>
    <message>
        <source>Run the last run, or the recording opened last, again bit by bit</source>
        <translation>Refaire au bit près le dernier calcul, ou le dernier enregistrement ouvert</translation>
    </message>
    <message>
        <source>Replay with &amp;current parameters</source>
        <translation>Rejouer avec les &amp;paramètres courants</translation>
    </message>
    <message>
        <source>What the same operator would have led to with the sliders as they are set</source>
        <translation>Ce que le même opérateur aurait donné avec les curseurs tels qu&apos;ils sont</translation>
    </message>
    <message>
        <source>Play the r&amp;eplay</source>
        <translation>&amp;Lancer la relecture</translation>
    </message>
    <message>
        <source>Step &amp;forward</source>
        <translation>Pas en a&amp;vant</translation>
    </message>
    <message>
        <source>Show the next step of the replay</source>
        <translation>Montrer le pas suivant de la relecture</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Pas en a&amp;rrière</translation>
    </message>
    <message>
        <source>Show the step before</source>
        <translation>Montrer le pas précédent</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>Au dé&amp;but</translation>
    </message>
    <message>
        <source>Show the replay from its beginning</source>
        <translation>Montrer la relecture depuis son début</translation>
    </message>
    <message>
        <source>Close the repla&amp;y</source>
        <translation>&amp;Fermer la relecture</translation>
    </message>
    <message>
        <source>Go back to the session; its run and parameters are as they were left</source>
        <translation>Revenir à la session ; son calcul et ses paramètres sont tels qu&apos;on les a laissés</translation>
    </message>
    <message>
        <source>Path by &amp;author</source>
        <translation>Chemin par &amp;auteur</translation>
    </message>
    <message>
        <source>Colour the path by who made each segment: computer, operator, contact</source>
        <translation>Colorer le chemin selon l&apos;auteur de chaque segment : ordinateur, opérateur, contact</translation>
    </message>
    <message>
        <source>&amp;Open study results...</source>
        <translation>&amp;Ouvrir les résultats d&apos;une étude...</translation>
    </message>
    <message>
        <source>Browse a study&apos;s tables and plots, and see its runs again</source>
        <translation>Parcourir les tableaux et les courbes d&apos;une étude, et revoir ses essais</translation>
    </message>
    <message>
        <source>&amp;Report as PDF...</source>
        <translation>&amp;Rapport en PDF...</translation>
    </message>
    <message>
        <source>Write the report of the study that is open as PDF</source>
        <translation>Écrire en PDF le rapport de l&apos;étude ouverte</translation>
    </message>
    <message>
        <source>S&amp;mooth the path</source>
        <translation>&amp;Lisser le chemin</translation>
    </message>
    <message>
        <source>Guidance force</source>
        <translation>Force de guidage</translation>
    </message>
    <message>
        <source>Show what guides the hand: the force as an arrow, its strength as a tint</source>
        <translation>Montrer ce qui guide la main : la force par une flèche, son intensité par une teinte</translation>
    </message>
    <message>
        <source>&amp;Automatic tuning</source>
        <translation>Réglage &amp;automatique</translation>
    </message>
    <message>
        <source>Let α, N and d set themselves while planning, or take them back as you had them</source>
        <translation>Laisser α, N et d se régler seuls pendant la planification, ou les reprendre tels que vous les aviez</translation>
    </message>
    <message>
        <source>Empty the list of the files opened last</source>
        <translation>Vider la liste des derniers fichiers ouverts</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>End what is being done in the background: reading, smoothing, looking for reasons</source>
        <translation>Arrêter ce qui se fait en arrière-plan : lecture, lissage, recherche des raisons</translation>
    </message>
    <message>
        <source>The camera &amp;rolls</source>
        <translation>Le &amp;roulis de la caméra</translation>
    </message>
    <message>
        <source>Turning about the line of sight rolls the camera, or the horizon stays level</source>
        <translation>Tourner autour de l&apos;axe de visée fait rouler la caméra, sinon l&apos;horizon reste droit</translation>
    </message>
    <message>
        <source>Shorten the path by shortcuts that are certified, or show it as planned</source>
        <translation>Raccourcir le chemin par des raccourcis certifiés, ou le montrer tel que planifié</translation>
    </message>
    <message>
        <source>&amp;Why no path?</source>
        <translation>&amp;Pourquoi pas de chemin ?</translation>
    </message>
    <message>
        <source>Play the way of &amp;least penetration</source>
        <translation>Jouer le chemin de &amp;moindre pénétration</translation>
    </message>
    <message>
        <source>Whole &amp;plot</source>
        <translation>&amp;Courbe entière</translation>
    </message>
    <message>
        <source>Show all of the study&apos;s plot again after a rubber band or the wheel has enlarged a part</source>
        <translation>Montrer de nouveau toute la courbe de l&apos;étude, après un agrandissement au rectangle ou à la molette</translation>
    </message>
    <message>
        <source>&amp;Copy plot</source>
        <translation>Co&amp;pier la courbe</translation>
    </message>
    <message>
        <source>Put the study&apos;s plot into the clipboard as it is seen</source>
        <translation>Mettre la courbe de l&apos;étude dans le presse-papiers telle qu&apos;on la voit</translation>
    </message>
    <message>
        <source>&amp;Save plot...</source>
        <translation>&amp;Enregistrer la courbe...</translation>
    </message>
    <message>
        <source>Save the study&apos;s plot as it is seen, as SVG or PNG</source>
        <translation>Enregistrer la courbe de l&apos;étude telle qu&apos;on la voit, en SVG ou en PNG</translation>
    </message>
    <message>
        <source>&amp;Hide the selected bodies</source>
        <translation>Cac&amp;her les corps sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Isolate the selected bodies</source>
        <translation>&amp;Isoler les corps sélectionnés</translation>
    </message>
    <message>
        <source>Draw the selected obstacles and no others</source>
        <translation>Dessiner les obstacles sélectionnés et aucun autre</translation>
    </message>
    <message>
        <source>&amp;Show all bodies</source>
        <translation>Montrer &amp;tous les corps</translation>
    </message>
    <message>
        <source>Draw all obstacles again</source>
        <translation>Dessiner de nouveau tous les obstacles</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>Disposition d&apos;&amp;origine</translation>
    </message>
    <message>
        <source>Put all panels where they were at first</source>
        <translation>Remettre tous les panneaux à leur place d&apos;origine</translation>
    </message>
    <message>
        <source>What stands in the way</source>
        <translation>Ce qui fait obstacle</translation>
    </message>
    <message>
        <source>Show why no path was found: blocking body, gap, way of least penetration</source>
        <translation>Montrer pourquoi aucun chemin n&apos;a été trouvé : corps bloquant, lacune, chemin de moindre pénétration</translation>
    </message>
    <message>
        <source>Difficulty panel</source>
        <translation>Panneau Difficulté</translation>
    </message>
    <message>
        <source>Bring the reasons why no path was found to the front</source>
        <translation>Mettre au premier plan les raisons pour lesquelles aucun chemin n&apos;a été trouvé</translation>
    </message>
    <message>
        <source>&amp;New from parts...</source>
        <translation>&amp;Nouveau à partir de pièces...</translation>
    </message>
    <message>
        <source>&amp;Add parts...</source>
        <translation>&amp;Ajouter des pièces...</translation>
    </message>
    <message>
        <source>This part &amp;moves</source>
        <translation>Cette pièce &amp;bouge</translation>
    </message>
    <message>
        <source>The selected body becomes the object, from where it lies to &quot;out&quot;; what moved until now stays where it started</source>
        <translation>Le corps sélectionné devient l&apos;objet, de là où il est vers « dehors » ; ce qui bougeait reste à son départ</translation>
    </message>
    <message>
        <source>Arrange &amp;with the mouse</source>
        <translation>Disposer à la so&amp;uris</translation>
    </message>
    <message>
        <source>Place by a face or a&amp;xis</source>
        <translation>Placer par une face ou un a&amp;xe</translation>
    </message>
    <message>
        <source>Click a plane or a cylinder: the numbers of the placement are those of its frame</source>
        <translation>Cliquer un plan ou un cylindre : les nombres du placement sont ceux de son repère</translation>
    </message>
    <message>
        <source>&amp;Start here</source>
        <translation>&amp;Départ ici</translation>
    </message>
    <message>
        <source>&amp;Goal here</source>
        <translation>&amp;But ici</translation>
    </message>
    <message>
        <source>Goal &amp;out</source>
        <translation>But : de&amp;hors</translation>
    </message>
    <message>
        <source>Move the ends &amp;clear</source>
        <translation>Dé&amp;gager les extrémités</translation>
    </message>
    <message>
        <source>Where the object touches or overlaps a body at its start or goal, move it clear by the least that is found</source>
        <translation>Là où l&apos;objet touche ou pénètre un corps à son départ ou à son but, l&apos;écarter du moins possible</translation>
    </message>
    <message>
        <source>S&amp;wap start and goal</source>
        <translation>É&amp;changer départ et but</translation>
    </message>
    <message>
        <source>&amp;Fit the workspace</source>
        <translation>A&amp;juster l&apos;espace de travail</translation>
    </message>
    <message>
        <source>A workspace about all bodies, with room for the object to get out</source>
        <translation>Un espace de travail autour de tous les corps, où l&apos;objet a la place de sortir</translation>
    </message>
    <message>
        <source>R&amp;ules of the strategy...</source>
        <translation>Rè&amp;gles de la stratégie...</translation>
    </message>
    <message>
        <source>Read how the strategy weighs places and chooses planners, and change it</source>
        <translation>Lire comment la stratégie pèse les lieux et choisit les planificateurs, et le changer</translation>
    </message>
    <message>
        <source>Save the certified path: as data, or as an animation for 3D viewers</source>
        <translation>Enregistrer le chemin certifié : les données, ou une animation pour visionneuses 3D</translation>
    </message>
    <message>
        <source>Open pa&amp;th...</source>
        <translation>Ouvrir un c&amp;hemin...</translation>
    </message>
    <message>
        <source>Read a path of this scenario, and prove that it holds or see where it is blocked</source>
        <translation>Lire un chemin de ce scénario, prouver qu&apos;il tient ou voir où il est bloqué</translation>
    </message>
    <message>
        <source>Remove edits with&amp;out effect</source>
        <translation>Supprimer les m&amp;odifications sans effet</translation>
    </message>
    <message>
        <source>Pre&amp;ferences...</source>
        <translation>&amp;Préférences...</translation>
    </message>
    <message>
        <source>&amp;Film of the path...</source>
        <translation>&amp;Film du chemin...</translation>
    </message>
    <message>
        <source>Film the 3D view while the path is played: MP4, WebM or pictures</source>
        <translation>Filmer la vue 3D pendant que le chemin est joué : MP4, WebM ou images</translation>
    </message>
    <message>
        <source>&amp;Report of the path...</source>
        <translation>&amp;Rapport du chemin...</translation>
    </message>
    <message>
        <source>Write problem, certificate, clearance and pictures of the path as HTML or PDF</source>
        <translation>Écrire le problème, le certificat, le jeu et des images du chemin en HTML ou en PDF</translation>
    </message>
    <message>
        <source>S&amp;wept volume</source>
        <translation>&amp;Volume balayé</translation>
    </message>
    <message>
        <source>Show all that the object covers along the path, never less</source>
        <translation>Afficher tout ce que l&apos;objet couvre le long du chemin, jamais moins</translation>
    </message>
    <message>
        <source>E&amp;xport the swept volume...</source>
        <translation>E&amp;xporter le volume balayé...</translation>
    </message>
    <message>
        <source>Write the swept volume as triangles: STL or GLB</source>
        <translation>Écrire le volume balayé en triangles : STL ou GLB</translation>
    </message>
    <message>
        <source>Where is it &amp;blocked?</source>
        <translation>Où est-il &amp;bloqué ?</translation>
    </message>
    <message>
        <source>Show the object at the first place where the path is blocked</source>
        <translation>Montrer l&apos;objet au premier endroit où le chemin est bloqué</translation>
    </message>
    <message>
        <source>Find f&amp;its</source>
        <translation>Chercher les a&amp;justements</translation>
    </message>
    <message>
        <source>List the pairs of bodies that touch or overlap, with their kind and allowance</source>
        <translation>Lister les paires de corps qui se touchent ou se recouvrent, avec leur type et leur tolérance</translation>
    </message>
    <message>
        <source>Is&amp;olate the pair</source>
        <translation>&amp;Isoler la paire</translation>
    </message>
    <message>
        <source>Draw the two bodies of the chosen fit and no other obstacles</source>
        <translation>Dessiner les deux corps de l&apos;ajustement choisi et aucun autre obstacle</translation>
    </message>
    <message>
        <source>Accept the &amp;clash</source>
        <translation>Accepter la &amp;collision</translation>
    </message>
    <message>
        <source>Allow the overlap of the chosen pair; results state it</source>
        <translation>Tolérer le recouvrement de la paire choisie ; les résultats l&apos;indiquent</translation>
    </message>
    <message>
        <source>Is a t&amp;hread</source>
        <translation>Est un &amp;filetage</translation>
    </message>
    <message>
        <source>The chosen pair is a thread that is drawn as cylinders</source>
        <translation>La paire choisie est un filetage dessiné en cylindres</translation>
    </message>
    <message>
        <source>Require c&amp;learance</source>
        <translation>Exiger un &amp;jeu</translation>
    </message>
    <message>
        <source>As m&amp;easured</source>
        <translation>Comme &amp;mesuré</translation>
    </message>
    <message>
        <source>Fits panel</source>
        <translation>Panneau Ajustements</translation>
    </message>
    <message>
        <source>Bring the table of fits to the front</source>
        <translation>Mettre le tableau des ajustements au premier plan</translation>
    </message>
    <message>
        <source>Show the o&amp;verlap</source>
        <translation>Montrer le &amp;recouvrement</translation>
    </message>
    <message>
        <source>Allow as f&amp;its</source>
        <translation>Admettre comme a&amp;justements</translation>
    </message>
    <message>
        <source>Close the &amp;message</source>
        <translation>Fermer le &amp;message</translation>
    </message>
    <message>
        <source>Hide the message over the scene and its marks</source>
        <translation>Masquer le message au-dessus de la scène et ses repères</translation>
    </message>
    <message>
        <source>&amp;Keep the path</source>
        <translation>&amp;Conserver le chemin</translation>
    </message>
    <message>
        <source>Keep the path that was found in the scenario</source>
        <translation>Conserver dans le scénario le chemin trouvé</translation>
    </message>
    <message>
        <source>Make it the c&amp;urrent path</source>
        <translation>En faire le chemin co&amp;urant</translation>
    </message>
    <message>
        <source>Play, smooth or export the selected kept path</source>
        <translation>Jouer, lisser ou exporter le chemin conservé sélectionné</translation>
    </message>
    <message>
        <source>Com&amp;pare paths</source>
        <translation>Com&amp;parer les chemins</translation>
    </message>
    <message>
        <source>Show the figures and curves of the selected paths side by side; of all where fewer than two are selected</source>
        <translation>Afficher côte à côte les valeurs et les courbes des chemins sélectionnés ; de tous si moins de deux sont sélectionnés</translation>
    </message>
    <message>
        <source>Rena&amp;me the path</source>
        <translation>Reno&amp;mmer le chemin</translation>
    </message>
    <message>
        <source>Give the selected kept path another name</source>
        <translation>Donner un autre nom au chemin conservé sélectionné</translation>
    </message>
    <message>
        <source>P&amp;in the path</source>
        <translation>Ép&amp;ingler le chemin</translation>
    </message>
    <message>
        <source>Let the selected kept paths stay at the top of the list, or no longer</source>
        <translation>Garder les chemins sélectionnés en tête de la liste, ou ne plus les y garder</translation>
    </message>
    <message>
        <source>Remove the ke&amp;pt path</source>
        <translation>Su&amp;pprimer le chemin conservé</translation>
    </message>
    <message>
        <source>Remove the selected paths from the scenario; Undo brings them back</source>
        <translation>Supprimer du scénario les chemins sélectionnés ; Annuler les rétablit</translation>
    </message>
    <message>
        <source>&amp;Zoom to the selection</source>
        <translation>&amp;Zoomer sur la sélection</translation>
    </message>
    <message>
        <source>Bring the selected bodies near, direction kept</source>
        <translation>Rapprocher la vue des corps sélectionnés sans changer de direction</translation>
    </message>
    <message>
        <source>Ort&amp;hographic</source>
        <translation>Ort&amp;hographique</translation>
    </message>
    <message>
        <source>Draw without perspective, so that lengths across the view are to scale</source>
        <translation>Dessiner sans perspective : les longueurs parallèles à l&apos;écran sont à l&apos;échelle</translation>
    </message>
    <message>
        <source>Measure a &amp;distance</source>
        <translation>Mesurer une &amp;distance</translation>
    </message>
    <message>
        <source>Click two vertices, edges or faces; the pointer snaps to them</source>
        <translation>Cliquer deux sommets, arêtes ou faces ; le pointeur s&apos;y accroche</translation>
    </message>
    <message>
        <source>Measure an &amp;angle</source>
        <translation>Mesurer un &amp;angle</translation>
    </message>
    <message>
        <source>Click two edges or faces</source>
        <translation>Cliquer deux arêtes ou deux faces</translation>
    </message>
    <message>
        <source>Measure a &amp;radius</source>
        <translation>Mesurer un &amp;rayon</translation>
    </message>
    <message>
        <source>Click a cylindrical face</source>
        <translation>Cliquer une face cylindrique</translation>
    </message>
    <message>
        <source>Measure a &amp;clearance</source>
        <translation>Mesurer un &amp;jeu</translation>
    </message>
    <message>
        <source>Click two bodies: their smallest distance</source>
        <translation>Cliquer deux corps : leur plus petite distance</translation>
    </message>
    <message>
        <source>Remove the mea&amp;surement</source>
        <translation>Effacer la me&amp;sure</translation>
    </message>
    <message>
        <source>Hide what was measured</source>
        <translation>Masquer ce qui a été mesuré</translation>
    </message>
    <message>
        <source>Paths panel</source>
        <translation>Panneau Gardés</translation>
    </message>
    <message>
        <source>Bring the list of kept paths to the front</source>
        <translation>Mettre la liste des chemins conservés au premier plan</translation>
    </message>
    <message>
        <source>Log panel</source>
        <translation>Panneau Journal</translation>
    </message>
    <message>
        <source>Bring the log of messages to the front</source>
        <translation>Mettre le journal des messages au premier plan</translation>
    </message>
    <message>
        <source>Fin&amp;d a command...</source>
        <translation>Trouver une comman&amp;de...</translation>
    </message>
    <message>
        <source>Type a part of its name to find any command and carry it out</source>
        <translation>Saisir une partie de son nom pour trouver une commande et l&apos;exécuter</translation>
    </message>
    <message>
        <source>Copy for a &amp;bug report</source>
        <translation>Copier pour un rapport d&apos;&amp;anomalie</translation>
    </message>
    <message>
        <source>Put versions, scenario, settings and the log into the clipboard</source>
        <translation>Copier dans le presse-papiers les versions, le scénario, les réglages et le journal</translation>
    </message>
    <message>
        <source>&amp;Forget the recent files</source>
        <translation>&amp;Oublier les fichiers récents</translation>
    </message>
    <message>
        <source>Re&amp;name the attribute...</source>
        <translation>Re&amp;nommer l&apos;attribut...</translation>
    </message>
    <message>
        <source>Re&amp;move the attribute</source>
        <translation>Suppri&amp;mer l&apos;attribut</translation>
    </message>
    <message>
        <source>&amp;Forbid the place</source>
        <translation>&amp;Interdire le lieu</translation>
    </message>
    <message>
        <source>&amp;Prefer the place</source>
        <translation>&amp;Préférer le lieu</translation>
    </message>
    <message>
        <source>Set the &amp;milestone</source>
        <translation>Placer le &amp;jalon</translation>
    </message>
    <message>
        <source>R&amp;eset the milestone</source>
        <translation>Réinitialis&amp;er le jalon</translation>
    </message>
    <message>
        <source>&amp;Remove the bodies</source>
        <translation>&amp;Retirer les corps</translation>
    </message>
    <message>
        <source>Play in a &amp;loop</source>
        <translation>Jouer en &amp;boucle</translation>
    </message>
    <message>
        <source>Play back&amp;wards</source>
        <translation>Jouer à re&amp;bours</translation>
    </message>
    <message>
        <source>Plan the se&amp;quence</source>
        <translation>Planifier la sé&amp;quence</translation>
    </message>
    <message>
        <source>Find in which order the parts of the product leave, each with a certified motion</source>
        <translation>Chercher dans quel ordre les pièces du produit sortent, chacune par un mouvement certifié</translation>
    </message>
    <message>
        <source>&amp;Go on planning</source>
        <translation>&amp;Continuer la planification</translation>
    </message>
    <message>
        <source>Go on with the sequence where planning was stopped</source>
        <translation>Continuer la séquence là où la planification a été arrêtée</translation>
    </message>
    <message>
        <source>Selected bodies sta&amp;y</source>
        <translation>Les corps sélectionnés &amp;restent</translation>
    </message>
    <message>
        <source>Keep the selected bodies in the product when the sequence is planned, or not</source>
        <translation>Garder les corps sélectionnés dans le produit quand la séquence est planifiée, ou non</translation>
    </message>
    <message>
        <source>Open a sequence...</source>
        <translation>Ouvrir une séquence...</translation>
    </message>
    <message>
        <source>Read an assembly plan of this product, and prove each step again</source>
        <translation>Lire un plan d&apos;assemblage de ce produit, et prouver de nouveau chaque étape</translation>
    </message>
    <message>
        <source>Save the sequence...</source>
        <translation>Enregistrer la séquence...</translation>
    </message>
    <message>
        <source>Save the plan, its work instruction, its table of steps or its animation</source>
        <translation>Enregistrer le plan, sa gamme de montage, sa table d&apos;étapes ou son animation</translation>
    </message>
    <message>
        <source>Play the sequence</source>
        <translation>Jouer la séquence</translation>
    </message>
    <message>
        <source>Order of assembly</source>
        <translation>Ordre du montage</translation>
    </message>
    <message>
        <source>Show the steps as they are assembled, or as they are removed</source>
        <translation>Montrer les étapes dans l&apos;ordre du montage, ou dans celui du démontage</translation>
    </message>
    <message>
        <source>Removed parts stand aside</source>
        <translation>Pièces sorties à côté</translation>
    </message>
    <message>
        <source>Show the whole product</source>
        <translation>Montrer tout le produit</translation>
    </message>
    <message>
        <source>Draw all parts where they are assembled</source>
        <translation>Dessiner toutes les pièces là où elles sont assemblées</translation>
    </message>
    <message>
        <source>Sequence panel</source>
        <translation>Panneau Séquence</translation>
    </message>
    <message>
        <source>Bring the assembly plan to the front</source>
        <translation>Mettre le plan d&apos;assemblage au premier plan</translation>
    </message>
    <message>
        <source>Order as a &amp;graph</source>
        <translation>Ordre en &amp;graphe</translation>
    </message>
    <message>
        <source>Show which step makes way for which, and who blocks the parts that are stuck</source>
        <translation>Montrer quelle étape fait place à quelle autre, et ce qui bloque les pièces bloquées</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>Monter l&apos;étape</translation>
    </message>
    <message>
        <source>Move the chosen step of the sequence one row up; the rest is planned anew</source>
        <translation>Monter l&apos;étape choisie de la séquence d&apos;une ligne ; le reste est planifié de nouveau</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>Descendre l&apos;étape</translation>
    </message>
    <message>
        <source>Move the chosen step of the sequence one row down; the rest is planned anew</source>
        <translation>Descendre l&apos;étape choisie de la séquence d&apos;une ligne ; le reste est planifié de nouveau</translation>
    </message>
    <message>
        <source>Loc&amp;k the step</source>
        <translation>&amp;Verrouiller l&apos;étape</translation>
    </message>
    <message>
        <source>The chosen steps keep their places and motions, or not any more</source>
        <translation>Les étapes choisies gardent leurs places et leurs mouvements, ou ne les gardent plus</translation>
    </message>
    <message>
        <source>Keep the order of the chosen steps</source>
        <translation>Garder l&apos;ordre des étapes choisies</translation>
    </message>
    <message>
        <source>Of several chosen steps, each is to leave before the next one</source>
        <translation>De plusieurs étapes choisies, chacune doit précéder la suivante</translation>
    </message>
    <message>
        <source>Move &amp;by hand</source>
        <translation>Déplacer à la &amp;main</translation>
    </message>
    <message>
        <source>&amp;Take the path as the step</source>
        <translation>&amp;Prendre le chemin comme étape</translation>
    </message>
    <message>
        <source>Go back to the sequence with the certified path of the part that was moved by hand</source>
        <translation>Revenir à la séquence avec le chemin certifié de la pièce déplacée à la main</translation>
    </message>
    <message>
        <source>Back to the sequence</source>
        <translation>Retour à la séquence</translation>
    </message>
    <message>
        <source>Go back to the sequence without a path</source>
        <translation>Revenir à la séquence sans chemin</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>Move and turn bodies, start and goal in the view: by arrows, rings, the arrow keys, or the body itself</source>
        <translation>Déplacer et tourner les corps, le départ et le but dans la vue : par des flèches, des anneaux, les touches fléchées ou le corps lui-même</translation>
    </message>
    <message>
        <source>Al&amp;ign...</source>
        <translation>Al&amp;igner...</translation>
    </message>
    <message>
        <source>Flip the ali&amp;gnment</source>
        <translation>Retourner l&apos;ali&amp;gnement</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Par &amp;pas</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>Ouvrir le manuel</translation>
    </message>
    <message>
        <source>Help on this &amp;panel</source>
        <translation>Aide sur ce &amp;panneau</translation>
    </message>
    <message>
        <source>Open the manual at the panel that has the focus</source>
        <translation>Ouvrir le manuel au panneau qui a le focus</translation>
    </message>
    <message>
        <source>Quit Glissade</source>
        <translation>Quitter Glissade</translation>
    </message>
    <message>
        <source>Pause the planner, or let it continue</source>
        <translation>Suspendre le planificateur, ou le laisser continuer</translation>
    </message>
    <message>
        <source>End the run; what was found is still shown</source>
        <translation>Terminer ; ce qui a été trouvé reste affiché</translation>
    </message>
    <message>
        <source>Move the object back to the start</source>
        <translation>Ramener l&apos;objet au départ</translation>
    </message>
    <message>
        <source>Move the object along the path, or pause</source>
        <translation>Déplacer l&apos;objet le long du chemin, ou l&apos;arrêter</translation>
    </message>
    <message>
        <source>Light texts on a dark background</source>
        <translation>Textes clairs sur fond sombre</translation>
    </message>
    <message>
        <source>Show the object</source>
        <translation>Montrer l&apos;objet</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>Annuler la dernière modification</translation>
    </message>
    <message>
        <source>Redo the edit that was undone</source>
        <translation>Refaire ce qui a été annulé</translation>
    </message>
    <message>
        <source>Prefer ways through the selected places, or no longer</source>
        <translation>Favoriser le passage par les lieux choisis, ou ne plus le faire</translation>
    </message>
    <message>
        <source>Let the chosen step end at the present pose of the object</source>
        <translation>Faire finir l&apos;étape choisie à la pose actuelle de l&apos;objet</translation>
    </message>
    <message>
        <source>Let the planner choose where the chosen step ends</source>
        <translation>Laisser le planificateur choisir où l&apos;étape choisie finit</translation>
    </message>
    <message>
        <source>Play the replayed run, or pause it</source>
        <translation>Faire défiler le calcul rejoué, ou le mettre en pause</translation>
    </message>
    <message>
        <source>Find the tightest passage, and by how much bodies overlap on the way of least penetration</source>
        <translation>Trouver le passage le plus étroit, et de combien les corps se recouvrent sur le chemin de moindre pénétration</translation>
    </message>
    <message>
        <source>Move the object along the way of least penetration, or pause</source>
        <translation>Déplacer l&apos;objet le long du chemin de moindre pénétration, ou mettre en pause</translation>
    </message>
    <message>
        <source>Hide the selected obstacles; planning still takes them into account</source>
        <translation>Cacher les obstacles sélectionnés ; la planification en tient toujours compte</translation>
    </message>
    <message>
        <source>Make a scenario from STEP, mesh or URDF files, one of which moves</source>
        <translation>Faire un scénario à partir de fichiers STEP, de maillage ou URDF, dont l&apos;un bouge</translation>
    </message>
    <message>
        <source>Add parts from STEP, mesh or URDF files to the scene</source>
        <translation>Ajouter à la scène des pièces de fichiers STEP, de maillage ou URDF</translation>
    </message>
    <message>
        <source>Remove the selected bodies from the scene</source>
        <translation>Retirer de la scène les corps sélectionnés</translation>
    </message>
    <message>
        <source>Make the present pose of the object the start</source>
        <translation>Prendre la pose actuelle de l&apos;objet comme départ</translation>
    </message>
    <message>
        <source>Make the present pose of the object the goal</source>
        <translation>Prendre la pose actuelle de l&apos;objet comme but</translation>
    </message>
    <message>
        <source>The goal is any pose clear of the other bodies</source>
        <translation>Le but est toute pose à l&apos;écart des autres corps</translation>
    </message>
    <message>
        <source>Plan the insertion instead of the removal, or the other way round</source>
        <translation>Planifier le montage au lieu du démontage, ou l&apos;inverse</translation>
    </message>
    <message>
        <source>Remove the edits of places and borders that no longer exist</source>
        <translation>Supprimer les modifications de lieux et de frontières qui n&apos;existent plus</translation>
    </message>
    <message>
        <source>Language, theme, size of texts, unit of lengths, navigation, colours</source>
        <translation>Langue, thème, taille des textes, unité des longueurs, navigation, couleurs</translation>
    </message>
    <message>
        <source>Give the chosen pair no allowance: it must keep the required clearance</source>
        <translation>Ne donner aucune tolérance à la paire choisie : elle doit garder le jeu exigé</translation>
    </message>
    <message>
        <source>Undo the decision about the chosen pair</source>
        <translation>Annuler la décision sur la paire choisie</translation>
    </message>
    <message>
        <source>Zoom to what is refused: the bodies, and where they overlap</source>
        <translation>Zoomer sur ce qui est refusé : les corps, et l&apos;endroit où ils se recouvrent</translation>
    </message>
    <message>
        <source>Give the object an allowance against the bodies that it overlaps there; results state it</source>
        <translation>Donner à l&apos;objet une tolérance contre les corps qu&apos;il recouvre à cet endroit ; les résultats l&apos;indiquent</translation>
    </message>
    <message>
        <source>Show all steps one after the other, or pause</source>
        <translation>Montrer toutes les étapes l&apos;une après l&apos;autre, ou mettre en pause</translation>
    </message>
    <message>
        <source>Draw removed parts where their motion ends, or hide them</source>
        <translation>Dessiner les pièces sorties là où leur mouvement finit, ou les cacher</translation>
    </message>
    <message>
        <source>Forbid this &amp;direction of removal</source>
        <translation>Interdire cette &amp;direction de sortie</translation>
    </message>
    <message>
        <source>Do not let the parts of the chosen step leave in its direction</source>
        <translation>Les pièces de l&apos;étape choisie ne doivent pas sortir dans sa direction</translation>
    </message>
    <message>
        <source>Remove the demands on the step</source>
        <translation>Retirer les exigences sur l&apos;étape</translation>
    </message>
    <message>
        <source>Remove the demands on the chosen parts: places, motions, directions, order</source>
        <translation>Retirer ce qui est exigé des pièces choisies : places, mouvements, directions, ordre</translation>
    </message>
    <message>
        <source>Move the part of the chosen step by hand, among the parts that are present at that step</source>
        <translation>Déplacer à la main la pièce de l&apos;étape choisie, parmi les pièces présentes à cette étape</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>Show the first steps in the window: places and strategies, then parts</source>
        <translation>Montrer les premières étapes dans la fenêtre : lieux et stratégies, puis pièces</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>&amp;Qu&apos;est-ce que c&apos;est ?</translation>
    </message>
    <message>
        <source>Click anything in the window to read what it is for</source>
        <translation>Cliquer un élément de la fenêtre pour lire à quoi il sert</translation>
    </message>
    <message>
        <source>Context &amp;menu</source>
        <translation>&amp;Menu contextuel</translation>
    </message>
    <message>
        <source>Open the menu of what is selected in the scene or in the table in use</source>
        <translation>Ouvrir le menu de ce qui est sélectionné dans la scène ou dans le tableau en cours</translation>
    </message>
    <message>
        <source>&amp;Save this view...</source>
        <translation>&amp;Enregistrer cette vue...</translation>
    </message>
    <message>
        <source>Give the present camera a name, to come back to it</source>
        <translation>Donner un nom à la caméra actuelle, pour y revenir</translation>
    </message>
    <message>
        <source>&amp;Manage named views...</source>
        <translation>&amp;Gérer les vues nommées...</translation>
    </message>
    <message>
        <source>Go to, rename and remove named views</source>
        <translation>Rappeler, renommer et supprimer des vues nommées</translation>
    </message>
    <message>
        <source>Camera follows the object</source>
        <translation>La caméra suit l&apos;objet</translation>
    </message>
    <message>
        <source>Keep the object in the middle of the view while the path is played</source>
        <translation>Garder l&apos;objet au milieu de la vue pendant la lecture du chemin</translation>
    </message>
    <message>
        <source>&amp;Depth shading</source>
        <translation>Ombrage de &amp;profondeur</translation>
    </message>
    <message>
        <source>Draw corners, holes and gaps darker</source>
        <translation>Assombrir les coins, les trous et les interstices</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>New seed</source>
        <translation>Nouvelle graine</translation>
    </message>
    <message>
        <source>Put a vertex, an edge, an axis or a plane onto one of another body: click that of what moves, then the other</source>
        <translation>Mettre un sommet, une arête, un axe ou un plan sur celui d&apos;un autre corps : cliquer celui de ce qui bouge, puis l&apos;autre</translation>
    </message>
    <message>
        <source>Turn what was aligned last round: the axis, or the face, looks the other way; a cylinder goes to the other side of the plane</source>
        <translation>Retourner ce qui a été aligné en dernier : l&apos;axe ou la face regarde de l&apos;autre côté ; un cylindre passe de l&apos;autre côté du plan</translation>
    </message>
    <message>
        <source>Let the arrows and rings of arranging move by whole steps; Ctrl held suspends it</source>
        <translation>Faire avancer les flèches et les anneaux par pas entiers ; Ctrl maintenu le suspend</translation>
    </message>
    <message>
        <source>Snap &amp;to faces and axes</source>
        <translation>Accrocher aux &amp;faces et aux axes</translation>
    </message>
    <message>
        <source>Let what is dragged by an arrow or a square meet faces and axes of other bodies; Ctrl held suspends it</source>
        <translation>Accrocher ce qui est tiré par une flèche ou un carré aux faces et aux axes d&apos;autres corps ; Ctrl maintenu le suspend</translation>
    </message>
</context>
<context>
    <name>Attributes</name>
    <message>
        <source>Complexity</source>
        <translation>Complexité</translation>
    </message>
    <message>
        <source>Cluttered</source>
        <translation>Encombré</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Fragile</source>
        <translation>Fragile</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Goes with</source>
        <translation>Va avec</translation>
    </message>
    <message>
        <source>Goes before</source>
        <translation>Va avant</translation>
    </message>
    <message>
        <source>Needs tool</source>
        <translation>Outil nécessaire</translation>
    </message>
    <message>
        <source>Class of the body, whose attributes it has: screw, seal, base_part.</source>
        <translation>Classe du corps, dont il a les attributs : screw, seal, base_part.</translation>
    </message>
    <message>
        <source>Mass of the body. 0: by its volume and density.</source>
        <translation>Masse du corps. 0 : d'après son volume et sa masse volumique.</translation>
    </message>
    <message>
        <source>The body leaves as early as it can, and is put in as late as it can.</source>
        <translation>Le corps part aussi tôt que possible, et est monté aussi tard que possible.</translation>
    </message>
    <message>
        <source>The assembly begins with the body: it does not leave.</source>
        <translation>L'assemblage commence par le corps : il ne part pas.</translation>
    </message>
    <message>
        <source>The body does not leave.</source>
        <translation>Le corps ne part pas.</translation>
    </message>
    <message>
        <source>Bodies that leave together with this one, with commas.</source>
        <translation>Corps qui partent avec celui-ci, séparés par des virgules.</translation>
    </message>
    <message>
        <source>Bodies that leave after this one, with commas.</source>
        <translation>Corps qui partent après celui-ci, séparés par des virgules.</translation>
    </message>
    <message>
        <source>Which tool turns the body: by_shape, none, or one of the tools.</source>
        <translation>Outil qui tourne le corps : by_shape, none, ou l'un des outils.</translation>
    </message>
    <message>
        <source>Narrowness</source>
        <translation>Étroitesse</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Compatibility</source>
        <translation>Compatibilité</translation>
    </message>
    <message>
        <source>Forbidden</source>
        <translation>Interdit</translation>
    </message>
    <message>
        <source>Preference</source>
        <translation>Préférence</translation>
    </message>
    <message>
        <source>Mobility</source>
        <translation>Mobilité</translation>
    </message>
    <message>
        <source>How hard the place is to cross: 1 for the widest, one more each time the width halves.</source>
        <translation>Difficulté de traverser le lieu : 1 pour le plus large, un de plus chaque fois que la largeur est divisée par deux.</translation>
    </message>
    <message>
        <source>Mobile bodies are in the place.</source>
        <translation>Des corps mobiles sont dans le lieu.</translation>
    </message>
    <message>
        <source>Diameter of the largest ball that fits at the widest spot.</source>
        <translation>Diamètre de la plus grande boule qui tient à l&apos;endroit le plus large.</translation>
    </message>
    <message>
        <source>Shape of the place&apos;s section, as the objects&apos; shapes are called.</source>
        <translation>Forme de la section du lieu, nommée comme celles des objets.</translation>
    </message>
    <message>
        <source>Whether the object goes through: 0 not at all, from 0.5 on it fits, 1 with ease.</source>
        <translation>Si l&apos;objet passe : 0 pas du tout, à partir de 0,5 il passe, 1 aisément.</translation>
    </message>
    <message>
        <source>No path may lead through the place.</source>
        <translation>Aucun chemin ne peut passer par le lieu.</translation>
    </message>
    <message>
        <source>Ways through the place count this many times shorter.</source>
        <translation>Les passages par le lieu comptent pour autant de fois plus courts.</translation>
    </message>
    <message>
        <source>Static bodies shape the places; mobile ones clutter them.</source>
        <translation>Les corps statiques forment les lieux ; les mobiles les encombrent.</translation>
    </message>
    <message>
        <source>What the body is shaped like.</source>
        <translation>La forme du corps.</translation>
    </message>
</context>
<context>
    <name>Devices</name>
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
    <message>
        <source>6D mouse</source>
        <translation>Souris 6D</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Manette</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>Simulated haptic hand</source>
        <translation>Main haptique simulée</translation>
    </message>
    <message>
        <source>A person: keys, 6D mouse and gamepad together.</source>
        <translation>Une personne : clavier, souris 6D et manette ensemble.</translation>
    </message>
    <message>
        <source>A person: the keys of the window.</source>
        <translation>Une personne : les touches de la fenêtre.</translation>
    </message>
    <message>
        <source>A person: a 3Dconnexion mouse.</source>
        <translation>Une personne : une souris 3Dconnexion.</translation>
    </message>
    <message>
        <source>A person: a game controller.</source>
        <translation>Une personne : une manette de jeu.</translation>
    </message>
    <message>
        <source>Follows the way-points fast and exactly.</source>
        <translation>Suit les points de passage vite et exactement.</translation>
    </message>
    <message>
        <source>Follows the way-points.</source>
        <translation>Suit les points de passage.</translation>
    </message>
    <message>
        <source>Follows the way-points, slow and unsure.</source>
        <translation>Suit les points de passage, lentement et avec hésitation.</translation>
    </message>
    <message>
        <source>Draws the object along the way-points and feels the obstacles.</source>
        <translation>Tire l&apos;objet le long des points de passage et sent les obstacles.</translation>
    </message>
</context>
<context>
    <name>Diagnostics</name>
    <message>
        <source>the bound of the swept volume needs more than 4 GiB</source>
        <translation>la borne du volume balayé demande plus de 4 Gio</translation>
    </message>
    <message>
        <source>the object penetrates &apos;%1&apos;</source>
        <translation>l&apos;objet pénètre dans « %1 »</translation>
    </message>
    <message>
        <source>the object is %1 m from &apos;%2&apos;, nearer than the required clearance of %3 m</source>
        <translation>l&apos;objet est à %1 m de « %2 », moins que le jeu exigé de %3 m</translation>
    </message>
    <message>
        <source>Move the start to a free place.</source>
        <translation>Placer le départ à un endroit libre.</translation>
    </message>
    <message>
        <source>Move the goal to a free place.</source>
        <translation>Placer le but à un endroit libre.</translation>
    </message>
    <message>
        <source>Move the start away or lower the required clearance.</source>
        <translation>Éloigner le départ ou réduire le jeu exigé.</translation>
    </message>
    <message>
        <source>Move the goal away or lower the required clearance.</source>
        <translation>Éloigner le but ou réduire le jeu exigé.</translation>
    </message>
    <message>
        <source>lies outside the workspace bounds</source>
        <translation>est hors des limites de l&apos;espace de travail</translation>
    </message>
    <message>
        <source>Enlarge the workspace or move the start inside.</source>
        <translation>Agrandir l&apos;espace de travail ou y placer le départ.</translation>
    </message>
    <message>
        <source>Enlarge the workspace or move the goal inside.</source>
        <translation>Agrandir l&apos;espace de travail ou y placer le but.</translation>
    </message>
    <message>
        <source>&apos;out&apos; cannot be reached: the workspace holds no place clear of the obstacles&apos; box</source>
        <translation>« dehors » est hors d&apos;atteinte : l&apos;espace de travail n&apos;a aucune place hors de la boîte des obstacles</translation>
    </message>
    <message>
        <source>Enlarge the workspace by the size of the object on one side at least.</source>
        <translation>Agrandir l&apos;espace de travail de la taille de l&apos;objet, d&apos;un côté au moins.</translation>
    </message>
    <message>
        <source>the step limit of %1 reached without a path</source>
        <translation>la limite de %1 pas est atteinte sans chemin</translation>
    </message>
    <message>
        <source>the limit of %1 random configurations reached without a path</source>
        <translation>la limite de %1 configurations aléatoires est atteinte sans chemin</translation>
    </message>
    <message>
        <source>the time limit of %1 s reached without a path</source>
        <translation>la limite de temps de %1 s est atteinte sans chemin</translation>
    </message>
    <message>
        <source>Raise %1, take part with the device, or try another seed.</source>
        <translation>Augmenter %1, participer avec le périphérique, ou essayer une autre graine.</translation>
    </message>
    <message>
        <source>no direct motion is free</source>
        <translation>aucun mouvement direct n&apos;est libre</translation>
    </message>
    <message>
        <source>Choose a planner that searches.</source>
        <translation>Choisir une stratégie qui cherche.</translation>
    </message>
    <message>
        <source>there is no configuration outside within the bounds</source>
        <translation>aucune configuration dehors n&apos;est dans les limites</translation>
    </message>
    <message>
        <source>strategy G found no path within its limit of samples</source>
        <translation>la stratégie G n&apos;a trouvé aucun chemin dans sa limite d&apos;échantillons</translation>
    </message>
    <message>
        <source>there is no such planner</source>
        <translation>cette stratégie n&apos;existe pas</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>l&apos;opération a été arrêtée</translation>
    </message>
    <message>
        <source>there is no path to export</source>
        <translation>il n&apos;y a pas de chemin à exporter</translation>
    </message>
    <message>
        <source>there is no path to report</source>
        <translation>il n&apos;y a pas de chemin dont faire le rapport</translation>
    </message>
    <message>
        <source>there is no path to film</source>
        <translation>il n&apos;y a pas de chemin à filmer</translation>
    </message>
    <message>
        <source>ffmpeg is needed for films, and is not installed</source>
        <translation>ffmpeg est nécessaire pour les films, et n&apos;est pas installé</translation>
    </message>
    <message>
        <source>Install the package ffmpeg, or give a name that ends with .png for a series of pictures.</source>
        <translation>Installer le paquet ffmpeg, ou donner un nom qui finit par .png pour une série d&apos;images.</translation>
    </message>
    <message>
        <source>ffmpeg could not write the film: %1</source>
        <translation>ffmpeg n&apos;a pas pu écrire le film : %1</translation>
    </message>
    <message>
        <source>Check the folder, its free space, and that ffmpeg has the codecs libx264 and libvpx-vp9.</source>
        <translation>Vérifier le dossier, sa place libre, et que ffmpeg a les codecs libx264 et libvpx-vp9.</translation>
    </message>
    <message>
        <source>films are not written in this format</source>
        <translation>les films ne sont pas écrits dans ce format</translation>
    </message>
    <message>
        <source>Choose one of: .mp4, .webm, .png.</source>
        <translation>Choisir parmi : .mp4, .webm, .png.</translation>
    </message>
    <message>
        <source>Solve first.</source>
        <translation>Chercher d&apos;abord un chemin.</translation>
    </message>
    <message>
        <source>there is no scenario that the path could be of</source>
        <translation>il n&apos;y a pas de scénario dont ce pourrait être un chemin</translation>
    </message>
    <message>
        <source>Open its scenario first.</source>
        <translation>Ouvrir d&apos;abord son scénario.</translation>
    </message>
    <message>
        <source>a path is being looked for</source>
        <translation>une recherche de chemin est en cours</translation>
    </message>
    <message>
        <source>Stop the run first.</source>
        <translation>Arrêter d&apos;abord le calcul.</translation>
    </message>
    <message>
        <source>a recording is shown</source>
        <translation>un enregistrement est affiché</translation>
    </message>
    <message>
        <source>Close the replay first.</source>
        <translation>Fermer d&apos;abord la relecture.</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ne peut pas être lu</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>ne peut pas être écrit</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>n&apos;existe pas</translation>
    </message>
    <message>
        <source>Correct the file.</source>
        <translation>Corriger le fichier.</translation>
    </message>
    <message>
        <source>is missing, and is free space to every proof: its file &apos;%1&apos; is not there (looked for in &apos;%2&apos;)</source>
        <translation>manque et compte comme espace libre pour toute preuve : son fichier « %1 » n&apos;existe pas (cherché dans « %2 »)</translation>
    </message>
    <message>
        <source>is missing, and is free space to every proof: its file &apos;%1&apos; is outside its folder (looked for in &apos;%2&apos;)</source>
        <translation>manque et compte comme espace libre pour toute preuve : son fichier « %1 » est hors du dossier (cherché dans « %2 »)</translation>
    </message>
    <message>
        <source>is missing, and is free space to every proof: its file &apos;%1&apos; is no STEP file (looked for in &apos;%2&apos;)</source>
        <translation>manque et compte comme espace libre pour toute preuve : son fichier « %1 » n&apos;est pas un fichier STEP (cherché dans « %2 »)</translation>
    </message>
    <message>
        <source>%1 more files of its parts are missing</source>
        <translation>%1 autres fichiers de ses pièces manquent</translation>
    </message>
    <message>
        <source>has its parts in other files, and none of them is there: %1 (looked for in &apos;%2&apos;)</source>
        <translation>a ses pièces dans d&apos;autres fichiers, dont aucun n&apos;existe : %1 (cherchés dans « %2 »)</translation>
    </message>
    <message>
        <source>Put the files there and load again, or export the product as one file.</source>
        <translation>Y placer les fichiers et recharger, ou exporter le produit en un seul fichier.</translation>
    </message>
    <message>
        <source>names &apos;%1&apos; for a part, which holds this file itself</source>
        <translation>nomme « %1 » pour une pièce, qui contient ce fichier lui-même</translation>
    </message>
    <message>
        <source>Export the product as one file.</source>
        <translation>Exporter le produit en un seul fichier.</translation>
    </message>
    <message>
        <source>had %1 planar holes, which were closed as asked for; %2 holes are left open</source>
        <translation>avait %1 trous plans, fermés comme demandé ; %2 trous restent ouverts</translation>
    </message>
    <message>
        <source>Look at them: what is behind a closed hole is solid.</source>
        <translation>À vérifier : ce qui est derrière un trou fermé est plein.</translation>
    </message>
    <message>
        <source>is not a closed surface</source>
        <translation>n&apos;est pas une surface fermée</translation>
    </message>
    <message>
        <source>Being inside it is not seen as a collision; close its surface, or let planar holes be closed (--close-holes).</source>
        <translation>Se trouver à l&apos;intérieur n&apos;est pas vu comme une collision ; fermer sa surface, ou faire fermer les trous plans (--close-holes).</translation>
    </message>
    <message>
        <source>edits cannot be saved automatically: %1</source>
        <translation>les modifications ne peuvent pas être enregistrées automatiquement : %1</translation>
    </message>
    <message>
        <source>Save the scenario.</source>
        <translation>Enregistrez le scénario.</translation>
    </message>
    <message>
        <source>the film was cancelled</source>
        <translation>le film a été annulé</translation>
    </message>
    <message>
        <source>Start it again.</source>
        <translation>Recommencez.</translation>
    </message>
    <message>
        <source>the plan has changed meanwhile</source>
        <translation>le plan a changé entre-temps</translation>
    </message>
    <message>
        <source>Save it again.</source>
        <translation>Enregistrez-le de nouveau.</translation>
    </message>
    <message>
        <source>another object moves now</source>
        <translation>un autre objet est mobile maintenant</translation>
    </message>
    <message>
        <source>Let &apos;%1&apos; move first.</source>
        <translation>Rendez d&apos;abord « %1 » mobile.</translation>
    </message>
    <message>
        <source>the milestone would be in collision with &apos;%1&apos;</source>
        <translation>le jalon serait en collision avec « %1 »</translation>
    </message>
    <message>
        <source>Drop it where the object is free.</source>
        <translation>Lâchez-le là où l&apos;objet est libre.</translation>
    </message>
    <message>
        <source>the report of a path is written as .html or .pdf</source>
        <translation>le rapport d&apos;un chemin s&apos;écrit en .html ou .pdf</translation>
    </message>
    <message>
        <source>a swept volume is written as .stl or .glb</source>
        <translation>un volume balayé s&apos;écrit en .stl ou .glb</translation>
    </message>
    <message>
        <source>Give a file name with one of these endings.</source>
        <translation>Donnez un nom de fichier avec l&apos;une de ces extensions.</translation>
    </message>
    <message>
        <source>there is no run to save</source>
        <translation>il n&apos;y a pas de calcul à enregistrer</translation>
    </message>
    <message>
        <source>Start one first.</source>
        <translation>Lancez-en d&apos;abord une.</translation>
    </message>
    <message>
        <source>there is no plan to write</source>
        <translation>il n&apos;y a pas de plan à écrire</translation>
    </message>
    <message>
        <source>Plan the sequence first.</source>
        <translation>Planifiez d&apos;abord la séquence.</translation>
    </message>
    <message>
        <source>there is no product that the plan could be of</source>
        <translation>il n&apos;y a pas de produit auquel le plan pourrait se rapporter</translation>
    </message>
    <message>
        <source>Open the product first.</source>
        <translation>Ouvrez d&apos;abord le produit.</translation>
    </message>
    <message>
        <source>its parts leave as one, and one part is in the hand</source>
        <translation>ses pièces sortent ensemble, et la main ne tient qu&apos;une pièce</translation>
    </message>
    <message>
        <source>Choose a step of a single part.</source>
        <translation>Choisissez une étape d&apos;une seule pièce.</translation>
    </message>
    <message>
        <source>assembly plans are not written in this format</source>
        <translation>les plans d&apos;assemblage ne s&apos;écrivent pas dans ce format</translation>
    </message>
    <message>
        <source>Choose one of: %1</source>
        <translation>Choisissez parmi : %1</translation>
    </message>
    <message>
        <source>Choose one of %1</source>
        <translation>Choisissez parmi %1</translation>
    </message>
    <message>
        <source>the scenario has changed since the study was made</source>
        <translation>le scénario a changé depuis que l&apos;étude a été faite</translation>
    </message>
    <message>
        <source>Put the old one back, or make the study again.</source>
        <translation>Remettez l&apos;ancien, ou refaites l&apos;étude.</translation>
    </message>
    <message>
        <source>is a run of a sequence, which is not shown as a path</source>
        <translation>est un essai de séquence, qui ne s&apos;affiche pas comme un chemin</translation>
    </message>
    <message>
        <source>Open its scenario and plan the sequence with this seed.</source>
        <translation>Ouvrez son scénario et planifiez la séquence avec cette graine.</translation>
    </message>
    <message>
        <source>was not saved: another program has changed the file since it was read</source>
        <translation>n&apos;a pas été enregistré : un autre programme a modifié le fichier depuis sa lecture</translation>
    </message>
    <message>
        <source>was not saved: the file has been removed or renamed since it was read</source>
        <translation>n&apos;a pas été enregistré : le fichier a été supprimé ou renommé depuis sa lecture</translation>
    </message>
    <message>
        <source>Save under another name, or open the file again.</source>
        <translation>Enregistrez sous un autre nom, ou ouvrez de nouveau le fichier.</translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation>Enregistrez sous un autre nom.</translation>
    </message>
    <message>
        <source>was saved, but %1</source>
        <translation>a été enregistré, mais %1</translation>
    </message>
    <message>
        <source>cannot be saved: %1</source>
        <translation>ne peut pas être enregistré : %1</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>there was not enough memory while %1</source>
        <translation>la mémoire n&apos;a pas suffi pour ce travail : %1</translation>
    </message>
    <message>
        <source>Close other programs or use coarser parts, then try again.</source>
        <translation>Fermez d&apos;autres programmes ou prenez des pièces moins fines, puis réessayez.</translation>
    </message>
    <message>
        <source>an error occurred while %1</source>
        <translation>une erreur est survenue pendant ce travail : %1</translation>
    </message>
    <message>
        <source>Try again. If it happens again, report it with the scenario and the seed.</source>
        <translation>Réessayez. Si l&apos;erreur revient, signalez-la avec le scénario et la graine.</translation>
    </message>
    <message>
        <source>the environment model was not finished</source>
        <translation>le modèle de l&apos;environnement n&apos;a pas été terminé</translation>
    </message>
    <message>
        <source>is flat</source>
        <translation>est plat</translation>
    </message>
    <message>
        <source>Give it a size.</source>
        <translation>Donnez-lui une taille.</translation>
    </message>
    <message>
        <source>is no attribute that is defined</source>
        <translation>n&apos;est pas un attribut défini</translation>
    </message>
    <message>
        <source>Define it under /attributes, or remove it.</source>
        <translation>Définissez-le sous /attributes, ou supprimez-le.</translation>
    </message>
    <message>
        <source>is no body of this scenario</source>
        <translation>n&apos;est pas un corps de ce scénario</translation>
    </message>
    <message>
        <source>Correct the id.</source>
        <translation>Corrigez l&apos;identifiant.</translation>
    </message>
    <message>
        <source>Export fewer triangles, split the file, or use a machine with more free memory.</source>
        <translation>Exportez moins de triangles, découpez le fichier, ou utilisez une machine avec plus de mémoire libre.</translation>
    </message>
    <message>
        <source>was not read to its end</source>
        <translation>n&apos;a pas été lu jusqu&apos;au bout</translation>
    </message>
    <message>
        <source>Read it again.</source>
        <translation>Lisez-le de nouveau.</translation>
    </message>
    <message>
        <source>Open it again.</source>
        <translation>Ouvrez-le de nouveau.</translation>
    </message>
    <message>
        <source>is of a kind that is not read (&apos;%1&apos;)</source>
        <translation>est d&apos;un type qui n&apos;est pas lu (« %1 »)</translation>
    </message>
    <message>
        <source>is a building model (IFC), not a product</source>
        <translation>est une maquette de bâtiment (IFC), pas un produit</translation>
    </message>
    <message>
        <source>is not a STEP file (it does not begin with ISO-10303-21)</source>
        <translation>n&apos;est pas un fichier STEP (il ne commence pas par ISO-10303-21)</translation>
    </message>
    <message>
        <source>Export it as STEP AP214 or AP242.</source>
        <translation>Exportez-le en STEP AP214 ou AP242.</translation>
    </message>
    <message>
        <source>Export the part as STEP AP214 or AP242, not compressed and not as XML.</source>
        <translation>Exportez la pièce en STEP AP214 ou AP242, sans compression ni XML.</translation>
    </message>
    <message>
        <source>Correct the URDF file.</source>
        <translation>Corrigez le fichier URDF.</translation>
    </message>
    <message>
        <source>Correct the OMPL.app problem file.</source>
        <translation>Corrigez le fichier de problème OMPL.app.</translation>
    </message>
    <message>
        <source>Widen the workspace.</source>
        <translation>Agrandissez l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>Switch fits on, put the object elsewhere, or check the parts and their unit.</source>
        <translation>Activez les ajustements, placez l&apos;objet ailleurs, ou vérifiez les pièces et leur unité.</translation>
    </message>
    <message>
        <source>the way of the smaller object could not be widened</source>
        <translation>le trajet de l&apos;objet réduit n&apos;a pas pu être élargi</translation>
    </message>
    <message>
        <source>Start again with another seed.</source>
        <translation>Recommencez avec une autre graine.</translation>
    </message>
    <message>
        <source>Start again.</source>
        <translation>Recommencez.</translation>
    </message>
    <message>
        <source>the rule is too long</source>
        <translation>la règle est trop longue</translation>
    </message>
    <message>
        <source>Use at most %1 characters.</source>
        <translation>Utilisez au plus %1 caractères.</translation>
    </message>
    <message>
        <source>Correct the rule: %1</source>
        <translation>Corrigez la règle : %1</translation>
    </message>
    <message>
        <source>has no last rule that always holds</source>
        <translation>n&apos;a pas de dernière règle toujours vraie</translation>
    </message>
    <message>
        <source>there is no local planner &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de planificateur local « %1 »</translation>
    </message>
    <message>
        <source>OMPL&apos;s path is not certified: it touches or passes through an obstacle</source>
        <translation>le chemin d&apos;OMPL n&apos;est pas certifié : il touche ou traverse un obstacle</translation>
    </message>
    <message>
        <source>OMPL&apos;s planner was given no free start within the bounds</source>
        <translation>le planificateur d&apos;OMPL n&apos;a pas de départ libre dans les bornes</translation>
    </message>
    <message>
        <source>OMPL&apos;s planners need a free goal within the bounds, and there is none</source>
        <translation>les planificateurs d&apos;OMPL ont besoin d&apos;un but libre dans les bornes, et il n&apos;y en a pas</translation>
    </message>
    <message>
        <source>Widen the bounds, or give another goal.</source>
        <translation>Élargissez les bornes, ou donnez un autre but.</translation>
    </message>
    <message>
        <source>Widen the bounds.</source>
        <translation>Élargissez les bornes.</translation>
    </message>
    <message>
        <source>Raise --global-samples, or use strategy GTS.</source>
        <translation>Augmentez --global-samples, ou prenez la stratégie GTS.</translation>
    </message>
    <message>
        <source>the path through the threads could not be certified</source>
        <translation>le chemin à travers les filetages n&apos;a pas pu être certifié</translation>
    </message>
    <message>
        <source>Require less clearance.</source>
        <translation>Exigez moins de jeu.</translation>
    </message>
    <message>
        <source>Edits are not saved automatically.</source>
        <translation>Les modifications ne sont pas enregistrées automatiquement.</translation>
    </message>
    <message>
        <source>expand to more than %1 rigid bodies</source>
        <translation>donnent plus de %1 corps rigides</translation>
    </message>
    <message>
        <source>Give the parts that matter, or fewer bodies made of the same file.</source>
        <translation>Donnez les pièces utiles, ou moins de corps faits du même fichier.</translation>
    </message>
    <message>
        <source>Check its pose, its size and the unit of its file.</source>
        <translation>Vérifiez sa pose, sa taille et l&apos;unité de son fichier.</translation>
    </message>
    <message>
        <source>Check the units of both, or give a smaller workspace.</source>
        <translation>Vérifiez les unités des deux, ou donnez un espace de travail plus petit.</translation>
    </message>
    <message>
        <source>is more than 1e10 times as large as the object</source>
        <translation>est plus de 1e10 fois plus grand que l&apos;objet</translation>
    </message>
    <message>
        <source>has changed since the scenario was saved</source>
        <translation>a changé depuis l&apos;enregistrement du scénario</translation>
    </message>
    <message>
        <source>Check the scenario and save it again.</source>
        <translation>Vérifiez le scénario et enregistrez-le de nouveau.</translation>
    </message>
    <message>
        <source>Export the part again.</source>
        <translation>Exportez de nouveau la pièce.</translation>
    </message>
    <message>
        <source>holds no triangle with three corners</source>
        <translation>ne contient aucun triangle à trois sommets</translation>
    </message>
    <message>
        <source>They have no area, so that no surface is missing.</source>
        <translation>Leur aire est nulle : il ne manque aucune surface.</translation>
    </message>
    <message>
        <source>the bodies have too many triangles for a GLB file (4 GiB)</source>
        <translation>les corps ont trop de triangles pour un fichier GLB (4 Gio)</translation>
    </message>
    <message>
        <source>Export the path in another format.</source>
        <translation>Exportez le chemin dans un autre format.</translation>
    </message>
    <message>
        <source>Make a scenario that has each part as a body: New from parts does so with STEP files.</source>
        <translation>Faites un scénario où chaque pièce est un corps : Nouveau à partir de pièces le fait pour les fichiers STEP.</translation>
    </message>
    <message>
        <source>does not fit the content: the file was edited outside of Glissade, or it is damaged</source>
        <translation>ne correspond pas au contenu : le fichier a été modifié hors de Glissade, ou il est endommagé</translation>
    </message>
    <message>
        <source>holds a number that is out of range</source>
        <translation>contient un nombre hors limites</translation>
    </message>
    <message>
        <source>Correct the number.</source>
        <translation>Corrigez le nombre.</translation>
    </message>
    <message>
        <source>Correct the text there.</source>
        <translation>Corrigez le texte à cet endroit.</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>Give a file with content.</source>
        <translation>Donnez un fichier qui a un contenu.</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>n&apos;est pas du JSON valide</translation>
    </message>
    <message>
        <source>has no ending that says in which format the path is to be written</source>
        <translation>n&apos;a pas d&apos;extension qui donne le format du chemin</translation>
    </message>
    <message>
        <source>the path holds no configuration</source>
        <translation>le chemin ne contient aucune configuration</translation>
    </message>
    <message>
        <source>holds no configuration</source>
        <translation>ne contient aucune configuration</translation>
    </message>
    <message>
        <source>Give a path.</source>
        <translation>Donnez un chemin.</translation>
    </message>
    <message>
        <source>is in a format that is only written</source>
        <translation>est dans un format qui ne peut qu&apos;être écrit</translation>
    </message>
    <message>
        <source>Give the product that was planned.</source>
        <translation>Donnez le produit qui a été planifié.</translation>
    </message>
    <message>
        <source>holds one body: there is nothing to take apart</source>
        <translation>contient un seul corps : il n&apos;y a rien à démonter</translation>
    </message>
    <message>
        <source>Give a product of several parts.</source>
        <translation>Donnez un produit de plusieurs pièces.</translation>
    </message>
    <message>
        <source>The run is not recorded on disk.</source>
        <translation>Le calcul n&apos;est pas enregistré sur disque.</translation>
    </message>
    <message>
        <source>the journal cannot be written: %1</source>
        <translation>le journal ne peut pas être écrit : %1</translation>
    </message>
    <message>
        <source>is damaged: %1</source>
        <translation>est endommagé : %1</translation>
    </message>
    <message>
        <source>Use an undamaged copy.</source>
        <translation>Utilisez une copie intacte.</translation>
    </message>
    <message>
        <source>has a name that is not valid UTF-8, which a scenario file cannot hold</source>
        <translation>a un nom qui n&apos;est pas de l&apos;UTF-8 valide, ce qu&apos;un fichier de scénario ne peut contenir</translation>
    </message>
    <message>
        <source>Rename the file or its folder.</source>
        <translation>Renommez le fichier ou son dossier.</translation>
    </message>
    <message>
        <source>is a part file, and a scenario is needed</source>
        <translation>est un fichier de pièce, et il faut un scénario</translation>
    </message>
    <message>
        <source>is not in the file</source>
        <translation>n&apos;est pas dans le fichier</translation>
    </message>
    <message>
        <source>is the name of several parts</source>
        <translation>est le nom de plusieurs pièces</translation>
    </message>
    <message>
        <source>was interrupted</source>
        <translation>a été interrompu</translation>
    </message>
    <message>
        <source>was stopped while fits were searched</source>
        <translation>a été arrêté pendant la recherche des ajustements</translation>
    </message>
    <message>
        <source>Let another body stay, or remove the demand.</source>
        <translation>Laissez un autre corps en place, ou retirez l&apos;exigence.</translation>
    </message>
    <message>
        <source>Give a minimum below the maximum.</source>
        <translation>Donnez un minimum inférieur au maximum.</translation>
    </message>
    <message>
        <source>is not a valid configuration</source>
        <translation>n&apos;est pas une configuration valide</translation>
    </message>
    <message>
        <source>Give finite numbers and a unit quaternion.</source>
        <translation>Donnez des nombres finis et un quaternion unitaire.</translation>
    </message>
    <message>
        <source>the swept volume was not finished</source>
        <translation>le volume balayé n&apos;a pas été terminé</translation>
    </message>
    <message>
        <source>the bound of the swept volume is finer than 32-bit coordinates are so far from the origin</source>
        <translation>la borne du volume balayé est plus fine que les coordonnées sur 32 bits aussi loin de l&apos;origine</translation>
    </message>
    <message>
        <source>there is nothing that moves</source>
        <translation>rien ne se déplace</translation>
    </message>
    <message>
        <source>Give a body with triangles and a path.</source>
        <translation>Donnez un corps avec des triangles et un chemin.</translation>
    </message>
    <message>
        <source>there is no such attribute</source>
        <translation>cet attribut n&apos;existe pas</translation>
    </message>
    <message>
        <source>Add it first.</source>
        <translation>Ajoutez-le d&apos;abord.</translation>
    </message>
    <message>
        <source>another place has this name</source>
        <translation>un autre lieu porte ce nom</translation>
    </message>
    <message>
        <source>Choose another.</source>
        <translation>Choisissez-en un autre.</translation>
    </message>
    <message>
        <source>the scenario&apos;s rule %1 uses the attribute &apos;%2&apos;</source>
        <translation>la règle %1 du scénario utilise l&apos;attribut « %2 »</translation>
    </message>
    <message>
        <source>Change the rule first.</source>
        <translation>Changez d&apos;abord la règle.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>« %1 » n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>Write it like 0.25.</source>
        <translation>Écrivez-le comme 0.25.</translation>
    </message>
    <message>
        <source>the picture cannot be written in this format</source>
        <translation>l&apos;image ne peut pas être écrite dans ce format</translation>
    </message>
    <message>
        <source>Choose a name that ends in .png or .jpg.</source>
        <translation>Choisissez un nom qui finit par .png ou .jpg.</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
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
        <translation>&lt;h3&gt;Glissade %1&lt;/h3&gt;&lt;p&gt;Un établi pour l&apos;assemblage virtuel : des mouvements certifiés, trouvés ensemble par un planificateur et une personne.&lt;/p&gt;&lt;p&gt;N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, &lt;i&gt;Tuning Interaction in Motion Planning with Contact&lt;/i&gt;, IEEE RO-MAN 2016.&lt;/p&gt;&lt;p&gt;S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, &lt;i&gt;Multi-layer path planning control for the simulation of manipulation tasks&lt;/i&gt;, RCIM 57, 2019.&lt;/p&gt;&lt;p&gt;Licence BSD à 3 clauses.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;Display</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Assembly</source>
        <translation>&amp;Assemblage</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Calcul</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>É&amp;tude</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>&amp;Opérateur</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>Lay&amp;ers</source>
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
        <translation>La part de l&apos;ordinateur dans les itérations : 1 est le planificateur seul, 0 l&apos;opérateur seul.</translation>
    </message>
    <message>
        <source>Samples shot on the tangent plane each time contact mode is entered.</source>
        <translation>Échantillons tirés sur le plan tangent à chaque entrée en mode contact.</translation>
    </message>
    <message>
        <source>Closer than this to the nearest obstacle, contact mode begins.</source>
        <translation>Plus près que cela de l&apos;obstacle le plus proche, le mode contact commence.</translation>
    </message>
    <message>
        <source>Radius of the disc on the tangent plane in which contact samples are shot.</source>
        <translation>Rayon du disque du plan tangent dans lequel les échantillons de contact sont tirés.</translation>
    </message>
    <message>
        <source>Required clearance</source>
        <translation>Jeu exigé</translation>
    </message>
    <message>
        <source>Repulsion</source>
        <translation>Répulsion</translation>
    </message>
    <message>
        <source>Attraction</source>
        <translation>Attraction</translation>
    </message>
    <message>
        <source>Guidance: how strongly obstacles nearer than the contact distance push the hand away; 0 is off.</source>
        <translation>Guidage : avec quelle force les obstacles plus proches que la distance de contact repoussent la main ; 0 pour aucune.</translation>
    </message>
    <message>
        <source>Guidance: how strongly the path or the next milestone draws the hand; 0 is off.</source>
        <translation>Guidage : avec quelle force le chemin ou le prochain jalon attire la main ; 0 pour aucune.</translation>
    </message>
    <message>
        <source>Automatic tuning</source>
        <translation>Réglage automatique</translation>
    </message>
    <message>
        <source>What sets itself while planning, added up: 1 for α, 2 for N, 4 for d. 0 is nothing, 7 all three.</source>
        <translation>Ce qui se règle seul pendant la planification, en somme : 1 pour α, 2 pour N, 4 pour d. 0 : rien, 7 : les trois.</translation>
    </message>
    <message>
        <source>Clearance that a delivered path is proved to keep.</source>
        <translation>Distance aux obstacles qu&apos;un chemin livré garde, preuve à l&apos;appui.</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>In the window: planner steps a second, so that a person can watch and steer. 0 is full speed; the first paper&apos;s planner made 40.</source>
        <translation>Dans la fenêtre : pas du planificateur par seconde, pour regarder et guider. 0 : pleine vitesse ; le planificateur du premier article en faisait 40.</translation>
    </message>
    <message>
        <source>Contact gap</source>
        <translation>Écart de contact</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Pas de croissance</translation>
    </message>
    <message>
        <source>Extension step</source>
        <translation>Pas d&apos;extension</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>Pas par seconde</translation>
    </message>
    <message>
        <source>Step limit</source>
        <translation>Limite de pas</translation>
    </message>
    <message>
        <source>Sample limit</source>
        <translation>Limite d&apos;échantillons</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Limite de temps</translation>
    </message>
    <message>
        <source>Samples of strategy G</source>
        <translation>Échantillons de la stratégie G</translation>
    </message>
    <message>
        <source>Samples a step</source>
        <translation>Échantillons par étape</translation>
    </message>
    <message>
        <source>Samples a border</source>
        <translation>Échantillons par frontière</translation>
    </message>
    <message>
        <source>Coarse paths</source>
        <translation>Chemins grossiers</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>OMPL&apos;s range</source>
        <translation>Portée d&apos;OMPL</translation>
    </message>
    <message>
        <source>OMPL&apos;s resolution</source>
        <translation>Résolution d&apos;OMPL</translation>
    </message>
    <message>
        <source>Planners side by side</source>
        <translation>Planificateurs côte à côte</translation>
    </message>
    <message>
        <source>Gap that contact samples keep to the surface, so that they touch without penetrating.</source>
        <translation>Écart que les échantillons de contact gardent à la surface, pour toucher sans pénétrer.</translation>
    </message>
    <message>
        <source>Sampling step of edges while the trees grow (delivered edges are certified).</source>
        <translation>Pas d&apos;échantillonnage des segments pendant la croissance des arbres (les segments livrés sont certifiés).</translation>
    </message>
    <message>
        <source>A blocked extension towards a random configuration ends at a multiple of this, off the obstacle.</source>
        <translation>Une extension bloquée vers une configuration aléatoire finit à un multiple de ce pas, à l&apos;écart de l&apos;obstacle.</translation>
    </message>
    <message>
        <source>Lockstep clock: planner steps in one second of the simulated or recorded operator.</source>
        <translation>Horloge sans temps réel : pas du planificateur en une seconde de l&apos;opérateur simulé ou enregistré.</translation>
    </message>
    <message>
        <source>Stop after this many planner steps; 0 is no limit.</source>
        <translation>Arrêter après ce nombre de pas du planificateur ; 0 : sans limite.</translation>
    </message>
    <message>
        <source>Stop after this many random configurations; 0 is no limit.</source>
        <translation>Arrêter après ce nombre de configurations aléatoires ; 0 : sans limite.</translation>
    </message>
    <message>
        <source>Stop after this many seconds of planning; 0 is no limit.</source>
        <translation>Arrêter après ce nombre de secondes de planification ; 0 : sans limite.</translation>
    </message>
    <message>
        <source>Strategy G gives up after this many random configurations.</source>
        <translation>La stratégie G abandonne après ce nombre de configurations aléatoires.</translation>
    </message>
    <message>
        <source>A topological step fails after this many random configurations.</source>
        <translation>Une étape topologique échoue après ce nombre de configurations aléatoires.</translation>
    </message>
    <message>
        <source>Random configurations drawn in a border to find its milestone.</source>
        <translation>Configurations aléatoires tirées dans une frontière pour trouver son jalon.</translation>
    </message>
    <message>
        <source>Coarse paths that a strategy with a loop tries before it searches the whole workspace only.</source>
        <translation>Chemins grossiers qu&apos;une stratégie en boucle essaie avant de ne chercher que dans tout l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>Shortcuts tried on the path found, each certified before it is taken; 0 leaves the path as planned.</source>
        <translation>Raccourcis essayés sur le chemin trouvé, chacun certifié avant d&apos;être pris ; 0 laisse le chemin tel que planifié.</translation>
    </message>
    <message>
        <source>Longest edge of the planners of unmodified OMPL, as a share of the space&apos;s extent; 0 is OMPL&apos;s default.</source>
        <translation>Plus long segment des planificateurs d&apos;OMPL non modifié, en part de l&apos;étendue de l&apos;espace ; 0 : le défaut d&apos;OMPL.</translation>
    </message>
    <message>
        <source>Distance of the configurations that the planners of unmodified OMPL check on an edge, as a share of the space&apos;s extent.</source>
        <translation>Distance des configurations que les planificateurs d&apos;OMPL non modifié examinent sur un segment, en part de l&apos;étendue de l&apos;espace.</translation>
    </message>
    <message>
        <source>Planners of strategy auto that work at the same time, on as many of the machine&apos;s cores. Another number is another search; the cores do not change it.</source>
        <translation>Planificateurs de la stratégie auto qui travaillent en même temps, sur autant de cœurs de la machine. Un autre nombre est une autre recherche ; les cœurs ne la changent pas.</translation>
    </message>
</context>
<context>
    <name>PathFormats</name>
    <message>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>With provenance</source>
        <translation>Avec provenance</translation>
    </message>
    <message>
        <source>OMPL columns</source>
        <translation>Colonnes OMPL</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
</context>
<context>
    <name>PlaceIdentifiers</name>
    <message>
        <source>Region growing</source>
        <translation>Croissance de régions</translation>
    </message>
    <message>
        <source>Watershed</source>
        <translation>Partage des eaux</translation>
    </message>
</context>
<context>
    <name>Planners</name>
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
        <translation>BiRRT interactif, contact d&apos;abord</translation>
    </message>
    <message>
        <source>G: geometry</source>
        <translation>G : géométrie</translation>
    </message>
    <message>
        <source>GT: and topology</source>
        <translation>GT : et topologie</translation>
    </message>
    <message>
        <source>GTS1: and semantics, same shape</source>
        <translation>GTS1 : et sémantique, même forme</translation>
    </message>
    <message>
        <source>GTS2: and semantics, compatible</source>
        <translation>GTS2 : et sémantique, compatible</translation>
    </message>
    <message>
        <source>GTS: in a loop, with scores</source>
        <translation>GTS : en boucle, avec scores</translation>
    </message>
    <message>
        <source>Own rules</source>
        <translation>Règles propres</translation>
    </message>
    <message>
        <source>OMPL: RRT-Connect</source>
        <translation>OMPL : RRT-Connect</translation>
    </message>
    <message>
        <source>OMPL: BKPIECE</source>
        <translation>OMPL : BKPIECE</translation>
    </message>
    <message>
        <source>OMPL: PRM</source>
        <translation>OMPL : PRM</translation>
    </message>
    <message>
        <source>OMPL: EST</source>
        <translation>OMPL : EST</translation>
    </message>
    <message>
        <source>OMPL unmodified: RRT-Connect</source>
        <translation>OMPL non modifié : RRT-Connect</translation>
    </message>
    <message>
        <source>OMPL unmodified: RRT</source>
        <translation>OMPL non modifié : RRT</translation>
    </message>
    <message>
        <source>OMPL unmodified: TRRT</source>
        <translation>OMPL non modifié : TRRT</translation>
    </message>
    <message>
        <source>OMPL unmodified: BiTRRT</source>
        <translation>OMPL non modifié : BiTRRT</translation>
    </message>
    <message>
        <source>OMPL unmodified: BKPIECE</source>
        <translation>OMPL non modifié : BKPIECE</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Interactive with contact</source>
        <translation>Interactif avec contact</translation>
    </message>
    <message>
        <source>Several planners work side by side; those that make progress get more time. No settings are needed.</source>
        <translation>Plusieurs planificateurs travaillent côte à côte ; ceux qui progressent reçoivent plus de temps. Aucun réglage n&apos;est nécessaire.</translation>
    </message>
    <message>
        <source>You steer the object and the computer searches with you; near an obstacle the object slides on it (Blin et al. 2016, Algorithm 1).</source>
        <translation>Vous guidez l&apos;objet et l&apos;ordinateur cherche avec vous ; près d&apos;un obstacle, l&apos;objet glisse dessus (Blin et al. 2016, algorithme 1).</translation>
    </message>
    <message>
        <source>The computer alone: the same planner with an authority of 1.</source>
        <translation>L&apos;ordinateur seul : le même planificateur avec une autorité de 1.</translation>
    </message>
    <message>
        <source>Operator and computer share authority, no contact sampling (Blin et al. 2016, table I).</source>
        <translation>L&apos;opérateur et l&apos;ordinateur partagent l&apos;autorité, sans échantillons de contact (Blin et al. 2016, tableau I).</translation>
    </message>
    <message>
        <source>As the papers&apos; software of 2016: near an obstacle contact sampling pre-empts the authority draw.</source>
        <translation>Comme le logiciel des articles en 2016 : près d&apos;un obstacle, les échantillons de contact passent avant le tirage de l&apos;autorité.</translation>
    </message>
    <message>
        <source>One RRT in the whole workspace (Cailhol et al. 2019, section 6.1).</source>
        <translation>Un RRT dans tout l&apos;espace de travail (Cailhol et al. 2019, section 6.1).</translation>
    </message>
    <message>
        <source>The shortest way through the places, RRT in each of them (Cailhol et al. 2019, section 6.1).</source>
        <translation>Le trajet le plus court à travers les lieux, un RRT dans chacun (Cailhol et al. 2019, section 6.1).</translation>
    </message>
    <message>
        <source>Holes of the object&apos;s shape and easy places first (Cailhol et al. 2019, section 6.2).</source>
        <translation>D&apos;abord les trous de la forme de l&apos;objet et les lieux faciles (Cailhol et al. 2019, section 6.2).</translation>
    </message>
    <message>
        <source>Holes that the object fits and easy places first (Cailhol et al. 2019, section 6.2, table 1).</source>
        <translation>D&apos;abord les trous où l&apos;objet passe et les lieux faciles (Cailhol et al. 2019, section 6.2, tableau 1).</translation>
    </message>
    <message>
        <source>Computed compatibility as a score, passages crossed where they fit best, and the next best way where one fails.</source>
        <translation>La compatibilité calculée sert de note, les passages sont franchis là où ils conviennent le mieux, et le trajet suivant est essayé après un échec.</translation>
    </message>
    <message>
        <source>The rules of the scenario.</source>
        <translation>Les règles du scénario.</translation>
    </message>
    <message>
        <source>Two trees that grow towards each other (Kuffner and LaValle 2000).</source>
        <translation>Deux arbres qui croissent l&apos;un vers l&apos;autre (Kuffner et LaValle 2000).</translation>
    </message>
    <message>
        <source>Two trees that grow from the border of the cells explored (Sucan and Kavraki 2009).</source>
        <translation>Deux arbres qui croissent depuis le bord des cellules explorées (Sucan et Kavraki 2009).</translation>
    </message>
    <message>
        <source>A roadmap of the whole space (Kavraki et al. 1996).</source>
        <translation>Un graphe de tout l&apos;espace (Kavraki et al. 1996).</translation>
    </message>
    <message>
        <source>One tree that grows where it is sparse (Hsu et al. 1999).</source>
        <translation>Un arbre qui croît là où il est clairsemé (Hsu et al. 1999).</translation>
    </message>
    <message>
        <source>RRT-Connect as OMPL&apos;s users run it: collisions by FCL, edges looked at every so often; the first path is judged by our certificate.</source>
        <translation>RRT-Connect comme l&apos;exécutent les utilisateurs d&apos;OMPL : collisions par FCL, arêtes examinées de loin en loin ; le premier chemin est jugé par notre certificat.</translation>
    </message>
    <message>
        <source>RRT as OMPL&apos;s users run it: collisions by FCL, edges looked at every so often; the first path is judged by our certificate.</source>
        <translation>RRT comme l&apos;exécutent les utilisateurs d&apos;OMPL : collisions par FCL, arêtes examinées de loin en loin ; le premier chemin est jugé par notre certificat.</translation>
    </message>
    <message>
        <source>TRRT as OMPL&apos;s users run it: collisions by FCL, edges looked at every so often; the first path is judged by our certificate.</source>
        <translation>TRRT comme l&apos;exécutent les utilisateurs d&apos;OMPL : collisions par FCL, arêtes examinées de loin en loin ; le premier chemin est jugé par notre certificat.</translation>
    </message>
    <message>
        <source>BiTRRT as OMPL&apos;s users run it: collisions by FCL, edges looked at every so often; the first path is judged by our certificate.</source>
        <translation>BiTRRT comme l&apos;exécutent les utilisateurs d&apos;OMPL : collisions par FCL, arêtes examinées de loin en loin ; le premier chemin est jugé par notre certificat.</translation>
    </message>
    <message>
        <source>BKPIECE as OMPL&apos;s users run it: collisions by FCL, edges looked at every so often; the first path is judged by our certificate.</source>
        <translation>BKPIECE comme l&apos;exécutent les utilisateurs d&apos;OMPL : collisions par FCL, arêtes examinées de loin en loin ; le premier chemin est jugé par notre certificat.</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>paper</source>
        <translation>article</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scénario</translation>
    </message>
    <message>
        <source>Success rate (%)</source>
        <translation>Taux de succès (%)</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Random configurations (mean)</source>
        <translation>Configurations aléatoires (moyenne)</translation>
    </message>
    <message>
        <source>Virtual time (s)</source>
        <translation>Temps virtuel (s)</translation>
    </message>
    <message>
        <source>Random configurations</source>
        <translation>Configurations aléatoires</translation>
    </message>
    <message>
        <source>Authority α</source>
        <translation>Autorité α</translation>
    </message>
    <message>
        <source>Contact samples N</source>
        <translation>Échantillons de contact N</translation>
    </message>
    <message>
        <source>Contact distance d (m)</source>
        <translation>Distance de contact d (m)</translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>As in CAD</source>
        <translation>Comme en CAO</translation>
    </message>
    <message>
        <source>Beginner</source>
        <translation>Débutant</translation>
    </message>
    <message>
        <source>Precise</source>
        <translation>Précis</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Vol</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
</context>
<context>
    <name>SaveConflict</name>
    <message>
        <source>The file is gone</source>
        <translation>Le fichier n&apos;est plus là</translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>Le fichier a été modifié</translation>
    </message>
    <message>
        <source>Another program has removed or renamed the file since it was opened:</source>
        <translation>Un autre programme a supprimé ou renommé le fichier depuis son ouverture :</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was opened:</source>
        <translation>Un autre programme a modifié le fichier depuis son ouverture :</translation>
    </message>
    <message>
        <source>Save it there again, or under another name.</source>
        <translation>Enregistrez-le de nouveau à cet endroit, ou sous un autre nom.</translation>
    </message>
    <message>
        <source>Overwrite it with your version: the other version stays under File &gt; Earlier versions. Or open the other version: your edits are lost. Or save your version under another name.</source>
        <translation>Remplacez-le par votre version : l&apos;autre version reste sous Fichier &gt; Versions antérieures. Ou ouvrez l&apos;autre version : vos modifications sont perdues. Ou enregistrez votre version sous un autre nom.</translation>
    </message>
    <message>
        <source>Save &amp;again</source>
        <translation>Enregistrer de &amp;nouveau</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Open the other &amp;version</source>
        <translation>Ouvrir l&apos;autre &amp;version</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Enregistrer &amp;sous...</translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>Ready. Press Start (F5), or take the object with the keys over the view.</source>
        <translation>Prêt. Appuyez sur Démarrer (F5), ou prenez l&apos;objet avec les touches sur la vue.</translation>
    </message>
    <message>
        <source>Planning: sampling on the nearest obstacle&apos;s tangent plane</source>
        <translation>Planification : échantillonnage sur le plan tangent de l&apos;obstacle le plus proche</translation>
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
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Planning: step %1 of %2, place %3 is crossed</source>
        <translation>Planification : étape %1 sur %2, traversée du lieu %3</translation>
    </message>
    <message>
        <source>Planning: milestones in the borders</source>
        <translation>Planification : jalons dans les frontières</translation>
    </message>
    <message>
        <source>The path does not hold here: see Path. Start (F5) looks for another.</source>
        <translation>Le chemin ne tient pas ici : voir Chemin. Démarrer (F5) en cherche un autre.</translation>
    </message>
    <message>
        <source>The path holds: certified free of penetration</source>
        <translation>Le chemin tient : certifié sans pénétration</translation>
    </message>
    <message>
        <source>The start is refused: see the message over the scene.</source>
        <translation>Le départ est refusé : voir le message au-dessus de la scène.</translation>
    </message>
    <message>
        <source>The goal is refused: see the message over the scene.</source>
        <translation>Le but est refusé : voir le message au-dessus de la scène.</translation>
    </message>
    <message>
        <source>Planning: growing two trees</source>
        <translation>Planification : croissance de deux arbres</translation>
    </message>
    <message>
        <source>Stopped: what was found is still shown</source>
        <translation>Arrêté : ce qui a été trouvé reste affiché</translation>
    </message>
    <message>
        <source>Planning: finding the places</source>
        <translation>Planification : les lieux sont recherchés</translation>
    </message>
    <message>
        <source>Planning: searching the whole workspace</source>
        <translation>Planification : recherche dans tout l&apos;espace de travail</translation>
    </message>
    <message>
        <source>%1 s of %2 s</source>
        <translation>%1 s sur %2 s</translation>
    </message>
</context>
<context>
    <name>UnsavedEditsDialog</name>
    <message>
        <source>The scenario was never saved.</source>
        <translation>Le scénario n&apos;a jamais été enregistré.</translation>
    </message>
    <message>
        <source>%1: the file is not there any more.</source>
        <translation>%1 : le fichier n&apos;est plus là.</translation>
    </message>
    <message>
        <source>%1: the file is as it was before these edits.</source>
        <translation>%1 : le fichier est tel qu&apos;il était avant ces modifications.</translation>
    </message>
    <message>
        <source>%1: the file has changed since. You will be asked before it is overwritten.</source>
        <translation>%1 : le fichier a changé depuis. Une question sera posée avant de le remplacer.</translation>
    </message>
    <message>
        <source>Unsaved edits were left</source>
        <translation>Des modifications non enregistrées sont restées</translation>
    </message>
    <message>
        <source>&amp;Open them</source>
        <translation>&amp;Les ouvrir</translation>
    </message>
    <message>
        <source>&amp;Discard them</source>
        <translation>Les &amp;supprimer</translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation>Demander &amp;plus tard</translation>
    </message>
    <message>
        <source>Glissade ended unexpectedly. Edits of the scenario &quot;%1&quot; from %2 are still there.</source>
        <translation>Glissade s&apos;est arrêté de façon inattendue. Des modifications du scénario « %1 » du %2 sont encore là.</translation>
    </message>
    <message>
        <source>Glissade ended unexpectedly. The edits from %1 are damaged and cannot be opened.</source>
        <translation>Glissade s&apos;est arrêté de façon inattendue. Les modifications du %1 sont endommagées et ne peuvent pas être ouvertes.</translation>
    </message>
</context>
<context>
    <name>FilmWriter</name>
    <message>
        <source>Film (*.mp4);;Film (*.webm);;Series of pictures (*.png)</source>
        <translation>Film (*.mp4);;Film (*.webm);;Série d&apos;images (*.png)</translation>
    </message>
</context>
<context>
    <name>glissade::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>Another language is used from the next start on.</source>
        <translation>Une autre langue sert à partir du prochain démarrage.</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>&amp;Size of texts</source>
        <translation>Ta&amp;ille des textes</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Background of the scene</source>
        <translation>&amp;Fond de la scène</translation>
    </message>
    <message>
        <source>&amp;Goal and its tree</source>
        <translation>&amp;But et son arbre</translation>
    </message>
    <message>
        <source>&amp;Path and selection</source>
        <translation>&amp;Chemin et sélection</translation>
    </message>
    <message>
        <source>&amp;Reset the colours</source>
        <translation>&amp;Rétablir les couleurs</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>L&amp;engths</source>
        <translation>&amp;Longueurs</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Save &amp;unsaved edits every</source>
        <translation>&amp;Sauvegarde automatique toutes les</translation>
    </message>
    <message>
        <source>Start and &amp;its tree</source>
        <translation>&amp;Départ et son arbre</translation>
    </message>
    <message>
        <source>Use the colours of the theme again: they are distinct to people with colour blindness</source>
        <translation>Reprendre les couleurs du thème : les personnes daltoniennes les distinguent</translation>
    </message>
    <message>
        <source>What is not saved is written into the program&apos;s data folder, to be offered after a crash</source>
        <translation>Ce qui n&apos;est pas enregistré est écrit dans le dossier de données du programme, pour être proposé après un arrêt brutal</translation>
    </message>
    <message>
        <source>µm, mm or m, as it fits</source>
        <translation>µm, mm ou m, selon la longueur</translation>
    </message>
</context>
<context>
    <name>glissade::FilmJob</name>
    <message>
        <source>Making the film</source>
        <translation>Création du film</translation>
    </message>
</context>
<context>
    <name>glissade::AssemblyController</name>
    <message>
        <source>Search bodies</source>
        <translation>Rechercher des corps</translation>
    </message>
    <message>
        <source>Goal out</source>
        <translation>But : dehors</translation>
    </message>
    <message>
        <source>Fit the workspace</source>
        <translation>Ajuster l&apos;espace de travail</translation>
    </message>
    <message>
        <source>Swap start and goal</source>
        <translation>Échanger départ et but</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Remove bodies</source>
        <translation>Retirer des corps</translation>
    </message>
    <message>
        <source>%1 moves</source>
        <translation>%1 bouge</translation>
    </message>
    <message>
        <source>Start and goal are clear of all bodies.</source>
        <translation>Le départ et le but sont à l&apos;écart de tous les corps.</translation>
    </message>
    <message>
        <source>Clear start and goal</source>
        <translation>Dégager départ et but</translation>
    </message>
    <message>
        <source>Clear of all bodies: %1</source>
        <translation>À l&apos;écart de tous les corps : %1</translation>
    </message>
    <message>
        <source>This cannot be done</source>
        <translation>Cela ne peut pas se faire</translation>
    </message>
    <message>
        <source>Moving the ends clear</source>
        <translation>Dégagement du départ et du but</translation>
    </message>
    <message>
        <source>the goal was moved by %1</source>
        <translation>le but a été déplacé de %1</translation>
    </message>
    <message>
        <source>the start was moved by %1</source>
        <translation>le départ a été déplacé de %1</translation>
    </message>
</context>
<context>
    <name>glissade::AttributeDialog</name>
    <message>
        <source>Add an attribute</source>
        <translation>Ajouter un attribut</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>oui ou non</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>nombre entier</translation>
    </message>
    <message>
        <source>number</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texte</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>choix</translation>
    </message>
    <message>
        <source>places</source>
        <translation>lieux</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>lower-case letters, digits and _</source>
        <translation>lettres minuscules, chiffres et _</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>séparés par des virgules</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Describes</source>
        <translation>Décrit</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Choix</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>0, or the nearest in range</source>
        <translation>0, ou le plus proche admis</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Initial value</source>
        <translation>Valeur initiale</translation>
    </message>
</context>
<context>
    <name>glissade::AttributeEditor</name>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
</context>
<context>
    <name>glissade::AttributeView</name>
    <message>
        <source>default</source>
        <translation>défaut</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>calculé</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>modifié</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Take the edit back: the computed value again</source>
        <translation>Annuler la modification : la valeur calculée à nouveau</translation>
    </message>
</context>
<context>
    <name>glissade::AuthorBar</name>
    <message>
        <source>computer</source>
        <translation>ordinateur</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>opérateur</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>contact</translation>
    </message>
    <message>
        <source>Computer: random configurations. Operator: where he held the object. Contact: shot on the tangent plane of his nearest obstacle.</source>
        <translation>Ordinateur : configurations aléatoires. Opérateur : là où il tenait l&apos;objet. Contact : tirées sur le plan tangent de son obstacle le plus proche.</translation>
    </message>
</context>
<context>
    <name>glissade::AxisBar</name>
    <message>
        <source>Thin: as the device reports it. Thick: after shaping. Hatched: the dead zone.</source>
        <translation>Fin : tel que le périphérique l&apos;indique. Épais : après mise en forme. Hachuré : la zone morte.</translation>
    </message>
</context>
<context>
    <name>glissade::AxisRow</name>
    <message>
        <source>Dead zone</source>
        <translation>Zone morte</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Turns the direction round</source>
        <translation>Inverse le sens</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Inversé</translation>
    </message>
    <message>
        <source>shift x</source>
        <translation>translation x</translation>
    </message>
    <message>
        <source>shift y</source>
        <translation>translation y</translation>
    </message>
    <message>
        <source>shift z</source>
        <translation>translation z</translation>
    </message>
    <message>
        <source>turn x</source>
        <translation>rotation x</translation>
    </message>
    <message>
        <source>turn y</source>
        <translation>rotation y</translation>
    </message>
    <message>
        <source>turn z</source>
        <translation>rotation z</translation>
    </message>
    <message>
        <source>The device&apos;s axis that drives this one</source>
        <translation>L&apos;axe du périphérique qui commande celui-ci</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Device, motion</source>
        <translation>Périphérique, mouvement</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Driven by</source>
        <translation>Commandé par</translation>
    </message>
</context>
<context>
    <name>glissade::CalibrationDialog</name>
    <message>
        <source>&amp;One axis at a time (the dominant one)</source>
        <translation>&amp;Un axe à la fois (le dominant)</translation>
    </message>
    <message>
        <source>Lock &amp;shifts</source>
        <translation>Bloquer les &amp;translations</translation>
    </message>
    <message>
        <source>Lock &amp;turns</source>
        <translation>Bloquer les &amp;rotations</translation>
    </message>
    <message>
        <source>Speed of shifts</source>
        <translation>Vitesse des translations</translation>
    </message>
    <message>
        <source>Speed of turns</source>
        <translation>Vitesse des rotations</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Périphériques</translation>
    </message>
    <message>
        <source>The settings cannot be written: %1</source>
        <translation>Les réglages ne peuvent pas être écrits : %1</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Réi&amp;nitialiser</translation>
    </message>
    <message>
        <source>Shaping and buttons of this device as at the first time</source>
        <translation>Mise en forme et boutons de ce périphérique comme la première fois</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Périphérique</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>Pré&amp;réglage</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>À droite</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>En haut</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>Vers vous</translation>
    </message>
    <message>
        <source>Tip forward</source>
        <translation>Basculer en avant</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Tourner à droite</translation>
    </message>
    <message>
        <source>Roll left</source>
        <translation>Rouler à gauche</translation>
    </message>
    <message>
        <source>of the view</source>
        <translation>de la vue</translation>
    </message>
    <message>
        <source>of the world</source>
        <translation>du monde</translation>
    </message>
    <message>
        <source>of the object</source>
        <translation>de l&apos;objet</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Axes</translation>
    </message>
    <message>
        <source>S&amp;hifts, speed</source>
        <translation>Translations, &amp;vitesse</translation>
    </message>
    <message>
        <source>T&amp;urns, speed</source>
        <translation>R&amp;otations, vitesse</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Boutons</translation>
    </message>
    <message>
        <source>&amp;Button</source>
        <translation>&amp;Bouton</translation>
    </message>
    <message>
        <source>d&amp;oes</source>
        <translation>d&amp;éclenche</translation>
    </message>
    <message>
        <source>Press a button of the device to find its number.</source>
        <translation>Appuyez sur un bouton du périphérique pour trouver son numéro.</translation>
    </message>
    <message>
        <source>own</source>
        <translation>personnel</translation>
    </message>
    <message>
        <source>connected: %1</source>
        <translation>connecté : %1</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
</context>
<context>
    <name>glissade::ClearanceCurve</name>
    <message>
        <source>Clearance along the path</source>
        <translation>Jeu le long du chemin</translation>
    </message>
    <message>
        <source>nothing near</source>
        <translation>rien à proximité</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>measuring the clearance</source>
        <translation>mesure du jeu en cours</translation>
    </message>
</context>
<context>
    <name>glissade::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Trouver une commande</translation>
    </message>
    <message>
        <source>Part of a command&apos;s name</source>
        <translation>Partie du nom d&apos;une commande</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
</context>
<context>
    <name>glissade::ComparePathsDialog</name>
    <message>
        <source>Proof</source>
        <translation>Preuve</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Smallest clearance</source>
        <translation>Plus petit jeu</translation>
    </message>
    <message>
        <source>Proved clearance</source>
        <translation>Jeu prouvé</translation>
    </message>
    <message>
        <source>Required clearance</source>
        <translation>Jeu exigé</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Rotations</translation>
    </message>
    <message>
        <source>Configurations</source>
        <translation>Configurations</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Lissé</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Allowances</source>
        <translation>Tolérances</translation>
    </message>
    <message>
        <source>Clearance along the path</source>
        <translation>Jeu le long du chemin</translation>
    </message>
    <message>
        <source>Compare paths</source>
        <translation>Comparer les chemins</translation>
    </message>
    <message>
        <source>Figures of the paths, side by side</source>
        <translation>Valeurs des chemins, côte à côte</translation>
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
        <translation>Passages dans la boucle de l&apos;article</translation>
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
        <translation>Tirées par l&apos;ordinateur, gardées ou non</translation>
    </message>
    <message>
        <source>Operator configurations</source>
        <translation>Configurations de l&apos;opérateur</translation>
    </message>
    <message>
        <source>Where the operator held the object</source>
        <translation>Là où l&apos;opérateur tenait l&apos;objet</translation>
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
        <translation>De l&apos;objet tenu par l&apos;opérateur</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>To the nearest obstacle</source>
        <translation>À l&apos;obstacle le plus proche</translation>
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
    <name>glissade::DeviceController</name>
    <message>
        <source>6D mouse: %1</source>
        <translation>Souris 6D : %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>No 6D mouse, or spacenavd does not run; looked for again and again</source>
        <translation>Pas de souris 6D, ou spacenavd ne tourne pas ; recherche répétée</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>Manette : %1</translation>
    </message>
    <message>
        <source>Moves: camera</source>
        <translation>Déplace : caméra</translation>
    </message>
    <message>
        <source>Moves: object</source>
        <translation>Déplace : objet</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
</context>
<context>
    <name>glissade::DifficultyController</name>
    <message>
        <source>Looking for what stands in the way</source>
        <translation>Recherche de ce qui fait obstacle</translation>
    </message>
</context>
<context>
    <name>glissade::DifficultyPanel</name>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Combien</translation>
    </message>
    <message>
        <source>Nearest body</source>
        <translation>Corps le plus proche</translation>
    </message>
    <message>
        <source>Place on the way of least penetration</source>
        <translation>Place sur le chemin de moindre pénétration</translation>
    </message>
    <message>
        <source>Not analysed yet.</source>
        <translation>Pas encore analysé.</translation>
    </message>
    <message>
        <source>Least penetration</source>
        <translation>Moindre pénétration</translation>
    </message>
    <message>
        <source>The object has too many triangles to look for the way of least penetration.</source>
        <translation>L&apos;objet a trop de triangles pour chercher le chemin de moindre pénétration.</translation>
    </message>
    <message>
        <source>Tightest passage reached</source>
        <translation>Passage le plus étroit atteint</translation>
    </message>
    <message>
        <source>Trees came within</source>
        <translation>Écart entre les arbres</translation>
    </message>
    <message>
        <source>Shows the object there</source>
        <translation>Montre l&apos;objet à cet endroit</translation>
    </message>
    <message>
        <source>There is a way if the object may overlap &lt;b&gt;%2&lt;/b&gt; by &lt;b&gt;%1&lt;/b&gt;.</source>
        <translation>Il y a un passage si l&apos;objet peut recouvrir &lt;b&gt;%2&lt;/b&gt; de &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>No way was found, however much the object was shrunk.</source>
        <translation>Même en réduisant l&apos;objet, aucun chemin n&apos;a été trouvé.</translation>
    </message>
    <message>
        <source>What stands in the way</source>
        <translation>Ce qui fait obstacle</translation>
    </message>
</context>
<context>
    <name>glissade::EarlierVersionsMenu</name>
    <message>
        <source>Earlier &amp;versions</source>
        <translation>&amp;Versions antérieures</translation>
    </message>
    <message>
        <source>Version %1, saved %2</source>
        <translation>Version %1, enregistrée le %2</translation>
    </message>
    <message>
        <source>No earlier version yet</source>
        <translation>Pas encore de version antérieure</translation>
    </message>
</context>
<context>
    <name>glissade::EnvironmentController</name>
    <message>
        <source>The places cannot be found</source>
        <translation>Les lieux ne peuvent pas être trouvés</translation>
    </message>
</context>
<context>
    <name>glissade::ExportDialog</name>
    <message>
        <source>Export the path</source>
        <translation>Exporter le chemin</translation>
    </message>
</context>
<context>
    <name>glissade::FileController</name>
    <message>
        <source>edits</source>
        <translation>des modifications</translation>
    </message>
    <message>
        <source>the path that was found</source>
        <translation>le chemin trouvé</translation>
    </message>
    <message>
        <source>the assembly plan</source>
        <translation>la gamme de montage</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Pas encore enregistré : %1.</translation>
    </message>
    <message>
        <source>Save keeps all of it in the scenario.</source>
        <translation>Enregistrer garde tout dans le scénario.</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>Fichiers ré&amp;cents</translation>
    </message>
    <message>
        <source>Opening the scenario</source>
        <translation>Ouverture du scénario</translation>
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
        <source>Save the scenario</source>
        <translation>Enregistrer le scénario</translation>
    </message>
    <message>
        <source>Scenarios (*.json)</source>
        <translation>Scénarios (*.json)</translation>
    </message>
    <message>
        <source>The scenario cannot be saved</source>
        <translation>Le scénario ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>%1 (not there)</source>
        <translation>%1 (absent)</translation>
    </message>
    <message>
        <source>No file yet</source>
        <translation>Aucun fichier</translation>
    </message>
    <message>
        <source>The scenario was saved, with a warning</source>
        <translation>Le scénario a été enregistré, avec un avertissement</translation>
    </message>
    <message>
        <source>Save the scenario?</source>
        <translation>Enregistrer le scénario ?</translation>
    </message>
</context>
<context>
    <name>glissade::FitsController</name>
    <message>
        <source>accept a clash</source>
        <translation>accepter une collision</translation>
    </message>
    <message>
        <source>mark a thread</source>
        <translation>marquer un filetage</translation>
    </message>
    <message>
        <source>require clearance</source>
        <translation>exiger un jeu</translation>
    </message>
    <message>
        <source>take a fit as measured</source>
        <translation>prendre un ajustement comme mesuré</translation>
    </message>
    <message>
        <source>Looking for fits</source>
        <translation>Recherche des ajustements</translation>
    </message>
    <message>
        <source>The fit cannot be changed</source>
        <translation>L&apos;ajustement ne peut pas être modifié</translation>
    </message>
</context>
<context>
    <name>glissade::FitsPanel</name>
    <message>
        <source>clear</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>toléré</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>clash</source>
        <translation>collision</translation>
    </message>
    <message>
        <source>%1 overlap</source>
        <translation>recouvrement %1</translation>
    </message>
    <message>
        <source>%1 gap</source>
        <translation>jeu %1</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>se touchent</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>jeu</translation>
    </message>
    <message>
        <source>planar</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>cylindrique</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>filetage</translation>
    </message>
    <message>
        <source>press fit</source>
        <translation>serrage</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>recouvrement</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>contact</translation>
    </message>
    <message>
        <source>Filter by kind, status or body</source>
        <translation>Filtrer par type, état ou corps</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Negative where the bodies overlap</source>
        <translation>Négatif là où les corps se recouvrent</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Body A</source>
        <translation>Corps A</translation>
    </message>
    <message>
        <source>Body B</source>
        <translation>Corps B</translation>
    </message>
    <message>
        <source>Fits</source>
        <translation>Ajustements</translation>
    </message>
    <message>
        <source>Not analysed yet.</source>
        <translation>Pas encore analysé.</translation>
    </message>
    <message>
        <source>No two bodies touch.</source>
        <translation>Aucun corps n&apos;en touche un autre.</translation>
    </message>
    <message>
        <source>Pairs of bodies: %1 (%2)</source>
        <translation>Paires de corps : %1 (%2)</translation>
    </message>
</context>
<context>
    <name>glissade::InteractionPanel</name>
    <message>
        <source>Who holds the object</source>
        <translation>Qui tient l&apos;objet</translation>
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
    <message>
        <source>The strategy of the next run</source>
        <translation>La stratégie du prochain calcul</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Replayed: as it was at this step</source>
        <translation>Relecture : tel qu&apos;à ce pas</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Advanced: the first paper</source>
        <translation>Avancé : premier article</translation>
    </message>
    <message>
        <source>Advanced: places and semantics (second paper)</source>
        <translation>Avancé : lieux et sémantique (second article)</translation>
    </message>
    <message>
        <source>Advanced: OMPL</source>
        <translation>Avancé : OMPL</translation>
    </message>
</context>
<context>
    <name>glissade::KeptPathsController</name>
    <message>
        <source>Comparing paths</source>
        <translation>Comparaison des chemins</translation>
    </message>
    <message>
        <source>This cannot be done with the path</source>
        <translation>Cela ne peut pas être fait avec le chemin</translation>
    </message>
</context>
<context>
    <name>glissade::KeptPathsPanel</name>
    <message>
        <source>taken %1 thinner against %2</source>
        <translation>pris %1 plus mince contre %2</translation>
    </message>
    <message>
        <source>The path is proved again in the background.</source>
        <translation>Le chemin est prouvé de nouveau en arrière-plan.</translation>
    </message>
    <message>
        <source>Certified again in the scenario as it is now.</source>
        <translation>Certifié de nouveau dans le scénario tel qu&apos;il est.</translation>
    </message>
    <message>
        <source>Not proved: the scenario was changed, and a body is in the way.</source>
        <translation>Non prouvé : le scénario a changé, et un corps fait obstacle.</translation>
    </message>
    <message>
        <source>Free of penetration, but it does not lead from the start to the goal any more.</source>
        <translation>Sans pénétration, mais il ne mène plus du départ au but.</translation>
    </message>
    <message>
        <source>Not proved: another object moves now.</source>
        <translation>Non prouvé : un autre objet se déplace maintenant.</translation>
    </message>
    <message>
        <source>proved %1, required %2</source>
        <translation>prouvé %1, exigé %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>not proved yet</source>
        <translation>pas encore prouvé</translation>
    </message>
    <message>
        <source>proved</source>
        <translation>prouvé</translation>
    </message>
    <message>
        <source>blocked</source>
        <translation>bloqué</translation>
    </message>
    <message>
        <source>blocked by %1</source>
        <translation>bloqué par %1</translation>
    </message>
    <message>
        <source>other ends</source>
        <translation>autres extrémités</translation>
    </message>
    <message>
        <source>other object</source>
        <translation>autre objet</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Preuve</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Rotations</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Allowances</source>
        <translation>Tolérances</translation>
    </message>
    <message>
        <source>Kept paths</source>
        <translation>Chemins conservés</translation>
    </message>
    <message>
        <source>Checked: drawn in this colour beside the others</source>
        <translation>Coché : dessiné de cette couleur à côté des autres</translation>
    </message>
    <message>
        <source>The path that was found is not kept yet: Keep (Ctrl+Alt+K) or Save (Ctrl+S).</source>
        <translation>Le chemin trouvé n&apos;est pas encore conservé : Conserver (Ctrl+Alt+K) ou Enregistrer (Ctrl+S).</translation>
    </message>
    <message>
        <source>No path is kept yet. A path that is found can be kept in the scenario.</source>
        <translation>Aucun chemin n&apos;est encore conservé. Un chemin trouvé peut être conservé dans le scénario.</translation>
    </message>
    <message>
        <source>Kept in the scenario: %1</source>
        <translation>Conservés dans le scénario : %1</translation>
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
    <name>glissade::LogController</name>
    <message>
        <source>The report is in the clipboard. Read it before you send it: it names files.</source>
        <translation>Le rapport est dans le presse-papiers. Relisez-le avant de l&apos;envoyer : il nomme des fichiers.</translation>
    </message>
    <message>
        <source>Run %1: %2, seed %3</source>
        <translation>Calcul %1 : %2, graine %3</translation>
    </message>
    <message>
        <source>%1 (%2 s, %3 nodes)</source>
        <translation>%1 (%2 s, %3 nœuds)</translation>
    </message>
    <message>
        <source>Opened &apos;%1&apos;, obstacles: %2</source>
        <translation>« %1 » ouvert, obstacles : %2</translation>
    </message>
    <message>
        <source>Start: %1</source>
        <translation>Départ : %1</translation>
    </message>
    <message>
        <source>Goal: %1</source>
        <translation>But : %1</translation>
    </message>
</context>
<context>
    <name>glissade::LogPanel</name>
    <message>
        <source>All messages</source>
        <translation>Tous les messages</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Avertissements et erreurs</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>Level of the messages that are shown</source>
        <translation>Niveau des messages affichés</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
</context>
<context>
    <name>glissade::MainWindow</name>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Arranging the product</source>
        <translation>Disposition du produit</translation>
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
        <source>Semantics</source>
        <translation>Sémantique</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Difficulté</translation>
    </message>
    <message>
        <source>This cannot be done</source>
        <translation>Cela ne peut pas se faire</translation>
    </message>
    <message>
        <source>Fits</source>
        <translation>Ajustements</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Gardés</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>Finding the fits</source>
        <translation>Recherche des ajustements</translation>
    </message>
    <message>
        <source>Preparing the bodies</source>
        <translation>Préparation des corps</translation>
    </message>
</context>
<context>
    <name>glissade::MeasureController</name>
    <message>
        <source>Finding edges and faces of the body…</source>
        <translation>Recherche des arêtes et des faces du corps…</translation>
    </message>
    <message>
        <source>This is no cylindrical face.</source>
        <translation>Cette face n&apos;est pas cylindrique.</translation>
    </message>
    <message>
        <source>Radius %1, diameter %2</source>
        <translation>Rayon %1, diamètre %2</translation>
    </message>
    <message>
        <source>A vertex or a free surface has no direction: click edges, planes or cylinders.</source>
        <translation>Un sommet ou une surface libre n&apos;a pas de direction : cliquer des arêtes, des plans ou des cylindres.</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Angle %1</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Distance %1</translation>
    </message>
    <message>
        <source> (x %1, y %2, z %3)</source>
        <translation> (x %1, y %2, z %3)</translation>
    </message>
    <message>
        <source>clearance %1</source>
        <translation>jeu %1</translation>
    </message>
    <message>
        <source>overlap %1</source>
        <translation>recouvrement %1</translation>
    </message>
    <message>
        <source>they touch</source>
        <translation>en contact</translation>
    </message>
    <message>
        <source>Measuring the clearance…</source>
        <translation>Mesure du jeu…</translation>
    </message>
    <message>
        <source>Click a cylindrical face. Esc ends measuring.</source>
        <translation>Cliquer une face cylindrique. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>This is neither a plane nor a cylinder.</source>
        <translation>Ce n&apos;est ni un plan ni un cylindre.</translation>
    </message>
    <message>
        <source>Click a plane or a cylinder of what is placed. Esc ends this.</source>
        <translation>Cliquer un plan ou un cylindre de ce qui est placé. Échap y met fin.</translation>
    </message>
    <message>
        <source>Click the first body. Esc ends measuring.</source>
        <translation>Cliquer le premier corps. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click the second body.</source>
        <translation>Cliquer le second corps.</translation>
    </message>
    <message>
        <source>Click the first vertex, edge or face. Esc ends measuring.</source>
        <translation>Cliquer le premier sommet, arête ou face. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click the second vertex, edge or face.</source>
        <translation>Cliquer le second sommet, arête ou face.</translation>
    </message>
    <message>
        <source>Click the first edge or face. Esc ends measuring.</source>
        <translation>Cliquer la première arête ou face. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click the second edge or face.</source>
        <translation>Cliquer la seconde arête ou face.</translation>
    </message>
</context>
<context>
    <name>glissade::MessageLog</name>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
</context>
<context>
    <name>glissade::NoticeBar</name>
    <message>
        <source>Close this message (Esc)</source>
        <translation>Fermer ce message (Échap)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>glissade::PaceBox</name>
    <message>
        <source>Full speed</source>
        <translation>Pleine vitesse</translation>
    </message>
    <message>
        <source>%1 steps a second (the first paper)</source>
        <translation>%1 pas par seconde (premier article)</translation>
    </message>
    <message>
        <source>%1 steps a second</source>
        <translation>%1 pas par seconde</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>How fast a run goes: choose a pace or type steps a second, to watch and to steer</source>
        <translation>Vitesse du calcul : choisir une cadence ou saisir des pas par seconde, pour regarder et guider</translation>
    </message>
</context>
<context>
    <name>glissade::ParameterSlider</name>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>%1 sets itself</source>
        <translation>%1 se règle seul</translation>
    </message>
    <message>
        <source>Sets itself while planning. Press, or move the slider, to take it back; yours is %1</source>
        <translation>Se règle seul pendant la planification. Appuyez ou déplacez le curseur pour le reprendre ; le vôtre est %1</translation>
    </message>
    <message>
        <source>Let it set itself while planning</source>
        <translation>Laisser se régler seul pendant la planification</translation>
    </message>
</context>
<context>
    <name>glissade::PartImport</name>
    <message>
        <source>Reading the parts</source>
        <translation>Lecture des pièces</translation>
    </message>
    <message>
        <source>Add parts</source>
        <translation>Ajouter des pièces</translation>
    </message>
    <message>
        <source>The parts cannot be taken</source>
        <translation>Les pièces ne peuvent pas être prises</translation>
    </message>
</context>
<context>
    <name>glissade::PartsDialog</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>New scenario from parts</source>
        <translation>Nouveau scénario à partir de pièces</translation>
    </message>
    <message>
        <source>Add parts</source>
        <translation>Ajouter des pièces</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Width × depth × height: shows whether the unit is right</source>
        <translation>Largeur × profondeur × hauteur : montre si l&apos;unité est la bonne</translation>
    </message>
    <message>
        <source>Add &amp;files…</source>
        <translation>Ajouter des &amp;fichiers…</translation>
    </message>
    <message>
        <source>Takes the selected rows out of the list (Del)</source>
        <translation>Retire de la liste les lignes sélectionnées (Suppr)</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Créer</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Ajouter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Role of %1</source>
        <translation>Rôle de %1</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unité de %1</translation>
    </message>
    <message>
        <source>Axis of %1 that points up</source>
        <translation>Axe de %1 qui pointe vers le haut</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bouge</translation>
    </message>
    <message>
        <source>The part whose motion is looked for</source>
        <translation>La pièce dont on cherche le mouvement</translation>
    </message>
    <message>
        <source>Static</source>
        <translation>Statique</translation>
    </message>
    <message>
        <source>Stays where it is</source>
        <translation>Reste où elle est</translation>
    </message>
    <message>
        <source>Mobile</source>
        <translation>Mobile</translation>
    </message>
    <message>
        <source>In the way, too, but somebody could move it</source>
        <translation>Gêne aussi, mais quelqu&apos;un pourrait la déplacer</translation>
    </message>
    <message>
        <source>Unit of the file; of all selected rows together</source>
        <translation>Unité du fichier ; de toutes les lignes sélectionnées ensemble</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>The file&apos;s axis that points up; of all selected rows together</source>
        <translation>L&apos;axe du fichier qui pointe vers le haut ; de toutes les lignes sélectionnées ensemble</translation>
    </message>
    <message>
        <source>Add the files of parts</source>
        <translation>Ajouter les fichiers de pièces</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>illisible</translation>
    </message>
    <message>
        <source>Add the files of the parts.</source>
        <translation>Ajoutez les fichiers des pièces.</translation>
    </message>
    <message>
        <source>The files are being read.</source>
        <translation>Les fichiers sont en cours de lecture.</translation>
    </message>
    <message>
        <source>Choose the part that moves.</source>
        <translation>Choisissez la pièce qui bouge.</translation>
    </message>
    <message>
        <source>Meshes (STL, OBJ, Collada, glTF), STEP or URDF files</source>
        <translation>Fichiers de maillages (STL, OBJ, Collada, glTF), STEP ou URDF</translation>
    </message>
    <message>
        <source>The file says its unit itself; Z is up</source>
        <translation>Le fichier indique lui-même son unité ; Z est vers le haut</translation>
    </message>
    <message>
        <source>What the part is in the scenario; static or mobile: all selected rows together</source>
        <translation>Ce que la pièce est dans le scénario ; fixe ou mobile : toutes les lignes sélectionnées ensemble</translation>
    </message>
    <message>
        <source>Select several rows to choose their role, unit or axis together.</source>
        <translation>Sélectionnez plusieurs lignes pour choisir ensemble leur rôle, leur unité ou leur axe.</translation>
    </message>
    <message>
        <source>Parts (*.step *.stp *.STEP *.STP *.stl *.obj *.ply *.dae *.gltf *.glb *.urdf);;All files (*)</source>
        <translation>Pièces (*.step *.stp *.STEP *.STP *.stl *.obj *.ply *.dae *.gltf *.glb *.urdf);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Close planar &amp;holes</source>
        <translation>Fermer les &amp;trous plans</translation>
    </message>
    <message>
        <source>Closes holes of meshes whose edge lies in a plane; a warning says how many</source>
        <translation>Ferme les trous des maillages dont le bord est dans un plan ; un avertissement dit combien</translation>
    </message>
    <message>
        <source>Is the unit right? The files do not say it, and their size does not tell. Choose it.</source>
        <translation>L&apos;unité est-elle juste ? Les fichiers ne la disent pas, et leur taille ne la révèle pas. La choisir.</translation>
    </message>
    <message>
        <source>The files do not say their unit: by their size it is the metre.</source>
        <translation>Les fichiers ne disent pas leur unité : d&apos;après leur taille, c&apos;est le mètre.</translation>
    </message>
</context>
<context>
    <name>glissade::PathController</name>
    <message>
        <source>Write the report of the path</source>
        <translation>Écrire le rapport du chemin</translation>
    </message>
    <message>
        <source>Film the path</source>
        <translation>Filmer le chemin</translation>
    </message>
    <message>
        <source>The film was saved as %1</source>
        <translation>Le film a été enregistré sous %1</translation>
    </message>
    <message>
        <source>The film was cancelled</source>
        <translation>Le film a été annulé</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf)</source>
        <translation>Page web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report was saved as %1</source>
        <translation>Le rapport a été enregistré sous %1</translation>
    </message>
    <message>
        <source>Open a path of this scenario</source>
        <translation>Ouvrir un chemin de ce scénario</translation>
    </message>
    <message>
        <source>Paths (%1);;All files (*)</source>
        <translation>Chemins (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The path was saved, with a warning</source>
        <translation>Le chemin a été enregistré, avec un avertissement</translation>
    </message>
    <message>
        <source>The path was saved as %1</source>
        <translation>Le chemin a été enregistré sous %1</translation>
    </message>
    <message>
        <source>This cannot be done with the path</source>
        <translation>C&apos;est impossible avec ce chemin</translation>
    </message>
</context>
<context>
    <name>glissade::PathPanel</name>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Vitesse de lecture</translation>
    </message>
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
        <source>clearance %1 to %2</source>
        <translation>jeu de %1 avec %2</translation>
    </message>
    <message>
        <source>Certified free of penetration</source>
        <translation>Certifié sans pénétration</translation>
    </message>
    <message>
        <source>%1 configurations, %2, %3°</source>
        <translation>%1 configurations, %2, %3°</translation>
    </message>
    <message>
        <source>Length by author</source>
        <translation>Longueur par auteur</translation>
    </message>
    <message>
        <source>proved %1, required %2</source>
        <translation>prouvé %1, exigé %2</translation>
    </message>
    <message>
        <source>required %1</source>
        <translation>exigé %1</translation>
    </message>
    <message>
        <source>%1 of %2 edges slide</source>
        <translation>%1 segments sur %2 glissent</translation>
    </message>
    <message>
        <source>It does not begin at the start.</source>
        <translation>Il ne commence pas au départ.</translation>
    </message>
    <message>
        <source>It does not end at the goal.</source>
        <translation>Il ne finit pas au but.</translation>
    </message>
    <message>
        <source>It leaves the workspace at configuration %1.</source>
        <translation>Il quitte l&apos;espace de travail à la configuration %1.</translation>
    </message>
    <message>
        <source>%1 of %2 edges are blocked, the first at %3 % by %4.</source>
        <translation>%1 arêtes sur %2 sont bloquées, la première à %3 % par %4.</translation>
    </message>
    <message>
        <source>This path does not hold here</source>
        <translation>Ce chemin ne tient pas ici</translation>
    </message>
    <message>
        <source>of 32-bit coordinates, which may be %1 nearer</source>
        <translation>des coordonnées de 32 bits, qui peuvent être %1 plus près</translation>
    </message>
    <message>
        <source>of triangles; STEP surfaces may be %1 nearer</source>
        <translation>des triangles ; les surfaces STEP peuvent être %1 plus près</translation>
    </message>
    <message>
        <source>taken %1 thinner against %2</source>
        <translation>aminci de %1 face à %2</translation>
    </message>
    <message>
        <source>(thread), pitch %1, %2 turns</source>
        <translation>(filetage), pas %1, %2 tours</translation>
    </message>
</context>
<context>
    <name>glissade::PathShelf</name>
    <message>
        <source>Keep a path</source>
        <translation>Conserver un chemin</translation>
    </message>
    <message>
        <source>Rename a path</source>
        <translation>Renommer un chemin</translation>
    </message>
    <message>
        <source>Pin a path</source>
        <translation>Épingler un chemin</translation>
    </message>
    <message>
        <source>Unpin a path</source>
        <translation>Détacher un chemin</translation>
    </message>
    <message>
        <source>Remove a path</source>
        <translation>Supprimer un chemin</translation>
    </message>
</context>
<context>
    <name>glissade::PlacementPanel</name>
    <message>
        <source>Placement: select one body, start or goal</source>
        <translation>Position : choisir un corps, départ ou but</translation>
    </message>
    <message>
        <source>Point that the numbers are about</source>
        <translation>Point auquel les nombres se rapportent</translation>
    </message>
    <message>
        <source>What the numbers are about; poses of a CAD system are about the origin of its file</source>
        <translation>Ce à quoi les nombres se rapportent ; les poses d&apos;un système de CAO se rapportent à l&apos;origine de son fichier</translation>
    </message>
    <message>
        <source>Origin of the file</source>
        <translation>Origine du fichier</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Reference point</source>
        <translation>Point de référence</translation>
    </message>
    <message>
        <source>What the poses of path files are about</source>
        <translation>Ce à quoi les poses des fichiers de chemin se rapportent</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Picked face or axis</source>
        <translation>Face ou axe choisi</translation>
    </message>
    <message>
        <source>Along the world&apos;s axis %1; a number may have a unit: 25.4 mm, 1 in</source>
        <translation>Le long de l&apos;axe %1 du monde ; un nombre peut avoir une unité : 25,4 mm, 1 in</translation>
    </message>
    <message>
        <source>Turned about the world&apos;s axis %1, in degrees, or with a unit: 0.1 rad; first X, then Y, then Z</source>
        <translation>Tourné autour de l&apos;axe %1 du monde, en degrés, ou avec une unité : 0,1 rad ; d&apos;abord X, puis Y, puis Z</translation>
    </message>
    <message>
        <source>“%1” is not a length up to 1 km. Write 12.5, 25.4 mm, 1 in or 0.5&quot;. Nothing has moved.</source>
        <translation>« %1 » n&apos;est pas une longueur jusqu&apos;à 1 km. Écrire 12,5, 25,4 mm, 1 in ou 0,5&quot;. Rien n&apos;a bougé.</translation>
    </message>
    <message>
        <source>“%1” is not an angle up to 360°. Write 30, 30 deg or 0.1 rad. Nothing has moved.</source>
        <translation>« %1 » n&apos;est pas un angle jusqu&apos;à 360°. Écrire 30, 30 deg ou 0,1 rad. Rien n&apos;a bougé.</translation>
    </message>
    <message>
        <source>Placement of %1, %2 and °</source>
        <translation>Placement de %1, %2 et °</translation>
    </message>
    <message>
        <source>Placement, %1 and °</source>
        <translation>Placement, %1 et °</translation>
    </message>
    <message>
        <source>“%1” is not a length. Nothing has moved.</source>
        <translation>« %1 » n&apos;est pas une longueur. Rien n&apos;a bougé.</translation>
    </message>
    <message>
        <source>“%1” is not an angle. Nothing has moved.</source>
        <translation>« %1 » n&apos;est pas un angle. Rien n&apos;a bougé.</translation>
    </message>
</context>
<context>
    <name>glissade::PlanPanel</name>
    <message>
        <source>to do</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Vers</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planificateur</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléat.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Random configurations, milestone and local planner together</source>
        <translation>Configurations aléatoires, jalon et planificateur local ensemble</translation>
    </message>
    <message>
        <source>No coarse plan: choose strategy GT or GTS and start.</source>
        <translation>Pas de plan grossier : choisissez la stratégie GT ou GTS et démarrez.</translation>
    </message>
    <message>
        <source>Coarse path of cost %1, not tried yet</source>
        <translation>Chemin grossier de coût %1, pas encore essayé</translation>
    </message>
    <message>
        <source>Coarse path %1, cost %2; random configurations: coarse %3, fine %4</source>
        <translation>Chemin grossier %1, coût %2 ; configurations aléatoires : grossier %3, fin %4</translation>
    </message>
    <message>
        <source>solved</source>
        <translation>résolu</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échoué</translation>
    </message>
    <message>
        <source>No way through the places.</source>
        <translation>Aucun trajet à travers les lieux.</translation>
    </message>
    <message>
        <source>Forbidden: %1.</source>
        <translation>Interdits : %1.</translation>
    </message>
    <message>
        <source>Of infinite cost: %1.</source>
        <translation>De coût infini : %1.</translation>
    </message>
    <message>
        <source>None leads from start to goal.</source>
        <translation>Aucun ne mène du départ au but.</translation>
    </message>
    <message>
        <source>Solved by the search of the whole workspace, after %1 coarse paths; random configurations: %2</source>
        <translation>Résolu par la recherche dans tout l&apos;espace de travail, après %1 chemins grossiers ; configurations aléatoires : %2</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>Steps of the coarse path</source>
        <translation>Étapes du chemin grossier</translation>
    </message>
</context>
<context>
    <name>glissade::RecordingController</name>
    <message>
        <source>The recording cannot be opened</source>
        <translation>L&apos;enregistrement ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.json *.journal);;All files (*)</source>
        <translation>Enregistrements (*.json *.journal);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>Lecture de l&apos;enregistrement</translation>
    </message>
    <message>
        <source>A run has begun meanwhile: open the recording after it.</source>
        <translation>Un calcul a commencé entre-temps : ouvrez l&apos;enregistrement après lui.</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>Sauvegarder l&apos;enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.json)</source>
        <translation>Enregistrements (*.json)</translation>
    </message>
    <message>
        <source>The recording was saved, with a warning</source>
        <translation>L&apos;enregistrement a été sauvegardé, avec un avertissement</translation>
    </message>
    <message>
        <source>The recording cannot be saved</source>
        <translation>L&apos;enregistrement ne peut pas être sauvegardé</translation>
    </message>
    <message>
        <source>The recording was saved</source>
        <translation>L&apos;enregistrement est sauvegardé</translation>
    </message>
    <message>
        <source>It names the scenario&apos;s file, which does not have the bodies as they are here. Save the scenario, too: only then can the recording be replayed.</source>
        <translation>Il nomme le fichier du scénario, qui n&apos;a pas les corps tels qu&apos;ils sont ici. Enregistrez aussi le scénario : alors seulement l&apos;enregistrement pourra être rejoué.</translation>
    </message>
    <message>
        <source>A recording was left</source>
        <translation>Un enregistrement est resté</translation>
    </message>
    <message>
        <source>Glissade ended unexpectedly with a recording that was not saved. It is still there.</source>
        <translation>Glissade s&apos;est arrêté de façon inattendue avec un enregistrement non sauvegardé. Il est toujours là.</translation>
    </message>
    <message>
        <source>&amp;Save...</source>
        <translation>&amp;Enregistrer...</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Plus tard</translation>
    </message>
    <message>
        <source>Saving the recording</source>
        <translation>Sauvegarde de l&apos;enregistrement</translation>
    </message>
    <message>
        <source>The recording is damaged</source>
        <translation>L&apos;enregistrement est endommagé</translation>
    </message>
</context>
<context>
    <name>glissade::RefusalController</name>
    <message>
        <source>&apos;%1&apos;: overlap %2</source>
        <translation>« %1 » : recouvrement %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: touches or overlaps</source>
        <translation>« %1 » : touche ou recouvre</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: %2 away, required %3</source>
        <translation>« %1 » : à %2, exigé %3</translation>
    </message>
    <message>
        <source>The run ended without a path.</source>
        <translation>Le calcul s&apos;est terminé sans chemin.</translation>
    </message>
    <message>
        <source>The start is refused.</source>
        <translation>Le départ est refusé.</translation>
    </message>
    <message>
        <source>The goal is refused.</source>
        <translation>Le but est refusé.</translation>
    </message>
    <message>
        <source>The path does not hold here.</source>
        <translation>Le chemin ne tient pas ici.</translation>
    </message>
    <message>
        <source>%1 of %2 edges are blocked.</source>
        <translation>%1 arêtes sur %2 sont bloquées.</translation>
    </message>
    <message>
        <source>The first is blocked by &apos;%1&apos;.</source>
        <translation>La première est bloquée par « %1 ».</translation>
    </message>
    <message>
        <source>Its ends are not the start and the goal.</source>
        <translation>Ses extrémités ne sont pas le départ et le but.</translation>
    </message>
    <message>
        <source>Start and goal are allowed now. Press Start (F5).</source>
        <translation>Le départ et le but sont admis maintenant. Appuyer sur Démarrer (F5).</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 autres</translation>
    </message>
    <message>
        <source>The start is refused: &apos;%1&apos; overlaps or touches what is there.</source>
        <translation>Le départ est refusé : « %1 » recouvre ou touche d&apos;autres corps.</translation>
    </message>
    <message>
        <source>The start is refused: &apos;%1&apos; is nearer than the required clearance.</source>
        <translation>Le départ est refusé : « %1 » est plus près que le jeu exigé.</translation>
    </message>
    <message>
        <source>The goal is refused: &apos;%1&apos; overlaps or touches what is there.</source>
        <translation>Le but est refusé : « %1 » recouvre ou touche d&apos;autres corps.</translation>
    </message>
    <message>
        <source>The goal is refused: &apos;%1&apos; is nearer than the required clearance.</source>
        <translation>Le but est refusé : « %1 » est plus près que le jeu exigé.</translation>
    </message>
    <message>
        <source>Allow as fits</source>
        <translation>Admettre comme ajustements</translation>
    </message>
    <message>
        <source>This cannot be allowed as a fit</source>
        <translation>Cela ne peut pas être admis comme ajustement</translation>
    </message>
</context>
<context>
    <name>glissade::ReplayBar</name>
    <message>
        <source>Replay</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>RELECTURE</translation>
    </message>
    <message>
        <source>What you see was recorded: nothing can be steered until the replay is closed</source>
        <translation>Ce que vous voyez a été enregistré : rien ne peut être piloté avant de fermer la relecture</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>Times the pace of the recorded run</source>
        <translation>Fois l&apos;allure du calcul enregistré</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Vitesse de la relecture</translation>
    </message>
    <message>
        <source>Step of the run</source>
        <translation>Pas du calcul</translation>
    </message>
</context>
<context>
    <name>glissade::ReplayController</name>
    <message>
        <source>replaying...</source>
        <translation>relecture en cours...</translation>
    </message>
    <message>
        <source>The run is being replayed</source>
        <translation>Le calcul est en train d&apos;être rejoué</translation>
    </message>
    <message>
        <source>replaying... %1 %</source>
        <translation>relecture en cours... %1 %</translation>
    </message>
    <message>
        <source>other parameters</source>
        <translation>autres paramètres</translation>
    </message>
    <message>
        <source>Other parameters: solved, %1 nodes (recorded: %2)</source>
        <translation>Autres paramètres : résolu, %1 nœuds (enregistré : %2)</translation>
    </message>
    <message>
        <source>Other parameters: no path, %1 nodes (recorded: %2)</source>
        <translation>Autres paramètres : pas de chemin, %1 nœuds (enregistré : %2)</translation>
    </message>
    <message>
        <source>≠ recorded</source>
        <translation>≠ enregistré</translation>
    </message>
    <message>
        <source>Differs from the recording: the same until step %1, not at step %2</source>
        <translation>Diffère de l&apos;enregistrement : identique jusqu&apos;au pas %1, plus au pas %2</translation>
    </message>
    <message>
        <source>✓ as recorded</source>
        <translation>✓ tel qu&apos;enregistré</translation>
    </message>
    <message>
        <source>Same roadmap as recorded: %1 nodes</source>
        <translation>Même graphe qu&apos;enregistré : %1 nœuds</translation>
    </message>
    <message>
        <source>Replay. %1</source>
        <translation>Relecture. %1</translation>
    </message>
    <message>
        <source>No journal of this run on disk: %1</source>
        <translation>Pas de journal de ce calcul sur le disque : %1</translation>
    </message>
    <message>
        <source>The recording cannot be replayed</source>
        <translation>L&apos;enregistrement ne peut pas être rejoué</translation>
    </message>
</context>
<context>
    <name>glissade::ResponseCurve</name>
    <message>
        <source>How the device&apos;s deflection (across) is answered (up); the dot is where it is now</source>
        <translation>La réponse (vers le haut) au débattement du périphérique (en travers) ; le point indique la position actuelle</translation>
    </message>
</context>
<context>
    <name>glissade::RulesDialog</name>
    <message>
        <source>f: what a border costs where places a and b meet. Known: %1</source>
        <translation>f : ce que coûte une frontière où les lieux a et b se rencontrent. Connus : %1</translation>
    </message>
    <message>
        <source>g: what a way across a place costs. Known: %1</source>
        <translation>g : ce que coûte un trajet à travers un lieu. Connus : %1</translation>
    </message>
    <message>
        <source>When a step fails, try the &amp;next best way</source>
        <translation>Quand une étape échoue, essayer le &amp;meilleur trajet suivant</translation>
    </message>
    <message>
        <source>&amp;Cross passages as the object fits best</source>
        <translation>Traverser les &amp;passages comme l&apos;objet y entre le mieux</translation>
    </message>
    <message>
        <source>Rules of the strategy</source>
        <translation>Règles de la stratégie</translation>
    </message>
    <message>
        <source>&amp;Borders: f =</source>
        <translation>&amp;Frontières : f =</translation>
    </message>
    <message>
        <source>&amp;Ways: g =</source>
        <translation>&amp;Trajets : g =</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attributs</translation>
    </message>
    <message>
        <source>&amp;Planners: the first row that holds decides; the last must always hold (1).</source>
        <translation>P&amp;lanificateurs : la première ligne vraie décide ; la dernière doit l&apos;être toujours (1).</translation>
    </message>
    <message>
        <source>&amp;Use as own rules</source>
        <translation>&amp;Utiliser comme règles propres</translation>
    </message>
    <message>
        <source>Own rules</source>
        <translation>Règles propres</translation>
    </message>
    <message>
        <source>Read a strategy of the paper, or ours, and begin with it</source>
        <translation>Lire une stratégie de l&apos;article, ou la nôtre, et en partir</translation>
    </message>
    <message>
        <source>Be&amp;gin with</source>
        <translation>&amp;Partir de</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>In a region</source>
        <translation>Dans une région</translation>
    </message>
    <message>
        <source>Local planner</source>
        <translation>Planificateur local</translation>
    </message>
    <message>
        <source>The geometrical planner first finds cells that the local planner stays in</source>
        <translation>Le planificateur géométrique trouve d&apos;abord des cellules où reste le planificateur local</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Ajouter</translation>
    </message>
    <message>
        <source>A rule before the current one</source>
        <translation>Une règle avant la règle courante</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>The current rule</source>
        <translation>La règle courante</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>Mon&amp;ter</translation>
    </message>
    <message>
        <source>The current rule is asked earlier</source>
        <translation>La règle courante est demandée plus tôt</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>Des&amp;cendre</translation>
    </message>
    <message>
        <source>The current rule is asked later</source>
        <translation>La règle courante est demandée plus tard</translation>
    </message>
    <message>
        <source>of places (place., a., b.): %1; of the object (object.): %2</source>
        <translation>des lieux (place., a., b.) : %1 ; de l&apos;objet (object.) : %2</translation>
    </message>
    <message>
        <source>Rules of the fine planners</source>
        <translation>Règles des planificateurs fins</translation>
    </message>
</context>
<context>
    <name>glissade::RunController</name>
    <message>
        <source>No scenario is open.</source>
        <translation>Aucun scénario n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>Change the rules</source>
        <translation>Changer les règles</translation>
    </message>
    <message>
        <source>The rules cannot be changed</source>
        <translation>Les règles ne peuvent pas être changées</translation>
    </message>
</context>
<context>
    <name>glissade::SaveController</name>
    <message>
        <source>Edits are not saved automatically</source>
        <translation>Les modifications ne sont pas enregistrées automatiquement</translation>
    </message>
    <message>
        <source>The earlier version cannot be opened</source>
        <translation>La version antérieure ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>The edits cannot be opened</source>
        <translation>Les modifications ne peuvent pas être ouvertes</translation>
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
    <message>
        <source>%1: drawn while the box is checked</source>
        <translation>%1 : dessiné tant que la case est cochée</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Within about %1 of the part&apos;s surface</source>
        <translation>À environ %1 près de la surface de la pièce</translation>
    </message>
</context>
<context>
    <name>glissade::SectionPanel</name>
    <message>
        <source>Sections cut obstacles open. The object that moves stays whole.</source>
        <translation>Les coupes ouvrent les obstacles. L&apos;objet mobile reste entier.</translation>
    </message>
    <message>
        <source>Cut obstacles open across %1</source>
        <translation>Ouvrir les obstacles par une coupe à travers %1</translation>
    </message>
    <message>
        <source>Place of the section across %1</source>
        <translation>Position de la coupe à travers %1</translation>
    </message>
    <message>
        <source>Show the other side of the section across %1</source>
        <translation>Montrer l&apos;autre côté de la coupe à travers %1</translation>
    </message>
</context>
<context>
    <name>glissade::SemanticDocument</name>
    <message>
        <source>Set %1</source>
        <translation>Définir %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Réinitialiser %1</translation>
    </message>
    <message>
        <source>Rename place</source>
        <translation>Renommer le lieu</translation>
    </message>
    <message>
        <source>Add attribute %1</source>
        <translation>Ajouter l&apos;attribut %1</translation>
    </message>
    <message>
        <source>Rename attribute</source>
        <translation>Renommer l&apos;attribut</translation>
    </message>
    <message>
        <source>Remove attribute %1</source>
        <translation>Supprimer l&apos;attribut %1</translation>
    </message>
    <message>
        <source>Move milestone</source>
        <translation>Déplacer le jalon</translation>
    </message>
    <message>
        <source>Reset milestone</source>
        <translation>Réinitialiser le jalon</translation>
    </message>
    <message>
        <source>Remove edits without effect</source>
        <translation>Supprimer les modifications sans effet</translation>
    </message>
</context>
<context>
    <name>glissade::SemanticsPanel</name>
    <message>
        <source>Filter by name or value</source>
        <translation>Filtrer par nom ou valeur</translation>
    </message>
    <message>
        <source>Rename the attribute</source>
        <translation>Renommer l&apos;attribut</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>Nouveau nom</translation>
    </message>
    <message>
        <source>How the places are found</source>
        <translation>Comment les lieux sont trouvés</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>%1 And %2 more.</source>
        <translation>%1 Et %2 autres.</translation>
    </message>
    <message>
        <source>Attributes of the selection</source>
        <translation>Attributs de la sélection</translation>
    </message>
    <message>
        <source>Places and bodies</source>
        <translation>Lieux et corps</translation>
    </message>
</context>
<context>
    <name>glissade::SemanticsTree</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Complexity</source>
        <translation>Complexité</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Places (not looked for yet)</source>
        <translation>Lieux (pas encore cherchés)</translation>
    </message>
    <message>
        <source>Places (%1)</source>
        <translation>Lieux (%1)</translation>
    </message>
    <message>
        <source>Cluttered by mobile bodies</source>
        <translation>Encombré par des corps mobiles</translation>
    </message>
    <message>
        <source>Bodies (%1)</source>
        <translation>Corps (%1)</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>déplacé</translation>
    </message>
    <message>
        <source>Forbidden: no path leads through</source>
        <translation>Interdit : aucun trajet n&apos;y passe</translation>
    </message>
    <message>
        <source>Preferred: ways through count %1 times shorter</source>
        <translation>Préféré : les trajets par ce lieu comptent %1 fois moins longs</translation>
    </message>
    <message>
        <source>Mobility</source>
        <translation>Mobilité</translation>
    </message>
</context>
<context>
    <name>glissade::StudyBrowser</name>
    <message>
        <source>Holds</source>
        <translation>Tient</translation>
    </message>
    <message>
        <source>Does not hold</source>
        <translation>Ne tient pas</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>En suspens</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Ending</source>
        <translation>Issue</translation>
    </message>
    <message>
        <source>Virtual s</source>
        <translation>s virtuelles</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléat.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>&amp;Show this run</source>
        <translation>&amp;Montrer cet essai</translation>
    </message>
    <message>
        <source>Open the scenario with the strategy, operator, parameters and seed of the chosen run, and run it</source>
        <translation>Ouvrir le scénario avec la stratégie, l&apos;opérateur, les paramètres et la graine de l&apos;essai choisi, et le lancer</translation>
    </message>
    <message>
        <source>%1 — study</source>
        <translation>%1 — étude</translation>
    </message>
    <message>
        <source>Double-click a run to see it again, from its seed.</source>
        <translation>Double-cliquez sur un essai pour le revoir, à partir de sa graine.</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Résolus</translation>
    </message>
    <message>
        <source>Success, 95 %</source>
        <translation>Succès, 95 %</translation>
    </message>
    <message>
        <source>%1, paper</source>
        <translation>%1, article</translation>
    </message>
    <message>
        <source>%1, ours</source>
        <translation>%1, Glissade</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 paires sur %2</translation>
    </message>
    <message>
        <source>The study declares no findings.</source>
        <translation>L&apos;étude n&apos;énonce pas de constats.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Cells of the study</source>
        <translation>Cellules de l&apos;étude</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Runs of the cell</source>
        <translation>Essais de la cellule</translation>
    </message>
</context>
<context>
    <name>glissade::StudyController</name>
    <message>
        <source>Open the results of a study</source>
        <translation>Ouvrir les résultats d&apos;une étude</translation>
    </message>
    <message>
        <source>The study cannot be opened</source>
        <translation>L&apos;étude ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>Documents (*.pdf)</source>
        <translation>Documents (*.pdf)</translation>
    </message>
    <message>
        <source>The report cannot be written</source>
        <translation>Le rapport ne peut pas être écrit</translation>
    </message>
    <message>
        <source>The run cannot be shown</source>
        <translation>L&apos;essai ne peut pas être montré</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of runs could not be read and are left out.</source>
        <translation>
            <numerusform>%n fichier d&apos;essai n&apos;a pas pu être lu et est laissé de côté.</numerusform>
            <numerusform>%n fichiers d&apos;essais n&apos;ont pas pu être lus et sont laissés de côté.</numerusform>
        </translation>
    </message>
    <message>
        <source>Seed %1 is running in the main window.</source>
        <translation>La graine %1 tourne dans la fenêtre principale.</translation>
    </message>
    <message>
        <source>Seed %1 ended as in the study: %2 nodes.</source>
        <translation>La graine %1 a fini comme dans l&apos;étude : %2 nœuds.</translation>
    </message>
    <message>
        <source>Seed %1 ended otherwise than in the study: with %2 nodes. Is this another version?</source>
        <translation>La graine %1 a fini autrement que dans l&apos;étude : avec %2 nœuds. Est-ce une autre version ?</translation>
    </message>
    <message>
        <source>Reading the study</source>
        <translation>Lecture de l&apos;étude</translation>
    </message>
    <message>
        <source>Save the plot</source>
        <translation>Enregistrer la courbe</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>Dessins (*.svg);;Images (*.png)</translation>
    </message>
    <message>
        <source>The plot cannot be saved</source>
        <translation>La courbe ne peut pas être enregistrée</translation>
    </message>
    <message>
        <source>The file was saved, with a warning</source>
        <translation>Le fichier a été enregistré, avec un avertissement</translation>
    </message>
</context>
<context>
    <name>glissade::ViewCube</name>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>View cube</source>
        <translation>Cube de vue</translation>
    </message>
    <message>
        <source>Arrow keys go round the scene, Home looks from a corner</source>
        <translation>Les flèches tournent autour de la scène, Début regarde depuis un coin</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there. Arrow keys go round, Home looks from a corner.</source>
        <translation>Cliquer une face, une arête ou un coin pour regarder de là. Les flèches tournent autour, Début regarde depuis un coin.</translation>
    </message>
</context>
<context>
    <name>glissade::WorkController</name>
    <message>
        <source>Smoothing the path</source>
        <translation>Lissage du chemin</translation>
    </message>
    <message>
        <source>Examining the path</source>
        <translation>Examen du chemin</translation>
    </message>
    <message>
        <source>%1: cancelled after %2 s</source>
        <translation>%1 : annulé après %2 s</translation>
    </message>
    <message>
        <source>%1: ended after %2 s</source>
        <translation>%1 : terminé après %2 s</translation>
    </message>
</context>
<context>
    <name>glissade::WorkbenchDocument</name>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>le départ</translation>
    </message>
    <message>
        <source>the goal</source>
        <translation>le but</translation>
    </message>
    <message>
        <source>Path %1</source>
        <translation>Chemin %1</translation>
    </message>
</context>
<context>
    <name>glissade::SequenceController</name>
    <message>
        <source>The film was cancelled</source>
        <translation>Le film a été annulé</translation>
    </message>
    <message>
        <source>The sequence cannot be planned</source>
        <translation>La séquence ne peut pas être planifiée</translation>
    </message>
    <message>
        <source>Planning the sequence</source>
        <translation>Planification de la séquence</translation>
    </message>
    <message>
        <source>The bodies cannot be marked</source>
        <translation>Les corps ne peuvent pas être marqués</translation>
    </message>
    <message>
        <source>Open an assembly plan of this product</source>
        <translation>Ouvrir un plan d&apos;assemblage de ce produit</translation>
    </message>
    <message>
        <source>Assembly plans (*.json);;All files (*)</source>
        <translation>Plans d&apos;assemblage (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The assembly plan cannot be opened</source>
        <translation>Le plan d&apos;assemblage ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Save the assembly plan</source>
        <translation>Enregistrer le plan d&apos;assemblage</translation>
    </message>
    <message>
        <source>Assembly plan (*.json);;Work instruction (*.html);;Work instruction (*.pdf);;Table of steps (*.csv);;Animation (*.glb)</source>
        <translation>Plan d&apos;assemblage (*.json);;Gamme de montage (*.html);;Gamme de montage (*.pdf);;Table des étapes (*.csv);;Animation (*.glb)</translation>
    </message>
    <message>
        <source>The assembly plan cannot be saved</source>
        <translation>Le plan d&apos;assemblage ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>The assembly plan was saved as %1</source>
        <translation>Le plan d&apos;assemblage a été enregistré dans %1</translation>
    </message>
    <message>
        <source>Demands of the sequence that is opened</source>
        <translation>Exigences de la séquence ouverte</translation>
    </message>
</context>
<context>
    <name>glissade::SequencePanel</name>
    <message>
        <source>Place in the sequence</source>
        <translation>Position dans la séquence</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Vue éclatée</translation>
    </message>
    <message>
        <source>Moves the parts apart along the directions in which they leave</source>
        <translation>Écarte les pièces dans les directions par lesquelles elles sortent</translation>
    </message>
    <message>
        <source>E&amp;xplode</source>
        <translation>É&amp;claté</translation>
    </message>
    <message>
        <source>No product is open.</source>
        <translation>Aucun produit n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>Not planned yet.</source>
        <translation>Pas encore planifié.</translation>
    </message>
    <message>
        <source>%1 of %2 parts leave, every motion certified.</source>
        <translation>%1 pièces sur %2 sortent, chaque mouvement est certifié.</translation>
    </message>
    <message>
        <source>%1 stays.</source>
        <translation>Reste : %1.</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>%1 stuck.</source>
        <translation>%1 bloquées.</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>Arrêté avant la fin.</translation>
    </message>
    <message>
        <source>%1 steps do not hold here.</source>
        <translation>%1 étapes ne tiennent pas ici.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>&amp;Demands</source>
        <translation>&amp;Exigences</translation>
    </message>
    <message>
        <source>Forbid a &amp;direction</source>
        <translation>Interdire une &amp;direction</translation>
    </message>
    <message>
        <source>Ste&amp;p</source>
        <translation>Éta&amp;pe</translation>
    </message>
    <message>
        <source>Move, lock or free the chosen step, or move its part by hand</source>
        <translation>Déplacer, verrouiller ou libérer l&apos;étape choisie, ou déplacer sa pièce à la main</translation>
    </message>
    <message>
        <source>&amp;Cost</source>
        <translation>&amp;Coût</translation>
    </message>
    <message>
        <source>What a step costs</source>
        <translation>Ce que coûte une étape</translation>
    </message>
    <message>
        <source>The order that costs least is chosen. An expression, as 5 * tool_change + length, or one of the list; &quot;as found&quot;: the order in which the parts were found to leave</source>
        <translation>L&apos;ordre le moins coûteux est choisi. Une expression, comme 5 * tool_change + length, ou une de la liste ; « tel que trouvé » : l&apos;ordre dans lequel les sorties ont été trouvées</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>tel que trouvé</translation>
    </message>
    <message>
        <source>%1 forced.</source>
        <translation>%1 forcées.</translation>
    </message>
    <message>
        <source>The time limit was reached.</source>
        <translation>La limite de temps a été atteinte.</translation>
    </message>
</context>
<context>
    <name>glissade::StepTable</name>
    <message>
        <source>certified</source>
        <translation>certifiée</translation>
    </message>
    <message>
        <source>✓ proved</source>
        <translation>✓ prouvée</translation>
    </message>
    <message>
        <source>✗ not here</source>
        <translation>✗ pas ici</translation>
    </message>
    <message>
        <source>certified when it was found</source>
        <translation>certifiée quand elle a été trouvée</translation>
    </message>
    <message>
        <source>proved again by the independent check</source>
        <translation>prouvée de nouveau par la vérification indépendante</translation>
    </message>
    <message>
        <source>does not hold in this arrangement</source>
        <translation>ne tient pas dans cette disposition</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillée</translation>
    </message>
    <message>
        <source>placed</source>
        <translation>placée</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Équilibre</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Above: smallest distance to other parts. Below: the largest allowance of the step; its tool tip lists all</source>
        <translation>En haut : la plus petite distance aux autres pièces. En bas : la plus grande tolérance de l&apos;étape ; son infobulle les énumère toutes</translation>
    </message>
    <message>
        <source>Above: the tool that turns the fastener, and what it cannot be brought past. Below: parts that would tip or fall, or what a forced step does not keep</source>
        <translation>En haut : l&apos;outil qui tourne la fixation, et ce devant quoi il ne passe pas. En bas : les pièces qui basculeraient ou tomberaient, ou ce qu&apos;une étape forcée ne respecte pas</translation>
    </message>
    <message>
        <source>Above: whether the motion is proved. Below: what a person has done to the step, or the seconds after which it was found</source>
        <translation>En haut : si le mouvement est prouvé. En bas : ce qu&apos;une personne a fait de l&apos;étape, ou les secondes après lesquelles elle a été trouvée</translation>
    </message>
    <message>
        <source>Steps of the sequence</source>
        <translation>Étapes de la séquence</translation>
    </message>
    <message>
        <source>proved %1; smallest %2 to %3</source>
        <translation>prouvé %1 ; le plus petit %2 à %3</translation>
    </message>
    <message>
        <source>forced: %1</source>
        <translation>forcée : %1</translation>
    </message>
    <message>
        <source>found by %1</source>
        <translation>trouvée par %1</translation>
    </message>
    <message>
        <source>found after %1</source>
        <translation>trouvée après %1</translation>
    </message>
    <message>
        <source>no motion found</source>
        <translation>aucun mouvement trouvé</translation>
    </message>
    <message>
        <source>blocked by %1</source>
        <translation>bloquée par %1</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>bloquée</translation>
    </message>
</context>
<context>
    <name>glissade::SequenceEdits</name>
    <message>
        <source>Cost of steps</source>
        <translation>Coût des étapes</translation>
    </message>
    <message>
        <source>The sequence cannot be planned so</source>
        <translation>La séquence ne peut pas être planifiée ainsi</translation>
    </message>
    <message>
        <source>%1 as step %2</source>
        <translation>%1 comme étape %2</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Verrouiller %1</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Déverrouiller %1</translation>
    </message>
    <message>
        <source>%1 not %2</source>
        <translation>%1 pas %2</translation>
    </message>
    <message>
        <source>Forbid the way of %1</source>
        <translation>Interdire la sortie de %1</translation>
    </message>
    <message>
        <source>Keep the order of %1</source>
        <translation>Garder l&apos;ordre de %1</translation>
    </message>
    <message>
        <source>No demands on %1</source>
        <translation>Aucune exigence sur %1</translation>
    </message>
    <message>
        <source>Remove: %1</source>
        <translation>Retirer : %1</translation>
    </message>
    <message>
        <source>%1 is locked as step %2 of removal</source>
        <translation>%1 est verrouillée comme étape %2 du démontage</translation>
    </message>
    <message>
        <source>%1 leaves as step %2</source>
        <translation>%1 sort comme étape %2</translation>
    </message>
    <message>
        <source>%1 leaves by the motion by hand</source>
        <translation>%1 sort par le mouvement à la main</translation>
    </message>
    <message>
        <source>%1 keeps its motion</source>
        <translation>%1 garde son mouvement</translation>
    </message>
    <message>
        <source>%1 does not leave %2</source>
        <translation>%1 ne sort pas %2</translation>
    </message>
    <message>
        <source>%1 leaves before %2</source>
        <translation>%1 sort avant %2</translation>
    </message>
    <message>
        <source>%1 leave as one</source>
        <translation>%1 sortent ensemble</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
</context>
<context>
    <name>glissade::SequenceHand</name>
    <message>
        <source>The step cannot be moved by hand</source>
        <translation>L&apos;étape ne peut pas être faite à la main</translation>
    </message>
    <message>
        <source>Move %1 by hand</source>
        <translation>Déplacer %1 à la main</translation>
    </message>
    <message>
        <source>%1 is in your hand, among the parts that are there at its step. Start (F5) begins a run. Its certified path becomes the step.</source>
        <translation>%1 est dans votre main, parmi les pièces présentes à son étape. Démarrer (F5) commence une recherche. Son chemin certifié devient l&apos;étape.</translation>
    </message>
    <message>
        <source>%1 by hand</source>
        <translation>%1 à la main</translation>
    </message>
    <message>
        <source>The path by hand is the motion of %1.</source>
        <translation>Le chemin à la main est le mouvement de %1.</translation>
    </message>
</context>
<context>
    <name>glissade::PlanGraphView</name>
    <message>
        <source>Order of the steps</source>
        <translation>Ordre des étapes</translation>
    </message>
    <message>
        <source>An arrow leads from a step to each step that it makes way for</source>
        <translation>Une flèche mène d&apos;une étape à chaque étape à laquelle elle fait place</translation>
    </message>
</context>
<context>
    <name>glissade::InstructionJob</name>
    <message>
        <source>Checking the steps and choosing the views</source>
        <translation>Vérification des étapes et choix des points de vue</translation>
    </message>
    <message>
        <source>Writing the work instruction</source>
        <translation>Écriture de la gamme de montage</translation>
    </message>
</context>
<context>
    <name>glissade::SweepController</name>
    <message>
        <source>The swept volume cannot be computed</source>
        <translation>Le volume balayé ne peut pas être calculé</translation>
    </message>
    <message>
        <source>Computing the swept volume</source>
        <translation>Calcul du volume balayé</translation>
    </message>
    <message>
        <source>Swept volume: %1 %2; its surface is at most %3 away from the object</source>
        <translation>Volume balayé : %1 %2 ; sa surface est à %3 de l&apos;objet au plus</translation>
    </message>
    <message>
        <source>; within it or at its surface: %1</source>
        <translation> ; à l&apos;intérieur ou à sa surface : %1</translation>
    </message>
    <message>
        <source>Export the swept volume</source>
        <translation>Exporter le volume balayé</translation>
    </message>
    <message>
        <source>Triangles in millimetres (%1);;3D viewers (%2)</source>
        <translation>Triangles en millimètres (%1);;Visionneuses 3D (%2)</translation>
    </message>
    <message>
        <source>The swept volume was not saved</source>
        <translation>Le volume balayé n&apos;a pas été enregistré</translation>
    </message>
    <message>
        <source>The swept volume was saved as %1</source>
        <translation>Le volume balayé a été enregistré sous %1</translation>
    </message>
    <message>
        <source>The swept volume was saved, with a warning</source>
        <translation>Le volume balayé a été enregistré, avec un avertissement</translation>
    </message>
</context>
<context>
    <name>glissade::ShortcutsDialog</name>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Attribuer</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>Par &amp;défaut</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Part of a command or of a shortcut</source>
        <translation>Partie d&apos;une commande ou d&apos;un raccourci</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Nouveau raccourci</translation>
    </message>
    <message>
        <source>&amp;New shortcut</source>
        <translation>&amp;Nouveau raccourci</translation>
    </message>
    <message>
        <source>Choose a command.</source>
        <translation>Choisir une commande.</translation>
    </message>
    <message>
        <source>Bold shortcuts differ from the default.</source>
        <translation>Les raccourcis en gras diffèrent des raccourcis par défaut.</translation>
    </message>
    <message>
        <source>Keys without Ctrl or Alt steer the object and write text.</source>
        <translation>Les touches sans Ctrl ni Alt dirigent l&apos;objet et écrivent du texte.</translation>
    </message>
    <message>
        <source>It is taken from &quot;%1&quot;.</source>
        <translation>Il est retiré à « %1 ».</translation>
    </message>
</context>
<context>
    <name>glissade::PathReportJob</name>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
    </message>
</context>
<context>
    <name>Arranging</name>
    <message>
        <source>the start</source>
        <translation>le départ</translation>
    </message>
    <message>
        <source>the goal</source>
        <translation>le but</translation>
    </message>
    <message>
        <source>on the axis of %1</source>
        <translation>sur l&apos;axe de %1</translation>
    </message>
    <message>
        <source>on the face of %1</source>
        <translation>sur la face de %1</translation>
    </message>
    <message>
        <source>level with the face of %1</source>
        <translation>au niveau de la face de %1</translation>
    </message>
</context>
<context>
    <name>glissade::ArrangeBar</name>
    <message>
        <source>Arranging</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Step of distances</source>
        <translation>Pas des distances</translation>
    </message>
    <message>
        <source>Step of angles</source>
        <translation>Pas des angles</translation>
    </message>
    <message>
        <source>End arranging (Esc)</source>
        <translation>Terminer la disposition (Échap)</translation>
    </message>
    <message>
        <source>End arranging</source>
        <translation>Terminer la disposition</translation>
    </message>
    <message>
        <source>%1, in any unit: 25.4 mm, 1 in, 30 deg</source>
        <translation>%1, dans n&apos;importe quelle unité : 25,4 mm, 1 in, 30 deg</translation>
    </message>
    <message>
        <source>“%1” is no step. Write 10, 25.4 mm, 1 in or 30 deg.</source>
        <translation>« %1 » n&apos;est pas un pas. Écrire 10, 25,4 mm, 1 in ou 30 deg.</translation>
    </message>
    <message>
        <source>Arranging: click a body, the start or the goal</source>
        <translation>Disposition : cliquer un corps, le départ ou le but</translation>
    </message>
    <message>
        <source>Arranging %1</source>
        <translation>Disposition : %1</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; Ctrl suspends snapping. Drag the body itself, with Ctrl to turn it. Arrow keys and Page Up/Down move by a step, with Shift they turn. Esc ends arranging.</source>
        <translation>Tirer une flèche, un carré ou un anneau ; Ctrl suspend l&apos;accrochage. Tirer le corps lui-même, avec Ctrl pour le tourner. Les flèches du clavier et Page préc./suiv. déplacent d&apos;un pas, avec Maj elles tournent. Échap termine.</translation>
    </message>
    <message>
        <source>To faces</source>
        <translation>Aux faces</translation>
    </message>
    <message>
        <source>Snapped: %1. Ctrl suspends snapping.</source>
        <translation>Accroché : %1. Ctrl suspend l&apos;accrochage.</translation>
    </message>
</context>
<context>
    <name>glissade::ArrangeController</name>
    <message>
        <source>%1 is aligned. %2 turns it round.</source>
        <translation>%1 : aligné. %2 le retourne.</translation>
    </message>
    <message>
        <source>%1 is aligned.</source>
        <translation>%1 : aligné.</translation>
    </message>
</context>
<context>
    <name>glissade::WorkspaceNotice</name>
    <message>
        <source>%1 is outside of the workspace now.</source>
        <translation>%1 est maintenant hors de l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>The start is outside of the workspace now.</source>
        <translation>Le départ est maintenant hors de l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>The goal is outside of the workspace now.</source>
        <translation>Le but est maintenant hors de l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>The object does not get there. Undo, or fit the workspace.</source>
        <translation>L&apos;objet n&apos;y va pas. Annuler, ou ajuster l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>A run is refused there. Undo, or fit the workspace.</source>
        <translation>Un calcul y est refusé. Annuler, ou ajuster l&apos;espace de travail.</translation>
    </message>
</context>
<context>
    <name>ManualTables</name>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Ce qu&apos;elle fait</translation>
    </message>
    <message>
        <source>In scripts</source>
        <translation>Dans les scripts</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>During a run</source>
        <translation>Pendant un calcul</translation>
    </message>
    <message>
        <source>In files</source>
        <translation>Dans les fichiers</translation>
    </message>
    <message>
        <source>In files, on the command line</source>
        <translation>Dans les fichiers, sur la ligne de commande</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>place</source>
        <translation>lieu</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>In files and rules</source>
        <translation>Dans les fichiers et les règles</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Ending</source>
        <translation>Terminaison</translation>
    </message>
    <message>
        <source>Can be read again</source>
        <translation>Peut être relu</translation>
    </message>
</context>
<context>
    <name>ManualWriter</name>
    <message>
        <source>Glissade manual</source>
        <translation>Manuel de Glissade</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
</context>
<context>
    <name>glissade::ManualView</name>
    <message>
        <source>Page of the manual</source>
        <translation>Page du manuel</translation>
    </message>
</context>
<context>
    <name>glissade::ManualBrowser</name>
    <message>
        <source>Glissade manual</source>
        <translation>Manuel de Glissade</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>The page before</source>
        <translation>La page précédente</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Avancer</translation>
    </message>
    <message>
        <source>The page after it</source>
        <translation>La page suivante</translation>
    </message>
    <message>
        <source>A−</source>
        <translation>A−</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Texte plus petit</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Texte plus grand</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>The place before</source>
        <translation>L&apos;endroit précédent</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>The next place</source>
        <translation>L&apos;endroit suivant</translation>
    </message>
    <message>
        <source>In the browser</source>
        <translation>Dans le navigateur</translation>
    </message>
    <message>
        <source>Open the page on the disk with the web browser</source>
        <translation>Ouvrir la page du disque avec le navigateur web</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>The manual does not have this text.</source>
        <translation>Le manuel ne contient pas ce texte.</translation>
    </message>
</context>
<context>
    <name>glissade::ManualController</name>
    <message>
        <source>The manual cannot be shown</source>
        <translation>Le manuel ne peut pas être montré</translation>
    </message>
</context>
<context>
    <name>glissade::RunCurves</name>
    <message>
        <source>Nodes, authority and clearance over the time of planning</source>
        <translation>Nœuds, autorité et jeu au cours du temps de planification</translation>
    </message>
    <message>
        <source>Nodes of the roadmap, the computer&apos;s share α, and the distance of the object in the operator&apos;s hand to the nearest obstacle, over the time of planning</source>
        <translation>Nœuds du graphe, part α de l&apos;ordinateur, et distance de l&apos;objet tenu par l&apos;opérateur à l&apos;obstacle le plus proche, au cours du temps de planification</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Authority α</source>
        <translation>Autorité α</translation>
    </message>
    <message>
        <source>Distance to the nearest obstacle</source>
        <translation>Distance à l&apos;obstacle le plus proche</translation>
    </message>
    <message>
        <source>in collision</source>
        <translation>en collision</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
</context>
<context>
    <name>glissade::BusyBar</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>glissade::ColourButton</name>
    <message>
        <source>As the theme</source>
        <translation>Comme le thème</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Four bodies</source>
        <translation>Quatre corps</translation>
    </message>
    <message>
        <source>A flat world in the manner of Cailhol et al. 2019</source>
        <translation>Un monde plat à la manière de Cailhol et al. 2019</translation>
    </message>
    <message>
        <source>Environment 1</source>
        <translation>Environnement 1</translation>
    </message>
    <message>
        <source>The cluttered environment of Blin et al. 2016 (figure 3)</source>
        <translation>L&apos;environnement encombré de Blin et al. 2016 (figure 3)</translation>
    </message>
    <message>
        <source>Roller stand</source>
        <translation>Support à rouleau</translation>
    </message>
    <message>
        <source>A roller on a shaft between two walls</source>
        <translation>Un rouleau sur un axe entre deux parois</translation>
    </message>
    <message>
        <source>Pump, unmounting</source>
        <translation>Pompe, démontage</translation>
    </message>
    <message>
        <source>The pump leaves its seat in the power-electronics frame</source>
        <translation>La pompe quitte son logement dans le châssis d&apos;électronique de puissance</translation>
    </message>
    <message>
        <source>Nut and bolt</source>
        <translation>Vis et écrou</translation>
    </message>
    <message>
        <source>A nut on its bolt, with modelled threads</source>
        <translation>Un écrou sur sa vis, aux filets modélisés</translation>
    </message>
    <message>
        <source>Shape game: star, tight</source>
        <translation>Jeu de formes : étoile, serré</translation>
    </message>
    <message>
        <source>The shape game of Cailhol et al. 2019 (figure 13)</source>
        <translation>Le jeu de formes de Cailhol et al. 2019 (figure 13)</translation>
    </message>
    <message>
        <source>Environment 2</source>
        <translation>Environnement 2</translation>
    </message>
    <message>
        <source>The very cluttered environment of Blin et al. 2016 (figure 11)</source>
        <translation>L&apos;environnement très encombré de Blin et al. 2016 (figure 11)</translation>
    </message>
    <message>
        <source>Interlocked: a turn</source>
        <translation>Imbriqués : un tour</translation>
    </message>
    <message>
        <source>A key whose bar lies across the slot of the cover</source>
        <translation>Une clé dont la barre est en travers de la fente du couvercle</translation>
    </message>
    <message>
        <source>Sliding plane</source>
        <translation>Plan de glissement</translation>
    </message>
    <message>
        <source>The L slides on a plane</source>
        <translation>Le L glisse sur un plan</translation>
    </message>
    <message>
        <source>Bolted brackets</source>
        <translation>Équerres boulonnées</translation>
    </message>
    <message>
        <source>Ten parts that touch, as CAD systems export them</source>
        <translation>Dix pièces qui se touchent, comme les systèmes de CAO les exportent</translation>
    </message>
</context>
<context>
    <name>glissade::WelcomeController</name>
    <message>
        <source>Not there</source>
        <translation>Absent</translation>
    </message>
</context>
<context>
    <name>glissade::WelcomePage</name>
    <message>
        <source>Welcome</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Make a scenario of your parts, open one, or drop files here: scenarios, STEP, meshes, URDF.</source>
        <translation>Faites un scénario de vos pièces, ouvrez-en un, ou déposez des fichiers ici : scénarios, STEP, maillages, URDF.</translation>
    </message>
</context>
<context>
    <name>glissade::ContextMenus</name>
    <message>
        <source>&amp;Display</source>
        <translation>&amp;Affichage</translation>
    </message>
</context>
<context>
    <name>glissade::TourController</name>
    <message>
        <source>This cannot be done</source>
        <translation>Cela ne peut pas se faire</translation>
    </message>
</context>
<context>
    <name>glissade::TourPanel</name>
    <message>
        <source>Do it for me</source>
        <translation>Le faire pour moi</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suite</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>End the tour (Esc)</source>
        <translation>Terminer la visite (Échap)</translation>
    </message>
    <message>
        <source>Tour: step %1 of %2</source>
        <translation>Visite : étape %1 sur %2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Fait</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Open a scenario</source>
        <translation>Ouvrir un scénario</translation>
    </message>
    <message>
        <source>Open the sample &quot;Four bodies&quot;: its card on the welcome page, or Open (Ctrl+O) and samples/teaching/scenario.json. The red box is to reach the ghost. A scenario holds bodies, the object that moves, its start and its goal.</source>
        <translation>Ouvrez l&apos;exemple « Quatre corps » : sa carte sur la page d&apos;accueil, ou Ouvrir (Ctrl+O) et samples/teaching/scenario.json. La boîte rouge doit atteindre le fantôme. Un scénario contient des corps, l&apos;objet qui bouge, son départ et son but.</translation>
    </message>
    <message>
        <source>See the places</source>
        <translation>Voir les lieux</translation>
    </message>
    <message>
        <source>Press F8 (View &gt; Layers &gt; Places). The free space is divided into places: the redder, the narrower; green ones are easy, yellow ones are cluttered by a mobile body. The blue line is the coarse path: the sequence of places that costs least.</source>
        <translation>Appuyez sur F8 (Vue &gt; Couches &gt; Lieux). L&apos;espace libre est divisé en lieux : plus ils sont rouges, plus ils sont étroits ; les verts sont faciles, les jaunes encombrés par un corps mobile. La ligne bleue est le chemin grossier : la suite de lieux qui coûte le moins.</translation>
    </message>
    <message>
        <source>Plan with topology</source>
        <translation>Planifier avec la topologie</translation>
    </message>
    <message>
        <source>Choose the strategy GT and press Start (F5). GT takes the shortest way through the places. It leads through the slot P6, which is too narrow, and the run ends there: the panel Plan says where and why.</source>
        <translation>Choisissez la stratégie GT et appuyez sur Démarrer (F5). GT prend le plus court passage par les lieux. Il traverse la fente P6, qui est trop étroite, et le calcul s&apos;y termine : le panneau Plan dit où et pourquoi.</translation>
    </message>
    <message>
        <source>Plan with semantics</source>
        <translation>Planifier avec la sémantique</translation>
    </message>
    <message>
        <source>Choose the strategy GTS and press Start (F5). GTS knows that the object does not fit through the slot and goes through P5. The path that it finds is proved free of penetration.</source>
        <translation>Choisissez la stratégie GTS et appuyez sur Démarrer (F5). GTS sait que l&apos;objet ne passe pas par la fente et va par P5. Il est prouvé que le chemin trouvé est sans pénétration.</translation>
    </message>
    <message>
        <source>Look at a step</source>
        <translation>Regarder une étape</translation>
    </message>
    <message>
        <source>Click a row of the table in the panel Plan (Alt+4). Each row is a step through one place, with the planner that found it. The scene marks the place of the step, and its attributes can be changed in the panel Semantics.</source>
        <translation>Cliquez une ligne du tableau du panneau Plan (Alt+4). Chaque ligne est une étape à travers un lieu, avec le planificateur qui l&apos;a trouvée. La scène marque le lieu de l&apos;étape, et ses attributs se changent dans le panneau Sémantique.</translation>
    </message>
    <message>
        <source>Open parts</source>
        <translation>Ouvrir des pièces</translation>
    </message>
    <message>
        <source>Plan the sequence</source>
        <translation>Planifier la séquence</translation>
    </message>
    <message>
        <source>Now parts. Open the sample &quot;Bolted brackets&quot; (samples/bolted-brackets): two brackets on a plate, with bolts, a rod and nuts. With parts of your own, begin with File &gt; New from parts (Ctrl+N): STEP, mesh or URDF files.</source>
        <translation>Maintenant des pièces. Ouvrez l&apos;exemple « Équerres boulonnées » (samples/bolted-brackets) : deux équerres sur une plaque, avec des vis, une tige et des écrous. Avec vos propres pièces, commencez par Fichier &gt; Nouveau à partir de pièces (Ctrl+N) : fichiers STEP, maillages ou URDF.</translation>
    </message>
    <message>
        <source>See the fits</source>
        <translation>Voir les ajustements</translation>
    </message>
    <message>
        <source>Choose Assembly &gt; Find fits (Ctrl+I). The parts touch, as most CAD parts do. The panel Fits lists the pairs, with gap and allowance: by so much the part that moves is taken thinner against the other one. A click on a row marks the two parts.</source>
        <translation>Choisissez Assemblage &gt; Chercher les ajustements (Ctrl+I). Les pièces se touchent, comme la plupart des pièces CAO. Le panneau Ajustements énumère les paires, avec écart et tolérance : d&apos;autant la pièce qui bouge est prise plus mince contre l&apos;autre. Un clic sur une ligne marque les deux pièces.</translation>
    </message>
    <message>
        <source>Take a part out</source>
        <translation>Sortir une pièce</translation>
    </message>
    <message>
        <source>Press Start (F5): the planner searches how the nut leaves the rod. The panel Path shows the clearance along the motion, the allowances, and plays it (Ctrl+P).</source>
        <translation>Appuyez sur Démarrer (F5) : le planificateur cherche comment l&apos;écrou quitte la tige. Le panneau Chemin montre le jeu le long du mouvement, les tolérances, et le joue (Ctrl+P).</translation>
    </message>
    <message>
        <source>Cut it open</source>
        <translation>Voir en coupe</translation>
    </message>
    <message>
        <source>Open the panel Section (Alt+7) and check Y: the plane cuts the bodies open, so that bolts, rod and holes are seen. The slider moves the plane.</source>
        <translation>Ouvrez le panneau Coupe (Alt+7) et cochez Y : le plan coupe les corps, et l&apos;on voit les vis, la tige et les trous. Le curseur déplace le plan.</translation>
    </message>
    <message>
        <source>Choose Assembly &gt; Plan the sequence (Ctrl+J): in which order do the parts leave? Each step has a motion that is proved. The rod leaves before the bolts, which have no room below it. A click on a row shows the step.</source>
        <translation>Choisissez Assemblage &gt; Planifier la séquence (Ctrl+J) : dans quel ordre les pièces partent-elles ? Chaque étape a un mouvement prouvé. La tige part avant les vis, qui n&apos;ont pas de place sous elle. Un clic sur une ligne montre l&apos;étape.</translation>
    </message>
    <message>
        <source>Write the instruction</source>
        <translation>Écrire la fiche d&apos;instructions</translation>
    </message>
    <message>
        <source>The slider Explode in the panel Sequence moves the parts apart. Choose Assembly &gt; Save the sequence (Ctrl+Alt+E) and a name that ends in .html or .pdf: a work instruction with a picture of each step. Shift+F1 explains anything in the window; Ctrl+K finds any command.</source>
        <translation>Le curseur Éclater du panneau Séquence écarte les pièces. Choisissez Assemblage &gt; Enregistrer la séquence (Ctrl+Alt+E) et un nom qui finit par .html ou .pdf : une fiche d&apos;instructions avec une image de chaque étape. Maj+F1 explique tout dans la fenêtre ; Ctrl+K trouve toute commande.</translation>
    </message>
</context>
<context>
    <name>ActionHelp</name>
    <message>
        <source>STEP files of a product become one row for each part, placed as the assembly has it. Meshes may need a unit and an axis. One part moves; the others are static or mobile.</source>
        <translation>Les fichiers STEP d&apos;un produit donnent une ligne par pièce, placée comme dans l&apos;assemblage. Les maillages peuvent demander une unité et un axe. Une pièce bouge ; les autres sont fixes ou mobiles.</translation>
    </message>
    <message>
        <source>A scenario holds bodies, the object that moves, its start and goal, places, fits, kept paths and parameters.</source>
        <translation>Un scénario contient les corps, l&apos;objet qui bouge, son départ et son but, les lieux, les ajustements, les chemins gardés et les paramètres.</translation>
    </message>
    <message>
        <source>The strategy, the operator and the sliders of the panel Interaction say how. A path that is found is proved free of penetration. Parameters can be changed while the run goes on.</source>
        <translation>La stratégie, l&apos;opérateur et les curseurs du panneau Interaction disent comment. Il est prouvé qu&apos;un chemin trouvé est sans pénétration. Les paramètres se changent pendant le calcul.</translation>
    </message>
    <message>
        <source>The program changes the values while it plans, from what computer, operator and contact have earned lately. A slider that is touched is set by hand again.</source>
        <translation>Le programme change les valeurs pendant le calcul, selon ce que l&apos;ordinateur, l&apos;opérateur et le contact ont apporté récemment. Un curseur que l&apos;on touche est de nouveau réglé à la main.</translation>
    </message>
    <message>
        <source>The free space is divided into cells, and cells of similar narrowness into places. Places overlap in borders. The strategies GT and GTS plan a coarse path through places first.</source>
        <translation>L&apos;espace libre est divisé en cellules, et les cellules d&apos;étroitesse semblable forment des lieux. Les lieux se recouvrent aux frontières. Les stratégies GT et GTS planifient d&apos;abord un chemin grossier par les lieux.</translation>
    </message>
    <message>
        <source>The coarse path is planned again at once, also during a run. An edit of a place is saved with the scenario and can be undone.</source>
        <translation>Le chemin grossier est aussitôt replanifié, même pendant un calcul. La modification d&apos;un lieu est enregistrée avec le scénario et peut être annulée.</translation>
    </message>
    <message>
        <source>A milestone is a configuration in the border of two places that the path passes through. It can be dragged in the scene, too.</source>
        <translation>Un jalon est une configuration à la frontière de deux lieux par laquelle le chemin passe. On peut aussi le tirer dans la scène.</translation>
    </message>
    <message>
        <source>CAD parts touch in their assembled position. Where clearance is required, start or goal have to move by the distance that is found and stated.</source>
        <translation>Les pièces CAO se touchent en position assemblée. Là où un jeu est exigé, le départ ou le but doivent se déplacer de la distance trouvée et indiquée.</translation>
    </message>
    <message>
        <source>The object is the one rigid body whose motion is planned. All other bodies are obstacles.</source>
        <translation>L&apos;objet est le seul corps rigide dont on planifie le mouvement. Tous les autres corps sont des obstacles.</translation>
    </message>
    <message>
        <source>Parts of a product touch or overlap as designed. A fit says by how much the object is taken thinner against one body, and every result states it.</source>
        <translation>Les pièces d&apos;un produit se touchent ou se chevauchent par conception. Un ajustement dit de combien l&apos;objet est aminci contre un corps, et chaque résultat l&apos;indique.</translation>
    </message>
    <message>
        <source>Assembly is the reverse order. The plan says which step makes way for which, which parts have to be held, and which tool turns a fastener.</source>
        <translation>L&apos;assemblage est l&apos;ordre inverse. Le plan dit quelle étape libère laquelle, quelles pièces il faut tenir, et quel outil tourne une fixation.</translation>
    </message>
    <message>
        <source>The shortened path is proved like the planned one; both are kept.</source>
        <translation>Le chemin raccourci est prouvé comme le chemin planifié ; les deux sont gardés.</translation>
    </message>
    <message>
        <source>The surface contains the object at every time of the path, and is nowhere farther from it than the stated bound.</source>
        <translation>La surface contient l&apos;objet à chaque instant du chemin, et n&apos;en est nulle part plus éloignée que la borne indiquée.</translation>
    </message>
    <message>
        <source>The panel Difficulty lists the smallest distance between the two trees, the bodies between them, and by how much the object would have to be thinner.</source>
        <translation>Le panneau Difficulté énumère la plus petite distance entre les deux arbres, les corps entre eux, et de combien l&apos;objet devrait être plus mince.</translation>
    </message>
    <message>
        <source>Every run is recorded with its seed, its parameters and what the operator did. The replay gives the same roadmap, node by node.</source>
        <translation>Chaque calcul est enregistré avec sa graine, ses paramètres et ce que l&apos;opérateur a fait. La relecture donne le même graphe, nœud par nœud.</translation>
    </message>
    <message>
        <source>Keys and devices move the object as a rule. In camera mode the same input moves the view instead.</source>
        <translation>D&apos;ordinaire, touches et périphériques déplacent l&apos;objet. En mode caméra, ils déplacent la vue.</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>How the next run plans, and who steers. The strategy is the planner. The operator holds the object: you, a device, or a simulated person. The sliders can be moved while a run goes on.</source>
        <translation>Comment le prochain calcul planifie, et qui dirige. La stratégie est le planificateur. L&apos;opérateur tient l&apos;objet : vous, un périphérique ou une personne simulée. Les curseurs se déplacent pendant le calcul.</translation>
    </message>
    <message>
        <source>All bodies of the scenario: the object that moves with its start and goal, and the obstacles. A checked box draws a body. Below are position and angles of what is selected.</source>
        <translation>Tous les corps du scénario : l&apos;objet qui bouge avec son départ et son but, et les obstacles. Une case cochée dessine un corps. Dessous, position et angles de la sélection.</translation>
    </message>
    <message>
        <source>What is known of places and bodies. Above are the places with their complexity and width, below the attributes of what is selected. The coarse path follows each change at once.</source>
        <translation>Ce que l&apos;on sait des lieux et des corps. En haut, les lieux avec complexité et largeur ; en bas, les attributs de la sélection. Le chemin grossier suit aussitôt chaque changement.</translation>
    </message>
    <message>
        <source>The pairs of bodies that touch or overlap as designed, with their kind and the allowance that planning takes. The menu of a row accepts a clash or marks a thread.</source>
        <translation>Les paires de corps qui se touchent ou se chevauchent par conception, avec leur genre et la tolérance que prend la planification. Le menu d&apos;une ligne accepte une collision ou marque un filetage.</translation>
    </message>
    <message>
        <source>Planes across the axes that cut the obstacles open in the view. Planning does not know of them.</source>
        <translation>Des plans perpendiculaires aux axes qui ouvrent les obstacles dans la vue. La planification les ignore.</translation>
    </message>
    <message>
        <source>Figures of the run: iterations, nodes and edges of the two trees, configurations by who drew them, and the nearest obstacle of the object.</source>
        <translation>Chiffres du calcul : itérations, nœuds et arêtes des deux arbres, configurations selon leur auteur, et l&apos;obstacle le plus proche de l&apos;objet.</translation>
    </message>
    <message>
        <source>The steps of the coarse path through places, with the planner of each and its result. A click on a row shows its place in the scene.</source>
        <translation>Les étapes du chemin grossier par les lieux, avec le planificateur de chacune et son résultat. Un clic sur une ligne montre son lieu dans la scène.</translation>
    </message>
    <message>
        <source>The path that was found, its certificate and its clearance. The slider and the curve move the object along it.</source>
        <translation>Le chemin trouvé, son certificat et son jeu. Le curseur et la courbe déplacent l&apos;objet le long du chemin.</translation>
    </message>
    <message>
        <source>The paths that the scenario keeps. Each is proved again when the scenario is opened or arranged. A checked box draws a path in the scene.</source>
        <translation>Les chemins que garde le scénario. Chacun est prouvé de nouveau quand le scénario est ouvert ou réarrangé. Une case cochée dessine un chemin dans la scène.</translation>
    </message>
    <message>
        <source>All messages since the program was started.</source>
        <translation>Tous les messages depuis le démarrage du programme.</translation>
    </message>
    <message>
        <source>In which order the parts of the product leave, each with a proved motion. A click on a row shows the step. Rows can be dragged, locked and moved by hand.</source>
        <translation>Dans quel ordre les pièces du produit partent, chacune avec un mouvement prouvé. Un clic sur une ligne montre l&apos;étape. Les lignes se déplacent, se verrouillent et se font à la main.</translation>
    </message>
    <message>
        <source>Why no path was found: where the trees come nearest, which body stands between them, and how much is missing.</source>
        <translation>Pourquoi aucun chemin n&apos;a été trouvé : où les arbres sont le plus près, quel corps les sépare, et combien il manque.</translation>
    </message>
    <message>
        <source>Files, undo, the run, and views of the scene.</source>
        <translation>Fichiers, annulation, calcul et vues de la scène.</translation>
    </message>
    <message>
        <source>The recorded run that is replayed, step by step.</source>
        <translation>Le calcul enregistré que l&apos;on relit, pas à pas.</translation>
    </message>
    <message>
        <source>The scene. Drag to orbit, middle-drag to pan, wheel to zoom, double-click to fit. A click selects a body, or a place while places are shown. The right button opens a menu. Keys move the object (Ctrl+F1 lists them).</source>
        <translation>La scène. Tirer pour tourner, tirer avec le bouton du milieu pour déplacer, molette pour zoomer, double clic pour cadrer. Un clic sélectionne un corps, ou un lieu quand les lieux sont affichés. Le bouton droit ouvre un menu. Les touches déplacent l&apos;objet (Ctrl+F1 les énumère).</translation>
    </message>
    <message>
        <source>What can be opened: new parts, recent files and samples.</source>
        <translation>Ce que l&apos;on peut ouvrir : nouvelles pièces, fichiers récents et exemples.</translation>
    </message>
    <message>
        <source>The name of the body. A checked box draws it.</source>
        <translation>Le nom du corps. Une case cochée le dessine.</translation>
    </message>
    <message>
        <source>Moved: the object. Static bodies stay; mobile bodies can be moved out of the way by a person.</source>
        <translation>Déplacé : l&apos;objet. Les corps fixes restent ; une personne peut écarter les corps mobiles.</translation>
    </message>
    <message>
        <source>How many triangles its surface has.</source>
        <translation>Combien de triangles a sa surface.</translation>
    </message>
    <message>
        <source>A place or a body. F2 renames a place.</source>
        <translation>Un lieu ou un corps. F2 renomme un lieu.</translation>
    </message>
    <message>
        <source>How hard the place is to pass, from its width and from what clutters it.</source>
        <translation>La difficulté du passage, d&apos;après la largeur du lieu et ce qui l&apos;encombre.</translation>
    </message>
    <message>
        <source>How wide the place is at its narrowest.</source>
        <translation>La largeur du lieu à son endroit le plus étroit.</translation>
    </message>
    <message>
        <source>The name of the attribute. Your own can be renamed and removed.</source>
        <translation>Le nom de l&apos;attribut. Les vôtres peuvent être renommés et enlevés.</translation>
    </message>
    <message>
        <source>Its value for what is selected.</source>
        <translation>Sa valeur pour la sélection.</translation>
    </message>
    <message>
        <source>Who says so: computed from geometry, a class of bodies, or you.</source>
        <translation>Qui le dit : un calcul géométrique, une classe de corps, ou vous.</translation>
    </message>
    <message>
        <source>Takes your value back.</source>
        <translation>Retire votre valeur.</translation>
    </message>
    <message>
        <source>How they meet: planar, cylindrical, thread, press, overlap, contact or clash.</source>
        <translation>Comment les deux surfaces se rencontrent : plan, cylindre, filetage, serrage, chevauchement, contact ou collision.</translation>
    </message>
    <message>
        <source>The distance of the surfaces; negative where the bodies overlap.</source>
        <translation>La distance des surfaces ; négative là où les corps se chevauchent.</translation>
    </message>
    <message>
        <source>The first body of the pair.</source>
        <translation>Le premier corps de la paire.</translation>
    </message>
    <message>
        <source>The second body of the pair.</source>
        <translation>Le second corps de la paire.</translation>
    </message>
    <message>
        <source>By how much the object is taken thinner against the other body.</source>
        <translation>De combien l&apos;objet est aminci contre l&apos;autre corps.</translation>
    </message>
    <message>
        <source>What was decided about the pair.</source>
        <translation>Ce qui a été décidé pour la paire.</translation>
    </message>
    <message>
        <source>The place that the step crosses.</source>
        <translation>Le lieu que l&apos;étape traverse.</translation>
    </message>
    <message>
        <source>The place that it leads to.</source>
        <translation>Le lieu où elle mène.</translation>
    </message>
    <message>
        <source>The planner that searches the step.</source>
        <translation>Le planificateur qui cherche l&apos;étape.</translation>
    </message>
    <message>
        <source>Random configurations that were drawn for the step.</source>
        <translation>Configurations aléatoires tirées pour l&apos;étape.</translation>
    </message>
    <message>
        <source>What came of the step.</source>
        <translation>Le résultat de l&apos;étape.</translation>
    </message>
    <message>
        <source>The name of the path. A checked box draws it.</source>
        <translation>Le nom du chemin. Une case cochée le dessine.</translation>
    </message>
    <message>
        <source>Whether the path holds in the present arrangement.</source>
        <translation>Si le chemin tient dans la disposition actuelle.</translation>
    </message>
    <message>
        <source>The smallest distance to other bodies along the path.</source>
        <translation>La plus petite distance aux autres corps le long du chemin.</translation>
    </message>
    <message>
        <source>The length of the way of the reference point.</source>
        <translation>La longueur du trajet du point de référence.</translation>
    </message>
    <message>
        <source>By how much the object turns along the path.</source>
        <translation>De combien l&apos;objet tourne le long du chemin.</translation>
    </message>
    <message>
        <source>The strategy that found it.</source>
        <translation>La stratégie qui l&apos;a trouvé.</translation>
    </message>
    <message>
        <source>The seed of that run: the same seed gives the same path.</source>
        <translation>La graine de ce calcul : la même graine donne le même chemin.</translation>
    </message>
    <message>
        <source>The largest allowance that the path needs.</source>
        <translation>La plus grande tolérance dont le chemin a besoin.</translation>
    </message>
    <message>
        <source>The number of the step.</source>
        <translation>Le numéro de l&apos;étape.</translation>
    </message>
    <message>
        <source>The part that leaves or is put in, and the kind of its motion.</source>
        <translation>La pièce qui part ou qui est montée, et le genre de son mouvement.</translation>
    </message>
    <message>
        <source>The smallest distance to other parts, and the largest allowance.</source>
        <translation>La plus petite distance aux autres pièces, et la plus grande tolérance.</translation>
    </message>
    <message>
        <source>The tool that turns a fastener, and which parts have to be held.</source>
        <translation>L&apos;outil qui tourne une fixation, et les pièces qu&apos;il faut tenir.</translation>
    </message>
    <message>
        <source>Whether the independent check agrees, and what the step does not keep.</source>
        <translation>Si la vérification indépendante est d&apos;accord, et ce que l&apos;étape ne respecte pas.</translation>
    </message>
    <message>
        <source>The place that was examined.</source>
        <translation>L&apos;endroit examiné.</translation>
    </message>
    <message>
        <source>The distance or the overlap there.</source>
        <translation>La distance ou le chevauchement à cet endroit.</translation>
    </message>
    <message>
        <source>The body that is nearest there.</source>
        <translation>Le corps le plus proche à cet endroit.</translation>
    </message>
    <message>
        <source>When the message came.</source>
        <translation>Quand le message est arrivé.</translation>
    </message>
    <message>
        <source>Information, warning or error.</source>
        <translation>Information, avertissement ou erreur.</translation>
    </message>
    <message>
        <source>What happened.</source>
        <translation>Ce qui s&apos;est passé.</translation>
    </message>
    <message>
        <source>Panels that share a place. Alt and a digit bring one to the front; View &gt; Panels shows and hides them.</source>
        <translation>Des panneaux qui partagent une place. Alt et un chiffre en mettent un au premier plan ; Vue &gt; Panneaux les montre et les cache.</translation>
    </message>
    <message>
        <source>All commands. Ctrl+K finds one by a part of its name.</source>
        <translation>Toutes les commandes. Ctrl+K en trouve une par une partie de son nom.</translation>
    </message>
    <message>
        <source>What the program is doing, what keys and devices move, and devices.</source>
        <translation>Ce que fait le programme, ce que déplacent les touches et les périphériques, et les périphériques.</translation>
    </message>
</context>
<context>
    <name>glissade::NamedViewsController</name>
    <message>
        <source>Named &amp;views</source>
        <translation>&amp;Vues nommées</translation>
    </message>
    <message>
        <source>Look from there again</source>
        <translation>Regarder de nouveau de là</translation>
    </message>
    <message>
        <source>Save this view</source>
        <translation>Enregistrer cette vue</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Nom de la vue</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
</context>
<context>
    <name>glissade::NamedViewsDialog</name>
    <message>
        <source>Named views</source>
        <translation>Vues nommées</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Rappeler</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>R&amp;emove</source>
        <translation>&amp;Supprimer</translation>
    </message>
</context>
<context>
    <name>glissade::ViewController</name>
    <message>
        <source>&lt;h2&gt;Glissade&lt;/h2&gt;&lt;p&gt;Open a scenario (Ctrl+O), or make one of your parts (Ctrl+N). Or drop either here.&lt;/p&gt;&lt;p&gt;The folder &lt;i&gt;samples&lt;/i&gt; holds the papers&apos; environments.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;Glissade&lt;/h2&gt;&lt;p&gt;Ouvrez un scénario (Ctrl+O), ou faites-en un de vos pièces (Ctrl+N). Ou déposez les uns ou les autres ici.&lt;/p&gt;&lt;p&gt;Le dossier &lt;i&gt;samples&lt;/i&gt; contient les environnements des articles.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>glissade::AlignTool</name>
    <message>
        <source>vertex</source>
        <translation>sommet</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>arête</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cylindre</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>free surface</source>
        <translation>surface libre</translation>
    </message>
    <message>
        <source>in one plane</source>
        <translation>dans un même plan</translation>
    </message>
    <message>
        <source>in one point</source>
        <translation>en un même point</translation>
    </message>
    <message>
        <source>tangent</source>
        <translation>tangent</translation>
    </message>
    <message>
        <source>in the plane</source>
        <translation>dans le plan</translation>
    </message>
    <message>
        <source>on the axis</source>
        <translation>sur l&apos;axe</translation>
    </message>
    <message>
        <source>on the edge</source>
        <translation>sur l&apos;arête</translation>
    </message>
    <message>
        <source>on one line</source>
        <translation>sur une même droite</translation>
    </message>
    <message>
        <source>Finding edges and faces of the body…</source>
        <translation>Recherche des arêtes et des faces du corps…</translation>
    </message>
    <message>
        <source>This is a free surface: it has no plane and no axis.</source>
        <translation>C&apos;est une surface libre : elle n&apos;a ni plan ni axe.</translation>
    </message>
    <message>
        <source>This is what moves. Click another body. Esc ends this.</source>
        <translation>C&apos;est ce qui bouge. Cliquer un autre corps. Échap termine.</translation>
    </message>
    <message>
        <source>Click to align: %1 with %2 of %3, %4. Esc ends this.</source>
        <translation>Cliquer pour aligner : %1 avec %2 de %3, %4. Échap termine.</translation>
    </message>
    <message>
        <source>Click what moves: %1 of %2. Esc ends this.</source>
        <translation>Cliquer ce qui bouge : %1 de %2. Échap termine.</translation>
    </message>
    <message>
        <source>Click the vertex, edge or face of another body that it goes onto. Esc ends this.</source>
        <translation>Cliquer le sommet, l&apos;arête ou la face d&apos;un autre corps sur lequel il va. Échap termine.</translation>
    </message>
    <message>
        <source>Click a vertex, an edge or a face of what moves. Esc ends this.</source>
        <translation>Cliquer un sommet, une arête ou une face de ce qui bouge. Échap termine.</translation>
    </message>
</context>
</TS>
