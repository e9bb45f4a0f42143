// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"
#include "model/tree/ImageAsset.h"

#include <QString>

namespace espalier {

/// The growth model that a tree grows by; see GrowthModel.
enum class GrowthModelKind : int {
    TreeSketch, ///< Self-organising competition for space and light (TreeSketch 2012)
    Vigour      ///< Flow of vigour from the shoots' light (Strands 2024), by VigourParameters
};
inline constexpr int kGrowthModelCount = 2;

/// How a tree grows (TreeSketch 2012 §3.2; symbols in the comments are the paper's). Lengths "in internodes"
/// are multiples of internodeLength. Any field may change at any step; a change applies to later growth, not
/// to internodes that exist, apart from straightening.
struct GrowthParameters {
    GrowthModelKind model = GrowthModelKind::TreeSketch;

    // Form of a shoot
    double internodeLength = 0.1;        ///< l, m
    double phyllotaxis = radians(137.5); ///< φ, rad, roll between successive nodes
    int lateralsPerNode = 1;             ///< lateral buds at a node, 1...6, evenly spaced around it
    double branchingAngle = radians(60); ///< ψ, rad, between the axis and a lateral bud
    double deflectionAngle = radians(8); ///< δ, rad, the axis turns away from a lateral that starts to grow
    double irregularity = 0.6;           ///< 0...1, random spread of angles and lengths (0 = none)
    double straightening = 0.35; ///< 0...1, share of a turn in young wood that is spread along it in a step
    int maxShootLength = 5; ///< n_max, internodes that the shoot with the greatest vigour grows in a step

    // Competition for space
    double occupancyRadius = 2.0;         ///< r, in internodes
    double perceptionDepth = 3.5;         ///< d, in internodes; a bud perceives from r to r + d
    double perceptionAngle = radians(90); ///< ζ, rad, full apex angle of the cone of perception

    // Competition for light and flow of vigour
    double apicalDominance = 0.52; ///< λ, 0...1; above 0.5 favours the main axis
    double lightSensitivity = 1.0; ///< κ > 0 in Q = b L^κ
    double shedding = 0.1;         ///< Th, 0...1; vigour per internode of a branch, relative to the tree's
    double shadowIntensity = 0.02; ///< a, shadow of one internode in its own voxel (voxel edge = r)
    double shadowFalloff = 1.8;    ///< b > 1, a layer's shadow is a b^-q
    int shadowDepth = 6;           ///< q_max, layers of the pyramid of shadow below an internode

    // Direction of growth
    double axisWeight = 0.5;            ///< α, weight of the current direction H
    double tropismWeight = 0.2;         ///< β, weight of the tropism T
    double spaceWeight = 0.3;           ///< γ, weight of the free space E
    double setPointAngle = radians(38); ///< θ, rad, gravitropic set-point angle: 0 up, π/2 level, π down
    bool tropismFromStroke = false;     ///< θ follows the direction of the brush stroke
    bool uprightTrunk = false;          ///< θ of the trunk is 0; other settings of θ are for branches only

    // Gravimorphism (eq. 1 and figure 10)
    double ellipseVertical = 1.0; ///< s_v
    double ellipseParallel = 1.0; ///< s_p
    double ellipseOffset = 0.0;   ///< e_v, |e_v| < s_v; > 0 favours buds above the axis (epitony), < 0 below

    // Markers of free space
    double markerDensity = 0.15; ///< brush: living markers per cubic internode length
    int markerAge = 5;           ///< brush: growth steps that a marker lives
    int markersPerBud = 3;       ///< autonomous growth: markers per bud and step

    bool operator==(const GrowthParameters&) const = default;
};

/// How a tree grows by the vigour model (Strands 2024 §4; the shoot part of Rhizomorph, Li et al. 2023). A
/// growth step is a month. Any field may change at any step.
struct VigourParameters {
    double growthRate = 0.25;            ///< m a year, of a shoot in full light with the greatest potential
    double internodeLength = 0.03;       ///< m
    double branchingAngle = radians(45); ///< rad, between the axis and a lateral bud
    double rollSpread = radians(20);     ///< rad, standard deviation of the roll between nodes
    double apicalSpread = radians(3);    ///< rad, standard deviation of the axis's turn at a node
    int lateralBuds = 1;                 ///< lateral buds at a node, 1...4
    double flushingRate = 0.5; ///< chance that a lateral bud breaks, per internode of growth, uninhibited

