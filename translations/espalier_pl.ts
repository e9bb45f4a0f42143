<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl_PL" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>Start with a seedling.</source>
        <translation>Zaczyna od siewki.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Otwórz…</translation>
    </message>
    <message>
        <source>Open a project or a recipe.</source>
        <translation>Otwiera projekt lub przepis.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>Zapisuje projekt.</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Zapisz jako…</translation>
    </message>
    <message>
        <source>Save the project under another name.</source>
        <translation>Zapisuje projekt pod inną nazwą.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Eksportuj…</translation>
    </message>
    <message>
        <source>Write the tree for other programs: GLB, FBX, OBJ, or its skeleton as CSV.</source>
        <translation>Zapisuje drzewo dla innych programów: GLB, FBX, OBJ albo jego szkielet jako CSV.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Zakończ</translation>
    </message>
    <message>
        <source>Leave Espalier.</source>
        <translation>Kończy pracę z programem Espalier.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Take back what you did last.</source>
        <translation>Cofa ostatnią czynność.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <source>Do again what you took back.</source>
        <translation>Wykonuje ponownie to, co cofnięto.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pędzel</translation>
    </message>
    <message>
        <source>Drag from the tree outward: it grows into the space that the brush passes through.</source>
        <translation>Przeciągnąć od drzewa na zewnątrz: wrasta ono w przestrzeń, którą przechodzi pędzel.</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wzrost</translation>
    </message>
    <message>
        <source>Press anywhere and hold: the tree grows on its own, competing for light and space.</source>
        <translation>Nacisnąć w dowolnym miejscu i przytrzymać: drzewo rośnie samo, walcząc o światło i miejsce.</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Cięcie</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw across all the branches to cut.</source>
        <translation>Stuknąć gałąź, aby ją odciąć, albo przeciągnąć przez wszystkie, które mają spaść.</translation>
    </message>
    <message>
        <source>Bud</source>
        <translation>Pąk</translation>
    </message>
    <message>
        <source>Tap a bud: from now on, only this bud grows, and what comes from it.</source>
        <translation>Stuknąć pąk: odtąd rośnie tylko on i to, co z niego powstanie.</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Gięcie</translation>
    </message>
    <message>
        <source>Pull a branch to bend it; tap it to pin it there.</source>
        <translation>Pociągnąć gałąź, aby ją wygiąć; stuknąć, aby przypiąć ją w tym miejscu.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Tap a branch to fix its width, and drag the handle to change it.</source>
        <translation>Stuknąć gałąź, aby ustalić jej grubość, a potem przeciągnąć uchwyt, aby ją zmienić.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw the silhouette of a crown: the tree grows until it fills that shape.</source>
        <translation>Narysować obrys korony: drzewo rośnie, aż go wypełni.</translation>
    </message>
    <message>
        <source>Grow One Step</source>
        <translation>Krok wzrostu</translation>
    </message>
    <message>
        <source>Let the tree grow one step on its own.</source>
        <translation>Drzewo samo rośnie o jeden krok.</translation>
    </message>
    <message>
        <source>Smaller Brush</source>
        <translation>Mniejszy pędzel</translation>
    </message>
    <message>
        <source>Make the brush smaller, even while brushing.</source>
        <translation>Zmniejsza pędzel, także podczas malowania.</translation>
    </message>
    <message>
        <source>Larger Brush</source>
        <translation>Większy pędzel</translation>
    </message>
    <message>
        <source>Make the brush larger, even while brushing.</source>
        <translation>Powiększa pędzel, także podczas malowania.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Take back the stroke or the growth under way.</source>
        <translation>Cofa trwające pociągnięcie lub wzrost.</translation>
    </message>
    <message>
        <source>Frame All</source>
        <translation>Pokaż całość</translation>
    </message>
    <message>
        <source>Show the whole tree.</source>
        <translation>Pokazuje całe drzewo.</translation>
    </message>
    <message>
        <source>From the Front</source>
        <translation>Z przodu</translation>
    </message>
    <message>
        <source>Look at the tree from the front.</source>
        <translation>Widok drzewa z przodu.</translation>
    </message>
    <message>
        <source>From the Side</source>
        <translation>Z boku</translation>
    </message>
    <message>
        <source>Look at the tree from the side.</source>
        <translation>Widok drzewa z boku.</translation>
    </message>
    <message>
        <source>From the Top</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>Look down at the tree.</source>
        <translation>Widok drzewa z góry.</translation>
    </message>
    <message>
        <source>Three-Quarter</source>
        <translation>Z ukosa</translation>
    </message>
    <message>
        <source>Look at the tree from between the front and the side.</source>
        <translation>Widok drzewa z ukosa.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Znaczniki</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads.</source>
        <translation>Pokazuje punkty wolnego miejsca, które rozsiewa pędzel.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Liście</translation>
    </message>
    <message>
        <source>Show the leaves.</source>
        <translation>Pokazuje liście.</translation>
    </message>
    <message>
        <source>Architecture</source>
        <translation>Architektura</translation>
    </message>
    <message>
        <source>How the tree grows from now on.</source>
        <translation>Jak drzewo rośnie od tej chwili.</translation>
    </message>
    <message>
        <source>What the leaves look like.</source>
        <translation>Wygląd liści.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Gałęzie</translation>
    </message>
    <message>
        <source>How thick branches are, and their bark.</source>
        <translation>Grubość gałęzi i ich kora.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Tło</translation>
    </message>
    <message>
        <source>What is around the tree: background, ground, sun, reference picture.</source>
        <translation>Otoczenie drzewa: tło, podłoże, słońce, obraz do odrysowania.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Everything you did, step by step; click a step to go back to it.</source>
        <translation>Wszystko, co zrobiono, krok po kroku; kliknięcie przenosi w dane miejsce.</translation>
    </message>
    <message>
        <source>Focus Panels or Tree</source>
        <translation>Do paneli i z powrotem</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the panels, or back to the tree.</source>
        <translation>Przekazuje klawisze panelom albo z powrotem drzewu.</translation>
    </message>
    <message>
        <source>Only the Tree</source>
        <translation>Tylko drzewo</translation>
    </message>
    <message>
        <source>Hide everything but the tree; the same key brings everything back.</source>
        <translation>Ukrywa wszystko poza drzewem; ten sam klawisz to przywraca.</translation>
    </message>
    <message>
        <source>Full Screen</source>
        <translation>Pełny ekran</translation>
    </message>
    <message>
        <source>Fill the whole screen.</source>
        <translation>Wypełnia cały ekran.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>Help on the current tool, and on everything else.</source>
        <translation>O wybranym narzędziu i o wszystkim innym.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Pliki</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Edycja</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Okno</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteka</translation>
    </message>
    <message>
        <source>Species to start from, and the trees you keep.</source>
        <translation>Gatunki na początek oraz zachowane drzewa.</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Ustawienia…</translation>
    </message>
    <message>
        <source>How Espalier looks, and how it responds to your hand.</source>
        <translation>Jak Espalier wygląda i jak reaguje na rękę.</translation>
    </message>
    <message>
        <source>Size of the brush, pressure of the pen, and what is shown while you brush.</source>
        <translation>Rozmiar pędzla, nacisk pióra i miejsce, które rozsiewa pędzel.</translation>
    </message>
    <message>
        <source>Save as Recipe…</source>
        <translation>Zapisz jako przepis…</translation>
    </message>
    <message>
        <source>Save everything that was done to the tree, so that it can be done again.</source>
        <translation>Zapisz, co zrobiono z drzewem, aby można było to powtórzyć.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Skręcanie</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands.</source>
        <translation>Przeciągnąć wzdłuż gałęzi albo wokół niej, aby skręcić jej pasma.</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>Nowe pąki</translation>
    </message>
    <message>
        <source>Tap old wood: buds break through its bark, and grow into branches.</source>
        <translation>Stuknąć stare drewno: przez korę przebijają się pąki i wyrastają z nich gałęzie.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Tap a branch to see its cross-section, and draw its shape.</source>
        <translation>Stuknąć gałąź, aby zobaczyć jej przekrój i narysować jego kształt.</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>Pobudzanie</translation>
    </message>
    <message>
        <source>Press a branch and hold: it alone grows until you let go.</source>
        <translation>Nacisnąć gałąź i przytrzymać: aż do puszczenia rośnie tylko ona.</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Redukcja</translation>
    </message>
    <message>
        <source>Press a branch and hold: its youngest growth disappears, step by step.</source>
        <translation>Nacisnąć gałąź i przytrzymać: krok po kroku znikają jej najmłodsze przyrosty.</translation>
    </message>
    <message>
        <source>Show the strands of the wood as lines, each branch in its own colour.</source>
        <translation>Pokazuje pasma, z których składa się drewno, jako linie, każdą gałąź w jej kolorze.</translation>
    </message>
    <message>
        <source>Strand Lines</source>
        <translation>Linie pasm</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Szkic</translation>
    </message>
    <message>
        <source>Draw the trunk and its branches as lines, then give the drawing depth.</source>
        <translation>Narysuj pień i gałęzie liniami, a potem nadaj rysunkowi głębię.</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Powielanie</translation>
    </message>
    <message>
        <source>Tap a branch: it gets more branches like those it carries, or passes on to others what it carries.</source>
        <translation>Dotknij gałęzi: dostanie więcej takich, jakie niesie, albo przekaże je dalej.</translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation>Odtwórz</translation>
    </message>
    <message>
        <source>Draw a trunk and a silhouette: the same tree takes on this new shape.</source>
        <translation>Narysuj pień i sylwetkę: to samo drzewo przyjmie tę nową postać.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Przesuń</translation>
    </message>
    <message>
        <source>Drag a branch along the wood, around it, or to other wood, with all it carries.</source>
        <translation>Przeciągnij gałąź wzdłuż drewna, wokół niego albo na inne drewno, ze wszystkim, co niesie.</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>Zapisz obraz…</translation>
    </message>
    <message>
        <source>Save a picture of the tree, in any size and from any side.</source>
        <translation>Zapisać obraz drzewa, w dowolnym rozmiarze i z dowolnej strony.</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Kopiuj obraz</translation>
    </message>
    <message>
        <source>Copy a picture of the tree, as it is shown now, to the clipboard.</source>
        <translation>Umieścić w schowku obraz drzewa, tak jak je widać.</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>Inne podobne</translation>
    </message>
    <message>
        <source>See six other trees that the same strokes could have made, and take one.</source>
        <translation>Zobaczyć sześć drzew, które te same pociągnięcia dają przez inny przypadek, i wziąć jedno.</translation>
    </message>
    <message>
        <source>Person for Scale</source>
        <translation>Człowiek dla skali</translation>
    </message>
    <message>
        <source>Show a person beside the tree, and how long a metre is.</source>
        <translation>Pokazać człowieka obok drzewa i długość metra.</translation>
    </message>
    <message>
        <source>Tool Ring</source>
        <translation>Pierścień narzędzi</translation>
    </message>
    <message>
        <source>Tools, undo and brush size in a ring around the pointer. Hold the key, and let go over the one you want.</source>
        <translation>Narzędzia, cofanie i rozmiar pędzla wokół wskaźnika. Przytrzymać klawisz i puścić nad jednym z nich.</translation>
    </message>
    <message>
        <source>Second View</source>
        <translation>Drugi widok</translation>
    </message>
    <message>
        <source>Show the tree from the right, in a corner of the window; draw there, too, to give it depth.</source>
        <translation>Pokazać w rogu drzewo z prawej; rysowanie także tam daje mu głębię.</translation>
    </message>
    <message>
        <source>Report a Problem…</source>
        <translation>Zgłoś problem…</translation>
    </message>
    <message>
        <source>Copy what a report should have: version, graphics and log.</source>
        <translation>Skopiuj to, co powinno znaleźć się w zgłoszeniu: wersję, dane o grafice i dziennik.</translation>
    </message>
    <message>
        <source>Bring Trees Back…</source>
        <translation>Przywróć drzewa…</translation>
    </message>
    <message>
        <source>See the trees that were not saved when Espalier ended.</source>
        <translation>Pokaż drzewa, które nie były zapisane, gdy Espalier zakończył działanie.</translation>
    </message>
</context>
<context>
    <name>AddBudsTool</name>
    <message>
        <source>Tap old wood to let buds break through its bark; they grow into branches</source>
        <translation>Stuknąć stare drewno, aby przez korę przebiły się pąki; wyrosną z nich gałęzie</translation>
    </message>
</context>
<context>
    <name>BendTool</name>
    <message>
        <source>Pull a branch to bend it; or tap where the bend begins, then where to hold it</source>
        <translation>Pociągnąć gałąź, aby ją wygiąć; stuknięcie przypina jej podstawę, a kolejne miejsca, w których jest trzymana</translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message>
        <source>Drag to brush a tree into being; begin at a branch to draw at its depth</source>
        <translation>Przeciągnąć, aby namalować drzewo; początek na gałęzi oznacza malowanie na jej głębokości</translation>
    </message>
    <message>
        <source>No bud sees this place: keep drawing, or begin at a branch</source>
        <translation>Żaden pąk nie widzi tego miejsca: rysuj dalej albo zacznij od gałęzi</translation>
    </message>
    <message>
        <source>Only the chosen bud grows, and it does not see this place</source>
        <translation>Rośnie tylko wybrany pąk, a on nie widzi tego miejsca</translation>
    </message>
</context>
<context>
    <name>ClearTool</name>
    <message>
        <source>buds may shoot</source>
        <translation>pąki mogą rosnąć</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: below your hand, nothing shoots any more</source>
        <translation>Przeciągnij w górę wzdłuż pnia lub gałęzi: poniżej dłoni nic już nie wyrasta</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--strict: nothing is written, because some operations did not find everything that they name</source>
        <translation>--strict: nic nie zapisano, bo operacje nie znalazły nic do zrobienia albo nie wszystko, co wymieniają</translation>
    </message>
    <message>
        <source>--size needs WIDTHxHEIGHT of up to %1 pixels each, not &quot;%2&quot;</source>
        <translation>--size wymaga SZEROKOŚĆxWYSOKOŚĆ, najwyżej po %1 pikseli, a nie „%2”</translation>
    </message>
    <message>
        <source>%1: the suffix of an output says its format, and is one of .espalier .%2</source>
        <translation>%1: rozszerzenie pliku wynikowego określa format i musi być jednym z .espalier .%2</translation>
    </message>
    <message>
        <source>--camera needs front, side, top or three-quarter, not &quot;%1&quot;</source>
        <translation>--camera to front, side, top lub three-quarter, a nie „%1”</translation>
    </message>
    <message>
        <source>--threads needs a number from 1 to %1, not &quot;%2&quot;</source>
        <translation>--threads wymaga liczby od 1 do %1, a nie „%2”</translation>
    </message>
    <message>
        <source>--seed needs a whole number from 0 to 18446744073709551615, not &quot;%1&quot;</source>
        <translation>--seed wymaga liczby całkowitej od 0 do 18446744073709551615, a nie „%1”</translation>
    </message>
    <message>
        <source>%1 has no option %2</source>
        <translation>%1 nie zna opcji %2</translation>
    </message>
    <message>
        <source>%1 takes no value</source>
        <translation>%1 nie przyjmuje wartości</translation>
    </message>
    <message>
        <source>%1 needs a value after it</source>
        <translation>po %1 musi następować wartość</translation>
    </message>
    <message>
        <source>--transparent needs --png FILE</source>
        <translation>--transparent wymaga --png PLIK</translation>
    </message>
    <message>
        <source>--ground-shadow needs --transparent</source>
        <translation>--ground-shadow wymaga --transparent</translation>
    </message>
    <message>
        <source>%1 needs one project</source>
        <translation>%1 wymaga jednego projektu</translation>
    </message>
    <message>
        <source>render needs --png FILE</source>
        <translation>render wymaga --png PLIK</translation>
    </message>
    <message>
        <source>info needs one file</source>
        <translation>info wymaga jednego pliku</translation>
    </message>
    <message>
        <source>a window opens only one file; &quot;%1&quot; is one too many</source>
        <translation>okno pokazuje jeden plik, czym więc jest „%1”?</translation>
    </message>
    <message>
        <source>%1: its history, played again, gives a different tree from the one it holds</source>
        <translation>%1: jego historia odtworzona ponownie daje inne drzewo niż zapisane</translation>
    </message>
    <message>
        <source>replay needs at least one recipe or project</source>
        <translation>replay wymaga co najmniej jednego przepisu lub projektu</translation>
    </message>
    <message>
        <source>import needs one skeleton and -o OUT</source>
        <translation>import wymaga jednego szkieletu i -o WYNIK</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>nie ma miejsca na więcej zestawów parametrów</translation>
    </message>
    <message>
        <source>--set needs group.name=value, not &quot;%1&quot;</source>
        <translation>--set wymaga grupa.nazwa=wartość, a nie „%1”</translation>
    </message>
    <message>
        <source>--set: there is no parameter &quot;%1&quot;</source>
        <translation>--set nie zna parametru „%1”</translation>
    </message>
    <message>
        <source>--fibres needs --png FILE</source>
        <translation>--fibres wymaga --png PLIK</translation>
    </message>
    <message>
        <source>--index needs a whole number from 0, not &quot;%1&quot;</source>
        <translation>--index wymaga liczby całkowitej od 0, a nie „%1”</translation>
    </message>
    <message>
        <source>sketch needs at least one drawing</source>
        <translation>sketch wymaga co najmniej jednego rysunku</translation>
    </message>
    <message>
        <source>it has more than %1 strokes</source>
        <translation>ma więcej niż %1 kresek</translation>
    </message>
    <message>
        <source>it has no line that can be a trunk, and no crown</source>
        <translation>nie ma linii, która mogłaby być pniem, ani korony</translation>
    </message>
    <message>
        <source>--vary needs a whole number from 0, and after a colon an amount from %1 to 1 if you like, such as 7 or 7:0.5, not &quot;%2&quot;</source>
        <translation>--vary wymaga liczby całkowitej od 0, a po dwukropku, jeśli chcesz, miary od %1 do 1, jak 7 lub 7:0.5, a nie „%2”</translation>
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
        <translation>Espalier: malowanie drzew.

espalier [PROJEKT]
    Otwiera okno.

espalier --demo [PRZEPIS]
    Otwiera okno i maluje w nim drzewo, po czym je oddaje.

espalier replay PRZEPIS|PROJEKT... [-o WYNIK]... [--png PLIK] [--size SxW]
                [--camera front|side|top|three-quarter]
                [--transparent [--ground-shadow]] [--fibres]
                [--stats PLIK] [--profiles PLIK] [--threads N] [--seed N]
                [--strict] [--vary LICZBA[:MIARA]]
                [--set GRUPA.NAZWA=WARTOŚĆ]...
    Wykonuje bez okna to, co mówi przepis, i zapisuje wynik.
    Z projektu powtarza wszystko, co zrobiono z jego drzewem.
    Przy kilku przepisach każdy prowadzi dalej drzewo poprzedniego: pierwszy
    podaje ziarno, a każdy na początku wprowadza swoje parametry.
    --profiles: położenie pasm w każdym przekroju, jako JSON.
    To, czego operacje nie znajdują w drzewie, jest wypisywane; z --strict jest
    to błąd i nic nie zostaje zapisane.
    --set nadaje parametrowi wartość na całe odtwarzanie, cokolwiek mówią
    przepisy: --set growth.shedding=0.1 --set leaves.visible=false. Kąty
    podaje się w stopniach.
    --vary zmienia trochę kąty i długości drzewa, o miarę 0.3 albo do 1: inna
    liczba to inne drzewo, obok niego w lesie.

espalier import SZKIELET.csv -o WYNIK...
    Tworzy drzewo ze zmierzonego: wiersze z id, parent, oboma końcami i
    promieniem.

espalier sketch RYSUNEK... [--index N] [--front-only] [-o WYNIK]...
                [--png PLIK] [--size SxW] [--camera ...] [--stats PLIK]
                [--seed N] [--set GRUPA.NAZWA=WARTOŚĆ]...
    Tworzy drzewo z tego, co ktoś narysował: linie to gałęzie, małe pętle to
    liście, duża pętla to korona, w którą drzewo wrasta. Rysunki to SVG albo
    .ndjson z Quick, Draw!, z którego --index bierze wiersz, od 0. Z kilku
    rysunków każdy jest rysowany na poprzednim. --front-only: głębia jest
    nadawana raz, bez drugiego umieszczenia rysunku z boku.

espalier export PROJEKT [-o WYNIK]... [--vary LICZBA[:MIARA]]
                [--set GRUPA.NAZWA=WARTOŚĆ]...
    Zapisuje projekt w innych formatach. --vary i --set zmieniają tylko to,
    co zostaje zapisane; projekt pozostaje bez zmian.

