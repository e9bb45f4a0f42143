<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Start with a seedling.</source>
        <translation>苗から始めます。</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Open a project or a recipe.</source>
        <translation>プロジェクトかレシピを開きます。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>プロジェクトを保存します。</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>別名で保存…</translation>
    </message>
    <message>
        <source>Save the project under another name.</source>
        <translation>プロジェクトを別の名前で保存します。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出し…</translation>
    </message>
    <message>
        <source>Write the tree for other programs: GLB, FBX, OBJ, or its skeleton as CSV.</source>
        <translation>ほかのプログラム用に書き出します。GLB、FBX、OBJ、または骨格の CSV です。</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Leave Espalier.</source>
        <translation>Espalier を終了します。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Take back what you did last.</source>
        <translation>直前の操作を元に戻します。</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Do again what you took back.</source>
        <translation>元に戻した操作をやり直します。</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Drag from the tree outward: it grows into the space that the brush passes through.</source>
        <translation>木から外へドラッグすると、ブラシが通った空間に木が伸びます。</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>成長</translation>
    </message>
    <message>
        <source>Press anywhere and hold: the tree grows on its own, competing for light and space.</source>
        <translation>どこでも押し続けると、木が光と空間を競いながら自然に成長します。</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>剪定</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw across all the branches to cut.</source>
        <translation>枝をタップして切り落とすか、落とす枝を横切る線を引きます。</translation>
    </message>
    <message>
        <source>Bud</source>
        <translation>芽</translation>
    </message>
    <message>
        <source>Tap a bud: from now on, only this bud grows, and what comes from it.</source>
        <translation>芽をタップすると、その芽とそこから出る枝だけが成長します。</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>曲げ</translation>
    </message>
    <message>
        <source>Pull a branch to bend it; tap it to pin it there.</source>
        <translation>枝を引くと曲がります。タップすると、その場所をピンで留めます。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>太さ</translation>
    </message>
    <message>
        <source>Tap a branch to fix its width, and drag the handle to change it.</source>
        <translation>枝をタップすると太さを固定し、ハンドルをドラッグすると変えられます。</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>投げ縄</translation>
    </message>
    <message>
        <source>Draw the silhouette of a crown: the tree grows until it fills that shape.</source>
        <translation>樹冠の輪郭を描くと、木がそれを満たすまで成長します。</translation>
    </message>
    <message>
        <source>Grow One Step</source>
        <translation>1 ステップ成長</translation>
    </message>
    <message>
        <source>Let the tree grow one step on its own.</source>
        <translation>木を自然に 1 ステップ成長させます。</translation>
    </message>
    <message>
        <source>Smaller Brush</source>
        <translation>ブラシを小さく</translation>
    </message>
    <message>
        <source>Make the brush smaller, even while brushing.</source>
        <translation>ブラシを小さくします。描いている途中でも使えます。</translation>
    </message>
    <message>
        <source>Larger Brush</source>
        <translation>ブラシを大きく</translation>
    </message>
    <message>
        <source>Make the brush larger, even while brushing.</source>
        <translation>ブラシを大きくします。描いている途中でも使えます。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Take back the stroke or the growth under way.</source>
        <translation>進行中のストロークや成長を取り消します。</translation>
    </message>
    <message>
        <source>Frame All</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>Show the whole tree.</source>
        <translation>木全体を表示します。</translation>
    </message>
    <message>
        <source>From the Front</source>
        <translation>正面から</translation>
    </message>
    <message>
        <source>Look at the tree from the front.</source>
        <translation>木を正面から見ます。</translation>
    </message>
    <message>
        <source>From the Side</source>
        <translation>側面から</translation>
    </message>
    <message>
        <source>Look at the tree from the side.</source>
        <translation>木を側面から見ます。</translation>
    </message>
    <message>
        <source>From the Top</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>Look down at the tree.</source>
        <translation>木を真上から見下ろします。</translation>
    </message>
    <message>
        <source>Three-Quarter</source>
        <translation>斜めから</translation>
    </message>
    <message>
        <source>Look at the tree from between the front and the side.</source>
        <translation>木を斜め方向から見ます。</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads.</source>
        <translation>ブラシが散らす空き空間の点を表示します。</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>葉</translation>
    </message>
    <message>
        <source>Show the leaves.</source>
        <translation>葉を表示します。</translation>
    </message>
    <message>
        <source>Architecture</source>
        <translation>樹形</translation>
    </message>
    <message>
        <source>How the tree grows from now on.</source>
        <translation>これから木がどう成長するかを決めます。</translation>
    </message>
    <message>
        <source>What the leaves look like.</source>
        <translation>葉の見た目を決めます。</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>枝</translation>
    </message>
    <message>
        <source>How thick branches are, and their bark.</source>
        <translation>枝の太さと樹皮を決めます。</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>What is around the tree: background, ground, sun, reference picture.</source>
        <translation>木のまわりのもの。背景、地面、太陽、下絵です。</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Everything you did, step by step; click a step to go back to it.</source>
        <translation>これまでの操作の一覧です。クリックするとその時点に移ります。</translation>
    </message>
    <message>
        <source>Focus Panels or Tree</source>
        <translation>パネルと木の切り替え</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the panels, or back to the tree.</source>
        <translation>キー操作の対象をパネルに移すか、木に戻します。</translation>
    </message>
    <message>
        <source>Only the Tree</source>
        <translation>木だけ表示</translation>
    </message>
    <message>
        <source>Hide everything but the tree; the same key brings everything back.</source>
        <translation>木以外をすべて隠します。同じキーで元に戻ります。</translation>
    </message>
    <message>
        <source>Full Screen</source>
        <translation>全画面表示</translation>
    </message>
    <message>
        <source>Fill the whole screen.</source>
        <translation>画面全体に表示します。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Help on the current tool, and on everything else.</source>
        <translation>手にしているツールの説明と、そのほかすべてのヘルプです。</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>ライブラリ</translation>
    </message>
    <message>
        <source>Species to start from, and the trees you keep.</source>
        <translation>出発点にする樹種と、保存してある木です。</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>設定…</translation>
    </message>
    <message>
        <source>How Espalier looks, and how it responds to your hand.</source>
        <translation>Espalier の見た目と、手の動きの受け取り方です。</translation>
    </message>
    <message>
        <source>Size of the brush, pressure of the pen, and what is shown while you brush.</source>
        <translation>ブラシの大きさ、筆圧、ブラシが広げる余地を決めます。</translation>
    </message>
    <message>
        <source>Save as Recipe…</source>
        <translation>レシピとして保存…</translation>
    </message>
    <message>
        <source>Save everything that was done to the tree, so that it can be done again.</source>
        <translation>木に対して行ったことを書き留めて、もう一度行えるようにします。</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>ねじり</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands.</source>
        <translation>枝に沿って、または枝を回すようにドラッグすると、ストランドがねじれます。</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>新しい芽</translation>
    </message>
    <message>
        <source>Tap old wood: buds break through its bark, and grow into branches.</source>
        <translation>古い枝や幹をタップすると、樹皮を破って芽が出て、枝に育ちます。</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>断面形</translation>
    </message>
    <message>
        <source>Tap a branch to see its cross-section, and draw its shape.</source>
        <translation>枝をタップすると断面が表示され、その形を描けます。</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>勢いづけ</translation>
    </message>
    <message>
        <source>Press a branch and hold: it alone grows until you let go.</source>
        <translation>枝を押し続けると、離すまでその枝だけが成長します。</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Press a branch and hold: its youngest growth disappears, step by step.</source>
        <translation>枝を押し続けると、新しく伸びた部分から 1 ステップずつ消えていきます。</translation>
    </message>
    <message>
        <source>Show the strands of the wood as lines, each branch in its own colour.</source>
        <translation>木を構成するストランドを線で表示します。枝ごとに色が変わります。</translation>
    </message>
    <message>
        <source>Strand Lines</source>
        <translation>ストランドの線</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>スケッチ</translation>
    </message>
    <message>
        <source>Draw the trunk and its branches as lines, then give the drawing depth.</source>
        <translation>幹と枝を線で描き、絵に奥行きを与えます。</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>増やす</translation>
    </message>
    <message>
        <source>Tap a branch: it gets more branches like those it carries, or passes on to others what it carries.</source>
        <translation>枝をタップすると、付いている枝が増えるか、ほかの枝に広まります。</translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation>再現</translation>
    </message>
    <message>
        <source>Draw a trunk and a silhouette: the same tree takes on this new shape.</source>
        <translation>幹と輪郭を描くと、同じ木がその新しい姿になります。</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移す</translation>
    </message>
    <message>
        <source>Drag a branch along the wood, around it, or to other wood, with all it carries.</source>
        <translation>枝を、木に沿って、木のまわりに、または別の木へ、付いているものごとドラッグします。</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>画像を保存…</translation>
    </message>
    <message>
        <source>Save a picture of the tree, in any size and from any side.</source>
        <translation>木の画像を、好きな大きさと向きで保存します。</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>画像をコピー</translation>
    </message>
    <message>
        <source>Copy a picture of the tree, as it is shown now, to the clipboard.</source>
        <translation>表示されているとおりの木の画像をクリップボードに入れます。</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>これに似た別の木</translation>
    </message>
    <message>
        <source>See six other trees that the same strokes could have made, and take one.</source>
        <translation>同じストロークから別の偶然で育つ 6 本の木を見て、1 本を選びます。</translation>
    </message>
    <message>
        <source>Person for Scale</source>
        <translation>大きさを比べる人</translation>
    </message>
    <message>
        <source>Show a person beside the tree, and how long a metre is.</source>
        <translation>木の横に人と、1 メートルの長さを表示します。</translation>
    </message>
    <message>
        <source>Tool Ring</source>
        <translation>ツールリング</translation>
    </message>
    <message>
        <source>Tools, undo and brush size in a ring around the pointer. Hold the key, and let go over the one you want.</source>
        <translation>ポインタのまわりに、ツール、元に戻す、ブラシの大きさを表示します。キーを押したまま、選ぶものの上で離します。</translation>
    </message>
    <message>
        <source>Second View</source>
        <translation>第 2 ビュー</translation>
    </message>
    <message>
        <source>Show the tree from the right, in a corner of the window; draw there, too, to give it depth.</source>
        <translation>隅に、右から見た木を表示します。そこにも描くと、木に奥行きが出ます。</translation>
    </message>
    <message>
        <source>Report a Problem…</source>
        <translation>問題を報告…</translation>
    </message>
    <message>
        <source>Copy what a report should have: version, graphics and log.</source>
        <translation>報告に必要な内容（バージョン、グラフィックス、ログ）をコピーします。</translation>
    </message>
    <message>
        <source>Bring Trees Back…</source>
        <translation>木を復元…</translation>
    </message>
    <message>
        <source>See the trees that were not saved when Espalier ended.</source>
        <translation>Espalier の終了時に保存されていなかった木を見ます。</translation>
    </message>
</context>
<context>
    <name>AddBudsTool</name>
    <message>
        <source>Tap old wood to let buds break through its bark; they grow into branches</source>
        <translation>古い枝や幹をタップすると、樹皮を破って芽が出ます。芽は枝に育ちます</translation>
    </message>
</context>
<context>
    <name>BendTool</name>
    <message>
        <source>Pull a branch to bend it; or tap where the bend begins, then where to hold it</source>
        <translation>枝を引いて曲げます。タップで根元を、続けて支える場所をピンで留めます</translation>
    </message>
</context>
<context>
    <name>BrushTool</name>
    <message>
        <source>Drag to brush a tree into being; begin at a branch to draw at its depth</source>
        <translation>ドラッグして木を描きます。枝から始めると、その奥行きで続きます</translation>
    </message>
    <message>
        <source>No bud sees this place: keep drawing, or begin at a branch</source>
        <translation>この場所が見える芽がありません。さらに描くか、枝から始めてください</translation>
    </message>
    <message>
        <source>Only the chosen bud grows, and it does not see this place</source>
        <translation>選んだ芽だけが伸びますが、その芽からはこの場所が見えません</translation>
    </message>
</context>
<context>
    <name>ClearTool</name>
    <message>
        <source>buds may shoot</source>
        <translation>芽が伸びられます</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: below your hand, nothing shoots any more</source>
        <translation>幹や枝に沿って上へドラッグすると、手より下からは何も伸びなくなります</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>--strict: nothing is written, because some operations did not find everything that they name</source>
        <translation>--strict: することがないか、指定したものがすべては見つからない操作があるため、何も書き出しません</translation>
    </message>
    <message>
        <source>--size needs WIDTHxHEIGHT of up to %1 pixels each, not &quot;%2&quot;</source>
        <translation>--size は「幅x高さ」で、それぞれ %1 ピクセルまでです (&quot;%2&quot; は使えません)</translation>
    </message>
    <message>
        <source>%1: the suffix of an output says its format, and is one of .espalier .%2</source>
        <translation>%1: 出力の形式は拡張子で決まります。使えるのは .espalier .%2 です</translation>
    </message>
    <message>
        <source>--camera needs front, side, top or three-quarter, not &quot;%1&quot;</source>
        <translation>--camera は front、side、top、three-quarter のいずれかです (&quot;%1&quot; は使えません)</translation>
    </message>
    <message>
        <source>--threads needs a number from 1 to %1, not &quot;%2&quot;</source>
        <translation>--threads は 1 から %1 までの数値です (&quot;%2&quot; は使えません)</translation>
    </message>
    <message>
        <source>--seed needs a whole number from 0 to 18446744073709551615, not &quot;%1&quot;</source>
        <translation>--seed は 0 から 18446744073709551615 までの整数です (&quot;%1&quot; は使えません)</translation>
    </message>
    <message>
        <source>%1 has no option %2</source>
        <translation>%1 に %2 というオプションはありません</translation>
    </message>
    <message>
        <source>%1 takes no value</source>
        <translation>%1 に値は付けられません</translation>
    </message>
    <message>
        <source>%1 needs a value after it</source>
        <translation>%1 の後に値が必要です</translation>
    </message>
    <message>
        <source>--transparent needs --png FILE</source>
        <translation>--transparent には --png FILE が必要です</translation>
    </message>
    <message>
        <source>--ground-shadow needs --transparent</source>
        <translation>--ground-shadow には --transparent が必要です</translation>
    </message>
    <message>
        <source>%1 needs one project</source>
        <translation>%1 にはプロジェクトを 1 つ指定します</translation>
    </message>
    <message>
        <source>render needs --png FILE</source>
        <translation>render には --png FILE が必要です</translation>
    </message>
    <message>
        <source>info needs one file</source>
        <translation>info にはファイルを 1 つ指定します</translation>
    </message>
    <message>
        <source>a window opens only one file; &quot;%1&quot; is one too many</source>
        <translation>1 つのウィンドウで開けるファイルは 1 つです。&quot;%1&quot; は余分です</translation>
    </message>
    <message>
        <source>%1: its history, played again, gives a different tree from the one it holds</source>
        <translation>%1: 履歴をもう一度再生すると、保存されている木と違う木になります</translation>
    </message>
    <message>
        <source>replay needs at least one recipe or project</source>
        <translation>replay にはレシピかプロジェクトが少なくとも 1 つ必要です</translation>
    </message>
    <message>
        <source>import needs one skeleton and -o OUT</source>
        <translation>import にはスケルトン 1 つと -o OUT が必要です</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>これ以上パラメーターの組を加える余地がありません</translation>
    </message>
    <message>
        <source>--set needs group.name=value, not &quot;%1&quot;</source>
        <translation>--set には group.name=value の形で指定します (&quot;%1&quot; は使えません)</translation>
    </message>
    <message>
        <source>--set: there is no parameter &quot;%1&quot;</source>
        <translation>--set に &quot;%1&quot; というパラメーターはありません</translation>
    </message>
    <message>
        <source>--fibres needs --png FILE</source>
        <translation>--fibres には --png ファイル が必要です</translation>
    </message>
    <message>
        <source>--index needs a whole number from 0, not &quot;%1&quot;</source>
        <translation>--index には 0 以上の整数が必要です。「%1」は使えません</translation>
    </message>
    <message>
        <source>sketch needs at least one drawing</source>
        <translation>sketch には絵が一つ以上必要です</translation>
    </message>
    <message>
        <source>it has more than %1 strokes</source>
        <translation>線が %1 本を超えています</translation>
    </message>
    <message>
        <source>it has no line that can be a trunk, and no crown</source>
        <translation>幹になれる線も樹冠もありません</translation>
    </message>
    <message>
        <source>--vary needs a whole number from 0, and after a colon an amount from %1 to 1 if you like, such as 7 or 7:0.5, not &quot;%2&quot;</source>
        <translation>--vary には 0 以上の整数と、必要ならコロンの後に %1 から 1 までの度合いが必要です（7 や 7:0.5 など）。「%2」は使えません</translation>
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
        <translation>Espalier: ブラシで木を描きます。

espalier [PROJECT]
    ウィンドウを開きます。

espalier --demo [RECIPE]
    ウィンドウを開いて木を 1 本描きます。その木は自由に使えます。

espalier replay RECIPE|PROJECT... [-o OUT]... [--png FILE] [--size WxH]
                [--camera front|side|top|three-quarter]
                [--transparent [--ground-shadow]] [--fibres]
                [--stats FILE] [--profiles FILE] [--threads N] [--seed N]
                [--strict] [--vary SEED[:AMOUNT]] [--set GROUP.NAME=VALUE]...
    ウィンドウなしでレシピを実行し、結果を書き出します。
    プロジェクトのときは、その木に対して行ったことをすべてもう一度行います。
    レシピが複数あるときは、それぞれが前の木の続きになります。シードは
    最初のレシピのものを使い、パラメーターは各レシピの最初に切り替わります。
    --profiles: 各断面でのストランドの位置を JSON で書き出します。
    操作の対象が木に見つからないときは、それを表示します。--strict を付けると
    エラーになり、何も書き出しません。
    --set は、レシピの内容にかかわらず、再生全体を通してパラメーターの値を
    決めます: --set growth.shedding=0.1 --set leaves.visible=false
    角度の単位は度です。
    --vary は木の角度と長さを少しずらします。度合いは 0.3、または 1 まで。
    数を変えると、森で隣に立つ別の木になります。

espalier import SKELETON.csv -o OUT...
    計測した木から木を作ります。各行は id、parent、両端、半径です。

espalier sketch DRAWING... [--index N] [--front-only] [-o OUT]... [--png FILE]
                [--size WxH] [--camera ...] [--stats FILE] [--seed N]
                [--set GROUP.NAME=VALUE]...
    描かれた絵から木を作ります。線は枝、小さな輪は葉、大きな輪は木が育って
    満たす樹冠です。絵は SVG か Quick, Draw! の .ndjson で、--index はその行を
    0 から数えて選びます。複数の絵は前の絵に重ねて描かれます。
    --front-only: 絵を横からもう一度置かず、奥行きを一度だけ与えます。

espalier export PROJECT [-o OUT]... [--vary SEED[:AMOUNT]]
                [--set GROUP.NAME=VALUE]...
    プロジェクトをほかの形式で書き出します。--vary と --set は書き出す
    内容だけを変え、プロジェクトはそのまま残ります。

espalier render PROJECT --png FILE [--size WxH] [--camera ...]
                [--transparent [--ground-shadow]] [--fibres]
                [--vary SEED[:AMOUNT]] [--set GROUP.NAME=VALUE]...
    画像を保存します。ディスプレイが必要ですが、仮想のものでかまいません。
    --transparent: 木だけを、ストレートアルファで保存します。
    --ground-shadow を付けると、影が半透明の黒で残ります。
    --fibres: 木のストランドを線で表示します。

