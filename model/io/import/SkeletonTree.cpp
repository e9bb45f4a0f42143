// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/SkeletonTree.h"

#include "model/base/Random.h"
#include "model/io/JsonReader.h"
#include "model/io/import/SkeletonText.h"
#include "model/tree/TreeIndex.h"

#include <algorithm>
#include <optional>

namespace espalier {

namespace {

/// Segments that are shorter, m, are left out.
constexpr float kShortestPiece = 1e-4F;
/// A branch that begins within this share of the length before its parent's end begins at the end.
constexpr float kAtEnd = 0.02F;
constexpr int kLastSlot = kBudSlots - 1;

/// An internode to be.
struct Piece {
    std::size_t segment;
    std::size_t parent; ///< Index of the piece that carries it; kNoPiece for a root
    float along = 1.0F; ///< Where on the parent it begins
    Vec3 base = Vec3::Zero();
    Rotation local = Rotation::Identity();
    float length = 0.0F;
    Placement end{}; ///< In the world
};

constexpr std::size_t kNoPiece = std::numeric_limits<std::size_t>::max();

Error faultOf(std::size_t segment, const QString& fault)
{
    return inputError(SkeletonText::tr("segment %1").arg(segment + 1), fault);
}

bool hasLength(const SkeletonSegment& segment)
{
    return (segment.tip - segment.base).norm() >= kShortestPiece;
}

/// For each segment, the nearest one with a length among those that carry it; kNoPiece if there is none.
std::vector<std::size_t> carriersOf(const Skeleton& skeleton)
{
    std::vector<std::size_t> carriers(skeleton.size(), kNoPiece);
    for (std::size_t i = 0; i < skeleton.size(); ++i) {
        const std::uint32_t parent = skeleton[i].parent;
        if (parent != kNoInternode)
            carriers[i] = hasLength(skeleton[parent]) ? parent : carriers[parent];
    }
    return carriers;
}

/// The pieces of those segments that have a length, not placed yet: parents first, and the thickest root
/// before all others.
std::vector<Piece> piecesOf(const Skeleton& skeleton)
{
    const std::vector<std::size_t> carriers = carriersOf(skeleton);
    std::optional<std::size_t> thickest;
    for (std::size_t i = 0; i < skeleton.size(); ++i) {
        const bool isRoot = carriers[i] == kNoPiece && hasLength(skeleton[i]);
        if (isRoot && (!thickest || skeleton[i].radius > skeleton[*thickest].radius))
            thickest = i;
    }
    std::vector<Piece> pieces;
    if (!thickest)
        return pieces;
    std::vector<std::size_t> pieceOf(skeleton.size(), kNoPiece);
    const auto add = [&](std::size_t segment) {
        const std::size_t carrier = carriers[segment];
        pieceOf[segment] = pieces.size();
        pieces.push_back({.segment = segment, .parent = carrier == kNoPiece ? kNoPiece : pieceOf[carrier]});
    };
    add(*thickest);
    for (std::size_t i = 0; i < skeleton.size(); ++i) {
        if (i != *thickest && hasLength(skeleton[i]))
            add(i);
    }
    return pieces;
}

/// Puts the piece where its segment is, as a row of a tree would stand there.
Result<void> place(Piece& piece, const std::vector<Piece>& pieces, const SkeletonSegment& segment,
                   const Vec3& offset)
{
    const Vec3 tip = segment.tip - offset;
    Rotation below = Rotation::Identity();
    piece.base = segment.base - offset;
    if (piece.parent != kNoPiece) {
        const Piece& parent = pieces[piece.parent];
        below = parent.end.rotation;
        const Vec3 way = parent.end.node - parent.base;
        const float along = (piece.base - parent.base).dot(way) / way.squaredNorm();
        piece.along = along > 1.0F - kAtEnd ? 1.0F : std::max(0.0F, along);
        piece.base = piece.along == 1.0F
                         ? parent.end.node
                         : Vec3(parent.end.node - (1.0F - piece.along) * parent.length *
                                                      (parent.end.rotation * Vec3(Vec3::UnitY())));
    } else if (piece.base.cwiseAbs().maxCoeff() > kFarthestRoot) {
        return faultOf(piece.segment, SkeletonText::tr("it stands more than %1 m from the thickest trunk")
                                          .arg(static_cast<double>(kFarthestRoot)));
    }
    const Vec3 way = tip - piece.base;
    piece.length = std::max(way.norm(), kShortestPiece);
    if (piece.length > kGreatestLength || tip.cwiseAbs().maxCoeff() > kFarthestNode)
        return faultOf(piece.segment, SkeletonText::tr("it is longer than %1 m, or more than %2 m away")
                                          .arg(static_cast<double>(kGreatestLength))
                                          .arg(static_cast<double>(kFarthestNode)));
    // The frame is carried along without a twist.
    const Vec3 heading =
        way.norm() < kShortestPiece ? Vec3(Vec3::UnitY()) : Vec3(below.conjugate() * way.normalized());
    piece.local = Rotation(Eigen::Quaternionf::FromTwoVectors(Vec3(Vec3::UnitY()), heading)).normalized();
    piece.end = placeOn(piece.base, below, piece.local, piece.length);
    return {};
}

/// The slots of the buds that the pieces grew from, and how many pieces before them share parent and slot.
struct Slots {
    std::vector<std::uint8_t> slot;
    std::vector<Step> repeats;
    std::vector<BudMask> used; ///< By piece: the slots of its children
};

Slots slotsOf(const std::vector<Piece>& pieces, const Skeleton& skeleton)
{
    std::vector<std::size_t> continuing(pieces.size(), kNoPiece);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::size_t parent = pieces[i].parent;
        if (parent == kNoPiece || pieces[i].along < 1.0F)
            continue;
        std::size_t& best = continuing[parent];
        if (best == kNoPiece || skeleton[pieces[i].segment].radius > skeleton[pieces[best].segment].radius)
            best = i;
    }
    Slots slots{std::vector<std::uint8_t>(pieces.size(), kTerminalSlot), std::vector<Step>(pieces.size(), 0),
                std::vector<BudMask>(pieces.size(), 0)};
    std::vector<Step> crowd(pieces.size(), 0); // children in the last slot
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::size_t parent = pieces[i].parent;
        if (parent == kNoPiece)
            continue;
        int slot = kTerminalSlot;
        if (continuing[parent] != i) {
            slot = kFirstAdventitiousSlot; // See TreeIndex::isPlacedByHand()
            while (slot < kLastSlot && (slots.used[parent] & budBit(slot)) != 0)
                ++slot;
            if (slot == kLastSlot)
                slots.repeats[i] = crowd[parent]++;
        }
        slots.slot[i] = static_cast<std::uint8_t>(slot);
        slots.used[parent] = static_cast<BudMask>(slots.used[parent] | budBit(slot));
    }
    return slots;
}