espalier render PROJEKT --png PLIK [--size SxW] [--camera ...]
                [--transparent [--ground-shadow]] [--fibres]
                [--vary LICZBA[:MIARA]] [--set GRUPA.NAZWA=WARTOŚĆ]...
    Tworzy obraz. Wymaga ekranu; wystarczy wirtualny.
    --transparent: samo drzewo, z prostym kanałem alfa; --ground-shadow
    zachowuje jego cień jako czerń o pewnym kryciu.
    --fibres: pasma drewna jako linie.

espalier info PLIK
    Podaje jako JSON, co jest w projekcie.

espalier --help, --version

WYNIK kończy się na .espalier (projekt) lub na rozszerzenie formatu:
%1Kod wyjścia: 0 po wykonaniu, 2 przy błędnym wierszu poleceń, 3 gdy danych nie
da się odczytać lub są błędne, 4 gdy nie udało się zapisać wyniku.
</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Bend</source>
        <translation>Gięcie</translation>
    </message>
    <message>
        <source>Brush Stroke</source>
        <translation>Pociągnięcie</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wzrost</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Cięcie</translation>
    </message>
    <message>
        <source>Change Parameters</source>
        <translation>Zmiana parametrów</translation>
    </message>
    <message>
        <source>Go to Another Time</source>
        <translation>Podróż w czasie</translation>
    </message>
    <message>
        <source>Remove Width</source>
        <translation>Usunięcie grubości</translation>
    </message>
    <message>
        <source>Set Width</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>a sketch can only become a tree where nothing has grown</source>
        <translation>szkic może stać się drzewem tylko tam, gdzie nic jeszcze nie wyrosło</translation>
    </message>
    <message>
        <source>no stroke of the sketch is a branch</source>
        <translation>żadna kreska szkicu nie jest gałęzią</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Szkic</translation>
    </message>
    <message>
        <source>a skeleton can only be imported where nothing has grown</source>
        <translation>szkielet można wczytać tylko tam, gdzie nic jeszcze nie wyrosło</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Wczytanie</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>Nowe pąki</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>Pobudzanie</translation>
    </message>
    <message>
        <source>Draw Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Blend Profiles</source>
        <translation>Interpolacja profili</translation>
    </message>
    <message>
        <source>Remove Profile</source>
        <translation>Usunięcie profilu</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Redukcja</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Skręcanie</translation>
    </message>
    <message>
        <source>Remove Twist</source>
        <translation>Usunięcie skręcenia</translation>
    </message>
    <message>
        <source>Give Depth</source>
        <translation>Nadaj głębię</translation>
    </message>
    <message>
        <source>Draw Branch</source>
        <translation>Rysuj gałąź</translation>
    </message>
    <message>
        <source>Multiply Branch</source>
        <translation>Powiel gałąź</translation>
    </message>
    <message>
        <source>Place Leaf</source>
        <translation>Umieść liść</translation>
    </message>
    <message>
        <source>Arrange Leaves</source>
        <translation>Rozmieść liście</translation>
    </message>
    <message>
        <source>Pass On Branch</source>
        <translation>Przenieś gałąź</translation>
    </message>
    <message>
        <source>the new trunk must be an open line</source>
        <translation>nowy pień musi być otwartą linią</translation>
    </message>
    <message>
        <source>Reshape Tree</source>
        <translation>Odtwórz drzewo</translation>
    </message>
    <message>
        <source>Vary Tree</source>
        <translation>Zmień drzewo</translation>
    </message>
    <message>
        <source>Move Branch</source>
        <translation>Przesuń gałąź</translation>
    </message>
    <message numerus="yes">
        <source>Brush Stroke, %n branches</source>
        <translation>
            <numerusform>Pociągnięcie pędzla, %n gałąź</numerusform>
            <numerusform>Pociągnięcie pędzla, %n gałęzie</numerusform>
            <numerusform>Pociągnięcie pędzla, %n gałęzi</numerusform>
        </translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Usuwanie</translation>
    </message>
    <message>
        <source>Thin Out</source>
        <translation>Przerzedzenie</translation>
    </message>
    <message>
        <source>Keep Clear</source>
        <translation>Oczyszczenie</translation>
    </message>
    <message>
        <source>Let Buds Shoot</source>
        <translation>Pozwolenie pąkom rosnąć</translation>
    </message>
    <message numerus="yes">
        <source>Prune, %n branches</source>
        <translation>
            <numerusform>Cięcie, %n gałąź</numerusform>
            <numerusform>Cięcie, %n gałęzie</numerusform>
            <numerusform>Cięcie, %n gałęzi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Grow, %n steps</source>
        <translation>
            <numerusform>Wzrost, %n krok</numerusform>
            <numerusform>Wzrost, %n kroki</numerusform>
            <numerusform>Wzrost, %n kroków</numerusform>
        </translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Ponowny wzrost</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>Usunięcie obwiedni</translation>
    </message>
    <message>
        <source>Earlier Steps</source>
        <translation>Wcześniejsze kroki</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Tap a branch to cut it off, or draw across the branches to cut</source>
        <translation>Dotknij gałęzi, aby ją odciąć, albo przeciągnij w poprzek gałęzi do ścięcia</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>there is no display (DISPLAY is not set); xvfb-run provides a virtual one</source>
        <translation>brak ekranu (zmienna DISPLAY nie jest ustawiona); wirtualny zapewnia xvfb-run</translation>
    </message>
    <message>
        <source>the display %1 does not answer</source>
        <translation>ekran %1 nie odpowiada</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>it is not an SVG</source>
        <translation>to nie jest SVG</translation>
    </message>
    <message>
        <source>it has no drawing %1</source>
        <translation>nie ma rysunku %1</translation>
    </message>
    <message>
        <source>a stroke has more x than y values, or fewer</source>
        <translation>kreska nie ma tylu x co y</translation>
    </message>
    <message>
        <source>a stroke has a point that is not a number</source>
        <translation>kreska ma punkt, który nie jest liczbą</translation>
    </message>
    <message>
        <source>it has no strokes</source>
        <translation>nie ma kresek</translation>
    </message>
    <message>
        <source>it has more than %1 points</source>
        <translation>ma więcej niż %1 punktów</translation>
    </message>
</context>
<context>
    <name>Envelope</name>
    <message>
        <source>There is no lasso stroke.</source>
        <translation>Nie ma obrysu lassa.</translation>
    </message>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>Płaszczyzna rysowania lassa jest nieprawidłowa.</translation>
    </message>
    <message>
        <source>The lasso is too small to enclose anything.</source>
        <translation>Lasso jest za małe, by cokolwiek objąć.</translation>
    </message>
    <message>
        <source>The lasso encloses no area.</source>
        <translation>Lasso nie obejmuje żadnego obszaru.</translation>
    </message>
    <message>
        <source>The lasso is too small for its distance from the origin.</source>
        <translation>Lasso jest za małe jak na swoją odległość od początku układu.</translation>
    </message>
</context>
<context>
    <name>EraserTool</name>
    <message>
        <source>Brush over twigs to thin them evenly; those to be removed turn red</source>
        <translation>Przesuń pędzlem po gałązkach, aby równomiernie usunąć część z nich; to, co zniknie, robi się czerwone</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are</source>
        <translation>Przesuń pędzlem po gałązkach i liściach, aby je usunąć, nawet głęboko w koronie</translation>
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
        <translation>Binarny glTF</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Skeleton as a table</source>
        <translation>Szkielet jako tabela</translation>
    </message>
</context>
<context>
    <name>Exporter</name>
    <message>
        <source>the meshes could not be written: %1</source>
        <translation>nie udało się zapisać siatek: %1</translation>
    </message>
    <message>
        <source>“.%1” is not an export format; the formats are %2</source>
        <translation>nie ma eksportu do „.%1”; możliwe są %2</translation>
    </message>
    <message>
        <source>The export was cancelled.</source>
        <translation>Eksport anulowano.</translation>
    </message>
    <message>
        <source>there are too many files with similar names in this folder; choose another name or another folder</source>
        <translation>w jego folderze jest zbyt wiele plików o podobnych nazwach; wybrać inną nazwę lub inny folder</translation>
    </message>
    <message>
        <source>another program made this file during the export; export again, and another name will be chosen</source>
        <translation>inny program utworzył ten plik podczas eksportu; wyeksportować ponownie, a zostanie wybrana inna nazwa</translation>
    </message>
    <message>
        <source>the tree takes more than the 4 GB that such a file can hold; export less detail</source>
        <translation>drzewo zajmuje więcej niż 4 GB, które mieści taki plik; wyeksportować mniej szczegółów</translation>
    </message>
    <message>
        <source>the tree takes more than such a file can hold; export less detail</source>
        <translation>drzewo zajmuje więcej, niż mieści taki plik; eksportuj mniej szczegółów</translation>
    </message>
</context>
<context>
    <name>FbxRepair</name>
    <message>
        <source>this is not a valid binary FBX file</source>
        <translation>to nie jest poprawny binarny plik FBX</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open</source>
        <translation>Otwieranie</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Zapisywanie</translation>
    </message>
    <message>
        <source>Trees (*.espalier)</source>
        <translation>Drzewa (*.espalier)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Espalier</source>
        <translation>Espalier</translation>
    </message>
    <message>
        <source>%1 is still growing. What has grown so far is not saved.</source>
        <translation>„%1” jeszcze rośnie. To, co dotąd wyrosło, nie jest zapisane.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>„%1” ma niezapisane zmiany.</translation>
    </message>
    <message>
        <source>%1 has been changed by another window or program since it was opened or saved here. Overwriting it loses those changes.</source>
        <translation>Plik %1 zmieniono w innym oknie lub programie, odkąd go tu otwarto lub zapisano. Nadpisanie usuwa te zmiany.</translation>
    </message>
    <message>
        <source>Save as Recipe</source>
        <translation>Zapisz jako przepis</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Przepisy (*.json)</translation>
    </message>
    <message>
        <source>Trees, recipes and measured skeletons (*.espalier *.json *.csv);;Trees (*.espalier);;Recipes (*.json);;Skeletons (*.csv);;All files (*)</source>
        <translation>Drzewa, przepisy i zmierzone szkielety (*.espalier *.json *.csv);;Drzewa (*.espalier);;Przepisy (*.json);;Szkielety (*.csv);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Zapis obrazu</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Obrazy (*.png)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Zapisz</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Odrzuć</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Anuluj</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>&amp;Zapisz jako…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Nadpisz</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>jest większy niż %1 bajtów</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>jest większy niż %1 MB</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>to jest folder</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file</source>
        <translation>to urządzenie lub potok, a nie plik</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>nie można go odczytać: %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>nie ma takiego pliku</translation>
    </message>
</context>
<context>
    <name>FileWriter</name>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>folder %1 nie istnieje</translation>
    </message>
    <message>
        <source>%1 is not a folder</source>
        <translation>%1 nie jest folderem</translation>
    </message>
    <message>
        <source>a folder with this name already exists</source>
        <translation>istnieje folder o tej nazwie</translation>
    </message>
    <message>
        <source>you may not write into the folder %1</source>
        <translation>brak uprawnień do zapisu w folderze %1</translation>
    </message>
    <message>
        <source>you may not change this file</source>
        <translation>brak uprawnień do zmiany tego pliku</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>dysk jest pełny</translation>
    </message>
    <message>
        <source>your disk quota is used up</source>
        <translation>przydzielona część dysku jest pełna</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>dysk jest tylko do odczytu</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>brak uprawnień do zapisu w tym miejscu</translation>
    </message>
    <message>
        <source>the file is too large for this disk</source>
        <translation>plik jest za duży na ten dysk</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>dysk jest uszkodzony</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>nazwa jest za długa</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>zbyt wiele plików jest otwartych</translation>
    </message>
    <message>
        <source>the system does not say why</source>
        <translation>system nie podaje przyczyny</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>plik musi mieć nazwę</translation>
    </message>
    <message>
        <source>it is a link that leads back to itself</source>
        <translation>to dowiązanie, które prowadzi do siebie samego</translation>
    </message>
    <message>
        <source>no program reads from this pipe</source>
        <translation>żaden program nie czyta z tego potoku</translation>
    </message>
    <message>
        <source>another program has changed it</source>
        <translation>inny program go zmienił</translation>
    </message>
</context>
<context>
    <name>GrowTool</name>
    <message>
        <source>Press and hold: the tree grows until you let go</source>
        <translation>Nacisnąć i przytrzymać: drzewo rośnie aż do puszczenia.</translation>
    </message>
</context>
<context>
    <name>ImageFile</name>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>rozmiar przekracza %1 MB</translation>
    </message>
    <message>
        <source>it is neither a PNG nor a JPEG image</source>
        <translation>to nie jest obraz PNG ani JPEG</translation>
    </message>
    <message>
        <source>the image is broken</source>
        <translation>obraz jest uszkodzony</translation>
    </message>
    <message>
        <source>it has %1 × %2 pixels; %3 along an edge is the most</source>
        <translation>wymiary to %1 × %2 pikseli; bok może mieć najwyżej %3</translation>
    </message>
    <message>
        <source>it is too small: only %1 × %2 pixels</source>
        <translation>wymiary to tylko %1 × %2 pikseli</translation>
    </message>
    <message>
        <source>it is not a picture that can be read</source>
        <translation>to nie jest obraz, który da się odczytać</translation>
    </message>
</context>
<context>
    <name>ImageStructure</name>
    <message>
        <source>the file is not whole</source>
        <translation>plik nie jest kompletny</translation>
    </message>
    <message>
        <source>it is made so that unpacking it would take very long</source>
        <translation>jest tak zbudowany, że rozpakowanie trwałoby bardzo długo</translation>
    </message>
</context>
<context>
    <name>InvigorateTool</name>
    <message>
        <source>Press a branch and hold: it grows until you let go</source>
        <translation>Nacisnąć gałąź i przytrzymać: rośnie aż do puszczenia</translation>
    </message>
</context>
<context>
    <name>JournalCheck</name>
    <message>
        <source>it changes nothing</source>
        <translation>niczego nie zmienia</translation>
    </message>
    <message>
        <source>it places a leaf that is not there</source>
        <translation>umieszcza liść, którego nie ma</translation>
    </message>
    <message>
        <source>it places a leaf at another time</source>
        <translation>umieszcza liść w innym czasie</translation>
    </message>
    <message>
        <source>it creates an internode whose parameters are not there</source>
        <translation>tworzy międzywęźle, którego parametrów nie ma</translation>
    </message>
    <message>
        <source>its steps do not follow on from those around it</source>
        <translation>jego kroki nie pasują do sąsiednich</translation>
    </message>
    <message>
        <source>its parameters do not follow on from those of the steps around it</source>
        <translation>jego parametry nie pasują do sąsiednich</translation>
    </message>
    <message>
        <source>its births are out of order</source>
        <translation>jego nowe międzywęźla są w złej kolejności</translation>
    </message>
    <message>
        <source>it records the death of an internode that did not die</source>
        <translation>uśmierca międzywęźle, które nie obumarło</translation>
    </message>
    <message>
        <source>it creates an internode that is not there</source>
        <translation>tworzy międzywęźle, którego nie ma</translation>
    </message>
    <message>
        <source>it creates an internode at another time</source>
        <translation>tworzy międzywęźle w innym czasie</translation>
    </message>
    <message>
        <source>before it, an internode would live on a dead one</source>
        <translation>przed nim międzywęźle żyłoby na martwym</translation>
    </message>
    <message>
        <source>before it, two internodes would continue the same axis</source>
        <translation>przed nim dwa międzywęźla przedłużałyby tę samą oś</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>krok %1 historii</translation>
    </message>
    <message>
        <source>it places a leaf on an internode that is not there</source>
        <translation>umieszcza liść na międzywęźlu, którego nie ma</translation>
    </message>
    <message>
        <source>it changes an envelope in a way that is not possible</source>
        <translation>zmienia obwiednię w niemożliwy sposób</translation>
    </message>
    <message>
        <source>something is set before it on what it brings</source>
        <translation>przed nim coś ustalono na tym, co dopiero on wnosi</translation>
    </message>
    <message>
        <source>the beginning of the history</source>
        <translation>początek historii</translation>
    </message>
    <message>
        <source>it changes “%1”, which never changes</source>
        <translation>zmienia „%1”, co nigdy się nie zmienia</translation>
    </message>
    <message>
        <source>it changes “%1” of a row that was not there</source>
        <translation>zmienia „%1” w wierszu, którego nie było</translation>
    </message>
    <message>
        <source>it changes “%1” in a way that is not possible</source>
        <translation>zmienia „%1” w niemożliwy sposób</translation>
    </message>
    <message>
        <source>it refers to strokes or profiles that are not there</source>
        <translation>wnosi obrysy lub profile, których nie ma</translation>
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
        <translation>rozmiar przekracza %1 MB</translation>
    </message>
    <message>
        <source>it holds too many values</source>
        <translation>zawiera zbyt wiele wartości</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>wiersz %1</translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation>nieprawidłowy JSON: %1</translation>
    </message>
    <message>
        <source>a JSON object is expected</source>
        <translation>oczekiwano obiektu JSON</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>brak tego elementu</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected</source>
        <translation>oczekiwano liczby całkowitej od %1 do %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected</source>
        <translation>oczekiwano liczby od %1 do %2</translation>
    </message>
    <message>
        <source>a string is expected</source>
        <translation>oczekiwano tekstu</translation>
    </message>
    <message>
        <source>a whole number of at most 64 bits is expected; from 2^53 on, write it as a string of digits</source>
        <translation>oczekiwano liczby całkowitej do 64 bitów, od 2^53 zapisanej jako ciąg cyfr</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>oczekiwano obiektu</translation>
    </message>
    <message>
        <source>an array is expected</source>
        <translation>oczekiwano tablicy</translation>
    </message>
    <message>
        <source>“%1” is not known here</source>
        <translation>nazwa „%1” nie jest tu znana</translation>
    </message>
</context>
<context>
    <name>Lasso</name>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>Płaszczyzna rysowania lassa jest nieprawidłowa.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>There is no envelope to regrow.</source>
        <translation>Nie ma obwiedni, którą drzewo mogłoby wypełnić od nowa.</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>Wzrost od nowa</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>Usunięcie obwiedni</translation>
    </message>
    <message>
        <source>There is no envelope to fill.</source>
        <translation>Nie ma obwiedni, którą drzewo mogłoby wypełnić.</translation>
    </message>
    <message>
        <source>There is no room for more parameter sets.</source>
        <translation>Nie ma miejsca na więcej zestawów parametrów.</translation>
    </message>
    <message>
        <source>There is no room for more lassos.</source>
        <translation>Nie ma miejsca na więcej lass.</translation>
    </message>
</context>
<context>
    <name>LassoTool</name>
    <message>
        <source>Draw the silhouette of a crown; the tree fills it. Begin at a branch to draw at its depth</source>
        <translation>Narysować obrys korony; drzewo go wypełni. Początek na gałęzi oznacza rysowanie na jej głębokości</translation>
    </message>
</context>
<context>
    <name>LeafChoices</name>
    <message>
        <source>One leaf at a time along the branch, each turned from the one before as the second is from the first.</source>
        <translation>Po jednym liściu wzdłuż gałęzi, każdy obrócony tak jak drugi względem pierwszego.</translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>A tree needs a name.</source>
        <translation>Drzewo musi mieć nazwę.</translation>
    </message>
    <message>
        <source>A name cannot begin with a full stop.</source>
        <translation>Nazwa nie może zaczynać się od kropki.</translation>
    </message>
    <message>
        <source>A name cannot contain any of / \ : * ? &quot; &lt; &gt; |.</source>
        <translation>Nazwa nie może zawierać żadnego ze znaków / \ : * ? &quot; &lt; &gt; |.</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>Ta nazwa jest za długa.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>Nie można utworzyć folderu %1.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Drzewo</translation>
    </message>
    <message>
        <source>There is already a tree named %1.</source>
        <translation>Drzewo o nazwie %1 już istnieje.</translation>
    </message>
    <message>
        <source>%1 cannot be renamed: %2</source>
        <translation>Nie można zmienić nazwy %1: %2</translation>
    </message>
    <message>
        <source>%1 cannot be copied: %2</source>
        <translation>Nie można skopiować %1: %2</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 już nie istnieje.</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash: %2</source>
        <translation>Nie można przenieść %1 do kosza: %2</translation>
    </message>
    <message>
        <source>There is another tree named %1 now.</source>
        <translation>Jest już inne drzewo o nazwie %1.</translation>
    </message>
    <message>
        <source>%1 cannot be taken out of the trash: %2</source>
        <translation>Nie można wyjąć %1 z kosza: %2</translation>
    </message>
</context>
<context>
    <name>MoveTool</name>
    <message>
        <source>a trunk stays where it stands; drag a branch</source>
        <translation>pień stoi w miejscu; chwyć gałąź</translation>
    </message>
    <message>
        <source>Drag a branch along the wood or around it; drag its base to other wood, its tip to scale it</source>
        <translation>Przeciągnij gałąź wzdłuż drewna lub wokół niego; przy nasadzie na inne drewno; przy wierzchołku, by zmienić wielkość</translation>
    </message>