espalier info FILE
    プロジェクトの内容を JSON で表示します。

espalier --help, --version

OUT の拡張子は .espalier (プロジェクト) か、次の形式のいずれかです。
%1終了コードは、完了すると 0、コマンドラインの誤りは 2、入力が読めないか
正しくないときは 3、出力を書き込めないときは 4 です。
</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Bend</source>
        <translation>曲げ</translation>
    </message>
    <message>
        <source>Brush Stroke</source>
        <translation>ブラシストローク</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>成長</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>剪定</translation>
    </message>
    <message>
        <source>Change Parameters</source>
        <translation>パラメーターの変更</translation>
    </message>
    <message>
        <source>Go to Another Time</source>
        <translation>時間の移動</translation>
    </message>
    <message>
        <source>Remove Width</source>
        <translation>太さの解除</translation>
    </message>
    <message>
        <source>Set Width</source>
        <translation>太さ</translation>
    </message>
    <message>
        <source>a sketch can only become a tree where nothing has grown</source>
        <translation>スケッチは、まだ何も育っていないところでだけ木になります</translation>
    </message>
    <message>
        <source>no stroke of the sketch is a branch</source>
        <translation>スケッチの線のどれも枝になりません</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>スケッチ</translation>
    </message>
    <message>
        <source>a skeleton can only be imported where nothing has grown</source>
        <translation>スケルトンは、まだ何も育っていないところにだけ読み込めます</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>読み込み</translation>
    </message>
    <message>
        <source>New Buds</source>
        <translation>新しい芽</translation>
    </message>
    <message>
        <source>Invigorate</source>
        <translation>勢いづけ</translation>
    </message>
    <message>
        <source>Draw Profile</source>
        <translation>断面形</translation>
    </message>
    <message>
        <source>Blend Profiles</source>
        <translation>断面形の補間</translation>
    </message>
    <message>
        <source>Remove Profile</source>
        <translation>断面形の解除</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>ねじり</translation>
    </message>
    <message>
        <source>Remove Twist</source>
        <translation>ねじりの解除</translation>
    </message>
    <message>
        <source>Give Depth</source>
        <translation>奥行きを与える</translation>
    </message>
    <message>
        <source>Draw Branch</source>
        <translation>枝を描く</translation>
    </message>
    <message>
        <source>Multiply Branch</source>
        <translation>枝を増やす</translation>
    </message>
    <message>
        <source>Place Leaf</source>
        <translation>葉を置く</translation>
    </message>
    <message>
        <source>Arrange Leaves</source>
        <translation>葉を配置</translation>
    </message>
    <message>
        <source>Pass On Branch</source>
        <translation>枝を広める</translation>
    </message>
    <message>
        <source>the new trunk must be an open line</source>
        <translation>新しい幹は開いた線でなければなりません</translation>
    </message>
    <message>
        <source>Reshape Tree</source>
        <translation>木を再現</translation>
    </message>
    <message>
        <source>Vary Tree</source>
        <translation>木を変化させる</translation>
    </message>
    <message>
        <source>Move Branch</source>
        <translation>枝を移す</translation>
    </message>
    <message numerus="yes">
        <source>Brush Stroke, %n branches</source>
        <translation>
            <numerusform>ブラシ、枝 %n 本</numerusform>
        </translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>Thin Out</source>
        <translation>間引き</translation>
    </message>
    <message>
        <source>Keep Clear</source>
        <translation>下枝なし</translation>
    </message>
    <message>
        <source>Let Buds Shoot</source>
        <translation>芽を伸ばす</translation>
    </message>
    <message numerus="yes">
        <source>Prune, %n branches</source>
        <translation>
            <numerusform>剪定、枝 %n 本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Grow, %n steps</source>
        <translation>
            <numerusform>成長、%n ステップ</numerusform>
        </translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>投げ縄</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>育て直し</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>外形を除く</translation>
    </message>
    <message>
        <source>Earlier Steps</source>
        <translation>以前の操作</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Tap a branch to cut it off, or draw across the branches to cut</source>
        <translation>枝をタップして切るか、切る枝を横切るように描きます</translation>
    </message>
</context>
<context>
    <name>Display</name>
    <message>
        <source>there is no display (DISPLAY is not set); xvfb-run provides a virtual one</source>
        <translation>ディスプレイがありません (DISPLAY が未設定です)。xvfb-run で仮想ディスプレイを用意できます</translation>
    </message>
    <message>
        <source>the display %1 does not answer</source>
        <translation>ディスプレイ %1 が応答しません</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>it is not an SVG</source>
        <translation>SVG ではありません</translation>
    </message>
    <message>
        <source>it has no drawing %1</source>
        <translation>%1 番の絵がありません</translation>
    </message>
    <message>
        <source>a stroke has more x than y values, or fewer</source>
        <translation>線の x と y の数が違います</translation>
    </message>
    <message>
        <source>a stroke has a point that is not a number</source>
        <translation>線に数でない点があります</translation>
    </message>
    <message>
        <source>it has no strokes</source>
        <translation>線がありません</translation>
    </message>
    <message>
        <source>it has more than %1 points</source>
        <translation>点が %1 個を超えています</translation>
    </message>
</context>
<context>
    <name>Envelope</name>
    <message>
        <source>There is no lasso stroke.</source>
        <translation>投げ縄のストロークがありません。</translation>
    </message>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>投げ縄の描画面が正しくありません。</translation>
    </message>
    <message>
        <source>The lasso is too small to enclose anything.</source>
        <translation>投げ縄が小さすぎて何も囲めません。</translation>
    </message>
    <message>
        <source>The lasso encloses no area.</source>
        <translation>投げ縄が何も囲んでいません。</translation>
    </message>
    <message>
        <source>The lasso is too small for its distance from the origin.</source>
        <translation>原点からの距離に対して投げ縄が小さすぎます。</translation>
    </message>
</context>
<context>
    <name>EraserTool</name>
    <message>
        <source>Brush over twigs to thin them evenly; those to be removed turn red</source>
        <translation>小枝の上をなぞると、むらなく一部が取れます。取れるものは赤くなります</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are</source>
        <translation>小枝や葉の上をなぞると、樹冠の奥にあるものまで取り除けます</translation>
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
        <translation>バイナリ glTF</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Skeleton as a table</source>
        <translation>骨格の表</translation>
    </message>
</context>
<context>
    <name>Exporter</name>
    <message>
        <source>the meshes could not be written: %1</source>
        <translation>メッシュを書き出せませんでした: %1</translation>
    </message>
    <message>
        <source>“.%1” is not an export format; the formats are %2</source>
        <translation>「.%1」には書き出せません。使える形式は %2 です</translation>
    </message>
    <message>
        <source>The export was cancelled.</source>
        <translation>書き出しをキャンセルしました。</translation>
    </message>
    <message>
        <source>there are too many files with similar names in this folder; choose another name or another folder</source>
        <translation>同じフォルダーに似た名前のファイルが多すぎます。別の名前か別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>another program made this file during the export; export again, and another name will be chosen</source>
        <translation>書き出し中に別のプログラムがこのファイルを作りました。もう一度書き出すと、別の名前になります</translation>
    </message>
    <message>
        <source>the tree takes more than the 4 GB that such a file can hold; export less detail</source>
        <translation>木が、この形式のファイルに収まる 4 GB を超えています。細部を減らして書き出してください</translation>
    </message>
    <message>
        <source>the tree takes more than such a file can hold; export less detail</source>
        <translation>木がこの形式のファイルに収まりません。細かさを下げて書き出してください</translation>
    </message>
