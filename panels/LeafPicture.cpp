// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LeafPicture.h"

#include "model/sketch/BranchAxis.h"
#include "model/tree/PlacedLeafIndex.h"
#include "panels/Theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace espalier {

namespace {

constexpr std::size_t kMostDrawn = 2'000; ///< Internodes
constexpr qreal kFrame = 4.0;             ///< px around the branch
constexpr qreal kAxisLine = 2.4;          ///< px
constexpr qreal kTwigLine = 1.2;          ///< px
/// A branch is seen from the side if its direction and the viewer's make a smaller angle than this has as its
/// sine.
constexpr float kLeastBroadside = 0.5F;
/// By which the view is turned around the branch, rad.
constexpr float kAside = 0.35F;
/// A leaf's outline, base to tip and back: x in widths, y in lengths.
constexpr std::array<std::array<float, 2>, 10> kOutline{{{0.0F, 0.0F},
                                                         {0.06F, 0.12F},
                                                         {0.38F, 0.3F},
                                                         {0.5F, 0.5F},
                                                         {0.32F, 0.76F},
                                                         {0.0F, 1.0F},
                                                         {-0.32F, 0.76F},
                                                         {-0.5F, 0.5F},
                                                         {-0.38F, 0.3F},
                                                         {-0.06F, 0.12F}}};

/// From the world to the picture.
struct Frame {
    Vec3 right;
    Vec3 up;
    Vec2 middle;     ///< m
    double scale;    ///< px per m
    double halfEdge; ///< px

    Vec2 flat(const Vec3& place) const { return {place.dot(right), place.dot(up)}; }
    QPointF operator()(const Vec3& place) const
    {
        const Vec2 offset = flat(place) - middle;
        return {halfEdge + scale * double{offset.x()}, halfEdge - scale * double{offset.y()}};
    }
};

/// The viewer's axes, turned around the branch's direction where the viewer sees it nearly end-on.
void standBeside(const Vec3& direction, Vec3& right, Vec3& up)
{
    const Vec3 toViewer = right.cross(up);
    const Vec3 seen = direction - direction.dot(toViewer) * toViewer;
    if (seen.norm() >= kLeastBroadside)
        return;
    // The branch grows upward in the picture.
    up = direction;
    const Vec3 side = direction.cross(toViewer);
    right = side.norm() > 1e-3F ? Vec3(side.normalized()) : right;
}

/// The rows of the leaves that a delta adds to a tree or changes.
std::unordered_set<LeafId> touchedLeaves(const TreeDelta& delta)
{
    std::unordered_set<LeafId> touched;
    for (LeafId leaf = delta.bornLeaves.first; leaf != delta.bornLeaves.end(); ++leaf)
        touched.insert(leaf);
    const auto add = [&touched](const auto& changes) {
        for (const auto& change : changes)
            touched.insert(change.row);
    };
    add(delta.leaves.internode);
    add(delta.leaves.along);
    add(delta.leaves.rotation);
    add(delta.leaves.length);
    return touched;
}

/// An axis and what it carries, nearer things first.
std::vector<InternodeId> branchWithTwigs(const TreeIndex& index, const std::vector<InternodeId>& axis)
{
    std::vector<InternodeId> all = axis;
    std::unordered_set<InternodeId> found(axis.begin(), axis.end());
    for (std::size_t i = 0; i < all.size() && all.size() < kMostDrawn; ++i) {
        for (InternodeId child = index.firstChild(all[i]); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (found.insert(child).second)
                all.push_back(child);
        }
    }
    return all;
}

struct ShownLeaf {
    LeafId row;
    float nearness; ///< m, toward the viewer
};

} // namespace

QImage leafPicture(const Tree& tree, const TreeIndex& index, InternodeId branch, const TreeDelta& suggestion,
                   const LeafPictureStyle& style)
{
    Tree after = tree;
    after.apply(suggestion);
    const std::vector<InternodeId> axis = BranchAxis(tree, index, branch).internodes();
    const Vec3 base = index.basePosition(tree, axis.front());
    Vec3 right = style.right;
    Vec3 up = style.up;
    const Vec3 direction = (index.nodePosition(axis.back()) - base).normalized();
    standBeside(direction, right, up);
    // Seen a little from the side of the branch, no leaf of a drawing is exactly edge-on.
    const Rotation aside(Eigen::AngleAxisf(kAside, direction));
    right = aside * right;
    up = aside * up;

    const std::vector<InternodeId> wood = branchWithTwigs(index, axis);
    const std::unordered_set<InternodeId> drawn(wood.begin(), wood.end());
    const LeafColumns& rows = after.placedLeaves();
    std::vector<ShownLeaf> leaves;
    float longest = 0.0F;
    for (LeafId row = 0; row < rows.size(); ++row) {
        if (rows.death[row] != kNever || !drawn.contains(rows.internode[row]))
            continue;
        leaves.push_back({row, placedLeafBase(after, index, row).dot(right.cross(up))});
        longest = std::max(longest, rows.length[row]);
    }
    std::ranges::stable_sort(leaves, {}, &ShownLeaf::nearness);

    Frame frame{.right = right, .up = up, .middle = {}, .scale = 1.0, .halfEdge = 0.5 * style.edge};
    Eigen::AlignedBox2f bounds(frame.flat(base));
    for (const InternodeId id : axis)
        bounds.extend(frame.flat(index.nodePosition(id)));
    frame.middle = bounds.center();
    const double extent = double{bounds.sizes().maxCoeff()} + double{longest};
    frame.scale = (style.edge - 2.0 * kFrame) / std::max(extent, 1e-6);

    QImage picture(QSize(style.edge, style.edge) * style.pixelRatio, QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(style.pixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = wood.size(); i-- > 0;) {
        const bool isOnAxis = i < axis.size();
        painter.setPen(QPen(isOnAxis ? theme::kDimText : theme::kFaintText, isOnAxis ? kAxisLine : kTwigLine,
                            Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(frame(index.basePosition(tree, wood[i])), frame(index.nodePosition(wood[i])));
    }
    const std::unordered_set<LeafId> touched = touchedLeaves(suggestion);
    const float width = static_cast<float>(after.parameters().leaves.aspect);
    for (const ShownLeaf& leaf : leaves) {
        const Vec3 place = placedLeafBase(after, index, leaf.row);
        const Rotation turn = placedLeafFrame(after, index, leaf.row);
        QPolygonF outline;
        for (const auto& [x, y] : kOutline)
            outline << frame(place + rows.length[leaf.row] * (turn * Vec3(x * width, y, 0.0F)));
        const bool isProposed = touched.contains(leaf.row);
        const QColor& colour = isProposed ? theme::kAccent : theme::kFaintText;
        painter.setBrush(colour);
        painter.setPen(QPen(isProposed ? theme::kAccentText : theme::kDimText, 0.8));
        painter.drawPolygon(outline);
    }
    return picture;
}

} // namespace espalier