</context>
<context>
    <name>MultiplyTool</name>
    <message>
        <source>Tap a branch: it gets one more branch like those that it carries</source>
        <translation>Dotknij gałęzi: dostanie jeszcze jedną podobną do tych, które niesie</translation>
    </message>
    <message>
        <source>Tap a branch: the others get what it carries; drag from it across branches to choose which of them get it</source>
        <translation>Stuknij gałąź: inne dostają to, co ona niesie; albo przeciągnij od niej przez te, które mają to dostać</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>A picture cannot be drawn, because there is no display that offers OpenGL 3.3; a virtual one (Xvfb) will do.</source>
        <translation>Nie można narysować obrazu: brak ekranu z obsługą OpenGL 3.3; wystarczy wirtualny (Xvfb).</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large; %3 along an edge is the most.</source>
        <translation>Obraz o wymiarach %1 × %2 pikseli jest za duży; bok może mieć najwyżej %3.</translation>
    </message>
</context>
<context>
    <name>Outputs</name>
    <message>
        <source>%1: the picture could not be compressed</source>
        <translation>%1: nie udało się spakować obrazu</translation>
    </message>
</context>
<context>
    <name>OwnTextures</name>
    <message>
        <source>%1: the leaf cannot be told apart from its background; the image needs a transparent or a plain background</source>
        <translation>%1: nie można odróżnić liścia od tego, co za nim; obraz musi mieć przezroczyste lub jednolite tło</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Backdrop</source>
        <translation>W tle</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Podłoże</translation>
    </message>
    <message>
        <source>Ground below the tree, with the tree&apos;s shadow.</source>
        <translation>Podłoże pod drzewem, z jego cieniem.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Siatka</translation>
    </message>
    <message>
        <source>Lines on the ground, a metre apart.</source>
        <translation>Linie na podłożu co metr.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Cienie</translation>
    </message>
    <message>
        <source>Shadows of the sun.</source>
        <translation>Cienie rzucane w słońcu.</translation>
    </message>
    <message>
        <source>Show the sun</source>
        <translation>Pokaż słońce</translation>
    </message>
    <message>
        <source>Show the sun as a ball that you can drag around the tree.</source>
        <translation>Pokazuje słońce jako kulę, którą można przeciągać wokół drzewa.</translation>
    </message>
    <message>
        <source>Pin the sun</source>
        <translation>Przypnij słońce</translation>
    </message>
    <message>
        <source>The sun stays where it is on the screen when the tree is turned; otherwise it turns with the tree.</source>
        <translation>Przy obracaniu drzewa słońce pozostaje na ekranie tam, gdzie jest; w przeciwnym razie obraca się z drzewem.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>Where the sun stands: 0° in front of the tree, 90° to its right; for a pinned sun, as seen on the screen.</source>
        <translation>Gdzie stoi słońce: 0° przed drzewem, 90° po jego prawej; przypięte słońce: względem patrzącego.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>How high the sun stands above the horizon.</source>
        <translation>Jak wysoko słońce stoi nad horyzontem.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Krycie</translation>
    </message>
    <message>
        <source>How opaque the picture is.</source>
        <translation>Jak wyraźnie widać obraz.</translation>
    </message>
    <message>
        <source>How tall the picture is.</source>
        <translation>Jak wysoki jest obraz.</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>W prawo</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is to the right of the seedling.</source>
        <translation>Położenie środka obrazu obok siewki.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>W górę</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is above the seedling.</source>
        <translation>Położenie środka obrazu nad siewką.</translation>
    </message>
    <message>
        <source>studio</source>
        <translation>studio</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>horyzont</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>jednolite</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>gradient</translation>
    </message>
    <message>
        <source>Set-point angle</source>
        <translation>Kąt docelowy</translation>
    </message>
    <message>
        <source>The direction that shoots turn to: 0° is up, 90° level, and more makes them weep.</source>
        <translation>Dokąd zwracają się pędy: 0° to w górę, 90° poziomo, a przy większym kącie pędy zwisają.</translation>
    </message>
    <message>
        <source>Gravitropic set-point angle: orthotropic at 0°, plagiotropic near 90°, positively gravitropic beyond.</source>
        <translation>Grawitropiczny kąt docelowy: ortotropowy przy 0°, plagiotropowy blisko 90°, dalej dodatnio grawitropiczny.</translation>
    </message>
    <message>
        <source>Buds above and below</source>
        <translation>Pąki górne i dolne</translation>
    </message>
    <message>
        <source>Vigour of the buds on the upper and lower sides of a leaning branch.</source>
        <translation>Wigor pąków nad pochyloną gałęzią i pod nią.</translation>
    </message>
    <message>
        <source>Vertical semi-axis of the gravimorphic ellipse.</source>
        <translation>Pionowa półoś elipsy grawimorfizmu.</translation>
    </message>
    <message>
        <source>Buds on the sides</source>
        <translation>Pąki boczne</translation>
    </message>
    <message>
        <source>Vigour of the buds on the sides of a leaning branch.</source>
        <translation>Wigor pąków po bokach pochylonej gałęzi.</translation>
    </message>
    <message>
        <source>Semi-axis parallel to the ground; if it is the greater one, amphitony.</source>
        <translation>Półoś równoległa do ziemi; gdy jest większa, to amfitonia.</translation>
    </message>
    <message>
        <source>Upper or lower buds</source>
        <translation>Górne lub dolne pąki</translation>
    </message>
    <message>
        <source>Above 0 the buds on the upper side are stronger, as in fruit trees; below 0 those on the lower side.</source>
        <translation>Powyżej 0 silniejsze są pąki na górnej stronie, jak u drzew owocowych; poniżej 0 te na dolnej.</translation>
    </message>
    <message>
        <source>Displacement of the ellipse: epitony above 0, hypotony below.</source>
        <translation>Przesunięcie elipsy: powyżej 0 epitonia, poniżej hipotonia.</translation>
    </message>
    <message>
        <source>Branching angle</source>
        <translation>Kąt rozgałęzienia</translation>
    </message>
    <message>
        <source>Between a branch and the branches that grow from it.</source>
        <translation>Między gałęzią a tym, co od niej odchodzi.</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral bud on its axis.</source>
        <translation>Kąt osadzenia pąka bocznego na osi.</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Odchylenie</translation>
    </message>
    <message>
        <source>How far an axis turns away from a branch that it bears: 0 keeps it straight, more makes it zigzag.</source>
        <translation>O ile oś odchyla się od gałęzi, którą wydaje: przy 0 pozostaje prosta, więcej daje zygzak.</translation>
    </message>
    <message>
        <source>How far the main axis gives way to a lateral: a tendency to sympodial growth.</source>
        <translation>Oś główna ustępuje bocznej, jak przy wzroście sympodialnym.</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Prostość</translation>
    </message>
    <message>
        <source>How much a shoot keeps the direction that it has.</source>
        <translation>Jak mocno pęd trzyma się swojego kierunku.</translation>
    </message>
    <message>
        <source>Weight of the heading H of the axis.</source>
        <translation>Waga kierunku osi H.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Tropizm</translation>
    </message>
    <message>
        <source>How much a shoot turns towards the set-point angle.</source>
        <translation>Jak mocno pęd zwraca się ku kątowi docelowemu.</translation>
    </message>
    <message>
        <source>Weight of gravitropism T.</source>
        <translation>Waga grawitropizmu T.</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Wolne miejsce</translation>
    </message>
    <message>
        <source>How much a shoot turns towards where there is room.</source>
        <translation>Jak mocno pęd zwraca się tam, gdzie jest miejsce.</translation>
    </message>
    <message>
        <source>Weight of the environment E: the mean direction of the free space that a bud perceives.</source>
        <translation>Waga otoczenia E: średni kierunek wolnej przestrzeni, którą postrzega pąk.</translation>
    </message>
    <message>
        <source>Occupied radius</source>
        <translation>Promień zajęty</translation>
    </message>
    <message>
        <source>Space around each bud that nothing else grows into, in internodes. More makes an airier crown.</source>
        <translation>Przestrzeń wokół każdego pąka, w którą nic innego nie wrasta, w międzywęźlach. Więcej daje bardziej ażurową koronę.</translation>
    </message>
    <message>
        <source>Radius of the zone of occupancy.</source>
        <translation>Promień strefy zajętej.</translation>
    </message>
    <message>
        <source>Sight</source>
        <translation>Wzrok</translation>
    </message>
    <message>
        <source>How far beyond its own space a bud sees room to grow, in internodes.</source>
        <translation>Jak daleko poza własną przestrzenią pąk widzi miejsce do wzrostu, w międzywęźlach.</translation>
    </message>
    <message>
        <source>Depth of the volume of perception, which reaches to r + d.</source>
        <translation>Głębokość obszaru percepcji, który sięga do r + d.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Pole widzenia</translation>
    </message>
    <message>
        <source>How far to the sides a bud sees room to grow.</source>
        <translation>Jak daleko na boki pąk widzi miejsce do wzrostu.</translation>
    </message>
    <message>
        <source>Apex angle of the cone of perception.</source>
        <translation>Kąt wierzchołkowy stożka percepcji.</translation>
    </message>
    <message>
        <source>Apical dominance</source>
        <translation>Dom. apikalna</translation>
    </message>
    <message>
        <source>What gets the vigour: above 0.5 the main axis, as in conifers; below it the branches, as in shrubs.</source>
        <translation>Kto dostaje wigor: powyżej 0,5 oś główna, jak u drzew iglastych; poniżej gałęzie, jak u krzewów.</translation>
    </message>
    <message>
        <source>Excurrent forms above 0.5, decurrent ones below.</source>
        <translation>Powyżej 0,5 formy z przewodnikiem, poniżej bez niego.</translation>
    </message>
    <message>
        <source>Light sensitivity</source>
        <translation>Czułość na światło</translation>
    </message>
    <message>
        <source>How much more a bud in the light thrives than one in the shade.</source>
        <translation>O ile lepiej rozwija się pąk w świetle niż pąk w cieniu.</translation>
    </message>
    <message>
        <source>Exponent of the response to light: high for light-demanding trees, low for shade-tolerant ones.</source>
        <translation>Wykładnik reakcji na światło: wysoki u drzew światłożądnych, niski u cienioznośnych.</translation>
    </message>
    <message>
        <source>Shedding</source>
        <translation>Zrzucanie</translation>
    </message>
    <message>
        <source>Branches with less vigour than this die: 0 keeps them all.</source>
        <translation>Gałęzie o mniejszym wigorze obumierają: 0 zachowuje wszystkie.</translation>
    </message>
    <message>
        <source>Threshold of cladoptosis: vigour per internode, relative to that of the whole tree.</source>
        <translation>Próg kladoptozy: wigor na międzywęźle względem wigoru całego drzewa.</translation>
    </message>
    <message>
        <source>Shoot length</source>
        <translation>Długość pędu</translation>
    </message>
    <message>
        <source>How many internodes the strongest shoot grows in one step.</source>
        <translation>O ile międzywęźli wydłuża się najsilniejszy pęd w jednym kroku.</translation>
    </message>
    <message>
        <source>Metamers of the strongest shoot of a flush.</source>
        <translation>Metamery najsilniejszego pędu w przyroście.</translation>
    </message>
    <message>
        <source>Phyllotaxis</source>
        <translation>Filotaksja</translation>
    </message>
    <message>
        <source>Turn around the axis from one bud to the next: 137.5° is a spiral, 180° two rows, 90° crossed pairs.</source>
        <translation>Obrót wokół osi od pąka do pąka: 137,5° to spirala, 180° dwa rzędy, 90° pary na krzyż.</translation>
    </message>
    <message>
        <source>Divergence angle: spiral, distichous, decussate.</source>
        <translation>Kąt dywergencji: ulistnienie spiralne, dwurzędowe, nakrzyżległe.</translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation>Za pociągnięciem</translation>
    </message>
    <message>
        <source>Shoots turn the way the brush goes, instead of to the set-point angle.</source>
        <translation>Pędy zwracają się tam, dokąd zmierza pędzel, zamiast ku kątowi docelowemu.</translation>
    </message>
    <message>
        <source>The set-point angle is inferred from the direction of the stroke.</source>
        <translation>Kąt docelowy wynika z kierunku pociągnięcia.</translation>
    </message>
    <message>
        <source>Upright trunk</source>
        <translation>Pionowy pień</translation>
    </message>
    <message>
        <source>The trunk grows straight up, whatever the branches do.</source>
        <translation>Pień rośnie prosto w górę, cokolwiek robią gałęzie.</translation>
    </message>
    <message>
        <source>The axis of order 0 is orthotropic, as in most conifers.</source>
        <translation>Oś rzędu 0 jest ortotropowa, jak u większości drzew iglastych.</translation>
    </message>
    <message>
        <source>Internode</source>
        <translation>Międzywęźle</translation>
    </message>
    <message>
        <source>Length of one internode. It is the measure of everything that grows: shorter ones make finer trees.</source>
        <translation>Długość jednego międzywęźla. To miara wszystkiego, co rośnie: krótsze daje drobniejsze drzewa.</translation>
    </message>
    <message>
        <source>Length of a metamer.</source>
        <translation>Długość metameru.</translation>
    </message>
    <message>
        <source>Buds at a node</source>
        <translation>Pąki w węźle</translation>
    </message>
    <message>
        <source>One is alternate, two opposite, more a whorl, as in pines.</source>
        <translation>Jeden to układ skrętoległy, dwa naprzeciwległy, więcej okółek, jak u sosen.</translation>
    </message>
    <message>
        <source>Alternate, opposite or verticillate.</source>
        <translation>Skrętolegle, naprzeciwlegle lub okółkowo.</translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation>Nieregularność</translation>
    </message>
    <message>
        <source>Spread of angles and lengths: 0 is as regular as a diagram, 1 as wild as nature.</source>
        <translation>Rozrzut kątów i długości: 0 to schemat, 1 to dzikość natury.</translation>
    </message>
    <message>
        <source>Variance of the angles and of the metamers.</source>
        <translation>Wariancja kątów i metamerów.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Cień</translation>
    </message>
    <message>
        <source>How much light one internode takes.</source>
        <translation>Ile światła zabiera jedno międzywęźle.</translation>
    </message>
    <message>
        <source>Intensity of the penumbra that a metamer casts.</source>
        <translation>Natężenie półcienia rzucanego przez metamer.</translation>
    </message>
    <message>
        <source>Shadow falloff</source>
        <translation>Zanik cienia</translation>
    </message>
    <message>
        <source>How fast a shadow fades on its way down.</source>
        <translation>Jak szybko cień słabnie ku dołowi.</translation>
    </message>
    <message>
        <source>Base of the shadow&apos;s decay from layer to layer.</source>
        <translation>Podstawa zaniku z warstwy na warstwę.</translation>
    </message>
    <message>
        <source>Shadow depth</source>
        <translation>Zasięg cienia</translation>
    </message>
    <message>
        <source>How many layers below an internode its shadow reaches.</source>
        <translation>Ile warstw pod międzywęźlem sięga jego cień.</translation>
    </message>
    <message>
        <source>Height of the pyramid of shadow, in voxels.</source>
        <translation>Wysokość piramidy cienia w wokselach.</translation>
    </message>
    <message>
        <source>Brush density</source>
        <translation>Gęstość pędzla</translation>
    </message>
    <message>
        <source>How densely the brush spreads room to grow, in points per cubic internode. More makes denser growth.</source>
        <translation>Ile miejsca do wzrostu rozsiewa pędzel, w punktach na sześcienne międzywęźle. Więcej daje gęstszy wzrost.</translation>
    </message>
    <message>
        <source>Density of the markers of free space.</source>
        <translation>Gęstość znaczników wolnej przestrzeni.</translation>
    </message>
    <message>
        <source>Brush memory</source>
        <translation>Pamięć pędzla</translation>
    </message>
    <message>
        <source>After this many growth steps, the room that the brush has spread is forgotten.</source>
        <translation>Liczba kroków wzrostu, po których miejsce rozsiane przez pędzel zostaje zapomniane.</translation>
    </message>
    <message>
        <source>Maximum age of a marker.</source>
        <translation>Największy wiek znacznika.</translation>
    </message>
    <message>
        <source>Room at a bud</source>
        <translation>Miejsce przy pąku</translation>
    </message>
    <message>
        <source>When the tree grows on its own: the room to grow that each bud finds around itself in each step.</source>
        <translation>Gdy drzewo rośnie samo: miejsce do wzrostu, które każdy pąk znajduje wokół siebie w każdym kroku.</translation>
    </message>
    <message>
        <source>Markers generated in each volume of perception.</source>
        <translation>Znaczniki tworzone w każdym obszarze percepcji.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Liście</translation>
    </message>
    <message>
        <source>Whether the tree has any.</source>
        <translation>Czy drzewo w ogóle ma liście.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>The outline of a leaf.</source>
        <translation>Zarys liścia.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>From the stalk to the tip.</source>
        <translation>Od ogonka do wierzchołka.</translation>
    </message>
    <message>
        <source>Breadth</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Width as a share of length.</source>
        <translation>Szerokość względem długości.</translation>
    </message>
    <message>
        <source>Variation in size</source>
        <translation>Zmienność rozmiaru</translation>
    </message>
    <message>
        <source>How much the sizes of leaves differ.</source>
        <translation>Jak bardzo różnią się rozmiary liści.</translation>
    </message>
    <message>
        <source>At a node</source>
        <translation>W węźle</translation>
    </message>
    <message>
        <source>How many leaves grow together.</source>
        <translation>Ile liści wyrasta razem.</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>Ułożenie</translation>
    </message>
    <message>
        <source>How leaves stand around a shoot: as its buds do; in a spiral; together, each pair or whorl across the one before; or flat in two rows, as on beech and hemlock.</source>
        <translation>Jak liście stoją wokół pędu: tak jak jego pąki; spiralnie; razem, każda para lub okółek w poprzek poprzedniego; albo płasko w dwóch rzędach, jak u buka i choiny.</translation>
    </message>
    <message>
        <source>Leaf phyllotaxis: spiral, decussate or verticillate, distichous.</source>
        <translation>Ulistnienie: skrętoległe, nakrzyżległe lub okółkowe, dwurzędowe.</translation>
    </message>
    <message>
        <source>shoot</source>
        <translation>pęd</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>spirala</translation>
    </message>
    <message>
        <source>opposite</source>
        <translation>naprzeciw</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>płasko</translation>
    </message>
    <message>
        <source>How far inward</source>
        <translation>Jak głęboko</translation>
    </message>
    <message>
        <source>Branches that carry more twigs than this are bare.</source>
        <translation>Gałęzie, które niosą więcej gałązek, są nagie.</translation>
    </message>
    <message>
        <source>Leafy internodes</source>
        <translation>Tylko przy końcach</translation>
    </message>
    <message>
        <source>How many internodes of a shoot bear leaves, counted from its tip.</source>
        <translation>Liście rosną tyle międzywęźli w dół od wierzchołka pędu i nie dalej.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kąt</translation>
    </message>
    <message>
        <source>Between a shoot and the leaf&apos;s stalk.</source>
        <translation>Między pędem a ogonkiem liścia.</translation>
    </message>
    <message>
        <source>Droop</source>
        <translation>Zwisanie</translation>
    </message>
    <message>
        <source>How far leaves hang down.</source>
        <translation>Jak mocno liście zwisają.</translation>
    </message>
    <message>
        <source>Towards the sky</source>
        <translation>Ku niebu</translation>
    </message>
    <message>
        <source>How far leaves turn their faces up.</source>
        <translation>Jak mocno liście zwracają się ku górze.</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Barwa</translation>
    </message>
    <message>
        <source>0° is red, 60° yellow, 120° green.</source>
        <translation>0° to czerwień, 60° żółć, 120° zieleń.</translation>
    </message>
    <message>
        <source>Variation in hue</source>
        <translation>Zmienność barwy</translation>
    </message>
    <message>
        <source>How much the colours of leaves differ.</source>
        <translation>Jak bardzo różnią się kolory liści.</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Nasycenie</translation>
    </message>
    <message>
        <source>How strong the colour is: low values suit blossom and silvery leaves.</source>
        <translation>Jak mocny jest kolor: słaby daje kwiaty i srebrne liście.</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Jasność</translation>
    </message>
    <message>
        <source>How bright the leaves are.</source>
        <translation>Jak jasne są liście.</translation>
    </message>
    <message>
        <source>Yellowing</source>
        <translation>Żółknięcie</translation>
    </message>
    <message>
        <source>How far the leaves of weak shoots turn towards yellow and red.</source>
        <translation>Jak mocno liście słabych pędów przechodzą w żółć i czerwień.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Wykładnik</translation>
    </message>
    <message>
        <source>How widths add up where branches meet: 2 is Leonardo&apos;s rule; less makes thicker trunks.</source>
        <translation>Jak sumują się grubości w miejscu rozgałęzienia: 2 to reguła Leonarda; mniej daje grubsze pnie.</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Końce</translation>
    </message>
    <message>
        <source>Diameter of the thinnest twigs.</source>
        <translation>Średnica najcieńszych gałązek.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Podstawa</translation>
    </message>
    <message>
        <source>Diameter of the trunk at the ground; at 0 it follows from the exponent.</source>
        <translation>Średnica pnia przy ziemi; przy 0 wynika z wykładnika.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Nabieg</translation>
    </message>
    <message>
        <source>How much the trunk spreads where it meets the ground.</source>
        <translation>Jak mocno pień rozszerza się przy ziemi.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>What the bark looks like.</source>
        <translation>Wygląd kory.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Length of trunk after which the bark&apos;s pattern repeats.</source>
        <translation>Długość pnia, po której wzór kory się powtarza.</translation>
    </message>
    <message>
        <source>Gravimorphism</source>
        <translation>Grawimorfizm</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>Rozgałęzianie</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Przestrzeń</translation>
    </message>
    <message>
        <source>Vigour</source>
        <translation>Wigor</translation>
    </message>
    <message>
        <source>Habit</source>
        <translation>Pokrój</translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation>Pęd</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Zacienienie</translation>
    </message>
    <message>
        <source>Room to grow</source>
        <translation>Miejsce wzrostu</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Położenie</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kolor</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Grubość</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Kora</translation>
    </message>
    <message>
        <source>ovate</source>
        <translation>jajowaty</translation>
    </message>
    <message>
        <source>lanceolate</source>
        <translation>lancetowaty</translation>
    </message>
    <message>
        <source>lobed</source>
        <translation>klapowany</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>igły</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>bruzdowana</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>gładka</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>tafelkowa</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>brzozowa</translation>
    </message>
    <message>
        <source>cordate</source>
        <translation>sercowaty</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>dłoniasty</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>pierzasty</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>wierzbowy</translation>
    </message>
    <message>
        <source>fascicle</source>
        <translation>pęczek</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>palmowy</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>wiśniowa</translation>
    </message>
    <message>
        <source>mottled</source>
        <translation>łaciata</translation>
    </message>
    <message>
        <source>fibrous</source>
        <translation>włóknista</translation>
    </message>
    <message>
        <source>ringed</source>
        <translation>pierścieniowa</translation>
    </message>
    <message>
        <source>What stands behind the tree. The studio is dark or light, as the theme is.</source>
        <translation>Co widać za drzewem. Studio jest ciemne lub jasne, tak jak program.</translation>
    </message>
    <message>
        <source>dark_studio</source>
        <translation>ciemne studio</translation>
    </message>
    <message>
        <source>light_studio</source>
        <translation>jasne studio</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Nacisk</translation>
    </message>
    <message>
        <source>A pen&apos;s pressure scales the brush: the radius is what a firm hand reaches.</source>
        <translation>Nacisk pióra zmienia rozmiar pędzla: pełny promień osiąga się mocnym naciskiem.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Znaczniki</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads, and that shoots grow towards.</source>
        <translation>Pokazuje punkty wolnego miejsca, które rozsiewa pędzel i ku którym rosną pędy.</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>Płaszczyzna</translation>
    </message>
    <message>
        <source>Show how deep in the tree the brush draws: a faint grid around it.</source>
        <translation>Pokazuje, na jakiej głębokości drzewa rysuje pędzel: blada siatka wokół niego.</translation>
    </message>
    <message>
        <source>Hazel</source>
        <translation>Leszczyna</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>Dąb</translation>
    </message>
    <message>
        <source>Maple</source>
        <translation>Klon</translation>
    </message>
    <message>
        <source>Elm</source>
        <translation>Wiąz</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>Topola</translation>
    </message>
    <message>
        <source>Spruce</source>
        <translation>Świerk</translation>
    </message>
    <message>
        <source>Pine</source>
        <translation>Sosna</translation>
    </message>
    <message>
        <source>Acacia</source>
        <translation>Akacja</translation>
    </message>
    <message>
        <source>Apple</source>
        <translation>Jabłoń</translation>
    </message>
    <message>
        <source>Joshua tree</source>
        <translation>Jukka krótkolistna</translation>
    </message>
    <message>
        <source>Buds</source>
        <translation>Pąki</translation>
    </message>
    <message>
        <source>How many buds a tap adds, in a spiral around the branch.</source>
        <translation>Ile pąków dodaje stuknięcie, spiralnie wokół gałęzi.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Odstęp</translation>
    </message>
    <message>
        <source>How far one bud is from the next along the branch: 0 is a whorl.</source>
        <translation>Jak daleko wzdłuż gałęzi jest od pąka do pąka: 0 to okółek.</translation>
    </message>
    <message>
        <source>Self-organising competition, or shoot growth by vigour with apical control.</source>
        <translation>Samoorganizująca się konkurencja albo wzrost pędów według wigoru z kontrolą apikalną.</translation>
    </message>
    <message>
        <source>Growth in a year</source>
        <translation>Roczny przyrost</translation>
    </message>
    <message>
        <source>How much the strongest shoot grows in full light, in twelve steps.</source>
        <translation>O ile w pełnym świetle wydłuża się najsilniejszy pęd w dwunastu krokach.</translation>
    </message>
    <message>
        <source>Annual elongation of a shoot.</source>
        <translation>Roczne wydłużenie pędu.</translation>
    </message>
    <message>
        <source>Length of internodes</source>
        <translation>Długość międzywęźli</translation>
    </message>
    <message>
        <source>An internode lengthens over several steps, up to this.</source>
        <translation>Międzywęźle wydłuża się przez kilka kroków, do tej długości.</translation>
    </message>
    <message>
        <source>Length of a mature metamer.</source>
        <translation>Długość dojrzałego metameru.</translation>
    </message>
    <message>
        <source>Angle of laterals</source>
        <translation>Kąt odgałęzień</translation>
    </message>
    <message>
        <source>Between an axis and a branch that begins on it.</source>
        <translation>Między osią a gałęzią, która się na niej zaczyna.</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral shoot.</source>
        <translation>Kąt osadzenia pędu bocznego.</translation>
    </message>
    <message>
        <source>Lateral buds</source>
        <translation>Pąki pachwinowe</translation>
    </message>
    <message>
        <source>At each node: one makes a spiral, two crossed pairs, more a whorl.</source>
        <translation>W każdym węźle: jeden daje spiralę, dwa pary na krzyż, więcej okółek.</translation>
    </message>
    <message>
        <source>Variation in roll</source>
        <translation>Rozrzut obrotu</translation>
    </message>
    <message>
        <source>How irregularly branches stand around their axis.</source>
        <translation>Jak nieregularnie gałęzie stoją wokół swojej osi.</translation>
    </message>
    <message>
        <source>Standard deviation of the divergence angle.</source>
        <translation>Odchylenie standardowe kąta dywergencji.</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>Krętość</translation>
    </message>
    <message>
        <source>How much an axis changes its direction from node to node.</source>
        <translation>Jak mocno oś zmienia kierunek od węzła do węzła.</translation>
    </message>
    <message>
        <source>Standard deviation of the apical angle.</source>
        <translation>Odchylenie standardowe kąta apikalnego.</translation>
    </message>
    <message>
        <source>Branch orders</source>
        <translation>Rzędy gałęzi</translation>
    </message>
    <message>
        <source>How many orders of branches there are at most: branches, their branches, and so on.</source>
        <translation>Gałęzie na gałęziach, a na nich kolejne: tyle rzędów i nie więcej.</translation>
    </message>
    <message>
        <source>Highest order of an axis.</source>
        <translation>Najwyższy rząd osi.</translation>
    </message>
    <message>
        <source>Flushing</source>
        <translation>Rozwijanie pąków</translation>
    </message>
    <message>
        <source>How readily lateral buds become branches.</source>
        <translation>Jak łatwo z pąków pachwinowych rozwijają się gałęzie.</translation>
    </message>
    <message>
        <source>Chance of lateral bud break for each internode of growth.</source>
        <translation>Prawdopodobieństwo pęknięcia pąka pachwinowego na każde międzywęźle przyrostu.</translation>
    </message>
    <message>
        <source>Inhibition</source>
        <translation>Hamowanie</translation>
    </message>
    <message>
        <source>How strongly growing tips hold back the buds below them.</source>
        <translation>Jak mocno rosnące wierzchołki powstrzymują pąki pod sobą.</translation>
    </message>
    <message>
        <source>Apical dominance: auxin from lit apical buds.</source>
        <translation>Dominacja apikalna: auksyna z oświetlonych pąków szczytowych.</translation>
    </message>
    <message>
        <source>Decay of the inhibitor on its way down.</source>
        <translation>Zanik inhibitora w drodze ku dołowi.</translation>
    </message>
    <message>
        <source>Apical control</source>
        <translation>Kontrola apikalna</translation>
    </message>
    <message>
        <source>Above 1 the trunk outgrows its branches, as in a spruce; below 1 they outgrow it.</source>
        <translation>Powyżej 1 pień przerasta swoje gałęzie, jak u świerka; poniżej 1 one przerastają jego.</translation>
    </message>
    <message>
        <source>Excurrent above 1, decurrent below.</source>
        <translation>Powyżej 1 forma z przewodnikiem, poniżej bez niego.</translation>
    </message>
    <message>
        <source>Loss with distance</source>
        <translation>Spadek z odległością</translation>
    </message>
    <message>
        <source>How much less a shoot grows far from the root.</source>
        <translation>O ile słabiej rosną pędy daleko od korzenia.</translation>
    </message>
    <message>
        <source>Decay of the potential with the distance to the root.</source>
        <translation>Zanik potencjału z odległością od korzenia.</translation>
    </message>
    <message>
        <source>Loss with height</source>
        <translation>Spadek z wysokością</translation>
    </message>
    <message>
        <source>How much less a shoot grows the higher it is: more makes the crown flat.</source>
        <translation>O ile słabiej rosną wysoko położone pędy: więcej daje płaskie korony.</translation>
    </message>
    <message>
        <source>Decay of the potential with height.</source>
        <translation>Zanik potencjału z wysokością.</translation>
    </message>
    <message>
        <source>Gravitropism</source>
        <translation>Grawitropizm</translation>
    </message>
    <message>
        <source>Above 0 shoots turn upwards at each node, below 0 downwards.</source>
        <translation>Powyżej 0 pędy w każdym węźle zwracają się w górę, poniżej 0 gałęzie zwracają się w dół.</translation>
    </message>
    <message>
        <source>Orthotropic above 0, positively gravitropic below.</source>
        <translation>Powyżej 0 ortotropowo, poniżej dodatnio grawitropicznie.</translation>
    </message>
    <message>
        <source>Phototropism</source>
        <translation>Fototropizm</translation>
    </message>
    <message>
        <source>How far shoots turn to the light at each node.</source>
        <translation>O ile pędy w każdym węźle zwracają się ku światłu.</translation>
    </message>
    <message>
        <source>Growth towards the brightest direction.</source>
        <translation>Wzrost w najjaśniejszym kierunku.</translation>
    </message>
    <message>
        <source>Level branches</source>
        <translation>Poziome gałęzie</translation>
    </message>
    <message>
        <source>How far a new branch turns towards the horizontal where it begins.</source>
        <translation>Jak bardzo nowa gałąź na początku zwraca się ku poziomowi.</translation>
    </message>
    <message>
        <source>Plagiotropy of lateral shoots.</source>
        <translation>Plagiotropizm pędów bocznych.</translation>
    </message>
    <message>
        <source>Sagging</source>
        <translation>Uginanie</translation>
    </message>
    <message>
        <source>How far branches sag under their weight as they grow.</source>
        <translation>Jak mocno rosnące gałęzie uginają się pod własnym ciężarem.</translation>
    </message>
    <message>
        <source>Gravimorphic bending by branch load.</source>
        <translation>Grawimorficzne wyginanie pod ciężarem gałęzi.</translation>
    </message>
    <message>
        <source>Stiffness with age</source>
        <translation>Sztywność z wiekiem</translation>
    </message>
    <message>
        <source>How much thick wood resists: at high values only the thin ends bend.</source>
        <translation>Jak mocno opiera się grube drewno: przy większej wartości uginają się tylko cienkie końce.</translation>
    </message>
    <message>
        <source>Exponent of thickness in flexural stiffness.</source>
        <translation>Wykładnik grubości w sztywności zginania.</translation>
    </message>
    <message>
        <source>Greatest sag</source>
        <translation>Największe ugięcie</translation>
    </message>
    <message>
        <source>An internode sags by at most this share of the angle between it and straight down.</source>
        <translation>Na każdym międzywęźlu najwyżej taka część kąta do pionu w dół.</translation>
    </message>
    <message>
        <source>Limit of the bend of an internode.</source>
        <translation>Granica wygięcia międzywęźla.</translation>
    </message>
    <message>
        <source>Shade pruning</source>
        <translation>Zrzucanie w cieniu</translation>
    </message>
    <message>
        <source>Branch ends that get less light than this drop off.</source>
        <translation>Końce gałęzi, które mają mniej światła, odpadają.</translation>
    </message>
    <message>
        <source>Cladoptosis of shaded shoots.</source>
        <translation>Kladoptoza zacienionych pędów.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Powierzchnia</translation>
    </message>
    <message>
        <source>Tubes: each branch is a tube that begins inside its parent. Strands: the wood is bundles of strands, which run from every tip to the ground, under one closed bark.</source>
        <translation>Rury: każda gałąź to rura, która zaczyna się wewnątrz gałęzi macierzystej. Pasma: drewno to wiązki pasm, które biegną od każdego wierzchołka do ziemi pod jedną zamkniętą korą.</translation>
    </message>
    <message>
        <source>Strands at a tip</source>
        <translation>Pasma na końcu</translation>
    </message>
    <message>
        <source>How many strands begin at each tip. More make a smoother surface, and branches that separate more clearly.</source>
        <translation>Ile pasm zaczyna się na każdym końcu. Więcej daje gładszą powierzchnię i wyraźniej rozdzielone gałęzie.</translation>
    </message>
    <message>
        <source>Strand radius</source>
        <translation>Promień pasma</translation>
    </message>
    <message>
        <source>How thick each strand is. Above 0, the trunk gets as thick as its strands make it; at 0 it keeps the width that it has.</source>
        <translation>Jak grube jest każde pasmo. Pień jest wtedy tak gruby, jak wynika z jego pasm; przy 0 zachowuje grubość, którą ma.</translation>
    </message>
    <message>
        <source>Cohesion</source>
        <translation>Spójność</translation>
    </message>
    <message>
        <source>Branches separate at a fork where their strands are further apart than this many strand radii: low values part them early, high ones late.</source>
        <translation>Gałęzie rozdzielają się w rozwidleniu tam, gdzie ich pasma dzieli więcej niż tyle promieni pasma: mała wartość rozdziela wcześnie, duża późno.</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Upakowanie</translation>
    </message>
    <message>
        <source>How the strands of a section are pressed together. At rest: until none overlaps. As published: by the paper&apos;s simulation, which stops before that.</source>
        <translation>Jak pasma w przekroju są do siebie dociskane. Do spoczynku: aż żadne nie zachodzi na inne. Z publikacji: symulacją z artykułu, która zatrzymuje się po drodze.</translation>
    </message>
    <message>
        <source>Packing steps</source>
        <translation>Kroki upakowania</translation>
    </message>
    <message>
        <source>For how long strands are pressed together at each node. With few steps, the shape of a fork is kept further down the trunk; with many, the trunk is round at once.</source>
        <translation>Jak długo pasma są dociskane w każdym węźle. Przy niewielu krokach kształt rozwidlenia zostaje niżej na pniu; przy wielu pień od razu robi się okrągły.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Wygładzanie</translation>
    </message>
    <message>
        <source>How far the ridges of single strands are smoothed: 0 shows each of them.</source>
        <translation>Jak mocno wygładzane są grzbiety pojedynczych pasm: 0 pokazuje każdy z nich.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Oś</translation>
    </message>
    <message>
        <source>Bud break</source>
        <translation>Pękanie pąków</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Kontrola</translation>
    </message>
    <message>
        <source>Tropisms</source>
        <translation>Tropizmy</translation>
    </message>
    <message>
        <source>Weight and shade</source>
        <translation>Ciężar i cień</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>Pasma</translation>
    </message>
    <message>
        <source>vigour</source>
        <translation>wigor</translation>
    </message>
    <message>
        <source>tubes</source>
        <translation>rury</translation>
    </message>
    <message>
        <source>strands</source>
        <translation>pasma</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>do spoczynku</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>z publikacji</translation>
    </message>
    <message>
        <source>Branches too</source>
        <translation>Także gałęzie</translation>
    </message>
    <message>
        <source>A drag twists all that the branch carries, not only the branch itself. Hold Shift for the opposite.</source>
        <translation>Przeciągnięcie skręca wszystko, co gałąź niesie, a nie tylko ją samą. Przytrzymany Shift działa odwrotnie.</translation>
    </message>
    <message>
        <source>Fading of the inhibition</source>
        <translation>Zanikanie hamowania</translation>
    </message>
    <message>
        <source>The share that is lost at each internode: higher values let buds break nearer to the tip.</source>
        <translation>Część, która ginie w każdym międzywęźlu: większa pozwala pąkom rozwijać się bliżej wierzchołka.</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Żłobienia</translation>
    </message>
    <message>
        <source>How far the trunk bulges below its limbs and towards its roots, and how deep the hollows of lost limbs are. At 0 the wood is round.</source>
        <translation>Jak bardzo pień wybrzusza się pod konarami i ku korzeniom oraz jak głębokie są zagłębienia po utraconych konarach. Przy 0 drewno jest okrągłe.</translation>
    </message>
    <message>
        <source>Growth model</source>
        <translation>Model wzrostu</translation>
    </message>
    <message>
        <source>TreeSketch: buds compete for space and light. Vigour: light decides how fast each shoot grows, month by month.</source>
        <translation>TreeSketch: pąki walczą o miejsce i światło. Wigor: światło decyduje, jak szybko rośnie każdy pęd, miesiąc po miesiącu.</translation>
    </message>
    <message>
        <source>TreeSketch</source>
        <translation>TreeSketch</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Zabieraj</translation>
    </message>
    <message>
        <source>A stroke takes away: a branch that it crosses once is cut there, one that it crosses twice is erased. Shift or a pen&apos;s eraser does so, too.</source>
        <translation>Kreska zabiera: gałąź, którą przetnie raz, zostaje tam odcięta, a ta, którą przetnie dwa razy, znika. Tak samo działa Shift albo gumka pióra.</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Odbicie</translation>
    </message>
    <message>
        <source>Each branch is drawn on the other side of the trunk as well.</source>
        <translation>Każda gałąź jest rysowana także po drugiej stronie pnia.</translation>
    </message>
    <message>
        <source>Fill the sides</source>
        <translation>Wypełnij boki</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Korona</translation>
    </message>
    <message>
        <source>How much wider than the drawing the crown may be in depth.</source>
        <translation>O ile szersza niż rysunek może być korona w głąb.</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Długości</translation>
    </message>
    <message>
        <source>How much longer branches may become in depth than those you drew.</source>
        <translation>O ile dłuższe niż narysowane mogą stać się gałęzie w głąb.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Kąty</translation>
    </message>
    <message>
        <source>How much wider an angle between branches may be than the widest you drew.</source>
        <translation>O ile szerszy niż najszerszy narysowany może być kąt między gałęziami.</translation>
    </message>
    <message>
        <source>Pass on</source>
        <translation>Przekazuj</translation>
    </message>
    <message>
        <source>A tap on a branch gives other branches what it carries. Otherwise it adds one branch like those that the branch carries.</source>
        <translation>Dotknięcie gałęzi daje innym to, co ona niesie. Inaczej dodaje jej jedną gałąź podobną do tych, które niesie.</translation>
    </message>
    <message>
        <source>Only to similar ones</source>
        <translation>Podobnym</translation>
    </message>
    <message>
        <source>Only branches that are equally many forks away from the trunk get it.</source>
        <translation>Dostają to tylko gałęzie z tyloma samymi rozgałęzieniami pod sobą.</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Skalowane</translation>
    </message>
    <message>
        <source>What a branch gets is scaled to the size of that branch. Otherwise it keeps its size, and its distance from the tip.</source>
        <translation>To, co dostaje gałąź, jest większe lub mniejsze tak jak ona. Inaczej zachowuje wielkość i odległość od wierzchołka.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>W zamian</translation>
    </message>
    <message>
        <source>What the branches carried until now is removed.</source>
        <translation>To, co gałęzie niosły dotąd, znika.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Odmienność</translation>
    </message>
    <message>
        <source>How much the angles and lengths of a variation deviate from those of the tree.</source>
        <translation>Jak bardzo kąty i długości odmiany odbiegają od drzewa.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numer</translation>
    </message>
    <message>
        <source>Which variation it is: the same number always gives the same variation of a tree.</source>
        <translation>Która to odmiana: ten sam numer robi z tego samego drzewa to samo.</translation>
    </message>
    <message>
        <source>Two sides</source>
        <translation>Dwie strony</translation>
    </message>
    <message>
        <source>Two strokes in a row, drawn side by side, are the two sides of one branch, which gets its width from them.</source>
        <translation>Dwie kreski obok siebie, jedna po drugiej, to dwie strony jednej gałęzi, która ma z nich swoją grubość.</translation>
    </message>
    <message>
        <source>The drawing is placed twice, the second time turned by 90° around the trunk, so that the tree is as full from the side as from the front. Without this, its branches themselves run towards you and away from you.</source>
        <translation>Rysunek jest umieszczany dwa razy, drugi raz obrócony o 90° wokół pnia, więc drzewo jest z boku tak samo pełne jak z przodu. Bez tego same gałęzie biegną ku tobie i od ciebie.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Where strokes go in depth. Screen: as deep as the branch that they begin at. Trunk: in the plane through the trunk and the branch that they begin at. Spread: each limb that begins at the trunk is turned into the widest gap, as long and as steep as you draw it.</source>
        <translation>Dokąd w głąb idą pociągnięcia. Ekran: tak głęboko jak gałąź, od której się zaczynają. Pień: w płaszczyźnie pnia i gałęzi, od której się zaczynają. Rozłożone: każdy konar zaczynający się na pniu obraca się w najszerszą lukę, zachowując narysowaną długość i nachylenie.</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Dookoła</translation>
    </message>
    <message>
        <source>How many strokes are made around the trunk for each one that you draw.</source>
        <translation>Ile pociągnięć powstaje wokół pnia na każde narysowane.</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>Ekran</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>Pień</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Rozłożone</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Promień</translation>
    </message>
    <message>
        <source>Radius of the brush, shared with the Brush tool.</source>
        <translation>Promień pędzla, ten sam co pędzla, który maluje.</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>The thickest wood that is removed, as a share of the trunk&apos;s width. Thicker branches stay, however often you brush over them.</source>
        <translation>Najgrubsze drewno, które zniknie, jako część grubości pnia. Grubsze gałęzie zostają, ile razy by po nich przesuwać.</translation>
    </message>
    <message>
        <source>Share of twigs</source>
        <translation>Ile</translation>
    </message>
    <message>
        <source>The share of the twigs under the brush that a stroke takes. They are chosen evenly along each limb.</source>
        <translation>Część gałązek pod pędzlem, którą usuwa jedno pociągnięcie. Są wybierane równomiernie wzdłuż każdego konaru.</translation>
    </message>
    <message>
        <source>Far side too</source>
        <translation>Także z tyłu</translation>
    </message>
    <message>
        <source>A stroke reaches through the whole tree. Otherwise it takes only what is on your side of the trunk.</source>
        <translation>Pociągnięcie sięga przez całe drzewo. Inaczej usuwa tylko to, co jest po tej stronie pnia.</translation>
    </message>
    <message>
        <source>Straightening</source>
        <translation>Prostowanie</translation>
    </message>
    <message>
        <source>How fast young wood smooths its bends as it grows on: 0 keeps every elbow.</source>
        <translation>Jak szybko młode drewno wygładza swoje zgięcia, rosnąc dalej: 0 zachowuje każde kolanko.</translation>
    </message>
    <message>
        <source>Reaction wood: an axis that takes over straightens.</source>
        <translation>Drewno reakcyjne: oś, która przejmuje prowadzenie, prostuje się.</translation>
    </message>