</context>
<context>
    <name>FbxRepair</name>
    <message>
        <source>this is not a valid binary FBX file</source>
        <translation>正しいバイナリ FBX ファイルではありません</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Trees (*.espalier)</source>
        <translation>木 (*.espalier)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Espalier</source>
        <translation>Espalier</translation>
    </message>
    <message>
        <source>%1 is still growing. What has grown so far is not saved.</source>
        <translation>%1 はまだ成長中です。ここまでに育った分は保存されていません。</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 には保存していない変更があります。</translation>
    </message>
    <message>
        <source>%1 has been changed by another window or program since it was opened or saved here. Overwriting it loses those changes.</source>
        <translation>%1 は、ここで開くか保存した後に、別のウィンドウかプログラムで変更されました。上書きすると、その変更は失われます。</translation>
    </message>
    <message>
        <source>Save as Recipe</source>
        <translation>レシピとして保存</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>レシピ (*.json)</translation>
    </message>
    <message>
        <source>Trees, recipes and measured skeletons (*.espalier *.json *.csv);;Trees (*.espalier);;Recipes (*.json);;Skeletons (*.csv);;All files (*)</source>
        <translation>木、レシピ、計測したスケルトン (*.espalier *.json *.csv);;木 (*.espalier);;レシピ (*.json);;スケルトン (*.csv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save As…</source>
        <translation>名前を付けて保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>上書き(&amp;O)</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>%1 バイトを超えています</translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>%1 MB を超えています</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>これはフォルダーです</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file</source>
        <translation>これはファイルではなく、デバイスまたはパイプです</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>読み込めません: %1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>このファイルはありません</translation>
    </message>
</context>
<context>
    <name>FileWriter</name>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>フォルダー %1 がありません</translation>
    </message>
    <message>
        <source>%1 is not a folder</source>
        <translation>%1 はフォルダーではありません</translation>
    </message>
    <message>
        <source>a folder with this name already exists</source>
        <translation>同じ名前のフォルダーがあります</translation>
    </message>
    <message>
        <source>you may not write into the folder %1</source>
        <translation>フォルダー %1 に書き込む権限がありません</translation>
    </message>
    <message>
        <source>you may not change this file</source>
        <translation>このファイルを変更する権限がありません</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>ディスクがいっぱいです</translation>
    </message>
    <message>
        <source>your disk quota is used up</source>
        <translation>ディスクの割り当て分がいっぱいです</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>ディスクは読み取り専用です</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>ここに書き込む権限がありません</translation>
    </message>
    <message>
        <source>the file is too large for this disk</source>
        <translation>ファイルがこのディスクには大きすぎます</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>ディスクに障害があります</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>名前が長すぎます</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>開いているファイルが多すぎます</translation>
    </message>
    <message>
        <source>the system does not say why</source>
        <translation>システムが理由を示していません</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>ファイルには名前が必要です</translation>
    </message>
    <message>
        <source>it is a link that leads back to itself</source>
        <translation>自分自身に戻るリンクです</translation>
    </message>
    <message>
        <source>no program reads from this pipe</source>
        <translation>このパイプを読むプログラムがありません</translation>
    </message>
    <message>
        <source>another program has changed it</source>
        <translation>別のプログラムが変更しました</translation>
    </message>
</context>
<context>
    <name>GrowTool</name>
    <message>
        <source>Press and hold: the tree grows until you let go</source>
        <translation>押している間、木が成長します。</translation>
    </message>
</context>
<context>
    <name>ImageFile</name>
    <message>
        <source>it is larger than %1 MB</source>
        <translation>%1 MB を超えています</translation>
    </message>
    <message>
        <source>it is neither a PNG nor a JPEG image</source>
        <translation>PNG 画像でも JPEG 画像でもありません</translation>
    </message>
    <message>
        <source>the image is broken</source>
        <translation>画像が壊れています</translation>
    </message>
    <message>
        <source>it has %1 × %2 pixels; %3 along an edge is the most</source>
        <translation>%1 × %2 ピクセルあります。1 辺は %3 ピクセルまでです</translation>
    </message>
    <message>
        <source>it is too small: only %1 × %2 pixels</source>
        <translation>%1 × %2 ピクセルしかありません</translation>
    </message>
    <message>
        <source>it is not a picture that can be read</source>
        <translation>読み込める画像ではありません</translation>
    </message>
</context>
<context>
    <name>ImageStructure</name>
    <message>
        <source>the file is not whole</source>
        <translation>ファイルが途中で切れています</translation>
    </message>
    <message>
        <source>it is made so that unpacking it would take very long</source>
        <translation>展開に非常に時間がかかるように作られています</translation>
    </message>
</context>
<context>
    <name>InvigorateTool</name>
    <message>
        <source>Press a branch and hold: it grows until you let go</source>
        <translation>枝を押し続けると、離すまで成長します</translation>
    </message>
</context>
<context>
    <name>JournalCheck</name>
    <message>
        <source>it changes nothing</source>
        <translation>何も変更していません</translation>
    </message>
    <message>
        <source>it places a leaf that is not there</source>
        <translation>存在しない葉を置いています</translation>
    </message>
    <message>
        <source>it places a leaf at another time</source>
        <translation>別の時点に葉を置いています</translation>
    </message>
    <message>
        <source>it creates an internode whose parameters are not there</source>
        <translation>パラメーターのない節間を生じています</translation>
    </message>
    <message>
        <source>its steps do not follow on from those around it</source>
        <translation>ステップが前後とつながりません</translation>
    </message>
    <message>
        <source>its parameters do not follow on from those of the steps around it</source>
        <translation>パラメーターが前後とつながりません</translation>
    </message>
    <message>
        <source>its births are out of order</source>
        <translation>節間の生まれる順序が正しくありません</translation>
    </message>
    <message>
        <source>it records the death of an internode that did not die</source>
        <translation>枯れていない節間が枯れたことになっています</translation>
    </message>
    <message>
        <source>it creates an internode that is not there</source>
        <translation>存在しない節間が生まれています</translation>
    </message>
    <message>
        <source>it creates an internode at another time</source>
        <translation>節間が別の時点で生まれています</translation>
    </message>
    <message>
        <source>before it, an internode would live on a dead one</source>
        <translation>その前の時点で、枯れた節間の上に節間が生きています</translation>
    </message>
    <message>
        <source>before it, two internodes would continue the same axis</source>
        <translation>その前の時点で、2 つの節間が同じ軸を継いでいます</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>履歴のステップ %1</translation>
    </message>
    <message>
        <source>it places a leaf on an internode that is not there</source>
        <translation>存在しない節間に葉が配置されています</translation>
    </message>
    <message>
        <source>it changes an envelope in a way that is not possible</source>
        <translation>外形がありえない形に変えられています</translation>
    </message>
    <message>
        <source>something is set before it on what it brings</source>
        <translation>その前の時点で、まだ加わっていないものに何かが設定されています</translation>
    </message>
    <message>
        <source>the beginning of the history</source>
        <translation>履歴の始まり</translation>
    </message>
    <message>
        <source>it changes “%1”, which never changes</source>
        <translation>変わるはずのない「%1」が変えられています</translation>
    </message>
    <message>
        <source>it changes “%1” of a row that was not there</source>
        <translation>存在しなかった行の「%1」が変えられています</translation>
    </message>
    <message>
        <source>it changes “%1” in a way that is not possible</source>
        <translation>「%1」がありえない値に変えられています</translation>
    </message>
    <message>
        <source>it refers to strokes or profiles that are not there</source>
        <translation>存在しないストロークか断面形を加えています</translation>
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
        <translation>%1 MB を超えています</translation>
    </message>
    <message>
        <source>it holds too many values</source>
        <translation>値が多すぎます</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation>正しい JSON ではありません: %1</translation>
    </message>
    <message>
        <source>a JSON object is expected</source>
        <translation>JSON オブジェクトが必要です</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected</source>
        <translation>%1 から %2 までの整数が必要です</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected</source>
        <translation>%1 から %2 までの数値が必要です</translation>
    </message>
    <message>
        <source>a string is expected</source>
        <translation>文字列が必要です</translation>
    </message>
    <message>
        <source>a whole number of at most 64 bits is expected; from 2^53 on, write it as a string of digits</source>
        <translation>64 ビット以内の整数が必要です。2^53 以上は数字の文字列で書きます</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>オブジェクトが必要です</translation>
    </message>
    <message>
        <source>an array is expected</source>
        <translation>配列が必要です</translation>
    </message>
    <message>
        <source>“%1” is not known here</source>
        <translation>「%1」はここでは使えません</translation>
    </message>
</context>
<context>
    <name>Lasso</name>
    <message>
        <source>The lasso&apos;s drawing plane is not valid.</source>
        <translation>投げ縄の描画面が正しくありません。</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>投げ縄</translation>
    </message>
    <message>
        <source>There is no envelope to regrow.</source>
        <translation>再成長させる外形がありません。</translation>
    </message>
    <message>
        <source>Regrow</source>
        <translation>再成長</translation>
    </message>
    <message>
        <source>Remove Envelope</source>
        <translation>外形の削除</translation>
    </message>
    <message>
        <source>There is no envelope to fill.</source>
        <translation>満たす外形がありません。</translation>
    </message>
    <message>
        <source>There is no room for more parameter sets.</source>
        <translation>これ以上パラメーターの組を加える余地がありません。</translation>
    </message>
    <message>
        <source>There is no room for more lassos.</source>
        <translation>これ以上の投げ縄は入りません。</translation>
    </message>
</context>
<context>
    <name>LassoTool</name>
    <message>
        <source>Draw the silhouette of a crown; the tree fills it. Begin at a branch to draw at its depth</source>
        <translation>樹冠の輪郭を描くと、木がそれを満たします。枝から始めると、その奥行きに描きます</translation>
    </message>
</context>
<context>
    <name>LeafChoices</name>
    <message>
        <source>One leaf at a time along the branch, each turned from the one before as the second is from the first.</source>
        <translation>枝に沿って葉を一枚ずつ。どれも、二枚目が一枚目に対して回った角度だけ回ります。</translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>A tree needs a name.</source>
        <translation>木には名前が必要です。</translation>
    </message>
    <message>
        <source>A name cannot begin with a full stop.</source>
        <translation>名前の先頭にピリオドは使えません。</translation>
    </message>
    <message>
        <source>A name cannot contain any of / \ : * ? &quot; &lt; &gt; |.</source>
        <translation>名前に次の文字は使えません: / \ : * ? &quot; &lt; &gt; |</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>名前が長すぎます。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>フォルダー %1 を作成できません。</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>木</translation>
    </message>
    <message>
        <source>There is already a tree named %1.</source>
        <translation>%1 という名前の木はすでにあります。</translation>
    </message>
    <message>
        <source>%1 cannot be renamed: %2</source>
        <translation>%1 の名前を変更できません: %2</translation>
    </message>
    <message>
        <source>%1 cannot be copied: %2</source>
        <translation>%1 をコピーできません: %2</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 はもうありません。</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash: %2</source>
        <translation>%1 をゴミ箱に移動できません: %2</translation>
    </message>
    <message>
        <source>There is another tree named %1 now.</source>
        <translation>%1 という名前の別の木ができています。</translation>
    </message>
    <message>
        <source>%1 cannot be taken out of the trash: %2</source>
        <translation>%1 をごみ箱から戻せません：%2</translation>
    </message>
</context>
<context>
    <name>MoveTool</name>
    <message>
        <source>a trunk stays where it stands; drag a branch</source>
        <translation>幹はその場に立ったままです。枝をつかんでください</translation>
    </message>
    <message>
        <source>Drag a branch along the wood or around it; drag its base to other wood, its tip to scale it</source>
        <translation>枝を木に沿って、または木のまわりにドラッグします。付け根なら別の木へ、先なら大きさが変わります</translation>
    </message>
</context>
<context>
    <name>MultiplyTool</name>
    <message>
        <source>Tap a branch: it gets one more branch like those that it carries</source>
        <translation>枝をタップすると、付いている枝に似た枝が一本増えます</translation>
    </message>
    <message>
        <source>Tap a branch: the others get what it carries; drag from it across branches to choose which of them get it</source>
        <translation>枝をタップすると、ほかの枝に広がります。一部の枝だけなら、その枝から相手の枝の上をドラッグします</translation>
    </message>
</context>
<context>
    <name>OffscreenRenderer</name>
    <message>
        <source>A picture cannot be drawn, because there is no display that offers OpenGL 3.3; a virtual one (Xvfb) will do.</source>
        <translation>OpenGL 3.3 を使えるディスプレイがないため、画像を描けません。仮想ディスプレイ (Xvfb) でもかまいません。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large; %3 along an edge is the most.</source>
        <translation>%1 × %2 ピクセルの画像は大きすぎます。1 辺は %3 までです。</translation>
    </message>
</context>
<context>
    <name>Outputs</name>
    <message>
        <source>%1: the picture could not be compressed</source>
        <translation>%1: 画像を圧縮できませんでした</translation>
    </message>
</context>
<context>
    <name>OwnTextures</name>
    <message>
        <source>%1: the leaf cannot be told apart from its background; the image needs a transparent or a plain background</source>
        <translation>%1: 葉とその背景を見分けられません。透明か無地の背景の画像が必要です</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Backdrop</source>
        <translation>背後</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Ground below the tree, with the tree&apos;s shadow.</source>
        <translation>木の下の地面です。木の影が落ちます。</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>グリッド</translation>
    </message>
    <message>
        <source>Lines on the ground, a metre apart.</source>
        <translation>地面に 1 m 間隔で引いた線です。</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>影</translation>
    </message>
    <message>
        <source>Shadows of the sun.</source>
        <translation>太陽による影です。</translation>
    </message>
    <message>
        <source>Show the sun</source>
        <translation>太陽を表示</translation>
    </message>
    <message>
        <source>Show the sun as a ball that you can drag around the tree.</source>
        <translation>太陽を球で表示します。木のまわりをドラッグして動かせます。</translation>
    </message>
    <message>
        <source>Pin the sun</source>
        <translation>太陽を固定</translation>
    </message>
    <message>
        <source>The sun stays where it is on the screen when the tree is turned; otherwise it turns with the tree.</source>
        <translation>木を回しても太陽は画面上の位置にとどまります。オフでは木と一緒に回ります。</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Where the sun stands: 0° in front of the tree, 90° to its right; for a pinned sun, as seen on the screen.</source>
        <translation>太陽の方向です。0° は木の手前、90° は右。固定した太陽では、見ている向きが基準です。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>How high the sun stands above the horizon.</source>
        <translation>地平線からの太陽の高さです。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How opaque the picture is.</source>
        <translation>下絵がどれだけ濃く見えるかです。</translation>
    </message>
    <message>
        <source>How tall the picture is.</source>
        <translation>下絵の高さです。</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>右へ</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is to the right of the seedling.</source>
        <translation>苗から見た下絵の中心の左右位置です。</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>How far the picture&apos;s middle is above the seedling.</source>
        <translation>苗から見た下絵の中心の高さです。</translation>
    </message>
    <message>
        <source>studio</source>
        <translation>スタジオ</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>地平線</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>無地</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>グラデーション</translation>
    </message>
    <message>
        <source>Set-point angle</source>
        <translation>設定角</translation>
    </message>
    <message>
        <source>The direction that shoots turn to: 0° is up, 90° level, and more makes them weep.</source>
        <translation>シュートの向かう角度です。0° は上、90° は水平、それ以上では枝垂れます。</translation>
    </message>
    <message>
        <source>Gravitropic set-point angle: orthotropic at 0°, plagiotropic near 90°, positively gravitropic beyond.</source>
        <translation>重力屈性の設定角。0° で直立性、90° 付近で斜生性、それを超えると正の重力屈性。</translation>
    </message>
    <message>
        <source>Buds above and below</source>
        <translation>上下の芽</translation>
    </message>
    <message>
        <source>Vigour of the buds on the upper and lower sides of a leaning branch.</source>
        <translation>傾いた枝の上側と下側の芽の勢いです。</translation>
    </message>
    <message>
        <source>Vertical semi-axis of the gravimorphic ellipse.</source>
        <translation>重力形態形成の楕円の垂直半軸。</translation>
    </message>
    <message>
        <source>Buds on the sides</source>
        <translation>横の芽</translation>
    </message>
    <message>
        <source>Vigour of the buds on the sides of a leaning branch.</source>
        <translation>傾いた枝の横側の芽の勢いです。</translation>
    </message>
    <message>
        <source>Semi-axis parallel to the ground; if it is the greater one, amphitony.</source>
        <translation>地面に平行な半軸。こちらが大きいと側方優勢 (アンフィトニー)。</translation>
    </message>
    <message>
        <source>Upper or lower buds</source>
        <translation>上下の芽の差</translation>
    </message>
    <message>
        <source>Above 0 the buds on the upper side are stronger, as in fruit trees; below 0 those on the lower side.</source>
        <translation>0 より上では果樹のように上側の芽が、0 より下では下側の芽が強くなります。</translation>
    </message>
    <message>
        <source>Displacement of the ellipse: epitony above 0, hypotony below.</source>
        <translation>楕円のずれ。0 より上で上側優勢 (エピトニー)、下で下側優勢 (ヒポトニー)。</translation>
    </message>
    <message>
        <source>Branching angle</source>
        <translation>分枝角</translation>
    </message>
    <message>
        <source>Between a branch and the branches that grow from it.</source>
        <translation>枝と、そこから分かれる枝との間の角度です。</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral bud on its axis.</source>
        <translation>軸に対する側芽の着生角度。</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>屈折</translation>
    </message>
    <message>
        <source>How far an axis turns away from a branch that it bears: 0 keeps it straight, more makes it zigzag.</source>
        <translation>枝を出すとき、軸が反対側へどれだけ向きを変えるかです。0 ではまっすぐ、大きいほどジグザグになります。</translation>
    </message>
    <message>
        <source>How far the main axis gives way to a lateral: a tendency to sympodial growth.</source>
        <translation>主軸が側枝に譲る。仮軸分枝に近づく。</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>直進性</translation>
    </message>
    <message>
        <source>How much a shoot keeps the direction that it has.</source>
        <translation>シュートが今の向きをどれだけ保つかです。</translation>
    </message>
    <message>
        <source>Weight of the heading H of the axis.</source>
        <translation>軸の進行方向 H の重み。</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>屈性</translation>
    </message>
    <message>
        <source>How much a shoot turns towards the set-point angle.</source>
        <translation>シュートがどれだけ設定角へ向かうかです。</translation>
    </message>
    <message>
        <source>Weight of gravitropism T.</source>
        <translation>重力屈性 T の重み。</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>空き空間</translation>
    </message>
    <message>
        <source>How much a shoot turns towards where there is room.</source>
        <translation>シュートがどれだけ空きのある方へ向かうかです。</translation>
    </message>
    <message>
        <source>Weight of the environment E: the mean direction of the free space that a bud perceives.</source>
        <translation>環境 E の重み。芽が知覚する空き空間の平均方向。</translation>
    </message>
    <message>
        <source>Occupied radius</source>
        <translation>占有半径</translation>
    </message>
    <message>
        <source>Space around each bud that nothing else grows into, in internodes. More makes an airier crown.</source>
        <translation>芽のまわりの、ほかの枝が入り込まない空間です (節間単位)。大きいほど樹冠が透きます。</translation>
    </message>
    <message>
        <source>Radius of the zone of occupancy.</source>
        <translation>占有領域の半径。</translation>
    </message>
    <message>
        <source>Sight</source>
        <translation>見通し</translation>
    </message>
    <message>
        <source>How far beyond its own space a bud sees room to grow, in internodes.</source>
        <translation>芽が自分の空間の先にある余地をどこまで見るかです (節間単位)。</translation>
    </message>
    <message>
        <source>Depth of the volume of perception, which reaches to r + d.</source>
        <translation>知覚領域の奥行き。領域は r + d まで届く。</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>視野角</translation>
    </message>
    <message>
        <source>How far to the sides a bud sees room to grow.</source>
        <translation>芽が余地を横方向にどこまで見るかです。</translation>
    </message>
    <message>
        <source>Apex angle of the cone of perception.</source>
        <translation>知覚円錐の頂角。</translation>
    </message>
    <message>
        <source>Apical dominance</source>
        <translation>頂芽優勢</translation>
    </message>
    <message>
        <source>What gets the vigour: above 0.5 the main axis, as in conifers; below it the branches, as in shrubs.</source>
        <translation>勢いの配分です。0.5 より上では針葉樹のように主軸に、下では低木のように枝に向かいます。</translation>
    </message>
    <message>
        <source>Excurrent forms above 0.5, decurrent ones below.</source>
        <translation>0.5 より上は主幹型、下は分散型の樹形。</translation>
    </message>
    <message>
        <source>Light sensitivity</source>
        <translation>光への感度</translation>
    </message>
    <message>
        <source>How much more a bud in the light thrives than one in the shade.</source>
        <translation>光の当たる芽が日陰の芽よりどれだけよく育つかです。</translation>
    </message>
    <message>
        <source>Exponent of the response to light: high for light-demanding trees, low for shade-tolerant ones.</source>
        <translation>光への応答の指数。陽樹では高く、陰樹では低い。</translation>
    </message>
    <message>
        <source>Shedding</source>
        <translation>落枝</translation>
    </message>
    <message>
        <source>Branches with less vigour than this die: 0 keeps them all.</source>
        <translation>勢いがこれより弱い枝は枯れます。0 ではすべて残ります。</translation>
    </message>
    <message>
        <source>Threshold of cladoptosis: vigour per internode, relative to that of the whole tree.</source>
        <translation>落枝のしきい値。木全体に対する、節間あたりの樹勢。</translation>
    </message>
    <message>
        <source>Shoot length</source>
        <translation>シュート長</translation>
    </message>
    <message>
        <source>How many internodes the strongest shoot grows in one step.</source>
        <translation>最も強いシュートが 1 ステップで伸ばす節間の数です。</translation>
    </message>
    <message>
        <source>Metamers of the strongest shoot of a flush.</source>
        <translation>1 回の伸長期に最も強いシュートがつくるメタマーの数。</translation>
    </message>
    <message>
        <source>Phyllotaxis</source>
        <translation>葉序</translation>
    </message>
    <message>
        <source>Turn around the axis from one bud to the next: 137.5° is a spiral, 180° two rows, 90° crossed pairs.</source>
        <translation>芽から次の芽まで軸のまわりを回る角度です。137.5° はらせん、180° は二列、90° は十字対生です。</translation>
    </message>
    <message>
        <source>Divergence angle: spiral, distichous, decussate.</source>
        <translation>開度。らせん、二列、十字対生。</translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation>ストロークに従う</translation>
    </message>
    <message>
        <source>Shoots turn the way the brush goes, instead of to the set-point angle.</source>
        <translation>シュートが設定角ではなく、ブラシの進む方へ向かいます。</translation>
    </message>
    <message>
        <source>The set-point angle is inferred from the direction of the stroke.</source>
        <translation>設定角をストロークの方向から求める。</translation>
    </message>
    <message>
        <source>Upright trunk</source>
        <translation>幹を直立</translation>
    </message>
    <message>
        <source>The trunk grows straight up, whatever the branches do.</source>
        <translation>枝の向きにかかわらず、幹がまっすぐ上に伸びます。</translation>
    </message>
    <message>
        <source>The axis of order 0 is orthotropic, as in most conifers.</source>
        <translation>0 次の軸が直立性になる。多くの針葉樹と同じ。</translation>
    </message>
    <message>
        <source>Internode</source>
        <translation>節間</translation>
    </message>
    <message>
        <source>Length of one internode. It is the measure of everything that grows: shorter ones make finer trees.</source>
        <translation>節間 1 つの長さです。成長するものすべての物差しで、小さいほど細やかな木になります。</translation>
    </message>
    <message>
        <source>Length of a metamer.</source>
        <translation>メタマーの長さ。</translation>
    </message>
    <message>
        <source>Buds at a node</source>
        <translation>節ごとの芽</translation>
    </message>
    <message>
        <source>One is alternate, two opposite, more a whorl, as in pines.</source>
        <translation>1 は互生、2 は対生、それ以上はマツのような輪生です。</translation>
    </message>
    <message>
        <source>Alternate, opposite or verticillate.</source>
        <translation>互生、対生、輪生。</translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation>不規則さ</translation>
    </message>
    <message>
        <source>Spread of angles and lengths: 0 is as regular as a diagram, 1 as wild as nature.</source>
        <translation>角度と長さのばらつきです。0 は模式図のよう、1 は自然のままです。</translation>
    </message>
    <message>
        <source>Variance of the angles and of the metamers.</source>
        <translation>角度とメタマーの分散。</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>影の濃さ</translation>
    </message>
    <message>
        <source>How much light one internode takes.</source>
        <translation>1 つの節間がどれだけ光をさえぎるかです。</translation>
    </message>
    <message>
        <source>Intensity of the penumbra that a metamer casts.</source>
        <translation>メタマーが落とす半影の強さ。</translation>
    </message>
    <message>
        <source>Shadow falloff</source>
        <translation>影の減衰</translation>
    </message>
    <message>
        <source>How fast a shadow fades on its way down.</source>
        <translation>影が下へ向かってどれだけ早く薄れるかです。</translation>
    </message>
    <message>
        <source>Base of the shadow&apos;s decay from layer to layer.</source>
        <translation>層ごとの減衰の底。</translation>
    </message>
    <message>
        <source>Shadow depth</source>
        <translation>影の深さ</translation>
    </message>
    <message>
        <source>How many layers below an internode its shadow reaches.</source>
        <translation>節間の影が何層下まで届くかです。</translation>
    </message>
    <message>
        <source>Height of the pyramid of shadow, in voxels.</source>
        <translation>影のピラミッドの高さ (ボクセル単位)。</translation>
    </message>
    <message>
        <source>Brush density</source>
        <translation>ブラシの密度</translation>
    </message>
    <message>
        <source>How densely the brush spreads room to grow, in points per cubic internode. More makes denser growth.</source>
        <translation>ブラシが広げる成長の余地です (節間の 3 乗あたりの点数)。大きいほど密に育ちます。</translation>
    </message>
    <message>
        <source>Density of the markers of free space.</source>
        <translation>空き空間のマーカーの密度。</translation>
    </message>
    <message>
        <source>Brush memory</source>
        <translation>ブラシの記憶</translation>
    </message>
    <message>
        <source>After this many growth steps, the room that the brush has spread is forgotten.</source>
        <translation>ブラシが広げた余地が忘れられるまでの成長ステップ数です。</translation>
    </message>
    <message>
        <source>Maximum age of a marker.</source>
        <translation>マーカーの最大齢。</translation>
    </message>
    <message>
        <source>Room at a bud</source>
        <translation>芽の周囲の余地</translation>
    </message>
    <message>
        <source>When the tree grows on its own: the room to grow that each bud finds around itself in each step.</source>
        <translation>木が自然に成長するとき、各ステップで芽が自分のまわりに見つける余地です。</translation>
    </message>
    <message>
        <source>Markers generated in each volume of perception.</source>
        <translation>各知覚領域に生成するマーカーの数。</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>葉</translation>
    </message>
    <message>
        <source>Whether the tree has any.</source>
        <translation>木に葉をつけるかどうかです。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>葉形</translation>
    </message>
    <message>
        <source>The outline of a leaf.</source>
        <translation>葉の輪郭です。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>From the stalk to the tip.</source>
        <translation>葉柄から先端までの長さです。</translation>
    </message>
    <message>
        <source>Breadth</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width as a share of length.</source>
        <translation>長さに対する幅の比です。</translation>
    </message>
    <message>
        <source>Variation in size</source>
        <translation>大きさのばらつき</translation>
    </message>
    <message>
        <source>How much the sizes of leaves differ.</source>
        <translation>葉の大きさのばらつきです。</translation>
    </message>
    <message>
        <source>At a node</source>
        <translation>節ごとの数</translation>
    </message>
    <message>
        <source>How many leaves grow together.</source>
        <translation>まとまってつく葉の枚数です。</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>並び方</translation>
    </message>
    <message>
        <source>How leaves stand around a shoot: as its buds do; in a spiral; together, each pair or whorl across the one before; or flat in two rows, as on beech and hemlock.</source>
        <translation>シュートのまわりの葉の並び方です。芽と同じ、らせん状、節ごとにまとまって前の対や輪と交差、またはブナやツガのように平らに 2 列。</translation>
    </message>
    <message>
        <source>Leaf phyllotaxis: spiral, decussate or verticillate, distichous.</source>
        <translation>葉序：らせん葉序、十字対生または輪生、二列互生。</translation>
    </message>
    <message>
        <source>shoot</source>
        <translation>シュート</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>らせん</translation>
    </message>
    <message>
        <source>opposite</source>
        <translation>対生</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平ら</translation>
    </message>
    <message>
        <source>How far inward</source>
        <translation>内側まで</translation>
    </message>
    <message>
        <source>Branches that carry more twigs than this are bare.</source>
        <translation>これより多くの小枝をつけた枝には葉がつきません。</translation>
    </message>
    <message>
        <source>Leafy internodes</source>
        <translation>枝先のみ</translation>
    </message>
    <message>
        <source>How many internodes of a shoot bear leaves, counted from its tip.</source>
        <translation>葉はシュートの先からこの数の節間までにつき、それより下にはつきません。</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Between a shoot and the leaf&apos;s stalk.</source>
        <translation>シュートと葉柄の間の角度です。</translation>
    </message>
    <message>
        <source>Droop</source>
        <translation>垂れ</translation>
    </message>
    <message>
        <source>How far leaves hang down.</source>
        <translation>葉がどれだけ垂れるかです。</translation>
    </message>
    <message>
        <source>Towards the sky</source>
        <translation>葉の上向き</translation>
    </message>
    <message>
        <source>How far leaves turn their faces up.</source>
        <translation>葉がどれだけ表を上に向けるかです。</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>0° is red, 60° yellow, 120° green.</source>
        <translation>0° は赤、60° は黄、120° は緑です。</translation>
    </message>
    <message>
        <source>Variation in hue</source>
        <translation>色相のばらつき</translation>
    </message>
    <message>
        <source>How much the colours of leaves differ.</source>
        <translation>葉の色のばらつきです。</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>How strong the colour is: low values suit blossom and silvery leaves.</source>
        <translation>色の鮮やかさです。低くすると花や銀色の葉になります。</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>明るさ</translation>
    </message>
    <message>
        <source>How bright the leaves are.</source>
        <translation>葉の明るさです。</translation>
    </message>
    <message>
        <source>Yellowing</source>
        <translation>黄葉</translation>
    </message>
    <message>
        <source>How far the leaves of weak shoots turn towards yellow and red.</source>
        <translation>弱いシュートの葉がどれだけ黄や赤に近づくかです。</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>How widths add up where branches meet: 2 is Leonardo&apos;s rule; less makes thicker trunks.</source>
        <translation>枝の合流点で太さをどう足し合わせるかです。2 はレオナルドの法則で、小さいほど幹が太くなります。</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>枝先</translation>
    </message>
    <message>
        <source>Diameter of the thinnest twigs.</source>
        <translation>最も細い小枝の直径です。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>根元</translation>
    </message>
    <message>
        <source>Diameter of the trunk at the ground; at 0 it follows from the exponent.</source>
        <translation>地際での幹の直径です。0 では指数から決まります。</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>根張り</translation>
    </message>
    <message>
        <source>How much the trunk spreads where it meets the ground.</source>
        <translation>幹が地際でどれだけ広がるかです。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>What the bark looks like.</source>
        <translation>樹皮の見た目です。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>スケール</translation>
    </message>
    <message>
        <source>Length of trunk after which the bark&apos;s pattern repeats.</source>
        <translation>樹皮の模様が繰り返すまでの幹の長さです。</translation>
    </message>
    <message>
        <source>Gravimorphism</source>
        <translation>重力形態形成</translation>
    </message>
    <message>
        <source>Branching</source>
        <translation>分枝</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空間</translation>
    </message>
    <message>
        <source>Vigour</source>
        <translation>樹勢</translation>
    </message>
    <message>
        <source>Habit</source>
        <translation>習性</translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation>シュート</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>日陰</translation>
    </message>
    <message>
        <source>Room to grow</source>
        <translation>成長の余地</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>付き方</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>太さ</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>樹皮</translation>
    </message>
    <message>
        <source>ovate</source>
        <translation>卵形</translation>
    </message>
    <message>
        <source>lanceolate</source>
        <translation>披針形</translation>
    </message>
    <message>
        <source>lobed</source>
        <translation>浅裂</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>針葉</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>縦溝</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>亀甲状</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>シラカバ</translation>
    </message>
    <message>
        <source>cordate</source>
        <translation>心形</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>掌状</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>羽状</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>ヤナギ葉</translation>
    </message>
    <message>
        <source>fascicle</source>
        <translation>針葉束</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>ヤシ葉</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>サクラ</translation>
    </message>
    <message>
        <source>mottled</source>
        <translation>まだら</translation>
    </message>
    <message>
        <source>fibrous</source>
        <translation>繊維状</translation>
    </message>
    <message>
        <source>ringed</source>
        <translation>環状</translation>
    </message>
    <message>
        <source>What stands behind the tree. The studio is dark or light, as the theme is.</source>
        <translation>木の後ろに見えるものです。スタジオの明暗はプログラムのテーマに従います。</translation>
    </message>
    <message>
        <source>dark_studio</source>
        <translation>暗いスタジオ</translation>
    </message>
    <message>
        <source>light_studio</source>
        <translation>明るいスタジオ</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>A pen&apos;s pressure scales the brush: the radius is what a firm hand reaches.</source>
        <translation>筆圧でブラシの大きさを変えます。半径は、強く押したときの大きさです。</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>Show the points of free space that the brush spreads, and that shoots grow towards.</source>
        <translation>ブラシが散らし、シュートが目指す空き空間の点を表示します。</translation>
    </message>
    <message>
        <source>Drawing plane</source>
        <translation>描画面</translation>
    </message>
    <message>
        <source>Show how deep in the tree the brush draws: a faint grid around it.</source>
        <translation>ブラシが木のどの奥行きに描くかを、まわりの薄いグリッドで示します。</translation>
    </message>
    <message>
        <source>Hazel</source>
        <translation>ハシバミ</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>ナラ</translation>
    </message>
    <message>
        <source>Maple</source>
        <translation>カエデ</translation>
    </message>
    <message>
        <source>Elm</source>
        <translation>ニレ</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>ポプラ</translation>
    </message>
    <message>
        <source>Spruce</source>
        <translation>トウヒ</translation>
    </message>
    <message>
        <source>Pine</source>
        <translation>マツ</translation>
    </message>
    <message>
        <source>Acacia</source>
        <translation>アカシア</translation>
    </message>
    <message>
        <source>Apple</source>
        <translation>リンゴ</translation>
    </message>
    <message>
        <source>Joshua tree</source>
        <translation>ジョシュアツリー</translation>
    </message>
    <message>
        <source>Buds</source>
        <translation>芽の数</translation>
    </message>
    <message>
        <source>How many buds a tap adds, in a spiral around the branch.</source>
        <translation>1 回のタップで、枝のまわりにらせん状に加わる芽の数です。</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>How far one bud is from the next along the branch: 0 is a whorl.</source>
        <translation>枝に沿った、芽から次の芽までの距離です。0 では輪生になります。</translation>
    </message>
    <message>
        <source>Self-organising competition, or shoot growth by vigour with apical control.</source>
        <translation>自己組織的な競争か、頂端制御を伴う樹勢によるシュートの成長。</translation>
    </message>
    <message>
        <source>Growth in a year</source>
        <translation>1 年の伸び</translation>
    </message>
    <message>
        <source>How much the strongest shoot grows in full light, in twelve steps.</source>
        <translation>最も強いシュートが、十分な光のもとで 12 ステップに伸びる長さです。</translation>
    </message>
    <message>
        <source>Annual elongation of a shoot.</source>
        <translation>シュートの年間伸長量。</translation>
    </message>
    <message>
        <source>Length of internodes</source>
        <translation>節間の長さ</translation>
    </message>
    <message>
        <source>An internode lengthens over several steps, up to this.</source>
        <translation>節間は、何ステップかかけてこの長さまで伸びます。</translation>
    </message>
    <message>
        <source>Length of a mature metamer.</source>
        <translation>成熟したメタマーの長さ。</translation>
    </message>
    <message>
        <source>Angle of laterals</source>
        <translation>側枝の角度</translation>
    </message>
    <message>
        <source>Between an axis and a branch that begins on it.</source>
        <translation>軸と、そこから出る枝との間の角度です。</translation>
    </message>
    <message>
        <source>Angle of insertion of a lateral shoot.</source>
        <translation>側生シュートの着生角度。</translation>
    </message>
    <message>
        <source>Lateral buds</source>
        <translation>側芽</translation>
    </message>
    <message>
        <source>At each node: one makes a spiral, two crossed pairs, more a whorl.</source>
        <translation>節ごとの数です。1 はらせん、2 は十字対生、それ以上は輪生になります。</translation>
    </message>
    <message>
        <source>Variation in roll</source>
        <translation>回転のばらつき</translation>
    </message>
    <message>
        <source>How irregularly branches stand around their axis.</source>
        <translation>枝が軸のまわりにどれだけ不規則につくかです。</translation>
    </message>
    <message>
        <source>Standard deviation of the divergence angle.</source>
        <translation>開度の標準偏差。</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>くねり</translation>
    </message>
    <message>
        <source>How much an axis changes its direction from node to node.</source>
        <translation>軸が節ごとにどれだけ向きを変えるかです。</translation>
    </message>
    <message>
        <source>Standard deviation of the apical angle.</source>
        <translation>頂端角の標準偏差。</translation>
    </message>
    <message>
        <source>Branch orders</source>
        <translation>枝の次数</translation>
    </message>
    <message>
        <source>How many orders of branches there are at most: branches, their branches, and so on.</source>
        <translation>枝の枝、そのまた枝と、何段まで分かれるかです。</translation>
    </message>
    <message>
        <source>Highest order of an axis.</source>
        <translation>軸の最大次数。</translation>
    </message>
    <message>
        <source>Flushing</source>
        <translation>芽吹き</translation>
    </message>
    <message>
        <source>How readily lateral buds become branches.</source>
        <translation>側芽がどれだけ枝になりやすいかです。</translation>
    </message>
    <message>
        <source>Chance of lateral bud break for each internode of growth.</source>
        <translation>節間 1 つの成長ごとに側芽が開く確率。</translation>
    </message>
    <message>
        <source>Inhibition</source>
        <translation>抑制</translation>
    </message>
    <message>
        <source>How strongly growing tips hold back the buds below them.</source>
        <translation>伸びている先端が、下の芽をどれだけ強く抑えるかです。</translation>
    </message>
    <message>
        <source>Apical dominance: auxin from lit apical buds.</source>
        <translation>頂芽優勢。光の当たる頂芽からのオーキシン。</translation>
    </message>
    <message>
        <source>Decay of the inhibitor on its way down.</source>
        <translation>下へ向かう抑制物質の減衰。</translation>
    </message>
    <message>
        <source>Apical control</source>
        <translation>頂端制御</translation>
    </message>
    <message>
        <source>Above 1 the trunk outgrows its branches, as in a spruce; below 1 they outgrow it.</source>
        <translation>1 より上ではトウヒのように幹が枝に勝ち、下では枝が幹に勝ちます。</translation>
    </message>
    <message>
        <source>Excurrent above 1, decurrent below.</source>
        <translation>1 より上で主幹型、下で分散型の樹形。</translation>
    </message>
    <message>
        <source>Loss with distance</source>
        <translation>距離による衰え</translation>
    </message>
    <message>
        <source>How much less a shoot grows far from the root.</source>
        <translation>根から遠いシュートの伸びがどれだけ弱まるかです。</translation>
    </message>
    <message>
        <source>Decay of the potential with the distance to the root.</source>
        <translation>根からの距離に伴う成長力の減衰。</translation>
    </message>
    <message>
        <source>Loss with height</source>
        <translation>高さによる衰え</translation>
    </message>
    <message>
        <source>How much less a shoot grows the higher it is: more makes the crown flat.</source>
        <translation>高いところのシュートの伸びがどれだけ弱まるかです。大きいほど樹冠が平らになります。</translation>
    </message>
    <message>
        <source>Decay of the potential with height.</source>
        <translation>高さに伴う成長力の減衰。</translation>
    </message>
    <message>
        <source>Gravitropism</source>
        <translation>重力屈性</translation>
    </message>
    <message>
        <source>Above 0 shoots turn upwards at each node, below 0 downwards.</source>
        <translation>0 より上では節ごとにシュートが上へ、下では枝が下へ向きを変えます。</translation>
    </message>
    <message>
        <source>Orthotropic above 0, positively gravitropic below.</source>
        <translation>0 より上で直立性、下で正の重力屈性。</translation>
    </message>
    <message>
        <source>Phototropism</source>
        <translation>光屈性</translation>
    </message>
    <message>
        <source>How far shoots turn to the light at each node.</source>
        <translation>シュートが節ごとにどれだけ光の方へ向きを変えるかです。</translation>
    </message>
    <message>
        <source>Growth towards the brightest direction.</source>
        <translation>最も明るい方向への成長。</translation>
    </message>
    <message>
        <source>Level branches</source>
        <translation>枝の水平さ</translation>
    </message>
    <message>
        <source>How far a new branch turns towards the horizontal where it begins.</source>
        <translation>新しい枝が、出るときにどれだけ水平に近づくかです。</translation>
    </message>
    <message>
        <source>Plagiotropy of lateral shoots.</source>
        <translation>側生シュートの斜生性。</translation>
    </message>
    <message>
        <source>Sagging</source>
        <translation>たわみ</translation>
    </message>
    <message>
        <source>How far branches sag under their weight as they grow.</source>
        <translation>育つにつれて、枝が自分の重さでどれだけたわむかです。</translation>
    </message>
    <message>
        <source>Gravimorphic bending by branch load.</source>
        <translation>枝の荷重による重力形態形成的な曲がり。</translation>
    </message>
    <message>
        <source>Stiffness with age</source>
        <translation>太い枝の硬さ</translation>
    </message>
    <message>
        <source>How much thick wood resists: at high values only the thin ends bend.</source>
        <translation>太い部分がどれだけたわみに逆らうかです。大きいほど、細い先だけがたわみます。</translation>
    </message>
    <message>
        <source>Exponent of thickness in flexural stiffness.</source>
        <translation>曲げ剛性における太さの指数。</translation>
    </message>
    <message>
        <source>Greatest sag</source>
        <translation>たわみの上限</translation>
    </message>
    <message>
        <source>An internode sags by at most this share of the angle between it and straight down.</source>
        <translation>節間ごとに、真下までの角度のうち、最大でこの割合までたわみます。</translation>
    </message>
    <message>
        <source>Limit of the bend of an internode.</source>
        <translation>節間の曲がりの限度。</translation>
    </message>
    <message>
        <source>Shade pruning</source>
        <translation>日陰の落枝</translation>
    </message>
    <message>
        <source>Branch ends that get less light than this drop off.</source>
        <translation>光がこれより少ない枝先が落ちます。</translation>
    </message>
    <message>
        <source>Cladoptosis of shaded shoots.</source>
        <translation>日陰のシュートの落枝。</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Tubes: each branch is a tube that begins inside its parent. Strands: the wood is bundles of strands, which run from every tip to the ground, under one closed bark.</source>
        <translation>チューブ: 枝の 1 本 1 本が、親の枝の中から始まる管です。ストランド: 木部はストランドの束で、どの枝先からも地面まで通り、ひと続きの樹皮に包まれます。</translation>
    </message>
    <message>
        <source>Strands at a tip</source>
        <translation>枝先のストランド</translation>
    </message>
    <message>
        <source>How many strands begin at each tip. More make a smoother surface, and branches that separate more clearly.</source>
        <translation>枝先ごとに始まるストランドの数です。多いほど表面がなめらかになり、枝がはっきり分かれます。</translation>
    </message>
    <message>
        <source>Strand radius</source>
        <translation>ストランドの半径</translation>
    </message>
    <message>
        <source>How thick each strand is. Above 0, the trunk gets as thick as its strands make it; at 0 it keeps the width that it has.</source>
        <translation>ストランド 1 本の太さです。幹の太さはストランドの量で決まります。0 では今の太さを保ちます。</translation>
    </message>
    <message>
        <source>Cohesion</source>
        <translation>結びつき</translation>
    </message>
    <message>
        <source>Branches separate at a fork where their strands are further apart than this many strand radii: low values part them early, high ones late.</source>
        <translation>ストランドどうしがストランド半径のこの倍数より離れたところで、枝が分かれます。小さいと早く、大きいと遅く分かれます。</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>詰め方</translation>
    </message>
    <message>
        <source>How the strands of a section are pressed together. At rest: until none overlaps. As published: by the paper&apos;s simulation, which stops before that.</source>
        <translation>断面のストランドをどう押し詰めるかです。静止まで: 重なりがなくなるまで。論文どおり: 論文のシミュレーションで、その途中で止まります。</translation>
    </message>
    <message>
        <source>Packing steps</source>
        <translation>詰めるステップ数</translation>
    </message>
    <message>
        <source>For how long strands are pressed together at each node. With few steps, the shape of a fork is kept further down the trunk; with many, the trunk is round at once.</source>
        <translation>節ごとにストランドをどれだけ長く押し詰めるかです。少ないと分かれ目の形が幹の下の方まで残り、多いとすぐに丸くなります。</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>なめらかさ</translation>
    </message>
    <message>
        <source>How far the ridges of single strands are smoothed: 0 shows each of them.</source>
        <translation>ストランド 1 本 1 本の筋をどれだけならすかです。0 ではすべての筋が見えます。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Bud break</source>
        <translation>開芽</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>制御</translation>
    </message>
    <message>
        <source>Tropisms</source>
        <translation>屈性</translation>
    </message>
    <message>
        <source>Weight and shade</source>
        <translation>重さと日陰</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>ストランド</translation>
    </message>
    <message>
        <source>vigour</source>
        <translation>樹勢</translation>
    </message>
    <message>
        <source>tubes</source>
        <translation>チューブ</translation>
    </message>
    <message>
        <source>strands</source>
        <translation>ストランド</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>静止まで</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>論文どおり</translation>
    </message>
    <message>
        <source>Branches too</source>
        <translation>枝もねじる</translation>
    </message>
    <message>
        <source>A drag twists all that the branch carries, not only the branch itself. Hold Shift for the opposite.</source>
        <translation>ドラッグすると、その枝だけでなく、枝についているものもすべてねじれます。Shift を押している間は逆になります。</translation>
    </message>
    <message>
        <source>Fading of the inhibition</source>
        <translation>抑制の減衰</translation>
    </message>
    <message>
        <source>The share that is lost at each internode: higher values let buds break nearer to the tip.</source>
        <translation>節間ごとに失われる割合。大きいほど、芽は先端の近くで開きます。</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>縦溝</translation>
    </message>
    <message>
        <source>How far the trunk bulges below its limbs and towards its roots, and how deep the hollows of lost limbs are. At 0 the wood is round.</source>
        <translation>大枝の下や根元で幹がどれだけ盛り上がるか、失った枝の跡がどれだけ深くくぼむかを決めます。0 では木は丸くなります。</translation>
    </message>
    <message>
        <source>Growth model</source>
        <translation>成長モデル</translation>
    </message>
    <message>
        <source>TreeSketch: buds compete for space and light. Vigour: light decides how fast each shoot grows, month by month.</source>
        <translation>TreeSketch: 芽が空間と光を競い合います。樹勢: 各シュートの伸びる速さが、月ごとに光で決まります。</translation>
    </message>
    <message>
        <source>TreeSketch</source>
        <translation>TreeSketch</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>取り去る</translation>
    </message>
    <message>
        <source>A stroke takes away: a branch that it crosses once is cut there, one that it crosses twice is erased. Shift or a pen&apos;s eraser does so, too.</source>
        <translation>線が取り去ります。一度横切った枝はそこで切れ、二度横切った枝は消えます。Shift やペンの消しゴムでも同じです。</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>左右対称</translation>
    </message>
    <message>
        <source>Each branch is drawn on the other side of the trunk as well.</source>
        <translation>枝は幹の反対側にも描かれます。</translation>
    </message>
    <message>
        <source>Fill the sides</source>
        <translation>側面を埋める</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>樹冠</translation>
    </message>
    <message>
        <source>How much wider than the drawing the crown may be in depth.</source>
        <translation>樹冠が奥行きで絵よりどれだけ広くなってよいか。</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>How much longer branches may become in depth than those you drew.</source>
        <translation>枝が奥行きで描いた枝よりどれだけ長くなってよいか。</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>How much wider an angle between branches may be than the widest you drew.</source>
        <translation>枝の間の角度が、描いた中で最も広い角度よりどれだけ広くてよいか。</translation>
    </message>
    <message>
        <source>Pass on</source>
        <translation>広める</translation>
    </message>
    <message>
        <source>A tap on a branch gives other branches what it carries. Otherwise it adds one branch like those that the branch carries.</source>
        <translation>枝をタップすると、付いているものがほかの枝に写されます。オフでは、付いている枝に似た枝が一本増えます。</translation>
    </message>
    <message>
        <source>Only to similar ones</source>
        <translation>同じ仲間に</translation>
    </message>
    <message>
        <source>Only branches that are equally many forks away from the trunk get it.</source>
        <translation>同じ回数だけ分かれた枝だけが受け取ります。</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>拡大縮小</translation>
    </message>
    <message>
        <source>What a branch gets is scaled to the size of that branch. Otherwise it keeps its size, and its distance from the tip.</source>
        <translation>受け取るものは枝の大きさに合わせて変わります。オフでは、大きさと先端からの距離がそのままです。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>What the branches carried until now is removed.</source>
        <translation>枝にそれまで付いていたものはなくなります。</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>How much the angles and lengths of a variation deviate from those of the tree.</source>
        <translation>角度と長さを、元の木からどれだけずらすか。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Which variation it is: the same number always gives the same variation of a tree.</source>
        <translation>どの変化か。同じ木からは、同じ番号で同じ木ができます。</translation>
    </message>
    <message>
        <source>Two sides</source>
        <translation>両側</translation>
    </message>
    <message>
        <source>Two strokes in a row, drawn side by side, are the two sides of one branch, which gets its width from them.</source>
        <translation>続けて並べて描いた二本の線は一本の枝の両側になり、枝の太さを決めます。</translation>
    </message>
    <message>
        <source>The drawing is placed twice, the second time turned by 90° around the trunk, so that the tree is as full from the side as from the front. Without this, its branches themselves run towards you and away from you.</source>
        <translation>絵を二度置き、二度目は幹のまわりに 90° 回します。横から見ても正面と同じくらい茂ります。切ると、枝そのものが手前と奥へ伸びます。</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Where strokes go in depth. Screen: as deep as the branch that they begin at. Trunk: in the plane through the trunk and the branch that they begin at. Spread: each limb that begins at the trunk is turned into the widest gap, as long and as steep as you draw it.</source>
        <translation>線の奥行きの決め方。画面：始点の枝と同じ奥行き。幹：幹と始点の枝を通る面。分散：幹から出る枝は、描いたとおりの長さと傾きのまま、いちばん広いすき間へ向けられます。</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>周囲</translation>
    </message>
    <message>
        <source>How many strokes are made around the trunk for each one that you draw.</source>
        <translation>描いた線 1 本につき、幹のまわりに何本できるか。</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>幹</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>分散</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the brush, shared with the Brush tool.</source>
        <translation>ブラシの半径。描くブラシと同じです。</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>太さの上限</translation>
    </message>
    <message>
        <source>The thickest wood that is removed, as a share of the trunk&apos;s width. Thicker branches stay, however often you brush over them.</source>
        <translation>取り除く枝の太さの上限（幹の太さに対する割合）。それより太い枝は、何度なぞっても残ります。</translation>
    </message>
    <message>
        <source>Share of twigs</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>The share of the twigs under the brush that a stroke takes. They are chosen evenly along each limb.</source>
        <translation>ひとなぞりで取れる小枝の割合。枝ごとにむらなく選ばれます。</translation>
    </message>
    <message>
        <source>Far side too</source>
        <translation>裏側も</translation>
    </message>
    <message>
        <source>A stroke reaches through the whole tree. Otherwise it takes only what is on your side of the trunk.</source>
        <translation>線が木の向こう側まで届きます。オフのときは、幹の手前側だけを取ります。</translation>
    </message>
    <message>
        <source>Straightening</source>
        <translation>まっすぐになる速さ</translation>
    </message>
    <message>
        <source>How fast young wood smooths its bends as it grows on: 0 keeps every elbow.</source>
        <translation>若い木が伸びるにつれて曲がりをならす速さ。0 ではどの曲がりも残ります。</translation>
    </message>
    <message>
        <source>Reaction wood: an axis that takes over straightens.</source>
        <translation>あて材。先導になった軸はまっすぐになります。</translation>
    </message>
</context>
<context>
    <name>ParametersJson</name>
    <message>
        <source>true or false is expected</source>
        <translation>true か false が必要です</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>次のいずれかが必要です: %1</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>整数が必要です</translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation>数値が必要です</translation>
    </message>
    <message>
        <source>%1 is not within %2…%3</source>
        <translation>%1 は %2…%3 の範囲外です</translation>
    </message>
    <message>
        <source>axisWeight, tropismWeight and spaceWeight must not all be 0</source>
        <translation>axisWeight、tropismWeight、spaceWeight をすべて 0 にはできません</translation>
    </message>
    <message>
        <source>it must not exceed 0.99 times ellipseVertical, which is %1</source>
        <translation>ellipseVertical の 0.99 倍、つまり %1 を超えられません</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>オブジェクトが必要です</translation>
    </message>
    <message>
        <source>there is no such parameter</source>
        <translation>そのようなパラメーターはありません</translation>
    </message>
    <message>
        <source>the name of an image is expected</source>
        <translation>画像の名前が必要です</translation>
    </message>
    <message>
        <source>there are no images here</source>
        <translation>ここには画像がありません</translation>
    </message>
</context>
<context>
    <name>PositionCheck</name>
    <message>
        <source>it and the later steps move a tree whose axes are longer than %1 m too often</source>
        <translation>これ以降のステップが、%1 m を超える軸を持つ木を動かす回数が多すぎます</translation>
    </message>
    <message>
        <source>before it, internode %1 lies more than %2 m away</source>
        <translation>その前に、節間 %1 が %2 m より遠くにあります</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>履歴のステップ %1</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>%1 m より遠くにあります</translation>
    </message>
    <message>
        <source>internode %1</source>
        <translation>節間 %1</translation>
    </message>
</context>
<context>
    <name>ProfileJson</name>
    <message>
        <source>a profile is expected</source>
        <translation>断面形が必要です</translation>
    </message>
    <message>
        <source>at most %1 are possible</source>
        <translation>%1 個までです</translation>
    </message>
    <message>
        <source>lists of points [x, y] are expected</source>
        <translation>点 [x, y] の並びが必要です</translation>
    </message>
</context>
<context>
    <name>ProfileTool</name>
    <message>
        <source>Tap a branch to see its cross-section, and draw another shape for it</source>
        <translation>枝をタップすると断面が表示され、別の形を描けます</translation>
    </message>
</context>
<context>
    <name>Program</name>
    <message>
        <source>%1; see espalier --help</source>
        <translation>%1。espalier --help をご覧ください</translation>
    </message>
    <message>
        <source>What you did is in a safety copy in %1; the next start offers it. The fault is described in %2.</source>
        <translation>作業内容は %1 の控えにあり、次の起動時に復元できます。エラーの内容は %2 にあります。</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>pairs of an internode and a diameter are expected</source>
        <translation>節間と直径の組が必要です</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>オブジェクトが必要です</translation>
    </message>
    <message>
        <source>it does not describe an Espalier project</source>
        <translation>Espalier のプロジェクトではありません</translation>
    </message>
    <message>
        <source>Espalier %1 wrote it in version %2 of the format; this is Espalier %3, which reads versions up to %4</source>
        <translation>Espalier %1 が形式バージョン %2 で書いたファイルです。この Espalier %3 が読めるのはバージョン %4 までです</translation>
    </message>
    <message>
        <source>1 to %1 sets are expected</source>
        <translation>1 から %1 組までが必要です</translation>
    </message>
    <message>
        <source>the lassos</source>
        <translation>投げ縄</translation>
    </message>
    <message>
        <source>their parts do not add up</source>
        <translation>各部分のつじつまが合いません</translation>
    </message>
    <message>
        <source>the history</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>its parts do not add up</source>
        <translation>各部分のつじつまが合いません</translation>
    </message>
    <message>
        <source>the tree or its history is too large for a project file</source>
        <translation>木またはその履歴が大きすぎて、プロジェクトファイルに収まりません</translation>
    </message>
    <message>
        <source>at most %1 images are expected</source>
        <translation>画像は %1 枚までです</translation>
    </message>
    <message>
        <source>the image “%1” is missing from it or broken; the built-in look is shown instead</source>
        <translation>画像「%1」がファイルにないか、壊れています。代わりに Espalier の描いた見た目で表示します</translation>
    </message>
    <message>
        <source>they have too many points</source>
        <translation>点が多すぎます</translation>
    </message>
    <message>
        <source>indices of strokes are expected</source>
        <translation>ストロークの番号が必要です</translation>
    </message>
    <message>
        <source>the record of what was done</source>
        <translation>行ったことの記録</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>履歴のステップ %1</translation>
    </message>
    <message>
        <source>the record of what was done is not a JSON object</source>
        <translation>行ったことの記録が JSON オブジェクトではありません</translation>
    </message>
    <message>
        <source>the profiles</source>
        <translation>断面形</translation>
    </message>
    <message>
        <source>there are too many</source>
        <translation>多すぎます</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>true か false が必要です</translation>
    </message>
    <message>
        <source>a colour such as #5c6268 is expected</source>
        <translation>#5c6268 のような色が必要です</translation>
    </message>
    <message>
        <source>there is no backdrop of this name</source>
        <translation>その名前の背景はありません</translation>
    </message>
    <message>
        <source>its background and light cannot be read (%1); those of a new tree are shown instead</source>
        <translation>背景と光を読み込めません（%1）。代わりに新しい木のものを表示します</translation>
    </message>
    <message>
        <source>the reference picture “%1” is missing from it or broken</source>
        <translation>下絵「%1」がないか、壊れています</translation>
    </message>
    <message>
        <source>a change of the history</source>
        <translation>履歴の変更</translation>
    </message>
    <message>
        <source>it does not follow on from what is before it</source>
        <translation>前の内容とつながっていません</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>このファイルはありません</translation>
    </message>
    <message>
        <source>some of what other programs have put into it cannot be kept</source>
        <translation>ほかのプログラムが入れたものの一部は保持できません</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>a stroke needs at least one point</source>
        <translation>線には点が1つ以上必要です</translation>
    </message>
    <message>
        <source>1 to %1 strokes are expected</source>
        <translation>1～%1本の線が必要です</translation>
    </message>
    <message>
        <source>internode %1 is a root, which cannot be pruned</source>
        <translation>節間 %1 は根元なので、剪定できません</translation>
    </message>
    <message>
        <source>there is no room for more parameter sets</source>
        <translation>これ以上パラメーターの組を加える余地がありません</translation>
    </message>
    <message>
        <source>there is no such bud</source>
        <translation>そのような芽はありません</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>オブジェクトが必要です</translation>
    </message>
    <message>
        <source>a number other than 0 is expected</source>
        <translation>0 以外の数値が必要です</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>a stroke needs at least one sample</source>
        <translation>ストロークには 1 つ以上のサンプルが必要です</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 samples</source>
        <translation>レシピのサンプルは %1 個までです</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected</source>
        <translation>±%1 以内の 3 つの数値が必要です</translation>
    </message>
    <message>
        <source>right and up must have length 1 and be at right angles</source>
        <translation>right と up は長さ 1 で、互いに直交する必要があります</translation>
    </message>
    <message>
        <source>a lasso needs at least three points</source>
        <translation>投げ縄には 3 点以上が必要です</translation>
    </message>
    <message>
        <source>two numbers within ±%1 are expected, right and up, in m</source>
        <translation>±%1 以内の 2 つの数値 (右と上、m 単位) が必要です</translation>
    </message>
    <message>
        <source>1 to %1 internodes are expected</source>
        <translation>1 から %1 個までの節間が必要です</translation>
    </message>
    <message>
        <source>an array of five numbers is expected: time, x, y, z, radius</source>
        <translation>5 つの数値の配列が必要です: 時間、x、y、z、半径</translation>
    </message>
    <message>
        <source>the time is not within 0…%1 s</source>
        <translation>時間が 0…%1 秒の範囲外です</translation>
    </message>
    <message>
        <source>the time does not go forwards</source>
        <translation>時間が前に進んでいません</translation>
    </message>
    <message>
        <source>a coordinate is not within ±%1 m</source>
        <translation>座標が ±%1 m の範囲外です</translation>
    </message>
    <message>
        <source>the radius is not within 0…%1 m</source>
        <translation>半径が 0…%1 m の範囲外です</translation>
    </message>
    <message>
        <source>a bend needs 1 to %1 handles</source>
        <translation>曲げのハンドルは 1 から %1 個までです</translation>
    </message>
    <message>
        <source>an array of three numbers within ±%1 is expected</source>
        <translation>±%1 以内の 3 つの数値の配列が必要です</translation>
    </message>
    <message>
        <source>there is no view “%1”; there are front, side, top and three-quarter</source>
        <translation>「%1」という視点はありません。使えるのは front、side、top、three-quarter です</translation>
    </message>
    <message>
        <source>this is not a recipe: a recipe begins with “%1”: %2</source>
        <translation>レシピではありません。レシピは「%1」: %2 で始まります</translation>
    </message>
    <message>
        <source>the recipe is of version %1; this program reads versions up to %2</source>
        <translation>レシピはバージョン %1 ですが、このプログラムが読めるのはバージョン %2 までです</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 operations</source>
        <translation>レシピの操作は %1 個までです</translation>
    </message>
    <message>
        <source>a recipe can have at most %1 images</source>
        <translation>レシピの画像は %1 枚までです</translation>
    </message>
    <message>
        <source>a path relative to the recipe is expected</source>
        <translation>レシピからの相対パスが必要です</translation>
    </message>
    <message>
        <source>internode %1 is not on the branch above internode %2</source>
        <translation>節間 %1 は、節間 %2 より先の枝にありません</translation>
    </message>
    <message>
        <source>nothing grew</source>
        <translation>何も成長しませんでした</translation>
    </message>
    <message>
        <source>internode %1 has no bud %2</source>
        <translation>節間 %1 に芽 %2 はありません</translation>
    </message>
    <message>
        <source>%1 hexadecimal digits are expected</source>
        <translation>%1 桁の 16 進数が必要です</translation>
    </message>
    <message>
        <source>a key (“key”) or a place (“at”) is expected</source>
        <translation>キー (「key」) か場所 (「at」) が必要です</translation>
    </message>
    <message>
        <source>there is no internode %1</source>
        <translation>節間 %1 はありません</translation>
    </message>
    <message>
        <source>there is no internode with the key %1</source>
        <translation>キー %1 の節間はありません</translation>
    </message>
    <message>
        <source>there is no internode near (%1, %2, %3) m</source>
        <translation>(%1, %2, %3) m の近くに節間はありません</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1 is expected</source>
        <translation>0 から %1 までの整数が必要です</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; ほか %2 件</translation>
    </message>
    <message>
        <source>there is no operation “%1”; there are %2</source>
        <translation>「%1」という操作はありません。使えるのは %2 です</translation>
    </message>
    <message>
        <source>there are only %1 commands to redo, not %2</source>
        <translation>やり直せるのは %1 回までで、%2 回はできません</translation>
    </message>
    <message>
        <source>there is no envelope</source>
        <translation>外形がありません</translation>
    </message>
    <message>
        <source>internode %1 has no width to take away</source>
        <translation>節間 %1 に解除する太さはありません</translation>
    </message>
    <message>
        <source>the history goes back only by %1, not by %2</source>
        <translation>履歴を戻れるのは %1 までで、%2 は戻れません</translation>
    </message>
    <message>
        <source>the history goes on only by %1, not by %2</source>
        <translation>履歴を進めるのは %1 までで、%2 は進めません</translation>
    </message>
    <message>
        <source>there are only %1 commands to undo, not %2</source>
        <translation>元に戻せるのは %1 回までで、%2 回はできません</translation>
    </message>
    <message>
        <source>a target for each handle is expected</source>
        <translation>ハンドルごとに目標が 1 つ必要です</translation>
    </message>
    <message>
        <source>arrays of three numbers within ±%1 are expected</source>
        <translation>±%1 以内の 3 つの数の配列が必要です</translation>
    </message>
    <message>
        <source>there are more than %1</source>
        <translation>%1 個を超えています</translation>
    </message>
    <message>
        <source>“%1” must be given with them</source>
        <translation>一緒に「%1」が必要です</translation>
    </message>
    <message>
        <source>1 to %1 envelopes are expected</source>
        <translation>1～%1 個の外形が必要です</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: of its %1 steps, %2 (%3) were made by a version of Espalier that did not record how</source>
        <translation>木の履歴をレシピにできません。全 %1 ステップのうち %2 ステップ（%3）は、やり方を記録しない版の Espalier で作られました</translation>
    </message>
    <message>
        <source>the tree&apos;s history cannot become a recipe: it does not begin with a seedling, because the tree was imported or its oldest steps were dropped</source>
        <translation>木の履歴をレシピにできません。木が読み込まれたものか、古い手順が捨てられたため、苗木から始まっていません</translation>
    </message>
    <message>
        <source>step %1 of the history</source>
        <translation>履歴のステップ %1</translation>
    </message>
    <message>
        <source>another file with this name is where the recipe&apos;s image should go</source>
        <translation>レシピの画像を置く場所に、同じ名前の別のファイルがあります</translation>
    </message>
    <message>
        <source>the recipe&apos;s numbers cannot be written exactly</source>
        <translation>レシピの数を正確に書けません</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>数値が %1 個必要です</translation>
    </message>
    <message>
        <source>its parent is neither one of the segments before it nor -1</source>
        <translation>親が、それより前のセグメントでも -1 でもありません</translation>
    </message>
    <message>
        <source>1 to %1 segments are expected</source>
        <translation>1 から %1 個までのセグメントが必要です</translation>
    </message>
    <message>
        <source>a recipe that was not read from a file cannot name files</source>
        <translation>ファイルでないレシピではファイルを指定できません</translation>
    </message>
    <message>
        <source>internode %1 has no room for buds above the ground</source>
        <translation>節間 %1 には、地面より上に芽をつける余地がありません</translation>
    </message>
    <message>
        <source>nothing was taken away</source>
        <translation>何も取り除かれませんでした</translation>
    </message>
    <message>
        <source>there is no branch from internode %1 to internode %2</source>
        <translation>節間 %1 から節間 %2 までの枝はありません</translation>
    </message>
    <message>
        <source>internode %1 has no profile to take away</source>
        <translation>節間 %1 に解除する断面形はありません</translation>
    </message>
    <message>
        <source>internode %1 has no twist to take away</source>
        <translation>節間 %1 に解除するねじりはありません</translation>
    </message>
    <message>
        <source>a branch must begin at exactly one internode</source>
        <translation>枝の始まりになる節間は 1 つだけです</translation>
    </message>
    <message>
        <source>true is expected</source>
        <translation>true が必要です</translation>
    </message>
    <message>
        <source>the other end of the branch (“to”) is missing</source>
        <translation>枝のもう一方の端 (「to」) がありません</translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation>次のいずれかが必要です: %1</translation>
    </message>
    <message>
        <source>a stroke needs at least %1 points</source>
        <translation>線には点が %1 個以上必要です</translation>
    </message>
    <message>
        <source>at most %1 radii are expected</source>
        <translation>半径は %1 個までです</translation>
    </message>
    <message>
        <source>numbers from 0 to %1 are expected, in m</source>
        <translation>0 から %1 までの数が必要です（m）</translation>
    </message>
    <message>
        <source>internode %1 cannot bear such a leaf</source>
        <translation>節間 %1 にはそのような葉を付けられません</translation>
    </message>
    <message>
        <source>no leaves at internode %1 can be arranged by “%2”</source>
        <translation>節間 %1 の葉は「%2」では配置できません</translation>
    </message>
    <message>
        <source>a quaternion is expected: four numbers x, y, z, w within ±1, not all of them 0</source>
        <translation>四元数が必要です。±1 以内の四つの数 x, y, z, w で、すべてが 0 ではないもの</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>true か false が必要です</translation>
    </message>
    <message>
        <source>nothing under the brush could be erased</source>
        <translation>ブラシの下に消せるものがありませんでした</translation>
    </message>
    <message>
        <source>there were no twigs under the brush to take</source>
        <translation>ブラシの下に取れる小枝がありませんでした</translation>
    </message>
    <message>
        <source>the branch of internode %1 is already kept clear that far</source>
        <translation>節間 %1 の枝はすでにその状態です</translation>
    </message>
    <message>
        <source>three numbers within ±%1 are expected: x, y, z, in m</source>
        <translation>±%1 の範囲の 3 つの数（x、y、z、単位 m）が必要です</translation>
    </message>
    <message>
        <source>four numbers are expected: x, y, z within ±%1 m, and a radius within 0…%2 m</source>
        <translation>4 つの数が必要です：±%1 m の x、y、z と、0…%2 m の半径</translation>
    </message>
    <message>
        <source>one stroke or more is expected</source>
        <translation>1 つ以上の線が必要です</translation>
    </message>
    <message>
        <source>growth stopped at %1 internodes, since the memory of this machine may not hold more</source>
        <translation>このコンピューターのメモリに入らないかもしれないため、成長は %1 節間で止まりました</translation>
    </message>
    <message>
        <source>there is no room for more profiles</source>
        <translation>これ以上の断面形は入りません</translation>
    </message>
</context>
<context>
    <name>RecipeTool</name>
    <message>
        <source>A recipe is playing; Escape hands the brush to you.</source>
        <translation>レシピを再生中です。Esc を押すとブラシを受け取れます。</translation>
    </message>
</context>
<context>
    <name>ReduceTool</name>
    <message>
        <source>Press a branch and hold: it shrinks until you let go</source>
        <translation>枝を押し続けると、離すまで縮みます</translation>
    </message>
</context>
<context>
    <name>ReproduceTool</name>
    <message>
        <source>turn the view back to where you drew the first stroke, or press Esc to discard it</source>
        <translation>最初の線を描いた向きに視点を戻すか、Esc で最初の線を取り消してください</translation>
    </message>
    <message>
        <source>look at the tree from the side, not from above or below, to draw its shape</source>
        <translation>木の姿を描くには、上や下からではなく横から見てください</translation>
    </message>
    <message>
        <source>there is no tree yet to give another shape: make one first</source>
        <translation>新しい姿にする木がまだありません。先に木を作ってください</translation>
    </message>
    <message>
        <source>that is a point: draw the trunk as a line</source>
        <translation>これは点です。幹は線で描いてください</translation>
    </message>
    <message>
        <source>that is a point: draw the silhouette as a line around the crown</source>
        <translation>これは点です。輪郭は樹冠を囲む線で描いてください</translation>
    </message>
    <message>
        <source>the stroke reaches too far away from the tree</source>
        <translation>線が木から離れすぎています</translation>
    </message>
    <message>
        <source>the trunk must be an open line</source>
        <translation>幹は閉じていない線でなければなりません</translation>
    </message>
    <message>
        <source>the tip of the trunk must be inside the silhouette</source>
        <translation>幹の先端は輪郭の中になければなりません</translation>
    </message>
    <message>
        <source>the silhouette must enclose the tip of the trunk</source>
        <translation>輪郭は幹の先端を囲まなければなりません</translation>
    </message>
    <message>
        <source>the trunk must be above the ground: draw it from its foot to its tip</source>
        <translation>幹は地面より上になければなりません。根元から先端まで描いてください</translation>
    </message>
    <message>
        <source>Make a tree first, with Brush or Sketch; then draw its new shape</source>
        <translation>先にブラシかスケッチで木を作り、それから新しい姿を描いてください</translation>
    </message>
    <message>
        <source>Draw the new trunk, then the silhouette of its crown</source>
        <translation>新しい幹を描き、次に樹冠の輪郭を描きます</translation>
    </message>
</context>
<context>
    <name>SafetyCopy</name>
    <message>
        <source>another program has changed it</source>
        <translation>別のプログラムが変更しました</translation>
    </message>
    <message>
        <source>a change of the tree is too large</source>
        <translation>木の変更が大きすぎます</translation>
    </message>
    <message>
        <source>it is not up to date</source>
        <translation>最新ではありません</translation>
    </message>
    <message>
        <source>what was done last cannot be brought back</source>
        <translation>最後に行ったことは復元できません</translation>
    </message>
</context>
<context>
    <name>SelectBudTool</name>
    <message>
        <source>Tap a bud, and it alone grows from now on; tap beside the tree to let all grow again</source>
        <translation>芽をタップすると、その芽だけが成長します。木の外をタップすると、すべての芽に戻ります</translation>
    </message>
    <message>
        <source>There is no bud here. Buds near the pointer are shown as dots.</source>
        <translation>ここに芽はありません。ポインターの近くの芽は点で示されます。</translation>
    </message>
    <message>
        <source>No bud is close enough. Tap one of the dots, or zoom in with the wheel.</source>
        <translation>そこまで近い芽はありません。点のどれかをタップするか、ホイールで近づいてください。</translation>
    </message>
</context>
<context>
    <name>Skeleton</name>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>長すぎます</translation>
    </message>
    <message>
        <source>%1 numbers are expected</source>
        <translation>数値が %1 個必要です</translation>
    </message>
    <message>
        <source>“%1” is not a number for %2</source>
        <translation>「%1」は %2 の数値ではありません</translation>
    </message>
    <message>
        <source>its id %1 is already used in line %2</source>
        <translation>id %1 は %2 行目にもあります</translation>
    </message>
    <message>
        <source>its parent, id %1, does not exist</source>
        <translation>親の id %1 がありません</translation>
    </message>
    <message>
        <source>it is its own ancestor</source>
        <translation>自分が支えているものに支えられています</translation>
    </message>
    <message>
        <source>it lies more than %1 m away</source>
        <translation>%1 m より遠くにあります</translation>
    </message>
    <message>
        <source>its radius is not between 0 and %1 m</source>
        <translation>半径が 0 から %1 m の間にありません</translation>
    </message>
    <message>
        <source>“%1” is expected</source>
        <translation>「%1」が必要です</translation>
    </message>
    <message>
        <source>a tree of more than %1 segments cannot be imported</source>
        <translation>%1 個を超えるセグメントの木は読み込めません</translation>
    </message>
    <message>
        <source>there are no segments</source>
        <translation>セグメントがありません</translation>
    </message>
    <message>
        <source>segment %1</source>
        <translation>セグメント %1</translation>
    </message>
    <message>
        <source>it stands more than %1 m from the thickest trunk</source>
        <translation>最も太い幹から %1 m より離れています</translation>
    </message>
    <message>
        <source>it is longer than %1 m, or more than %2 m away</source>
        <translation>%1 m より長いか、%2 m より遠くにあります</translation>
    </message>
    <message>
        <source>no segment has a length</source>
        <translation>長さのあるセグメントがありません</translation>
    </message>
</context>
<context>
    <name>Sketch</name>
    <message>
        <source>a trunk can only be drawn where nothing has grown</source>
        <translation>幹は何も育っていないところにだけ描けます</translation>
    </message>
    <message>
        <source>the stroke has no length</source>
        <translation>線に長さがありません</translation>
    </message>
    <message>
        <source>the stroke is longer than %1 m, or more than %2 m away</source>
        <translation>線が %1 m より長いか、%2 m より遠くにあります</translation>
    </message>
    <message>
        <source>only a tree with one root can be given depth</source>
        <translation>奥行きを与えられるのは根が一つの木だけです</translation>
    </message>
    <message>
        <source>the tree has depth already</source>
        <translation>木にはもう奥行きがあります</translation>
    </message>
    <message>
        <source>draw branches first: a trunk alone has no depth to find</source>
        <translation>先に枝を描いてください。幹だけでは奥行きを決められません</translation>
    </message>
    <message>
        <source>the wood that it would grow from is gone</source>
        <translation>枝が出るはずの木部がもうありません</translation>
    </message>
    <message>
        <source>the copies would have more than %1 internodes</source>
        <translation>写しの節間が %1 を超えます</translation>
    </message>
    <message>
        <source>a copy would reach more than %1 m away</source>
        <translation>写しが %1 m より遠くに達します</translation>
    </message>
    <message>
        <source>internode %1 is not alive</source>
        <translation>節間 %1 は生きていません</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries no branch to imitate</source>
        <translation>節間 %1 の枝には手本になる枝がありません</translation>
    </message>
    <message>
        <source>the branch of internode %1 carries nothing to copy</source>
        <translation>節間 %1 の枝には写すものがありません</translation>
    </message>
    <message>
        <source>more than %1 branches are listed</source>
        <translation>枝が %1 本を超えて挙げられています</translation>
    </message>
    <message>
        <source>there is no other branch to copy to</source>
        <translation>写す先の枝がほかにありません</translation>
    </message>
    <message>
        <source>all other branches are too short for what the branch of internode %1 carries</source>
        <translation>ほかの枝はどれも、節間 %1 の枝に付くものには短すぎます</translation>
    </message>
    <message>
        <source>an internode would be longer than %1 m or lie more than %2 m away</source>
        <translation>節間が %1 m より長くなるか、%2 m より遠くになります</translation>
    </message>
    <message>
        <source>the new trunk has no length</source>
        <translation>新しい幹に長さがありません</translation>
    </message>
    <message>
        <source>the silhouette encloses nothing</source>
        <translation>シルエットが何も囲んでいません</translation>
    </message>
    <message>
        <source>a trunk cannot be moved</source>
        <translation>幹は移せません</translation>
    </message>
    <message>
        <source>a branch cannot stand on itself</source>
        <translation>枝をその枝自身に付けることはできません</translation>
    </message>
    <message>
        <source>a branch can be made %1 to %2 times as large</source>
        <translation>枝の大きさは %1 倍から %2 倍までです</translation>
    </message>
</context>
<context>
    <name>SketchTool</name>
    <message>
        <source>Draw the trunk, then branches; two strokes side by side give a branch its width</source>
        <translation>幹を描き、次に枝を描きます。並べて描いた二本の線は枝の太さになります</translation>
    </message>
    <message>
        <source>Draw a branch from the wood; hold Shift and draw across branches to take them away</source>
        <translation>木部から枝を描きます。Shift を押して枝を横切ると取り去ります</translation>
    </message>
    <message>
        <source>Two sides of one branch</source>
        <translation>一本の枝の両側</translation>
    </message>
    <message>
        <source>A leaf</source>
        <translation>葉</translation>
    </message>
    <message>
        <source>A crown</source>
        <translation>樹冠</translation>
    </message>
</context>
<context>
    <name>StrandProfile</name>
    <message>
        <source>an outline needs at least three points</source>
        <translation>輪郭には少なくとも 3 つの点が必要です</translation>
    </message>
    <message>
        <source>an outline reaches too far</source>
        <translation>輪郭が遠くまで延びすぎています</translation>
    </message>
    <message>
        <source>it has no outline</source>
        <translation>輪郭がありません</translation>
    </message>
    <message>
        <source>it has more than %1 outlines or %2 points</source>
        <translation>輪郭が %1 個、または点が %2 個を超えています</translation>
    </message>
    <message>
        <source>it has more than %1 attractors</source>
        <translation>アトラクターが %1 個を超えています</translation>
    </message>
    <message>
        <source>an attractor lies too far away</source>
        <translation>アトラクターが遠すぎます</translation>
    </message>
    <message>
        <source>its outline crosses itself</source>
        <translation>輪郭が自分自身と交差しています</translation>
    </message>
    <message>
        <source>its outlines cross each other</source>
        <translation>輪郭どうしが交差しています</translation>
    </message>
    <message>
        <source>its outline has no area</source>
        <translation>輪郭が何も囲んでいません</translation>
    </message>
</context>
<context>
    <name>SunTool</name>
    <message>
        <source>%1° high</source>
        <translation>高さ %1°</translation>
    </message>
    <message>
        <source>Drag the sun around the tree</source>
        <translation>太陽を木のまわりでドラッグします。</translation>
    </message>
</context>
<context>
    <name>Tree</name>
    <message>
        <source>its internode is missing</source>
        <translation>節間がありません</translation>
    </message>
    <message>
        <source>it is out of order</source>
        <translation>順序が正しくありません</translation>
    </message>
    <message>
        <source>its place of attachment is out of range</source>
        <translation>付く位置が範囲外です</translation>
    </message>
    <message>
        <source>its rotation is not valid</source>
        <translation>回転の値が正しくありません</translation>
    </message>
    <message>
        <source>its length is out of range</source>
        <translation>長さが範囲外です</translation>
    </message>
    <message>
        <source>its vigour is out of range</source>
        <translation>樹勢が範囲外です</translation>
    </message>
    <message>
        <source>it grows from a bud that does not exist</source>
        <translation>存在しない芽から伸びています</translation>
    </message>
    <message>
        <source>it has a bud that does not exist</source>
        <translation>存在しない芽があります</translation>
    </message>
    <message>
        <source>its kind is not known</source>
        <translation>種類が不明です</translation>
    </message>
    <message>
        <source>its width is out of range</source>
        <translation>太さが範囲外です</translation>
    </message>
    <message>
        <source>its root lies too far away</source>
        <translation>根の位置が遠すぎます</translation>
    </message>
    <message>
        <source>its parent does not come before it</source>
        <translation>親がそれより前にありません</translation>
    </message>
    <message>
        <source>its parameters are missing</source>
        <translation>パラメーターがありません</translation>
    </message>
    <message>
        <source>it was born in the future</source>
        <translation>未来に生まれています</translation>
    </message>
    <message>
        <source>it died before it was born, or in the future</source>
        <translation>生まれる前か、未来に枯れています</translation>
    </message>
    <message>
        <source>it lives on a dead internode</source>
        <translation>枯れた節間の上に生きています</translation>
    </message>
    <message>
        <source>the columns of the tree have different lengths</source>
        <translation>木のデータ列の長さがそろっていません</translation>
    </message>
    <message>
        <source>the tree is empty or lacks its parameters</source>
        <translation>木が空か、パラメーターがありません</translation>
    </message>
    <message>
        <source>the tree has more than %1 parameter sets</source>
        <translation>木のパラメーターが %1 組を超えています</translation>
    </message>
    <message>
        <source>the seedling must stand at the base</source>
        <translation>苗は根元になければなりません</translation>
    </message>
    <message>
        <source>two internodes continue the same axis</source>
        <translation>2 つの節間が同じ軸を継いでいます</translation>
    </message>
    <message>
        <source>another internode has its key</source>
        <translation>別の節間が同じキーを持っています</translation>
    </message>
    <message>
        <source>internode %1: %2</source>
        <translation>節間 %1: %2</translation>
    </message>
    <message>
        <source>the columns of the placed leaves have different lengths</source>
        <translation>配置した葉のデータ列の長さがそろっていません</translation>
    </message>
    <message>
        <source>placed leaf %1: %2</source>
        <translation>配置した葉 %1: %2</translation>
    </message>
    <message>
        <source>entry %1 of “%2”: %3</source>
        <translation>「%2」の項目 %1: %3</translation>
    </message>
    <message>
        <source>lasso %1: its plane or its points are not valid</source>
        <translation>投げ縄 %1: 描画面か点が正しくありません</translation>
    </message>
    <message>
        <source>the lassos in force are out of order</source>
        <translation>有効な投げ縄の順序が正しくありません</translation>
    </message>
    <message>
        <source>profile %1: %2</source>
        <translation>断面形 %1: %2</translation>
    </message>
    <message>
        <source>its profile is missing</source>
        <translation>断面形がありません</translation>
    </message>
    <message>
        <source>its twist is out of range</source>
        <translation>ねじりが範囲外です</translation>
    </message>
    <message>
        <source>its added vigour is out of range</source>
        <translation>加えた勢いが範囲外です</translation>
    </message>
    <message>
        <source>the length that is kept clear is out of range</source>
        <translation>下枝を止める長さが範囲外です</translation>
    </message>
    <message>
        <source>the length that was drawn is out of range</source>
        <translation>描かれた長さが範囲外です</translation>
    </message>
</context>
<context>
    <name>TwistTool</name>
    <message>
        <source>%1° from node to node</source>
        <translation>節ごとに %1°</translation>
    </message>
    <message>
        <source>Drag along a branch, or around it, to twist its strands; double-tap to untwist them</source>
        <translation>枝に沿って、または枝を回すようにドラッグするとねじれます。2 回タップでねじりが戻ります</translation>
    </message>
</context>
<context>
    <name>WidthTool</name>
    <message>
        <source>Tap a branch to fix its width; drag the ends of the handle to change it</source>
        <translation>枝をタップして太さを固定し、ハンドルの端をドラッグして変えます</translation>
    </message>
</context>
<context>
    <name>WithinMemory</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>このためのメモリが足りません。</translation>
    </message>
</context>
<context>
    <name>ZipArchive</name>
    <message>
        <source>the archive could not be compressed: %1</source>
        <translation>アーカイブを作成できませんでした: %1</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>壊れています</translation>
    </message>
    <message>
        <source>it is not a project file, or a damaged one (%1)</source>
        <translation>プロジェクトファイルではないか、壊れています (%1)</translation>
    </message>
    <message>
        <source>it is not a project file: it is empty</source>
        <translation>プロジェクトファイルではありません。中身が空です</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>it has %1 bytes, but %2 are expected</source>
        <translation>%1 バイトですが、%2 バイトのはずです</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>%1 バイトを超えています</translation>
    </message>
    <message>
        <source>it claims to hold far more than its size allows</source>
        <translation>大きさから考えられるよりもはるかに多くの内容を持つことになっています</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherController</name>
    <message>
        <source>Draw a tree first: then there can be others like it.</source>
        <translation>まず木を描いてください。そうすれば、似た別の木を作れます。</translation>
    </message>
    <message>
        <source>Another Like This</source>
        <translation>これに似た別の木</translation>
    </message>
</context>
<context>
    <name>espalier::AnotherPanel</name>
    <message>
        <source>Another Like This</source>
        <translation>これに似た別の木</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Tree %1 of %2</source>
        <translation>木 %1 / %2</translation>
    </message>
    <message>
        <source>Take this tree in place of yours. Undo brings yours back.</source>
        <translation>この木を今の木と入れ替えます。「元に戻す」で元の木に戻ります。</translation>
    </message>
    <message>
        <source>Six More</source>
        <translation>さらに 6 本</translation>
    </message>
    <message>
        <source>They are growing…</source>
        <translation>育てています…</translation>
    </message>
    <message>
        <source>The same strokes; only chance differs.</source>
        <translation>同じストローク。違うのは偶然だけです。</translation>
    </message>
</context>
<context>
    <name>espalier::ArchitecturePanel</name>
    <message>
        <source>Architecture</source>
        <translation>樹形</translation>
    </message>
    <message>
        <source>More ›</source>
        <translation>詳細 ›</translation>
    </message>
    <message>
        <source>Everything else that steers growth: shoots, shade, room to grow</source>
        <translation>成長を左右する残りの項目: シュート、日陰、成長の余地</translation>
    </message>
    <message>
        <source>‹ Less</source>
        <translation>‹ 簡易</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>樹種</translation>
    </message>
    <message>
        <source>Set all parameters of the vigour model to those of a species.</source>
        <translation>樹勢モデルの値をすべて、その樹種の育ち方に合わせます</translation>
    </message>
    <message>
        <source>No species</source>
        <translation>樹種なし</translation>
    </message>
</context>
<context>
    <name>espalier::Autosave</name>
    <message>
        <source>A tree that was never saved</source>
        <translation>未保存の木</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>フォルダー %1 に書き込めません。</translation>
    </message>
</context>
<context>
    <name>espalier::BackgroundPanel</name>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>The colour of the background, or of its lower edge.</source>
        <translation>背景の色、または下端の色です。</translation>
    </message>
    <message>
        <source>The colour at the upper edge.</source>
        <translation>上端の色です。</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>太陽</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Show no picture behind the tree.</source>
        <translation>木の後ろに下絵を表示しません。</translation>
    </message>
    <message>
        <source>Lower colour</source>
        <translation>下の色</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Upper colour</source>
        <translation>上の色</translation>
    </message>
    <message>
        <source>Use for New Trees</source>
        <translation>新しい木に使う</translation>
    </message>
    <message>
        <source>New trees begin with this background, ground and light. The picture stays with this tree.</source>
        <translation>新しい木はこの背景、地面、光で始まります。下絵はこの木だけのものです。</translation>
    </message>
    <message>
        <source>Reference picture</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Choose a picture to show behind the tree while you draw. It is saved with the tree.</source>
        <translation>描くときに木の後ろに表示する画像を選びます。木と一緒に保存されます。</translation>
    </message>
</context>
<context>
    <name>espalier::BendPopOut</name>
    <message>
        <source>Stiffness</source>
        <translation>曲げにくさ</translation>
    </message>
    <message>
        <source>&lt;b&gt;Stiffness&lt;/b&gt;&lt;br&gt;How much a branch resists being bent: a stiff one bends in a wide curve and is stretched sooner.</source>
        <translation>&lt;b&gt;曲げにくさ&lt;/b&gt;&lt;br&gt;枝がどれだけ曲げに逆らうかです。硬い枝はゆるやかな弧を描き、そのぶん早く引き伸ばされます。</translation>
    </message>
    <message>
        <source>Holds length</source>
        <translation>伸びにくさ</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds length&lt;/b&gt;&lt;br&gt;How much a branch resists being stretched: at low values it follows the hand further.</source>
        <translation>&lt;b&gt;伸びにくさ&lt;/b&gt;&lt;br&gt;枝がどれだけ伸びに逆らうかです。長さを保つか、手に遠くまでついてくるかが決まります。</translation>
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
        <translation>ジグザグ</translation>
    </message>
    <message>
        <source>acute</source>
        <translation>鋭角</translation>
    </message>
    <message>
        <source>spreading</source>
        <translation>開出</translation>
    </message>
    <message>
        <source>reflexed</source>
        <translation>反曲</translation>
    </message>
</context>
<context>
    <name>espalier::BrushPanel</name>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pressure curve&lt;/b&gt;&lt;br&gt;How firmly the pen must press for the full radius. Drag the curve, or press here with your pen to try it.</source>
        <translation>&lt;b&gt;筆圧カーブ&lt;/b&gt;&lt;br&gt;半径いっぱいにするのに、ペンをどれだけ強く押すかです。カーブをドラッグして変えるか、ここをペンで押して試せます。</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
</context>
<context>
    <name>espalier::BrushRadius</name>
    <message>
        <source>&lt;b&gt;Brush radius&lt;/b&gt; [ ]&lt;br&gt;A large brush grows a crown into the space it passes; towards zero it draws a single branch exactly along the stroke.</source>
        <translation>&lt;b&gt;ブラシの半径&lt;/b&gt; [ ]&lt;br&gt;大きいブラシは通った空間に樹冠を育て、ゼロに近いとストロークどおりに 1 本の枝を描きます。</translation>
    </message>
    <message>
        <source>draws a branch</source>
        <translation>枝を描きます</translation>
    </message>
    <message>
        <source>grows a crown</source>
        <translation>樹冠を育てます</translation>
    </message>
</context>
<context>
    <name>espalier::DirectionDiagram</name>
    <message>
        <source>Weights of direction</source>
        <translation>方向の重み</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>均衡</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>直進</translation>
    </message>
    <message>
        <source>tropism</source>
        <translation>屈性</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>空き空間</translation>
    </message>
    <message>
        <source>H straight on</source>
        <translation>H 直進</translation>
    </message>
    <message>
        <source>T tropism</source>
        <translation>T 屈性</translation>
    </message>
    <message>
        <source>E space</source>
        <translation>E 空間</translation>
    </message>
</context>
<context>
    <name>espalier::DocumentFile</name>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
</context>
<context>
    <name>espalier::ExportQueue</name>
    <message>
        <source>Writing %1</source>
        <translation>%1 を書き出し中</translation>
    </message>
    <message>
        <source>Writing %1, then %2</source>
        <translation>%1 を書き出し中、次は %2</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 を書き出しました</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 は書き出されませんでした。</translation>
    </message>
    <message>
        <source>Not exported. %1</source>
        <translation>書き出せませんでした。%1</translation>
    </message>
</context>
<context>
    <name>espalier::FileController</name>
    <message>
        <source>Not saved. %1</source>
        <translation>保存できませんでした。%1</translation>
    </message>
    <message>
        <source>No safety copy can be saved: %1</source>
        <translation>クラッシュに備えた控えを保存できません: %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 を保存中</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存しました</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>一覧を消去</translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. The tree is still here; save it to keep it.</source>
        <translation>%1 は別のプログラムで移動または削除されました。木はまだここにあります。残すには保存してください。</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program. Saving here asks before it replaces that version.</source>
        <translation>%1 は別のウィンドウかプログラムで変更されました。ここで保存すると、その変更を置き換える前に確認します。</translation>
    </message>
    <message>
        <source>Open Again</source>
        <translation>開き直す</translation>
    </message>
    <message>
        <source>Keep This</source>
        <translation>今の木を残す</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 を開いています</translation>
    </message>
</context>
<context>
    <name>espalier::GravimorphismDiagram</name>
    <message>
        <source>all alike</source>
        <translation>均等</translation>
    </message>
    <message>
        <source>amphitony</source>
        <translation>側方優勢</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>上下優勢</translation>
    </message>
    <message>
        <source>epitony</source>
        <translation>上側優勢</translation>
    </message>
    <message>
        <source>hypotony</source>
        <translation>下側優勢</translation>
    </message>
    <message>
        <source>side %1</source>
        <translation>横 %1</translation>
    </message>
    <message>
        <source>above %1 · below %2</source>
        <translation>上 %1 · 下 %2</translation>
    </message>
</context>
<context>
    <name>espalier::GrowPopOut</name>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Play what happened from here on, or all of it.</source>
        <translation>ここから先の、または全体の経過を再生します</translation>
    </message>
    <message>
        <source>Hold to grow</source>
        <translation>押して成長</translation>
    </message>
    <message>
        <source>A tap grows one step; hold to grow on. One hold is one undo step.</source>
        <translation>タップで 1 ステップ成長し、押し続けると成長し続けます。1 回の長押しが、元に戻すときの 1 回分です。</translation>
    </message>
    <message>
        <source>Steps to grow</source>
        <translation>成長ステップ数</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Grow that many steps, as one undo step. Escape stops.</source>
        <translation>この数だけ成長します。元に戻すときは 1 回分です。Esc で止まります。</translation>
    </message>
    <message>
        <source>Back: the tree ungrows, through all that you did. Forth: it comes back. Pull the handle well past the mark, and the tree grows. Far from the slider, or with Shift, a drag is finer.</source>
        <translation>戻すと、行った操作をさかのぼって木が縮みます。進めると元に戻ります。つまみを印よりずっと先まで引くと木が育ちます。スライダーから離れるか Shift を押すと、細かく動かせます。</translation>
    </message>
    <message>
        <source>New steps: %L1</source>
        <translation>新しいステップ：%L1</translation>
    </message>
    <message>
        <source>Moment %L1 of %L2</source>
        <translation>時点 %L1 / %L2</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>苗</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPage</name>
    <message>
        <source>Help page</source>
        <translation>ヘルプのページ</translation>
    </message>
</context>
<context>
    <name>espalier::HelpPanel</name>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Back to the previous page</source>
        <translation>前のページに戻る</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>Close the help</source>
        <translation>ヘルプを閉じる</translation>
    </message>
    <message>
        <source>Close the help (Esc)</source>
        <translation>ヘルプを閉じる (Esc)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>ヘルプを検索</translation>
    </message>
    <message>
        <source>Help pages</source>
        <translation>ヘルプのページ一覧</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>案内を見る</translation>
    </message>
    <message>
        <source>Play this recipe</source>
        <translation>このレシピを再生</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>見つかりません</translation>
    </message>
</context>
<context>
    <name>espalier::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Seedling</source>
        <translation>苗</translation>
    </message>
</context>
<context>
    <name>espalier::LassoPopOut</name>
    <message>
        <source>Regrow</source>
        <translation>再成長</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>ここで停止</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>外形</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>&lt;b&gt;Regrow&lt;/b&gt;&lt;br&gt;Take the tree back to how it was before its envelope was drawn, and let it fill the envelope again with the parameters that are in force now. What you have done to it since is lost.</source>
        <translation>&lt;b&gt;再成長&lt;/b&gt;&lt;br&gt;外形を描く前の状態まで木を戻し、今のパラメーターで外形をもう一度満たします。その後に加えた操作は失われます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Remove&lt;/b&gt;&lt;br&gt;Take the envelope away; the tree stays as it grew.</source>
        <translation>&lt;b&gt;削除&lt;/b&gt;&lt;br&gt;外形を取り除きます。木は育ったまま残ります。</translation>
    </message>
    <message>
        <source>Keep what has grown. Escape takes it back instead.</source>
        <translation>ここまで育ったものを残します。Esc では取り消します。</translation>
    </message>
    <message>
        <source>Show the envelope.</source>
        <translation>外形を表示します。</translation>
    </message>
    <message>
        <source>Show the points of free space that the tree grows into.</source>
        <translation>木が伸びていく空き空間の点を表示します。</translation>
    </message>
</context>
<context>
    <name>espalier::LeafChoices</name>
    <message>
        <source>Continue with</source>
        <translation>続け方</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>もう一枚</translation>
    </message>
    <message>
        <source>One more leaf at this place; all of them stand evenly around the branch.</source>
        <translation>この場所に葉をもう一枚。すべての葉が枝のまわりに均等に並びます。</translation>
    </message>
    <message>
        <source>Whorls</source>
        <translation>輪生</translation>
    </message>
    <message>
        <source>Whorls like this along the whole branch, at the same spacing.</source>
        <translation>同じ輪を、この間隔で枝全体に。</translation>
    </message>
    <message>
        <source>Alternate</source>
        <translation>互生</translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation>対生</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, all in one plane.</source>
        <translation>枝に沿って葉を二枚ずつ、すべて一つの面に。</translation>
    </message>
    <message>
        <source>Decussate</source>
        <translation>十字対生</translation>
    </message>
    <message>
        <source>Pairs of leaves along the branch, each across the one below it.</source>
        <translation>枝に沿って葉を二枚ずつ、どの組も下の組と直交させて。</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryCards</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryController</name>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 をゴミ箱に移動しました。</translation>
    </message>
    <message>
        <source>The system has no trash here. %1 is in %2 now.</source>
        <translation>ここではシステムのゴミ箱を使えません。%1 を %2 に移しました。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
</context>
<context>
    <name>espalier::LibraryPanel</name>
    <message>
        <source>Keep This Tree</source>
        <translation>この木を保存</translation>
    </message>
    <message>
        <source>Start from This</source>
        <translation>これから始める</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>ライブラリ</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>木</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Save the open tree in the library.</source>
        <translation>開いている木をライブラリに保存します。</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>木に戻る</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>A new seedling that grows the way this tree does.</source>
        <translation>この木と同じように育つ新しい苗です。</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>樹種</translation>
    </message>
    <message>
        <source>Your Trees</source>
        <translation>自分の木</translation>
    </message>
    <message>
        <source>No tree has a name like that.</source>
        <translation>その名前のものはありません。</translation>
    </message>
    <message>
        <source>No trees yet. “Keep This Tree” saves the open tree here.</source>
        <translation>まだありません。「この木を保存」で、開いている木をここに保存します。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Move to Trash</source>
        <translation>ゴミ箱に移動</translation>
    </message>
</context>
<context>
    <name>espalier::LookChoice</name>
    <message>
        <source>Choose an image…</source>
        <translation>画像を選択…</translation>
    </message>
    <message>
        <source>A PNG or JPEG of one leaf, stalk down, on a transparent or plain background</source>
        <translation>葉 1 枚の PNG か JPEG。葉柄を下にし、背景は透明か無地のもの</translation>
    </message>
    <message>
        <source>A PNG or JPEG of bark; normal and roughness maps found beside it are used, too</source>
        <translation>樹皮の PNG か JPEG。同じ場所にある法線マップと粗さマップも取り込みます</translation>
    </message>
    <message>
        <source>Your image: %1</source>
        <translation>自分の画像: %1</translation>
    </message>
</context>
<context>
    <name>espalier::LookController</name>
    <message>
        <source>Image of a Leaf</source>
        <translation>葉の画像</translation>
    </message>
    <message>
        <source>Image of Bark</source>
        <translation>樹皮の画像</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg)</source>
        <translation>画像 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>葉</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>樹皮</translation>
    </message>
    <message>
        <source>Maps found beside it are used, too.</source>
        <translation>隣にあるマップも取り込みました。</translation>
    </message>
    <message>
        <source>What is %1 for?</source>
        <translation>%1 を何に使いますか？</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>This tree has had so many images that its file has no room for another one.</source>
        <translation>この木はすでに多くの画像を使ったため、ファイルにはもう画像が入りません。</translation>
    </message>
