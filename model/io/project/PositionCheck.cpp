// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/PositionCheck.h"

#include "model/io/JsonReader.h"
#include "model/io/project/ProjectLimits.h"
#include "model/tree/TreeIndex.h"

#include <QCoreApplication>

namespace espalier {

namespace {

struct PositionText {
    Q_DECLARE_TR_FUNCTIONS(PositionCheck)
};

/// Positions are sums of floats; this share of the limit is far above their rounding errors.
constexpr double kRoundingMargin = 0.01;

/// How far a node can lie from the origin along an axis at any moment, m: the distance of the farthest root
/// plus the longest path, with the greatest length that each internode ever has.
double farthestReach(const Tree& tree, const Journal& journal)
{
    std::vector<double> reach(tree.columns().length.cbegin(), tree.columns().length.cend());
    double root = 0.0;
    const auto extend = [](double& value, double other) { value = std::max(value, other); };
    const auto distance = [](const Vec3& position) { return double{position.cwiseAbs().maxCoeff()}; };
    for (const auto& cell : tree.content().sparse.rootPosition.cells())
        extend(root, distance(cell.value));
    // Each value of the past is the value before some change.
    for (const auto& delta : journal) {
        for (const auto& change : delta->internodes.length)
            extend(reach[change.row], double{change.before});
        for (const auto& change : delta->sparse.rootPosition) {
            if (change.before)
                extend(root, distance(*change.before));
        }
    }
    double farthest = 0.0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        const InternodeId parent = tree.parent(id);
        reach[id] += parent == kNoInternode ? root : reach[parent];
        extend(farthest, reach[id]);
    }
    return farthest;
}

/// The places of all nodes of a tree that is taken back through its history.
class PlaceRewind {
public:
    explicit PlaceRewind(const Tree& tree);

    /// Reverts @p delta, the last one of the tree, and places what it moved again.
    void revert(const TreeDelta& delta);
    /// The first node that was placed beyond the limit; kNoInternode if there is none.
    InternodeId farNode() const { return m_farNode; }
    /// Number of rows that were looked at, in all.
    std::uint64_t work() const { return m_work; }

private:
    void place(InternodeId id);

    Tree m_tree;
    std::vector<Placement> m_places;
    std::vector<std::uint32_t> m_rounds; ///< By row: the round in which it moved last
    std::uint32_t m_round = 0;
    std::uint64_t m_work = 0;
    InternodeId m_farNode = kNoInternode;
};

PlaceRewind::PlaceRewind(const Tree& tree) : m_tree(tree), m_places(tree.size()), m_rounds(tree.size(), 0)
{
    for (InternodeId id = 0; id < tree.size(); ++id)
        place(id);
}

void PlaceRewind::place(InternodeId id)
{
    const InternodeColumns& c = m_tree.columns();
    const InternodeId parent = c.parent[id];
    Placement below{m_tree.rootPosition(id), Rotation::Identity()};
    if (parent != kNoInternode) {
        below = m_places[parent];
        if (c.along[id] != 1.0F)
            below.node -= (1.0F - c.along[id]) * c.length[parent] * (below.rotation * Vec3(Vec3::UnitY()));
    }
    m_places[id] = placeOn(below.node, below.rotation, c.rotation[id], c.length[id]);
    const bool isNear =
        m_places[id].node.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFarthestNode; // false for NaN
    if (!isNear && m_farNode == kNoInternode)
        m_farNode = id;
}

void PlaceRewind::revert(const TreeDelta& delta)
{
    m_tree.revertDropping(delta);
    if (!delta.reframes())
        return;
    ++m_round;
    InternodeId first = m_tree.size();
    delta.forEachReframed([&](InternodeId id) {
        m_rounds[id] = m_round;
        first = std::min(first, id);
    });
    m_work += m_tree.size() - first;
    for (InternodeId id = first; id < m_tree.size(); ++id) {
        const InternodeId parent = m_tree.parent(id);
        if (parent != kNoInternode && m_rounds[parent] == m_round)
            m_rounds[id] = m_round;
        if (m_rounds[id] == m_round)
            place(id);
    }
}

} // namespace

Result<void> checkPositions(const Tree& tree, const Journal& journal)
{
    if (farthestReach(tree, journal) <= (1.0 - kRoundingMargin) * double{kFarthestNode})
        return {};
    PlaceRewind rewind(tree);
    if (const InternodeId id = rewind.farNode(); id != kNoInternode)
        return inputError(PositionText::tr("internode %1").arg(id),
                          PositionText::tr("it lies more than %1 m away").arg(kFarthestNode));
    for (std::size_t i = journal.size(); i-- > 0;) {
        rewind.revert(*journal[i]);
        const QString place = PositionText::tr("step %1 of the history").arg(i + 1);
        if (const InternodeId id = rewind.farNode(); id != kNoInternode)
            return inputError(place, PositionText::tr("before it, internode %1 lies more than %2 m away")
                                         .arg(id)
                                         .arg(kFarthestNode));
        if (rewind.work() > projectLimits::kMovedRows)
            return inputError(
                place, PositionText::tr(
                           "it and the later steps move a tree whose axes are longer than %1 m too often")
                           .arg(kFarthestNode));
    }
    return {};
}

} // namespace espalier