</context>
<context>
    <name>ParametersJson</name>
    <message>
        <source>true or false is expected</source>
        <translation>oczekiwano wartości true lub false</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>oczekiwano jednej z wartości: %1</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>oczekiwano liczby całkowitej</translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation>oczekiwano liczby</translation>
    </message>
    <message>
        <source>%1 is not within %2…%3</source>
        <translation>%1 nie mieści się w zakresie %2…%3</translation>
    </message>
    <message>
        <source>axisWeight, tropismWeight and spaceWeight must not all be 0</source>
        <translation>axisWeight, tropismWeight i spaceWeight nie mogą wszystkie być równe 0</translation>
    </message>
    <message>
        <source>it must not exceed 0.99 times ellipseVertical, which is %1</source>
        <translation>wartość nie może wykraczać poza 0,99 wartości ellipseVertical, czyli %1</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>oczekiwano obiektu</translation>
    </message>
    <message>
        <source>there is no such parameter</source>
        <translation>nie ma takiego parametru</translation>
    </message>
    <message>
        <source>the name of an image is expected</source>
        <translation>oczekiwano nazwy obrazu</translation>
    </message>
    <message>
        <source>there are no images here</source>
        <translation>tutaj nie ma obrazów</translation>
    </message>
</context>
<context>
    <name>PositionCheck</name>
    <message>
        <source>it and the later steps move a tree whose axes are longer than %1 m too often</source>
        <translation>ten i późniejsze kroki zbyt często poruszają drzewo o osiach dłuższych niż %1 m</translation>
    </message>
    <message>
        <source>before it, internode %1 lies more than %2 m away</source>
        <translation>przed nim międzywęźle %1 leży dalej niż %2 m</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>krok %1 historii</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>leży dalej niż %1 m od początku układu</translation>
    </message>
    <message>
        <source>internode %1</source>
        <translation>międzywęźle %1</translation>
    </message>