</context>
<context>
    <name>espalier::MainWindow</name>
    <message>
        <source>The tree has no room left to grow.</source>
        <translation>木にはもう成長の余地がありません。</translation>
    </message>
    <message>
        <source>%1[*] – Espalier</source>
        <translation>%1[*] – Espalier</translation>
    </message>
    <message>
        <source>Growing %1</source>
        <translation>%1 を成長中</translation>
    </message>
    <message>
        <source>Not everything that the recipe names was found in the tree (%1 of %2 operations): %3</source>
        <translation>レシピの操作 %2 個のうち %1 個で、することがないか、指定したものがすべては見つかりませんでした: %3</translation>
    </message>
    <message>
        <source>Building the wood from strands</source>
        <translation>ストランドの木を作成中</translation>
    </message>
    <message>
        <source>Growth has stopped: the tree has %L1 internodes, and the memory of this machine may not hold a larger one.</source>
        <translation>成長を止めました。木には %L1 の節間があり、このコンピューターのメモリにはこれより大きい木が入らないかもしれません。</translation>
    </message>
    <message>
        <source>Allow More</source>
        <translation>さらに成長させる</translation>
    </message>
    <message>
        <source>Leave It</source>
        <translation>このままにする</translation>
    </message>
    <message>
        <source>The oldest steps of the history were dropped, so that it takes no more than %1 MB.</source>
        <translation>履歴が %1 MB を超えないように、古いステップを削除しました。</translation>
    </message>