    double apicalControl = 1.25;   ///< a_c: above 1 lower orders are stronger, below 1 higher ones
    double distanceControl = 0.0;  ///< decay of the potential with the distance from the root
    double heightControl = 0.0;    ///< decay of the potential with the height
    double apicalDominance = 0.25; ///< inhibitor that a growing tip emits in full light
    double inhibitorLoss = 0.08;   ///< share of the inhibitor that is lost from one internode to the next
    int maximumOrder = 8;          ///< axes of this order do not branch

    double gravitropism = 0.0;      ///< -1...1, share of the angle to the zenith that a new internode turns
    double phototropism = 0.045;    ///< 0...1, the same toward the light
    double horizontalTropism = 0.0; ///< 0...1, share of the angle to the level that a new lateral turns

    double bending = 0.0;         ///< k, how far branches sag under their weight
    double bendingExponent = 1.0; ///< p, how much thick branches resist
    double bendingMaximum = 1.0;  ///< 0...1, the most that an internode sags, as a share of the angle to down
    double lightPruning = 0.0;    ///< shoots with less light are shed, 0...1

    bool operator==(const VigourParameters&) const = default;
};

/// How thick branches are: d^n = Σ d_i^n (TreeSketch eq. 3).
struct WidthParameters {
    double exponent = 2.2;      ///< n, used when baseDiameter is 0
    double tipDiameter = 0.003; ///< d_e, m
    double baseDiameter = 0.0;  ///< d_b, m; 0 = follows from the exponent
    double flare = 0.5;         ///< by how much the trunk is thicker at the ground, as a share of itself

    bool operator==(const WidthParameters&) const = default;
};

enum class LeafShape : int {
    Ovate,
    Lanceolate,
    Lobed,
    Needles,
    Cordate,
    Palmate,
    Pinnate,
    Willow,
    Fascicle,
    Frond,
    Own ///< The shape of the user's own image; no parameter has this value
};
/// The number of shapes that the program draws itself: all but Own.
inline constexpr int kLeafShapeCount = 10;

/// How leaves are arranged around their shoot.
enum class LeafArrangement : int {
    Shoot,    ///< At the buds: evenly spaced around each node
    Spiral,   ///< One after another along the shoot, the golden angle apart
    Opposite, ///< Together at the node, each pair or whorl in the gaps of the one before (decussate)
    Flat,     ///< One after another, left and right, in the plane of the twig (distichous)
};
inline constexpr int kLeafArrangementCount = 4;

/// Leaves on young shoots.
struct LeafParameters {
    bool visible = true;
    LeafShape shape = LeafShape::Ovate;
    double length = 0.09;        ///< m, petiole to tip
    double aspect = 0.6;         ///< width / length
    int perNode = 2;             ///< leaves at a node, 0...8
    int maxTips = 3;             ///< an internode bears leaves only if it carries at most this many twig tips
    int reach = 1000;            ///< and if its subtree has at most this many internodes, itself included
    double angle = radians(50);  ///< rad, between the shoot and the petiole
    double droop = 0.25;         ///< 0...1, how far gravity turns a leaf down
    double upward = 0.6;         ///< 0...1, how far the blade turns its face to the sky
    double sizeVariation = 0.25; ///< 0...1
    double hue = radians(98);    ///< rad on the colour wheel (0 red, 120° green)
    double hueVariation = radians(8); ///< rad
    double saturation = 1.0;          ///< of the texture's: 0 grey, 1 as painted
    double brightness = 1.0;          ///< of the texture's
    double vigourHue = 0.25;          ///< 0...1, shift of weak shoots' leaves toward yellow and red
    LeafArrangement arrangement = LeafArrangement::Shoot;
    /// Replaces the drawing of the shape: petiole below, tip above. Its alpha channel cuts the leaf out, or,
    /// if it has none, its plain background is removed; see cutLeaf().
    ImageAsset image{};

