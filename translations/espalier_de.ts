<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Start with a seedling.</source>
        <translation>Mit einem Sämling beginnen.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open a project or a recipe.</source>
        <translation>Ein Projekt oder ein Rezept öffnen.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>Das Projekt speichern.</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save the project under another name.</source>
        <translation>Das Projekt unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write the tree for other programs: GLB, FBX, OBJ, or its skeleton as CSV.</source>
        <translation>Den Baum für andere Programme schreiben: GLB, FBX, OBJ, oder sein Skelett als CSV.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Leave Espalier.</source>
        <translation>Espalier verlassen.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take back what you did last.</source>
        <translation>Zurücknehmen, was zuletzt getan wurde.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Nochmals</translation>
    </message>
    <message>
        <source>Do again what you took back.</source>
        <translation>Zurückgenommenes noch einmal tun.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Drag from the tree outward: it grows into the space that the brush passes through.</source>
        <translation>Vom Baum nach außen ziehen: Er wächst in den Raum, den der Pinsel durchstreift.</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Press anywhere and hold: the tree grows on its own, competing for light and space.</source>
        <translation>Irgendwo drücken und halten: Der Baum wächst von selbst, im Wettbewerb um Licht und Raum.</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw across all the branches to cut.</source>
        <translation>Einen Ast antippen, um ihn abzunehmen, oder quer über alles ziehen, was fallen soll.</translation>
    </message>
    <message>
        <source>Bud</source>
        <translation>Knospe</translation>
    </message>
    <message>
        <source>Tap a bud: from now on, only this bud grows, and what comes from it.</source>
        <translation>Eine Knospe antippen: Von nun an wächst nur sie, mit allem, was aus ihr entsteht.</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Pull a branch to bend it; tap it to pin it there.</source>
        <translation>An einem Ast ziehen, um ihn zu biegen; antippen, um festzulegen, wo er gehalten wird.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Tap a branch to fix its width, and drag the handle to change it.</source>
        <translation>Einen Ast antippen, um seine Dicke festzuhalten, und am Griff ziehen, um sie zu ändern.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw the silhouette of a crown: the tree grows until it fills that shape.</source>
        <translation>Den Umriss einer Krone zeichnen: Der Baum wächst, bis er ihn ausfüllt.</translation>
    </message>
    <message>
        <source>Grow One Step</source>
        <translation>Ein Wuchsschritt</translation>
    </message>
    <message>
        <source>Let the tree grow one step on its own.</source>
        <translation>Den Baum von selbst einen Schritt wachsen lassen.</translation>
    </message>
    <message>
        <source>Smaller Brush</source>
        <translation>Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush smaller, even while brushing.</source>
        <translation>Den Pinsel verkleinern, auch während des Pinselns.</translation>
    </message>
    <message>
        <source>Larger Brush</source>
        <translation>Größerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush larger, even while brushing.</source>
        <translation>Den Pinsel vergrößern, auch während des Pinselns.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Take back the stroke or the growth under way.</source>
        <translation>Den laufenden Strich oder das laufende Wachstum zurücknehmen.</translation>
    </message>
    <message>
        <source>Frame All</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Show the whole tree.</source>
        <translation>Den ganzen Baum zeigen.</translation>
    </message>
    <message>
        <source>From the Front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Look at the tree from the front.</source>
        <translation>Den Baum von vorn betrachten.</translation>
    </message>
    <message>
        <source>From the Side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>Look at the tree from the side.</source>
        <translation>Den Baum von der Seite betrachten.</translation>
    </message>
    <message>
        <source>From the Top</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Look down at the tree.</source>
        <translation>Auf den Baum hinabschauen.</translation>
    </message>
    <message>
        <source>Three-Quarter</source>
        <translation>Schräg von vorn</translation>
    </message>
    <message>
        <source>Look at the tree from between the front and the side.</source>
        <translation>Den Baum schräg von vorn betrachten.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads.</source>
        <translation>Die Punkte freien Raums zeigen, die der Pinsel verteilt.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>Show the leaves.</source>
        <translation>Die Blätter zeigen.</translation>
    </message>
    <message>
        <source>Architecture</source>
        <translation>Architektur</translation>
    </message>
    <message>
        <source>How the tree grows from now on.</source>
        <translation>Wie der Baum von nun an wächst.</translation>
    </message>
    <message>
        <source>What the leaves look like.</source>
        <translation>Wie die Blätter aussehen.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Äste</translation>
    </message>
    <message>
        <source>How thick branches are, and their bark.</source>
        <translation>Wie dick die Äste sind, und ihre Rinde.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>What is around the tree: background, ground, sun, reference picture.</source>
        <translation>Was um den Baum herum ist: Hintergrund, Boden, Sonne, eine Bildvorlage.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Everything you did, step by step; click a step to go back to it.</source>
        <translation>Alles Getane, Schritt für Schritt; ein Klick führt dorthin.</translation>
    </message>
    <message>
        <source>Focus Panels or Tree</source>
        <translation>Zu den Bedienfeldern und zurück</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the panels, or back to the tree.</source>
        <translation>Die Tastatur den Bedienfeldern geben oder zurück dem Baum.</translation>
    </message>
    <message>
        <source>Only the Tree</source>
        <translation>Nur der Baum</translation>
    </message>
    <message>
        <source>Hide everything but the tree; the same key brings everything back.</source>
        <translation>Alles außer dem Baum ausblenden; dieselbe Taste holt es zurück.</translation>
    </message>
    <message>
        <source>Full Screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Fill the whole screen.</source>
        <translation>Den ganzen Bildschirm füllen.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Help on the current tool, and on everything else.</source>
        <translation>Über das Werkzeug in der Hand und über alles andere.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Species to start from, and the trees you keep.</source>
        <translation>Arten zum Beginnen und die eigenen Bäume.</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>How Espalier looks, and how it responds to your hand.</source>
        <translation>Wie Espalier aussieht und wie es auf die Hand reagiert.</translation>
    </message>
    <message>
        <source>Size of the brush, pressure of the pen, and what is shown while you brush.</source>
        <translation>Größe des Pinsels, Druck des Stifts und der Wuchsraum, den der Pinsel verteilt.</translation>
    </message>
    <message>
        <source>Save as Recipe…</source>
        <translation>Als Rezept speichern …</translation>
    </message>
    <message>
        <source>Save everything that was done to the tree, so that it can be done again.</source>
        <translation>Aufschreiben, was mit dem Baum gemacht wurde, damit es sich wiederholen lässt.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands.</source>
        <translation>An einem Ast entlang oder um ihn herum ziehen, um seine Stränge zu verdrehen.</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>Neutriebe</translation>
    </message>
    <message>
        <source>Tap old wood: buds break through its bark, and grow into branches.</source>
        <translation>Altes Holz antippen: Knospen brechen durch die Rinde und wachsen zu Ästen heran.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Tap a branch to see its cross-section, and draw its shape.</source>
        <translation>Einen Ast antippen, um seinen Querschnitt zu sehen und dessen Form zu zeichnen.</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>Kräftigen</translation>
    </message>
    <message>
        <source>Press a branch and hold: it alone grows until you let go.</source>
        <translation>Auf einen Ast drücken und halten: Nur er wächst, bis zum Loslassen.</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Einkürzen</translation>
    </message>
    <message>
        <source>Press a branch and hold: its youngest growth disappears, step by step.</source>
        <translation>Auf einen Ast drücken und halten: Sein jüngster Zuwachs verschwindet, Schritt für Schritt.</translation>
    </message>
    <message>
        <source>Show the strands of the wood as lines, each branch in its own colour.</source>
        <translation>Zeigt die Stränge, aus denen das Holz besteht, als Linien, jeden Ast in seiner Farbe.</translation>
    </message>
    <message>
        <source>Strand Lines</source>
        <translation>Stranglinien</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Skizze</translation>
    </message>
    <message>
        <source>Draw the trunk and its branches as lines, then give the drawing depth.</source>
        <translation>Stamm und Äste als Linien zeichnen, dann der Zeichnung Tiefe geben.</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Vermehren</translation>
    </message>
    <message>
        <source>Tap a branch: it gets more branches like those it carries, or passes on to others what it carries.</source>
        <translation>Auf einen Ast tippen: er bekommt mehr von dem, was er trägt, oder gibt es weiter.</translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation>Nachbilden</translation>
    </message>
    <message>
        <source>Draw a trunk and a silhouette: the same tree takes on this new shape.</source>
        <translation>Stamm und Umriss zeichnen: derselbe Baum nimmt diese neue Gestalt an.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Versetzen</translation>
    </message>
    <message>
        <source>Drag a branch along the wood, around it, or to other wood, with all it carries.</source>
        <translation>Einen Ast am Holz entlang ziehen, um es herum oder an anderes Holz, mit allem, was er trägt.</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save a picture of the tree, in any size and from any side.</source>
        <translation>Ein Bild des Baums speichern, in jeder Größe und von jeder Seite.</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy a picture of the tree, as it is shown now, to the clipboard.</source>
        <translation>Ein Bild des Baums, wie er gezeigt wird, in die Zwischenablage legen.</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>Noch einer wie dieser</translation>
    </message>
    <message>
        <source>See six other trees that the same strokes could have made, and take one.</source>
        <translation>Sechs Bäume ansehen, die dieselben Striche durch anderen Zufall ergeben, und einen nehmen.</translation>
    </message>
    <message>
        <source>Person for Scale</source>
        <translation>Mensch als Maßstab</translation>
    </message>
    <message>
        <source>Show a person beside the tree, and how long a metre is.</source>
        <translation>Einen Menschen neben dem Baum zeigen, und wie lang ein Meter ist.</translation>
    </message>
    <message>
        <source>Tool Ring</source>
        <translation>Werkzeugring</translation>
    </message>
    <message>
        <source>Tools, undo and brush size in a ring around the pointer. Hold the key, and let go over the one you want.</source>
        <translation>Werkzeuge, Rückgängig und die Größe des Pinsels rings um den Zeiger. Die Taste halten und über einem davon loslassen.</translation>
    </message>
    <message>
        <source>Second View</source>
        <translation>Zweite Ansicht</translation>
    </message>
    <message>
        <source>Show the tree from the right, in a corner of the window; draw there, too, to give it depth.</source>
        <translation>Den Baum in einer Ecke von rechts zeigen; auch dort zeichnen gibt ihm Tiefe.</translation>
    </message>
    <message>
        <source>Report a Problem…</source>
        <translation>Problem melden …</translation>
    </message>
    <message>
        <source>Copy what a report should have: version, graphics and log.</source>
        <translation>Kopieren, was ein Bericht enthalten soll: Version, Grafik und Protokoll.</translation>
    </message>
    <message>
        <source>Bring Trees Back…</source>
        <translation>Bäume zurückholen …</translation>
    </message>
    <message>
        <source>See the trees that were not saved when Espalier ended.</source>
        <translation>Die Bäume sehen, die beim Ende von Espalier nicht gespeichert waren.</translation>
    </message>
</context>
<context>
    <name>AddBudsTool</name>
    <message>
        <source>Tap old wood to let buds break through its bark; they grow into branches</source>
        <translation>Altes Holz antippen, damit Knospen durch die Rinde brechen; sie wachsen zu Ästen heran</translation>
    </message>
</context>
<context>
    <name>BendTool</name>
    <message>
        <source>Pull a branch to bend it; or tap where the bend begins, then where to hold it</source>
        <translation>An einem Ast ziehen, um ihn zu biegen; antippen, um erst seine Basis festzulegen, dann Haltepunkte</translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message>
        <source>Drag to brush a tree into being; begin at a branch to draw at its depth</source>
        <translation>Ziehen, um einen Baum zu pinseln; an einem Ast beginnen, um in dessen Tiefe fortzufahren</translation>
    </message>
    <message>
        <source>No bud sees this place: keep drawing, or begin at a branch</source>
        <translation>Keine Knospe sieht diese Stelle: weiterziehen oder an einem Ast beginnen</translation>
    </message>
    <message>
        <source>Only the chosen bud grows, and it does not see this place</source>
        <translation>Nur die gewählte Knospe wächst, und sie sieht diese Stelle nicht</translation>
    </message>
</context>
<context>
    <name>ClearTool</name>
    <message>
        <source>buds may shoot</source>
        <translation>Knospen dürfen treiben</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: below your hand, nothing shoots any more</source>
        <translation>An einem Stamm oder Ast hinaufziehen: Unterhalb der Hand treibt nichts mehr aus</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--strict: nothing is written, because some operations did not find everything that they name</source>
        <translation>--strict: nichts wird geschrieben, da Operationen nichts zu tun fanden oder nicht alles, was sie nennen</translation>
    </message>
    <message>
        <source>--size needs WIDTHxHEIGHT of up to %1 pixels each, not &quot;%2&quot;</source>
        <translation>--size verlangt BREITExHÖHE von bis zu %1 Pixeln je Kante, nicht &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1: the suffix of an output says its format, and is one of .espalier .%2</source>
        <translation>%1: die Endung einer Ausgabe nennt ihr Format und ist eine von .espalier .%2</translation>
    </message>
    <message>
        <source>--camera needs front, side, top or three-quarter, not &quot;%1&quot;</source>
        <translation>--camera ist front, side, top oder three-quarter, nicht &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--threads needs a number from 1 to %1, not &quot;%2&quot;</source>
        <translation>--threads verlangt eine Zahl von 1 bis %1, nicht &quot;%2&quot;</translation>
    </message>
    <message>
        <source>--seed needs a whole number from 0 to 18446744073709551615, not &quot;%1&quot;</source>
        <translation>--seed verlangt eine ganze Zahl von 0 bis 18446744073709551615, nicht &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 has no option %2</source>
        <translation>%1 kennt keine Option %2</translation>
    </message>
    <message>
        <source>%1 takes no value</source>
        <translation>%1 verlangt keinen Wert</translation>
    </message>
    <message>
        <source>%1 needs a value after it</source>
        <translation>%1 verlangt einen Wert dahinter</translation>
    </message>
    <message>
        <source>--transparent needs --png FILE</source>
        <translation>--transparent verlangt --png DATEI</translation>
    </message>
    <message>
        <source>--ground-shadow needs --transparent</source>
        <translation>--ground-shadow verlangt --transparent</translation>
    </message>
    <message>
        <source>%1 needs one project</source>
        <translation>%1 verlangt ein Projekt</translation>
    </message>
    <message>
        <source>render needs --png FILE</source>
        <translation>render verlangt --png DATEI</translation>
    </message>
    <message>
        <source>info needs one file</source>
        <translation>info verlangt eine Datei</translation>
    </message>
    <message>
        <source>a window opens only one file; &quot;%1&quot; is one too many</source>
        <translation>ein Fenster zeigt eine Datei, was ist also &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>%1: its history, played again, gives a different tree from the one it holds</source>
        <translation>%1: Seine Geschichte ergibt, noch einmal abgespielt, einen anderen Baum als den gespeicherten</translation>
    </message>
    <message>
        <source>replay needs at least one recipe or project</source>
        <translation>replay braucht mindestens ein Rezept oder Projekt</translation>
    </message>
    <message>
        <source>import needs one skeleton and -o OUT</source>
        <translation>import verlangt ein Skelett und -o AUSGABE</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>für weitere Parametersätze ist kein Platz</translation>
    </message>
    <message>
        <source>--set needs group.name=value, not &quot;%1&quot;</source>
        <translation>--set verlangt gruppe.name=wert, nicht &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--set: there is no parameter &quot;%1&quot;</source>
        <translation>--set kennt keinen Parameter &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--fibres needs --png FILE</source>
        <translation>--fibres verlangt --png DATEI</translation>
    </message>
    <message>
        <source>--index needs a whole number from 0, not &quot;%1&quot;</source>
        <translation>--index verlangt eine ganze Zahl ab 0, nicht „%1“</translation>
    </message>
    <message>
        <source>sketch needs at least one drawing</source>
        <translation>sketch verlangt mindestens eine Zeichnung</translation>
    </message>
    <message>
        <source>it has more than %1 strokes</source>
        <translation>sie hat mehr als %1 Striche</translation>
    </message>
    <message>
        <source>it has no line that can be a trunk, and no crown</source>
        <translation>sie hat keine Linie, die ein Stamm sein kann, und keine Krone</translation>
    </message>
    <message>
        <source>--vary needs a whole number from 0, and after a colon an amount from %1 to 1 if you like, such as 7 or 7:0.5, not &quot;%2&quot;</source>
        <translation>--vary verlangt eine ganze Zahl ab 0, und nach einem Doppelpunkt auf Wunsch ein Maß von %1 bis 1, wie 7 oder 7:0.5, nicht „%2“</translation>
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
        <translation>Espalier: Bäume mit dem Pinsel wachsen lassen.

espalier [PROJEKT]
    Öffnet das Fenster.

espalier --demo [REZEPT]
    Öffnet das Fenster und pinselt einen Baum darin; danach gehört er Ihnen.

espalier replay REZEPT|PROJEKT... [-o AUSGABE]... [--png DATEI] [--size BxH]
                [--camera front|side|top|three-quarter]
                [--transparent [--ground-shadow]] [--fibres]
                [--stats DATEI] [--profiles DATEI] [--threads N] [--seed N]
                [--strict] [--vary ZAHL[:MASS]]
                [--set GRUPPE.NAME=WERT]...
    Tut ohne Fenster, was ein Rezept sagt, und schreibt, was daraus wird.
    Bei einem Projekt wird alles noch einmal getan, was mit seinem Baum geschah.
    Von mehreren Rezepten setzt jedes den Baum des vorigen fort: das erste
    bestimmt den Startwert, und jedes setzt zu Beginn seine Parameter in Kraft.
    --profiles: die Lage der Stränge in jedem Querschnitt, als JSON.
    Was Operationen im Baum nicht finden, wird ausgegeben; mit --strict ist es
    ein Fehler, und nichts wird geschrieben.
    --set gibt einem Parameter einen Wert für das ganze Abspielen, was Rezepte
    auch sagen: --set growth.shedding=0.1 --set leaves.visible=false. Winkel
    sind in Grad.
    --vary lässt Winkel und Längen des Baums ein wenig abweichen, um ein Maß von
    0.3 oder bis zu 1: eine andere Zahl ist ein anderer Baum neben ihm im Wald.

espalier import SKELETT.csv -o AUSGABE...
    Macht aus einem gemessenen Baum einen eigenen: Zeilen aus id, parent, beiden
    Enden und Radius.

espalier sketch ZEICHNUNG... [--index N] [--front-only] [-o AUSGABE]...
                [--png DATEI] [--size BxH] [--camera ...] [--stats DATEI]
                [--seed N] [--set GRUPPE.NAME=WERT]...
    Macht einen Baum aus dem, was jemand gezeichnet hat: Linien sind Äste,
    kleine Schleifen Blätter, eine große Schleife ist eine Krone, in die er
    wächst. Zeichnungen sind SVG oder .ndjson von Quick, Draw!, aus denen
    --index eine Zeile nimmt, von 0 an. Von mehreren wird jede über die vorige
    gezeichnet. --front-only: Tiefe wird einmal gegeben, ohne die Zeichnung
    von der Seite noch einmal einzusetzen.

espalier export PROJEKT [-o AUSGABE]... [--vary ZAHL[:MASS]]
                [--set GRUPPE.NAME=WERT]...
    Schreibt ein Projekt in anderen Formaten. --vary und --set ändern, was
    geschrieben wird; das Projekt bleibt, wie es ist.

espalier render PROJEKT --png DATEI [--size BxH] [--camera ...]
                [--transparent [--ground-shadow]] [--fibres]
                [--vary ZAHL[:MASS]] [--set GRUPPE.NAME=WERT]...
    Nimmt ein Bild auf. Das verlangt eine Anzeige; eine virtuelle genügt.
    --transparent: der Baum allein, mit nicht vormultipliziertem Alpha;
    --ground-shadow behält seinen Schatten, als Schwarz mit etwas Deckkraft.
    --fibres: die Stränge des Holzes als Linien.

espalier info DATEI
    Sagt als JSON, was in einem Projekt ist.

espalier --help, --version