</context>
<context>
    <name>espalier::Notice</name>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
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
        <translation>密</translation>
    </message>
    <message>
        <source>ordinary</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>airy</source>
        <translation>疎</translation>
    </message>
</context>
<context>
    <name>espalier::PictureController</name>
    <message>
        <source>Drawing the picture</source>
        <translation>画像を描いています</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>画像をクリップボードに入れました。</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存しました</translation>
    </message>
    <message>
        <source>Not saved. %1</source>
        <translation>保存されていません。%1</translation>
    </message>
</context>
<context>
    <name>espalier::PictureSheet</name>
    <message>
        <source>Like the window, %1 × %2</source>
        <translation>ウィンドウと同じ、%1 × %2</translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>フル HD、1920 × 1080</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K、3840 × 2160</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>正方形、1080 × 1080</translation>
    </message>
    <message>
        <source>Large square, 2048 × 2048</source>
        <translation>大きな正方形、2048 × 2048</translation>
    </message>
    <message>
        <source>Portrait, 1080 × 1350</source>
        <translation>縦長、1080 × 1350</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>その他の大きさ</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>透明な背景</translation>
    </message>
    <message>
        <source>With the shadow on the ground</source>
        <translation>地面の影も含める</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>As shown now</source>
        <translation>今の表示のまま</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>正面から</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>横から</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>斜めから</translation>
    </message>
    <message>
        <source>Nothing is behind the tree, so that it can be laid over other pictures.</source>
        <translation>木の後ろに何もないので、ほかの画像に重ねられます。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>View</source>
        <translation>視点</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Put the picture on the clipboard.</source>
        <translation>画像をクリップボードに入れます。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