    bool operator==(const LeafParameters&) const = default;
};

/// Which surface the wood gets.
enum class WoodMesherKind : int {
    Tubes,  ///< A tube for each axis
    Strands ///< One closed surface around bundles of strands (Strands 2024)
};
inline constexpr int kWoodMesherCount = 2;

/// How strands are arranged in a cross-section.
enum class StrandPacking : int {
    Rest, ///< At rest: no two strands overlap
    Pbd   ///< Position based dynamics as published (Strands 2024 §5.2), which does not come to rest
};
inline constexpr int kStrandPackingCount = 2;

/// The wood's surface, and the strands that it consists of (Strands 2024 §5).
struct WoodParameters {
    WoodMesherKind mesher = WoodMesherKind::Tubes;
    StrandPacking packing = StrandPacking::Rest;
    int strandsPerTip = 1; ///< 1...5, strands that begin at each tip and run to the root
    /// m; 0 = as thick as the widths of the branches want it
    double strandRadius = 0.0;
    /// α, in strand radii: strands further apart belong to different branches. More makes forks separate
    /// later.
    double alpha = 6.0;
    int steps = 500;        ///< of packing at each node; few keep the shape of a fork further down
    double smoothing = 0.5; ///< 0...1, how far ridges of single strands are smoothed
    /// 0...1, how far ridges below limbs, buttresses and the hollows of lost limbs stand out (Reliefs)
    double flutes = 0.4;

    bool operator==(const WoodParameters&) const = default;
};

enum class BarkKind : int { Furrowed, Smooth, Plated, Birch, Cherry, Mottled, Fibrous, Ringed };
inline constexpr int kBarkKindCount = 8;

struct BarkParameters {
    BarkKind kind = BarkKind::Furrowed;
    double scale = 0.5; ///< m of trunk length that one tile of texture covers
    // Images that replace the drawing of the kind. Missing normals and roughness follow from the colours.
    ImageAsset image{};          ///< Colours
    ImageAsset normalImage{};    ///< Normals in tangent space, green up
    ImageAsset roughnessImage{}; ///< Grey: 0 is a mirror, white is matte

    bool operator==(const BarkParameters&) const = default;
};

/// All parameters of a tree.
struct TreeParameters {
    GrowthParameters growth;
    VigourParameters vigour;
    WidthParameters widths;
    WoodParameters wood;
    LeafParameters leaves;
    BarkParameters bark;

