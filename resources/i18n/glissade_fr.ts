<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>ActionHelp</name>
    <message>
        <source>STEP files of a product become one row for each part, placed as the assembly has it. Meshes may need a unit and an axis. One part is the moving part; the others are static or mobile.</source>
        <translation>Un fichier STEP d&apos;un produit donne une ligne par pièce, placée comme dans l&apos;assemblage. Pour les maillages, indiquez au besoin l&apos;unité et l&apos;axe vertical. Une pièce est la pièce manipulée&#xa0;; les autres sont statiques ou mobiles.</translation>
    </message>
    <message>
        <source>A scenario holds bodies, the moving part, its start and goal, places, fits, kept paths and parameters.</source>
        <translation>Un scénario contient les corps, la pièce manipulée, son départ et son but, les lieux, les ajustements, les chemins conservés et les paramètres.</translation>
    </message>
    <message>
        <source>The strategy, the operator and the sliders of the panel Interaction say how. A path that is found is certified free of penetration. Parameters can be changed during the run.</source>
        <translation>La stratégie, l&apos;opérateur et les curseurs du panneau Interaction déterminent le calcul. Un chemin trouvé est certifié sans pénétration. Les paramètres peuvent être modifiés pendant le calcul.</translation>
    </message>
    <message>
        <source>The program changes the values while it plans, from what computer, operator and contact have earned lately. A slider that is touched is set by hand again.</source>
        <translation>Le programme change les valeurs pendant le calcul, selon ce que l&apos;ordinateur, l&apos;opérateur et le contact ont apporté récemment. Un curseur que vous touchez reprend votre valeur.</translation>
    </message>
    <message>
        <source>The coarse path is planned again at once, also during a run. An edit of a place is saved with the scenario and can be undone.</source>
        <translation>Le chemin grossier est aussitôt replanifié, même pendant un calcul. La modification d&apos;un lieu est enregistrée avec le scénario et peut être annulée.</translation>
    </message>
    <message>
        <source>A milestone is a configuration in the border of two places that the path passes through. It can be dragged in the scene, too.</source>
        <translation>Un jalon est une configuration de passage à la frontière de deux lieux. Vous pouvez aussi le faire glisser dans la scène.</translation>
    </message>
    <message>
        <source>CAD parts touch in their assembled position. If clearance is required, start and goal collide there. They are moved by the smallest distance that resolves this, and the distance is stated.</source>
        <translation>Les pièces CAO se touchent en position assemblée. Si un jeu est exigé, le départ et le but y sont en collision. Ils sont déplacés de la plus petite distance qui la résout, et cette distance est indiquée.</translation>
    </message>
    <message>
        <source>Parts of a product touch or overlap as designed. A fit has an allowance: the object is that much thinner against one body. Every result states it.</source>
        <translation>Les pièces d&apos;un produit se touchent ou se recouvrent par conception. Un ajustement a un amincissement&#xa0;: l&apos;objet est d&apos;autant plus mince face à un corps. Chaque résultat le mentionne.</translation>
    </message>
    <message>
        <source>Assembly is the reverse order. The plan states which step precedes which, which parts need support, and which tool turns a fastener.</source>
        <translation>L&apos;assemblage est l&apos;ordre inverse. Le plan indique quelle étape précède quelle autre, quelles pièces demandent un maintien, et quel outil tourne une fixation.</translation>
    </message>
    <message>
        <source>The shortened path is certified like the planned one; both are kept.</source>
        <translation>Le chemin raccourci est certifié comme le chemin planifié&#xa0;; les deux sont conservés.</translation>
    </message>
    <message>
        <source>The surface contains the object at every time of the path, and is nowhere farther from it than the stated bound.</source>
        <translation>La surface contient l&apos;objet à chaque instant du chemin, et n&apos;en est nulle part plus éloignée que la borne indiquée.</translation>
    </message>
    <message>
        <source>Every run is recorded with its seed, its parameters and what the operator did. The replay gives the same roadmap, node by node.</source>
        <translation>Chaque calcul est enregistré avec sa graine, ses paramètres et ce que l&apos;opérateur a fait. La relecture donne le même graphe, nœud par nœud.</translation>
    </message>
    <message>
        <source>Keys and devices move the object as a rule. In camera mode the same input moves the view instead.</source>
        <translation>D&apos;ordinaire, touches et périphériques déplacent l&apos;objet. En mode caméra, ils déplacent la vue.</translation>
    </message>
    <message>
        <source>The object is the moving part: one body, or several as one rigid body. All other bodies are obstacles.</source>
        <translation>L&apos;objet est la pièce manipulée&#xa0;: un corps, ou plusieurs comme un seul corps rigide. Tous les autres corps sont des obstacles.</translation>
    </message>
    <message>
        <source>CAD files often hold variants of a part that are drawn over each other. One is built, the others are excluded. Certificates are about the product without them.</source>
        <translation>Les fichiers de CAO contiennent souvent des variantes d&apos;une pièce dessinées l&apos;une sur l&apos;autre. Une seule est construite, les autres sont exclues. Les certificats portent sur le produit sans elles.</translation>
    </message>
    <message>
        <source>Screws, nuts, inserts, pins and rolling bearings are recognised by their shapes. Belts, clips, what is glued, and purchased units are suggested and count when you confirm them.</source>
        <translation>Les vis, écrous, inserts, goupilles et roulements sont reconnus à leur forme. Les courroies, les clips, ce qui est collé et les unités achetées sont proposés et comptent quand vous les confirmez.</translation>
    </message>
    <message>
        <source>The free space is divided into cells, and cells of similar narrowness into places. Places overlap in borders. Layers and the strategies with places plan a coarse path through places first.</source>
        <translation>L&apos;espace libre est divisé en cellules, et les cellules d&apos;étroitesse semblable forment des lieux. Les lieux se recouvrent aux frontières. Couches et les stratégies à lieux planifient d&apos;abord un chemin grossier par les lieux.</translation>
    </message>
    <message>
        <source>The hand is taken to a configuration that the search has reached. The ghost is the nearest one on the other side: lead the object there. Where nobody held the object, or the search had ended, it starts again by hand.</source>
        <translation>La main est conduite à une configuration que la recherche a atteinte. Le fantôme est la plus proche de l&apos;autre côté&#xa0;: menez-y l&apos;objet. Si personne ne tenait l&apos;objet, ou si la recherche était terminée, elle redémarre à la main.</translation>
    </message>
    <message>
        <source>It holds for keys and devices. F over the scene does the same.</source>
        <translation>Cela vaut pour les touches et les périphériques. La touche F dans la vue fait de même.</translation>
    </message>
    <message>
        <source>Several ways to hold the part or its tool are tried, with the wrist bent in six ways. Hand, forearm and tool are sampled along the motion: this is no proof. Measures of the hand are those of ANSUR II.</source>
        <translation>Plusieurs prises de la pièce ou de son outil sont essayées, avec six flexions du poignet. La main, l&apos;avant-bras et l&apos;outil sont vérifiés par échantillons le long du mouvement : ce n&apos;est pas une preuve. Les mesures de la main sont celles d&apos;ANSUR II.</translation>
    </message>
    <message>
        <source>The panel Path &gt; Why not lists the smallest distance between the two trees, the bodies between them, and how much more room the object needs.</source>
        <translation>Le panneau Chemin &gt; Pourquoi non énumère la plus petite distance entre les deux arbres, les corps entre eux, et la place qui manque à l&apos;objet.</translation>
    </message>
</context>
<context>
    <name>Actions</name>
    <message>
        <source>Rename...</source>
        <translation>Renommer...</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Play the path again when its end is reached</source>
        <translation>Reprendre la lecture du chemin au début quand elle arrive à la fin</translation>
    </message>
    <message>
        <source>Play the path from its goal to its start</source>
        <translation>Lire le chemin du but vers le départ</translation>
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
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>Left orbits, middle or Shift + left pans, right zooms</source>
        <translation>Gauche&#xa0;: tourner&#xa0;; milieu ou Maj + gauche&#xa0;: déplacer&#xa0;; droit&#xa0;: zoomer</translation>
    </message>
    <message>
        <source>&amp;CAD</source>
        <translation>&amp;CAO</translation>
    </message>
    <message>
        <source>Middle orbits, Ctrl + middle pans, Shift + middle zooms</source>
        <translation>Milieu&#xa0;: tourner&#xa0;; Ctrl + milieu&#xa0;: déplacer&#xa0;; Maj + milieu&#xa0;: zoomer</translation>
    </message>
    <message>
        <source>&amp;Blender</source>
        <translation>&amp;Blender</translation>
    </message>
    <message>
        <source>Middle orbits, Shift + middle pans, Ctrl + middle zooms</source>
        <translation>Milieu&#xa0;: tourner&#xa0;; Maj + milieu&#xa0;: déplacer&#xa0;; Ctrl + milieu&#xa0;: zoomer</translation>
    </message>
    <message>
        <source>FreeCAD &amp;gesture</source>
        <translation>&amp;Gestes de FreeCAD</translation>
    </message>
    <message>
        <source>Left orbits, right pans, both roll</source>
        <translation>Gauche&#xa0;: tourner&#xa0;; droit&#xa0;: déplacer&#xa0;; les deux&#xa0;: incliner</translation>
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
        <translation>Ne dessiner que les arêtes des corps&#xa0;; les arêtes cachées sont en tirets</translation>
    </message>
    <message>
        <source>Draw the selected bodies opaque, with their edges</source>
        <translation>Dessiner les corps sélectionnés opaques, avec leurs arêtes</translation>
    </message>
    <message>
        <source>Draw the selected bodies opaque, without edges</source>
        <translation>Dessiner les corps sélectionnés opaques, sans arêtes</translation>
    </message>
    <message>
        <source>Draw the selected bodies transparent, with all their edges</source>
        <translation>Dessiner les corps sélectionnés transparents, avec toutes leurs arêtes</translation>
    </message>
    <message>
        <source>Draw only the edges of the selected bodies</source>
        <translation>Ne dessiner que les arêtes des corps sélectionnés</translation>
    </message>
    <message>
        <source>Draw the selected bodies in the display mode of the view again</source>
        <translation>Redonner aux corps sélectionnés le mode d&apos;affichage de la vue</translation>
    </message>
    <message>
        <source>&amp;Export path...</source>
        <translation>Exporter le &amp;chemin...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Restart with a &amp;new seed</source>
        <translation>Redémarrer avec une &amp;nouvelle graine</translation>
    </message>
    <message>
        <source>Stop and start again with the next seed</source>
        <translation>Arrêter le calcul et le redémarrer avec la graine suivante</translation>
    </message>
    <message>
        <source>&amp;Play the path</source>
        <translation>&amp;Lire le chemin</translation>
    </message>
    <message>
        <source>Fit bodies, start, goal and path in the view, direction kept</source>
        <translation>Cadrer les corps, le départ, le but et le chemin sans changer de direction</translation>
    </message>
    <message>
        <source>Look from a corner</source>
        <translation>Regarder depuis un coin de la scène</translation>
    </message>
    <message>
        <source>Look along y</source>
        <translation>Regarder selon y</translation>
    </message>
    <message>
        <source>Look against y</source>
        <translation>Regarder contre y</translation>
    </message>
    <message>
        <source>Look along x</source>
        <translation>Regarder selon x</translation>
    </message>
    <message>
        <source>Look against x</source>
        <translation>Regarder contre x</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Regarder de dessus</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Regarder de dessous</translation>
    </message>
    <message>
        <source>Show the obstacles</source>
        <translation>Montrer les obstacles</translation>
    </message>
    <message>
        <source>Show start and goal as ghosts</source>
        <translation>Montrer le départ et le but en transparence</translation>
    </message>
    <message>
        <source>Show the bounds of the reference point</source>
        <translation>Montrer les limites du point de référence</translation>
    </message>
    <message>
        <source>Show the trees</source>
        <translation>Montrer les arbres</translation>
    </message>
    <message>
        <source>Show the path</source>
        <translation>Montrer le chemin</translation>
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
        <translation>Le pilotage et tous les raccourcis</translation>
    </message>
    <message>
        <source>&amp;Change shortcuts...</source>
        <translation>&amp;Changer les raccourcis...</translation>
    </message>
    <message>
        <source>Assign other shortcuts to commands</source>
        <translation>Attribuer d&apos;autres raccourcis aux commandes</translation>
    </message>
    <message>
        <source>&amp;About Glissade</source>
        <translation>À &amp;propos de Glissade</translation>
    </message>
    <message>
        <source>Version, licence and the papers</source>
        <translation>Version, licence et articles scientifiques</translation>
    </message>
    <message>
        <source>Save the scenario with its attributes, strategy and parameters</source>
        <translation>Enregistrer le scénario avec ses attributs, sa stratégie et ses paramètres</translation>
    </message>
    <message>
        <source>Save the scenario under another name</source>
        <translation>Enregistrer le scénario sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
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
        <translation>Construire le modèle de l&apos;environnement&#xa0;: octree, lieux, frontières, compatibilité</translation>
    </message>
    <message>
        <source>&amp;Add attribute...</source>
        <translation>&amp;Ajouter un attribut...</translation>
    </message>
    <message>
        <source>Define an attribute of your own on places or bodies</source>
        <translation>Définir un attribut personnel pour les lieux ou les corps</translation>
    </message>
    <message>
        <source>Rename the attribute of the current row, where it is your own</source>
        <translation>Renommer l&apos;attribut de la ligne courante, s&apos;il est personnel</translation>
    </message>
    <message>
        <source>Remove the attribute of the current row, where it is your own</source>
        <translation>Supprimer l&apos;attribut de la ligne courante, s&apos;il est personnel</translation>
    </message>
    <message>
        <source>Show the octree&apos;s free cells, the coarsest first</source>
        <translation>Montrer les cellules libres de l&apos;octree, les plus grandes d&apos;abord</translation>
    </message>
    <message>
        <source>Show the cells that only mobile bodies clutter</source>
        <translation>Montrer les cellules que seuls des corps mobiles encombrent</translation>
    </message>
    <message>
        <source>Show the cells that static bodies clutter</source>
        <translation>Montrer les cellules que des corps statiques encombrent</translation>
    </message>
    <message>
        <source>Show the places, coloured by complexity; click to select</source>
        <translation>Montrer les lieux, colorés selon leur complexité&#xa0;; cliquer pour sélectionner</translation>
    </message>
    <message>
        <source>Show where places meet</source>
        <translation>Montrer où les lieux se rejoignent</translation>
    </message>
    <message>
        <source>Show the topological graph with its costs</source>
        <translation>Montrer le graphe topologique avec ses coûts</translation>
    </message>
    <message>
        <source>Show the cheapest path through the graph</source>
        <translation>Montrer le chemin le moins coûteux dans le graphe</translation>
    </message>
    <message>
        <source>Show where the local planner of the selected step searches</source>
        <translation>Montrer où cherche le planificateur local de l&apos;étape sélectionnée</translation>
    </message>
    <message>
        <source>Bring the list of bodies to the front</source>
        <translation>Mettre la liste des corps au premier plan</translation>
    </message>
    <message>
        <source>Bring the figures of the run to the front</source>
        <translation>Mettre les chiffres du calcul au premier plan</translation>
    </message>
    <message>
        <source>Bring the topological steps to the front</source>
        <translation>Mettre les étapes topologiques au premier plan</translation>
    </message>
    <message>
        <source>Bring the path and its certificate to the front</source>
        <translation>Mettre le chemin et son certificat au premier plan</translation>
    </message>
    <message>
        <source>Show the octree&apos;s cells one level deeper</source>
        <translation>Montrer les cellules de l&apos;octree un niveau plus bas</translation>
    </message>
    <message>
        <source>Show the octree&apos;s cells one level less deep</source>
        <translation>Montrer les cellules de l&apos;octree un niveau plus haut</translation>
    </message>
    <message>
        <source>Show the configurations to pass through; drag one to move it, Ctrl+drag to turn it</source>
        <translation>Montrer les configurations de passage&#xa0;; faire glisser un jalon pour le déplacer, avec Ctrl pour le tourner</translation>
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
        <source>Calibrate 6D mouse, keys and gamepad: live axes, curves, presets, buttons</source>
        <translation>Étalonner souris 6D, clavier et manette&#xa0;: axes en direct, courbes, préréglages, boutons</translation>
    </message>
    <message>
        <source>Save &amp;recording...</source>
        <translation>Enregis&amp;trer l&apos;enregistrement...</translation>
    </message>
    <message>
        <source>Replay a recorded run</source>
        <translation>Rejouer un calcul enregistré</translation>
    </message>
    <message>
        <source>Replay the &amp;last run</source>
        <translation>Rejouer le dernier &amp;calcul</translation>
    </message>
    <message>
        <source>Show the next step of the replay</source>
        <translation>Montrer le pas suivant de la relecture</translation>
    </message>
    <message>
        <source>Show the step before</source>
        <translation>Montrer le pas précédent de la relecture</translation>
    </message>
    <message>
        <source>Show the replay from its beginning</source>
        <translation>Montrer la relecture depuis son début</translation>
    </message>
    <message>
        <source>Go back to the session; its run and parameters are as they were left</source>
        <translation>Revenir à la session&#xa0;; son calcul et ses paramètres n&apos;ont pas changé</translation>
    </message>
    <message>
        <source>Colour the path by who made each segment: computer, operator, contact</source>
        <translation>Colorer chaque segment du chemin selon son auteur&#xa0;: ordinateur, opérateur, contact</translation>
    </message>
    <message>
        <source>&amp;Open study results...</source>
        <translation>&amp;Ouvrir les résultats d&apos;une étude...</translation>
    </message>
    <message>
        <source>Write the report of the study that is open as PDF</source>
        <translation>Écrire en PDF le rapport de l&apos;étude ouverte</translation>
    </message>
    <message>
        <source>Show what guides the hand: the force as an arrow, its strength as a tint</source>
        <translation>Montrer la force de guidage&#xa0;: une flèche pour la force, une teinte pour son intensité</translation>
    </message>
    <message>
        <source>Clear the list of recent files</source>
        <translation>Vider la liste des fichiers récents</translation>
    </message>
    <message>
        <source>Turning about the line of sight rolls the camera, or the horizon stays level</source>
        <translation>Faire rouler la caméra autour de l&apos;axe de visée, ou garder l&apos;horizon horizontal</translation>
    </message>
    <message>
        <source>Shorten the path by shortcuts that are certified, or show it as planned</source>
        <translation>Raccourcir le chemin par des raccourcis certifiés, ou montrer le chemin tel qu&apos;il a été planifié</translation>
    </message>
    <message>
        <source>&amp;Why no path?</source>
        <translation>&amp;Pourquoi pas de chemin&#xa0;?</translation>
    </message>
    <message>
        <source>Play the path of &amp;least penetration</source>
        <translation>Lire le chemin de &amp;moindre pénétration</translation>
    </message>
    <message>
        <source>&amp;Hide the selected bodies</source>
        <translation>Mas&amp;quer les corps sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Isolate the selected bodies</source>
        <translation>&amp;Isoler les corps sélectionnés</translation>
    </message>
    <message>
        <source>Draw the selected obstacles and no others</source>
        <translation>N&apos;afficher que les obstacles sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Show all bodies</source>
        <translation>Montrer &amp;tous les corps</translation>
    </message>
    <message>
        <source>Draw all obstacles again</source>
        <translation>Afficher de nouveau tous les obstacles</translation>
    </message>
    <message>
        <source>Restore the default layout of the panels</source>
        <translation>Rétablir la disposition par défaut des panneaux</translation>
    </message>
    <message>
        <source>Show why no path was found: blocking body, gap, path of least penetration</source>
        <translation>Montrer pourquoi aucun chemin n&apos;a été trouvé&#xa0;: corps bloquant, écart, chemin de moindre pénétration</translation>
    </message>
    <message>
        <source>Bring the reasons why no path was found to the front</source>
        <translation>Mettre au premier plan les causes de l&apos;absence de chemin</translation>
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
        <source>Click a plane or a cylinder: the numbers of the placement are those of its frame</source>
        <translation>Cliquer un plan ou un cylindre&#xa0;: les coordonnées affichées sont celles de son repère</translation>
    </message>
    <message>
        <source>&amp;Goal here</source>
        <translation>Placer le &amp;but ici</translation>
    </message>
    <message>
        <source>Goal: rem&amp;oved</source>
        <translation>But&#xa0;: &amp;démonté</translation>
    </message>
    <message>
        <source>S&amp;wap start and goal</source>
        <translation>Écha&amp;nger départ et but</translation>
    </message>
    <message>
        <source>&amp;Fit the workspace</source>
        <translation>Ajuster l&apos;&amp;espace de travail</translation>
    </message>
    <message>
        <source>Read how the strategy weighs places and chooses planners, and change it</source>
        <translation>Lire et modifier la façon dont la stratégie évalue les lieux et choisit les planificateurs</translation>
    </message>
    <message>
        <source>Save the certified path: as data, or as an animation for 3D viewers</source>
        <translation>Enregistrer le chemin certifié&#xa0;: les données, ou une animation pour visionneuses 3D</translation>
    </message>
    <message>
        <source>Read a path of this scenario, and certify it or see where it is blocked</source>
        <translation>Ouvrir un chemin de ce scénario, et le certifier ou montrer où il est bloqué</translation>
    </message>
    <message>
        <source>&amp;Film of the path...</source>
        <translation>&amp;Film du chemin...</translation>
    </message>
    <message>
        <source>Film the 3D view while the path is played: MP4, WebM or pictures</source>
        <translation>Filmer la vue 3D pendant la lecture du chemin&#xa0;: MP4, WebM ou images</translation>
    </message>
    <message>
        <source>&amp;Report of the path...</source>
        <translation>&amp;Rapport du chemin...</translation>
    </message>
    <message>
        <source>Write problem, certificate, clearance and pictures of the path as HTML or PDF</source>
        <translation>Écrire en HTML ou en PDF le problème, le certificat, le jeu et des images du chemin</translation>
    </message>
    <message>
        <source>Write the swept volume as triangles: STL or GLB</source>
        <translation>Exporter le volume balayé sous forme de triangles&#xa0;: STL ou GLB</translation>
    </message>
    <message>
        <source>Show the object at the first place where the path is blocked</source>
        <translation>Montrer l&apos;objet au premier endroit où le chemin est bloqué</translation>
    </message>
    <message>
        <source>List the pairs of bodies that touch or overlap, with their kind and allowance</source>
        <translation>Lister les paires de corps qui se touchent ou se recouvrent, avec leur type et leur amincissement</translation>
    </message>
    <message>
        <source>Draw the two bodies of the selected fit and no other obstacles</source>
        <translation>N&apos;afficher que les deux corps de l&apos;ajustement sélectionné</translation>
    </message>
    <message>
        <source>Accept the &amp;clash</source>
        <translation>A&amp;ccepter l&apos;interférence</translation>
    </message>
    <message>
        <source>Allow the overlap of the selected pair; results state it</source>
        <translation>Admettre le recouvrement de la paire sélectionnée&#xa0;; les résultats l&apos;indiquent</translation>
    </message>
    <message>
        <source>The selected pair is a thread that is drawn as cylinders</source>
        <translation>La paire sélectionnée est un filetage représenté par des cylindres</translation>
    </message>
    <message>
        <source>Bring the table of fits to the front</source>
        <translation>Mettre le tableau des ajustements au premier plan</translation>
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
        <source>Ke&amp;ep the path</source>
        <translation>Conser&amp;ver le chemin</translation>
    </message>
    <message>
        <source>Keep the path that was found in the scenario</source>
        <translation>Conserver dans le scénario le chemin trouvé</translation>
    </message>
    <message>
        <source>Play, smooth or export the selected kept path</source>
        <translation>Faire du chemin conservé sélectionné celui que l&apos;on lit, lisse ou exporte</translation>
    </message>
    <message>
        <source>Show the figures and curves of the selected paths side by side; of all where fewer than two are selected</source>
        <translation>Afficher côte à côte les valeurs et les courbes des chemins sélectionnés&#xa0;; de tous si moins de deux sont sélectionnés</translation>
    </message>
    <message>
        <source>Give the selected kept path another name</source>
        <translation>Donner un autre nom au chemin conservé sélectionné</translation>
    </message>
    <message>
        <source>Remove the selected paths from the scenario; Undo brings them back</source>
        <translation>Supprimer du scénario les chemins sélectionnés&#xa0;; Annuler les rétablit</translation>
    </message>
    <message>
        <source>&amp;Zoom to the selection</source>
        <translation>&amp;Zoomer sur la sélection</translation>
    </message>
    <message>
        <source>Bring the selected bodies near, direction kept</source>
        <translation>Zoomer sur les corps sélectionnés sans changer de direction</translation>
    </message>
    <message>
        <source>Draw without perspective, so that lengths across the view are to scale</source>
        <translation>Dessiner sans perspective&#xa0;: les longueurs parallèles à l&apos;écran sont à l&apos;échelle</translation>
    </message>
    <message>
        <source>Measure a &amp;distance</source>
        <translation>Mesurer une &amp;distance</translation>
    </message>
    <message>
        <source>Click two vertices, edges or faces; the pointer snaps to them</source>
        <translation>Cliquer deux sommets, arêtes ou faces&#xa0;; le pointeur s&apos;y accroche</translation>
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
        <translation>Cliquer deux corps&#xa0;: leur plus petite distance</translation>
    </message>
    <message>
        <source>Remove the mea&amp;surement</source>
        <translation>&amp;Effacer la mesure</translation>
    </message>
    <message>
        <source>Hide what was measured</source>
        <translation>Masquer ce qui a été mesuré</translation>
    </message>
    <message>
        <source>Bring the list of kept paths to the front</source>
        <translation>Mettre la liste des chemins conservés au premier plan</translation>
    </message>
    <message>
        <source>Bring the log of messages to the front</source>
        <translation>Mettre le journal des messages au premier plan</translation>
    </message>
    <message>
        <source>Type a part of its name, or another word for it, to find any command and run it</source>
        <translation>Taper une partie du nom, ou un mot de même sens, pour trouver une commande et l&apos;exécuter</translation>
    </message>
    <message>
        <source>Copy for a &amp;bug report</source>
        <translation>&amp;Copier pour un rapport d&apos;anomalie</translation>
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
        <source>&amp;Forbid the place</source>
        <translation>&amp;Interdire le lieu</translation>
    </message>
    <message>
        <source>Plan the se&amp;quence</source>
        <translation>Planifier la sé&amp;quence</translation>
    </message>
    <message>
        <source>Find in which order the parts of the product are removed, each with a certified motion</source>
        <translation>Chercher dans quel ordre les pièces du produit se démontent, chacune par un mouvement certifié</translation>
    </message>
    <message>
        <source>Resume plannin&amp;g</source>
        <translation>Reprendre la planifi&amp;cation de la séquence</translation>
    </message>
    <message>
        <source>Resume the sequence where planning was stopped</source>
        <translation>Reprendre la séquence là où la planification a été arrêtée</translation>
    </message>
    <message>
        <source>The selected bodies are the base: the sequence does not remove them. Or release them</source>
        <translation>Les corps sélectionnés forment la base&#xa0;: la séquence ne les démonte pas. Ou les libérer</translation>
    </message>
    <message>
        <source>Read an assembly plan of this product, and certify each step again</source>
        <translation>Lire un plan d&apos;assemblage de ce produit, et certifier de nouveau chaque étape</translation>
    </message>
    <message>
        <source>Save the plan, its work instruction, its table of steps or its animation</source>
        <translation>Enregistrer le plan d&apos;assemblage, la gamme de montage, le tableau des étapes ou l&apos;animation</translation>
    </message>
    <message>
        <source>Show the steps as they are assembled, or as they are removed</source>
        <translation>Montrer les étapes dans l&apos;ordre du montage, ou dans celui du démontage</translation>
    </message>
    <message>
        <source>Draw all parts where they are assembled</source>
        <translation>Dessiner toutes les pièces là où elles sont assemblées</translation>
    </message>
    <message>
        <source>Bring the assembly plan to the front</source>
        <translation>Mettre le plan d&apos;assemblage au premier plan</translation>
    </message>
    <message>
        <source>Precedence &amp;graph</source>
        <translation>&amp;Graphe d&apos;antériorité</translation>
    </message>
    <message>
        <source>Each of the selected steps comes before the next one</source>
        <translation>Chaque étape sélectionnée doit précéder la suivante</translation>
    </message>
    <message>
        <source>Use this pat&amp;h</source>
        <translation>&amp;Utiliser ce chemin</translation>
    </message>
    <message>
        <source>Go back to the sequence with the certified path of the part that was moved by hand</source>
        <translation>Revenir à la séquence avec le chemin certifié de la pièce déplacée à la main</translation>
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
        <translation>Déplacer et tourner les corps, le départ et le but dans la vue&#xa0;: par des flèches, des anneaux, les touches fléchées ou le corps lui-même</translation>
    </message>
    <message>
        <source>Flip the ali&amp;gnment</source>
        <translation>&amp;Retourner l&apos;alignement</translation>
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
        <translation>&amp;Aide sur ce panneau</translation>
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
        <source>Move the object back to the start</source>
        <translation>Ramener l&apos;objet au départ</translation>
    </message>
    <message>
        <source>Move the object along the path, or pause</source>
        <translation>Déplacer l&apos;objet le long du chemin, ou suspendre la lecture</translation>
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
        <translation>Rétablir la modification annulée</translation>
    </message>
    <message>
        <source>Prefer paths through the selected places, or no longer</source>
        <translation>Favoriser les chemins par les lieux sélectionnés, ou ne plus les favoriser</translation>
    </message>
    <message>
        <source>Let the selected step end at the present pose of the object</source>
        <translation>Terminer l&apos;étape sélectionnée à la position actuelle de l&apos;objet</translation>
    </message>
    <message>
        <source>Let the planner choose where the selected step ends</source>
        <translation>Laisser le planificateur choisir où finit l&apos;étape sélectionnée</translation>
    </message>
    <message>
        <source>Play the replayed run, or pause it</source>
        <translation>Lancer ou suspendre la relecture</translation>
    </message>
    <message>
        <source>Find the tightest passage, and by how much bodies overlap on the path of least penetration</source>
        <translation>Trouver le passage le plus étroit, et le recouvrement des corps sur le chemin de moindre pénétration</translation>
    </message>
    <message>
        <source>Move the object along the path of least penetration, or pause</source>
        <translation>Déplacer l&apos;objet le long du chemin de moindre pénétration, ou suspendre la lecture</translation>
    </message>
    <message>
        <source>Make a scenario from STEP, mesh or URDF files, with one moving part</source>
        <translation>Créer un scénario à partir de fichiers STEP, de maillages ou URDF, avec une pièce manipulée</translation>
    </message>
    <message>
        <source>Add parts from STEP, mesh or URDF files to the scene</source>
        <translation>Ajouter au scénario des pièces de fichiers STEP, de maillages ou URDF</translation>
    </message>
    <message>
        <source>Remove the selected bodies from the scene</source>
        <translation>Retirer de la scène les corps sélectionnés</translation>
    </message>
    <message>
        <source>Make the present pose of the object the start</source>
        <translation>Prendre la position actuelle de l&apos;objet comme départ</translation>
    </message>
    <message>
        <source>Make the present pose of the object the goal</source>
        <translation>Prendre la position actuelle de l&apos;objet comme but</translation>
    </message>
    <message>
        <source>The goal is any pose outside of the other bodies: the part is removed</source>
        <translation>Le but est une pose quelconque hors des autres corps&#xa0;: la pièce est démontée</translation>
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
        <source>Language, theme, font size, unit of lengths, navigation, colours</source>
        <translation>Langue, thème, taille de police, unité des longueurs, navigation, couleurs</translation>
    </message>
    <message>
        <source>Give the selected pair no allowance: it must keep the required clearance</source>
        <translation>N&apos;admettre aucun amincissement pour la paire sélectionnée&#xa0;: elle doit garder le jeu exigé</translation>
    </message>
    <message>
        <source>Undo the decision about the selected pair</source>
        <translation>Annuler la décision prise pour la paire sélectionnée</translation>
    </message>
    <message>
        <source>Zoom to the collision: the bodies, and where they overlap</source>
        <translation>Zoomer sur la collision&#xa0;: les corps, et l&apos;endroit où ils se recouvrent</translation>
    </message>
    <message>
        <source>Give the object an allowance against the bodies that it overlaps there; results state it</source>
        <translation>Amincir l&apos;objet face aux corps qu&apos;il recouvre à cet endroit&#xa0;; les résultats l&apos;indiquent</translation>
    </message>
    <message>
        <source>Show all steps one after the other, or pause</source>
        <translation>Montrer toutes les étapes l&apos;une après l&apos;autre, ou suspendre la lecture</translation>
    </message>
    <message>
        <source>Draw removed parts where their motion ends, or hide them</source>
        <translation>Montrer les pièces démontées là où leur mouvement finit, ou les masquer</translation>
    </message>
    <message>
        <source>Rule out this &amp;direction of removal</source>
        <translation>&amp;Interdire cette direction de démontage</translation>
    </message>
    <message>
        <source>The parts of the selected step are not removed in its direction</source>
        <translation>Les pièces de l&apos;étape sélectionnée ne se démontent pas dans sa direction</translation>
    </message>
    <message>
        <source>Remove the constraints on the selected parts: places, motions, directions, order</source>
        <translation>Supprimer les contraintes sur les pièces sélectionnées&#xa0;: places, mouvements, directions, ordre</translation>
    </message>
    <message>
        <source>Move the part of the selected step by hand, among the parts that are present at that step</source>
        <translation>Déplacer à la main la pièce de l&apos;étape sélectionnée, parmi les pièces présentes à cette étape</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>Show the first steps in the window: places and strategies, then parts</source>
        <translation>Montrer les premières étapes dans la fenêtre&#xa0;: lieux et stratégies, puis pièces</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>&amp;Qu&apos;est-ce que c&apos;est&#xa0;?</translation>
    </message>
    <message>
        <source>Click anything in the window to read what it is for</source>
        <translation>Cliquer un élément de la fenêtre pour lire à quoi il sert</translation>
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
        <translation>Afficher, renommer et supprimer des vues nommées</translation>
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
        <source>New seed</source>
        <translation>Nouvelle graine</translation>
    </message>
    <message>
        <source>Show the &amp;tightest place</source>
        <translation>Montrer le &amp;passage le plus étroit</translation>
    </message>
    <message>
        <source>Sele&amp;cted: shaded with edges</source>
        <translation>Séle&amp;ction : ombrée avec arêtes</translation>
    </message>
    <message>
        <source>Selected: s&amp;haded</source>
        <translation>Sélection : o&amp;mbrée</translation>
    </message>
    <message>
        <source>Selected: see-th&amp;rough</source>
        <translation>&amp;Sélection : transparente</translation>
    </message>
    <message>
        <source>Selected: wire&amp;frame</source>
        <translation>Sélectio&amp;n : fil de fer</translation>
    </message>
    <message>
        <source>Selected: as the &amp;view</source>
        <translation>Sélection : comme la &amp;vue</translation>
    </message>
    <message>
        <source>&amp;Find path</source>
        <translation>&amp;Chercher un chemin</translation>
    </message>
    <message>
        <source>Pa&amp;use the run</source>
        <translation>&amp;Suspendre le calcul</translation>
    </message>
    <message>
        <source>&amp;Restart the run</source>
        <translation>&amp;Redémarrer le calcul</translation>
    </message>
    <message>
        <source>&amp;Move the object to the start</source>
        <translation>Ramener l&apos;&amp;objet au départ</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>Tout cad&amp;rer</translation>
    </message>
    <message>
        <source>&amp;Isometric view</source>
        <translation>Vue &amp;isométrique</translation>
    </message>
    <message>
        <source>Fro&amp;nt view</source>
        <translation>Vue de &amp;face</translation>
    </message>
    <message>
        <source>&amp;Back view</source>
        <translation>Vue &amp;arrière</translation>
    </message>
    <message>
        <source>&amp;Left view</source>
        <translation>Vue de ga&amp;uche</translation>
    </message>
    <message>
        <source>&amp;Right view</source>
        <translation>Vue de &amp;droite</translation>
    </message>
    <message>
        <source>&amp;Top view</source>
        <translation>Vue de de&amp;ssus</translation>
    </message>
    <message>
        <source>Botto&amp;m view</source>
        <translation>&amp;Vue de dessous</translation>
    </message>
    <message>
        <source>Dark &amp;theme</source>
        <translation>Thème &amp;sombre</translation>
    </message>
    <message>
        <source>&amp;Obstacles</source>
        <translation>&amp;Obstacles</translation>
    </message>
    <message>
        <source>O&amp;bject</source>
        <translation>O&amp;bjet</translation>
    </message>
    <message>
        <source>Start and &amp;goal</source>
        <translation>&amp;Départ et but</translation>
    </message>
    <message>
        <source>&amp;Workspace</source>
        <translation>&amp;Espace de travail</translation>
    </message>
    <message>
        <source>&amp;Roadmap</source>
        <translation>G&amp;raphe</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>C&amp;hemin</translation>
    </message>
    <message>
        <source>&amp;Contact</source>
        <translation>&amp;Contact</translation>
    </message>
    <message>
        <source>&amp;Save scenario</source>
        <translation>&amp;Enregistrer le scénario</translation>
    </message>
    <message>
        <source>Save scenario &amp;as...</source>
        <translation>Enregistrer le scénario &amp;sous...</translation>
    </message>
    <message>
        <source>&amp;Free cells</source>
        <translation>&amp;Cellules libres</translation>
    </message>
    <message>
        <source>&amp;Cells with mobile bodies</source>
        <translation>Cellules à corps &amp;mobiles</translation>
    </message>
    <message>
        <source>Cells with s&amp;tatic bodies</source>
        <translation>Cellules à corps &amp;statiques</translation>
    </message>
    <message>
        <source>&amp;Places</source>
        <translation>&amp;Lieux</translation>
    </message>
    <message>
        <source>&amp;Borders</source>
        <translation>&amp;Frontières</translation>
    </message>
    <message>
        <source>Topological &amp;graph</source>
        <translation>&amp;Graphe topologique</translation>
    </message>
    <message>
        <source>Coarse pat&amp;h</source>
        <translation>C&amp;hemin grossier</translation>
    </message>
    <message>
        <source>&amp;Milestones</source>
        <translation>&amp;Jalons</translation>
    </message>
    <message>
        <source>&amp;Region of a step</source>
        <translation>&amp;Région d&apos;une étape</translation>
    </message>
    <message>
        <source>&amp;Run panel</source>
        <translation>Panneau &amp;Calcul</translation>
    </message>
    <message>
        <source>Pa&amp;th panel</source>
        <translation>Panneau C&amp;hemin</translation>
    </message>
    <message>
        <source>Show fi&amp;ner cells</source>
        <translation>Mo&amp;ntrer des cellules plus fines</translation>
    </message>
    <message>
        <source>&amp;Show coarser cells</source>
        <translation>Montrer des cellules &amp;plus grosses</translation>
    </message>
    <message>
        <source>Calibrate the &amp;devices...</source>
        <translation>Étalonner les &amp;périphériques...</translation>
    </message>
    <message>
        <source>Open recor&amp;ding...</source>
        <translation>Ouv&amp;rir un enregistrement...</translation>
    </message>
    <message>
        <source>&amp;Replay with current parameters</source>
        <translation>Rejouer avec les &amp;paramètres courants</translation>
    </message>
    <message>
        <source>&amp;Play the replay</source>
        <translation>&amp;Lancer la relecture</translation>
    </message>
    <message>
        <source>Step the replay &amp;forward</source>
        <translation>&amp;Avancer la relecture d&apos;un pas</translation>
    </message>
    <message>
        <source>Step the replay &amp;back</source>
        <translation>&amp;Reculer la relecture d&apos;un pas</translation>
    </message>
    <message>
        <source>&amp;Go to the beginning of the replay</source>
        <translation>Aller au &amp;début de la relecture</translation>
    </message>
    <message>
        <source>&amp;Close the replay</source>
        <translation>&amp;Fermer la relecture</translation>
    </message>
    <message>
        <source>Colour the path by &amp;author</source>
        <translation>Colorer le chemin par &amp;auteur</translation>
    </message>
    <message>
        <source>Save the &amp;report as PDF...</source>
        <translation>Enregistrer le &amp;rapport en PDF...</translation>
    </message>
    <message>
        <source>&amp;Smooth the path</source>
        <translation>&amp;Lisser le chemin</translation>
    </message>
    <message>
        <source>Guidance &amp;force</source>
        <translation>&amp;Force de guidage</translation>
    </message>
    <message>
        <source>&amp;Automatic tuning of α, N and d</source>
        <translation>Réglage auto&amp;matique de α, N et d</translation>
    </message>
    <message>
        <source>&amp;Cancel the work in progress</source>
        <translation>A&amp;bandonner le travail en cours</translation>
    </message>
    <message>
        <source>Let the camera &amp;roll</source>
        <translation>Autoriser le &amp;roulis de la caméra</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>&amp;Rétablir la disposition</translation>
    </message>
    <message>
        <source>Arra&amp;nge with the mouse</source>
        <translation>Disposer à la so&amp;uris</translation>
    </message>
    <message>
        <source>&amp;Place by a face or axis</source>
        <translation>&amp;Placer par une face ou un axe</translation>
    </message>
    <message>
        <source>Start &amp;here</source>
        <translation>Départ &amp;ici</translation>
    </message>
    <message>
        <source>&amp;Resolve start and goal collisions</source>
        <translation>Résoudre les co&amp;llisions du départ et du but</translation>
    </message>
    <message>
        <source>Rules of the strate&amp;gy...</source>
        <translation>Rè&amp;gles de la stratégie...</translation>
    </message>
    <message>
        <source>Open &amp;path...</source>
        <translation>Ouvrir un c&amp;hemin...</translation>
    </message>
    <message>
        <source>Remove &amp;edits without effect</source>
        <translation>Supprimer les &amp;modifications sans effet</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Préférences...</translation>
    </message>
    <message>
        <source>Swept &amp;volume</source>
        <translation>&amp;Volume balayé</translation>
    </message>
    <message>
        <source>&amp;Export the swept volume...</source>
        <translation>&amp;Exporter le volume balayé...</translation>
    </message>
    <message>
        <source>Show where the path is &amp;blocked</source>
        <translation>Montrer où le chemin est blo&amp;qué</translation>
    </message>
    <message>
        <source>&amp;Find fits</source>
        <translation>Chercher les a&amp;justements</translation>
    </message>
    <message>
        <source>&amp;Isolate the pair</source>
        <translation>&amp;Isoler la paire</translation>
    </message>
    <message>
        <source>&amp;Mark as a thread</source>
        <translation>Marquer comme &amp;filetage</translation>
    </message>
    <message>
        <source>&amp;Require clearance</source>
        <translation>Exiger un &amp;jeu</translation>
    </message>
    <message>
        <source>&amp;Fits panel</source>
        <translation>Panneau &amp;Ajustements</translation>
    </message>
    <message>
        <source>&amp;Show the overlap</source>
        <translation>Montrer le &amp;recouvrement</translation>
    </message>
    <message>
        <source>&amp;Allow the overlap as fits</source>
        <translation>&amp;Admettre comme ajustements</translation>
    </message>
    <message>
        <source>&amp;Make the kept path current</source>
        <translation>&amp;Rendre courant le chemin conservé</translation>
    </message>
    <message>
        <source>&amp;Compare paths</source>
        <translation>&amp;Comparer les chemins</translation>
    </message>
    <message>
        <source>&amp;Rename the kept path</source>
        <translation>Reno&amp;mmer le chemin conservé</translation>
    </message>
    <message>
        <source>Pin the &amp;kept path</source>
        <translation>Épi&amp;ngler le chemin conservé</translation>
    </message>
    <message>
        <source>Remove the kept &amp;path</source>
        <translation>&amp;Supprimer le chemin conservé</translation>
    </message>
    <message>
        <source>&amp;Orthographic projection</source>
        <translation>Projection &amp;orthographique</translation>
    </message>
    <message>
        <source>&amp;Log panel</source>
        <translation>Panneau &amp;Journal</translation>
    </message>
    <message>
        <source>&amp;Find a command...</source>
        <translation>Trouver une comman&amp;de...</translation>
    </message>
    <message>
        <source>&amp;Remove the attribute</source>
        <translation>&amp;Supprimer l&apos;attribut</translation>
    </message>
    <message>
        <source>Prefer the pla&amp;ce</source>
        <translation>&amp;Préférer le lieu</translation>
    </message>
    <message>
        <source>&amp;Set the milestone</source>
        <translation>Placer le &amp;jalon</translation>
    </message>
    <message>
        <source>Reset the &amp;milestone</source>
        <translation>&amp;Réinitialiser le jalon</translation>
    </message>
    <message>
        <source>&amp;Remove the selected bodies</source>
        <translation>&amp;Retirer les corps sélectionnés</translation>
    </message>
    <message>
        <source>Play the path in a &amp;loop</source>
        <translation>Jouer le chemin en &amp;boucle</translation>
    </message>
    <message>
        <source>&amp;Play the path backwards</source>
        <translation>&amp;Jouer le chemin à rebours</translation>
    </message>
    <message>
        <source>Fix as &amp;base</source>
        <translation>Fixer comme &amp;base</translation>
    </message>
    <message>
        <source>&amp;Open a sequence...</source>
        <translation>Ouvrir une &amp;séquence...</translation>
    </message>
    <message>
        <source>&amp;Save the sequence...</source>
        <translation>&amp;Enregistrer la séquence...</translation>
    </message>
    <message>
        <source>&amp;Play the sequence</source>
        <translation>&amp;Jouer la séquence</translation>
    </message>
    <message>
        <source>Order of &amp;assembly</source>
        <translation>&amp;Ordre du montage</translation>
    </message>
    <message>
        <source>Show the &amp;whole product</source>
        <translation>Montrer &amp;tout le produit</translation>
    </message>
    <message>
        <source>Seque&amp;nce panel</source>
        <translation>Panneau &amp;Séquence</translation>
    </message>
    <message>
        <source>Move the step &amp;up</source>
        <translation>Mo&amp;nter l&apos;étape</translation>
    </message>
    <message>
        <source>Move the step d&amp;own</source>
        <translation>&amp;Descendre l&apos;étape</translation>
    </message>
    <message>
        <source>&amp;Lock the step</source>
        <translation>&amp;Verrouiller l&apos;étape</translation>
    </message>
    <message>
        <source>&amp;Keep the order of the selected steps</source>
        <translation>&amp;Garder l&apos;ordre des étapes sélectionnées</translation>
    </message>
    <message>
        <source>Move the &amp;part by hand</source>
        <translation>Déplacer la pièce à la &amp;main</translation>
    </message>
    <message>
        <source>&amp;Back to the sequence</source>
        <translation>Retour à la &amp;séquence</translation>
    </message>
    <message>
        <source>&amp;Snap to steps</source>
        <translation>&amp;Déplacer par pas</translation>
    </message>
    <message>
        <source>&amp;Remove the constraints on the step</source>
        <translation>Supprime&amp;r les contraintes sur l&apos;étape</translation>
    </message>
    <message>
        <source>Open the context &amp;menu</source>
        <translation>Ouvrir le &amp;menu contextuel</translation>
    </message>
    <message>
        <source>&amp;Camera follows the object</source>
        <translation>La &amp;caméra suit l&apos;objet</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Par pas</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Path by author</source>
        <translation>Chemin par auteur</translation>
    </message>
    <message>
        <source>Allow as fits</source>
        <translation>Admettre comme ajustements</translation>
    </message>
    <message>
        <source>Where is it blocked?</source>
        <translation>Où est-il bloqué ?</translation>
    </message>
    <message>
        <source>Section across &amp;X</source>
        <translation>Coupe perpendiculaire à &amp;X</translation>
    </message>
    <message>
        <source>Section across &amp;Y</source>
        <translation>Coupe perpendiculaire à &amp;Y</translation>
    </message>
    <message>
        <source>Section across &amp;Z</source>
        <translation>Coupe perpendiculaire à &amp;Z</translation>
    </message>
    <message>
        <source>Cut bodies open across x; drag the arrow to move the section</source>
        <translation>Couper les corps perpendiculairement à x ; tirez la flèche pour déplacer la coupe</translation>
    </message>
    <message>
        <source>Cut bodies open across y; drag the arrow to move the section</source>
        <translation>Couper les corps perpendiculairement à y ; tirez la flèche pour déplacer la coupe</translation>
    </message>
    <message>
        <source>Cut bodies open across z; drag the arrow to move the section</source>
        <translation>Couper les corps perpendiculairement à z ; tirez la flèche pour déplacer la coupe</translation>
    </message>
    <message>
        <source>Section along a &amp;face</source>
        <translation>Coupe le long d&apos;une &amp;face</translation>
    </message>
    <message>
        <source>Click a face: the section lies along it, or through the axis of a cylinder</source>
        <translation>Cliquez une face : la coupe se place le long d&apos;elle, ou par l&apos;axe d&apos;un cylindre</translation>
    </message>
    <message>
        <source>&amp;Handles of sections</source>
        <translation>&amp;Poignées des coupes</translation>
    </message>
    <message>
        <source>Show outlines of sections, and arrows that drag them</source>
        <translation>Montrer les contours des coupes, et des flèches qui les déplacent</translation>
    </message>
    <message>
        <source>&amp;Remove all sections</source>
        <translation>&amp;Retirer toutes les coupes</translation>
    </message>
    <message>
        <source>Draw all bodies whole again</source>
        <translation>Dessiner de nouveau tous les corps entiers</translation>
    </message>
    <message>
        <source>Grou&amp;nd grid</source>
        <translation>Gri&amp;lle au sol</translation>
    </message>
    <message>
        <source>Show a grid under the product, in round lengths of the unit in use</source>
        <translation>Montrer une grille sous le produit, en longueurs rondes de l&apos;unité utilisée</translation>
    </message>
    <message>
        <source>Co&amp;py the measurement</source>
        <translation>Co&amp;pier la mesure</translation>
    </message>
    <message>
        <source>Put what was measured into the clipboard, as text</source>
        <translation>Mettre ce qui a été mesuré dans le presse-papiers, comme texte</translation>
    </message>
    <message>
        <source>Forbid place</source>
        <translation>Interdire le lieu</translation>
    </message>
    <message>
        <source>Prefer place</source>
        <translation>Préférer le lieu</translation>
    </message>
    <message>
        <source>Set milestone</source>
        <translation>Placer le jalon</translation>
    </message>
    <message>
        <source>Reset milestone</source>
        <translation>Réinitialiser le jalon</translation>
    </message>
    <message>
        <source>Draw the roadmap in full colours while a path is shown</source>
        <translation>Garder le graphe bien visible pendant qu&apos;un chemin est affiché</translation>
    </message>
    <message>
        <source>Forbid paths through the selected places, or allow them again</source>
        <translation>Interdire tout chemin par les lieux sélectionnés, ou les autoriser de nouveau</translation>
    </message>
    <message>
        <source>Save the recording of the last run, to replay it exactly</source>
        <translation>Sauvegarder l&apos;enregistrement du dernier calcul, pour le rejouer à l&apos;identique</translation>
    </message>
    <message>
        <source>Replay the last run, or the recording opened last, exactly</source>
        <translation>Rejouer à l&apos;identique le dernier calcul, ou le dernier enregistrement ouvert</translation>
    </message>
    <message>
        <source>Replay the same input of the operator with the present values of the sliders</source>
        <translation>Rejouer les gestes de l&apos;opérateur avec les réglages actuels des curseurs</translation>
    </message>
    <message>
        <source>Let the program set α, N and d while planning, or use your values again</source>
        <translation>Laisser le programme régler α, N et d pendant la planification, ou reprendre vos valeurs</translation>
    </message>
    <message>
        <source>Cancel the work in the background: reading, smoothing, looking for reasons</source>
        <translation>Arrêter le travail en arrière-plan&#xa0;: lecture, lissage, recherche des causes</translation>
    </message>
    <message>
        <source>Why there i&amp;s no path</source>
        <translation>Cau&amp;ses de l&apos;absence de chemin</translation>
    </message>
    <message>
        <source>Move start and goal out of contact and collision by the smallest distance that is found</source>
        <translation>Écarter le départ et le but de tout contact et de toute collision, de la plus petite distance trouvée</translation>
    </message>
    <message>
        <source>Fit the workspace to all bodies, with room to remove the object</source>
        <translation>Ajuster l&apos;espace de travail à tous les corps, avec la place nécessaire au démontage de l&apos;objet</translation>
    </message>
    <message>
        <source>Show the swept volume: all that the object covers along the path</source>
        <translation>Montrer tout le volume que l&apos;objet occupe le long du chemin, sans rien en omettre</translation>
    </message>
    <message>
        <source>&amp;Use the measured fit</source>
        <translation>&amp;Utiliser l&apos;ajustement mesuré</translation>
    </message>
    <message>
        <source>Keep the selected paths at the top of the list, or unpin them</source>
        <translation>Épingler les chemins sélectionnés en tête de la liste, ou les détacher</translation>
    </message>
    <message>
        <source>Show &amp;removed parts aside</source>
        <translation>Pièces so&amp;rties à côté du produit</translation>
    </message>
    <message>
        <source>Show which step precedes which, and which parts block the stuck ones</source>
        <translation>Montrer quelle étape précède quelle autre, et quelles pièces bloquent celles qui sont coincées</translation>
    </message>
    <message>
        <source>Keep the places and motions of the selected steps, or release them</source>
        <translation>Garder la place et le mouvement des étapes sélectionnées, ou les libérer</translation>
    </message>
    <message>
        <source>Put a vertex, an edge, an axis or a plane onto one of another body: click that of the moving part, then the other</source>
        <translation>Mettre un sommet, une arête, un axe ou un plan sur celui d&apos;un autre corps&#xa0;: cliquer celui de la pièce manipulée, puis l&apos;autre</translation>
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
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>&amp;Align...</source>
        <translation>&amp;Aligner...</translation>
    </message>
    <message>
        <source>E&amp;xclude the selected bodies</source>
        <translation>E&amp;xclure les corps sélectionnés</translation>
    </message>
    <message>
        <source>The selected bodies are kept in the scenario, and are not part of the product: variants that are not built</source>
        <translation>Les corps sélectionnés restent dans le scénario, et ne font pas partie du produit&#xa0;: variantes non construites</translation>
    </message>
    <message>
        <source>Choose &amp;variants...</source>
        <translation>Choisir les &amp;variantes...</translation>
    </message>
    <message>
        <source>Bodies that fill the same place: choose which of them is built</source>
        <translation>Corps qui remplissent le même endroit&#xa0;: choisir celui qui est construit</translation>
    </message>
    <message>
        <source>Incl&amp;ude the selected bodies</source>
        <translation>Inclur&amp;e les corps sélectionnés</translation>
    </message>
    <message>
        <source>The selected bodies under &quot;Excluded&quot; are part of the product again</source>
        <translation>Les corps sélectionnés sous «&#xa0;Exclus&#xa0;» font de nouveau partie du produit</translation>
    </message>
    <message>
        <source>&amp;Make moving part</source>
        <translation>Dé&amp;finir comme pièce manipulée</translation>
    </message>
    <message>
        <source>The selected bodies become the moving part, as one, from their present pose to &quot;removed&quot;; the moving part of before stays at its start</source>
        <translation>Les corps sélectionnés deviennent la pièce manipulée, ensemble, de leur position actuelle à «&#xa0;démonté&#xa0;»&#xa0;; la pièce manipulée d&apos;avant reste à son départ</translation>
    </message>
    <message>
        <source>Assembly &amp;times</source>
        <translation>Temps d&apos;&amp;assemblage</translation>
    </message>
    <message>
        <source>Show the times of the steps, the critical path, and the balance of a line with several stations</source>
        <translation>Montrer les temps des étapes, le chemin critique et l&apos;équilibrage d&apos;une ligne à plusieurs postes</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Confirmer</translation>
    </message>
    <message>
        <source>Confirm all</source>
        <translation>Tout confirmer</translation>
    </message>
    <message>
        <source>Dissolve</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Make...</source>
        <translation>Créer...</translation>
    </message>
    <message>
        <source>Find &amp;joints</source>
        <translation>Chercher les &amp;liaisons</translation>
    </message>
    <message>
        <source>List how the bodies are joined: screws, nuts, inserts, pins, units</source>
        <translation>Lister comment les corps sont liés&#xa0;: vis, écrous, inserts, goupilles, unités</translation>
    </message>
    <message>
        <source>&amp;Isolate the bodies of the joint</source>
        <translation>&amp;Isoler les corps de la liaison</translation>
    </message>
    <message>
        <source>Draw the bodies of the selected joints and no other obstacles</source>
        <translation>N&apos;afficher que les corps des liaisons sélectionnées, sans les autres obstacles</translation>
    </message>
    <message>
        <source>&amp;Confirm the joint</source>
        <translation>&amp;Confirmer la liaison</translation>
    </message>
    <message>
        <source>The selected joints exist as they were found; assembly plans respect them</source>
        <translation>Les liaisons sélectionnées existent telles qu&apos;elles ont été trouvées&#xa0;; les plans d&apos;assemblage les respectent</translation>
    </message>
    <message>
        <source>Confirm &amp;all suggested joints</source>
        <translation>Confirmer les liaisons &amp;proposées</translation>
    </message>
    <message>
        <source>All joints that are only suggested exist</source>
        <translation>Toutes les liaisons seulement proposées existent</translation>
    </message>
    <message>
        <source>&amp;Dissolve the joint</source>
        <translation>&amp;Supprimer la liaison</translation>
    </message>
    <message>
        <source>The selected joints do not exist; assembly plans ignore them</source>
        <translation>Les liaisons sélectionnées n&apos;existent pas&#xa0;; les plans d&apos;assemblage les ignorent</translation>
    </message>
    <message>
        <source>&amp;Press the insert out</source>
        <translation>C&amp;hasser l&apos;insert</translation>
    </message>
    <message>
        <source>The selected inserts are pressed out of their hosts along their axes</source>
        <translation>Les inserts sélectionnés sont chassés de leur logement le long de leur axe</translation>
    </message>
    <message>
        <source>&amp;Open the unit</source>
        <translation>&amp;Ouvrir l&apos;unité</translation>
    </message>
    <message>
        <source>The bodies of the selected units are disassembled</source>
        <translation>Les corps des unités sélectionnées se démontent</translation>
    </message>
    <message>
        <source>&amp;Use the joint as found</source>
        <translation>&amp;Utiliser la liaison trouvée</translation>
    </message>
    <message>
        <source>Undo the decision about the selected joints</source>
        <translation>Annuler la décision sur les liaisons sélectionnées</translation>
    </message>
    <message>
        <source>C&amp;hange the joint...</source>
        <translation>&amp;Modifier la liaison...</translation>
    </message>
    <message>
        <source>Give the selected joint another kind, direction, thread or bend</source>
        <translation>Donner à la liaison sélectionnée un autre type, une autre direction, un autre filetage ou une autre flexion</translation>
    </message>
    <message>
        <source>&amp;Make a joint...</source>
        <translation>C&amp;réer une liaison...</translation>
    </message>
    <message>
        <source>Join the selected bodies; find the joints first</source>
        <translation>Lier les corps sélectionnés&#xa0;; cherchez d&apos;abord les liaisons</translation>
    </message>
    <message>
        <source>&amp;Joints panel</source>
        <translation>Panneau &amp;Liaisons</translation>
    </message>
    <message>
        <source>Bring the table of joints to the front</source>
        <translation>Mettre le tableau des liaisons au premier plan</translation>
    </message>
    <message>
        <source>Report of the se&amp;quence...</source>
        <translation>Rapport de la sé&amp;quence...</translation>
    </message>
    <message>
        <source>Save the report of the plan for the engineer: motions, clearances, allowances, checks and times</source>
        <translation>Enregistrer le rapport du plan pour l&apos;ingénieur&#xa0;: mouvements, jeux, amincissements, vérifications et temps</translation>
    </message>
    <message>
        <source>Work instructions on &amp;Letter paper</source>
        <translation>Gammes de montage sur &amp;papier Letter</translation>
    </message>
    <message>
        <source>Lay out work instructions for sheets of US Letter, or for A4</source>
        <translation>Mettre en page les gammes de montage pour des feuilles US Letter, ou A4</translation>
    </message>
    <message>
        <source>Te&amp;mplate of work instructions...</source>
        <translation>&amp;Modèle des gammes de montage...</translation>
    </message>
    <message>
        <source>Choose a file with the logo, columns, language and paper of work instructions</source>
        <translation>Choisir un fichier avec le logo, les colonnes, la langue et le papier des gammes de montage</translation>
    </message>
    <message>
        <source>Work &amp;instructions without a template</source>
        <translation>Gammes de montage sans mo&amp;dèle</translation>
    </message>
    <message>
        <source>Write work instructions in the language of the window, without a logo</source>
        <translation>Écrire les gammes de montage dans la langue de la fenêtre, sans logo</translation>
    </message>
    <message>
        <source>&amp;Film of the sequence...</source>
        <translation>&amp;Film de la séquence...</translation>
    </message>
    <message>
        <source>Film the 3D view while the sequence is played: MP4, WebM or pictures</source>
        <translation>Filmer la vue 3D pendant la lecture de la séquence : MP4, WebM ou images</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>Lége&amp;nde</translation>
    </message>
    <message>
        <source>Say what the colours in the scene mean: a row for each thing that is drawn now</source>
        <translation>Dire ce que signifient les couleurs de la scène&#xa0;: une ligne par chose dessinée en ce moment</translation>
    </message>
    <message>
        <source>Work instru&amp;ction...</source>
        <translation>Gamme de mo&amp;ntage...</translation>
    </message>
    <message>
        <source>&amp;Follow the head</source>
        <translation>&amp;Suivre la tête</translation>
    </message>
    <message>
        <source>The view follows a head that a tracker (OpenTrack) sees before the screen</source>
        <translation>La vue suit une tête qu&apos;un capteur (OpenTrack) voit devant l&apos;écran</translation>
    </message>
    <message>
        <source>Calibrate the &amp;head tracker...</source>
        <translation>Étalonner le capteur de &amp;tête...</translation>
    </message>
    <message>
        <source>Port, axes, signs, rest and delay of the head tracker, with live values</source>
        <translation>Port, axes, signes, repos et retard du capteur de tête, avec les valeurs en direct</translation>
    </message>
    <message>
        <source>&amp;No stereo</source>
        <translation>Sans stéré&amp;o</translation>
    </message>
    <message>
        <source>Draw the scene for both eyes alike</source>
        <translation>Dessiner la scène de la même façon pour les deux yeux</translation>
    </message>
    <message>
        <source>&amp;Anaglyph, red and cyan</source>
        <translation>&amp;Anaglyphe, rouge et cyan</translation>
    </message>
    <message>
        <source>Draw the scene for glasses with a red and a cyan filter; colours stay</source>
        <translation>Dessiner la scène pour des lunettes à filtres rouge et cyan ; les couleurs restent</translation>
    </message>
    <message>
        <source>S&amp;ide by side</source>
        <translation>&amp;Côte à côte</translation>
    </message>
    <message>
        <source>Draw the left half for one eye, the right half for the other</source>
        <translation>Dessiner la moitié gauche pour un œil, la moitié droite pour l&apos;autre</translation>
    </message>
    <message>
        <source>&amp;Top and bottom</source>
        <translation>En &amp;haut et en bas</translation>
    </message>
    <message>
        <source>Draw the upper half for one eye, the lower half for the other</source>
        <translation>Dessiner la moitié haute pour un œil, la moitié basse pour l&apos;autre</translation>
    </message>
    <message>
        <source>Int&amp;erlaced</source>
        <translation>&amp;Entrelacé</translation>
    </message>
    <message>
        <source>Draw the rows of the screen for one eye and the other in turn</source>
        <translation>Dessiner les lignes de l&apos;écran tour à tour pour un œil et pour l&apos;autre</translation>
    </message>
    <message>
        <source>&amp;Checkerboard</source>
        <translation>&amp;Damier</translation>
    </message>
    <message>
        <source>Draw the pixels of the screen for one eye and the other in turn</source>
        <translation>Dessiner les pixels de l&apos;écran tour à tour pour un œil et pour l&apos;autre</translation>
    </message>
    <message>
        <source>&amp;Quad buffer</source>
        <translation>&amp;Quatre tampons</translation>
    </message>
    <message>
        <source>Let the driver show each eye its picture: shutter glasses</source>
        <translation>Laisser le pilote montrer à chaque œil son image : lunettes à obturateurs</translation>
    </message>
    <message>
        <source>&amp;Left eye only</source>
        <translation>Œil &amp;gauche seul</translation>
    </message>
    <message>
        <source>Draw the scene as the left eye sees it</source>
        <translation>Dessiner la scène comme l&apos;œil gauche la voit</translation>
    </message>
    <message>
        <source>&amp;Right eye only</source>
        <translation>Œil d&amp;roit seul</translation>
    </message>
    <message>
        <source>Draw the scene as the right eye sees it</source>
        <translation>Dessiner la scène comme l&apos;œil droit la voit</translation>
    </message>
    <message>
        <source>&amp;Swap the eyes</source>
        <translation>Échanger les &amp;yeux</translation>
    </message>
    <message>
        <source>Show the picture of the left eye to the right one, and the other way round</source>
        <translation>Montrer l&apos;image de l&apos;œil gauche à l&apos;œil droit, et inversement</translation>
    </message>
    <message>
        <source>Stereo an&amp;d screen...</source>
        <translation>Stéréo et écra&amp;n...</translation>
    </message>
    <message>
        <source>Size and distance of the screen, separation of the eyes, what lies in its plane</source>
        <translation>Taille et distance de l&apos;écran, écart des yeux, ce qui se trouve dans son plan</translation>
    </message>
    <message>
        <source>Show at true si&amp;ze</source>
        <translation>Montrer à la &amp;taille vraie</translation>
    </message>
    <message>
        <source>What is in the middle of the view has its true size on the screen</source>
        <translation>Ce qui est au milieu de la vue a sa taille vraie à l&apos;écran</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>Show the scene alone on a whole display; commands keep their keys</source>
        <translation>Montrer la scène seule sur un écran entier ; les commandes gardent leurs touches</translation>
    </message>
    <message>
        <source>Show the scene in a headset (OpenXR), or stop it</source>
        <translation>Montrer la scène dans un casque (OpenXR), ou l&apos;arrêter</translation>
    </message>
    <message>
        <source>In the headset the product is as large as a table has room for, or at true scale</source>
        <translation>Dans le casque, le produit a la taille pour laquelle une table a de la place, ou l&apos;échelle vraie</translation>
    </message>
    <message>
        <source>&amp;Show the scene in a headset</source>
        <translation>&amp;Montrer la scène dans un casque</translation>
    </message>
    <message>
        <source>&amp;Product on a table in the headset</source>
        <translation>&amp;Produit sur une table dans le casque</translation>
    </message>
    <message>
        <source>Change steering &amp;axes</source>
        <translation>Changer les &amp;axes de guidage</translation>
    </message>
    <message>
        <source>Move along the axes of the view, of the world or of the object</source>
        <translation>Déplacer selon les axes de la vue, du monde ou de l&apos;objet</translation>
    </message>
    <message>
        <source>Help where the search &amp;is stuck</source>
        <translation>Aider là où la recherche est &amp;bloquée</translation>
    </message>
    <message>
        <source>Take your hand and the view to the next place where the search is stuck</source>
        <translation>Conduire votre main et la vue au prochain endroit où la recherche est bloquée</translation>
    </message>
    <message>
        <source>Sh&amp;ow where your hand helps</source>
        <translation>Montrer où votre ma&amp;in est utile</translation>
    </message>
    <message>
        <source>Show where the trees come nearest, and how much more room the object needs</source>
        <translation>Montrer où les arbres sont le plus proches, et combien de place il manque à l&apos;objet</translation>
    </message>
    <message>
        <source>Steering ke&amp;ys</source>
        <translation>&amp;Touches de guidage</translation>
    </message>
    <message>
        <source>Show the steering keys over the scene during a run by hand</source>
        <translation>Montrer les touches de guidage dans la vue pendant un calcul guidé à la main</translation>
    </message>
    <message>
        <source>Where your &amp;hand helps</source>
        <translation>Où votre main est &amp;utile</translation>
    </message>
    <message>
        <source>Show the places where your hand helps the search, and the arrow that leads there</source>
        <translation>Montrer les endroits où votre main aide la recherche, et la flèche qui y mène</translation>
    </message>
    <message>
        <source>&amp;Left hand takes the object</source>
        <translation>La main &amp;gauche prend l&apos;objet</translation>
    </message>
    <message>
        <source>In the headset the left controller takes the object, or the right one</source>
        <translation>Dans le casque, la manette gauche prend l&apos;objet, ou bien la droite</translation>
    </message>
    <message>
        <source>&amp;Grip sets the computer&apos;s share</source>
        <translation>La prise &amp;règle la part de l&apos;ordinateur</translation>
    </message>
    <message>
        <source>The firmer a controller holds the object, the smaller α is; let go, α is as before</source>
        <translation>Plus une manette serre l&apos;objet, plus α est petit&#xa0;; une fois l&apos;objet lâché, α est comme avant</translation>
    </message>
    <message>
        <source>Panel &amp;before me in the headset</source>
        <translation>Panneau &amp;devant moi dans le casque</translation>
    </message>
    <message>
        <source>The panel in the headset stays before you, or goes with the other hand</source>
        <translation>Le panneau dans le casque reste devant vous, ou suit l&apos;autre main</translation>
    </message>
    <message>
        <source>Se&amp;ction at the hand</source>
        <translation>&amp;Coupe à la main</translation>
    </message>
    <message>
        <source>Cut bodies open where a controller of the headset is; the section follows the hand while its button is held</source>
        <translation>Couper les corps là où est une manette du casque ; la coupe suit la main tant que son bouton est maintenu</translation>
    </message>
    <message>
        <source>&amp;Measure with the ray</source>
        <translation>M&amp;esurer avec le rayon</translation>
    </message>
    <message>
        <source>Take the point that the ray of a controller meets; the second one is measured from the first one</source>
        <translation>Prendre le point que le rayon d&apos;une manette rencontre ; le second est mesuré depuis le premier</translation>
    </message>
    <message>
        <source>&amp;Walk through the instruction</source>
        <translation>&amp;Suivre la gamme de montage</translation>
    </message>
    <message>
        <source>In the headset: take the part that is marked and lead it along its motion to where it belongs, step by step</source>
        <translation>Dans le casque : prendre la pièce marquée et la mener sur son mouvement jusqu&apos;à sa place, étape par étape</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>Étape pré&amp;cédente</translation>
    </message>
    <message>
        <source>Show the step before the one that is shown</source>
        <translation>Montrer l&apos;étape avant celle qui est montrée</translation>
    </message>
    <message>
        <source>Ne&amp;xt step</source>
        <translation>Étape s&amp;uivante</translation>
    </message>
    <message>
        <source>Show the step after the one that is shown</source>
        <translation>Montrer l&apos;étape après celle qui est montrée</translation>
    </message>
    <message>
        <source>Check hand access for the &amp;sequence</source>
        <translation>Vérifier l&apos;accès de la main pour la &amp;séquence</translation>
    </message>
    <message>
        <source>Check for each step whether hand, forearm and tool reach the work, and whether it is visible</source>
        <translation>Vérifier à chaque étape si la main, l&apos;avant-bras et l&apos;outil accèdent au travail, et s&apos;il est visible</translation>
    </message>
    <message>
        <source>Check hand access along the &amp;path</source>
        <translation>Vérifier l&apos;accès de la main le long du &amp;chemin</translation>
    </message>
    <message>
        <source>Check whether a hand that holds the object stays free of collision along the path</source>
        <translation>Vérifier si une main qui tient l&apos;objet reste sans collision le long du chemin</translation>
    </message>
    <message>
        <source>&amp;Next step without hand access</source>
        <translation>Étape s&amp;uivante sans accès de la main</translation>
    </message>
    <message>
        <source>Show the next step that is not reachable or not visible, where the hand is blocked</source>
        <translation>Montrer l&apos;étape suivante inaccessible ou invisible, là où la main est bloquée</translation>
    </message>
    <message>
        <source>Show the &amp;hand on the moving part</source>
        <translation>Afficher la m&amp;ain sur la pièce manipulée</translation>
    </message>
    <message>
        <source>Draw hand, forearm and tool where they can hold the moving part</source>
        <translation>Dessiner la main, l&apos;avant-bras et l&apos;outil là où ils peuvent tenir la pièce manipulée</translation>
    </message>
    <message>
        <source>Hand of a small &amp;woman</source>
        <translation>Main d&apos;une petite &amp;femme</translation>
    </message>
    <message>
        <source>Check with the hand of the 5th percentile of women</source>
        <translation>Vérifier avec la main du 5e centile des femmes</translation>
    </message>
    <message>
        <source>&amp;Average hand</source>
        <translation>Main mo&amp;yenne</translation>
    </message>
    <message>
        <source>Check with the mean of the median hands of women and men</source>
        <translation>Vérifier avec la moyenne des mains médianes des femmes et des hommes</translation>
    </message>
    <message>
        <source>Hand of a large &amp;man</source>
        <translation>Main d&apos;un grand &amp;homme</translation>
    </message>
    <message>
        <source>Check with the hand of the 95th percentile of men</source>
        <translation>Vérifier avec la main du 95e centile des hommes</translation>
    </message>
    <message>
        <source>&amp;Figures of drawing in the headset</source>
        <translation>C&amp;hiffres du dessin dans le casque</translation>
    </message>
    <message>
        <source>Say what a picture of the headset costs, and how simple the scene is for it</source>
        <translation>Dire ce que coûte une image du casque, et combien la scène est simplifiée pour lui</translation>
    </message>
    <message>
        <source>Write the page of a study with its tables and plots, and open it in the browser</source>
        <translation>Écrire la page d&apos;une étude avec ses tableaux et ses courbes, et l&apos;ouvrir dans le navigateur</translation>
    </message>
    <message>
        <source>Open ru&amp;n of a study...</source>
        <translation>Ouvrir un &amp;essai d&apos;une étude...</translation>
    </message>
    <message>
        <source>Show a run of a study again, from its file runs/cellN-seedM.json</source>
        <translation>Revoir un essai d&apos;une étude, à partir de son fichier runs/cellN-seedM.json</translation>
    </message>
    <message>
        <source>Plan sequence</source>
        <translation>Planifier la séquence</translation>
    </message>
    <message>
        <source>Instruction</source>
        <translation>Instruction</translation>
    </message>
    <message>
        <source>options settings</source>
        <translation>options réglages paramètres</translation>
    </message>
    <message>
        <source>undock dock floating panels windows</source>
        <translation>détacher ancrer panneaux fenêtres</translation>
    </message>
    <message>
        <source>move rotate drag transform</source>
        <translation>déplacer tourner transformer</translation>
    </message>
    <message>
        <source>mate constraint coincident concentric</source>
        <translation>contrainte coïncidence coaxial</translation>
    </message>
    <message>
        <source>bounding box limits</source>
        <translation>boîte englobante limites</translation>
    </message>
    <message>
        <source>interference detection clash check collision tolerance contacts</source>
        <translation>interférence détection collision recouvrement contacts tolérance</translation>
    </message>
    <message>
        <source>ignore interference allow</source>
        <translation>ignorer interférence admettre</translation>
    </message>
    <message>
        <source>fasteners screws bolts nuts connections mates</source>
        <translation>fixations vis boulons écrous assemblages</translation>
    </message>
    <message>
        <source>interference clash contact tolerance</source>
        <translation>interférence collision contact tolérance</translation>
    </message>
    <message>
        <source>fasteners screws bolts mates connections</source>
        <translation>fixations vis boulons</translation>
    </message>
    <message>
        <source>import STEP CAD mesh</source>
        <translation>importer CAO maillage</translation>
    </message>
    <message>
        <source>load import</source>
        <translation>charger importer</translation>
    </message>
    <message>
        <source>keyboard keys hotkeys</source>
        <translation>clavier raccourci</translation>
    </message>
    <message>
        <source>ruler dimension length</source>
        <translation>règle cote longueur</translation>
    </message>
    <message>
        <source>gap minimum distance</source>
        <translation>écart distance minimale</translation>
    </message>
    <message>
        <source>save path</source>
        <translation>enregistrer le chemin</translation>
    </message>
    <message>
        <source>animate simulate</source>
        <translation>animer simuler</translation>
    </message>
    <message>
        <source>shorten optimize</source>
        <translation>raccourcir optimiser</translation>
    </message>
    <message>
        <source>video animation movie record</source>
        <translation>vidéo animation enregistrer</translation>
    </message>
    <message>
        <source>envelope space reservation</source>
        <translation>enveloppe encombrement</translation>
    </message>
    <message>
        <source>import insert component</source>
        <translation>importer insérer composant</translation>
    </message>
    <message>
        <source>suppress leave out omit</source>
        <translation>supprimer écarter omettre</translation>
    </message>
    <message>
        <source>configurations alternatives duplicates</source>
        <translation>configurations alternatives doublons</translation>
    </message>
    <message>
        <source>unsuppress restore put back</source>
        <translation>rétablir remettre réintégrer</translation>
    </message>
    <message>
        <source>active component manipulate part to remove</source>
        <translation>composant actif manipuler</translation>
    </message>
    <message>
        <source>remove extract unmount out</source>
        <translation>extraire déposer dehors</translation>
    </message>
    <message>
        <source>blank invisible</source>
        <translation>invisible cacher</translation>
    </message>
    <message>
        <source>solo show only</source>
        <translation>montrer seulement</translation>
    </message>
    <message>
        <source>unhide</source>
        <translation>afficher tout</translation>
    </message>
    <message>
        <source>clear interference penetration separate</source>
        <translation>dégager interférence pénétration écarter</translation>
    </message>
    <message>
        <source>solve plan motion removal path extract simulate</source>
        <translation>résoudre planifier mouvement démontage extraire</translation>
    </message>
    <message>
        <source>resume continue</source>
        <translation>reprendre continuer</translation>
    </message>
    <message>
        <source>computer share authority</source>
        <translation>part de l&apos;ordinateur autorité</translation>
    </message>
    <message>
        <source>blocked bottleneck tight stuck</source>
        <translation>bloqué goulet étroit coincé</translation>
    </message>
    <message>
        <source>clip cut cross-section clipping plane</source>
        <translation>couper plan de coupe</translation>
    </message>
    <message>
        <source>disassemble disassembly assembly order dismantle</source>
        <translation>démonter désassembler démontage ordre montage</translation>
    </message>
    <message>
        <source>continue</source>
        <translation>continuer poursuivre</translation>
    </message>
    <message>
        <source>ground anchor fixed fixture</source>
        <translation>ancrer bloquer fixe bâti</translation>
    </message>
    <message>
        <source>import load</source>
        <translation>importer charger</translation>
    </message>
    <message>
        <source>CSV GLB JSON export</source>
        <translation>exporter</translation>
    </message>
    <message>
        <source>BOM bill of materials parts list manual documentation</source>
        <translation>nomenclature liste des pièces gamme documentation</translation>
    </message>
    <message>
        <source>BOM bill of materials parts list documentation</source>
        <translation>nomenclature liste des pièces documentation</translation>
    </message>
    <message>
        <source>order constraints predecessors</source>
        <translation>ordre précédence antécédents</translation>
    </message>
    <message>
        <source>cycle time takt line balancing duration critical path</source>
        <translation>durée cadence cycle équilibrage chemin critique</translation>
    </message>
    <message>
        <source>pin freeze</source>
        <translation>figer geler</translation>
    </message>
    <message>
        <source>forbid direction prohibit</source>
        <translation>exclure empêcher direction</translation>
    </message>
    <message>
        <source>precedence constraint before after</source>
        <translation>antériorité précédence avant après</translation>
    </message>
    <message>
        <source>manual drag</source>
        <translation>manuel déplacer</translation>
    </message>
    <message>
        <source>accept apply keep</source>
        <translation>accepter appliquer garder</translation>
    </message>
    <message>
        <source>ergonomics reach manikin human</source>
        <translation>ergonomie atteinte mannequin</translation>
    </message>
    <message>
        <source>explode exploded view BOM disassembly</source>
        <translation>éclater vue éclatée nomenclature démontage</translation>
    </message>
    <message>
        <source>zoom all extents</source>
        <translation>zoomer tout</translation>
    </message>
    <message>
        <source>transparent x-ray</source>
        <translation>transparence rayons x</translation>
    </message>
    <message>
        <source>Finish for &amp;me</source>
        <translation>&amp;Finir à ma place</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>&amp;Assembly</source>
        <translation>&amp;Assemblage</translation>
    </message>
    <message>
        <source>Show the panels for products: their bodies and the sequence</source>
        <translation>Affiche les panneaux des produits&#xa0;: leurs corps et la séquence</translation>
    </message>
    <message>
        <source>workspace layout product</source>
        <translation>espace de travail disposition produit</translation>
    </message>
    <message>
        <source>&amp;Path planning</source>
        <translation>&amp;Planification de chemin</translation>
    </message>
    <message>
        <source>Show the panels for one motion: its strategy, its run and its path</source>
        <translation>Affiche les panneaux d&apos;un mouvement&#xa0;: sa stratégie, son calcul et son chemin</translation>
    </message>
    <message>
        <source>Path planning</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>workspace layout motion</source>
        <translation>espace de travail disposition mouvement</translation>
    </message>
    <message>
        <source>&amp;Study</source>
        <translation>É&amp;tude</translation>
    </message>
    <message>
        <source>Show all panels of a run, the bodies and the log, for research</source>
        <translation>Affiche tous les panneaux d&apos;un calcul, les corps et le journal, pour la recherche</translation>
    </message>
    <message>
        <source>workspace layout research</source>
        <translation>espace de travail disposition recherche</translation>
    </message>
    <message>
        <source>&amp;Bodies panel</source>
        <translation>Panneau C&amp;orps</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>Fer&amp;mer</translation>
    </message>
    <message>
        <source>Close the scenario and show the welcome page</source>
        <translation>Ferme le scénario et affiche la page d&apos;accueil</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>No&amp;uvelle fenêtre</translation>
    </message>
    <message>
        <source>Open another window, for another scenario</source>
        <translation>Ouvre une autre fenêtre, pour un autre scénario</translation>
    </message>
    <message>
        <source>&amp;Kept paths panel</source>
        <translation>Panneau Chemins co&amp;nservés</translation>
    </message>
    <message>
        <source>Pla&amp;ces panel</source>
        <translation>Panneau L&amp;ieux</translation>
    </message>
    <message>
        <source>Bring the places and the attributes to the front</source>
        <translation>Met les lieux et les attributs au premier plan</translation>
    </message>
    <message>
        <source>Coarse &amp;plan panel</source>
        <translation>Panneau Plan &amp;grossier</translation>
    </message>
    <message>
        <source>R&amp;ename...</source>
        <translation>Re&amp;nommer...</translation>
    </message>
    <message>
        <source>Give the selected body another name (F2 in the list of bodies)</source>
        <translation>Donne un autre nom au corps sélectionné (F2 dans la liste des corps)</translation>
    </message>
    <message>
        <source>Pr&amp;operties</source>
        <translation>Pr&amp;opriétés</translation>
    </message>
    <message>
        <source>Show the attributes of what is selected: class, mass, mobility</source>
        <translation>Affiche les attributs de la sélection&#xa0;: classe, masse, mobilité</translation>
    </message>
    <message>
        <source>attributes mass material class</source>
        <translation>attributs masse matériau classe</translation>
    </message>
    <message>
        <source>Hide the selected obstacles (also H); planning still takes them into account</source>
        <translation>Masquer les obstacles sélectionnés (aussi H)&#xa0;; la planification en tient toujours compte</translation>
    </message>
    <message>
        <source>&amp;Why not panel</source>
        <translation>Panneau Po&amp;urquoi non</translation>
    </message>
    <message>
        <source>&amp;Section bar</source>
        <translation>&amp;Barre des coupes</translation>
    </message>
    <message>
        <source>Show the bar of the section planes</source>
        <translation>Affiche la barre des plans de coupe</translation>
    </message>
    <message>
        <source>Compare with a revisio&amp;n...</source>
        <translation>Comparer a&amp;vec une révision...</translation>
    </message>
    <message>
        <source>Compare the product with a file of another revision, and judge each step in it</source>
        <translation>Comparer le produit avec un fichier d&apos;une autre révision, et y juger chaque étape</translation>
    </message>
    <message>
        <source>version change difference update engineering change</source>
        <translation>version changement différence mise à jour modification</translation>
    </message>
    <message>
        <source>Bac&amp;k to the start place</source>
        <translation>Re&amp;venir à la place de départ</translation>
    </message>
    <message>
        <source>In the headset, go back to where the scenario was first seen</source>
        <translation>Dans le casque, revenir à l&apos;endroit d&apos;où le scénario a d&apos;abord été vu</translation>
    </message>
    <message>
        <source>S&amp;elect with the ray</source>
        <translation>Sélec&amp;tionner avec le rayon</translation>
    </message>
    <message>
        <source>Select the body that the ray of a controller meets</source>
        <translation>Sélectionner le corps que le rayon d&apos;une manette rencontre</translation>
    </message>
    <message>
        <source>Lea&amp;ve the headset</source>
        <translation>&amp;Quitter le casque</translation>
    </message>
    <message>
        <source>Stop showing the scene in the headset</source>
        <translation>Ne plus montrer la scène dans le casque</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Open a scenario, a product (STEP, IGES, BREP), part files, or an OMPL.app problem</source>
        <translation>Ouvrir un scénario, un produit (STEP, IGES, BREP), des fichiers de pièces ou un problème OMPL.app</translation>
    </message>
    <message>
        <source>Save the pages for the line, once the sequence is planned: what is done, with which tool and which parts</source>
        <translation>Enregistrer les pages pour la ligne, une fois la séquence planifiée : ce qu&apos;il faut faire, avec quel outil et quelles pièces</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Arrê&amp;ter</translation>
    </message>
    <message>
        <source>Stop the run, or else the work in the background; results are kept</source>
        <translation>Arrêter l&apos;exécution, ou sinon le travail en arrière-plan&#xa0;; les résultats sont gardés</translation>
    </message>
    <message>
        <source>Let the automatic planners finish the run at full speed, from the way of your hand if it is kept</source>
        <translation>Laisser les planificateurs automatiques terminer l&apos;exécution à pleine vitesse, depuis le chemin de votre main s&apos;il est gardé</translation>
    </message>
    <message>
        <source>Plan with a fresh roadmap and the current seed; a run that your hand leads begins with its first motion</source>
        <translation>Planifier à partir d&apos;un graphe vide, avec la graine courante&#xa0;; un calcul que mène votre main commence à son premier mouvement</translation>
    </message>
    <message>
        <source>Pause the run and the object in your hand, or resume them</source>
        <translation>Suspendre le calcul et l&apos;objet dans votre main, ou les reprendre</translation>
    </message>
    <message>
        <source>Go back to the start pose and find the path again with the same seed; a run that your hand leads begins with its first motion</source>
        <translation>Revenir à la pose de départ et chercher de nouveau le chemin avec la même graine&#xa0;; un calcul que mène votre main commence à son premier mouvement</translation>
    </message>
    <message>
        <source>Move the selected step of the sequence one row up if the motions stay free</source>
        <translation>Déplacer l&apos;étape sélectionnée d&apos;une ligne vers le haut si les mouvements restent libres</translation>
    </message>
    <message>
        <source>Move the selected step of the sequence one row down if the motions stay free</source>
        <translation>Déplacer l&apos;étape sélectionnée d&apos;une ligne vers le bas si les mouvements restent libres</translation>
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
    <name>FilmWriter</name>
    <message>
        <source>Series of pictures (*.png)</source>
        <translation>Série d&apos;images (*.png)</translation>
    </message>
    <message>
        <source>Film (*.mp4);;Film (*.webm)</source>
        <translation>Film (*.mp4);;Film (*.webm)</translation>
    </message>
</context>
<context>
    <name>FrameName</name>
    <message>
        <source>axes of the view</source>
        <translation>axes de la vue</translation>
    </message>
    <message>
        <source>axes of the world</source>
        <translation>axes du monde</translation>
    </message>
    <message>
        <source>axes of the object</source>
        <translation>axes de l&apos;objet</translation>
    </message>
</context>
<context>
    <name>HandLead</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>HeadsetQuestions</name>
    <message>
        <source>This dialog is in the window. Take the headset off to answer it.</source>
        <translation>Ce dialogue est dans la fenêtre. Retirez le casque pour y répondre.</translation>
    </message>
    <message>
        <source>Close it</source>
        <translation>Le fermer</translation>
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
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>About Glissade</source>
        <translation>À propos de Glissade</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Glissade %1&lt;/h3&gt;&lt;p&gt;A workbench for virtual assembly: certified motions, found by a planner and a person together.&lt;/p&gt;&lt;p&gt;N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, &lt;i&gt;Tuning Interaction in Motion Planning with Contact&lt;/i&gt;, IEEE RO-MAN 2016.&lt;/p&gt;&lt;p&gt;S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, &lt;i&gt;Multi-layer path planning control for the simulation of manipulation tasks&lt;/i&gt;, RCIM 57, 2019.&lt;/p&gt;&lt;p&gt;BSD 3-Clause licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Glissade %1&lt;/h3&gt;&lt;p&gt;Un établi pour l&apos;assemblage virtuel&#xa0;: des mouvements certifiés, trouvés ensemble par un planificateur et une personne.&lt;/p&gt;&lt;p&gt;N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, &lt;i&gt;Tuning Interaction in Motion Planning with Contact&lt;/i&gt;, IEEE RO-MAN 2016.&lt;/p&gt;&lt;p&gt;S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, &lt;i&gt;Multi-layer path planning control for the simulation of manipulation tasks&lt;/i&gt;, RCIM 57, 2019.&lt;/p&gt;&lt;p&gt;Licence BSD à 3 clauses.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>While the 3D view has the focus; directions are those of the view, until F chooses other axes.</source>
        <translation>Quand la vue 3D a le focus&#xa0;; les directions sont celles de la vue, tant que la touche F n&apos;en choisit pas d&apos;autres.</translation>
    </message>
</context>
<context>
    <name>Joints</name>
    <message>
        <source>%1 turns</source>
        <translation>%1 tours</translation>
    </message>
    <message>
        <source>screw</source>
        <translation>vis</translation>
    </message>
    <message>
        <source>nut</source>
        <translation>écrou</translation>
    </message>
    <message>
        <source>insert</source>
        <translation>insert</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>goupille</translation>
    </message>
    <message>
        <source>snap</source>
        <translation>clip</translation>
    </message>
    <message>
        <source>flexible</source>
        <translation>souple</translation>
    </message>
    <message>
        <source>permanent</source>
        <translation>permanente</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>recognised</source>
        <translation>reconnue</translation>
    </message>
    <message>
        <source>suggested</source>
        <translation>proposée</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>confirmée</translation>
    </message>
    <message>
        <source>user-defined</source>
        <translation>définie par l&apos;utilisateur</translation>
    </message>
    <message>
        <source>pressed out</source>
        <translation>chassée</translation>
    </message>
    <message>
        <source>dissolved</source>
        <translation>supprimée</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>impossible</translation>
    </message>
    <message>
        <source>bends %1</source>
        <translation>fléchit de %1</translation>
    </message>
    <message>
        <source>outer hexagon</source>
        <translation>hexagone extérieur</translation>
    </message>
    <message>
        <source>hexagon socket</source>
        <translation>six pans creux</translation>
    </message>
    <message>
        <source>cross recess</source>
        <translation>cruciforme</translation>
    </message>
    <message>
        <source>slot</source>
        <translation>fente</translation>
    </message>
    <message>
        <source>six lobes</source>
        <translation>six lobes</translation>
    </message>
    <message>
        <source>No joint was found.</source>
        <translation>Aucune liaison n&apos;a été trouvée.</translation>
    </message>
    <message>
        <source>Joints: %1 (%2)</source>
        <translation>Liaisons&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>; suggested: %1</source>
        <translation>&#xa0;; proposées&#xa0;: %1</translation>
    </message>
    <message>
        <source>; for you to decide (?): %1</source>
        <translation>&#xa0;; à vous de décider (?)&#xa0;: %1</translation>
    </message>
    <message>
        <source>; screws without a hole in the file: %1</source>
        <translation>&#xa0;; vis sans trou dans le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1; clamps %2</source>
        <translation>%1&#xa0;; serre %2</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>filetage</translation>
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
        <translation>Signification</translation>
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
        <translation>Extension</translation>
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
    <name>Menus</name>
    <message>
        <source>&amp;Display</source>
        <translation>A&amp;ffichage</translation>
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
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Standard vie&amp;ws</source>
        <translation>Vues stan&amp;dard</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Couches</translation>
    </message>
    <message>
        <source>La&amp;yers of places</source>
        <translation>Couches des &amp;lieux</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Go to panel</source>
        <translation>&amp;Aller au panneau</translation>
    </message>
    <message>
        <source>&amp;Placement</source>
        <translation>&amp;Placement</translation>
    </message>
    <message>
        <source>S&amp;tart and goal</source>
        <translation>&amp;Départ et but</translation>
    </message>
    <message>
        <source>Se&amp;lected fit</source>
        <translation>Ajuste&amp;ment sélectionné</translation>
    </message>
    <message>
        <source>S&amp;equence</source>
        <translation>&amp;Séquence</translation>
    </message>
    <message>
        <source>&amp;Step of the sequence</source>
        <translation>É&amp;tape de la séquence</translation>
    </message>
    <message>
        <source>Pat&amp;h</source>
        <translation>C&amp;hemin</translation>
    </message>
    <message>
        <source>K&amp;ept paths</source>
        <translation>Chemins conser&amp;vés</translation>
    </message>
    <message>
        <source>Repla&amp;y</source>
        <translation>R&amp;electure</translation>
    </message>
    <message>
        <source>Show or hide the panel</source>
        <translation>Montrer ou masquer le panneau</translation>
    </message>
    <message>
        <source>Se&amp;ctions</source>
        <translation>Coup&amp;es</translation>
    </message>
    <message>
        <source>Selected j&amp;oint</source>
        <translation>Liaiso&amp;n sélectionnée</translation>
    </message>
    <message>
        <source>Ster&amp;eo</source>
        <translation>Vue stéré&amp;o</translation>
    </message>
    <message>
        <source>He&amp;adset</source>
        <translation>Casq&amp;ue</translation>
    </message>
    <message>
        <source>&amp;Hand access</source>
        <translation>Accès de la ma&amp;in</translation>
    </message>
    <message>
        <source>P&amp;laces</source>
        <translation>L&amp;ieux</translation>
    </message>
    <message>
        <source>P&amp;lan</source>
        <translation>Pla&amp;nification</translation>
    </message>
    <message>
        <source>&amp;Difficulties</source>
        <translation>&amp;Difficultés</translation>
    </message>
    <message>
        <source>Stud&amp;ies</source>
        <translation>Ét&amp;udes</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>&amp;Keep the earlier constraint</source>
        <translation>&amp;Garder la contrainte précédente</translation>
    </message>
    <message>
        <source>&amp;Remove it and take the new one</source>
        <translation>&amp;La supprimer et prendre la nouvelle</translation>
    </message>
    <message>
        <source>hand, forearm and tool were sampled along each motion: this is no proof of what lies between the samples, and the rest of the body is not considered</source>
        <translation>la main, l&apos;avant-bras et l&apos;outil ont été échantillonnés le long de chaque mouvement&#xa0;: cela ne prouve rien entre les échantillons, et le reste du corps n&apos;est pas considéré</translation>
    </message>
    <message>
        <source>the hand reaches the work</source>
        <translation>la main accède au travail</translation>
    </message>
    <message>
        <source>the hand is blocked at %1 of the motion</source>
        <translation>la main est bloquée à %1 du mouvement</translation>
    </message>
    <message>
        <source>the hand is blocked by &apos;%1&apos; at %2 of the motion</source>
        <translation>la main est bloquée par «&#xa0;%1&#xa0;» à %2 du mouvement</translation>
    </message>
    <message>
        <source>no grasp by one hand was found</source>
        <translation>aucune prise d&apos;une main n&apos;a été trouvée</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>non vérifié</translation>
    </message>
    <message>
        <source>%1 of the work is visible</source>
        <translation>%1 du travail est visible</translation>
    </message>
    <message>
        <source>%1 of the work is visible, hidden by &apos;%2&apos;</source>
        <translation>%1 du travail est visible, le reste est caché par «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1 with the tool (%2)</source>
        <translation>%1 avec l&apos;outil (%2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 of %2 {2|step|steps} {1|is|are} reachable and visible for the hand %3</source>
        <translation>%1 {1|étape|étapes} sur %2 {1|accessible et visible|accessibles et visibles} pour la main %3</translation>
    </message>
    <message>
        <source>one of them is needed, and not both</source>
        <translation>il faut l&apos;une des deux, et pas les deux</translation>
    </message>
    <message>
        <source>Give a path of the scenario&apos;s object, or an assembly plan.</source>
        <translation>Donnez un chemin de l&apos;objet du scénario, ou un plan d&apos;assemblage.</translation>
    </message>
    <message>
        <source>is not a place</source>
        <translation>n&apos;est pas un endroit</translation>
    </message>
    <message>
        <source>Give three numbers in metres.</source>
        <translation>Donnez trois nombres en mètres.</translation>
    </message>
    <message>
        <source>%1 % checked</source>
        <translation>%1 % vérifiés</translation>
    </message>
    <message>
        <source>is for assembly plans: a path is of a scenario</source>
        <translation>est réservée aux plans d&apos;assemblage&#xa0;: un chemin appartient à un scénario</translation>
    </message>
    <message>
        <source>Remove the body from the scenario.</source>
        <translation>Retirez le corps du scénario.</translation>
    </message>
    <message>
        <source>is for assembly plans: a path states no decisions of the user</source>
        <translation>est réservée aux plans d&apos;assemblage&#xa0;: un chemin n&apos;énonce aucune décision de l&apos;utilisateur</translation>
    </message>
    <message>
        <source>Leave it out.</source>
        <translation>Omettez-la.</translation>
    </message>
    <message>
        <source>is below zero</source>
        <translation>est négatif</translation>
    </message>
    <message>
        <source>Give seconds, 0 for none.</source>
        <translation>Donnez des secondes, 0 pour aucune limite.</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>%1 a été écrit</translation>
    </message>
    <message>
        <source>this format holds more than the path</source>
        <translation>ce format contient plus que le chemin</translation>
    </message>
    <message>
        <source>Name the scenario with --scenario, or write OMPL&apos;s format (.path).</source>
        <translation>Nommez le scénario avec --scenario, ou écrivez le format d&apos;OMPL (.path).</translation>
    </message>
    <message>
        <source>octree     %1 levels, cells: %2 free, %3 mobile, %4 static</source>
        <translation>octree         %1 niveaux, cellules&#xa0;: %2 libres, %3 mobiles, %4 statiques</translation>
    </message>
    <message>
        <source>places (%1)</source>
        <translation>lieux (%1)</translation>
    </message>
    <message>
        <source>passage</source>
        <translation>passage</translation>
    </message>
    <message>
        <source>  %1complexity %2narrowness %3compatibility %4%5%6</source>
        <translation>  %1complexité %2étroitesse %3compatibilité %4%5%6</translation>
    </message>
    <message>
        <source>cluttered</source>
        <translation>encombré</translation>
    </message>
    <message>
        <source>borders</source>
        <translation>frontières</translation>
    </message>
    <message>
        <source>  %1 - %2, opening %3 m2 at %4</source>
        <translation>  %1 - %2, ouverture de %3 m2 en %4</translation>
    </message>
    <message>
        <source>both by %1</source>
        <translation>a et b de %1</translation>
    </message>
    <message>
        <source>the volumes that solids have in common are not known: %1</source>
        <translation>les volumes que les solides ont en commun ne sont pas connus&#xa0;: %1</translation>
    </message>
    <message>
        <source>clash</source>
        <translation>interférence</translation>
    </message>
    <message>
        <source>without overlap</source>
        <translation>sans recouvrement</translation>
    </message>
    <message>
        <source>a by %1</source>
        <translation>a de %1</translation>
    </message>
    <message>
        <source>b by %1</source>
        <translation>b de %1</translation>
    </message>
    <message>
        <source>common volumes of the solids in the file:</source>
        <translation>volumes communs des solides du fichier&#xa0;:</translation>
    </message>
    <message>
        <source>  &apos;%1&apos; and &apos;%2&apos;: %3, %4 deep</source>
        <translation>  «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»&#xa0;: %3, sur %4 de profondeur</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>recouvrement</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>écart</translation>
    </message>
    <message>
        <source>%1 {1|pair|pairs} of %2 {2|body|bodies}</source>
        <translation>%1 {1|paire|paires} de %2 corps</translation>
    </message>
    <message>
        <source>allowance</source>
        <translation>amincissement</translation>
    </message>
    <message>
        <source>gap or overlap</source>
        <translation>écart ou recouvrement</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>type</translation>
    </message>
    <message>
        <source>Give a length, as 0.5mm.</source>
        <translation>Donnez une longueur, comme 0.5mm.</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>OPEN</source>
        <translation>OUVERT</translation>
    </message>
    <message>
        <source>  %1%2%3 triangles  %4  %5 x %6 x %7 m</source>
        <translation>  %1%2%3 triangles  %4  %5 x %6 x %7 m</translation>
    </message>
    <message>
        <source>%1  within %2 mm of its surface</source>
        <translation>%1  à %2 mm au plus de sa surface</translation>
    </message>
    <message>
        <source>%1  coordinate spacing %2 mm</source>
        <translation>%1  espacement des coordonnées %2 mm</translation>
    </message>
    <message>
        <source>assemblies</source>
        <translation>assemblages</translation>
    </message>
    <message>
        <source>%1  %2 {2|body|bodies}%3</source>
        <translation>%1  %2 corps%3</translation>
    </message>
    <message>
        <source>workspace  x %1 ... %2, y %3 ... %4, z %5 ... %6 m</source>
        <translation>espace         x %1 ... %2, y %3 ... %4, z %5 ... %6 m</translation>
    </message>
    <message>
        <source>goal       removed</source>
        <translation>but            démonté</translation>
    </message>
    <message>
        <source>goal       a configuration</source>
        <translation>but            une configuration</translation>
    </message>
    <message>
        <source>planner    %1</source>
        <translation>planificateur  %1</translation>
    </message>
    <message>
        <source>seed       %1</source>
        <translation>graine         %1</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objet</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <source>units of %1</source>
        <translation>unités de %1</translation>
    </message>
    <message>
        <source>shapes that are no bodies  %1</source>
        <translation>formes qui ne sont pas des corps  %1</translation>
    </message>
    <message>
        <source>%1 {1|body|bodies}, %2 different {2|mesh|meshes}, %3 {3|triangle|triangles}</source>
        <translation>%1 corps, %2 {2|maillage différent|maillages différents}, %3 {3|triangle|triangles}</translation>
    </message>
    <message>
        <source>%1, lengths in %2</source>
        <translation>%1, longueurs en %2</translation>
    </message>
    <message>
        <source>needs a scenario: a part file has no object</source>
        <translation>demande un scénario&#xa0;: un fichier de pièces n&apos;a pas d&apos;objet</translation>
    </message>
    <message>
        <source>Make a scenario of the file with glissade-cli new.</source>
        <translation>Faites un scénario de ce fichier avec glissade-cli new.</translation>
    </message>
    <message>
        <source>%1 x %2 mm, %3 mm engaged</source>
        <translation>%1 x %2 mm, en prise sur %3 mm</translation>
    </message>
    <message>
        <source>state</source>
        <translation>état</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>in or on</source>
        <translation>dans ou sur</translation>
    </message>
    <message>
        <source>clamps</source>
        <translation>serre</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>filetage</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>tours</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>empreinte</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>indices</translation>
    </message>
    <message>
        <source>%1 {1|joint|joints} of %2 {2|body|bodies}</source>
        <translation>%1 {1|liaison|liaisons} de %2 corps</translation>
    </message>
    <message>
        <source>joints whose evidence contradicts itself, for the user to decide (?): %1</source>
        <translation>liaisons dont les indices se contredisent, à trancher par l&apos;utilisateur (?)&#xa0;: %1</translation>
    </message>
    <message>
        <source>was interrupted</source>
        <translation>a été interrompu</translation>
    </message>
    <message>
        <source>One JSON object on standard output and nothing else</source>
        <translation>Un objet JSON sur la sortie standard et rien d&apos;autre</translation>
    </message>
    <message>
        <source>is below zero: give a length, as 1.5mm</source>
        <translation>est inférieur à zéro&#xa0;: donnez une longueur, comme 1.5mm</translation>
    </message>
    <message>
        <source>In accepted clashes, the body that is cut where it is not clear which of the two has the hole</source>
        <translation>Dans les interférences acceptées, le corps qui est découpé lorsqu&apos;on ne sait pas lequel des deux a le trou</translation>
    </message>
    <message>
        <source>Whether bodies that fit where they are assembled have an allowance against each other: on or off (default: %1)</source>
        <translation>Si les corps ajustés à leur place assemblée ont un amincissement l&apos;un face à l&apos;autre&#xa0;: on ou off (par défaut&#xa0;: %1)</translation>
    </message>
    <message>
        <source>Plan a motion and deliver it with its certificate</source>
        <translation>Planifier un mouvement et le livrer avec son certificat</translation>
    </message>
    <message>
        <source>Scenario file or OMPL.app .cfg</source>
        <translation>Fichier de scénario ou .cfg d&apos;OMPL.app</translation>
    </message>
    <message>
        <source>Planner: %1 (default: the scenario&apos;s)</source>
        <translation>Planificateur&#xa0;: %1 (par défaut&#xa0;: celui du scénario)</translation>
    </message>
    <message>
        <source>Collision checker: kernel or fcl (default: kernel)</source>
        <translation>Détecteur de collisions&#xa0;: kernel ou fcl (par défaut&#xa0;: kernel)</translation>
    </message>
    <message>
        <source>the scenario&apos;s</source>
        <translation>comme dans le scénario</translation>
    </message>
    <message>
        <source>A simulated operator follows this path, not the scenario&apos;s way-points</source>
        <translation>Un opérateur simulé suit ce chemin, et non les points de passage du scénario</translation>
    </message>
    <message>
        <source>Shorten the path and keep it certified: --smoothing %1</source>
        <translation>Raccourcir le chemin en le gardant certifié&#xa0;: --smoothing %1</translation>
    </message>
    <message>
        <source>Report the certificate of every edge</source>
        <translation>Rapporter le certificat de chaque segment</translation>
    </message>
    <message>
        <source>Where no path is found, print the reasons</source>
        <translation>Si aucun chemin n&apos;est trouvé, afficher les raisons</translation>
    </message>
    <message>
        <source>Seed of everything random (default: the scenario&apos;s)</source>
        <translation>Graine de tout ce qui est aléatoire (par défaut&#xa0;: celle du scénario)</translation>
    </message>
    <message>
        <source>Write the path: %1</source>
        <translation>Écrire le chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Write a run record for replay</source>
        <translation>Écrire un enregistrement du calcul, à rejouer</translation>
    </message>
    <message>
        <source>Exclude a body or an assembly of the product: its name (can be repeated)</source>
        <translation>Exclure un corps ou un assemblage du produit&#xa0;: son nom (peut être répété)</translation>
    </message>
    <message>
        <source>Split a part of several solids into these: its name (can be repeated)</source>
        <translation>Diviser une pièce de plusieurs solides en ceux-ci&#xa0;: son nom (peut être répété)</translation>
    </message>
    <message>
        <source>Threads; they do not change the result (default: one for each core)</source>
        <translation>Fils d&apos;exécution&#xa0;; ils ne changent pas le résultat (par défaut&#xa0;: un par cœur)</translation>
    </message>
    <message>
        <source>Check a path or an assembly plan with the independent check</source>
        <translation>Vérifier un chemin ou un plan d&apos;assemblage par la vérification indépendante</translation>
    </message>
    <message>
        <source>Scenario file or OMPL.app .cfg; of an assembly plan the product, as in sequence</source>
        <translation>Fichier de scénario ou .cfg d&apos;OMPL.app&#xa0;; pour un plan d&apos;assemblage le produit, comme dans sequence</translation>
    </message>
    <message>
        <source>Assembly plan, or path: %1</source>
        <translation>Plan d&apos;assemblage, ou chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Clearance to certify [m] (default: the scenario&apos;s)</source>
        <translation>Jeu à certifier [m] (par défaut&#xa0;: celui du scénario)</translation>
    </message>
    <message>
        <source>What the plan states itself counts as the user&apos;s decision: bends, flexible bodies, units, accepted clashes, constraints that are given up</source>
        <translation>Ce que le plan énonce lui-même vaut comme décision de l&apos;utilisateur&#xa0;: flexions, corps souples, unités, interférences acceptées, contraintes abandonnées</translation>
    </message>
    <message>
        <source>Time limit in seconds; 0: none</source>
        <translation>Limite de temps en secondes&#xa0;; 0&#xa0;: aucune</translation>
    </message>
    <message>
        <source>Shorten a certified path and keep it certified</source>
        <translation>Raccourcir un chemin certifié en le gardant certifié</translation>
    </message>
    <message>
        <source>Path: %1</source>
        <translation>Chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Shortcuts to try</source>
        <translation>Raccourcis à essayer</translation>
    </message>
    <message>
        <source>Seed of the shortcuts</source>
        <translation>Graine des raccourcis</translation>
    </message>
    <message>
        <source>Write the swept volume of a path: all that the object covers</source>
        <translation>Écrire le volume balayé d&apos;un chemin&#xa0;: tout ce que l&apos;objet occupe</translation>
    </message>
    <message>
        <source>Write the swept volume: .stl (millimetres) or .glb</source>
        <translation>Écrire le volume balayé&#xa0;: .stl (millimètres) ou .glb</translation>
    </message>
    <message>
        <source>How far its surface may be from the object, as 0.5mm (default: one with which the volume is about 7 % too large)</source>
        <translation>Distance maximale de sa surface à l&apos;objet, comme 0.5mm (par défaut&#xa0;: celle avec laquelle le volume est trop grand d&apos;environ 7&#xa0;%)</translation>
    </message>
    <message>
        <source>Show bodies, triangles, units and the quality of the meshes</source>
        <translation>Montrer les corps, les triangles, les unités et la qualité des maillages</translation>
    </message>
    <message>
        <source>Scenario, OMPL.app .cfg, or part file (STEP, IGES, BREP, mesh, URDF)</source>
        <translation>Scénario, .cfg d&apos;OMPL.app ou fichier de pièces (STEP, IGES, BREP, maillage, URDF)</translation>
    </message>
    <message>
        <source>Build the environment model: octree, places, borders, compatibility</source>
        <translation>Construire le modèle de l&apos;environnement&#xa0;: octree, lieux, frontières, compatibilité</translation>
    </message>
    <message>
        <source>Write into the scenario file where its forbidden places are, which &apos;check&apos; reads</source>
        <translation>Écrire dans le fichier de scénario où sont ses lieux interdits, que «&#xa0;check&#xa0;» lit</translation>
    </message>
    <message>
        <source>is not from 1e-12 m to 1e9 m</source>
        <translation>n&apos;est pas entre 1e-12 m et 1e9 m</translation>
    </message>
    <message>
        <source>Mesh tolerance: how far triangles may be off the surfaces of a STEP file, as 0.05mm (default: automatic, by the size of each part)</source>
        <translation>Tolérance de maillage&#xa0;: écart maximal des triangles aux surfaces d&apos;un fichier STEP, comme 0.05mm (par défaut&#xa0;: automatique, selon la taille de chaque pièce)</translation>
    </message>
    <message>
        <source>List the contacts, fits and clashes of a product as it is assembled</source>
        <translation>Lister les contacts, les ajustements et les interférences d&apos;un produit assemblé</translation>
    </message>
    <message>
        <source>Scenario, STEP, IGES or BREP file, or an assembly in one (product.step:pump)</source>
        <translation>Scénario, fichier STEP, IGES ou BREP, ou un assemblage qu&apos;il contient (product.step:pump)</translation>
    </message>
    <message>
        <source>List pairs with a gap of up to this, too, as 0.5mm (default: 0)</source>
        <translation>Lister aussi les paires dont l&apos;écart va jusqu&apos;à cette longueur, comme 0.5mm (par défaut&#xa0;: 0)</translation>
    </message>
    <message>
        <source>An overlap above this is a clash (default: 1mm)</source>
        <translation>Un recouvrement plus grand est une interférence (par défaut&#xa0;: 1mm)</translation>
    </message>
    <message>
        <source>An overlap above this share of the local thickness is a clash, too</source>
        <translation>Un recouvrement supérieur à cette part de l&apos;épaisseur locale est aussi une interférence</translation>
    </message>
    <message>
        <source>Comma-separated values, a line a pair</source>
        <translation>Valeurs séparées par des virgules, une ligne par paire</translation>
    </message>
    <message>
        <source>List how the bodies of a product are joined: screws, nuts, inserts</source>
        <translation>Lister comment les corps d&apos;un produit sont liés&#xa0;: vis, écrous, inserts</translation>
    </message>
    <message>
        <source>suggested: joints that are suggested count as if the user had confirmed them; recognised: they do not (default)</source>
        <translation>suggested&#xa0;: les liaisons proposées comptent comme si l&apos;utilisateur les avait confirmées&#xa0;; recognised&#xa0;: elles ne comptent pas (par défaut)</translation>
    </message>
    <message>
        <source>Find in which order the parts of a product are removed, with a certified motion each</source>
        <translation>Trouver dans quel ordre se démontent les pièces d&apos;un produit, chacune par un mouvement certifié</translation>
    </message>
    <message>
        <source>Scenario, STEP, IGES or BREP file, an assembly in one (product.step:pump), or URDF file</source>
        <translation>Scénario, fichier STEP, IGES ou BREP, un assemblage qu&apos;il contient (product.step:pump), ou fichier URDF</translation>
    </message>
    <message>
        <source>Write the assembly plan (.json), also while it is planned</source>
        <translation>Écrire le plan d&apos;assemblage (.json), aussi pendant sa planification</translation>
    </message>
    <message>
        <source>Seconds after which the plan so far is written to --out</source>
        <translation>Secondes après lesquelles le plan obtenu jusque-là est écrit dans --out</translation>
    </message>
    <message>
        <source>Resume a plan that has not ended</source>
        <translation>Reprendre un plan qui n&apos;est pas terminé</translation>
    </message>
    <message>
        <source>How the order is searched: best-first or greedy (default: best-first, or the resumed plan&apos;s)</source>
        <translation>Façon de chercher l&apos;ordre&#xa0;: best-first ou greedy (par défaut&#xa0;: best-first, ou celle du plan repris)</translation>
    </message>
    <message>
        <source>Seed of everything random (default: 1, or the resumed plan&apos;s)</source>
        <translation>Graine de tout ce qui est aléatoire (par défaut&#xa0;: 1, ou celle du plan repris)</translation>
    </message>
    <message>
        <source>Time limit in seconds; the plan found so far is then written; 0: none</source>
        <translation>Limite de temps en secondes&#xa0;; le plan trouvé jusque-là est alors écrit&#xa0;; 0&#xa0;: aucune</translation>
    </message>
    <message>
        <source>Bodies that are removed as one: names with commas between them</source>
        <translation>Corps qui se démontent ensemble&#xa0;: des noms séparés par des virgules</translation>
    </message>
    <message>
        <source>first,then: the first body is removed before the second</source>
        <translation>premier,suivant&#xa0;: le premier corps se démonte avant le second</translation>
    </message>
    <message>
        <source>3,name: the body is removed in the third step; 3,name,name: as one</source>
        <translation>3,nom&#xa0;: le corps se démonte à la troisième étape&#xa0;; 3,nom,nom&#xa0;: ensemble</translation>
    </message>
    <message>
        <source>name,-z or name,0,0,-1: the body is not removed in this direction</source>
        <translation>nom,-z ou nom,0,0,-1&#xa0;: le corps ne se démonte pas dans cette direction</translation>
    </message>
    <message>
        <source>Joints that the plan respects: recognised, suggested (those too that the user would have to confirm) or off (default: the scenario&apos;s, or recognised)</source>
        <translation>Liaisons que le plan respecte&#xa0;: recognised, suggested (aussi celles que l&apos;utilisateur devrait confirmer) ou off (par défaut&#xa0;: celles du scénario, ou recognised)</translation>
    </message>
    <message>
        <source>What a step costs for best-first: fitter, balanced, steady, few-tools, short, fragile-first, as-found, or an expression (default: the scenario&apos;s, or fitter)</source>
        <translation>Coût d&apos;une étape pour best-first&#xa0;: fitter, balanced, steady, few-tools, short, fragile-first, as-found, ou une expression (par défaut&#xa0;: celui du scénario, ou fitter)</translation>
    </message>
    <message>
        <source>on, or the scenario&apos;s</source>
        <translation>on, ou comme dans le scénario</translation>
    </message>
    <message>
        <source>Assembly times: how long the steps of an assembly plan take, also balanced over a line</source>
        <translation>Temps d&apos;assemblage&#xa0;: durée des étapes d&apos;un plan d&apos;assemblage, aussi équilibrées sur une ligne</translation>
    </message>
    <message>
        <source>The product of the plan: a scenario or a STEP file</source>
        <translation>Le produit du plan&#xa0;: un scénario ou un fichier STEP</translation>
    </message>
    <message>
        <source>Assembly plan, as &apos;sequence --out&apos; writes it</source>
        <translation>Plan d&apos;assemblage, tel que «&#xa0;sequence --out&#xa0;» l&apos;écrit</translation>
    </message>
    <message>
        <source>Balance the steps over so many stations, one person each</source>
        <translation>Équilibrer les étapes sur ce nombre de postes, une personne chacun</translation>
    </message>
    <message>
        <source>File of work times (default: the program&apos;s estimates)</source>
        <translation>Fichier de temps de travail (par défaut&#xa0;: les estimations du programme)</translation>
    </message>
    <message>
        <source>Write the table of work times to a file, to be edited</source>
        <translation>Écrire le tableau des temps de travail dans un fichier, pour le modifier</translation>
    </message>
    <message>
        <source>Hand access: whether a hand reaches a path or the steps of an assembly plan, and whether they are visible</source>
        <translation>Accès de la main&#xa0;: si une main accède à un chemin ou aux étapes d&apos;un plan d&apos;assemblage, et si on les voit</translation>
    </message>
    <message>
        <source>Hand, forearm and tool are sampled along each motion; this is no proof. Measures: ANSUR II (NATICK/TR-15/007).
Exit codes: 0 all is reachable and visible, 1 not all, 2 wrong usage, 3 unreadable input, 130 interrupted.</source>
        <translation>La main, l&apos;avant-bras et l&apos;outil sont échantillonnés le long de chaque mouvement&#xa0;; ce n&apos;est pas une preuve. Mesures&#xa0;: ANSUR II (NATICK/TR-15/007).
Codes de retour&#xa0;: 0 tout est accessible et visible, 1 pas tout, 2 mauvais usage, 3 entrée illisible, 130 interrompu.</translation>
    </message>
    <message>
        <source>The scenario of the path, or the product of the plan</source>
        <translation>Le scénario du chemin, ou le produit du plan</translation>
    </message>
    <message>
        <source>Path of the object: %1</source>
        <translation>Chemin de l&apos;objet&#xa0;: %1</translation>
    </message>
    <message>
        <source>Whose hand: p5f 5th percentile of women, p50 average, p95m 95th percentile of men (default: p50)</source>
        <translation>Main de qui&#xa0;: p5f 5e centile des femmes, p50 moyenne, p95m 95e centile des hommes (par défaut&#xa0;: p50)</translation>
    </message>
    <message>
        <source>Viewpoint on the work: x y z in metres (default: 17 positions above it are tried)</source>
        <translation>Point de vue sur le travail&#xa0;: x y z en mètres (par défaut&#xa0;: 17 positions au-dessus sont essayées)</translation>
    </message>
    <message>
        <source>Convert an OMPL.app .cfg to a scenario, or a path to another format</source>
        <translation>Convertir un .cfg d&apos;OMPL.app en scénario, ou un chemin en un autre format</translation>
    </message>
    <message>
        <source>What to read: a .cfg, a scenario; or a path: %1</source>
        <translation>Ce qui est lu&#xa0;: un .cfg, un scénario&#xa0;; ou un chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>What to write: a scenario (.json); or a path: %1</source>
        <translation>Ce qui est écrit&#xa0;: un scénario (.json)&#xa0;; ou un chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Scenario of the path, for formats that hold its clearances or bodies</source>
        <translation>Scénario du chemin, pour les formats qui contiennent ses jeux ou ses corps</translation>
    </message>
    <message>
        <source>Make a scenario of part files (meshes, STEP, IGES, BREP, URDF), with one moving part</source>
        <translation>Faire un scénario de fichiers de pièces (maillages, STEP, IGES, BREP, URDF), avec une pièce manipulée</translation>
    </message>
    <message>
        <source>A part of a STEP file is named behind its file: --moves product.step:pin --static product.step makes a body
of every other part. An assembly in the file (product.step:pump) stands for all of its parts; two parts of
one name are pin and pin#2. A solid of a part of several (product.step:frame/solid#2) opens the part: each of
its solids is a body. #3 is the third part that &apos;info&apos; lists. A group of an OBJ file is named in the same way: --moves product.obj:lid --groups
--static product.obj makes a body of every other group.</source>
        <translation>Une pièce d&apos;un fichier STEP se nomme après son fichier&#xa0;: --moves product.step:pin --static product.step fait un corps
de chaque autre pièce. Un assemblage du fichier (product.step:pump) représente toutes ses pièces&#xa0;; deux pièces de
même nom sont pin et pin#2. Un solide d&apos;une pièce qui en a plusieurs (product.step:frame/solid#2) ouvre la pièce&#xa0;: chacun de
ses solides est un corps. #3 est la troisième pièce que «&#xa0;info&#xa0;» liste. Un groupe d&apos;un fichier OBJ se nomme de même&#xa0;: --moves product.obj:lid --groups
--static product.obj fait un corps de chaque autre groupe.</translation>
    </message>
    <message>
        <source>Scenario file to write</source>
        <translation>Fichier de scénario à écrire</translation>
    </message>
    <message>
        <source>The moving part (can be repeated: they move as one)</source>
        <translation>La pièce manipulée (peut être répété&#xa0;: elles se déplacent ensemble)</translation>
    </message>
    <message>
        <source>Static parts: they do not move</source>
        <translation>Pièces statiques&#xa0;: elles ne bougent pas</translation>
    </message>
    <message>
        <source>Parts in the way that a person could move</source>
        <translation>Pièces sur le passage qu&apos;une personne pourrait déplacer</translation>
    </message>
    <message>
        <source>A unit of the files, as 1mm, 1m, 1in or 25.4mm (default: 1m for Collada and glTF; for other meshes 1mm, or 1m where only that fits their size, which a warning says); STEP and URDF files say it themselves</source>
        <translation>Une unité des fichiers, comme 1mm, 1m, 1in ou 25.4mm (par défaut&#xa0;: 1m pour Collada et glTF&#xa0;; pour les autres maillages 1mm, ou 1m si cela seul convient à leur taille, ce qu&apos;un avertissement indique)&#xa0;; les fichiers STEP et URDF l&apos;indiquent eux-mêmes</translation>
    </message>
    <message>
        <source>The files&apos; axis that points up (default: y for Collada and glTF, z for other meshes)</source>
        <translation>L&apos;axe des fichiers qui pointe vers le haut (par défaut&#xa0;: y pour Collada et glTF, z pour les autres maillages)</translation>
    </message>
    <message>
        <source>Mesh tolerance: how far the triangles of STEP parts may be off their surfaces, as 0.05mm (default: a thousandth of each part&apos;s diagonal, from 0.01mm to 0.5mm)</source>
        <translation>Tolérance de maillage&#xa0;: écart maximal des triangles des pièces STEP à leurs surfaces, comme 0.05mm (par défaut&#xa0;: un millième de la diagonale de chaque pièce, de 0.01mm à 0.5mm)</translation>
    </message>
    <message>
        <source>Split OBJ files: each group (o or g) is a part of its own</source>
        <translation>Diviser les fichiers OBJ&#xa0;: chaque groupe (o ou g) est une pièce à part</translation>
    </message>
    <message>
        <source>Close the planar holes of meshes, and print how many</source>
        <translation>Fermer les trous plans des maillages, et afficher combien</translation>
    </message>
    <message>
        <source>Resolve collisions at the start: move it clear of the bodies that it touches, and print how far</source>
        <translation>Résoudre les collisions au départ&#xa0;: l&apos;écarter des corps qu&apos;il touche, et afficher de combien</translation>
    </message>
    <message>
        <source>Repeat runs over scenarios, strategies, parameters and seeds</source>
        <translation>Répéter des essais en faisant varier scénarios, stratégies, paramètres et graines</translation>
    </message>
    <message>
        <source>Study file (samples/studies)</source>
        <translation>Fichier d&apos;étude (samples/studies)</translation>
    </message>
    <message>
        <source>Folder of the results; a study that was begun there is continued</source>
        <translation>Dossier des résultats&#xa0;; une étude qui y a été commencée est poursuivie</translation>
    </message>
    <message>
        <source>Runs at once</source>
        <translation>Essais simultanés</translation>
    </message>
    <message>
        <source>I/N: only every N-th run, from the I-th; see merge</source>
        <translation>I/N&#xa0;: seulement un essai sur N, à partir du I-ième&#xa0;; voir merge</translation>
    </message>
    <message>
        <source>The study&apos;s quick section: about a minute</source>
        <translation>La version rapide de l&apos;étude&#xa0;: environ une minute</translation>
    </message>
    <message>
        <source>Print what would be run; write nothing</source>
        <translation>Afficher ce qui serait exécuté&#xa0;; ne rien écrire</translation>
    </message>
    <message>
        <source>Combine the results of the parts of a study (--shard) and write its tables</source>
        <translation>Réunir les résultats des parts d&apos;une étude (--shard) et écrire ses tableaux</translation>
    </message>
    <message>
        <source>Folders of results</source>
        <translation>Dossiers de résultats</translation>
    </message>
    <message>
        <source>Folder of the combined results</source>
        <translation>Dossier des résultats réunis</translation>
    </message>
    <message>
        <source>Write the report of a study: tables, plots, findings, one HTML page</source>
        <translation>Écrire le rapport d&apos;une étude&#xa0;: tableaux, courbes, conclusions, une page HTML</translation>
    </message>
    <message>
        <source>Folder of results</source>
        <translation>Dossier de résultats</translation>
    </message>
    <message>
        <source>Language of the report</source>
        <translation>Langue du rapport</translation>
    </message>
    <message>
        <source>Write the page of results of packaging/benchmarks.sh</source>
        <translation>Écrire la page des résultats de packaging/benchmarks.sh</translation>
    </message>
    <message>
        <source>Run a recorded run again and compare the roadmaps bit by bit</source>
        <translation>Rejouer un calcul enregistré et comparer les graphes bit à bit</translation>
    </message>
    <message>
        <source>Run record, or the journal of a run that was interrupted</source>
        <translation>Enregistrement d&apos;un calcul, ou journal d&apos;un calcul qui a été interrompu</translation>
    </message>
    <message>
        <source>Scenario of the run (default: the one that the record names)</source>
        <translation>Scénario du calcul (par défaut&#xa0;: celui que l&apos;enregistrement nomme)</translation>
    </message>
    <message>
        <source>Language of messages and texts, also behind a command</source>
        <translation>Langue des messages et des textes, aussi après une commande</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>sortie standard</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>ne peut pas être écrite&#xa0;: %1</translation>
    </message>
    <message>
        <source>Send it to another file.</source>
        <translation>Envoyez-la dans un autre fichier.</translation>
    </message>
    <message>
        <source>running the command</source>
        <translation>exécution de la commande</translation>
    </message>
    <message>
        <source>start</source>
        <translation>le départ</translation>
    </message>
    <message>
        <source>names the moving part</source>
        <translation>désigne la pièce manipulée</translation>
    </message>
    <message>
        <source>Name another body.</source>
        <translation>Nommez un autre corps.</translation>
    </message>
    <message>
        <source>start moved clear by %1 mm</source>
        <translation>départ dégagé de %1 mm</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a length: give metres, or a unit as in 0.5mm (m, cm, mm, in, ft)</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une longueur&#xa0;: donnez des mètres, ou une unité comme dans 0.5mm (m, cm, mm, in, ft)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is beyond 1e9 m: check the unit</source>
        <translation>«&#xa0;%1&#xa0;» dépasse 1e9 m&#xa0;: vérifiez l&apos;unité</translation>
    </message>
    <message>
        <source>Subcommands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Glissade: certified motions for virtual assembly</source>
        <translation>Glissade&#xa0;: des mouvements certifiés pour l&apos;assemblage virtuel</translation>
    </message>
    <message>
        <source>Usage</source>
        <translation>Utilisation</translation>
    </message>
    <message>
        <source>Positionals</source>
        <translation>Arguments</translation>
    </message>
    <message>
        <source>SUBCOMMAND</source>
        <translation>COMMANDE</translation>
    </message>
    <message>
        <source>REQUIRED</source>
        <translation>OBLIGATOIRE</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Options</translation>
    </message>
    <message>
        <source>Print this help message and exit</source>
        <translation>Afficher cette aide et quitter</translation>
    </message>
    <message>
        <source>Display program version information and exit</source>
        <translation>Afficher la version du programme et quitter</translation>
    </message>
    <message>
        <source>there is no planner &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de stratégie «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>See &apos;glissade-cli plan --help&apos; for the planners.</source>
        <translation>Voyez les planificateurs avec «&#xa0;glissade-cli plan --help&#xa0;».</translation>
    </message>
    <message>
        <source>there is no operator &apos;%1&apos;</source>
        <translation>il n&apos;y a pas d&apos;opérateur «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Choose one of %1 or replay:FILE.</source>
        <translation>Choisissez parmi %1 ou replay:FICHIER.</translation>
    </message>
    <message>
        <source>Choose gts to plan with them.</source>
        <translation>Choisissez gts pour en tenir compte.</translation>
    </message>
    <message>
        <source>are not used by strategy &apos;%1&apos;</source>
        <translation>ne sont pas utilisés par la stratégie «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>have preferences, which are not used by strategy &apos;%1&apos;</source>
        <translation>ont des préférences, que la stratégie «&#xa0;%1&#xa0;» n&apos;utilise pas</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>graine %1</translation>
    </message>
    <message>
        <source>the replay was not finished</source>
        <translation>la relecture n&apos;a pas été terminée</translation>
    </message>
    <message>
        <source>Start it again.</source>
        <translation>Relancez-le.</translation>
    </message>
    <message>
        <source>same roadmap as recorded: %1 {1|node|nodes}</source>
        <translation>même graphe que l&apos;enregistrement&#xa0;: %1 {1|nœud|nœuds}</translation>
    </message>
    <message>
        <source>(a record of version 1: only the nodes were counted)</source>
        <translation>(enregistrement de version 1&#xa0;: seuls les nœuds ont été comptés)</translation>
    </message>
    <message>
        <source>(the recording was full there; the run went on)</source>
        <translation>(l&apos;enregistrement était plein à cet endroit&#xa0;; le calcul a continué)</translation>
    </message>
    <message>
        <source>different: the same until step %1, not at step %2 (recorded %3 nodes, replayed %4 at step %5)</source>
        <translation>différent&#xa0;: identique jusqu&apos;au pas %1, mais pas au pas %2 (%3 nœuds enregistrés, %4 rejoués au pas %5)</translation>
    </message>
    <message>
        <source>recorded by %1, %2; replayed by Glissade %3, %4</source>
        <translation>enregistré par %1, %2&#xa0;; rejoué par Glissade %3, %4</translation>
    </message>
    <message>
        <source>a forbidden place</source>
        <translation>un lieu interdit</translation>
    </message>
    <message>
        <source>forbids places to the path of its object; the steps of an assembly plan may cross them</source>
        <translation>interdit des lieux au chemin de son objet&#xa0;; les étapes d&apos;un plan d&apos;assemblage peuvent les traverser</translation>
    </message>
    <message>
        <source>Forbid directions of parts instead (--forbid).</source>
        <translation>Interdisez plutôt des directions aux pièces (--forbid).</translation>
    </message>
    <message>
        <source>warning: %1</source>
        <translation>avertissement&#xa0;: %1</translation>
    </message>
    <message>
        <source>nothing near</source>
        <translation>aucun corps proche</translation>
    </message>
    <message>
        <source>clearance %1 mm to &apos;%2&apos;</source>
        <translation>jeu de %1 mm par rapport à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>required %1 mm</source>
        <translation>exigé&#xa0;: %1 mm</translation>
    </message>
    <message>
        <source>%1, %2 of %3 {3|edge|edges} {2|slides|slide}</source>
        <translation>%1, %2 {2|segment|segments} sur %3 {2|glisse|glissent}</translation>
    </message>
    <message>
        <source>%1; %2 from forbidden places</source>
        <translation>%1&#xa0;; à %2 des lieux interdits</translation>
    </message>
    <message>
        <source>certified: %1 (%2)</source>
        <translation>certifié&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>violated: on edge %1 the object is in the thread of &apos;%2&apos;, and the edge is no turn about their axis by the pitch</source>
        <translation>réfuté&#xa0;: sur le segment %1, l&apos;objet est dans le filetage de «&#xa0;%2&#xa0;», et ce segment n&apos;est pas une rotation autour de leur axe au pas du filetage</translation>
    </message>
    <message>
        <source>violated: %1 mm to &apos;%2&apos; on edge %3 at %4 (required %5 mm)</source>
        <translation>réfuté&#xa0;: à %1 mm de «&#xa0;%2&#xa0;» sur le segment %3, en %4 (exigé&#xa0;: %5 mm)</translation>
    </message>
    <message>
        <source>  edge %1: certified, %2</source>
        <translation>  segment %1&#xa0;: certifié, %2</translation>
    </message>
    <message>
        <source>  edge %1: violated, %2</source>
        <translation>  segment %1&#xa0;: réfuté, %2</translation>
    </message>
    <message>
        <source>  edge %1: undecided, %2</source>
        <translation>  segment %1&#xa0;: indécis, %2</translation>
    </message>
    <message>
        <source>clearance %1 to %2 mm</source>
        <translation>jeu de %1 à %2 mm</translation>
    </message>
    <message>
        <source>%1 to &apos;%2&apos; at %3</source>
        <translation>%1 par rapport à «&#xa0;%2&#xa0;» en %3</translation>
    </message>
    <message>
        <source>%1 (required %2 mm, sliding)</source>
        <translation>%1 (exigé&#xa0;: %2 mm, en glissement)</translation>
    </message>
    <message>
        <source>%1 (required %2 mm)</source>
        <translation>%1 (exigé&#xa0;: %2 mm)</translation>
    </message>
    <message>
        <source>undecided on edge %1</source>
        <translation>indécis sur le segment %1</translation>
    </message>
    <message>
        <source>allowance: %1</source>
        <translation>amincissement&#xa0;: %1</translation>
    </message>
    <message>
        <source>CAD accuracy of the certificate: +/- %1</source>
        <translation>précision CAO du certificat&#xa0;: +/- %1</translation>
    </message>
    <message>
        <source>coordinate spacing: mesh files hold 32-bit numbers or were closed at T-junctions, so that bodies may be %1 mm nearer</source>
        <translation>espacement des coordonnées&#xa0;: des fichiers de maillage contiennent des nombres sur 32 bits ou ont été fermés à des jonctions en T, si bien que les corps peuvent être plus proches de %1 mm</translation>
    </message>
    <message>
        <source>the trees came within %1 m of each other, from %2 to %3</source>
        <translation>les arbres se sont approchés à %1 m l&apos;un de l&apos;autre, de %2 à %3</translation>
    </message>
    <message>
        <source>%1; between the object and the goal&apos;s tree stands &apos;%2&apos;, at %3</source>
        <translation>%1&#xa0;; entre l&apos;objet et l&apos;arbre du but se trouve «&#xa0;%2&#xa0;», en %3</translation>
    </message>
    <message>
        <source>tightest passage reached: %1 mm to &apos;%2&apos;, at %3</source>
        <translation>passage le plus étroit atteint&#xa0;: %1 mm par rapport à «&#xa0;%2&#xa0;», en %3</translation>
    </message>
    <message>
        <source>with %1 mm more room between the object and &apos;%2&apos;, at %3, there is a path of %4 configurations</source>
        <translation>avec %1 mm de place en plus entre l&apos;objet et «&#xa0;%2&#xa0;», en %3, il existe un chemin de %4 configurations</translation>
    </message>
    <message>
        <source>no erosion of the object that was tried opens a path</source>
        <translation>aucun des amincissements essayés de l&apos;objet n&apos;ouvre de chemin</translation>
    </message>
    <message>
        <source>solved</source>
        <translation>résolu</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>limit-reached</source>
        <translation>limite atteinte</translation>
    </message>
    <message>
        <source>not-certified</source>
        <translation>non certifié</translation>
    </message>
    <message>
        <source>no-path</source>
        <translation>sans chemin</translation>
    </message>
    <message>
        <source>in-collision</source>
        <translation>en collision</translation>
    </message>
    <message>
        <source>malformed</source>
        <translation>mal formé</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>pending</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>your hand showed %1 {1|configuration|configurations}; %2 {2|was|were} in collision, %3 of these {3|was|were} moved to contact</source>
        <translation>votre main a montré %1 {1|configuration|configurations}&#xa0;; %2 {2|était|étaient} en collision, dont %3 {3|a été amenée|ont été amenées} au contact</translation>
    </message>
    <message>
        <source>your way joined start and goal</source>
        <translation>votre trajet a relié le départ et le but</translation>
    </message>
    <message>
        <source>the computer joined start and goal</source>
        <translation>l&apos;ordinateur a relié le départ et le but</translation>
    </message>
    <message>
        <source>the path follows your way for %1 of its length</source>
        <translation>le chemin suit votre trajet sur %1 de sa longueur</translation>
    </message>
    <message>
        <source>coarse path %1:</source>
        <translation>chemin grossier %1&#xa0;:</translation>
    </message>
    <message>
        <source>  %1 to %2: %3, %4 random {4|configuration|configurations} (%5)</source>
        <translation>  %1 vers %2&#xa0;: %3, %4 {4|configuration aléatoire|configurations aléatoires} (%5)</translation>
    </message>
    <message>
        <source>%1 by %2 after %3 {3|step|steps} (%4 s virtual, %5 s of planning)</source>
        <translation>%1 par %2 après %3 pas (%4 s virtuelles, %5 s de planification)</translation>
    </message>
    <message>
        <source>nodes %1, edges %2, configurations: random %3, operator %4, contact %5</source>
        <translation>nœuds&#xa0;: %1, arêtes&#xa0;: %2, configurations aléatoires&#xa0;: %3, de l&apos;opérateur&#xa0;: %4, de contact&#xa0;: %5</translation>
    </message>
    <message>
        <source>nodes by the computer %1, the operator %2, contact %3</source>
        <translation>nœuds de l&apos;ordinateur&#xa0;: %1, de l&apos;opérateur&#xa0;: %2, de contact&#xa0;: %3</translation>
    </message>
    <message>
        <source>path of %1 {1|configuration|configurations}, %2 m, %3 rad</source>
        <translation>chemin de %1 {1|configuration|configurations}, %2 m, %3 rad</translation>
    </message>
    <message>
        <source>of its length by the computer %1, the operator %2, contact %3</source>
        <translation>sur sa longueur, l&apos;ordinateur&#xa0;: %1, l&apos;opérateur&#xa0;: %2, le contact&#xa0;: %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>«&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>held at its start by %1</source>
        <translation>retenu à son départ par %1</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s&#xa0;: %2</translation>
    </message>
    <message>
        <source>comparing pairs of bodies, %1 %</source>
        <translation>comparaison des paires de corps, %1&#xa0;%</translation>
    </message>
    <message>
        <source>searching motions of %1 {1|part|parts}, effort %2</source>
        <translation>recherche des mouvements de %1 {1|pièce|pièces}, effort %2</translation>
    </message>
    <message>
        <source>%1 of %2 {2|part|parts}: %3 removed (%4)</source>
        <translation>%1 {1|pièce|pièces} sur %2&#xa0;: %3 démontée (%4)</translation>
    </message>
    <message>
        <source>%1 of %2 {2|part|parts}: %3 removed as one (%4)</source>
        <translation>%1 {1|pièce|pièces} sur %2&#xa0;: %3 démontées ensemble (%4)</translation>
    </message>
    <message>
        <source>is not a number from 1, a comma and a name: %1</source>
        <translation>n&apos;est pas un nombre à partir de 1, une virgule et un nom&#xa0;: %1</translation>
    </message>
    <message>
        <source>Give 3,name.</source>
        <translation>Donnez 3,nom.</translation>
    </message>
    <message>
        <source>is not a name, a comma and a direction: %1</source>
        <translation>n&apos;est pas un nom, une virgule et une direction&#xa0;: %1</translation>
    </message>
    <message>
        <source>Give name,-z or name,0,0,-1.</source>
        <translation>Donnez nom,-z ou nom,0,0,-1.</translation>
    </message>
    <message>
        <source>is not two names with a comma between them: %1</source>
        <translation>n&apos;est pas formé de deux noms séparés par une virgule&#xa0;: %1</translation>
    </message>
    <message>
        <source>Give first,then.</source>
        <translation>Donnez premier,suivant.</translation>
    </message>
    <message>
        <source>is no direction</source>
        <translation>n&apos;est pas une direction</translation>
    </message>
    <message>
        <source>Give three numbers, as 0 0 -1.</source>
        <translation>Donnez trois nombres, comme 0 0 -1.</translation>
    </message>
    <message>
        <source>is unknown: %1</source>
        <translation>est inconnu&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose one of: %1.</source>
        <translation>Choisissez parmi&#xa0;: %1.</translation>
    </message>
    <message>
        <source>are off, so that no part is removed that touches another one where it is assembled</source>
        <translation>sont désactivés, si bien qu&apos;aucune pièce ne se démonte si elle en touche une autre à sa place assemblée</translation>
    </message>
    <message>
        <source>Run again with --fits on, or switch them on in the scenario.</source>
        <translation>Relancez avec --fits on, ou activez-les dans le scénario.</translation>
    </message>
    <message>
        <source>has a strategy, a seed, a base and a mesh tolerance of its own</source>
        <translation>a sa propre stratégie, sa graine, sa base et sa tolérance de maillage</translation>
    </message>
    <message>
        <source>Leave out --strategy, --seed, --stay and --deflection, or plan anew.</source>
        <translation>Omettez --strategy, --seed, --stay et --deflection, ou planifiez à nouveau.</translation>
    </message>
    <message>
        <source>has constraints of its own</source>
        <translation>a ses propres contraintes</translation>
    </message>
    <message>
        <source>Leave out --together, --before, --place, --forbid, --gravity, --joints and --cost, or plan anew.</source>
        <translation>Omettez --together, --before, --place, --forbid, --gravity, --joints et --cost, ou planifiez à nouveau.</translation>
    </message>
    <message>
        <source>%1, not certified</source>
        <translation>%1, non certifié</translation>
    </message>
    <message>
        <source>%1, clearance %2 to &apos;%3&apos;</source>
        <translation>%1, jeu de %2 par rapport à «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>tool: %1</source>
        <translation>outil&#xa0;: %1</translation>
    </message>
    <message>
        <source>forced, although: %1</source>
        <translation>forcée, bien que&#xa0;: %1</translation>
    </message>
    <message>
        <source>support: %1</source>
        <translation>maintien&#xa0;: %1</translation>
    </message>
    <message>
        <source>stuck: %1</source>
        <translation>coincée&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1, blocked by %2</source>
        <translation>%1, bloqué par %2</translation>
    </message>
    <message>
        <source>the group of step %1 is disassembled off %2:</source>
        <translation>le groupe de l&apos;étape %1 se démonte à partir de %2&#xa0;:</translation>
    </message>
    <message>
        <source>%1 of %2 {2|part|parts} removed in %3 {3|step|steps}</source>
        <translation>%1 {1|pièce démontée|pièces démontées} sur %2 en %3 {3|étape|étapes}</translation>
    </message>
    <message>
        <source>%1, every motion certified</source>
        <translation>%1, tous les mouvements sont certifiés</translation>
    </message>
    <message>
        <source>%1, every motion certified but those of %2 flexible {2|part|parts}</source>
        <translation>%1, tous les mouvements sont certifiés sauf ceux de %2 {2|pièce souple|pièces souples}</translation>
    </message>
    <message>
        <source>base: %1</source>
        <translation>base&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of the removed parts are in groups that are not disassembled</source>
        <translation>parmi les pièces démontées, %1 le sont dans des groupes qui ne sont pas démontés</translation>
    </message>
    <message>
        <source>%1, computed in %2 s</source>
        <translation>%1, calculé en %2 s</translation>
    </message>
    <message>
        <source>Choose greedy or best-first.</source>
        <translation>Choisissez greedy ou best-first.</translation>
    </message>
    <message>
        <source>was reached while fits were searched</source>
        <translation>a été atteinte pendant la recherche des ajustements</translation>
    </message>
    <message>
        <source>Give more time.</source>
        <translation>Donnez plus de temps.</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>segment %1</translation>
    </message>
    <message>
        <source>Only certified paths are smoothed. glissade-cli check says more about the path.</source>
        <translation>Seuls les chemins certifiés sont raccourcis. glissade-cli check en dit plus sur le chemin.</translation>
    </message>
    <message>
        <source>from %1 m to %2 m in the metric, from %3 to %4 configurations, %5</source>
        <translation>de %1 m à %2 m dans la métrique, de %3 à %4 configurations, %5</translation>
    </message>
    <message>
        <source>%1 of %2 {2|run|runs}, %3 solved</source>
        <translation>%1 {1|essai|essais} sur %2, %3 {3|résolu|résolus}</translation>
    </message>
    <message>
        <source>%1, %2 ended by time, memory or a fault</source>
        <translation>%1, %2 terminés par le temps, la mémoire ou une défaillance</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, encore %2 environ</translation>
    </message>
    <message>
        <source>%1 (quick)</source>
        <translation>%1 (version rapide)</translation>
    </message>
    <message>
        <source>medians of the solved runs</source>
        <translation>médianes des essais résolus</translation>
    </message>
    <message>
        <source>     solved   virtual s     nodes     edges    random</source>
        <translation>     résolus virtuel s     nœuds    arêtes    tirées</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>see %1 and summary.csv</source>
        <translation>voir %1 et summary.csv</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not I/N with I from 1 to N</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas I/N avec I de 1 à N</translation>
    </message>
    <message>
        <source>Write 1/4, 2/4, 3/4 and 4/4 for four shards.</source>
        <translation>Écrivez 1/4, 2/4, 3/4 et 4/4 pour quatre parts.</translation>
    </message>
    <message>
        <source>%1 {1|cell|cells}, %2 {2|run|runs} in shard %3 of %4, %5 of them done</source>
        <translation>%1 {1|cellule|cellules}, %2 {2|essai|essais} dans la part %3 sur %4, dont %5 {5|effectué|effectués}</translation>
    </message>
    <message>
        <source>  %1 {1|seed|seeds} of: %2</source>
        <translation>  %1 {1|graine|graines} de&#xa0;: %2</translation>
    </message>
    <message>
        <source>swept volume %1 %2, %3 triangles; it contains the sweep, and its surface is at most %4 mm away from it</source>
        <translation>volume balayé de %1 %2, %3 triangles&#xa0;; il contient tout le balayage, et sa surface en est éloignée de %4 mm au plus</translation>
    </message>
    <message>
        <source>its volume is about %1 % larger than what the object covers</source>
        <translation>son volume dépasse d&apos;environ %1&#xa0;% ce que l&apos;objet occupe</translation>
    </message>
    <message>
        <source>how much larger its volume is than what the object covers is not known: the object is thin</source>
        <translation>on ne sait pas de combien son volume dépasse ce que l&apos;objet occupe&#xa0;: l&apos;objet est mince</translation>
    </message>
    <message>
        <source>within it or at its surface: %1</source>
        <translation>à l&apos;intérieur ou à sa surface&#xa0;: %1</translation>
    </message>
    <message>
        <source>the swept volume was not written</source>
        <translation>le volume balayé n&apos;a pas été écrit</translation>
    </message>
    <message>
        <source>the times are estimates and were not measured; --write-table writes the table, --table reads an edited one</source>
        <translation>les temps sont des estimations et n&apos;ont pas été mesurés&#xa0;; --write-table écrit le tableau, --table en lit un modifié</translation>
    </message>
    <message>
        <source>step  seconds   fetch   place    turn    tool    hold  parts</source>
        <translation>  n° secondes prendre   poser tourner   outil   tenir  pièces</translation>
    </message>
    <message>
        <source>%1 {1|station|stations}: cycle time %2 s (minimum %3 s), utilization %4 %</source>
        <translation>%1 {1|poste|postes}&#xa0;: temps de cycle %2 s (minimum %3 s), taux d&apos;occupation %4 %</translation>
    </message>
    <message>
        <source>  station %1: %2 s, steps %3</source>
        <translation>  poste %1&#xa0;: %2 s, étapes %3</translation>
    </message>
    <message>
        <source>one person: %1 s</source>
        <translation>une personne&#xa0;: %1 s</translation>
    </message>
    <message>
        <source>critical path: %1 s, steps %2</source>
        <translation>chemin critique&#xa0;: %1 s, étapes %2</translation>
    </message>
    <message>
        <source>running the workbench</source>
        <translation>exécution du programme</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>Give a number.</source>
        <translation>Indiquez un nombre.</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>n&apos;est pas un nombre entier</translation>
    </message>
    <message>
        <source>Give a number of 0 or more.</source>
        <translation>Indiquez un nombre positif ou nul.</translation>
    </message>
    <message>
        <source>is not a mode of stereo</source>
        <translation>n&apos;est pas un mode stéréo</translation>
    </message>
    <message>
        <source>glissade --help names them.</source>
        <translation>glissade --help les énumère.</translation>
    </message>
    <message>
        <source>is a mode that is not possible here</source>
        <translation>est un mode impossible ici</translation>
    </message>
    <message>
        <source>is a file too many: one scenario is opened</source>
        <translation>est un fichier de trop&#xa0;: un seul scénario est ouvert</translation>
    </message>
    <message>
        <source>Give one scenario, or on screen part files only. glissade-cli new makes a scenario of parts.</source>
        <translation>Indiquez un scénario ou, à l&apos;écran, des fichiers de pièces seulement. glissade-cli new fait un scénario à partir de pièces.</translation>
    </message>
    <message>
        <source>See glissade --help.</source>
        <translation>Voir glissade --help.</translation>
    </message>
    <message>
        <source>is not WIDTHxHEIGHT</source>
        <translation>n&apos;est pas LARGEURxHAUTEUR</translation>
    </message>
    <message>
        <source>Give for example 1280x720.</source>
        <translation>Indiquez par exemple 1280x720.</translation>
    </message>
    <message>
        <source>is not a whole number from 16 to 2048</source>
        <translation>n&apos;est pas un nombre entier de 16 à 2048</translation>
    </message>
    <message>
        <source>Give for example 256.</source>
        <translation>Indiquez par exemple 256.</translation>
    </message>
    <message>
        <source>is neither light nor dark</source>
        <translation>n&apos;est ni light ni dark</translation>
    </message>
    <message>
        <source>is neither en nor fr</source>
        <translation>n&apos;est ni en ni fr</translation>
    </message>
    <message>
        <source>looking for places to help</source>
        <translation>recherche d&apos;endroits où aider</translation>
    </message>
    <message>
        <source>edits cannot be saved automatically: %1</source>
        <translation>les modifications ne peuvent pas être enregistrées automatiquement&#xa0;: %1</translation>
    </message>
    <message>
        <source>Save the scenario.</source>
        <translation>Enregistrez le scénario.</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>le but</translation>
    </message>
    <message>
        <source>planning coarsely</source>
        <translation>planification grossière</translation>
    </message>
    <message>
        <source>finding edges and faces</source>
        <translation>recherche des arêtes et des faces</translation>
    </message>
    <message>
        <source>ffmpeg could not write the film: %1</source>
        <translation>ffmpeg n&apos;a pas pu écrire le film&#xa0;: %1</translation>
    </message>
    <message>
        <source>Check the folder, its free space, and that ffmpeg has the codecs libx264 and libvpx-vp9.</source>
        <translation>Vérifiez le dossier, sa place libre, et la présence des codecs libx264 et libvpx-vp9 dans ffmpeg.</translation>
    </message>
    <message>
        <source>the film was cancelled</source>
        <translation>le film a été annulé</translation>
    </message>
    <message>
        <source>ffmpeg is needed for films, and is not installed</source>
        <translation>ffmpeg est nécessaire pour les films, et n&apos;est pas installé</translation>
    </message>
    <message>
        <source>Install the package ffmpeg, or give a name that ends with .png for a series of pictures.</source>
        <translation>Installez le paquet ffmpeg, ou donnez un nom qui finit par .png pour une série d&apos;images.</translation>
    </message>
    <message>
        <source>films are not written in this format</source>
        <translation>les films ne sont pas écrits dans ce format</translation>
    </message>
    <message>
        <source>Choose one of: .mp4, .webm, .png.</source>
        <translation>Choisissez parmi&#xa0;: .mp4, .webm, .png.</translation>
    </message>
    <message>
        <source>handling an event of the window</source>
        <translation>traitement d&apos;un événement de la fenêtre</translation>
    </message>
    <message>
        <source>showing an error</source>
        <translation>affichage d&apos;une erreur</translation>
    </message>
    <message>
        <source>UDP port %1</source>
        <translation>port UDP %1</translation>
    </message>
    <message>
        <source>cannot be used: %1</source>
        <translation>ne peut pas être utilisé : %1</translation>
    </message>
    <message>
        <source>Choose another port, and set it in the tracker, too.</source>
        <translation>Choisissez un autre port, et réglez-le aussi dans le capteur.</translation>
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
        <source>documents are not written in this format</source>
        <translation>les documents ne sont pas écrits dans ce format</translation>
    </message>
    <message>
        <source>Choose .html or .pdf.</source>
        <translation>Choisissez .html ou .pdf.</translation>
    </message>
    <message>
        <source>the document was cancelled</source>
        <translation>le document a été annulé</translation>
    </message>
    <message>
        <source>looking for joints</source>
        <translation>recherche des liaisons</translation>
    </message>
    <message>
        <source>certifying a kept path</source>
        <translation>certification d&apos;un chemin conservé</translation>
    </message>
    <message>
        <source>another body is the moving part now</source>
        <translation>un autre corps est maintenant la pièce manipulée</translation>
    </message>
    <message>
        <source>Make &apos;%1&apos; the object first.</source>
        <translation>Faites d&apos;abord de «&#xa0;%1&#xa0;» l&apos;objet.</translation>
    </message>
    <message>
        <source>a run is going on</source>
        <translation>un calcul est en cours</translation>
    </message>
    <message>
        <source>Stop the run first.</source>
        <translation>Arrêtez d&apos;abord le calcul.</translation>
    </message>
    <message>
        <source>measuring a clearance</source>
        <translation>mesure d&apos;un jeu</translation>
    </message>
    <message>
        <source>the report of a path is written as .html or .pdf</source>
        <translation>le rapport d&apos;un chemin s&apos;écrit en .html ou .pdf</translation>
    </message>
    <message>
        <source>Give a file name with one of these endings.</source>
        <translation>Donnez un nom de fichier avec l&apos;une de ces extensions.</translation>
    </message>
    <message>
        <source>The path</source>
        <translation>Le chemin</translation>
    </message>
    <message>
        <source>The place with the smallest clearance</source>
        <translation>L&apos;endroit du plus petit jeu</translation>
    </message>
    <message>
        <source>no scenario is open</source>
        <translation>aucun scénario n&apos;est ouvert</translation>
    </message>
    <message>
        <source>Open its scenario first.</source>
        <translation>Ouvrez d&apos;abord son scénario.</translation>
    </message>
    <message>
        <source>a recording is shown</source>
        <translation>un enregistrement est affiché</translation>
    </message>
    <message>
        <source>Close the replay first.</source>
        <translation>Fermez d&apos;abord la relecture.</translation>
    </message>
    <message>
        <source>measuring the clearance along the path</source>
        <translation>mesure du jeu le long du chemin</translation>
    </message>
    <message>
        <source>there is no path to export</source>
        <translation>il n&apos;y a pas de chemin à exporter</translation>
    </message>
    <message>
        <source>Solve first.</source>
        <translation>Cherchez d&apos;abord un chemin.</translation>
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
        <source>examining start and goal</source>
        <translation>examen du départ et du but</translation>
    </message>
    <message>
        <source>there is no run to save</source>
        <translation>il n&apos;y a pas de calcul à enregistrer</translation>
    </message>
    <message>
        <source>Start one first.</source>
        <translation>Lancez d&apos;abord un calcul.</translation>
    </message>
    <message>
        <source>See the list of the interaction panel.</source>
        <translation>Voyez la liste du panneau d&apos;interaction.</translation>
    </message>
    <message>
        <source>cutting bodies open</source>
        <translation>coupe des corps</translation>
    </message>
    <message>
        <source>no product is open</source>
        <translation>aucun produit n&apos;est ouvert</translation>
    </message>
    <message>
        <source>Open the product first.</source>
        <translation>Ouvrez d&apos;abord le produit.</translation>
    </message>
    <message>
        <source>is not written yet</source>
        <translation>n&apos;est pas encore écrit</translation>
    </message>
    <message>
        <source>Wait.</source>
        <translation>Attendez.</translation>
    </message>
    <message>
        <source>assembly plans are not written in this format</source>
        <translation>les plans d&apos;assemblage ne s&apos;écrivent pas dans ce format</translation>
    </message>
    <message>
        <source>Choose one of: .json, .csv, .glb, .html, .pdf, .mp4, .webm, .png.</source>
        <translation>Choisissez parmi&#xa0;: .json, .csv, .glb, .html, .pdf, .mp4, .webm, .png.</translation>
    </message>
    <message>
        <source>looking for a view of the step</source>
        <translation>recherche d&apos;une vue de l&apos;étape</translation>
    </message>
    <message>
        <source>cell %1, seed %2</source>
        <translation>cellule %1, graine %2</translation>
    </message>
    <message>
        <source>ends otherwise than in the study</source>
        <translation>se termine autrement que dans l&apos;étude</translation>
    </message>
    <message>
        <source>Use the version that made it, or make the study again.</source>
        <translation>Utilisez la version qui l&apos;a produite, ou refaites l&apos;étude.</translation>
    </message>
    <message>
        <source>is for runs without a display</source>
        <translation>est prévu pour les exécutions sans affichage</translation>
    </message>
    <message>
        <source>Add --offscreen.</source>
        <translation>Ajoutez --offscreen.</translation>
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
        <source>the scenario has changed since the study was made</source>
        <translation>le scénario a changé depuis que l&apos;étude a été faite</translation>
    </message>
    <message>
        <source>Put the old one back, or make the study again.</source>
        <translation>Remettez l&apos;ancien scénario, ou refaites l&apos;étude.</translation>
    </message>
    <message>
        <source>balancing the line</source>
        <translation>équilibrage de la ligne</translation>
    </message>
    <message>
        <source>looking for variants</source>
        <translation>recherche de variantes</translation>
    </message>
    <message>
        <source>announcing a result</source>
        <translation>annonce d&apos;un résultat</translation>
    </message>
    <message>
        <source>the journal cannot be written: %1</source>
        <translation>le journal ne peut pas être écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>The run is not recorded on disk.</source>
        <translation>Le calcul n&apos;est pas enregistré sur disque.</translation>
    </message>
    <message>
        <source>building the environment model</source>
        <translation>construction du modèle d&apos;environnement</translation>
    </message>
    <message>
        <source>replaying the recording</source>
        <translation>relecture de l&apos;enregistrement</translation>
    </message>
    <message>
        <source>planning the sequence</source>
        <translation>planification de la séquence</translation>
    </message>
    <message>
        <source>checking the sequence</source>
        <translation>vérification de la séquence</translation>
    </message>
    <message>
        <source>preparing the planner</source>
        <translation>préparation du planificateur</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
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
        <source>Left controller</source>
        <translation>Manette gauche</translation>
    </message>
    <message>
        <source>Right controller</source>
        <translation>Manette droite</translation>
    </message>
    <message>
        <source>arranging the product</source>
        <translation>arrangement du produit</translation>
    </message>
    <message>
        <source>there is no kept path of this name</source>
        <translation>il n&apos;y a pas de chemin gardé de ce nom</translation>
    </message>
    <message>
        <source>Choose one of the list.</source>
        <translation>Choisissez-en un dans la liste.</translation>
    </message>
    <message>
        <source>the new name is empty</source>
        <translation>le nouveau nom est vide</translation>
    </message>
    <message>
        <source>Give a name.</source>
        <translation>Donnez un nom.</translation>
    </message>
    <message>
        <source>another path has this name</source>
        <translation>un autre chemin porte ce nom</translation>
    </message>
    <message>
        <source>Give another name.</source>
        <translation>Indiquez un autre nom.</translation>
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
        <translation>la règle %1 du scénario utilise l&apos;attribut «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Change the rule first.</source>
        <translation>Changez d&apos;abord la règle.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>Write it like 0.25.</source>
        <translation>Écrivez-le comme 0.25.</translation>
    </message>
    <message>
        <source>reading the parts</source>
        <translation>lecture des pièces</translation>
    </message>
    <message>
        <source>is a picture that cannot be read</source>
        <translation>est une image illisible</translation>
    </message>
    <message>
        <source>Save the logo as PNG again.</source>
        <translation>Enregistrez de nouveau le logo en PNG.</translation>
    </message>
    <message>
        <source>the page of the manual has no heading</source>
        <translation>la page du manuel n&apos;a pas de titre</translation>
    </message>
    <message>
        <source>Write it.</source>
        <translation>Écrivez-le.</translation>
    </message>
    <message>
        <source>the manual names what does not exist: %1</source>
        <translation>le manuel nomme ce qui n&apos;existe pas&#xa0;: %1</translation>
    </message>
    <message>
        <source>Correct the page.</source>
        <translation>Corrigez la page.</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>drawing the parts</source>
        <translation>dessin des pièces</translation>
    </message>
    <message>
        <source>the picture cannot be written in this format</source>
        <translation>l&apos;image ne peut pas être écrite dans ce format</translation>
    </message>
    <message>
        <source>Choose a name that ends in .png or .jpg.</source>
        <translation>Choisissez un nom qui finit par .png ou .jpg.</translation>
    </message>
    <message>
        <source>hand access was not checked to the end</source>
        <translation>la vérification de l&apos;accès de la main n&apos;est pas terminée</translation>
    </message>
    <message>
        <source>names &apos;%1&apos;, which is not a body of the product</source>
        <translation>nomme «&#xa0;%1&#xa0;», qui n&apos;est pas un corps du produit</translation>
    </message>
    <message>
        <source>See &apos;glissade-cli fits&apos; for the names.</source>
        <translation>Les noms sont ceux de «&#xa0;glissade-cli fits&#xa0;».</translation>
    </message>
    <message>
        <source>leaves no body</source>
        <translation>ne laisse aucun corps</translation>
    </message>
    <message>
        <source>Name fewer bodies.</source>
        <translation>Nommez moins de corps.</translation>
    </message>
    <message>
        <source>the certificate is about the product without these shapes, which the file states: %1</source>
        <translation>le certificat porte sur le produit sans ces formes, que le fichier énonce&#xa0;: %1</translation>
    </message>
    <message>
        <source>its input and output cannot be made</source>
        <translation>ses flux d&apos;entrée et de sortie ne peuvent pas être créés</translation>
    </message>
    <message>
        <source>no process can be made</source>
        <translation>aucun processus ne peut être créé</translation>
    </message>
    <message>
        <source>it cannot have a session of its own</source>
        <translation>il ne peut pas avoir sa propre session</translation>
    </message>
    <message>
        <source>its limits cannot be set</source>
        <translation>ses limites ne peuvent pas être fixées</translation>
    </message>
    <message>
        <source>its open files cannot be closed</source>
        <translation>ses fichiers ouverts ne peuvent pas être fermés</translation>
    </message>
    <message>
        <source>its file cannot be run</source>
        <translation>son fichier ne peut pas être exécuté</translation>
    </message>
    <message>
        <source>cannot be started: %1: %2</source>
        <translation>ne peut pas être lancé&#xa0;: %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Install the program again.</source>
        <translation>Réinstallez le programme.</translation>
    </message>
    <message>
        <source>Run fewer programs at once, or free some memory.</source>
        <translation>Exécutez moins de programmes en même temps, ou libérez de la mémoire.</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>is too large</source>
        <translation>est trop grand</translation>
    </message>
    <message>
        <source>Give a file of its kind.</source>
        <translation>Donnez un fichier du type voulu.</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ne peut pas être ouvert&#xa0;: %1</translation>
    </message>
    <message>
        <source>Check the name and the folder.</source>
        <translation>Vérifiez le nom et le dossier.</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>Give a file, not a folder, a pipe or a device.</source>
        <translation>Donnez un fichier, et non un dossier, un tube ou un périphérique.</translation>
    </message>
    <message>
        <source>was saved, but %1</source>
        <translation>a été enregistré, mais %1</translation>
    </message>
    <message>
        <source>was not saved: another program has changed the file since it was read</source>
        <translation>n&apos;a pas été enregistré&#xa0;: un autre programme a modifié le fichier depuis sa lecture</translation>
    </message>
    <message>
        <source>Save under another name, or open the file again.</source>
        <translation>Enregistrez sous un autre nom, ou ouvrez de nouveau le fichier.</translation>
    </message>
    <message>
        <source>was not saved: the file has been removed or renamed since it was read</source>
        <translation>n&apos;a pas été enregistré&#xa0;: le fichier a été supprimé ou renommé depuis sa lecture</translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation>Enregistrez sous un autre nom.</translation>
    </message>
    <message>
        <source>its group</source>
        <translation>son groupe</translation>
    </message>
    <message>
        <source>its owner</source>
        <translation>son propriétaire</translation>
    </message>
    <message>
        <source>its owner and group</source>
        <translation>son propriétaire et son groupe</translation>
    </message>
    <message>
        <source>%1 could not be kept</source>
        <translation>%1 n&apos;ont pas pu être conservés</translation>
    </message>
    <message>
        <source>Ask the former owner if others read the file.</source>
        <translation>Si d&apos;autres personnes lisent ce fichier, adressez-vous à l&apos;ancien propriétaire.</translation>
    </message>
    <message>
        <source>its permissions cannot be set</source>
        <translation>ses droits d&apos;accès ne peuvent pas être fixés</translation>
    </message>
    <message>
        <source>its access control list could not be kept</source>
        <translation>sa liste de contrôle d&apos;accès n&apos;a pas pu être conservée</translation>
    </message>
    <message>
        <source>Set it again.</source>
        <translation>Fixez-la de nouveau.</translation>
    </message>
    <message>
        <source>the file has %1 more {1|name (hard link), which keeps|names (hard links), which keep} the old content</source>
        <translation>le fichier a %1 {1|autre nom (lien physique), qui garde|autres noms (liens physiques), qui gardent} l&apos;ancien contenu</translation>
    </message>
    <message>
        <source>Copy the file over them, or link them again.</source>
        <translation>Copiez le fichier à leur place, ou refaites les liens.</translation>
    </message>
    <message>
        <source>cannot be saved over the present file: %1</source>
        <translation>ne peut pas remplacer le fichier présent&#xa0;: %1</translation>
    </message>
    <message>
        <source>its folder could not be flushed to the disk</source>
        <translation>son dossier n&apos;a pas pu être écrit sur le disque</translation>
    </message>
    <message>
        <source>After a power failure the file may have its old content. Save again.</source>
        <translation>Après une coupure de courant, le fichier pourrait avoir son ancien contenu. Enregistrez de nouveau.</translation>
    </message>
    <message>
        <source>no earlier version was kept</source>
        <translation>aucune version antérieure n&apos;a été conservée</translation>
    </message>
    <message>
        <source>It could not be read.</source>
        <translation>Elle n&apos;a pas pu être lue.</translation>
    </message>
    <message>
        <source>no earlier version was kept: %1</source>
        <translation>aucune version antérieure n&apos;a été conservée&#xa0;: %1</translation>
    </message>
    <message>
        <source>its folder of earlier versions cannot be made</source>
        <translation>son dossier de versions antérieures ne peut pas être créé</translation>
    </message>
    <message>
        <source>the permissions of its earlier version cannot be set</source>
        <translation>les droits d&apos;accès de sa version antérieure ne peuvent pas être fixés</translation>
    </message>
    <message>
        <source>its earlier version cannot be flushed to the disk</source>
        <translation>sa version antérieure ne peut pas être écrite sur le disque</translation>
    </message>
    <message>
        <source>there was not enough memory while %1 (%2)</source>
        <translation>la mémoire n&apos;a pas suffi pour cette opération&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>Close other programs or use coarser parts, then try again.</source>
        <translation>Fermez d&apos;autres programmes ou prenez des pièces moins fines, puis réessayez.</translation>
    </message>
    <message>
        <source>an error occurred while %1: %2</source>
        <translation>une erreur est survenue pendant cette opération&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>Try again. If it happens again, report it with the scenario and the seed.</source>
        <translation>Réessayez. Si l&apos;erreur revient, signalez-la avec le scénario et la graine.</translation>
    </message>
    <message>
        <source>of an unknown kind</source>
        <translation>de nature inconnue</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>n&apos;est pas un objet JSON</translation>
    </message>
    <message>
        <source>is an unknown key</source>
        <translation>est une clé inconnue</translation>
    </message>
    <message>
        <source>Remove it, or use one of: %1.</source>
        <translation>Supprimez-la, ou utilisez l&apos;une de&#xa0;: %1.</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>Add it.</source>
        <translation>Ajoutez-le.</translation>
    </message>
    <message>
        <source>is not a list</source>
        <translation>n&apos;est pas une liste</translation>
    </message>
    <message>
        <source>has more than %1 entries</source>
        <translation>a plus de %1 éléments</translation>
    </message>
    <message>
        <source>is not a text</source>
        <translation>n&apos;est pas un texte</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>holds a zero byte, which no file&apos;s name can</source>
        <translation>contient un octet nul, ce qu&apos;aucun nom de fichier ne peut</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>is not above zero</source>
        <translation>n&apos;est pas supérieur à zéro</translation>
    </message>
    <message>
        <source>is beyond 1e9 m</source>
        <translation>dépasse 1e9 m</translation>
    </message>
    <message>
        <source>Give metres; check the unit.</source>
        <translation>Donnez des mètres&#xa0;; vérifiez l&apos;unité.</translation>
    </message>
    <message>
        <source>is not a whole number of zero or more</source>
        <translation>n&apos;est pas un nombre entier positif ou nul</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>n&apos;est ni true ni false</translation>
    </message>
    <message>
        <source>is nested too deeply</source>
        <translation>est trop imbriqué</translation>
    </message>
    <message>
        <source>holds too many values</source>
        <translation>contient trop de valeurs</translation>
    </message>
    <message>
        <source>holds the key &apos;%1&apos; twice in one object</source>
        <translation>contient deux fois la clé «&#xa0;%1&#xa0;» dans un objet</translation>
    </message>
    <message>
        <source>holds an object with more than %1 keys</source>
        <translation>contient un objet de plus de %1 clés</translation>
    </message>
    <message>
        <source>was not read to its end</source>
        <translation>n&apos;a pas été lu jusqu&apos;au bout</translation>
    </message>
    <message>
        <source>Open it again.</source>
        <translation>Ouvrez-le de nouveau.</translation>
    </message>
    <message>
        <source>Give a file with content.</source>
        <translation>Donnez un fichier qui a un contenu.</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>n&apos;est pas du JSON valide</translation>
    </message>
    <message>
        <source>Correct the text there.</source>
        <translation>Corrigez le texte à cet endroit.</translation>
    </message>
    <message>
        <source>Correct the file.</source>
        <translation>Corrigez le fichier.</translation>
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
        <source>is not one of: %1</source>
        <translation>n&apos;est pas l&apos;une des valeurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>Computer share</source>
        <translation>Part de l&apos;ordinateur</translation>
    </message>
    <message>
        <source>Contact samples</source>
        <translation>Échantillons de contact</translation>
    </message>
    <message>
        <source>Samples drawn on the tangent plane each time contact mode is entered.</source>
        <translation>Échantillons tirés sur le plan tangent à chaque entrée en mode contact.</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Distance de contact</translation>
    </message>
    <message>
        <source>Closer than this to the nearest obstacle, contact mode begins.</source>
        <translation>Le mode contact commence quand l&apos;obstacle le plus proche est à moins de cette distance.</translation>
    </message>
    <message>
        <source>Contact disc</source>
        <translation>Disque de contact</translation>
    </message>
    <message>
        <source>Radius of the disc on the tangent plane in which contact samples are drawn.</source>
        <translation>Rayon du disque du plan tangent dans lequel les échantillons de contact sont tirés.</translation>
    </message>
    <message>
        <source>Contact gap</source>
        <translation>Écart au contact</translation>
    </message>
    <message>
        <source>Gap that contact samples keep to the surface, so that they touch without penetrating.</source>
        <translation>Écart que les échantillons de contact gardent à la surface, pour toucher sans pénétrer.</translation>
    </message>
    <message>
        <source>Required clearance</source>
        <translation>Jeu exigé</translation>
    </message>
    <message>
        <source>Clearance that a delivered path is certified to keep.</source>
        <translation>Jeu que le chemin livré est certifié garder.</translation>
    </message>
    <message>
        <source>Growth step</source>
        <translation>Pas de croissance</translation>
    </message>
    <message>
        <source>Sampling step of edges while the trees grow (delivered edges are certified).</source>
        <translation>Pas d&apos;échantillonnage des segments pendant la croissance des arbres (les segments livrés sont certifiés).</translation>
    </message>
    <message>
        <source>Extension step</source>
        <translation>Pas d&apos;extension</translation>
    </message>
    <message>
        <source>A blocked extension towards a random configuration ends at a multiple of this, off the obstacle.</source>
        <translation>Une extension bloquée vers une configuration aléatoire s&apos;arrête à un multiple de ce pas, à l&apos;écart de l&apos;obstacle.</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>Pas par seconde</translation>
    </message>
    <message>
        <source>Lockstep clock: planner steps in one second of the simulated or recorded operator.</source>
        <translation>Horloge du mode pas à pas&#xa0;: pas du planificateur par seconde de l&apos;opérateur simulé ou enregistré.</translation>
    </message>
    <message>
        <source>Step limit</source>
        <translation>Limite de pas</translation>
    </message>
    <message>
        <source>Stop after this many planner steps; 0 is no limit.</source>
        <translation>Arrêter après ce nombre de pas du planificateur&#xa0;; 0&#xa0;: sans limite.</translation>
    </message>
    <message>
        <source>Sample limit</source>
        <translation>Limite d&apos;échantillons</translation>
    </message>
    <message>
        <source>Stop after this many random configurations; 0 is no limit.</source>
        <translation>Arrêter après ce nombre de configurations aléatoires&#xa0;; 0&#xa0;: sans limite.</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Limite de temps</translation>
    </message>
    <message>
        <source>Stop after this many seconds of planning; 0 is no limit.</source>
        <translation>Arrêter après ce nombre de secondes de planification&#xa0;; 0&#xa0;: sans limite.</translation>
    </message>
    <message>
        <source>Samples of strategy G</source>
        <translation>Échantillons de la stratégie G</translation>
    </message>
    <message>
        <source>Strategy G gives up after this many random configurations.</source>
        <translation>La stratégie G abandonne après ce nombre de configurations aléatoires.</translation>
    </message>
    <message>
        <source>Samples a step</source>
        <translation>Échantillons par étape</translation>
    </message>
    <message>
        <source>A topological step fails after this many random configurations.</source>
        <translation>Une étape topologique échoue après ce nombre de configurations aléatoires.</translation>
    </message>
    <message>
        <source>Samples a border</source>
        <translation>Échantillons par frontière</translation>
    </message>
    <message>
        <source>Random configurations drawn in a border to find its milestone.</source>
        <translation>Configurations aléatoires tirées dans une frontière pour trouver son jalon.</translation>
    </message>
    <message>
        <source>Coarse paths</source>
        <translation>Chemins grossiers</translation>
    </message>
    <message>
        <source>Coarse paths that a strategy with a loop tries before it searches the whole workspace only.</source>
        <translation>Nombre de chemins grossiers qu&apos;une stratégie en boucle essaie avant de ne chercher que dans tout l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Shortcuts tried on the path found, each certified before it is taken; 0 leaves the path as planned.</source>
        <translation>Raccourcis essayés sur le chemin trouvé, chacun certifié avant d&apos;être pris&#xa0;; 0 laisse le chemin tel que planifié.</translation>
    </message>
    <message>
        <source>Repulsion</source>
        <translation>Répulsion</translation>
    </message>
    <message>
        <source>Guidance: how strongly obstacles nearer than the contact distance push the hand away; 0 is off.</source>
        <translation>Guidage&#xa0;: avec quelle force les obstacles plus proches que la distance de contact repoussent la main&#xa0;; 0 pour aucune.</translation>
    </message>
    <message>
        <source>Attraction</source>
        <translation>Attraction</translation>
    </message>
    <message>
        <source>Guidance: how strongly the path or the next milestone draws the hand; 0 is off.</source>
        <translation>Guidage&#xa0;: avec quelle force le chemin ou le prochain jalon attire la main&#xa0;; 0 pour aucune.</translation>
    </message>
    <message>
        <source>OMPL&apos;s range</source>
        <translation>Portée d&apos;OMPL</translation>
    </message>
    <message>
        <source>Longest edge of the planners of unmodified OMPL, as a share of the space&apos;s extent; 0 is OMPL&apos;s default.</source>
        <translation>Plus long segment des planificateurs d&apos;OMPL non modifié, en part de l&apos;étendue de l&apos;espace&#xa0;; 0&#xa0;: valeur par défaut d&apos;OMPL.</translation>
    </message>
    <message>
        <source>OMPL&apos;s resolution</source>
        <translation>Résolution d&apos;OMPL</translation>
    </message>
    <message>
        <source>Distance of the configurations that the planners of unmodified OMPL check on an edge, as a share of the space&apos;s extent.</source>
        <translation>Distance des configurations que les planificateurs d&apos;OMPL non modifié examinent sur un segment, en part de l&apos;étendue de l&apos;espace.</translation>
    </message>
    <message>
        <source>Automatic tuning</source>
        <translation>Réglage automatique</translation>
    </message>
    <message>
        <source>What sets itself while planning, added up: 1 for α, 2 for N, 4 for d. 0 is nothing, 7 all three.</source>
        <translation>Valeurs que le programme règle pendant la planification, en somme&#xa0;: 1 pour α, 2 pour N, 4 pour d. 0&#xa0;: aucune, 7&#xa0;: les trois.</translation>
    </message>
    <message>
        <source>Planners side by side</source>
        <translation>Planificateurs en parallèle</translation>
    </message>
    <message>
        <source>Planners of strategy auto that work at the same time, on as many of the machine&apos;s cores. Another number is another search; the cores do not change it.</source>
        <translation>Nombre de planificateurs de la stratégie auto qui travaillent en même temps, sur autant de cœurs de la machine. Un autre nombre donne une autre recherche&#xa0;; le nombre de cœurs ne la change pas.</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>In the window: planner steps a second, so that a person can watch and steer. 0 is full speed; the first paper&apos;s planner made 40.</source>
        <translation>Dans la fenêtre&#xa0;: pas du planificateur par seconde, pour regarder et guider. 0&#xa0;: pleine vitesse&#xa0;; le planificateur du premier article en faisait 40.</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>%1 is %2, which is not allowed</source>
        <translation>%1 vaut %2, ce qui n&apos;est pas admis</translation>
    </message>
    <message>
        <source>Give %1 from %2 to %3.</source>
        <translation>Donnez %1 de %2 à %3.</translation>
    </message>
    <message>
        <source>the folder takes no new file</source>
        <translation>le dossier n&apos;accepte pas de nouveau fichier</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>l&apos;écriture a échoué</translation>
    </message>
    <message>
        <source>flushing to the disk failed</source>
        <translation>l&apos;écriture sur le disque a échoué</translation>
    </message>
    <message>
        <source>closing failed</source>
        <translation>la fermeture a échoué</translation>
    </message>
    <message>
        <source>what was written reads back differently</source>
        <translation>ce qui a été écrit n&apos;est pas relu à l&apos;identique</translation>
    </message>
    <message>
        <source>giving it its name failed</source>
        <translation>il n&apos;a pas pu recevoir son nom</translation>
    </message>
    <message>
        <source>Free some space, or save on another disk.</source>
        <translation>Libérez de la place, ou enregistrez sur un autre disque.</translation>
    </message>
    <message>
        <source>Raise the limit of the file size, or save on another disk.</source>
        <translation>Relevez la limite de taille des fichiers, ou enregistrez sur un autre disque.</translation>
    </message>
    <message>
        <source>Save into a folder that you may write to.</source>
        <translation>Enregistrez dans un dossier où vous avez le droit d&apos;écrire.</translation>
    </message>
    <message>
        <source>The file system is read-only. Save into another folder.</source>
        <translation>Le système de fichiers est en lecture seule. Enregistrez dans un autre dossier.</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Choisissez un nom plus court.</translation>
    </message>
    <message>
        <source>Create the folder, or choose another one.</source>
        <translation>Créez le dossier, ou choisissez-en un autre.</translation>
    </message>
    <message>
        <source>The disk may be failing. Save on another disk.</source>
        <translation>Le disque est peut-être défaillant. Enregistrez sur un autre disque.</translation>
    </message>
    <message>
        <source>Save into another folder.</source>
        <translation>Enregistrez dans un autre dossier.</translation>
    </message>
    <message>
        <source>cannot be saved: %1</source>
        <translation>ne peut pas être enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>What was there is untouched. %1</source>
        <translation>Le contenu précédent est intact. %1</translation>
    </message>
    <message>
        <source>it cannot be looked at</source>
        <translation>il ne peut pas être examiné</translation>
    </message>
    <message>
        <source>its links cannot be followed</source>
        <translation>ses liens ne peuvent pas être suivis</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c&apos;est un dossier</translation>
    </message>
    <message>
        <source>it is a pipe</source>
        <translation>c&apos;est un tube</translation>
    </message>
    <message>
        <source>it is a socket</source>
        <translation>c&apos;est un socket</translation>
    </message>
    <message>
        <source>it is a device</source>
        <translation>c&apos;est un périphérique</translation>
    </message>
    <message>
        <source>it is read-only</source>
        <translation>il est en lecture seule</translation>
    </message>
    <message>
        <source>Save under another name, or make the file writable.</source>
        <translation>Enregistrez sous un autre nom, ou rendez le fichier modifiable.</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>il n&apos;a pas de nom</translation>
    </message>
    <message>
        <source>clashes up to %1 are accepted (--accept-clashes %2)</source>
        <translation>les interférences jusqu&apos;à %1 sont acceptées (--accept-clashes %2)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the one that is cut (--cut &quot;%2&quot;)</source>
        <translation>«&#xa0;%1&#xa0;» est celui qui est découpé (--cut &quot;%2&quot;)</translation>
    </message>
    <message>
        <source>the hook of &apos;%1&apos; in &apos;%2&apos; bends by %3</source>
        <translation>le crochet de « %1 » dans « %2 » fléchit de %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is flexible, so that its motion needs no certificate</source>
        <translation>«&#xa0;%1&#xa0;» est souple, si bien que son mouvement n&apos;a pas besoin de certificat</translation>
    </message>
    <message>
        <source>no joints are used</source>
        <translation>aucune liaison n&apos;est utilisée</translation>
    </message>
    <message>
        <source>the joint of &apos;%1&apos; and &apos;%2&apos; is dissolved or pressed out</source>
        <translation>la liaison de « %1 » et « %2 » est supprimée ou chassée</translation>
    </message>
    <message>
        <source>%1 are one unit</source>
        <translation>%1 forment une unité</translation>
    </message>
    <message>
        <source>%1 are fixed as base</source>
        <translation>%1 sont fixés comme base</translation>
    </message>
    <message>
        <source>&apos;%1&apos; may be removed before &apos;%2&apos;, although a constraint states the reverse</source>
        <translation>«&#xa0;%1&#xa0;» peut être démonté avant «&#xa0;%2&#xa0;», bien qu&apos;une contrainte énonce l&apos;inverse</translation>
    </message>
    <message>
        <source>&apos;%1&apos; may be removed as number %2, although a constraint states number %3</source>
        <translation>«&#xa0;%1&#xa0;» peut être démonté en position %2, bien qu&apos;une contrainte énonce la position %3</translation>
    </message>
    <message>
        <source>the thread of &apos;%1&apos; in &apos;%2&apos; has a pitch of %3, which no standard thread of %4 has</source>
        <translation>le filetage de « %1 » dans « %2 » a un pas de %3, qu&apos;aucun filetage normalisé de %4 n&apos;a</translation>
    </message>
    <message>
        <source>the thread of &apos;%1&apos; in &apos;%2&apos; has a pitch of %3, although the user states %4</source>
        <translation>le filetage de «&#xa0;%1&#xa0;» dans «&#xa0;%2&#xa0;» a un pas de %3, bien que l&apos;utilisateur indique %4</translation>
    </message>
    <message>
        <source>the thread of &apos;%1&apos; in &apos;%2&apos; is left-handed</source>
        <translation>le filetage de « %1 » dans « %2 » est à gauche</translation>
    </message>
    <message>
        <source>the thread of &apos;%1&apos; in &apos;%2&apos; is right-handed, although a name says left-handed</source>
        <translation>le filetage de « %1 » dans « %2 » est à droite, bien qu&apos;un nom dise à gauche</translation>
    </message>
    <message>
        <source>they overlap by %1, a clash that is not accepted</source>
        <translation>ils se recouvrent de %1, une interférence non acceptée</translation>
    </message>
    <message>
        <source>the user uses no joints</source>
        <translation>l&apos;utilisateur n&apos;utilise aucune liaison</translation>
    </message>
    <message>
        <source>the user has dissolved their joint, or has it pressed out</source>
        <translation>l&apos;utilisateur a supprimé leur liaison, ou la fait chasser</translation>
    </message>
    <message>
        <source>the user calls the pair &apos;%1&apos;</source>
        <translation>l&apos;utilisateur dit que la paire est «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the user accepts their clash</source>
        <translation>l&apos;utilisateur accepte leur interférence</translation>
    </message>
    <message>
        <source>the edge turns by half a circle, and rounding decides which way; insert a configuration between its ends</source>
        <translation>le segment tourne d&apos;un demi-tour, et c&apos;est l&apos;arrondi qui décide du sens&#xa0;; insérez une configuration entre ses extrémités</translation>
    </message>
    <message>
        <source>the rounding of coordinates of this size is not small against the required clearance; move the scene to the origin, or require more clearance</source>
        <translation>l&apos;arrondi de coordonnées de cette grandeur n&apos;est pas petit devant le jeu exigé&#xa0;; rapprochez la scène de l&apos;origine, ou exigez plus de jeu</translation>
    </message>
    <message>
        <source>the clearance is so close to the required one that %1 comparisons of triangles do not certify it; require less clearance, or divide the edge</source>
        <translation>le jeu est si proche du jeu exigé que %1 comparaisons de triangles ne le certifient pas&#xa0;; exigez moins de jeu, ou divisez le segment</translation>
    </message>
    <message>
        <source>the check was stopped</source>
        <translation>la vérification a été arrêtée</translation>
    </message>
    <message>
        <source>it states &quot;after&quot;: %1, and %2 {2|step comes|steps come} before it</source>
        <translation>elle indique «&#xa0;after&#xa0;»&#xa0;: %1, et %2 {2|étape la précède|étapes la précèdent}</translation>
    </message>
    <message>
        <source>it is of a flexible body, and says that it is certified</source>
        <translation>elle est celle d&apos;un corps souple, et dit qu&apos;elle est certifiée</translation>
    </message>
    <message>
        <source>it says that it is not certified, and its body is not flexible</source>
        <translation>elle dit qu&apos;elle n&apos;est pas certifiée, et son corps n&apos;est pas souple</translation>
    </message>
    <message>
        <source>it moves &apos;%1&apos;, which is not a body of the product</source>
        <translation>elle déplace «&#xa0;%1&#xa0;», qui n&apos;est pas un corps du produit</translation>
    </message>
    <message>
        <source>it moves &apos;%1&apos;, which is fixed as base</source>
        <translation>elle déplace «&#xa0;%1&#xa0;», qui est fixé comme base</translation>
    </message>
    <message>
        <source>it moves &apos;%1&apos;, which was removed before</source>
        <translation>elle déplace «&#xa0;%1&#xa0;», qui est déjà démonté</translation>
    </message>
    <message>
        <source>it moves &apos;%1&apos;, which is not in the group</source>
        <translation>elle déplace «&#xa0;%1&#xa0;», qui n&apos;est pas dans le groupe</translation>
    </message>
    <message>
        <source>it moves no body</source>
        <translation>elle ne déplace aucun corps</translation>
    </message>
    <message>
        <source>fits are off: every pair has to keep its clearance</source>
        <translation>les ajustements sont désactivés&#xa0;: chaque paire doit garder son jeu</translation>
    </message>
    <message>
        <source>they are apart</source>
        <translation>ils sont à distance l&apos;un de l&apos;autre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos;: the file&apos;s pitch is not the one that the user gives for the thread</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»&#xa0;: le pas du fichier n&apos;est pas celui que l&apos;utilisateur donne pour le filetage</translation>
    </message>
    <message>
        <source>the scenario forbids places, and where they are is not known</source>
        <translation>le scénario interdit des lieux, et on ne sait pas où ils sont</translation>
    </message>
    <message>
        <source>the file states an allowance of &apos;%1&apos; against &apos;%2&apos;, which are not the object and another body</source>
        <translation>le fichier indique un amincissement de «&#xa0;%1&#xa0;» face à «&#xa0;%2&#xa0;», qui ne sont pas l&apos;objet et un autre corps</translation>
    </message>
    <message>
        <source>configuration %1 is outside the scenario&apos;s workspace; the path was not examined further</source>
        <translation>la configuration %1 est hors de l&apos;espace de travail du scénario&#xa0;; la suite du chemin n&apos;a pas été examinée</translation>
    </message>
    <message>
        <source>%1 {1|pair overlaps|pairs overlap} without being a fit, a thread or a press</source>
        <translation>%1 {1|paire se recouvre|paires se recouvrent} sans être ni un ajustement, ni un filetage, ni un serrage</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; by %3</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» de %3</translation>
    </message>
    <message>
        <source>the plan lists &apos;%1&apos; twice</source>
        <translation>le plan énumère deux fois «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the plan lists &apos;%1&apos;, which is not a body of the product</source>
        <translation>le plan énumère «&#xa0;%1&#xa0;», qui n&apos;est pas un corps du produit</translation>
    </message>
    <message>
        <source>the product has &apos;%1&apos;, which the plan does not list</source>
        <translation>le produit contient «&#xa0;%1&#xa0;», que le plan n&apos;énumère pas</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is fixed as base and is none of the plan&apos;s bodies</source>
        <translation>«&#xa0;%1&#xa0;» est fixé comme base, mais ce n&apos;est pas un corps du plan</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is fixed as base twice</source>
        <translation>«&#xa0;%1&#xa0;» est fixé deux fois comme base</translation>
    </message>
    <message>
        <source>the plan states &quot;%1&quot;: %2, and there are %3</source>
        <translation>le plan indique «&#xa0;%1&#xa0;»&#xa0;: %2, et il y en a %3</translation>
    </message>
    <message>
        <source>a constraint is about &apos;%1&apos;, which is no body or assembly: it is not checked</source>
        <translation>une contrainte porte sur «&#xa0;%1&#xa0;», qui n&apos;est ni un corps ni un assemblage&#xa0;: elle n&apos;est pas vérifiée</translation>
    </message>
    <message>
        <source>the plan states that it is not certified</source>
        <translation>le plan indique qu&apos;il n&apos;est pas certifié</translation>
    </message>
    <message>
        <source>the plan states that it is certified, and a step says that it is not</source>
        <translation>le plan indique qu&apos;il est certifié, et une étape dit qu&apos;elle ne l&apos;est pas</translation>
    </message>
    <message>
        <source>the plan is called complete, and all of its bodies are fixed as base: nothing is disassembled</source>
        <translation>le plan est dit complet, et tous ses corps sont fixés comme base&#xa0;: rien n&apos;est démonté</translation>
    </message>
    <message>
        <source>the plan is called complete, and %1 of %2 {2|part|parts} {1|has|have} no step</source>
        <translation>le plan est dit complet, et %1 {1|pièce|pièces} sur %2 {1|n&apos;a|n&apos;ont} pas d&apos;étape</translation>
    </message>
    <message>
        <source>&apos;%1&apos; moves in a direction that is ruled out for it before it is clear of what it touched</source>
        <translation>«&#xa0;%1&#xa0;» se déplace dans une direction qui lui est interdite avant d&apos;être dégagé de ce qu&apos;il touchait</translation>
    </message>
    <message>
        <source>a constraint states that &apos;%1&apos; is removed before, and the step does not state that this is given up</source>
        <translation>une contrainte énonce que «&#xa0;%1&#xa0;» est démonté avant, et l&apos;étape ne signale pas qu&apos;elle l&apos;abandonne</translation>
    </message>
    <message>
        <source>a constraint removes it together with others, which stay behind</source>
        <translation>une contrainte le démonte avec d&apos;autres corps, qui restent en arrière</translation>
    </message>
    <message>
        <source>a constraint states number %1, and it is number %2 of the removal</source>
        <translation>une contrainte énonce la position %1, et elle est en position %2 du démontage</translation>
    </message>
    <message>
        <source>a constraint states another motion for it</source>
        <translation>une contrainte énonce un autre mouvement pour lui</translation>
    </message>
    <message>
        <source>%1, … (%2)</source>
        <translation>%1, … (%2)</translation>
    </message>
    <message>
        <source>it states &quot;step&quot;: %1, and there are %2</source>
        <translation>elle indique «&#xa0;step&#xa0;»&#xa0;: %1, et il y en a %2</translation>
    </message>
    <message>
        <source>its bodies are not those of its step</source>
        <translation>ses corps ne sont pas ceux de son étape</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is fixed as base and is not in the group</source>
        <translation>«&#xa0;%1&#xa0;» est fixé comme base, mais ce corps n&apos;est pas dans le groupe</translation>
    </message>
    <message>
        <source>its step has another line</source>
        <translation>son étape a une autre ligne</translation>
    </message>
    <message>
        <source>%1 of a thread of %2</source>
        <translation>%1 d&apos;un filetage de %2</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>dépasse %1 octets</translation>
    </message>
    <message>
        <source>is one configuration too many</source>
        <translation>est une configuration de trop</translation>
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
        <source>Each line holds x y z qx qy qz qw; a CSV begins with its header.</source>
        <translation>Chaque ligne contient x y z qx qy qz qw&#xa0;; un CSV commence par son en-tête.</translation>
    </message>
    <message>
        <source>Each line holds %1.</source>
        <translation>Chaque ligne contient %1.</translation>
    </message>
    <message>
        <source>does not have %1 columns</source>
        <translation>n&apos;a pas %1 colonnes</translation>
    </message>
    <message>
        <source>holds &apos;%1&apos;, which is not a finite number</source>
        <translation>contient «&#xa0;%1&#xa0;», qui n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>holds &apos;%1&apos;, which is beyond 1e9 m</source>
        <translation>contient «&#xa0;%1&#xa0;», qui dépasse 1e9 m</translation>
    </message>
    <message>
        <source>has an orientation that is not a unit quaternion</source>
        <translation>a une orientation qui n&apos;est pas un quaternion unitaire</translation>
    </message>
    <message>
        <source>names an unknown author &apos;%1&apos;</source>
        <translation>nomme un auteur inconnu, «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is not &quot;glissade-path&quot;</source>
        <translation>n&apos;est pas «&#xa0;glissade-path&#xa0;»</translation>
    </message>
    <message>
        <source>is not 1</source>
        <translation>n&apos;est pas 1</translation>
    </message>
    <message>
        <source>Use a newer Glissade.</source>
        <translation>Utilisez une version plus récente de Glissade.</translation>
    </message>
    <message>
        <source>Plan again. To check an edited path, remove its checksum.</source>
        <translation>Planifiez de nouveau. Pour vérifier un chemin modifié, supprimez sa somme de contrôle.</translation>
    </message>
    <message>
        <source>is in a format that can only be written</source>
        <translation>est dans un format qui ne peut qu&apos;être écrit</translation>
    </message>
    <message>
        <source>Give the path as CSV, JSON or OMPL&apos;s columns.</source>
        <translation>Donnez le chemin en CSV, en JSON ou dans les colonnes d&apos;OMPL.</translation>
    </message>
    <message>
        <source>is not &quot;glissade-plan&quot;</source>
        <translation>n&apos;est pas «&#xa0;glissade-plan&#xa0;»</translation>
    </message>
    <message>
        <source>is not complete, stuck, time_limit or interrupted</source>
        <translation>n&apos;est pas complete, stuck, time_limit ou interrupted</translation>
    </message>
    <message>
        <source>is neither 0 nor a size from 1e-12 to 1e9 m</source>
        <translation>n&apos;est ni 0 ni une taille de 1e-12 à 1e9 m</translation>
    </message>
    <message>
        <source>Plan again. To use an edited plan, remove its checksum.</source>
        <translation>Planifiez de nouveau. Pour utiliser un plan modifié, supprimez sa somme de contrôle.</translation>
    </message>
    <message>
        <source>Start again.</source>
        <translation>Relancez le calcul.</translation>
    </message>
    <message>
        <source>body &apos;%1&apos;</source>
        <translation>corps «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is not a closed surface</source>
        <translation>n&apos;est pas une surface fermée</translation>
    </message>
    <message>
        <source>Being inside it is not seen as a collision; close its surface, or let planar holes be closed (--close-holes).</source>
        <translation>Une position à l&apos;intérieur n&apos;est pas reconnue comme une collision&#xa0;; fermez sa surface, ou faites fermer les trous plans (--close-holes).</translation>
    </message>
    <message>
        <source>names the body &apos;%1&apos;, which is not there</source>
        <translation>nomme le corps «&#xa0;%1&#xa0;», qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>is a part file, and a scenario is needed</source>
        <translation>est un fichier de pièce, et il faut un scénario</translation>
    </message>
    <message>
        <source>Make a scenario of it: glissade-cli new OUT.json --moves FILE:PART --static FILE.</source>
        <translation>Faites-en un scénario&#xa0;: glissade-cli new OUT.json --moves FICHIER:PIÈCE --static FICHIER.</translation>
    </message>
    <message>
        <source>Check the scenario, then save it again or remove the checksum.</source>
        <translation>Vérifiez le scénario, puis enregistrez-le de nouveau ou supprimez la somme de contrôle.</translation>
    </message>
    <message>
        <source>is checked with the automatic mesh tolerance of its parts</source>
        <translation>est vérifié avec la tolérance de maillage automatique de ses pièces</translation>
    </message>
    <message>
        <source>The plan states a coarser one.</source>
        <translation>Le plan en indique une plus grossière.</translation>
    </message>
    <message>
        <source>is excluded</source>
        <translation>est exclu</translation>
    </message>
    <message>
        <source>Certificates are about the product without it.</source>
        <translation>Les certificats portent sur le produit sans lui.</translation>
    </message>
    <message>
        <source>holds one body: there is nothing to disassemble</source>
        <translation>contient un seul corps&#xa0;: il n&apos;y a rien à démonter</translation>
    </message>
    <message>
        <source>Give a product of several parts.</source>
        <translation>Donnez un produit de plusieurs pièces.</translation>
    </message>
    <message>
        <source>does not name exactly one shape</source>
        <translation>ne nomme pas exactement une forme</translation>
    </message>
    <message>
        <source>names the asset &apos;%1&apos;, which is not in /assets</source>
        <translation>nomme l&apos;asset «&#xa0;%1&#xa0;», qui n&apos;est pas dans /assets</translation>
    </message>
    <message>
        <source>has a size that is not above zero, or below 1e-12 m</source>
        <translation>a une taille nulle, négative ou inférieure à 1e-12 m</translation>
    </message>
    <message>
        <source>is the same body as &apos;a&apos;</source>
        <translation>est le même corps que «&#xa0;a&#xa0;»</translation>
    </message>
    <message>
        <source>is not a kind of fit</source>
        <translation>n&apos;est pas un type d&apos;ajustement</translation>
    </message>
    <message>
        <source>Give metres, 0 or more.</source>
        <translation>Donnez des mètres, 0 ou plus.</translation>
    </message>
    <message>
        <source>is not a pitch</source>
        <translation>n&apos;est pas un pas de filetage</translation>
    </message>
    <message>
        <source>Give metres a turn, from 0.00001 to 1; below zero for a left-handed thread.</source>
        <translation>Donnez des mètres par tour, de 0.00001 à 1&#xa0;; négatif pour un filetage à gauche.</translation>
    </message>
    <message>
        <source>is neither of the two bodies</source>
        <translation>n&apos;est aucun des deux corps</translation>
    </message>
    <message>
        <source>is neither &quot;on&quot; nor &quot;off&quot;</source>
        <translation>n&apos;est ni «&#xa0;on&#xa0;» ni «&#xa0;off&#xa0;»</translation>
    </message>
    <message>
        <source>is about a pair that was there before</source>
        <translation>concerne une paire déjà donnée</translation>
    </message>
    <message>
        <source>Remove one.</source>
        <translation>Supprimez-en un.</translation>
    </message>
    <message>
        <source>is not six numbers</source>
        <translation>n&apos;est pas formé de six nombres</translation>
    </message>
    <message>
        <source>has a minimum above its maximum</source>
        <translation>a un minimum supérieur à son maximum</translation>
    </message>
    <message>
        <source>is not &quot;glissade-scenario&quot;</source>
        <translation>n&apos;est pas «&#xa0;glissade-scenario&#xa0;»</translation>
    </message>
    <message>
        <source>holds a &apos;/&apos;</source>
        <translation>contient un «&#xa0;/&#xa0;»</translation>
    </message>
    <message>
        <source>has the id &apos;%1&apos; a second time</source>
        <translation>a une seconde fois l&apos;identifiant «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is neither a configuration nor &quot;out&quot;</source>
        <translation>n&apos;est ni une configuration ni «&#xa0;out&#xa0;»</translation>
    </message>
    <message>
        <source>is not a parameter</source>
        <translation>n&apos;est pas un paramètre</translation>
    </message>
    <message>
        <source>has no direction</source>
        <translation>n&apos;a pas de direction</translation>
    </message>
    <message>
        <source>is not computer, operator or contact</source>
        <translation>n&apos;est pas computer, operator ou contact</translation>
    </message>
    <message>
        <source>is not two names</source>
        <translation>n&apos;est pas fait de deux noms</translation>
    </message>
    <message>
        <source>it states &quot;%1&quot;: %2, and the independent check finds %3</source>
        <translation>elle indique «&#xa0;%1&#xa0;»&#xa0;: %2, et la vérification indépendante trouve&#xa0;: %3</translation>
    </message>
    <message>
        <source>it states &quot;%1&quot;: %2 of %3, and the independent check finds %4</source>
        <translation>elle indique «&#xa0;%1&#xa0;»&#xa0;: %2 pour %3, et la vérification indépendante trouve&#xa0;: %4</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>%1 {1|step|steps} before it</source>
        <translation>%1 {1|étape|étapes} avant elle</translation>
    </message>
    <message>
        <source>no such body</source>
        <translation>aucun corps de ce nom</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>at least the certified %1</source>
        <translation>au moins la valeur certifiée, %1</translation>
    </message>
    <message>
        <source>the joint of &apos;%1&apos;</source>
        <translation>la liaison de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a cylinder of %1</source>
        <translation>un cylindre de %1</translation>
    </message>
    <message>
        <source>bodies of %1</source>
        <translation>des corps de %1</translation>
    </message>
    <message>
        <source>no statement about a bend</source>
        <translation>aucune indication de flexion</translation>
    </message>
    <message>
        <source>a body of %1</source>
        <translation>un corps de %1</translation>
    </message>
    <message>
        <source>no two parallel faces so far apart</source>
        <translation>pas deux faces parallèles à cette distance</translation>
    </message>
    <message>
        <source>the allowance for &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>l&apos;amincissement pour «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>it states an allowance of &apos;%1&apos; against &apos;%2&apos;, which are not a body of the step and one of the product</source>
        <translation>elle indique un amincissement de «&#xa0;%1&#xa0;» face à «&#xa0;%2&#xa0;», qui ne sont pas un corps de l&apos;étape et un corps du produit</translation>
    </message>
    <message>
        <source>it says that it does not keep the rule &quot;%1&quot; about %2</source>
        <translation>elle dit ne pas respecter la règle «&#xa0;%1&#xa0;» pour %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos;: the thread is modelled with a pitch of %3, and the motion has %4</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»&#xa0;: le filetage est modélisé avec un pas de %3, et le mouvement a un pas de %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is pulled off &apos;%2&apos; without being unscrewed: %3</source>
        <translation>«&#xa0;%1&#xa0;» est tiré hors de «&#xa0;%2&#xa0;» sans être dévissé&#xa0;: %3</translation>
    </message>
    <message>
        <source>their meshes state no cylinders</source>
        <translation>leurs maillages n&apos;indiquent aucun cylindre</translation>
    </message>
    <message>
        <source>the plan says that %1</source>
        <translation>selon le plan, %1</translation>
    </message>
    <message>
        <source>they are removed together</source>
        <translation>ils sont démontés ensemble</translation>
    </message>
    <message>
        <source>the other one was removed before</source>
        <translation>l&apos;autre est déjà démonté</translation>
    </message>
    <message>
        <source>a thread is taken away of one body of a pair, and nothing else</source>
        <translation>un filetage est retiré d&apos;un seul corps de la paire, et rien d&apos;autre</translation>
    </message>
    <message>
        <source>the user states that the pair is no thread</source>
        <translation>l&apos;utilisateur indique que la paire n&apos;est pas un filetage</translation>
    </message>
    <message>
        <source>the hole is not as narrow as the file states</source>
        <translation>le trou n&apos;est pas aussi étroit que le fichier l&apos;indique</translation>
    </message>
    <message>
        <source>its thread is not so deep</source>
        <translation>son filetage n&apos;est pas si profond</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the one that is cut</source>
        <translation>c&apos;est «&#xa0;%1&#xa0;» qui est découpé</translation>
    </message>
    <message>
        <source>which of the two is cut is not clear, and the user does not name it</source>
        <translation>on ne sait pas lequel des deux est découpé, et l&apos;utilisateur ne le nomme pas</translation>
    </message>
    <message>
        <source>what would be left of it is not one piece as before</source>
        <translation>ce qui en resterait n&apos;est pas d&apos;un seul tenant comme avant</translation>
    </message>
    <message>
        <source>what overlaps is taken away of one body of a pair, and the other one has the allowance</source>
        <translation>ce qui se recouvre est retiré d&apos;un corps de la paire, et l&apos;autre a l&apos;amincissement</translation>
    </message>
    <message>
        <source>the user states that the pair is a thread</source>
        <translation>l&apos;utilisateur indique que la paire est un filetage</translation>
    </message>
    <message>
        <source>no overlap with the other one can be taken away of it</source>
        <translation>aucun recouvrement avec l&apos;autre ne peut en être retiré</translation>
    </message>
    <message>
        <source>the axis that the file states for the thread is not one that the meshes of both bodies show</source>
        <translation>l&apos;axe que le fichier indique pour le filetage n&apos;est pas de ceux que montrent les maillages des deux corps</translation>
    </message>
    <message>
        <source>Plan again.</source>
        <translation>Planifiez de nouveau.</translation>
    </message>
    <message>
        <source>the user calls the pair a thread, but no shaft of the one is on the axis of a hole of the other</source>
        <translation>l&apos;utilisateur dit que la paire est un filetage, mais aucun arbre de l&apos;un n&apos;est sur l&apos;axe d&apos;un trou de l&apos;autre</translation>
    </message>
    <message>
        <source>Give the pair another kind.</source>
        <translation>Donnez un autre type à la paire.</translation>
    </message>
    <message>
        <source>a pitch of %1 mm is none of a thread of %2 mm: it has to be from 0.01 mm to two diameters</source>
        <translation>un pas de %1 mm n&apos;est pas celui d&apos;un filetage de %2 mm&#xa0;: il doit être compris entre 0,01 mm et deux diamètres</translation>
    </message>
    <message>
        <source>the hole is not around the axis that the file states for the thread</source>
        <translation>le trou n&apos;est pas autour de l&apos;axe que le fichier indique pour le filetage</translation>
    </message>
    <message>
        <source>the shaft has no groove that is as narrow as the hole</source>
        <translation>l&apos;arbre n&apos;a pas de gorge aussi étroite que le trou</translation>
    </message>
    <message>
        <source>the crests are not around the axis that the file states</source>
        <translation>les sommets de filet ne sont pas autour de l&apos;axe que le fichier indique</translation>
    </message>
    <message>
        <source>the shaft has no helix of the pitch that the file states</source>
        <translation>l&apos;arbre n&apos;a pas d&apos;hélice au pas que le fichier indique</translation>
    </message>
    <message>
        <source>what of the shaft is wider than the hole is no thread of this pitch</source>
        <translation>ce qui, de l&apos;arbre, est plus large que le trou n&apos;est pas un filetage de ce pas</translation>
    </message>
    <message>
        <source>certified: %1 (required %2 mm)</source>
        <translation>certifié&#xa0;: %1 (exigé&#xa0;: %2 mm)</translation>
    </message>
    <message>
        <source>certified: %1 (required %2 mm, %3 of %4 {4|edge|edges} {3|slides|slide})</source>
        <translation>certifié&#xa0;: %1 (exigé&#xa0;: %2 mm, %3 {3|segment|segments} sur %4 {3|glisse|glissent})</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; are a thread, which can only be unscrewed</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» forment un filetage, qui ne peut qu&apos;être dévissé</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is unscrewed, and has to be removed first</source>
        <translation>%1&#xa0;: c&apos;est «&#xa0;%2&#xa0;» que l&apos;on dévisse et qui doit être démonté d&apos;abord</translation>
    </message>
    <message>
        <source>%1: each turn about its axis advances by %2</source>
        <translation>%1&#xa0;: chaque tour autour de son axe fait avancer de %2</translation>
    </message>
    <message>
        <source>clearance %1 to %2 mm to &apos;%3&apos;</source>
        <translation>jeu de %1 à %2 mm par rapport à «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>%1, slides</source>
        <translation>%1, en glissement</translation>
    </message>
    <message>
        <source>valid: %1</source>
        <translation>valide&#xa0;: %1</translation>
    </message>
    <message>
        <source>valid without shapes that the files state: %1</source>
        <translation>valide sans certaines formes que les fichiers énoncent&#xa0;: %1</translation>
    </message>
    <message>
        <source>invalid: %1</source>
        <translation>non valide&#xa0;: %1</translation>
    </message>
    <message>
        <source>undecided: %1</source>
        <translation>indécis&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 {1|configuration|configurations}, %2</source>
        <translation>%1 {1|configuration|configurations}, %2</translation>
    </message>
    <message>
        <source>edge %1 meets the forbidden place &apos;%2&apos;, or its margin of %3</source>
        <translation>le segment %1 rencontre le lieu interdit «&#xa0;%2&#xa0;», ou sa marge de %3</translation>
    </message>
    <message>
        <source>forbidden places: the path keeps %1 from %2</source>
        <translation>lieux interdits&#xa0;: le chemin reste à %1 au moins de %2</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>refusé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the path does not begin at the scenario&apos;s start</source>
        <translation>le chemin ne commence pas au départ du scénario</translation>
    </message>
    <message>
        <source>the path does not end at the scenario&apos;s goal</source>
        <translation>le chemin ne finit pas au but du scénario</translation>
    </message>
    <message>
        <source>its motion is undecided on edge %1</source>
        <translation>son mouvement est indécis sur le segment %1</translation>
    </message>
    <message>
        <source>its motion is undecided on edge %1 by &apos;%2&apos;</source>
        <translation>son mouvement est indécis sur le segment %1 à cause de «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>it does not end outside of the others&apos; bounding box</source>
        <translation>elle ne finit pas hors de la boîte englobante des autres corps</translation>
    </message>
    <message>
        <source>step %1: allowance: %2</source>
        <translation>étape %1&#xa0;: amincissement&#xa0;: %2</translation>
    </message>
    <message>
        <source>step %1: note: %2</source>
        <translation>étape %1&#xa0;: remarque&#xa0;: %2</translation>
    </message>
    <message>
        <source>step %1 (%2): as the plan says: %3</source>
        <translation>étape %1 (%2)&#xa0;: comme le plan le dit&#xa0;: %3</translation>
    </message>
    <message>
        <source>step %1 (%2): only if %3</source>
        <translation>étape %1 (%2)&#xa0;: seulement si %3</translation>
    </message>
    <message>
        <source>step %1 (%2): its motion has no certificate, it is flexible</source>
        <translation>étape %1 (%2)&#xa0;: son mouvement n&apos;a pas de certificat, le corps est souple</translation>
    </message>
    <message>
        <source>step %1 (%2) is invalid: %3;</source>
        <translation>l&apos;étape %1 (%2) est non valide&#xa0;: %3&#xa0;;</translation>
    </message>
    <message>
        <source>step %1 (%2) is undecided: %3;</source>
        <translation>l&apos;étape %1 (%2) est indécise&#xa0;: %3&#xa0;;</translation>
    </message>
    <message>
        <source>%1 of %2 {2|part|parts} {1|has|have} no step, %3 {3|is|are} removed alone, %4 as units, %5 in groups that are not disassembled</source>
        <translation>%1 {1|pièce|pièces} sur %2 {1|n&apos;a|n&apos;ont} pas d&apos;étape, %3 {3|est démontée seule|sont démontées seules}, %4 en unités, %5 dans des groupes qui ne sont pas démontés</translation>
    </message>
    <message>
        <source>%1 of %2 {2|step|steps} {1|is|are} certified, %3</source>
        <translation>%1 {1|étape|étapes} sur %2 {1|est certifiée|sont certifiées}, %3</translation>
    </message>
    <message>
        <source>%1 of %2 {2|step|steps} {1|is|are} as stated, %3</source>
        <translation>%1 {1|étape|étapes} sur %2 {1|est conforme|sont conformes} à ce qui est indiqué, %3</translation>
    </message>
    <message>
        <source>incomplete: %1</source>
        <translation>incomplet&#xa0;: %1</translation>
    </message>
    <message>
        <source>valid only if %1: %2</source>
        <translation>valide seulement si %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>valid only under %1 {1|condition|conditions} that the plan states itself: %2</source>
        <translation>valide seulement sous %1 {1|condition|conditions} que le plan pose lui-même&#xa0;: %2</translation>
    </message>
    <message>
        <source>condition: %1</source>
        <translation>condition&#xa0;: %1</translation>
    </message>
    <message>
        <source>Only the plan states this. State the conditions in the scenario, or trust the plan (--trust-plan).</source>
        <translation>Seul le plan l&apos;indique. Énoncez les conditions dans le scénario, ou faites confiance au plan (--trust-plan).</translation>
    </message>
    <message>
        <source>refused: the line of step %1: %2</source>
        <translation>refusé&#xa0;: la ligne de l&apos;étape %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 {1|step of a flexible body has|steps of flexible bodies have} no certificate</source>
        <translation>%1 {1|étape d&apos;un corps souple n&apos;a|étapes de corps souples n&apos;ont} pas de certificat</translation>
    </message>
    <message>
        <source>CAD accuracy of the certificates: +/- %1</source>
        <translation>précision CAO des certificats&#xa0;: +/- %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>the user allows %1</source>
        <translation>l&apos;utilisateur admet %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>overlap %1, mesh tolerance %2, spacing %3, gap %4, user-defined for the pair %5</source>
        <translation>recouvrement %1, tolérance de maillage %2, espacement %3, écart %4, défini par l&apos;utilisateur pour la paire %5</translation>
    </message>
    <message>
        <source>overlap %1, mesh tolerance %2, spacing %3, gap %4</source>
        <translation>recouvrement %1, tolérance de maillage %2, espacement %3, écart %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; without what overlaps &apos;%2&apos;, up to %3 deep: a clash that the user accepts</source>
        <translation>«&#xa0;%1&#xa0;» sans ce qui recouvre «&#xa0;%2&#xa0;», jusqu&apos;à %3 de profondeur&#xa0;: une interférence que l&apos;utilisateur accepte</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, %2 on &apos;%3&apos; (%4)</source>
        <translation>«&#xa0;%1&#xa0;», %2 face à «&#xa0;%3&#xa0;» (%4)</translation>
    </message>
    <message>
        <source>%1, at the hook, which the user lets bend by %2</source>
        <translation>%1, au crochet, que l&apos;utilisateur laisse fléchir de %2</translation>
    </message>
    <message>
        <source>%1, where its thread is taken away</source>
        <translation>%1, là où son filetage est retiré</translation>
    </message>
    <message>
        <source>%1, a thread with a pitch of %2</source>
        <translation>%1, un filetage au pas de %2</translation>
    </message>
    <message>
        <source>the file states &apos;%1&apos; without what overlaps &apos;%2&apos;, up to %3 deep</source>
        <translation>le fichier indique «&#xa0;%1&#xa0;» sans ce qui recouvre «&#xa0;%2&#xa0;», jusqu&apos;à %3 de profondeur</translation>
    </message>
    <message>
        <source>the file states an allowance of %2 of &apos;%1&apos; on &apos;%3&apos;</source>
        <translation>le fichier indique un amincissement de %2 de «&#xa0;%1&#xa0;» face à «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>%1: %2. Mend the parts, or accept the clash.</source>
        <translation>%1&#xa0;: %2. Corrigez les pièces, ou acceptez l&apos;interférence.</translation>
    </message>
    <message>
        <source>%1, and the independent check finds reason for nothing</source>
        <translation>%1, et la vérification indépendante n&apos;en justifie rien</translation>
    </message>
    <message>
        <source>%1, and the independent check finds reason for %2 only (%3)</source>
        <translation>%1, et la vérification indépendante n&apos;en justifie que %2 (%3)</translation>
    </message>
    <message>
        <source>%1. Plan again, or allow it for this pair.</source>
        <translation>%1. Planifiez de nouveau, ou admettez-le pour cette paire.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither true nor false</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est ni vrai ni faux</translation>
    </message>
    <message>
        <source>Give true or false.</source>
        <translation>Donnez true ou false.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a whole number</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre entier</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, which is out of range</source>
        <translation>«&#xa0;%1&#xa0;» vaut %2, ce qui est hors limites</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a text</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un texte</translation>
    </message>
    <message>
        <source>Give a text.</source>
        <translation>Donnez un texte.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of its choices</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas l&apos;un de ses choix</translation>
    </message>
    <message>
        <source>Give one of %1.</source>
        <translation>Donnez l&apos;une de ces valeurs&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Mobility</source>
        <translation>Mobilité</translation>
    </message>
    <message>
        <source>Static bodies shape the places; mobile ones clutter them.</source>
        <translation>Les corps statiques délimitent les lieux&#xa0;; les corps mobiles les encombrent.</translation>
    </message>
    <message>
        <source>Needs tool</source>
        <translation>Outil nécessaire</translation>
    </message>
    <message>
        <source>Which tool turns the body: by_shape, none, or one of the tools.</source>
        <translation>Outil qui fait tourner le corps&#xa0;: by_shape, none, ou l&apos;un des outils.</translation>
    </message>
    <message>
        <source>Complexity</source>
        <translation>Complexité</translation>
    </message>
    <message>
        <source>How hard the place is to cross: 1 for the widest, one more each time the width halves.</source>
        <translation>Difficulté de traversée du lieu&#xa0;: 1 pour les plus larges, un de plus à chaque division de la largeur par deux.</translation>
    </message>
    <message>
        <source>Cluttered</source>
        <translation>Encombré</translation>
    </message>
    <message>
        <source>Mobile bodies are in the place.</source>
        <translation>Des corps mobiles sont dans le lieu.</translation>
    </message>
    <message>
        <source>Narrowness</source>
        <translation>Étroitesse</translation>
    </message>
    <message>
        <source>Diameter of the largest ball that fits at the widest spot.</source>
        <translation>Diamètre de la plus grande boule qui tient à l&apos;endroit le plus large du lieu.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Shape of the place&apos;s section, as the objects&apos; shapes are called.</source>
        <translation>Forme de la section du lieu, avec les mêmes noms que les formes des objets.</translation>
    </message>
    <message>
        <source>Compatibility</source>
        <translation>Compatibilité</translation>
    </message>
    <message>
        <source>Whether the object goes through: 0 not at all, from 0.5 on it fits, 1 with ease.</source>
        <translation>Aptitude de l&apos;objet à passer&#xa0;: 0, il ne passe pas&#xa0;; à partir de 0,5, il passe&#xa0;; 1, il passe aisément.</translation>
    </message>
    <message>
        <source>Forbidden</source>
        <translation>Interdit</translation>
    </message>
    <message>
        <source>No path may lead through the place.</source>
        <translation>Aucun chemin ne peut passer par le lieu.</translation>
    </message>
    <message>
        <source>Preference</source>
        <translation>Préférence</translation>
    </message>
    <message>
        <source>Paths through the place count this many times shorter.</source>
        <translation>Les chemins par le lieu comptent pour autant de fois plus courts.</translation>
    </message>
    <message>
        <source>What the body is shaped like.</source>
        <translation>Forme du corps.</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Class of the body, whose attributes it has: screw, seal, base_part.</source>
        <translation>Classe du corps, dont il reprend les attributs&#xa0;: screw, seal, base_part.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Mass of the body. 0: by its volume and density.</source>
        <translation>Masse du corps. 0&#xa0;: d&apos;après son volume et sa masse volumique.</translation>
    </message>
    <message>
        <source>Fragile</source>
        <translation>Fragile</translation>
    </message>
    <message>
        <source>The body is removed as early as possible, and is assembled as late as possible.</source>
        <translation>Le corps est démonté aussi tôt que possible, et il est monté aussi tard que possible.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>The assembly begins with the body: it is not removed.</source>
        <translation>L&apos;assemblage commence par ce corps&#xa0;: il n&apos;est pas démonté.</translation>
    </message>
    <message>
        <source>Fixed as base</source>
        <translation>Fixé comme base</translation>
    </message>
    <message>
        <source>The body is not removed.</source>
        <translation>Le corps n&apos;est pas démonté.</translation>
    </message>
    <message>
        <source>Removed with</source>
        <translation>Démonté avec</translation>
    </message>
    <message>
        <source>Bodies that are removed together with this one, with commas.</source>
        <translation>Corps démontés avec celui-ci, séparés par des virgules.</translation>
    </message>
    <message>
        <source>Removed before</source>
        <translation>Démonté avant</translation>
    </message>
    <message>
        <source>Bodies that are removed after this one, with commas.</source>
        <translation>Corps démontés après celui-ci, séparés par des virgules.</translation>
    </message>
    <message>
        <source>the attribute name &apos;%1&apos; is not a word</source>
        <translation>le nom d&apos;attribut «&#xa0;%1&#xa0;» n&apos;est pas un mot</translation>
    </message>
    <message>
        <source>Use lower-case letters, digits and &apos;_&apos;, a letter first.</source>
        <translation>Utilisez des minuscules, des chiffres et «&#xa0;_&#xa0;», en commençant par une lettre.</translation>
    </message>
    <message>
        <source>there is an attribute &apos;%1&apos; already</source>
        <translation>il y a déjà un attribut «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the attribute &apos;%1&apos; has no choices</source>
        <translation>l&apos;attribut «&#xa0;%1&#xa0;» n&apos;a pas de choix</translation>
    </message>
    <message>
        <source>Give at least one.</source>
        <translation>Donnez-en au moins un.</translation>
    </message>
    <message>
        <source>the attribute &apos;%1&apos; has a choice without a name</source>
        <translation>l&apos;attribut «&#xa0;%1&#xa0;» a un choix sans nom</translation>
    </message>
    <message>
        <source>Remove it.</source>
        <translation>Supprimez-le.</translation>
    </message>
    <message>
        <source>the attribute &apos;%1&apos; has the choice &apos;%2&apos; twice</source>
        <translation>l&apos;attribut «&#xa0;%1&#xa0;» a deux fois le choix «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>the attribute &apos;%1&apos; has a minimum above its maximum</source>
        <translation>l&apos;attribut «&#xa0;%1&#xa0;» a un minimum supérieur à son maximum</translation>
    </message>
    <message>
        <source>Swap them.</source>
        <translation>Échangez-les.</translation>
    </message>
    <message>
        <source>the parents of the class &apos;%1&apos; form a cycle</source>
        <translation>les classes mères de la classe «&#xa0;%1&#xa0;» forment un cycle</translation>
    </message>
    <message>
        <source>Correct &apos;of&apos;.</source>
        <translation>Corrigez «&#xa0;of&#xa0;».</translation>
    </message>
    <message>
        <source>the class &apos;%1&apos; is of &apos;%2&apos;, which is not a class</source>
        <translation>la classe «&#xa0;%1&#xa0;» est de «&#xa0;%2&#xa0;», qui n&apos;est pas une classe</translation>
    </message>
    <message>
        <source>edits the same place as /places/%1</source>
        <translation>modifie le même lieu que /places/%1</translation>
    </message>
    <message>
        <source>Merge the two edits: where they differ, the later one applies.</source>
        <translation>Réunissez les deux modifications&#xa0;: là où elles diffèrent, la seconde s&apos;applique.</translation>
    </message>
    <message>
        <source>has the name &apos;%1&apos;, which another place has already</source>
        <translation>porte le nom «&#xa0;%1&#xa0;», qu&apos;un autre lieu porte déjà</translation>
    </message>
    <message>
        <source>lies in no place and near none, so the edit has no effect</source>
        <translation>n&apos;est dans aucun lieu ni près d&apos;aucun&#xa0;: la modification n&apos;a pas d&apos;effet</translation>
    </message>
    <message>
        <source>Move its &quot;at&quot; into the place that it is about.</source>
        <translation>Déplacez son «&#xa0;at&#xa0;» dans le lieu concerné.</translation>
    </message>
    <message>
        <source>lies in no place; the edit applies to the nearest place, %1</source>
        <translation>n&apos;est dans aucun lieu&#xa0;; la modification s&apos;applique au lieu le plus proche, %1</translation>
    </message>
    <message>
        <source>Edit that place once more, or move its &quot;at&quot; into the place that it is about.</source>
        <translation>Modifiez de nouveau ce lieu, ou déplacez son «&#xa0;at&#xa0;» dans le lieu concerné.</translation>
    </message>
    <message>
        <source>lies in no border of two places and near none, so the edit has no effect</source>
        <translation>n&apos;est sur aucune frontière de deux lieux ni près d&apos;aucune&#xa0;: la modification n&apos;a pas d&apos;effet</translation>
    </message>
    <message>
        <source>Move its &quot;at&quot; to where the two places meet.</source>
        <translation>Déplacez son «&#xa0;at&#xa0;» là où les deux lieux se touchent.</translation>
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
        <source>is too small for this workspace</source>
        <translation>est trop petit pour cet espace de travail</translation>
    </message>
    <message>
        <source>Give 0, or at least %1.</source>
        <translation>Donnez 0, ou au moins %1.</translation>
    </message>
    <message>
        <source>is out of range</source>
        <translation>est hors limites</translation>
    </message>
    <message>
        <source>Give 1 to 4096 MiB.</source>
        <translation>Donnez 1 à 4096 Mio.</translation>
    </message>
    <message>
        <source>Give 2 to 8.</source>
        <translation>Donnez 2 à 8.</translation>
    </message>
    <message>
        <source>names no way to find places: &apos;%1&apos;</source>
        <translation>ne nomme aucune méthode de recherche des lieux&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the environment model was not finished</source>
        <translation>le modèle de l&apos;environnement n&apos;a pas été terminé</translation>
    </message>
    <message>
        <source>forbids a place that is not there: its point lies in no place and near none</source>
        <translation>interdit un lieu qui n&apos;existe pas&#xa0;: son point n&apos;est dans aucun lieu ni près d&apos;aucun</translation>
    </message>
    <message>
        <source>Forbid the place where it is now, or remove this edit.</source>
        <translation>Interdisez le lieu là où il est maintenant, ou supprimez cette modification.</translation>
    </message>
    <message>
        <source>Region growing</source>
        <translation>Croissance de régions</translation>
    </message>
    <message>
        <source>Grows places from the coarsest free cells down (Cailhol et al. 2019, section 5.1.2).</source>
        <translation>Fait croître les lieux à partir des cellules libres les plus grosses (Cailhol et al. 2019, section 5.1.2).</translation>
    </message>
    <message>
        <source>Watershed</source>
        <translation>Partage des eaux</translation>
    </message>
    <message>
        <source>Floods the distance transform from its widest spots (Meyer 1994).</source>
        <translation>Inonde la transformée de distance à partir de ses points les plus larges (Meyer 1994).</translation>
    </message>
    <message>
        <source>is not a defined attribute</source>
        <translation>n&apos;est pas un attribut défini</translation>
    </message>
    <message>
        <source>Define it under /attributes, or remove it.</source>
        <translation>Définissez-le sous /attributes, ou supprimez-le.</translation>
    </message>
    <message>
        <source>is not a body of this scenario</source>
        <translation>n&apos;est pas un corps de ce scénario</translation>
    </message>
    <message>
        <source>Correct the id.</source>
        <translation>Corrigez l&apos;identifiant.</translation>
    </message>
    <message>
        <source>is not a list of three numbers</source>
        <translation>n&apos;est pas une liste de trois nombres</translation>
    </message>
    <message>
        <source>is not a quaternion x, y, z, w</source>
        <translation>n&apos;est pas un quaternion x, y, z, w</translation>
    </message>
    <message>
        <source>is not a unit quaternion (its length is %1)</source>
        <translation>n&apos;est pas un quaternion unitaire (sa norme est %1)</translation>
    </message>
    <message>
        <source>Divide its four numbers by that length.</source>
        <translation>Divisez ses quatre nombres par cette norme.</translation>
    </message>
    <message>
        <source>it is not sound BREP text</source>
        <translation>ce n&apos;est pas un texte BREP correct</translation>
    </message>
    <message>
        <source>holds no triangle</source>
        <translation>ne contient aucun triangle</translation>
    </message>
    <message>
        <source>needs more than the %1 MiB of memory that a file of its size may take on this machine</source>
        <translation>demande plus que les %1 Mio de mémoire admis sur cette machine pour un fichier de cette taille</translation>
    </message>
    <message>
        <source>%1 more {1|face was triangulated from its boundary|faces were triangulated from their boundaries}</source>
        <translation>%1 {1|autre face a été triangulée à partir de son contour|autres faces ont été triangulées à partir de leurs contours}</translation>
    </message>
    <message>
        <source>it needs more than %1 triangles</source>
        <translation>il demande plus de %1 triangles</translation>
    </message>
    <message>
        <source>it has more than %1 faces</source>
        <translation>il a plus de %1 faces</translation>
    </message>
    <message>
        <source>cannot be read as %1: %2</source>
        <translation>ne peut pas être lu comme %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>names</source>
        <translation>noms</translation>
    </message>
    <message>
        <source>are read as %1: &apos;%2&apos;</source>
        <translation>sont lus comme %1&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>are in an encoding that cannot be told, and are read as %1: &apos;%2&apos;</source>
        <translation>sont dans un codage impossible à déterminer, et sont lus comme %1&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>it is empty or too large</source>
        <translation>il est vide ou trop grand</translation>
    </message>
    <message>
        <source>its shapes cannot be computed (%1)</source>
        <translation>ses formes ne peuvent pas être calculées (%1)</translation>
    </message>
    <message>
        <source>it needs more memory than an import may take</source>
        <translation>il demande plus de mémoire qu&apos;un import n&apos;en peut prendre</translation>
    </message>
    <message>
        <source>a limit cannot be set</source>
        <translation>une limite ne peut pas être fixée</translation>
    </message>
    <message>
        <source>the time cannot be limited</source>
        <translation>le temps ne peut pas être limité</translation>
    </message>
    <message>
        <source>the memory cannot be limited</source>
        <translation>la mémoire ne peut pas être limitée</translation>
    </message>
    <message>
        <source>the capabilities cannot be given up</source>
        <translation>les privilèges ne peuvent pas être abandonnés</translation>
    </message>
    <message>
        <source>new privileges cannot be given up</source>
        <translation>l&apos;obtention de nouveaux privilèges ne peut pas être interdite</translation>
    </message>
    <message>
        <source>is too large: it has %1, and at most %2 are read with the memory of this machine</source>
        <translation>est trop grand&#xa0;: il a %1, et au plus %2 sont lus avec la mémoire de cette machine</translation>
    </message>
    <message>
        <source>Export fewer triangles, split the file, or use a machine with more free memory.</source>
        <translation>Exportez moins de triangles, découpez le fichier, ou utilisez une machine avec plus de mémoire libre.</translation>
    </message>
    <message>
        <source>is a Git LFS pointer: the file itself was not fetched</source>
        <translation>est un pointeur Git LFS : le fichier lui-même n’a pas été récupéré</translation>
    </message>
    <message>
        <source>Fetch it (git lfs pull), and load again.</source>
        <translation>Récupérez-le (git lfs pull), puis rechargez.</translation>
    </message>
    <message>
        <source>has a triangle with a corner that does not exist</source>
        <translation>a un triangle dont un sommet n&apos;existe pas</translation>
    </message>
    <message>
        <source>holds no geometry</source>
        <translation>ne contient aucune géométrie</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>octet %1</translation>
    </message>
    <message>
        <source>ends before its last chunk</source>
        <translation>finit avant son dernier bloc</translation>
    </message>
    <message>
        <source>has the unknown component type %1</source>
        <translation>a le type de composante inconnu %1</translation>
    </message>
    <message>
        <source>goes beyond the end of its data</source>
        <translation>va au-delà de la fin de ses données</translation>
    </message>
    <message>
        <source>has no whole number &apos;%1&apos;</source>
        <translation>n&apos;a pas de nombre entier «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is not a glTF file: its JSON is malformed or cut off</source>
        <translation>n&apos;est pas un fichier glTF&#xa0;: son JSON est mal formé ou tronqué</translation>
    </message>
    <message>
        <source>is of version %1; only 2 is read</source>
        <translation>est de la version %1&#xa0;; seule la version 2 est lue</translation>
    </message>
    <message>
        <source>claims a length of %1 bytes but is only %2 bytes long</source>
        <translation>annonce %1 octets mais n&apos;en a que %2</translation>
    </message>
    <message>
        <source>has a &apos;uri&apos; that is not a text</source>
        <translation>a un «&#xa0;uri&#xa0;» qui n&apos;est pas un texte</translation>
    </message>
    <message>
        <source>keeps its data in a file of its own (%1)</source>
        <translation>garde ses données dans un fichier séparé (%1)</translation>
    </message>
    <message>
        <source>holds data that is not base64</source>
        <translation>contient des données qui ne sont pas en base64</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>n&apos;existe pas</translation>
    </message>
    <message>
        <source>names a buffer that does not exist</source>
        <translation>nomme un tampon qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>is not of the type %1</source>
        <translation>n&apos;est pas du type %1</translation>
    </message>
    <message>
        <source>has no data</source>
        <translation>n&apos;a pas de données</translation>
    </message>
    <message>
        <source>has no element</source>
        <translation>n&apos;a aucun élément</translation>
    </message>
    <message>
        <source>claims %1 elements, more than its data holds</source>
        <translation>annonce %1 éléments, plus que ses données n&apos;en contiennent</translation>
    </message>
    <message>
        <source>has no indices or no values</source>
        <translation>n&apos;a pas d&apos;indices ou pas de valeurs</translation>
    </message>
    <message>
        <source>claims more elements than the file has bytes</source>
        <translation>annonce plus d&apos;éléments que le fichier n&apos;a d&apos;octets</translation>
    </message>
    <message>
        <source>has an index that does not exist</source>
        <translation>a un indice qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>requires the extension %1, which is not read</source>
        <translation>exige l&apos;extension %1, qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>has a &apos;%1&apos; that is not %2 numbers</source>
        <translation>a un «&#xa0;%1&#xa0;» qui n&apos;est pas fait de %2 nombres</translation>
    </message>
    <message>
        <source>has a rotation of length zero</source>
        <translation>a une rotation de norme nulle</translation>
    </message>
    <message>
        <source>has %1 corners, which are not whole triangles</source>
        <translation>a %1 sommets, qui ne font pas des triangles entiers</translation>
    </message>
    <message>
        <source>names a node that is not a number</source>
        <translation>nomme un nœud qui n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>names node %1, which is in the scene already</source>
        <translation>nomme le nœud %1, qui est déjà dans la scène</translation>
    </message>
    <message>
        <source>has instances by the extension &apos;EXT_mesh_gpu_instancing&apos;, which is not read</source>
        <translation>a des instances par l&apos;extension «&#xa0;EXT_mesh_gpu_instancing&#xa0;», qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>%1: has a skin, which is not applied</source>
        <translation>%1&#xa0;: a une peau («&#xa0;skin&#xa0;»), qui n&apos;est pas appliquée</translation>
    </message>
    <message>
        <source>has no primitives</source>
        <translation>n&apos;a pas de primitives</translation>
    </message>
    <message>
        <source>has the unknown mode %1</source>
        <translation>a le mode inconnu %1</translation>
    </message>
    <message>
        <source>%1: has morph targets, which are not applied</source>
        <translation>%1&#xa0;: a des cibles de morphage, qui ne sont pas appliquées</translation>
    </message>
    <message>
        <source>has a position that is not a finite number</source>
        <translation>a une position qui n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>has vertex %1 in its indices, but %2 vertices</source>
        <translation>a le sommet %1 dans ses indices, mais %2 sommets</translation>
    </message>
    <message>
        <source>has JSON values of the wrong types</source>
        <translation>a des valeurs JSON de mauvais type</translation>
    </message>
    <message>
        <source>line %1: the last line has no end; the file may be cut off</source>
        <translation>ligne %1&#xa0;: la dernière ligne n&apos;a pas de fin&#xa0;; le fichier est peut-être tronqué</translation>
    </message>
    <message>
        <source>has a free-form curve or surface (%1), which is not read</source>
        <translation>a une courbe ou une surface de forme libre (%1), qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>begins with %1, which is not a statement of an OBJ file</source>
        <translation>commence par %1, qui n&apos;est pas une instruction d&apos;un fichier OBJ</translation>
    </message>
    <message>
        <source>the coordinate</source>
        <translation>la coordonnée</translation>
    </message>
    <message>
        <source>the weight</source>
        <translation>le poids</translation>
    </message>
    <message>
        <source>has a vertex with a weight other than 1</source>
        <translation>a un sommet dont le poids n&apos;est pas 1</translation>
    </message>
    <message>
        <source>has a face of 1 corner</source>
        <translation>a une face de 1 sommet</translation>
    </message>
    <message>
        <source>has a face of %1 corners</source>
        <translation>a une face de %1 sommets</translation>
    </message>
    <message>
        <source>has a face whose outline crosses itself</source>
        <translation>a une face dont le contour se recoupe</translation>
    </message>
    <message>
        <source>has the corner %1, which is not of the form a/b/c</source>
        <translation>a le coin %1, qui n&apos;est pas de la forme a/b/c</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>sommet</translation>
    </message>
    <message>
        <source>texture coordinate</source>
        <translation>coordonnée de texture</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>has %1 where the number of a %2 is expected</source>
        <translation>a %1 là où un numéro est attendu (%2)</translation>
    </message>
    <message>
        <source>has a face with %1 %2, but the file has %3</source>
        <translation>a une face avec %1 %2, mais le fichier en a %3</translation>
    </message>
    <message>
        <source>has %1 where a type of numbers is expected</source>
        <translation>a %1 là où un type de nombres est attendu</translation>
    </message>
    <message>
        <source>has the unknown format %1</source>
        <translation>a le format inconnu %1</translation>
    </message>
    <message>
        <source>has %1 where a number of elements is expected</source>
        <translation>a %1 là où un nombre d&apos;éléments est attendu</translation>
    </message>
    <message>
        <source>has a property without a name</source>
        <translation>a une propriété sans nom</translation>
    </message>
    <message>
        <source>claims %1 of %2 but is only %3 bytes long</source>
        <translation>annonce %1 de %2 mais n&apos;a que %3 octets</translation>
    </message>
    <message>
        <source>does not begin with &apos;ply&apos;</source>
        <translation>ne commence pas par «&#xa0;ply&#xa0;»</translation>
    </message>
    <message>
        <source>has a property before any element</source>
        <translation>a une propriété avant tout élément</translation>
    </message>
    <message>
        <source>does not say its format before &apos;end_header&apos;</source>
        <translation>n&apos;indique pas son format avant «&#xa0;end_header&#xa0;»</translation>
    </message>
    <message>
        <source>ends after its header</source>
        <translation>finit après son en-tête</translation>
    </message>
    <message>
        <source>has %1 in its header</source>
        <translation>a %1 dans son en-tête</translation>
    </message>
    <message>
        <source>ends before &apos;end_header&apos;</source>
        <translation>finit avant «&#xa0;end_header&#xa0;»</translation>
    </message>
    <message>
        <source>the number</source>
        <translation>le nombre</translation>
    </message>
    <message>
        <source>ends before its last element</source>
        <translation>finit avant son dernier élément</translation>
    </message>
    <message>
        <source>has a number that is not finite</source>
        <translation>a un nombre qui n&apos;est pas fini</translation>
    </message>
    <message>
        <source>holds triangle strips, which are not read</source>
        <translation>contient des bandes de triangles, qui ne sont pas lues</translation>
    </message>
    <message>
        <source>goes on after the elements that its header claims</source>
        <translation>continue après les éléments qu&apos;annonce son en-tête</translation>
    </message>
    <message>
        <source>has a list of an impossible length</source>
        <translation>a une liste d&apos;une longueur impossible</translation>
    </message>
    <message>
        <source>has vertices without x, y and z</source>
        <translation>a des sommets sans x, y et z</translation>
    </message>
    <message>
        <source>has faces before its vertices</source>
        <translation>a des faces avant ses sommets</translation>
    </message>
    <message>
        <source>has faces without a list &apos;vertex_indices&apos;</source>
        <translation>a des faces sans liste «&#xa0;vertex_indices&#xa0;»</translation>
    </message>
    <message>
        <source>has a face with vertex %1, but the file has %2</source>
        <translation>a une face avec le sommet %1, mais le fichier en a %2</translation>
    </message>
    <message>
        <source>has a facet with more than three corners</source>
        <translation>a une facette de plus de trois sommets</translation>
    </message>
    <message>
        <source>has a facet normal with fewer than three numbers</source>
        <translation>a une normale de facette de moins de trois nombres</translation>
    </message>
    <message>
        <source>ends before &apos;endsolid&apos;</source>
        <translation>finit avant «&#xa0;endsolid&#xa0;»</translation>
    </message>
    <message>
        <source>has %1 where &apos;%2&apos; is expected</source>
        <translation>a %1 là où «&#xa0;%2&#xa0;» est attendu</translation>
    </message>
    <message>
        <source>is too short for an STL file</source>
        <translation>est trop court pour un fichier STL</translation>
    </message>
    <message>
        <source>claims %1 triangles but is only %2 bytes long</source>
        <translation>annonce %1 triangles mais n&apos;a que %2 octets</translation>
    </message>
    <message>
        <source>goes on after the %1 triangles that it claims to have</source>
        <translation>continue après les %1 triangles qu&apos;il annonce</translation>
    </message>
    <message>
        <source>has a coordinate that is not a finite number</source>
        <translation>a une coordonnée qui n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>ends before %1</source>
        <translation>finit avant %1</translation>
    </message>
    <message>
        <source>%1 %2 is not a number</source>
        <translation>%1 %2 n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>%1 %2 is not a finite number</source>
        <translation>%1 %2 n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>has %1 {1|triangle with two equal corners, which was|triangles with two equal corners, which were} left out</source>
        <translation>a %1 {1|triangle à deux sommets égaux, qui a été omis|triangles à deux sommets égaux, qui ont été omis}</translation>
    </message>
    <message>
        <source>They have no area, so that no surface is missing.</source>
        <translation>Leur aire est nulle&#xa0;: il ne manque aucune surface.</translation>
    </message>
    <message>
        <source>was closed along %1 {1|edge|edges} on which vertices of neighbouring faces lie (T-junctions)</source>
        <translation>a été fermé le long de %1 {1|arête|arêtes} où se trouvent des sommets de faces voisines (jonctions en T)</translation>
    </message>
    <message>
        <source>The surface has moved by at most %1 micrometres.</source>
        <translation>La surface s&apos;est déplacée d&apos;au plus %1 micromètres.</translation>
    </message>
    <message>
        <source>had %1 planar {1|hole, which was|holes, which were} closed as asked for; %2 {2|hole is|holes are} left open</source>
        <translation>avait %1 {1|trou plan, fermé|trous plans, fermés} comme demandé&#xa0;; %2 {2|trou reste ouvert|trous restent ouverts}</translation>
    </message>
    <message>
        <source>Look at them: what is behind a closed hole is solid.</source>
        <translation>Vérifiez-les&#xa0;: ce qui est derrière un trou fermé est plein.</translation>
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
        <source>holds no triangle with three corners</source>
        <translation>ne contient aucun triangle à trois sommets</translation>
    </message>
    <message>
        <source>Export the part again.</source>
        <translation>Exportez de nouveau la pièce.</translation>
    </message>
    <message>
        <source>asset &apos;%1&apos;</source>
        <translation>asset «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>has a unit or an up-axis, but a %1 file says itself what its numbers mean, and is z up</source>
        <translation>a une unité ou un axe vertical, mais un fichier %1 donne lui-même le sens de ses nombres, avec z vers le haut</translation>
    </message>
    <message>
        <source>Leave out &apos;unit&apos; and &apos;up_axis&apos;.</source>
        <translation>Omettez «&#xa0;unit&#xa0;» et «&#xa0;up_axis&#xa0;».</translation>
    </message>
    <message>
        <source>is not closed: faces or boundaries that could not be made: %1; certificates take what is missing as free space</source>
        <translation>n&apos;est pas fermé&#xa0;: %1 faces ou contours n&apos;ont pas pu être construits&#xa0;; les certificats prennent ce qui manque pour de l&apos;espace libre</translation>
    </message>
    <message>
        <source>Do not trust paths near it; export it again, or as a mesh.</source>
        <translation>Ne vous fiez pas aux chemins qui passent près d&apos;elle&#xa0;; exportez-la de nouveau, ou en maillage.</translation>
    </message>
    <message>
        <source>the scenario neither names it nor excludes it</source>
        <translation>le scénario ne la nomme pas et ne l&apos;exclut pas</translation>
    </message>
    <message>
        <source>it is not sound IGES text</source>
        <translation>ce n&apos;est pas un texte IGES correct</translation>
    </message>
    <message>
        <source>its kind is not read</source>
        <translation>sa sorte n&apos;est pas lue</translation>
    </message>
    <message>
        <source>it could not be made</source>
        <translation>il n&apos;a pas pu être construit</translation>
    </message>
    <message>
        <source>it ends before its terminate section (T): it is cut off</source>
        <translation>il finit avant sa section de fin (T)&#xa0;: il est tronqué</translation>
    </message>
    <message>
        <source>column 73 of its first line is not S: it is no text of 80 columns</source>
        <translation>la colonne 73 de sa première ligne n&apos;est pas S&#xa0;: ce n&apos;est pas un texte de 80 colonnes</translation>
    </message>
    <message>
        <source>its line %1 is of no section, or of another one than the lines around it</source>
        <translation>sa ligne %1 n&apos;est d&apos;aucune section, ou d&apos;une autre que les lignes voisines</translation>
    </message>
    <message>
        <source>its line %1 is not numbered as it should be (%2): lines are missing, or damaged</source>
        <translation>sa ligne %1 n&apos;a pas le numéro attendu (%2)&#xa0;: des lignes manquent ou sont abîmées</translation>
    </message>
    <message>
        <source>it has %1 {1|line|lines} in its section %2, and states %3: lines are missing</source>
        <translation>il a %1 {1|ligne|lignes} dans sa section %2 et en annonce %3&#xa0;: des lignes manquent</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1&#xa0;octets</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1&#xa0;Mio</translation>
    </message>
    <message>
        <source>Read it again.</source>
        <translation>Lisez-le de nouveau.</translation>
    </message>
    <message>
        <source>takes too long to read: it is too complex or malformed</source>
        <translation>est trop long à lire&#xa0;: il est trop complexe ou mal formé</translation>
    </message>
    <message>
        <source>was not read: the library that reads this format crashed on it</source>
        <translation>n&apos;a pas été lu&#xa0;: la bibliothèque qui lit ce format s&apos;est arrêtée brutalement</translation>
    </message>
    <message>
        <source>was not read: the library that reads this format crashed on it (%1)</source>
        <translation>n&apos;a pas été lu&#xa0;: la bibliothèque qui lit ce format s&apos;est arrêtée brutalement (%1)</translation>
    </message>
    <message>
        <source>the importer failed on it</source>
        <translation>l&apos;importateur a échoué sur ce fichier</translation>
    </message>
    <message>
        <source>was not read: the importing process cannot give up its rights (%1)</source>
        <translation>n&apos;a pas été lu&#xa0;: le processus d&apos;import ne peut pas abandonner ses droits (%1)</translation>
    </message>
    <message>
        <source>Files are read only where the kernel permits seccomp filters: use another machine or container.</source>
        <translation>Les fichiers ne sont lus que si le noyau permet les filtres seccomp&#xa0;: utilisez une autre machine ou un autre conteneur.</translation>
    </message>
    <message>
        <source>holds %1 vertices and %2 triangles; at most %3 of each are read</source>
        <translation>contient %1 sommets et %2 triangles&#xa0;; au plus %3 de chaque sont lus</translation>
    </message>
    <message>
        <source>has a vertex whose coordinates are not finite, or too large</source>
        <translation>a un sommet dont les coordonnées ne sont pas finies ou sont trop grandes</translation>
    </message>
    <message>
        <source>does not fit the content: the file was edited outside of Glissade, or it is damaged</source>
        <translation>ne correspond pas au contenu&#xa0;: le fichier a été modifié hors de Glissade, ou il est endommagé</translation>
    </message>
    <message>
        <source>its groups are nested too deeply</source>
        <translation>ses groupes sont trop imbriqués</translation>
    </message>
    <message>
        <source>it has too many groups and parts</source>
        <translation>il a trop de groupes et de pièces</translation>
    </message>
    <message>
        <source>it has more than %1 parts</source>
        <translation>il a plus de %1 pièces</translation>
    </message>
    <message>
        <source>%1 {1|face is|faces are} smaller than the gaps between faces</source>
        <translation>%1 {1|face est plus petite|faces sont plus petites} que les intervalles entre les faces</translation>
    </message>
    <message>
        <source>holds 32-bit coordinates whose spacing of %1 is too coarse for a part with a diagonal of %2 (units of the file)</source>
        <translation>contient des coordonnées sur 32 bits dont l&apos;espacement de %1 est trop grossier pour une pièce de diagonale %2 (unités du fichier)</translation>
    </message>
    <message>
        <source>Export the part nearer to its origin, or as STL text, OBJ or PLY text with enough digits.</source>
        <translation>Exportez la pièce plus près de son origine, ou en texte STL, OBJ ou PLY avec assez de chiffres.</translation>
    </message>
    <message>
        <source>Export the part again, for example as binary STL or GLB.</source>
        <translation>Exportez de nouveau la pièce, par exemple en STL binaire ou en GLB.</translation>
    </message>
    <message>
        <source>is of a kind that is not read (&apos;%1&apos;)</source>
        <translation>est d&apos;un type qui n&apos;est pas lu («&#xa0;%1 »)</translation>
    </message>
    <message>
        <source>Use STL, OBJ, PLY, DAE, glTF or GLB; &quot;step&quot; and &quot;urdf&quot; are shapes of their own in a scenario.</source>
        <translation>Utilisez STL, OBJ, PLY, DAE, glTF ou GLB&#xa0;; dans un scénario, «&#xa0;step&#xa0;» et «&#xa0;urdf&#xa0;» sont des formes à part.</translation>
    </message>
    <message>
        <source>Buffers in files of their own are not read: export it as one .glb file.</source>
        <translation>Les tampons dans des fichiers séparés ne sont pas lus&#xa0;: exportez-le en un seul fichier .glb.</translation>
    </message>
    <message>
        <source>it holds neither a solid nor a face</source>
        <translation>il ne contient ni solide ni face</translation>
    </message>
    <message>
        <source>it holds neither a solid nor a face: %1 %2: %3</source>
        <translation>il ne contient ni solide ni face&#xa0;: %1 %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Correct the OMPL.app problem file.</source>
        <translation>Corrigez le fichier de problème OMPL.app.</translation>
    </message>
    <message>
        <source>is not &apos;key = value&apos;</source>
        <translation>n&apos;est pas de la forme «&#xa0;clé = valeur&#xa0;»</translation>
    </message>
    <message>
        <source>gives &apos;%1&apos; a second time</source>
        <translation>donne «&#xa0;%1&#xa0;» une seconde fois</translation>
    </message>
    <message>
        <source>is missing or empty</source>
        <translation>manque ou est vide</translation>
    </message>
    <message>
        <source>is beyond 1e9</source>
        <translation>dépasse 1e9</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>est nul</translation>
    </message>
    <message>
        <source>names &apos;%1&apos;, which is no part of several solids</source>
        <translation>nomme «&#xa0;%1&#xa0;», qui n&apos;est pas une pièce de plusieurs solides</translation>
    </message>
    <message>
        <source>See &apos;glissade-cli info&apos; for the names.</source>
        <translation>Les noms sont donnés par «&#xa0;glissade-cli info&#xa0;».</translation>
    </message>
    <message>
        <source>the file name &apos;%1&apos; leaves the folder</source>
        <translation>le nom de fichier «&#xa0;%1&#xa0;» sort du dossier</translation>
    </message>
    <message>
        <source>Put the file beside the scenario or below it and name it relative to it.</source>
        <translation>Mettez le fichier à côté du scénario ou au-dessous, et nommez-le relativement à lui.</translation>
    </message>
    <message>
        <source>has no face that could be tessellated</source>
        <translation>n&apos;a aucune face qui ait pu être triangulée</translation>
    </message>
    <message>
        <source>The deviation counts in every certificate; export the part as a mesh if it is too much.</source>
        <translation>L&apos;écart compte dans chaque certificat&#xa0;; exportez la pièce en maillage s&apos;il est trop grand.</translation>
    </message>
    <message>
        <source>It is an obstacle that can be inside of others. Export it as a solid, or exclude it (--without).</source>
        <translation>C&apos;est un obstacle qui peut se trouver à l&apos;intérieur d&apos;autres. Exportez-le comme solide, ou excluez-le (--without).</translation>
    </message>
    <message>
        <source>Give them faces if they are parts.</source>
        <translation>Donnez-leur des faces si ce sont des pièces.</translation>
    </message>
    <message>
        <source>Exclude it if it is no part (--without).</source>
        <translation>Excluez-le si ce n&apos;est pas une pièce (--without).</translation>
    </message>
    <message>
        <source>Export solids and triangles as two products if they are two parts.</source>
        <translation>Exportez les solides et les triangles comme deux produits si ce sont deux pièces.</translation>
    </message>
    <message>
        <source>Where that is wrong, export it with names in UTF-8, or name its parts by their numbers (#2).</source>
        <translation>Si c&apos;est faux, exportez-le avec des noms en UTF-8, ou nommez ses pièces par leurs numéros (#2).</translation>
    </message>
    <message>
        <source>%1: the part is not closed there; certificates take what is missing as free space</source>
        <translation>%1&#xa0;: la pièce n&apos;y est pas fermée&#xa0;; les certificats prennent ce qui manque pour de l&apos;espace libre</translation>
    </message>
    <message>
        <source>has a part that is at no place in space</source>
        <translation>a une pièce sans position dans l&apos;espace</translation>
    </message>
    <message>
        <source>its assemblies are nested too deeply, or hold themselves</source>
        <translation>ses assemblages sont trop imbriqués, ou se contiennent eux-mêmes</translation>
    </message>
    <message>
        <source>it has more than %1 assemblies and parts</source>
        <translation>il a plus de %1 assemblages et pièces</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is mirrored or scaled by its assembly and is in another file</source>
        <translation>«&#xa0;%1&#xa0;» est symétrisée ou mise à l&apos;échelle par son assemblage et se trouve dans un autre fichier</translation>
    </message>
    <message>
        <source>%1 more could not be made</source>
        <translation>%1 autres n&apos;ont pas pu être construits</translation>
    </message>
    <message>
        <source>it is not sound STEP text</source>
        <translation>ce n&apos;est pas un texte STEP correct</translation>
    </message>
    <message>
        <source>it holds no product that can be understood</source>
        <translation>il ne contient aucun produit interprétable</translation>
    </message>
    <message>
        <source>Export the part as a solid with faces, or as triangles.</source>
        <translation>Exportez la pièce comme solide avec des faces, ou comme triangles.</translation>
    </message>
    <message>
        <source>Put the files there and load again, or export the product as one file.</source>
        <translation>Placez-y les fichiers et rechargez, ou exportez le produit en un seul fichier.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>has more than %1 parts</source>
        <translation>a plus de %1 pièces</translation>
    </message>
    <message>
        <source>places other files more than %1 times, those that they place counted</source>
        <translation>place plus de %1 fois d&apos;autres fichiers, en comptant ceux que ces fichiers placent</translation>
    </message>
    <message>
        <source>is nested too deeply in other files</source>
        <translation>est trop imbriqué dans d&apos;autres fichiers</translation>
    </message>
    <message>
        <source>names &apos;%1&apos; for a part, which holds this file itself</source>
        <translation>nomme pour une pièce le fichier «&#xa0;%1&#xa0;», qui contient le présent fichier</translation>
    </message>
    <message>
        <source>names more than %1 files</source>
        <translation>nomme plus de %1 fichiers</translation>
    </message>
    <message>
        <source>and the files that it names have more than %1</source>
        <translation>a, avec les fichiers qu&apos;il nomme, plus de %1</translation>
    </message>
    <message>
        <source>needs more than %1 triangles</source>
        <translation>demande plus de %1 triangles</translation>
    </message>
    <message>
        <source>%1 more of its shapes are missing</source>
        <translation>%1 autres de ses formes manquent</translation>
    </message>
    <message>
        <source>part &apos;%1&apos;</source>
        <translation>pièce «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>nothing is known of where %1 is, and certificates are about the product without it: %2</source>
        <translation>on ne sait pas où est %1, et les certificats portent sur le produit sans lui&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 more {1|file of its parts is|files of its parts are} missing</source>
        <translation>%1 {1|autre fichier de ses pièces manque|autres fichiers de ses pièces manquent}</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>pièce %1</translation>
    </message>
    <message>
        <source>is missing, and certificates take it as free space: its file &apos;%1&apos; %2 (looked for in &apos;%3&apos;)</source>
        <translation>manque, et les certificats la prennent pour de l&apos;espace libre&#xa0;: son fichier «&#xa0;%1&#xa0;» %2 (cherché dans «&#xa0;%3&#xa0;»)</translation>
    </message>
    <message>
        <source>has its parts in other files, and none of them is there: %1 (looked for in &apos;%2&apos;)</source>
        <translation>a ses pièces dans d&apos;autres fichiers, dont aucun n&apos;existe&#xa0;: %1 (cherchés dans «&#xa0;%2 »)</translation>
    </message>
    <message>
        <source>Export the product as one file.</source>
        <translation>Exportez le produit en un seul fichier.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cylindre</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>cône</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>tore</translation>
    </message>
    <message>
        <source>B-spline surface</source>
        <translation>surface B-spline</translation>
    </message>
    <message>
        <source>Bezier surface</source>
        <translation>surface de Bézier</translation>
    </message>
    <message>
        <source>surface of revolution</source>
        <translation>surface de révolution</translation>
    </message>
    <message>
        <source>surface of extrusion</source>
        <translation>surface d&apos;extrusion</translation>
    </message>
    <message>
        <source>offset surface</source>
        <translation>surface décalée</translation>
    </message>
    <message>
        <source>face %1 (%2)</source>
        <translation>la face %1 (%2)</translation>
    </message>
    <message>
        <source>face %1 (%2) of &apos;%3&apos;</source>
        <translation>face %1 (%2) de «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>OpenCASCADE makes no triangles for it</source>
        <translation>OpenCASCADE ne lui fait aucun triangle</translation>
    </message>
    <message>
        <source>OpenCASCADE&apos;s triangles leave its boundary open</source>
        <translation>les triangles d&apos;OpenCASCADE laissent son contour ouvert</translation>
    </message>
    <message>
        <source>OpenCASCADE&apos;s triangles overlap on it</source>
        <translation>les triangles d&apos;OpenCASCADE s&apos;y recouvrent</translation>
    </message>
    <message>
        <source>%1; it was triangulated from its boundaries, within %2 mm of its surface</source>
        <translation>%1&#xa0;; elle a été triangulée à partir de ses contours, à %2&#xa0;mm de sa surface au plus</translation>
    </message>
    <message>
        <source>%1, because its boundaries cross; it was triangulated between their points, within %2 mm of its surface</source>
        <translation>%1, parce que ses contours se croisent&#xa0;; elle a été triangulée entre leurs points, à %2&#xa0;mm de sa surface au plus</translation>
    </message>
    <message>
        <source>%1, and its boundaries cannot be triangulated</source>
        <translation>%1, et ses contours ne peuvent pas être triangulés</translation>
    </message>
    <message>
        <source>its triangles enclose %1 cubic millimetres, and its faces %2: they differ by more than the deviation of the triangles explains</source>
        <translation>ses triangles enferment %1 millimètres cubes, et ses faces %2&#xa0;: la différence dépasse ce que l&apos;écart des triangles explique</translation>
    </message>
    <message>
        <source>is not a STEP file (it does not begin with ISO-10303-21)</source>
        <translation>n&apos;est pas un fichier STEP (il ne commence pas par ISO-10303-21)</translation>
    </message>
    <message>
        <source>Export the part as STEP AP214 or AP242, not compressed and not as XML.</source>
        <translation>Exportez la pièce en STEP AP214 ou AP242, sans compression ni XML.</translation>
    </message>
    <message>
        <source>is a building model (IFC), not a product</source>
        <translation>est une maquette de bâtiment (IFC), pas un produit</translation>
    </message>
    <message>
        <source>Export it as STEP AP214 or AP242.</source>
        <translation>Exportez-le en STEP AP214 ou AP242.</translation>
    </message>
    <message>
        <source>ends before END-ISO-10303-21: it is cut off</source>
        <translation>finit avant END-ISO-10303-21&#xa0;: il est tronqué</translation>
    </message>
    <message>
        <source>is a binary BREP file, which is not read: write it as text</source>
        <translation>est un fichier BREP binaire, qui n&apos;est pas lu&#xa0;: écrivez-le en texte</translation>
    </message>
    <message>
        <source>is not a BREP file (it does not begin with &apos;CASCADE Topology V&apos;)</source>
        <translation>n&apos;est pas un fichier BREP (il ne commence pas par «&#xa0;CASCADE Topology V&#xa0;»)</translation>
    </message>
    <message>
        <source>Export it again as STEP AP214 or AP242, or its parts as meshes.</source>
        <translation>Exportez-le de nouveau en STEP AP214 ou AP242, ou ses pièces en maillages.</translation>
    </message>
    <message>
        <source>the solid could not be made</source>
        <translation>le solide n&apos;a pas pu être construit</translation>
    </message>
    <message>
        <source>number %1 of its faces is not a face</source>
        <translation>sa face numéro %1 n&apos;est pas une face</translation>
    </message>
    <message>
        <source>its face %1 could not be made</source>
        <translation>sa face %1 n&apos;a pas pu être construite</translation>
    </message>
    <message>
        <source>number %1 of its boundaries could not be made</source>
        <translation>son contour numéro %1 n&apos;a pas pu être construit</translation>
    </message>
    <message>
        <source>more than %1 of its faces could not be made</source>
        <translation>plus de %1 de ses faces n&apos;ont pas pu être construites</translation>
    </message>
    <message>
        <source>%1 mirrors a part in a way that cannot be read: write it as a part of its own</source>
        <translation>%1 symétrise une pièce d&apos;une façon qui ne peut pas être lue&#xa0;: écrivez-la comme une pièce à part</translation>
    </message>
    <message>
        <source>%1 scales a part in a way that cannot be read: write it as a part of its own</source>
        <translation>%1 met une pièce à l&apos;échelle d&apos;une façon qui ne peut pas être lue&#xa0;: écrivez-la comme une pièce à part</translation>
    </message>
    <message>
        <source>%1 places a part in a way that cannot be read: write it as a part of its own</source>
        <translation>%1 place une pièce d&apos;une façon qui ne peut pas être lue&#xa0;: écrivez-la comme une pièce à part</translation>
    </message>
    <message>
        <source>%1 places a part that could not be made</source>
        <translation>%1 place une pièce qui n&apos;a pas pu être construite</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is distorted by its assembly</source>
        <translation>«&#xa0;%1&#xa0;» est déformée par son assemblage</translation>
    </message>
    <message>
        <source>a mirrored or scaled part was not found in its assembly</source>
        <translation>une pièce symétrisée ou mise à l&apos;échelle n&apos;a pas été trouvée dans son assemblage</translation>
    </message>
    <message>
        <source>the product has no shape in the file</source>
        <translation>le produit n&apos;a pas de forme dans le fichier</translation>
    </message>
    <message>
        <source>it places the part, and is not understood</source>
        <translation>il place la pièce, et n&apos;est pas compris</translation>
    </message>
    <message>
        <source>it belongs to no solid of the file</source>
        <translation>il n&apos;appartient à aucun solide du fichier</translation>
    </message>
    <message>
        <source>its triangles cannot be read: %1</source>
        <translation>ses triangles ne peuvent pas être lus&#xa0;: %1</translation>
    </message>
    <message>
        <source>it was made in %1 of its %2 {2|place|places}</source>
        <translation>il a été construit à %1 de ses %2 {2|emplacement|emplacements}</translation>
    </message>
    <message>
        <source>it belongs to no product of the file and is read as a body where its coordinates are</source>
        <translation>il n&apos;appartient à aucun produit du fichier et est lu comme corps là où sont ses coordonnées</translation>
    </message>
    <message>
        <source>is not a file name</source>
        <translation>n&apos;est pas un nom de fichier</translation>
    </message>
    <message>
        <source>is outside its folder</source>
        <translation>est hors de son dossier</translation>
    </message>
    <message>
        <source>is not there</source>
        <translation>n&apos;existe pas</translation>
    </message>
    <message>
        <source>is not a STEP file</source>
        <translation>n&apos;est pas un fichier STEP</translation>
    </message>
    <message>
        <source>is the name of several parts</source>
        <translation>est le nom de plusieurs pièces</translation>
    </message>
    <message>
        <source>Give the whole name: %1.</source>
        <translation>Donnez le nom entier&#xa0;: %1.</translation>
    </message>
    <message>
        <source>is not in the file</source>
        <translation>n&apos;est pas dans le fichier</translation>
    </message>
    <message>
        <source>The file holds one part: leave out the name.</source>
        <translation>Le fichier contient une seule pièce&#xa0;: omettez le nom.</translation>
    </message>
    <message>
        <source>It holds: %1.</source>
        <translation>Il contient&#xa0;: %1.</translation>
    </message>
    <message>
        <source>#%1 is there twice</source>
        <translation>#%1 y est deux fois</translation>
    </message>
    <message>
        <source>%1 refers to #%2, which is not in the file</source>
        <translation>%1 renvoie à #%2, qui n&apos;est pas dans le fichier</translation>
    </message>
    <message>
        <source>%1 refers to %2, which refers back to it</source>
        <translation>%1 renvoie à %2, qui renvoie à lui</translation>
    </message>
    <message>
        <source>it is taken for a second representation of a solid of its size and is left out</source>
        <translation>il est pris pour une seconde représentation d&apos;un solide de sa taille et est ignoré</translation>
    </message>
    <message>
        <source>is no solid: its faces (%1) bound nothing, %2 of their edges are open</source>
        <translation>n&apos;est pas un solide&#xa0;: ses faces (%1) ne délimitent rien, %2 de leurs arêtes sont ouvertes</translation>
    </message>
    <message>
        <source>has no thickness: its faces enclose no volume</source>
        <translation>n&apos;a pas d&apos;épaisseur&#xa0;: ses faces n&apos;enferment aucun volume</translation>
    </message>
    <message>
        <source>has curves that lie on no face (%1): they are left out</source>
        <translation>a des courbes qui ne sont sur aucune face (%1)&#xa0;: elles sont ignorées</translation>
    </message>
    <message>
        <source>a list of its numbers holds something else</source>
        <translation>une liste de ses nombres contient autre chose</translation>
    </message>
    <message>
        <source>it has no triangle with three corners</source>
        <translation>il n&apos;a aucun triangle à trois sommets</translation>
    </message>
    <message>
        <source>its items are nested too deeply</source>
        <translation>ses éléments sont imbriqués trop profondément</translation>
    </message>
    <message>
        <source>%1 has too few values</source>
        <translation>%1 a trop peu de valeurs</translation>
    </message>
    <message>
        <source>its item %1 is of a kind that is not read</source>
        <translation>son élément %1 est d&apos;une sorte qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>%1 has a triangle without three corners</source>
        <translation>%1 a un triangle sans trois sommets</translation>
    </message>
    <message>
        <source>%1 has no COORDINATES_LIST</source>
        <translation>%1 n&apos;a pas de COORDINATES_LIST</translation>
    </message>
    <message>
        <source>a point of COORDINATES_LIST #%1 has no three numbers</source>
        <translation>un point de COORDINATES_LIST n° %1 n&apos;a pas trois nombres</translation>
    </message>
    <message>
        <source>%1 refers to point %2, which is not in its lists</source>
        <translation>%1 renvoie au point %2, qui n&apos;est pas dans ses listes</translation>
    </message>
    <message>
        <source>%1 has a point that is not in space</source>
        <translation>%1 a un point qui n&apos;est pas dans l&apos;espace</translation>
    </message>
    <message>
        <source>it is repositioned in a way that is not read</source>
        <translation>il est déplacé d&apos;une manière qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>a parenthesis is not closed</source>
        <translation>une parenthèse n&apos;est pas fermée</translation>
    </message>
    <message>
        <source>a parenthesis is closed that was not opened</source>
        <translation>une parenthèse est fermée sans avoir été ouverte</translation>
    </message>
    <message>
        <source>parentheses are nested more than %1 deep</source>
        <translation>les parenthèses sont imbriquées sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>a list has more than %1 values</source>
        <translation>une liste a plus de %1 valeurs</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une valeur</translation>
    </message>
    <message>
        <source>a number has %1 characters</source>
        <translation>un nombre a %1 caractères</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>validation property %1</source>
        <translation>propriété de validation %1</translation>
    </message>
    <message>
        <source>its triangles enclose %1 cubic millimetres, and the file states %2: they differ by more than the deviation of the triangles explains</source>
        <translation>ses triangles enferment %1 millimètres cubes, et le fichier indique %2&#xa0;: la différence dépasse ce que l&apos;écart des triangles explique</translation>
    </message>
    <message>
        <source>its triangles have %1 square millimetres, and the file states %2: they differ by more than the deviation of the triangles explains</source>
        <translation>ses triangles couvrent %1 millimètres carrés, et le fichier indique %2&#xa0;: la différence dépasse ce que l&apos;écart des triangles explique</translation>
    </message>
    <message>
        <source>the centroid of its triangles is %1 mm from the one that the file states: more than the deviation of the triangles explains</source>
        <translation>le centre de gravité de ses triangles est à %1&#xa0;mm de celui que le fichier indique&#xa0;: plus que ce que l&apos;écart des triangles explique</translation>
    </message>
    <message>
        <source>the filter of system calls cannot be loaded: %1</source>
        <translation>le filtre des appels système ne peut pas être chargé&#xa0;: %1</translation>
    </message>
    <message>
        <source>a SolidWorks file</source>
        <translation>un fichier SolidWorks</translation>
    </message>
    <message>
        <source>a CATIA file</source>
        <translation>un fichier CATIA</translation>
    </message>
    <message>
        <source>an Inventor file</source>
        <translation>un fichier Inventor</translation>
    </message>
    <message>
        <source>a part or an assembly of NX, Creo or Solid Edge</source>
        <translation>une pièce ou un assemblage de NX, Creo ou Solid Edge</translation>
    </message>
    <message>
        <source>a Solid Edge file</source>
        <translation>un fichier Solid Edge</translation>
    </message>
    <message>
        <source>a JT file</source>
        <translation>un fichier JT</translation>
    </message>
    <message>
        <source>a Parasolid file</source>
        <translation>un fichier Parasolid</translation>
    </message>
    <message>
        <source>an ACIS file</source>
        <translation>un fichier ACIS</translation>
    </message>
    <message>
        <source>a Fusion file</source>
        <translation>un fichier Fusion</translation>
    </message>
    <message>
        <source>a FreeCAD file</source>
        <translation>un fichier FreeCAD</translation>
    </message>
    <message>
        <source>a Rhino file</source>
        <translation>un fichier Rhino</translation>
    </message>
    <message>
        <source>an AutoCAD drawing</source>
        <translation>un dessin AutoCAD</translation>
    </message>
    <message>
        <source>a VDA-FS file</source>
        <translation>un fichier VDA-FS</translation>
    </message>
    <message>
        <source>a binary BREP file</source>
        <translation>un fichier BREP binaire</translation>
    </message>
    <message>
        <source>an OpenSCAD program</source>
        <translation>un programme OpenSCAD</translation>
    </message>
    <message>
        <source>a 3MF file</source>
        <translation>un fichier 3MF</translation>
    </message>
    <message>
        <source>an AMF file</source>
        <translation>un fichier AMF</translation>
    </message>
    <message>
        <source>a SketchUp file</source>
        <translation>un fichier SketchUp</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>un fichier Blender</translation>
    </message>
    <message>
        <source>an FBX file</source>
        <translation>un fichier FBX</translation>
    </message>
    <message>
        <source>a 3ds Max file</source>
        <translation>un fichier 3ds Max</translation>
    </message>
    <message>
        <source>a USD file</source>
        <translation>un fichier USD</translation>
    </message>
    <message>
        <source>a VRML or X3D file</source>
        <translation>un fichier VRML ou X3D</translation>
    </message>
    <message>
        <source>a building model (IFC)</source>
        <translation>un modèle de bâtiment (IFC)</translation>
    </message>
    <message>
        <source>STEP as XML</source>
        <translation>du STEP en XML</translation>
    </message>
    <message>
        <source>a compressed file</source>
        <translation>un fichier compressé</translation>
    </message>
    <message>
        <source>Export it as STEP (AP214 or AP242) in the program that it is from.</source>
        <translation>Exportez-le en STEP (AP214 ou AP242) dans le programme dont il vient.</translation>
    </message>
    <message>
        <source>Export it as STL, OBJ, PLY or glTF in the program that it is from.</source>
        <translation>Exportez-le en STL, OBJ, PLY ou glTF dans le programme dont il vient.</translation>
    </message>
    <message>
        <source>Unpack it, and give the file that is in it.</source>
        <translation>Décompressez-le, et donnez le fichier qu&apos;il contient.</translation>
    </message>
    <message>
        <source>is %1, which is not read</source>
        <translation>est %1, ce qui n&apos;est pas lu</translation>
    </message>
    <message>
        <source>Correct the URDF file.</source>
        <translation>Corrigez le fichier URDF.</translation>
    </message>
    <message>
        <source>has a link that is the child of two joints</source>
        <translation>a un corps qui dépend de deux liaisons</translation>
    </message>
    <message>
        <source>has more than %1 triangles</source>
        <translation>a plus de %1 triangles</translation>
    </message>
    <message>
        <source>joint &apos;%1&apos;</source>
        <translation>liaison «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is not fixed: only rigid bodies are read</source>
        <translation>n&apos;est pas fixe&#xa0;: seuls les corps rigides sont lus</translation>
    </message>
    <message>
        <source>has links that no joint connects to its root</source>
        <translation>a des corps qu&apos;aucune liaison ne relie à sa racine</translation>
    </message>
    <message>
        <source>holds no shape</source>
        <translation>ne contient aucune forme</translation>
    </message>
    <message>
        <source>link &apos;%1&apos;</source>
        <translation>corps URDF «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>has a shape whose size is not a positive number from 1e-12 m to 1e9 m</source>
        <translation>a une forme dont la taille n&apos;est pas un nombre positif de 1e-12 m à 1e9 m</translation>
    </message>
    <message>
        <source>has an unknown shape</source>
        <translation>a une forme inconnue</translation>
    </message>
    <message>
        <source>has a mesh whose scale is not a number from 1e-12 to 1e9</source>
        <translation>a un maillage dont l&apos;échelle n&apos;est pas un nombre de 1e-12 à 1e9</translation>
    </message>
    <message>
        <source>has an origin that is not finite, or beyond 1e9 m</source>
        <translation>a une origine qui n&apos;est pas finie ou dépasse 1e9 m</translation>
    </message>
    <message>
        <source>has more than %1 links</source>
        <translation>a plus de %1 corps</translation>
    </message>
    <message>
        <source>is not a URDF file</source>
        <translation>n&apos;est pas un fichier URDF</translation>
    </message>
    <message>
        <source>has a shape that cannot be read</source>
        <translation>a une forme qui ne peut pas être lue</translation>
    </message>
    <message>
        <source>ends inside the element &apos;%1&apos;</source>
        <translation>finit à l&apos;intérieur de l&apos;élément «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is not valid UTF-8 text</source>
        <translation>n&apos;est pas un texte UTF-8 valide</translation>
    </message>
    <message>
        <source>a comment</source>
        <translation>un commentaire</translation>
    </message>
    <message>
        <source>a CDATA section</source>
        <translation>une section CDATA</translation>
    </message>
    <message>
        <source>has a document type, which is not read</source>
        <translation>a un type de document, ce qui n&apos;est pas lu</translation>
    </message>
    <message>
        <source>has %1 that does not end</source>
        <translation>a %1 qui ne finit pas</translation>
    </message>
    <message>
        <source>has a processing instruction that does not end with its first &apos;&gt;&apos;</source>
        <translation>a une instruction de traitement qui ne finit pas à son premier «&#xa0;&gt;&#xa0;»</translation>
    </message>
    <message>
        <source>has the end tag of an element that is not open</source>
        <translation>a la balise de fin d&apos;un élément qui n&apos;est pas ouvert</translation>
    </message>
    <message>
        <source>has a tag that does not end</source>
        <translation>a une balise qui ne finit pas</translation>
    </message>
    <message>
        <source>has more than %1 elements</source>
        <translation>a plus de %1 éléments</translation>
    </message>
    <message>
        <source>is nested too deeply (more than %1 elements)</source>
        <translation>est trop imbriqué (plus de %1 éléments)</translation>
    </message>
    <message>
        <source>has a tag that is not valid XML</source>
        <translation>a une balise qui n&apos;est pas du XML valide</translation>
    </message>
    <message>
        <source>has an element with more than %1 attributes</source>
        <translation>a un élément avec plus de %1 attributs</translation>
    </message>
    <message>
        <source>has an attribute without a value</source>
        <translation>a un attribut sans valeur</translation>
    </message>
    <message>
        <source>has an attribute whose value is not quoted</source>
        <translation>a un attribut dont la valeur n&apos;est pas entre guillemets</translation>
    </message>
    <message>
        <source>has an attribute whose value does not end</source>
        <translation>a un attribut dont la valeur ne finit pas</translation>
    </message>
    <message>
        <source>has &apos;&lt;&apos; in the value of an attribute, which XML writes as &amp;lt;</source>
        <translation>a «&#xa0;&lt;&#xa0;» dans la valeur d&apos;un attribut, ce que XML écrit &amp;lt;</translation>
    </message>
    <message>
        <source>has a tag or an attribute without a name</source>
        <translation>a une balise ou un attribut sans nom</translation>
    </message>
    <message>
        <source>A person: keys, 6D mouse, gamepad and the controllers of a headset together.</source>
        <translation>Une personne&#xa0;: clavier, souris 6D, manette de jeu et manettes d&apos;un casque ensemble.</translation>
    </message>
    <message>
        <source>A person: the keys of the window.</source>
        <translation>Une personne&#xa0;: les touches de la fenêtre.</translation>
    </message>
    <message>
        <source>A person: a 3Dconnexion mouse.</source>
        <translation>Une personne&#xa0;: une souris 3Dconnexion.</translation>
    </message>
    <message>
        <source>A person: a game controller.</source>
        <translation>Une personne&#xa0;: une manette de jeu.</translation>
    </message>
    <message>
        <source>A person with a headset: its left controller.</source>
        <translation>Une personne avec un casque&#xa0;: sa manette gauche.</translation>
    </message>
    <message>
        <source>A person with a headset: its right controller.</source>
        <translation>Une personne avec un casque&#xa0;: sa manette droite.</translation>
    </message>
    <message>
        <source>Simulated expert</source>
        <translation>Expert simulé</translation>
    </message>
    <message>
        <source>Follows the way-points fast and exactly.</source>
        <translation>Suit les points de passage vite et avec précision.</translation>
    </message>
    <message>
        <source>Simulated operator</source>
        <translation>Opérateur simulé</translation>
    </message>
    <message>
        <source>Follows the way-points.</source>
        <translation>Suit les points de passage.</translation>
    </message>
    <message>
        <source>Simulated novice</source>
        <translation>Novice simulé</translation>
    </message>
    <message>
        <source>Follows the way-points, slow and unsure.</source>
        <translation>Suit les points de passage, lentement et avec hésitation.</translation>
    </message>
    <message>
        <source>Simulated haptic hand</source>
        <translation>Main haptique simulée</translation>
    </message>
    <message>
        <source>Draws the object along the way-points and feels the obstacles.</source>
        <translation>Tire l&apos;objet le long des points de passage et perçoit les obstacles.</translation>
    </message>
    <message>
        <source>Shows a path at the level of a task.</source>
        <translation>Montre un chemin au niveau de la tâche.</translation>
    </message>
    <message>
        <source>reading the gamepad</source>
        <translation>lecture de la manette</translation>
    </message>
    <message>
        <source>disconnecting the gamepad</source>
        <translation>déconnexion de la manette</translation>
    </message>
    <message>
        <source>stopping the haptic device</source>
        <translation>arrêt du périphérique haptique</translation>
    </message>
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
    <message>
        <source>reading the 6D mouse</source>
        <translation>lecture de la souris 6D</translation>
    </message>
    <message>
        <source>disconnecting the 6D mouse</source>
        <translation>déconnexion de la souris 6D</translation>
    </message>
    <message>
        <source>the workspace has no configuration outside the product</source>
        <translation>l&apos;espace de travail n&apos;a aucune configuration hors du produit</translation>
    </message>
    <message>
        <source>Widen the workspace.</source>
        <translation>Agrandissez l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>no direct motion is free</source>
        <translation>aucun mouvement direct n&apos;est libre</translation>
    </message>
    <message>
        <source>Choose a planner that searches.</source>
        <translation>Choisissez une stratégie qui cherche.</translation>
    </message>
    <message>
        <source>no screw motion out of the modelled thread is free</source>
        <translation>aucun mouvement de dévissage du filetage modélisé n&apos;est libre</translation>
    </message>
    <message>
        <source>%1; no clear position was found within %2 mm</source>
        <translation>%1&#xa0;; aucune position dégagée n&apos;a été trouvée à moins de %2 mm</translation>
    </message>
    <message>
        <source>Switch fits on, put the object elsewhere, or check the parts and their unit.</source>
        <translation>Activez les ajustements, placez l&apos;objet ailleurs, ou vérifiez les pièces et leur unité.</translation>
    </message>
    <message>
        <source>the object is nearer to &apos;%1&apos; than the required clearance</source>
        <translation>l&apos;objet est plus près de «&#xa0;%1&#xa0;» que le jeu exigé</translation>
    </message>
    <message>
        <source>the object penetrates &apos;%1&apos;</source>
        <translation>l&apos;objet pénètre dans «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the object touches &apos;%1&apos;</source>
        <translation>l&apos;objet touche «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the object overlaps &apos;%1&apos; by %2 mm</source>
        <translation>l&apos;objet recouvre «&#xa0;%1&#xa0;» de %2 mm</translation>
    </message>
    <message>
        <source>the operation was stopped</source>
        <translation>l&apos;opération a été arrêtée</translation>
    </message>
    <message>
        <source>the path of the shrunk object could not be repaired for the full-size object</source>
        <translation>le chemin de l&apos;objet réduit n&apos;a pas pu être adapté à l&apos;objet réel</translation>
    </message>
    <message>
        <source>Start again with another seed.</source>
        <translation>Recommencez avec une autre graine.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not expected</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;était pas attendu</translation>
    </message>
    <message>
        <source>a text stands where a number is needed</source>
        <translation>un texte est là où il faut un nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, a text, stands where a number is needed</source>
        <translation>«&#xa0;%1&#xa0;», un texte, est là où il faut un nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing</source>
        <translation>«&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>the rule ends too early</source>
        <translation>la règle finit trop tôt</translation>
    </message>
    <message>
        <source>a text is not closed</source>
        <translation>un texte n&apos;est pas fermé</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is unknown</source>
        <translation>le nom «&#xa0;%1&#xa0;» est inconnu</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has the wrong number of arguments</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;a pas le bon nombre d&apos;arguments</translation>
    </message>
    <message>
        <source>the rule is nested too deeply</source>
        <translation>la règle est trop imbriquée</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
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
        <translation>Corrigez la règle&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>there is no local planner &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de planificateur local «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>has no last rule that always holds</source>
        <translation>n&apos;a pas de dernière règle toujours vraie</translation>
    </message>
    <message>
        <source>End it with {&quot;when&quot;: &quot;1&quot;, ...}.</source>
        <translation>Terminez-la par {&quot;when&quot;: &quot;1&quot;, ...}.</translation>
    </message>
    <message>
        <source>divides by zero %1</source>
        <translation>divise par zéro %1</translation>
    </message>
    <message>
        <source>gives the negative cost %1 %2</source>
        <translation>donne le coût négatif %1 %2</translation>
    </message>
    <message>
        <source>A cost is 0 or more: correct the rule %1</source>
        <translation>Un coût vaut 0 ou plus&#xa0;: corrigez la règle %1</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 et %2</translation>
    </message>
    <message>
        <source>in place %1</source>
        <translation>dans le lieu %1</translation>
    </message>
    <message>
        <source>the direct path to the goal is blocked</source>
        <translation>le chemin direct vers le but est bloqué</translation>
    </message>
    <message>
        <source>the direct path to the goal is not free</source>
        <translation>le chemin direct vers le but n&apos;est pas libre</translation>
    </message>
    <message>
        <source>the topological graph has no path from start to goal</source>
        <translation>le graphe topologique n&apos;a aucun chemin du départ au but</translation>
    </message>
    <message>
        <source>%1; forbidden: %2</source>
        <translation>%1&#xa0;; interdits&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1; of infinite cost by the rules: %2</source>
        <translation>%1&#xa0;; de coût infini d&apos;après les règles&#xa0;: %2</translation>
    </message>
    <message>
        <source>Check the semantic attributes of the places, or use strategy G.</source>
        <translation>Vérifiez les attributs sémantiques des lieux, ou prenez la stratégie G.</translation>
    </message>
    <message>
        <source>no free milestone in border %1</source>
        <translation>pas de jalon libre dans la frontière %1</translation>
    </message>
    <message>
        <source>%1; crossed before</source>
        <translation>%1&#xa0;; déjà traversé</translation>
    </message>
    <message>
        <source>no way through place %1</source>
        <translation>aucun passage par le lieu %1</translation>
    </message>
    <message>
        <source>Relax its attributes, or use Layers (gts).</source>
        <translation>Assouplissez ses attributs, ou utilisez Couches (gts).</translation>
    </message>
    <message>
        <source>searched from start to goal after the coarse paths</source>
        <translation>recherche du départ au but après les chemins grossiers</translation>
    </message>
    <message>
        <source>Allow one of these places again, or raise the samples a step.</source>
        <translation>Autorisez de nouveau un de ces lieux, ou augmentez les échantillons par étape.</translation>
    </message>
    <message>
        <source>the steps together cannot be certified</source>
        <translation>les étapes ensemble ne peuvent pas être certifiées</translation>
    </message>
    <message>
        <source>Please report it with the scenario and the seed.</source>
        <translation>Signalez-le avec le scénario et la graine.</translation>
    </message>
    <message>
        <source>geometrical planner, then %1</source>
        <translation>planificateur géométrique, puis %1</translation>
    </message>
    <message>
        <source>a straight crossing fits, so linear</source>
        <translation>une traversée rectiligne convient, donc linear</translation>
    </message>
    <message>
        <source>complexity %1, cluttered, so %2</source>
        <translation>complexité %1, encombré, donc %2</translation>
    </message>
    <message>
        <source>complexity %1, so %2</source>
        <translation>complexité %1, donc %2</translation>
    </message>
    <message>
        <source>%1; blocked, so %2</source>
        <translation>%1&#xa0;; bloqué, donc %2</translation>
    </message>
    <message>
        <source>preparing OMPL&apos;s planner</source>
        <translation>préparation du planificateur d&apos;OMPL</translation>
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
        <source>Choose another planner.</source>
        <translation>Choisissez une autre stratégie.</translation>
    </message>
    <message>
        <source>planning with OMPL</source>
        <translation>planification avec OMPL</translation>
    </message>
    <message>
        <source>reading OMPL&apos;s roadmap</source>
        <translation>lecture du graphe d&apos;OMPL</translation>
    </message>
    <message>
        <source>OMPL&apos;s planner was given no free start within the bounds</source>
        <translation>le planificateur d&apos;OMPL n&apos;a pas de départ libre dans les bornes</translation>
    </message>
    <message>
        <source>Widen the bounds.</source>
        <translation>Élargissez les bornes.</translation>
    </message>
    <message>
        <source>OMPL&apos;s path is not certified: it touches or passes through an obstacle</source>
        <translation>le chemin d&apos;OMPL n&apos;est pas certifié&#xa0;: il touche ou traverse un obstacle</translation>
    </message>
    <message>
        <source>Lower %1, or plan with &apos;auto&apos;.</source>
        <translation>Réduisez %1, ou planifiez avec «&#xa0;auto&#xa0;».</translation>
    </message>
    <message>
        <source>RRT-Connect</source>
        <translation>RRT-Connect</translation>
    </message>
    <message>
        <source>The computer alone: two trees that grow towards each other, with contact sampling. The same planner with a computer share of 1.</source>
        <translation>L&apos;ordinateur seul&#xa0;: deux arbres qui croissent l&apos;un vers l&apos;autre, avec échantillons de contact. Le même planificateur avec une part de l&apos;ordinateur de 1.</translation>
    </message>
    <message>
        <source>RRT-Connect (OMPL)</source>
        <translation>RRT-Connect (OMPL)</translation>
    </message>
    <message>
        <source>Two trees that grow towards each other (Kuffner and LaValle 2000).</source>
        <translation>Deux arbres qui croissent l&apos;un vers l&apos;autre (Kuffner et LaValle 2000).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a planner for comparison, which only glissade-cli has</source>
        <translation>«&#xa0;%1&#xa0;» est une stratégie de comparaison, que seul glissade-cli possède</translation>
    </message>
    <message>
        <source>Run it with &apos;glissade-cli plan&apos;, &apos;replay&apos; or &apos;study&apos;, or choose another strategy.</source>
        <translation>Lancez-la avec «&#xa0;glissade-cli plan&#xa0;», «&#xa0;replay&#xa0;» ou «&#xa0;study&#xa0;», ou choisissez une autre stratégie.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Several planners work side by side; those that make progress get more time. No settings are needed.</source>
        <translation>Plusieurs planificateurs travaillent en parallèle&#xa0;; ceux qui progressent reçoivent plus de temps. Aucun réglage n&apos;est nécessaire.</translation>
    </message>
    <message>
        <source>Interactive</source>
        <translation>Interactif</translation>
    </message>
    <message>
        <source>You steer the object, and the automatic planners search along the way that you show. Without your hand it is the automatic strategy.</source>
        <translation>Vous guidez l&apos;objet, et les planificateurs automatiques cherchent le long du trajet que vous montrez. Sans votre main, c&apos;est la stratégie automatique.</translation>
    </message>
    <message>
        <source>Interactive without contact</source>
        <translation>Interactive sans contact</translation>
    </message>
    <message>
        <source>Operator and computer share the iterations, no contact sampling (Blin et al. 2016, table I).</source>
        <translation>L&apos;opérateur et l&apos;ordinateur se partagent les itérations, sans échantillons de contact (Blin et al. 2016, tableau I).</translation>
    </message>
    <message>
        <source>Interactive, contact that follows</source>
        <translation>Interactif, contact suivi</translation>
    </message>
    <message>
        <source>Near an obstacle the object follows its surfaces from one contact to the next, and turns as they make it turn.</source>
        <translation>Près d&apos;un obstacle, l&apos;objet suit ses surfaces d&apos;un contact au suivant et tourne comme elles le font tourner.</translation>
    </message>
    <message>
        <source>Interactive, contact first</source>
        <translation>Interactive, contact d&apos;abord</translation>
    </message>
    <message>
        <source>As the papers&apos; software of 2016: near an obstacle contact sampling comes before the draw by computer share.</source>
        <translation>Comme le logiciel des articles en 2016&#xa0;: près d&apos;un obstacle, les échantillons de contact passent avant le tirage selon la part de l&apos;ordinateur.</translation>
    </message>
    <message>
        <source>One RRT in the whole workspace (Cailhol et al. 2019, section 6.1).</source>
        <translation>Un RRT dans tout l&apos;espace de travail (Cailhol et al. 2019, section 6.1).</translation>
    </message>
    <message>
        <source>The shortest path through the places, RRT in each of them (Cailhol et al. 2019, section 6.1).</source>
        <translation>Le chemin le plus court à travers les lieux, un RRT dans chacun (Cailhol et al. 2019, section 6.1).</translation>
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
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Geometry, places and semantics (GTS): the object goes through the passages that it fits best, and takes the next best path where one fails.</source>
        <translation>Géométrie, lieux et sémantique (GTS)&#xa0;: l&apos;objet prend les passages qui lui conviennent le mieux, et le meilleur chemin suivant quand l&apos;un échoue.</translation>
    </message>
    <message>
        <source>The rules of the scenario.</source>
        <translation>Les règles du scénario.</translation>
    </message>
    <message>
        <source>Linear interpolation</source>
        <translation>Interpolation linéaire</translation>
    </message>
    <message>
        <source>The straight motion, where it is free.</source>
        <translation>Le mouvement rectiligne, là où il est libre.</translation>
    </message>
    <message>
        <source>RRT</source>
        <translation>RRT</translation>
    </message>
    <message>
        <source>One tree (LaValle 1998).</source>
        <translation>Un seul arbre (LaValle 1998).</translation>
    </message>
    <message>
        <source>Potential field</source>
        <translation>Champ de potentiel</translation>
    </message>
    <message>
        <source>Down the slope to the goal (Khatib 1985).</source>
        <translation>Descente du gradient vers le but (Khatib 1985).</translation>
    </message>
    <message>
        <source>strategy G found no path within its limit of samples</source>
        <translation>la stratégie G n&apos;a trouvé aucun chemin dans sa limite d&apos;échantillons</translation>
    </message>
    <message>
        <source>Raise --global-samples, or use the strategy Layers (gts).</source>
        <translation>Augmentez --global-samples, ou prenez la stratégie Couches (gts).</translation>
    </message>
    <message>
        <source>the object is in the thread of %1, which would turn with it</source>
        <translation>l&apos;objet est dans le filetage de %1, qui tournerait avec lui</translation>
    </message>
    <message>
        <source>the object is in the threads of %1, which cannot be unscrewed at the same time: their axes or pitches differ</source>
        <translation>l&apos;objet est dans les filetages de %1, qui ne peuvent pas être dévissés en même temps&#xa0;: leurs axes ou leurs pas diffèrent</translation>
    </message>
    <message>
        <source>it has no room</source>
        <translation>il n&apos;a pas la place</translation>
    </message>
    <message>
        <source>%1 is in the way</source>
        <translation>%1 fait obstacle</translation>
    </message>
    <message>
        <source>the object cannot be unscrewed from %1, because %2</source>
        <translation>l&apos;objet ne peut pas être dévissé de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Remove what is named first, or change the thread.</source>
        <translation>Retirez d&apos;abord ce qui est nommé, ou changez le filetage.</translation>
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
        <source>fill the same place (%1 % of the larger one): they may be variants of one part</source>
        <translation>remplissent la même place (%1 % du plus grand)&#xa0;: ce sont peut-être des variantes d&apos;une même pièce</translation>
    </message>
    <message>
        <source>Exclude one (--without %1).</source>
        <translation>Excluez-en un (--without %1).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names a standard that is not known</source>
        <translation>«&#xa0;%1&#xa0;» nomme une norme inconnue</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no designation of a standard part that is known</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est la désignation d&apos;aucune pièce normalisée connue</translation>
    </message>
    <message>
        <source>Give one as &apos;ISO 4762 M3x8&apos;, &apos;DIN 934 M5&apos; or &apos;M3x8 SHCS&apos;.</source>
        <translation>Donnez-la comme «&#xa0;ISO 4762 M3x8&#xa0;», «&#xa0;DIN 934 M5&#xa0;» ou «&#xa0;M3x8 SHCS&#xa0;».</translation>
    </message>
    <message>
        <source>screw</source>
        <translation>vis</translation>
    </message>
    <message>
        <source>set screw</source>
        <translation>vis sans tête</translation>
    </message>
    <message>
        <source>nut</source>
        <translation>écrou</translation>
    </message>
    <message>
        <source>washer</source>
        <translation>rondelle</translation>
    </message>
    <message>
        <source>insert</source>
        <translation>insert</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>goupille</translation>
    </message>
    <message>
        <source>bearing</source>
        <translation>roulement</translation>
    </message>
    <message>
        <source>retaining ring</source>
        <translation>anneau élastique</translation>
    </message>
    <message>
        <source>belt</source>
        <translation>courroie</translation>
    </message>
    <message>
        <source>seal</source>
        <translation>joint d&apos;étanchéité</translation>
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
        <source>press</source>
        <translation>serrage</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>contact</translation>
    </message>
    <message>
        <source>%1, %2 in the tapped hole of %3 (%4)</source>
        <translation>%1, %2 dans le trou taraudé de %3 (%4)</translation>
    </message>
    <message>
        <source>%1, %2 in the hole of %3 (%4)</source>
        <translation>%1, %2 dans le trou de %3 (%4)</translation>
    </message>
    <message>
        <source>%1, %2 on the thread of %3 (%4)</source>
        <translation>%1, %2 sur le filetage de %3 (%4)</translation>
    </message>
    <message>
        <source>%1, %2 on the shaft of %3 (%4)</source>
        <translation>%1, %2 sur l&apos;arbre de %3 (%4)</translation>
    </message>
    <message>
        <source>%1, %2 on %3 (%4)</source>
        <translation>%1, %2 face à %3 (%4)</translation>
    </message>
    <message>
        <source>%1 without what overlaps %2, up to %3 deep (accepted clash)</source>
        <translation>%1 sans ce qui recouvre %2, jusqu&apos;à %3 de profondeur (interférence acceptée)</translation>
    </message>
    <message>
        <source>%1, user-defined</source>
        <translation>%1, défini par l&apos;utilisateur</translation>
    </message>
    <message>
        <source>%1, pitch %2</source>
        <translation>%1, pas %2</translation>
    </message>
    <message>
        <source>%1, pitch %2 (ISO coarse, %3)</source>
        <translation>%1, pas %2 (pas gros ISO, %3)</translation>
    </message>
    <message>
        <source>%1, %2 {2|turn|turns}</source>
        <translation>%1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>need an allowance of %1, which the local thickness or the shape of neither gives: it counts as a clash</source>
        <translation>demandent un amincissement de %1, ce que ni leur épaisseur locale ni leur forme ne permettent&#xa0;: c&apos;est une interférence</translation>
    </message>
    <message>
        <source>need an allowance of %1, which the local thickness or the shape of neither gives, and the surface of one is open %2 from the contact, so that what is inside it there is not known: it counts as a clash</source>
        <translation>demandent un amincissement de %1, ce que ni leur épaisseur locale ni leur forme ne permettent, et la surface de l&apos;un est ouverte à %2 du contact, de sorte que son intérieur n&apos;y est pas connu&#xa0;: c&apos;est une interférence</translation>
    </message>
    <message>
        <source>touch where neither can have an allowance: the surfaces are open %1 and %2 from the contact, so that what is inside them there is not known</source>
        <translation>se touchent là où aucun des deux ne peut avoir d&apos;amincissement&#xa0;: leurs surfaces sont ouvertes à %1 et %2 du contact, et l&apos;intérieur n&apos;y est donc pas connu</translation>
    </message>
    <message>
        <source>was stopped while fits were searched</source>
        <translation>a été arrêté pendant la recherche des ajustements</translation>
    </message>
    <message>
        <source>overlap by %1 without being a fit, a thread or a press</source>
        <translation>se recouvrent de %1 sans être ni un ajustement, ni un filetage, ni un serrage</translation>
    </message>
    <message>
        <source>Mend the parts, or say what kind of fit they are.</source>
        <translation>Corrigez les pièces, ou dites quel type d&apos;ajustement elles forment.</translation>
    </message>
    <message>
        <source>%1 more {1|pair overlaps|pairs overlap} in the same way</source>
        <translation>%1 {1|autre paire se recouvre|autres paires se recouvrent} de la même façon</translation>
    </message>
    <message>
        <source>See &apos;glissade-cli fits&apos; for all of them.</source>
        <translation>Voyez «&#xa0;glissade-cli fits&#xa0;» pour les connaître toutes.</translation>
    </message>
    <message>
        <source>dissolved</source>
        <translation>supprimée</translation>
    </message>
    <message>
        <source>there is no body &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de corps &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Name bodies by the ids that &apos;joints --json&apos; prints.</source>
        <translation>Nommez les corps par les identifiants que &apos;joints --json&apos; affiche.</translation>
    </message>
    <message>
        <source>it names a body twice</source>
        <translation>elle nomme deux fois un corps</translation>
    </message>
    <message>
        <source>Name each body of a joint once.</source>
        <translation>Nommez une seule fois chaque corps d&apos;une liaison.</translation>
    </message>
    <message>
        <source>there is no such joint that could be %1</source>
        <translation>il n&apos;y a pas de telle liaison qui puisse être %1</translation>
    </message>
    <message>
        <source>&apos;glissade-cli joints&apos; lists those that are found; &apos;made&apos; makes one.</source>
        <translation>«&#xa0;glissade-cli joints&#xa0;» énumère celles qui sont trouvées&#xa0;; «&#xa0;made&#xa0;» en crée une.</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>confirmée</translation>
    </message>
    <message>
        <source>only an insert is pressed out</source>
        <translation>seul un insert se chasse</translation>
    </message>
    <message>
        <source>Dissolve the joint, or say &apos;opened&apos; of a unit.</source>
        <translation>Supprimez la liaison, ou dites &apos;opened&apos; d&apos;une unité.</translation>
    </message>
    <message>
        <source>pressed out</source>
        <translation>chassée</translation>
    </message>
    <message>
        <source>the user has it pressed out</source>
        <translation>l&apos;utilisateur le fait chasser</translation>
    </message>
    <message>
        <source>only a unit is opened</source>
        <translation>seule une unité s&apos;ouvre</translation>
    </message>
    <message>
        <source>Dissolve the joint.</source>
        <translation>Supprimez la liaison.</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>it has one body only</source>
        <translation>elle n&apos;a qu&apos;un corps</translation>
    </message>
    <message>
        <source>Name what it is joined with in &apos;others&apos;.</source>
        <translation>Nommez dans &apos;others&apos; ce à quoi il est lié.</translation>
    </message>
    <message>
        <source>its thread is not stated</source>
        <translation>son filetage n&apos;est pas indiqué</translation>
    </message>
    <message>
        <source>Give &apos;thread&apos; with diameter, pitch and engaged length.</source>
        <translation>Donnez &apos;thread&apos; avec le diamètre, le pas et la longueur engagée.</translation>
    </message>
    <message>
        <source>user-defined</source>
        <translation>défini par l&apos;utilisateur</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is far from &apos;%2&apos;</source>
        <translation>&apos;%1&apos; est loin de &apos;%2&apos;</translation>
    </message>
    <message>
        <source>Join bodies that touch, or nearly do.</source>
        <translation>Liez des corps qui se touchent, ou presque.</translation>
    </message>
    <message>
        <source>only a snap bends</source>
        <translation>seul un clip fléchit</translation>
    </message>
    <message>
        <source>Remove &apos;bend_m&apos;.</source>
        <translation>Supprimez &apos;bend_m&apos;.</translation>
    </message>
    <message>
        <source>a hook does not bend by %1</source>
        <translation>un crochet ne fléchit pas de %1</translation>
    </message>
    <message>
        <source>Give 0 to %1 for this body.</source>
        <translation>Donnez de 0 à %1 pour ce corps.</translation>
    </message>
    <message>
        <source>screw of %1</source>
        <translation>vis de %1</translation>
    </message>
    <message>
        <source>nut of %1</source>
        <translation>écrou de %1</translation>
    </message>
    <message>
        <source>thread of %1</source>
        <translation>filetage de %1</translation>
    </message>
    <message>
        <source>insert of %1</source>
        <translation>insert de %1</translation>
    </message>
    <message>
        <source>pin of %1</source>
        <translation>goupille de %1</translation>
    </message>
    <message>
        <source>snap of %1</source>
        <translation>clip de %1</translation>
    </message>
    <message>
        <source>flexible of %1</source>
        <translation>liaison souple de %1</translation>
    </message>
    <message>
        <source>permanent of %1</source>
        <translation>liaison permanente de %1</translation>
    </message>
    <message>
        <source>unit of %1</source>
        <translation>unité de %1</translation>
    </message>
    <message>
        <source>joints hold each other in a circle: %1</source>
        <translation>des liaisons se tiennent en cercle&#xa0;: %1</translation>
    </message>
    <message>
        <source>Dissolve or change one of them.</source>
        <translation>Supprimez ou changez l&apos;une d&apos;elles.</translation>
    </message>
    <message>
        <source>the name says a thread of %1, the shape is %2</source>
        <translation>le nom dit un filetage de %1, la forme a %2</translation>
    </message>
    <message>
        <source>the name says a left-hand thread, the shape is a right-hand one</source>
        <translation>le nom indique un filetage à gauche, la forme est à droite</translation>
    </message>
    <message>
        <source>the name says a left-hand thread</source>
        <translation>le nom indique un filetage à gauche</translation>
    </message>
    <message>
        <source>the drive is that of the name</source>
        <translation>l&apos;empreinte est celle du nom</translation>
    </message>
    <message>
        <source>the name says the drive &apos;%1&apos;, the shape is &apos;%2&apos;</source>
        <translation>le nom dit l&apos;empreinte «&#xa0;%1&#xa0;», la forme a «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>the name says a drive of %1, the shape has %2</source>
        <translation>le nom dit une empreinte de %1, la forme a %2</translation>
    </message>
    <message>
        <source>the name says &apos;%1&apos;</source>
        <translation>le nom dit «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the head has the proportions of ISO 4762</source>
        <translation>la tête a les proportions de l&apos;ISO 4762</translation>
    </message>
    <message>
        <source>the sizes do not agree: a shaft of %1 in a nut %2</source>
        <translation>les tailles ne concordent pas&#xa0;: un arbre de %1 dans un écrou %2</translation>
    </message>
    <message>
        <source>the shaft is thicker than the hole</source>
        <translation>l&apos;arbre est plus gros que le trou</translation>
    </message>
    <message>
        <source>the name says that it is a nut</source>
        <translation>le nom dit que c&apos;est un écrou</translation>
    </message>
    <message>
        <source>it has the width of a nut %1</source>
        <translation>il a la largeur d&apos;un écrou %1</translation>
    </message>
    <message>
        <source>allows for &apos;%1&apos; and &apos;%2&apos;, which do not touch where they are assembled</source>
        <translation>donne un amincissement à «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;», qui ne se touchent pas en position assemblée</translation>
    </message>
    <message>
        <source>Remove the allowance.</source>
        <translation>Supprimez l&apos;amincissement.</translation>
    </message>
    <message>
        <source>allows %1, more than the thickness of &apos;%2&apos; or of &apos;%3&apos; gives</source>
        <translation>admet %1, plus que n&apos;en permet l&apos;épaisseur de «&#xa0;%2&#xa0;» ou de «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>Give at most %1.</source>
        <translation>Donnez au plus %1.</translation>
    </message>
    <message>
        <source>calls &apos;%1&apos; and &apos;%2&apos; a thread, but no shaft of the one is on the axis of a hole of the other</source>
        <translation>donne «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» pour un filetage, mais aucun arbre de l&apos;un n&apos;est sur l&apos;axe d&apos;un trou de l&apos;autre</translation>
    </message>
    <message>
        <source>Give another kind.</source>
        <translation>Donnez un autre type.</translation>
    </message>
    <message>
        <source>overlap by %1, and which of the two is cut is not clear</source>
        <translation>se recouvrent de %1, et on ne sait pas lequel des deux est découpé</translation>
    </message>
    <message>
        <source>overlap by %1, and neither can be cut and stay in one piece</source>
        <translation>se recouvrent de %1, et aucun des deux ne peut être découpé et rester d&apos;un seul tenant</translation>
    </message>
    <message>
        <source>Mend the parts.</source>
        <translation>Corrigez les pièces.</translation>
    </message>
    <message>
        <source>overlap by %1, because the insert is pressed or melted in</source>
        <translation>se recouvrent de %1, car l&apos;insert est emmanché ou fondu dans la pièce</translation>
    </message>
    <message>
        <source>It is removed with its host. To press it out, accept the clash (--accept-clashes %1) and state this for the joint.</source>
        <translation>Il se démonte avec sa pièce. Pour le chasser, acceptez l&apos;interférence (--accept-clashes %1) et indiquez-le pour la liaison.</translation>
    </message>
    <message>
        <source>overlap by %1, which is a clash</source>
        <translation>se recouvrent de %1, ce qui est une interférence</translation>
    </message>
    <message>
        <source>Accept it (--accept-clashes %1), or mend the parts.</source>
        <translation>Acceptez-la (--accept-clashes %1), ou corrigez les pièces.</translation>
    </message>
    <message>
        <source>Close the surface of one of them.</source>
        <translation>Fermez la surface de l&apos;un des deux.</translation>
    </message>
    <message>
        <source>a ring in a hole</source>
        <translation>une bague dans un trou</translation>
    </message>
    <message>
        <source>a thread is in it</source>
        <translation>un filetage s&apos;y trouve</translation>
    </message>
    <message>
        <source>a pin in a hole</source>
        <translation>une goupille dans un trou</translation>
    </message>
    <message>
        <source>it is thicker by as much as a thread</source>
        <translation>il est plus gros d&apos;autant qu&apos;un filetage</translation>
    </message>
    <message>
        <source>a shaft of %1 in a hole</source>
        <translation>un arbre de %1 dans un trou</translation>
    </message>
    <message>
        <source>it is %1 thicker than its hole</source>
        <translation>plus gros de %1 que son trou</translation>
    </message>
    <message>
        <source>it is as wide as its hole</source>
        <translation>aussi large que son trou</translation>
    </message>
    <message>
        <source>two rings with %1 balls between them</source>
        <translation>deux bagues séparées par %1 billes</translation>
    </message>
    <message>
        <source>two rings with %1 rollers between them</source>
        <translation>deux bagues séparées par %1 rouleaux</translation>
    </message>
    <message>
        <source>a helix is modelled on it</source>
        <translation>une hélice y est modélisée</translation>
    </message>
    <message>
        <source>the assembly is called &apos;%1&apos;</source>
        <translation>l&apos;assemblage s&apos;appelle «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>its class is &apos;%1&apos;</source>
        <translation>sa classe est «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>it is a ring of round section</source>
        <translation>c&apos;est un anneau de section ronde</translation>
    </message>
    <message>
        <source>its hooks bend by %1 when it is removed along a line</source>
        <translation>ses crochets fléchissent de %1 quand il est démonté en ligne droite</translation>
    </message>
    <message>
        <source>a nut is on the shaft</source>
        <translation>un écrou est sur l&apos;arbre</translation>
    </message>
    <message>
        <source>the hole is as wide as the shaft, and the farthest from the head</source>
        <translation>le trou est aussi large que l&apos;arbre, et le plus éloigné de la tête</translation>
    </message>
    <message>
        <source>the hole is the narrowest, and the farthest from the head</source>
        <translation>le trou est le plus étroit, et le plus éloigné de la tête</translation>
    </message>
    <message>
        <source>a shaft of %1 with a head</source>
        <translation>un arbre de %1 avec une tête</translation>
    </message>
    <message>
        <source>a shaft of %1 with a recess</source>
        <translation>un arbre de %1 avec une empreinte</translation>
    </message>
    <message>
        <source>the file has no hole there, so the screw makes it</source>
        <translation>le fichier n&apos;a pas de trou à cet endroit&#xa0;: la vis le fait</translation>
    </message>
    <message>
        <source>the nut is free to be turned</source>
        <translation>l&apos;écrou peut tourner librement</translation>
    </message>
    <message>
        <source>a nut with a hole of %1</source>
        <translation>un écrou avec un trou de %1</translation>
    </message>
    <message>
        <source>a shaft of %1 is %2 thicker than the hole around it, as a thread is</source>
        <translation>un arbre de %1, plus gros de %2 que le trou qui l&apos;entoure, comme un filetage</translation>
    </message>
    <message>
        <source>neither body is a screw or a nut by its shape</source>
        <translation>aucun des deux corps n&apos;a la forme d&apos;une vis ou d&apos;un écrou</translation>
    </message>
    <message>
        <source>there is no such body</source>
        <translation>ce corps n&apos;existe pas</translation>
    </message>
    <message>
        <source>this is not a position in space</source>
        <translation>ce n&apos;est pas une position dans l&apos;espace</translation>
    </message>
    <message>
        <source>Give finite numbers.</source>
        <translation>Donnez des nombres finis.</translation>
    </message>
    <message>
        <source>is the moving part</source>
        <translation>est la pièce manipulée</translation>
    </message>
    <message>
        <source>Choose another object first.</source>
        <translation>Choisissez d&apos;abord un autre objet.</translation>
    </message>
    <message>
        <source>the goal is &quot;removed&quot;, which has no position</source>
        <translation>le but est «&#xa0;démonté&#xa0;», qui n&apos;a pas de position</translation>
    </message>
    <message>
        <source>Give the goal a position first.</source>
        <translation>Donnez d&apos;abord une position au but.</translation>
    </message>
    <message>
        <source>no body is selected</source>
        <translation>aucun corps n&apos;est sélectionné</translation>
    </message>
    <message>
        <source>Select the moving part.</source>
        <translation>Sélectionnez la pièce manipulée.</translation>
    </message>
    <message>
        <source>this is the object already</source>
        <translation>c&apos;est déjà l&apos;objet</translation>
    </message>
    <message>
        <source>Choose other bodies.</source>
        <translation>Choisissez d&apos;autres corps.</translation>
    </message>
    <message>
        <source>Edits are not saved automatically.</source>
        <translation>Les modifications ne sont pas enregistrées automatiquement.</translation>
    </message>
    <message>
        <source>the new file cannot be locked</source>
        <translation>le nouveau fichier ne peut pas être verrouillé</translation>
    </message>
    <message>
        <source>The edits cannot be restored.</source>
        <translation>Les modifications ne peuvent pas être rétablies.</translation>
    </message>
    <message>
        <source>is not unsaved edits of Glissade</source>
        <translation>n&apos;est pas un fichier de modifications non enregistrées de Glissade</translation>
    </message>
    <message>
        <source>Give planar, cylindrical, thread, press, overlap, contact or clash.</source>
        <translation>Donnez planar, cylindrical, thread, press, overlap, contact ou clash.</translation>
    </message>
    <message>
        <source>has no effect, because the pair is not marked as a thread</source>
        <translation>n&apos;a pas d&apos;effet, car la paire n&apos;est pas marquée comme filetage</translation>
    </message>
    <message>
        <source>Add &quot;kind&quot;: &quot;thread&quot;, or remove it.</source>
        <translation>Ajoutez &quot;kind&quot;: &quot;thread&quot;, ou supprimez-le.</translation>
    </message>
    <message>
        <source>Name the body that is turned.</source>
        <translation>Nommez le corps que l&apos;on tourne.</translation>
    </message>
    <message>
        <source>is missing, so that the file does not say where the forbidden places are</source>
        <translation>manque, si bien que le fichier ne dit pas où sont les lieux interdits</translation>
    </message>
    <message>
        <source>is not where the forbidden places are</source>
        <translation>n&apos;est pas là où sont les lieux interdits</translation>
    </message>
    <message>
        <source>Write it with glissade-cli info --save-regions, or save the scenario in the window.</source>
        <translation>Écrivez-le avec glissade-cli info --save-regions, ou enregistrez le scénario dans la fenêtre.</translation>
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
        <source>is several parts in one body of the scenario, of which &apos;%1&apos; cannot be moved alone</source>
        <translation>est fait de plusieurs pièces en un seul corps du scénario, dont «&#xa0;%1&#xa0;» ne peut pas être déplacée seule</translation>
    </message>
    <message>
        <source>Make a scenario that has each part as a body: New from parts does so with STEP files.</source>
        <translation>Faites un scénario où chaque pièce est un corps&#xa0;: Nouveau à partir de pièces le fait pour les fichiers STEP.</translation>
    </message>
    <message>
        <source>has no length</source>
        <translation>n&apos;a pas de longueur</translation>
    </message>
    <message>
        <source>Give a direction, as [0, 0, 1].</source>
        <translation>Donnez une direction, par exemple [0, 0, 1].</translation>
    </message>
    <message>
        <source>has no effect, because the joint is not confirmed</source>
        <translation>n&apos;a pas d&apos;effet, car la liaison n&apos;est pas confirmée</translation>
    </message>
    <message>
        <source>Remove it, or say &quot;confirmed&quot;.</source>
        <translation>Supprimez-le, ou dites &quot;confirmed&quot;.</translation>
    </message>
    <message>
        <source>is about a joint that was there before</source>
        <translation>concerne une liaison déjà donnée</translation>
    </message>
    <message>
        <source>is the name of a path before it</source>
        <translation>est déjà le nom d&apos;un chemin précédent</translation>
    </message>
    <message>
        <source>Give every path a name of its own.</source>
        <translation>Donnez à chaque chemin un nom différent.</translation>
    </message>
    <message>
        <source>there is no part</source>
        <translation>il n&apos;y a aucune pièce</translation>
    </message>
    <message>
        <source>Give the files of the parts.</source>
        <translation>Donnez les fichiers des pièces.</translation>
    </message>
    <message>
        <source>has a unit that is not from 1e-12 m to 1e9 m</source>
        <translation>a une unité qui n&apos;est pas entre 1e-12 m et 1e9 m</translation>
    </message>
    <message>
        <source>Give the metres in a unit of the file.</source>
        <translation>Donnez la valeur en mètres d&apos;une unité du fichier.</translation>
    </message>
    <message>
        <source>no part is the moving part</source>
        <translation>aucune pièce n&apos;est la pièce manipulée</translation>
    </message>
    <message>
        <source>Choose the moving part.</source>
        <translation>Choisissez la pièce manipulée.</translation>
    </message>
    <message>
        <source>cannot be the moving part: the scenario has one</source>
        <translation>ne peut pas être la pièce manipulée&#xa0;: le scénario en a déjà une</translation>
    </message>
    <message>
        <source>Make it static or mobile.</source>
        <translation>Rendez-la statique ou mobile.</translation>
    </message>
    <message>
        <source>has no part that the scenario does not have</source>
        <translation>n&apos;a aucune pièce que le scénario n&apos;ait déjà</translation>
    </message>
    <message>
        <source>Name the part to have it twice.</source>
        <translation>Nommez la pièce pour l&apos;avoir deux fois.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>the path holds no configuration</source>
        <translation>le chemin ne contient aucune configuration</translation>
    </message>
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
    <message>
        <source>has no ending that says in which format the path is to be written</source>
        <translation>n&apos;a pas d&apos;extension qui indique le format du chemin</translation>
    </message>
    <message>
        <source>paths are not written as &apos;.%1&apos;</source>
        <translation>les chemins ne s&apos;écrivent pas en «&#xa0;.%1&#xa0;»</translation>
    </message>
    <message>
        <source>a position of the path is beyond single precision</source>
        <translation>une position du chemin dépasse la simple précision</translation>
    </message>
    <message>
        <source>is one too many: a path has at most %1 configurations</source>
        <translation>est de trop&#xa0;: un chemin a au plus %1 configurations</translation>
    </message>
    <message>
        <source>holds %1, which is not a finite number</source>
        <translation>contient %1, qui n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>holds %1, which is beyond 1e9 m</source>
        <translation>contient %1, qui dépasse 1e9 m</translation>
    </message>
    <message>
        <source>names an unknown author %1</source>
        <translation>nomme un auteur inconnu %1</translation>
    </message>
    <message>
        <source>is not &quot;%1&quot;</source>
        <translation>n&apos;est pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Give the path as one of: %1.</source>
        <translation>Donnez le chemin dans l&apos;un de ces formats&#xa0;: %1.</translation>
    </message>
    <message>
        <source>is about a product that has &apos;%1&apos;</source>
        <translation>concerne un produit qui a «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is about a product with other bodies</source>
        <translation>concerne un produit qui a d&apos;autres corps</translation>
    </message>
    <message>
        <source>Give the product that was planned.</source>
        <translation>Donnez le produit qui a été planifié.</translation>
    </message>
    <message>
        <source>a position of the plan is beyond single precision</source>
        <translation>une position du plan dépasse la simple précision</translation>
    </message>
    <message>
        <source>Export the plan as JSON.</source>
        <translation>Exportez le plan en JSON.</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>y est deux fois</translation>
    </message>
    <message>
        <source>is none of the plan&apos;s bodies</source>
        <translation>n&apos;est pas un corps du plan</translation>
    </message>
    <message>
        <source>is more than the steps before it</source>
        <translation>dépasse le nombre d&apos;étapes précédentes</translation>
    </message>
    <message>
        <source>Name the bodies that are removed.</source>
        <translation>Nommez les corps qui sont démontés.</translation>
    </message>
    <message>
        <source>is fixed as base, or was removed before</source>
        <translation>est fixé comme base, ou est déjà démonté</translation>
    </message>
    <message>
        <source>is not an earlier step</source>
        <translation>n&apos;est pas une étape précédente</translation>
    </message>
    <message>
        <source>is without a pitch</source>
        <translation>n&apos;a pas de pas de filetage</translation>
    </message>
    <message>
        <source>is fixed as base, or was removed</source>
        <translation>est fixé comme base, ou est démonté</translation>
    </message>
    <message>
        <source>is not a step before it</source>
        <translation>n&apos;est pas une étape qui le précède</translation>
    </message>
    <message>
        <source>is a scenario, which states the mesh tolerance of each of its assets</source>
        <translation>est un scénario, qui donne lui-même la tolérance de maillage de chacun de ses assets</translation>
    </message>
    <message>
        <source>Change &quot;deflection&quot; of the asset there, or give the part file.</source>
        <translation>Changez-y «&#xa0;deflection&#xa0;» de l&apos;asset, ou donnez le fichier de la pièce.</translation>
    </message>
    <message>
        <source>is a scenario, which says itself which bodies it has</source>
        <translation>est un scénario, qui indique lui-même ses corps</translation>
    </message>
    <message>
        <source>Name the solids when it is made: glissade-cli new OUT.json --static FILE:PART/SOLID --static FILE.</source>
        <translation>Nommez les solides à sa création&#xa0;: glissade-cli new OUT.json --static FICHIER:PIÈCE/SOLIDE --static FICHIER.</translation>
    </message>
    <message>
        <source>is damaged, and names the scenario and the settings of the run</source>
        <translation>est endommagée, alors qu&apos;elle nomme le scénario et les réglages du calcul</translation>
    </message>
    <message>
        <source>Use an undamaged copy.</source>
        <translation>Utilisez une copie intacte.</translation>
    </message>
    <message>
        <source>the folder refuses a new file</source>
        <translation>le dossier refuse un nouveau fichier</translation>
    </message>
    <message>
        <source>cannot be locked</source>
        <translation>ne peut pas être verrouillé</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>ne peut pas être écrit</translation>
    </message>
    <message>
        <source>Use an undamaged copy. To replay an edited recording, remove its checksum.</source>
        <translation>Utilisez une copie intacte. Pour rejouer un enregistrement modifié, supprimez sa somme de contrôle.</translation>
    </message>
    <message>
        <source>is damaged: %1 {1|line of the journal is|lines of the journal are} lost</source>
        <translation>est endommagé&#xa0;: %1 {1|ligne du journal est perdue|lignes du journal sont perdues}</translation>
    </message>
    <message>
        <source>Nothing is missing until step %1; the replay may differ from the run after it.</source>
        <translation>Rien ne manque jusqu&apos;au pas %1&#xa0;; ensuite la relecture peut différer du calcul.</translation>
    </message>
    <message>
        <source>Name the scenario that the run was recorded on, as it was then.</source>
        <translation>Donnez le scénario sur lequel le calcul a été enregistré, tel qu&apos;il était alors.</translation>
    </message>
    <message>
        <source>the run was recorded on another scenario than &apos;%1&apos;</source>
        <translation>le calcul a été enregistré sur un autre scénario que «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the asset &apos;%1&apos; has changed since the run was recorded</source>
        <translation>l&apos;asset «&#xa0;%1&#xa0;» a changé depuis l&apos;enregistrement du calcul</translation>
    </message>
    <message>
        <source>Replay it with the Glissade that recorded it: %1.</source>
        <translation>Rejouez-le avec la version de Glissade qui l&apos;a enregistré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>comes before the step above it</source>
        <translation>vient avant le pas qui le précède</translation>
    </message>
    <message>
        <source>is not a number of 16 hexadecimal digits</source>
        <translation>n&apos;est pas un nombre de 16 chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>is neither [step] nor [step, x, y, z, qx, qy, qz, qw]</source>
        <translation>n&apos;est ni [step] ni [step, x, y, z, qx, qy, qz, qw]</translation>
    </message>
    <message>
        <source>holds no unit quaternion</source>
        <translation>ne contient pas de quaternion unitaire</translation>
    </message>
    <message>
        <source>comes before the last checkpoint</source>
        <translation>vient avant le dernier point de contrôle</translation>
    </message>
    <message>
        <source>Check its pose, its size and the unit of its file.</source>
        <translation>Vérifiez sa pose, sa taille et l&apos;unité de son fichier.</translation>
    </message>
    <message>
        <source>reaches %1 m from the world&apos;s origin, beyond 1e9 m</source>
        <translation>s&apos;étend à %1 m de l&apos;origine du monde, au-delà de 1e9 m</translation>
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
        <source>has a radius of %1 m, which is not from 1e-12 m to 1e9 m</source>
        <translation>a un rayon de %1 m, qui n&apos;est pas entre 1e-12 m et 1e9 m</translation>
    </message>
    <message>
        <source>is more than 1e10 times as large as the object</source>
        <translation>est plus de 1e10 fois plus grand que l&apos;objet</translation>
    </message>
    <message>
        <source>Check the units of both, or give a smaller workspace.</source>
        <translation>Vérifiez les unités des deux, ou donnez un espace de travail plus petit.</translation>
    </message>
    <message>
        <source>excludes bodies: %1</source>
        <translation>exclut des corps&#xa0;: %1</translation>
    </message>
    <message>
        <source>Certificates are about the product without them.</source>
        <translation>Les certificats portent sur le produit sans eux.</translation>
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
        <source>Say all of a node at one place.</source>
        <translation>Dites tout d&apos;un nœud au même endroit.</translation>
    </message>
    <message>
        <source>is neither a body nor an assembly of this product</source>
        <translation>n&apos;est ni un corps ni un assemblage de ce produit</translation>
    </message>
    <message>
        <source>is about a body, which has its attributes itself</source>
        <translation>concerne un corps, qui porte lui-même ses attributs</translation>
    </message>
    <message>
        <source>Write them there.</source>
        <translation>Écrivez-les là.</translation>
    </message>
    <message>
        <source>is no assembly that the node can be in</source>
        <translation>n&apos;est pas un assemblage qui puisse contenir le nœud</translation>
    </message>
    <message>
        <source>Name an assembly that is not below it.</source>
        <translation>Nommez un assemblage qui n&apos;en dépend pas.</translation>
    </message>
    <message>
        <source>is not a colour: three numbers from 0 to 1</source>
        <translation>n&apos;est pas une couleur&#xa0;: trois nombres de 0 à 1</translation>
    </message>
    <message>
        <source>Add the asset.</source>
        <translation>Ajoutez l&apos;asset.</translation>
    </message>
    <message>
        <source>is for mesh files only</source>
        <translation>ne vaut que pour les fichiers de maillage</translation>
    </message>
    <message>
        <source>is said twice: there is &apos;centre_on_vertex_mean&apos;</source>
        <translation>est dit deux fois&#xa0;: il y a «&#xa0;centre_on_vertex_mean&#xa0;»</translation>
    </message>
    <message>
        <source>is not beside &apos;centre_on_vertex_mean&apos;</source>
        <translation>ne se met pas à côté de &apos;centre_on_vertex_mean&apos;</translation>
    </message>
    <message>
        <source>Remove it, or see &apos;glissade-cli plan --help&apos;.</source>
        <translation>Supprimez-le, ou voyez «&#xa0;glissade-cli plan --help&#xa0;».</translation>
    </message>
    <message>
        <source>Give every one an id of its own.</source>
        <translation>Donnez à chacun un identifiant différent.</translation>
    </message>
    <message>
        <source>is version %1; this program reads up to version %2</source>
        <translation>est de la version %1&#xa0;; ce programme lit jusqu&apos;à la version %2</translation>
    </message>
    <message>
        <source>is not a box</source>
        <translation>n&apos;est pas une boîte</translation>
    </message>
    <message>
        <source>Give six coordinates: the least x, y and z, then the largest.</source>
        <translation>Donnez six coordonnées&#xa0;: les plus petits x, y et z, puis les plus grands.</translation>
    </message>
    <message>
        <source>Give metres, or 0 for as fine as the memory allows.</source>
        <translation>Donnez des mètres, ou 0 pour la plus grande finesse que permet la mémoire.</translation>
    </message>
    <message>
        <source>names no way to find places</source>
        <translation>ne nomme aucune méthode de recherche des lieux</translation>
    </message>
    <message>
        <source>Give region-growing or watershed.</source>
        <translation>Donnez region-growing ou watershed.</translation>
    </message>
    <message>
        <source>is not two texts</source>
        <translation>n&apos;est pas fait de deux textes</translation>
    </message>
    <message>
        <source>names a fastener that is not one of: %1</source>
        <translation>nomme une fixation qui n&apos;est pas l&apos;une de&#xa0;: %1</translation>
    </message>
    <message>
        <source>is not 1 or more</source>
        <translation>n&apos;est pas au moins 1</translation>
    </message>
    <message>
        <source>the class of &apos;%1&apos; is &apos;%2&apos;, which is not a class of bodies</source>
        <translation>la classe de «&#xa0;%1&#xa0;» est «&#xa0;%2&#xa0;», qui n&apos;est pas une classe de corps</translation>
    </message>
    <message>
        <source>Choose one of %1, or add it under /sequence/classes.</source>
        <translation>Choisissez parmi %1, ou ajoutez-la sous /sequence/classes.</translation>
    </message>
    <message>
        <source>a swept volume is written as .stl or .glb</source>
        <translation>un volume balayé s&apos;écrit en .stl ou .glb</translation>
    </message>
    <message>
        <source>does not say its unit; its size is %1</source>
        <translation>ne dit pas son unité&#xa0;; sa taille est %1</translation>
    </message>
    <message>
        <source>it is taken in millimetres</source>
        <translation>il est pris en millimètres</translation>
    </message>
    <message>
        <source>it is taken in metres</source>
        <translation>il est pris en mètres</translation>
    </message>
    <message>
        <source>the size does not decide this</source>
        <translation>la taille ne permet pas d&apos;en décider</translation>
    </message>
    <message>
        <source>other files taken in the same way: %1</source>
        <translation>autres fichiers interprétés de la même façon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Give the unit: --unit 1mm, or --unit 1m.</source>
        <translation>Donnez l&apos;unité&#xa0;: --unit 1mm, ou --unit 1m.</translation>
    </message>
    <message>
        <source>Give the unit: --unit 1m, or --unit 1mm.</source>
        <translation>Donnez l&apos;unité&#xa0;: --unit 1m, ou --unit 1mm.</translation>
    </message>
    <message>
        <source>is not %1</source>
        <translation>n&apos;est pas %1</translation>
    </message>
    <message>
        <source>is no work time</source>
        <translation>n&apos;est pas un temps de travail</translation>
    </message>
    <message>
        <source>Take the names that &apos;times --write-table&apos; writes.</source>
        <translation>Prenez les noms qu&apos;écrit «&#xa0;times --write-table&#xa0;».</translation>
    </message>
    <message>
        <source>is not from 0 to %1</source>
        <translation>n&apos;est pas de 0 à %1</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>une droite</translation>
    </message>
    <message>
        <source>two lines</source>
        <translation>deux droites</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>une rotation</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>flexible</source>
        <translation>souple</translation>
    </message>
    <message>
        <source>the locked motion of &apos;%1&apos; uses the direction that is to be ruled out</source>
        <translation>le mouvement verrouillé de «&#xa0;%1&#xa0;» utilise la direction à interdire</translation>
    </message>
    <message>
        <source>this motion uses a direction you ruled out for &apos;%1&apos;</source>
        <translation>ce mouvement utilise une direction que vous avez interdite pour «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is to be removed before &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» doit être démonté avant «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Remove the earlier constraint, or omit the new one.</source>
        <translation>Supprimez la contrainte précédente, ou renoncez à la nouvelle.</translation>
    </message>
    <message>
        <source>of %1 mm</source>
        <translation>de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 screw</source>
        <translation>%1 vis</translation>
    </message>
    <message>
        <source>%1 screws</source>
        <translation>%1 vis</translation>
    </message>
    <message>
        <source>%1 screw %2</source>
        <translation>%1 vis %2</translation>
    </message>
    <message>
        <source>%1 screws %2</source>
        <translation>%1 vis %2</translation>
    </message>
    <message>
        <source>%1 nut</source>
        <translation>%1 écrou</translation>
    </message>
    <message>
        <source>%1 nuts</source>
        <translation>%1 écrous</translation>
    </message>
    <message>
        <source>%1 nut %2</source>
        <translation>%1 écrou %2</translation>
    </message>
    <message>
        <source>%1 nuts %2</source>
        <translation>%1 écrous %2</translation>
    </message>
    <message>
        <source>%1 thread</source>
        <translation>%1 filetage</translation>
    </message>
    <message>
        <source>%1 threads</source>
        <translation>%1 filetages</translation>
    </message>
    <message>
        <source>%1 thread %2</source>
        <translation>%1 filetage %2</translation>
    </message>
    <message>
        <source>%1 threads %2</source>
        <translation>%1 filetages %2</translation>
    </message>
    <message>
        <source>%1 flexible</source>
        <translation>%1 pièce souple</translation>
    </message>
    <message>
        <source>%1 flexibles</source>
        <translation>%1 pièces souples</translation>
    </message>
    <message>
        <source>%1 flexible %2</source>
        <translation>%1 pièce souple %2</translation>
    </message>
    <message>
        <source>%1 flexibles %2</source>
        <translation>%1 pièces souples %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>is not from 1 to %1</source>
        <translation>n&apos;est pas de 1 à %1</translation>
    </message>
    <message>
        <source>Give a number of stations in this range.</source>
        <translation>Donnez un nombre de postes dans ces limites.</translation>
    </message>
    <message>
        <source>of task %1 are below 0, or no number</source>
        <translation>de la tâche %1 sont inférieures à 0, ou ne sont pas un nombre</translation>
    </message>
    <message>
        <source>Give finite seconds, 0 or more.</source>
        <translation>Donnez des secondes finies, 0 ou plus.</translation>
    </message>
    <message>
        <source>names task %1, which is no earlier one, for task %2</source>
        <translation>cite la tâche %1, qui n&apos;est pas antérieure, pour la tâche %2</translation>
    </message>
    <message>
        <source>Number the tasks in an order that can be carried out.</source>
        <translation>Numérotez les tâches dans un ordre réalisable.</translation>
    </message>
    <message>
        <source>a constraint names &apos;%1&apos;, which is not a body of the product</source>
        <translation>une contrainte nomme «&#xa0;%1&#xa0;», qui n&apos;est pas un corps du produit</translation>
    </message>
    <message>
        <source>a constraint about a step names no body</source>
        <translation>une contrainte sur une étape ne nomme aucun corps</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is in two constrained steps or groups</source>
        <translation>«&#xa0;%1&#xa0;» est dans deux étapes ou groupes contraints</translation>
    </message>
    <message>
        <source>Name the same bodies in both, or remove one.</source>
        <translation>Nommez les mêmes corps dans les deux, ou supprimez-en un.</translation>
    </message>
    <message>
        <source>two steps are constrained to place %1</source>
        <translation>deux étapes sont contraintes à la place %1</translation>
    </message>
    <message>
        <source>Give each a place of its own, from 1.</source>
        <translation>Donnez à chacune sa propre place, à partir de 1.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is constrained to two places</source>
        <translation>«&#xa0;%1&#xa0;» est contraint à deux places</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Supprimez l&apos;une d&apos;elles.</translation>
    </message>
    <message>
        <source>a motion of a constraint has fewer than two configurations</source>
        <translation>un mouvement d&apos;une contrainte a moins de deux configurations</translation>
    </message>
    <message>
        <source>Give two configurations.</source>
        <translation>Donnez deux configurations.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is constrained to two motions</source>
        <translation>«&#xa0;%1&#xa0;» est contraint à deux mouvements</translation>
    </message>
    <message>
        <source>a direction that is ruled out for &apos;%1&apos; has no length</source>
        <translation>une direction interdite à «&#xa0;%1&#xa0;» est de longueur nulle</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is constrained to a motion in a direction that is ruled out for it</source>
        <translation>«&#xa0;%1&#xa0;» est contraint à un mouvement dans une direction qui lui est interdite</translation>
    </message>
    <message>
        <source>Remove one of the two constraints.</source>
        <translation>Supprimez l&apos;une des deux contraintes.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is in two groups that are to be removed together</source>
        <translation>«&#xa0;%1&#xa0;» est dans deux groupes à démonter ensemble</translation>
    </message>
    <message>
        <source>Name each body once.</source>
        <translation>Nommez chaque corps une seule fois.</translation>
    </message>
    <message>
        <source>the constraints on the order form a cycle</source>
        <translation>les contraintes sur l&apos;ordre forment un cycle</translation>
    </message>
    <message>
        <source>Fix another body as base, or remove the constraint.</source>
        <translation>Fixez un autre corps comme base, ou supprimez la contrainte.</translation>
    </message>
    <message>
        <source>Greedy</source>
        <translation>Gloutonne</translation>
    </message>
    <message>
        <source>Every part that can be removed is removed, the smallest first; the others are tried again when a part that blocks them was removed.</source>
        <translation>Toute pièce qui peut être démontée l&apos;est, la plus petite d&apos;abord&#xa0;; les autres sont réessayées quand une pièce qui les bloque est démontée.</translation>
    </message>
    <message>
        <source>Best first</source>
        <translation>Meilleur d&apos;abord</translation>
    </message>
    <message>
        <source>The motions of the greedy strategy in the order that costs least: length, changes of direction and of tools, bodies that would fall.</source>
        <translation>Les mouvements de la stratégie greedy dans l&apos;ordre le moins coûteux&#xa0;: longueur, changements de direction et d&apos;outil, corps qui tomberaient.</translation>
    </message>
    <message>
        <source>As a fitter would</source>
        <translation>Comme un monteur</translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation>Équilibré</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Stable</translation>
    </message>
    <message>
        <source>Few changes of tools</source>
        <translation>Peu de changements d&apos;outil</translation>
    </message>
    <message>
        <source>Short motions</source>
        <translation>Mouvements courts</translation>
    </message>
    <message>
        <source>Fragile parts removed first</source>
        <translation>Pièces fragiles démontées d&apos;abord</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Comme trouvé</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is one part of %2 solids that do not touch each other: split it (--open &quot;%3&quot;, or &quot;Split OBJ groups and solids&quot; in the list of parts)</source>
        <translation>«&#xa0;%1&#xa0;» est une pièce de %2 solides qui ne se touchent pas&#xa0;: divisez-la (--open &quot;%3&quot;, ou «&#xa0;Diviser groupes OBJ et solides&#xa0;» dans la liste des pièces)</translation>
    </message>
    <message>
        <source>a constraint states that &apos;%1&apos; is removed before</source>
        <translation>une contrainte énonce que «&#xa0;%1&#xa0;» est démonté avant</translation>
    </message>
    <message>
        <source>it and &apos;%1&apos; hold each other: no motion was found for either alone, nor for both as one; motions of several bodies at the same time are not searched</source>
        <translation>elle et «&#xa0;%1&#xa0;» se bloquent mutuellement&#xa0;: aucun mouvement n&apos;a été trouvé, ni pour l&apos;une seule, ni pour les deux ensemble&#xa0;; les mouvements simultanés de plusieurs corps ne sont pas cherchés</translation>
    </message>
    <message>
        <source>its motion by hand is not free</source>
        <translation>son mouvement fait à la main n&apos;est pas libre</translation>
    </message>
    <message>
        <source>no motion was found in a direction that is not ruled out</source>
        <translation>aucun mouvement n&apos;a été trouvé dans une direction permise</translation>
    </message>
    <message>
        <source>it is between parts that are pressed together: press one of them out</source>
        <translation>elle est entre des pièces emmanchées l&apos;une dans l&apos;autre : en chasser une</translation>
    </message>
    <message>
        <source>no motion was found, alone or with others</source>
        <translation>aucun mouvement n&apos;a été trouvé, ni seule ni avec d&apos;autres</translation>
    </message>
    <message>
        <source>held by %1: remove these first; &apos;%2&apos; is captive: &apos;%3&apos; is in its way</source>
        <translation>tenue par %1&#xa0;: retirez-les d&apos;abord&#xa0;; «&#xa0;%2&#xa0;» est imperdable&#xa0;: «&#xa0;%3&#xa0;» fait obstacle</translation>
    </message>
    <message>
        <source>held by %1: remove these first</source>
        <translation>tenue par %1&#xa0;: retirez-les d&apos;abord</translation>
    </message>
    <message>
        <source>it is held by %1 in &apos;%2&apos;, and cannot be unscrewed: clear the space, or dissolve the joint</source>
        <translation>elle est tenue par %1 dans «&#xa0;%2&#xa0;», et ne peut pas être dévissée&#xa0;: dégagez le passage, ou supprimez la liaison</translation>
    </message>
    <message>
        <source>it and &apos;%1&apos; clash where they are assembled: mend the parts, or accept the clash</source>
        <translation>elle et «&#xa0;%1&#xa0;» interfèrent à l’état assemblé&#xa0;: corrigez les pièces, ou acceptez l&apos;interférence</translation>
    </message>
    <message>
        <source>it and &apos;%1&apos; clash where they are assembled (%2): mend the parts, or accept the clash</source>
        <translation>elle et «&#xa0;%1&#xa0;» interfèrent à l’état assemblé (%2)&#xa0;: corrigez les pièces, ou acceptez l&apos;interférence</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs the tool &apos;%2&apos;, which is unknown</source>
        <translation>«&#xa0;%1&#xa0;» demande l&apos;outil «&#xa0;%2&#xa0;», qui est inconnu</translation>
    </message>
    <message>
        <source>a part is small below this length</source>
        <translation>une pièce est petite au-dessous de cette longueur</translation>
    </message>
    <message>
        <source>a part is large above this length</source>
        <translation>une pièce est grande au-dessus de cette longueur</translation>
    </message>
    <message>
        <source>a heavier part is handled as a large one</source>
        <translation>une pièce plus lourde est manipulée comme une grande</translation>
    </message>
    <message>
        <source>a heavier part needs a lifting aid</source>
        <translation>une pièce plus lourde demande une aide au levage</translation>
    </message>
    <message>
        <source>fetch a part</source>
        <translation>prendre une pièce</translation>
    </message>
    <message>
        <source>fetch a small part</source>
        <translation>prendre une petite pièce</translation>
    </message>
    <message>
        <source>fetch a large part with both hands</source>
        <translation>prendre une grande pièce à deux mains</translation>
    </message>
    <message>
        <source>fetch a part with a lifting aid</source>
        <translation>prendre une pièce avec une aide au levage</translation>
    </message>
    <message>
        <source>place a part along a straight path</source>
        <translation>poser une pièce par un chemin droit</translation>
    </message>
    <message>
        <source>place a part into a fit</source>
        <translation>poser une pièce dans un ajustement</translation>
    </message>
    <message>
        <source>place a part along a path with turns</source>
        <translation>poser une pièce par un chemin avec des virages</translation>
    </message>
    <message>
        <source>press a part into its seat</source>
        <translation>emmancher une pièce dans son logement</translation>
    </message>
    <message>
        <source>lay a flexible part on</source>
        <translation>poser une pièce souple</translation>
    </message>
    <message>
        <source>start a thread</source>
        <translation>engager un filetage</translation>
    </message>
    <message>
        <source>one turn with a powered tool</source>
        <translation>un tour avec un outil à moteur</translation>
    </message>
    <message>
        <source>one turn by hand or with an open wrench</source>
        <translation>un tour à la main ou avec une clé plate</translation>
    </message>
    <message>
        <source>take another tool</source>
        <translation>prendre un autre outil</translation>
    </message>
    <message>
        <source>hold one body meanwhile</source>
        <translation>tenir un corps pendant ce temps</translation>
    </message>
    <message>
        <source>planning</source>
        <translation>planification</translation>
    </message>
    <message>
        <source>device</source>
        <translation>le périphérique</translation>
    </message>
    <message>
        <source>Choose a device again.</source>
        <translation>Choisissez de nouveau un périphérique.</translation>
    </message>
    <message>
        <source>moving the object with the device</source>
        <translation>déplacement de l&apos;objet avec le périphérique</translation>
    </message>
    <message>
        <source>stopping the planner</source>
        <translation>arrêt du planificateur</translation>
    </message>
    <message>
        <source>Raise the limit (%1), steer the object yourself, or try another seed.</source>
        <translation>Augmentez la limite (%1), guidez l&apos;objet vous-même, ou essayez une autre graine.</translation>
    </message>
    <message>
        <source>starting the planner</source>
        <translation>démarrage du planificateur</translation>
    </message>
    <message>
        <source>smoothing the path</source>
        <translation>lissage du chemin</translation>
    </message>
    <message>
        <source>examining the path</source>
        <translation>examen du chemin</translation>
    </message>
    <message>
        <source>changing the settings of the run</source>
        <translation>changement des réglages du calcul</translation>
    </message>
    <message>
        <source>completing the roadmap</source>
        <translation>achèvement du graphe</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1, graine %2</translation>
    </message>
    <message>
        <source>Choose one of %1.</source>
        <translation>Choisissez parmi %1.</translation>
    </message>
    <message>
        <source>the path that was found leads through &apos;%1&apos;, which was forbidden meanwhile</source>
        <translation>le chemin trouvé passe par «&#xa0;%1&#xa0;», interdit entre-temps</translation>
    </message>
    <message>
        <source>the step limit of %1 was reached without a path</source>
        <translation>la limite de %1 pas a été atteinte sans chemin</translation>
    </message>
    <message>
        <source>the limit of %1 random configurations was reached without a path</source>
        <translation>la limite de %1 configurations aléatoires a été atteinte sans chemin</translation>
    </message>
    <message>
        <source>the time limit of %1 s was reached without a path</source>
        <translation>la limite de temps de %1 s a été atteinte sans chemin</translation>
    </message>
    <message>
        <source>publishing the roadmap</source>
        <translation>publication du graphe</translation>
    </message>
    <message>
        <source>Enlarge the workspace or move the start inside.</source>
        <translation>Agrandissez l&apos;espace de travail, ou placez-y le départ.</translation>
    </message>
    <message>
        <source>Allow the place again, or move the start out of it.</source>
        <translation>Autorisez de nouveau le lieu, ou déplacez le départ hors de celui-ci.</translation>
    </message>
    <message>
        <source>Move the start to a position clear of all bodies.</source>
        <translation>Placez le départ à l&apos;écart de tous les corps.</translation>
    </message>
    <message>
        <source>Move the start away or lower the required clearance.</source>
        <translation>Éloignez le départ, ou réduisez le jeu exigé.</translation>
    </message>
    <message>
        <source>Enlarge the workspace or move the goal inside.</source>
        <translation>Agrandissez l&apos;espace de travail, ou placez-y le but.</translation>
    </message>
    <message>
        <source>Allow the place again, or move the goal out of it.</source>
        <translation>Autorisez de nouveau le lieu, ou déplacez le but hors de celui-ci.</translation>
    </message>
    <message>
        <source>Move the goal to a position clear of all bodies.</source>
        <translation>Placez le but à l&apos;écart de tous les corps.</translation>
    </message>
    <message>
        <source>Move the goal away or lower the required clearance.</source>
        <translation>Éloignez le but, ou réduisez le jeu exigé.</translation>
    </message>
    <message>
        <source>the milestone is inside of &apos;%1&apos;, which is forbidden</source>
        <translation>le jalon est à l&apos;intérieur de «&#xa0;%1&#xa0;», qui est interdit</translation>
    </message>
    <message>
        <source>the reference point is inside of &apos;%1&apos;, which is forbidden</source>
        <translation>le point de référence est à l&apos;intérieur de «&#xa0;%1&#xa0;», qui est interdit</translation>
    </message>
    <message>
        <source>the milestone lies on the boundary of &apos;%1&apos;, which is forbidden, or within the margin of %2 m</source>
        <translation>le jalon est sur le bord de «&#xa0;%1&#xa0;», qui est interdit, ou dans la marge de %2 m</translation>
    </message>
    <message>
        <source>the reference point lies on the boundary of &apos;%1&apos;, which is forbidden, or within the margin of %2 m</source>
        <translation>le point de référence est sur le bord de «&#xa0;%1&#xa0;», qui est interdit, ou dans la marge de %2 m</translation>
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
        <source>lies outside the workspace bounds</source>
        <translation>est hors des limites de l&apos;espace de travail</translation>
    </message>
    <message>
        <source>the object is %1 m from &apos;%2&apos;, nearer than the required clearance of %3 m</source>
        <translation>l&apos;objet est à %1 m de «&#xa0;%2 », moins que le jeu exigé de %3 m</translation>
    </message>
    <message>
        <source>the milestone is in collision with &apos;%1&apos;</source>
        <translation>le jalon est en collision avec «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Put it where the object is free, or remove it.</source>
        <translation>Placez-le là où l&apos;objet est libre, ou supprimez-le.</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>l&apos;espace de travail</translation>
    </message>
    <message>
        <source>Give a minimum below the maximum.</source>
        <translation>Donnez un minimum inférieur au maximum.</translation>
    </message>
    <message>
        <source>the goal &apos;removed&apos; cannot be reached: the workspace has no room outside the box around the obstacles</source>
        <translation>le but «&#xa0;démonté&#xa0;» ne peut pas être atteint&#xa0;: l&apos;espace de travail n&apos;a pas de place hors de la boîte des obstacles</translation>
    </message>
    <message>
        <source>Enlarge the workspace by the size of the object on one side at least.</source>
        <translation>Agrandissez l&apos;espace de travail de la taille de l&apos;objet, d&apos;un côté au moins.</translation>
    </message>
    <message>
        <source>announcing a snapshot</source>
        <translation>annonce d&apos;un état du calcul</translation>
    </message>
    <message>
        <source>For comparison: unmodified %1</source>
        <translation>Pour comparer&#xa0;: %1 non modifié</translation>
    </message>
    <message>
        <source>%1 as OMPL&apos;s users run it: collisions by FCL, edges sampled at intervals; the first path is checked by our certificate.</source>
        <translation>%1 tel que l&apos;emploient les utilisateurs d&apos;OMPL&#xa0;: collisions par FCL, arêtes vérifiées par points&#xa0;; le premier chemin est vérifié par notre certificat.</translation>
    </message>
    <message>
        <source>has no meaning beside a number</source>
        <translation>n&apos;a pas de sens à côté d&apos;un nombre</translation>
    </message>
    <message>
        <source>Put it into &quot;than&quot;.</source>
        <translation>Mettez-le dans «&#xa0;than&#xa0;».</translation>
    </message>
    <message>
        <source>names the unknown %1 &apos;%2&apos;</source>
        <translation>nomme %1 inconnu «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>mesure</translation>
    </message>
    <message>
        <source>statistic</source>
        <translation>statistique</translation>
    </message>
    <message>
        <source>kind of runs</source>
        <translation>type d&apos;essais</translation>
    </message>
    <message>
        <source>Tools: %1</source>
        <translation>Outils : %1</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Nomenclature</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Subassembly for step %1</source>
        <translation>Sous-ensemble pour l&apos;étape %1</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Work instruction</source>
        <translation>Gamme de montage</translation>
    </message>
    <message>
        <source>names no column</source>
        <translation>ne nomme aucune colonne</translation>
    </message>
    <message>
        <source>Name at least one column, or leave the member out.</source>
        <translation>Nommez au moins une colonne, ou supprimez ce champ.</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>est donné deux fois</translation>
    </message>
    <message>
        <source>Name each column once.</source>
        <translation>Nommez chaque colonne une fois.</translation>
    </message>
    <message>
        <source>is not below the folder of the template</source>
        <translation>n&apos;est pas sous le dossier du modèle</translation>
    </message>
    <message>
        <source>Copy the picture beside the template and give its name.</source>
        <translation>Copiez l&apos;image à côté du modèle et donnez son nom.</translation>
    </message>
    <message>
        <source>is neither a PNG nor a JPEG picture</source>
        <translation>n&apos;est une image ni PNG ni JPEG</translation>
    </message>
    <message>
        <source>Save the logo as PNG.</source>
        <translation>Enregistrez le logo en PNG.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Designation</source>
        <translation>Désignation</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>the page has no 3D view, because the animation is too large</source>
        <translation>la page n&apos;a pas de vue 3D, car l&apos;animation est trop grande</translation>
    </message>
    <message>
        <source>Save the animation as GLB, and open it in a 3D viewer.</source>
        <translation>Enregistrez l&apos;animation en GLB, et ouvrez-la dans une visionneuse 3D.</translation>
    </message>
    <message>
        <source>the page has no 3D view, because three.js is not installed</source>
        <translation>la page n&apos;a pas de vue 3D, car three.js n&apos;est pas installé</translation>
    </message>
    <message>
        <source>Install the package libjs-three, and save the page again.</source>
        <translation>Installez le paquet libjs-three, et enregistrez de nouveau la page.</translation>
    </message>
    <message>
        <source>Screw in %1.</source>
        <translation>Visser %1.</translation>
    </message>
    <message>
        <source>Screw on %1.</source>
        <translation>Visser %1.</translation>
    </message>
    <message>
        <source>Press in %1.</source>
        <translation>Emmancher %1.</translation>
    </message>
    <message>
        <source>Push in %1.</source>
        <translation>Enfoncer %1.</translation>
    </message>
    <message>
        <source>Snap in %1.</source>
        <translation>Clipser %1.</translation>
    </message>
    <message>
        <source>Lay on %1.</source>
        <translation>Poser %1.</translation>
    </message>
    <message>
        <source>Turn in %1.</source>
        <translation>Mettre %1 en tournant.</translation>
    </message>
    <message>
        <source>Insert %1.</source>
        <translation>Insérer %1.</translation>
    </message>
    <message>
        <source>Place %1.</source>
        <translation>Placer %1.</translation>
    </message>
    <message>
        <source>Turn the product over.</source>
        <translation>Retourner le produit.</translation>
    </message>
    <message>
        <source>Turn the product over and by half a turn.</source>
        <translation>Retourner le produit et le tourner d&apos;un demi-tour.</translation>
    </message>
    <message>
        <source>Turn the product by half a turn.</source>
        <translation>Tourner le produit d&apos;un demi-tour.</translation>
    </message>
    <message>
        <source>Turn the product over and to the left.</source>
        <translation>Retourner le produit et le tourner vers la gauche.</translation>
    </message>
    <message>
        <source>Turn the product over and to the right.</source>
        <translation>Retourner le produit et le tourner vers la droite.</translation>
    </message>
    <message>
        <source>Turn the product to the left.</source>
        <translation>Tourner le produit vers la gauche.</translation>
    </message>
    <message>
        <source>Turn the product to the right.</source>
        <translation>Tourner le produit vers la droite.</translation>
    </message>
    <message>
        <source>Put %1 on the bench.</source>
        <translation>Poser %1 sur l&apos;établi.</translation>
    </message>
    <message>
        <source>Put these parts on the bench.</source>
        <translation>Poser ces pièces sur l&apos;établi.</translation>
    </message>
    <message>
        <source>subassembly %1</source>
        <translation>sous-ensemble %1</translation>
    </message>
    <message>
        <source>Start all by hand, then tighten crosswise.</source>
        <translation>Tout engager à la main, puis serrer en croix.</translation>
    </message>
    <message>
        <source>Hold %1, turn %2.</source>
        <translation>Tenir %1, tourner %2.</translation>
    </message>
    <message>
        <source>Needs support: %1</source>
        <translation>À soutenir : %1</translation>
    </message>
    <message>
        <source>Hold while you turn it over: %1</source>
        <translation>À tenir pendant le retournement : %1</translation>
    </message>
    <message>
        <source>One person</source>
        <translation>Une personne</translation>
    </message>
    <message>
        <source>Station %1</source>
        <translation>Poste %1</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>Framed steps: the critical path</source>
        <translation>Étapes encadrées&#xa0;: le chemin critique</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Étape %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>Report of a path: %1</source>
        <translation>Rapport d&apos;un chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scénario</translation>
    </message>
    <message>
        <source>Moving part</source>
        <translation>Pièce manipulée</translation>
    </message>
    <message>
        <source>Other parts</source>
        <translation>Autres pièces</translation>
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
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>The path is certified free of penetration: the part keeps the required clearance from all other parts at every time of the motion, not only at samples.</source>
        <translation>Le chemin est certifié sans pénétration&#xa0;: la pièce garde le jeu exigé à toutes les autres pièces à chaque instant du mouvement, et non seulement à des échantillons.</translation>
    </message>
    <message>
        <source>Certified clearance</source>
        <translation>Jeu certifié</translation>
    </message>
    <message>
        <source>Smallest clearance met</source>
        <translation>Plus petit jeu rencontré</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Edges that slide</source>
        <translation>Segments qui glissent</translation>
    </message>
    <message>
        <source>Forbidden places</source>
        <translation>Lieux interdits</translation>
    </message>
    <message>
        <source>the path keeps %1 from them</source>
        <translation>le chemin en reste à %1</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Amincissement</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Inconnu</translation>
    </message>
    <message>
        <source>where these shapes of the file are: %1</source>
        <translation>où sont ces formes du fichier : %1</translation>
    </message>
    <message>
        <source>CAD accuracy</source>
        <translation>Précision CAO</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>32-bit coordinates</source>
        <translation>Coordonnées à 32 bits</translation>
    </message>
    <message>
        <source>surfaces may be %1 nearer</source>
        <translation>les surfaces peuvent être plus proches de %1</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Clearance along the path</source>
        <translation>Jeu le long du chemin</translation>
    </message>
    <message>
        <source>Distances of triangles to the nearest part at places of the path; the smallest is %1 to %2.</source>
        <translation>Distances des triangles à la pièce la plus proche à des endroits du chemin&#xa0;; la plus petite est %1 à %2.</translation>
    </message>
    <message>
        <source>share of the path, %</source>
        <translation>part du chemin, %</translation>
    </message>
    <message>
        <source>clearance, mm</source>
        <translation>jeu, mm</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>All parts are boxes, cylinders and spheres of the scenario.</source>
        <translation>Toutes les pièces sont des boîtes, des cylindres et des sphères du scénario.</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>coincée</translation>
    </message>
    <message>
        <source>Report of the sequence: %1</source>
        <translation>Rapport de la séquence : %1</translation>
    </message>
    <message>
        <source>Precedence graph</source>
        <translation>Graphe d&apos;antériorité</translation>
    </message>
    <message>
        <source>An arrow leads from a step of the removal to each step that has to come after it.</source>
        <translation>Une flèche mène d&apos;une étape du démontage à chaque étape qui doit la suivre.</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produit</translation>
    </message>
    <message>
        <source>Parts to assemble</source>
        <translation>Pièces à monter</translation>
    </message>
    <message>
        <source>Assembly steps</source>
        <translation>Étapes du montage</translation>
    </message>
    <message>
        <source>Parts without a step</source>
        <translation>Pièces sans étape</translation>
    </message>
    <message>
        <source>Every motion is certified: the part keeps its clearance from all parts that are present, along its whole path.</source>
        <translation>Chaque mouvement est certifié&#xa0;: la pièce garde son jeu à toutes les pièces présentes, sur tout son chemin.</translation>
    </message>
    <message>
        <source>The independent check agrees with %1 of %2 {2|step|steps}.</source>
        <translation>La vérification indépendante confirme %1 {1|étape|étapes} sur %2.</translation>
    </message>
    <message>
        <source>The certificate is about the product without these shapes of the file, which were not made into bodies: %1.</source>
        <translation>Le certificat porte sur le produit sans ces formes du fichier, dont aucun corps n&apos;a été fait&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The plan is valid only if %1.</source>
        <translation>Le plan n&apos;est valable que si %1.</translation>
    </message>
    <message>
        <source>%1 {1|part is removed in a group that is|parts are removed in groups that are} not disassembled.</source>
        <translation>%1 {1|pièce est démontée dans un groupe qui n&apos;est pas démonté|pièces sont démontées dans des groupes qui ne sont pas démontés}.</translation>
    </message>
    <message>
        <source>CAD accuracy of the certificates: ± %1.</source>
        <translation>Précision CAO des certificats&#xa0;: ± %1.</translation>
    </message>
    <message>
        <source>The product, exploded</source>
        <translation>Le produit, éclaté</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Hand access, sampled</source>
        <translation>Accès de la main, par échantillons</translation>
    </message>
    <message>
        <source>%1 is not put on alone.</source>
        <translation>%1 n&apos;est pas montée seule.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Steps %1 to %2 of %3: %4</source>
        <translation>Étapes %1 à %2 sur %3&#xa0;: %4</translation>
    </message>
    <message>
        <source>%1, removal path</source>
        <translation>%1, chemin de démontage</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Nom complet</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Maintien</translation>
    </message>
    <message>
        <source>Forced, although</source>
        <translation>Forcée, bien que</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Found by</source>
        <translation>Trouvé par</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>%1 times: %2</source>
        <translation>%1 fois&#xa0;: %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>not carried out</source>
        <translation>non exécutée</translation>
    </message>
    <message>
        <source>the independent check agrees</source>
        <translation>la vérification indépendante confirme</translation>
    </message>
    <message>
        <source>the independent check does not agree</source>
        <translation>la vérification indépendante ne confirme pas</translation>
    </message>
    <message>
        <source>no part is near</source>
        <translation>aucune pièce n&apos;est proche</translation>
    </message>
    <message>
        <source>at least %1, smallest %2 to %3</source>
        <translation>au moins %1, le plus petit %2 à %3</translation>
    </message>
    <message>
        <source>No motion was found for these parts. They are in the product from the beginning.</source>
        <translation>Aucun mouvement n&apos;a été trouvé pour ces pièces. Elles sont dans le produit dès le début.</translation>
    </message>
    <message>
        <source>Blocked by</source>
        <translation>Bloquée par</translation>
    </message>
    <message>
        <source>+X</source>
        <translation>+X</translation>
    </message>
    <message>
        <source>−X</source>
        <translation>−X</translation>
    </message>
    <message>
        <source>+Y</source>
        <translation>+Y</translation>
    </message>
    <message>
        <source>−Y</source>
        <translation>−Y</translation>
    </message>
    <message>
        <source>up (+Z)</source>
        <translation>haut (+Z)</translation>
    </message>
    <message>
        <source>down (−Z)</source>
        <translation>bas (−Z)</translation>
    </message>
    <message>
        <source>hex key</source>
        <translation>clé à six pans</translation>
    </message>
    <message>
        <source>socket</source>
        <translation>clé à douille</translation>
    </message>
    <message>
        <source>screwdriver</source>
        <translation>tournevis</translation>
    </message>
    <message>
        <source>open wrench</source>
        <translation>clé plate</translation>
    </message>
    <message>
        <source>%1 at %2, %3 is held</source>
        <translation>%1 sur %2, en tenant %3</translation>
    </message>
    <message>
        <source>hold %1</source>
        <translation>tenir %1</translation>
    </message>
    <message>
        <source>to be removed before: %1</source>
        <translation>à démonter avant&#xa0;: %1</translation>
    </message>
    <message>
        <source>nuts still on it: %1</source>
        <translation>écrous encore dessus&#xa0;: %1</translation>
    </message>
    <message>
        <source>falling: %1</source>
        <translation>tombent&#xa0;: %1</translation>
    </message>
    <message>
        <source>still joined to it: %1</source>
        <translation>encore assemblés avec elle&#xa0;: %1</translation>
    </message>
    <message>
        <source>constrained to another place</source>
        <translation>contrainte à une autre place</translation>
    </message>
    <message>
        <source>screw into %1, %2 {2|turn|turns}</source>
        <translation>visser dans %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>unscrew nut %1, %2 {2|turn|turns}</source>
        <translation>dévisser l&apos;écrou %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>screw on nut %1, %2 {2|turn|turns}</source>
        <translation>visser l&apos;écrou %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>unscrew %1, %2 {2|turn|turns}</source>
        <translation>dévisser la vis %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>screw in %1, %2 {2|turn|turns}</source>
        <translation>visser %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>unscrew from %1, %2 {2|turn|turns}</source>
        <translation>dévisser de %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>screw together with %1, %2 {2|turn|turns}</source>
        <translation>visser avec %1, %2 {2|tour|tours}</translation>
    </message>
    <message>
        <source>press out of %1</source>
        <translation>chasser de %1</translation>
    </message>
    <message>
        <source>press into %1</source>
        <translation>emmancher dans %1</translation>
    </message>
    <message>
        <source>pull out of %1</source>
        <translation>tirer de %1</translation>
    </message>
    <message>
        <source>put into %1</source>
        <translation>mettre dans %1</translation>
    </message>
    <message>
        <source>bent by %1</source>
        <translation>fléchi de %1</translation>
    </message>
    <message>
        <source>remove from %1</source>
        <translation>retirer de %1</translation>
    </message>
    <message>
        <source>lay on %1</source>
        <translation>poser sur %1</translation>
    </message>
    <message>
        <source>unscrew %1 {1|turn|turns}, then %2</source>
        <translation>dévisser de %1 {1|tour|tours}, puis %2</translation>
    </message>
    <message>
        <source>%2, then screw in %1 {1|turn|turns}</source>
        <translation>%2, puis visser de %1 {1|tour|tours}</translation>
    </message>
    <message>
        <source>does not move</source>
        <translation>ne bouge pas</translation>
    </message>
    <message>
        <source>around obstacles, %1, out %2</source>
        <translation>en contournant des obstacles, %1, sortie %2</translation>
    </message>
    <message>
        <source>around obstacles, %1, in %2</source>
        <translation>en contournant des obstacles, %1, entrée %2</translation>
    </message>
    <message>
        <source>, then </source>
        <translation>, puis </translation>
    </message>
    <message>
        <source>%1, %2, turning %3 about %4</source>
        <translation>%1, %2, en tournant de %3 autour de l&apos;axe %4</translation>
    </message>
    <message>
        <source>turn %1 about %2</source>
        <translation>rotation de %1 autour de l&apos;axe %2</translation>
    </message>
    <message>
        <source>%1 without what overlaps it, up to %2 deep (accepted clash)</source>
        <translation>%1 sans ce qui le recouvre, jusqu&apos;à %2 de profondeur (interférence acceptée)</translation>
    </message>
    <message>
        <source>without what overlaps %2, up to %1 deep (accepted clash)</source>
        <translation>sans ce qui recouvre %2, jusqu&apos;à %1 de profondeur (interférence acceptée)</translation>
    </message>
    <message>
        <source>, user-defined</source>
        <translation>, défini par l&apos;utilisateur</translation>
    </message>
    <message>
        <source>%2 on %1, which gives way (%3)</source>
        <translation>%2 sur %1, qui cède (%3)</translation>
    </message>
    <message>
        <source>%1 on %2 (%3)</source>
        <translation>%1 face à %2 (%3)</translation>
    </message>
    <message>
        <source>is not &quot;glissade-study-run&quot;</source>
        <translation>n&apos;est pas «&#xa0;glissade-study-run&#xa0;»</translation>
    </message>
    <message>
        <source>is not a status</source>
        <translation>n&apos;est pas un état</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>ne peut pas être créé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose another --out.</source>
        <translation>Choisissez un autre --out.</translation>
    </message>
    <message>
        <source>holds results of another study, of another version of it or of Glissade, or of its other size (--quick)</source>
        <translation>contient les résultats d&apos;une autre étude, d&apos;une autre version de l&apos;étude ou de Glissade, ou de son autre taille (--quick)</translation>
    </message>
    <message>
        <source>Choose another --out, or remove that folder.</source>
        <translation>Choisissez un autre --out, ou supprimez ce dossier.</translation>
    </message>
    <message>
        <source>is not a folder of study results</source>
        <translation>n&apos;est pas un dossier de résultats d&apos;étude</translation>
    </message>
    <message>
        <source>Choose a new folder as --out.</source>
        <translation>Choisissez un nouveau dossier pour --out.</translation>
    </message>
    <message>
        <source>is of another plan</source>
        <translation>vient d&apos;un autre plan</translation>
    </message>
    <message>
        <source>It is left out.</source>
        <translation>Il est laissé de côté.</translation>
    </message>
    <message>
        <source>the scenario of the study is no longer there</source>
        <translation>le scénario de l&apos;étude n&apos;existe plus</translation>
    </message>
    <message>
        <source>Put it back, or write the place of the study file into %1.</source>
        <translation>Remettez-le, ou écrivez l&apos;emplacement du fichier de l&apos;étude dans %1.</translation>
    </message>
    <message>
        <source>has another result than a folder named before it</source>
        <translation>a un autre résultat qu&apos;un dossier nommé avant lui</translation>
    </message>
    <message>
        <source>The same run must end the same everywhere: look for different builds of Glissade.</source>
        <translation>Le même essai doit finir partout de la même façon&#xa0;: cherchez des versions différentes de Glissade.</translation>
    </message>
    <message>
        <source>is of another study, version or size than %1</source>
        <translation>est d&apos;une autre étude, version ou taille que %1</translation>
    </message>
    <message>
        <source>Merge folders of one study, made by one version of Glissade.</source>
        <translation>Réunissez des dossiers d&apos;une même étude, faits par une même version de Glissade.</translation>
    </message>
    <message>
        <source>has no &apos;%1&apos;</source>
        <translation>n&apos;a pas de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is there a second time</source>
        <translation>y est une seconde fois</translation>
    </message>
    <message>
        <source>is a limit</source>
        <translation>est une limite</translation>
    </message>
    <message>
        <source>Move it to &quot;limits&quot;.</source>
        <translation>Déplacez-le dans «&#xa0;limits&#xa0;».</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>stratégie</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>opérateur</translation>
    </message>
    <message>
        <source>is beyond %1</source>
        <translation>dépasse %1</translation>
    </message>
    <message>
        <source>Labels name rows.</source>
        <translation>Les étiquettes nomment des lignes.</translation>
    </message>
    <message>
        <source>makes too many runs</source>
        <translation>fait trop d&apos;essais</translation>
    </message>
    <message>
        <source>Vary less, or less finely.</source>
        <translation>Faites varier moins, ou moins finement.</translation>
    </message>
    <message>
        <source>row</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>scénario</translation>
    </message>
    <message>
        <source>is a sequence with an operator</source>
        <translation>est une séquence avec un opérateur</translation>
    </message>
    <message>
        <source>Say &quot;none&quot;.</source>
        <translation>Indiquez «&#xa0;none&#xa0;».</translation>
    </message>
    <message>
        <source>is a sequence without a time limit</source>
        <translation>est une séquence sans limite de temps</translation>
    </message>
    <message>
        <source>Give time_limit under &quot;limits&quot;.</source>
        <translation>Donnez time_limit sous «&#xa0;limits&#xa0;».</translation>
    </message>
    <message>
        <source>is a sequence, which has no parameter %1</source>
        <translation>est une séquence, qui n&apos;a pas de paramètre %1</translation>
    </message>
    <message>
        <source>Give limits only.</source>
        <translation>Ne donnez que des limites.</translation>
    </message>
    <message>
        <source>has no scenario</source>
        <translation>n&apos;a pas de scénario</translation>
    </message>
    <message>
        <source>Add &quot;scenarios&quot;.</source>
        <translation>Ajoutez «&#xa0;scenarios&#xa0;».</translation>
    </message>
    <message>
        <source>has no strategy</source>
        <translation>n&apos;a pas de stratégie</translation>
    </message>
    <message>
        <source>Add &quot;strategies&quot;.</source>
        <translation>Ajoutez «&#xa0;strategies&#xa0;».</translation>
    </message>
    <message>
        <source>has no seeds</source>
        <translation>n&apos;a pas de graines</translation>
    </message>
    <message>
        <source>Add &quot;seeds&quot;.</source>
        <translation>Ajoutez «&#xa0;seeds&#xa0;».</translation>
    </message>
    <message>
        <source>may run for ever</source>
        <translation>pourrait ne jamais finir</translation>
    </message>
    <message>
        <source>Give time_limit, max_steps or max_samples under &quot;limits&quot;.</source>
        <translation>Donnez time_limit, max_steps ou max_samples sous «&#xa0;limits&#xa0;».</translation>
    </message>
    <message>
        <source>interrupted with %1 of %2 {2|run|runs} done</source>
        <translation>interrompu après %1 {1|essai|essais} sur %2</translation>
    </message>
    <message>
        <source>The same command resumes from here.</source>
        <translation>La même commande reprend à partir d&apos;ici.</translation>
    </message>
    <message>
        <source>Work of each station</source>
        <translation>Travail de chaque poste</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Poste</translation>
    </message>
    <message>
        <source>Line of %1 {1|station|stations}</source>
        <translation>Ligne de %1 {1|poste|postes}</translation>
    </message>
    <message>
        <source>Cycle time %1. Minimum %2.</source>
        <translation>Temps de cycle %1. Minimum %2.</translation>
    </message>
    <message>
        <source>The times are estimates of the size of tables for manual assembly (Boothroyd, Dewhurst and Knight 2011). They were not measured.</source>
        <translation>Les temps sont des estimations de l&apos;ordre des tables d&apos;assemblage manuel (Boothroyd, Dewhurst et Knight 2011). Ils n&apos;ont pas été mesurés.</translation>
    </message>
    <message>
        <source>The times follow an edited table. %1 of its %2 values were edited. The others are estimates of the size of tables for manual assembly (Boothroyd, Dewhurst and Knight 2011) and were not measured.</source>
        <translation>Les temps suivent un tableau modifié. %1 de ses %2 valeurs ont été modifiées. Les autres sont des estimations de l&apos;ordre des tables d&apos;assemblage manuel (Boothroyd, Dewhurst et Knight 2011) et n&apos;ont pas été mesurées.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Critical path</source>
        <translation>Chemin critique</translation>
    </message>
    <message>
        <source>Steps of the critical path</source>
        <translation>Étapes du chemin critique</translation>
    </message>
    <message>
        <source>the swept volume was not finished</source>
        <translation>le volume balayé n&apos;a pas été terminé</translation>
    </message>
    <message>
        <source>there is no moving part</source>
        <translation>il n&apos;y a pas de pièce manipulée</translation>
    </message>
    <message>
        <source>Give a body with triangles and a path.</source>
        <translation>Donnez un corps avec des triangles et un chemin.</translation>
    </message>
    <message>
        <source>the bound of the swept volume is finer than 32-bit coordinates are so far from the origin</source>
        <translation>la borne du volume balayé est plus fine que les coordonnées sur 32 bits aussi loin de l&apos;origine</translation>
    </message>
    <message>
        <source>Give at least %1 mm.</source>
        <translation>Donnez au moins %1 mm.</translation>
    </message>
    <message>
        <source>the bound of the swept volume needs more than 4 GiB</source>
        <translation>la borne du volume balayé demande plus de 4 Gio</translation>
    </message>
    <message>
        <source>the bound of the swept volume is not above 0</source>
        <translation>la borne du volume balayé n&apos;est pas supérieure à 0</translation>
    </message>
    <message>
        <source>Give a length as 0.5mm.</source>
        <translation>Donnez une longueur, comme 0.5mm.</translation>
    </message>
    <message>
        <source>nothing can be removed: every body is fixed as base, or a joint holds it to the base. See &apos;glissade-cli joints&apos;, and dissolve a joint in a scenario.</source>
        <translation>rien ne peut être démonté&#xa0;: chaque corps est fixé comme base, ou une liaison le lie à la base. Voyez «&#xa0;glissade-cli joints&#xa0;», et supprimez une liaison dans un scénario.</translation>
    </message>
    <message>
        <source>Name the one that is cut (--cut &quot;%1&quot; or --cut &quot;%2&quot;), or mend the parts.</source>
        <translation>Nommez celui qui est découpé (--cut &quot;%1&quot; ou --cut &quot;%2&quot;), ou corrigez les pièces.</translation>
    </message>
    <message>
        <source>it is larger than inserts are, and may be screwed in</source>
        <translation>il est plus grand que les inserts, et est peut-être vissé</translation>
    </message>
    <message>
        <source>the clash of it and &apos;%1&apos; (%2) is accepted, and which of the two is cut is not clear: name the one that is cut (--cut &quot;%3&quot; or --cut &quot;%1&quot;)</source>
        <translation>son interférence avec «&#xa0;%1&#xa0;» (%2) est acceptée, et il n&apos;est pas clair laquelle des deux pièces est découpée&#xa0;: nommez celle qui est découpée (--cut &quot;%3&quot; ou --cut &quot;%1&quot;)</translation>
    </message>
    <message>
        <source>Write report.html, too (needs Python and matplotlib)</source>
        <translation>Écrire aussi report.html (demande Python et matplotlib)</translation>
    </message>
    <message>
        <source>Folder of report.html and of the tables (default: DIR)</source>
        <translation>Dossier de report.html et des tableaux (par défaut&#xa0;: DIR)</translation>
    </message>
    <message>
        <source>see %1; &apos;glissade-cli report %2&apos; writes the page of the study</source>
        <translation>voir %1&#xa0;; «&#xa0;glissade-cli report %2&#xa0;» écrit la page de l&apos;étude</translation>
    </message>
    <message>
        <source>Choose a run in the folder of its study.</source>
        <translation>Choisissez un essai dans le dossier de son étude.</translation>
    </message>
    <message>
        <source>was stopped</source>
        <translation>a été arrêté</translation>
    </message>
    <message>
        <source>needs a module of Python that is not installed: %1</source>
        <translation>demande un module de Python qui n&apos;est pas installé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Install it, or name a Python that has it by GLISSADE_PYTHON.</source>
        <translation>Installez-le, ou nommez par GLISSADE_PYTHON un Python qui l&apos;a.</translation>
    </message>
    <message>
        <source>has failed: %1</source>
        <translation>a échoué&#xa0;: %1</translation>
    </message>
    <message>
        <source>is not there; pages of studies are written by Python</source>
        <translation>est absent&#xa0;; les pages des études sont écrites par Python</translation>
    </message>
    <message>
        <source>Install it (apt install python3-matplotlib), or name it by GLISSADE_PYTHON.</source>
        <translation>Installez-le (apt install python3-matplotlib), ou nommez-le par GLISSADE_PYTHON.</translation>
    </message>
    <message>
        <source>is not found in the samples/studies of the program</source>
        <translation>est introuvable dans samples/studies du programme</translation>
    </message>
    <message>
        <source>Install Glissade as a whole.</source>
        <translation>Installez Glissade en entier.</translation>
    </message>
    <message>
        <source>Base part</source>
        <translation>Pièce de base</translation>
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
        <source>snap</source>
        <translation>clip</translation>
    </message>
    <message>
        <source>permanent</source>
        <translation>permanente</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>recognised</source>
        <translation>reconnue</translation>
    </message>
    <message>
        <source>suggested</source>
        <translation>proposée</translation>
    </message>
    <message>
        <source>Operator: %1 or replay:FILE</source>
        <translation>Opérateur&#xa0;: %1 ou replay:FICHIER</translation>
    </message>
    <message>
        <source>The computer&apos;s share of the iterations: 1 is the automatic planner alone, 0 the operator alone. While the hand rests the computer goes on, except at 0 in the strategy With my hand.</source>
        <translation>La part de l&apos;ordinateur dans les itérations&#xa0;: 1 est le planificateur seul, 0 l&apos;opérateur seul. Tant que la main est immobile, l&apos;ordinateur continue, sauf à 0 avec la stratégie Avec ma main.</translation>
    </message>
    <message>
        <source>With my hand</source>
        <translation>Avec ma main</translation>
    </message>
    <message>
        <source>has fewer than %1 entries</source>
        <translation>a moins de %1 entrées</translation>
    </message>
    <message>
        <source>screws in bodies without a tapped hole in the file, each of which makes its own: %1</source>
        <translation>vis dans des corps sans trou taraudé dans le fichier, qui font chacune le leur&#xa0;: %1</translation>
    </message>
    <message>
        <source>not for assembly: &apos;%1&apos; is pulled off &apos;%2&apos; without being unscrewed: %3</source>
        <translation>pas pour le montage&#xa0;: «&#xa0;%1&#xa0;» est tiré de «&#xa0;%2&#xa0;» sans être dévissé&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 {1|pair|pairs} with allowances {1|overlaps|overlap} without being a fit, a thread or a press: %2</source>
        <translation>%1 {1|paire avec amincissement se recouvre|paires avec amincissement se recouvrent} sans être ni un ajustement, ni un filetage, ni un serrage&#xa0;: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; without what its screw &apos;%2&apos; fills: the file has no tapped hole there</source>
        <translation>«&#xa0;%1&#xa0;» sans ce que sa vis «&#xa0;%2&#xa0;» remplit&#xa0;: le fichier n&apos;a pas de trou taraudé à cet endroit</translation>
    </message>
    <message>
        <source>%1 without what its screw fills (no tapped hole in the file)</source>
        <translation>%1 sans ce que sa vis remplit (aucun trou taraudé dans le fichier)</translation>
    </message>
    <message>
        <source>without what its screw %1 fills (no tapped hole in the file)</source>
        <translation>sans ce que sa vis %1 remplit (aucun trou taraudé dans le fichier)</translation>
    </message>
    <message>
        <source>not for assembly: the path pulls &apos;%1&apos; through the thread of &apos;%2&apos; without a turn (%3)</source>
        <translation>pas pour le montage&#xa0;: la trajectoire tire «&#xa0;%1&#xa0;» à travers le filetage de «&#xa0;%2&#xa0;» sans tourner (%3)</translation>
    </message>
    <message>
        <source>%1 without what its screw %2 fills (no tapped hole in the file)</source>
        <translation>%1 sans ce que sa vis %2 remplit (aucun trou taraudé dans le fichier)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is in its way, and is stuck for a reason of its own</source>
        <translation>«&#xa0;%1&#xa0;» est sur son chemin, et est lui-même bloqué pour une autre raison</translation>
    </message>
    <message>
        <source>&apos;%1&apos; alone blocks every straight motion of it, and no other motion was found; if &apos;%1&apos; is several parts drawn as one, such as a bolt with its nut, draw them apart</source>
        <translation>«&#xa0;%1&#xa0;» bloque à lui seul chaque mouvement droit de la pièce, et aucun autre mouvement n&apos;a été trouvé&#xa0;; si «&#xa0;%1&#xa0;» est fait de plusieurs pièces dessinées en une, comme une vis avec son écrou, dessinez-les séparément</translation>
    </message>
    <message>
        <source>it is oriented and names no shell</source>
        <translation>elle est orientée et ne nomme aucune coque</translation>
    </message>
    <message>
        <source>Choose one of the panel Product.</source>
        <translation>Choisissez-en un dans le panneau Produit.</translation>
    </message>
    <message>
        <source>cannot have the name &apos;%1&apos;</source>
        <translation>ne peut pas porter le nom «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Give a name without &apos;/&apos;.</source>
        <translation>Donnez un nom sans «&#xa0;/&#xa0;».</translation>
    </message>
    <message>
        <source>My hand</source>
        <translation>Ma main</translation>
    </message>
    <message>
        <source>Interactive with contact</source>
        <translation>Interactif avec contact</translation>
    </message>
    <message>
        <source>Algorithm 1 as printed (Blin et al. 2016): you steer the object and the computer searches with you; near an obstacle the object slides on it.</source>
        <translation>Algorithme 1 tel qu&apos;imprimé (Blin et al. 2016)&#xa0;: vous dirigez l&apos;objet et l&apos;ordinateur cherche avec vous&#xa0;; près d&apos;un obstacle, l&apos;objet glisse sur celui-ci.</translation>
    </message>
    <message>
        <source>BKPIECE</source>
        <translation>BKPIECE</translation>
    </message>
    <message>
        <source>Two trees that grow from the border of the cells explored (Sucan and Kavraki 2009), of OMPL.</source>
        <translation>Deux arbres qui croissent depuis le bord des cellules explorées (Sucan et Kavraki 2009), d&apos;OMPL.</translation>
    </message>
    <message>
        <source>PRM</source>
        <translation>PRM</translation>
    </message>
    <message>
        <source>A roadmap of the whole space (Kavraki et al. 1996), of OMPL.</source>
        <translation>Une carte de tout l&apos;espace (Kavraki et al. 1996), d&apos;OMPL.</translation>
    </message>
    <message>
        <source>EST</source>
        <translation>EST</translation>
    </message>
    <message>
        <source>One tree that grows where it is sparse (Hsu et al. 1999), of OMPL.</source>
        <translation>Un arbre qui croît là où il est clairsemé (Hsu et al. 1999), d&apos;OMPL.</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>GT</source>
        <translation>GT</translation>
    </message>
    <message>
        <source>GTS1</source>
        <translation>GTS1</translation>
    </message>
    <message>
        <source>GTS2</source>
        <translation>GTS2</translation>
    </message>
    <message>
        <source>Own rules</source>
        <translation>Règles propres</translation>
    </message>
    <message>
        <source>column</source>
        <translation>colonne</translation>
    </message>
    <message>
        <source>another shape, up to %1 apart</source>
        <translation>autre forme, à %1 au plus</translation>
    </message>
    <message>
        <source>moved by %1</source>
        <translation>déplacée de %1</translation>
    </message>
    <message>
        <source>moved by %1 and turned by %2 degrees</source>
        <translation>déplacée de %1 et tournée de %2 degrés</translation>
    </message>
    <message>
        <source>came: %1</source>
        <translation>ajoutée&#xa0;: %1</translation>
    </message>
    <message>
        <source>went: %1</source>
        <translation>supprimée&#xa0;: %1</translation>
    </message>
    <message>
        <source>renamed: %1 is %2</source>
        <translation>renommée&#xa0;: %1 s&apos;appelle %2</translation>
    </message>
    <message>
        <source>changed: %1, %2</source>
        <translation>modifiée&#xa0;: %1, %2</translation>
    </message>
    <message>
        <source>parts: %1 unchanged, %2 changed, %3 renamed, %4 came, %5 went</source>
        <translation>pièces&#xa0;: %1 inchangées, %2 modifiées, %3 renommées, %4 ajoutées, %5 supprimées</translation>
    </message>
    <message>
        <source>step %1 (%2) does not hold: %3</source>
        <translation>l&apos;étape %1 (%2) n&apos;est plus valable&#xa0;: %3</translation>
    </message>
    <message>
        <source>no step: %1</source>
        <translation>sans étape&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 {2|step holds|steps hold}, %3 {3|part has|parts have} no step</source>
        <translation>%1 {1|étape valable|étapes valables} sur %2, %3 {3|pièce|pièces} sans étape</translation>
    </message>
    <message>
        <source>Plan again with &apos;glissade-cli sequence NEW --reuse PLAN --out FILE&apos;: motions of steps that hold are taken over.</source>
        <translation>Refaites le plan avec «&#xa0;glissade-cli sequence NEW --reuse PLAN --out FILE&#xa0;»&#xa0;: les mouvements des étapes valables sont repris.</translation>
    </message>
    <message>
        <source>a part of it is gone</source>
        <translation>une de ses pièces n&apos;existe plus</translation>
    </message>
    <message>
        <source>Try the motions of this plan of an earlier revision before new ones are searched</source>
        <translation>Essayer les mouvements de ce plan d&apos;une révision antérieure avant d&apos;en chercher d&apos;autres</translation>
    </message>
    <message>
        <source>Compare two revisions of a product: parts that came, went, moved or changed, and steps that hold</source>
        <translation>Comparer deux révisions d&apos;un produit&#xa0;: pièces ajoutées, supprimées, déplacées ou modifiées, et étapes encore valables</translation>
    </message>
    <message>
        <source>Parts correspond by their names. With a plan of the earlier revision, each of its steps is judged in the later one.
Exit codes: 0 the same, or all steps hold; 1 there are differences, or steps do not hold; 2 wrong usage, 3 unreadable input, 130 interrupted.</source>
        <translation>Les pièces se correspondent par leurs noms. Avec un plan de la révision antérieure, chacune de ses étapes est jugée dans la nouvelle.
Codes de retour&#xa0;: 0 identiques, ou toutes les étapes sont valables&#xa0;; 1 il y a des différences, ou des étapes ne sont plus valables&#xa0;; 2 mauvais usage, 3 entrée illisible, 130 interrompu.</translation>
    </message>
    <message>
        <source>The earlier revision: a scenario or a part file</source>
        <translation>La révision antérieure&#xa0;: un scénario ou un fichier de pièces</translation>
    </message>
    <message>
        <source>The later revision</source>
        <translation>La nouvelle révision</translation>
    </message>
    <message>
        <source>Assembly plan of the earlier revision</source>
        <translation>Plan d&apos;assemblage de la révision antérieure</translation>
    </message>
    <message>
        <source>You steer the object. The way of your hand is kept and certified, and the computer searches from it; at α = 1 the automatic planners finish the path.</source>
        <translation>Vous guidez l&apos;objet. Le trajet de votre main est conservé et certifié, et l&apos;ordinateur cherche à partir de lui&#xa0;; à α = 1, les planificateurs automatiques finissent le chemin.</translation>
    </message>
    <message>
        <source>Only the plan states this. State the conditions in the scenario.</source>
        <translation>Seul le plan l&apos;indique. Énoncez les conditions dans le scénario.</translation>
    </message>
    <message>
        <source>OpenCASCADE&apos;s triangles cross the body beside it</source>
        <translation>les triangles d&apos;OpenCASCADE traversent le corps à côté d&apos;elle</translation>
    </message>
    <message>
        <source>%1, because its boundary encloses nothing alone; it was triangulated together with its neighbour on the same cylinder</source>
        <translation>%1, car son contour n&apos;entoure rien à lui seul&#xa0;; elle a été triangulée avec sa voisine sur le même cylindre</translation>
    </message>
    <message>
        <source>its triangles leave %1 {1|face|faces} open (%2)</source>
        <translation>ses triangles laissent %1 {1|face ouverte|faces ouvertes} (%2)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>does not turn on edge %1 in the thread it has with &apos;%2&apos;</source>
        <translation>ne tourne pas sur le segment %1 dans le filetage commun avec «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>does not keep its clearance on edge %1</source>
        <translation>ne garde pas son jeu sur le segment %1</translation>
    </message>
    <message>
        <source>penetrates &apos;%2&apos; on edge %1</source>
        <translation>pénètre «&#xa0;%2&#xa0;» sur le segment %1</translation>
    </message>
    <message>
        <source>comes within %3 of &apos;%2&apos; on edge %1; the required clearance is %4</source>
        <translation>s&apos;approche à %3 de «&#xa0;%2&#xa0;» sur le segment %1&#xa0;; le jeu exigé est de %4</translation>
    </message>
    <message>
        <source>Bodies fixed as base: they are not removed (default: a large one that touches many)</source>
        <translation>Corps fixés comme base&#xa0;: ils ne se démontent pas (par défaut&#xa0;: un grand que beaucoup touchent)</translation>
    </message>
    <message>
        <source>Write the liaison graph as CSV or JSON</source>
        <translation>Écrire le graphe des liaisons en CSV ou en JSON</translation>
    </message>
    <message>
        <source>the milestone lies outside the workspace</source>
        <translation>le jalon est hors de l&apos;espace de travail</translation>
    </message>
    <message>
        <source>Put it inside, enlarge the workspace, or remove it.</source>
        <translation>Placez-le à l&apos;intérieur, agrandissez l&apos;espace de travail ou enlevez-le.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is cut, because its clash with &apos;%2&apos; (%3) is accepted; if &apos;%2&apos; is the one to cut, name it (--cut &quot;%2&quot;)</source>
        <translation>«&#xa0;%1&#xa0;» est découpée, car son interférence avec «&#xa0;%2&#xa0;» (%3) est acceptée&#xa0;; si c&apos;est «&#xa0;%2&#xa0;» qu&apos;il faut découper, nommez-la (--cut &quot;%2&quot;)</translation>
    </message>
    <message>
        <source>the clash of &apos;%1&apos; and &apos;%2&apos; (%3) is accepted, and they are thinned where they overlap; if one is drawn through the other, name the one to cut (--cut &quot;%1&quot; or --cut &quot;%2&quot;)</source>
        <translation>l&apos;interférence de «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» (%3) est acceptée, et elles sont amincies là où elles se recouvrent&#xa0;; si l&apos;une est dessinée à travers l&apos;autre, nommez celle qu&apos;il faut découper (--cut &quot;%1&quot; ou --cut &quot;%2&quot;)</translation>
    </message>
    <message>
        <source>no motion was found: %1</source>
        <translation>aucun mouvement n&apos;a été trouvé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Take clashes up to this overlap as fits, as 1.5mm; advised: each clash by its own overlap</source>
        <translation>Prendre pour des ajustements les interférences jusqu&apos;à ce recouvrement, par exemple 1.5mm&#xa0;; advised&#xa0;: chaque interférence pour son propre recouvrement</translation>
    </message>
    <message>
        <source>&apos;advised&apos; is not kept in a scenario</source>
        <translation>«&#xa0;advised&#xa0;» n&apos;est pas conservé dans un scénario</translation>
    </message>
    <message>
        <source>Give a length, as 1.5mm.</source>
        <translation>Donnez une longueur, par exemple 1.5mm.</translation>
    </message>
    <message>
        <source>Incomplete: the plan has no step for %1.</source>
        <translation>Incomplet&#xa0;: le plan n&apos;a pas d&apos;étape pour %1.</translation>
    </message>
    <message>
        <source>no step</source>
        <translation>sans étape</translation>
    </message>
    <message>
        <source>is neither 1 nor 2</source>
        <translation>n&apos;est ni 1 ni 2</translation>
    </message>
    <message>
        <source>%1, motion %2</source>
        <translation>%1, mouvement %2</translation>
    </message>
    <message>
        <source>Hold %1 (%2).</source>
        <translation>Maintenir %1 (%2).</translation>
    </message>
    <message>
        <source>%1, %2 is held (%3)</source>
        <translation>%1, %2 est maintenu (%3)</translation>
    </message>
    <message>
        <source>Hold %1.</source>
        <translation>Maintenir %1.</translation>
    </message>
    <message>
        <source>%1, %2 is held</source>
        <translation>%1, %2 est maintenu</translation>
    </message>
    <message>
        <source>planning was stopped before every motion of it was tried</source>
        <translation>la planification a été arrêtée avant que tous ses mouvements soient essayés</translation>
    </message>
    <message>
        <source>the snap with &apos;%1&apos; was tried in the direction %2 with a bend of %3, and needs %4: change the joint to this bend</source>
        <translation>le clip avec «&#xa0;%1&#xa0;» a été essayé dans la direction %2 avec une flexion de %3, et il faut %4&#xa0;: donnez cette flexion à la liaison</translation>
    </message>
    <message>
        <source>the snap with &apos;%1&apos; was tried in the direction %2, and the most that its hook can bend, %3, is too little: change the direction of the joint, or move the part by hand</source>
        <translation>le clip avec «&#xa0;%1&#xa0;» a été essayé dans la direction %2, et la plus grande flexion de son crochet, %3, ne suffit pas&#xa0;: changez la direction de la liaison, ou déplacez la pièce à la main</translation>
    </message>
    <message>
        <source>it would leave in the direction %1 if &apos;%2&apos; bends by %3: make the two a snap with this bend</source>
        <translation>elle sortirait dans la direction %1 si «&#xa0;%2&#xa0;» fléchit de %3&#xa0;: faites des deux un clip avec cette flexion</translation>
    </message>
    <message>
        <source>as a snap that bends by up to %1 it leaves along no axis: move it by hand, or make the two a permanent joint</source>
        <translation>comme clip qui fléchit jusqu&apos;à %1, elle ne sort selon aucun axe&#xa0;: déplacez-la à la main, ou faites des deux une liaison permanente</translation>
    </message>
    <message>
        <source>Accepted clashes: %1</source>
        <translation>Interférences acceptées : %1</translation>
    </message>
    <message>
        <source>holds one part of %1 solids, which are taken as bodies</source>
        <translation>contient une seule pièce de %1 solides, qui sont pris comme corps</translation>
    </message>
    <message>
        <source>Join solids of one body in the CAD program.</source>
        <translation>Réunissez dans le logiciel de CAO les solides d&apos;un même corps.</translation>
    </message>
    <message>
        <source>has surfaces inside its solid (%1 {1|face|faces}), as cosmetic threads are: they are left out</source>
        <translation>a des surfaces à l&apos;intérieur de son solide (%1 {1|face|faces}), comme les filetages cosmétiques : elles sont laissées de côté</translation>
    </message>
    <message>
        <source>The solid covers them, so that nothing is missing.</source>
        <translation>Le solide les recouvre, donc rien ne manque.</translation>
    </message>
    <message>
        <source>looking how the product lies in each step</source>
        <translation>recherche de la position du produit à chaque étape</translation>
    </message>
    <message>
        <source>Excluded, without a step: %1</source>
        <translation>Exclues, sans étape&#xa0;: %1</translation>
    </message>
    <message>
        <source>Hold until this step is done, because nothing supports it before: %1.</source>
        <translation>À tenir jusqu’à la fin de cette étape, car rien ne le soutient avant&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Hold from this step on, because nothing supports it any more: %1.</source>
        <translation>À tenir à partir de cette étape, car plus rien ne le soutient&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Touches nothing and may lie beside the product: %1.</source>
        <translation>Ne touche rien et se trouve peut-être à côté du produit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>accepted clash: %1</source>
        <translation>interférence acceptée&#xa0;: %1</translation>
    </message>
    <message>
        <source>leaves %1 {1|pair|pairs} of bodies that are not compared, and whose bodies may stay</source>
        <translation>laisse %1 {1|paire|paires} de corps non {1|comparée|comparées}, dont les corps peuvent rester</translation>
    </message>
    <message>
        <source>Open %1 into its groove.</source>
        <translation>Ouvrir %1 et le placer dans sa gorge.</translation>
    </message>
    <message>
        <source>cut: %1</source>
        <translation>découpé&#xa0;: %1</translation>
    </message>
    <message>
        <source>circlip pliers</source>
        <translation>pince à circlips</translation>
    </message>
    <message>
        <source>is drawn %1 times in one place, and stands for: %2</source>
        <translation>est dessiné %1 fois au même endroit, et représente&#xa0;: %2</translation>
    </message>
    <message>
        <source>Delete the copies in the CAD program.</source>
        <translation>Supprimez les copies dans le logiciel de CAO.</translation>
    </message>
    <message>
        <source>step %1 (%2) holds without %3</source>
        <translation>l&apos;étape %1 (%2) reste valable sans %3</translation>
    </message>
    <message>
        <source>Accept it and name the one that is cut (--accept-clashes %1 --cut &quot;%2&quot; or --cut &quot;%3&quot;), or mend the parts.</source>
        <translation>Acceptez-la et nommez celui qui est découpé (--accept-clashes %1 --cut &quot;%2&quot; ou --cut &quot;%3&quot;), ou corrigez les pièces.</translation>
    </message>
    <message>
        <source>it is a purchased unit with the number of its article</source>
        <translation>c&apos;est un composant acheté avec son numéro d&apos;article</translation>
    </message>
    <message>
        <source>the other parts are on its board, as if soldered</source>
        <translation>les autres pièces sont sur sa carte, comme soudées</translation>
    </message>
    <message>
        <source>it is a flat ring, which is assumed to be opened out of its groove</source>
        <translation>c&apos;est un anneau plat, que l&apos;on suppose ouvert pour sortir de sa gorge</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos;, %3</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;», %3</translation>
    </message>
    <message>
        <source>%1: both are taken thinner</source>
        <translation>%1&#xa0;: les deux sont amincis</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is cut</source>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» est découpé</translation>
    </message>
    <message>
        <source>it and &apos;%1&apos; were not compared within the time limit: give more time</source>
        <translation>elle et «&#xa0;%1&#xa0;» n&apos;ont pas été comparées dans le temps imparti&#xa0;: donnez plus de temps</translation>
    </message>
    <message>
        <source>it and &apos;%1&apos; clash where they are assembled (%2), and neither can be cut and stay in one piece: mend the parts</source>
        <translation>elle et «&#xa0;%1&#xa0;» interfèrent à l’état assemblé (%2), et aucune ne peut être découpée et rester d&apos;un seul tenant&#xa0;: corrigez les pièces</translation>
    </message>
    <message>
        <source>changing the order of the steps</source>
        <translation>changement de l&apos;ordre des étapes</translation>
    </message>
    <message>
        <source>reading the studies of the papers</source>
        <translation>lecture des études des articles</translation>
    </message>
    <message>
        <source>Hold the other %1 with a second %2.</source>
        <translation>Tenir l&apos;autre %1 avec un deuxième outil (%2).</translation>
    </message>
    <message>
        <source>%1: %2 {2|turn|turns}, until flush with the end of %3.</source>
        <translation>%1&#xa0;: %2 {2|tour|tours}, jusqu&apos;à affleurer le bout de %3.</translation>
    </message>
    <message>
        <source>%1: %2 {2|turn|turns} onto %3.</source>
        <translation>%1&#xa0;: %2 {2|tour|tours} sur %3.</translation>
    </message>
    <message>
        <source>%1: %2 {2|turn|turns}, until %3 of %4 stick out.</source>
        <translation>%1&#xa0;: %2 {2|tour|tours}, jusqu&apos;à ce que %4 dépasse de %3.</translation>
    </message>
    <message>
        <source>%1 {1|part|parts} + base, %3 {3|step|steps}</source>
        <translation>%1 {1|pièce|pièces} + base, %3 {3|étape|étapes}</translation>
    </message>
    <message>
        <source>%1 {1|part|parts} + base of %2, %3 {3|step|steps}</source>
        <translation>%1 {1|pièce|pièces} + base de %2, %3 {3|étape|étapes}</translation>
    </message>
    <message>
        <source>no motion was found at the place that a constraint gives it</source>
        <translation>aucun mouvement n&apos;a été trouvé à la place qu&apos;une contrainte lui donne</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is fixed as base, and a constraint gives it a place among the steps</source>
        <translation>«&#xa0;%1&#xa0;» est fixée comme base, et une contrainte lui donne une place parmi les étapes</translation>
    </message>
    <message>
        <source>a constraint states that &apos;%1&apos; is removed before &apos;%2&apos;</source>
        <translation>une contrainte dit que «&#xa0;%1&#xa0;» se démonte avant «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is on &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» est sur «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; clamps &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» serre «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is screwed to &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» est vissée à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; goes around &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» entoure «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is flexible and may meet &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» est souple et peut rencontrer «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is in the way of &apos;%2&apos;</source>
        <translation>«&#xa0;%1&#xa0;» gêne «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>the motion of &apos;%1&apos; is not certified there</source>
        <translation>le mouvement de «&#xa0;%1&#xa0;» n&apos;y est pas certifié</translation>
    </message>
    <message>
        <source>up, in the file: %1</source>
        <translation>vers le haut, dans le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>Hold %1 until step %2 is done.</source>
        <translation>Tenir %1 jusqu’à la fin de l’étape %2.</translation>
    </message>
    <message>
        <source>Direction of gravity: x y z (default: the scenario&apos;s, or such that the base lies well)</source>
        <translation>Direction de la pesanteur&#xa0;: x y z (par défaut&#xa0;: celle du scénario, ou telle que la base repose bien)</translation>
    </message>
    <message>
        <source>Then let go of %1.</source>
        <translation>Lâcher ensuite %1.</translation>
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
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Méta</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée (pavé)</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Inser</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page préc.</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page suiv.</translation>
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
        <translation>Un rouleau sur un arbre entre deux parois</translation>
    </message>
    <message>
        <source>Pump, unmounting</source>
        <translation>Pompe, démontage</translation>
    </message>
    <message>
        <source>The pump leaves its seat in the power-electronics frame</source>
        <translation>La pompe sort de son logement dans le châssis d&apos;électronique de puissance</translation>
    </message>
    <message>
        <source>Nut and bolt</source>
        <translation>Vis et écrou</translation>
    </message>
    <message>
        <source>A nut on its bolt, with modelled threads</source>
        <translation>Un écrou sur sa vis, aux filetages modélisés</translation>
    </message>
    <message>
        <source>Shape game: star, tight</source>
        <translation>Jeu de formes&#xa0;: étoile, serré</translation>
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
        <translation>Imbriqués&#xa0;: une rotation</translation>
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
    <name>SaveConflict</name>
    <message>
        <source>The file is gone</source>
        <translation>Le fichier n&apos;existe plus</translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>Le fichier a été modifié</translation>
    </message>
    <message>
        <source>Another program has removed or renamed the file since it was opened:</source>
        <translation>Un autre programme a supprimé ou renommé le fichier depuis son ouverture&#xa0;:</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was opened:</source>
        <translation>Un autre programme a modifié le fichier depuis son ouverture&#xa0;:</translation>
    </message>
    <message>
        <source>Save it there again, or under another name.</source>
        <translation>Enregistrez-le de nouveau à cet endroit, ou sous un autre nom.</translation>
    </message>
    <message>
        <source>Overwrite it with your version: the other version stays under File &gt; Earlier versions. Or open the other version: your edits are lost. Or save your version under another name.</source>
        <translation>Remplacez-le par votre version&#xa0;: l&apos;autre version reste sous Fichier &gt; Versions antérieures. Ou ouvrez l&apos;autre version&#xa0;: vos modifications sont perdues. Ou enregistrez votre version sous un autre nom.</translation>
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
        <source>Ready. Press Find path (F5), or steer with the keys.</source>
        <translation>Prêt. Appuyez sur Chercher un chemin (F5), ou pilotez au clavier.</translation>
    </message>
    <message>
        <source>Planning: sampling on the nearest obstacle&apos;s tangent plane</source>
        <translation>Planification&#xa0;: échantillonnage sur le plan tangent de l&apos;obstacle le plus proche</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Planning: step %1 of %2, place %3 is crossed</source>
        <translation>Planification&#xa0;: étape %1 sur %2, traversée du lieu %3</translation>
    </message>
    <message>
        <source>Planning: milestones in the borders</source>
        <translation>Planification&#xa0;: recherche des jalons dans les frontières</translation>
    </message>
    <message>
        <source>The path is no longer valid: see Path. Find path (F5) looks for another.</source>
        <translation>Le chemin n&apos;est plus valide&#xa0;: voir le panneau Chemin. Chercher un chemin (F5) en cherche un autre.</translation>
    </message>
    <message>
        <source>The path is valid: certified free of penetration</source>
        <translation>Chemin valide&#xa0;: certifié sans pénétration</translation>
    </message>
    <message>
        <source>The start pose cannot be used: see the message over the scene.</source>
        <translation>La position de départ est inutilisable&#xa0;: voir le message au-dessus de la scène.</translation>
    </message>
    <message>
        <source>The goal pose cannot be used: see the message over the scene.</source>
        <translation>La position de but est inutilisable&#xa0;: voir le message au-dessus de la scène.</translation>
    </message>
    <message>
        <source>Planning: growing two trees</source>
        <translation>Planification&#xa0;: croissance de deux arbres</translation>
    </message>
    <message>
        <source>Stopped. Results kept.</source>
        <translation>Arrêté. Résultats conservés.</translation>
    </message>
    <message>
        <source>Planning: finding the places</source>
        <translation>Planification&#xa0;: recherche des lieux</translation>
    </message>
    <message>
        <source>Planning: searching the whole workspace</source>
        <translation>Planification&#xa0;: recherche dans tout l&apos;espace de travail</translation>
    </message>
    <message>
        <source>%1 s of %2 s</source>
        <translation>%1 s sur %2 s</translation>
    </message>
    <message>
        <source>✓ Path found: certified free of penetration. Play shows it.</source>
        <translation>✓ Chemin trouvé&#xa0;: certifié sans pénétration. Lecture le montre.</translation>
    </message>
    <message>
        <source>At the start: the run begins when you move the object.</source>
        <translation>Au départ&#xa0;: le calcul commence quand vous déplacez l&apos;objet.</translation>
    </message>
</context>
<context>
    <name>SteeringKeys</name>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>down</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>en s&apos;éloignant de vous</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>vers vous</translation>
    </message>
    <message>
        <source>turn left</source>
        <translation>tourner à gauche</translation>
    </message>
    <message>
        <source>turn right</source>
        <translation>tourner à droite</translation>
    </message>
    <message>
        <source>tip back</source>
        <translation>basculer en arrière</translation>
    </message>
    <message>
        <source>tip forward</source>
        <translation>basculer en avant</translation>
    </message>
    <message>
        <source>roll left</source>
        <translation>rouler à gauche</translation>
    </message>
    <message>
        <source>roll right</source>
        <translation>rouler à droite</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Open a scenario</source>
        <translation>Ouvrir un scénario</translation>
    </message>
    <message>
        <source>Open the sample &quot;Four bodies&quot;: its card on the welcome page, or Open (Ctrl+O) and samples/teaching/scenario.json. The red box is to reach the ghost. A scenario holds bodies, the moving part, its start and its goal.</source>
        <translation>Ouvrez l&apos;exemple «&#xa0;Quatre corps&#xa0;»&#xa0;: sa carte sur la page d&apos;accueil, ou Ouvrir (Ctrl+O) et samples/teaching/scenario.json. La boîte rouge doit atteindre le fantôme. Un scénario contient des corps, la pièce manipulée, son départ et son but.</translation>
    </message>
    <message>
        <source>See the places</source>
        <translation>Voir les lieux</translation>
    </message>
    <message>
        <source>Plan with topology</source>
        <translation>Planifier avec la topologie</translation>
    </message>
    <message>
        <source>Plan with semantics</source>
        <translation>Planifier avec la sémantique</translation>
    </message>
    <message>
        <source>Look at a step</source>
        <translation>Regarder une étape</translation>
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
        <source>Press F8 (View &gt; Layers of places &gt; Places). The free space is divided into places: the redder, the narrower; green ones are easy, yellow ones are cluttered by a mobile body. The blue line is the coarse path: the sequence of places that costs least.</source>
        <translation>Appuyez sur F8 (Vue &gt; Couches des lieux &gt; Lieux). L&apos;espace libre est divisé en lieux&#xa0;: plus ils sont rouges, plus ils sont étroits&#xa0;; les verts sont faciles, les jaunes encombrés par un corps mobile. La ligne bleue est le chemin grossier&#xa0;: la suite de lieux qui coûte le moins.</translation>
    </message>
    <message>
        <source>See the fits</source>
        <translation>Voir les ajustements</translation>
    </message>
    <message>
        <source>Remove a part</source>
        <translation>Démonter une pièce</translation>
    </message>
    <message>
        <source>Press Find path (F5): the planner searches the removal path of the nut. The panel Path shows the clearance along the motion, the allowances, and plays it (Ctrl+P).</source>
        <translation>Appuyez sur Chercher un chemin (F5)&#xa0;: le planificateur cherche le chemin de démontage de l&apos;écrou. Le panneau Chemin montre le jeu le long du mouvement, les amincissements, et le joue (Ctrl+P).</translation>
    </message>
    <message>
        <source>Cut it open</source>
        <translation>Voir en coupe</translation>
    </message>
    <message>
        <source>Choose View &gt; Sections &gt; Section across Y (Ctrl+Alt+Y): the plane cuts the bodies open, so that bolts, rod and holes are seen. The arrow in the scene moves the plane.</source>
        <translation>Choisissez Vue &gt; Coupes &gt; Coupe perpendiculaire à Y (Ctrl+Alt+Y)&#xa0;: le plan coupe les corps, et l&apos;on voit les vis, la tige et les trous. La flèche dans la scène déplace le plan.</translation>
    </message>
    <message>
        <source>Choose Assembly &gt; Plan the sequence (Ctrl+J): in which order are the parts removed? Each step has a certified motion. The rod is removed before the bolts, which have no room below it. A click on a row shows the step.</source>
        <translation>Choisissez Assemblage &gt; Planifier la séquence (Ctrl+J)&#xa0;: dans quel ordre les pièces se démontent-elles&#xa0;? Chaque étape a un mouvement certifié. La tige se démonte avant les vis, qui n&apos;ont pas de place sous elle. Un clic sur une ligne montre l&apos;étape.</translation>
    </message>
    <message>
        <source>Write the instruction</source>
        <translation>Écrire la gamme de montage</translation>
    </message>
    <message>
        <source>Choose the strategy Layers and press Find path (F5). It knows that the object does not fit through the slot and goes through P5. The path that it finds is certified free of penetration.</source>
        <translation>Choisissez la stratégie Couches et appuyez sur Chercher un chemin (F5). Elle sait que l&apos;objet ne passe pas par la fente, et passe par P5. Le chemin trouvé est certifié sans pénétration.</translation>
    </message>
    <message>
        <source>Now parts. Press Do it for me: it opens the sample &quot;Bolted brackets&quot; in place of the one that is open. It has two brackets on a plate, with bolts, a rod and nuts. With parts of your own, begin with File &gt; New from parts (Ctrl+N): STEP, mesh or URDF files.</source>
        <translation>Maintenant des pièces. Appuyez sur Le faire pour moi&#xa0;: l&apos;exemple «&#xa0;Équerres boulonnées&#xa0;» s&apos;ouvre à la place de celui qui est ouvert. Il a deux équerres sur une plaque, avec des vis, une tige et des écrous. Avec vos propres pièces, commencez par Fichier &gt; Nouveau à partir de pièces (Ctrl+N)&#xa0;: fichiers STEP, maillages ou URDF.</translation>
    </message>
    <message>
        <source>The slider Explode in the panel Sequence moves the parts apart, in the order of removal. Choose Assembly &gt; Sequence &gt; Save the sequence (Ctrl+Alt+E) and a name that ends in .html or .pdf: a work instruction with a picture of each step. Shift+F1 explains anything in the window; Ctrl+K finds any command.</source>
        <translation>Le curseur Éclater du panneau Séquence écarte les pièces, dans l&apos;ordre du démontage. Choisissez Assemblage &gt; Séquence &gt; Enregistrer la séquence (Ctrl+Alt+E) et un nom qui finit par .html ou .pdf&#xa0;: une gamme de montage avec une image de chaque étape. Maj+F1 explique tout dans la fenêtre&#xa0;; Ctrl+K trouve toute commande.</translation>
    </message>
    <message>
        <source>In the list of strategies (panel Interaction), choose Research, then GT, and press Find path (F5). The path leads through the slot P6, which is too narrow, and the run ends there: the panel Run &gt; Coarse plan says where and why.</source>
        <translation>Dans la liste des stratégies (panneau Interaction), choisissez Recherche, puis GT, et appuyez sur Chercher un chemin (F5). Le chemin passe par la fente P6, qui est trop étroite, et le calcul s&apos;y termine&#xa0;: le panneau Calcul &gt; Plan grossier dit où et pourquoi.</translation>
    </message>
    <message>
        <source>Click a row of the table in the panel Run &gt; Coarse plan (Alt+4). Each row is a step through one place, with the planner that found it. The scene marks the place of the step, and its attributes can be changed in the panel Product &gt; Places (Alt+2).</source>
        <translation>Cliquez une ligne du tableau dans le panneau Calcul &gt; Plan grossier (Alt+4). Chaque ligne est la traversée d&apos;un lieu, avec le planificateur qui l&apos;a trouvée. La scène marque le lieu de l&apos;étape, et ses attributs se modifient dans le panneau Produit &gt; Lieux (Alt+2).</translation>
    </message>
    <message>
        <source>Choose Assembly &gt; Find fits (Ctrl+I). The parts touch, as most CAD parts do. The panel Contacts &gt; Fits lists the pairs, with gap and allowance: the moving part is that much thinner against the other one. A click on a row marks the two parts.</source>
        <translation>Choisissez Assemblage &gt; Chercher les ajustements (Ctrl+I). Les pièces se touchent, comme la plupart des pièces CAO. Le panneau Contacts &gt; Ajustements énumère les paires, avec écart et amincissement&#xa0;: la pièce manipulée est d&apos;autant plus mince face à l&apos;autre. Un clic sur une ligne marque les deux pièces.</translation>
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
        <translation>%1&#xa0;: le fichier n&apos;est plus là.</translation>
    </message>
    <message>
        <source>%1: the file is as it was before these edits.</source>
        <translation>%1&#xa0;: le fichier est tel qu&apos;il était avant ces modifications.</translation>
    </message>
    <message>
        <source>%1: the file has changed since. You will be asked before it is overwritten.</source>
        <translation>%1&#xa0;: le fichier a changé depuis. Une confirmation sera demandée avant de le remplacer.</translation>
    </message>
    <message>
        <source>Unsaved edits were left</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>&amp;Open them</source>
        <translation>&amp;Ouvrir les modifications</translation>
    </message>
    <message>
        <source>&amp;Discard them</source>
        <translation>&amp;Supprimer les modifications</translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation>Demander &amp;plus tard</translation>
    </message>
    <message>
        <source>Glissade ended unexpectedly. Edits of the scenario &quot;%1&quot; from %2 are still there.</source>
        <translation>Glissade s&apos;est arrêté de façon inattendue. Des modifications du scénario «&#xa0;%1&#xa0;» du %2 sont encore là.</translation>
    </message>
    <message>
        <source>Glissade ended unexpectedly. The edits from %1 are damaged and cannot be opened.</source>
        <translation>Glissade s&apos;est arrêté de façon inattendue. Les modifications du %1 sont endommagées et ne peuvent pas être ouvertes.</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>All bodies of the scenario: the moving part with its start and goal, and the obstacles. A checked box draws a body. Below are position and angles of what is selected.</source>
        <translation>Tous les corps du scénario&#xa0;: la pièce manipulée avec son départ et son but, et les obstacles. La case affiche ou masque un corps. Au-dessous&#xa0;: la position et les angles de la sélection.</translation>
    </message>
    <message>
        <source>What is known of places and bodies. Above are the places with their complexity and width, below the attributes of what is selected. The coarse path follows each change at once.</source>
        <translation>Ce que l&apos;on sait des lieux et des corps. En haut&#xa0;: les lieux, leur complexité et leur largeur&#xa0;; en bas&#xa0;: les attributs de la sélection. Le chemin grossier est recalculé à chaque modification.</translation>
    </message>
    <message>
        <source>The pairs of bodies that touch or overlap as designed, with their kind and the allowance that planning takes. The menu of a row accepts a clash or marks a thread.</source>
        <translation>Les paires de corps qui se touchent ou se recouvrent par conception, avec leur type et l&apos;amincissement que prend la planification. Le menu d&apos;une ligne permet d&apos;accepter une interférence ou de déclarer un filetage.</translation>
    </message>
    <message>
        <source>Figures of the run: iterations, nodes and edges of the two trees, configurations by who drew them, and the nearest obstacle of the object.</source>
        <translation>Chiffres du calcul&#xa0;: itérations, nœuds et arêtes des deux arbres, configurations selon leur auteur, et l&apos;obstacle le plus proche de l&apos;objet.</translation>
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
        <source>The paths that the scenario keeps. Each is certified again when the scenario is opened or arranged. A checked box draws a path in the scene.</source>
        <translation>Les chemins conservés dans le scénario. Chacun est certifié de nouveau quand le scénario est ouvert ou modifié. La case affiche un chemin dans la scène.</translation>
    </message>
    <message>
        <source>All messages since the program was started.</source>
        <translation>Tous les messages depuis le démarrage du programme.</translation>
    </message>
    <message>
        <source>In which order the parts of the product are removed, each with a certified motion. A click on a row shows the step. Rows can be dragged, locked and moved by hand.</source>
        <translation>L&apos;ordre dans lequel les pièces du produit se démontent, chacune par un mouvement certifié. Un clic sur une ligne montre l&apos;étape. Une étape peut être déplacée, verrouillée ou faite à la main.</translation>
    </message>
    <message>
        <source>Why no path was found: where the trees come nearest, which body stands between them, and how much is missing.</source>
        <translation>Pourquoi aucun chemin n&apos;a été trouvé&#xa0;: où les arbres sont les plus proches, quel corps les sépare, et combien il manque.</translation>
    </message>
    <message>
        <source>Files, undo, the run, and views of the scene.</source>
        <translation>Fichiers, annulation, calcul et vues de la scène.</translation>
    </message>
    <message>
        <source>The recorded run that is replayed, step by step.</source>
        <translation>L&apos;enregistrement que l&apos;on relit, pas à pas.</translation>
    </message>
    <message>
        <source>What can be opened: new parts, recent files and samples.</source>
        <translation>Ce que l&apos;on peut ouvrir&#xa0;: nouvelles pièces, fichiers récents et exemples.</translation>
    </message>
    <message>
        <source>The name of the body. A checked box draws it.</source>
        <translation>Nom du corps. La case l&apos;affiche ou le masque.</translation>
    </message>
    <message>
        <source>Moving part, static body, or mobile body. A static body keeps its place; a person can move a mobile one out of the way.</source>
        <translation>Pièce manipulée, corps statique ou corps mobile. Un corps statique garde sa place&#xa0;; une personne peut écarter un corps mobile.</translation>
    </message>
    <message>
        <source>How many triangles its surface has.</source>
        <translation>Nombre de triangles de sa surface.</translation>
    </message>
    <message>
        <source>A place or a body. F2 renames a place.</source>
        <translation>Un lieu ou un corps. F2 renomme un lieu.</translation>
    </message>
    <message>
        <source>How hard the place is to pass, from its width and from what clutters it.</source>
        <translation>Difficulté de traversée, d&apos;après la largeur du lieu et ce qui l&apos;encombre.</translation>
    </message>
    <message>
        <source>How wide the place is at its narrowest.</source>
        <translation>Largeur du lieu à son endroit le plus étroit.</translation>
    </message>
    <message>
        <source>The name of the attribute. Your own can be renamed and removed.</source>
        <translation>Nom de l&apos;attribut. Les attributs personnels peuvent être renommés et supprimés.</translation>
    </message>
    <message>
        <source>Its value for what is selected.</source>
        <translation>Sa valeur pour la sélection.</translation>
    </message>
    <message>
        <source>How they meet: planar, cylindrical, thread, press, overlap, contact or clash.</source>
        <translation>Type de contact&#xa0;: plan, cylindrique, filetage, serrage, recouvrement, contact ou interférence.</translation>
    </message>
    <message>
        <source>The distance of the surfaces; negative where the bodies overlap.</source>
        <translation>Distance des surfaces&#xa0;; négative si les corps se recouvrent.</translation>
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
        <source>By how much the object is thinner against the other body.</source>
        <translation>Amincissement de l&apos;objet face à l&apos;autre corps.</translation>
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
        <translation>Le lieu vers lequel elle mène.</translation>
    </message>
    <message>
        <source>The planner that searches the step.</source>
        <translation>Le planificateur qui calcule l&apos;étape.</translation>
    </message>
    <message>
        <source>Random configurations that were drawn for the step.</source>
        <translation>Configurations aléatoires tirées pour l&apos;étape.</translation>
    </message>
    <message>
        <source>The name of the path. A checked box draws it.</source>
        <translation>Nom du chemin. La case l&apos;affiche ou le masque.</translation>
    </message>
    <message>
        <source>Whether the path is certified in the present arrangement.</source>
        <translation>Si le chemin est certifié dans la disposition actuelle.</translation>
    </message>
    <message>
        <source>The smallest distance to other bodies along the path.</source>
        <translation>La plus petite distance aux autres corps le long du chemin.</translation>
    </message>
    <message>
        <source>The length of the path of the reference point.</source>
        <translation>Longueur du chemin du point de référence.</translation>
    </message>
    <message>
        <source>By how much the object turns along the path.</source>
        <translation>Rotation totale de l&apos;objet le long du chemin.</translation>
    </message>
    <message>
        <source>The strategy that found it.</source>
        <translation>La stratégie qui l&apos;a trouvé.</translation>
    </message>
    <message>
        <source>The seed of that run: the same seed gives the same path.</source>
        <translation>La graine de ce calcul&#xa0;: la même graine donne le même chemin.</translation>
    </message>
    <message>
        <source>The largest allowance that the path needs.</source>
        <translation>Le plus grand amincissement dont le chemin a besoin.</translation>
    </message>
    <message>
        <source>The number of the step.</source>
        <translation>Le numéro de l&apos;étape.</translation>
    </message>
    <message>
        <source>The part that is removed or assembled, and the kind of its motion.</source>
        <translation>La pièce démontée ou montée, et le type de son mouvement.</translation>
    </message>
    <message>
        <source>The smallest distance to other parts, and the largest allowance.</source>
        <translation>La plus petite distance aux autres pièces, et le plus grand amincissement.</translation>
    </message>
    <message>
        <source>The tool that turns a fastener, and which parts need support.</source>
        <translation>L&apos;outil qui tourne une fixation, et les pièces à maintenir.</translation>
    </message>
    <message>
        <source>Whether the independent check agrees, and which constraints the step violates.</source>
        <translation>Accord de la vérification indépendante, et contraintes que l&apos;étape ne respecte pas.</translation>
    </message>
    <message>
        <source>The place that was examined.</source>
        <translation>L&apos;endroit examiné.</translation>
    </message>
    <message>
        <source>The distance or the overlap there.</source>
        <translation>La distance ou le recouvrement à cet endroit.</translation>
    </message>
    <message>
        <source>The body that is nearest there.</source>
        <translation>Le corps le plus proche à cet endroit.</translation>
    </message>
    <message>
        <source>When the message came.</source>
        <translation>Heure du message.</translation>
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
        <translation>Panneaux superposés. Alt et un chiffre mettent un panneau au premier plan&#xa0;; Vue &gt; Panneaux les affiche et les masque.</translation>
    </message>
    <message>
        <source>All commands. Ctrl+K finds one by a part of its name.</source>
        <translation>Toutes les commandes. Ctrl+K en trouve une par une partie de son nom.</translation>
    </message>
    <message>
        <source>What the program is doing, what keys and devices move, and devices.</source>
        <translation>L&apos;activité du programme, ce que déplacent les touches et les périphériques, et les périphériques eux-mêmes.</translation>
    </message>
    <message>
        <source>The settings of the next run. The strategy is the planner. The operator holds the object: you, a device, or a simulated person. The sliders can be moved during a run.</source>
        <translation>Réglages du prochain calcul. La stratégie est le planificateur. L&apos;opérateur tient l&apos;objet&#xa0;: vous, un périphérique ou une personne simulée. Les curseurs peuvent être déplacés pendant le calcul.</translation>
    </message>
    <message>
        <source>Where the value comes from: computed from geometry, a class of bodies, or you.</source>
        <translation>Origine de la valeur&#xa0;: calcul géométrique, classe de corps, ou vous.</translation>
    </message>
    <message>
        <source>Removes your value.</source>
        <translation>Annule votre valeur.</translation>
    </message>
    <message>
        <source>The result of the step.</source>
        <translation>Le résultat de l&apos;étape.</translation>
    </message>
    <message>
        <source>Planes that cut bodies open in the view: across an axis, or along a face. Arrows in the scene drag them. Planning ignores them.</source>
        <translation>Plans qui coupent les corps dans la vue&#xa0;: perpendiculaires à un axe, ou le long d&apos;une face. Des flèches dans la scène les déplacent. La planification n&apos;en tient pas compte.</translation>
    </message>
    <message>
        <source>How the bodies are joined: screws, nuts, inserts, pins, units. The menu of a row confirms or dissolves joints. Assembly plans keep to them.</source>
        <translation>Comment les corps sont liés&#xa0;: vis, écrous, inserts, goupilles, unités. Le menu d&apos;une ligne confirme ou supprime des liaisons. Les plans d&apos;assemblage les respectent.</translation>
    </message>
    <message>
        <source>The body that is removed: the screw, the nut, the insert, the pin.</source>
        <translation>Le corps démonté&#xa0;: la vis, l&apos;écrou, l&apos;insert, la goupille.</translation>
    </message>
    <message>
        <source>What it is joined with, and what it clamps.</source>
        <translation>À quoi il est lié, et ce qu&apos;il serre.</translation>
    </message>
    <message>
        <source>The designation or the size of the thread, and the turns until it is free.</source>
        <translation>La désignation ou la taille du filetage, et les tours jusqu&apos;à ce qu&apos;il soit libre.</translation>
    </message>
    <message>
        <source>Recognised by shape, suggested by name or class, or user-defined. A (?) marks doubt.</source>
        <translation>Reconnue à la forme, proposée par le nom ou la classe, ou définie par l&apos;utilisateur. Un (?) marque un doute.</translation>
    </message>
    <message>
        <source>How they are joined: screw, nut, thread, insert, pin, snap, flexible, permanent, unit.</source>
        <translation>Comment ils sont liés&#xa0;: vis, écrou, filetage, insert, goupille, clip, souple, permanente, unité.</translation>
    </message>
    <message>
        <source>The product: its bodies, and the places of the free space.</source>
        <translation>Le produit&#xa0;: ses corps, et les lieux de l&apos;espace libre.</translation>
    </message>
    <message>
        <source>How the bodies of the product touch, and how they are joined.</source>
        <translation>Comment les corps du produit se touchent, et comment ils sont liés.</translation>
    </message>
    <message>
        <source>The scene. Drag to orbit, middle-drag to pan, wheel to zoom, double-click to fit. A click selects a body, or a place while places are shown; Ctrl+Shift and a drag select all bodies in a box. The right button opens a menu. Keys move the object (Ctrl+F1 lists them).</source>
        <translation>La scène. Bouton gauche&#xa0;: tourner&#xa0;; bouton du milieu&#xa0;: déplacer&#xa0;; molette&#xa0;: zoomer&#xa0;; double clic&#xa0;: cadrer. Un clic sélectionne un corps, ou un lieu quand les lieux sont affichés&#xa0;; Ctrl+Maj et un glissement sélectionnent tous les corps dans un rectangle. Le bouton droit ouvre un menu. Les touches déplacent l&apos;objet (Ctrl+F1 les énumère).</translation>
    </message>
</context>
<context>
    <name>WorkTimes</name>
    <message>
        <source>Default: %1 %3. It is an estimate of the size of the tables for manual assembly in Boothroyd, Dewhurst and Knight, Product Design for Manufacture and Assembly (2011), and was not measured. Values from 0 to %2 %3 are taken.</source>
        <translation>Valeur par défaut&#xa0;: %1 %3. C&apos;est une estimation de l&apos;ordre des tables d&apos;assemblage manuel de Boothroyd, Dewhurst et Knight, Product Design for Manufacture and Assembly (2011), et elle n&apos;a pas été mesurée. Les valeurs de 0 à %2 %3 sont acceptées.</translation>
    </message>
</context>
<context>
    <name>glissade::AccessController</name>
    <message>
        <source>Hand access was not checked</source>
        <translation>L&apos;accès de la main n&apos;a pas été vérifié</translation>
    </message>
    <message>
        <source>Hand (%1): %2 of %3 steps are reachable and visible; sampled, no proof</source>
        <translation>Main (%1)&#xa0;: %2 étapes sur %3 sont accessibles et visibles&#xa0;; par échantillons, sans preuve</translation>
    </message>
    <message>
        <source>Checking hand access</source>
        <translation>Vérification de l&apos;accès de la main</translation>
    </message>
    <message>
        <source>Hand (%1): %2; sampled, no proof</source>
        <translation>Main (%1)&#xa0;: %2&#xa0;; par échantillons, sans preuve</translation>
    </message>
    <message>
        <source>Hand access to all steps</source>
        <translation>Accès de la main à toutes les étapes</translation>
    </message>
</context>
<context>
    <name>glissade::AccessTexts</name>
    <message>
        <source>The hand reaches the work, and pushes at the end</source>
        <translation>La main accède au travail, et pousse à la fin</translation>
    </message>
    <message>
        <source>The hand reaches the work</source>
        <translation>La main accède au travail</translation>
    </message>
    <message>
        <source>No grasp by one hand was found</source>
        <translation>Aucune prise d&apos;une main n&apos;a été trouvée</translation>
    </message>
    <message>
        <source>Hand access was not checked</source>
        <translation>L&apos;accès de la main n&apos;a pas été vérifié</translation>
    </message>
    <message>
        <source>The hand is blocked at %1 % of the motion</source>
        <translation>La main est bloquée à %1 % du mouvement</translation>
    </message>
    <message>
        <source>The hand is blocked by %1 at %2 % of the motion</source>
        <translation>La main est bloquée par %1 à %2 % du mouvement</translation>
    </message>
    <message>
        <source>%1 % of the work is visible</source>
        <translation>%1 % du travail est visible</translation>
    </message>
    <message>
        <source>%1, hidden by %2</source>
        <translation>%1, caché par %2</translation>
    </message>
    <message>
        <source>no grasp</source>
        <translation>sans prise</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>accessible</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>non visible</translation>
    </message>
    <message>
        <source>5th percentile of women</source>
        <translation>5e centile des femmes</translation>
    </message>
    <message>
        <source>95th percentile of men</source>
        <translation>95e centile des hommes</translation>
    </message>
    <message>
        <source>average</source>
        <translation>moyenne</translation>
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
        <translation>C&apos;est une surface libre&#xa0;: elle n&apos;a ni plan ni axe.</translation>
    </message>
    <message>
        <source>This is the moving part. Click another body. Esc ends this.</source>
        <translation>C&apos;est la pièce manipulée. Cliquer un autre corps. Échap termine.</translation>
    </message>
    <message>
        <source>Click to align: %1 with %2 of %3, %4. Esc ends this.</source>
        <translation>Cliquer pour aligner&#xa0;: %1 avec %2 de %3, %4. Échap termine.</translation>
    </message>
    <message>
        <source>Click the moving part: %1 of %2. Esc ends this.</source>
        <translation>Cliquer la pièce manipulée&#xa0;: %1 de %2. Échap termine.</translation>
    </message>
    <message>
        <source>Click the vertex, edge or face of another body that it goes onto. Esc ends this.</source>
        <translation>Cliquer le sommet, l&apos;arête ou la face d&apos;un autre corps sur lequel il va. Échap termine.</translation>
    </message>
    <message>
        <source>Click a vertex, an edge or a face of the moving part. Esc ends this.</source>
        <translation>Cliquer un sommet, une arête ou une face de la pièce manipulée. Échap termine.</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>cône</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>tore</translation>
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
        <translation>%1, dans n&apos;importe quelle unité&#xa0;: 25,4 mm, 1 in, 30 deg</translation>
    </message>
    <message>
        <source>Arranging: click a body, the start or the goal</source>
        <translation>Disposition&#xa0;: cliquez un corps, le départ ou le but</translation>
    </message>
    <message>
        <source>Arranging %1</source>
        <translation>Disposition&#xa0;: %1</translation>
    </message>
    <message>
        <source>“%1” is not a step. Write 10, 25.4 mm, 1 in or 30 deg.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un pas. Écrivez 10, 25,4 mm, 1 in ou 30 deg.</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; Ctrl suspends snapping. Drag the body itself, with Ctrl to turn it. Arrow keys and Page Up/Down move by a step, with Shift they turn. Esc ends arranging.</source>
        <translation>Tirer une flèche, un carré ou un anneau&#xa0;; Ctrl suspend l&apos;accrochage. Tirer le corps lui-même, avec Ctrl pour le tourner. Les flèches du clavier et Page préc./suiv. déplacent d&apos;un pas, avec Maj elles tournent. Échap termine.</translation>
    </message>
    <message>
        <source>To faces</source>
        <translation>Aux faces</translation>
    </message>
    <message>
        <source>Snapped: %1. Ctrl suspends snapping.</source>
        <translation>Accroché&#xa0;: %1. Ctrl suspend l&apos;accrochage.</translation>
    </message>
</context>
<context>
    <name>glissade::ArrangeController</name>
    <message>
        <source>%1 is aligned. %2 reverses the direction.</source>
        <translation>%1&#xa0;: aligné. %2 le retourne.</translation>
    </message>
    <message>
        <source>%1 is aligned.</source>
        <translation>%1&#xa0;: aligné.</translation>
    </message>
</context>
<context>
    <name>glissade::AssemblyController</name>
    <message>
        <source>Search bodies</source>
        <translation>Rechercher des corps</translation>
    </message>
    <message>
        <source>Goal: removed</source>
        <translation>But&#xa0;: démonté</translation>
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
        <source>Moving part: %1</source>
        <translation>Pièce manipulée&#xa0;: %1</translation>
    </message>
    <message>
        <source>Start and goal have no collisions.</source>
        <translation>Le départ et le but sont sans collision.</translation>
    </message>
    <message>
        <source>Resolve start and goal collisions</source>
        <translation>Résoudre les collisions du départ et du but</translation>
    </message>
    <message>
        <source>Collisions resolved: %1</source>
        <translation>Collisions résolues&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>Opération impossible</translation>
    </message>
    <message>
        <source>Resolving start and goal collisions</source>
        <translation>Résolution des collisions du départ et du but</translation>
    </message>
    <message>
        <source>the goal was moved by %1</source>
        <translation>le but a été déplacé de %1</translation>
    </message>
    <message>
        <source>the start was moved by %1</source>
        <translation>le départ a été déplacé de %1</translation>
    </message>
    <message>
        <source>Exclude %1</source>
        <translation>Exclure %1</translation>
    </message>
    <message>
        <source>Exclude bodies</source>
        <translation>Exclure des corps</translation>
    </message>
    <message>
        <source>Include bodies</source>
        <translation>Inclure des corps</translation>
    </message>
    <message numerus="yes">
        <source>Moving part: %1 and %n more</source>
        <translation>
            <numerusform>Pièce manipulée&#xa0;: %1 et %n autre</numerusform>
            <numerusform>Pièce manipulée&#xa0;: %1 et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
</context>
<context>
    <name>glissade::AssistController</name>
    <message>
        <source>No place to help was found.</source>
        <translation>Aucun endroit où aider n&apos;a été trouvé.</translation>
    </message>
    <message>
        <source>Looking for places to help</source>
        <translation>Recherche des endroits où aider</translation>
    </message>
    <message>
        <source>Place to help %1 of %2:</source>
        <translation>Endroit où aider, %1 sur %2&#xa0;:</translation>
    </message>
    <message>
        <source>the passage is open.</source>
        <translation>le passage est ouvert.</translation>
    </message>
    <message>
        <source>needs up to %1 more room at %2.</source>
        <translation>il faut jusqu&apos;à %1 de place en plus contre %2.</translation>
    </message>
    <message>
        <source>needs up to %1 more room.</source>
        <translation>il faut jusqu&apos;à %1 de place en plus.</translation>
    </message>
    <message>
        <source>Lead it along the arrow; %1: next place.</source>
        <translation>Menez-le le long de la flèche&#xa0;; %1&#xa0;: endroit suivant.</translation>
    </message>
    <message>
        <source>%1 takes your hand there.</source>
        <translation>%1 y conduit votre main.</translation>
    </message>
    <message>
        <source>%1: next place.</source>
        <translation>%1&#xa0;: endroit suivant.</translation>
    </message>
    <message>
        <source>the computer has not found a way through yet.</source>
        <translation>l&apos;ordinateur n&apos;a pas encore trouvé de passage.</translation>
    </message>
    <message>
        <source>%1 is in the way, and the computer has not found a way past it yet.</source>
        <translation>%1 fait obstacle, et l&apos;ordinateur n&apos;a pas encore trouvé comment le passer.</translation>
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
        <translation>Signification</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>0, or the nearest in range</source>
        <translation>0, ou la valeur admise la plus proche</translation>
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
    <message>
        <source>by volume</source>
        <translation>par le volume</translation>
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
        <source>Remove the edit and use the computed value</source>
        <translation>Annuler la modification et reprendre la valeur calculée</translation>
    </message>
    <message>
        <source>of its assembly</source>
        <translation>de son assemblage</translation>
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
        <source>Computer: random configurations. Operator: where he held the object. Contact: drawn on the tangent plane of his nearest obstacle.</source>
        <translation>Ordinateur&#xa0;: configurations aléatoires. Opérateur&#xa0;: positions où il tenait l&apos;objet. Contact&#xa0;: tirées sur le plan tangent de l&apos;obstacle le plus proche.</translation>
    </message>
</context>
<context>
    <name>glissade::AxisBar</name>
    <message>
        <source>Thin: as the device reports it. Thick: after shaping. Hatched: the dead zone.</source>
        <translation>Trait fin&#xa0;: valeur du périphérique. Trait épais&#xa0;: après mise en forme. Hachures&#xa0;: zone morte.</translation>
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
    <name>glissade::BusyBar</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
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
        <translation>Les réglages ne peuvent pas être écrits&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
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
        <translation>connecté&#xa0;: %1</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
    <message>
        <source>&amp;Reset the device</source>
        <translation>Réi&amp;nitialiser le périphérique</translation>
    </message>
    <message>
        <source>Restores the original curves and buttons of this device</source>
        <translation>Rétablir les courbes et les boutons d&apos;origine de ce périphérique</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Gâchette</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Lower button</source>
        <translation>Bouton du bas</translation>
    </message>
    <message>
        <source>Upper button</source>
        <translation>Bouton du haut</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Stick</translation>
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
        <translation>aucun corps proche</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 avec %2</translation>
    </message>
    <message>
        <source>measuring the clearance</source>
        <translation>mesure du jeu en cours</translation>
    </message>
</context>
<context>
    <name>glissade::ColourButton</name>
    <message>
        <source>Follow theme</source>
        <translation>Suivre le thème</translation>
    </message>
</context>
<context>
    <name>glissade::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Trouver une commande</translation>
    </message>
    <message>
        <source>Part of a command&apos;s name, or another word for it</source>
        <translation>Partie du nom d&apos;une commande, ou mot de même sens</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>No command found for &quot;%1&quot;.</source>
        <translation>Aucune commande trouvée pour «&#xa0;%1&#xa0;».</translation>
    </message>
</context>
<context>
    <name>glissade::ComparePathsDialog</name>
    <message>
        <source>accepted clash, %1</source>
        <translation>interférence acceptée, %1</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
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
        <source>Certified clearance</source>
        <translation>Jeu certifié</translation>
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
        <translation>Amincissements</translation>
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
    <name>glissade::ContextMenus</name>
    <message>
        <source>&amp;Display</source>
        <translation>&amp;Affichage</translation>
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
        <translation>Passages dans la boucle de l&apos;algorithme de l&apos;article</translation>
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
        <source>Random configurations</source>
        <translation>Configurations aléatoires</translation>
    </message>
    <message>
        <source>Drawn by the computer, kept or not</source>
        <translation>Tirées par l&apos;ordinateur, conservées ou non</translation>
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
        <source>Drawn on tangent planes, kept or not</source>
        <translation>Tirées sur les plans tangents, conservées ou non</translation>
    </message>
    <message>
        <source>Contact mode</source>
        <translation>Mode contact</translation>
    </message>
    <message>
        <source>On while contact samples are drawn</source>
        <translation>Actif pendant le tirage des échantillons de contact</translation>
    </message>
    <message>
        <source>Nearest obstacle</source>
        <translation>Obstacle le plus proche</translation>
    </message>
    <message>
        <source>Of the object in the operator&apos;s hand</source>
        <translation>Pour l&apos;objet tenu par l&apos;opérateur</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>To the nearest obstacle</source>
        <translation>Distance à l&apos;obstacle le plus proche</translation>
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
    <message>
        <source>Your hand showed %1 configurations. In collision: %2; moved to contact: %3.</source>
        <translation>Votre main a montré %1 configurations. En collision&#xa0;: %2&#xa0;; ramenées au contact&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Your way joined start and goal.</source>
        <translation>Votre trajet a relié le départ et le but.</translation>
    </message>
    <message>
        <source>The computer joined start and goal.</source>
        <translation>L&apos;ordinateur a relié le départ et le but.</translation>
    </message>
    <message>
        <source>The path follows your way for %1 % of its length.</source>
        <translation>Le chemin suit votre trajet sur %1&#xa0;% de sa longueur.</translation>
    </message>
    <message>
        <source>Edges, both directions</source>
        <translation>Arêtes, dans les deux sens</translation>
    </message>
    <message>
        <source>Each edge counts twice, as in the papers&apos; tables</source>
        <translation>Chaque arête compte deux fois, comme dans les tableaux des articles</translation>
    </message>
    <message>
        <source>Duration of the run</source>
        <translation>Durée de l’exécution</translation>
    </message>
    <message>
        <source>Includes the person&apos;s time; pauses do not count</source>
        <translation>Comprend le temps de la personne&#xa0;; les pauses ne comptent pas</translation>
    </message>
    <message>
        <source>Processor time</source>
        <translation>Temps de processeur</translation>
    </message>
    <message>
        <source>Time in which the computer planned; the processors&apos; times are added</source>
        <translation>Temps pendant lequel l’ordinateur a planifié&#xa0;; les temps des processeurs sont additionnés</translation>
    </message>
    <message>
        <source>Steps per second of the run</source>
        <translation>Étapes par seconde d’exécution</translation>
    </message>
    <message>
        <source>Planner steps in a second of the duration, in which a person steers; Pace limits them</source>
        <translation>Étapes du planificateur par seconde de la durée, pendant laquelle une personne dirige&#xa0;; la cadence les limite</translation>
    </message>
</context>
<context>
    <name>glissade::DeviceController</name>
    <message>
        <source>6D mouse: %1</source>
        <translation>Souris 6D&#xa0;: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>No 6D mouse, or spacenavd does not run; looked for again and again</source>
        <translation>Aucune souris 6D, ou spacenavd n&apos;est pas lancé&#xa0;; la recherche continue</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>Manette&#xa0;: %1</translation>
    </message>
    <message>
        <source>Moves: camera</source>
        <translation>Déplace&#xa0;: caméra</translation>
    </message>
    <message>
        <source>Moves: object</source>
        <translation>Déplace&#xa0;: objet</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
</context>
<context>
    <name>glissade::DifficultyController</name>
    <message>
        <source>Looking for the reasons</source>
        <translation>Recherche des causes</translation>
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
        <source>Place on the path of least penetration</source>
        <translation>Position sur le chemin de moindre pénétration</translation>
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
        <source>Tightest passage reached</source>
        <translation>Passage le plus étroit atteint</translation>
    </message>
    <message>
        <source>Shows the object there</source>
        <translation>Montre l&apos;objet à cet endroit</translation>
    </message>
    <message>
        <source>There is a path if the object may overlap &lt;b&gt;%2&lt;/b&gt; by &lt;b&gt;%1&lt;/b&gt;.</source>
        <translation>Il existe un chemin si l&apos;objet peut recouvrir &lt;b&gt;%2&lt;/b&gt; de &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>Distance between the trees</source>
        <translation>Écart entre les arbres</translation>
    </message>
    <message>
        <source>No path was found, even for an object as thin as its thickness allows.</source>
        <translation>Aucun chemin n&apos;a été trouvé, même pour un objet aminci autant que son épaisseur le permet.</translation>
    </message>
    <message>
        <source>Reasons why there is no path</source>
        <translation>Causes de l&apos;absence de chemin</translation>
    </message>
    <message>
        <source>Your hand may find the path.</source>
        <translation>Votre main trouvera peut-être le chemin.</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>open</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>Place to help %1</source>
        <translation>Endroit où aider %1</translation>
    </message>
</context>
<context>
    <name>glissade::DocumentController</name>
    <message>
        <source>Arranging the product</source>
        <translation>Disposition du produit</translation>
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
    <message>
        <source>The milestone was not moved</source>
        <translation>Le jalon n&apos;a pas été déplacé</translation>
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
        <source>the path found</source>
        <translation>le chemin trouvé</translation>
    </message>
    <message>
        <source>the assembly plan</source>
        <translation>le plan d&apos;assemblage</translation>
    </message>
    <message>
        <source>Open re&amp;cent</source>
        <translation>&amp;Fichiers récents</translation>
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
        <source>Open a scenario or a product</source>
        <translation>Ouvrir un scénario ou un produit</translation>
    </message>
    <message>
        <source>Scenarios and parts (%1 %2);;Scenarios (%1);;Parts (%2);;All files (*)</source>
        <translation>Scénarios et pièces (%1 %2);;Scénarios (%1);;Pièces (%2);;Tous les fichiers (*)</translation>
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
        <source>End what is under way?</source>
        <translation>Interrompre le travail en cours ?</translation>
    </message>
    <message>
        <source>Under way: %1.</source>
        <translation>En cours&#xa0;: %1.</translation>
    </message>
    <message>
        <source>It goes on while this question is open. It is lost where it is ended now.</source>
        <translation>Il continue tant que cette question est ouverte. Il est perdu s&apos;il est interrompu maintenant.</translation>
    </message>
    <message>
        <source>&amp;End it</source>
        <translation>&amp;Interrompre</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>Enregistrer les modifications&#xa0;?</translation>
    </message>
    <message>
        <source>Save changes to &quot;%1&quot;?</source>
        <translation>Enregistrer les modifications de «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>Not saved: %1.</source>
        <translation>Non enregistré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Save a copy of the sample</source>
        <translation>Enregistrer une copie de l&apos;exemple</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Keep the path?</source>
        <translation>Conserver le chemin&#xa0;?</translation>
    </message>
    <message>
        <source>Keep the path of &quot;%1&quot;?</source>
        <translation>Conserver le chemin de «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Keep path</source>
        <translation>&amp;Conserver le chemin</translation>
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
    <name>glissade::FinenessBox</name>
    <message>
        <source>Mesh tolerance of STEP files</source>
        <translation>Tolérance de maillage des fichiers STEP</translation>
    </message>
    <message>
        <source>How far triangles may be off the surfaces of STEP files. A finer tolerance allows smaller gaps and takes longer; automatic: a thousandth of the diagonal of each part, from 0.01 to 0.5 mm</source>
        <translation>Écart maximal entre les triangles et les surfaces des fichiers STEP. Une tolérance plus fine permet des écarts plus petits entre les pièces et prend plus de temps&#xa0;; automatique&#xa0;: un millième de la diagonale de chaque pièce, de 0,01 à 0,5 mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Mesh tolerance: </source>
        <translation>Tolérance de maillage&#xa0;: </translation>
    </message>
    <message>
        <source>Mesh tolerance: automatic</source>
        <translation>Tolérance de maillage&#xa0;: automatique</translation>
    </message>
</context>
<context>
    <name>glissade::FitsController</name>
    <message>
        <source>The fits cannot be found</source>
        <translation>Les ajustements ne peuvent pas être trouvés</translation>
    </message>
    <message>
        <source>accept a clash</source>
        <translation>accepter une interférence</translation>
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
        <source>%1 without what overlaps, up to %2 deep</source>
        <translation>%1 sans ce qui le recouvre, jusqu&apos;à %2 de profondeur</translation>
    </message>
    <message>
        <source>Allowance of %1: %2</source>
        <translation>Amincissement de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>No allowance for either body</source>
        <translation>Aucun amincissement pour les deux corps</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>dégagé</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>admis</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>clash</source>
        <translation>interférence</translation>
    </message>
    <message>
        <source>%1 overlap</source>
        <translation>recouvrement %1</translation>
    </message>
    <message>
        <source>%1 gap</source>
        <translation>écart %1</translation>
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
        <translation>Écart</translation>
    </message>
    <message>
        <source>Negative where the bodies overlap</source>
        <translation>Négatif si les corps se recouvrent</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Amincissement</translation>
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
        <translation>Paires de corps&#xa0;: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>glissade::GhostRow</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>number</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>every</source>
        <translation>tous les</translation>
    </message>
    <message>
        <source>Ghosts of the object along the path</source>
        <translation>Fantômes de l&apos;objet le long du chemin</translation>
    </message>
    <message>
        <source>Draw the object along the path: not at all, at a number of places, or every so many millimetres</source>
        <translation>Dessiner l&apos;objet le long du chemin&#xa0;: pas du tout, en un nombre de lieux, ou tous les tant de millimètres</translation>
    </message>
    <message>
        <source>Number of ghosts</source>
        <translation>Nombre de fantômes</translation>
    </message>
    <message>
        <source>Number of ghosts between start and goal</source>
        <translation>Nombre de fantômes entre le départ et le but</translation>
    </message>
    <message>
        <source>Spacing of ghosts</source>
        <translation>Espacement des fantômes</translation>
    </message>
    <message>
        <source>Spacing of ghosts, in any unit: 25.4 mm, 1 in. Turns count as far as they move the object. At most %1 are drawn.</source>
        <translation>Espacement des fantômes, dans une unité quelconque&#xa0;: 25,4 mm, 1 in. Les rotations comptent autant qu&apos;elles déplacent l&apos;objet. Au plus %1 sont dessinés.</translation>
    </message>
    <message>
        <source>Ghosts</source>
        <translation>Fantômes</translation>
    </message>
</context>
<context>
    <name>glissade::HandHint</name>
    <message>
        <source>Hold %1</source>
        <translation>Maintenez %1</translation>
    </message>
    <message>
        <source>To the goal: %1</source>
        <translation>Jusqu’au but&#xa0;: %1</translation>
    </message>
    <message>
        <source>keys move the object again</source>
        <translation>les touches déplacent de nouveau l’objet</translation>
    </message>
    <message>
        <source>keys move the camera</source>
        <translation>les touches déplacent la caméra</translation>
    </message>
    <message>
        <source>A D W S Q E: move · J L I K U O: turn · Shift: slow · F: change the axes (now: %1) · %2: %3 · %4: go where the search is stuck</source>
        <translation>A D W S Q E&#xa0;: déplacer · J L I K U O&#xa0;: tourner · Maj&#xa0;: lentement · F&#xa0;: changer d’axes (maintenant&#xa0;: %1) · %2&#xa0;: %3 · %4&#xa0;: aller où la recherche est bloquée</translation>
    </message>
    <message>
        <source>Touches %1: turn the object, or go back.</source>
        <translation>Touche %1&#xa0;: tournez l&apos;objet, ou revenez en arrière.</translation>
    </message>
    <message>
        <source>Touches %1: back off or slide along it. Free: %2</source>
        <translation>Touche %1&#xa0;: reculez ou glissez le long. Libre&#xa0;: %2</translation>
    </message>
    <message>
        <source>Paused: press %1 to go on.</source>
        <translation>En pause&#xa0;: %1 pour continuer.</translation>
    </message>
    <message>
        <source>The run begins when you move the object.</source>
        <translation>Le calcul commence quand vous déplacez l&apos;objet.</translation>
    </message>
</context>
<context>
    <name>glissade::HeadController</name>
    <message>
        <source>The head cannot be tracked</source>
        <translation>La tête ne peut pas être suivie</translation>
    </message>
    <message>
        <source>The head is not tracked: nothing comes to port %1</source>
        <translation>La tête n&apos;est pas suivie&#xa0;: rien n&apos;arrive au port %1</translation>
    </message>
</context>
<context>
    <name>glissade::HeadDialog</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Receive from &amp;other machines, too</source>
        <translation>Recevoir aussi d&apos;&amp;autres machines</translation>
    </message>
    <message>
        <source>Head tracker</source>
        <translation>Capteur de tête</translation>
    </message>
    <message>
        <source>&amp;I sit straight before the screen</source>
        <translation>&amp;Je suis droit devant l&apos;écran</translation>
    </message>
    <message>
        <source>What the tracker sends now is the head at rest: press it while you look at the middle</source>
        <translation>Ce que le capteur envoie maintenant est la tête au repos&#xa0;: appuyez en regardant le milieu</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>Use the original axes, signs, delay and port again</source>
        <translation>Reprendre les axes, les signes, le retard et le port d&apos;origine</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Otherwise only programs of this machine can move the view</source>
        <translation>Sinon, seuls les programmes de cette machine peuvent bouger la vue</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>From</source>
        <translation>D&apos;après</translation>
    </message>
    <message>
        <source>Tracker sends</source>
        <translation>Le capteur envoie</translation>
    </message>
    <message>
        <source>Head has moved</source>
        <translation>La tête a bougé de</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>Vers vous</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Tourner à gauche</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Lever la tête</translation>
    </message>
    <message>
        <source>Tilt left</source>
        <translation>Pencher à gauche</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>lacet</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>tangage</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>roulis</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>inversé</translation>
    </message>
    <message>
        <source>The number of the tracker that this comes from</source>
        <translation>Le nombre du capteur dont cela provient</translation>
    </message>
    <message>
        <source>%1, inverted</source>
        <translation>%1, inversé</translation>
    </message>
    <message>
        <source>The tracker counts in the other direction</source>
        <translation>Le capteur compte dans l&apos;autre sens</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>More of it lets a head at rest tremble less; a head that moves is followed faster</source>
        <translation>Plus il est grand, moins une tête au repos tremble&#xa0;; une tête qui bouge est suivie plus vite</translation>
    </message>
    <message>
        <source>&amp;Delay of a head at rest</source>
        <translation>Retar&amp;d d&apos;une tête au repos</translation>
    </message>
    <message>
        <source>off</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>the head is tracked</source>
        <translation>la tête est suivie</translation>
    </message>
    <message>
        <source>nothing comes</source>
        <translation>rien n&apos;arrive</translation>
    </message>
    <message>
        <source>; dropped: %L1</source>
        <translation>&#xa0;; rejetés&#xa0;: %L1</translation>
    </message>
    <message>
        <source>now %L1 ms</source>
        <translation>maintenant %L1 ms</translation>
    </message>
    <message>
        <source>The settings cannot be written: %1</source>
        <translation>Les réglages ne peuvent pas être écrits&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>glissade::HeadsetController</name>
    <message>
        <source>Searching for a headset</source>
        <translation>Recherche d&apos;un casque</translation>
    </message>
    <message>
        <source>A headset needs an X display with OpenGL, and there is none. Retrying</source>
        <translation>Un casque demande un écran X avec OpenGL, et il n&apos;y en a pas. La recherche continue</translation>
    </message>
    <message>
        <source>No OpenXR runtime answers. Start the program of your headset. Retrying</source>
        <translation>Aucun moteur OpenXR ne répond. Démarrez le programme de votre casque. La recherche continue</translation>
    </message>
    <message>
        <source>The OpenXR runtime takes no pictures by OpenGL. Choose another one. Retrying</source>
        <translation>Le moteur OpenXR ne prend pas d&apos;images par OpenGL. Choisissez-en un autre. La recherche continue</translation>
    </message>
    <message>
        <source>No headset is connected. Connect one. Retrying</source>
        <translation>Aucun casque n&apos;est branché. Branchez-en un. La recherche continue</translation>
    </message>
    <message>
        <source>The headset was lost. Nothing else is lost. Searching again</source>
        <translation>Le casque est perdu. Rien d&apos;autre n&apos;est perdu. La recherche continue</translation>
    </message>
    <message>
        <source>The OpenXR runtime has ended. Nothing else is lost. Searching again</source>
        <translation>Le moteur OpenXR s&apos;est arrêté. Rien d&apos;autre n&apos;est perdu. La recherche continue</translation>
    </message>
    <message>
        <source>The headset does not work: %1. Retrying</source>
        <translation>Le casque ne fonctionne pas&#xa0;: %1. La recherche continue</translation>
    </message>
    <message>
        <source>The headset %1 is connected. Put it on</source>
        <translation>Le casque %1 est branché. Mettez-le</translation>
    </message>
    <message>
        <source>The headset was left. Choose View &gt; Headset to come back</source>
        <translation>Le casque a été quitté. Choisissez Vue &gt; Casque pour revenir</translation>
    </message>
    <message>
        <source>This program was built without OpenXR, or there is no display</source>
        <translation>Ce programme a été construit sans OpenXR, ou il n&apos;y a pas d&apos;écran</translation>
    </message>
    <message>
        <source>The scene is shown in the headset %1</source>
        <translation>La scène est montrée dans le casque %1</translation>
    </message>
    <message>
        <source>The headset has shown no pictures yet</source>
        <translation>Le casque n&apos;a pas encore montré d&apos;images</translation>
    </message>
    <message>
        <source>A picture of an eye: %1 draw calls, %2 triangles, %3 ms to choose them, %4 ms in OpenGL; the scene is simplified %5 of %6 times</source>
        <translation>Une image d&apos;un œil&#xa0;: %1 appels de dessin, %2 triangles, %3 ms pour les choisir, %4 ms dans OpenGL&#xa0;; la scène est simplifiée %5 fois sur %6</translation>
    </message>
    <message>
        <source>The headset has not asked for a picture for seconds. Its program may be busy</source>
        <translation>Le casque ne demande plus d&apos;image depuis des secondes. Son programme est peut-être occupé</translation>
    </message>
    <message>
        <source>The OpenXR runtime refused %1. The headset works without it</source>
        <translation>Le moteur OpenXR a refusé %1. Le casque fonctionne sans cela</translation>
    </message>
    <message>
        <source>The headset is off</source>
        <translation>Le casque est éteint</translation>
    </message>
    <message>
        <source>The headset reports no controllers that are known here. Known are Touch, Index, Vive, Windows Mixed Reality, and OpenXR&apos;s simple controller</source>
        <translation>Le casque n&apos;annonce aucune manette connue ici. Sont connues Touch, Index, Vive, Windows Mixed Reality et la manette simple d&apos;OpenXR</translation>
    </message>
</context>
<context>
    <name>glissade::HeadsetPage</name>
    <message>
        <source>Panel in the headset</source>
        <translation>Panneau dans le casque</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Strategy: %1</source>
        <translation>Stratégie&#xa0;: %1</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>No sequence yet</source>
        <translation>Pas encore de séquence</translation>
    </message>
    <message>
        <source>Stand where the camera of %1 is</source>
        <translation>Se placer là où est la caméra de %1</translation>
    </message>
</context>
<context>
    <name>glissade::HeadsetTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 jusqu&apos;à %2</translation>
    </message>
</context>
<context>
    <name>glissade::InstructionController</name>
    <message>
        <source>Work instructions have no template</source>
        <translation>Les gammes de montage n&apos;ont pas de modèle</translation>
    </message>
    <message>
        <source>Work instructions follow the template %1</source>
        <translation>Les gammes de montage suivent le modèle %1</translation>
    </message>
    <message>
        <source>The template of work instructions cannot be used</source>
        <translation>Le modèle des gammes de montage ne peut pas être utilisé</translation>
    </message>
    <message>
        <source>Save the report of the sequence</source>
        <translation>Enregistrer le rapport de la séquence</translation>
    </message>
    <message>
        <source>Web page (*.html);;PDF (*.pdf)</source>
        <translation>Page Web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Choose the template of work instructions</source>
        <translation>Choisir le modèle des gammes de montage</translation>
    </message>
    <message>
        <source>Templates (*.json);;All files (*)</source>
        <translation>Modèles (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save the work instruction</source>
        <translation>Enregistrer la gamme de montage</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;Web page (*.html)</source>
        <translation>PDF (*.pdf);;Page web (*.html)</translation>
    </message>
</context>
<context>
    <name>glissade::InstructionJob</name>
    <message>
        <source>Writing the work instruction</source>
        <translation>Écriture de la gamme de montage</translation>
    </message>
    <message>
        <source>Writing the report of the sequence</source>
        <translation>Écriture du rapport de la séquence</translation>
    </message>
</context>
<context>
    <name>glissade::InstructionWalk</name>
    <message>
        <source>Take %1</source>
        <translation>Prenez %1</translation>
    </message>
    <message>
        <source>The product is assembled</source>
        <translation>Le produit est assemblé</translation>
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
        <translation>Mêmes scénario, graine et entrées&#xa0;: même graphe</translation>
    </message>
    <message>
        <source>Whose configuration was tried last</source>
        <translation>Auteur de la dernière configuration essayée</translation>
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
        <source>Tried last</source>
        <translation>Dernier essai</translation>
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
        <translation>Relecture&#xa0;: tel qu&apos;à ce pas</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
</context>
<context>
    <name>glissade::JointDialog</name>
    <message>
        <source>Left-handed</source>
        <translation>Pas à gauche</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Removed body</source>
        <translation>Corps démonté</translation>
    </message>
    <message>
        <source>Clamps</source>
        <translation>Serre</translation>
    </message>
    <message>
        <source>Removed along</source>
        <translation>Démonté selon</translation>
    </message>
    <message>
        <source>Thread diameter</source>
        <translation>Diamètre du filetage</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Engaged length</source>
        <translation>Longueur en prise</translation>
    </message>
    <message>
        <source>Bend of the hook</source>
        <translation>Flexion du crochet</translation>
    </message>
    <message>
        <source>Designation</source>
        <translation>Désignation</translation>
    </message>
    <message>
        <source>proposed (%1)</source>
        <translation>proposée (%1)</translation>
    </message>
    <message>
        <source>opposite (%1)</source>
        <translation>opposée (%1)</translation>
    </message>
    <message>
        <source>All other bodies are clamped. Uncheck the one that the thread is in.</source>
        <translation>Tous les autres corps sont serrés. Décochez celui où se trouve le filetage.</translation>
    </message>
</context>
<context>
    <name>glissade::JointsController</name>
    <message>
        <source>confirm joints</source>
        <translation>confirmer des liaisons</translation>
    </message>
    <message>
        <source>press inserts out</source>
        <translation>chasser des inserts</translation>
    </message>
    <message>
        <source>open units</source>
        <translation>ouvrir des unités</translation>
    </message>
    <message>
        <source>Looking for joints</source>
        <translation>Recherche des liaisons</translation>
    </message>
    <message>
        <source>dissolve joints</source>
        <translation>supprimer des liaisons</translation>
    </message>
    <message>
        <source>take joints as found</source>
        <translation>prendre des liaisons comme trouvées</translation>
    </message>
    <message>
        <source>confirm all suggested joints</source>
        <translation>confirmer toutes les liaisons proposées</translation>
    </message>
    <message>
        <source>make a joint</source>
        <translation>créer une liaison</translation>
    </message>
    <message>
        <source>change a joint</source>
        <translation>modifier une liaison</translation>
    </message>
    <message>
        <source>The joint cannot be changed</source>
        <translation>La liaison ne peut pas être modifiée</translation>
    </message>
</context>
<context>
    <name>glissade::JointsPanel</name>
    <message>
        <source>clamps %1</source>
        <translation>serre %1</translation>
    </message>
    <message>
        <source>%1 (?)</source>
        <translation>%1 (?)</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrer</translation>
    </message>
    <message>
        <source>Filter by kind, body, thread or state</source>
        <translation>Filtrer par type, corps, filetage ou état</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>With</source>
        <translation>Avec</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Not looked for yet.</source>
        <translation>Pas encore recherchées.</translation>
    </message>
    <message>
        <source>drive: %1</source>
        <translation>empreinte&#xa0;: %1</translation>
    </message>
    <message>
        <source>; </source>
        <translation>&#xa0;; </translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>The thread, or the bend of a hook</source>
        <translation>Le filetage, ou la flexion d&apos;un crochet</translation>
    </message>
</context>
<context>
    <name>glissade::KeptPathsController</name>
    <message>
        <source>Comparing paths</source>
        <translation>Comparaison des chemins</translation>
    </message>
    <message>
        <source>Not possible with this path</source>
        <translation>Opération impossible avec ce chemin</translation>
    </message>
</context>
<context>
    <name>glissade::KeptPathsPanel</name>
    <message>
        <source>accepted clash with %1, %2 deep</source>
        <translation>interférence acceptée avec %1, profonde de %2</translation>
    </message>
    <message>
        <source>Allowance: %1 on %2</source>
        <translation>Amincissement&#xa0;: %1 face à %2</translation>
    </message>
    <message>
        <source>Allowance: %2 on %1, which gives way</source>
        <translation>Amincissement&#xa0;: %2 sur %1, qui cède</translation>
    </message>
    <message>
        <source>The path is certified again in the background.</source>
        <translation>Le chemin est certifié de nouveau en arrière-plan.</translation>
    </message>
    <message>
        <source>Certified again in the scenario as it is now.</source>
        <translation>Certifié de nouveau dans le scénario actuel.</translation>
    </message>
    <message>
        <source>Not certified: the scenario was changed, and a body is in the way.</source>
        <translation>Non certifié&#xa0;: le scénario a changé, et un corps fait obstacle.</translation>
    </message>
    <message>
        <source>Free of penetration, but it no longer leads from the start pose to the goal pose.</source>
        <translation>Sans pénétration, mais il ne mène plus du départ au but.</translation>
    </message>
    <message>
        <source>Not certified: another body is the moving part now.</source>
        <translation>Non certifié&#xa0;: un autre corps est maintenant la pièce manipulée.</translation>
    </message>
    <message>
        <source>certified %1, required %2</source>
        <translation>certifié %1, exigé %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>not certified yet</source>
        <translation>pas encore certifié</translation>
    </message>
    <message>
        <source>certified</source>
        <translation>certifié</translation>
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
        <source>Certificate</source>
        <translation>Certificat</translation>
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
        <translation>Amincissements</translation>
    </message>
    <message>
        <source>Kept paths</source>
        <translation>Chemins conservés</translation>
    </message>
    <message>
        <source>Checked: drawn in this colour beside the others</source>
        <translation>Coché&#xa0;: dessiné de cette couleur à côté des autres</translation>
    </message>
    <message>
        <source>The path that was found is not kept yet: Keep (Ctrl+Alt+K) or Save (Ctrl+S).</source>
        <translation>Le chemin trouvé n&apos;est pas encore conservé&#xa0;: Conserver (Ctrl+Alt+K) ou Enregistrer (Ctrl+S).</translation>
    </message>
    <message>
        <source>No path is kept yet. A path that is found can be kept in the scenario.</source>
        <translation>Aucun chemin n&apos;est encore conservé. Un chemin trouvé peut être conservé dans le scénario.</translation>
    </message>
    <message>
        <source>Kept in the scenario: %1</source>
        <translation>Conservés dans le scénario&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>glissade::KeyboardSteering</name>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>a quarter of the speed</source>
        <translation>un quart de la vitesse</translation>
    </message>
    <message>
        <source>axes of the view, of the world or of the object</source>
        <translation>axes de la vue, du monde ou de l&apos;objet</translation>
    </message>
</context>
<context>
    <name>glissade::LegendOverlay</name>
    <message>
        <source>Moving part</source>
        <translation>Pièce manipulée</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>But</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Espace de travail</translation>
    </message>
    <message>
        <source>Searched from the start</source>
        <translation>Cherché depuis le départ</translation>
    </message>
    <message>
        <source>Searched from the goal</source>
        <translation>Cherché depuis le but</translation>
    </message>
    <message>
        <source>By the operator</source>
        <translation>Par l&apos;opérateur</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>En contact</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Path, from tight to wide</source>
        <translation>Chemin, d&apos;étroit à large</translation>
    </message>
    <message>
        <source>Path, by step</source>
        <translation>Chemin, par étape</translation>
    </message>
    <message>
        <source>Path of the computer</source>
        <translation>Chemin de l&apos;ordinateur</translation>
    </message>
    <message>
        <source>Path of the operator</source>
        <translation>Chemin de l&apos;opérateur</translation>
    </message>
    <message>
        <source>Path in contact</source>
        <translation>Chemin en contact</translation>
    </message>
    <message>
        <source>Object along the path</source>
        <translation>Objet le long du chemin</translation>
    </message>
    <message>
        <source>Path no longer valid</source>
        <translation>Chemin qui n&apos;est plus valide</translation>
    </message>
    <message>
        <source>Blocked part of the path</source>
        <translation>Partie bloquée du chemin</translation>
    </message>
    <message>
        <source>To the nearest obstacle</source>
        <translation>Vers l&apos;obstacle le plus proche</translation>
    </message>
    <message>
        <source>Contact with an obstacle</source>
        <translation>Contact avec un obstacle</translation>
    </message>
    <message>
        <source>Guiding force</source>
        <translation>Force de guidage</translation>
    </message>
    <message>
        <source>Swept volume</source>
        <translation>Volume balayé</translation>
    </message>
    <message>
        <source>Free cells</source>
        <translation>Cellules libres</translation>
    </message>
    <message>
        <source>Cells with mobile bodies</source>
        <translation>Cellules à corps mobiles</translation>
    </message>
    <message>
        <source>Cells with static bodies</source>
        <translation>Cellules à corps fixes</translation>
    </message>
    <message>
        <source>Places, from easy to narrow</source>
        <translation>Lieux, de facile à étroit</translation>
    </message>
    <message>
        <source>Places with a mobile body</source>
        <translation>Lieux avec un corps mobile</translation>
    </message>
    <message>
        <source>Borders of places</source>
        <translation>Frontières des lieux</translation>
    </message>
    <message>
        <source>Graph, with costs</source>
        <translation>Graphe, avec les coûts</translation>
    </message>
    <message>
        <source>Coarse path</source>
        <translation>Chemin grossier</translation>
    </message>
    <message>
        <source>Milestones</source>
        <translation>Jalons</translation>
    </message>
    <message>
        <source>Region of the step</source>
        <translation>Région de l&apos;étape</translation>
    </message>
    <message>
        <source>Blocking body</source>
        <translation>Corps bloquant</translation>
    </message>
    <message>
        <source>Tightest place</source>
        <translation>Endroit le plus étroit</translation>
    </message>
    <message>
        <source>Gap of the search</source>
        <translation>Écart entre les arbres</translation>
    </message>
    <message>
        <source>Overlapped body</source>
        <translation>Corps recouvert</translation>
    </message>
    <message>
        <source>Object where it overlaps</source>
        <translation>Objet là où il recouvre</translation>
    </message>
    <message>
        <source>Ruled-out direction</source>
        <translation>Direction interdite</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Part of the step</source>
        <translation>Pièce de l&apos;étape</translation>
    </message>
    <message>
        <source>Removal path</source>
        <translation>Chemin de démontage</translation>
    </message>
    <message>
        <source>Your hand</source>
        <translation>Votre main</translation>
    </message>
    <message>
        <source>Where your hand helps</source>
        <translation>Où votre main est utile</translation>
    </message>
    <message>
        <source>Hand with access</source>
        <translation>Main qui accède</translation>
    </message>
    <message>
        <source>Hand that is blocked</source>
        <translation>Main bloquée</translation>
    </message>
</context>
<context>
    <name>glissade::LogController</name>
    <message>
        <source>The report is in the clipboard. Read it before you send it: it names files.</source>
        <translation>Le rapport est dans le presse-papiers. Relisez-le avant de l&apos;envoyer&#xa0;: il nomme des fichiers.</translation>
    </message>
    <message>
        <source>Run %1: %2, seed %3</source>
        <translation>Calcul %1&#xa0;: %2, graine %3</translation>
    </message>
    <message>
        <source>%1 (%2 s, %3 nodes)</source>
        <translation>%1 (%2 s, %3 nœuds)</translation>
    </message>
    <message>
        <source>Opened &apos;%1&apos;, obstacles: %2</source>
        <translation>«&#xa0;%1&#xa0;» ouvert, obstacles&#xa0;: %2</translation>
    </message>
    <message>
        <source>Start: %1</source>
        <translation>Départ&#xa0;: %1</translation>
    </message>
    <message>
        <source>Goal: %1</source>
        <translation>But&#xa0;: %1</translation>
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
        <source>Interaction</source>
        <translation>Interaction</translation>
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
        <source>Not possible</source>
        <translation>Opération impossible</translation>
    </message>
    <message>
        <source>Fits</source>
        <translation>Ajustements</translation>
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
        <source>Joints</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produit</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lieux</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Chiffres</translation>
    </message>
    <message>
        <source>Coarse plan</source>
        <translation>Plan grossier</translation>
    </message>
    <message>
        <source>This path</source>
        <translation>Ce chemin</translation>
    </message>
    <message>
        <source>Kept paths</source>
        <translation>Conservés</translation>
    </message>
    <message>
        <source>Why not</source>
        <translation>Pourquoi non</translation>
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
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>The page before</source>
        <translation>La page précédente</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Page suivante</translation>
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
        <translation>Le manuel ne peut pas être affiché</translation>
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
    <name>glissade::MeasureController</name>
    <message>
        <source>Finding edges and faces of the body…</source>
        <translation>Recherche des arêtes et des faces du corps…</translation>
    </message>
    <message>
        <source>Radius %1, diameter %2</source>
        <translation>Rayon %1, diamètre %2</translation>
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
        <translation>les corps se touchent</translation>
    </message>
    <message>
        <source>Measuring the clearance…</source>
        <translation>Mesure du jeu…</translation>
    </message>
    <message>
        <source>Click a cylindrical face. Esc ends measuring.</source>
        <translation>Cliquez une face cylindrique. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click a plane or a cylinder of what is placed. Esc ends this.</source>
        <translation>Cliquez un plan ou un cylindre de l&apos;élément à positionner. Échap termine.</translation>
    </message>
    <message>
        <source>Click the first body. Esc ends measuring.</source>
        <translation>Cliquez le premier corps. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click the second body.</source>
        <translation>Cliquez le second corps.</translation>
    </message>
    <message>
        <source>Click the first vertex, edge or face. Esc ends measuring.</source>
        <translation>Cliquez le premier sommet, la première arête ou la première face. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click the second vertex, edge or face.</source>
        <translation>Cliquez le second sommet, la seconde arête ou la seconde face.</translation>
    </message>
    <message>
        <source>Click the first edge or face. Esc ends measuring.</source>
        <translation>Cliquez la première arête ou face. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click the second edge or face.</source>
        <translation>Cliquez la seconde arête ou face.</translation>
    </message>
    <message>
        <source>Click the face that the section lies along. Esc ends this.</source>
        <translation>Cliquez la face le long de laquelle la coupe se place. Échap termine.</translation>
    </message>
    <message>
        <source>%1 copies this. Esc removes it.</source>
        <translation>%1 copie ceci. Échap l&apos;enlève.</translation>
    </message>
    <message>
        <source>Torus: radius of the circle %1, of the tube %2</source>
        <translation>Tore&#xa0;: rayon du cercle %1, du tube %2</translation>
    </message>
    <message>
        <source> there; half angle of the cone %1</source>
        <translation> à cet endroit&#xa0;; demi-angle du cône %1</translation>
    </message>
    <message>
        <source>This is neither a plane nor a round face with an axis or a centre.</source>
        <translation>Ce n&apos;est ni un plan ni une face ronde qui a un axe ou un centre.</translation>
    </message>
    <message>
        <source>This is no face of a cylinder, a cone, a sphere or a torus.</source>
        <translation>Cette face n&apos;est ni celle d&apos;un cylindre ni celle d&apos;un cône, d&apos;une sphère ou d&apos;un tore.</translation>
    </message>
    <message>
        <source>A vertex, a sphere or a free surface has no direction: click edges, planes or faces with an axis.</source>
        <translation>Un sommet, une sphère ou une surface libre n&apos;a pas de direction&#xa0;: cliquez des arêtes, des plans ou des faces qui ont un axe.</translation>
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
        <source>%1 steps a second</source>
        <translation>%1 pas/s</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>How fast a run goes: choose a pace or type steps a second, to watch and to steer</source>
        <translation>Vitesse du calcul&#xa0;: choisissez une cadence ou saisissez un nombre de pas par seconde, pour regarder et guider</translation>
    </message>
    <message>
        <source>%1 steps a second: real time</source>
        <translation>%1 pas/s&#xa0;: temps réel</translation>
    </message>
</context>
<context>
    <name>glissade::PaperComparison</name>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 à %3)</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>article</translation>
    </message>
    <message>
        <source>this run</source>
        <translation>cette exécution</translation>
    </message>
    <message numerus="yes">
        <source>simulated, %n runs</source>
        <translation>
            <numerusform>simulé, %n calcul</numerusform>
            <numerusform>simulés, %n calculs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glissade::ParameterSlider</name>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>The program sets %1</source>
        <translation>%1 est réglé par le programme</translation>
    </message>
    <message>
        <source>The program sets this value while planning. Press here, or move the slider, to use your value again: %1</source>
        <translation>Le programme règle cette valeur pendant la planification. Appuyez ici ou déplacez le curseur pour la reprendre&#xa0;; la vôtre est %1</translation>
    </message>
    <message>
        <source>Let the program set this value while planning</source>
        <translation>Laisser le programme régler cette valeur pendant la planification</translation>
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
        <source>The parts cannot be added</source>
        <translation>Les pièces ne peuvent pas être ajoutées</translation>
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
        <translation>Axe vertical</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Width × depth × height: shows whether the unit is right</source>
        <translation>Largeur × profondeur × hauteur&#xa0;: montre si l&apos;unité est la bonne</translation>
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
        <translation>Axe vertical de %1</translation>
    </message>
    <message>
        <source>Unit of the file; of all selected rows together</source>
        <translation>Unité du fichier&#xa0;; pour toutes les lignes sélectionnées</translation>
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
        <translation>Axe vertical du fichier&#xa0;; pour toutes les lignes sélectionnées</translation>
    </message>
    <message>
        <source>Add the files of parts</source>
        <translation>Ajouter les fichiers de pièces</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ne peut pas être lu</translation>
    </message>
    <message>
        <source>Add the files of the parts.</source>
        <translation>Ajoutez les fichiers des pièces.</translation>
    </message>
    <message>
        <source>Choose the moving part.</source>
        <translation>Choisissez la pièce manipulée.</translation>
    </message>
    <message>
        <source>Meshes (STL, OBJ, Collada, glTF), STEP or URDF files</source>
        <translation>Fichiers de maillages (STL, OBJ, Collada, glTF), STEP ou URDF</translation>
    </message>
    <message>
        <source>The file says its unit itself; Z is up</source>
        <translation>Le fichier donne lui-même son unité&#xa0;; Z est l&apos;axe vertical</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>Pièces (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Close planar &amp;holes</source>
        <translation>Fermer les &amp;trous plans</translation>
    </message>
    <message>
        <source>Closes holes of meshes whose edge lies in a plane; a warning says how many</source>
        <translation>Ferme les trous des maillages dont le bord est dans un plan&#xa0;; un avertissement dit combien</translation>
    </message>
    <message>
        <source>The files do not say their unit: by their size it is the metre.</source>
        <translation>Les fichiers ne donnent pas leur unité&#xa0;: d&apos;après leur taille, c&apos;est le mètre.</translation>
    </message>
    <message>
        <source>In the way, but a person could move it</source>
        <translation>Fait obstacle, mais une personne pourrait la déplacer</translation>
    </message>
    <message>
        <source>Is the unit right? The files do not state it, and their size does not decide it. Choose the unit.</source>
        <translation>L&apos;unité est-elle la bonne&#xa0;? Les fichiers ne la donnent pas, et leur taille ne permet pas de la déduire. Choisissez-la.</translation>
    </message>
    <message>
        <source>The part whose path is planned; several move as one</source>
        <translation>La pièce dont on planifie le chemin&#xa0;; plusieurs bougent ensemble</translation>
    </message>
    <message>
        <source>Split OBJ &amp;groups and solids</source>
        <translation>Diviser &amp;groupes OBJ et solides</translation>
    </message>
    <message>
        <source>Takes each group of an OBJ file, and each solid of a CAD part of several, as a part of its own</source>
        <translation>Prend chaque groupe d&apos;un fichier OBJ, et chaque solide d&apos;une pièce de CAO qui en a plusieurs, comme une pièce à part</translation>
    </message>
    <message>
        <source>The files are being read: %1 of %2.</source>
        <translation>Lecture des fichiers&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>file&apos;s</source>
        <translation>du fichier</translation>
    </message>
    <message>
        <source>What the part does while the path of one part is planned; an assembly plan moves every part. It is set for all selected rows together</source>
        <translation>Ce que fait la pièce pendant la planification du chemin d’une pièce&#xa0;; un plan d’assemblage déplace chaque pièce. Réglé pour toutes les lignes sélectionnées</translation>
    </message>
    <message>
        <source>Moves: its path is planned</source>
        <translation>Se déplace&#xa0;: son chemin est planifié</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Reste en place</translation>
    </message>
    <message>
        <source>Does not move while another part moves</source>
        <translation>Ne bouge pas pendant qu’une autre pièce se déplace</translation>
    </message>
    <message>
        <source>Stays, could be moved aside</source>
        <translation>Reste, pourrait être écartée</translation>
    </message>
    <message>
        <source>Roles are for the path of one part; an assembly plan moves every part. Select several rows to choose their role, unit or axis together.</source>
        <translation>Les rôles valent pour le chemin d’une pièce&#xa0;; un plan d’assemblage déplace chaque pièce. Sélectionnez plusieurs lignes pour choisir ensemble leur rôle, leur unité ou leur axe.</translation>
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
        <source>Not possible with this path</source>
        <translation>Opération impossible avec ce chemin</translation>
    </message>
</context>
<context>
    <name>glissade::PathPanel</name>
    <message>
        <source>accepted clash with %1, %2 deep</source>
        <translation>interférence acceptée avec %1, profonde de %2</translation>
    </message>
    <message>
        <source>a forbidden place</source>
        <translation>un lieu interdit</translation>
    </message>
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
        <translation>aucun corps proche</translation>
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
        <source>certified %1, required %2</source>
        <translation>certifié %1, exigé %2</translation>
    </message>
    <message>
        <source>required %1</source>
        <translation>exigé %1</translation>
    </message>
    <message>
        <source>It no longer starts at the start pose.</source>
        <translation>Il ne commence plus à la position de départ.</translation>
    </message>
    <message>
        <source>It no longer ends at the goal pose.</source>
        <translation>Il ne finit plus à la position de but.</translation>
    </message>
    <message>
        <source>It leaves the workspace at configuration %1.</source>
        <translation>Il quitte l&apos;espace de travail à la configuration %1.</translation>
    </message>
    <message>
        <source>This path is no longer valid</source>
        <translation>Ce chemin n&apos;est plus valide</translation>
    </message>
    <message>
        <source>%1 or more from forbidden places</source>
        <translation>à %1 ou plus des lieux interdits</translation>
    </message>
    <message>
        <source>of 32-bit coordinates, which may be %1 nearer</source>
        <translation>pour des coordonnées sur 32 bits, qui peuvent être plus proches de %1</translation>
    </message>
    <message>
        <source>without shapes that were not read, of which nothing is known: %1</source>
        <translation>sans les formes qui n&apos;ont pas été lues, dont on ne sait rien&#xa0;: %1</translation>
    </message>
    <message>
        <source>CAD accuracy ± %1</source>
        <translation>précision CAO ± %1</translation>
    </message>
    <message>
        <source>Allowance: %1 on %2</source>
        <translation>Amincissement&#xa0;: %1 face à %2</translation>
    </message>
    <message>
        <source>Allowance: %2 on %1, which gives way</source>
        <translation>Amincissement&#xa0;: %2 sur %1, qui cède</translation>
    </message>
    <message>
        <source>(thread), pitch %1, %2 turns</source>
        <translation>(filetage), pas %1, %2 tours</translation>
    </message>
    <message>
        <source>, user-defined</source>
        <translation>, défini par l&apos;utilisateur</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 edges slide</source>
        <translation>
            <numerusform>%n segment sur %1 glisse</numerusform>
            <numerusform>%n segments sur %1 glissent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 edges are blocked, the first at %2 % by %3.</source>
        <translation>
            <numerusform>%n segment sur %1 est bloqué, à %2 % par %3.</numerusform>
            <numerusform>%n segments sur %1 sont bloqués, le premier à %2 % par %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>no tapped hole in the file, with %1</source>
        <translation>aucun trou taraudé dans le fichier, avec %1</translation>
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
        <translation>Position&#xa0;: sélectionnez un corps, le départ ou le but</translation>
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
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Picked face or axis</source>
        <translation>Face ou axe choisi</translation>
    </message>
    <message>
        <source>Along the world&apos;s axis %1; a number may have a unit: 25.4 mm, 1 in</source>
        <translation>Suivant l&apos;axe %1 du monde&#xa0;; un nombre peut avoir une unité&#xa0;: 25,4 mm, 1 in</translation>
    </message>
    <message>
        <source>Turned about the world&apos;s axis %1, in degrees, or with a unit: 0.1 rad; first X, then Y, then Z</source>
        <translation>Tourné autour de l&apos;axe %1 du monde, en degrés, ou avec une unité&#xa0;: 0,1 rad&#xa0;; d&apos;abord X, puis Y, puis Z</translation>
    </message>
    <message>
        <source>“%1” is not a length up to 1 km. Write 12.5, 25.4 mm, 1 in or 0.5&quot;. Nothing has moved.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une longueur d&apos;au plus 1 km. Écrivez 12,5, 25,4 mm, 1 in ou 0,5&quot;. Rien n&apos;a été déplacé.</translation>
    </message>
    <message>
        <source>“%1” is not an angle up to 360°. Write 30, 30 deg or 0.1 rad. Nothing has moved.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un angle d&apos;au plus 360°. Écrivez 30, 30 deg ou 0,1 rad. Rien n&apos;a été déplacé.</translation>
    </message>
    <message>
        <source>Placement of %1, %2 and °</source>
        <translation>Position de %1, en %2 et °</translation>
    </message>
    <message>
        <source>Placement, %1 and °</source>
        <translation>Position, en %1 et °</translation>
    </message>
    <message>
        <source>Point whose coordinates are shown</source>
        <translation>Point de référence des coordonnées</translation>
    </message>
    <message>
        <source>The point whose coordinates are shown; a CAD system gives those of the origin of its file</source>
        <translation>Point dont les coordonnées sont affichées&#xa0;; un système de CAO donne celles de l&apos;origine de son fichier</translation>
    </message>
    <message>
        <source>The point whose poses are in path files</source>
        <translation>Point dont les fichiers de chemin donnent la position</translation>
    </message>
    <message>
        <source>“%1” is not a length. Nothing has moved.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une longueur. Rien n&apos;a bougé.</translation>
    </message>
    <message>
        <source>“%1” is not an angle. Nothing has moved.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un angle. Rien n&apos;a bougé.</translation>
    </message>
</context>
<context>
    <name>glissade::PlanGraphView</name>
    <message>
        <source>Precedence graph</source>
        <translation>Graphe d&apos;antériorité</translation>
    </message>
    <message>
        <source>An arrow leads from a step to each step that has to come after it</source>
        <translation>Une flèche va d&apos;une étape à chaque étape qui doit la suivre</translation>
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
        <source>Coarse path of cost %1, not tried yet</source>
        <translation>Chemin grossier de coût %1, pas encore essayé</translation>
    </message>
    <message>
        <source>Coarse path %1, cost %2; random configurations: coarse %3, fine %4</source>
        <translation>Chemin grossier %1, coût %2&#xa0;; configurations aléatoires&#xa0;: grossier %3, fin %4</translation>
    </message>
    <message>
        <source>solved</source>
        <translation>résolu</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>No path through the places.</source>
        <translation>Aucun chemin par les lieux.</translation>
    </message>
    <message>
        <source>Forbidden: %1.</source>
        <translation>Interdits&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Of infinite cost: %1.</source>
        <translation>De coût infini&#xa0;: %1.</translation>
    </message>
    <message>
        <source>None leads from start to goal.</source>
        <translation>Aucun ne mène du départ au but.</translation>
    </message>
    <message>
        <source>Solved by the search of the whole workspace, after %1 coarse paths; random configurations: %2</source>
        <translation>Résolu par la recherche dans tout l&apos;espace de travail, après %1 chemins grossiers&#xa0;; configurations aléatoires&#xa0;: %2</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>Steps of the coarse path</source>
        <translation>Étapes du chemin grossier</translation>
    </message>
    <message>
        <source>No coarse plan: choose the strategy Layers and start.</source>
        <translation>Pas de plan grossier&#xa0;: choisissez la stratégie Couches et démarrez.</translation>
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
        <translation>Une autre langue s&apos;applique au prochain démarrage.</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>Font &amp;size</source>
        <translation>Ta&amp;ille de police</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Suivre le système</translation>
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
        <translation>&amp;Réinitialiser les couleurs</translation>
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
        <translation>Reprendre les couleurs du thème&#xa0;: les personnes daltoniennes les distinguent</translation>
    </message>
    <message>
        <source>What is not saved is written into the program&apos;s data folder, to be offered after a crash</source>
        <translation>Ce qui n&apos;est pas enregistré est écrit dans le dossier de données du programme, pour être proposé après un arrêt brutal</translation>
    </message>
    <message>
        <source>Light or dark, as the system was when the program started</source>
        <translation>Clair ou sombre, comme le système au démarrage du programme</translation>
    </message>
    <message>
        <source>Follow product</source>
        <translation>Suivre le produit</translation>
    </message>
    <message>
        <source>Unit of the product&apos;s file; else millimetres, or metres in a workspace of 2 m or more</source>
        <translation>Unité du fichier du produit&#xa0;; sinon millimètres, ou mètres dans un espace de travail de 2 m ou plus</translation>
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
        <translation>Un calcul a commencé entre-temps&#xa0;: ouvrez l&apos;enregistrement quand il sera fini.</translation>
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
        <translation>L&apos;enregistrement renvoie au fichier du scénario, où les corps ne sont pas disposés comme ici. Enregistrez aussi le scénario, sans quoi l&apos;enregistrement ne pourra pas être rejoué.</translation>
    </message>
    <message>
        <source>Glissade ended unexpectedly with a recording that was not saved. It is still there.</source>
        <translation>Glissade s&apos;est arrêté de façon inattendue avec un enregistrement non sauvegardé. Il est toujours là.</translation>
    </message>
    <message>
        <source>&amp;Save...</source>
        <translation>&amp;Sauvegarder...</translation>
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
    <message>
        <source>A recording was not saved</source>
        <translation>Enregistrement non sauvegardé</translation>
    </message>
    <message>
        <source>The recording was saved as %1</source>
        <translation>L&apos;enregistrement a été sauvé sous %1</translation>
    </message>
</context>
<context>
    <name>glissade::RefusalController</name>
    <message>
        <source>The first leads through a forbidden place.</source>
        <translation>Le premier traverse un lieu interdit.</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: overlap %2</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: recouvrement %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: touches or overlaps</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: contact ou recouvrement</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: %2 away, required %3</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: à %2, jeu exigé %3</translation>
    </message>
    <message>
        <source>The run ended without a path.</source>
        <translation>Le calcul s&apos;est terminé sans chemin.</translation>
    </message>
    <message>
        <source>The start pose cannot be used.</source>
        <translation>La position de départ est inutilisable.</translation>
    </message>
    <message>
        <source>The goal pose cannot be used.</source>
        <translation>La position de but est inutilisable.</translation>
    </message>
    <message>
        <source>The path is no longer valid.</source>
        <translation>Le chemin n&apos;est plus valide.</translation>
    </message>
    <message>
        <source>The first is blocked by &apos;%1&apos;.</source>
        <translation>Le premier est bloqué par «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>It no longer leads from the start pose to the goal pose.</source>
        <translation>Il ne mène plus de la position de départ à celle du but.</translation>
    </message>
    <message>
        <source>Start and goal have no collisions now. Press Find path (F5).</source>
        <translation>Le départ et le but sont maintenant sans collision. Appuyez sur Chercher un chemin (F5).</translation>
    </message>
    <message>
        <source>Allow as fits</source>
        <translation>Admettre comme ajustements</translation>
    </message>
    <message>
        <source>This cannot be allowed as a fit</source>
        <translation>Cela ne peut pas être admis comme ajustement</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 edges are blocked.</source>
        <translation>
            <numerusform>%n segment sur %1 est bloqué.</numerusform>
            <numerusform>%n segments sur %1 sont bloqués.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Start pose collides: &apos;%1&apos; overlaps %2 by %3.</source>
        <translation>Collision au départ&#xa0;: «&#xa0;%1&#xa0;» recouvre %2 de %3.</translation>
    </message>
    <message>
        <source>Goal pose collides: &apos;%1&apos; overlaps %2 by %3.</source>
        <translation>Collision au but&#xa0;: «&#xa0;%1&#xa0;» recouvre %2 de %3.</translation>
    </message>
    <message>
        <source>Start pose collides: &apos;%1&apos; touches or overlaps %2.</source>
        <translation>Collision au départ&#xa0;: «&#xa0;%1&#xa0;» touche ou recouvre %2.</translation>
    </message>
    <message>
        <source>Goal pose collides: &apos;%1&apos; touches or overlaps %2.</source>
        <translation>Collision au but&#xa0;: «&#xa0;%1&#xa0;» touche ou recouvre %2.</translation>
    </message>
    <message>
        <source>Start pose too close: &apos;%1&apos; is %2 away from %3, required %4.</source>
        <translation>Départ trop proche&#xa0;: «&#xa0;%1&#xa0;» est à %2 de %3, exigé %4.</translation>
    </message>
    <message>
        <source>Goal pose too close: &apos;%1&apos; is %2 away from %3, required %4.</source>
        <translation>But trop proche&#xa0;: «&#xa0;%1&#xa0;» est à %2 de %3, exigé %4.</translation>
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
        <translation>Vous voyez un enregistrement&#xa0;: rien ne peut être piloté avant la fermeture de la relecture</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>Times the pace of the recorded run</source>
        <translation>Multiple de la cadence du calcul enregistré</translation>
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
        <translation>relecture en cours... %1&#xa0;%</translation>
    </message>
    <message>
        <source>other parameters</source>
        <translation>autres paramètres</translation>
    </message>
    <message>
        <source>Other parameters: solved, %1 nodes (recorded: %2)</source>
        <translation>Autres paramètres&#xa0;: résolu, %1 nœuds (enregistré&#xa0;: %2)</translation>
    </message>
    <message>
        <source>Other parameters: no path, %1 nodes (recorded: %2)</source>
        <translation>Autres paramètres&#xa0;: pas de chemin, %1 nœuds (enregistré&#xa0;: %2)</translation>
    </message>
    <message>
        <source>≠ recorded</source>
        <translation>≠ enregistrement</translation>
    </message>
    <message>
        <source>Differs from the recording: the same until step %1, not at step %2</source>
        <translation>Diffère de l&apos;enregistrement&#xa0;: identique jusqu&apos;au pas %1, différent au pas %2</translation>
    </message>
    <message>
        <source>✓ as recorded</source>
        <translation>✓ conforme</translation>
    </message>
    <message>
        <source>Same roadmap as recorded: %1 nodes</source>
        <translation>Même graphe que l&apos;enregistrement&#xa0;: %1 nœuds</translation>
    </message>
    <message>
        <source>Replay. %1</source>
        <translation>Relecture. %1</translation>
    </message>
    <message>
        <source>No journal of this run on disk: %1</source>
        <translation>Pas de journal de ce calcul sur le disque&#xa0;: %1</translation>
    </message>
    <message>
        <source>The recording cannot be replayed</source>
        <translation>L&apos;enregistrement ne peut pas être rejoué</translation>
    </message>
</context>
<context>
    <name>glissade::ResearchBox</name>
    <message>
        <source>Research…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Shows what studies compare, by the names of the literature</source>
        <translation>Affiche ce que les études comparent, sous les noms de la littérature</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>glissade::ResponseCurve</name>
    <message>
        <source>How the device&apos;s deflection (across) is answered (up); the dot is where it is now</source>
        <translation>Réponse (en ordonnée) au débattement du périphérique (en abscisse)&#xa0;; le point indique la valeur actuelle</translation>
    </message>
</context>
<context>
    <name>glissade::RevisionController</name>
    <message>
        <source>Compare with another revision</source>
        <translation>Comparer avec une autre révision</translation>
    </message>
    <message>
        <source>Products (*.step *.stp *.p21 *.iges *.igs *.brep *.urdf *.json);;All files (*)</source>
        <translation>Produits (*.step *.stp *.p21 *.iges *.igs *.brep *.urdf *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The revisions were not compared</source>
        <translation>Les révisions n&apos;ont pas été comparées</translation>
    </message>
    <message>
        <source>Comparing revisions</source>
        <translation>Comparaison des révisions</translation>
    </message>
    <message>
        <source>Comparison with %1</source>
        <translation>Comparaison avec %1</translation>
    </message>
    <message>
        <source>Differences, and steps that do not hold</source>
        <translation>Différences, et étapes qui ne sont plus valables</translation>
    </message>
    <message>
        <source>The open product is the earlier revision. Each step of its sequence is judged in the other one.</source>
        <translation>Le produit ouvert est la révision antérieure. Chaque étape de sa séquence est jugée dans l&apos;autre.</translation>
    </message>
</context>
<context>
    <name>glissade::RulesDialog</name>
    <message>
        <source>f: what a border costs where places a and b meet. Known: %1</source>
        <translation>f&#xa0;: coût d&apos;une frontière entre les lieux a et b. Noms connus&#xa0;: %1</translation>
    </message>
    <message>
        <source>g: what a path across a place costs. Known: %1</source>
        <translation>g&#xa0;: coût de la traversée d&apos;un lieu. Noms connus&#xa0;: %1</translation>
    </message>
    <message>
        <source>When a step fails, try the &amp;next best path</source>
        <translation>Quand une étape échoue, essayer le &amp;meilleur chemin suivant</translation>
    </message>
    <message>
        <source>&amp;Cross passages as the object fits best</source>
        <translation>Traverser les &amp;passages dans l&apos;orientation la plus favorable à l&apos;objet</translation>
    </message>
    <message>
        <source>Rules of the strategy</source>
        <translation>Règles de la stratégie</translation>
    </message>
    <message>
        <source>&amp;Borders: f =</source>
        <translation>&amp;Frontières&#xa0;: f =</translation>
    </message>
    <message>
        <source>Pa&amp;ths: g =</source>
        <translation>C&amp;hemins&#xa0;: g =</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attributs</translation>
    </message>
    <message>
        <source>&amp;Planners: the first row that holds decides; the last must always hold (1).</source>
        <translation>P&amp;lanificateurs&#xa0;: la première ligne vraie décide&#xa0;; la dernière doit toujours être vraie (1).</translation>
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
        <translation>Partir d&apos;une stratégie de l&apos;article, ou de la nôtre</translation>
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
        <translation>Ajouter une règle avant la règle courante</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>The current rule</source>
        <translation>Retirer la règle courante</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>Mon&amp;ter</translation>
    </message>
    <message>
        <source>The current rule is asked earlier</source>
        <translation>Examiner la règle courante plus tôt</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>Des&amp;cendre</translation>
    </message>
    <message>
        <source>The current rule is asked later</source>
        <translation>Examiner la règle courante plus tard</translation>
    </message>
    <message>
        <source>of places (place., a., b.): %1; of the object (object.): %2</source>
        <translation>des lieux (place., a., b.)&#xa0;: %1&#xa0;; de l&apos;objet (object.)&#xa0;: %2</translation>
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
    <message>
        <source>Ready. Plan sequence (%1) is for all parts, Find path (%2) for the moving part.</source>
        <translation>Prêt. Planifier la séquence (%1)&#xa0;: toutes les pièces&#xa0;; Chercher un chemin (%2)&#xa0;: la pièce mobile.</translation>
    </message>
    <message>
        <source>Ready. The file is one part: a sequence needs two parts or more.</source>
        <translation>Prêt. Le fichier contient une seule pièce&#xa0;: une séquence en demande au moins deux.</translation>
    </message>
</context>
<context>
    <name>glissade::RunCurves</name>
    <message>
        <source>Nodes, computer share and clearance over the time of planning</source>
        <translation>Nœuds, part de l&apos;ordinateur et jeu au cours du temps de planification</translation>
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
        <source>Computer share α</source>
        <translation>Part de l&apos;ordinateur α</translation>
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
        <source>Duration of the run</source>
        <translation>Durée de l’exécution</translation>
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
    <name>glissade::ScaleBar</name>
    <message>
        <source>grid %1</source>
        <translation>grille %1</translation>
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
        <translation>Type</translation>
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
        <source>moving part</source>
        <translation>pièce manipulée</translation>
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
        <source>removed</source>
        <translation>démonté</translation>
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
        <translation>%1&#xa0;: dessiné tant que la case est cochée</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>CAD accuracy ± %1</source>
        <translation>Précision CAO ± %1</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Exclus</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>%1: part of the product&apos;s file, and not of this product</source>
        <translation>%1&#xa0;: fait partie du fichier du produit, mais pas de ce produit</translation>
    </message>
    <message>
        <source>Where the origin of the object&apos;s file is then</source>
        <translation>Où se trouve alors l&apos;origine du fichier de l&apos;objet</translation>
    </message>
    <message>
        <source>Other parts</source>
        <translation>Autres pièces</translation>
    </message>
    <message>
        <source>Moving part of Find path</source>
        <translation>Pièce mobile de Chercher un chemin</translation>
    </message>
</context>
<context>
    <name>glissade::SectionController</name>
    <message>
        <source>Sections</source>
        <translation>Coupes</translation>
    </message>
</context>
<context>
    <name>glissade::SectionPanel</name>
    <message>
        <source>Face</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Tout retirer</translation>
    </message>
    <message>
        <source>Add:</source>
        <translation>Ajouter&#xa0;:</translation>
    </message>
    <message>
        <source>“%1” is no place. Write 10, 25.4 mm or 1 in.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une position. Écrivez 10, 25,4 mm ou 1 in.</translation>
    </message>
    <message>
        <source>Sections cut bodies open: across an axis, or along a face that is clicked. The moving part stays whole.</source>
        <translation>Les coupes ouvrent les corps&#xa0;: perpendiculairement à un axe, ou le long d&apos;une face que l&apos;on clique. La pièce manipulée reste entière.</translation>
    </message>
    <message>
        <source>Drag the arrows in the scene, or type a place such as 25.4 mm.</source>
        <translation>Tirez les flèches dans la scène, ou tapez une position comme 25,4 mm.</translation>
    </message>
</context>
<context>
    <name>glissade::SectionRow</name>
    <message>
        <source>Show the other side of section %1</source>
        <translation>Montrer l&apos;autre côté de la coupe %1</translation>
    </message>
    <message>
        <source>Remove section %1</source>
        <translation>Retirer la coupe %1</translation>
    </message>
    <message>
        <source>Cut the bodies open by section %1</source>
        <translation>Ouvrir les corps par la coupe %1</translation>
    </message>
    <message>
        <source>Place of section %1</source>
        <translation>Position de la coupe %1</translation>
    </message>
    <message>
        <source>Place of section %1 as a length</source>
        <translation>Position de la coupe %1, en longueur</translation>
    </message>
    <message>
        <source>Place of section %1, in any unit: 25.4 mm, 1 in</source>
        <translation>Position de la coupe %1, dans une unité quelconque&#xa0;: 25,4 mm, 1 in</translation>
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
        <translation>Méthode de recherche des lieux</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Attributes of the selection</source>
        <translation>Attributs de la sélection</translation>
    </message>
    <message>
        <source>Places and bodies</source>
        <translation>Lieux et corps</translation>
    </message>
    <message numerus="yes">
        <source>%1 And %n more.</source>
        <translation>
            <numerusform>%1 Et %n autre.</numerusform>
            <numerusform>%1 Et %n autres.</numerusform>
        </translation>
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
        <translation>Lieux (pas encore recherchés)</translation>
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
        <source>moving part</source>
        <translation>pièce manipulée</translation>
    </message>
    <message>
        <source>Forbidden: no path leads through</source>
        <translation>Interdit&#xa0;: aucun chemin n&apos;y passe</translation>
    </message>
    <message>
        <source>Preferred: paths through count %1 times shorter</source>
        <translation>Préféré&#xa0;: les chemins par ce lieu comptent %1 fois moins longs</translation>
    </message>
    <message>
        <source>Mobility</source>
        <translation>Mobilité</translation>
    </message>
    <message>
        <source>Assemblies (%1)</source>
        <translation>Assemblages (%1)</translation>
    </message>
</context>
<context>
    <name>glissade::SequenceController</name>
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
        <translation>Plan d&apos;assemblage (*.json);;Gamme de montage (*.html);;Gamme de montage (*.pdf);;Tableau des étapes (*.csv);;Animation (*.glb)</translation>
    </message>
    <message>
        <source>The assembly plan cannot be saved</source>
        <translation>Le plan d&apos;assemblage ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Constraints of the opened sequence</source>
        <translation>Contraintes de la séquence ouverte</translation>
    </message>
    <message>
        <source>%1 was cancelled</source>
        <translation>%1 a été annulé</translation>
    </message>
    <message>
        <source>%1 was saved</source>
        <translation>%1 a été enregistré</translation>
    </message>
    <message>
        <source>Film the sequence</source>
        <translation>Filmer la séquence</translation>
    </message>
    <message>
        <source>Certifying the sequence again</source>
        <translation>Nouvelle certification de la séquence</translation>
    </message>
    <message>
        <source>Sequence: %1</source>
        <translation>Séquence&#xa0;: %1</translation>
    </message>
    <message>
        <source>Moving the step</source>
        <translation>Déplacement de l&apos;étape</translation>
    </message>
    <message>
        <source>Step %1 has to come after step %2: %3</source>
        <translation>L&apos;étape %1 doit venir après l&apos;étape %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1. The order is as before.</source>
        <translation>%1. L&apos;ordre reste tel quel.</translation>
    </message>
    <message>
        <source>The step cannot be moved there</source>
        <translation>L&apos;étape ne peut pas aller là</translation>
    </message>
    <message>
        <source>&amp;Search other motions</source>
        <translation>&amp;Chercher d&apos;autres mouvements</translation>
    </message>
</context>
<context>
    <name>glissade::SequenceEdits</name>
    <message>
        <source>Two constraints exclude each other</source>
        <translation>Deux contraintes s&apos;excluent</translation>
    </message>
    <message>
        <source>Cost of steps</source>
        <translation>Coût des étapes</translation>
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
        <translation>%1&#xa0;: direction %2 interdite</translation>
    </message>
    <message>
        <source>Rule out the direction of %1</source>
        <translation>Interdire la direction de %1</translation>
    </message>
    <message>
        <source>Keep the order of %1</source>
        <translation>Garder l&apos;ordre de %1</translation>
    </message>
    <message>
        <source>No constraints on %1</source>
        <translation>Supprimer les contraintes sur %1</translation>
    </message>
    <message>
        <source>Remove: %1</source>
        <translation>Retirer&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is removed by the motion by hand</source>
        <translation>%1 est démontée par le mouvement fait à la main</translation>
    </message>
    <message>
        <source>%1 keeps its motion</source>
        <translation>%1 garde son mouvement</translation>
    </message>
    <message>
        <source>%1 is not removed %2</source>
        <translation>%1 n&apos;est pas démontée dans la direction %2</translation>
    </message>
    <message>
        <source>%1 is removed before %2</source>
        <translation>%1 est démontée avant %2</translation>
    </message>
    <message>
        <source>%1 are removed as one</source>
        <translation>%1 sont démontées ensemble</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>The sequence cannot be planned with these constraints</source>
        <translation>La séquence ne peut pas être planifiée avec ces contraintes</translation>
    </message>
    <message>
        <source>%1 is locked as step %2</source>
        <translation>%1 est verrouillée comme étape %2</translation>
    </message>
    <message>
        <source>%1 is placed as step %2</source>
        <translation>%1 est placée comme étape %2</translation>
    </message>
</context>
<context>
    <name>glissade::SequenceHand</name>
    <message>
        <source>The path uses a ruled-out direction</source>
        <translation>Le chemin utilise une direction interdite</translation>
    </message>
    <message>
        <source>Path of %1</source>
        <translation>Chemin de %1</translation>
    </message>
    <message>
        <source>The path that the computer found is the motion of %1.</source>
        <translation>Le chemin trouvé par l&apos;ordinateur devient le mouvement de %1.</translation>
    </message>
    <message>
        <source>The step cannot be moved by hand</source>
        <translation>L&apos;étape ne peut pas être faite à la main</translation>
    </message>
    <message>
        <source>Move %1 by hand</source>
        <translation>Déplacer %1 à la main</translation>
    </message>
    <message>
        <source>%1 by hand</source>
        <translation>%1 à la main</translation>
    </message>
    <message>
        <source>The path by hand is the motion of %1.</source>
        <translation>Le chemin fait à la main devient le mouvement de %1.</translation>
    </message>
    <message>
        <source>Step %1 by hand: %2</source>
        <translation>Étape %1 à la main&#xa0;: %2</translation>
    </message>
    <message>
        <source>Find path (F5) begins a run. Its certified path becomes the step. Esc goes back.</source>
        <translation>Chercher un chemin (F5) lance un calcul. Son chemin certifié devient l&apos;étape. Échap revient en arrière.</translation>
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
        <source>Moves the parts apart along their directions of removal</source>
        <translation>Écarte les pièces dans leurs directions de démontage</translation>
    </message>
    <message>
        <source>E&amp;xplode</source>
        <translation>Éc&amp;laté</translation>
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
        <source>Base: %1.</source>
        <translation>Base&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>Stopped. Results kept.</source>
        <translation>Arrêté. Résultats conservés.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Co&amp;nstraints</source>
        <translation>&amp;Contraintes</translation>
    </message>
    <message>
        <source>Ste&amp;p</source>
        <translation>Éta&amp;pe</translation>
    </message>
    <message>
        <source>Move, lock or free the selected step, or move its part by hand</source>
        <translation>Déplacer, verrouiller ou libérer l&apos;étape sélectionnée, ou déplacer sa pièce à la main</translation>
    </message>
    <message>
        <source>&amp;Cost</source>
        <translation>Coû&amp;t</translation>
    </message>
    <message>
        <source>What a step costs</source>
        <translation>Coût d&apos;une étape</translation>
    </message>
    <message>
        <source>The time limit was reached.</source>
        <translation>La limite de temps a été atteinte.</translation>
    </message>
    <message>
        <source>Rule out a &amp;direction</source>
        <translation>&amp;Interdire une direction</translation>
    </message>
    <message>
        <source>The order that costs least is used. An expression, as 5 * tool_change + length, or one of the list; the last of it keeps the order in which the removals were found</source>
        <translation>L&apos;ordre le moins coûteux est utilisé. Une expression, comme 5 * tool_change + length, ou un choix de la liste&#xa0;; le dernier garde l&apos;ordre dans lequel les démontages ont été trouvés</translation>
    </message>
    <message numerus="yes">
        <source>%n stuck.</source>
        <translation>
            <numerusform>%n coincée.</numerusform>
            <numerusform>%n coincées.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n forced.</source>
        <translation>
            <numerusform>%n forcée.</numerusform>
            <numerusform>%n forcées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Valid only if %1.</source>
        <translation>Valable seulement si %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) are no longer valid.</source>
        <translation>
            <numerusform>%n étape n&apos;est plus valide.</numerusform>
            <numerusform>%n étapes ne sont plus valides.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sequence: %n step(s)</source>
        <translation>
            <numerusform>Séquence : %n étape</numerusform>
            <numerusform>Séquence : %n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 (pressed into %2)</source>
        <translation>%1 (emmanché dans %2)</translation>
    </message>
    <message>
        <source>%1 (permanent joint with %2)</source>
        <translation>%1 (liaison permanente avec %2)</translation>
    </message>
    <message>
        <source>%1 (one unit with %2)</source>
        <translation>%1 (une unité avec %2)</translation>
    </message>
    <message>
        <source>Stays with it: %1.</source>
        <translation>Reste avec elle&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Constraints have changed: planning begins when you pause, or now by Plan sequence.</source>
        <translation>Des contraintes ont changé&#xa0;: la planification commence dès que vous faites une pause, ou tout de suite par Planifier la séquence.</translation>
    </message>
    <message>
        <source>Trying %1…</source>
        <translation>Essai de %1…</translation>
    </message>
    <message numerus="yes">
        <source>Trying %1 and %n more…</source>
        <translation>
            <numerusform>Essai de %1 et de %n autre…</numerusform>
            <numerusform>Essai de %1 et de %n autres…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 parts assembled</source>
        <translation>
            <numerusform>%n pièce sur %1 assemblée</numerusform>
            <numerusform>%n pièces sur %1 assemblées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 parts removed</source>
        <translation>
            <numerusform>%n pièce sur %1 démontée</numerusform>
            <numerusform>%n pièces sur %1 démontées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them in groups that stay together</source>
        <translation>
            <numerusform>dont %n dans un groupe qui reste entier</numerusform>
            <numerusform>dont %n dans des groupes qui restent entiers</numerusform>
        </translation>
    </message>
    <message>
        <source>every motion certified</source>
        <translation>chaque mouvement certifié</translation>
    </message>
    <message numerus="yes">
        <source>%n without a certificate</source>
        <translation>
            <numerusform>%n sans certificat</numerusform>
            <numerusform>%n sans certificat</numerusform>
        </translation>
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
        <translation>Choisissez une commande.</translation>
    </message>
    <message>
        <source>Bold shortcuts differ from the default.</source>
        <translation>Les raccourcis en gras diffèrent des raccourcis par défaut.</translation>
    </message>
    <message>
        <source>Keys without Ctrl or Alt steer the object and write text.</source>
        <translation>Les touches sans Ctrl ni Alt pilotent l&apos;objet et servent à la saisie.</translation>
    </message>
    <message>
        <source>It is taken from &quot;%1&quot;.</source>
        <translation>Il sera retiré à «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Part of a command, a menu or a shortcut</source>
        <translation>Partie d&apos;une commande, d&apos;un menu ou d&apos;un raccourci</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
</context>
<context>
    <name>glissade::StepTable</name>
    <message>
        <source>certified</source>
        <translation>certifiée</translation>
    </message>
    <message>
        <source>✓ certified</source>
        <translation>✓ certifiée</translation>
    </message>
    <message>
        <source>✗ not valid</source>
        <translation>✗ non valide</translation>
    </message>
    <message>
        <source>certified when it was found</source>
        <translation>certifiée au moment de sa découverte</translation>
    </message>
    <message>
        <source>certified again by the independent check</source>
        <translation>certifiée de nouveau par la vérification indépendante</translation>
    </message>
    <message>
        <source>not valid in this arrangement</source>
        <translation>non valide dans cette disposition</translation>
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
        <translation>Aminci de</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Maintien</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Above: the tool that turns the fastener, and what blocks it. Below: parts that need support because they would tip or fall, or the constraints that a forced step violates</source>
        <translation>En haut&#xa0;: l&apos;outil qui tourne la fixation, et ce qui le bloque. En bas&#xa0;: les pièces à maintenir car elles basculeraient ou tomberaient, ou les contraintes qu&apos;une étape forcée ne respecte pas</translation>
    </message>
    <message>
        <source>Steps of the sequence</source>
        <translation>Étapes de la séquence</translation>
    </message>
    <message>
        <source>forced: %1</source>
        <translation>forcée&#xa0;: %1</translation>
    </message>
    <message>
        <source>found by %1</source>
        <translation>trouvée par %1</translation>
    </message>
    <message>
        <source>Above: whether the motion is certified. Below: edits of the step</source>
        <translation>En haut&#xa0;: certificat du mouvement. En bas&#xa0;: modifications de l&apos;étape</translation>
    </message>
    <message>
        <source>found after %1 s of computing</source>
        <translation>trouvée après %1 s de calcul</translation>
    </message>
    <message>
        <source>%1 is stuck.</source>
        <translation>%1 est coincée.</translation>
    </message>
    <message>
        <source>Blocked by %1.</source>
        <translation>Bloqué par %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n inside not reached</source>
        <translation>
            <numerusform>%n à l&apos;intérieur non atteinte</numerusform>
            <numerusform>%n à l&apos;intérieur non atteintes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in its group: %2</source>
        <translation>%1, dans son groupe&#xa0;: %2</translation>
    </message>
    <message>
        <source>earlier plan</source>
        <translation>plan précédent</translation>
    </message>
    <message>
        <source>%1 was not removed.</source>
        <translation>%1 n&apos;a pas été démontée.</translation>
    </message>
    <message>
        <source>Next: decide about its fits and joints (Contacts), move it by hand (menu of the row), or see the precedence graph.</source>
        <translation>Ensuite&#xa0;: décidez de ses ajustements et de ses liaisons (Contacts), déplacez-la à la main (menu de la ligne), ou consultez le graphe d&apos;antériorité.</translation>
    </message>
    <message>
        <source>Next: resume planning.</source>
        <translation>Ensuite&#xa0;: reprenez la planification.</translation>
    </message>
    <message>
        <source>Above: smallest distance to other parts on the motion. Below: how much thinner the part counts where the file lets parts touch or overlap, such as a fit</source>
        <translation>En haut&#xa0;: plus petite distance aux autres pièces pendant le mouvement. En bas&#xa0;: amincissement de la pièce là où le fichier fait se toucher ou se chevaucher des pièces, comme un ajustement</translation>
    </message>
    <message>
        <source>touches nothing</source>
        <translation>ne touche rien</translation>
    </message>
    <message>
        <source>The part touches nothing: it may lie beside the product.</source>
        <translation>La pièce ne touche rien&#xa0;: elle se trouve peut-être à côté du produit.</translation>
    </message>
    <message>
        <source>Clearance: the smallest distance on the whole motion is %1, to %2; at least %3 is certified. It is certified because it is not below the required clearance.</source>
        <translation>Jeu&#xa0;: la plus petite distance pendant tout le mouvement est de %1, à %2&#xa0;; au moins %3 est certifié. Il est certifié parce qu’il n’est pas inférieur au jeu exigé.</translation>
    </message>
    <message>
        <source>Allowance: the file lets these parts touch or overlap, so that the moving part counts as thinner by this length against them. An allowance above the clearance is usual for a fit; the clearance is what is left beside it.</source>
        <translation>Amincissement&#xa0;: le fichier fait se toucher ou se chevaucher ces pièces, si bien que la pièce mobile compte comme plus mince de cette longueur face à elles. Un amincissement supérieur au jeu est habituelle pour un ajustement&#xa0;; le jeu est ce qui reste en plus.</translation>
    </message>
</context>
<context>
    <name>glissade::StereoController</name>
    <message>
        <source>The graphics driver has no buffers of their own for each eye</source>
        <translation>Le pilote graphique n&apos;a pas de tampons propres à chaque œil</translation>
    </message>
</context>
<context>
    <name>glissade::StereoDialog</name>
    <message>
        <source>&amp;Swap the eyes</source>
        <translation>Échanger les &amp;yeux</translation>
    </message>
    <message>
        <source>Of the whole screen, measured with a ruler</source>
        <translation>De l&apos;écran entier, mesurée à la règle</translation>
    </message>
    <message>
        <source>From the eyes to the screen</source>
        <translation>Des yeux à l&apos;écran</translation>
    </message>
    <message>
        <source>From pupil to pupil; 63 mm is the mean of adults</source>
        <translation>D&apos;une pupille à l&apos;autre&#xa0;; 63 mm est la moyenne des adultes</translation>
    </message>
    <message>
        <source>Stereo and screen</source>
        <translation>Stéréo et écran</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Mode</translation>
    </message>
    <message>
        <source>&amp;Width of the screen</source>
        <translation>&amp;Largeur de l&apos;écran</translation>
    </message>
    <message>
        <source>&amp;Distance of the eyes</source>
        <translation>&amp;Distance des yeux</translation>
    </message>
    <message>
        <source>Separa&amp;tion of the eyes</source>
        <translation>Écar&amp;t des yeux</translation>
    </message>
    <message>
        <source>In the &amp;plane of the screen</source>
        <translation>Dans le &amp;plan de l&apos;écran</translation>
    </message>
    <message>
        <source>&amp;Full screen on</source>
        <translation>Plein écran s&amp;ur</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>the middle of the view</source>
        <translation>le milieu de la vue</translation>
    </message>
    <message>
        <source>the object</source>
        <translation>l&apos;objet</translation>
    </message>
    <message>
        <source>what the pointer rests on</source>
        <translation>ce sur quoi le pointeur s&apos;est posé</translation>
    </message>
    <message>
        <source>What neither stands out of the screen nor lies behind it</source>
        <translation>Ce qui ne sort pas de l&apos;écran et n&apos;est pas derrière lui</translation>
    </message>
    <message>
        <source>the display of the window</source>
        <translation>l&apos;écran de la fenêtre</translation>
    </message>
    <message>
        <source>The scene is then %L1 × %L2 mm large.</source>
        <translation>La scène mesure alors %L1 × %L2 mm.</translation>
    </message>
</context>
<context>
    <name>glissade::StudyController</name>
    <message>
        <source>Open the results of a study</source>
        <translation>Ouvrir les résultats d&apos;une étude</translation>
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
        <source>The run cannot be shown</source>
        <translation>L&apos;essai ne peut pas être montré</translation>
    </message>
    <message>
        <source>Seed %1 ended as in the study: %2 nodes.</source>
        <translation>L&apos;essai de graine %1 a fini comme dans l&apos;étude&#xa0;: %2 nœuds.</translation>
    </message>
    <message>
        <source>Seed %1 ended differently from the study: %2 nodes. Is this another version of Glissade?</source>
        <translation>La graine %1 n&apos;a pas fini comme dans l&apos;étude&#xa0;: %2 nœuds. Est-ce une autre version&#xa0;?</translation>
    </message>
    <message>
        <source>Open a run of a study</source>
        <translation>Ouvrir un essai d&apos;une étude</translation>
    </message>
    <message>
        <source>Runs of studies (cell*.json)</source>
        <translation>Essais d&apos;études (cell*.json)</translation>
    </message>
    <message>
        <source>Writing the page of the study</source>
        <translation>Écriture de la page de l&apos;étude</translation>
    </message>
    <message>
        <source>The page cannot be written</source>
        <translation>La page ne peut pas être écrite</translation>
    </message>
    <message>
        <source>The page was written, with a warning</source>
        <translation>La page a été écrite, avec un avertissement</translation>
    </message>
    <message>
        <source>The page is %1</source>
        <translation>La page est %1</translation>
    </message>
    <message>
        <source>Seed %1 of the study is running.</source>
        <translation>La graine %1 de l&apos;étude est calculée.</translation>
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
        <translation>Volume balayé&#xa0;: %1 %2&#xa0;; sa surface est à %3 de l&apos;objet au plus</translation>
    </message>
    <message>
        <source>; within it or at its surface: %1</source>
        <translation>&#xa0;; à l&apos;intérieur ou à sa surface&#xa0;: %1</translation>
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
    <message>
        <source>; a closer surface takes too much memory: the volume may be more than %1 % too large</source>
        <translation>&#xa0;; une surface plus proche demande trop de mémoire&#xa0;: le volume peut être trop grand de plus de %1 %</translation>
    </message>
</context>
<context>
    <name>glissade::TimesController</name>
    <message>
        <source>Balancing the line</source>
        <translation>Équilibrage de la ligne</translation>
    </message>
    <message>
        <source>The line cannot be balanced</source>
        <translation>La ligne ne peut pas être équilibrée</translation>
    </message>
    <message>
        <source>The table of times of %1 is used</source>
        <translation>Le tableau des temps de %1 est utilisé</translation>
    </message>
    <message>
        <source>The table of times was saved as %1</source>
        <translation>Le tableau des temps a été enregistré sous %1</translation>
    </message>
    <message>
        <source>Open a table of times</source>
        <translation>Ouvrir un tableau des temps</translation>
    </message>
    <message>
        <source>Tables of times (*.json);;All files (*)</source>
        <translation>Tableaux des temps (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The table of times cannot be opened</source>
        <translation>Le tableau des temps ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Save the table of times</source>
        <translation>Enregistrer le tableau des temps</translation>
    </message>
    <message>
        <source>Tables of times (*.json)</source>
        <translation>Tableaux des temps (*.json)</translation>
    </message>
    <message>
        <source>The table of times cannot be saved</source>
        <translation>Le tableau des temps ne peut pas être enregistré</translation>
    </message>
</context>
<context>
    <name>glissade::TimesView</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>One person: %1. Critical path: %2, the minimum, however many people.</source>
        <translation>Une personne&#xa0;: %1. Chemin critique&#xa0;: %2, le minimum quel que soit le nombre de personnes.</translation>
    </message>
    <message>
        <source>Cycle time %1, minimum %2. Utilization %3 %.</source>
        <translation>Temps de cycle %1, minimum %2. Taux d&apos;occupation %3 %.</translation>
    </message>
    <message>
        <source>The times are estimates and were not measured.</source>
        <translation>Les temps sont des estimations et n&apos;ont pas été mesurés.</translation>
    </message>
    <message>
        <source>Assembly times</source>
        <translation>Temps d&apos;assemblage</translation>
    </message>
    <message>
        <source>Stations of the line, one person each; the product passes them in order</source>
        <translation>Postes de la ligne, une personne chacun&#xa0;; le produit les passe dans l&apos;ordre</translation>
    </message>
    <message>
        <source>A bar for each station with the numbers of its steps</source>
        <translation>Une barre par poste avec les numéros de ses étapes</translation>
    </message>
    <message>
        <source>&amp;Stations</source>
        <translation>&amp;Postes</translation>
    </message>
    <message>
        <source>There is no assembly plan.</source>
        <translation>Il n&apos;y a pas de plan d&apos;assemblage.</translation>
    </message>
    <message>
        <source>%1 of the %2 values of the table of times were edited. The others are estimates and were not measured.</source>
        <translation>%1 des %2 valeurs du tableau des temps ont été modifiées. Les autres sont des estimations et n&apos;ont pas été mesurées.</translation>
    </message>
    <message>
        <source>&amp;Chart</source>
        <translation>&amp;Graphique</translation>
    </message>
    <message>
        <source>&amp;Table of times</source>
        <translation>&amp;Tableau des temps</translation>
    </message>
</context>
<context>
    <name>glissade::TourController</name>
    <message>
        <source>Not possible</source>
        <translation>Opération impossible</translation>
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
        <translation>Visite&#xa0;: étape %1 sur %2</translation>
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
    <name>glissade::VariantsController</name>
    <message>
        <source>Bodies fill the same place: are they variants of one part?</source>
        <translation>Des corps remplissent le même endroit&#xa0;: sont-ils des variantes d&apos;une pièce&#xa0;?</translation>
    </message>
    <message>
        <source>Exclude variants</source>
        <translation>Exclure des variantes</translation>
    </message>
    <message>
        <source>The variant cannot be excluded</source>
        <translation>La variante ne peut pas être exclue</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glissade::VariantsDialog</name>
    <message>
        <source>Variants</source>
        <translation>Variantes</translation>
    </message>
    <message>
        <source>These bodies fill the same place, as variants of one part do. Choose the one that is built. The scenario keeps the others under &quot;Excluded&quot;.</source>
        <translation>Ces corps remplissent le même endroit, comme le font les variantes d&apos;une pièce. Choisissez celui qui est construit. Le scénario garde les autres sous «&#xa0;Exclus&#xa0;».</translation>
    </message>
    <message>
        <source>&amp;Exclude the others</source>
        <translation>E&amp;xclure les autres</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Endroit %1</translation>
    </message>
    <message>
        <source>All of them are built</source>
        <translation>Tous sont construits</translation>
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
    <name>glissade::WelcomeController</name>
    <message>
        <source>Not there</source>
        <translation>Absent</translation>
    </message>
    <message>
        <source>The samples were not found. They were searched in:</source>
        <translation>Les exemples n&apos;ont pas été trouvés. Ils ont été cherchés dans&#xa0;:</translation>
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
        <translation>Créez un scénario à partir de vos pièces, ouvrez-en un, ou déposez des fichiers ici&#xa0;: scénarios, STEP, maillages, URDF.</translation>
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
        <translation>%1&#xa0;: annulé après %2 s</translation>
    </message>
    <message>
        <source>%1: ended after %2 s</source>
        <translation>%1&#xa0;: terminé après %2 s</translation>
    </message>
</context>
<context>
    <name>glissade::WorkTimeTable</name>
    <message>
        <source>Table of times</source>
        <translation>Tableau des temps</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Élément</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modifié</translation>
    </message>
</context>
<context>
    <name>glissade::WorkTimesEditor</name>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>Set the selected values back to their defaults</source>
        <translation>Remettre les valeurs sélectionnées à leur valeur par défaut</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Réinitialiser to&amp;ut</translation>
    </message>
    <message>
        <source>Set all values back to their defaults</source>
        <translation>Remettre toutes les valeurs à leur valeur par défaut</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>Réta&amp;blir</translation>
    </message>
    <message>
        <source>&amp;Open table...</source>
        <translation>&amp;Ouvrir un tableau...</translation>
    </message>
    <message>
        <source>Read a table of times, as glissade-cli times --write-table writes it</source>
        <translation>Lire un tableau des temps, tel que glissade-cli times --write-table l&apos;écrit</translation>
    </message>
    <message>
        <source>Sa&amp;ve table...</source>
        <translation>&amp;Enregistrer le tableau...</translation>
    </message>
    <message>
        <source>Write the table into a file, which glissade-cli times --table reads</source>
        <translation>Écrire le tableau dans un fichier, que glissade-cli times --table lit</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; %3. The value stays %4 %5.</source>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» %3. La valeur reste %4 %5.</translation>
    </message>
    <message>
        <source>Changed values: %1 of %2</source>
        <translation>Valeurs modifiées&#xa0;: %1 sur %2</translation>
    </message>
    <message>
        <source>Undo the last edit of the table (%1)</source>
        <translation>Annuler la dernière modification du tableau (%1)</translation>
    </message>
    <message>
        <source>Redo the edit of the table that was undone (%1)</source>
        <translation>Rétablir la modification annulée du tableau (%1)</translation>
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
        <source>The object cannot reach it. Undo, or fit the workspace.</source>
        <translation>L&apos;objet ne peut pas l&apos;atteindre. Annulez, ou ajustez l&apos;espace de travail.</translation>
    </message>
    <message>
        <source>No run can start there. Undo, or fit the workspace.</source>
        <translation>Aucun calcul ne peut y commencer. Annulez, ou ajustez l&apos;espace de travail.</translation>
    </message>
</context>
</TS>