</context>
<context>
    <name>ProfileJson</name>
    <message>
        <source>a profile is expected</source>
        <translation>oczekiwano profilu</translation>
    </message>
    <message>
        <source>at most %1 are possible</source>
        <translation>możliwe jest najwyżej %1</translation>
    </message>
    <message>
        <source>lists of points [x, y] are expected</source>
        <translation>oczekiwano list punktów [x, y]</translation>
    </message>
</context>
<context>
    <name>ProfileTool</name>
    <message>
        <source>Tap a branch to see its cross-section, and draw another shape for it</source>
        <translation>Stuknąć gałąź, aby zobaczyć jej przekrój i narysować dla niego inny kształt</translation>
    </message>
</context>
<context>
    <name>Program</name>
    <message>
        <source>%1; see espalier --help</source>
        <translation>%1; patrz espalier --help</translation>
    </message>
    <message>
        <source>What you did is in a safety copy in %1; the next start offers it. The fault is described in %2.</source>
        <translation>To, co zrobiono, jest w kopii zapasowej w %1; przy następnym uruchomieniu można ją przywrócić. Błąd opisano w %2.</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>pairs of an internode and a diameter are expected</source>
        <translation>oczekiwano par: międzywęźle i średnica</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>oczekiwano obiektu</translation>
    </message>
    <message>
        <source>it does not describe an Espalier project</source>
        <translation>to nie jest opis projektu programu Espalier</translation>
    </message>
    <message>
        <source>Espalier %1 wrote it in version %2 of the format; this is Espalier %3, which reads versions up to %4</source>
        <translation>zapisano w programie Espalier %1, w wersji %2 formatu; to jest Espalier %3, który odczytuje wersje do %4</translation>
    </message>
    <message>
        <source>1 to %1 sets are expected</source>
        <translation>oczekiwano od 1 do %1 zestawów</translation>
    </message>
    <message>
        <source>the lassos</source>
        <translation>obrysy lassa</translation>
    </message>
    <message>
        <source>their parts do not add up</source>
        <translation>ich części nie zgadzają się ze sobą</translation>
    </message>
    <message>
        <source>the history</source>
        <translation>historia</translation>
    </message>
    <message>
        <source>its parts do not add up</source>
        <translation>jej części nie zgadzają się ze sobą</translation>
    </message>
    <message>
        <source>the tree or its history is too large for a project file</source>
        <translation>drzewo lub jego historia jest za duże na plik projektu</translation>
    </message>
    <message>
        <source>at most %1 images are expected</source>
        <translation>oczekiwano najwyżej %1 obrazów</translation>
    </message>
    <message>
        <source>the image “%1” is missing from it or broken; the built-in look is shown instead</source>
        <translation>brakuje w nim obrazu „%1” albo jest on uszkodzony; zamiast niego widać wygląd, który rysuje Espalier</translation>
    </message>
    <message>
        <source>they have too many points</source>
        <translation>mają zbyt wiele punktów</translation>
    </message>
    <message>
        <source>indices of strokes are expected</source>
        <translation>oczekiwano indeksów obrysów</translation>
    </message>
    <message>
        <source>the record of what was done</source>
        <translation>zapis wykonanych czynności</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>krok %1 historii</translation>
    </message>
    <message>
        <source>the record of what was done is not a JSON object</source>
        <translation>zapis wykonanych czynności nie jest obiektem JSON</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>profile</translation>
    </message>
    <message>
        <source>there are too many</source>
        <translation>jest ich za dużo</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>oczekiwano true lub false</translation>
    </message>
    <message>
        <source>a colour such as #5c6268 is expected</source>
        <translation>oczekiwano koloru takiego jak #5c6268</translation>
    </message>
    <message>
        <source>there is no backdrop of this name</source>
        <translation>nie ma tła o tej nazwie</translation>
    </message>
    <message>
        <source>its background and light cannot be read (%1); those of a new tree are shown instead</source>
        <translation>nie można odczytać jego tła i światła (%1); zamiast nich widać te nowego drzewa</translation>
    </message>
    <message>
        <source>the reference picture “%1” is missing from it or broken</source>
        <translation>brakuje w nim obrazu referencyjnego „%1” lub jest on uszkodzony</translation>
    </message>
    <message>
        <source>a change of the history</source>
        <translation>zmiana historii</translation>
    </message>
    <message>
        <source>it does not follow on from what is before it</source>
        <translation>nie wynika z tego, co jest przed nią</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>nie ma takiego pliku</translation>
    </message>
    <message>
        <source>some of what other programs have put into it cannot be kept</source>
        <translation>części tego, co włożyły do niego inne programy, nie można zachować</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>a stroke needs at least one point</source>
        <translation>kreska ma co najmniej jeden punkt</translation>
    </message>
    <message>
        <source>1 to %1 strokes are expected</source>
        <translation>oczekiwana jest liczba kresek od 1 do %1</translation>
    </message>
    <message>
        <source>internode %1 is a root, which cannot be pruned</source>
        <translation>międzywęźle %1 to korzeń, którego nie można odciąć</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>nie ma miejsca na więcej zestawów parametrów</translation>
    </message>
    <message>
        <source>there is no such bud</source>
        <translation>nie ma takiego pąka</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>oczekiwano obiektu</translation>
    </message>
    <message>
        <source>a number other than 0 is expected</source>
        <translation>oczekiwano liczby innej niż 0</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>brak tego elementu</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample</source>
        <translation>pociągnięcie ma co najmniej jedną próbkę</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 samples</source>
        <translation>przepis ma najwyżej %1 próbek</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected</source>
        <translation>oczekiwano trzech liczb w zakresie ±%1</translation>
    </message>
    <message>
        <source>right and up must have length 1 and be at right angles</source>
        <translation>right i up muszą mieć długość 1 i być prostopadłe</translation>
    </message>
    <message>
        <source>a lasso needs at least three points</source>
        <translation>lasso ma co najmniej trzy punkty</translation>
    </message>
    <message>
        <source>two numbers within ±%1 are expected, right and up, in m</source>
        <translation>oczekiwano dwóch liczb w zakresie ±%1, w prawo i w górę, w m</translation>
    </message>
    <message>
        <source>1 to %1 internodes are expected</source>
        <translation>oczekiwano od 1 do %1 międzywęźli</translation>
    </message>
    <message>
        <source>an array of five numbers is expected: time, x, y, z, radius</source>
        <translation>oczekiwano tablicy pięciu liczb: czas, x, y, z, promień</translation>
    </message>
    <message>
        <source>the time is not within 0…%1 s</source>
        <translation>czas nie mieści się w zakresie 0…%1 s</translation>
    </message>
    <message>
        <source>the time does not go forwards</source>
        <translation>czas nie biegnie do przodu</translation>
    </message>
    <message>
        <source>a coordinate is not within ±%1 m</source>
        <translation>współrzędna nie mieści się w zakresie ±%1 m</translation>
    </message>
    <message>
        <source>the radius is not within 0…%1 m</source>
        <translation>promień nie mieści się w zakresie 0…%1 m</translation>
    </message>
    <message>
        <source>a bend needs 1 to %1 handles</source>
        <translation>wygięcie ma od 1 do %1 uchwytów</translation>
    </message>
    <message>
        <source>an array of three numbers within ±%1 is expected</source>
        <translation>oczekiwano tablicy trzech liczb w zakresie ±%1</translation>
    </message>
    <message>
        <source>there is no view “%1”; there are front, side, top and three-quarter</source>
        <translation>nie ma widoku „%1”; są front, side, top i three-quarter</translation>
    </message>
    <message>
        <source>this is not a recipe: a recipe begins with “%1”: %2</source>
        <translation>to nie jest przepis: przepis zaczyna się od „%1”: %2</translation>
    </message>
    <message>
        <source>the recipe is of version %1; this program reads versions up to %2</source>
        <translation>przepis jest w wersji %1, ten program odczytuje wersje do %2</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 operations</source>
        <translation>przepis ma najwyżej %1 operacji</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 images</source>
        <translation>przepis ma najwyżej %1 obrazów</translation>
    </message>
    <message>
        <source>a path relative to the recipe is expected</source>
        <translation>oczekiwano ścieżki względem przepisu</translation>
    </message>
    <message>
        <source>internode %1 is not on the branch above internode %2</source>
        <translation>międzywęźle %1 nie leży na gałęzi powyżej międzywęźla %2</translation>
    </message>
    <message>
        <source>nothing grew</source>
        <translation>nic nie wyrosło</translation>
    </message>
    <message>
        <source>internode %1 has no bud %2</source>
        <translation>międzywęźle %1 nie ma pąka %2</translation>
    </message>
    <message>
        <source>%1 hexadecimal digits are expected</source>
        <translation>oczekiwano %1 cyfr szesnastkowych</translation>
    </message>
    <message>
        <source>a key (“key”) or a place (“at”) is expected</source>
        <translation>oczekiwano klucza („key”) lub miejsca („at”)</translation>
    </message>
    <message>
        <source>there is no internode %1</source>
        <translation>nie ma międzywęźla %1</translation>
    </message>
    <message>
        <source>there is no internode with the key %1</source>
        <translation>nie ma międzywęźla o kluczu %1</translation>
    </message>
    <message>
        <source>there is no internode near (%1, %2, %3) m</source>
        <translation>nie ma międzywęźla w pobliżu (%1, %2, %3) m</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1 is expected</source>
        <translation>oczekiwano liczby całkowitej od 0 do %1</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; i jeszcze %2</translation>
    </message>
    <message>
        <source>there is no operation “%1”; there are %2</source>
        <translation>nie ma operacji „%1”; są %2</translation>
    </message>
    <message>
        <source>there are only %1 commands to redo, not %2</source>
        <translation>poleceń do ponowienia jest tylko %1, a nie %2</translation>
    </message>
    <message>
        <source>there is no envelope</source>
        <translation>nie ma obwiedni</translation>
    </message>
    <message>
        <source>internode %1 has no width to take away</source>
        <translation>międzywęźle %1 nie ma grubości do usunięcia</translation>
    </message>
    <message>
        <source>the history goes back only by %1, not by %2</source>
        <translation>historia sięga wstecz tylko o %1, a nie o %2</translation>
    </message>
    <message>
        <source>the history goes on only by %1, not by %2</source>
        <translation>historia sięga naprzód tylko o %1, a nie o %2</translation>
    </message>
    <message>
        <source>there are only %1 commands to undo, not %2</source>
        <translation>poleceń do cofnięcia jest tylko %1, a nie %2</translation>
    </message>
    <message>
        <source>a target for each handle is expected</source>
        <translation>oczekiwano celu dla każdego uchwytu</translation>
    </message>
    <message>
        <source>arrays of three numbers within ±%1 are expected</source>
        <translation>oczekiwano tablic trzech liczb w zakresie ±%1</translation>
    </message>
    <message>
        <source>there are more than %1</source>
        <translation>jest ich więcej niż %1</translation>
    </message>
    <message>
        <source>“%1” must be given with them</source>
        <translation>wymagają obok siebie „%1”</translation>
    </message>
    <message>
        <source>1 to %1 envelopes are expected</source>
        <translation>oczekiwano od 1 do %1 obwiedni</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: of its %1 steps, %2 (%3) were made by a version of Espalier that did not record how</source>
        <translation>historii drzewa nie da się zamienić w przepis: z jej %1 kroków %2 (%3) pochodzi z wersji Espaliera, która nie zapisywała, jak powstały</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: it does not begin with a seedling, because the tree was imported or its oldest steps were dropped</source>
        <translation>historii drzewa nie da się zamienić w przepis: nie zaczyna się od siewki, ponieważ drzewo zaimportowano albo usunięto jego najstarsze kroki</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>krok %1 historii</translation>
    </message>
    <message>
        <source>another file with this name is where the recipe&apos;s image should go</source>
        <translation>w miejscu obrazu przepisu leży inny plik o tej nazwie</translation>
    </message>
    <message>
        <source>the recipe&apos;s numbers cannot be written exactly</source>
        <translation>liczb przepisu nie da się zapisać dokładnie</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>oczekiwano %1 liczb</translation>
    </message>
    <message>
        <source>its parent is neither one of the segments before it nor -1</source>
        <translation>jego rodzic nie jest żadnym z segmentów przed nim ani -1</translation>
    </message>
    <message>
        <source>1 to %1 segments are expected</source>
        <translation>oczekiwano od 1 do %1 segmentów</translation>
    </message>
    <message>
        <source>a recipe that was not read from a file cannot name files</source>
        <translation>przepis, który nie jest plikiem, nie może wskazywać plików</translation>
    </message>
    <message>
        <source>internode %1 has no room for buds above the ground</source>
        <translation>międzywęźle %1 nie ma nad ziemią miejsca na pąki</translation>
    </message>
    <message>
        <source>nothing was taken away</source>
        <translation>niczego nie usunięto</translation>
    </message>
    <message>
        <source>there is no branch from internode %1 to internode %2</source>
        <translation>nie ma gałęzi od międzywęźla %1 do międzywęźla %2</translation>
    </message>
    <message>
        <source>internode %1 has no profile to take away</source>
        <translation>międzywęźle %1 nie ma profilu do usunięcia</translation>
    </message>
    <message>
        <source>internode %1 has no twist to take away</source>
        <translation>międzywęźle %1 nie ma skręcenia do usunięcia</translation>
    </message>
    <message>
        <source>a branch must begin at exactly one internode</source>
        <translation>gałąź zaczyna się na jednym międzywęźlu</translation>
    </message>
    <message>
        <source>true is expected</source>
        <translation>oczekiwano wartości true</translation>
    </message>
    <message>
        <source>the other end of the branch (“to”) is missing</source>
        <translation>brakuje drugiego końca gałęzi („to”)</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>oczekiwano jednej z wartości: %1</translation>
    </message>
    <message>
        <source>a stroke needs at least %1 points</source>
        <translation>kreska ma co najmniej %1 punkty</translation>
    </message>
    <message>
        <source>at most %1 radii are expected</source>
        <translation>oczekiwanych jest najwyżej %1 promieni</translation>
    </message>
    <message>
        <source>numbers from 0 to %1 are expected, in m</source>
        <translation>oczekiwane są liczby od 0 do %1, w m</translation>
    </message>
    <message>
        <source>internode %1 cannot bear such a leaf</source>
        <translation>międzywęźle %1 nie może mieć takiego liścia</translation>
    </message>
    <message>
        <source>no leaves at internode %1 can be arranged by “%2”</source>
        <translation>przy międzywęźlu %1 nie da się rozmieścić liści według „%2”</translation>
    </message>
    <message>
        <source>a quaternion is expected: four numbers x, y, z, w within ±1, not all of them 0</source>
        <translation>oczekiwany jest kwaternion: cztery liczby x, y, z, w w zakresie ±1, nie wszystkie 0</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>oczekiwane jest true albo false</translation>
    </message>
    <message>
        <source>nothing under the brush could be erased</source>
        <translation>pod pędzlem nie było nic do usunięcia</translation>
    </message>
    <message>
        <source>there were no twigs under the brush to take</source>
        <translation>pod pędzlem nie było gałązek do usunięcia</translation>
    </message>
    <message>
        <source>the branch of internode %1 is already kept clear that far</source>
        <translation>gałąź międzywęźla %1 jest już tak oczyszczona</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected: x, y, z, in m</source>
        <translation>oczekiwano trzech liczb w zakresie ±%1: x, y, z, w m</translation>
    </message>
    <message>
        <source>four numbers are expected: x, y, z within ±%1 m, and a radius within 0…%2 m</source>
        <translation>oczekiwano czterech liczb: x, y, z w zakresie ±%1 m i promienia w zakresie 0…%2 m</translation>
    </message>
    <message>
        <source>one stroke or more is expected</source>
        <translation>oczekiwano co najmniej jednego pociągnięcia</translation>
    </message>
    <message>
        <source>growth stopped at %1 internodes, since the memory of this machine may not hold more</source>
        <translation>wzrost zatrzymał się na %1 międzywęźlach, bo pamięć tego komputera może nie pomieścić więcej</translation>
    </message>
    <message>
        <source>there is no room for more profiles</source>
        <translation>nie ma miejsca na więcej profili</translation>
    </message>