/// Adds the births of leaves to @p delta. @p offset: the place that becomes the world's origin.
void addSkeletonLeaves(TreeDelta& delta, std::span<const SkeletonLeaf> leaves,
                       const std::vector<Piece>& pieces, const Skeleton& skeleton, const Vec3& offset)
{
    if (leaves.empty())
        return;
    const std::vector<std::size_t> carriers = carriersOf(skeleton);
    std::vector<std::size_t> pieceOf(skeleton.size(), kNoPiece);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        pieceOf[pieces[i].segment] = i;
    for (const SkeletonLeaf& leaf : leaves) {
        const std::size_t carrier = hasLength(skeleton[leaf.segment]) ? leaf.segment : carriers[leaf.segment];
        if (carrier == kNoPiece)
            continue; // there is no wood that it could stand on
        const Piece& piece = pieces[pieceOf[carrier]];
        const Vec3 heading = piece.end.rotation * Vec3(Vec3::UnitY());
        const float down = (piece.end.node - (leaf.base - offset)).dot(heading);
        LeafRow row;
        row.internode = static_cast<InternodeId>(pieceOf[carrier]);
        row.along = std::clamp(1.0F - down / piece.length, 0.0F, 1.0F);
        row.rotation = (piece.end.rotation.conjugate() * leaf.blade.frame).normalized();
        row.length = leaf.blade.length;
        addLeaf(delta, row);
    }
}

} // namespace

Result<TreeDelta> growSkeleton(const Tree& tree, const Skeleton& skeleton,
                               std::span<const SkeletonLeaf> leaves)
{
    std::vector<Piece> pieces = piecesOf(skeleton);
    if (pieces.empty())
        return Error{Error::Kind::Input, SkeletonText::tr("no segment has a length")};
    Vec3 offset = skeleton[pieces.front().segment].base;
    for (const Piece& piece : pieces) {
        if (piece.parent == kNoPiece)
            offset.y() = std::min(offset.y(), skeleton[piece.segment].base.y());
    }
    for (Piece& piece : pieces) {
        if (Result<void> placed = place(piece, pieces, skeleton[piece.segment], offset); !placed)
            return placed.error();
    }

    const Slots slots = slotsOf(pieces, skeleton);
    TreeDelta delta = deltaStartingAt(tree);
    delta.stepAfter = delta.stepBefore + 1;
    delta.born.count = static_cast<std::uint32_t>(pieces.size() - 1);
    delta.rows = std::make_shared<TreeRows>();
    const auto laterals = static_cast<BudMask>((1U << tree.parameters().growth.lateralsPerNode) - 1U);
    std::vector<InternodeKey> keys;
    std::uint32_t roots = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        const auto id = static_cast<InternodeId>(i);
        const bool isTip = (slots.used[i] & kTerminalBud) == 0;
        const BudStates buds =
            isTip ? BudStates::active(static_cast<BudMask>((laterals & ~slots.used[i]) | kTerminalBud))
                  : BudStates();
        const bool isRoot = piece.parent == kNoPiece;
        keys.push_back(isRoot
                           ? rootKey(tree.seed(), roots++)
                           : childKey(keys[piece.parent], slots.slot[i], delta.stepAfter + slots.repeats[i]));
        if (i == 0) {
            delta.addFrame(id, tree.columns().rotation[id], piece.local, tree.length(id), piece.length);
            delta.internodes.buds.push_back({id, tree.budStates(id), buds});
        } else {
            delta.rows->internodes.append(
                {.parent = isRoot ? kNoInternode : static_cast<InternodeId>(piece.parent),
                 .along = piece.along,
                 .rotation = piece.local,
                 .length = piece.length,
                 .vigour = 1.0F,
                 .slot = slots.slot[i],
                 .buds = buds,
                 .birth = delta.stepAfter,
                 .parameterSet = static_cast<std::uint16_t>(tree.currentParameterSet()),
                 .key = keys.back()});
        }
        // The seedling may have a place and a width already.
        const SparseColumns& sparse = tree.content().sparse;
        if (isRoot && piece.base != Vec3(Vec3::Zero()))
            delta.sparse.rootPosition.push_back({id, sparse.rootPosition.at(id), piece.base});
        if (const float radius = skeleton[piece.segment].radius; radius > 0.0F)
            delta.sparse.width.push_back({id, sparse.width.at(id), 2.0F * radius});
    }
    addSkeletonLeaves(delta, leaves, pieces, skeleton, offset);
    return delta;
}

} // namespace espalier
