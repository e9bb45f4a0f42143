// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Straightening.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace espalier {

namespace {

/// Internodes that a path is followed down from a growing node: wood below is too thick to turn.
constexpr std::size_t kPathLength = 24;
/// A turn that would change by less than this stays as it is, rad.
constexpr float kLeastTurn = 0.04F;
/// Wood turns in one of so many steps, by as much more: each turn of an internode is kept in the history.
constexpr Step kStepsPerTurn = 2;

/// Of a branch.
struct Extent {
    float lowest = std::numeric_limits<float>::infinity(); ///< Of its nodes, m above the ground
    float reach = 0.0F;                                    ///< Length of its longest path, m

    /// With what stands at the end of an internode whose node is @p height m above the ground.
    void addBelow(float height, float length)
    {
        lowest = std::min(lowest, height);
        reach += length;
    }
    void join(const Extent& other)
    {
        lowest = std::min(lowest, other.lowest);
        reach = std::max(reach, other.reach);
    }
};

/// Whether the branch that begins with @p id carries more tips than any other at its node; of equal ones, the
/// oldest.
bool leads(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    const std::uint32_t tips = index.tipCount(id);
    for (InternodeId other = index.firstChild(tree.parent(id)); other != kNoInternode;
         other = index.nextSibling(other)) {
        if (index.tipCount(other) > tips || (index.tipCount(other) == tips && other < id))
            return false;
    }
    return true;
}

/// Whether a person drew the internode, or placed its axis.
bool isByHand(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    const InternodeId axis = index.axis(id);
    const float drawn = tree.drawnLength(axis);
    if (drawn <= 0.0F)
        return index.isPlacedByHand(tree, id);
    float along = 0.0F; // Of the internode's lower end
    for (InternodeId below = id; below != axis && along < drawn; along += tree.length(below))
        below = tree.parent(below);
    return along < drawn;
}

/// Straightens the paths of a growth step, each internode once.
class Straightening {
public:
    Straightening(GrowingTree& growing, GrowthWorkspace& workspace)
        : m_growing(growing),
          m_tree(growing.tree()),
          m_index(growing.index()),
          m_isMet(workspace.marks),
          m_share(static_cast<float>(1.0 -
                                     std::pow(1.0 - m_tree.parameters().growth.straightening, kStepsPerTurn)))
    {
        m_isMet.clear(m_tree.size());
        findShoots();
    }

    void straightenBelow(InternodeId tip)
    {
        if (!followDown(tip) || !spreadTurns() || !staysAboveGround())
            return;
        for (std::size_t i = 1; i < m_path.size(); ++i) {
            if (m_bends[i - 1].angle == 0.0F && m_bends[i].angle == 0.0F)
                continue;
            // What else stands at the node keeps its angle to what leads.
            for (InternodeId id = m_index.firstChild(m_path[i - 1]); id != kNoInternode;
                 id = m_index.nextSibling(id)) {
                if (mayTurn(id))
                    turn(id, m_bends[i - 1].turn, m_bends[i].turn);
            }
        }
    }

    void finish()
    {
        std::ranges::sort(m_turns, {}, &Turn::id);
        for (const Turn& turn : m_turns)
            m_growing.turn(turn.id, turn.local);
    }

private:
    struct Turn {
        InternodeId id;
        Rotation local;
    };
    /// How an internode of the path turns in the world.
    struct Bend {
        Rotation turn = Rotation::Identity();
        float angle = 0.0F; ///< rad
        float moved = 0.0F; ///< m, at most, of its upper end
    };
    /// What grew in this step.
    struct NewShoot {
        InternodeId parent; ///< Where it stands
        Extent extent;
    };

    void findShoots()
    {
        const InternodeId first = m_tree.size();
        std::vector<Extent> extents(m_growing.size() - first);
        for (InternodeId id = m_growing.size(); id-- > first;) {
            Extent& own = extents[id - first];
            own.addBelow(m_growing.nodePosition(id).y(), m_growing.length(id));
            const InternodeId parent = m_growing.parent(id);
            if (m_growing.isNew(parent))
                extents[parent - first].join(own);
            else
                m_shoots.push_back({parent, own});
        }
        std::ranges::stable_sort(m_shoots, {}, &NewShoot::parent);
        for (const NewShoot& shoot : m_shoots)
            m_longestShoot = std::max(m_longestShoot, shoot.extent.reach);
    }

    bool mayTurn(InternodeId id) const
    {
        return !m_tree.isRoot(id) && !isByHand(m_tree, m_index, id) &&
               !(m_tree.parameters().growth.uprightTrunk && m_tree.isRoot(m_index.axis(id)));
    }

    /// Sets the path that ends with @p tip, from below. Returns whether something of it can turn.
    bool followDown(InternodeId tip)
    {
        m_path.assign(1, tip);
        for (InternodeId id = tip; m_path.size() < kPathLength && mayTurn(id) && m_isMet.setOnce(id, 1) &&
                                   leads(m_tree, m_index, id);) {
            const InternodeId parent = m_tree.parent(id);
            // A lateral keeps its angle to an axis that stays as it is.
            if (!mayTurn(parent) && !m_tree.continuesAxis(id))
                break;
            id = parent;
            m_path.push_back(id);
        }
        std::ranges::reverse(m_path);
        return m_path.size() > 2;
    }

