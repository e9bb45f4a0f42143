<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message>
        <source>Brush Stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change Parameters</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JsonReader</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is larger than %1 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds too many values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a JSON object is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a string is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number of at most 64 bits is expected, from 2^53 on as a string of digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an array is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not known here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Internode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of one internode. It is the measure of everything that grows: smaller ones make finer trees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shoot length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many internodes the strongest shoot grows in one step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branching angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between a branch and what branches off it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far an axis turns away from a branch that it bears: 0 keeps it straight, more makes it zigzag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phyllotaxis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn around the axis from one bud to the next: 137.5° is a spiral, 180° two rows, 90° crossed pairs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Buds at a node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One is alternate, two opposite, more a whorl, as in pines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Occupied radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space around each bud that nothing else grows into, in internodes. More makes an airier crown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far beyond its own space a bud sees room to grow, in internodes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far to the sides a bud sees room to grow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much room to grow the brush spreads, in points per cubic internode. More makes denser growth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Growth steps after which the room that the brush has spread is forgotten.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room at a bud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the tree grows on its own: the room to grow that each bud finds around itself in each step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apical dominance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who gets the vigour: above 0.5 the main axis, as in conifers; below it the branches, as in shrubs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light sensitivity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much more a bud in the light thrives than one in the shade.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shedding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branches with less vigour than this die: 0 keeps them all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much light one internode takes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadow falloff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast a shadow fades on its way down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadow depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many layers below an internode its shadow reaches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much a shoot keeps the direction that it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much a shoot turns toward the set-point angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much a shoot turns toward where there is room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-point angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where shoots turn: 0° is up, 90° level, and more makes them weep.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shoots turn toward where the brush goes, instead of to the set-point angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vigour of the buds above and below a leaning branch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sideways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vigour of the buds on the sides of a leaning branch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above or below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above 0 the buds on the upper side are stronger, as in fruit trees; below 0 those on the lower side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread of angles and lengths: 0 is a diagram, 1 as wild as nature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upright trunk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trunk grows straight up, whatever the branches do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the tree has any.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline of a leaf.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the stalk to the tip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Breadth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width by length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variation of size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the sizes of leaves differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At a node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many leaves grow together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far inward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Branches that carry more twigs than this are bare.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between a shoot and the leaf&apos;s stalk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Droop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far leaves hang down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toward the sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far leaves turn their faces up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0° is red, 60° yellow, 120° green.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variation of hue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the colours of leaves differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow of the weak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the leaves of weak shoots turn toward yellow and red.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How widths add up where branches meet: 2 is Leonardo&apos;s rule; less makes thicker trunks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the thinnest twigs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the trunk at the ground; at 0 it follows from the exponent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the bark looks like.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of trunk after which the bark&apos;s pattern repeats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light and vigour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravimorphism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ovate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lanceolate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lobed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>birch</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParametersJson</name>
    <message>
        <source>true or false is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of these is expected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not within %2…%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axisWeight, tropismWeight and spaceWeight must not all be 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it must not be beyond 0.99 times ellipseVertical, which is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such parameter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>espalier</name>
    <message>
        <source>its parent does not come before it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its rotation is not one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its length is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its vigour is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it grows from a bud that does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has a bud that does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is neither there nor away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its parameters are missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was born in the future</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it died before it was born</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>espalier::Tree</name>
    <message>
        <source>the columns of the tree have different lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tree is empty or lacks its parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the seedling must stand at the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it lives on a dead internode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two internodes continue the same axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>internode %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