</context>
<context>
    <name>espalier::PressureCurve</name>
    <message>
        <source>Pressure curve</source>
        <translation>筆圧カーブ</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileCanvas</name>
    <message>
        <source>Cross-section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Draw an outline first: attractors gather the strands within it.</source>
        <translation>先に輪郭を描いてください。アトラクターは、その中のストランドを集めます。</translation>
    </message>
    <message>
        <source>This cannot be the profile: %1.</source>
        <translation>この断面形は使えません: %1。</translation>
    </message>
    <message>
        <source>Tap a branch of the tree to see its cross-section.</source>
        <translation>木の枝をタップすると、断面が表示されます。</translation>
    </message>
</context>
<context>
    <name>espalier::ProfileController</name>
    <message>
        <source>The two places are not on one branch.</source>
        <translation>2 つの場所は同じ枝にありません。</translation>
    </message>
    <message>
        <source>The other place has no profile to blend with.</source>
        <translation>もう一方の場所に、補間する断面形がありません。</translation>
    </message>
    <message>
        <source>There is no room for more profiles.</source>
        <translation>これ以上の断面形は入りません。</translation>
    </message>
</context>
<context>
    <name>espalier::ProfilePanel</name>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>&lt;b&gt;Outline&lt;/b&gt;&lt;br&gt;Draw a closed line. One beside another splits the wood; one within another is a hollow.</source>
        <translation>&lt;b&gt;輪郭&lt;/b&gt;&lt;br&gt;閉じた線を描きます。ほかの線の隣に描くと木部が分かれ、線の内側に描くと空洞になります。</translation>
    </message>
    <message>
        <source>Attractor</source>
        <translation>アトラクター</translation>
    </message>
    <message>
        <source>&lt;b&gt;Attractor&lt;/b&gt;&lt;br&gt;Drag a straight line that the strands gather at.</source>
        <translation>&lt;b&gt;アトラクター&lt;/b&gt;&lt;br&gt;ドラッグして、ストランドが集まる直線を引きます。</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>&lt;b&gt;Points&lt;/b&gt;&lt;br&gt;Drag the points of an outline, or the ends of an attractor.</source>
        <translation>&lt;b&gt;点&lt;/b&gt;&lt;br&gt;輪郭の点か、アトラクターの端をドラッグします。</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>&lt;b&gt;Erase&lt;/b&gt;&lt;br&gt;Tap a line to take it away. A pen&apos;s eraser does the same at any time.</source>
        <translation>&lt;b&gt;消去&lt;/b&gt;&lt;br&gt;線をタップして消します。ペンの消しゴムなら、いつでも消せます。</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>円形</translation>
    </message>
    <message>
        <source>Elongated</source>
        <translation>細長</translation>
    </message>
    <message>
        <source>C-shaped</source>
        <translation>C 字形</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>空洞</translation>
    </message>
    <message>
        <source>Split in two</source>
        <translation>2 つに分割</translation>
    </message>
    <message>
        <source>Split in three</source>
        <translation>3 つに分割</translation>
    </message>
    <message>
        <source>Fluted</source>
        <translation>溝つき</translation>
    </message>
    <message>
        <source>Copy to branch</source>
        <translation>枝にコピー</translation>
    </message>
    <message>
        <source>&lt;b&gt;Copy to branch&lt;/b&gt;&lt;br&gt;Then tap another place on this branch: everything between gets this profile.</source>
        <translation>&lt;b&gt;枝にコピー&lt;/b&gt;&lt;br&gt;続けて、この枝の別の場所をタップします。その間がすべてこの断面形になります。</translation>
    </message>
    <message>
        <source>▼</source>
        <translation>▼</translation>
    </message>
    <message>
        <source>To the next place down the branch.</source>
        <translation>根元側の次の場所へ</translation>
    </message>
    <message>
        <source>▲</source>
        <translation>▲</translation>
    </message>
    <message>
        <source>To the next place up the branch.</source>
        <translation>枝先側の次の場所へ</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Show the whole cross-section.</source>
        <translation>断面全体を表示します</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>クリア</translation>
    </message>
    <message>
        <source>&lt;b&gt;Clear&lt;/b&gt;&lt;br&gt;Take the profile away: the strands are packed round again.</source>
        <translation>&lt;b&gt;クリア&lt;/b&gt;&lt;br&gt;断面形を取り除きます。ストランドは再び丸く詰まります。</translation>
    </message>
    <message>
        <source>Down the branch</source>
        <translation>根元のほうへ</translation>
    </message>
    <message>
        <source>Up the branch</source>
        <translation>枝先のほうへ</translation>
    </message>
    <message numerus="yes">
        <source>Radius %1 · %Ln strands</source>
        <translation>
            <numerusform>半径 %1 · ストランド %Ln 本</numerusform>
        </translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>断面形</translation>
    </message>
    <message>
        <source>Draw another closed line: beside the first to split the wood, within it for a hollow.</source>
        <translation>閉じた線をもう 1 本描きます。隣なら木部が分かれ、内側なら空洞になります。</translation>
    </message>
    <message>
        <source>Draw a closed line, or begin with one of these shapes.</source>
        <translation>閉じた線を描くか、これらの形のどれかから始めます。</translation>
    </message>
    <message>
        <source>Drag a straight line: the strands gather at it.</source>
        <translation>ドラッグして直線を引くと、ストランドがそこに集まります。</translation>
    </message>
    <message>
        <source>Drag the points of a line.</source>
        <translation>線の点をドラッグします。</translation>
    </message>
    <message>
        <source>Tap a line to take it away.</source>
        <translation>線をタップすると消えます。</translation>
    </message>
    <message>
        <source>Tap the other end on this branch, or go there with ▲ and ▼ and press the button again.</source>
        <translation>この枝のもう一方の端をタップするか、▲ と ▼ でそこへ移ってボタンをもう一度押します。</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>補間</translation>
    </message>
    <message>
        <source>&lt;b&gt;Blend&lt;/b&gt;&lt;br&gt;Then tap another place on this branch that has a profile: the sections between change from one to the other.</source>
        <translation>&lt;b&gt;補間&lt;/b&gt;&lt;br&gt;続けて、この枝の、断面形のある別の場所をタップします。その間が、一方の形から他方の形へ移り変わります。</translation>
    </message>