    /// Sets the bends along the path. Returns whether there are any.
    bool spreadTurns()
    {
        m_bends.assign(m_path.size(), {});
        bool isBent = false;
        for (std::size_t i = 1; i < m_path.size(); ++i) {
            Bend& bend = m_bends[i];
            bend.moved = m_bends[i - 1].moved;
            if (i + 1 == m_path.size())
                break;
            const Vec3 heading = m_index.heading(m_path[i]);
            const Vec3 around = m_index.heading(m_path[i - 1]) + m_index.heading(m_path[i + 1]);
            const Vec3 wanted = heading + m_share * (0.5F * around - heading);
            const float angle = std::atan2(heading.cross(wanted).norm(), heading.dot(wanted));
            if (angle < kLeastTurn)
                continue;
            bend.turn = Rotation(Eigen::Quaternionf::FromTwoVectors(heading, wanted));
            bend.angle = angle;
            bend.moved += angle * m_tree.length(m_path[i]);
            isBent = true;
        }
        return isBent;
    }

    bool staysAboveGround() const
    {
        for (std::size_t i = 0; i < m_path.size(); ++i) {
            const InternodeId id = m_path[i];
            const Bend& bend = m_bends[i];
            if (m_index.nodePosition(id).y() < bend.moved)
                return false;
            const bool isLast = i + 1 == m_path.size();
            const float angle = std::max(bend.angle, isLast ? 0.0F : m_bends[i + 1].angle);
            const auto stays = [&](const Extent& extent) {
                return extent.lowest >= bend.moved + angle * extent.reach;
            };
            for (InternodeId child = m_index.firstChild(id); child != kNoInternode;
                 child = m_index.nextSibling(child)) {
                if (!isLast && child == m_path[i + 1])
                    continue;
                // It cannot be longer than if all of it were one line.
                const float most = static_cast<float>(m_index.subtreeSize(child)) * m_index.greatestLength() +
                                   m_longestShoot;
                if (!stays({m_index.nodePosition(id).y() - most, most}) && !stays(extentOf(child)))
                    return false;
            }
            const auto shoots = std::ranges::equal_range(m_shoots, id, {}, &NewShoot::parent);
            if (!std::ranges::all_of(shoots, stays, &NewShoot::extent))
                return false;
        }
        return true;
    }

    /// Of what the branch that begins with an internode carries, in this step's shoots as well.
    Extent extentOf(InternodeId branch) const
    {
        Extent extent;
        struct Open {
            InternodeId id;
            float reach;
        };
        std::vector<Open> open{{branch, 0.0F}};
        while (!open.empty()) {
            const auto [id, below] = open.back();
            open.pop_back();
            const float reach = below + m_tree.length(id);
            extent.join({m_index.nodePosition(id).y(), reach});
            for (InternodeId child = m_index.firstChild(id); child != kNoInternode;
                 child = m_index.nextSibling(child))
                open.push_back({child, reach});
            for (const NewShoot& shoot : std::ranges::equal_range(m_shoots, id, {}, &NewShoot::parent))
                extent.join({shoot.extent.lowest, reach + shoot.extent.reach});
        }
        return extent;
    }

    /// Turns an internode by @p own in the world, where its carrier turns by @p carriers.
    void turn(InternodeId id, const Rotation& carriers, const Rotation& own)
    {
        const Rotation& carrier = m_index.rotation(m_tree.parent(id));
        const Rotation local = (carriers * carrier).conjugate() * (own * m_index.rotation(id));
        m_turns.push_back({id, local.normalized()});
    }

    GrowingTree& m_growing;
    const Tree& m_tree;
    const TreeIndex& m_index;
    StampedColumn<std::uint8_t>& m_isMet;
    std::vector<NewShoot> m_shoots; ///< By where they stand
    float m_longestShoot = 0.0F;    ///< m
    float m_share;
    std::vector<InternodeId> m_path;
    std::vector<Bend> m_bends; ///< By place on the path
    std::vector<Turn> m_turns;
};

} // namespace

void straightenWood(GrowingTree& growing, std::span<const InternodeId> growingAt, GrowthWorkspace& workspace)
{
    const Tree& tree = growing.tree();
    if (tree.parameters().growth.straightening <= 0.0 || growingAt.empty() ||
        tree.step() % kStepsPerTurn != 0)
        return;
    std::vector<InternodeId> tips(growingAt.begin(), growingAt.end());
    std::ranges::sort(tips, std::greater());
    const auto repeated = std::ranges::unique(tips);
    tips.erase(repeated.begin(), repeated.end());
    Straightening straightening(growing, workspace);
    for (const InternodeId tip : tips)
        straightening.straightenBelow(tip);
    straightening.finish();
}

} // namespace espalier