AUSGABE endet auf .espalier (Projekt) oder auf die Endung eines Formats:
%1Endet mit 0, wenn alles getan ist, mit 2, wenn die Befehlszeile falsch ist, mit
3, wenn eine Eingabe unlesbar oder falsch ist, mit 4, wenn eine Ausgabe nicht
geschrieben werden konnte.
</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Brush Stroke</source>
        <translation>Pinselstrich</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Change Parameters</source>
        <translation>Parameter ändern</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Go to Another Time</source>
        <translation>Zeitreise</translation>
    </message>
    <message>
        <source>Remove Width</source>
        <translation>Dicke freigeben</translation>
    </message>
    <message>
        <source>Set Width</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>a sketch can only become a tree where nothing has grown</source>
        <translation>eine Zeichnung kann nur zum Baum werden, wo noch nichts gewachsen ist</translation>
    </message>
    <message>
        <source>no stroke of the sketch is a branch</source>
        <translation>kein Strich der Zeichnung ist ein Zweig</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>a skeleton can only be imported where nothing has grown</source>
        <translation>ein Skelett kann nur eingelesen werden, wo noch nichts gewachsen ist</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>Neutriebe</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>Kräftigen</translation>
    </message>
    <message>
        <source>Draw Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Blend Profiles</source>
        <translation>Profile überblenden</translation>
    </message>
    <message>
        <source>Remove Profile</source>
        <translation>Profil entfernen</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Einkürzen</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Remove Twist</source>
        <translation>Verdrehung entfernen</translation>
    </message>
    <message>
        <source>Give Depth</source>
        <translation>Tiefe geben</translation>
    </message>
    <message>
        <source>Draw Branch</source>
        <translation>Ast zeichnen</translation>
    </message>
    <message>
        <source>Multiply Branch</source>
        <translation>Ast vermehren</translation>
    </message>
    <message>
        <source>Place Leaf</source>
        <translation>Blatt setzen</translation>
    </message>
    <message>
        <source>Arrange Leaves</source>
        <translation>Blätter anordnen</translation>
    </message>
    <message>
        <source>Pass On Branch</source>
        <translation>Ast übertragen</translation>
    </message>
    <message>
        <source>the new trunk must be an open line</source>
        <translation>der neue Stamm muss eine offene Linie sein</translation>
    </message>
    <message>
        <source>Reshape Tree</source>
        <translation>Baum nachbilden</translation>
    </message>
    <message>
        <source>Vary Tree</source>
        <translation>Baum abwandeln</translation>
    </message>
    <message>
        <source>Move Branch</source>
        <translation>Ast versetzen</translation>
    </message>
    <message numerus="yes">
        <source>Brush Stroke, %n branches</source>
        <translation>
            <numerusform>Pinselstrich, %n Ast</numerusform>
            <numerusform>Pinselstrich, %n Äste</numerusform>
        </translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Thin Out</source>
        <translation>Auslichten</translation>
    </message>
    <message>
        <source>Keep Clear</source>
        <translation>Freihalten</translation>
    </message>
    <message>
        <source>Let Buds Shoot</source>
        <translation>Knospen treiben lassen</translation>
    </message>
    <message numerus="yes">
        <source>Prune, %n branches</source>
        <translation>
            <numerusform>Schneiden, %n Ast</numerusform>
            <numerusform>Schneiden, %n Äste</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Grow, %n steps</source>
        <translation>
            <numerusform>Wachsen, %n Schritt</numerusform>
            <numerusform>Wachsen, %n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Neuwuchs</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>Hülle entfernen</translation>
    </message>
    <message>
        <source>Earlier Steps</source>
        <translation>Frühere Schritte</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Tap a branch to cut it off, or draw across the branches to cut</source>
        <translation>Einen Ast antippen, um ihn abzuschneiden, oder quer über die Äste ziehen, die fallen sollen</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>there is no display (DISPLAY is not set); xvfb-run provides a virtual one</source>
        <translation>es gibt keine Anzeige (DISPLAY ist nicht gesetzt); xvfb-run stellt eine virtuelle bereit</translation>
    </message>
    <message>
        <source>the display %1 does not answer</source>
        <translation>die Anzeige %1 antwortet nicht</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>it is not an SVG</source>
        <translation>sie ist kein SVG</translation>
    </message>
    <message>
        <source>it has no drawing %1</source>
        <translation>sie hat keine Zeichnung %1</translation>
    </message>
    <message>
        <source>a stroke has more x than y values, or fewer</source>
        <translation>ein Strich hat nicht so viele x wie y</translation>
    </message>
    <message>
        <source>a stroke has a point that is not a number</source>
        <translation>ein Strich hat einen Punkt, der keine Zahl ist</translation>
    </message>
    <message>
        <source>it has no strokes</source>
        <translation>sie hat keine Striche</translation>
    </message>
    <message>
        <source>it has more than %1 points</source>
        <translation>sie hat mehr als %1 Punkte</translation>
    </message>
</context>
<context>
    <name>Envelope</name>
    <message>
        <source>There is no lasso stroke.</source>
        <translation>Es gibt keinen Lassostrich.</translation>
    </message>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>Die Zeichenebene des Lassos ist ungültig.</translation>
    </message>
    <message>
        <source>The lasso is too small to enclose anything.</source>
        <translation>Das Lasso ist zu klein, um etwas zu umschließen.</translation>
    </message>
    <message>
        <source>The lasso encloses no area.</source>
        <translation>Das Lasso umschließt keine Fläche.</translation>
    </message>
    <message>
        <source>The lasso is too small for its distance from the origin.</source>
        <translation>Das Lasso ist zu klein für seinen Abstand vom Ursprung.</translation>
    </message>
</context>
<context>
    <name>EraserTool</name>
    <message>
        <source>Brush over twigs to thin them evenly; those to be removed turn red</source>
        <translation>Über Zweige streichen, um einige gleichmäßig herauszunehmen; was fällt, wird rot</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are</source>
        <translation>Über Zweige und Blätter streichen, um sie wegzunehmen, so tief sie auch in der Krone sind</translation>
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
        <translation>Binäres glTF</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Skeleton as a table</source>
        <translation>Skelett als Tabelle</translation>
    </message>
</context>
<context>
    <name>Exporter</name>
    <message>
        <source>the meshes could not be written: %1</source>
        <translation>die Netze konnten nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>“.%1” is not an export format; the formats are %2</source>
        <translation>es gibt keinen Export nach „.%1“; es gibt %2</translation>
    </message>
    <message>
        <source>The export was cancelled.</source>
        <translation>Der Export wurde abgebrochen.</translation>
    </message>
    <message>
        <source>there are too many files with similar names in this folder; choose another name or another folder</source>
        <translation>im Ordner der Datei gibt es zu viele Dateien mit ähnlichen Namen; einen anderen Namen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>another program made this file during the export; export again, and another name will be chosen</source>
        <translation>ein anderes Programm hat diese Datei während des Exports angelegt; noch einmal exportieren, dann wird ein anderer Name gewählt</translation>
    </message>
    <message>
        <source>the tree takes more than the 4 GB that such a file can hold; export less detail</source>
        <translation>der Baum braucht mehr als die 4 GB, die eine solche Datei fassen kann; weniger Einzelheiten exportieren</translation>
    </message>
    <message>
        <source>the tree takes more than such a file can hold; export less detail</source>
        <translation>der Baum braucht mehr, als eine solche Datei fasst; exportieren Sie weniger Einzelheiten</translation>
    </message>