    bool operator==(const TreeParameters&) const = default;
};

/// The parameters of recipes of version 1, and of projects, that do not say otherwise: rules that are younger
/// than these are off.
inline TreeParameters parametersOfFirstFiles()
{
    TreeParameters parameters;
    parameters.growth.straightening = 0.0;
    return parameters;
}

/// The kind of a parameter's value, which decides how files, recipes and panels write it.
enum class Quantity { Number, Metres, Angle, Count, Switch, Choice };

/// Describes one parameter for files, recipes, help and panels. Limits are in surface units, those of files
/// and panels: degrees for angles, the number of the choice for choices.
struct ParameterInfo {
    const char* key; ///< "group.name", stable: it is in files
    Quantity quantity;
    double minimum;
    double maximum;
    const char* choices = nullptr; ///< names of a Choice, in order, separated by spaces
};

/// Calls @p visit(info, field) for each parameter except the images (visitImages()). This is the only list of
/// the parameters. Works on const and mutable parameters.
template <class Parameters, class Visit>
void visitParameters(Parameters& p, Visit&& visit)
{
    using enum Quantity;
    auto& g = p.growth;
    visit(ParameterInfo{"growth.model", Choice, 0, kGrowthModelCount - 1, "treesketch vigour"}, g.model);
    visit(ParameterInfo{"growth.internodeLength", Metres, 0.005, 2}, g.internodeLength);
    visit(ParameterInfo{"growth.phyllotaxis", Angle, 0, 360}, g.phyllotaxis);
    visit(ParameterInfo{"growth.lateralsPerNode", Count, 1, 6}, g.lateralsPerNode);
    visit(ParameterInfo{"growth.branchingAngle", Angle, 0, 150}, g.branchingAngle);
    visit(ParameterInfo{"growth.deflectionAngle", Angle, 0, 60}, g.deflectionAngle);
    visit(ParameterInfo{"growth.irregularity", Number, 0, 1}, g.irregularity);
    visit(ParameterInfo{"growth.straightening", Number, 0, 1}, g.straightening);
    visit(ParameterInfo{"growth.maxShootLength", Count, 1, 40}, g.maxShootLength);
    visit(ParameterInfo{"growth.occupancyRadius", Number, 0.5, 10}, g.occupancyRadius);
    visit(ParameterInfo{"growth.perceptionDepth", Number, 0.5, 10}, g.perceptionDepth);
    visit(ParameterInfo{"growth.perceptionAngle", Angle, 10, 360}, g.perceptionAngle);
    visit(ParameterInfo{"growth.apicalDominance", Number, 0, 1}, g.apicalDominance);
    visit(ParameterInfo{"growth.lightSensitivity", Number, 0.05, 8}, g.lightSensitivity);
    visit(ParameterInfo{"growth.shedding", Number, 0, 1}, g.shedding);
    visit(ParameterInfo{"growth.shadowIntensity", Number, 0, 1}, g.shadowIntensity);
    visit(ParameterInfo{"growth.shadowFalloff", Number, 1.01, 10}, g.shadowFalloff);
    visit(ParameterInfo{"growth.shadowDepth", Count, 0, 16}, g.shadowDepth);
    visit(ParameterInfo{"growth.axisWeight", Number, 0, 1}, g.axisWeight);
    visit(ParameterInfo{"growth.tropismWeight", Number, 0, 1}, g.tropismWeight);
    visit(ParameterInfo{"growth.spaceWeight", Number, 0, 1}, g.spaceWeight);
    visit(ParameterInfo{"growth.setPointAngle", Angle, 0, 180}, g.setPointAngle);
    visit(ParameterInfo{"growth.tropismFromStroke", Switch, 0, 1}, g.tropismFromStroke);
    visit(ParameterInfo{"growth.uprightTrunk", Switch, 0, 1}, g.uprightTrunk);
    visit(ParameterInfo{"growth.ellipseVertical", Number, 0.05, 3}, g.ellipseVertical);
    visit(ParameterInfo{"growth.ellipseParallel", Number, 0.05, 3}, g.ellipseParallel);
    visit(ParameterInfo{"growth.ellipseOffset", Number, -3, 3}, g.ellipseOffset);
    visit(ParameterInfo{"growth.markerDensity", Number, 0.001, 4}, g.markerDensity);
    visit(ParameterInfo{"growth.markerAge", Count, 1, 100}, g.markerAge);
    visit(ParameterInfo{"growth.markersPerBud", Count, 1, 32}, g.markersPerBud);

    auto& v = p.vigour;
    visit(ParameterInfo{"vigour.growthRate", Metres, 0.01, 5}, v.growthRate);
    visit(ParameterInfo{"vigour.internodeLength", Metres, 0.005, 2}, v.internodeLength);
    visit(ParameterInfo{"vigour.branchingAngle", Angle, 0, 150}, v.branchingAngle);
    visit(ParameterInfo{"vigour.rollSpread", Angle, 0, 180}, v.rollSpread);
    visit(ParameterInfo{"vigour.apicalSpread", Angle, 0, 60}, v.apicalSpread);
    visit(ParameterInfo{"vigour.lateralBuds", Count, 1, 4}, v.lateralBuds);
    visit(ParameterInfo{"vigour.flushingRate", Number, 0, 1}, v.flushingRate);
    visit(ParameterInfo{"vigour.apicalControl", Number, 0.5, 2}, v.apicalControl);
    visit(ParameterInfo{"vigour.distanceControl", Number, 0, 2}, v.distanceControl);
    visit(ParameterInfo{"vigour.heightControl", Number, 0, 2}, v.heightControl);
    visit(ParameterInfo{"vigour.apicalDominance", Number, 0, 5}, v.apicalDominance);
    visit(ParameterInfo{"vigour.inhibitorLoss", Number, 0, 1}, v.inhibitorLoss);
    visit(ParameterInfo{"vigour.maximumOrder", Count, 1, 16}, v.maximumOrder);
    visit(ParameterInfo{"vigour.gravitropism", Number, -1, 1}, v.gravitropism);
    visit(ParameterInfo{"vigour.phototropism", Number, 0, 1}, v.phototropism);
    visit(ParameterInfo{"vigour.horizontalTropism", Number, 0, 1}, v.horizontalTropism);
    visit(ParameterInfo{"vigour.bending", Number, 0, 100}, v.bending);
    visit(ParameterInfo{"vigour.bendingExponent", Number, 0.5, 4}, v.bendingExponent);
    visit(ParameterInfo{"vigour.bendingMaximum", Number, 0, 1}, v.bendingMaximum);
    visit(ParameterInfo{"vigour.lightPruning", Number, 0, 1}, v.lightPruning);

    auto& w = p.widths;
    visit(ParameterInfo{"widths.exponent", Number, 0.5, 10}, w.exponent);
    visit(ParameterInfo{"widths.tipDiameter", Metres, 0.0002, 0.2}, w.tipDiameter);
    visit(ParameterInfo{"widths.baseDiameter", Metres, 0, 20}, w.baseDiameter);
    visit(ParameterInfo{"widths.flare", Number, 0, 2}, w.flare);

    auto& t = p.wood;
    visit(ParameterInfo{"wood.mesher", Choice, 0, kWoodMesherCount - 1, "tubes strands"}, t.mesher);
    visit(ParameterInfo{"wood.packing", Choice, 0, kStrandPackingCount - 1, "rest pbd"}, t.packing);
    visit(ParameterInfo{"wood.strandsPerTip", Count, 1, 5}, t.strandsPerTip);
    visit(ParameterInfo{"wood.strandRadius", Metres, 0, 0.1}, t.strandRadius);
    visit(ParameterInfo{"wood.alpha", Number, 2.5, 100}, t.alpha);
    visit(ParameterInfo{"wood.steps", Count, 0, 10000}, t.steps);
    visit(ParameterInfo{"wood.smoothing", Number, 0, 1}, t.smoothing);
    visit(ParameterInfo{"wood.flutes", Number, 0, 1}, t.flutes);

    auto& f = p.leaves;
    visit(ParameterInfo{"leaves.visible", Switch, 0, 1}, f.visible);
    visit(ParameterInfo{"leaves.shape", Choice, 0, kLeafShapeCount - 1,
                        "ovate lanceolate lobed needles cordate palmate pinnate willow fascicle frond"},
          f.shape);
    visit(ParameterInfo{"leaves.length", Metres, 0.005, 2}, f.length);
    visit(ParameterInfo{"leaves.aspect", Number, 0.02, 3}, f.aspect);
    visit(ParameterInfo{"leaves.perNode", Count, 0, 8}, f.perNode);
    visit(ParameterInfo{"leaves.maxTips", Count, 1, 1000}, f.maxTips);
    visit(ParameterInfo{"leaves.reach", Count, 1, 1000}, f.reach);
    visit(ParameterInfo{"leaves.angle", Angle, 0, 150}, f.angle);
    visit(ParameterInfo{"leaves.droop", Number, 0, 1}, f.droop);
    visit(ParameterInfo{"leaves.upward", Number, 0, 1}, f.upward);
    visit(ParameterInfo{"leaves.sizeVariation", Number, 0, 1}, f.sizeVariation);
    visit(ParameterInfo{"leaves.hue", Angle, 0, 360}, f.hue);
    visit(ParameterInfo{"leaves.hueVariation", Angle, 0, 90}, f.hueVariation);
    visit(ParameterInfo{"leaves.saturation", Number, 0, 1.5}, f.saturation);
    visit(ParameterInfo{"leaves.brightness", Number, 0.2, 2.5}, f.brightness);
    visit(ParameterInfo{"leaves.vigourHue", Number, 0, 1}, f.vigourHue);
    visit(ParameterInfo{"leaves.arrangement", Choice, 0, kLeafArrangementCount - 1,
                        "shoot spiral opposite flat"},
          f.arrangement);

    auto& b = p.bark;
    visit(ParameterInfo{"bark.kind", Choice, 0, kBarkKindCount - 1,
                        "furrowed smooth plated birch cherry mottled fibrous ringed"},
          b.kind);
    visit(ParameterInfo{"bark.scale", Metres, 0.02, 20}, b.scale);
}

/// Calls @p visit(key, image) for each image among the parameters, like visitParameters() for the others.
template <class Parameters, class Visit>
void visitImages(Parameters& p, Visit&& visit)
{
    visit("leaves.image", p.leaves.image);
    visit("bark.image", p.bark.image);
    visit("bark.normalImage", p.bark.normalImage);
    visit("bark.roughnessImage", p.bark.roughnessImage);
}

} // namespace espalier
