<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Start with a seedling.</source>
        <translation>Commencer avec une plantule.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open a project or a recipe.</source>
        <translation>Ouvrir un projet ou une recette.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>Enregistrer le projet.</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Save the project under another name.</source>
        <translation>Enregistrer le projet sous un autre nom.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Write the tree for other programs: GLB, FBX, OBJ, or its skeleton as CSV.</source>
        <translation>Écrire l’arbre pour d’autres programmes&#xa0;: GLB, FBX, OBJ, ou son squelette en CSV.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Leave Espalier.</source>
        <translation>Quitter Espalier.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take back what you did last.</source>
        <translation>Annuler la dernière action.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Do again what you took back.</source>
        <translation>Refaire ce qui a été annulé.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Drag from the tree outward: it grows into the space that the brush passes through.</source>
        <translation>Faire glisser depuis l’arbre vers l’extérieur&#xa0;: il pousse dans l’espace où passe le pinceau.</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Croître</translation>
    </message>
    <message>
        <source>Press anywhere and hold: the tree grows on its own, competing for light and space.</source>
        <translation>Appuyer n’importe où et maintenir&#xa0;: l’arbre pousse seul, en concurrence pour la lumière et l’espace.</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Tailler</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw across all the branches to cut.</source>
        <translation>Toucher une branche pour l’ôter, ou tracer à travers tout ce qui doit tomber.</translation>
    </message>
    <message>
        <source>Bud</source>
        <translation>Bourgeon</translation>
    </message>
    <message>
        <source>Tap a bud: from now on, only this bud grows, and what comes from it.</source>
        <translation>Toucher un bourgeon&#xa0;: lui seul pousse désormais, avec ce qui en naît.</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Courber</translation>
    </message>
    <message>
        <source>Pull a branch to bend it; tap it to pin it there.</source>
        <translation>Tirer sur une branche pour la courber&#xa0;; la toucher pour l’épingler là où elle est tenue.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Tap a branch to fix its width, and drag the handle to change it.</source>
        <translation>Toucher une branche pour fixer son épaisseur, et tirer la poignée pour la changer.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw the silhouette of a crown: the tree grows until it fills that shape.</source>
        <translation>Dessiner la silhouette d’un houppier&#xa0;: l’arbre pousse jusqu’à le remplir.</translation>
    </message>
    <message>
        <source>Grow One Step</source>
        <translation>Croître d’une étape</translation>
    </message>
    <message>
        <source>Let the tree grow one step on its own.</source>
        <translation>Laisser l’arbre croître seul d’une étape.</translation>
    </message>
    <message>
        <source>Smaller Brush</source>
        <translation>Pinceau plus petit</translation>
    </message>
    <message>
        <source>Make the brush smaller, even while brushing.</source>
        <translation>Réduire le pinceau, même en cours de trait.</translation>
    </message>
    <message>
        <source>Larger Brush</source>
        <translation>Pinceau plus grand</translation>
    </message>
    <message>
        <source>Make the brush larger, even while brushing.</source>
        <translation>Agrandir le pinceau, même en cours de trait.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Take back the stroke or the growth under way.</source>
        <translation>Annuler le trait ou la croissance en cours.</translation>
    </message>
    <message>
        <source>Frame All</source>
        <translation>Tout cadrer</translation>
    </message>
    <message>
        <source>Show the whole tree.</source>
        <translation>Afficher l’arbre entier.</translation>
    </message>
    <message>
        <source>From the Front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>Look at the tree from the front.</source>
        <translation>Regarder l’arbre de face.</translation>
    </message>
    <message>
        <source>From the Side</source>
        <translation>De côté</translation>
    </message>
    <message>
        <source>Look at the tree from the side.</source>
        <translation>Regarder l’arbre de côté.</translation>
    </message>
    <message>
        <source>From the Top</source>
        <translation>De dessus</translation>
    </message>
    <message>
        <source>Look down at the tree.</source>
        <translation>Regarder l’arbre d’en haut.</translation>
    </message>
    <message>
        <source>Three-Quarter</source>
        <translation>Trois quarts</translation>
    </message>
    <message>
        <source>Look at the tree from between the front and the side.</source>
        <translation>Regarder l’arbre de trois quarts.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads.</source>
        <translation>Afficher les points d’espace libre que répand le pinceau.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Show the leaves.</source>
        <translation>Afficher les feuilles.</translation>
    </message>
    <message>
        <source>Architecture</source>
        <translation>Architecture</translation>
    </message>
    <message>
        <source>How the tree grows from now on.</source>
        <translation>Comment l’arbre pousse à partir de maintenant.</translation>
    </message>
    <message>
        <source>What the leaves look like.</source>
        <translation>L’aspect des feuilles.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>How thick branches are, and their bark.</source>
        <translation>L’épaisseur des branches, et leur écorce.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>What is around the tree: background, ground, sun, reference picture.</source>
        <translation>Ce qui entoure l’arbre&#xa0;: fond, sol, soleil, image modèle.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Everything you did, step by step; click a step to go back to it.</source>
        <translation>Tout ce qui a été fait, étape par étape&#xa0;; un clic y ramène.</translation>
    </message>
    <message>
        <source>Focus Panels or Tree</source>
        <translation>Vers les panneaux et retour</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the panels, or back to the tree.</source>
        <translation>Donner le clavier aux panneaux, ou le rendre à l’arbre.</translation>
    </message>
    <message>
        <source>Only the Tree</source>
        <translation>L’arbre seul</translation>
    </message>
    <message>
        <source>Hide everything but the tree; the same key brings everything back.</source>
        <translation>Tout masquer sauf l’arbre&#xa0;; la même touche fait tout revenir.</translation>
    </message>
    <message>
        <source>Full Screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Fill the whole screen.</source>
        <translation>Occuper tout l’écran.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Help on the current tool, and on everything else.</source>
        <translation>L’outil en main, et tout le reste.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Species to start from, and the trees you keep.</source>
        <translation>Des espèces pour commencer, et les arbres gardés.</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Réglages…</translation>
    </message>
    <message>
        <source>How Espalier looks, and how it responds to your hand.</source>
        <translation>L’aspect d’Espalier, et sa façon de répondre à la main.</translation>
    </message>
    <message>
        <source>Size of the brush, pressure of the pen, and what is shown while you brush.</source>
        <translation>Taille du pinceau, pression du stylet, et place que répand le pinceau.</translation>
    </message>
    <message>
        <source>Save as Recipe…</source>
        <translation>Enregistrer comme recette…</translation>
    </message>
    <message>
        <source>Save everything that was done to the tree, so that it can be done again.</source>
        <translation>Noter ce qui a été fait à l’arbre, pour pouvoir le refaire.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsader</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands.</source>
        <translation>Faire glisser le long d’une branche, ou autour d’elle, pour torsader ses brins.</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>Rejets</translation>
    </message>
    <message>
        <source>Tap old wood: buds break through its bark, and grow into branches.</source>
        <translation>Toucher du vieux bois&#xa0;: des bourgeons percent l’écorce et deviennent des branches.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Tap a branch to see its cross-section, and draw its shape.</source>
        <translation>Toucher une branche pour voir sa section, et en dessiner la forme.</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>Fortifier</translation>
    </message>
    <message>
        <source>Press a branch and hold: it alone grows until you let go.</source>
        <translation>Appuyer sur une branche et maintenir&#xa0;: elle seule pousse jusqu’au relâchement.</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>Press a branch and hold: its youngest growth disappears, step by step.</source>
        <translation>Appuyer sur une branche et maintenir&#xa0;: ce qui a poussé en dernier s’en va, étape par étape.</translation>
    </message>
    <message>
        <source>Show the strands of the wood as lines, each branch in its own colour.</source>
        <translation>Montre les brins dont le bois est fait sous forme de lignes, chaque branche dans sa couleur.</translation>
    </message>
    <message>
        <source>Strand Lines</source>
        <translation>Lignes des brins</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Esquisse</translation>
    </message>
    <message>
        <source>Draw the trunk and its branches as lines, then give the drawing depth.</source>
        <translation>Dessiner le tronc et ses branches en lignes, puis donner sa profondeur au dessin.</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplier</translation>
    </message>
    <message>
        <source>Tap a branch: it gets more branches like those it carries, or passes on to others what it carries.</source>
        <translation>Toucher une branche : elle en reçoit d’autres comme celles qu’elle porte, ou les transmet.</translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation>Reproduire</translation>
    </message>
    <message>
        <source>Draw a trunk and a silhouette: the same tree takes on this new shape.</source>
        <translation>Dessiner un tronc et une silhouette&#xa0;: le même arbre prend cette nouvelle forme.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Drag a branch along the wood, around it, or to other wood, with all it carries.</source>
        <translation>Tirer une branche le long du bois, autour de lui ou sur un autre bois, avec tout ce qu’elle porte.</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>Enregistrer une image…</translation>
    </message>
    <message>
        <source>Save a picture of the tree, in any size and from any side.</source>
        <translation>Enregistrer une image de l’arbre, de toute taille et de tout côté.</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Copier l’image</translation>
    </message>
    <message>
        <source>Copy a picture of the tree, as it is shown now, to the clipboard.</source>
        <translation>Placer dans le presse-papiers une image de l’arbre tel qu’il est affiché.</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>Un autre comme celui-ci</translation>
    </message>
    <message>
        <source>See six other trees that the same strokes could have made, and take one.</source>
        <translation>Voir six arbres que les mêmes traits donnent par un autre hasard, et en prendre un.</translation>
    </message>
    <message>
        <source>Person for Scale</source>
        <translation>Personne pour l’échelle</translation>
    </message>
    <message>
        <source>Show a person beside the tree, and how long a metre is.</source>
        <translation>Montrer une personne à côté de l’arbre, et la longueur d’un mètre.</translation>
    </message>
    <message>
        <source>Tool Ring</source>
        <translation>Anneau d’outils</translation>
    </message>
    <message>
        <source>Tools, undo and brush size in a ring around the pointer. Hold the key, and let go over the one you want.</source>
        <translation>Les outils, l’annulation et la taille du pinceau autour du pointeur. Maintenez la touche et relâchez-la sur l’un d’eux.</translation>
    </message>
    <message>
        <source>Second View</source>
        <translation>Seconde vue</translation>
    </message>
    <message>
        <source>Show the tree from the right, in a corner of the window; draw there, too, to give it depth.</source>
        <translation>Montrer l’arbre vu de droite dans un coin ; dessinez-y aussi pour lui donner de la profondeur.</translation>
    </message>
    <message>
        <source>Report a Problem…</source>
        <translation>Signaler un problème…</translation>
    </message>
    <message>
        <source>Copy what a report should have: version, graphics and log.</source>
        <translation>Copier ce qu’un rapport doit contenir : version, affichage et journal.</translation>
    </message>
    <message>
        <source>Bring Trees Back…</source>
        <translation>Récupérer des arbres…</translation>
    </message>
    <message>
        <source>See the trees that were not saved when Espalier ended.</source>
        <translation>Voir les arbres qui n’étaient pas enregistrés à la fin d’Espalier.</translation>
    </message>
</context>
<context>
    <name>AddBudsTool</name>
    <message>
        <source>Tap old wood to let buds break through its bark; they grow into branches</source>
        <translation>Toucher du vieux bois pour que des bourgeons percent l’écorce&#xa0;; ils deviennent des branches</translation>
    </message>
</context>
<context>
    <name>BendTool</name>
    <message>
        <source>Pull a branch to bend it; or tap where the bend begins, then where to hold it</source>
        <translation>Tirer sur une branche pour la courber&#xa0;; toucher pour épingler sa base, puis là où elle est tenue</translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message>
        <source>Drag to brush a tree into being; begin at a branch to draw at its depth</source>
        <translation>Faire glisser pour peindre un arbre&#xa0;; partir d’une branche pour continuer à sa profondeur</translation>
    </message>
    <message>
        <source>No bud sees this place: keep drawing, or begin at a branch</source>
        <translation>Aucun bourgeon ne voit cet endroit : continuez le trait, ou partez d’une branche</translation>
    </message>
    <message>
        <source>Only the chosen bud grows, and it does not see this place</source>
        <translation>Seul le bourgeon choisi pousse, et il ne voit pas cet endroit</translation>
    </message>
</context>
<context>
    <name>ClearTool</name>
    <message>
        <source>buds may shoot</source>
        <translation>les bourgeons peuvent pousser</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: below your hand, nothing shoots any more</source>
        <translation>Glissez vers le haut le long d’un tronc ou d’une branche : plus rien ne pousse au-dessous de votre main</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--strict: nothing is written, because some operations did not find everything that they name</source>
        <translation>--strict&#xa0;: rien n’est écrit, car des opérations n’ont rien trouvé à faire, ou pas tout ce qu’elles nomment</translation>
    </message>
    <message>
        <source>--size needs WIDTHxHEIGHT of up to %1 pixels each, not &quot;%2&quot;</source>
        <translation>--size attend LARGEURxHAUTEUR jusqu’à %1 pixels chacune, pas «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1: the suffix of an output says its format, and is one of .espalier .%2</source>
        <translation>%1&#xa0;: le suffixe d’une sortie indique son format, et c’est l’un de .espalier .%2</translation>
    </message>
    <message>
        <source>--camera needs front, side, top or three-quarter, not &quot;%1&quot;</source>
        <translation>--camera vaut front, side, top ou three-quarter, pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>--threads needs a number from 1 to %1, not &quot;%2&quot;</source>
        <translation>--threads attend un nombre de 1 à %1, pas «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>--seed needs a whole number from 0 to 18446744073709551615, not &quot;%1&quot;</source>
        <translation>--seed attend un nombre entier de 0 à 18446744073709551615, pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 has no option %2</source>
        <translation>%1 ne connaît pas l’option %2</translation>
    </message>
    <message>
        <source>%1 takes no value</source>
        <translation>%1 n’attend pas de valeur</translation>
    </message>
    <message>
        <source>%1 needs a value after it</source>
        <translation>%1 attend une valeur à sa suite</translation>
    </message>
    <message>
        <source>--transparent needs --png FILE</source>
        <translation>--transparent attend --png FICHIER</translation>
    </message>
    <message>
        <source>--ground-shadow needs --transparent</source>
        <translation>--ground-shadow attend --transparent</translation>
    </message>
    <message>
        <source>%1 needs one project</source>
        <translation>%1 attend un projet</translation>
    </message>
    <message>
        <source>render needs --png FILE</source>
        <translation>render attend --png FICHIER</translation>
    </message>
    <message>
        <source>info needs one file</source>
        <translation>info attend un fichier</translation>
    </message>
    <message>
        <source>a window opens only one file; &quot;%1&quot; is one too many</source>
        <translation>une fenêtre montre un seul fichier&#xa0;; qu’est donc «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>%1: its history, played again, gives a different tree from the one it holds</source>
        <translation>%1 : son historique, rejoué, donne un autre arbre que celui qu’il contient</translation>
    </message>
    <message>
        <source>replay needs at least one recipe or project</source>
        <translation>replay demande au moins une recette ou un projet</translation>
    </message>
    <message>
        <source>import needs one skeleton and -o OUT</source>
        <translation>import veut un squelette et -o SORTIE</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>il n’y a plus de place pour d’autres jeux de paramètres</translation>
    </message>
    <message>
        <source>--set needs group.name=value, not &quot;%1&quot;</source>
        <translation>--set attend groupe.nom=valeur, pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>--set: there is no parameter &quot;%1&quot;</source>
        <translation>--set ne connaît pas le paramètre «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>--fibres needs --png FILE</source>
        <translation>--fibres demande --png FICHIER</translation>
    </message>
    <message>
        <source>--index needs a whole number from 0, not &quot;%1&quot;</source>
        <translation>--index demande un nombre entier à partir de 0, pas « %1 »</translation>
    </message>
    <message>
        <source>sketch needs at least one drawing</source>
        <translation>sketch demande au moins un dessin</translation>
    </message>
    <message>
        <source>it has more than %1 strokes</source>
        <translation>il a plus de %1 traits</translation>
    </message>
    <message>
        <source>it has no line that can be a trunk, and no crown</source>
        <translation>il n’a ni ligne qui puisse être un tronc, ni couronne</translation>
    </message>
    <message>
        <source>--vary needs a whole number from 0, and after a colon an amount from %1 to 1 if you like, such as 7 or 7:0.5, not &quot;%2&quot;</source>
        <translation>--vary attend un nombre entier à partir de 0 et, si vous voulez, après deux-points, une mesure de %1 à 1, comme 7 ou 7:0.5, et non «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Espalier: brush trees into being.

espalier [PROJECT]
    Opens the window.

espalier --demo [RECIPE]
    Opens the window and brushes a tree in it; then it is yours.

espalier replay RECIPE|PROJECT... [-o OUT]... [--png FILE] [--size WxH]
                [--camera front|side|top|three-quarter]
                [--transparent [--ground-shadow]] [--fibres]
                [--stats FILE] [--profiles FILE] [--threads N] [--seed N]
                [--strict] [--vary SEED[:AMOUNT]] [--set GROUP.NAME=VALUE]...
    Plays a recipe without a window, and writes the result.
    For a project, all that was done to its tree is done again.
    With several recipes, each continues the tree of the one before: the
    first sets the seed, and each begins by applying its own parameters.
    --profiles: the places of the strands in each cross-section, as JSON.
    Whatever an operation does not find is printed; with --strict it is an
    error, and nothing is written.
    --set gives a parameter a value for the whole replay, whatever recipes say:
    --set growth.shedding=0.1 --set leaves.visible=false. Angles are in degrees.
    --vary makes the tree&apos;s angles and lengths deviate a little, by 0.3 or by
    an AMOUNT of up to 1; each SEED gives another neighbour in a forest.

espalier import SKELETON.csv -o OUT...
    Makes a tree from a measured one: each line has id, parent, both ends, radius.

espalier sketch DRAWING... [--index N] [--front-only] [-o OUT]... [--png FILE]
                [--size WxH] [--camera ...] [--stats FILE] [--seed N]
                [--set GROUP.NAME=VALUE]...
    Makes a tree from a drawing: lines are branches, small loops are leaves,
    a large loop is a crown to grow into. Drawings are SVG, or Quick, Draw!
    .ndjson, where --index picks a line, from 0. Several drawings are drawn one
    over the other. --front-only: the drawing is placed once, and not a second
    time from the side.

espalier export PROJECT [-o OUT]... [--vary SEED[:AMOUNT]]
                [--set GROUP.NAME=VALUE]...
    Writes a project in other formats. --vary and --set change what is written;
    the project stays as it is.

espalier render PROJECT --png FILE [--size WxH] [--camera ...]
                [--transparent [--ground-shadow]] [--fibres]
                [--vary SEED[:AMOUNT]] [--set GROUP.NAME=VALUE]...
    Draws a picture. It needs a display; a virtual one will do.
    --transparent: the tree alone, with straight alpha; --ground-shadow keeps
    its shadow, as partly transparent black. --fibres: the strands of the wood.

espalier info FILE
    Prints as JSON what is in a project.

espalier --help, --version

OUT ends in .espalier (project) or in the suffix of a format:
%1Exits with 0 when done, 2 when the command line is wrong, 3 when an input is
unreadable or wrong, 4 when an output could not be written.
</source>
        <translation>Espalier&#xa0;: peindre des arbres et les voir naître.

espalier [PROJET]
    Ouvre la fenêtre.

espalier --demo [RECETTE]
    Ouvre la fenêtre et y peint un arbre&#xa0;; ensuite il est à vous.

espalier replay RECETTE|PROJET... [-o SORTIE]... [--png FICHIER] [--size LxH]
                [--camera front|side|top|three-quarter]
                [--transparent [--ground-shadow]] [--fibres]
                [--stats FICHIER] [--profiles FICHIER] [--threads N] [--seed N]
                [--strict] [--vary NOMBRE[:MESURE]]
                [--set GROUPE.NOM=VALEUR]...
    Fait ce que dit une recette, sans fenêtre, et écrit ce qui en résulte.
    D’un projet, tout ce qui a été fait à son arbre est refait.
    De plusieurs recettes, chacune continue l’arbre de la précédente&#xa0;: la
    première donne la graine, et chacune met d’abord ses paramètres en vigueur.
    --profiles&#xa0;: la place des brins dans chaque section, en JSON.
    Ce que les opérations ne trouvent pas dans l’arbre est affiché&#xa0;; avec
    --strict, c’est une erreur, et rien n’est écrit.
    --set donne une valeur à un paramètre pour tout le rejeu, quoi que disent
    les recettes&#xa0;: --set growth.shedding=0.1 --set leaves.visible=false. Les
    angles sont en degrés.
    --vary fait varier un peu les angles et les longueurs de l’arbre, d’une
    mesure de 0.3, ou jusqu’à 1&#xa0;: un autre nombre est un autre arbre de la forêt.