</context>
<context>
    <name>espalier::PrunePopOut</name>
    <message>
        <source>Cut</source>
        <translation>切る</translation>
    </message>
    <message>
        <source>Tap a branch to cut it off, or draw a line across several.</source>
        <translation>枝をタップして取るか、何本かを横切る線を描きます。</translation>
    </message>
    <message>
        <source>Keep clear</source>
        <translation>枝下を空ける</translation>
    </message>
    <message>
        <source>Drag up along a trunk or a branch: the shoots below your hand are removed, and no new ones come. Drag the ring down again to let buds shoot.</source>
        <translation>幹や枝に沿って上へドラッグすると、手より下の枝が取れ、新しい枝も出なくなります。輪を下へ戻すと、また芽が伸びます。</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>Brush over twigs and leaves to take them away, however deep in the crown they are. Limbs stay.</source>
        <translation>小枝や葉の上をなぞると、樹冠の奥にあるものまで取り除けます。太い枝は残ります。</translation>
    </message>
    <message>
        <source>Thin out</source>
        <translation>間引く</translation>
    </message>
    <message>
        <source>Brush over the crown to take out some of its twigs evenly.</source>
        <translation>樹冠の上をなぞると、小枝の一部がむらなく取れます。</translation>
    </message>
</context>
<context>
    <name>espalier::RadiusSlider</name>
    <message>
        <source>Brush radius</source>
        <translation>ブラシの半径</translation>
    </message>
