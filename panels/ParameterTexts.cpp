// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterTexts.h"

#include "panels/Theme.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace espalier {

namespace {

using enum ParameterText::Scale;

constexpr ParameterText kModel[] = {
    {"growth.model", QT_TRANSLATE_NOOP("Parameters", "Growth model"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "TreeSketch: buds compete for space and light. Vigour: light decides how "
                       "fast each shoot grows, month by month."),
     Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Self-organising competition, or shoot growth by vigour with apical control.")},
};

constexpr ParameterText kVigourShoot[] = {
    {"vigour.growthRate", QT_TRANSLATE_NOOP("Parameters", "Growth in a year"), "",
     QT_TRANSLATE_NOOP("Parameters", "How much the strongest shoot grows in full light, in twelve steps."),
     Logarithmic, 0, "cm", 100.0, "", QT_TRANSLATE_NOOP("Parameters", "Annual elongation of a shoot.")},
    {"vigour.internodeLength", QT_TRANSLATE_NOOP("Parameters", "Length of internodes"), "",
     QT_TRANSLATE_NOOP("Parameters", "An internode lengthens over several steps, up to this."), Logarithmic,
     1, "cm", 100.0, "", QT_TRANSLATE_NOOP("Parameters", "Length of a mature metamer.")},
    {"vigour.branchingAngle", QT_TRANSLATE_NOOP("Parameters", "Angle of laterals"), "",
     QT_TRANSLATE_NOOP("Parameters", "Between an axis and a branch that begins on it."), Linear, 0, "°", 1.0,
     "", QT_TRANSLATE_NOOP("Parameters", "Angle of insertion of a lateral shoot.")},
    {"vigour.lateralBuds", QT_TRANSLATE_NOOP("Parameters", "Lateral buds"), "",
     QT_TRANSLATE_NOOP("Parameters", "At each node: one makes a spiral, two crossed pairs, more a whorl."),
     Linear, 0, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Alternate, opposite or verticillate.")},
};

constexpr ParameterText kVigourAxis[] = {
    {"vigour.rollSpread", QT_TRANSLATE_NOOP("Parameters", "Variation in roll"), "",
     QT_TRANSLATE_NOOP("Parameters", "How irregularly branches stand around their axis."), Linear, 0, "°",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "Standard deviation of the divergence angle.")},
    {"vigour.apicalSpread", QT_TRANSLATE_NOOP("Parameters", "Wandering"), "",
     QT_TRANSLATE_NOOP("Parameters", "How much an axis changes its direction from node to node."), Linear, 1,
     "°", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Standard deviation of the apical angle.")},
    {"vigour.maximumOrder", QT_TRANSLATE_NOOP("Parameters", "Branch orders"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How many orders of branches there are at most: branches, their branches, and so on."),
     Linear, 0, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Highest order of an axis.")},
};

constexpr ParameterText kVigourBuds[] = {
    {"vigour.flushingRate", QT_TRANSLATE_NOOP("Parameters", "Flushing"), "",
     QT_TRANSLATE_NOOP("Parameters", "How readily lateral buds become branches."), Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Chance of lateral bud break for each internode of growth.")},
    {"vigour.apicalDominance", QT_TRANSLATE_NOOP("Parameters", "Inhibition"), "",
     QT_TRANSLATE_NOOP("Parameters", "How strongly growing tips hold back the buds below them."), Cubic, 2,
     "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Apical dominance: auxin from lit apical buds.")},
    {"vigour.inhibitorLoss", QT_TRANSLATE_NOOP("Parameters", "Fading of the inhibition"), "",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "The share that is lost at each internode: higher values let buds break nearer to the tip."),
     Cubic, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Decay of the inhibitor on its way down.")},
};

constexpr ParameterText kVigourControl[] = {
    {"vigour.apicalControl", QT_TRANSLATE_NOOP("Parameters", "Apical control"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Above 1 the trunk outgrows its branches, as in a spruce; below 1 they outgrow it."),
     Linear, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Excurrent above 1, decurrent below.")},
    {"vigour.distanceControl", QT_TRANSLATE_NOOP("Parameters", "Loss with distance"), "",
     QT_TRANSLATE_NOOP("Parameters", "How much less a shoot grows far from the root."), Linear, 2, "", 1.0,
     "", QT_TRANSLATE_NOOP("Parameters", "Decay of the potential with the distance to the root.")},
    {"vigour.heightControl", QT_TRANSLATE_NOOP("Parameters", "Loss with height"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How much less a shoot grows the higher it is: more makes the crown flat."),
     Linear, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Decay of the potential with height.")},
};

constexpr ParameterText kVigourTropisms[] = {
    {"vigour.gravitropism", QT_TRANSLATE_NOOP("Parameters", "Gravitropism"), "",
     QT_TRANSLATE_NOOP("Parameters", "Above 0 shoots turn upwards at each node, below 0 downwards."), Linear,
     2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Orthotropic above 0, positively gravitropic below.")},
    {"vigour.phototropism", QT_TRANSLATE_NOOP("Parameters", "Phototropism"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far shoots turn to the light at each node."), Cubic, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Growth towards the brightest direction.")},
    {"vigour.horizontalTropism", QT_TRANSLATE_NOOP("Parameters", "Level branches"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far a new branch turns towards the horizontal where it begins."),
     Linear, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Plagiotropy of lateral shoots.")},
};

constexpr ParameterText kVigourWeight[] = {
    {"vigour.bending", QT_TRANSLATE_NOOP("Parameters", "Sagging"), "k",
     QT_TRANSLATE_NOOP("Parameters", "How far branches sag under their weight as they grow."), Cubic, 1, "",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "Gravimorphic bending by branch load.")},
    {"vigour.bendingExponent", QT_TRANSLATE_NOOP("Parameters", "Stiffness with age"), "p",
     QT_TRANSLATE_NOOP("Parameters", "How much thick wood resists: at high values only the thin ends bend."),
     Linear, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Exponent of thickness in flexural stiffness.")},
    {"vigour.bendingMaximum", QT_TRANSLATE_NOOP("Parameters", "Greatest sag"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "An internode sags by at most this share of the angle between it and straight down."),
     Cubic, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Limit of the bend of an internode.")},
    {"vigour.lightPruning", QT_TRANSLATE_NOOP("Parameters", "Shade pruning"), "",
     QT_TRANSLATE_NOOP("Parameters", "Branch ends that get less light than this drop off."), Linear, 2, "",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "Cladoptosis of shaded shoots.")},
};

constexpr ParameterText kTropism[] = {
    {"growth.setPointAngle", QT_TRANSLATE_NOOP("Parameters", "Set-point angle"), "θ",
     QT_TRANSLATE_NOOP("Parameters",
                       "The direction that shoots turn to: 0° is up, 90° level, and more makes them weep."),
     Linear, 0, "°", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Gravitropic set-point angle: orthotropic at 0°, plagiotropic near 90°, "
                                     "positively gravitropic beyond.")},
};

constexpr ParameterText kGravimorphism[] = {
    {"growth.ellipseVertical", QT_TRANSLATE_NOOP("Parameters", "Buds above and below"), "s_v",
     QT_TRANSLATE_NOOP("Parameters", "Vigour of the buds on the upper and lower sides of a leaning branch."),
     Cubic, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Vertical semi-axis of the gravimorphic ellipse.")},
    {"growth.ellipseParallel", QT_TRANSLATE_NOOP("Parameters", "Buds on the sides"), "s_p",
     QT_TRANSLATE_NOOP("Parameters", "Vigour of the buds on the sides of a leaning branch."), Cubic, 2, "",
     1.0, "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Semi-axis parallel to the ground; if it is the greater one, amphitony.")},
    {"growth.ellipseOffset", QT_TRANSLATE_NOOP("Parameters", "Upper or lower buds"), "e_v",
     QT_TRANSLATE_NOOP("Parameters", "Above 0 the buds on the upper side are stronger, as in fruit trees; "
                                     "below 0 those on the lower side."),
     Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Displacement of the ellipse: epitony above 0, hypotony below.")},
};

constexpr ParameterText kBranching[] = {
    {"growth.branchingAngle", QT_TRANSLATE_NOOP("Parameters", "Branching angle"), "ψ",
     QT_TRANSLATE_NOOP("Parameters", "Between a branch and the branches that grow from it."), Linear, 0, "°",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "Angle of insertion of a lateral bud on its axis.")},
    {"growth.deflectionAngle", QT_TRANSLATE_NOOP("Parameters", "Deflection"), "δ",
     QT_TRANSLATE_NOOP("Parameters", "How far an axis turns away from a branch that it bears: 0 keeps it "
                                     "straight, more makes it zigzag."),
     Linear, 0, "°", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How far the main axis gives way to a lateral: a tendency to sympodial growth.")},
};

constexpr ParameterText kDirection[] = {
    {"growth.axisWeight", QT_TRANSLATE_NOOP("Parameters", "Straightness"), "α",
     QT_TRANSLATE_NOOP("Parameters", "How much a shoot keeps the direction that it has."), Linear, 2, "", 1.0,
     "", QT_TRANSLATE_NOOP("Parameters", "Weight of the heading H of the axis.")},
    {"growth.tropismWeight", QT_TRANSLATE_NOOP("Parameters", "Tropism"), "β",
     QT_TRANSLATE_NOOP("Parameters", "How much a shoot turns towards the set-point angle."), Linear, 2, "",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "Weight of gravitropism T.")},
    {"growth.spaceWeight", QT_TRANSLATE_NOOP("Parameters", "Free space"), "γ",
     QT_TRANSLATE_NOOP("Parameters", "How much a shoot turns towards where there is room."), Linear, 2, "",
     1.0, "",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "Weight of the environment E: the mean direction of the free space that a bud perceives.")},
};

constexpr ParameterText kSpace[] = {
    {"growth.occupancyRadius", QT_TRANSLATE_NOOP("Parameters", "Occupied radius"), "r",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "Space around each bud that nothing else grows into, in internodes. More makes an airier crown."),
     Logarithmic, 2, "l", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Radius of the zone of occupancy.")},
    {"growth.perceptionDepth", QT_TRANSLATE_NOOP("Parameters", "Sight"), "d",
     QT_TRANSLATE_NOOP("Parameters", "How far beyond its own space a bud sees room to grow, in internodes."),
     Logarithmic, 2, "l", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Depth of the volume of perception, which reaches to r + d.")},
    {"growth.perceptionAngle", QT_TRANSLATE_NOOP("Parameters", "Field of view"), "ζ",
     QT_TRANSLATE_NOOP("Parameters", "How far to the sides a bud sees room to grow."), Linear, 0, "°", 1.0,
     "", QT_TRANSLATE_NOOP("Parameters", "Apex angle of the cone of perception.")},
};

constexpr ParameterText kVigour[] = {
    {"growth.apicalDominance", QT_TRANSLATE_NOOP("Parameters", "Apical dominance"), "λ",
     QT_TRANSLATE_NOOP("Parameters", "What gets the vigour: above 0.5 the main axis, as in conifers; below "
                                     "it the branches, as in shrubs."),
     Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Excurrent forms above 0.5, decurrent ones below.")},
    {"growth.lightSensitivity", QT_TRANSLATE_NOOP("Parameters", "Light sensitivity"), "κ",
     QT_TRANSLATE_NOOP("Parameters", "How much more a bud in the light thrives than one in the shade."),
     Logarithmic, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "Exponent of the response to light: high for light-demanding trees, low for shade-tolerant ones.")},
    {"growth.shedding", QT_TRANSLATE_NOOP("Parameters", "Shedding"), "Th",
     QT_TRANSLATE_NOOP("Parameters", "Branches with less vigour than this die: 0 keeps them all."), Cubic, 3,
     "", 1.0, "",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "Threshold of cladoptosis: vigour per internode, relative to that of the whole tree.")},
    {"growth.maxShootLength", QT_TRANSLATE_NOOP("Parameters", "Shoot length"), "n",
     QT_TRANSLATE_NOOP("Parameters", "How many internodes the strongest shoot grows in one step."),
     Logarithmic, 0, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Metamers of the strongest shoot of a flush.")},
};

constexpr ParameterText kHabit[] = {
    {"growth.phyllotaxis", QT_TRANSLATE_NOOP("Parameters", "Phyllotaxis"), "φ",
     QT_TRANSLATE_NOOP("Parameters", "Turn around the axis from one bud to the next: 137.5° is a spiral, "
                                     "180° two rows, 90° crossed pairs."),
     Linear, 1, "°", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Divergence angle: spiral, distichous, decussate.")},
    {"growth.uprightTrunk", QT_TRANSLATE_NOOP("Parameters", "Upright trunk"), "",
     QT_TRANSLATE_NOOP("Parameters", "The trunk grows straight up, whatever the branches do."), Linear, 2, "",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "The axis of order 0 is orthotropic, as in most conifers.")},
};

constexpr ParameterText kShoot[] = {
    {"growth.internodeLength", QT_TRANSLATE_NOOP("Parameters", "Internode"), "l",
     QT_TRANSLATE_NOOP("Parameters", "Length of one internode. It is the measure of everything that grows: "
                                     "shorter ones make finer trees."),
     Logarithmic, 1, "cm", 100.0, "", QT_TRANSLATE_NOOP("Parameters", "Length of a metamer.")},
    {"growth.lateralsPerNode", QT_TRANSLATE_NOOP("Parameters", "Buds at a node"), "",
     QT_TRANSLATE_NOOP("Parameters", "One is alternate, two opposite, more a whorl, as in pines."), Linear, 0,
     "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Alternate, opposite or verticillate.")},
    {"growth.irregularity", QT_TRANSLATE_NOOP("Parameters", "Irregularity"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Spread of angles and lengths: 0 is as regular as a diagram, 1 as wild as nature."),
     Linear, 2, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Variance of the angles and of the metamers.")},
    {"growth.straightening", QT_TRANSLATE_NOOP("Parameters", "Straightening"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How fast young wood smooths its bends as it grows on: 0 keeps every elbow."),
     Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Reaction wood: an axis that takes over straightens.")},
    {"growth.markersPerBud", QT_TRANSLATE_NOOP("Parameters", "Room at a bud"), "",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "When the tree grows on its own: the room to grow that each bud finds around itself in each step."),
     Logarithmic, 0, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Markers generated in each volume of perception.")},
};

constexpr ParameterText kShadow[] = {
    {"growth.shadowIntensity", QT_TRANSLATE_NOOP("Parameters", "Shadow"), "a",
     QT_TRANSLATE_NOOP("Parameters", "How much light one internode takes."), Cubic, 3, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Intensity of the penumbra that a metamer casts.")},
    {"growth.shadowFalloff", QT_TRANSLATE_NOOP("Parameters", "Shadow falloff"), "b",
     QT_TRANSLATE_NOOP("Parameters", "How fast a shadow fades on its way down."), Logarithmic, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Base of the shadow's decay from layer to layer.")},
    {"growth.shadowDepth", QT_TRANSLATE_NOOP("Parameters", "Shadow depth"), "q",
     QT_TRANSLATE_NOOP("Parameters", "How many layers below an internode its shadow reaches."), Linear, 0, "",
     1.0, "", QT_TRANSLATE_NOOP("Parameters", "Height of the pyramid of shadow, in voxels.")},
};

constexpr ParameterText kMarkers[] = {
    {"growth.markerDensity", QT_TRANSLATE_NOOP("Parameters", "Brush density"), "",
     QT_TRANSLATE_NOOP("Parameters", "How densely the brush spreads room to grow, in points per cubic "
                                     "internode. More makes denser growth."),
     Logarithmic, 3, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Density of the markers of free space.")},
    {"growth.markerAge", QT_TRANSLATE_NOOP("Parameters", "Brush memory"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "After this many growth steps, the room that the brush has spread is forgotten."),
     Logarithmic, 0, "", 1.0, "", QT_TRANSLATE_NOOP("Parameters", "Maximum age of a marker.")},
    {"growth.tropismFromStroke", QT_TRANSLATE_NOOP("Parameters", "Follow the stroke"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Shoots turn the way the brush goes, instead of to the set-point angle."),
     Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "The set-point angle is inferred from the direction of the stroke.")},
};

constexpr ParameterText kLeafForm[] = {
    {"leaves.visible", QT_TRANSLATE_NOOP("Parameters", "Leaves"), "",
     QT_TRANSLATE_NOOP("Parameters", "Whether the tree has any.")},
    {"leaves.shape", QT_TRANSLATE_NOOP("Parameters", "Shape"), "",
     QT_TRANSLATE_NOOP("Parameters", "The outline of a leaf.")},
    {"leaves.length", QT_TRANSLATE_NOOP("Parameters", "Length"), "",
     QT_TRANSLATE_NOOP("Parameters", "From the stalk to the tip."), Logarithmic, 1, "cm", 100.0},
    {"leaves.aspect", QT_TRANSLATE_NOOP("Parameters", "Breadth"), "",
     QT_TRANSLATE_NOOP("Parameters", "Width as a share of length."), Logarithmic},
    {"leaves.sizeVariation", QT_TRANSLATE_NOOP("Parameters", "Variation in size"), "",
     QT_TRANSLATE_NOOP("Parameters", "How much the sizes of leaves differ.")},
};

constexpr ParameterText kLeafPlace[] = {
    {"leaves.perNode", QT_TRANSLATE_NOOP("Parameters", "At a node"), "",
     QT_TRANSLATE_NOOP("Parameters", "How many leaves grow together."), Linear, 0},
    {"leaves.arrangement", QT_TRANSLATE_NOOP("Parameters", "Arrangement"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How leaves stand around a shoot: as its buds do; in a spiral; together, "
                       "each pair or whorl across the one before; or flat in two rows, as on "
                       "beech and hemlock."),
     Linear, 2, "", 1.0, "",
     QT_TRANSLATE_NOOP("Parameters", "Leaf phyllotaxis: spiral, decussate or verticillate, distichous.")},
    {"leaves.maxTips", QT_TRANSLATE_NOOP("Parameters", "How far inward"), "",
     QT_TRANSLATE_NOOP("Parameters", "Branches that carry more twigs than this are bare."), Logarithmic, 0},
    {"leaves.reach", QT_TRANSLATE_NOOP("Parameters", "Leafy internodes"), "",
     QT_TRANSLATE_NOOP("Parameters", "How many internodes of a shoot bear leaves, counted from its tip."),
     Logarithmic, 0},
    {"leaves.angle", QT_TRANSLATE_NOOP("Parameters", "Angle"), "",
     QT_TRANSLATE_NOOP("Parameters", "Between a shoot and the leaf's stalk."), Linear, 0, "°"},
    {"leaves.droop", QT_TRANSLATE_NOOP("Parameters", "Droop"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far leaves hang down.")},
    {"leaves.upward", QT_TRANSLATE_NOOP("Parameters", "Towards the sky"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far leaves turn their faces up.")},
};

constexpr ParameterText kLeafColour[] = {
    {"leaves.hue", QT_TRANSLATE_NOOP("Parameters", "Hue"), "",
     QT_TRANSLATE_NOOP("Parameters", "0° is red, 60° yellow, 120° green."), Linear, 0, "°"},
    {"leaves.hueVariation", QT_TRANSLATE_NOOP("Parameters", "Variation in hue"), "",
     QT_TRANSLATE_NOOP("Parameters", "How much the colours of leaves differ."), Linear, 0, "°"},
    {"leaves.saturation", QT_TRANSLATE_NOOP("Parameters", "Saturation"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How strong the colour is: low values suit blossom and silvery leaves.")},
    {"leaves.brightness", QT_TRANSLATE_NOOP("Parameters", "Brightness"), "",
     QT_TRANSLATE_NOOP("Parameters", "How bright the leaves are.")},
    {"leaves.vigourHue", QT_TRANSLATE_NOOP("Parameters", "Yellowing"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far the leaves of weak shoots turn towards yellow and red.")},
};

constexpr ParameterText kWidths[] = {
    {"widths.exponent", QT_TRANSLATE_NOOP("Parameters", "Exponent"), "n",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "How widths add up where branches meet: 2 is Leonardo's rule; less makes thicker trunks."),
     Logarithmic},
    {"widths.tipDiameter", QT_TRANSLATE_NOOP("Parameters", "Tips"), "d_e",
     QT_TRANSLATE_NOOP("Parameters", "Diameter of the thinnest twigs."), Logarithmic, 1, "mm", 1000.0},
    {"widths.baseDiameter", QT_TRANSLATE_NOOP("Parameters", "Base"), "d_b",
     QT_TRANSLATE_NOOP("Parameters",
                       "Diameter of the trunk at the ground; at 0 it follows from the exponent."),
     Cubic, 1, "cm", 100.0, QT_TRANSLATE_NOOP("Parameters", "automatic")},
    {"widths.flare", QT_TRANSLATE_NOOP("Parameters", "Flare"), "",
     QT_TRANSLATE_NOOP("Parameters", "How much the trunk spreads where it meets the ground.")},
};

constexpr ParameterText kStrands[] = {
    {"wood.mesher", QT_TRANSLATE_NOOP("Parameters", "Surface"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Tubes: each branch is a tube that begins inside its parent. Strands: the "
                       "wood is bundles of strands, which run from every tip to the ground, "
                       "under one closed bark.")},
    {"wood.strandsPerTip", QT_TRANSLATE_NOOP("Parameters", "Strands at a tip"), "",
     QT_TRANSLATE_NOOP("Parameters", "How many strands begin at each tip. More make a smoother surface, and "
                                     "branches that separate more clearly."),
     Linear, 0},
    {"wood.strandRadius", QT_TRANSLATE_NOOP("Parameters", "Strand radius"), "",
     QT_TRANSLATE_NOOP("Parameters", "How thick each strand is. Above 0, the trunk gets as thick as its "
                                     "strands make it; at 0 it keeps the width that it has."),
     Cubic, 1, "mm", 1000.0, QT_TRANSLATE_NOOP("Parameters", "automatic")},
    {"wood.alpha", QT_TRANSLATE_NOOP("Parameters", "Cohesion"), "α",
     QT_TRANSLATE_NOOP("Parameters", "Branches separate at a fork where their strands are further apart than "
                                     "this many strand radii: low values part them early, high ones late."),
     Logarithmic, 1},
    {"wood.packing", QT_TRANSLATE_NOOP("Parameters", "Packing"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How the strands of a section are pressed together. At rest: until none overlaps. As "
                       "published: by the paper's simulation, which stops before that.")},
    {"wood.steps", QT_TRANSLATE_NOOP("Parameters", "Packing steps"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "For how long strands are pressed together at each node. With few steps, the shape of "
                       "a fork is kept further down the trunk; with many, the trunk is round at once."),
     Cubic, 0},
    {"wood.smoothing", QT_TRANSLATE_NOOP("Parameters", "Smoothing"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How far the ridges of single strands are smoothed: 0 shows each of them.")},
    {"wood.flutes", QT_TRANSLATE_NOOP("Parameters", "Flutes"), "",
     QT_TRANSLATE_NOOP("Parameters", "How far the trunk bulges below its limbs and towards its roots, and "
                                     "how deep the hollows of lost limbs are. At 0 the wood is round.")},
};

constexpr ParameterText kBark[] = {
    {"bark.kind", QT_TRANSLATE_NOOP("Parameters", "Kind"), "",
     QT_TRANSLATE_NOOP("Parameters", "What the bark looks like.")},
    {"bark.scale", QT_TRANSLATE_NOOP("Parameters", "Scale"), "",
     QT_TRANSLATE_NOOP("Parameters", "Length of trunk after which the bark's pattern repeats."), Logarithmic,
     0, "cm", 100.0},
};

using enum ParameterSection::Look;

constexpr ParameterSection kSections[] = {
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Growth model"), kModel, Model},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Tropism"), kTropism, Diagram},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Gravimorphism"), kGravimorphism, Diagram},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Branching"), kBranching, Diagram},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Direction"), kDirection, Diagram},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Space"), kSpace, Diagram},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Vigour"), kVigour, Rows},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Habit"), kHabit, Rows},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Shoot"), kShoot, More},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Shade"), kShadow, More},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Shoot"), kVigourShoot, Vigour},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Axis"), kVigourAxis, Vigour},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Bud break"), kVigourBuds, Vigour},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Control"), kVigourControl, Vigour},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Tropisms"), kVigourTropisms, Vigour},
    {ParameterSheet::Architecture, QT_TRANSLATE_NOOP("Parameters", "Weight and shade"), kVigourWeight,
     Vigour},
    {ParameterSheet::Brush, QT_TRANSLATE_NOOP("Parameters", "Room to grow"), kMarkers},
    {ParameterSheet::Leaves, QT_TRANSLATE_NOOP("Parameters", "Form"), kLeafForm},
    {ParameterSheet::Leaves, QT_TRANSLATE_NOOP("Parameters", "Place"), kLeafPlace},
    {ParameterSheet::Leaves, QT_TRANSLATE_NOOP("Parameters", "Colour"), kLeafColour},
    {ParameterSheet::Branches, QT_TRANSLATE_NOOP("Parameters", "Width"), kWidths},
    {ParameterSheet::Branches, QT_TRANSLATE_NOOP("Parameters", "Strands"), kStrands},
    {ParameterSheet::Branches, QT_TRANSLATE_NOOP("Parameters", "Bark"), kBark},
};

// The names of the choices in ParameterInfo, as a person reads them.
[[maybe_unused]] constexpr const char* kChoices[] = {
    QT_TRANSLATE_NOOP("Parameters", "ovate"),    QT_TRANSLATE_NOOP("Parameters", "lanceolate"),
    QT_TRANSLATE_NOOP("Parameters", "lobed"),    QT_TRANSLATE_NOOP("Parameters", "needles"),
    QT_TRANSLATE_NOOP("Parameters", "furrowed"), QT_TRANSLATE_NOOP("Parameters", "smooth"),
    QT_TRANSLATE_NOOP("Parameters", "plated"),   QT_TRANSLATE_NOOP("Parameters", "birch"),
    QT_TRANSLATE_NOOP("Parameters", "cordate"),  QT_TRANSLATE_NOOP("Parameters", "palmate"),
    QT_TRANSLATE_NOOP("Parameters", "pinnate"),  QT_TRANSLATE_NOOP("Parameters", "willow"),
    QT_TRANSLATE_NOOP("Parameters", "fascicle"), QT_TRANSLATE_NOOP("Parameters", "frond"),
    QT_TRANSLATE_NOOP("Parameters", "cherry"),   QT_TRANSLATE_NOOP("Parameters", "mottled"),
    QT_TRANSLATE_NOOP("Parameters", "fibrous"),  QT_TRANSLATE_NOOP("Parameters", "ringed"),
    QT_TRANSLATE_NOOP("Parameters", "shoot"),    QT_TRANSLATE_NOOP("Parameters", "spiral"),
    QT_TRANSLATE_NOOP("Parameters", "opposite"), QT_TRANSLATE_NOOP("Parameters", "flat"),
    QT_TRANSLATE_NOOP("Parameters", "vigour"),   QT_TRANSLATE_NOOP("Parameters", "tubes"),
    QT_TRANSLATE_NOOP("Parameters", "strands"),
};

/// Choices that a person reads under another name than files have.
struct LongerName {
    const char* choice;
    const char* shown; ///< Untranslated
};
constexpr LongerName kLongerNames[] = {
    {"treesketch", QT_TRANSLATE_NOOP("Parameters", "TreeSketch")},
    {"rest", QT_TRANSLATE_NOOP("Parameters", "at rest")},
    {"pbd", QT_TRANSLATE_NOOP("Parameters", "as published")},
};

} // namespace

std::span<const ParameterSection> parameterSections()
{
    return kSections;
}

const ParameterText* parameterText(std::string_view key)
{
    for (const ParameterSection& section : kSections) {
        for (const ParameterText& text : section.parameters) {
            if (key == text.key)
                return &text;
        }
    }
    return nullptr;
}

QString richLabel(const ParameterText& text)
{
    QString symbol = QString::fromUtf8(text.symbol);
    if (const auto underscore = symbol.indexOf(QLatin1Char('_')); underscore > 0)
        symbol = QStringLiteral("%1<sub>%2</sub>").arg(symbol.left(underscore), symbol.mid(underscore + 1));
    const QString label = parameterTr(text.label).toHtmlEscaped();
    if (symbol.isEmpty())
        return label;
    return QStringLiteral("%1 <span style='color:%2'>%3</span>").arg(label, theme::kSymbol.name(), symbol);
}

QString explanation(const ParameterText& text)
{
    QString result =
        QStringLiteral("<b>%1</b><br>%2").arg(richLabel(text), parameterTr(text.tip).toHtmlEscaped());
    if (*text.botany != '\0')
        result += QStringLiteral("<br><i style='color:%1'>%2</i>")
                      .arg(theme::kOverDark.name(), parameterTr(text.botany).toHtmlEscaped());
    return result;
}

QString parameterTr(const char* text)
{
    return QCoreApplication::translate("Parameters", text);
}

QStringList choiceNames(const char* choices)
{
    QStringList names;
    for (const QByteArray& name : QByteArray(choices).split(' ')) {
        const auto* longer =
            std::ranges::find_if(kLongerNames, [&](const LongerName& known) { return name == known.choice; });
        QString shown = parameterTr(longer != std::end(kLongerNames) ? longer->shown : name.constData());
        shown.replace(QLatin1Char('_'), QLatin1Char(' '));
        if (!shown.isEmpty())
            shown[0] = shown[0].toUpper();
        names.append(shown);
    }
    return names;
}

} // namespace espalier