espalier import SQUELETTE.csv -o SORTIE...
    Fait un arbre d’un arbre mesuré&#xa0;: des lignes d’id, parent, deux bouts et
    rayon.

espalier sketch DESSIN... [--index N] [--front-only] [-o SORTIE]...
                [--png FICHIER] [--size LxH] [--camera ...] [--stats FICHIER]
                [--seed N] [--set GROUPE.NOM=VALEUR]...
    Fait un arbre de ce que quelqu’un a dessiné : les lignes sont des branches,
    les petites boucles des feuilles, une grande boucle est une couronne à
    remplir. Les dessins sont des SVG, ou des .ndjson de Quick, Draw!, dont
    --index prend une ligne, à partir de 0. De plusieurs dessins, chacun est
    tracé sur le précédent. --front-only : la profondeur est donnée une fois,
    sans placer le dessin encore une fois de côté.

espalier export PROJET [-o SORTIE]... [--vary NOMBRE[:MESURE]]
                [--set GROUPE.NOM=VALEUR]...
    Écrit un projet dans d’autres formats. --vary et --set changent ce qui est
    écrit&#xa0;; le projet reste tel quel.

espalier render PROJET --png FICHIER [--size LxH] [--camera ...]
                [--transparent [--ground-shadow]] [--fibres]
                [--vary NOMBRE[:MESURE]] [--set GROUPE.NOM=VALEUR]...
    Prend une image. Il faut un affichage&#xa0;; un affichage virtuel convient.
    --transparent&#xa0;: l’arbre seul, avec un alpha non prémultiplié&#xa0;;
    --ground-shadow garde son ombre, en noir plus ou moins opaque.
    --fibres : les brins du bois, en lignes.

espalier info FICHIER
    Dit en JSON ce que contient un projet.

espalier --help, --version

SORTIE se termine par .espalier (projet) ou par le suffixe d’un format&#xa0;:
%1Se termine avec 0 en cas de succès, 2 si la ligne de commande est fausse, 3 si
une entrée est illisible ou fausse, 4 si une sortie n’a pas pu être écrite.
</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Bend</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>Brush Stroke</source>
        <translation>Coup de pinceau</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Change Parameters</source>
        <translation>Changement de paramètres</translation>
    </message>
    <message>
        <source>Go to Another Time</source>
        <translation>Voyage dans le temps</translation>
    </message>
    <message>
        <source>Remove Width</source>
        <translation>Retrait d’épaisseur</translation>
    </message>
    <message>
        <source>Set Width</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>a sketch can only become a tree where nothing has grown</source>
        <translation>un croquis ne peut devenir un arbre que là où rien n’a encore poussé</translation>
    </message>
    <message>
        <source>no stroke of the sketch is a branch</source>
        <translation>aucun trait du croquis n’est une branche</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Croquis</translation>
    </message>
    <message>
        <source>a skeleton can only be imported where nothing has grown</source>
        <translation>un squelette ne peut être importé que là où rien n’a encore poussé</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>Rejets</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>Apport de vigueur</translation>
    </message>
    <message>
        <source>Draw Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Blend Profiles</source>
        <translation>Interpolation de profils</translation>
    </message>
    <message>
        <source>Remove Profile</source>
        <translation>Retrait de profil</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Réduction</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsade</translation>
    </message>
    <message>
        <source>Remove Twist</source>
        <translation>Retrait de torsade</translation>
    </message>
    <message>
        <source>Give Depth</source>
        <translation>Donner la profondeur</translation>
    </message>
    <message>
        <source>Draw Branch</source>
        <translation>Dessiner une branche</translation>
    </message>
    <message>
        <source>Multiply Branch</source>
        <translation>Multiplier la branche</translation>
    </message>
    <message>
        <source>Place Leaf</source>
        <translation>Poser une feuille</translation>
    </message>
    <message>
        <source>Arrange Leaves</source>
        <translation>Disposer les feuilles</translation>
    </message>
    <message>
        <source>Pass On Branch</source>
        <translation>Propager la branche</translation>
    </message>
    <message>
        <source>the new trunk must be an open line</source>
        <translation>le nouveau tronc doit être une ligne ouverte</translation>
    </message>
    <message>
        <source>Reshape Tree</source>
        <translation>Reproduire l’arbre</translation>
    </message>
    <message>
        <source>Vary Tree</source>
        <translation>Varier l’arbre</translation>
    </message>
    <message>
        <source>Move Branch</source>
        <translation>Déplacer la branche</translation>
    </message>
    <message numerus="yes">
        <source>Brush Stroke, %n branches</source>
        <translation>
            <numerusform>Coup de pinceau, %n branche</numerusform>
            <numerusform>Coup de pinceau, %n branches</numerusform>
        </translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Thin Out</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Keep Clear</source>
        <translation>Dégager</translation>
    </message>
    <message>
        <source>Let Buds Shoot</source>
        <translation>Laisser pousser les bourgeons</translation>
    </message>
    <message numerus="yes">
        <source>Prune, %n branches</source>
        <translation>
            <numerusform>Taille, %n branche</numerusform>
            <numerusform>Taille, %n branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Grow, %n steps</source>
        <translation>
            <numerusform>Croissance, %n étape</numerusform>
            <numerusform>Croissance, %n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Repousse</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>Retirer l’enveloppe</translation>
    </message>
    <message>
        <source>Earlier Steps</source>
        <translation>Étapes antérieures</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Tap a branch to cut it off, or draw across the branches to cut</source>
        <translation>Touchez une branche pour la couper, ou tracez en travers des branches à couper</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>there is no display (DISPLAY is not set); xvfb-run provides a virtual one</source>
        <translation>aucun affichage (DISPLAY n’est pas défini)&#xa0;; xvfb-run en fournit un virtuel</translation>
    </message>
    <message>
        <source>the display %1 does not answer</source>
        <translation>l’affichage %1 ne répond pas</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>it is not an SVG</source>
        <translation>ce n’est pas un SVG</translation>
    </message>
    <message>
        <source>it has no drawing %1</source>
        <translation>il n’a pas de dessin %1</translation>
    </message>
    <message>
        <source>a stroke has more x than y values, or fewer</source>
        <translation>un trait n’a pas autant de x que de y</translation>
    </message>
    <message>
        <source>a stroke has a point that is not a number</source>
        <translation>un trait a un point qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>it has no strokes</source>
        <translation>il n’a pas de traits</translation>
    </message>
    <message>
        <source>it has more than %1 points</source>
        <translation>il a plus de %1 points</translation>
    </message>
</context>
<context>
    <name>Envelope</name>
    <message>
        <source>There is no lasso stroke.</source>
        <translation>Il n’y a pas de tracé de lasso.</translation>
    </message>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>Le plan de dessin du lasso n’est pas valable.</translation>
    </message>
    <message>
        <source>The lasso is too small to enclose anything.</source>
        <translation>Le lasso est trop petit pour entourer quoi que ce soit.</translation>
    </message>
    <message>
        <source>The lasso encloses no area.</source>
        <translation>Le lasso n’entoure aucune surface.</translation>
    </message>
    <message>
        <source>The lasso is too small for its distance from the origin.</source>
        <translation>Le lasso est trop petit pour sa distance à l’origine.</translation>
    </message>
</context>
<context>
    <name>EraserTool</name>
    <message>
        <source>Brush over twigs to thin them evenly; those to be removed turn red</source>
        <translation>Passez sur les rameaux pour en retirer une partie, régulièrement ; ce qui part devient rouge</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are</source>
        <translation>Passez sur les rameaux et les feuilles pour les retirer, si profond qu’ils soient dans la couronne</translation>
    </message>
</context>
<context>
    <name>ExportFormat</name>
    <message>
        <source>FBX</source>
        <translation>FBX</translation>
    </message>
    <message>
        <source>Binary glTF</source>
        <translation>glTF binaire</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Skeleton as a table</source>
        <translation>Squelette en tableau</translation>
    </message>
</context>
<context>
    <name>Exporter</name>
    <message>
        <source>the meshes could not be written: %1</source>
        <translation>les maillages n’ont pas pu être écrits&#xa0;: %1</translation>
    </message>
    <message>
        <source>“.%1” is not an export format; the formats are %2</source>
        <translation>il n’y a pas d’exportation vers «&#xa0;.%1&#xa0;»&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>The export was cancelled.</source>
        <translation>L’exportation a été annulée.</translation>
    </message>
    <message>
        <source>there are too many files with similar names in this folder; choose another name or another folder</source>
        <translation>il y a trop de fichiers aux noms semblables dans son dossier&#xa0;; choisir un autre nom ou un autre dossier</translation>
    </message>
    <message>
        <source>another program made this file during the export; export again, and another name will be chosen</source>
        <translation>un autre programme a créé ce fichier pendant l’exportation&#xa0;; exporter à nouveau, et un autre nom sera choisi</translation>
    </message>
    <message>
        <source>the tree takes more than the 4 GB that such a file can hold; export less detail</source>
        <translation>l’arbre prend plus que les 4 Go que peut contenir un tel fichier&#xa0;; exporter moins de détails</translation>
    </message>
    <message>
        <source>the tree takes more than such a file can hold; export less detail</source>
        <translation>l’arbre prend plus qu’un tel fichier ne peut contenir ; exportez moins de détail</translation>
    </message>