</context>
<context>
    <name>RecipeTool</name>
    <message>
        <source>A recipe is playing; Escape hands the brush to you.</source>
        <translation>Przepis jest odtwarzany; Esc oddaje pędzel.</translation>
    </message>
</context>
<context>
    <name>ReduceTool</name>
    <message>
        <source>Press a branch and hold: it shrinks until you let go</source>
        <translation>Nacisnąć gałąź i przytrzymać: kurczy się aż do puszczenia</translation>
    </message>
</context>
<context>
    <name>ReproduceTool</name>
    <message>
        <source>turn the view back to where you drew the first stroke, or press Esc to discard it</source>
        <translation>obróć widok tam, skąd powstała pierwsza kreska, albo zapomnij ją klawiszem Esc</translation>
    </message>
    <message>
        <source>look at the tree from the side, not from above or below, to draw its shape</source>
        <translation>aby narysować postać drzewa, patrz na nie z boku, nie z góry ani z dołu</translation>
    </message>
    <message>
        <source>there is no tree yet to give another shape: make one first</source>
        <translation>nie ma jeszcze drzewa, które mogłoby przyjąć inną postać: najpierw je zrób</translation>
    </message>
    <message>
        <source>that is a point: draw the trunk as a line</source>
        <translation>to punkt: narysuj pień jako linię</translation>
    </message>
    <message>
        <source>that is a point: draw the silhouette as a line around the crown</source>
        <translation>to punkt: narysuj sylwetkę jako linię wokół korony</translation>
    </message>
    <message>
        <source>the stroke reaches too far away from the tree</source>
        <translation>kreska sięga zbyt daleko od drzewa</translation>
    </message>
    <message>
        <source>the trunk must be an open line</source>
        <translation>pień musi być linią otwartą</translation>
    </message>
    <message>
        <source>the tip of the trunk must be inside the silhouette</source>
        <translation>wierzchołek pnia musi leżeć wewnątrz sylwetki</translation>
    </message>
    <message>
        <source>the silhouette must enclose the tip of the trunk</source>
        <translation>sylwetka musi otaczać wierzchołek pnia</translation>
    </message>
    <message>
        <source>the trunk must be above the ground: draw it from its foot to its tip</source>
        <translation>pień musi być nad ziemią: narysuj go od podstawy do wierzchołka</translation>
    </message>
    <message>
        <source>Make a tree first, with Brush or Sketch; then draw its new shape</source>
        <translation>Najpierw zrób drzewo pędzlem lub szkicem; potem narysuj jego nową postać</translation>
    </message>
    <message>
        <source>Draw the new trunk, then the silhouette of its crown</source>
        <translation>Narysuj nowy pień, potem sylwetkę jego korony</translation>
    </message>
</context>
<context>
    <name>SafetyCopy</name>
    <message>
        <source>another program has changed it</source>
        <translation>inny program go zmienił</translation>
    </message>
    <message>
        <source>a change of the tree is too large</source>
        <translation>zmiana drzewa jest zbyt duża</translation>
    </message>
    <message>
        <source>it is not up to date</source>
        <translation>nie jest aktualna</translation>
    </message>
    <message>
        <source>what was done last cannot be brought back</source>
        <translation>tego, co zrobiono na końcu, nie można przywrócić</translation>
    </message>
</context>
<context>
    <name>SelectBudTool</name>
    <message>
        <source>Tap a bud, and it alone grows from now on; tap beside the tree to let all grow again</source>
        <translation>Stuknąć pąk, a odtąd będzie rósł tylko on; stuknąć obok drzewa, aby znów rosły wszystkie</translation>
    </message>
    <message>
        <source>There is no bud here. Buds near the pointer are shown as dots.</source>
        <translation>Tu nie ma pąka. Pąki blisko wskaźnika widać jako punkty.</translation>
    </message>
    <message>
        <source>No bud is close enough. Tap one of the dots, or zoom in with the wheel.</source>
        <translation>Żaden pąk nie jest tak blisko. Dotknij jednego z punktów albo zbliż się kółkiem.</translation>
    </message>
</context>
<context>
    <name>Skeleton</name>
    <message>
        <source>line %1</source>
        <translation>wiersz %1</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>jest za długi</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>oczekiwano %1 liczb</translation>
    </message>
    <message>
        <source>“%1” is not a number for %2</source>
        <translation>„%1” nie jest liczbą dla %2</translation>
    </message>
    <message>
        <source>its id %1 is already used in line %2</source>
        <translation>jego id %1 ma też wiersz %2</translation>
    </message>
    <message>
        <source>its parent, id %1, does not exist</source>
        <translation>nie ma id %1, jego rodzica</translation>
    </message>
    <message>
        <source>it is its own ancestor</source>
        <translation>niesie go to, co sam niesie</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>leży dalej niż %1 m</translation>
    </message>
    <message>
        <source>its radius is not between 0 and %1 m</source>
        <translation>promień nie mieści się między 0 a %1 m</translation>
    </message>
    <message>
        <source>“%1” is expected</source>
        <translation>oczekiwano „%1”</translation>
    </message>
    <message>
        <source>a tree of more than %1 segments cannot be imported</source>
        <translation>drzewa z więcej niż %1 segmentów nie można wczytać</translation>
    </message>
    <message>
        <source>there are no segments</source>
        <translation>nie ma segmentów</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>segment %1</translation>
    </message>
    <message>
        <source>it stands more than %1 m from the thickest trunk</source>
        <translation>stoi dalej niż %1 m od najgrubszego pnia</translation>
    </message>
    <message>
        <source>it is longer than %1 m, or more than %2 m away</source>
        <translation>jest dłuższy niż %1 m albo leży dalej niż %2 m</translation>
    </message>
    <message>
        <source>no segment has a length</source>
        <translation>żaden segment nie ma długości</translation>
    </message>
</context>
<context>
    <name>Sketch</name>
    <message>
        <source>a trunk can only be drawn where nothing has grown</source>
        <translation>pień można narysować tylko tam, gdzie nic nie urosło</translation>
    </message>
    <message>
        <source>the stroke has no length</source>
        <translation>kreska nie ma długości</translation>
    </message>
    <message>
        <source>the stroke is longer than %1 m, or more than %2 m away</source>
        <translation>kreska jest dłuższa niż %1 m albo oddalona o więcej niż %2 m</translation>
    </message>
    <message>
        <source>only a tree with one root can be given depth</source>
        <translation>głębię można nadać tylko drzewu o jednym korzeniu</translation>
    </message>
    <message>
        <source>the tree has depth already</source>
        <translation>drzewo ma już głębię</translation>
    </message>
    <message>
        <source>draw branches first: a trunk alone has no depth to find</source>
        <translation>najpierw narysuj gałęzie: sam pień nie ma głębi do znalezienia</translation>
    </message>
    <message>
        <source>the wood that it would grow from is gone</source>
        <translation>drewna, z którego miałaby rosnąć, już nie ma</translation>
    </message>
    <message>
        <source>the copies would have more than %1 internodes</source>
        <translation>kopie miałyby więcej niż %1 międzywęźli</translation>
    </message>
    <message>
        <source>a copy would reach more than %1 m away</source>
        <translation>kopia sięgałaby dalej niż %1 m</translation>
    </message>
    <message>
        <source>internode %1 is not alive</source>
        <translation>międzywęźle %1 nie żyje</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries no branch to imitate</source>
        <translation>gałąź międzywęźla %1 nie ma gałęzi do naśladowania</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries nothing to copy</source>
        <translation>gałąź międzywęźla %1 nie ma nic do skopiowania</translation>
    </message>
    <message>
        <source>more than %1 branches are listed</source>
        <translation>wymieniono więcej niż %1 gałęzi</translation>
    </message>
    <message>
        <source>there is no other branch to copy to</source>
        <translation>nie ma innej gałęzi, na którą można by kopiować</translation>
    </message>
    <message>
        <source>all other branches are too short for what the branch of internode %1 carries</source>
        <translation>wszystkie inne gałęzie są za krótkie na to, co ma gałąź międzywęźla %1</translation>
    </message>
    <message>
        <source>an internode would be longer than %1 m or lie more than %2 m away</source>
        <translation>międzywęźle byłoby dłuższe niż %1 m albo leżałoby dalej niż %2 m</translation>
    </message>
    <message>
        <source>the new trunk has no length</source>
        <translation>nowy pień nie ma długości</translation>
    </message>
    <message>
        <source>the silhouette encloses nothing</source>
        <translation>sylwetka niczego nie obejmuje</translation>
    </message>
    <message>
        <source>a trunk cannot be moved</source>
        <translation>pnia nie można przesunąć</translation>
    </message>
    <message>
        <source>a branch cannot stand on itself</source>
        <translation>gałąź nie może stać na sobie samej</translation>
    </message>
    <message>
        <source>a branch can be made %1 to %2 times as large</source>
        <translation>gałąź może być od %1 do %2 razy większa</translation>
    </message>
</context>
<context>
    <name>SketchTool</name>
    <message>
        <source>Draw the trunk, then branches; two strokes side by side give a branch its width</source>
        <translation>Narysuj pień, potem gałęzie; dwie kreski obok siebie nadają gałęzi grubość</translation>
    </message>
    <message>
        <source>Draw a branch from the wood; hold Shift and draw across branches to take them away</source>
        <translation>Narysuj gałąź od drewna; z Shiftem kreska w poprzek zabiera gałęzie</translation>
    </message>
    <message>
        <source>Two sides of one branch</source>
        <translation>Dwie strony jednej gałęzi</translation>
    </message>
    <message>
        <source>A leaf</source>
        <translation>Liść</translation>
    </message>
    <message>
        <source>A crown</source>
        <translation>Korona</translation>
    </message>
</context>
<context>
    <name>StrandProfile</name>
    <message>
        <source>an outline needs at least three points</source>
        <translation>kontur wymaga co najmniej trzech punktów</translation>
    </message>
    <message>
        <source>an outline reaches too far</source>
        <translation>kontur sięga za daleko</translation>
    </message>
    <message>
        <source>it has no outline</source>
        <translation>nie ma konturu</translation>
    </message>
    <message>
        <source>it has more than %1 outlines or %2 points</source>
        <translation>ma więcej niż %1 konturów lub %2 punktów</translation>
    </message>
    <message>
        <source>it has more than %1 attractors</source>
        <translation>ma więcej niż %1 atraktorów</translation>
    </message>
    <message>
        <source>an attractor lies too far away</source>
        <translation>atraktor leży za daleko</translation>
    </message>
    <message>
        <source>its outline crosses itself</source>
        <translation>jego kontur przecina sam siebie</translation>
    </message>
    <message>
        <source>its outlines cross each other</source>
        <translation>jego kontury przecinają się nawzajem</translation>
    </message>
    <message>
        <source>its outline has no area</source>
        <translation>jego kontur nie obejmuje żadnego pola</translation>
    </message>
</context>
<context>
    <name>SunTool</name>
    <message>
        <source>%1° high</source>
        <translation>wysokość %1°</translation>
    </message>
    <message>
        <source>Drag the sun around the tree</source>
        <translation>Przeciągnąć słońce wokół drzewa.</translation>
    </message>
</context>
<context>
    <name>Tree</name>
    <message>
        <source>its internode is missing</source>
        <translation>brak jego międzywęźla</translation>
    </message>
    <message>
        <source>it is out of order</source>
        <translation>jest w złej kolejności</translation>
    </message>
    <message>
        <source>its place of attachment is out of range</source>
        <translation>jego miejsce osadzenia jest poza zakresem</translation>
    </message>
    <message>
        <source>its rotation is not valid</source>
        <translation>jego obrót nie jest obrotem</translation>
    </message>
    <message>
        <source>its length is out of range</source>
        <translation>jego długość jest poza zakresem</translation>
    </message>
    <message>
        <source>its vigour is out of range</source>
        <translation>jego wigor jest poza zakresem</translation>
    </message>
    <message>
        <source>it grows from a bud that does not exist</source>
        <translation>wyrasta z pąka, który nie istnieje</translation>
    </message>
    <message>
        <source>it has a bud that does not exist</source>
        <translation>ma pąk, który nie istnieje</translation>
    </message>
    <message>
        <source>its kind is not known</source>
        <translation>jego rodzaj jest nieznany</translation>
    </message>
    <message>
        <source>its width is out of range</source>
        <translation>jego grubość jest poza zakresem</translation>
    </message>
    <message>
        <source>its root lies too far away</source>
        <translation>jego korzeń leży za daleko</translation>
    </message>
    <message>
        <source>its parent does not come before it</source>
        <translation>jego rodzic go nie poprzedza</translation>
    </message>
    <message>
        <source>its parameters are missing</source>
        <translation>brak jego parametrów</translation>
    </message>
    <message>
        <source>it was born in the future</source>
        <translation>powstało w przyszłości</translation>
    </message>
    <message>
        <source>it died before it was born, or in the future</source>
        <translation>obumarcie przypada przed powstaniem albo w przyszłości</translation>
    </message>
    <message>
        <source>it lives on a dead internode</source>
        <translation>żyje na martwym międzywęźlu</translation>
    </message>
    <message>
        <source>the columns of the tree have different lengths</source>
        <translation>kolumny drzewa mają różne długości</translation>
    </message>
    <message>
        <source>the tree is empty or lacks its parameters</source>
        <translation>drzewo jest puste lub nie ma parametrów</translation>
    </message>
    <message>
        <source>the tree has more than %1 parameter sets</source>
        <translation>drzewo ma więcej niż %1 zestawów parametrów</translation>
    </message>
    <message>
        <source>the seedling must stand at the base</source>
        <translation>siewka musi stać u podstawy</translation>
    </message>
    <message>
        <source>two internodes continue the same axis</source>
        <translation>dwa międzywęźla przedłużają tę samą oś</translation>
    </message>
    <message>
        <source>another internode has its key</source>
        <translation>inne międzywęźle ma ten sam klucz</translation>
    </message>
    <message>
        <source>internode %1: %2</source>
        <translation>międzywęźle %1: %2</translation>
    </message>
    <message>
        <source>the columns of the placed leaves have different lengths</source>
        <translation>kolumny umieszczonych liści mają różne długości</translation>
    </message>
    <message>
        <source>placed leaf %1: %2</source>
        <translation>umieszczony liść %1: %2</translation>
    </message>
    <message>
        <source>entry %1 of “%2”: %3</source>
        <translation>wpis %1 w „%2”: %3</translation>
    </message>
    <message>
        <source>lasso %1: its plane or its points are not valid</source>
        <translation>lasso %1: jego płaszczyzna lub punkty są nieprawidłowe</translation>
    </message>
    <message>
        <source>the lassos in force are out of order</source>
        <translation>obowiązujące obrysy lassa są w złej kolejności</translation>
    </message>
    <message>
        <source>profile %1: %2</source>
        <translation>profil %1: %2</translation>
    </message>
    <message>
        <source>its profile is missing</source>
        <translation>brak jego profilu</translation>
    </message>
    <message>
        <source>its twist is out of range</source>
        <translation>jego skręcenie jest poza zakresem</translation>
    </message>
    <message>
        <source>its added vigour is out of range</source>
        <translation>jego dodany wigor jest poza zakresem</translation>
    </message>
    <message>
        <source>the length that is kept clear is out of range</source>
        <translation>oczyszczona długość jest poza zakresem</translation>
    </message>
    <message>
        <source>the length that was drawn is out of range</source>
        <translation>narysowana długość jest poza zakresem</translation>
    </message>
</context>
<context>
    <name>TwistTool</name>
    <message>
        <source>%1° from node to node</source>
        <translation>%1° od węzła do węzła</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands; double-tap to untwist them</source>
        <translation>Przeciągnąć wzdłuż gałęzi albo wokół niej, aby skręcić jej pasma; stuknąć dwa razy, aby je rozkręcić</translation>
    </message>
</context>
<context>
    <name>WidthTool</name>
    <message>
        <source>Tap a branch to fix its width; drag the ends of the handle to change it</source>
        <translation>Stuknąć gałąź, aby ustalić jej grubość; przeciągnąć końce uchwytu, aby ją zmienić</translation>
    </message>
</context>
<context>
    <name>WithinMemory</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Na to nie wystarcza pamięci.</translation>
    </message>
</context>
<context>
    <name>ZipArchive</name>
    <message>
        <source>the archive could not be compressed: %1</source>
        <translation>nie udało się spakować archiwum: %1</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>dane są uszkodzone</translation>
    </message>
    <message>
        <source>it is not a project file, or a damaged one (%1)</source>
        <translation>to nie jest plik projektu albo jest uszkodzony (%1)</translation>
    </message>
    <message>
        <source>it is not a project file: it is empty</source>
        <translation>to nie jest plik projektu: jest pusty</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>brak tego elementu</translation>
    </message>
    <message>
        <source>it has %1 bytes, but %2 are expected</source>
        <translation>liczba bajtów to %1, a oczekiwano %2</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>rozmiar w bajtach przekracza %1</translation>
    </message>
    <message>
        <source>it claims to hold far more than its size allows</source>
        <translation>podaje, że zawiera znacznie więcej, niż pozwala na to jego rozmiar</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherController</name>
    <message>
        <source>Draw a tree first: then there can be others like it.</source>
        <translation>Najpierw narysuj drzewo: wtedy mogą powstać inne, podobne.</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>Inne podobne</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherPanel</name>
    <message>
        <source>Another Like This</source>
        <translation>Inne podobne</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Tree %1 of %2</source>
        <translation>Drzewo %1 z %2</translation>
    </message>
    <message>
        <source>Take this tree in place of yours. Undo brings yours back.</source>
        <translation>Wziąć to drzewo w miejsce własnego. Cofnij przywraca własne.</translation>
    </message>
    <message>
        <source>Six More</source>
        <translation>Sześć kolejnych</translation>
    </message>
    <message>
        <source>They are growing…</source>
        <translation>Rosną…</translation>
    </message>
    <message>
        <source>The same strokes; only chance differs.</source>
        <translation>Te same pociągnięcia; różni je tylko przypadek.</translation>
    </message>
</context>
<context>
    <name>espalier::ArchitecturePanel</name>
    <message>
        <source>Architecture</source>
        <translation>Architektura</translation>
    </message>
    <message>
        <source>More ›</source>
        <translation>Więcej ›</translation>
    </message>
    <message>
        <source>Everything else that steers growth: shoots, shade, room to grow</source>
        <translation>Reszta tego, co steruje wzrostem: pędy, zacienienie, miejsce wzrostu</translation>
    </message>
    <message>
        <source>‹ Less</source>
        <translation>‹ Mniej</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Gatunek</translation>
    </message>
    <message>
        <source>Set all parameters of the vigour model to those of a species.</source>
        <translation>Ustawia wszystkie wartości modelu wigoru tak, jak rośnie dany gatunek</translation>
    </message>
    <message>
        <source>No species</source>
        <translation>Bez gatunku</translation>
    </message>
</context>
<context>
    <name>espalier::Autosave</name>
    <message>
        <source>A tree that was never saved</source>
        <translation>drzewo, którego nigdy nie zapisano</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>Nie można zapisywać w folderze %1.</translation>
    </message>
</context>
<context>
    <name>espalier::BackgroundPanel</name>
    <message>
        <source>Background</source>
        <translation>Tło</translation>
    </message>
    <message>
        <source>The colour of the background, or of its lower edge.</source>
        <translation>Kolor, także ten przy dolnej krawędzi.</translation>
    </message>
    <message>
        <source>The colour at the upper edge.</source>
        <translation>Kolor przy górnej krawędzi.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Podłoże</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Słońce</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wybierz…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Show no picture behind the tree.</source>
        <translation>Nie pokazuje za drzewem żadnego obrazu.</translation>
    </message>
    <message>
        <source>Lower colour</source>
        <translation>Dolny kolor</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kolor</translation>
    </message>
    <message>
        <source>Upper colour</source>
        <translation>Górny kolor</translation>
    </message>
    <message>
        <source>Use for New Trees</source>
        <translation>Użyj dla nowych drzew</translation>
    </message>
    <message>
        <source>New trees begin with this background, ground and light. The picture stays with this tree.</source>
        <translation>Nowe drzewa zaczynają z tym tłem, podłożem i światłem. Obraz zostaje przy tym drzewie.</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>Obraz referencyjny</translation>
    </message>
    <message>
        <source>Choose a picture to show behind the tree while you draw. It is saved with the tree.</source>
        <translation>Wybrać obraz widoczny za drzewem podczas rysowania. Jest zapisywany razem z drzewem.</translation>
    </message>