</context>
<context>
    <name>espalier::Recovery</name>
    <message>
        <source>%1, but the file is no longer there</source>
        <translation>%1（ファイルはもうありません）</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>読み込めません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln internodes</source>
        <translation>
            <numerusform>%Ln 節間</numerusform>
        </translation>
    </message>
    <message>
        <source>Changed by another program since</source>
        <translation>その後ほかのプログラムが変更</translation>
    </message>
    <message>
        <source>There is nothing to bring back: all was saved, or given up.</source>
        <translation>復元するものはありません。すべて保存されたか、破棄されています。</translation>
    </message>
    <message>
        <source>Another tree can be brought back.</source>
        <translation>復元できる木がもう 1 本あります。</translation>
    </message>
    <message numerus="yes">
        <source>%n other trees can be brought back.</source>
        <translation>
            <numerusform>復元できる木がほかに %n 本あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>The safety copy of %1 cannot be read. It is kept as %2.</source>
        <translation>%1 の控えを読み込めません。%2 として残してあります。</translation>
    </message>
    <message numerus="yes">
        <source>%n safety copies cannot be read. They are kept in %1.</source>
        <translation>
            <numerusform>%n 個の控えを読み込めません。%1 に残してあります。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>espalier::RecoveryRow</name>
    <message>
        <source>Bring Back</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Can be brought back</source>
        <translation>復元できる状態</translation>
    </message>
    <message>
        <source>It will be deleted when this closes.</source>
        <translation>閉じると削除されます。</translation>
    </message>
    <message>
        <source>Bring back %1</source>
        <translation>%1 を復元</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 を破棄</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>描画中…</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>画像なし</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>残す</translation>
    </message>
</context>
<context>
    <name>espalier::RecoverySheet</name>
    <message>
        <source>today, %1</source>
        <translation>今日 %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>昨日 %1</translation>
    </message>
    <message>
        <source>Bring Trees Back</source>
        <translation>木を復元</translation>
    </message>
    <message>
        <source>Espalier ended before this was saved. What you leave here is offered again at the next start.</source>
        <translation>保存する前に Espalier が終了しました。ここに残したものは、次の起動時にもう一度表示されます。</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
</context>
<context>
    <name>espalier::ReportSheet</name>
    <message>
        <source>With the recipe of this tree</source>
        <translation>この木のレシピも含める</translation>
    </message>
    <message>
        <source>Report a Problem</source>
        <translation>問題を報告</translation>
    </message>
    <message>
        <source>Copy this text, and add what you did and what happened. Espalier sends nothing by itself. Without the recipe, the text has nothing of your tree.</source>
        <translation>このテキストをコピーし、何をしたか、何が起こったかを書き加えてください。Espalier が自動で送信することはありません。レシピを含めなければ、木の内容は入りません。</translation>
    </message>
    <message>
        <source>Text of the report</source>
        <translation>報告のテキスト</translation>
    </message>
    <message>
        <source>All that was done to the tree, so that others can do it again.</source>
        <translation>木に対して行ったことのすべて。ほかの人が同じことを再現できます。</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>espalier::ReproduceController</name>
    <message>
        <source>Draw the new trunk, from its base to its tip.</source>
        <translation>新しい幹を、根元から先端まで描いてください。</translation>
    </message>
    <message>
        <source>Now draw the silhouette of the crown around its tip.</source>
        <translation>次に、先端を囲むように樹冠の輪郭を描いてください。</translation>
    </message>
    <message>
        <source>Now draw the trunk, with its tip inside the silhouette.</source>
        <translation>次に、先端が輪郭の中に入るように幹を描いてください。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>espalier::ReproducePopOut</name>
    <message>
        <source>Another</source>
        <translation>別の木</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another&lt;/b&gt;&lt;br&gt;The same tree with slightly different angles and lengths, as it could stand beside it in a forest. As long as nothing else is done, the next one takes its place.</source>
        <translation>&lt;b&gt;別の木&lt;/b&gt;&lt;br&gt;角度と長さが少し違う同じ木で、森で隣に立っていそうなものです。ほかのことをしないかぎり、次の木がその代わりになります。</translation>
    </message>
</context>
<context>
    <name>espalier::RingMenu</name>
    <message>
        <source>Tools around the pointer</source>
        <translation>ポインタのまわりのツール</translation>
    </message>
</context>
<context>
    <name>espalier::RotationStrip</name>
    <message>
        <source>Rotation strip</source>
        <translation>回転バー</translation>
    </message>
</context>
<context>
    <name>espalier::SceneController</name>
    <message>
        <source>Reference Picture</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>New trees will have this background, ground and light.</source>
        <translation>これからの新しい木は、この背景、地面、光になります。</translation>
    </message>
</context>
<context>
    <name>espalier::SettingsSheet</name>
    <message>
        <source>The middle button turns; with Shift it pans, with Ctrl it zooms. Alt with the left button turns, too.</source>
        <translation>中ボタンで回転、Shift と中ボタンで移動、Ctrl と中ボタンで近づきます。Alt と左ボタンでも回転します。</translation>
    </message>
    <message>
        <source>With Alt, the left button turns, the middle one pans and the right one zooms.</source>
        <translation>Alt と左ボタンで回転、Alt と中ボタンで移動、Alt と右ボタンで近づきます。</translation>
    </message>
    <message>
        <source>The right or middle button turns; Shift with the middle button pans. Alt with the left button turns, too.</source>
        <translation>右ボタンか中ボタンで回転、Shift と中ボタンで移動します。Alt と左ボタンでも回転します。</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>既定値</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Like the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>On the left</source>
        <translation>左側</translation>
    </message>
    <message>
        <source>On the right</source>
        <translation>右側</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>How firmly a pen must press for a large brush.</source>
        <translation>ブラシを大きくするのに、ペンをどれだけ強く押すかです。</translation>
    </message>
    <message>
        <source>Press here with your pen to try it.</source>
        <translation>ここをペンで押して試せます。</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>軽い</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>強い</translation>
    </message>
    <message>
        <source>Pen pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>変更…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>作業</translation>
    </message>
    <message>
        <source>Undo steps kept</source>
        <translation>元に戻す回数</translation>
    </message>
    <message>
        <source>A change applies to the next tree that you begin or open.</source>
        <translation>回数は、次に新しく始める木、または開く木から有効になります。</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>ライブラリ</translation>
    </message>
    <message>
        <source>In Espalier&apos;s own folder</source>
        <translation>Espalier 専用のフォルダー</translation>
    </message>
    <message>
        <source>Library Folder</source>
        <translation>ライブラリのフォルダー</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Metres, centimetres</source>
        <translation>メートル、センチメートル</translation>
    </message>
    <message>
        <source>Feet, inches</source>
        <translation>フィート、インチ</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Size of the interface</source>
        <translation>画面の拡大率</translation>
    </message>
    <message>
        <source>Stroke stabiliser</source>
        <translation>手ぶれ補正</translation>
    </message>
    <message>
        <source>A stroke follows the pointer at this distance, like a stone on a string, so it does not tremble.</source>
        <translation>線は、糸に引かれる石のように、ポインターからこの距離だけ離れてついてきます。震えません。</translation>
    </message>
    <message>
        <source>A stroke lags this far behind the pointer, and is smoother.</source>
        <translation>線はポインターよりこれだけ遅れて、なめらかについてきます。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>遅れ</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Takes effect the next time Espalier starts.</source>
        <translation>次に Espalier を起動したときから有効です。</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>履歴のメモリー</translation>
    </message>
    <message>
        <source>If the history takes more, its oldest steps go.</source>
        <translation>履歴がこれを超えると、古いステップから消えます。</translation>
    </message>
</context>
<context>
    <name>espalier::SizeChoices</name>
    <message>
        <source>Bonsai</source>
        <translation>盆栽</translation>
    </message>
    <message>
        <source>Shrub</source>
        <translation>低木</translation>
    </message>
    <message>
        <source>Street Tree</source>
        <translation>街路樹</translation>
    </message>
    <message>
        <source>Forest Tree</source>
        <translation>森の木</translation>
    </message>
    <message>
        <source>Size of the new tree</source>
        <translation>新しい木の大きさ</translation>
    </message>
    <message>
        <source>How tall should the new tree grow?</source>
        <translation>新しい木をどれくらいの高さにしますか？</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;About %2 tall; the brush, the branches and the leaves are in proportion.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;高さ約 %2。ブラシ、枝、葉もそれに合わせた大きさになります。</translation>
    </message>
</context>
<context>
    <name>espalier::SketchController</name>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>espalier::SketchPopOut</name>
    <message>
        <source>Give depth</source>
        <translation>奥行きを与える</translation>
    </message>
    <message>
        <source>&lt;b&gt;Give depth&lt;/b&gt;&lt;br&gt;The branches of the drawing spread into depth, as far from each other as they can. From the front the tree looks as you drew it.</source>
        <translation>&lt;b&gt;奥行きを与える&lt;/b&gt;&lt;br&gt;絵の枝が、できるだけ離れるように奥行きへ広がります。正面からは描いたとおりです。</translation>
    </message>
    <message>
        <source>Another depth</source>
        <translation>別の奥行き</translation>
    </message>
    <message>
        <source>&lt;b&gt;Another depth&lt;/b&gt;&lt;br&gt;Choose new depths for the branches.</source>
        <translation>&lt;b&gt;別の奥行き&lt;/b&gt;&lt;br&gt;枝の奥行きを選び直します。</translation>
    </message>
</context>
<context>
    <name>espalier::TopBar</name>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 には保存していない変更があります。</translation>
    </message>
</context>
<context>
    <name>espalier::Tour</name>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Back in time</source>
        <translation>時間をさかのぼる</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>ぐるりと見る</translation>
    </message>
    <message>
        <source>When you wonder</source>
        <translation>迷ったときは</translation>
    </message>
    <message>
        <source>&lt;b&gt;F1&lt;/b&gt; or this button tells you about the tool in your hand. &lt;b&gt;Ctrl+Z&lt;/b&gt; takes back whatever you did, so try things.</source>
        <translation>&lt;b&gt;F1&lt;/b&gt; かこのボタンで、手にしているツールの説明が開きます。&lt;b&gt;Ctrl+Z&lt;/b&gt; で何でも元に戻せるので、気軽に試してください。</translation>
    </message>
    <message>
        <source>Draw a tree</source>
        <translation>木を描く</translation>
    </message>
    <message>
        <source>Draw a trunk</source>
        <translation>幹を描く</translation>
    </message>
    <message>
        <source>Draw a branch</source>
        <translation>枝を描く</translation>
    </message>
    <message>
        <source>Here is a seedling. &lt;b&gt;Press on it and draw a line upward&lt;/b&gt;, to the middle of the picture or higher: it becomes the trunk.</source>
        <translation>苗があります。&lt;b&gt;その上で押して、上へ線を引いてください&lt;/b&gt;。画面の中ほどか、それより上まで引くと、幹になります。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a branch and draw outward&lt;/b&gt;: the line becomes a branch.</source>
        <translation>&lt;b&gt;枝の上で押して、外側へ線を引いてください&lt;/b&gt;。その線が枝になります。</translation>
    </message>
    <message>
        <source>Draw the limbs</source>
        <translation>大枝を描く</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on the trunk and draw outward and up&lt;/b&gt;, to the left and to the right. Three limbs or four are enough.</source>
        <translation>&lt;b&gt;幹の上で押して、外側の上へ線を引いてください&lt;/b&gt;。左と右に、3、4 本あれば十分です。</translation>
    </message>
    <message>
        <source>Small and large</source>
        <translation>小さく、大きく</translation>
    </message>
    <message>
        <source>A tiny brush draws a single branch, a large one grows a crown. &lt;b&gt;Drag the slider upward, or press&amp;nbsp;]&lt;/b&gt;; [ makes the brush smaller.</source>
        <translation>小さなブラシは枝を 1 本描き、大きなブラシは樹冠を育てます。&lt;b&gt;スライダーを上へドラッグするか、]&amp;nbsp;を押してください&lt;/b&gt;。[ でブラシが小さくなります。</translation>
    </message>
    <message>
        <source>Grow a crown</source>
        <translation>樹冠を育てる</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press on a limb and draw slowly along the limbs and around their ends&lt;/b&gt;: twigs and leaves grow wherever the brush passes.</source>
        <translation>&lt;b&gt;大枝の上で押し、枝に沿ってその先のまわりまで、ゆっくりドラッグしてください&lt;/b&gt;。ブラシの通ったところに小枝と葉が育ちます。</translation>
    </message>
    <message>
        <source>Prune, bend, draw with a lasso: what a gardener needs is here. &lt;b&gt;Choose Grow&lt;/b&gt;.</source>
        <translation>剪定する、曲げる、投げ縄で描く。庭師に必要なものがここにあります。&lt;b&gt;「成長」を選んでください&lt;/b&gt;。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag this slider to the left&lt;/b&gt;, and the tree ungrows; drag it back to the right, and the tree is there again.</source>
        <translation>&lt;b&gt;このスライダーを左へドラッグする&lt;/b&gt;と、木が縮んでいきます。右へ戻すと、木も元に戻ります。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag along this edge&lt;/b&gt;, and the tree turns, even while your other hand brushes. The right mouse button turns it as well.</source>
        <translation>&lt;b&gt;この縁に沿ってドラッグする&lt;/b&gt;と木が回ります。もう一方の手で描いている間も回せます。マウスの右ボタンでも回ります。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Choose Sketch&lt;/b&gt; to draw a trunk and branches as on paper, and give the drawing depth. Watch how thirty strokes become a tree.</source>
        <translation>&lt;b&gt;「スケッチ」を選ぶ&lt;/b&gt;と、紙に描くように幹と枝を描き、奥行きを与えられます。30 本の線が木になる様子を見てください。</translation>
    </message>
</context>
<context>
    <name>espalier::TourCard</name>
    <message>
        <source>Skip</source>
        <translation>スキップ</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>見る</translation>
    </message>
</context>
<context>
    <name>espalier::TropismDiagram</name>
    <message>
        <source>as the stroke</source>
        <translation>ストローク通り</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>直立</translation>
    </message>
    <message>
        <source>slanting</source>
        <translation>斜め</translation>
    </message>
    <message>
        <source>level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>weeping</source>
        <translation>枝垂れ</translation>
    </message>
</context>
<context>
    <name>espalier::Viewport</name>
    <message>
        <source>Tree</source>
        <translation>木</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>右から</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>正面から</translation>
    </message>
</context>
<context>
    <name>espalier::Workspace</name>
    <message>
        <source>Only one bud grows  ✕</source>
        <translation>1 本の枝だけ成長  ✕</translation>
    </message>
    <message>
        <source>Let all buds grow again.</source>
        <translation>すべての芽を再び成長させます</translation>
    </message>
    <message>
        <source>a seedling</source>
        <translation>苗</translation>
    </message>
    <message>
        <source>%L1 internodes · %L2 leaves · step %L3</source>
        <translation>節間 %L1 · 葉 %L2 · ステップ %L3</translation>
    </message>
    <message>
        <source>Back to My Tree</source>
        <translation>自分の木に戻る</translation>
    </message>
    <message>
        <source>Show your own tree again, as it was before this recipe was played.</source>
        <translation>このレシピの前の、自分の木をもう一度表示します</translation>
    </message>
</context>
</TS>