</context>
<context>
    <name>FbxRepair</name>
    <message>
        <source>this is not a valid binary FBX file</source>
        <translation>ce n’est pas un fichier FBX binaire correct</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Trees (*.espalier)</source>
        <translation>Arbres (*.espalier)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Espalier</source>
        <translation>Espalier</translation>
    </message>
    <message>
        <source>%1 is still growing. What has grown so far is not saved.</source>
        <translation>%1 pousse encore. Ce qui a poussé jusqu’ici n’est pas enregistré.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>%1 has been changed by another window or program since it was opened or saved here. Overwriting it loses those changes.</source>
        <translation>%1 a été modifié par une autre fenêtre ou un autre programme depuis son ouverture ou son enregistrement ici. L’écraser fait perdre ces modifications.</translation>
    </message>
    <message>
        <source>Save as Recipe</source>
        <translation>Enregistrer comme recette</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Recettes (*.json)</translation>
    </message>
    <message>
        <source>Trees, recipes and measured skeletons (*.espalier *.json *.csv);;Trees (*.espalier);;Recipes (*.json);;Skeletons (*.csv);;All files (*)</source>
        <translation>Arbres, recettes et squelettes mesurés (*.espalier *.json *.csv);;Arbres (*.espalier);;Recettes (*.json);;Squelettes (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Ne pas enregistrer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>&amp;Enregistrer sous…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Remplacer</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>il dépasse %1 octets</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>il dépasse %1 Mo</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file</source>
        <translation>c’est un périphérique ou un tube, pas un fichier</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>il ne peut pas être lu : %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
</context>
<context>
    <name>FileWriter</name>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>le dossier %1 n’existe pas</translation>
    </message>
    <message>
        <source>%1 is not a folder</source>
        <translation>%1 n’est pas un dossier</translation>
    </message>
    <message>
        <source>a folder with this name already exists</source>
        <translation>il y a un dossier de ce nom</translation>
    </message>
    <message>
        <source>you may not write into the folder %1</source>
        <translation>il n’est pas permis d’écrire dans le dossier %1</translation>
    </message>
    <message>
        <source>you may not change this file</source>
        <translation>il n’est pas permis de modifier ce fichier</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>your disk quota is used up</source>
        <translation>la part attribuée du disque est pleine</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>le disque est en lecture seule</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>il n’est pas permis d’écrire ici</translation>
    </message>
    <message>
        <source>the file is too large for this disk</source>
        <translation>le fichier est trop grand pour ce disque</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>le disque est défectueux</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>le nom est trop long</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>trop de fichiers sont ouverts</translation>
    </message>
    <message>
        <source>the system does not say why</source>
        <translation>le système ne dit pas pourquoi</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>il faut un nom au fichier</translation>
    </message>
    <message>
        <source>it is a link that leads back to itself</source>
        <translation>c’est un lien qui revient sur lui-même</translation>
    </message>
    <message>
        <source>no program reads from this pipe</source>
        <translation>aucun programme ne lit ce tube</translation>
    </message>
    <message>
        <source>another program has changed it</source>
        <translation>un autre programme l’a modifié</translation>
    </message>
</context>
<context>
    <name>GrowTool</name>
    <message>
        <source>Press and hold: the tree grows until you let go</source>
        <translation>Appuyer et maintenir&#xa0;: l’arbre pousse jusqu’au relâchement.</translation>
    </message>
</context>
<context>
    <name>ImageFile</name>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>la taille dépasse %1 Mo</translation>
    </message>
    <message>
        <source>it is neither a PNG nor a JPEG image</source>
        <translation>ce n’est une image ni PNG ni JPEG</translation>
    </message>
    <message>
        <source>the image is broken</source>
        <translation>l’image est endommagée</translation>
    </message>
    <message>
        <source>it has %1 × %2 pixels; %3 along an edge is the most</source>
        <translation>l’image fait %1 × %2 pixels&#xa0;; le maximum par côté est %3</translation>
    </message>
    <message>
        <source>it is too small: only %1 × %2 pixels</source>
        <translation>l’image ne fait que %1 × %2 pixels</translation>
    </message>
    <message>
        <source>it is not a picture that can be read</source>
        <translation>ce n’est pas une image lisible</translation>
    </message>
</context>
<context>
    <name>ImageStructure</name>
    <message>
        <source>the file is not whole</source>
        <translation>le fichier n’est pas complet</translation>
    </message>
    <message>
        <source>it is made so that unpacking it would take very long</source>
        <translation>il est fait de telle sorte que sa décompression prendrait très longtemps</translation>
    </message>
</context>
<context>
    <name>InvigorateTool</name>
    <message>
        <source>Press a branch and hold: it grows until you let go</source>
        <translation>Appuyer sur une branche et maintenir&#xa0;: elle pousse jusqu’au relâchement</translation>
    </message>
</context>
<context>
    <name>JournalCheck</name>
    <message>
        <source>it changes nothing</source>
        <translation>elle ne change rien</translation>
    </message>
    <message>
        <source>it places a leaf that is not there</source>
        <translation>elle place une feuille qui n’existe pas</translation>
    </message>
    <message>
        <source>it places a leaf at another time</source>
        <translation>elle place une feuille à un autre moment</translation>
    </message>
    <message>
        <source>it creates an internode whose parameters are not there</source>
        <translation>elle fait naître un entre-nœud dont les paramètres n’existent pas</translation>
    </message>
    <message>
        <source>its steps do not follow on from those around it</source>
        <translation>ses étapes ne se raccordent pas à celles qui l’entourent</translation>
    </message>
    <message>
        <source>its parameters do not follow on from those of the steps around it</source>
        <translation>ses paramètres ne se raccordent pas à ceux qui l’entourent</translation>
    </message>
    <message>
        <source>its births are out of order</source>
        <translation>ses naissances sont dans le désordre</translation>
    </message>
    <message>
        <source>it records the death of an internode that did not die</source>
        <translation>elle fait mourir un entre-nœud qui n’est pas mort</translation>
    </message>
    <message>
        <source>it creates an internode that is not there</source>
        <translation>elle fait naître un entre-nœud qui n’existe pas</translation>
    </message>
    <message>
        <source>it creates an internode at another time</source>
        <translation>elle fait naître un entre-nœud à un autre moment</translation>
    </message>
    <message>
        <source>before it, an internode would live on a dead one</source>
        <translation>avant elle, un entre-nœud vivrait sur un entre-nœud mort</translation>
    </message>
    <message>
        <source>before it, two internodes would continue the same axis</source>
        <translation>avant elle, deux entre-nœuds prolongeraient le même axe</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>étape %1 de l’historique</translation>
    </message>
    <message>
        <source>it places a leaf on an internode that is not there</source>
        <translation>elle place une feuille sur un entre-nœud qui n’existe pas</translation>
    </message>
    <message>
        <source>it changes an envelope in a way that is not possible</source>
        <translation>elle change une enveloppe d’une façon impossible</translation>
    </message>
    <message>
        <source>something is set before it on what it brings</source>
        <translation>avant elle, quelque chose est fixé sur ce qu’elle apporte</translation>
    </message>
    <message>
        <source>the beginning of the history</source>
        <translation>le début de l’historique</translation>
    </message>
    <message>
        <source>it changes “%1”, which never changes</source>
        <translation>elle change «&#xa0;%1&#xa0;», qui ne change jamais</translation>
    </message>
    <message>
        <source>it changes “%1” of a row that was not there</source>
        <translation>elle change «&#xa0;%1&#xa0;» d’une ligne qui n’existait pas</translation>
    </message>
    <message>
        <source>it changes “%1” in a way that is not possible</source>
        <translation>elle change «&#xa0;%1&#xa0;» d’une façon impossible</translation>
    </message>
    <message>
        <source>it refers to strokes or profiles that are not there</source>
        <translation>elle apporte des traits ou des profils qui n’existent pas</translation>
    </message>
</context>
<context>
    <name>JsonReader</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>la taille dépasse %1 Mo</translation>
    </message>
    <message>
        <source>it holds too many values</source>
        <translation>il y a trop de valeurs</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation>JSON non valable&#xa0;: %1</translation>
    </message>
    <message>
        <source>a JSON object is expected</source>
        <translation>un objet JSON est attendu</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>cela manque</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected</source>
        <translation>un nombre entier de %1 à %2 est attendu</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected</source>
        <translation>un nombre de %1 à %2 est attendu</translation>
    </message>
    <message>
        <source>a string is expected</source>
        <translation>une chaîne de caractères est attendue</translation>
    </message>
    <message>
        <source>a whole number of at most 64 bits is expected; from 2^53 on, write it as a string of digits</source>
        <translation>un nombre entier d’au plus 64 bits est attendu, à partir de 2^53 sous forme de chaîne de chiffres</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>un objet est attendu</translation>
    </message>
    <message>
        <source>an array is expected</source>
        <translation>un tableau est attendu</translation>
    </message>
    <message>
        <source>“%1” is not known here</source>
        <translation>«&#xa0;%1&#xa0;» est inconnu ici</translation>
    </message>
</context>
<context>
    <name>Lasso</name>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>Le plan de dessin du lasso n’est pas valable.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>There is no envelope to regrow.</source>
        <translation>Il n’y a pas d’enveloppe à régénérer.</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Régénération</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>Retrait de l’enveloppe</translation>
    </message>
    <message>
        <source>There is no envelope to fill.</source>
        <translation>Il n’y a pas d’enveloppe à remplir.</translation>
    </message>
    <message>
        <source>There is no room for more parameter sets.</source>
        <translation>Il n’y a plus de place pour d’autres jeux de paramètres.</translation>
    </message>
    <message>
        <source>There is no room for more lassos.</source>
        <translation>Il n’y a plus de place pour d’autres lassos.</translation>
    </message>
</context>
<context>
    <name>LassoTool</name>
    <message>
        <source>Draw the silhouette of a crown; the tree fills it. Begin at a branch to draw at its depth</source>
        <translation>Dessiner la silhouette d’un houppier&#xa0;; l’arbre la remplit. Partir d’une branche pour dessiner à sa profondeur</translation>
    </message>
</context>
<context>
    <name>LeafChoices</name>
    <message>
        <source>One leaf at a time along the branch, each turned from the one before as the second is from the first.</source>
        <translation>Une feuille à la fois le long de la branche, chacune tournée comme la deuxième par rapport à la première.</translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>A tree needs a name.</source>
        <translation>Il faut un nom à l’arbre.</translation>
    </message>
    <message>
        <source>A name cannot begin with a full stop.</source>
        <translation>Un nom ne peut pas commencer par un point.</translation>
    </message>
    <message>
        <source>A name cannot contain any of / \ : * ? &quot; &lt; &gt; |.</source>
        <translation>Un nom ne peut contenir aucun des caractères / \ : * ? &quot; &lt; &gt; |.</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>Ce nom est trop long.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>Impossible de créer le dossier %1.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>There is already a tree named %1.</source>
        <translation>Il y a déjà un arbre nommé %1.</translation>
    </message>
    <message>
        <source>%1 cannot be renamed: %2</source>
        <translation>Impossible de renommer %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be copied: %2</source>
        <translation>Impossible de copier %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 n’est plus là.</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash: %2</source>
        <translation>Impossible de mettre %1 à la corbeille&#xa0;: %2</translation>
    </message>
    <message>
        <source>There is another tree named %1 now.</source>
        <translation>Il y a maintenant un autre arbre nommé %1.</translation>
    </message>
    <message>
        <source>%1 cannot be taken out of the trash: %2</source>
        <translation>%1 ne peut être retiré de la corbeille : %2</translation>
    </message>
</context>
<context>
    <name>MoveTool</name>
    <message>
        <source>a trunk stays where it stands; drag a branch</source>
        <translation>un tronc reste où il est&#xa0;; tenez une branche</translation>
    </message>
    <message>
        <source>Drag a branch along the wood or around it; drag its base to other wood, its tip to scale it</source>
        <translation>Tirer une branche le long du bois ou autour de lui&#xa0;; à sa base, sur un autre bois&#xa0;; à sa pointe, pour l’agrandir</translation>
    </message>
</context>
<context>
    <name>MultiplyTool</name>
    <message>
        <source>Tap a branch: it gets one more branch like those that it carries</source>
        <translation>Touchez une branche : elle en reçoit une de plus comme celles qu’elle porte</translation>
    </message>
    <message>
        <source>Tap a branch: the others get what it carries; drag from it across branches to choose which of them get it</source>
        <translation>Toucher une branche&#xa0;: les autres reçoivent ce qu’elle porte&#xa0;; ou tirer d’elle à travers celles qui doivent le recevoir</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>A picture cannot be drawn, because there is no display that offers OpenGL 3.3; a virtual one (Xvfb) will do.</source>
        <translation>Impossible de dessiner une image&#xa0;: aucun affichage n’offre OpenGL 3.3&#xa0;; un affichage virtuel (Xvfb) convient.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large; %3 along an edge is the most.</source>
        <translation>Une image de %1 × %2 pixels est trop grande&#xa0;; le maximum par côté est %3.</translation>
    </message>
</context>
<context>
    <name>Outputs</name>
    <message>
        <source>%1: the picture could not be compressed</source>
        <translation>%1&#xa0;: l’image n’a pas pu être compressée</translation>
    </message>
</context>
<context>
    <name>OwnTextures</name>
    <message>
        <source>%1: the leaf cannot be told apart from its background; the image needs a transparent or a plain background</source>
        <translation>%1&#xa0;: impossible de distinguer la feuille de ce qui est derrière elle&#xa0;; l’image a besoin d’un fond transparent ou uni</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Backdrop</source>
        <translation>Derrière</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Ground below the tree, with the tree&apos;s shadow.</source>
        <translation>Le sol sous l’arbre, avec l’ombre de l’arbre.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Lines on the ground, a metre apart.</source>
        <translation>Des lignes au sol, tous les mètres.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Ombres</translation>
    </message>
    <message>
        <source>Shadows of the sun.</source>
        <translation>Les ombres du soleil.</translation>
    </message>
    <message>
        <source>Show the sun</source>
        <translation>Afficher le soleil</translation>
    </message>
    <message>
        <source>Show the sun as a ball that you can drag around the tree.</source>
        <translation>Afficher le soleil comme une boule que l’on peut faire glisser autour de l’arbre.</translation>
    </message>
    <message>
        <source>Pin the sun</source>
        <translation>Épingler le soleil</translation>
    </message>
    <message>
        <source>The sun stays where it is on the screen when the tree is turned; otherwise it turns with the tree.</source>
        <translation>Le soleil reste à sa place à l’écran quand on tourne l’arbre&#xa0;; sinon, il tourne avec l’arbre.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Where the sun stands: 0° in front of the tree, 90° to its right; for a pinned sun, as seen on the screen.</source>
        <translation>Où se trouve le soleil&#xa0;: 0° devant l’arbre, 90° à sa droite&#xa0;; s’il est épinglé, par rapport au regard.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>How high the sun stands above the horizon.</source>
        <translation>La hauteur du soleil au-dessus de l’horizon.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How opaque the picture is.</source>
        <translation>À quel point l’image est visible.</translation>
    </message>
    <message>
        <source>How tall the picture is.</source>
        <translation>La hauteur de l’image.</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Vers la droite</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is to the right of the seedling.</source>
        <translation>Où se trouve le milieu de l’image à côté de la plantule.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is above the seedling.</source>
        <translation>Où se trouve le milieu de l’image au-dessus de la plantule.</translation>
    </message>
    <message>
        <source>studio</source>
        <translation>studio</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>horizon</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>uni</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>dégradé</translation>
    </message>
    <message>
        <source>Set-point angle</source>
        <translation>Angle de consigne</translation>
    </message>
    <message>
        <source>The direction that shoots turn to: 0° is up, 90° level, and more makes them weep.</source>
        <translation>Où se tournent les pousses&#xa0;: 0° vers le haut, 90° à l’horizontale, et davantage les fait pleurer.</translation>
    </message>
    <message>
        <source>Gravitropic set-point angle: orthotropic at 0°, plagiotropic near 90°, positively gravitropic beyond.</source>
        <translation>Angle de consigne gravitropique&#xa0;: orthotrope à 0°, plagiotrope près de 90°, gravitropisme positif au-delà.</translation>
    </message>
    <message>
        <source>Buds above and below</source>
        <translation>Bourgeons haut et bas</translation>
    </message>
    <message>
        <source>Vigour of the buds on the upper and lower sides of a leaning branch.</source>
        <translation>Vigueur des bourgeons au-dessus et au-dessous d’une branche inclinée.</translation>
    </message>
    <message>
        <source>Vertical semi-axis of the gravimorphic ellipse.</source>
        <translation>Demi-axe vertical de l’ellipse gravimorphique.</translation>
    </message>
    <message>
        <source>Buds on the sides</source>
        <translation>Bourgeons latéraux</translation>
    </message>
    <message>
        <source>Vigour of the buds on the sides of a leaning branch.</source>
        <translation>Vigueur des bourgeons sur les côtés d’une branche inclinée.</translation>
    </message>
    <message>
        <source>Semi-axis parallel to the ground; if it is the greater one, amphitony.</source>
        <translation>Demi-axe parallèle au sol&#xa0;; le plus grand correspond à l’amphitonie.</translation>
    </message>
    <message>
        <source>Upper or lower buds</source>
        <translation>Bourgeons haut ou bas</translation>
    </message>
    <message>
        <source>Above 0 the buds on the upper side are stronger, as in fruit trees; below 0 those on the lower side.</source>
        <translation>Au-dessus de 0, les bourgeons de la face supérieure sont plus forts, comme chez les arbres fruitiers&#xa0;; en dessous de 0, ceux de la face inférieure.</translation>
    </message>
    <message>
        <source>Displacement of the ellipse: epitony above 0, hypotony below.</source>
        <translation>Décalage de l’ellipse&#xa0;: épitonie au-dessus de 0, hypotonie en dessous.</translation>
    </message>
    <message>
        <source>Branching angle</source>
        <translation>Angle d’insertion</translation>
    </message>
    <message>
        <source>Between a branch and the branches that grow from it.</source>
        <translation>Entre une branche et ce qui s’en détache.</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral bud on its axis.</source>
        <translation>Angle d’insertion d’un bourgeon latéral sur son axe.</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Déviation</translation>
    </message>
    <message>
        <source>How far an axis turns away from a branch that it bears: 0 keeps it straight, more makes it zigzag.</source>
        <translation>À quel point un axe s’écarte d’une branche qu’il porte&#xa0;: 0 le garde droit, davantage le fait zigzaguer.</translation>
    </message>
    <message>
        <source>How far the main axis gives way to a lateral: a tendency to sympodial growth.</source>
        <translation>L’axe principal cède devant un latéral, comme vers une croissance sympodiale.</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Rectitude</translation>
    </message>
    <message>
        <source>How much a shoot keeps the direction that it has.</source>
        <translation>À quel point une pousse garde sa direction.</translation>
    </message>
    <message>
        <source>Weight of the heading H of the axis.</source>
        <translation>Poids de la direction H de l’axe.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Tropisme</translation>
    </message>
    <message>
        <source>How much a shoot turns towards the set-point angle.</source>
        <translation>À quel point une pousse se tourne vers l’angle de consigne.</translation>
    </message>
    <message>
        <source>Weight of gravitropism T.</source>
        <translation>Poids du gravitropisme T.</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Espace libre</translation>
    </message>
    <message>
        <source>How much a shoot turns towards where there is room.</source>
        <translation>À quel point une pousse se tourne vers là où il y a de la place.</translation>
    </message>
    <message>
        <source>Weight of the environment E: the mean direction of the free space that a bud perceives.</source>
        <translation>Poids de l’environnement E&#xa0;: la direction moyenne de l’espace libre que perçoit un bourgeon.</translation>
    </message>
    <message>
        <source>Occupied radius</source>
        <translation>Rayon occupé</translation>
    </message>
    <message>
        <source>Space around each bud that nothing else grows into, in internodes. More makes an airier crown.</source>
        <translation>Espace autour de chaque bourgeon où rien d’autre ne pousse, en entre-nœuds. Davantage donne un houppier plus aéré.</translation>
    </message>
    <message>
        <source>Radius of the zone of occupancy.</source>
        <translation>Rayon de la zone d’occupation.</translation>
    </message>
    <message>
        <source>Sight</source>
        <translation>Portée de vue</translation>
    </message>
    <message>
        <source>How far beyond its own space a bud sees room to grow, in internodes.</source>
        <translation>Jusqu’où, au-delà de son propre espace, un bourgeon voit de la place pour pousser, en entre-nœuds.</translation>
    </message>
    <message>
        <source>Depth of the volume of perception, which reaches to r + d.</source>
        <translation>Profondeur du volume de perception, qui s’étend jusqu’à r + d.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Champ de vision</translation>
    </message>
    <message>
        <source>How far to the sides a bud sees room to grow.</source>
        <translation>Jusqu’où, sur les côtés, un bourgeon voit de la place pour pousser.</translation>
    </message>
    <message>
        <source>Apex angle of the cone of perception.</source>
        <translation>Angle au sommet du cône de perception.</translation>
    </message>
    <message>
        <source>Apical dominance</source>
        <translation>Dom. apicale</translation>
    </message>
    <message>
        <source>What gets the vigour: above 0.5 the main axis, as in conifers; below it the branches, as in shrubs.</source>
        <translation>Qui reçoit la vigueur&#xa0;: au-dessus de 0,5 l’axe principal, comme chez les conifères&#xa0;; en dessous les branches, comme chez les arbustes.</translation>
    </message>
    <message>
        <source>Excurrent forms above 0.5, decurrent ones below.</source>
        <translation>Formes excurrentes au-dessus de 0,5, décurrentes en dessous.</translation>
    </message>
    <message>
        <source>Light sensitivity</source>
        <translation>Besoin de lumière</translation>
    </message>
    <message>
        <source>How much more a bud in the light thrives than one in the shade.</source>
        <translation>À quel point un bourgeon à la lumière prospère mieux qu’un bourgeon à l’ombre.</translation>
    </message>
    <message>
        <source>Exponent of the response to light: high for light-demanding trees, low for shade-tolerant ones.</source>
        <translation>Exposant de la réponse à la lumière&#xa0;: élevé pour les essences de lumière, bas pour les essences d’ombre.</translation>
    </message>
    <message>
        <source>Shedding</source>
        <translation>Élagage naturel</translation>
    </message>
    <message>
        <source>Branches with less vigour than this die: 0 keeps them all.</source>
        <translation>Les branches moins vigoureuses que cela meurent&#xa0;: 0 les garde toutes.</translation>
    </message>
    <message>
        <source>Threshold of cladoptosis: vigour per internode, relative to that of the whole tree.</source>
        <translation>Seuil de cladoptose&#xa0;: vigueur par entre-nœud, relative à celle de l’arbre entier.</translation>
    </message>
    <message>
        <source>Shoot length</source>
        <translation>Long. de pousse</translation>
    </message>
    <message>
        <source>How many internodes the strongest shoot grows in one step.</source>
        <translation>Nombre d’entre-nœuds que la pousse la plus forte produit en une étape.</translation>
    </message>
    <message>
        <source>Metamers of the strongest shoot of a flush.</source>
        <translation>Métamères de la pousse la plus forte d’une vague de croissance.</translation>
    </message>
    <message>
        <source>Phyllotaxis</source>
        <translation>Phyllotaxie</translation>
    </message>
    <message>
        <source>Turn around the axis from one bud to the next: 137.5° is a spiral, 180° two rows, 90° crossed pairs.</source>
        <translation>Rotation autour de l’axe d’un bourgeon au suivant&#xa0;: 137,5° donne une spirale, 180° deux rangs, 90° des paires croisées.</translation>
    </message>
    <message>
        <source>Divergence angle: spiral, distichous, decussate.</source>
        <translation>Angle de divergence&#xa0;: spiralé, distique, décussé.</translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation>Suivre le trait</translation>
    </message>
    <message>
        <source>Shoots turn the way the brush goes, instead of to the set-point angle.</source>
        <translation>Les pousses se tournent vers là où va le pinceau, au lieu de l’angle de consigne.</translation>
    </message>
    <message>
        <source>The set-point angle is inferred from the direction of the stroke.</source>
        <translation>L’angle de consigne est déduit de la direction du trait.</translation>
    </message>
    <message>
        <source>Upright trunk</source>
        <translation>Tronc dressé</translation>
    </message>
    <message>
        <source>The trunk grows straight up, whatever the branches do.</source>
        <translation>Le tronc pousse tout droit vers le haut, quoi que fassent les branches.</translation>
    </message>
    <message>
        <source>The axis of order 0 is orthotropic, as in most conifers.</source>
        <translation>L’axe d’ordre 0 est orthotrope, comme chez la plupart des conifères.</translation>
    </message>
    <message>
        <source>Internode</source>
        <translation>Entre-nœud</translation>
    </message>
    <message>
        <source>Length of one internode. It is the measure of everything that grows: shorter ones make finer trees.</source>
        <translation>Longueur d’un entre-nœud. C’est la mesure de tout ce qui pousse&#xa0;: plus court, il donne des arbres plus fins.</translation>
    </message>
    <message>
        <source>Length of a metamer.</source>
        <translation>Longueur d’un métamère.</translation>
    </message>
    <message>
        <source>Buds at a node</source>
        <translation>Bourgeons par nœud</translation>
    </message>
    <message>
        <source>One is alternate, two opposite, more a whorl, as in pines.</source>
        <translation>Un&#xa0;: alterne&#xa0;; deux&#xa0;: opposé&#xa0;; davantage&#xa0;: un verticille, comme chez les pins.</translation>
    </message>
    <message>
        <source>Alternate, opposite or verticillate.</source>
        <translation>Alterne, opposé ou verticillé.</translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation>Irrégularité</translation>
    </message>
    <message>
        <source>Spread of angles and lengths: 0 is as regular as a diagram, 1 as wild as nature.</source>
        <translation>Dispersion des angles et des longueurs&#xa0;: 0 donne un schéma, 1 est aussi libre que la nature.</translation>
    </message>
    <message>
        <source>Variance of the angles and of the metamers.</source>
        <translation>Variance des angles et des métamères.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Ombre</translation>
    </message>
    <message>
        <source>How much light one internode takes.</source>
        <translation>Quantité de lumière que prend un entre-nœud.</translation>
    </message>
    <message>
        <source>Intensity of the penumbra that a metamer casts.</source>
        <translation>Intensité de la pénombre que projette un métamère.</translation>
    </message>
    <message>
        <source>Shadow falloff</source>
        <translation>Atténuation</translation>
    </message>
    <message>
        <source>How fast a shadow fades on its way down.</source>
        <translation>À quelle vitesse une ombre s’estompe en descendant.</translation>
    </message>
    <message>
        <source>Base of the shadow&apos;s decay from layer to layer.</source>
        <translation>Base de sa décroissance d’une couche à l’autre.</translation>
    </message>
    <message>
        <source>Shadow depth</source>
        <translation>Portée d’ombre</translation>
    </message>
    <message>
        <source>How many layers below an internode its shadow reaches.</source>
        <translation>Nombre de couches que l’ombre d’un entre-nœud atteint sous lui.</translation>
    </message>
    <message>
        <source>Height of the pyramid of shadow, in voxels.</source>
        <translation>Hauteur de la pyramide d’ombre, en voxels.</translation>
    </message>
    <message>
        <source>Brush density</source>
        <translation>Densité du pinceau</translation>
    </message>
    <message>
        <source>How densely the brush spreads room to grow, in points per cubic internode. More makes denser growth.</source>
        <translation>Quantité de place pour pousser que répand le pinceau, en points par entre-nœud cube. Davantage rend la croissance plus dense.</translation>
    </message>
    <message>
        <source>Density of the markers of free space.</source>
        <translation>Densité des marqueurs d’espace libre.</translation>
    </message>
    <message>
        <source>Brush memory</source>
        <translation>Mémoire du pinceau</translation>
    </message>
    <message>
        <source>After this many growth steps, the room that the brush has spread is forgotten.</source>
        <translation>Nombre d’étapes de croissance après lequel la place répandue par le pinceau est oubliée.</translation>
    </message>
    <message>
        <source>Maximum age of a marker.</source>
        <translation>Âge maximal d’un marqueur.</translation>
    </message>
    <message>
        <source>Room at a bud</source>
        <translation>Place au bourgeon</translation>
    </message>
    <message>
        <source>When the tree grows on its own: the room to grow that each bud finds around itself in each step.</source>
        <translation>Quand l’arbre pousse seul&#xa0;: la place que chaque bourgeon trouve autour de lui à chaque étape.</translation>
    </message>
    <message>
        <source>Markers generated in each volume of perception.</source>
        <translation>Marqueurs produits dans chaque volume de perception.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Whether the tree has any.</source>
        <translation>Si l’arbre en porte.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>The outline of a leaf.</source>
        <translation>Le contour d’une feuille.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>From the stalk to the tip.</source>
        <translation>Du pétiole à la pointe.</translation>
    </message>
    <message>
        <source>Breadth</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width as a share of length.</source>
        <translation>Rapport de la largeur à la longueur.</translation>
    </message>
    <message>
        <source>Variation in size</source>
        <translation>Écart de taille</translation>
    </message>
    <message>
        <source>How much the sizes of leaves differ.</source>
        <translation>À quel point les tailles des feuilles diffèrent.</translation>
    </message>
    <message>
        <source>At a node</source>
        <translation>Par nœud</translation>
    </message>
    <message>
        <source>How many leaves grow together.</source>
        <translation>Nombre de feuilles qui poussent ensemble.</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>How leaves stand around a shoot: as its buds do; in a spiral; together, each pair or whorl across the one before; or flat in two rows, as on beech and hemlock.</source>
        <translation>Comment les feuilles se placent autour d’une pousse : comme ses bourgeons ; en spirale ; ensemble, chaque paire ou verticille en croix avec le précédent ; ou à plat sur deux rangs, comme chez le hêtre et la pruche.</translation>
    </message>
    <message>
        <source>Leaf phyllotaxis: spiral, decussate or verticillate, distichous.</source>
        <translation>Phyllotaxie des feuilles : spiralée, décussée ou verticillée, distique.</translation>
    </message>
    <message>
        <source>shoot</source>
        <translation>pousse</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>spirale</translation>
    </message>
    <message>
        <source>opposite</source>
        <translation>opposée</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>à plat</translation>
    </message>
    <message>
        <source>How far inward</source>
        <translation>Vers l’intérieur</translation>
    </message>
    <message>
        <source>Branches that carry more twigs than this are bare.</source>
        <translation>Les branches qui portent plus de rameaux que cela sont nues.</translation>
    </message>
    <message>
        <source>Leafy internodes</source>
        <translation>Seulement au bout</translation>
    </message>
    <message>
        <source>How many internodes of a shoot bear leaves, counted from its tip.</source>
        <translation>Les feuilles poussent sur ce nombre d’entre-nœuds depuis le bout d’une pousse, pas plus loin.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Between a shoot and the leaf&apos;s stalk.</source>
        <translation>Entre une pousse et le pétiole de la feuille.</translation>
    </message>
    <message>
        <source>Droop</source>
        <translation>Retombée</translation>
    </message>
    <message>
        <source>How far leaves hang down.</source>
        <translation>À quel point les feuilles pendent.</translation>
    </message>
    <message>
        <source>Towards the sky</source>
        <translation>Vers le ciel</translation>
    </message>
    <message>
        <source>How far leaves turn their faces up.</source>
        <translation>À quel point les feuilles tournent leur face vers le haut.</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>0° is red, 60° yellow, 120° green.</source>
        <translation>0° est rouge, 60° jaune, 120° vert.</translation>
    </message>
    <message>
        <source>Variation in hue</source>
        <translation>Écart de teinte</translation>
    </message>
    <message>
        <source>How much the colours of leaves differ.</source>
        <translation>À quel point les couleurs des feuilles diffèrent.</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>How strong the colour is: low values suit blossom and silvery leaves.</source>
        <translation>L’intensité de la couleur&#xa0;: faible, elle donne des fleurs et des feuilles argentées.</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Luminosité</translation>
    </message>
    <message>
        <source>How bright the leaves are.</source>
        <translation>À quel point les feuilles sont claires.</translation>
    </message>
    <message>
        <source>Yellowing</source>
        <translation>Jaunissement</translation>
    </message>
    <message>
        <source>How far the leaves of weak shoots turn towards yellow and red.</source>
        <translation>À quel point les feuilles des pousses faibles virent au jaune et au rouge.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exposant</translation>
    </message>
    <message>
        <source>How widths add up where branches meet: 2 is Leonardo&apos;s rule; less makes thicker trunks.</source>
        <translation>Comment les épaisseurs s’additionnent là où les branches se rejoignent&#xa0;: 2 est la règle de Léonard&#xa0;; moins donne des troncs plus épais.</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Extrémités</translation>
    </message>
    <message>
        <source>Diameter of the thinnest twigs.</source>
        <translation>Diamètre des rameaux les plus fins.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Diameter of the trunk at the ground; at 0 it follows from the exponent.</source>
        <translation>Diamètre du tronc au sol&#xa0;; à 0, il découle de l’exposant.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Empattement</translation>
    </message>
    <message>
        <source>How much the trunk spreads where it meets the ground.</source>
        <translation>À quel point le tronc s’évase là où il rencontre le sol.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What the bark looks like.</source>
        <translation>L’aspect de l’écorce.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Length of trunk after which the bark&apos;s pattern repeats.</source>
        <translation>Longueur de tronc après laquelle le motif de l’écorce se répète.</translation>
    </message>
    <message>
        <source>Gravimorphism</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>Ramification</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Vigour</source>
        <translation>Vigueur</translation>
    </message>
    <message>
        <source>Habit</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation>Pousse</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Ombrage</translation>
    </message>
    <message>
        <source>Room to grow</source>
        <translation>Place disponible</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Aspect</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Écorce</translation>
    </message>
    <message>
        <source>ovate</source>
        <translation>ovée</translation>
    </message>
    <message>
        <source>lanceolate</source>
        <translation>lancéolée</translation>
    </message>
    <message>
        <source>lobed</source>
        <translation>lobée</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>aiguilles</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>sillonnée</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>lisse</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>à plaques</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>bouleau</translation>
    </message>
    <message>
        <source>cordate</source>
        <translation>cordée</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>palmée</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>pennée</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>saule</translation>
    </message>
    <message>
        <source>fascicle</source>
        <translation>faisceau</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>fronde</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>cerisier</translation>
    </message>
    <message>
        <source>mottled</source>
        <translation>marbrée</translation>
    </message>
    <message>
        <source>fibrous</source>
        <translation>fibreuse</translation>
    </message>
    <message>
        <source>ringed</source>
        <translation>annelée</translation>
    </message>
    <message>
        <source>What stands behind the tree. The studio is dark or light, as the theme is.</source>
        <translation>Ce qui se trouve derrière l’arbre. Le studio est sombre ou clair, comme le programme.</translation>
    </message>
    <message>
        <source>dark_studio</source>
        <translation>studio sombre</translation>
    </message>
    <message>
        <source>light_studio</source>
        <translation>studio clair</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>A pen&apos;s pressure scales the brush: the radius is what a firm hand reaches.</source>
        <translation>La pression d’un stylet modifie la taille du pinceau&#xa0;: le rayon entier est ce qu’atteint une main ferme.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads, and that shoots grow towards.</source>
        <translation>Afficher les points d’espace libre que répand le pinceau et vers lesquels les pousses se dirigent.</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Plan de dessin</translation>
    </message>
    <message>
        <source>Show how deep in the tree the brush draws: a faint grid around it.</source>
        <translation>Montrer à quelle profondeur de l’arbre le pinceau dessine&#xa0;: une grille pâle autour de lui.</translation>
    </message>
    <message>
        <source>Hazel</source>
        <translation>Noisetier</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>Chêne</translation>
    </message>
    <message>
        <source>Maple</source>
        <translation>Érable</translation>
    </message>
    <message>
        <source>Elm</source>
        <translation>Orme</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>Peuplier</translation>
    </message>
    <message>
        <source>Spruce</source>
        <translation>Épicéa</translation>
    </message>
    <message>
        <source>Pine</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Acacia</source>
        <translation>Acacia</translation>
    </message>
    <message>
        <source>Apple</source>
        <translation>Pommier</translation>
    </message>
    <message>
        <source>Joshua tree</source>
        <translation>Arbre de Josué</translation>
    </message>
    <message>
        <source>Buds</source>
        <translation>Bourgeons</translation>
    </message>
    <message>
        <source>How many buds a tap adds, in a spiral around the branch.</source>
        <translation>Nombre de bourgeons qu’un toucher ajoute, en spirale autour de la branche.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>How far one bud is from the next along the branch: 0 is a whorl.</source>
        <translation>La distance d’un bourgeon au suivant le long de la branche&#xa0;: 0 donne un verticille.</translation>
    </message>
    <message>
        <source>Self-organising competition, or shoot growth by vigour with apical control.</source>
        <translation>Compétition auto-organisée, ou croissance des pousses selon la vigueur, avec contrôle apical.</translation>
    </message>
    <message>
        <source>Growth in a year</source>
        <translation>Pousse annuelle</translation>
    </message>
    <message>
        <source>How much the strongest shoot grows in full light, in twelve steps.</source>
        <translation>De combien la pousse la plus forte s’allonge en pleine lumière, en douze étapes.</translation>
    </message>
    <message>
        <source>Annual elongation of a shoot.</source>
        <translation>Élongation annuelle d’une pousse.</translation>
    </message>
    <message>
        <source>Length of internodes</source>
        <translation>Long. d’entre-nœud</translation>
    </message>
    <message>
        <source>An internode lengthens over several steps, up to this.</source>
        <translation>Un entre-nœud s’allonge sur plusieurs étapes, jusqu’à cette longueur.</translation>
    </message>
    <message>
        <source>Length of a mature metamer.</source>
        <translation>Longueur d’un métamère adulte.</translation>
    </message>
    <message>
        <source>Angle of laterals</source>
        <translation>Angle des latéraux</translation>
    </message>
    <message>
        <source>Between an axis and a branch that begins on it.</source>
        <translation>Entre un axe et une branche qui y naît.</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral shoot.</source>
        <translation>Angle d’insertion d’une pousse latérale.</translation>
    </message>
    <message>
        <source>Lateral buds</source>
        <translation>Bourgeons axillaires</translation>
    </message>
    <message>
        <source>At each node: one makes a spiral, two crossed pairs, more a whorl.</source>
        <translation>À chaque nœud&#xa0;: un donne une spirale, deux des paires croisées, davantage un verticille.</translation>
    </message>
    <message>
        <source>Variation in roll</source>
        <translation>Écart de rotation</translation>
    </message>
    <message>
        <source>How irregularly branches stand around their axis.</source>
        <translation>À quel point les branches sont irrégulièrement réparties autour de leur axe.</translation>
    </message>
    <message>
        <source>Standard deviation of the divergence angle.</source>
        <translation>Écart-type de l’angle de divergence.</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>Sinuosité</translation>
    </message>
    <message>
        <source>How much an axis changes its direction from node to node.</source>
        <translation>À quel point un axe change de direction d’un nœud à l’autre.</translation>
    </message>
    <message>
        <source>Standard deviation of the apical angle.</source>
        <translation>Écart-type de l’angle apical.</translation>
    </message>
    <message>
        <source>Branch orders</source>
        <translation>Ordres de ramification</translation>
    </message>
    <message>
        <source>How many orders of branches there are at most: branches, their branches, and so on.</source>
        <translation>Des branches sur des branches sur des branches&#xa0;: autant d’ordres, pas plus.</translation>
    </message>
    <message>
        <source>Highest order of an axis.</source>
        <translation>Ordre le plus élevé d’un axe.</translation>
    </message>
    <message>
        <source>Flushing</source>
        <translation>Débourrement</translation>
    </message>
    <message>
        <source>How readily lateral buds become branches.</source>
        <translation>Avec quelle facilité les bourgeons axillaires deviennent des branches.</translation>
    </message>
    <message>
        <source>Chance of lateral bud break for each internode of growth.</source>
        <translation>Probabilité de débourrement d’un bourgeon axillaire par entre-nœud de croissance.</translation>
    </message>
    <message>
        <source>Inhibition</source>
        <translation>Inhibition</translation>
    </message>
    <message>
        <source>How strongly growing tips hold back the buds below them.</source>
        <translation>À quel point les extrémités en croissance retiennent les bourgeons situés sous elles.</translation>
    </message>
    <message>
        <source>Apical dominance: auxin from lit apical buds.</source>
        <translation>Dominance apicale&#xa0;: auxine des bourgeons terminaux éclairés.</translation>
    </message>
    <message>
        <source>Decay of the inhibitor on its way down.</source>
        <translation>Décroissance de l’inhibiteur en descendant.</translation>
    </message>
    <message>
        <source>Apical control</source>
        <translation>Contrôle apical</translation>
    </message>
    <message>
        <source>Above 1 the trunk outgrows its branches, as in a spruce; below 1 they outgrow it.</source>
        <translation>Au-dessus de 1, le tronc dépasse ses branches, comme chez l’épicéa&#xa0;; en dessous de 1, elles le dépassent.</translation>
    </message>
    <message>
        <source>Excurrent above 1, decurrent below.</source>
        <translation>Excurrent au-dessus de 1, décurrent en dessous.</translation>
    </message>
    <message>
        <source>Loss with distance</source>
        <translation>Fatigue au loin</translation>
    </message>
    <message>
        <source>How much less a shoot grows far from the root.</source>
        <translation>À quel point les pousses éloignées de la racine poussent moins.</translation>
    </message>
    <message>
        <source>Decay of the potential with the distance to the root.</source>
        <translation>Décroissance du potentiel avec la distance à la racine.</translation>
    </message>
    <message>
        <source>Loss with height</source>
        <translation>Fatigue en hauteur</translation>
    </message>
    <message>
        <source>How much less a shoot grows the higher it is: more makes the crown flat.</source>
        <translation>À quel point les pousses hautes poussent moins&#xa0;: davantage donne des houppiers plats.</translation>
    </message>
    <message>
        <source>Decay of the potential with height.</source>
        <translation>Décroissance du potentiel avec la hauteur.</translation>
    </message>
    <message>
        <source>Gravitropism</source>
        <translation>Gravitropisme</translation>
    </message>
    <message>
        <source>Above 0 shoots turn upwards at each node, below 0 downwards.</source>
        <translation>Au-dessus de 0, les pousses se tournent vers le haut à chaque nœud&#xa0;; en dessous de 0, les branches se tournent vers le bas.</translation>
    </message>
    <message>
        <source>Orthotropic above 0, positively gravitropic below.</source>
        <translation>Orthotrope au-dessus de 0, à gravitropisme positif en dessous.</translation>
    </message>
    <message>
        <source>Phototropism</source>
        <translation>Phototropisme</translation>
    </message>
    <message>
        <source>How far shoots turn to the light at each node.</source>
        <translation>À quel point les pousses se tournent vers la lumière à chaque nœud.</translation>
    </message>
    <message>
        <source>Growth towards the brightest direction.</source>
        <translation>Croissance vers la direction la plus claire.</translation>
    </message>
    <message>
        <source>Level branches</source>
        <translation>Branches horizontales</translation>
    </message>
    <message>
        <source>How far a new branch turns towards the horizontal where it begins.</source>
        <translation>À quel point une nouvelle branche se tourne vers l’horizontale à son départ.</translation>
    </message>
    <message>
        <source>Plagiotropy of lateral shoots.</source>
        <translation>Plagiotropie des pousses latérales.</translation>
    </message>
    <message>
        <source>Sagging</source>
        <translation>Affaissement</translation>
    </message>
    <message>
        <source>How far branches sag under their weight as they grow.</source>
        <translation>À quel point les branches s’affaissent sous leur poids en poussant.</translation>
    </message>
    <message>
        <source>Gravimorphic bending by branch load.</source>
        <translation>Courbure gravimorphique due au poids des branches.</translation>
    </message>
    <message>
        <source>Stiffness with age</source>
        <translation>Raideur avec l’âge</translation>
    </message>
    <message>
        <source>How much thick wood resists: at high values only the thin ends bend.</source>
        <translation>À quel point le bois épais résiste&#xa0;: davantage ne courbe que les bouts minces.</translation>
    </message>
    <message>
        <source>Exponent of thickness in flexural stiffness.</source>
        <translation>Exposant de l’épaisseur dans la rigidité à la flexion.</translation>
    </message>
    <message>
        <source>Greatest sag</source>
        <translation>Affaissement max.</translation>
    </message>
    <message>
        <source>An internode sags by at most this share of the angle between it and straight down.</source>
        <translation>Au plus cette part de l’angle jusqu’à la verticale vers le bas, par entre-nœud.</translation>
    </message>
    <message>
        <source>Limit of the bend of an internode.</source>
        <translation>Limite de la courbure d’un entre-nœud.</translation>
    </message>
    <message>
        <source>Shade pruning</source>
        <translation>Élagage par l’ombre</translation>
    </message>
    <message>
        <source>Branch ends that get less light than this drop off.</source>
        <translation>Les bouts de branches qui reçoivent moins de lumière que cela tombent.</translation>
    </message>
    <message>
        <source>Cladoptosis of shaded shoots.</source>
        <translation>Cladoptose des pousses ombragées.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Tubes: each branch is a tube that begins inside its parent. Strands: the wood is bundles of strands, which run from every tip to the ground, under one closed bark.</source>
        <translation>Tubes&#xa0;: chaque branche est un tube qui commence dans celle qui la porte. Brins&#xa0;: le bois est fait de faisceaux de brins, qui vont de chaque extrémité jusqu’au sol, sous une seule écorce fermée.</translation>
    </message>
    <message>
        <source>Strands at a tip</source>
        <translation>Brins par extrémité</translation>
    </message>
    <message>
        <source>How many strands begin at each tip. More make a smoother surface, and branches that separate more clearly.</source>
        <translation>Nombre de brins qui partent de chaque extrémité. Davantage donne une surface plus lisse, et des branches qui se séparent plus nettement.</translation>
    </message>
    <message>
        <source>Strand radius</source>
        <translation>Rayon des brins</translation>
    </message>
    <message>
        <source>How thick each strand is. Above 0, the trunk gets as thick as its strands make it; at 0 it keeps the width that it has.</source>
        <translation>L’épaisseur de chaque brin. Le tronc devient alors aussi épais que ses brins le demandent&#xa0;; à 0, il garde l’épaisseur qu’il a.</translation>
    </message>
    <message>
        <source>Cohesion</source>
        <translation>Cohésion</translation>
    </message>
    <message>
        <source>Branches separate at a fork where their strands are further apart than this many strand radii: low values part them early, high ones late.</source>
        <translation>Les branches se séparent à une fourche là où leurs brins sont plus éloignés que ce nombre de rayons de brin&#xa0;: tôt si la valeur est basse, tard si elle est haute.</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Tassement</translation>
    </message>
    <message>
        <source>How the strands of a section are pressed together. At rest: until none overlaps. As published: by the paper&apos;s simulation, which stops before that.</source>
        <translation>Comment les brins d’une section sont serrés les uns contre les autres. Au repos&#xa0;: jusqu’à ce qu’aucun n’en recouvre un autre. Publié&#xa0;: par la simulation de l’article, qui s’arrête en chemin.</translation>
    </message>
    <message>
        <source>Packing steps</source>
        <translation>Étapes de tassement</translation>
    </message>
    <message>
        <source>For how long strands are pressed together at each node. With few steps, the shape of a fork is kept further down the trunk; with many, the trunk is round at once.</source>
        <translation>Combien de temps les brins sont serrés à chaque nœud. Peu d’étapes gardent la forme d’une fourche plus bas sur le tronc&#xa0;; beaucoup l’arrondissent aussitôt.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>How far the ridges of single strands are smoothed: 0 shows each of them.</source>
        <translation>À quel point le relief des brins isolés est lissé&#xa0;: 0 montre chacun d’eux.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Bud break</source>
        <translation>Départ des bourgeons</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Contrôle</translation>
    </message>
    <message>
        <source>Tropisms</source>
        <translation>Tropismes</translation>
    </message>
    <message>
        <source>Weight and shade</source>
        <translation>Poids et ombre</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>Brins</translation>
    </message>
    <message>
        <source>vigour</source>
        <translation>vigueur</translation>
    </message>
    <message>
        <source>tubes</source>
        <translation>tubes</translation>
    </message>
    <message>
        <source>strands</source>
        <translation>brins</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>publié</translation>
    </message>
    <message>
        <source>Branches too</source>
        <translation>Branches aussi</translation>
    </message>
    <message>
        <source>A drag twists all that the branch carries, not only the branch itself. Hold Shift for the opposite.</source>
        <translation>Un glissement torsade tout ce que la branche porte, pas seulement la branche elle-même. Maj fait l’inverse tant qu’elle est enfoncée.</translation>
    </message>
    <message>
        <source>Fading of the inhibition</source>
        <translation>Atténuation de l’inhibition</translation>
    </message>
    <message>
        <source>The share that is lost at each internode: higher values let buds break nearer to the tip.</source>
        <translation>La part qui se perd à chaque entre-nœud : plus elle est grande, plus les bourgeons débourrent près de l’extrémité.</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Cannelures</translation>
    </message>
    <message>
        <source>How far the trunk bulges below its limbs and towards its roots, and how deep the hollows of lost limbs are. At 0 the wood is round.</source>
        <translation>À quel point le tronc se renfle sous ses branches et vers ses racines, et la profondeur des creux laissés par les branches perdues. À 0, le bois est rond.</translation>
    </message>
    <message>
        <source>Growth model</source>
        <translation>Modèle de croissance</translation>
    </message>
    <message>
        <source>TreeSketch: buds compete for space and light. Vigour: light decides how fast each shoot grows, month by month.</source>
        <translation>TreeSketch&#xa0;: les bourgeons se disputent l’espace et la lumière. Vigueur&#xa0;: la lumière décide de la vitesse de chaque pousse, mois après mois.</translation>
    </message>
    <message>
        <source>TreeSketch</source>
        <translation>TreeSketch</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Enlever</translation>
    </message>
    <message>
        <source>A stroke takes away: a branch that it crosses once is cut there, one that it crosses twice is erased. Shift or a pen&apos;s eraser does so, too.</source>
        <translation>Un trait enlève : une branche qu’il croise une fois est coupée à cet endroit, une branche qu’il croise deux fois est effacée. Maj ou la gomme d’un stylet font de même.</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Each branch is drawn on the other side of the trunk as well.</source>
        <translation>Chaque branche est dessinée aussi de l’autre côté du tronc.</translation>
    </message>
    <message>
        <source>Fill the sides</source>
        <translation>Remplir les côtés</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Couronne</translation>
    </message>
    <message>
        <source>How much wider than the drawing the crown may be in depth.</source>
        <translation>De combien la couronne peut être plus large en profondeur que le dessin.</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>How much longer branches may become in depth than those you drew.</source>
        <translation>De combien les branches peuvent devenir plus longues en profondeur que celles dessinées.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>How much wider an angle between branches may be than the widest you drew.</source>
        <translation>De combien un angle entre branches peut dépasser le plus ouvert du dessin.</translation>
    </message>
    <message>
        <source>Pass on</source>
        <translation>Transmettre</translation>
    </message>
    <message>
        <source>A tap on a branch gives other branches what it carries. Otherwise it adds one branch like those that the branch carries.</source>
        <translation>Toucher une branche donne aux autres ce qu’elle porte. Sinon, elle reçoit une branche de plus comme celles qu’elle porte.</translation>
    </message>
    <message>
        <source>Only to similar ones</source>
        <translation>À ses pareilles</translation>
    </message>
    <message>
        <source>Only branches that are equally many forks away from the trunk get it.</source>
        <translation>Seules les branches ayant autant de ramifications sous elles le reçoivent.</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>À l’échelle</translation>
    </message>
    <message>
        <source>What a branch gets is scaled to the size of that branch. Otherwise it keeps its size, and its distance from the tip.</source>
        <translation>Ce qu’une branche reçoit est plus grand ou plus petit, comme elle. Sinon, cela garde sa taille et sa distance à la pointe.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>À la place</translation>
    </message>
    <message>
        <source>What the branches carried until now is removed.</source>
        <translation>Ce que les branches portaient jusqu’ici disparaît.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>How much the angles and lengths of a variation deviate from those of the tree.</source>
        <translation>À quel point les angles et les longueurs d’une variation s’écartent de l’arbre.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Which variation it is: the same number always gives the same variation of a tree.</source>
        <translation>De quelle variation il s’agit&#xa0;: le même numéro fait du même arbre le même.</translation>
    </message>
    <message>
        <source>Two sides</source>
        <translation>Deux côtés</translation>
    </message>
    <message>
        <source>Two strokes in a row, drawn side by side, are the two sides of one branch, which gets its width from them.</source>
        <translation>Deux traits côte à côte, l’un après l’autre, sont les deux côtés d’une branche, qui en reçoit son épaisseur.</translation>
    </message>
    <message>
        <source>The drawing is placed twice, the second time turned by 90° around the trunk, so that the tree is as full from the side as from the front. Without this, its branches themselves run towards you and away from you.</source>
        <translation>Le dessin est placé deux fois, la seconde tourné de 90° autour du tronc, pour que l’arbre soit aussi fourni de côté que de face. Sans cela, les branches elles-mêmes viennent vers vous et s’éloignent.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Where strokes go in depth. Screen: as deep as the branch that they begin at. Trunk: in the plane through the trunk and the branch that they begin at. Spread: each limb that begins at the trunk is turned into the widest gap, as long and as steep as you draw it.</source>
        <translation>Où vont les traits en profondeur. Écran : à la profondeur de la branche dont ils partent. Tronc : dans le plan du tronc et de la branche dont ils partent. Réparti : chaque branche qui part du tronc est tournée vers le plus grand vide, aussi longue et inclinée que vous la tracez.</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Autour</translation>
    </message>
    <message>
        <source>How many strokes are made around the trunk for each one that you draw.</source>
        <translation>Combien de traits naissent autour du tronc pour chacun que vous tracez.</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>Tronc</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Réparti</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Radius of the brush, shared with the Brush tool.</source>
        <translation>Rayon du pinceau, le même que celui du pinceau qui peint.</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>Jusqu’à</translation>
    </message>
    <message>
        <source>The thickest wood that is removed, as a share of the trunk&apos;s width. Thicker branches stay, however often you brush over them.</source>
        <translation>Le bois le plus épais qui part, en part de l’épaisseur du tronc. Les branches plus grosses restent, même en repassant.</translation>
    </message>
    <message>
        <source>Share of twigs</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>The share of the twigs under the brush that a stroke takes. They are chosen evenly along each limb.</source>
        <translation>La part des rameaux sous le pinceau qu’un trait retire. Ils sont choisis régulièrement le long de chaque branche.</translation>
    </message>
    <message>
        <source>Far side too</source>
        <translation>Face arrière aussi</translation>
    </message>
    <message>
        <source>A stroke reaches through the whole tree. Otherwise it takes only what is on your side of the trunk.</source>
        <translation>Un trait traverse tout l’arbre. Sinon, il ne prend que ce qui est de votre côté du tronc.</translation>
    </message>
    <message>
        <source>Straightening</source>
        <translation>Redressement</translation>
    </message>
    <message>
        <source>How fast young wood smooths its bends as it grows on: 0 keeps every elbow.</source>
        <translation>La vitesse à laquelle le jeune bois adoucit ses coudes en poussant : 0 garde chaque coude.</translation>
    </message>
    <message>
        <source>Reaction wood: an axis that takes over straightens.</source>
        <translation>Bois de réaction : un axe qui prend le relais se redresse.</translation>
    </message>
</context>
<context>
    <name>ParametersJson</name>
    <message>
        <source>true or false is expected</source>
        <translation>true ou false est attendu</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>l’une de ces valeurs est attendue&#xa0;: %1</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>un nombre entier est attendu</translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation>un nombre est attendu</translation>
    </message>
    <message>
        <source>%1 is not within %2…%3</source>
        <translation>%1 n’est pas compris dans %2…%3</translation>
    </message>
    <message>
        <source>axisWeight, tropismWeight and spaceWeight must not all be 0</source>
        <translation>axisWeight, tropismWeight et spaceWeight ne peuvent pas être tous à 0</translation>
    </message>
    <message>
        <source>it must not exceed 0.99 times ellipseVertical, which is %1</source>
        <translation>la valeur ne peut pas dépasser 0,99 fois ellipseVertical, qui vaut %1</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>un objet est attendu</translation>
    </message>
    <message>
        <source>there is no such parameter</source>
        <translation>il n’y a pas de tel paramètre</translation>
    </message>
    <message>
        <source>the name of an image is expected</source>
        <translation>le nom d’une image est attendu</translation>
    </message>
    <message>
        <source>there are no images here</source>
        <translation>il n’y a pas d’images ici</translation>
    </message>
</context>
<context>
    <name>PositionCheck</name>
    <message>
        <source>it and the later steps move a tree whose axes are longer than %1 m too often</source>
        <translation>elle et les étapes suivantes déplacent trop souvent un arbre dont les axes dépassent %1 m</translation>
    </message>
    <message>
        <source>before it, internode %1 lies more than %2 m away</source>
        <translation>avant elle, l’entre-nœud %1 est à plus de %2 m</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>étape %1 de l’historique</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>il se trouve à plus de %1 m</translation>
    </message>
    <message>
        <source>internode %1</source>
        <translation>entre-nœud %1</translation>
    </message>
</context>
<context>
    <name>ProfileJson</name>
    <message>
        <source>a profile is expected</source>
        <translation>un profil est attendu</translation>
    </message>
    <message>
        <source>at most %1 are possible</source>
        <translation>%1 au plus sont possibles</translation>
    </message>
    <message>
        <source>lists of points [x, y] are expected</source>
        <translation>des listes de points [x, y] sont attendues</translation>
    </message>
</context>
<context>
    <name>ProfileTool</name>
    <message>
        <source>Tap a branch to see its cross-section, and draw another shape for it</source>
        <translation>Toucher une branche pour voir sa section, et lui dessiner une autre forme</translation>
    </message>
</context>
<context>
    <name>Program</name>
    <message>
        <source>%1; see espalier --help</source>
        <translation>%1&#xa0;; voir espalier --help</translation>
    </message>
    <message>
        <source>What you did is in a safety copy in %1; the next start offers it. The fault is described in %2.</source>
        <translation>Votre travail se trouve dans une copie de sécurité dans %1 ; le prochain démarrage la propose. L’erreur est décrite dans %2.</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>pairs of an internode and a diameter are expected</source>
        <translation>des paires d’un entre-nœud et d’un diamètre sont attendues</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>un objet est attendu</translation>
    </message>
    <message>
        <source>it does not describe an Espalier project</source>
        <translation>cela ne décrit pas un projet Espalier</translation>
    </message>
    <message>
        <source>Espalier %1 wrote it in version %2 of the format; this is Espalier %3, which reads versions up to %4</source>
        <translation>Espalier %1 l’a écrit dans la version %2 du format&#xa0;; ceci est Espalier %3, qui lit les versions jusqu’à %4</translation>
    </message>
    <message>
        <source>1 to %1 sets are expected</source>
        <translation>de 1 à %1 jeux de paramètres sont attendus</translation>
    </message>
    <message>
        <source>the lassos</source>
        <translation>les lassos</translation>
    </message>
    <message>
        <source>their parts do not add up</source>
        <translation>leurs parties ne concordent pas</translation>
    </message>
    <message>
        <source>the history</source>
        <translation>l’historique</translation>
    </message>
    <message>
        <source>its parts do not add up</source>
        <translation>ses parties ne concordent pas</translation>
    </message>
    <message>
        <source>the tree or its history is too large for a project file</source>
        <translation>l’arbre ou son historique est trop grand pour un fichier de projet</translation>
    </message>
    <message>
        <source>at most %1 images are expected</source>
        <translation>au plus %1 images sont attendues</translation>
    </message>
    <message>
        <source>the image “%1” is missing from it or broken; the built-in look is shown instead</source>
        <translation>l’image «&#xa0;%1&#xa0;» y manque ou est endommagée&#xa0;; l’aspect dessiné par Espalier apparaît à sa place</translation>
    </message>
    <message>
        <source>they have too many points</source>
        <translation>ils ont trop de points</translation>
    </message>
    <message>
        <source>indices of strokes are expected</source>
        <translation>des indices de tracés sont attendus</translation>
    </message>
    <message>
        <source>the record of what was done</source>
        <translation>l’enregistrement de ce qui a été fait</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>étape %1 de l’historique</translation>
    </message>
    <message>
        <source>the record of what was done is not a JSON object</source>
        <translation>l’enregistrement de ce qui a été fait n’est pas un objet JSON</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>les profils</translation>
    </message>
    <message>
        <source>there are too many</source>
        <translation>il y en a trop</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>true ou false est attendu</translation>
    </message>
    <message>
        <source>a colour such as #5c6268 is expected</source>
        <translation>une couleur comme #5c6268 est attendue</translation>
    </message>
    <message>
        <source>there is no backdrop of this name</source>
        <translation>il n’y a pas d’arrière-plan de ce nom</translation>
    </message>
    <message>
        <source>its background and light cannot be read (%1); those of a new tree are shown instead</source>
        <translation>son arrière-plan et sa lumière sont illisibles (%1) ; ceux d’un nouvel arbre les remplacent</translation>
    </message>
    <message>
        <source>the reference picture “%1” is missing from it or broken</source>
        <translation>l’image de référence « %1 » y manque ou est endommagée</translation>
    </message>
    <message>
        <source>a change of the history</source>
        <translation>une modification de l’historique</translation>
    </message>
    <message>
        <source>it does not follow on from what is before it</source>
        <translation>elle ne s’enchaîne pas à ce qui la précède</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>some of what other programs have put into it cannot be kept</source>
        <translation>une partie de ce que d’autres programmes y ont mis ne peut pas être gardée</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>a stroke needs at least one point</source>
        <translation>un trait a au moins un point</translation>
    </message>
    <message>
        <source>1 to %1 strokes are expected</source>
        <translation>de 1 à %1 traits sont attendus</translation>
    </message>
    <message>
        <source>internode %1 is a root, which cannot be pruned</source>
        <translation>l’entre-nœud %1 est une racine, qui ne peut pas être taillée</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>il n’y a plus de place pour d’autres jeux de paramètres</translation>
    </message>
    <message>
        <source>there is no such bud</source>
        <translation>il n’y a pas de tel bourgeon</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>un objet est attendu</translation>
    </message>
    <message>
        <source>a number other than 0 is expected</source>
        <translation>un nombre autre que 0 est attendu</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>cela manque</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample</source>
        <translation>un trait a au moins un échantillon</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 samples</source>
        <translation>une recette a au plus %1 échantillons</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected</source>
        <translation>trois nombres compris dans ±%1 sont attendus</translation>
    </message>
    <message>
        <source>right and up must have length 1 and be at right angles</source>
        <translation>right et up doivent être de longueur 1 et à angle droit</translation>
    </message>
    <message>
        <source>a lasso needs at least three points</source>
        <translation>un lasso a au moins trois points</translation>
    </message>
    <message>
        <source>two numbers within ±%1 are expected, right and up, in m</source>
        <translation>deux nombres compris dans ±%1 sont attendus, vers la droite et vers le haut, en m</translation>
    </message>
    <message>
        <source>1 to %1 internodes are expected</source>
        <translation>de 1 à %1 entre-nœuds sont attendus</translation>
    </message>
    <message>
        <source>an array of five numbers is expected: time, x, y, z, radius</source>
        <translation>un tableau de cinq nombres est attendu&#xa0;: temps, x, y, z, rayon</translation>
    </message>
    <message>
        <source>the time is not within 0…%1 s</source>
        <translation>le temps n’est pas compris dans 0…%1 s</translation>
    </message>
    <message>
        <source>the time does not go forwards</source>
        <translation>le temps n’avance pas</translation>
    </message>
    <message>
        <source>a coordinate is not within ±%1 m</source>
        <translation>une coordonnée n’est pas comprise dans ±%1 m</translation>
    </message>
    <message>
        <source>the radius is not within 0…%1 m</source>
        <translation>le rayon n’est pas compris dans 0…%1 m</translation>
    </message>
    <message>
        <source>a bend needs 1 to %1 handles</source>
        <translation>une courbure a de 1 à %1 poignées</translation>
    </message>
    <message>
        <source>an array of three numbers within ±%1 is expected</source>
        <translation>un tableau de trois nombres compris dans ±%1 est attendu</translation>
    </message>
    <message>
        <source>there is no view “%1”; there are front, side, top and three-quarter</source>
        <translation>il n’y a pas de vue «&#xa0;%1&#xa0;»&#xa0;; il y a front, side, top et three-quarter</translation>
    </message>
    <message>
        <source>this is not a recipe: a recipe begins with “%1”: %2</source>
        <translation>ce n’est pas une recette&#xa0;: une recette commence par «&#xa0;%1&#xa0;»&#xa0;: %2</translation>
    </message>
    <message>
        <source>the recipe is of version %1; this program reads versions up to %2</source>
        <translation>la recette est de la version %1, ce programme lit les versions jusqu’à %2</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 operations</source>
        <translation>une recette a au plus %1 opérations</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 images</source>
        <translation>une recette a au plus %1 images</translation>
    </message>
    <message>
        <source>a path relative to the recipe is expected</source>
        <translation>un chemin relatif à la recette est attendu</translation>
    </message>
    <message>
        <source>internode %1 is not on the branch above internode %2</source>
        <translation>l’entre-nœud %1 n’est pas sur la branche au-dessus de l’entre-nœud %2</translation>
    </message>
    <message>
        <source>nothing grew</source>
        <translation>rien n’a poussé</translation>
    </message>
    <message>
        <source>internode %1 has no bud %2</source>
        <translation>l’entre-nœud %1 n’a pas de bourgeon %2</translation>
    </message>
    <message>
        <source>%1 hexadecimal digits are expected</source>
        <translation>%1 chiffres hexadécimaux sont attendus</translation>
    </message>
    <message>
        <source>a key (“key”) or a place (“at”) is expected</source>
        <translation>une clé («&#xa0;key&#xa0;») ou un lieu («&#xa0;at&#xa0;») est attendu</translation>
    </message>
    <message>
        <source>there is no internode %1</source>
        <translation>il n’y a pas d’entre-nœud %1</translation>
    </message>
    <message>
        <source>there is no internode with the key %1</source>
        <translation>il n’y a pas d’entre-nœud portant la clé %1</translation>
    </message>
    <message>
        <source>there is no internode near (%1, %2, %3) m</source>
        <translation>il n’y a pas d’entre-nœud près de (%1, %2, %3) m</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1 is expected</source>
        <translation>un nombre entier de 0 à %1 est attendu</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1&#xa0;; et encore %2</translation>
    </message>
    <message>
        <source>there is no operation “%1”; there are %2</source>
        <translation>il n’y a pas d’opération «&#xa0;%1&#xa0;»&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>there are only %1 commands to redo, not %2</source>
        <translation>commandes à rétablir&#xa0;: %1 seulement, pas %2</translation>
    </message>
    <message>
        <source>there is no envelope</source>
        <translation>il n’y a pas d’enveloppe</translation>
    </message>
    <message>
        <source>internode %1 has no width to take away</source>
        <translation>l’entre-nœud %1 n’a pas d’épaisseur à retirer</translation>
    </message>
    <message>
        <source>the history goes back only by %1, not by %2</source>
        <translation>l’historique ne remonte que de %1, pas de %2</translation>
    </message>
    <message>
        <source>the history goes on only by %1, not by %2</source>
        <translation>l’historique n’avance que de %1, pas de %2</translation>
    </message>
    <message>
        <source>there are only %1 commands to undo, not %2</source>
        <translation>commandes à annuler&#xa0;: %1 seulement, pas %2</translation>
    </message>
    <message>
        <source>a target for each handle is expected</source>
        <translation>une cible pour chaque poignée est attendue</translation>
    </message>
    <message>
        <source>arrays of three numbers within ±%1 are expected</source>
        <translation>des tableaux de trois nombres dans ±%1 sont attendus</translation>
    </message>
    <message>
        <source>there are more than %1</source>
        <translation>il y en a plus de %1</translation>
    </message>
    <message>
        <source>“%1” must be given with them</source>
        <translation>il leur faut « %1 » à côté</translation>
    </message>
    <message>
        <source>1 to %1 envelopes are expected</source>
        <translation>1 à %1 enveloppes sont attendues</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: of its %1 steps, %2 (%3) were made by a version of Espalier that did not record how</source>
        <translation>l’historique de l’arbre ne peut pas devenir une recette : de ses %1 étapes, %2 (%3) viennent d’une version d’Espalier qui n’enregistrait pas comment</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: it does not begin with a seedling, because the tree was imported or its oldest steps were dropped</source>
        <translation>l’historique de l’arbre ne peut pas devenir une recette : il ne commence pas par un semis, parce que l’arbre a été importé ou que ses étapes les plus anciennes ont été supprimées</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>étape %1 de l’historique</translation>
    </message>
    <message>
        <source>another file with this name is where the recipe&apos;s image should go</source>
        <translation>un autre fichier de ce nom se trouve à la place de l’image de la recette</translation>
    </message>
    <message>
        <source>the recipe&apos;s numbers cannot be written exactly</source>
        <translation>les nombres de la recette ne peuvent pas être écrits exactement</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>%1 nombres sont attendus</translation>
    </message>
    <message>
        <source>its parent is neither one of the segments before it nor -1</source>
        <translation>son parent n’est ni l’un des segments qui le précèdent, ni -1</translation>
    </message>
    <message>
        <source>1 to %1 segments are expected</source>
        <translation>de 1 à %1 segments sont attendus</translation>
    </message>
    <message>
        <source>a recipe that was not read from a file cannot name files</source>
        <translation>une recette qui n’est pas un fichier ne peut pas nommer de fichiers</translation>
    </message>
    <message>
        <source>internode %1 has no room for buds above the ground</source>
        <translation>l’entre-nœud %1 n’a pas de place pour des bourgeons au-dessus du sol</translation>
    </message>
    <message>
        <source>nothing was taken away</source>
        <translation>rien n’a été retiré</translation>
    </message>
    <message>
        <source>there is no branch from internode %1 to internode %2</source>
        <translation>il n’y a pas de branche de l’entre-nœud %1 à l’entre-nœud %2</translation>
    </message>
    <message>
        <source>internode %1 has no profile to take away</source>
        <translation>l’entre-nœud %1 n’a pas de profil à retirer</translation>
    </message>
    <message>
        <source>internode %1 has no twist to take away</source>
        <translation>l’entre-nœud %1 n’a pas de torsade à retirer</translation>
    </message>
    <message>
        <source>a branch must begin at exactly one internode</source>
        <translation>une branche commence à un seul entre-nœud</translation>
    </message>
    <message>
        <source>true is expected</source>
        <translation>true est attendu</translation>
    </message>
    <message>
        <source>the other end of the branch (“to”) is missing</source>
        <translation>l’autre bout de la branche («&#xa0;to&#xa0;») manque</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>l’un de ceux-ci est attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>a stroke needs at least %1 points</source>
        <translation>un trait a au moins %1 points</translation>
    </message>
    <message>
        <source>at most %1 radii are expected</source>
        <translation>au plus %1 rayons sont attendus</translation>
    </message>
    <message>
        <source>numbers from 0 to %1 are expected, in m</source>
        <translation>des nombres de 0 à %1 sont attendus, en m</translation>
    </message>
    <message>
        <source>internode %1 cannot bear such a leaf</source>
        <translation>l’entre-nœud %1 ne peut porter une telle feuille</translation>
    </message>
    <message>
        <source>no leaves at internode %1 can be arranged by “%2”</source>
        <translation>aucune feuille à l’entre-nœud %1 ne peut être disposée par « %2 »</translation>
    </message>
    <message>
        <source>a quaternion is expected: four numbers x, y, z, w within ±1, not all of them 0</source>
        <translation>un quaternion est attendu : quatre nombres x, y, z, w dans ±1, non tous nuls</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>true ou false est attendu</translation>
    </message>
    <message>
        <source>nothing under the brush could be erased</source>
        <translation>rien sous le pinceau ne pouvait être effacé</translation>
    </message>
    <message>
        <source>there were no twigs under the brush to take</source>
        <translation>il n’y avait aucun rameau à retirer sous le pinceau</translation>
    </message>
    <message>
        <source>the branch of internode %1 is already kept clear that far</source>
        <translation>la branche de l’entre-nœud %1 est déjà dégagée ainsi</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected: x, y, z, in m</source>
        <translation>trois nombres dans ±%1 sont attendus : x, y, z, en m</translation>
    </message>
    <message>
        <source>four numbers are expected: x, y, z within ±%1 m, and a radius within 0…%2 m</source>
        <translation>quatre nombres sont attendus : x, y, z dans ±%1 m, et un rayon dans 0…%2 m</translation>
    </message>
    <message>
        <source>one stroke or more is expected</source>
        <translation>au moins un trait est attendu</translation>
    </message>
    <message>
        <source>growth stopped at %1 internodes, since the memory of this machine may not hold more</source>
        <translation>la croissance s’est arrêtée à %1 entre-nœuds, car la mémoire de cette machine ne suffira peut-être pas pour davantage</translation>
    </message>
    <message>
        <source>there is no room for more profiles</source>
        <translation>il n’y a plus de place pour d’autres profils</translation>
    </message>
</context>
<context>
    <name>RecipeTool</name>
    <message>
        <source>A recipe is playing; Escape hands the brush to you.</source>
        <translation>Une recette se joue&#xa0;; Échap rend le pinceau.</translation>
    </message>
</context>
<context>
    <name>ReduceTool</name>
    <message>
        <source>Press a branch and hold: it shrinks until you let go</source>
        <translation>Appuyer sur une branche et maintenir&#xa0;: elle rétrécit jusqu’au relâchement</translation>
    </message>
</context>
<context>
    <name>ReproduceTool</name>
    <message>
        <source>turn the view back to where you drew the first stroke, or press Esc to discard it</source>
        <translation>ramenez la vue là où vous avez dessiné le premier trait, ou oubliez-le avec Échap</translation>
    </message>
    <message>
        <source>look at the tree from the side, not from above or below, to draw its shape</source>
        <translation>regardez l’arbre de côté, et non d’en haut ou d’en bas, pour dessiner sa forme</translation>
    </message>
    <message>
        <source>there is no tree yet to give another shape: make one first</source>
        <translation>il n’y a pas encore d’arbre qui puisse prendre une autre forme&#xa0;: faites-en d’abord un</translation>
    </message>
    <message>
        <source>that is a point: draw the trunk as a line</source>
        <translation>c’est un point&#xa0;: dessinez le tronc comme une ligne</translation>
    </message>
    <message>
        <source>that is a point: draw the silhouette as a line around the crown</source>
        <translation>c’est un point&#xa0;: dessinez la silhouette comme une ligne autour du houppier</translation>
    </message>
    <message>
        <source>the stroke reaches too far away from the tree</source>
        <translation>le trait va trop loin de l’arbre</translation>
    </message>
    <message>
        <source>the trunk must be an open line</source>
        <translation>le tronc doit être une ligne ouverte</translation>
    </message>
    <message>
        <source>the tip of the trunk must be inside the silhouette</source>
        <translation>la pointe du tronc doit être à l’intérieur de la silhouette</translation>
    </message>
    <message>
        <source>the silhouette must enclose the tip of the trunk</source>
        <translation>la silhouette doit entourer la pointe du tronc</translation>
    </message>
    <message>
        <source>the trunk must be above the ground: draw it from its foot to its tip</source>
        <translation>le tronc doit être au-dessus du sol&#xa0;: dessinez-le du pied à la pointe</translation>
    </message>
    <message>
        <source>Make a tree first, with Brush or Sketch; then draw its new shape</source>
        <translation>Faites d’abord un arbre, au pinceau ou à l’esquisse&#xa0;; dessinez ensuite sa nouvelle forme</translation>
    </message>
    <message>
        <source>Draw the new trunk, then the silhouette of its crown</source>
        <translation>Dessinez le nouveau tronc, puis la silhouette de son houppier</translation>
    </message>
</context>
<context>
    <name>SafetyCopy</name>
    <message>
        <source>another program has changed it</source>
        <translation>un autre programme l’a modifié</translation>
    </message>
    <message>
        <source>a change of the tree is too large</source>
        <translation>une modification de l’arbre est trop grande</translation>
    </message>
    <message>
        <source>it is not up to date</source>
        <translation>elle n’est pas à jour</translation>
    </message>
    <message>
        <source>what was done last cannot be brought back</source>
        <translation>ce qui a été fait en dernier ne peut pas être récupéré</translation>
    </message>
</context>
<context>
    <name>SelectBudTool</name>
    <message>
        <source>Tap a bud, and it alone grows from now on; tap beside the tree to let all grow again</source>
        <translation>Toucher un bourgeon, et lui seul pousse désormais&#xa0;; toucher à côté de l’arbre pour que tous poussent à nouveau</translation>
    </message>
    <message>
        <source>There is no bud here. Buds near the pointer are shown as dots.</source>
        <translation>Il n’y a pas de bourgeon ici. Les bourgeons proches du pointeur apparaissent comme des points.</translation>
    </message>
    <message>
        <source>No bud is close enough. Tap one of the dots, or zoom in with the wheel.</source>
        <translation>Aucun bourgeon n’est aussi proche. Touchez l’un des points, ou approchez-vous avec la molette.</translation>
    </message>
</context>
<context>
    <name>Skeleton</name>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>elle est trop longue</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>%1 nombres sont attendus</translation>
    </message>
    <message>
        <source>“%1” is not a number for %2</source>
        <translation>« %1 » n’est pas un nombre pour %2</translation>
    </message>
    <message>
        <source>its id %1 is already used in line %2</source>
        <translation>son id %1 est aussi celui de la ligne %2</translation>
    </message>
    <message>
        <source>its parent, id %1, does not exist</source>
        <translation>l’id %1, son parent, n’existe pas</translation>
    </message>
    <message>
        <source>it is its own ancestor</source>
        <translation>elle est portée par ce qu’elle porte</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>se trouve à plus de %1 m</translation>
    </message>
    <message>
        <source>its radius is not between 0 and %1 m</source>
        <translation>le rayon n’est pas entre 0 et %1 m</translation>
    </message>
    <message>
        <source>“%1” is expected</source>
        <translation>« %1 » est attendu</translation>
    </message>
    <message>
        <source>a tree of more than %1 segments cannot be imported</source>
        <translation>un arbre de plus de %1 segments ne peut pas être importé</translation>
    </message>
    <message>
        <source>there are no segments</source>
        <translation>il n’y a pas de segments</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>segment %1</translation>
    </message>
    <message>
        <source>it stands more than %1 m from the thickest trunk</source>
        <translation>se dresse à plus de %1 m du tronc le plus épais</translation>
    </message>
    <message>
        <source>it is longer than %1 m, or more than %2 m away</source>
        <translation>mesure plus de %1 m, ou se trouve à plus de %2 m</translation>
    </message>
    <message>
        <source>no segment has a length</source>
        <translation>aucun segment n’a de longueur</translation>
    </message>
</context>
<context>
    <name>Sketch</name>
    <message>
        <source>a trunk can only be drawn where nothing has grown</source>
        <translation>un tronc ne peut être dessiné que là où rien n’a poussé</translation>
    </message>
    <message>
        <source>the stroke has no length</source>
        <translation>le trait n’a pas de longueur</translation>
    </message>
    <message>
        <source>the stroke is longer than %1 m, or more than %2 m away</source>
        <translation>le trait fait plus de %1 m, ou se trouve à plus de %2 m</translation>
    </message>
    <message>
        <source>only a tree with one root can be given depth</source>
        <translation>seul un arbre à une racine peut recevoir une profondeur</translation>
    </message>
    <message>
        <source>the tree has depth already</source>
        <translation>l’arbre a déjà une profondeur</translation>
    </message>
    <message>
        <source>draw branches first: a trunk alone has no depth to find</source>
        <translation>dessinez d’abord des branches : un tronc seul n’a pas de profondeur à trouver</translation>
    </message>
    <message>
        <source>the wood that it would grow from is gone</source>
        <translation>le bois dont elle partirait n’existe plus</translation>
    </message>
    <message>
        <source>the copies would have more than %1 internodes</source>
        <translation>les copies auraient plus de %1 entre-nœuds</translation>
    </message>
    <message>
        <source>a copy would reach more than %1 m away</source>
        <translation>une copie irait à plus de %1 m</translation>
    </message>
    <message>
        <source>internode %1 is not alive</source>
        <translation>l’entre-nœud %1 n’est pas vivant</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries no branch to imitate</source>
        <translation>la branche de l’entre-nœud %1 ne porte aucune branche à imiter</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries nothing to copy</source>
        <translation>la branche de l’entre-nœud %1 ne porte rien à copier</translation>
    </message>
    <message>
        <source>more than %1 branches are listed</source>
        <translation>plus de %1 branches sont énumérées</translation>
    </message>
    <message>
        <source>there is no other branch to copy to</source>
        <translation>il n’y a pas d’autre branche où copier</translation>
    </message>
    <message>
        <source>all other branches are too short for what the branch of internode %1 carries</source>
        <translation>toutes les autres branches sont trop courtes pour ce que porte celle de l’entre-nœud %1</translation>
    </message>
    <message>
        <source>an internode would be longer than %1 m or lie more than %2 m away</source>
        <translation>un entre-nœud dépasserait %1 m ou serait à plus de %2 m</translation>
    </message>
    <message>
        <source>the new trunk has no length</source>
        <translation>le nouveau tronc n’a pas de longueur</translation>
    </message>
    <message>
        <source>the silhouette encloses nothing</source>
        <translation>la silhouette n’enclot rien</translation>
    </message>
    <message>
        <source>a trunk cannot be moved</source>
        <translation>un tronc ne peut pas être déplacé</translation>
    </message>
    <message>
        <source>a branch cannot stand on itself</source>
        <translation>une branche ne peut pas se porter elle-même</translation>
    </message>
    <message>
        <source>a branch can be made %1 to %2 times as large</source>
        <translation>une branche peut devenir de %1 à %2 fois plus grande</translation>
    </message>
</context>
<context>
    <name>SketchTool</name>
    <message>
        <source>Draw the trunk, then branches; two strokes side by side give a branch its width</source>
        <translation>Dessinez le tronc, puis des branches ; deux traits côte à côte donnent son épaisseur à une branche</translation>
    </message>
    <message>
        <source>Draw a branch from the wood; hold Shift and draw across branches to take them away</source>
        <translation>Dessinez une branche depuis le bois ; avec Maj, un trait en travers enlève les branches</translation>
    </message>
    <message>
        <source>Two sides of one branch</source>
        <translation>Deux côtés d’une branche</translation>
    </message>
    <message>
        <source>A leaf</source>
        <translation>Une feuille</translation>
    </message>
    <message>
        <source>A crown</source>
        <translation>Une couronne</translation>
    </message>
</context>
<context>
    <name>StrandProfile</name>
    <message>
        <source>an outline needs at least three points</source>
        <translation>un contour a besoin d’au moins trois points</translation>
    </message>
    <message>
        <source>an outline reaches too far</source>
        <translation>un contour va trop loin</translation>
    </message>
    <message>
        <source>it has no outline</source>
        <translation>il n’a pas de contour</translation>
    </message>
    <message>
        <source>it has more than %1 outlines or %2 points</source>
        <translation>il a plus de %1 contours ou de %2 points</translation>
    </message>
    <message>
        <source>it has more than %1 attractors</source>
        <translation>il a plus de %1 attracteurs</translation>
    </message>
    <message>
        <source>an attractor lies too far away</source>
        <translation>un attracteur est trop éloigné</translation>
    </message>
    <message>
        <source>its outline crosses itself</source>
        <translation>son contour se croise lui-même</translation>
    </message>
    <message>
        <source>its outlines cross each other</source>
        <translation>ses contours se croisent</translation>
    </message>
    <message>
        <source>its outline has no area</source>
        <translation>son contour n’a pas de surface</translation>
    </message>
</context>
<context>
    <name>SunTool</name>
    <message>
        <source>%1° high</source>
        <translation>%1° de haut</translation>
    </message>
    <message>
        <source>Drag the sun around the tree</source>
        <translation>Faire glisser le soleil autour de l’arbre.</translation>
    </message>
</context>
<context>
    <name>Tree</name>
    <message>
        <source>its internode is missing</source>
        <translation>son entre-nœud manque</translation>
    </message>
    <message>
        <source>it is out of order</source>
        <translation>elle n’est pas à sa place</translation>
    </message>
    <message>
        <source>its place of attachment is out of range</source>
        <translation>son point d’attache est hors limites</translation>
    </message>
    <message>
        <source>its rotation is not valid</source>
        <translation>sa rotation n’en est pas une</translation>
    </message>
    <message>
        <source>its length is out of range</source>
        <translation>sa longueur est hors limites</translation>
    </message>
    <message>
        <source>its vigour is out of range</source>
        <translation>sa vigueur est hors limites</translation>
    </message>
    <message>
        <source>it grows from a bud that does not exist</source>
        <translation>il pousse d’un bourgeon qui n’existe pas</translation>
    </message>
    <message>
        <source>it has a bud that does not exist</source>
        <translation>il a un bourgeon qui n’existe pas</translation>
    </message>
    <message>
        <source>its kind is not known</source>
        <translation>son type est inconnu</translation>
    </message>
    <message>
        <source>its width is out of range</source>
        <translation>son épaisseur est hors limites</translation>
    </message>
    <message>
        <source>its root lies too far away</source>
        <translation>sa racine est trop éloignée</translation>
    </message>
    <message>
        <source>its parent does not come before it</source>
        <translation>son parent ne vient pas avant lui</translation>
    </message>
    <message>
        <source>its parameters are missing</source>
        <translation>ses paramètres manquent</translation>
    </message>
    <message>
        <source>it was born in the future</source>
        <translation>il est né dans le futur</translation>
    </message>
    <message>
        <source>it died before it was born, or in the future</source>
        <translation>sa mort précède sa naissance, ou se situe dans le futur</translation>
    </message>
    <message>
        <source>it lives on a dead internode</source>
        <translation>il vit sur un entre-nœud mort</translation>
    </message>
    <message>
        <source>the columns of the tree have different lengths</source>
        <translation>les colonnes de l’arbre ont des longueurs différentes</translation>
    </message>
    <message>
        <source>the tree is empty or lacks its parameters</source>
        <translation>l’arbre est vide ou ses paramètres manquent</translation>
    </message>
    <message>
        <source>the tree has more than %1 parameter sets</source>
        <translation>l’arbre a plus de %1 jeux de paramètres</translation>
    </message>
    <message>
        <source>the seedling must stand at the base</source>
        <translation>la plantule doit se trouver à la base</translation>
    </message>
    <message>
        <source>two internodes continue the same axis</source>
        <translation>deux entre-nœuds prolongent le même axe</translation>
    </message>
    <message>
        <source>another internode has its key</source>
        <translation>un autre entre-nœud a la même clé</translation>
    </message>
    <message>
        <source>internode %1: %2</source>
        <translation>entre-nœud %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>the columns of the placed leaves have different lengths</source>
        <translation>les colonnes des feuilles placées ont des longueurs différentes</translation>
    </message>
    <message>
        <source>placed leaf %1: %2</source>
        <translation>feuille placée %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>entry %1 of “%2”: %3</source>
        <translation>entrée %1 de «&#xa0;%2&#xa0;»&#xa0;: %3</translation>
    </message>
    <message>
        <source>lasso %1: its plane or its points are not valid</source>
        <translation>lasso %1&#xa0;: son plan ou ses points ne sont pas valables</translation>
    </message>
    <message>
        <source>the lassos in force are out of order</source>
        <translation>les lassos en vigueur sont dans le désordre</translation>
    </message>
    <message>
        <source>profile %1: %2</source>
        <translation>profil %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>its profile is missing</source>
        <translation>son profil manque</translation>
    </message>
    <message>
        <source>its twist is out of range</source>
        <translation>sa torsade est hors limites</translation>
    </message>
    <message>
        <source>its added vigour is out of range</source>
        <translation>sa vigueur ajoutée est hors limites</translation>
    </message>
    <message>
        <source>the length that is kept clear is out of range</source>
        <translation>la longueur dégagée est hors limites</translation>
    </message>
    <message>
        <source>the length that was drawn is out of range</source>
        <translation>la longueur dessinée est hors limites</translation>
    </message>
</context>
<context>
    <name>TwistTool</name>
    <message>
        <source>%1° from node to node</source>
        <translation>%1° d’un nœud à l’autre</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands; double-tap to untwist them</source>
        <translation>Faire glisser le long d’une branche, ou autour d’elle, pour torsader ses brins&#xa0;; toucher deux fois pour les détordre</translation>
    </message>
</context>
<context>
    <name>WidthTool</name>
    <message>
        <source>Tap a branch to fix its width; drag the ends of the handle to change it</source>
        <translation>Toucher une branche pour fixer son épaisseur&#xa0;; tirer les bouts de la poignée pour la changer</translation>
    </message>
</context>
<context>
    <name>WithinMemory</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Il n’y a pas assez de mémoire pour cela.</translation>
    </message>
</context>
<context>
    <name>ZipArchive</name>
    <message>
        <source>the archive could not be compressed: %1</source>
        <translation>l’archive n’a pas pu être compressée&#xa0;: %1</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>le contenu est endommagé</translation>
    </message>
    <message>
        <source>it is not a project file, or a damaged one (%1)</source>
        <translation>ce n’est pas un fichier de projet, ou il est endommagé (%1)</translation>
    </message>
    <message>
        <source>it is not a project file: it is empty</source>
        <translation>ce n’est pas un fichier de projet&#xa0;: il est vide</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>cela manque</translation>
    </message>
    <message>
        <source>it has %1 bytes, but %2 are expected</source>
        <translation>il y a %1 octets, mais %2 sont attendus</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>la taille dépasse %1 octets</translation>
    </message>
    <message>
        <source>it claims to hold far more than its size allows</source>
        <translation>il prétend contenir bien plus que sa taille ne le permet</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherController</name>
    <message>
        <source>Draw a tree first: then there can be others like it.</source>
        <translation>Dessinez d’abord un arbre : il pourra alors y en avoir d’autres comme lui.</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>Un autre comme celui-ci</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherPanel</name>
    <message>
        <source>Another Like This</source>
        <translation>Un autre comme celui-ci</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Tree %1 of %2</source>
        <translation>Arbre %1 sur %2</translation>
    </message>
    <message>
        <source>Take this tree in place of yours. Undo brings yours back.</source>
        <translation>Prendre cet arbre à la place du vôtre. Annuler ramène le vôtre.</translation>
    </message>
    <message>
        <source>Six More</source>
        <translation>Six autres</translation>
    </message>
    <message>
        <source>They are growing…</source>
        <translation>Ils poussent…</translation>
    </message>
    <message>
        <source>The same strokes; only chance differs.</source>
        <translation>Les mêmes traits ; seul le hasard diffère.</translation>
    </message>
</context>
<context>
    <name>espalier::ArchitecturePanel</name>
    <message>
        <source>Architecture</source>
        <translation>Architecture</translation>
    </message>
    <message>
        <source>More ›</source>
        <translation>Plus ›</translation>
    </message>
    <message>
        <source>Everything else that steers growth: shoots, shade, room to grow</source>
        <translation>Le reste de ce qui guide la croissance&#xa0;: pousses, ombrage, place disponible</translation>
    </message>
    <message>
        <source>‹ Less</source>
        <translation>‹ Moins</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Espèce</translation>
    </message>
    <message>
        <source>Set all parameters of the vigour model to those of a species.</source>
        <translation>Règle tout ce que suit le modèle de vigueur, comme pousse une espèce</translation>
    </message>
    <message>
        <source>No species</source>
        <translation>Aucune espèce</translation>
    </message>
</context>
<context>
    <name>espalier::Autosave</name>
    <message>
        <source>A tree that was never saved</source>
        <translation>Un arbre jamais enregistré</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>Impossible d’écrire dans le dossier %1.</translation>
    </message>
</context>
<context>
    <name>espalier::BackgroundPanel</name>
    <message>
        <source>Background</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>The colour of the background, or of its lower edge.</source>
        <translation>La couleur, ou celle au bord inférieur.</translation>
    </message>
    <message>
        <source>The colour at the upper edge.</source>
        <translation>La couleur au bord supérieur.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Soleil</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Show no picture behind the tree.</source>
        <translation>Ne montrer aucune image derrière l’arbre.</translation>
    </message>
    <message>
        <source>Lower colour</source>
        <translation>Couleur du bas</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Upper colour</source>
        <translation>Couleur du haut</translation>
    </message>
    <message>
        <source>Use for New Trees</source>
        <translation>Pour les nouveaux arbres</translation>
    </message>
    <message>
        <source>New trees begin with this background, ground and light. The picture stays with this tree.</source>
        <translation>Les nouveaux arbres commencent avec cet arrière-plan, ce sol et cette lumière. L’image reste avec cet arbre.</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>Image de référence</translation>
    </message>
    <message>
        <source>Choose a picture to show behind the tree while you draw. It is saved with the tree.</source>
        <translation>Choisir une image à montrer derrière l’arbre pendant que vous dessinez. Elle est enregistrée avec l’arbre.</translation>
    </message>
</context>
<context>
    <name>espalier::BendPopOut</name>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Stiffness&lt;/b&gt;&lt;br&gt;How much a branch resists being bent: a stiff one bends in a wide curve and is stretched sooner.</source>
        <translation>&lt;b&gt;Raideur&lt;/b&gt;&lt;br&gt;À quel point une branche résiste à la courbure&#xa0;: raide, elle fait une large courbe et s’étire plus tôt.</translation>
    </message>
    <message>
        <source>Holds length</source>
        <translation>Garde sa longueur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds length&lt;/b&gt;&lt;br&gt;How much a branch resists being stretched: at low values it follows the hand further.</source>
        <translation>&lt;b&gt;Garde sa longueur&lt;/b&gt;&lt;br&gt;À quel point une branche résiste à l’étirement&#xa0;: elle garde sa longueur, ou suit la main plus loin.</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
</context>
<context>
    <name>espalier::BranchingDiagram</name>
    <message>
        <source>zigzag</source>
        <translation>zigzag</translation>
    </message>
    <message>
        <source>acute</source>
        <translation>aigu</translation>
    </message>
    <message>
        <source>spreading</source>
        <translation>étalé</translation>
    </message>
    <message>
        <source>reflexed</source>
        <translation>réfléchi</translation>
    </message>
</context>
<context>
    <name>espalier::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stylet</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pressure curve&lt;/b&gt;&lt;br&gt;How firmly the pen must press for the full radius. Drag the curve, or press here with your pen to try it.</source>
        <translation>&lt;b&gt;Courbe de pression&lt;/b&gt;&lt;br&gt;Avec quelle fermeté le stylet doit appuyer pour atteindre le rayon entier. Faire glisser la courbe, ou appuyer ici avec le stylet pour essayer.</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
</context>
<context>
    <name>espalier::BrushRadius</name>
    <message>
        <source>&lt;b&gt;Brush radius&lt;/b&gt; [ ]&lt;br&gt;A large brush grows a crown into the space it passes; towards zero it draws a single branch exactly along the stroke.</source>
        <translation>&lt;b&gt;Rayon du pinceau&lt;/b&gt; [ ]&lt;br&gt;Un grand pinceau fait pousser un houppier dans l’espace où il passe&#xa0;; près de zéro, il trace une seule branche en suivant exactement le trait.</translation>
    </message>
    <message>
        <source>draws a branch</source>
        <translation>trace une branche</translation>
    </message>
    <message>
        <source>grows a crown</source>
        <translation>forme un houppier</translation>
    </message>
</context>
<context>
    <name>espalier::DirectionDiagram</name>
    <message>
        <source>Weights of direction</source>
        <translation>Poids des directions</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>équilibré</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>tropism</source>
        <translation>tropisme</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>espace libre</translation>
    </message>
    <message>
        <source>H straight on</source>
        <translation>H tout droit</translation>
    </message>
    <message>
        <source>T tropism</source>
        <translation>T tropisme</translation>
    </message>
    <message>
        <source>E space</source>
        <translation>E espace</translation>
    </message>
</context>
<context>
    <name>espalier::DocumentFile</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
</context>
<context>
    <name>espalier::ExportQueue</name>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Writing %1, then %2</source>
        <translation>Écriture de %1, puis de %2</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 n’a pas été écrit.</translation>
    </message>
    <message>
        <source>Not exported. %1</source>
        <translation>Non exporté. %1</translation>
    </message>
</context>
<context>
    <name>espalier::FileController</name>
    <message>
        <source>Not saved. %1</source>
        <translation>Non enregistré. %1</translation>
    </message>
    <message>
        <source>No safety copy can be saved: %1</source>
        <translation>L’arbre ne peut pas être protégé d’un plantage&#xa0;: %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 est enregistré</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Aucun encore</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Les oublier</translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. The tree is still here; save it to keep it.</source>
        <translation>%1 a été déplacé ou supprimé par un autre programme. L’arbre est encore ici&#xa0;; l’enregistrer pour le garder.</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program. Saving here asks before it replaces that version.</source>
        <translation>%1 a été modifié par une autre fenêtre ou un autre programme. Enregistrer ici demandera confirmation avant de remplacer ces modifications.</translation>
    </message>
    <message>
        <source>Open Again</source>
        <translation>Rouvrir</translation>
    </message>
    <message>
        <source>Keep This</source>
        <translation>Garder celui-ci</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
</context>
<context>
    <name>espalier::GravimorphismDiagram</name>
    <message>
        <source>all alike</source>
        <translation>tous égaux</translation>
    </message>
    <message>
        <source>amphitony</source>
        <translation>amphitonie</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>vertical</translation>
    </message>
    <message>
        <source>epitony</source>
        <translation>épitonie</translation>
    </message>
    <message>
        <source>hypotony</source>
        <translation>hypotonie</translation>
    </message>
    <message>
        <source>side %1</source>
        <translation>côté %1</translation>
    </message>
    <message>
        <source>above %1 · below %2</source>
        <translation>dessus %1 · dessous %2</translation>
    </message>
</context>
<context>
    <name>espalier::GrowPopOut</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Jouer</translation>
    </message>
    <message>
        <source>Play what happened from here on, or all of it.</source>
        <translation>Jouer ce qui s’est passé à partir d’ici, ou tout</translation>
    </message>
    <message>
        <source>Hold to grow</source>
        <translation>Maintenir</translation>
    </message>
    <message>
        <source>A tap grows one step; hold to grow on. One hold is one undo step.</source>
        <translation>Un appui bref fait croître d’une étape&#xa0;; un appui prolongé continue. Chaque appui forme une seule étape d’annulation.</translation>
    </message>
    <message>
        <source>Steps to grow</source>
        <translation>Nombre d’étapes</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>étapes</translation>
    </message>
    <message>
        <source>Grow that many steps, as one undo step. Escape stops.</source>
        <translation>Croître d’autant d’étapes, en une seule étape d’annulation. Échap arrête.</translation>
    </message>
    <message>
        <source>Back: the tree ungrows, through all that you did. Forth: it comes back. Pull the handle well past the mark, and the tree grows. Far from the slider, or with Shift, a drag is finer.</source>
        <translation>En arrière : l’arbre décroît, à travers tout ce que vous avez fait. En avant : il revient. Tirez la poignée bien au-delà du repère, et l’arbre pousse. Loin du curseur, ou avec Maj, le réglage est plus fin.</translation>
    </message>
    <message>
        <source>New steps: %L1</source>
        <translation>Nouvelles étapes : %L1</translation>
    </message>
    <message>
        <source>Moment %L1 of %L2</source>
        <translation>Moment %L1 sur %L2</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>Jeune plant</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPage</name>
    <message>
        <source>Help page</source>
        <translation>Page de l’aide</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPanel</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Back to the previous page</source>
        <translation>Revenir à la page précédente</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Fermer l’aide</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>Fermer l’aide (Échap)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>Rechercher dans l’aide</translation>
    </message>
    <message>
        <source>Help pages</source>
        <translation>Pages de l’aide</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Play this recipe</source>
        <translation>Jouer cette recette</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Aucun résultat</translation>
    </message>
</context>
<context>
    <name>espalier::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>Plantule</translation>
    </message>
</context>
<context>
    <name>espalier::LassoPopOut</name>
    <message>
        <source>Regrow</source>
        <translation>Régénérer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Arrêter ici</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Enveloppe</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>&lt;b&gt;Regrow&lt;/b&gt;&lt;br&gt;Take the tree back to how it was before its envelope was drawn, and let it fill the envelope again with the parameters that are in force now. What you have done to it since is lost.</source>
        <translation>&lt;b&gt;Régénérer&lt;/b&gt;&lt;br&gt;Ramener l’arbre là où il en était avant que son enveloppe soit dessinée, et lui faire remplir à nouveau l’enveloppe avec les paramètres en vigueur maintenant. Ce qui lui a été fait depuis disparaît.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Remove&lt;/b&gt;&lt;br&gt;Take the envelope away; the tree stays as it grew.</source>
        <translation>&lt;b&gt;Retirer&lt;/b&gt;&lt;br&gt;Ôter l’enveloppe&#xa0;; l’arbre reste tel qu’il a poussé.</translation>
    </message>
    <message>
        <source>Keep what has grown. Escape takes it back instead.</source>
        <translation>Garder ce qui a poussé. Échap l’annule au contraire.</translation>
    </message>
    <message>
        <source>Show the envelope.</source>
        <translation>Afficher l’enveloppe.</translation>
    </message>
    <message>
        <source>Show the points of free space that the tree grows into.</source>
        <translation>Afficher les points d’espace libre dans lesquels l’arbre pousse.</translation>
    </message>
</context>
<context>
    <name>espalier::LeafChoices</name>
    <message>
        <source>Continue with</source>
        <translation>Continuer avec</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Une de plus</translation>
    </message>
    <message>
        <source>One more leaf at this place; all of them stand evenly around the branch.</source>
        <translation>Une feuille de plus à cet endroit&#xa0;; toutes se tiennent régulièrement autour de la branche.</translation>
    </message>
    <message>
        <source>Whorls</source>
        <translation>Verticilles</translation>
    </message>
    <message>
        <source>Whorls like this along the whole branch, at the same spacing.</source>
        <translation>De tels verticilles à cette distance, tout le long de la branche.</translation>
    </message>
    <message>
        <source>Alternate</source>
        <translation>Alternes</translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation>Opposées</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, all in one plane.</source>
        <translation>Des paires de feuilles le long de la branche, toutes dans un plan.</translation>
    </message>
    <message>
        <source>Decussate</source>
        <translation>Décussées</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, each across the one below it.</source>
        <translation>Des paires de feuilles le long de la branche, chacune en croix avec celle du dessous.</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryCards</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryController</name>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 est à la corbeille.</translation>
    </message>
    <message>
        <source>The system has no trash here. %1 is in %2 now.</source>
        <translation>Le système n’a pas de corbeille ici. %1 est maintenant dans %2.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryPanel</name>
    <message>
        <source>Keep This Tree</source>
        <translation>Garder cet arbre</translation>
    </message>
    <message>
        <source>Start from This</source>
        <translation>Partir de celui-ci</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Arbres</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Save the open tree in the library.</source>
        <translation>Enregistrer l’arbre ouvert dans la bibliothèque.</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>Retour à l’arbre</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>A new seedling that grows the way this tree does.</source>
        <translation>Une nouvelle plantule qui pousse comme cet arbre.</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Espèces</translation>
    </message>
    <message>
        <source>Your Trees</source>
        <translation>Mes arbres</translation>
    </message>
    <message>
        <source>No tree has a name like that.</source>
        <translation>Aucun ne porte ce nom.</translation>
    </message>
    <message>
        <source>No trees yet. “Keep This Tree” saves the open tree here.</source>
        <translation>Aucun encore. «&#xa0;Garder cet arbre&#xa0;» enregistre ici l’arbre ouvert.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Move to Trash</source>
        <translation>À la corbeille</translation>
    </message>
</context>
<context>
    <name>espalier::LookChoice</name>
    <message>
        <source>Choose an image…</source>
        <translation>Choisir une image…</translation>
    </message>
    <message>
        <source>A PNG or JPEG of one leaf, stalk down, on a transparent or plain background</source>
        <translation>Un PNG ou un JPEG d’une seule feuille, pétiole en bas, sans fond ou sur un fond uni</translation>
    </message>
    <message>
        <source>A PNG or JPEG of bark; normal and roughness maps found beside it are used, too</source>
        <translation>Un PNG ou un JPEG d’écorce&#xa0;; les cartes de normales et de rugosité placées à côté sont prises aussi</translation>
    </message>
    <message>
        <source>Your image: %1</source>
        <translation>Image personnelle&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>espalier::LookController</name>
    <message>
        <source>Image of a Leaf</source>
        <translation>Image de feuille</translation>
    </message>
    <message>
        <source>Image of Bark</source>
        <translation>Image d’écorce</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg)</source>
        <translation>Images (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Feuilles</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Écorce</translation>
    </message>
    <message>
        <source>Maps found beside it are used, too.</source>
        <translation>Les cartes qui se trouvent à côté ont été prises aussi.</translation>
    </message>
    <message>
        <source>What is %1 for?</source>
        <translation>À quoi sert %1 ?</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>Image de référence</translation>
    </message>
    <message>
        <source>This tree has had so many images that its file has no room for another one.</source>
        <translation>Cet arbre a eu tant d’images que son fichier n’a plus de place pour une autre.</translation>
    </message>
</context>
<context>
    <name>espalier::MainWindow</name>
    <message>
        <source>The tree has no room left to grow.</source>
        <translation>L’arbre n’a plus de place pour pousser.</translation>
    </message>
    <message>
        <source>%1[*] – Espalier</source>
        <translation>%1[*] – Espalier</translation>
    </message>
    <message>
        <source>Growing %1</source>
        <translation>Croissance&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not everything that the recipe names was found in the tree (%1 of %2 operations): %3</source>
        <translation>Opérations de la recette qui n’ont rien trouvé à faire, ou pas tout ce qu’elles nomment (%1 sur %2)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Building the wood from strands</source>
        <translation>Création du bois en brins</translation>
    </message>
    <message>
        <source>Growth has stopped: the tree has %L1 internodes, and the memory of this machine may not hold a larger one.</source>
        <translation>La croissance s’est arrêtée : l’arbre a %L1 entre-nœuds, et la mémoire de cette machine ne suffira peut-être pas pour un plus grand.</translation>
    </message>
    <message>
        <source>Allow More</source>
        <translation>Autoriser davantage</translation>
    </message>
    <message>
        <source>Leave It</source>
        <translation>En rester là</translation>
    </message>
    <message>
        <source>The oldest steps of the history were dropped, so that it takes no more than %1 MB.</source>
        <translation>Les plus anciennes étapes de l’historique ont été abandonnées, pour qu’il ne prenne pas plus de %1 Mo.</translation>
    </message>
</context>
<context>
    <name>espalier::Notice</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>espalier::ParameterRow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>espalier::PerceptionDiagram</name>
    <message>
        <source>dense</source>
        <translation>dense</translation>
    </message>
    <message>
        <source>ordinary</source>
        <translation>ordinaire</translation>
    </message>
    <message>
        <source>airy</source>
        <translation>aéré</translation>
    </message>
</context>
<context>
    <name>espalier::PictureController</name>
    <message>
        <source>Drawing the picture</source>
        <translation>Dessin de l’image</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>L’image est dans le presse-papiers.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Not saved. %1</source>
        <translation>Non enregistré. %1</translation>
    </message>
</context>
<context>
    <name>espalier::PictureSheet</name>
    <message>
        <source>Like the window, %1 × %2</source>
        <translation>Comme la fenêtre, %1 × %2</translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>Full HD, 1920 × 1080</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K, 3840 × 2160</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>Carré, 1080 × 1080</translation>
    </message>
    <message>
        <source>Large square, 2048 × 2048</source>
        <translation>Grand carré, 2048 × 2048</translation>
    </message>
    <message>
        <source>Portrait, 1080 × 1350</source>
        <translation>Portrait, 1080 × 1350</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Autre taille</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fond transparent</translation>
    </message>
    <message>
        <source>With the shadow on the ground</source>
        <translation>Avec l’ombre au sol</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>Comme affiché</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>De côté</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>Du dessus</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>De trois quarts</translation>
    </message>
    <message>
        <source>Nothing is behind the tree, so that it can be laid over other pictures.</source>
        <translation>Il n’y a rien derrière l’arbre, pour pouvoir le poser sur d’autres images.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Put the picture on the clipboard.</source>
        <translation>Placer l’image dans le presse-papiers.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
</context>
<context>
    <name>espalier::PressureCurve</name>
    <message>
        <source>Pressure curve</source>
        <translation>Courbe de pression</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileCanvas</name>
    <message>
        <source>Cross-section</source>
        <translation>Section</translation>
    </message>
    <message>
        <source>Draw an outline first: attractors gather the strands within it.</source>
        <translation>Dessiner d’abord un contour&#xa0;: les attracteurs rassemblent les brins à l’intérieur.</translation>
    </message>
    <message>
        <source>This cannot be the profile: %1.</source>
        <translation>Ceci ne peut pas être le profil&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Tap a branch of the tree to see its cross-section.</source>
        <translation>Toucher une branche de l’arbre pour voir sa section.</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileController</name>
    <message>
        <source>The two places are not on one branch.</source>
        <translation>Les deux endroits ne sont pas sur une même branche.</translation>
    </message>
    <message>
        <source>The other place has no profile to blend with.</source>
        <translation>L’autre endroit n’a pas de profil vers lequel interpoler.</translation>
    </message>
    <message>
        <source>There is no room for more profiles.</source>
        <translation>Il n’y a plus de place pour d’autres profils.</translation>
    </message>
</context>
<context>
    <name>espalier::ProfilePanel</name>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>&lt;b&gt;Outline&lt;/b&gt;&lt;br&gt;Draw a closed line. One beside another splits the wood; one within another is a hollow.</source>
        <translation>&lt;b&gt;Contour&lt;/b&gt;&lt;br&gt;Dessiner une ligne fermée. Une ligne à côté d’autres divise le bois, une ligne dans une autre est un creux.</translation>
    </message>
    <message>
        <source>Attractor</source>
        <translation>Attracteur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Attractor&lt;/b&gt;&lt;br&gt;Drag a straight line that the strands gather at.</source>
        <translation>&lt;b&gt;Attracteur&lt;/b&gt;&lt;br&gt;Tirer une ligne droite autour de laquelle les brins se rassemblent.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>&lt;b&gt;Points&lt;/b&gt;&lt;br&gt;Drag the points of an outline, or the ends of an attractor.</source>
        <translation>&lt;b&gt;Points&lt;/b&gt;&lt;br&gt;Tirer les points d’un contour, ou les bouts d’un attracteur.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gommer</translation>
    </message>
    <message>
        <source>&lt;b&gt;Erase&lt;/b&gt;&lt;br&gt;Tap a line to take it away. A pen&apos;s eraser does the same at any time.</source>
        <translation>&lt;b&gt;Gommer&lt;/b&gt;&lt;br&gt;Toucher une ligne pour l’ôter. La gomme d’un stylet fait de même à tout moment.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Ronde</translation>
    </message>
    <message>
        <source>Elongated</source>
        <translation>Allongée</translation>
    </message>
    <message>
        <source>C-shaped</source>
        <translation>En C</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Creuse</translation>
    </message>
    <message>
        <source>Split in two</source>
        <translation>Fendue en deux</translation>
    </message>
    <message>
        <source>Split in three</source>
        <translation>Fendue en trois</translation>
    </message>
    <message>
        <source>Fluted</source>
        <translation>Cannelée</translation>
    </message>
    <message>
        <source>Copy to branch</source>
        <translation>Copier sur la branche</translation>
    </message>
    <message>
        <source>&lt;b&gt;Copy to branch&lt;/b&gt;&lt;br&gt;Then tap another place on this branch: everything between gets this profile.</source>
        <translation>&lt;b&gt;Copier sur la branche&lt;/b&gt;&lt;br&gt;Toucher ensuite un autre endroit de cette branche&#xa0;: tout ce qui est entre les deux reçoit ce profil.</translation>
    </message>
    <message>
        <source>▼</source>
        <translation>▼</translation>
    </message>
    <message>
        <source>To the next place down the branch.</source>
        <translation>Vers l’endroit suivant en descendant la branche</translation>
    </message>
    <message>
        <source>▲</source>
        <translation>▲</translation>
    </message>
    <message>
        <source>To the next place up the branch.</source>
        <translation>Vers l’endroit suivant en remontant la branche</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Show the whole cross-section.</source>
        <translation>Afficher toute la section</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>&lt;b&gt;Clear&lt;/b&gt;&lt;br&gt;Take the profile away: the strands are packed round again.</source>
        <translation>&lt;b&gt;Retirer&lt;/b&gt;&lt;br&gt;Ôter le profil&#xa0;: les brins se tassent de nouveau en rond.</translation>
    </message>
    <message>
        <source>Down the branch</source>
        <translation>Vers le bas de la branche</translation>
    </message>
    <message>
        <source>Up the branch</source>
        <translation>Vers le haut de la branche</translation>
    </message>
    <message numerus="yes">
        <source>Radius %1 · %Ln strands</source>
        <translation>
            <numerusform>Rayon %1 · %Ln brin</numerusform>
            <numerusform>Rayon %1 · %Ln brins</numerusform>
        </translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Draw another closed line: beside the first to split the wood, within it for a hollow.</source>
        <translation>Dessiner une autre ligne fermée&#xa0;: à côté de la première pour diviser le bois, à l’intérieur pour un creux.</translation>
    </message>
    <message>
        <source>Draw a closed line, or begin with one of these shapes.</source>
        <translation>Dessiner une ligne fermée, ou partir de l’une de ces formes.</translation>
    </message>
    <message>
        <source>Drag a straight line: the strands gather at it.</source>
        <translation>Tirer une ligne droite&#xa0;: les brins se rassemblent autour d’elle.</translation>
    </message>
    <message>
        <source>Drag the points of a line.</source>
        <translation>Tirer les points d’une ligne.</translation>
    </message>
    <message>
        <source>Tap a line to take it away.</source>
        <translation>Toucher une ligne pour l’ôter.</translation>
    </message>
    <message>
        <source>Tap the other end on this branch, or go there with ▲ and ▼ and press the button again.</source>
        <translation>Toucher l’autre bout sur cette branche, ou y aller avec ▲ et ▼ et appuyer de nouveau sur le bouton.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Interpoler</translation>
    </message>
    <message>
        <source>&lt;b&gt;Blend&lt;/b&gt;&lt;br&gt;Then tap another place on this branch that has a profile: the sections between change from one to the other.</source>
        <translation>&lt;b&gt;Interpoler&lt;/b&gt;&lt;br&gt;Toucher ensuite un autre endroit de cette branche qui a un profil&#xa0;: entre les deux, on passe de l’un à l’autre.</translation>
    </message>
</context>
<context>
    <name>espalier::PrunePopOut</name>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw a line across several.</source>
        <translation>Touchez une branche pour la retirer, ou tracez une ligne en travers de plusieurs.</translation>
    </message>
    <message>
        <source>Keep clear</source>
        <translation>Dégager</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: the shoots below your hand are removed, and no new ones come. Drag the ring down again to let buds shoot.</source>
        <translation>Glissez vers le haut le long d’un tronc ou d’une branche : les pousses au-dessous de votre main partent, et il n’en vient plus. Redescendez l’anneau pour laisser pousser les bourgeons.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gommer</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are. Limbs stay.</source>
        <translation>Passez sur les rameaux et les feuilles pour les retirer, si profond qu’ils soient dans la couronne. Les grosses branches restent.</translation>
    </message>
    <message>
        <source>Thin out</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Brush over the crown to take out some of its twigs evenly.</source>
        <translation>Passez sur la couronne pour retirer une partie de ses rameaux, régulièrement.</translation>
    </message>
</context>
<context>
    <name>espalier::RadiusSlider</name>
    <message>
        <source>Brush radius</source>
        <translation>Rayon du pinceau</translation>
    </message>
</context>
<context>
    <name>espalier::Recovery</name>
    <message>
        <source>%1, but the file is no longer there</source>
        <translation>%1, mais le fichier n’y est plus</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>Illisible.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln internodes</source>
        <translation>
            <numerusform>%Ln entre-nœud</numerusform>
            <numerusform>%Ln entre-nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Changed by another program since</source>
        <translation>Modifié depuis par un autre programme</translation>
    </message>
    <message>
        <source>There is nothing to bring back: all was saved, or given up.</source>
        <translation>Il n’y a rien à récupérer : tout est enregistré ou abandonné.</translation>
    </message>
    <message>
        <source>Another tree can be brought back.</source>
        <translation>Un autre arbre peut être récupéré.</translation>
    </message>
    <message numerus="yes">
        <source>%n other trees can be brought back.</source>
        <translation>
            <numerusform>%n autre arbre peut être récupéré.</numerusform>
            <numerusform>%n autres arbres peuvent être récupérés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>The safety copy of %1 cannot be read. It is kept as %2.</source>
        <translation>La copie de sécurité de %1 est illisible. Elle est gardée sous %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n safety copies cannot be read. They are kept in %1.</source>
        <translation>
            <numerusform>%n copie de sécurité est illisible. Elle est gardée dans %1.</numerusform>
            <numerusform>%n copies de sécurité sont illisibles. Elles sont gardées dans %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::RecoveryRow</name>
    <message>
        <source>Bring Back</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>Dans le fichier</translation>
    </message>
    <message>
        <source>Can be brought back</source>
        <translation>Peut être récupéré</translation>
    </message>
    <message>
        <source>It will be deleted when this closes.</source>
        <translation>Sera supprimé à la fermeture.</translation>
    </message>
    <message>
        <source>Bring back %1</source>
        <translation>Récupérer %1</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>Abandonner %1</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Dessin en cours…</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Pas d’image</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
</context>
<context>
    <name>espalier::RecoverySheet</name>
    <message>
        <source>today, %1</source>
        <translation>aujourd’hui, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>hier, %1</translation>
    </message>
    <message>
        <source>Bring Trees Back</source>
        <translation>Récupérer des arbres</translation>
    </message>
    <message>
        <source>Espalier ended before this was saved. What you leave here is offered again at the next start.</source>
        <translation>Espalier s’est arrêté avant que cela soit enregistré. Ce que vous laissez ici sera proposé de nouveau au prochain démarrage.</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>espalier::ReportSheet</name>
    <message>
        <source>With the recipe of this tree</source>
        <translation>Avec la recette de cet arbre</translation>
    </message>
    <message>
        <source>Report a Problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>Copy this text, and add what you did and what happened. Espalier sends nothing by itself. Without the recipe, the text has nothing of your tree.</source>
        <translation>Copiez ce texte et ajoutez ce que vous avez fait et ce qui s’est passé. Espalier n’envoie rien de lui-même. Sans la recette, le texte ne contient rien de votre arbre.</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>Texte du rapport</translation>
    </message>
    <message>
        <source>All that was done to the tree, so that others can do it again.</source>
        <translation>Tout ce qui a été fait à l’arbre, pour que d’autres puissent le refaire.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>espalier::ReproduceController</name>
    <message>
        <source>Draw the new trunk, from its base to its tip.</source>
        <translation>Dessinez le nouveau tronc, du pied à la pointe.</translation>
    </message>
    <message>
        <source>Now draw the silhouette of the crown around its tip.</source>
        <translation>Dessinez maintenant la silhouette du houppier autour de sa pointe.</translation>
    </message>
    <message>
        <source>Now draw the trunk, with its tip inside the silhouette.</source>
        <translation>Dessinez maintenant le tronc, la pointe dans la silhouette.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>espalier::ReproducePopOut</name>
    <message>
        <source>Another</source>
        <translation>Un autre</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another&lt;/b&gt;&lt;br&gt;The same tree with slightly different angles and lengths, as it could stand beside it in a forest. As long as nothing else is done, the next one takes its place.</source>
        <translation>&lt;b&gt;Un autre&lt;/b&gt;&lt;br&gt;Le même arbre avec des angles et des longueurs un peu différents, comme il pourrait se tenir à côté dans une forêt. Tant que rien d’autre n’est fait, le suivant prend sa place.</translation>
    </message>
</context>
<context>
    <name>espalier::RingMenu</name>
    <message>
        <source>Tools around the pointer</source>
        <translation>Outils autour du pointeur</translation>
    </message>
</context>
<context>
    <name>espalier::RotationStrip</name>
    <message>
        <source>Rotation strip</source>
        <translation>Bande de rotation</translation>
    </message>
</context>
<context>
    <name>espalier::SceneController</name>
    <message>
        <source>Reference Picture</source>
        <translation>Image de référence</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message>
        <source>New trees will have this background, ground and light.</source>
        <translation>Les nouveaux arbres auront cet arrière-plan, ce sol et cette lumière.</translation>
    </message>
</context>
<context>
    <name>espalier::SettingsSheet</name>
    <message>
        <source>The middle button turns; with Shift it pans, with Ctrl it zooms. Alt with the left button turns, too.</source>
        <translation>Le bouton du milieu tourne, avec Maj il déplace, avec Ctrl il approche. Alt et le bouton gauche tournent aussi.</translation>
    </message>
    <message>
        <source>With Alt, the left button turns, the middle one pans and the right one zooms.</source>
        <translation>Alt et le bouton gauche tournent, Alt et celui du milieu déplacent, Alt et le droit approchent.</translation>
    </message>
    <message>
        <source>The right or middle button turns; Shift with the middle button pans. Alt with the left button turns, too.</source>
        <translation>Le bouton droit ou du milieu tourne, Maj et celui du milieu déplacent. Alt et le bouton gauche tournent aussi.</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Par défaut</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>On the left</source>
        <translation>À gauche</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>À droite</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>How firmly a pen must press for a large brush.</source>
        <translation>À quel point il faut appuyer le stylet pour un grand pinceau.</translation>
    </message>
    <message>
        <source>Press here with your pen to try it.</source>
        <translation>Appuyer ici avec le stylet pour essayer.</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Souple</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Ferme</translation>
    </message>
    <message>
        <source>Pen pressure</source>
        <translation>Pression du stylet</translation>
    </message>
    <message>
        <source>all</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Changer…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Undo steps kept</source>
        <translation>Étapes annulables</translation>
    </message>
    <message>
        <source>A change applies to the next tree that you begin or open.</source>
        <translation>Le nombre d’étapes vaut à partir du prochain arbre commencé ou ouvert.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>In Espalier&apos;s own folder</source>
        <translation>Dans un dossier propre à Espalier</translation>
    </message>
    <message>
        <source>Library Folder</source>
        <translation>Dossier de la bibliothèque</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Metres, centimetres</source>
        <translation>Mètres, centimètres</translation>
    </message>
    <message>
        <source>Feet, inches</source>
        <translation>Pieds, pouces</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Size of the interface</source>
        <translation>Taille de l’interface</translation>
    </message>
    <message>
        <source>Stroke stabiliser</source>
        <translation>Stabilisateur</translation>
    </message>
    <message>
        <source>A stroke follows the pointer at this distance, like a stone on a string, so it does not tremble.</source>
        <translation>Le trait suit le pointeur à cette distance, comme une pierre au bout d’un fil : il ne tremble pas.</translation>
    </message>
    <message>
        <source>A stroke lags this far behind the pointer, and is smoother.</source>
        <translation>Le trait suit le pointeur avec ce retard, et plus doucement.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>Takes effect the next time Espalier starts.</source>
        <translation>Prend effet au prochain démarrage d’Espalier.</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Mémoire de l’historique</translation>
    </message>
    <message>
        <source>If the history takes more, its oldest steps go.</source>
        <translation>Si l’historique en prend plus, ses plus anciennes étapes disparaissent.</translation>
    </message>
</context>
<context>
    <name>espalier::SizeChoices</name>
    <message>
        <source>Bonsai</source>
        <translation>Bonsaï</translation>
    </message>
    <message>
        <source>Shrub</source>
        <translation>Arbuste</translation>
    </message>
    <message>
        <source>Street Tree</source>
        <translation>Arbre de rue</translation>
    </message>
    <message>
        <source>Forest Tree</source>
        <translation>Arbre de forêt</translation>
    </message>
    <message>
        <source>Size of the new tree</source>
        <translation>Taille du nouvel arbre</translation>
    </message>
    <message>
        <source>How tall should the new tree grow?</source>
        <translation>Quelle hauteur aura le nouvel arbre ?</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;About %2 tall; the brush, the branches and the leaves are in proportion.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Environ %2 de haut ; le pinceau, les branches et les feuilles sont en proportion.</translation>
    </message>
</context>
<context>
    <name>espalier::SketchController</name>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>espalier::SketchPopOut</name>
    <message>
        <source>Give depth</source>
        <translation>Donner la profondeur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Give depth&lt;/b&gt;&lt;br&gt;The branches of the drawing spread into depth, as far from each other as they can. From the front the tree looks as you drew it.</source>
        <translation>&lt;b&gt;Donner la profondeur&lt;/b&gt;&lt;br&gt;Les branches du dessin s’écartent en profondeur, aussi loin que possible les unes des autres. De face, l’arbre reste tel que vous l’avez dessiné.</translation>
    </message>
    <message>
        <source>Another depth</source>
        <translation>Autre profondeur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another depth&lt;/b&gt;&lt;br&gt;Choose new depths for the branches.</source>
        <translation>&lt;b&gt;Autre profondeur&lt;/b&gt;&lt;br&gt;Choisir à nouveau la profondeur des branches.</translation>
    </message>
</context>
<context>
    <name>espalier::TopBar</name>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 a des modifications non enregistrées.</translation>
    </message>
</context>
<context>
    <name>espalier::Tour</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Back in time</source>
        <translation>Remonter le temps</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Tout autour</translation>
    </message>
    <message>
        <source>When you wonder</source>
        <translation>En cas de doute</translation>
    </message>
    <message>
        <source>&lt;b&gt;F1&lt;/b&gt; or this button tells you about the tool in your hand. &lt;b&gt;Ctrl+Z&lt;/b&gt; takes back whatever you did, so try things.</source>
        <translation>&lt;b&gt;F1&lt;/b&gt; ou ce bouton parle de l’outil en main. &lt;b&gt;Ctrl+Z&lt;/b&gt; annule tout ce que vous avez fait&#xa0;: essayez donc.</translation>
    </message>
    <message>
        <source>Draw a tree</source>
        <translation>Dessiner un arbre</translation>
    </message>
    <message>
        <source>Draw a trunk</source>
        <translation>Tracer un tronc</translation>
    </message>
    <message>
        <source>Draw a branch</source>
        <translation>Tracer une branche</translation>
    </message>
    <message>
        <source>Here is a seedling. &lt;b&gt;Press on it and draw a line upward&lt;/b&gt;, to the middle of the picture or higher: it becomes the trunk.</source>
        <translation>Voici une plantule. &lt;b&gt;Appuyez dessus et tracez une ligne vers le haut&lt;/b&gt;, jusqu’au milieu de l’image ou plus haut : ce sera le tronc.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a branch and draw outward&lt;/b&gt;: the line becomes a branch.</source>
        <translation>&lt;b&gt;Appuyez sur une branche et tracez vers l’extérieur&lt;/b&gt; : la ligne devient une branche.</translation>
    </message>
    <message>
        <source>Draw the limbs</source>
        <translation>Tracer les branches</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on the trunk and draw outward and up&lt;/b&gt;, to the left and to the right. Three limbs or four are enough.</source>
        <translation>&lt;b&gt;Appuyez sur le tronc et tracez vers l’extérieur et vers le haut&lt;/b&gt;, à gauche et à droite. Trois ou quatre branches suffisent.</translation>
    </message>
    <message>
        <source>Small and large</source>
        <translation>Petit et grand</translation>
    </message>
    <message>
        <source>A tiny brush draws a single branch, a large one grows a crown. &lt;b&gt;Drag the slider upward, or press&amp;nbsp;]&lt;/b&gt;; [ makes the brush smaller.</source>
        <translation>Un pinceau minuscule trace une seule branche, un grand fait pousser un houppier. &lt;b&gt;Glissez le curseur vers le haut, ou appuyez sur&amp;nbsp;]&lt;/b&gt; ; [ rapetisse le pinceau.</translation>
    </message>
    <message>
        <source>Grow a crown</source>
        <translation>Faire pousser un houppier</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a limb and draw slowly along the limbs and around their ends&lt;/b&gt;: twigs and leaves grow wherever the brush passes.</source>
        <translation>&lt;b&gt;Appuyez sur une branche et passez lentement le long des branches et autour de leurs extrémités&lt;/b&gt; : rameaux et feuilles poussent partout où passe le pinceau.</translation>
    </message>
    <message>
        <source>Prune, bend, draw with a lasso: what a gardener needs is here. &lt;b&gt;Choose Grow&lt;/b&gt;.</source>
        <translation>Tailler, courber, dessiner au lasso : tout ce qu’il faut à un jardinier est ici. &lt;b&gt;Choisissez Croître&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag this slider to the left&lt;/b&gt;, and the tree ungrows; drag it back to the right, and the tree is there again.</source>
        <translation>&lt;b&gt;Glissez ce curseur vers la gauche&lt;/b&gt;, et l’arbre décroît ; ramenez-le à droite, et l’arbre est de nouveau là.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag along this edge&lt;/b&gt;, and the tree turns, even while your other hand brushes. The right mouse button turns it as well.</source>
        <translation>&lt;b&gt;Glissez le long de ce bord&lt;/b&gt;, et l’arbre tourne, même pendant que l’autre main peint. Le bouton droit de la souris le tourne aussi.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Choose Sketch&lt;/b&gt; to draw a trunk and branches as on paper, and give the drawing depth. Watch how thirty strokes become a tree.</source>
        <translation>&lt;b&gt;Choisissez Esquisse&lt;/b&gt; pour dessiner un tronc et des branches comme sur le papier, et donner de la profondeur au dessin. Voyez comment trente traits deviennent un arbre.</translation>
    </message>
</context>
<context>
    <name>espalier::TourCard</name>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Regarder</translation>
    </message>
</context>
<context>
    <name>espalier::TropismDiagram</name>
    <message>
        <source>as the stroke</source>
        <translation>selon le trait</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>dressé</translation>
    </message>
    <message>
        <source>slanting</source>
        <translation>oblique</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>weeping</source>
        <translation>pleureur</translation>
    </message>
</context>
<context>
    <name>espalier::Viewport</name>
    <message>
        <source>Tree</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>De droite</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
</context>
<context>
    <name>espalier::Workspace</name>
    <message>
        <source>Only one bud grows  ✕</source>
        <translation>Une seule branche pousse  ✕</translation>
    </message>
    <message>
        <source>Let all buds grow again.</source>
        <translation>Laisser à nouveau pousser tous les bourgeons</translation>
    </message>
    <message>
        <source>a seedling</source>
        <translation>une plantule</translation>
    </message>
    <message>
        <source>%L1 internodes · %L2 leaves · step %L3</source>
        <translation>%L1 entre-nœuds · %L2 feuilles · étape %L3</translation>
    </message>
    <message>
        <source>Back to My Tree</source>
        <translation>Revenir à mon arbre</translation>
    </message>
    <message>
        <source>Show your own tree again, as it was before this recipe was played.</source>
        <translation>Montrer de nouveau votre arbre, tel qu’il était avant cette recette</translation>
    </message>
</context>
</TS>