</context>
<context>
    <name>espalier::BendPopOut</name>
    <message>
        <source>Stiffness</source>
        <translation>Sztywność</translation>
    </message>
    <message>
        <source>&lt;b&gt;Stiffness&lt;/b&gt;&lt;br&gt;How much a branch resists being bent: a stiff one bends in a wide curve and is stretched sooner.</source>
        <translation>&lt;b&gt;Sztywność&lt;/b&gt;&lt;br&gt;Jak mocno gałąź opiera się zginaniu: sztywna wygina się szerokim łukiem i prędzej się rozciąga.</translation>
    </message>
    <message>
        <source>Holds length</source>
        <translation>Trzyma długość</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds length&lt;/b&gt;&lt;br&gt;How much a branch resists being stretched: at low values it follows the hand further.</source>
        <translation>&lt;b&gt;Trzyma długość&lt;/b&gt;&lt;br&gt;Jak mocno gałąź opiera się rozciąganiu: zachowuje długość albo dalej podąża za ręką.</translation>
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
        <translation>zygzak</translation>
    </message>
    <message>
        <source>acute</source>
        <translation>ostry</translation>
    </message>
    <message>
        <source>spreading</source>
        <translation>odstający</translation>
    </message>
    <message>
        <source>reflexed</source>
        <translation>odgięty</translation>
    </message>
</context>
<context>
    <name>espalier::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>Pędzel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Pióro</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pressure curve&lt;/b&gt;&lt;br&gt;How firmly the pen must press for the full radius. Drag the curve, or press here with your pen to try it.</source>
        <translation>&lt;b&gt;Krzywa nacisku&lt;/b&gt;&lt;br&gt;Jak mocno trzeba nacisnąć pióro, by uzyskać cały promień. Przeciągnąć krzywą albo nacisnąć tu piórem, aby wypróbować.</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Widoczne</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Głębia</translation>
    </message>
</context>
<context>
    <name>espalier::BrushRadius</name>
    <message>
        <source>&lt;b&gt;Brush radius&lt;/b&gt; [ ]&lt;br&gt;A large brush grows a crown into the space it passes; towards zero it draws a single branch exactly along the stroke.</source>
        <translation>&lt;b&gt;Promień pędzla&lt;/b&gt; [ ]&lt;br&gt;Duży pędzel hoduje koronę w przestrzeni, którą przechodzi; przy promieniu bliskim zera rysuje pojedynczą gałąź dokładnie wzdłuż pociągnięcia.</translation>
    </message>
    <message>
        <source>draws a branch</source>
        <translation>rysuje gałąź</translation>
    </message>
    <message>
        <source>grows a crown</source>
        <translation>hoduje koronę</translation>
    </message>
</context>
<context>
    <name>espalier::DirectionDiagram</name>
    <message>
        <source>Weights of direction</source>
        <translation>Wagi kierunku</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>równowaga</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>prosto</translation>
    </message>
    <message>
        <source>tropism</source>
        <translation>tropizm</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>wolne miejsce</translation>
    </message>
    <message>
        <source>H straight on</source>
        <translation>H prosto</translation>
    </message>
    <message>
        <source>T tropism</source>
        <translation>T tropizm</translation>
    </message>
    <message>
        <source>E space</source>
        <translation>E miejsce</translation>
    </message>
</context>
<context>
    <name>espalier::DocumentFile</name>
    <message>
        <source>Untitled</source>
        <translation>Bez nazwy</translation>
    </message>
</context>
<context>
    <name>espalier::ExportQueue</name>
    <message>
        <source>Writing %1</source>
        <translation>Eksportowanie %1</translation>
    </message>
    <message>
        <source>Writing %1, then %2</source>
        <translation>Eksportowanie %1, potem %2</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Wyeksportowano %1</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>Nie zapisano pliku %1.</translation>
    </message>
    <message>
        <source>Not exported. %1</source>
        <translation>Nie wyeksportowano. %1</translation>
    </message>
</context>
<context>
    <name>espalier::FileController</name>
    <message>
        <source>Not saved. %1</source>
        <translation>Nie zapisano. %1</translation>
    </message>
    <message>
        <source>No safety copy can be saved: %1</source>
        <translation>Nie można zabezpieczyć drzewa na wypadek awarii: %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Zapisywanie %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Jeszcze brak</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Wyczyść listę</translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. The tree is still here; save it to keep it.</source>
        <translation>Plik %1 został przeniesiony lub usunięty przez inny program. Drzewo nadal tu jest; zapisać je, aby je zachować.</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program. Saving here asks before it replaces that version.</source>
        <translation>Plik %1 zmieniono w innym oknie lub programie. Przy zapisie pojawi się tu pytanie, zanim te zmiany zostaną zastąpione.</translation>
    </message>
    <message>
        <source>Open Again</source>
        <translation>Otwórz ponownie</translation>
    </message>
    <message>
        <source>Keep This</source>
        <translation>Zachowaj to</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Otwieranie %1</translation>
    </message>
</context>
<context>
    <name>espalier::GravimorphismDiagram</name>
    <message>
        <source>all alike</source>
        <translation>po równo</translation>
    </message>
    <message>
        <source>amphitony</source>
        <translation>amfitonia</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>pionowo</translation>
    </message>
    <message>
        <source>epitony</source>
        <translation>epitonia</translation>
    </message>
    <message>
        <source>hypotony</source>
        <translation>hipotonia</translation>
    </message>
    <message>
        <source>side %1</source>
        <translation>bok %1</translation>
    </message>
    <message>
        <source>above %1 · below %2</source>
        <translation>góra %1 · dół %2</translation>
    </message>
</context>
<context>
    <name>espalier::GrowPopOut</name>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Odtwórz</translation>
    </message>
    <message>
        <source>Play what happened from here on, or all of it.</source>
        <translation>Odtwarza to, co działo się od tej chwili, albo całość</translation>
    </message>
    <message>
        <source>Hold to grow</source>
        <translation>Wzrost (trzymać)</translation>
    </message>
    <message>
        <source>A tap grows one step; hold to grow on. One hold is one undo step.</source>
        <translation>Stuknięcie daje jeden krok wzrostu; przytrzymanie przedłuża wzrost. Jedno przytrzymanie to jeden krok cofania.</translation>
    </message>
    <message>
        <source>Steps to grow</source>
        <translation>Liczba kroków wzrostu</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>kroków</translation>
    </message>
    <message>
        <source>Grow that many steps, as one undo step. Escape stops.</source>
        <translation>Tyle kroków wzrostu jako jeden krok cofania. Esc zatrzymuje.</translation>
    </message>
    <message>
        <source>Back: the tree ungrows, through all that you did. Forth: it comes back. Pull the handle well past the mark, and the tree grows. Far from the slider, or with Shift, a drag is finer.</source>
        <translation>Wstecz: drzewo cofa wzrost przez wszystko, co zostało zrobione. Naprzód: wraca. Uchwyt pociągnięty wyraźnie za znak sprawia, że drzewo rośnie. Daleko od suwaka albo z Shift przeciąganie jest dokładniejsze.</translation>
    </message>
    <message>
        <source>New steps: %L1</source>
        <translation>Nowe kroki: %L1</translation>
    </message>
    <message>
        <source>Moment %L1 of %L2</source>
        <translation>Chwila %L1 z %L2</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>Siewka</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPage</name>
    <message>
        <source>Help page</source>
        <translation>Strona pomocy</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPanel</name>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Back to the previous page</source>
        <translation>Powrót do poprzedniej strony</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Spis treści</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>Zamknij pomoc</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>Zamknij pomoc (Esc)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Szukaj</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>Szukaj w pomocy</translation>
    </message>
    <message>
        <source>Help pages</source>
        <translation>Strony pomocy</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoc</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Oprowadź mnie</translation>
    </message>
    <message>
        <source>Play this recipe</source>
        <translation>Odtwórz ten przepis</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nic nie znaleziono</translation>
    </message>
</context>
<context>
    <name>espalier::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>Siewka</translation>
    </message>
</context>
<context>
    <name>espalier::LassoPopOut</name>
    <message>
        <source>Regrow</source>
        <translation>Od nowa</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Wystarczy</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Obwiednia</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Znaczniki</translation>
    </message>
    <message>
        <source>&lt;b&gt;Regrow&lt;/b&gt;&lt;br&gt;Take the tree back to how it was before its envelope was drawn, and let it fill the envelope again with the parameters that are in force now. What you have done to it since is lost.</source>
        <translation>&lt;b&gt;Od nowa&lt;/b&gt;&lt;br&gt;Przenosi drzewo do chwili sprzed narysowania obwiedni i pozwala mu wypełnić ją ponownie z obecnymi parametrami. To, co zrobiono z nim później, przepada.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Remove&lt;/b&gt;&lt;br&gt;Take the envelope away; the tree stays as it grew.</source>
        <translation>&lt;b&gt;Usuń&lt;/b&gt;&lt;br&gt;Usuwa obwiednię; drzewo zostaje takie, jakie wyrosło.</translation>
    </message>
    <message>
        <source>Keep what has grown. Escape takes it back instead.</source>
        <translation>Zachowuje to, co wyrosło. Esc natomiast to cofa.</translation>
    </message>
    <message>
        <source>Show the envelope.</source>
        <translation>Pokazuje obwiednię.</translation>
    </message>
    <message>
        <source>Show the points of free space that the tree grows into.</source>
        <translation>Pokazuje punkty wolnego miejsca, w które wrasta drzewo.</translation>
    </message>
</context>
<context>
    <name>espalier::LeafChoices</name>
    <message>
        <source>Continue with</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Jeszcze jeden</translation>
    </message>
    <message>
        <source>One more leaf at this place; all of them stand evenly around the branch.</source>
        <translation>Jeszcze jeden liść w tym miejscu; wszystkie stoją równo wokół gałęzi.</translation>
    </message>
    <message>
        <source>Whorls</source>
        <translation>Okółki</translation>
    </message>
    <message>
        <source>Whorls like this along the whole branch, at the same spacing.</source>
        <translation>Takie okółki w tym odstępie wzdłuż całej gałęzi.</translation>
    </message>
    <message>
        <source>Alternate</source>
        <translation>Skrętoległe</translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation>Naprzeciwległe</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, all in one plane.</source>
        <translation>Pary liści wzdłuż gałęzi, wszystkie w jednej płaszczyźnie.</translation>
    </message>
    <message>
        <source>Decussate</source>
        <translation>Na krzyż</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, each across the one below it.</source>
        <translation>Pary liści wzdłuż gałęzi, każda w poprzek tej poniżej.</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryCards</name>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryController</name>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 jest w koszu.</translation>
    </message>
    <message>
        <source>The system has no trash here. %1 is in %2 now.</source>
        <translation>System nie ma tu kosza. %1 jest teraz w %2.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryPanel</name>
    <message>
        <source>Keep This Tree</source>
        <translation>Zachowaj to drzewo</translation>
    </message>
    <message>
        <source>Start from This</source>
        <translation>Zacznij od tego</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteka</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Drzewa</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Szukaj</translation>
    </message>
    <message>
        <source>Save the open tree in the library.</source>
        <translation>Zapisuje otwarte drzewo w bibliotece.</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>Z powrotem do drzewa</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>A new seedling that grows the way this tree does.</source>
        <translation>Nowa siewka, która rośnie tak jak to drzewo.</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Gatunki</translation>
    </message>
    <message>
        <source>Your Trees</source>
        <translation>Własne drzewa</translation>
    </message>
    <message>
        <source>No tree has a name like that.</source>
        <translation>Żadne nie ma takiej nazwy.</translation>
    </message>
    <message>
        <source>No trees yet. “Keep This Tree” saves the open tree here.</source>
        <translation>Jeszcze brak. „Zachowaj to drzewo” zapisuje drzewo, które jest tu otwarte.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Zmień nazwę</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Powiel</translation>
    </message>
    <message>
        <source>Move to Trash</source>
        <translation>Przenieś do kosza</translation>
    </message>
</context>
<context>
    <name>espalier::LookChoice</name>
    <message>
        <source>Choose an image…</source>
        <translation>Wybierz obraz…</translation>
    </message>
    <message>
        <source>A PNG or JPEG of one leaf, stalk down, on a transparent or plain background</source>
        <translation>PNG lub JPEG z jednym liściem, ogonkiem w dół, bez tła lub na jednolitym tle</translation>
    </message>
    <message>
        <source>A PNG or JPEG of bark; normal and roughness maps found beside it are used, too</source>
        <translation>PNG lub JPEG z korą; mapy normalnych i chropowatości leżące obok też zostaną użyte</translation>
    </message>
    <message>
        <source>Your image: %1</source>
        <translation>Własny obraz: %1</translation>
    </message>