</context>
<context>
    <name>FbxRepair</name>
    <message>
        <source>this is not a valid binary FBX file</source>
        <translation>dies ist keine einwandfreie binäre FBX-Datei</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Trees (*.espalier)</source>
        <translation>Bäume (*.espalier)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Espalier</source>
        <translation>Espalier</translation>
    </message>
    <message>
        <source>%1 is still growing. What has grown so far is not saved.</source>
        <translation>%1 wächst noch. Was bisher gewachsen ist, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 enthält ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>%1 has been changed by another window or program since it was opened or saved here. Overwriting it loses those changes.</source>
        <translation>%1 wurde von einem anderen Fenster oder Programm geändert, seit es hier geöffnet oder gespeichert wurde. Beim Überschreiben gehen diese Änderungen verloren.</translation>
    </message>
    <message>
        <source>Save as Recipe</source>
        <translation>Als Rezept speichern</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Rezepte (*.json)</translation>
    </message>
    <message>
        <source>Trees, recipes and measured skeletons (*.espalier *.json *.csv);;Trees (*.espalier);;Recipes (*.json);;Skeletons (*.csv);;All files (*)</source>
        <translation>Bäume, Rezepte und gemessene Skelette (*.espalier *.json *.csv);;Bäume (*.espalier);;Rezepte (*.json);;Skelette (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>&amp;Speichern unter …</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>sie ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>sie ist größer als %1 MB</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>sie ist ein Ordner</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file</source>
        <translation>sie ist ein Gerät oder eine Pipe, keine Datei</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>sie kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
</context>
<context>
    <name>FileWriter</name>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>den Ordner %1 gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is not a folder</source>
        <translation>%1 ist kein Ordner</translation>
    </message>
    <message>
        <source>a folder with this name already exists</source>
        <translation>es gibt einen Ordner dieses Namens</translation>
    </message>
    <message>
        <source>you may not write into the folder %1</source>
        <translation>in den Ordner %1 darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>you may not change this file</source>
        <translation>diese Datei darf nicht geändert werden</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>your disk quota is used up</source>
        <translation>der zugeteilte Anteil am Datenträger ist voll</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>der Datenträger kann nur gelesen werden</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>hier darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the file is too large for this disk</source>
        <translation>die Datei ist zu groß für diesen Datenträger</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>der Datenträger ist fehlerhaft</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>zu viele Dateien sind geöffnet</translation>
    </message>
    <message>
        <source>the system does not say why</source>
        <translation>das System nennt keinen Grund</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>eine Datei braucht einen Namen</translation>
    </message>
    <message>
        <source>it is a link that leads back to itself</source>
        <translation>sie ist eine Verknüpfung, die auf sich selbst zurückführt</translation>
    </message>
    <message>
        <source>no program reads from this pipe</source>
        <translation>kein Programm liest aus dieser Pipe</translation>
    </message>
    <message>
        <source>another program has changed it</source>
        <translation>ein anderes Programm hat sie geändert</translation>
    </message>
</context>
<context>
    <name>GrowTool</name>
    <message>
        <source>Press and hold: the tree grows until you let go</source>
        <translation>Drücken und halten: Der Baum wächst bis zum Loslassen.</translation>
    </message>
</context>
<context>
    <name>ImageFile</name>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>ist größer als %1 MB</translation>
    </message>
    <message>
        <source>it is neither a PNG nor a JPEG image</source>
        <translation>ist weder ein PNG- noch ein JPEG-Bild</translation>
    </message>
    <message>
        <source>the image is broken</source>
        <translation>das Bild ist beschädigt</translation>
    </message>
    <message>
        <source>it has %1 × %2 pixels; %3 along an edge is the most</source>
        <translation>hat %1 × %2 Pixel; höchstens %3 je Kante sind möglich</translation>
    </message>
    <message>
        <source>it is too small: only %1 × %2 pixels</source>
        <translation>hat nur %1 × %2 Pixel</translation>
    </message>
    <message>
        <source>it is not a picture that can be read</source>
        <translation>es ist kein lesbares Bild</translation>
    </message>
</context>
<context>
    <name>ImageStructure</name>
    <message>
        <source>the file is not whole</source>
        <translation>die Datei ist nicht vollständig</translation>
    </message>
    <message>
        <source>it is made so that unpacking it would take very long</source>
        <translation>sie ist so beschaffen, dass das Entpacken sehr lange dauern würde</translation>
    </message>
</context>
<context>
    <name>InvigorateTool</name>
    <message>
        <source>Press a branch and hold: it grows until you let go</source>
        <translation>Auf einen Ast drücken und halten: Er wächst bis zum Loslassen</translation>
    </message>
</context>
<context>
    <name>JournalCheck</name>
    <message>
        <source>it changes nothing</source>
        <translation>er ändert nichts</translation>
    </message>
    <message>
        <source>it places a leaf that is not there</source>
        <translation>er setzt ein Blatt, das nicht da ist</translation>
    </message>
    <message>
        <source>it places a leaf at another time</source>
        <translation>er setzt ein Blatt zu einer anderen Zeit</translation>
    </message>
    <message>
        <source>it creates an internode whose parameters are not there</source>
        <translation>er bringt ein Internodium hervor, dessen Parameter nicht da sind</translation>
    </message>
    <message>
        <source>its steps do not follow on from those around it</source>
        <translation>die Schritte schließen nicht an die benachbarten an</translation>
    </message>
    <message>
        <source>its parameters do not follow on from those of the steps around it</source>
        <translation>die Parameter schließen nicht an die benachbarten an</translation>
    </message>
    <message>
        <source>its births are out of order</source>
        <translation>die Geburten sind nicht in der richtigen Reihenfolge</translation>
    </message>
    <message>
        <source>it records the death of an internode that did not die</source>
        <translation>lässt ein Internodium sterben, das nicht gestorben ist</translation>
    </message>
    <message>
        <source>it creates an internode that is not there</source>
        <translation>bringt ein Internodium hervor, das es nicht gibt</translation>
    </message>
    <message>
        <source>it creates an internode at another time</source>
        <translation>bringt ein Internodium zu einer anderen Zeit hervor</translation>
    </message>
    <message>
        <source>before it, an internode would live on a dead one</source>
        <translation>davor würde ein Internodium auf einem toten leben</translation>
    </message>
    <message>
        <source>before it, two internodes would continue the same axis</source>
        <translation>davor würden zwei Internodien dieselbe Achse fortsetzen</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>Schritt %1 der Geschichte</translation>
    </message>
    <message>
        <source>it places a leaf on an internode that is not there</source>
        <translation>setzt ein Blatt auf ein Internodium, das es nicht gibt</translation>
    </message>
    <message>
        <source>it changes an envelope in a way that is not possible</source>
        <translation>ändert eine Hülle auf unmögliche Weise</translation>
    </message>
    <message>
        <source>something is set before it on what it brings</source>
        <translation>davor ist etwas an dem festgelegt, was erst mit diesem Schritt kommt</translation>
    </message>
    <message>
        <source>the beginning of the history</source>
        <translation>der Anfang der Geschichte</translation>
    </message>
    <message>
        <source>it changes “%1”, which never changes</source>
        <translation>ändert „%1“, was sich nie ändert</translation>
    </message>
    <message>
        <source>it changes “%1” of a row that was not there</source>
        <translation>ändert „%1“ einer Zeile, die nicht da war</translation>
    </message>
    <message>
        <source>it changes “%1” in a way that is not possible</source>
        <translation>ändert „%1“ auf unmögliche Weise</translation>
    </message>
    <message>
        <source>it refers to strokes or profiles that are not there</source>
        <translation>bringt Striche oder Profile, die es nicht gibt</translation>
    </message>
</context>
<context>
    <name>JsonReader</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>ist größer als %1 MB</translation>
    </message>
    <message>
        <source>it holds too many values</source>
        <translation>enthält zu viele Werte</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation>kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>a JSON object is expected</source>
        <translation>ein JSON-Objekt wird erwartet</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected</source>
        <translation>eine ganze Zahl von %1 bis %2 wird erwartet</translation>
    </message>
    <message>
        <source>a string is expected</source>
        <translation>eine Zeichenkette wird erwartet</translation>
    </message>
    <message>
        <source>a whole number of at most 64 bits is expected; from 2^53 on, write it as a string of digits</source>
        <translation>eine ganze Zahl von höchstens 64 Bit wird erwartet, ab 2^53 als Zeichenkette aus Ziffern</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>ein Objekt wird erwartet</translation>
    </message>
    <message>
        <source>an array is expected</source>
        <translation>ein Array wird erwartet</translation>
    </message>
    <message>
        <source>“%1” is not known here</source>
        <translation>„%1“ ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected</source>
        <translation>eine Zahl von %1 bis %2 wird erwartet</translation>
    </message>
</context>
<context>
    <name>Lasso</name>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>Die Zeichenebene des Lassos ist ungültig.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>There is no envelope to regrow.</source>
        <translation>Es gibt keine Hülle für einen Neuwuchs.</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Neuwuchs</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>Hülle entfernen</translation>
    </message>
    <message>
        <source>There is no envelope to fill.</source>
        <translation>Es gibt keine Hülle zum Ausfüllen.</translation>
    </message>
    <message>
        <source>There is no room for more parameter sets.</source>
        <translation>Für weitere Parametersätze ist kein Platz.</translation>
    </message>
    <message>
        <source>There is no room for more lassos.</source>
        <translation>Für weitere Lassos ist kein Platz.</translation>
    </message>
</context>
<context>
    <name>LassoTool</name>
    <message>
        <source>Draw the silhouette of a crown; the tree fills it. Begin at a branch to draw at its depth</source>
        <translation>Den Umriss einer Krone zeichnen; der Baum füllt ihn aus. An einem Ast beginnen, um in dessen Tiefe zu zeichnen</translation>
    </message>
</context>
<context>
    <name>LeafChoices</name>
    <message>
        <source>One leaf at a time along the branch, each turned from the one before as the second is from the first.</source>
        <translation>Ein Blatt nach dem anderen am Ast entlang, jedes so gedreht wie das zweite gegen das erste.</translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>A tree needs a name.</source>
        <translation>Ein Baum braucht einen Namen.</translation>
    </message>
    <message>
        <source>A name cannot begin with a full stop.</source>
        <translation>Ein Name darf nicht mit einem Punkt beginnen.</translation>
    </message>
    <message>
        <source>A name cannot contain any of / \ : * ? &quot; &lt; &gt; |.</source>
        <translation>Ein Name darf keines der Zeichen / \ : * ? &quot; &lt; &gt; | enthalten.</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>Dieser Name ist zu lang.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>There is already a tree named %1.</source>
        <translation>Es gibt schon einen Baum namens %1.</translation>
    </message>
    <message>
        <source>%1 cannot be renamed: %2</source>
        <translation>%1 kann nicht umbenannt werden: %2</translation>
    </message>
    <message>
        <source>%1 cannot be copied: %2</source>
        <translation>%1 kann nicht kopiert werden: %2</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash: %2</source>
        <translation>%1 kann nicht in den Papierkorb verschoben werden: %2</translation>
    </message>
    <message>
        <source>There is another tree named %1 now.</source>
        <translation>Es gibt jetzt einen anderen Baum namens %1.</translation>
    </message>
    <message>
        <source>%1 cannot be taken out of the trash: %2</source>
        <translation>%1 lässt sich nicht aus dem Papierkorb holen: %2</translation>
    </message>
</context>
<context>
    <name>MoveTool</name>
    <message>
        <source>a trunk stays where it stands; drag a branch</source>
        <translation>ein Stamm bleibt, wo er steht; fassen Sie einen Ast</translation>
    </message>
    <message>
        <source>Drag a branch along the wood or around it; drag its base to other wood, its tip to scale it</source>
        <translation>Einen Ast am Holz entlang oder um es herum ziehen; am Ansatz an anderes Holz; an der Spitze skalieren</translation>
    </message>
</context>
<context>
    <name>MultiplyTool</name>
    <message>
        <source>Tap a branch: it gets one more branch like those that it carries</source>
        <translation>Auf einen Ast tippen: er bekommt einen Ast mehr wie die, die er trägt</translation>
    </message>
    <message>
        <source>Tap a branch: the others get what it carries; drag from it across branches to choose which of them get it</source>
        <translation>Auf einen Ast tippen: Die anderen bekommen, was er trägt; oder von ihm über die ziehen, die es bekommen sollen</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>A picture cannot be drawn, because there is no display that offers OpenGL 3.3; a virtual one (Xvfb) will do.</source>
        <translation>Es kann kein Bild gezeichnet werden, denn es gibt keine Anzeige mit OpenGL 3.3; eine virtuelle (Xvfb) genügt.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large; %3 along an edge is the most.</source>
        <translation>Ein Bild von %1 × %2 Pixeln ist zu groß; höchstens %3 je Kante sind möglich.</translation>
    </message>
</context>
<context>
    <name>Outputs</name>
    <message>
        <source>%1: the picture could not be compressed</source>
        <translation>%1: das Bild konnte nicht gepackt werden</translation>
    </message>
</context>
<context>
    <name>OwnTextures</name>
    <message>
        <source>%1: the leaf cannot be told apart from its background; the image needs a transparent or a plain background</source>
        <translation>%1: das Blatt lässt sich nicht von dem unterscheiden, was dahinter ist; das Bild braucht einen transparenten oder einfarbigen Hintergrund</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Internode</source>
        <translation>Internodium</translation>
    </message>
    <message>
        <source>Length of one internode. It is the measure of everything that grows: shorter ones make finer trees.</source>
        <translation>Länge eines Internodiums. Es ist das Maß für alles, was wächst: kleinere ergeben feinere Bäume.</translation>
    </message>
    <message>
        <source>Shoot length</source>
        <translation>Trieblänge</translation>
    </message>
    <message>
        <source>How many internodes the strongest shoot grows in one step.</source>
        <translation>Wie viele Internodien der stärkste Trieb in einem Schritt wächst.</translation>
    </message>
    <message>
        <source>Branching angle</source>
        <translation>Verzweigungswinkel</translation>
    </message>
    <message>
        <source>Between a branch and the branches that grow from it.</source>
        <translation>Zwischen einem Ast und dem, was von ihm abzweigt.</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Ablenkung</translation>
    </message>
    <message>
        <source>How far an axis turns away from a branch that it bears: 0 keeps it straight, more makes it zigzag.</source>
        <translation>Wie weit eine Achse von einem Ast weggelenkt wird, den sie trägt: 0 hält sie gerade, mehr lässt sie im Zickzack wachsen.</translation>
    </message>
    <message>
        <source>Phyllotaxis</source>
        <translation>Phyllotaxis</translation>
    </message>
    <message>
        <source>Turn around the axis from one bud to the next: 137.5° is a spiral, 180° two rows, 90° crossed pairs.</source>
        <translation>Drehung um die Achse von einer Knospe zur nächsten: 137,5° ist eine Spirale, 180° zwei Zeilen, 90° gekreuzte Paare.</translation>
    </message>
    <message>
        <source>Buds at a node</source>
        <translation>Knospen je Knoten</translation>
    </message>
    <message>
        <source>One is alternate, two opposite, more a whorl, as in pines.</source>
        <translation>Eine ist wechselständig, zwei gegenständig, mehr ein Quirl, wie bei Kiefern.</translation>
    </message>
    <message>
        <source>Occupied radius</source>
        <translation>Belegter Radius</translation>
    </message>
    <message>
        <source>Space around each bud that nothing else grows into, in internodes. More makes an airier crown.</source>
        <translation>Raum um jede Knospe, in den nichts anderes wächst, in Internodien. Mehr ergibt eine luftigere Krone.</translation>
    </message>
    <message>
        <source>Sight</source>
        <translation>Sichtweite</translation>
    </message>
    <message>
        <source>How far beyond its own space a bud sees room to grow, in internodes.</source>
        <translation>Wie weit über ihren eigenen Raum hinaus eine Knospe Wuchsraum sieht, in Internodien.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Sichtfeld</translation>
    </message>
    <message>
        <source>How far to the sides a bud sees room to grow.</source>
        <translation>Wie weit zu den Seiten eine Knospe Wuchsraum sieht.</translation>
    </message>
    <message>
        <source>Brush density</source>
        <translation>Pinseldichte</translation>
    </message>
    <message>
        <source>How densely the brush spreads room to grow, in points per cubic internode. More makes denser growth.</source>
        <translation>Wie viel Wuchsraum der Pinsel verteilt, in Punkten je Kubikinternodium. Mehr ergibt dichteren Wuchs.</translation>
    </message>
    <message>
        <source>Brush memory</source>
        <translation>Pinselgedächtnis</translation>
    </message>
    <message>
        <source>After this many growth steps, the room that the brush has spread is forgotten.</source>
        <translation>Wuchsschritte, nach denen der vom Pinsel verteilte Raum vergessen wird.</translation>
    </message>
    <message>
        <source>Room at a bud</source>
        <translation>Raum je Knospe</translation>
    </message>
    <message>
        <source>When the tree grows on its own: the room to grow that each bud finds around itself in each step.</source>
        <translation>Wenn der Baum von selbst wächst: der Wuchsraum, den jede Knospe in jedem Schritt um sich findet.</translation>
    </message>
    <message>
        <source>Apical dominance</source>
        <translation>Apikaldominanz</translation>
    </message>
    <message>
        <source>What gets the vigour: above 0.5 the main axis, as in conifers; below it the branches, as in shrubs.</source>
        <translation>Wer die Wuchskraft bekommt: über 0,5 die Hauptachse, wie bei Nadelbäumen; darunter die Äste, wie bei Sträuchern.</translation>
    </message>
    <message>
        <source>Light sensitivity</source>
        <translation>Lichtbedarf</translation>
    </message>
    <message>
        <source>How much more a bud in the light thrives than one in the shade.</source>
        <translation>Wie viel besser eine Knospe im Licht gedeiht als eine im Schatten.</translation>
    </message>
    <message>
        <source>Shedding</source>
        <translation>Astabwurf</translation>
    </message>
    <message>
        <source>Branches with less vigour than this die: 0 keeps them all.</source>
        <translation>Äste mit weniger Wuchskraft sterben ab: 0 erhält alle.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>How much light one internode takes.</source>
        <translation>Wie viel Licht ein Internodium wegnimmt.</translation>
    </message>
    <message>
        <source>Shadow falloff</source>
        <translation>Schattenabfall</translation>
    </message>
    <message>
        <source>How fast a shadow fades on its way down.</source>
        <translation>Wie schnell ein Schatten nach unten hin schwindet.</translation>
    </message>
    <message>
        <source>Shadow depth</source>
        <translation>Schattentiefe</translation>
    </message>
    <message>
        <source>How many layers below an internode its shadow reaches.</source>
        <translation>Wie viele Schichten unter einem Internodium sein Schatten noch erreicht.</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Geradheit</translation>
    </message>
    <message>
        <source>How much a shoot keeps the direction that it has.</source>
        <translation>Wie sehr ein Trieb die Richtung beibehält, die er hat.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Tropismus</translation>
    </message>
    <message>
        <source>How much a shoot turns towards the set-point angle.</source>
        <translation>Wie sehr sich ein Trieb zum Sollwinkel hin wendet.</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Freier Raum</translation>
    </message>
    <message>
        <source>How much a shoot turns towards where there is room.</source>
        <translation>Wie sehr sich ein Trieb dorthin wendet, wo Raum ist.</translation>
    </message>
    <message>
        <source>Set-point angle</source>
        <translation>Sollwinkel</translation>
    </message>
    <message>
        <source>The direction that shoots turn to: 0° is up, 90° level, and more makes them weep.</source>
        <translation>Wohin sich Triebe wenden: 0° ist aufwärts, 90° waagerecht, mehr lässt sie hängen.</translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation>Dem Strich folgen</translation>
    </message>
    <message>
        <source>Shoots turn the way the brush goes, instead of to the set-point angle.</source>
        <translation>Triebe wenden sich dorthin, wohin der Pinsel geht, statt zum Sollwinkel.</translation>
    </message>
    <message>
        <source>Vigour of the buds on the upper and lower sides of a leaning branch.</source>
        <translation>Wuchskraft der Knospen oben und unten an einem geneigten Ast.</translation>
    </message>
    <message>
        <source>Vigour of the buds on the sides of a leaning branch.</source>
        <translation>Wuchskraft der Knospen an den Seiten eines geneigten Asts.</translation>
    </message>
    <message>
        <source>Above 0 the buds on the upper side are stronger, as in fruit trees; below 0 those on the lower side.</source>
        <translation>Über 0 sind die Knospen der Oberseite stärker, wie bei Obstbäumen; unter 0 die der Unterseite.</translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Spread of angles and lengths: 0 is as regular as a diagram, 1 as wild as nature.</source>
        <translation>Streuung der Winkel und Längen: 0 ist ein Schema, 1 so wild wie die Natur.</translation>
    </message>
    <message>
        <source>Upright trunk</source>
        <translation>Aufrechter Stamm</translation>
    </message>
    <message>
        <source>The trunk grows straight up, whatever the branches do.</source>
        <translation>Der Stamm wächst gerade nach oben, was auch die Äste tun.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>Whether the tree has any.</source>
        <translation>Ob der Baum welche hat.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>The outline of a leaf.</source>
        <translation>Der Umriss eines Blatts.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>From the stalk to the tip.</source>
        <translation>Vom Stiel bis zur Spitze.</translation>
    </message>
    <message>
        <source>Breadth</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width as a share of length.</source>
        <translation>Breite im Verhältnis zur Länge.</translation>
    </message>
    <message>
        <source>Variation in size</source>
        <translation>Größenstreuung</translation>
    </message>
    <message>
        <source>How much the sizes of leaves differ.</source>
        <translation>Wie sehr sich die Größen der Blätter unterscheiden.</translation>
    </message>
    <message>
        <source>At a node</source>
        <translation>Je Knoten</translation>
    </message>
    <message>
        <source>How many leaves grow together.</source>
        <translation>Wie viele Blätter zusammen wachsen.</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>How leaves stand around a shoot: as its buds do; in a spiral; together, each pair or whorl across the one before; or flat in two rows, as on beech and hemlock.</source>
        <translation>Wie Blätter um einen Trieb stehen: wie seine Knospen; in einer Spirale; zusammen, jedes Paar oder jeder Quirl quer zum vorigen; oder flach in zwei Reihen wie bei Buche und Hemlocktanne.</translation>
    </message>
    <message>
        <source>Leaf phyllotaxis: spiral, decussate or verticillate, distichous.</source>
        <translation>Blattstellung: zerstreut, gekreuzt-gegenständig oder quirlig, zweizeilig.</translation>
    </message>
    <message>
        <source>shoot</source>
        <translation>Trieb</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>opposite</source>
        <translation>gekreuzt</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>How far inward</source>
        <translation>Wie weit innen</translation>
    </message>
    <message>
        <source>Branches that carry more twigs than this are bare.</source>
        <translation>Äste, die mehr Zweige tragen, sind kahl.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Between a shoot and the leaf&apos;s stalk.</source>
        <translation>Zwischen einem Trieb und dem Blattstiel.</translation>
    </message>
    <message>
        <source>Droop</source>
        <translation>Hängen</translation>
    </message>
    <message>
        <source>How far leaves hang down.</source>
        <translation>Wie weit die Blätter herabhängen.</translation>
    </message>
    <message>
        <source>Towards the sky</source>
        <translation>Zum Himmel</translation>
    </message>
    <message>
        <source>How far leaves turn their faces up.</source>
        <translation>Wie weit die Blätter ihre Flächen nach oben wenden.</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>0° is red, 60° yellow, 120° green.</source>
        <translation>0° ist Rot, 60° Gelb, 120° Grün.</translation>
    </message>
    <message>
        <source>Variation in hue</source>
        <translation>Farbtonstreuung</translation>
    </message>
    <message>
        <source>How much the colours of leaves differ.</source>
        <translation>Wie sehr sich die Farben der Blätter unterscheiden.</translation>
    </message>
    <message>
        <source>How far the leaves of weak shoots turn towards yellow and red.</source>
        <translation>Wie weit sich die Blätter schwacher Triebe nach Gelb und Rot verfärben.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>How widths add up where branches meet: 2 is Leonardo&apos;s rule; less makes thicker trunks.</source>
        <translation>Wie sich die Dicken addieren, wo Äste zusammentreffen: 2 ist Leonardos Regel; weniger ergibt dickere Stämme.</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>Diameter of the thinnest twigs.</source>
        <translation>Durchmesser der dünnsten Zweige.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Diameter of the trunk at the ground; at 0 it follows from the exponent.</source>
        <translation>Durchmesser des Stamms am Boden; bei 0 folgt er aus dem Exponenten.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What the bark looks like.</source>
        <translation>Wie die Rinde aussieht.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Length of trunk after which the bark&apos;s pattern repeats.</source>
        <translation>Stammlänge, nach der sich das Rindenmuster wiederholt.</translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation>Trieb</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Gravimorphism</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Gestalt</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Rinde</translation>
    </message>
    <message>
        <source>ovate</source>
        <translation>eiförmig</translation>
    </message>
    <message>
        <source>lanceolate</source>
        <translation>lanzettlich</translation>
    </message>
    <message>
        <source>lobed</source>
        <translation>gelappt</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>Nadeln</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>gefurcht</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>plattig</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>Birke</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Dahinter</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Ground below the tree, with the tree&apos;s shadow.</source>
        <translation>Boden unter dem Baum, mit dem Schatten des Baums.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Lines on the ground, a metre apart.</source>
        <translation>Linien auf dem Boden, im Abstand von einem Meter.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Shadows of the sun.</source>
        <translation>Schatten der Sonne.</translation>
    </message>
    <message>
        <source>Show the sun</source>
        <translation>Sonne zeigen</translation>
    </message>
    <message>
        <source>Show the sun as a ball that you can drag around the tree.</source>
        <translation>Die Sonne als Kugel zeigen, die sich um den Baum ziehen lässt.</translation>
    </message>
    <message>
        <source>Pin the sun</source>
        <translation>Sonne anheften</translation>
    </message>
    <message>
        <source>The sun stays where it is on the screen when the tree is turned; otherwise it turns with the tree.</source>
        <translation>Die Sonne behält ihren Ort auf dem Bildschirm, wenn der Baum gedreht wird; sonst dreht sie sich mit dem Baum.</translation>
    </message>
    <message>
        <source>Where the sun stands: 0° in front of the tree, 90° to its right; for a pinned sun, as seen on the screen.</source>
        <translation>Wo die Sonne steht: 0° vor dem Baum, 90° rechts von ihm; bei angehefteter Sonne aus der Sicht des Betrachters.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>How high the sun stands above the horizon.</source>
        <translation>Wie hoch die Sonne über dem Horizont steht.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How opaque the picture is.</source>
        <translation>Wie deutlich das Bild zu sehen ist.</translation>
    </message>
    <message>
        <source>How tall the picture is.</source>
        <translation>Wie hoch das Bild ist.</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is to the right of the seedling.</source>
        <translation>Wo die Mitte des Bilds neben dem Sämling liegt.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is above the seedling.</source>
        <translation>Wo die Mitte des Bilds über dem Sämling liegt.</translation>
    </message>
    <message>
        <source>studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>Horizont</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>einfarbig</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>Farbverlauf</translation>
    </message>
    <message>
        <source>Gravitropic set-point angle: orthotropic at 0°, plagiotropic near 90°, positively gravitropic beyond.</source>
        <translation>Gravitroper Sollwinkel: orthotrop bei 0°, plagiotrop nahe 90°, darüber positiv gravitrop.</translation>
    </message>
    <message>
        <source>Buds above and below</source>
        <translation>Knospen oben und unten</translation>
    </message>
    <message>
        <source>Vertical semi-axis of the gravimorphic ellipse.</source>
        <translation>Senkrechte Halbachse der gravimorphen Ellipse.</translation>
    </message>
    <message>
        <source>Buds on the sides</source>
        <translation>Knospen seitlich</translation>
    </message>
    <message>
        <source>Semi-axis parallel to the ground; if it is the greater one, amphitony.</source>
        <translation>Halbachse parallel zum Boden; ist sie die größere, herrscht Amphitonie.</translation>
    </message>
    <message>
        <source>Upper or lower buds</source>
        <translation>Ober- oder Unterseite</translation>
    </message>
    <message>
        <source>Displacement of the ellipse: epitony above 0, hypotony below.</source>
        <translation>Verschiebung der Ellipse: Epitonie über 0, Hypotonie darunter.</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral bud on its axis.</source>
        <translation>Ansatzwinkel einer Seitenknospe an ihrer Achse.</translation>
    </message>
    <message>
        <source>How far the main axis gives way to a lateral: a tendency to sympodial growth.</source>
        <translation>Die Hauptachse weicht einer Seitenachse aus, in Richtung sympodialen Wuchses.</translation>
    </message>
    <message>
        <source>Weight of the heading H of the axis.</source>
        <translation>Gewicht der Richtung H der Achse.</translation>
    </message>
    <message>
        <source>Weight of gravitropism T.</source>
        <translation>Gewicht des Gravitropismus T.</translation>
    </message>
    <message>
        <source>Weight of the environment E: the mean direction of the free space that a bud perceives.</source>
        <translation>Gewicht der Umgebung E: die mittlere Richtung des freien Raums, den eine Knospe wahrnimmt.</translation>
    </message>
    <message>
        <source>Radius of the zone of occupancy.</source>
        <translation>Radius der belegten Zone.</translation>
    </message>
    <message>
        <source>Depth of the volume of perception, which reaches to r + d.</source>
        <translation>Tiefe des Wahrnehmungsraums, der bis r + d reicht.</translation>
    </message>
    <message>
        <source>Apex angle of the cone of perception.</source>
        <translation>Öffnungswinkel des Wahrnehmungskegels.</translation>
    </message>
    <message>
        <source>Excurrent forms above 0.5, decurrent ones below.</source>
        <translation>Exkurrente Wuchsformen über 0,5, dekurrente darunter.</translation>
    </message>
    <message>
        <source>Exponent of the response to light: high for light-demanding trees, low for shade-tolerant ones.</source>
        <translation>Exponent der Reaktion auf Licht: hoch bei Lichtbaumarten, niedrig bei Schattenbaumarten.</translation>
    </message>
    <message>
        <source>Threshold of cladoptosis: vigour per internode, relative to that of the whole tree.</source>
        <translation>Schwelle der Kladoptose: Wuchskraft je Internodium, bezogen auf die des ganzen Baums.</translation>
    </message>
    <message>
        <source>Metamers of the strongest shoot of a flush.</source>
        <translation>Metamere des stärksten Triebs eines Austriebs.</translation>
    </message>
    <message>
        <source>Divergence angle: spiral, distichous, decussate.</source>
        <translation>Divergenzwinkel: spiralig, zweizeilig, kreuzgegenständig.</translation>
    </message>
    <message>
        <source>The set-point angle is inferred from the direction of the stroke.</source>
        <translation>Der Sollwinkel wird aus der Richtung des Strichs abgeleitet.</translation>
    </message>
    <message>
        <source>The axis of order 0 is orthotropic, as in most conifers.</source>
        <translation>Die Achse der Ordnung 0 ist orthotrop, wie bei den meisten Nadelbäumen.</translation>
    </message>
    <message>
        <source>Length of a metamer.</source>
        <translation>Länge eines Metamers.</translation>
    </message>
    <message>
        <source>Alternate, opposite or verticillate.</source>
        <translation>Wechselständig, gegenständig oder quirlständig.</translation>
    </message>
    <message>
        <source>Variance of the angles and of the metamers.</source>
        <translation>Varianz der Winkel und der Metamere.</translation>
    </message>
    <message>
        <source>Intensity of the penumbra that a metamer casts.</source>
        <translation>Stärke des Halbschattens, den ein Metamer wirft.</translation>
    </message>
    <message>
        <source>Base of the shadow&apos;s decay from layer to layer.</source>
        <translation>Basis der Abnahme von Schicht zu Schicht.</translation>
    </message>
    <message>
        <source>Height of the pyramid of shadow, in voxels.</source>
        <translation>Höhe der Schattenpyramide, in Voxeln.</translation>
    </message>
    <message>
        <source>Density of the markers of free space.</source>
        <translation>Dichte der Marker freien Raums.</translation>
    </message>
    <message>
        <source>Maximum age of a marker.</source>
        <translation>Höchstalter eines Markers.</translation>
    </message>
    <message>
        <source>Markers generated in each volume of perception.</source>
        <translation>In jedem Wahrnehmungsraum erzeugte Marker.</translation>
    </message>
    <message>
        <source>Leafy internodes</source>
        <translation>Nur an den Spitzen</translation>
    </message>
    <message>
        <source>How many internodes of a shoot bear leaves, counted from its tip.</source>
        <translation>Blätter wachsen von der Spitze eines Triebs so viele Internodien abwärts und nicht weiter.</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>How strong the colour is: low values suit blossom and silvery leaves.</source>
        <translation>Wie kräftig die Farbe ist: wenig davon ergibt Blüten und silbrige Blätter.</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>How bright the leaves are.</source>
        <translation>Wie hell die Blätter sind.</translation>
    </message>
    <message>
        <source>Yellowing</source>
        <translation>Vergilbung</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>How much the trunk spreads where it meets the ground.</source>
        <translation>Wie sehr sich der Stamm am Boden verbreitert.</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>Verzweigung</translation>
    </message>
    <message>
        <source>Vigour</source>
        <translation>Wuchskraft</translation>
    </message>
    <message>
        <source>Habit</source>
        <translation>Habitus</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Beschattung</translation>
    </message>
    <message>
        <source>Room to grow</source>
        <translation>Wuchsraum</translation>
    </message>
    <message>
        <source>cordate</source>
        <translation>herzförmig</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>handförmig</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>gefiedert</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>Weide</translation>
    </message>
    <message>
        <source>fascicle</source>
        <translation>Büschel</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>Wedel</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>Kirsche</translation>
    </message>
    <message>
        <source>mottled</source>
        <translation>gefleckt</translation>
    </message>
    <message>
        <source>fibrous</source>
        <translation>faserig</translation>
    </message>
    <message>
        <source>ringed</source>
        <translation>geringelt</translation>
    </message>
    <message>
        <source>What stands behind the tree. The studio is dark or light, as the theme is.</source>
        <translation>Was hinter dem Baum steht. Das Studio ist dunkel oder hell, wie das Programm.</translation>
    </message>
    <message>
        <source>dark_studio</source>
        <translation>dunkles Studio</translation>
    </message>
    <message>
        <source>light_studio</source>
        <translation>helles Studio</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>A pen&apos;s pressure scales the brush: the radius is what a firm hand reaches.</source>
        <translation>Der Stiftdruck bestimmt die Größe des Pinsels mit: Den ganzen Radius erreicht eine feste Hand.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads, and that shoots grow towards.</source>
        <translation>Die Punkte freien Raums zeigen, die der Pinsel verteilt und zu denen die Triebe wachsen.</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Zeichenebene</translation>
    </message>
    <message>
        <source>Show how deep in the tree the brush draws: a faint grid around it.</source>
        <translation>Zeigen, in welcher Tiefe des Baums der Pinsel zeichnet: ein blasses Gitter um ihn herum.</translation>
    </message>
    <message>
        <source>Hazel</source>
        <translation>Hasel</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>Eiche</translation>
    </message>
    <message>
        <source>Maple</source>
        <translation>Ahorn</translation>
    </message>
    <message>
        <source>Elm</source>
        <translation>Ulme</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>Pappel</translation>
    </message>
    <message>
        <source>Spruce</source>
        <translation>Fichte</translation>
    </message>
    <message>
        <source>Pine</source>
        <translation>Kiefer</translation>
    </message>
    <message>
        <source>Acacia</source>
        <translation>Akazie</translation>
    </message>
    <message>
        <source>Apple</source>
        <translation>Apfelbaum</translation>
    </message>
    <message>
        <source>Joshua tree</source>
        <translation>Josuabaum</translation>
    </message>
    <message>
        <source>Buds</source>
        <translation>Knospen</translation>
    </message>
    <message>
        <source>How many buds a tap adds, in a spiral around the branch.</source>
        <translation>Wie viele Knospen ein Tippen hinzufügt, in einer Spirale um den Ast.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>How far one bud is from the next along the branch: 0 is a whorl.</source>
        <translation>Wie weit eine Knospe am Ast entlang von der nächsten entfernt ist: 0 ist ein Quirl.</translation>
    </message>
    <message>
        <source>Self-organising competition, or shoot growth by vigour with apical control.</source>
        <translation>Selbstorganisierende Konkurrenz, oder Triebwachstum nach Wuchskraft mit Apikalkontrolle.</translation>
    </message>
    <message>
        <source>Growth in a year</source>
        <translation>Jahreszuwachs</translation>
    </message>
    <message>
        <source>How much the strongest shoot grows in full light, in twelve steps.</source>
        <translation>Wie viel der stärkste Trieb bei vollem Licht in zwölf Schritten wächst.</translation>
    </message>
    <message>
        <source>Annual elongation of a shoot.</source>
        <translation>Jährliche Streckung eines Triebs.</translation>
    </message>
    <message>
        <source>Length of internodes</source>
        <translation>Internodienlänge</translation>
    </message>
    <message>
        <source>An internode lengthens over several steps, up to this.</source>
        <translation>Ein Internodium streckt sich über mehrere Schritte, bis zu dieser Länge.</translation>
    </message>
    <message>
        <source>Length of a mature metamer.</source>
        <translation>Länge eines ausgewachsenen Metamers.</translation>
    </message>
    <message>
        <source>Angle of laterals</source>
        <translation>Seitentriebwinkel</translation>
    </message>
    <message>
        <source>Between an axis and a branch that begins on it.</source>
        <translation>Zwischen einer Achse und einem Ast, der an ihr beginnt.</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral shoot.</source>
        <translation>Ansatzwinkel eines Seitentriebs.</translation>
    </message>
    <message>
        <source>Lateral buds</source>
        <translation>Seitenknospen</translation>
    </message>
    <message>
        <source>At each node: one makes a spiral, two crossed pairs, more a whorl.</source>
        <translation>An jedem Knoten: eine ergibt eine Spirale, zwei gekreuzte Paare, mehr einen Quirl.</translation>
    </message>
    <message>
        <source>Variation in roll</source>
        <translation>Drehstreuung</translation>
    </message>
    <message>
        <source>How irregularly branches stand around their axis.</source>
        <translation>Wie unregelmäßig Äste um ihre Achse stehen.</translation>
    </message>
    <message>
        <source>Standard deviation of the divergence angle.</source>
        <translation>Standardabweichung des Divergenzwinkels.</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>Schlängeln</translation>
    </message>
    <message>
        <source>How much an axis changes its direction from node to node.</source>
        <translation>Wie sehr eine Achse von Knoten zu Knoten ihre Richtung ändert.</translation>
    </message>
    <message>
        <source>Standard deviation of the apical angle.</source>
        <translation>Standardabweichung des Apikalwinkels.</translation>
    </message>
    <message>
        <source>Branch orders</source>
        <translation>Astordnungen</translation>
    </message>
    <message>
        <source>How many orders of branches there are at most: branches, their branches, and so on.</source>
        <translation>Äste von Ästen von Ästen: so viele Ordnungen und nicht mehr.</translation>
    </message>
    <message>
        <source>Highest order of an axis.</source>
        <translation>Höchste Ordnung einer Achse.</translation>
    </message>
    <message>
        <source>Flushing</source>
        <translation>Austriebsfreude</translation>
    </message>
    <message>
        <source>How readily lateral buds become branches.</source>
        <translation>Wie leicht Seitenknospen zu Ästen werden.</translation>
    </message>
    <message>
        <source>Chance of lateral bud break for each internode of growth.</source>
        <translation>Wahrscheinlichkeit des Austriebs von Seitenknospen je Internodium Zuwachs.</translation>
    </message>
    <message>
        <source>Inhibition</source>
        <translation>Hemmung</translation>
    </message>
    <message>
        <source>How strongly growing tips hold back the buds below them.</source>
        <translation>Wie stark wachsende Spitzen die Knospen unter ihnen zurückhalten.</translation>
    </message>
    <message>
        <source>Apical dominance: auxin from lit apical buds.</source>
        <translation>Apikaldominanz: Auxin aus belichteten Endknospen.</translation>
    </message>
    <message>
        <source>Decay of the inhibitor on its way down.</source>
        <translation>Abnahme des Hemmstoffs auf dem Weg nach unten.</translation>
    </message>
    <message>
        <source>Apical control</source>
        <translation>Apikalkontrolle</translation>
    </message>
    <message>
        <source>Above 1 the trunk outgrows its branches, as in a spruce; below 1 they outgrow it.</source>
        <translation>Über 1 wächst der Stamm seinen Ästen davon, wie bei einer Fichte; unter 1 wachsen sie ihm davon.</translation>
    </message>
    <message>
        <source>Excurrent above 1, decurrent below.</source>
        <translation>Exkurrent über 1, dekurrent darunter.</translation>
    </message>
    <message>
        <source>Loss with distance</source>
        <translation>Müde in der Ferne</translation>
    </message>
    <message>
        <source>How much less a shoot grows far from the root.</source>
        <translation>Wie viel weniger Triebe wachsen, die weit von der Wurzel entfernt sind.</translation>
    </message>
    <message>
        <source>Decay of the potential with the distance to the root.</source>
        <translation>Abnahme des Potenzials mit der Entfernung zur Wurzel.</translation>
    </message>
    <message>
        <source>Loss with height</source>
        <translation>Müde in der Höhe</translation>
    </message>
    <message>
        <source>How much less a shoot grows the higher it is: more makes the crown flat.</source>
        <translation>Wie viel weniger Triebe in der Höhe wachsen: mehr ergibt flache Kronen.</translation>
    </message>
    <message>
        <source>Decay of the potential with height.</source>
        <translation>Abnahme des Potenzials mit der Höhe.</translation>
    </message>
    <message>
        <source>Gravitropism</source>
        <translation>Gravitropismus</translation>
    </message>
    <message>
        <source>Above 0 shoots turn upwards at each node, below 0 downwards.</source>
        <translation>Über 0 wenden sich Triebe an jedem Knoten nach oben, unter 0 Äste nach unten.</translation>
    </message>
    <message>
        <source>Orthotropic above 0, positively gravitropic below.</source>
        <translation>Orthotrop über 0, positiv gravitrop darunter.</translation>
    </message>
    <message>
        <source>Phototropism</source>
        <translation>Phototropismus</translation>
    </message>
    <message>
        <source>How far shoots turn to the light at each node.</source>
        <translation>Wie weit sich Triebe an jedem Knoten zum Licht wenden.</translation>
    </message>
    <message>
        <source>Growth towards the brightest direction.</source>
        <translation>Wachstum in die hellste Richtung.</translation>
    </message>
    <message>
        <source>Level branches</source>
        <translation>Waagerechte Äste</translation>
    </message>
    <message>
        <source>How far a new branch turns towards the horizontal where it begins.</source>
        <translation>Wie weit sich ein neuer Ast an seinem Anfang zur Waagerechten wendet.</translation>
    </message>
    <message>
        <source>Plagiotropy of lateral shoots.</source>
        <translation>Plagiotropie der Seitentriebe.</translation>
    </message>
    <message>
        <source>Sagging</source>
        <translation>Durchhang</translation>
    </message>
    <message>
        <source>How far branches sag under their weight as they grow.</source>
        <translation>Wie weit sich Äste im Wachsen unter ihrem Gewicht senken.</translation>
    </message>
    <message>
        <source>Gravimorphic bending by branch load.</source>
        <translation>Gravimorphe Biegung durch die Last der Äste.</translation>
    </message>
    <message>
        <source>Stiffness with age</source>
        <translation>Steif im Alter</translation>
    </message>
    <message>
        <source>How much thick wood resists: at high values only the thin ends bend.</source>
        <translation>Wie sehr dickes Holz widersteht: mehr biegt nur die dünnen Enden.</translation>
    </message>
    <message>
        <source>Exponent of thickness in flexural stiffness.</source>
        <translation>Exponent der Dicke in der Biegesteifigkeit.</translation>
    </message>
    <message>
        <source>Greatest sag</source>
        <translation>Größter Durchhang</translation>
    </message>
    <message>
        <source>An internode sags by at most this share of the angle between it and straight down.</source>
        <translation>Je Internodium höchstens dieser Teil des Winkels bis senkrecht nach unten.</translation>
    </message>
    <message>
        <source>Limit of the bend of an internode.</source>
        <translation>Grenze der Biegung eines Internodiums.</translation>
    </message>
    <message>
        <source>Shade pruning</source>
        <translation>Schattenabwurf</translation>
    </message>
    <message>
        <source>Branch ends that get less light than this drop off.</source>
        <translation>Astenden mit weniger Licht als diesem fallen ab.</translation>
    </message>
    <message>
        <source>Cladoptosis of shaded shoots.</source>
        <translation>Kladoptose beschatteter Triebe.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Tubes: each branch is a tube that begins inside its parent. Strands: the wood is bundles of strands, which run from every tip to the ground, under one closed bark.</source>
        <translation>Röhren: Jeder Ast ist eine Röhre, die in dem Ast beginnt, der ihn trägt. Stränge: Das Holz besteht aus Bündeln von Strängen, die von jeder Spitze bis zum Boden laufen, unter einer geschlossenen Rinde.</translation>
    </message>
    <message>
        <source>Strands at a tip</source>
        <translation>Stränge je Spitze</translation>
    </message>
    <message>
        <source>How many strands begin at each tip. More make a smoother surface, and branches that separate more clearly.</source>
        <translation>Wie viele Stränge an jeder Spitze beginnen. Mehr ergeben eine glattere Oberfläche und Äste, die sich deutlicher trennen.</translation>
    </message>
    <message>
        <source>Strand radius</source>
        <translation>Strangradius</translation>
    </message>
    <message>
        <source>How thick each strand is. Above 0, the trunk gets as thick as its strands make it; at 0 it keeps the width that it has.</source>
        <translation>Wie dick jeder Strang ist. Der Stamm wird dann so dick, wie seine Stränge es verlangen; bei 0 behält er seine Dicke.</translation>
    </message>
    <message>
        <source>Cohesion</source>
        <translation>Zusammenhalt</translation>
    </message>
    <message>
        <source>Branches separate at a fork where their strands are further apart than this many strand radii: low values part them early, high ones late.</source>
        <translation>Äste trennen sich an einer Gabel dort, wo ihre Stränge mehr als so viele Strangradien auseinanderliegen: niedrig früh, hoch spät.</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Packung</translation>
    </message>
    <message>
        <source>How the strands of a section are pressed together. At rest: until none overlaps. As published: by the paper&apos;s simulation, which stops before that.</source>
        <translation>Wie die Stränge eines Querschnitts aneinandergedrückt werden. In Ruhe: bis sich keine mehr überlappen. Wie publiziert: mit der Simulation des Fachartikels, die auf dem Weg dorthin stehen bleibt.</translation>
    </message>
    <message>
        <source>Packing steps</source>
        <translation>Packungsschritte</translation>
    </message>
    <message>
        <source>For how long strands are pressed together at each node. With few steps, the shape of a fork is kept further down the trunk; with many, the trunk is round at once.</source>
        <translation>Wie lange Stränge an jedem Knoten aneinandergedrückt werden. Wenige Schritte erhalten die Form einer Gabel weiter den Stamm hinab; viele machen ihn gleich rund.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>How far the ridges of single strands are smoothed: 0 shows each of them.</source>
        <translation>Wie weit die Wülste einzelner Stränge geglättet werden: 0 zeigt jeden von ihnen.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Bud break</source>
        <translation>Austrieb</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Tropisms</source>
        <translation>Tropismen</translation>
    </message>
    <message>
        <source>Weight and shade</source>
        <translation>Gewicht und Schatten</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>Stränge</translation>
    </message>
    <message>
        <source>vigour</source>
        <translation>Wuchskraft</translation>
    </message>
    <message>
        <source>tubes</source>
        <translation>Röhren</translation>
    </message>
    <message>
        <source>strands</source>
        <translation>Stränge</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>wie publiziert</translation>
    </message>
    <message>
        <source>Branches too</source>
        <translation>Auch die Äste</translation>
    </message>
    <message>
        <source>A drag twists all that the branch carries, not only the branch itself. Hold Shift for the opposite.</source>
        <translation>Ein Ziehen verdreht alles, was der Ast trägt, nicht nur den Ast selbst. Umschalt bewirkt das Gegenteil, solange es gedrückt ist.</translation>
    </message>
    <message>
        <source>Fading of the inhibition</source>
        <translation>Abklingen der Hemmung</translation>
    </message>
    <message>
        <source>The share that is lost at each internode: higher values let buds break nearer to the tip.</source>
        <translation>Der Anteil, der an jedem Internodium verloren geht: Mehr lässt Knospen näher an der Spitze austreiben.</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Riefen</translation>
    </message>
    <message>
        <source>How far the trunk bulges below its limbs and towards its roots, and how deep the hollows of lost limbs are. At 0 the wood is round.</source>
        <translation>Wie weit sich der Stamm unter seinen Ästen und zu den Wurzeln hin wölbt und wie tief die Höhlungen verlorener Äste sind. Bei 0 ist das Holz rund.</translation>
    </message>
    <message>
        <source>Growth model</source>
        <translation>Wachstumsmodell</translation>
    </message>
    <message>
        <source>TreeSketch: buds compete for space and light. Vigour: light decides how fast each shoot grows, month by month.</source>
        <translation>TreeSketch: Knospen konkurrieren um Raum und Licht. Wuchskraft: Das Licht entscheidet, wie schnell jeder Trieb wächst, Monat für Monat.</translation>
    </message>
    <message>
        <source>TreeSketch</source>
        <translation>TreeSketch</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>A stroke takes away: a branch that it crosses once is cut there, one that it crosses twice is erased. Shift or a pen&apos;s eraser does so, too.</source>
        <translation>Ein Strich nimmt weg: ein Ast, den er einmal kreuzt, wird dort abgeschnitten, einer, den er zweimal kreuzt, wird gelöscht. Mit Umschalt oder dem Radierer eines Stifts geht es auch.</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Each branch is drawn on the other side of the trunk as well.</source>
        <translation>Jeder Ast wird auch auf der anderen Seite des Stamms gezeichnet.</translation>
    </message>
    <message>
        <source>Fill the sides</source>
        <translation>Seiten füllen</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Krone</translation>
    </message>
    <message>
        <source>How much wider than the drawing the crown may be in depth.</source>
        <translation>Wie viel breiter als die Zeichnung die Krone in der Tiefe sein darf.</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>How much longer branches may become in depth than those you drew.</source>
        <translation>Wie viel länger als gezeichnete die Äste in der Tiefe werden dürfen.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>How much wider an angle between branches may be than the widest you drew.</source>
        <translation>Wie viel weiter als der weiteste gezeichnete ein Winkel zwischen Ästen sein darf.</translation>
    </message>
    <message>
        <source>Pass on</source>
        <translation>Weitergeben</translation>
    </message>
    <message>
        <source>A tap on a branch gives other branches what it carries. Otherwise it adds one branch like those that the branch carries.</source>
        <translation>Ein Tippen auf einen Ast gibt anderen Ästen, was er trägt. Sonst bekommt er einen Ast mehr wie die, die er trägt.</translation>
    </message>
    <message>
        <source>Only to similar ones</source>
        <translation>An seinesgleichen</translation>
    </message>
    <message>
        <source>Only branches that are equally many forks away from the trunk get it.</source>
        <translation>Nur Äste mit ebenso vielen Verzweigungen unter sich bekommen es.</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Skaliert</translation>
    </message>
    <message>
        <source>What a branch gets is scaled to the size of that branch. Otherwise it keeps its size, and its distance from the tip.</source>
        <translation>Was ein Ast bekommt, ist größer oder kleiner, wie der Ast es ist. Sonst behält es seine Größe und seinen Abstand von der Spitze.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>An seiner Stelle</translation>
    </message>
    <message>
        <source>What the branches carried until now is removed.</source>
        <translation>Was die Äste bisher trugen, verschwindet.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>How much the angles and lengths of a variation deviate from those of the tree.</source>
        <translation>Wie sehr Winkel und Längen einer Abwandlung vom Baum abweichen.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Which variation it is: the same number always gives the same variation of a tree.</source>
        <translation>Welche Abwandlung es ist: dieselbe Nummer macht aus demselben Baum denselben.</translation>
    </message>
    <message>
        <source>Two sides</source>
        <translation>Zwei Seiten</translation>
    </message>
    <message>
        <source>Two strokes in a row, drawn side by side, are the two sides of one branch, which gets its width from them.</source>
        <translation>Zwei Striche nebeneinander, einer nach dem anderen, sind die beiden Seiten eines Astes, der von ihnen seine Dicke hat.</translation>
    </message>
    <message>
        <source>The drawing is placed twice, the second time turned by 90° around the trunk, so that the tree is as full from the side as from the front. Without this, its branches themselves run towards you and away from you.</source>
        <translation>Die Zeichnung wird zweimal eingesetzt, das zweite Mal um 90° um den Stamm gedreht, sodass der Baum von der Seite so voll ist wie von vorn. Ohne dies laufen die Äste selbst auf Sie zu und von Ihnen weg.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Where strokes go in depth. Screen: as deep as the branch that they begin at. Trunk: in the plane through the trunk and the branch that they begin at. Spread: each limb that begins at the trunk is turned into the widest gap, as long and as steep as you draw it.</source>
        <translation>Wohin Striche in der Tiefe gehen. Bildschirm: so tief wie der Ast, an dem sie beginnen. Stamm: in der Ebene durch den Stamm und den Ast, an dem sie beginnen. Verteilt: Jeder Ast, der am Stamm beginnt, dreht sich in die breiteste Lücke, so lang und so steil wie gezeichnet.</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Ringsum</translation>
    </message>
    <message>
        <source>How many strokes are made around the trunk for each one that you draw.</source>
        <translation>Wie viele Striche rings um den Stamm entstehen für jeden, der gezeichnet wird.</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>Stamm</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Verteilt</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the brush, shared with the Brush tool.</source>
        <translation>Radius des Pinsels, derselbe wie der des malenden Pinsels.</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>Bis zu</translation>
    </message>
    <message>
        <source>The thickest wood that is removed, as a share of the trunk&apos;s width. Thicker branches stay, however often you brush over them.</source>
        <translation>Das dickste Holz, das fällt, als Anteil der Stammdicke. Dickere Äste bleiben, so oft man auch darüberstreicht.</translation>
    </message>
    <message>
        <source>Share of twigs</source>
        <translation>Nimmt</translation>
    </message>
    <message>
        <source>The share of the twigs under the brush that a stroke takes. They are chosen evenly along each limb.</source>
        <translation>Der Anteil der Zweige unter dem Pinsel, den ein Strich nimmt. Sie werden gleichmäßig entlang jedes Astes gewählt.</translation>
    </message>
    <message>
        <source>Far side too</source>
        <translation>Auch dahinter</translation>
    </message>
    <message>
        <source>A stroke reaches through the whole tree. Otherwise it takes only what is on your side of the trunk.</source>
        <translation>Ein Strich reicht durch den ganzen Baum. Sonst nimmt er nur, was diesseits des Stamms ist.</translation>
    </message>
    <message>
        <source>Straightening</source>
        <translation>Geradewachsen</translation>
    </message>
    <message>
        <source>How fast young wood smooths its bends as it grows on: 0 keeps every elbow.</source>
        <translation>Wie schnell junges Holz seine Knicke beim Weiterwachsen ausgleicht: 0 behält jeden Knick.</translation>
    </message>
    <message>
        <source>Reaction wood: an axis that takes over straightens.</source>
        <translation>Reaktionsholz: Eine Achse, die die Führung übernimmt, richtet sich gerade.</translation>
    </message>
</context>
<context>
    <name>ParametersJson</name>
    <message>
        <source>true or false is expected</source>
        <translation>true oder false wird erwartet</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>eines von diesen wird erwartet: %1</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>eine ganze Zahl wird erwartet</translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation>eine Zahl wird erwartet</translation>
    </message>
    <message>
        <source>%1 is not within %2…%3</source>
        <translation>%1 liegt nicht in %2…%3</translation>
    </message>
    <message>
        <source>axisWeight, tropismWeight and spaceWeight must not all be 0</source>
        <translation>axisWeight, tropismWeight und spaceWeight dürfen nicht alle 0 sein</translation>
    </message>
    <message>
        <source>it must not exceed 0.99 times ellipseVertical, which is %1</source>
        <translation>darf nicht über das 0,99-Fache von ellipseVertical (%1) hinausgehen</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>ein Objekt wird erwartet</translation>
    </message>
    <message>
        <source>there is no such parameter</source>
        <translation>einen solchen Parameter gibt es nicht</translation>
    </message>
    <message>
        <source>the name of an image is expected</source>
        <translation>der Name eines Bilds wird erwartet</translation>
    </message>
    <message>
        <source>there are no images here</source>
        <translation>hier gibt es keine Bilder</translation>
    </message>
</context>
<context>
    <name>PositionCheck</name>
    <message>
        <source>it and the later steps move a tree whose axes are longer than %1 m too often</source>
        <translation>er und die späteren Schritte bewegen einen Baum mit Achsen von mehr als %1 m zu oft</translation>
    </message>
    <message>
        <source>before it, internode %1 lies more than %2 m away</source>
        <translation>vor ihm liegt Internodium %1 weiter als %2 m entfernt</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>Schritt %1 der Geschichte</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>liegt weiter als %1 m entfernt</translation>
    </message>
    <message>
        <source>internode %1</source>
        <translation>Internodium %1</translation>
    </message>
</context>
<context>
    <name>ProfileJson</name>
    <message>
        <source>a profile is expected</source>
        <translation>ein Profil wird erwartet</translation>
    </message>
    <message>
        <source>at most %1 are possible</source>
        <translation>höchstens %1 sind möglich</translation>
    </message>
    <message>
        <source>lists of points [x, y] are expected</source>
        <translation>Listen von Punkten [x, y] werden erwartet</translation>
    </message>
</context>
<context>
    <name>ProfileTool</name>
    <message>
        <source>Tap a branch to see its cross-section, and draw another shape for it</source>
        <translation>Einen Ast antippen, um seinen Querschnitt zu sehen und ihm eine andere Form zu zeichnen</translation>
    </message>
</context>
<context>
    <name>Program</name>
    <message>
        <source>%1; see espalier --help</source>
        <translation>%1; siehe espalier --help</translation>
    </message>
    <message>
        <source>What you did is in a safety copy in %1; the next start offers it. The fault is described in %2.</source>
        <translation>Was Sie getan haben, ist in einer Sicherheitskopie in %1; der nächste Start bietet sie an. Der Fehler ist in %2 beschrieben.</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>pairs of an internode and a diameter are expected</source>
        <translation>Paare aus einem Internodium und einem Durchmesser werden erwartet</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>ein Objekt wird erwartet</translation>
    </message>
    <message>
        <source>it does not describe an Espalier project</source>
        <translation>beschreibt kein Espalier-Projekt</translation>
    </message>
    <message>
        <source>Espalier %1 wrote it in version %2 of the format; this is Espalier %3, which reads versions up to %4</source>
        <translation>Espalier %1 hat die Datei in Version %2 des Formats geschrieben; dies ist Espalier %3, das Versionen bis %4 liest</translation>
    </message>
    <message>
        <source>1 to %1 sets are expected</source>
        <translation>1 bis %1 Sätze werden erwartet</translation>
    </message>
    <message>
        <source>the lassos</source>
        <translation>die Lassos</translation>
    </message>
    <message>
        <source>their parts do not add up</source>
        <translation>ihre Teile passen nicht zusammen</translation>
    </message>
    <message>
        <source>the history</source>
        <translation>die Geschichte</translation>
    </message>
    <message>
        <source>its parts do not add up</source>
        <translation>die Teile passen nicht zusammen</translation>
    </message>
    <message>
        <source>the tree or its history is too large for a project file</source>
        <translation>der Baum oder seine Geschichte ist zu groß für eine Projektdatei</translation>
    </message>
    <message>
        <source>at most %1 images are expected</source>
        <translation>höchstens %1 Bilder werden erwartet</translation>
    </message>
    <message>
        <source>the image “%1” is missing from it or broken; the built-in look is shown instead</source>
        <translation>das Bild „%1“ fehlt darin oder ist beschädigt; stattdessen erscheint das von Espalier gezeichnete Aussehen</translation>
    </message>
    <message>
        <source>they have too many points</source>
        <translation>haben zu viele Punkte</translation>
    </message>
    <message>
        <source>indices of strokes are expected</source>
        <translation>Indizes von Strichen werden erwartet</translation>
    </message>
    <message>
        <source>the record of what was done</source>
        <translation>die Aufzeichnung dessen, was getan wurde</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>Schritt %1 der Geschichte</translation>
    </message>
    <message>
        <source>the record of what was done is not a JSON object</source>
        <translation>die Aufzeichnung dessen, was getan wurde, ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>die Profile</translation>
    </message>
    <message>
        <source>there are too many</source>
        <translation>es sind zu viele</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>true oder false wird erwartet</translation>
    </message>
    <message>
        <source>a colour such as #5c6268 is expected</source>
        <translation>eine Farbe wie #5c6268 wird erwartet</translation>
    </message>
    <message>
        <source>there is no backdrop of this name</source>
        <translation>einen Hintergrund dieses Namens gibt es nicht</translation>
    </message>
    <message>
        <source>its background and light cannot be read (%1); those of a new tree are shown instead</source>
        <translation>Hintergrund und Licht darin lassen sich nicht lesen (%1); stattdessen zeigen sich die eines neuen Baums</translation>
    </message>
    <message>
        <source>the reference picture “%1” is missing from it or broken</source>
        <translation>das Vorlagenbild „%1“ fehlt darin oder ist beschädigt</translation>
    </message>
    <message>
        <source>a change of the history</source>
        <translation>eine Änderung der Geschichte</translation>
    </message>
    <message>
        <source>it does not follow on from what is before it</source>
        <translation>sie schließt nicht an das an, was vor ihr steht</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>some of what other programs have put into it cannot be kept</source>
        <translation>manches, was andere Programme hineingelegt haben, lässt sich nicht behalten</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>a stroke needs at least one point</source>
        <translation>ein Strich hat mindestens einen Punkt</translation>
    </message>
    <message>
        <source>1 to %1 strokes are expected</source>
        <translation>1 bis %1 Striche werden erwartet</translation>
    </message>
    <message>
        <source>internode %1 is a root, which cannot be pruned</source>
        <translation>Internodium %1 ist eine Wurzel, die nicht geschnitten werden kann</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>für weitere Parametersätze ist kein Platz</translation>
    </message>
    <message>
        <source>there is no such bud</source>
        <translation>eine solche Knospe gibt es nicht</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>ein Objekt wird erwartet</translation>
    </message>
    <message>
        <source>a number other than 0 is expected</source>
        <translation>eine andere Zahl als 0 wird erwartet</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample</source>
        <translation>ein Strich hat mindestens einen Stützpunkt</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 samples</source>
        <translation>ein Rezept hat höchstens %1 Stützpunkte</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected</source>
        <translation>drei Zahlen innerhalb von ±%1 werden erwartet</translation>
    </message>
    <message>
        <source>right and up must have length 1 and be at right angles</source>
        <translation>right und up müssen die Länge 1 haben und im rechten Winkel stehen</translation>
    </message>
    <message>
        <source>a lasso needs at least three points</source>
        <translation>ein Lasso hat mindestens drei Punkte</translation>
    </message>
    <message>
        <source>two numbers within ±%1 are expected, right and up, in m</source>
        <translation>zwei Zahlen innerhalb von ±%1 werden erwartet, right und up, in m</translation>
    </message>
    <message>
        <source>1 to %1 internodes are expected</source>
        <translation>1 bis %1 Internodien werden erwartet</translation>
    </message>
    <message>
        <source>an array of five numbers is expected: time, x, y, z, radius</source>
        <translation>ein Array aus fünf Zahlen wird erwartet: Zeit, x, y, z, Radius</translation>
    </message>
    <message>
        <source>the time is not within 0…%1 s</source>
        <translation>die Zeit liegt nicht in 0…%1 s</translation>
    </message>
    <message>
        <source>the time does not go forwards</source>
        <translation>die Zeit geht nicht vorwärts</translation>
    </message>
    <message>
        <source>a coordinate is not within ±%1 m</source>
        <translation>eine Koordinate liegt nicht innerhalb von ±%1 m</translation>
    </message>
    <message>
        <source>the radius is not within 0…%1 m</source>
        <translation>der Radius liegt nicht in 0…%1 m</translation>
    </message>
    <message>
        <source>a bend needs 1 to %1 handles</source>
        <translation>eine Biegung hat 1 bis %1 Griffe</translation>
    </message>
    <message>
        <source>an array of three numbers within ±%1 is expected</source>
        <translation>ein Array aus drei Zahlen innerhalb von ±%1 wird erwartet</translation>
    </message>
    <message>
        <source>there is no view “%1”; there are front, side, top and three-quarter</source>
        <translation>es gibt keine Ansicht „%1“; es gibt front, side, top und three-quarter</translation>
    </message>
    <message>
        <source>this is not a recipe: a recipe begins with “%1”: %2</source>
        <translation>dies ist kein Rezept: eines beginnt mit „%1“: %2</translation>
    </message>
    <message>
        <source>the recipe is of version %1; this program reads versions up to %2</source>
        <translation>das Rezept hat Version %1, dieses Programm liest Versionen bis %2</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 operations</source>
        <translation>ein Rezept hat höchstens %1 Operationen</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 images</source>
        <translation>ein Rezept hat höchstens %1 Bilder</translation>
    </message>
    <message>
        <source>a path relative to the recipe is expected</source>
        <translation>ein Pfad relativ zum Rezept wird erwartet</translation>
    </message>
    <message>
        <source>internode %1 is not on the branch above internode %2</source>
        <translation>Internodium %1 liegt nicht auf dem Ast oberhalb von Internodium %2</translation>
    </message>
    <message>
        <source>nothing grew</source>
        <translation>nichts ist gewachsen</translation>
    </message>
    <message>
        <source>internode %1 has no bud %2</source>
        <translation>Internodium %1 hat keine Knospe %2</translation>
    </message>
    <message>
        <source>%1 hexadecimal digits are expected</source>
        <translation>%1 hexadezimale Ziffern werden erwartet</translation>
    </message>
    <message>
        <source>a key (“key”) or a place (“at”) is expected</source>
        <translation>ein Schlüssel („key“) oder ein Ort („at“) wird erwartet</translation>
    </message>
    <message>
        <source>there is no internode %1</source>
        <translation>es gibt kein Internodium %1</translation>
    </message>
    <message>
        <source>there is no internode with the key %1</source>
        <translation>es gibt kein Internodium mit dem Schlüssel %1</translation>
    </message>
    <message>
        <source>there is no internode near (%1, %2, %3) m</source>
        <translation>es gibt kein Internodium nahe (%1, %2, %3) m</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1 is expected</source>
        <translation>eine ganze Zahl von 0 bis %1 wird erwartet</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; und %2 weitere</translation>
    </message>
    <message>
        <source>there is no operation “%1”; there are %2</source>
        <translation>es gibt keine Operation „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>there are only %1 commands to redo, not %2</source>
        <translation>Befehle zum Wiederherstellen: nur %1, nicht %2</translation>
    </message>
    <message>
        <source>there is no envelope</source>
        <translation>es gibt keine Hülle</translation>
    </message>
    <message>
        <source>internode %1 has no width to take away</source>
        <translation>Internodium %1 hat keine Dicke, die sich freigeben lässt</translation>
    </message>
    <message>
        <source>the history goes back only by %1, not by %2</source>
        <translation>die Geschichte reicht nur um %1 zurück, nicht um %2</translation>
    </message>
    <message>
        <source>the history goes on only by %1, not by %2</source>
        <translation>die Geschichte geht nur um %1 weiter, nicht um %2</translation>
    </message>
    <message>
        <source>there are only %1 commands to undo, not %2</source>
        <translation>Befehle zum Rückgängigmachen: nur %1, nicht %2</translation>
    </message>
    <message>
        <source>a target for each handle is expected</source>
        <translation>für jeden Griff wird ein Ziel erwartet</translation>
    </message>
    <message>
        <source>arrays of three numbers within ±%1 are expected</source>
        <translation>Felder aus drei Zahlen innerhalb von ±%1 werden erwartet</translation>
    </message>
    <message>
        <source>there are more than %1</source>
        <translation>es sind mehr als %1</translation>
    </message>
    <message>
        <source>“%1” must be given with them</source>
        <translation>dazu gehört „%1“</translation>
    </message>
    <message>
        <source>1 to %1 envelopes are expected</source>
        <translation>1 bis %1 Hüllen werden erwartet</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: of its %1 steps, %2 (%3) were made by a version of Espalier that did not record how</source>
        <translation>die Geschichte des Baums kann kein Rezept werden: von ihren %1 Schritten stammen %2 (%3) von einer Version von Espalier, die nicht aufzeichnete, wie sie entstanden</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: it does not begin with a seedling, because the tree was imported or its oldest steps were dropped</source>
        <translation>die Geschichte des Baums kann kein Rezept werden: sie beginnt nicht mit einem Sämling, weil der Baum importiert wurde oder seine ältesten Schritte entfallen sind</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>Schritt %1 der Geschichte</translation>
    </message>
    <message>
        <source>another file with this name is where the recipe&apos;s image should go</source>
        <translation>dort, wo das Bild des Rezepts hingehört, liegt eine andere Datei dieses Namens</translation>
    </message>
    <message>
        <source>the recipe&apos;s numbers cannot be written exactly</source>
        <translation>die Zahlen des Rezepts lassen sich nicht genau schreiben</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>%1 Zahlen werden erwartet</translation>
    </message>
    <message>
        <source>its parent is neither one of the segments before it nor -1</source>
        <translation>sein Träger ist keines der Segmente davor, und nicht -1</translation>
    </message>
    <message>
        <source>1 to %1 segments are expected</source>
        <translation>1 bis %1 Segmente werden erwartet</translation>
    </message>
    <message>
        <source>a recipe that was not read from a file cannot name files</source>
        <translation>ein Rezept, das keine Datei ist, kann keine Dateien nennen</translation>
    </message>
    <message>
        <source>internode %1 has no room for buds above the ground</source>
        <translation>Internodium %1 hat über dem Boden keinen Platz für Knospen</translation>
    </message>
    <message>
        <source>nothing was taken away</source>
        <translation>nichts wurde weggenommen</translation>
    </message>
    <message>
        <source>there is no branch from internode %1 to internode %2</source>
        <translation>es gibt keinen Ast von Internodium %1 zu Internodium %2</translation>
    </message>
    <message>
        <source>internode %1 has no profile to take away</source>
        <translation>Internodium %1 hat kein Profil, das sich entfernen lässt</translation>
    </message>
    <message>
        <source>internode %1 has no twist to take away</source>
        <translation>Internodium %1 hat keine Verdrehung, die sich entfernen lässt</translation>
    </message>
    <message>
        <source>a branch must begin at exactly one internode</source>
        <translation>ein Ast beginnt an genau einem Internodium</translation>
    </message>
    <message>
        <source>true is expected</source>
        <translation>true wird erwartet</translation>
    </message>
    <message>
        <source>the other end of the branch (“to”) is missing</source>
        <translation>das andere Ende des Asts („to“) fehlt</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>eines von diesen wird erwartet: %1</translation>
    </message>
    <message>
        <source>a stroke needs at least %1 points</source>
        <translation>ein Strich hat mindestens %1 Punkte</translation>
    </message>
    <message>
        <source>at most %1 radii are expected</source>
        <translation>höchstens %1 Radien werden erwartet</translation>
    </message>
    <message>
        <source>numbers from 0 to %1 are expected, in m</source>
        <translation>Zahlen von 0 bis %1 werden erwartet, in m</translation>
    </message>
    <message>
        <source>internode %1 cannot bear such a leaf</source>
        <translation>das Internodium %1 kann kein solches Blatt tragen</translation>
    </message>
    <message>
        <source>no leaves at internode %1 can be arranged by “%2”</source>
        <translation>am Internodium %1 lassen sich keine Blätter nach „%2“ anordnen</translation>
    </message>
    <message>
        <source>a quaternion is expected: four numbers x, y, z, w within ±1, not all of them 0</source>
        <translation>ein Quaternion wird erwartet: vier Zahlen x, y, z, w innerhalb ±1, nicht alle 0</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>true oder false wird erwartet</translation>
    </message>
    <message>
        <source>nothing under the brush could be erased</source>
        <translation>unter dem Pinsel ließ sich nichts wegnehmen</translation>
    </message>
    <message>
        <source>there were no twigs under the brush to take</source>
        <translation>unter dem Pinsel waren keine Zweige</translation>
    </message>
    <message>
        <source>the branch of internode %1 is already kept clear that far</source>
        <translation>der Ast des Internodiums %1 wird schon so freigehalten</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected: x, y, z, in m</source>
        <translation>drei Zahlen innerhalb ±%1 werden erwartet: x, y, z, in m</translation>
    </message>
    <message>
        <source>four numbers are expected: x, y, z within ±%1 m, and a radius within 0…%2 m</source>
        <translation>vier Zahlen werden erwartet: x, y, z innerhalb ±%1 m und ein Radius innerhalb 0…%2 m</translation>
    </message>
    <message>
        <source>one stroke or more is expected</source>
        <translation>mindestens ein Strich wird erwartet</translation>
    </message>
    <message>
        <source>growth stopped at %1 internodes, since the memory of this machine may not hold more</source>
        <translation>das Wachstum endete bei %1 Internodien, da der Speicher dieses Rechners vielleicht nicht mehr fasst</translation>
    </message>
    <message>
        <source>there is no room for more profiles</source>
        <translation>für weitere Profile ist kein Platz</translation>
    </message>
</context>
<context>
    <name>RecipeTool</name>
    <message>
        <source>A recipe is playing; Escape hands the brush to you.</source>
        <translation>Ein Rezept läuft; Esc gibt den Pinsel frei.</translation>
    </message>
</context>
<context>
    <name>ReduceTool</name>
    <message>
        <source>Press a branch and hold: it shrinks until you let go</source>
        <translation>Auf einen Ast drücken und halten: Er schrumpft bis zum Loslassen</translation>
    </message>
</context>
<context>
    <name>ReproduceTool</name>
    <message>
        <source>turn the view back to where you drew the first stroke, or press Esc to discard it</source>
        <translation>drehen Sie die Ansicht dorthin zurück, wo Sie den ersten Strich gezeichnet haben, oder vergessen Sie ihn mit Esc</translation>
    </message>
    <message>
        <source>look at the tree from the side, not from above or below, to draw its shape</source>
        <translation>sehen Sie den Baum von der Seite an, nicht von oben oder unten, um seine Gestalt zu zeichnen</translation>
    </message>
    <message>
        <source>there is no tree yet to give another shape: make one first</source>
        <translation>noch gibt es keinen Baum, der eine andere Gestalt annehmen könnte: machen Sie zuerst einen</translation>
    </message>
    <message>
        <source>that is a point: draw the trunk as a line</source>
        <translation>das ist ein Punkt: zeichnen Sie den Stamm als Linie</translation>
    </message>
    <message>
        <source>that is a point: draw the silhouette as a line around the crown</source>
        <translation>das ist ein Punkt: zeichnen Sie den Umriss als Linie um die Krone</translation>
    </message>
    <message>
        <source>the stroke reaches too far away from the tree</source>
        <translation>der Strich reicht zu weit vom Baum weg</translation>
    </message>
    <message>
        <source>the trunk must be an open line</source>
        <translation>der Stamm muss eine offene Linie sein</translation>
    </message>
    <message>
        <source>the tip of the trunk must be inside the silhouette</source>
        <translation>die Spitze des Stamms muss innerhalb des Umrisses liegen</translation>
    </message>
    <message>
        <source>the silhouette must enclose the tip of the trunk</source>
        <translation>der Umriss muss die Spitze des Stamms umschließen</translation>
    </message>
    <message>
        <source>the trunk must be above the ground: draw it from its foot to its tip</source>
        <translation>der Stamm muss über dem Boden liegen: zeichnen Sie ihn vom Fuß zur Spitze</translation>
    </message>
    <message>
        <source>Make a tree first, with Brush or Sketch; then draw its new shape</source>
        <translation>Machen Sie zuerst einen Baum, mit Pinsel oder Skizze; dann zeichnen Sie seine neue Gestalt</translation>
    </message>
    <message>
        <source>Draw the new trunk, then the silhouette of its crown</source>
        <translation>Zeichnen Sie den neuen Stamm, dann den Umriss seiner Krone</translation>
    </message>
</context>
<context>
    <name>SafetyCopy</name>
    <message>
        <source>another program has changed it</source>
        <translation>ein anderes Programm hat sie geändert</translation>
    </message>
    <message>
        <source>a change of the tree is too large</source>
        <translation>eine Änderung des Baums ist zu groß</translation>
    </message>
    <message>
        <source>it is not up to date</source>
        <translation>sie ist nicht auf dem neuesten Stand</translation>
    </message>
    <message>
        <source>what was done last cannot be brought back</source>
        <translation>was zuletzt getan wurde, kann nicht zurückgebracht werden</translation>
    </message>
</context>
<context>
    <name>SelectBudTool</name>
    <message>
        <source>Tap a bud, and it alone grows from now on; tap beside the tree to let all grow again</source>
        <translation>Eine Knospe antippen, und nur sie wächst von nun an; neben den Baum tippen, um wieder alle wachsen zu lassen</translation>
    </message>
    <message>
        <source>There is no bud here. Buds near the pointer are shown as dots.</source>
        <translation>Hier ist keine Knospe. Knospen in der Nähe des Zeigers erscheinen als Punkte.</translation>
    </message>
    <message>
        <source>No bud is close enough. Tap one of the dots, or zoom in with the wheel.</source>
        <translation>So nah ist keine Knospe. Einen der Punkte antippen oder mit dem Rad näher herangehen.</translation>
    </message>
</context>
<context>
    <name>Skeleton</name>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>sie ist zu lang</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>%1 Zahlen werden erwartet</translation>
    </message>
    <message>
        <source>“%1” is not a number for %2</source>
        <translation>„%1“ ist keine Zahl für %2</translation>
    </message>
    <message>
        <source>its id %1 is already used in line %2</source>
        <translation>ihre id %1 hat auch Zeile %2</translation>
    </message>
    <message>
        <source>its parent, id %1, does not exist</source>
        <translation>die id %1, ihr Träger, fehlt</translation>
    </message>
    <message>
        <source>it is its own ancestor</source>
        <translation>sie wird von dem getragen, was sie trägt</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>liegt mehr als %1 m entfernt</translation>
    </message>
    <message>
        <source>its radius is not between 0 and %1 m</source>
        <translation>der Radius liegt nicht zwischen 0 und %1 m</translation>
    </message>
    <message>
        <source>“%1” is expected</source>
        <translation>„%1“ wird erwartet</translation>
    </message>
    <message>
        <source>a tree of more than %1 segments cannot be imported</source>
        <translation>ein Baum aus mehr als %1 Segmenten kann nicht eingelesen werden</translation>
    </message>
    <message>
        <source>there are no segments</source>
        <translation>es gibt keine Segmente</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>it stands more than %1 m from the thickest trunk</source>
        <translation>steht mehr als %1 m vom dicksten Stamm entfernt</translation>
    </message>
    <message>
        <source>it is longer than %1 m, or more than %2 m away</source>
        <translation>ist länger als %1 m, oder mehr als %2 m entfernt</translation>
    </message>
    <message>
        <source>no segment has a length</source>
        <translation>kein Segment hat eine Länge</translation>
    </message>
</context>
<context>
    <name>Sketch</name>
    <message>
        <source>a trunk can only be drawn where nothing has grown</source>
        <translation>ein Stamm lässt sich nur zeichnen, wo nichts gewachsen ist</translation>
    </message>
    <message>
        <source>the stroke has no length</source>
        <translation>der Strich hat keine Länge</translation>
    </message>
    <message>
        <source>the stroke is longer than %1 m, or more than %2 m away</source>
        <translation>der Strich ist länger als %1 m oder mehr als %2 m entfernt</translation>
    </message>
    <message>
        <source>only a tree with one root can be given depth</source>
        <translation>nur einem Baum mit einer Wurzel lässt sich Tiefe geben</translation>
    </message>
    <message>
        <source>the tree has depth already</source>
        <translation>der Baum hat schon Tiefe</translation>
    </message>
    <message>
        <source>draw branches first: a trunk alone has no depth to find</source>
        <translation>zeichnen Sie zuerst Äste: ein Stamm allein hat keine Tiefe zu finden</translation>
    </message>
    <message>
        <source>the wood that it would grow from is gone</source>
        <translation>das Holz, aus dem er wachsen würde, ist nicht mehr da</translation>
    </message>
    <message>
        <source>the copies would have more than %1 internodes</source>
        <translation>die Kopien hätten mehr als %1 Internodien</translation>
    </message>
    <message>
        <source>a copy would reach more than %1 m away</source>
        <translation>eine Kopie reichte weiter als %1 m weg</translation>
    </message>
    <message>
        <source>internode %1 is not alive</source>
        <translation>das Internodium %1 lebt nicht</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries no branch to imitate</source>
        <translation>der Ast von Internodium %1 trägt keinen Ast, der nachzuahmen wäre</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries nothing to copy</source>
        <translation>der Ast von Internodium %1 trägt nichts, was zu kopieren wäre</translation>
    </message>
    <message>
        <source>more than %1 branches are listed</source>
        <translation>mehr als %1 Äste sind aufgeführt</translation>
    </message>
    <message>
        <source>there is no other branch to copy to</source>
        <translation>es gibt keinen anderen Ast, auf den zu kopieren wäre</translation>
    </message>
    <message>
        <source>all other branches are too short for what the branch of internode %1 carries</source>
        <translation>alle anderen Äste sind zu kurz für das, was der Ast von Internodium %1 trägt</translation>
    </message>
    <message>
        <source>an internode would be longer than %1 m or lie more than %2 m away</source>
        <translation>ein Internodium wäre länger als %1 m oder läge weiter als %2 m weg</translation>
    </message>
    <message>
        <source>the new trunk has no length</source>
        <translation>der neue Stamm hat keine Länge</translation>
    </message>
    <message>
        <source>the silhouette encloses nothing</source>
        <translation>die Silhouette umschließt nichts</translation>
    </message>
    <message>
        <source>a trunk cannot be moved</source>
        <translation>ein Stamm kann nicht versetzt werden</translation>
    </message>
    <message>
        <source>a branch cannot stand on itself</source>
        <translation>ein Ast kann nicht auf sich selbst stehen</translation>
    </message>
    <message>
        <source>a branch can be made %1 to %2 times as large</source>
        <translation>ein Ast kann %1- bis %2-mal so groß werden</translation>
    </message>
</context>
<context>
    <name>SketchTool</name>
    <message>
        <source>Draw the trunk, then branches; two strokes side by side give a branch its width</source>
        <translation>Zeichnen Sie den Stamm, dann Äste; zwei Striche nebeneinander geben einem Ast seine Dicke</translation>
    </message>
    <message>
        <source>Draw a branch from the wood; hold Shift and draw across branches to take them away</source>
        <translation>Zeichnen Sie einen Ast vom Holz aus; mit Umschalt quer über Äste gezeichnet, nimmt der Strich sie weg</translation>
    </message>
    <message>
        <source>Two sides of one branch</source>
        <translation>Zwei Seiten eines Astes</translation>
    </message>
    <message>
        <source>A leaf</source>
        <translation>Ein Blatt</translation>
    </message>
    <message>
        <source>A crown</source>
        <translation>Eine Krone</translation>
    </message>
</context>
<context>
    <name>StrandProfile</name>
    <message>
        <source>an outline needs at least three points</source>
        <translation>ein Umriss braucht mindestens drei Punkte</translation>
    </message>
    <message>
        <source>an outline reaches too far</source>
        <translation>ein Umriss reicht zu weit</translation>
    </message>
    <message>
        <source>it has no outline</source>
        <translation>es hat keinen Umriss</translation>
    </message>
    <message>
        <source>it has more than %1 outlines or %2 points</source>
        <translation>es hat mehr als %1 Umrisse oder %2 Punkte</translation>
    </message>
    <message>
        <source>it has more than %1 attractors</source>
        <translation>es hat mehr als %1 Attraktoren</translation>
    </message>
    <message>
        <source>an attractor lies too far away</source>
        <translation>ein Attraktor liegt zu weit entfernt</translation>
    </message>
    <message>
        <source>its outline crosses itself</source>
        <translation>der Umriss kreuzt sich selbst</translation>
    </message>
    <message>
        <source>its outlines cross each other</source>
        <translation>die Umrisse kreuzen einander</translation>
    </message>
    <message>
        <source>its outline has no area</source>
        <translation>der Umriss hat keine Fläche</translation>
    </message>
</context>
<context>
    <name>SunTool</name>
    <message>
        <source>%1° high</source>
        <translation>%1° hoch</translation>
    </message>
    <message>
        <source>Drag the sun around the tree</source>
        <translation>Die Sonne um den Baum ziehen.</translation>
    </message>
</context>
<context>
    <name>Tree</name>
    <message>
        <source>its internode is missing</source>
        <translation>das Internodium fehlt</translation>
    </message>
    <message>
        <source>it is out of order</source>
        <translation>ist nicht in der richtigen Reihenfolge</translation>
    </message>
    <message>
        <source>its place of attachment is out of range</source>
        <translation>die Ansatzstelle liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>its rotation is not valid</source>
        <translation>die Drehung ist keine</translation>
    </message>
    <message>
        <source>its length is out of range</source>
        <translation>die Länge liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>its vigour is out of range</source>
        <translation>die Wuchskraft liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>it grows from a bud that does not exist</source>
        <translation>wächst aus einer Knospe, die es nicht gibt</translation>
    </message>
    <message>
        <source>it has a bud that does not exist</source>
        <translation>hat eine Knospe, die es nicht gibt</translation>
    </message>
    <message>
        <source>its kind is not known</source>
        <translation>die Art ist nicht bekannt</translation>
    </message>
    <message>
        <source>its width is out of range</source>
        <translation>die Dicke liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>its root lies too far away</source>
        <translation>die Wurzel liegt zu weit entfernt</translation>
    </message>
    <message>
        <source>its parent does not come before it</source>
        <translation>der Träger kommt nicht davor</translation>
    </message>
    <message>
        <source>its parameters are missing</source>
        <translation>die Parameter fehlen</translation>
    </message>
    <message>
        <source>it was born in the future</source>
        <translation>wurde in der Zukunft geboren</translation>
    </message>
    <message>
        <source>it died before it was born, or in the future</source>
        <translation>starb vor der eigenen Geburt oder in der Zukunft</translation>
    </message>
    <message>
        <source>it lives on a dead internode</source>
        <translation>lebt auf einem toten Internodium</translation>
    </message>
    <message>
        <source>the columns of the tree have different lengths</source>
        <translation>die Spalten des Baums sind verschieden lang</translation>
    </message>
    <message>
        <source>the tree is empty or lacks its parameters</source>
        <translation>der Baum ist leer, oder ihm fehlen seine Parameter</translation>
    </message>
    <message>
        <source>the tree has more than %1 parameter sets</source>
        <translation>der Baum hat mehr als %1 Parametersätze</translation>
    </message>
    <message>
        <source>the seedling must stand at the base</source>
        <translation>der Sämling muss an der Basis stehen</translation>
    </message>
    <message>
        <source>two internodes continue the same axis</source>
        <translation>zwei Internodien setzen dieselbe Achse fort</translation>
    </message>
    <message>
        <source>another internode has its key</source>
        <translation>ein anderes Internodium hat denselben Schlüssel</translation>
    </message>
    <message>
        <source>internode %1: %2</source>
        <translation>Internodium %1: %2</translation>
    </message>
    <message>
        <source>the columns of the placed leaves have different lengths</source>
        <translation>die Spalten der gesetzten Blätter sind verschieden lang</translation>
    </message>
    <message>
        <source>placed leaf %1: %2</source>
        <translation>gesetztes Blatt %1: %2</translation>
    </message>
    <message>
        <source>entry %1 of “%2”: %3</source>
        <translation>Eintrag %1 von „%2“: %3</translation>
    </message>
    <message>
        <source>lasso %1: its plane or its points are not valid</source>
        <translation>Lasso %1: die Ebene oder die Punkte sind ungültig</translation>
    </message>
    <message>
        <source>the lassos in force are out of order</source>
        <translation>die geltenden Lassos sind nicht in der richtigen Reihenfolge</translation>
    </message>
    <message>
        <source>profile %1: %2</source>
        <translation>Profil %1: %2</translation>
    </message>
    <message>
        <source>its profile is missing</source>
        <translation>das Profil fehlt</translation>
    </message>
    <message>
        <source>its twist is out of range</source>
        <translation>die Verdrehung liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>its added vigour is out of range</source>
        <translation>die hinzugefügte Wuchskraft liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the length that is kept clear is out of range</source>
        <translation>die freigehaltene Länge liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the length that was drawn is out of range</source>
        <translation>die gezeichnete Länge liegt außerhalb des zulässigen Bereichs</translation>
    </message>
</context>
<context>
    <name>TwistTool</name>
    <message>
        <source>%1° from node to node</source>
        <translation>%1° von Knoten zu Knoten</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands; double-tap to untwist them</source>
        <translation>An einem Ast entlang oder um ihn herum ziehen, um seine Stränge zu verdrehen; zweimal antippen, um sie zu entdrehen</translation>
    </message>
</context>
<context>
    <name>WidthTool</name>
    <message>
        <source>Tap a branch to fix its width; drag the ends of the handle to change it</source>
        <translation>Einen Ast antippen, um seine Dicke festzuhalten; an den Enden des Griffs ziehen, um sie zu ändern</translation>
    </message>
</context>
<context>
    <name>WithinMemory</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>ZipArchive</name>
    <message>
        <source>the archive could not be compressed: %1</source>
        <translation>das Archiv konnte nicht gepackt werden: %1</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>it is not a project file, or a damaged one (%1)</source>
        <translation>keine Projektdatei, oder eine beschädigte (%1)</translation>
    </message>
    <message>
        <source>it is not a project file: it is empty</source>
        <translation>keine Projektdatei: sie ist leer</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>it has %1 bytes, but %2 are expected</source>
        <translation>hat %1 Bytes, aber %2 werden erwartet</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>it claims to hold far more than its size allows</source>
        <translation>sie gibt vor, viel mehr zu enthalten, als ihre Größe erlaubt</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherController</name>
    <message>
        <source>Draw a tree first: then there can be others like it.</source>
        <translation>Zuerst einen Baum zeichnen: Dann kann es andere wie ihn geben.</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>Noch einer wie dieser</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherPanel</name>
    <message>
        <source>Another Like This</source>
        <translation>Noch einer wie dieser</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Tree %1 of %2</source>
        <translation>Baum %1 von %2</translation>
    </message>
    <message>
        <source>Take this tree in place of yours. Undo brings yours back.</source>
        <translation>Diesen Baum anstelle des eigenen nehmen. Rückgängig holt den eigenen zurück.</translation>
    </message>
    <message>
        <source>Six More</source>
        <translation>Sechs weitere</translation>
    </message>
    <message>
        <source>They are growing…</source>
        <translation>Sie wachsen …</translation>
    </message>
    <message>
        <source>The same strokes; only chance differs.</source>
        <translation>Dieselben Striche; nur der Zufall ist ein anderer.</translation>
    </message>
</context>
<context>
    <name>espalier::ArchitecturePanel</name>
    <message>
        <source>Architecture</source>
        <translation>Architektur</translation>
    </message>
    <message>
        <source>More ›</source>
        <translation>Mehr ›</translation>
    </message>
    <message>
        <source>Everything else that steers growth: shoots, shade, room to grow</source>
        <translation>Was das Wachstum sonst noch lenkt: Triebe, Beschattung, Wuchsraum</translation>
    </message>
    <message>
        <source>‹ Less</source>
        <translation>‹ Weniger</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Baumart</translation>
    </message>
    <message>
        <source>Set all parameters of the vigour model to those of a species.</source>
        <translation>Stellt alles, wonach sich das Wuchskraft-Modell richtet, so ein, wie eine Baumart wächst</translation>
    </message>
    <message>
        <source>No species</source>
        <translation>Keine Baumart</translation>
    </message>
</context>
<context>
    <name>espalier::Autosave</name>
    <message>
        <source>A tree that was never saved</source>
        <translation>Ein nie gespeicherter Baum</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>In den Ordner %1 kann nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>espalier::BackgroundPanel</name>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>The colour of the background, or of its lower edge.</source>
        <translation>Die Farbe, oder die am unteren Rand.</translation>
    </message>
    <message>
        <source>The colour at the upper edge.</source>
        <translation>Die Farbe am oberen Rand.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Show no picture behind the tree.</source>
        <translation>Kein Bild hinter dem Baum zeigen.</translation>
    </message>
    <message>
        <source>Lower colour</source>
        <translation>Farbe unten</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Upper colour</source>
        <translation>Farbe oben</translation>
    </message>
    <message>
        <source>Use for New Trees</source>
        <translation>Für neue Bäume</translation>
    </message>
    <message>
        <source>New trees begin with this background, ground and light. The picture stays with this tree.</source>
        <translation>Neue Bäume beginnen mit diesem Hintergrund, Boden und Licht. Das Bild bleibt bei diesem Baum.</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>Vorlagenbild</translation>
    </message>
    <message>
        <source>Choose a picture to show behind the tree while you draw. It is saved with the tree.</source>
        <translation>Ein Bild wählen, das beim Zeichnen hinter dem Baum steht. Es wird mit dem Baum gespeichert.</translation>
    </message>
</context>
<context>
    <name>espalier::BendPopOut</name>
    <message>
        <source>Stiffness</source>
        <translation>Steifheit</translation>
    </message>
    <message>
        <source>&lt;b&gt;Stiffness&lt;/b&gt;&lt;br&gt;How much a branch resists being bent: a stiff one bends in a wide curve and is stretched sooner.</source>
        <translation>&lt;b&gt;Steifheit&lt;/b&gt;&lt;br&gt;Wie sehr sich ein Ast dem Biegen widersetzt: ein steifer biegt sich in weitem Bogen und wird eher in die Länge gezogen.</translation>
    </message>
    <message>
        <source>Holds length</source>
        <translation>Hält die Länge</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds length&lt;/b&gt;&lt;br&gt;How much a branch resists being stretched: at low values it follows the hand further.</source>
        <translation>&lt;b&gt;Hält die Länge&lt;/b&gt;&lt;br&gt;Wie sehr sich ein Ast dem Dehnen widersetzt: er behält seine Länge, oder er folgt der Hand weiter.</translation>
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
        <translation>Zickzack</translation>
    </message>
    <message>
        <source>acute</source>
        <translation>spitz</translation>
    </message>
    <message>
        <source>spreading</source>
        <translation>abstehend</translation>
    </message>
    <message>
        <source>reflexed</source>
        <translation>zurückgebogen</translation>
    </message>
</context>
<context>
    <name>espalier::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pressure curve&lt;/b&gt;&lt;br&gt;How firmly the pen must press for the full radius. Drag the curve, or press here with your pen to try it.</source>
        <translation>&lt;b&gt;Druckkurve&lt;/b&gt;&lt;br&gt;Wie fest der Stift für den ganzen Radius drücken muss. Die Kurve ziehen, oder zum Ausprobieren hier mit dem Stift drücken.</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
</context>
<context>
    <name>espalier::BrushRadius</name>
    <message>
        <source>&lt;b&gt;Brush radius&lt;/b&gt; [ ]&lt;br&gt;A large brush grows a crown into the space it passes; towards zero it draws a single branch exactly along the stroke.</source>
        <translation>&lt;b&gt;Pinselradius&lt;/b&gt; [ ]&lt;br&gt;Ein großer Pinsel lässt eine Krone in den Raum wachsen, den er durchstreift; gegen null zeichnet er einen einzelnen Ast genau entlang des Strichs.</translation>
    </message>
    <message>
        <source>draws a branch</source>
        <translation>zeichnet einen Ast</translation>
    </message>
    <message>
        <source>grows a crown</source>
        <translation>bildet eine Krone</translation>
    </message>
</context>
<context>
    <name>espalier::DirectionDiagram</name>
    <message>
        <source>Weights of direction</source>
        <translation>Gewichte der Richtung</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>ausgewogen</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>tropism</source>
        <translation>Tropismus</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>freier Raum</translation>
    </message>
    <message>
        <source>H straight on</source>
        <translation>H geradeaus</translation>
    </message>
    <message>
        <source>T tropism</source>
        <translation>T Tropismus</translation>
    </message>
    <message>
        <source>E space</source>
        <translation>E Raum</translation>
    </message>
</context>
<context>
    <name>espalier::DocumentFile</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
</context>
<context>
    <name>espalier::ExportQueue</name>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Writing %1, then %2</source>
        <translation>%1 wird geschrieben, dann %2</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>Not exported. %1</source>
        <translation>Nicht exportiert. %1</translation>
    </message>
</context>
<context>
    <name>espalier::FileController</name>
    <message>
        <source>Not saved. %1</source>
        <translation>Nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>No safety copy can be saved: %1</source>
        <translation>Der Baum kann nicht gegen einen Absturz gesichert werden: %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. The tree is still here; save it to keep it.</source>
        <translation>%1 wurde von einem anderen Programm verschoben oder gelöscht. Der Baum ist noch hier; speichern, um ihn zu behalten.</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program. Saving here asks before it replaces that version.</source>
        <translation>%1 wurde von einem anderen Fenster oder Programm geändert. Das Speichern fragt hier nach, bevor es diese Änderungen ersetzt.</translation>
    </message>
    <message>
        <source>Open Again</source>
        <translation>Neu öffnen</translation>
    </message>
    <message>
        <source>Keep This</source>
        <translation>Diesen behalten</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
</context>
<context>
    <name>espalier::GravimorphismDiagram</name>
    <message>
        <source>all alike</source>
        <translation>alle gleich</translation>
    </message>
    <message>
        <source>amphitony</source>
        <translation>Amphitonie</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>epitony</source>
        <translation>Epitonie</translation>
    </message>
    <message>
        <source>hypotony</source>
        <translation>Hypotonie</translation>
    </message>
    <message>
        <source>side %1</source>
        <translation>seitlich %1</translation>
    </message>
    <message>
        <source>above %1 · below %2</source>
        <translation>oben %1 · unten %2</translation>
    </message>
</context>
<context>
    <name>espalier::GrowPopOut</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play what happened from here on, or all of it.</source>
        <translation>Das Geschehene von hier an abspielen, oder alles</translation>
    </message>
    <message>
        <source>Hold to grow</source>
        <translation>Wachsen (halten)</translation>
    </message>
    <message>
        <source>A tap grows one step; hold to grow on. One hold is one undo step.</source>
        <translation>Tippen: ein Wuchsschritt; halten: weiter wachsen. Einmal halten ist ein Schritt zum Rückgängigmachen.</translation>
    </message>
    <message>
        <source>Steps to grow</source>
        <translation>Anzahl der Schritte</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Grow that many steps, as one undo step. Escape stops.</source>
        <translation>So viele Schritte wachsen, rückgängig zu machen in einem Schritt. Esc hält an.</translation>
    </message>
    <message>
        <source>Back: the tree ungrows, through all that you did. Forth: it comes back. Pull the handle well past the mark, and the tree grows. Far from the slider, or with Shift, a drag is finer.</source>
        <translation>Zurück: Der Baum wächst rückwärts, durch alles, was getan wurde. Vor: Er kommt wieder. Den Griff deutlich über die Marke ziehen, und der Baum wächst. Weit vom Regler, oder mit Umschalt, zieht es sich feiner.</translation>
    </message>
    <message>
        <source>New steps: %L1</source>
        <translation>Neue Schritte: %L1</translation>
    </message>
    <message>
        <source>Moment %L1 of %L2</source>
        <translation>Zeitpunkt %L1 von %L2</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>Sämling</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPage</name>
    <message>
        <source>Help page</source>
        <translation>Hilfeseite</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPanel</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Back to the previous page</source>
        <translation>Zurück zur vorigen Seite</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Hilfe schließen</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>Hilfe schließen (Esc)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>In der Hilfe suchen</translation>
    </message>
    <message>
        <source>Help pages</source>
        <translation>Seiten der Hilfe</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Rundgang starten</translation>
    </message>
    <message>
        <source>Play this recipe</source>
        <translation>Rezept abspielen</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nichts gefunden</translation>
    </message>
</context>
<context>
    <name>espalier::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>Sämling</translation>
    </message>
</context>
<context>
    <name>espalier::LassoPopOut</name>
    <message>
        <source>Regrow</source>
        <translation>Neuwuchs</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Hülle</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>&lt;b&gt;Regrow&lt;/b&gt;&lt;br&gt;Take the tree back to how it was before its envelope was drawn, and let it fill the envelope again with the parameters that are in force now. What you have done to it since is lost.</source>
        <translation>&lt;b&gt;Neuwuchs&lt;/b&gt;&lt;br&gt;Den Baum dorthin zurückbringen, wo er vor dem Zeichnen seiner Hülle stand, und ihn die Hülle mit den jetzt geltenden Parametern neu füllen lassen. Was seither an ihm getan wurde, entfällt.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Remove&lt;/b&gt;&lt;br&gt;Take the envelope away; the tree stays as it grew.</source>
        <translation>&lt;b&gt;Entfernen&lt;/b&gt;&lt;br&gt;Die Hülle wegnehmen; der Baum bleibt, wie er gewachsen ist.</translation>
    </message>
    <message>
        <source>Keep what has grown. Escape takes it back instead.</source>
        <translation>Behalten, was gewachsen ist. Esc nimmt es stattdessen zurück.</translation>
    </message>
    <message>
        <source>Show the envelope.</source>
        <translation>Die Hülle zeigen.</translation>
    </message>
    <message>
        <source>Show the points of free space that the tree grows into.</source>
        <translation>Die Punkte freien Raums zeigen, in den der Baum wächst.</translation>
    </message>
</context>
<context>
    <name>espalier::LeafChoices</name>
    <message>
        <source>Continue with</source>
        <translation>Weiter mit</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Eins mehr</translation>
    </message>
    <message>
        <source>One more leaf at this place; all of them stand evenly around the branch.</source>
        <translation>Ein Blatt mehr an dieser Stelle; alle stehen gleichmäßig um den Ast.</translation>
    </message>
    <message>
        <source>Whorls</source>
        <translation>Quirle</translation>
    </message>
    <message>
        <source>Whorls like this along the whole branch, at the same spacing.</source>
        <translation>Solche Quirle in diesem Abstand am ganzen Ast entlang.</translation>
    </message>
    <message>
        <source>Alternate</source>
        <translation>Wechselständig</translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation>Gegenständig</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, all in one plane.</source>
        <translation>Blattpaare am Ast entlang, alle in einer Ebene.</translation>
    </message>
    <message>
        <source>Decussate</source>
        <translation>Kreuzgegenständig</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, each across the one below it.</source>
        <translation>Blattpaare am Ast entlang, jedes quer zu dem darunter.</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryCards</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryController</name>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 ist im Papierkorb.</translation>
    </message>
    <message>
        <source>The system has no trash here. %1 is in %2 now.</source>
        <translation>Das System hat hier keinen Papierkorb. %1 ist jetzt in %2.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryPanel</name>
    <message>
        <source>Keep This Tree</source>
        <translation>Baum behalten</translation>
    </message>
    <message>
        <source>Start from This</source>
        <translation>Damit beginnen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Save the open tree in the library.</source>
        <translation>Den geöffneten Baum in der Bibliothek speichern.</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>Zurück zum Baum</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>A new seedling that grows the way this tree does.</source>
        <translation>Ein neuer Sämling, der wächst wie dieser Baum.</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>Your Trees</source>
        <translation>Eigene Bäume</translation>
    </message>
    <message>
        <source>No tree has a name like that.</source>
        <translation>Nichts davon heißt so.</translation>
    </message>
    <message>
        <source>No trees yet. “Keep This Tree” saves the open tree here.</source>
        <translation>Noch keine. „Baum behalten“ speichert den Baum, der hier geöffnet ist.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Move to Trash</source>
        <translation>In den Papierkorb</translation>
    </message>
</context>
<context>
    <name>espalier::LookChoice</name>
    <message>
        <source>Choose an image…</source>
        <translation>Bild wählen…</translation>
    </message>
    <message>
        <source>A PNG or JPEG of one leaf, stalk down, on a transparent or plain background</source>
        <translation>Ein PNG oder JPEG eines einzelnen Blatts, der Stiel unten, ohne Hintergrund oder vor einem einfarbigen</translation>
    </message>
    <message>
        <source>A PNG or JPEG of bark; normal and roughness maps found beside it are used, too</source>
        <translation>Ein PNG oder JPEG von Rinde; Karten der Normalen und der Rauheit, die danebenliegen, werden mit übernommen</translation>
    </message>
    <message>
        <source>Your image: %1</source>
        <translation>Eigenes Bild: %1</translation>
    </message>
</context>
<context>
    <name>espalier::LookController</name>
    <message>
        <source>Image of a Leaf</source>
        <translation>Bild eines Blatts</translation>
    </message>
    <message>
        <source>Image of Bark</source>
        <translation>Bild der Rinde</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Rinde</translation>
    </message>
    <message>
        <source>Maps found beside it are used, too.</source>
        <translation>Karten, die daneben liegen, wurden mit übernommen.</translation>
    </message>
    <message>
        <source>What is %1 for?</source>
        <translation>Wofür ist %1?</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>Vorlagenbild</translation>
    </message>
    <message>
        <source>This tree has had so many images that its file has no room for another one.</source>
        <translation>Dieser Baum hatte schon so viele Bilder, dass seine Datei keinen Platz für ein weiteres hat.</translation>
    </message>
</context>
<context>
    <name>espalier::MainWindow</name>
    <message>
        <source>The tree has no room left to grow.</source>
        <translation>Der Baum hat keinen Raum mehr zum Wachsen.</translation>
    </message>
    <message>
        <source>%1[*] – Espalier</source>
        <translation>%1[*] – Espalier</translation>
    </message>
    <message>
        <source>Growing %1</source>
        <translation>%1 wächst</translation>
    </message>
    <message>
        <source>Not everything that the recipe names was found in the tree (%1 of %2 operations): %3</source>
        <translation>Operationen des Rezepts, die nichts zu tun fanden oder nicht alles, was sie nennen (%1 von %2): %3</translation>
    </message>
    <message>
        <source>Building the wood from strands</source>
        <translation>Das Holz aus Strängen entsteht</translation>
    </message>
    <message>
        <source>Growth has stopped: the tree has %L1 internodes, and the memory of this machine may not hold a larger one.</source>
        <translation>Das Wachstum hat angehalten: der Baum hat %L1 Internodien, und der Speicher dieses Rechners fasst vielleicht keinen größeren.</translation>
    </message>
    <message>
        <source>Allow More</source>
        <translation>Mehr erlauben</translation>
    </message>
    <message>
        <source>Leave It</source>
        <translation>Dabei lassen</translation>
    </message>
    <message>
        <source>The oldest steps of the history were dropped, so that it takes no more than %1 MB.</source>
        <translation>Die ältesten Schritte des Verlaufs wurden verworfen, damit er nicht mehr als %1 MB braucht.</translation>
    </message>
</context>
<context>
    <name>espalier::Notice</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>espalier::ParameterRow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>espalier::PerceptionDiagram</name>
    <message>
        <source>dense</source>
        <translation>dicht</translation>
    </message>
    <message>
        <source>ordinary</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>airy</source>
        <translation>luftig</translation>
    </message>
</context>
<context>
    <name>espalier::PictureController</name>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>Das Bild ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Not saved. %1</source>
        <translation>Nicht gespeichert. %1</translation>
    </message>
</context>
<context>
    <name>espalier::PictureSheet</name>
    <message>
        <source>Like the window, %1 × %2</source>
        <translation>Wie das Fenster, %1 × %2</translation>
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
        <translation>Quadrat, 1080 × 1080</translation>
    </message>
    <message>
        <source>Large square, 2048 × 2048</source>
        <translation>Großes Quadrat, 2048 × 2048</translation>
    </message>
    <message>
        <source>Portrait, 1080 × 1350</source>
        <translation>Hochformat, 1080 × 1350</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>With the shadow on the ground</source>
        <translation>Mit dem Schatten auf dem Boden</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>Wie jetzt gezeigt</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>Nothing is behind the tree, so that it can be laid over other pictures.</source>
        <translation>Hinter dem Baum ist nichts, sodass er sich über andere Bilder legen lässt.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Put the picture on the clipboard.</source>
        <translation>Das Bild in die Zwischenablage legen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
</context>
<context>
    <name>espalier::PressureCurve</name>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileCanvas</name>
    <message>
        <source>Cross-section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Draw an outline first: attractors gather the strands within it.</source>
        <translation>Zuerst einen Umriss zeichnen: Attraktoren sammeln die Stränge in ihm.</translation>
    </message>
    <message>
        <source>This cannot be the profile: %1.</source>
        <translation>Dies kann nicht das Profil sein: %1.</translation>
    </message>
    <message>
        <source>Tap a branch of the tree to see its cross-section.</source>
        <translation>Einen Ast des Baums antippen, um seinen Querschnitt zu sehen.</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileController</name>
    <message>
        <source>The two places are not on one branch.</source>
        <translation>Die beiden Stellen liegen nicht auf einem Ast.</translation>
    </message>
    <message>
        <source>The other place has no profile to blend with.</source>
        <translation>Die andere Stelle hat kein Profil, mit dem sich überblenden ließe.</translation>
    </message>
    <message>
        <source>There is no room for more profiles.</source>
        <translation>Für weitere Profile ist kein Platz.</translation>
    </message>
</context>
<context>
    <name>espalier::ProfilePanel</name>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>&lt;b&gt;Outline&lt;/b&gt;&lt;br&gt;Draw a closed line. One beside another splits the wood; one within another is a hollow.</source>
        <translation>&lt;b&gt;Umriss&lt;/b&gt;&lt;br&gt;Eine geschlossene Linie zeichnen. Eine neben anderen teilt das Holz, eine in einer anderen ist ein Hohlraum.</translation>
    </message>
    <message>
        <source>Attractor</source>
        <translation>Attraktor</translation>
    </message>
    <message>
        <source>&lt;b&gt;Attractor&lt;/b&gt;&lt;br&gt;Drag a straight line that the strands gather at.</source>
        <translation>&lt;b&gt;Attraktor&lt;/b&gt;&lt;br&gt;Eine gerade Linie ziehen, an der sich die Stränge sammeln.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>&lt;b&gt;Points&lt;/b&gt;&lt;br&gt;Drag the points of an outline, or the ends of an attractor.</source>
        <translation>&lt;b&gt;Punkte&lt;/b&gt;&lt;br&gt;An den Punkten eines Umrisses oder den Enden eines Attraktors ziehen.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>&lt;b&gt;Erase&lt;/b&gt;&lt;br&gt;Tap a line to take it away. A pen&apos;s eraser does the same at any time.</source>
        <translation>&lt;b&gt;Radieren&lt;/b&gt;&lt;br&gt;Eine Linie antippen, um sie zu entfernen. Der Radierer eines Stifts tut jederzeit dasselbe.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>Elongated</source>
        <translation>Länglich</translation>
    </message>
    <message>
        <source>C-shaped</source>
        <translation>C-förmig</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Hohl</translation>
    </message>
    <message>
        <source>Split in two</source>
        <translation>Zweigeteilt</translation>
    </message>
    <message>
        <source>Split in three</source>
        <translation>Dreigeteilt</translation>
    </message>
    <message>
        <source>Fluted</source>
        <translation>Spannrückig</translation>
    </message>
    <message>
        <source>Copy to branch</source>
        <translation>Auf Ast kopieren</translation>
    </message>
    <message>
        <source>&lt;b&gt;Copy to branch&lt;/b&gt;&lt;br&gt;Then tap another place on this branch: everything between gets this profile.</source>
        <translation>&lt;b&gt;Auf Ast kopieren&lt;/b&gt;&lt;br&gt;Danach eine andere Stelle dieses Asts antippen: Alle dazwischen erhalten dieses Profil.</translation>
    </message>
    <message>
        <source>▼</source>
        <translation>▼</translation>
    </message>
    <message>
        <source>To the next place down the branch.</source>
        <translation>Zur nächsten Stelle den Ast hinab</translation>
    </message>
    <message>
        <source>▲</source>
        <translation>▲</translation>
    </message>
    <message>
        <source>To the next place up the branch.</source>
        <translation>Zur nächsten Stelle den Ast hinauf</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole cross-section.</source>
        <translation>Den ganzen Querschnitt zeigen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Clear&lt;/b&gt;&lt;br&gt;Take the profile away: the strands are packed round again.</source>
        <translation>&lt;b&gt;Entfernen&lt;/b&gt;&lt;br&gt;Das Profil entfernen: Die Stränge werden wieder rund gepackt.</translation>
    </message>
    <message>
        <source>Down the branch</source>
        <translation>Den Ast hinab</translation>
    </message>
    <message>
        <source>Up the branch</source>
        <translation>Den Ast hinauf</translation>
    </message>
    <message numerus="yes">
        <source>Radius %1 · %Ln strands</source>
        <translation>
            <numerusform>Radius %1 · %Ln Strang</numerusform>
            <numerusform>Radius %1 · %Ln Stränge</numerusform>
        </translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Draw another closed line: beside the first to split the wood, within it for a hollow.</source>
        <translation>Eine weitere geschlossene Linie zeichnen: neben der ersten, um das Holz zu teilen, in ihr für einen Hohlraum.</translation>
    </message>
    <message>
        <source>Draw a closed line, or begin with one of these shapes.</source>
        <translation>Eine geschlossene Linie zeichnen oder mit einer dieser Formen beginnen.</translation>
    </message>
    <message>
        <source>Drag a straight line: the strands gather at it.</source>
        <translation>Eine gerade Linie ziehen: Die Stränge sammeln sich an ihr.</translation>
    </message>
    <message>
        <source>Drag the points of a line.</source>
        <translation>An den Punkten einer Linie ziehen.</translation>
    </message>
    <message>
        <source>Tap a line to take it away.</source>
        <translation>Eine Linie antippen, um sie zu entfernen.</translation>
    </message>
    <message>
        <source>Tap the other end on this branch, or go there with ▲ and ▼ and press the button again.</source>
        <translation>Das andere Ende auf diesem Ast antippen, oder mit ▲ und ▼ dorthin gehen und den Knopf noch einmal drücken.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>&lt;b&gt;Blend&lt;/b&gt;&lt;br&gt;Then tap another place on this branch that has a profile: the sections between change from one to the other.</source>
        <translation>&lt;b&gt;Überblenden&lt;/b&gt;&lt;br&gt;Danach eine andere Stelle dieses Asts antippen, die ein Profil hat: Die Profile dazwischen gehen vom einen ins andere über.</translation>
    </message>
</context>
<context>
    <name>espalier::PrunePopOut</name>
    <message>
        <source>Cut</source>
        <translation>Abschneiden</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw a line across several.</source>
        <translation>Einen Ast antippen, um ihn abzunehmen, oder eine Linie quer über mehrere ziehen.</translation>
    </message>
    <message>
        <source>Keep clear</source>
        <translation>Freihalten</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: the shoots below your hand are removed, and no new ones come. Drag the ring down again to let buds shoot.</source>
        <translation>An einem Stamm oder Ast hinaufziehen: Die Triebe unterhalb der Hand fallen, und neue kommen nicht. Den Ring wieder hinunterziehen, um Knospen treiben zu lassen.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are. Limbs stay.</source>
        <translation>Über Zweige und Blätter streichen, um sie wegzunehmen, so tief sie auch in der Krone sind. Dicke Äste bleiben.</translation>
    </message>
    <message>
        <source>Thin out</source>
        <translation>Auslichten</translation>
    </message>
    <message>
        <source>Brush over the crown to take out some of its twigs evenly.</source>
        <translation>Über die Krone streichen, um einige ihrer Zweige gleichmäßig herauszunehmen.</translation>
    </message>
</context>
<context>
    <name>espalier::RadiusSlider</name>
    <message>
        <source>Brush radius</source>
        <translation>Pinselradius</translation>
    </message>
</context>
<context>
    <name>espalier::Recovery</name>
    <message>
        <source>%1, but the file is no longer there</source>
        <translation>%1, aber die Datei ist nicht mehr da</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>Nicht lesbar.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln internodes</source>
        <translation>
            <numerusform>%Ln Internodium</numerusform>
            <numerusform>%Ln Internodien</numerusform>
        </translation>
    </message>
    <message>
        <source>Changed by another program since</source>
        <translation>Seither von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>There is nothing to bring back: all was saved, or given up.</source>
        <translation>Es gibt nichts zurückzuholen: Alles ist gespeichert oder verworfen.</translation>
    </message>
    <message>
        <source>Another tree can be brought back.</source>
        <translation>Ein weiterer Baum lässt sich zurückholen.</translation>
    </message>
    <message numerus="yes">
        <source>%n other trees can be brought back.</source>
        <translation>
            <numerusform>%n weiterer Baum lässt sich zurückholen.</numerusform>
            <numerusform>%n weitere Bäume lassen sich zurückholen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>The safety copy of %1 cannot be read. It is kept as %2.</source>
        <translation>Die Sicherheitskopie von %1 ist nicht lesbar. Sie bleibt als %2 erhalten.</translation>
    </message>
    <message numerus="yes">
        <source>%n safety copies cannot be read. They are kept in %1.</source>
        <translation>
            <numerusform>%n Sicherheitskopie ist nicht lesbar. Sie bleibt in %1 erhalten.</numerusform>
            <numerusform>%n Sicherheitskopien sind nicht lesbar. Sie bleiben in %1 erhalten.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::RecoveryRow</name>
    <message>
        <source>Bring Back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Can be brought back</source>
        <translation>Lässt sich zurückholen</translation>
    </message>
    <message>
        <source>It will be deleted when this closes.</source>
        <translation>Wird beim Schließen gelöscht.</translation>
    </message>
    <message>
        <source>Bring back %1</source>
        <translation>%1 zurückholen</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 verwerfen</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
</context>
<context>
    <name>espalier::RecoverySheet</name>
    <message>
        <source>today, %1</source>
        <translation>heute, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>gestern, %1</translation>
    </message>
    <message>
        <source>Bring Trees Back</source>
        <translation>Bäume zurückholen</translation>
    </message>
    <message>
        <source>Espalier ended before this was saved. What you leave here is offered again at the next start.</source>
        <translation>Espalier endete, bevor dies gespeichert war. Was Sie hier lassen, wird beim nächsten Start wieder angeboten.</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>espalier::ReportSheet</name>
    <message>
        <source>With the recipe of this tree</source>
        <translation>Mit dem Rezept dieses Baums</translation>
    </message>
    <message>
        <source>Report a Problem</source>
        <translation>Problem melden</translation>
    </message>
    <message>
        <source>Copy this text, and add what you did and what happened. Espalier sends nothing by itself. Without the recipe, the text has nothing of your tree.</source>
        <translation>Kopieren Sie diesen Text und fügen Sie hinzu, was Sie getan haben und was geschehen ist. Espalier sendet selbst nichts. Ohne das Rezept enthält der Text nichts von Ihrem Baum.</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>Text des Berichts</translation>
    </message>
    <message>
        <source>All that was done to the tree, so that others can do it again.</source>
        <translation>Alles, was mit dem Baum getan wurde, damit andere es wiederholen können.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>espalier::ReproduceController</name>
    <message>
        <source>Draw the new trunk, from its base to its tip.</source>
        <translation>Zeichnen Sie den neuen Stamm, vom Fuß zur Spitze.</translation>
    </message>
    <message>
        <source>Now draw the silhouette of the crown around its tip.</source>
        <translation>Zeichnen Sie nun um seine Spitze den Umriss der Krone.</translation>
    </message>
    <message>
        <source>Now draw the trunk, with its tip inside the silhouette.</source>
        <translation>Zeichnen Sie nun den Stamm, mit der Spitze innerhalb des Umrisses.</translation>
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
        <translation>Ein anderer</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another&lt;/b&gt;&lt;br&gt;The same tree with slightly different angles and lengths, as it could stand beside it in a forest. As long as nothing else is done, the next one takes its place.</source>
        <translation>&lt;b&gt;Ein anderer&lt;/b&gt;&lt;br&gt;Derselbe Baum mit etwas anderen Winkeln und Längen, wie er im Wald daneben stehen könnte. Solange nichts anderes geschieht, tritt der nächste an seine Stelle.</translation>
    </message>
</context>
<context>
    <name>espalier::RingMenu</name>
    <message>
        <source>Tools around the pointer</source>
        <translation>Werkzeuge um den Zeiger</translation>
    </message>
</context>
<context>
    <name>espalier::RotationStrip</name>
    <message>
        <source>Rotation strip</source>
        <translation>Drehleiste</translation>
    </message>
</context>
<context>
    <name>espalier::SceneController</name>
    <message>
        <source>Reference Picture</source>
        <translation>Vorlagenbild</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>New trees will have this background, ground and light.</source>
        <translation>Neue Bäume bekommen diesen Hintergrund, Boden und dieses Licht.</translation>
    </message>
</context>
<context>
    <name>espalier::SettingsSheet</name>
    <message>
        <source>The middle button turns; with Shift it pans, with Ctrl it zooms. Alt with the left button turns, too.</source>
        <translation>Mittlere Taste dreht, mit Umschalt verschiebt sie, mit Strg geht sie näher. Auch Alt und die linke Taste drehen.</translation>
    </message>
    <message>
        <source>With Alt, the left button turns, the middle one pans and the right one zooms.</source>
        <translation>Alt und die linke Taste drehen, Alt und die mittlere verschieben, Alt und die rechte gehen näher.</translation>
    </message>
    <message>
        <source>The right or middle button turns; Shift with the middle button pans. Alt with the left button turns, too.</source>
        <translation>Rechte oder mittlere Taste dreht, Umschalt und die mittlere verschieben. Auch Alt und die linke Taste drehen.</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>On the left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Design</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>How firmly a pen must press for a large brush.</source>
        <translation>Wie fest ein Stift für einen großen Pinsel drücken muss.</translation>
    </message>
    <message>
        <source>Press here with your pen to try it.</source>
        <translation>Zum Ausprobieren hier mit dem Stift drücken.</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Pen pressure</source>
        <translation>Stiftdruck</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Undo steps kept</source>
        <translation>Schritte zurück</translation>
    </message>
    <message>
        <source>A change applies to the next tree that you begin or open.</source>
        <translation>Die Zahl der Schritte gilt ab dem nächsten Baum, der begonnen oder geöffnet wird.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>In Espalier&apos;s own folder</source>
        <translation>In Espaliers eigenem Ordner</translation>
    </message>
    <message>
        <source>Library Folder</source>
        <translation>Ordner der Bibliothek</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Metres, centimetres</source>
        <translation>Meter, Zentimeter</translation>
    </message>
    <message>
        <source>Feet, inches</source>
        <translation>Fuß, Zoll</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Size of the interface</source>
        <translation>Größe der Oberfläche</translation>
    </message>
    <message>
        <source>Stroke stabiliser</source>
        <translation>Strichberuhigung</translation>
    </message>
    <message>
        <source>A stroke follows the pointer at this distance, like a stone on a string, so it does not tremble.</source>
        <translation>Ein Strich folgt dem Zeiger in diesem Abstand, wie ein Stein an der Schnur: Er zittert nicht.</translation>
    </message>
    <message>
        <source>A stroke lags this far behind the pointer, and is smoother.</source>
        <translation>Ein Strich kommt so viel später als der Zeiger, und ruhiger.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
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
        <translation>aus</translation>
    </message>
    <message>
        <source>Takes effect the next time Espalier starts.</source>
        <translation>Gilt ab dem nächsten Start von Espalier.</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Speicher für den Verlauf</translation>
    </message>
    <message>
        <source>If the history takes more, its oldest steps go.</source>
        <translation>Braucht der Verlauf mehr, fallen die ältesten Schritte weg.</translation>
    </message>
</context>
<context>
    <name>espalier::SizeChoices</name>
    <message>
        <source>Bonsai</source>
        <translation>Bonsai</translation>
    </message>
    <message>
        <source>Shrub</source>
        <translation>Strauch</translation>
    </message>
    <message>
        <source>Street Tree</source>
        <translation>Straßenbaum</translation>
    </message>
    <message>
        <source>Forest Tree</source>
        <translation>Waldbaum</translation>
    </message>
    <message>
        <source>Size of the new tree</source>
        <translation>Größe des neuen Baums</translation>
    </message>
    <message>
        <source>How tall should the new tree grow?</source>
        <translation>Wie hoch soll der neue Baum werden?</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;About %2 tall; the brush, the branches and the leaves are in proportion.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Etwa %2 hoch; Pinsel, Äste und Blätter passen dazu.</translation>
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
        <translation>Tiefe geben</translation>
    </message>
    <message>
        <source>&lt;b&gt;Give depth&lt;/b&gt;&lt;br&gt;The branches of the drawing spread into depth, as far from each other as they can. From the front the tree looks as you drew it.</source>
        <translation>&lt;b&gt;Tiefe geben&lt;/b&gt;&lt;br&gt;Die Äste der Zeichnung breiten sich in die Tiefe aus, so weit voneinander entfernt wie möglich. Von vorn sieht der Baum aus wie gezeichnet.</translation>
    </message>
    <message>
        <source>Another depth</source>
        <translation>Andere Tiefe</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another depth&lt;/b&gt;&lt;br&gt;Choose new depths for the branches.</source>
        <translation>&lt;b&gt;Andere Tiefe&lt;/b&gt;&lt;br&gt;Die Tiefen der Äste neu wählen.</translation>
    </message>
</context>
<context>
    <name>espalier::TopBar</name>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 enthält ungespeicherte Änderungen.</translation>
    </message>
</context>
<context>
    <name>espalier::Tour</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Back in time</source>
        <translation>Zurück in der Zeit</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Ringsum</translation>
    </message>
    <message>
        <source>When you wonder</source>
        <translation>Bei Fragen</translation>
    </message>
    <message>
        <source>&lt;b&gt;F1&lt;/b&gt; or this button tells you about the tool in your hand. &lt;b&gt;Ctrl+Z&lt;/b&gt; takes back whatever you did, so try things.</source>
        <translation>&lt;b&gt;F1&lt;/b&gt; oder dieser Knopf erklärt das Werkzeug in der Hand. &lt;b&gt;Strg+Z&lt;/b&gt; nimmt alles zurück, also ruhig ausprobieren.</translation>
    </message>
    <message>
        <source>Draw a tree</source>
        <translation>Einen Baum zeichnen</translation>
    </message>
    <message>
        <source>Draw a trunk</source>
        <translation>Einen Stamm zeichnen</translation>
    </message>
    <message>
        <source>Draw a branch</source>
        <translation>Einen Ast zeichnen</translation>
    </message>
    <message>
        <source>Here is a seedling. &lt;b&gt;Press on it and draw a line upward&lt;/b&gt;, to the middle of the picture or higher: it becomes the trunk.</source>
        <translation>Hier ist ein Sämling. &lt;b&gt;Darauf drücken und eine Linie nach oben ziehen&lt;/b&gt;, bis zur Bildmitte oder höher: Sie wird der Stamm.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a branch and draw outward&lt;/b&gt;: the line becomes a branch.</source>
        <translation>&lt;b&gt;Auf einen Ast drücken und nach außen ziehen&lt;/b&gt;: Die Linie wird ein Ast.</translation>
    </message>
    <message>
        <source>Draw the limbs</source>
        <translation>Die Äste zeichnen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on the trunk and draw outward and up&lt;/b&gt;, to the left and to the right. Three limbs or four are enough.</source>
        <translation>&lt;b&gt;Auf den Stamm drücken und nach außen und oben ziehen&lt;/b&gt;, nach links und nach rechts. Drei oder vier Äste genügen.</translation>
    </message>
    <message>
        <source>Small and large</source>
        <translation>Klein und groß</translation>
    </message>
    <message>
        <source>A tiny brush draws a single branch, a large one grows a crown. &lt;b&gt;Drag the slider upward, or press&amp;nbsp;]&lt;/b&gt;; [ makes the brush smaller.</source>
        <translation>Ein winziger Pinsel zeichnet einen einzelnen Ast, ein großer lässt eine Krone wachsen. &lt;b&gt;Den Regler hinaufziehen oder ]&amp;nbsp;drücken&lt;/b&gt;; [ macht den Pinsel kleiner.</translation>
    </message>
    <message>
        <source>Grow a crown</source>
        <translation>Eine Krone wachsen lassen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a limb and draw slowly along the limbs and around their ends&lt;/b&gt;: twigs and leaves grow wherever the brush passes.</source>
        <translation>&lt;b&gt;Auf einen Ast drücken und langsam die Äste entlang und um ihre Enden ziehen&lt;/b&gt;: Zweige und Blätter wachsen, wo der Pinsel vorbeikommt.</translation>
    </message>
    <message>
        <source>Prune, bend, draw with a lasso: what a gardener needs is here. &lt;b&gt;Choose Grow&lt;/b&gt;.</source>
        <translation>Schneiden, biegen, mit dem Lasso zeichnen: Alles, was ein Gärtner braucht, ist hier. &lt;b&gt;Wachsen wählen&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag this slider to the left&lt;/b&gt;, and the tree ungrows; drag it back to the right, and the tree is there again.</source>
        <translation>&lt;b&gt;Diesen Regler nach links ziehen&lt;/b&gt;, und der Baum wächst rückwärts; wieder nach rechts, und der Baum ist wieder da.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag along this edge&lt;/b&gt;, and the tree turns, even while your other hand brushes. The right mouse button turns it as well.</source>
        <translation>&lt;b&gt;An diesem Rand entlangziehen&lt;/b&gt;, und der Baum dreht sich, auch während die andere Hand pinselt. Die rechte Maustaste dreht ihn ebenso.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Choose Sketch&lt;/b&gt; to draw a trunk and branches as on paper, and give the drawing depth. Watch how thirty strokes become a tree.</source>
        <translation>&lt;b&gt;Skizze wählen&lt;/b&gt;, um Stamm und Äste wie auf Papier zu zeichnen und der Zeichnung Tiefe zu geben. Hier ist zu sehen, wie dreißig Striche ein Baum werden.</translation>
    </message>
</context>
<context>
    <name>espalier::TourCard</name>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Zusehen</translation>
    </message>
</context>
<context>
    <name>espalier::TropismDiagram</name>
    <message>
        <source>as the stroke</source>
        <translation>wie der Strich</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>aufrecht</translation>
    </message>
    <message>
        <source>slanting</source>
        <translation>schräg</translation>
    </message>
    <message>
        <source>level</source>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>weeping</source>
        <translation>hängend</translation>
    </message>
</context>
<context>
    <name>espalier::Viewport</name>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
</context>
<context>
    <name>espalier::Workspace</name>
    <message>
        <source>Only one bud grows  ✕</source>
        <translation>Nur ein Ast wächst  ✕</translation>
    </message>
    <message>
        <source>Let all buds grow again.</source>
        <translation>Alle Knospen wieder wachsen lassen</translation>
    </message>
    <message>
        <source>a seedling</source>
        <translation>ein Sämling</translation>
    </message>
    <message>
        <source>%L1 internodes · %L2 leaves · step %L3</source>
        <translation>%L1 Internodien · %L2 Blätter · Schritt %L3</translation>
    </message>
    <message>
        <source>Back to My Tree</source>
        <translation>Zurück zu meinem Baum</translation>
    </message>
    <message>
        <source>Show your own tree again, as it was before this recipe was played.</source>
        <translation>Wieder den eigenen Baum zeigen, wie er vor diesem Rezept war</translation>
    </message>
</context>
</TS>