</context>
<context>
    <name>espalier::LookController</name>
    <message>
        <source>Image of a Leaf</source>
        <translation>Obraz liścia</translation>
    </message>
    <message>
        <source>Image of Bark</source>
        <translation>Obraz kory</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg)</source>
        <translation>Obrazy (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Liście</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Kora</translation>
    </message>
    <message>
        <source>Maps found beside it are used, too.</source>
        <translation>Wzięto też mapy leżące obok.</translation>
    </message>
    <message>
        <source>What is %1 for?</source>
        <translation>Do czego służy %1?</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>Obraz referencyjny</translation>
    </message>
    <message>
        <source>This tree has had so many images that its file has no room for another one.</source>
        <translation>To drzewo miało już tyle obrazów, że w jego pliku nie ma miejsca na następny.</translation>
    </message>
</context>
<context>
    <name>espalier::MainWindow</name>
    <message>
        <source>The tree has no room left to grow.</source>
        <translation>Drzewo nie ma już miejsca, w którym mogłoby rosnąć.</translation>
    </message>
    <message>
        <source>%1[*] – Espalier</source>
        <translation>%1[*] – Espalier</translation>
    </message>
    <message>
        <source>Growing %1</source>
        <translation>Rośnie: %1</translation>
    </message>
    <message>
        <source>Not everything that the recipe names was found in the tree (%1 of %2 operations): %3</source>
        <translation>Operacje przepisu, które nie znalazły nic do zrobienia albo nie wszystko, co wymieniają (%1 z %2): %3</translation>
    </message>
    <message>
        <source>Building the wood from strands</source>
        <translation>Tworzenie drewna z pasm</translation>
    </message>
    <message>
        <source>Growth has stopped: the tree has %L1 internodes, and the memory of this machine may not hold a larger one.</source>
        <translation>Wzrost zatrzymano: drzewo ma %L1 międzywęźli, a pamięć tego komputera może nie pomieścić większego.</translation>
    </message>
    <message>
        <source>Allow More</source>
        <translation>Pozwól na więcej</translation>
    </message>
    <message>
        <source>Leave It</source>
        <translation>Zostaw tak</translation>
    </message>
    <message>
        <source>The oldest steps of the history were dropped, so that it takes no more than %1 MB.</source>
        <translation>Najstarsze kroki historii usunięto, aby nie zajmowała więcej niż %1 MB.</translation>
    </message>
</context>
<context>
    <name>espalier::Notice</name>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
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
        <translation>gęsta</translation>
    </message>
    <message>
        <source>ordinary</source>
        <translation>zwykła</translation>
    </message>
    <message>
        <source>airy</source>
        <translation>ażurowa</translation>
    </message>
</context>
<context>
    <name>espalier::PictureController</name>
    <message>
        <source>Drawing the picture</source>
        <translation>Rysowanie obrazu</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>Obraz jest w schowku.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Zapisano %1</translation>
    </message>
    <message>
        <source>Not saved. %1</source>
        <translation>Nie zapisano. %1</translation>
    </message>
</context>
<context>
    <name>espalier::PictureSheet</name>
    <message>
        <source>Like the window, %1 × %2</source>
        <translation>Jak okno, %1 × %2</translation>
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
        <translation>Kwadrat, 1080 × 1080</translation>
    </message>
    <message>
        <source>Large square, 2048 × 2048</source>
        <translation>Duży kwadrat, 2048 × 2048</translation>
    </message>
    <message>
        <source>Portrait, 1080 × 1350</source>
        <translation>Pionowy, 1080 × 1350</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Inny rozmiar</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Przezroczyste tło</translation>
    </message>
    <message>
        <source>With the shadow on the ground</source>
        <translation>Z cieniem na podłożu</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Zapis obrazu</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>Tak jak teraz widać</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Z przodu</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Z boku</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Z ukosa</translation>
    </message>
    <message>
        <source>Nothing is behind the tree, so that it can be laid over other pictures.</source>
        <translation>Za drzewem nie ma nic, więc można je nałożyć na inne obrazy.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Tło</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Put the picture on the clipboard.</source>
        <translation>Umieścić obraz w schowku.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Zapisz…</translation>
    </message>
</context>
<context>
    <name>espalier::PressureCurve</name>
    <message>
        <source>Pressure curve</source>
        <translation>Krzywa nacisku</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileCanvas</name>
    <message>
        <source>Cross-section</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>Draw an outline first: attractors gather the strands within it.</source>
        <translation>Najpierw narysować kontur: atraktory skupiają pasma w jego wnętrzu.</translation>
    </message>
    <message>
        <source>This cannot be the profile: %1.</source>
        <translation>To nie może być profil: %1.</translation>
    </message>
    <message>
        <source>Tap a branch of the tree to see its cross-section.</source>
        <translation>Stuknąć gałąź drzewa, aby zobaczyć jej przekrój.</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileController</name>
    <message>
        <source>The two places are not on one branch.</source>
        <translation>Te dwa miejsca nie leżą na jednej gałęzi.</translation>
    </message>
    <message>
        <source>The other place has no profile to blend with.</source>
        <translation>W drugim miejscu nie ma profilu, do którego można by interpolować.</translation>
    </message>
    <message>
        <source>There is no room for more profiles.</source>
        <translation>Nie ma miejsca na więcej profili.</translation>
    </message>
</context>
<context>
    <name>espalier::ProfilePanel</name>
    <message>
        <source>Outline</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>&lt;b&gt;Outline&lt;/b&gt;&lt;br&gt;Draw a closed line. One beside another splits the wood; one within another is a hollow.</source>
        <translation>&lt;b&gt;Kontur&lt;/b&gt;&lt;br&gt;Narysować zamkniętą linię. Linia obok innych dzieli drewno, linia wewnątrz innej daje pustkę.</translation>
    </message>
    <message>
        <source>Attractor</source>
        <translation>Atraktor</translation>
    </message>
    <message>
        <source>&lt;b&gt;Attractor&lt;/b&gt;&lt;br&gt;Drag a straight line that the strands gather at.</source>
        <translation>&lt;b&gt;Atraktor&lt;/b&gt;&lt;br&gt;Przeciągnąć prostą linię, przy której skupiają się pasma.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>&lt;b&gt;Points&lt;/b&gt;&lt;br&gt;Drag the points of an outline, or the ends of an attractor.</source>
        <translation>&lt;b&gt;Punkty&lt;/b&gt;&lt;br&gt;Przeciągnąć punkty konturu albo końce atraktora.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Wymaż</translation>
    </message>
    <message>
        <source>&lt;b&gt;Erase&lt;/b&gt;&lt;br&gt;Tap a line to take it away. A pen&apos;s eraser does the same at any time.</source>
        <translation>&lt;b&gt;Wymaż&lt;/b&gt;&lt;br&gt;Stuknąć linię, aby ją usunąć. Gumka pióra robi to samo w każdej chwili.</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Okrągły</translation>
    </message>
    <message>
        <source>Elongated</source>
        <translation>Wydłużony</translation>
    </message>
    <message>
        <source>C-shaped</source>
        <translation>W kształcie C</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Wydrążony</translation>
    </message>
    <message>
        <source>Split in two</source>
        <translation>Na dwie części</translation>
    </message>
    <message>
        <source>Split in three</source>
        <translation>Na trzy części</translation>
    </message>
    <message>
        <source>Fluted</source>
        <translation>Żłobiony</translation>
    </message>
    <message>
        <source>Copy to branch</source>
        <translation>Kopiuj na gałąź</translation>
    </message>
    <message>
        <source>&lt;b&gt;Copy to branch&lt;/b&gt;&lt;br&gt;Then tap another place on this branch: everything between gets this profile.</source>
        <translation>&lt;b&gt;Kopiuj na gałąź&lt;/b&gt;&lt;br&gt;Następnie stuknąć inne miejsce tej gałęzi: wszystkie pomiędzy dostają ten profil.</translation>
    </message>
    <message>
        <source>▼</source>
        <translation>▼</translation>
    </message>
    <message>
        <source>To the next place down the branch.</source>
        <translation>Do następnego miejsca w dół gałęzi</translation>
    </message>
    <message>
        <source>▲</source>
        <translation>▲</translation>
    </message>
    <message>
        <source>To the next place up the branch.</source>
        <translation>Do następnego miejsca w górę gałęzi</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Całość</translation>
    </message>
    <message>
        <source>Show the whole cross-section.</source>
        <translation>Pokazuje cały przekrój</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Wyczyść</translation>
    </message>
    <message>
        <source>&lt;b&gt;Clear&lt;/b&gt;&lt;br&gt;Take the profile away: the strands are packed round again.</source>
        <translation>&lt;b&gt;Wyczyść&lt;/b&gt;&lt;br&gt;Usuwa profil: pasma znów układają się w okrągły przekrój.</translation>
    </message>
    <message>
        <source>Down the branch</source>
        <translation>W dół gałęzi</translation>
    </message>
    <message>
        <source>Up the branch</source>
        <translation>W górę gałęzi</translation>
    </message>
    <message numerus="yes">
        <source>Radius %1 · %Ln strands</source>
        <translation>
            <numerusform>Promień %1 · %Ln pasmo</numerusform>
            <numerusform>Promień %1 · %Ln pasma</numerusform>
            <numerusform>Promień %1 · %Ln pasm</numerusform>
        </translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Draw another closed line: beside the first to split the wood, within it for a hollow.</source>
        <translation>Narysować kolejną zamkniętą linię: obok pierwszej, aby podzielić drewno, wewnątrz niej, aby powstała pustka.</translation>
    </message>
    <message>
        <source>Draw a closed line, or begin with one of these shapes.</source>
        <translation>Narysować zamkniętą linię albo zacząć od jednego z tych kształtów.</translation>
    </message>
    <message>
        <source>Drag a straight line: the strands gather at it.</source>
        <translation>Przeciągnąć prostą linię: pasma skupią się przy niej.</translation>
    </message>
    <message>
        <source>Drag the points of a line.</source>
        <translation>Przeciągnąć punkty linii.</translation>
    </message>
    <message>
        <source>Tap a line to take it away.</source>
        <translation>Stuknąć linię, aby ją usunąć.</translation>
    </message>
    <message>
        <source>Tap the other end on this branch, or go there with ▲ and ▼ and press the button again.</source>
        <translation>Stuknąć drugi koniec na tej gałęzi albo przejść tam przyciskami ▲ i ▼ i nacisnąć przycisk ponownie.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Interpoluj</translation>
    </message>
    <message>
        <source>&lt;b&gt;Blend&lt;/b&gt;&lt;br&gt;Then tap another place on this branch that has a profile: the sections between change from one to the other.</source>
        <translation>&lt;b&gt;Interpoluj&lt;/b&gt;&lt;br&gt;Następnie stuknąć inne miejsce tej gałęzi, które ma profil: miejsca pomiędzy przechodzą od jednego do drugiego.</translation>
    </message>
</context>
<context>
    <name>espalier::PrunePopOut</name>
    <message>
        <source>Cut</source>
        <translation>Odetnij</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw a line across several.</source>
        <translation>Dotknij gałęzi, aby ją zdjąć, albo przeciągnij linię w poprzek kilku.</translation>
    </message>
    <message>
        <source>Keep clear</source>
        <translation>Bez pędów</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: the shoots below your hand are removed, and no new ones come. Drag the ring down again to let buds shoot.</source>
        <translation>Przeciągnij w górę wzdłuż pnia lub gałęzi: pędy poniżej dłoni znikają i nowe nie wyrastają. Przeciągnij pierścień w dół, aby pąki znów mogły rosnąć.</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Wymaż</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are. Limbs stay.</source>
        <translation>Przesuń pędzlem po gałązkach i liściach, aby je usunąć, nawet głęboko w koronie. Konary zostają.</translation>
    </message>
    <message>
        <source>Thin out</source>
        <translation>Przerzedź</translation>
    </message>
    <message>
        <source>Brush over the crown to take out some of its twigs evenly.</source>
        <translation>Przesuń pędzlem po koronie, aby równomiernie usunąć część gałązek.</translation>
    </message>
</context>
<context>
    <name>espalier::RadiusSlider</name>
    <message>
        <source>Brush radius</source>
        <translation>Promień pędzla</translation>
    </message>
</context>
<context>
    <name>espalier::Recovery</name>
    <message>
        <source>%1, but the file is no longer there</source>
        <translation>%1, ale pliku już tam nie ma</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>Nie można odczytać.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln internodes</source>
        <translation>
            <numerusform>%Ln międzywęźle</numerusform>
            <numerusform>%Ln międzywęźla</numerusform>
            <numerusform>%Ln międzywęźli</numerusform>
        </translation>
    </message>
    <message>
        <source>Changed by another program since</source>
        <translation>Zmieniony potem przez inny program</translation>
    </message>
    <message>
        <source>There is nothing to bring back: all was saved, or given up.</source>
        <translation>Nie ma czego przywracać: wszystko jest zapisane lub odrzucone.</translation>
    </message>
    <message>
        <source>Another tree can be brought back.</source>
        <translation>Można przywrócić jeszcze jedno drzewo.</translation>
    </message>
    <message numerus="yes">
        <source>%n other trees can be brought back.</source>
        <translation>
            <numerusform>Można przywrócić jeszcze %n drzewo.</numerusform>
            <numerusform>Można przywrócić jeszcze %n drzewa.</numerusform>
            <numerusform>Można przywrócić jeszcze %n drzew.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>The safety copy of %1 cannot be read. It is kept as %2.</source>
        <translation>Nie można odczytać kopii zapasowej %1. Pozostaje jako %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n safety copies cannot be read. They are kept in %1.</source>
        <translation>
            <numerusform>Nie można odczytać %n kopii zapasowej. Pozostaje w %1.</numerusform>
            <numerusform>Nie można odczytać %n kopii zapasowych. Pozostają w %1.</numerusform>
            <numerusform>Nie można odczytać %n kopii zapasowych. Pozostają w %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::RecoveryRow</name>
    <message>
        <source>Bring Back</source>
        <translation>Przywróć</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>W pliku</translation>
    </message>
    <message>
        <source>Can be brought back</source>
        <translation>Można przywrócić</translation>
    </message>
    <message>
        <source>It will be deleted when this closes.</source>
        <translation>Zostanie usunięte po zamknięciu.</translation>
    </message>
    <message>
        <source>Bring back %1</source>
        <translation>Przywróć %1</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>Odrzuć %1</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Rysowanie…</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Brak obrazu</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Zachowaj</translation>
    </message>
</context>
<context>
    <name>espalier::RecoverySheet</name>
    <message>
        <source>today, %1</source>
        <translation>dzisiaj, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>wczoraj, %1</translation>
    </message>
    <message>
        <source>Bring Trees Back</source>
        <translation>Przywróć drzewa</translation>
    </message>
    <message>
        <source>Espalier ended before this was saved. What you leave here is offered again at the next start.</source>
        <translation>Espalier zakończył działanie, zanim to zapisano. To, co tu zostawisz, pojawi się znowu przy następnym uruchomieniu.</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Później</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Gotowe</translation>
    </message>
</context>
<context>
    <name>espalier::ReportSheet</name>
    <message>
        <source>With the recipe of this tree</source>
        <translation>Z przepisem tego drzewa</translation>
    </message>
    <message>
        <source>Report a Problem</source>
        <translation>Zgłoś problem</translation>
    </message>
    <message>
        <source>Copy this text, and add what you did and what happened. Espalier sends nothing by itself. Without the recipe, the text has nothing of your tree.</source>
        <translation>Skopiuj ten tekst i dodaj, co robiono i co się stało. Espalier sam niczego nie wysyła. Bez przepisu tekst nie zawiera niczego z drzewa.</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>Tekst zgłoszenia</translation>
    </message>
    <message>
        <source>All that was done to the tree, so that others can do it again.</source>
        <translation>Wszystko, co zrobiono z drzewem, aby inni mogli to powtórzyć.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
</context>
<context>
    <name>espalier::ReproduceController</name>
    <message>
        <source>Draw the new trunk, from its base to its tip.</source>
        <translation>Narysuj nowy pień, od podstawy do wierzchołka.</translation>
    </message>
    <message>
        <source>Now draw the silhouette of the crown around its tip.</source>
        <translation>Teraz narysuj sylwetkę korony wokół jego wierzchołka.</translation>
    </message>
    <message>
        <source>Now draw the trunk, with its tip inside the silhouette.</source>
        <translation>Teraz narysuj pień, z wierzchołkiem wewnątrz sylwetki.</translation>
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
        <translation>Inne</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another&lt;/b&gt;&lt;br&gt;The same tree with slightly different angles and lengths, as it could stand beside it in a forest. As long as nothing else is done, the next one takes its place.</source>
        <translation>&lt;b&gt;Inne&lt;/b&gt;&lt;br&gt;To samo drzewo z nieco innymi kątami i długościami, jakie mogłoby stać obok w lesie. Dopóki nic innego nie zrobisz, następne zajmuje jego miejsce.</translation>
    </message>
</context>
<context>
    <name>espalier::RingMenu</name>
    <message>
        <source>Tools around the pointer</source>
        <translation>Narzędzia wokół wskaźnika</translation>
    </message>
</context>
<context>
    <name>espalier::RotationStrip</name>
    <message>
        <source>Rotation strip</source>
        <translation>Pasek obrotu</translation>
    </message>
</context>
<context>
    <name>espalier::SceneController</name>
    <message>
        <source>Reference Picture</source>
        <translation>Obraz referencyjny</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Obrazy (%1)</translation>
    </message>
    <message>
        <source>New trees will have this background, ground and light.</source>
        <translation>Nowe drzewa będą miały to tło, podłoże i światło.</translation>
    </message>
</context>
<context>
    <name>espalier::SettingsSheet</name>
    <message>
        <source>The middle button turns; with Shift it pans, with Ctrl it zooms. Alt with the left button turns, too.</source>
        <translation>Środkowy przycisk obraca, z Shift przesuwa, z Ctrl przybliża. Alt i lewy przycisk też obracają.</translation>
    </message>
    <message>
        <source>With Alt, the left button turns, the middle one pans and the right one zooms.</source>
        <translation>Alt i lewy przycisk obracają, Alt i środkowy przesuwają, Alt i prawy przybliżają.</translation>
    </message>
    <message>
        <source>The right or middle button turns; Shift with the middle button pans. Alt with the left button turns, too.</source>
        <translation>Prawy lub środkowy przycisk obraca, Shift i środkowy przesuwają. Alt i lewy przycisk też obracają.</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Domyślne</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Ciemny</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Jasny</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>Jak w systemie</translation>
    </message>
    <message>
        <source>On the left</source>
        <translation>Po lewej</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>Po prawej</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Wygląd</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Motyw</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Nacisk</translation>
    </message>
    <message>
        <source>How firmly a pen must press for a large brush.</source>
        <translation>Jak mocno trzeba nacisnąć pióro, by pędzel był duży.</translation>
    </message>
    <message>
        <source>Press here with your pen to try it.</source>
        <translation>Nacisnąć tu piórem, aby wypróbować.</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mysz</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Lekko</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Mocno</translation>
    </message>
    <message>
        <source>Pen pressure</source>
        <translation>Nacisk pióra</translation>
    </message>
    <message>
        <source>all</source>
        <translation>wszystkie</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Zmień…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Praca</translation>
    </message>
    <message>
        <source>Undo steps kept</source>
        <translation>Kroki cofania</translation>
    </message>
    <message>
        <source>A change applies to the next tree that you begin or open.</source>
        <translation>Liczba kroków obowiązuje od następnego rozpoczętego lub otwartego drzewa.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteka</translation>
    </message>
    <message>
        <source>In Espalier&apos;s own folder</source>
        <translation>We własnym folderze programu</translation>
    </message>
    <message>
        <source>Library Folder</source>
        <translation>Folder biblioteki</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
    <message>
        <source>Metres, centimetres</source>
        <translation>Metry, centymetry</translation>
    </message>
    <message>
        <source>Feet, inches</source>
        <translation>Stopy, cale</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Długości</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Size of the interface</source>
        <translation>Rozmiar interfejsu</translation>
    </message>
    <message>
        <source>Stroke stabiliser</source>
        <translation>Stabilizacja kreski</translation>
    </message>
    <message>
        <source>A stroke follows the pointer at this distance, like a stone on a string, so it does not tremble.</source>
        <translation>Kreska podąża za wskaźnikiem w tej odległości, jak kamień na sznurku: nie drży.</translation>
    </message>
    <message>
        <source>A stroke lags this far behind the pointer, and is smoother.</source>
        <translation>Kreska przychodzi o tyle później niż wskaźnik, za to płynniej.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Odległość</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Opóźnienie</translation>
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
        <translation>wyłączone</translation>
    </message>
    <message>
        <source>Takes effect the next time Espalier starts.</source>
        <translation>Działa od następnego uruchomienia programu.</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Pamięć na historię</translation>
    </message>
    <message>
        <source>If the history takes more, its oldest steps go.</source>
        <translation>Jeśli historia zajmie więcej, znikną jej najstarsze kroki.</translation>
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
        <translation>Krzew</translation>
    </message>
    <message>
        <source>Street Tree</source>
        <translation>Drzewo uliczne</translation>
    </message>
    <message>
        <source>Forest Tree</source>
        <translation>Drzewo leśne</translation>
    </message>
    <message>
        <source>Size of the new tree</source>
        <translation>Rozmiar nowego drzewa</translation>
    </message>
    <message>
        <source>How tall should the new tree grow?</source>
        <translation>Jak wysokie ma być nowe drzewo?</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;About %2 tall; the brush, the branches and the leaves are in proportion.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Około %2 wysokości; pędzel, gałęzie i liście są w proporcji.</translation>
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
        <translation>Nadaj głębię</translation>
    </message>
    <message>
        <source>&lt;b&gt;Give depth&lt;/b&gt;&lt;br&gt;The branches of the drawing spread into depth, as far from each other as they can. From the front the tree looks as you drew it.</source>
        <translation>&lt;b&gt;Nadaj głębię&lt;/b&gt;&lt;br&gt;Gałęzie rysunku rozkładają się w głąb, jak najdalej od siebie. Od przodu drzewo wygląda tak, jak je narysowano.</translation>
    </message>
    <message>
        <source>Another depth</source>
        <translation>Inna głębia</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another depth&lt;/b&gt;&lt;br&gt;Choose new depths for the branches.</source>
        <translation>&lt;b&gt;Inna głębia&lt;/b&gt;&lt;br&gt;Wybierz głębie gałęzi na nowo.</translation>
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
        <translation>Otwórz ostatnie</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>„%1” ma niezapisane zmiany.</translation>
    </message>
</context>
<context>
    <name>espalier::Tour</name>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Back in time</source>
        <translation>Wstecz w czasie</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Dookoła</translation>
    </message>
    <message>
        <source>When you wonder</source>
        <translation>W razie pytań</translation>
    </message>
    <message>
        <source>&lt;b&gt;F1&lt;/b&gt; or this button tells you about the tool in your hand. &lt;b&gt;Ctrl+Z&lt;/b&gt; takes back whatever you did, so try things.</source>
        <translation>&lt;b&gt;F1&lt;/b&gt; lub ten przycisk opowiada o wybranym narzędziu. &lt;b&gt;Ctrl+Z&lt;/b&gt; cofa każdą czynność, więc warto próbować.</translation>
    </message>
    <message>
        <source>Draw a tree</source>
        <translation>Narysuj drzewo</translation>
    </message>
    <message>
        <source>Draw a trunk</source>
        <translation>Narysuj pień</translation>
    </message>
    <message>
        <source>Draw a branch</source>
        <translation>Narysuj gałąź</translation>
    </message>
    <message>
        <source>Here is a seedling. &lt;b&gt;Press on it and draw a line upward&lt;/b&gt;, to the middle of the picture or higher: it becomes the trunk.</source>
        <translation>Oto siewka. &lt;b&gt;Naciśnij ją i pociągnij linię w górę&lt;/b&gt;, do środka obrazu lub wyżej: powstanie pień.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a branch and draw outward&lt;/b&gt;: the line becomes a branch.</source>
        <translation>&lt;b&gt;Naciśnij gałąź i ciągnij na zewnątrz&lt;/b&gt;: linia stanie się gałęzią.</translation>
    </message>
    <message>
        <source>Draw the limbs</source>
        <translation>Narysuj konary</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on the trunk and draw outward and up&lt;/b&gt;, to the left and to the right. Three limbs or four are enough.</source>
        <translation>&lt;b&gt;Naciśnij pień i ciągnij na zewnątrz i w górę&lt;/b&gt;, w lewo i w prawo. Wystarczą trzy albo cztery konary.</translation>
    </message>
    <message>
        <source>Small and large</source>
        <translation>Mały i duży</translation>
    </message>
    <message>
        <source>A tiny brush draws a single branch, a large one grows a crown. &lt;b&gt;Drag the slider upward, or press&amp;nbsp;]&lt;/b&gt;; [ makes the brush smaller.</source>
        <translation>Maleńki pędzel rysuje jedną gałąź, duży hoduje koronę. &lt;b&gt;Przeciągnij suwak w górę albo naciśnij&amp;nbsp;]&lt;/b&gt;; [ zmniejsza pędzel.</translation>
    </message>
    <message>
        <source>Grow a crown</source>
        <translation>Wyhoduj koronę</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a limb and draw slowly along the limbs and around their ends&lt;/b&gt;: twigs and leaves grow wherever the brush passes.</source>
        <translation>&lt;b&gt;Naciśnij konar i powoli ciągnij wzdłuż konarów i wokół ich końców&lt;/b&gt;: gałązki i liście rosną wszędzie, gdzie przejdzie pędzel.</translation>
    </message>
    <message>
        <source>Prune, bend, draw with a lasso: what a gardener needs is here. &lt;b&gt;Choose Grow&lt;/b&gt;.</source>
        <translation>Cięcie, gięcie, rysowanie lassem: wszystko, czego potrzebuje ogrodnik, jest tutaj. &lt;b&gt;Wybierz Wzrost&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag this slider to the left&lt;/b&gt;, and the tree ungrows; drag it back to the right, and the tree is there again.</source>
        <translation>&lt;b&gt;Przeciągnij ten suwak w lewo&lt;/b&gt;, a drzewo cofa wzrost; z powrotem w prawo, a drzewo znów jest.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag along this edge&lt;/b&gt;, and the tree turns, even while your other hand brushes. The right mouse button turns it as well.</source>
        <translation>&lt;b&gt;Przeciągnij wzdłuż tej krawędzi&lt;/b&gt;, a drzewo się obraca, nawet gdy druga ręka maluje. Prawy przycisk myszy też je obraca.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Choose Sketch&lt;/b&gt; to draw a trunk and branches as on paper, and give the drawing depth. Watch how thirty strokes become a tree.</source>
        <translation>&lt;b&gt;Wybierz Szkic&lt;/b&gt;, aby narysować pień i gałęzie jak na papierze i nadać rysunkowi głębię. Zobacz, jak trzydzieści kresek staje się drzewem.</translation>
    </message>
</context>
<context>
    <name>espalier::TourCard</name>
    <message>
        <source>Skip</source>
        <translation>Pomiń</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Wprowadzenie</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Gotowe</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Zobacz</translation>
    </message>
</context>
<context>
    <name>espalier::TropismDiagram</name>
    <message>
        <source>as the stroke</source>
        <translation>za pociągnięciem</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>pionowo</translation>
    </message>
    <message>
        <source>slanting</source>
        <translation>ukośnie</translation>
    </message>
    <message>
        <source>level</source>
        <translation>poziomo</translation>
    </message>
    <message>
        <source>weeping</source>
        <translation>zwisająco</translation>
    </message>
</context>
<context>
    <name>espalier::Viewport</name>
    <message>
        <source>Tree</source>
        <translation>Drzewo</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Z prawej</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Z przodu</translation>
    </message>
</context>
<context>
    <name>espalier::Workspace</name>
    <message>
        <source>Only one bud grows  ✕</source>
        <translation>Rośnie tylko jedna gałąź  ✕</translation>
    </message>
    <message>
        <source>Let all buds grow again.</source>
        <translation>Znów rosną wszystkie pąki</translation>
    </message>
    <message>
        <source>a seedling</source>
        <translation>siewka</translation>
    </message>
    <message>
        <source>%L1 internodes · %L2 leaves · step %L3</source>
        <translation>międzywęźla: %L1 · liście: %L2 · krok %L3</translation>
    </message>
    <message>
        <source>Back to My Tree</source>
        <translation>Wróć do mojego drzewa</translation>
    </message>
    <message>
        <source>Show your own tree again, as it was before this recipe was played.</source>
        <translation>Pokazać znów własne drzewo, takie jak przed odtworzeniem tego przepisu</translation>
    </message>
</context>
</TS>
