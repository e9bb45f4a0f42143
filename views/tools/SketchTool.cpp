// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/SketchTool.h"

#include "commands/PlaceLeaves.h"
#include "commands/Prune.h"
#include "model/envelope/LassoLoop.h"
#include "model/sketch/FlatTree.h"
#include "model/sketch/LeafPlacement.h"
#include "views/tools/ToolColours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// The drawing's plane is drawn in unless it is seen at a sharper angle than this from its edge.
constexpr float kLeastFacing = 0.25F;
/// Radii that a branch gets.
constexpr std::size_t kFormRadii = 12;
/// A branch is at its base at most so many times as thick as the wood below it.
constexpr float kMostOfParent = 0.65F;
/// A larger loop is a crown, as a share of the tree's size.
constexpr float kLargestLeaf = 0.4F;
/// The ring around the place where a stroke would join: its least radius, px, and its radius in those of the
/// wood.
constexpr float kJoinRing = 6.0F;
constexpr float kRingInRadii = 1.25F;

/// px to the right and up.
Eigen::Vector2d upward(const QPointF& screen)
{
    return {screen.x(), -screen.y()};
}

/// The nodes of the living wood.
Box3 boundsOf(const TreeDocument& document)
{
    Box3 box;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id))
            box.extend(document.index().nodePosition(id));
    }
    box.extend(document.tree().rootPosition(0));
    return box;
}

QPointF downward(const Eigen::Vector2d& pixel)
{
    return {pixel.x(), -pixel.y()};
}

} // namespace

void SketchTool::begin(const PointerSample& sample)
{
    m_filling.end();
    m_isActive = true;
    m_isCutting = sample.isEraser || sample.modifiers.testFlag(Qt::ShiftModifier) ||
                  context().viewSettings().values().sketchCuts;
    m_path = {sample.position};
    m_place.reset();
    context().requestRepaint();
}

void SketchTool::move(const PointerSample& sample)
{
    if (!m_isActive || m_path.back() == sample.position)
        return;
    // The ink comes first: the tree changes when the pointer is lifted.
    m_path.push_back(sample.position);
    if (m_isCutting)
        crossOut();
    context().requestRepaint();
}

void SketchTool::end(const PointerSample& sample)
{
    move(sample);
    finish();
}

void SketchTool::finish()
{
    if (!std::exchange(m_isActive, false))
        return;
    if (m_isCutting) {
        const std::vector<InternodeId> cuts = m_preview.take(context());
        if (!cuts.empty())
            pruneBranches(context().document(), cuts);
    } else {
        draw();
    }
    m_path.clear();
    context().requestRepaint();
}

void SketchTool::cancel()
{
    m_isActive = false;
    m_path.clear();
    m_preview.show(context(), {});
    leave();
}

void SketchTool::hover(const PointerSample& sample)
{
    m_pointer = sample.position;
    m_place.reset();
    m_placeRevision = context().document().revision();
    if (!isSeedling() && !sample.isEraser && !context().viewSettings().values().sketchCuts) {
        const Eigen::Vector2d pixel = upward(sample.position);
        if (const std::optional<Attachment> nearest = attachmentOf(pixel, pixel))
            m_place = nearest->place;
    }
    context().requestRepaint();
}

void SketchTool::leave()
{
    m_place.reset();
    context().requestRepaint();
}

bool SketchTool::isSeedling() const
{
    return context().document().index().livingCount() == 1;
}

std::optional<Attachment> SketchTool::attachmentOf(const Eigen::Vector2d& first,
                                                   const Eigen::Vector2d& last) const
{
    const Camera& camera = context().camera();
    const auto seen = [&camera](const Vec3& point) {
        const std::optional<QPointF> place = camera.project(point);
        return place ? std::optional(upward(*place)) : std::nullopt;
    };
    const TreeDocument& document = context().document();
    return nearestAttachment(document.tree(), document.index(), seen, first, last);
}

SketchTool::Plane SketchTool::planeThrough(const Vec3& base) const
{
    const TreeDocument& document = context().document();
    const Camera& camera = context().camera();
    if (std::abs(camera.forward().z()) > kLeastFacing && isFlat(document.tree(), document.index()))
        return {};
    return {.origin = base, .right = camera.right(), .up = camera.up(), .isDrawing = false};
}

Vec3 SketchTool::onPlane(const Plane& plane, const Eigen::Vector2d& pixel) const
{
    const Camera& camera = context().camera();
    if (!plane.isDrawing)
        return camera.onPlane(downward(pixel), plane.origin);
    const Ray ray = camera.ray(downward(pixel));
    // planeThrough() has seen to it that the ray is not parallel to the plane.
    return ray.origin - ray.origin.z() / ray.direction.z() * ray.direction;
}

SketchTool::Reading SketchTool::reading() const
{
    SketchLine samples;
    for (const QPointF& point : m_path)
        samples.push_back(upward(point));
    std::optional<SketchStroke> stroke = fitStroke(samples);
    if (!stroke || stroke->kind == SketchStroke::Kind::Dot)
        return {};
    if (stroke->kind == SketchStroke::Kind::Closed) {
        const Meaning meaning = isLarge(stroke->line) ? Meaning::Crown : Meaning::Leaf;
        return {.meaning = meaning, .line = std::move(stroke->line), .radii = {}};
    }
    const bool mayBeSide = m_last && context().viewSettings().values().sketchSides &&
                           m_last->revision == context().document().revision() &&
                           m_last->camera == context().camera();
    if (mayBeSide) {
        if (std::optional<TwoSidedBranch> branch = twoSidedBranch(m_last->line, stroke->line)) {
            if (!m_last->base && branch->axis.front().y() > branch->axis.back().y()) { // Drawn downward
                std::ranges::reverse(branch->axis);
                std::ranges::reverse(branch->radii);
            }
            return {.meaning = Meaning::SecondSide,
                    .line = std::move(branch->axis),
                    .radii = std::move(branch->radii)};
        }
    }
    return {.meaning = Meaning::Branch, .line = std::move(stroke->line), .radii = {}};
}

/// Whether a loop is large for the tree, or there is none.
bool SketchTool::isLarge(const SketchLine& outline) const
{
    const TreeDocument& document = context().document();
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : outline)
        box.extend(point);
    const Vec3 foot = document.tree().rootPosition(0);
    const Camera& camera = context().camera();
    const double scale = camera.pixelsPerMetre(std::max(camera.depth(foot), Camera::kMinDistance));
    const double size = double{boundsOf(document).sizes().norm()};
    return isSeedling() || box.diagonal().norm() > kLargestLeaf * size * scale;
}

void SketchTool::draw()
{
    Reading drawn = reading();
    if (drawn.meaning == Meaning::Nothing)
        return;
    const std::optional<Side> first = std::exchange(m_last, std::nullopt);
    switch (drawn.meaning) {
    case Meaning::Nothing:
        break;
    case Meaning::Crown:
        drawCrown(drawn.line);
        break;
    case Meaning::Leaf:
        drawLeaf(std::move(drawn.line));
        break;
    case Meaning::Branch:
    case Meaning::SecondSide:
        drawBranch(std::move(drawn), first);
        break;
    }
}

/// The tree fills the outline, in the plane through its foot, and, if the sides are to be filled, across it.
void SketchTool::drawCrown(const SketchLine& outline)
{
    const Camera& camera = context().camera();
    LassoStroke stroke{context().document().tree().rootPosition(0), camera.right(), camera.up(), {}};
    for (const Eigen::Vector2d& pixel : outline) {
        const Vec3 offset = camera.onPlane(downward(pixel), stroke.origin) - stroke.origin;
        stroke.points.emplace_back(offset.dot(stroke.right), offset.dot(stroke.up));
    }
    if (context().viewSettings().values().secondTree)
        m_filling.fillAll(std::array{stroke, turnedToTheSide(stroke)});
    else
        m_filling.fill(stroke);
}

void SketchTool::drawLeaf(SketchLine outline)
{
    TreeDocument& document = context().document();
    // The point that is nearest to the wood is the leaf's base.
    std::optional<Attachment> nearest;
    std::size_t base = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::optional<Attachment> here = attachmentOf(outline[i], outline[i]);
        if (here && (!nearest || here->distance < nearest->distance)) {
            nearest = here;
            base = i;
        }
    }
    if (!nearest)
        return;
    std::ranges::rotate(outline, outline.begin() + static_cast<std::ptrdiff_t>(base));
    const Vec3 place = positionOf(document.tree(), document.index(), nearest->place);
    const Plane plane = planeThrough(place);
    std::vector<Eigen::Vector3d> inSpace{place.cast<double>()};
    for (std::size_t i = 1; i < outline.size(); ++i)
        inSpace.emplace_back(onPlane(plane, outline[i]).cast<double>());
    const Vec3 toViewer = plane.right.cross(plane.up);
    const std::optional<LeafBlade> blade = bladeOf(inSpace, toViewer.cast<double>());
    if (blade)
        placeLeaf(document, leafOn(document.tree(), document.index(), nearest->place.internode,
                                   nearest->place.along, *blade));
}

void SketchTool::drawBranch(Reading drawn, const std::optional<Side>& first)
{
    TreeDocument& document = context().document();
    const Camera& camera = context().camera();
    if (isSeedling()) // A new drawing has no form yet
        m_form = kUsualForm;
    BranchStroke stroke{.stroke = {}, .base = {}};
    stroke.isMirrored = context().viewSettings().values().sketchMirror;
    const bool hasSides = drawn.meaning == Meaning::SecondSide;
    if (hasSides) {
        stroke.base = first->base;
        stroke.replaces = first->branch;
    } else if (!isSeedling()) {
        const std::optional<Attachment> nearest = attachmentOf(drawn.line.front(), drawn.line.back());
        if (!nearest)
            return;
        stroke.base = nearest->place;
        if (nearest->isReversed)
            std::ranges::reverse(drawn.line);
    }
    const Vec3 base = stroke.base ? positionOf(document.tree(), document.index(), *stroke.base)
                                  : document.tree().rootPosition(0);
    const Plane plane = planeThrough(base);
    stroke.stroke = {plane.origin, plane.right, plane.up, {}};
    float length = 0.0F;
    for (const Eigen::Vector2d& pixel : drawn.line) {
        const Vec3 offset = onPlane(plane, pixel) - plane.origin;
        const Vec2 point(offset.dot(plane.right), offset.dot(plane.up));
        if (!stroke.stroke.points.empty())
            length += (point - stroke.stroke.points.back()).norm();
        stroke.stroke.points.push_back(point);
    }
    if (hasSides) {
        const float scale = 1.0F / camera.pixelsPerMetre(std::max(camera.depth(base), Camera::kMinDistance));
        m_form.clear();
        for (std::size_t i = 0; i < kFormRadii; ++i) {
            const std::size_t at = i * (drawn.radii.size() - 1) / (kFormRadii - 1);
            stroke.radii.push_back(scale * static_cast<float>(drawn.radii[at]));
            m_form.push_back(length > 0.0F ? stroke.radii.back() / length : 0.0F);
        }
    } else {
        stroke.radii = usualRadii(stroke.base, length);
    }
    const Result<InternodeId> branch = sketchBranch(document, stroke);
    if (!branch) {
        m_refused(branch.error().message);
        return;
    }
    if (!hasSides)
        m_last = Side{.line = std::move(drawn.line),
                      .branch = *branch,
                      .base = stroke.base,
                      .camera = camera,
                      .revision = document.revision()};
}

std::vector<float> SketchTool::usualRadii(const std::optional<BranchPlace>& base, float length) const
{
    float scale = length;
    if (base && m_form.front() > 0.0F)
        scale = std::min(scale, kMostOfParent * context().branchRadius(base->internode) / m_form.front());
    std::vector<float> radii;
    for (const float radius : m_form)
        radii.push_back(scale * radius);
    return radii;
}

void SketchTool::crossOut()
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    SketchLine blade;
    for (const QPointF& point : m_path)
        blade.push_back(upward(point));
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : blade)
        box.extend(point);
    std::vector<InternodeId> crossed; // Axis by axis, base first
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const auto lower = camera.project(index.basePosition(tree, id));
        const auto upper = camera.project(index.nodePosition(id));
        if (!lower || !upper)
            continue;
        Eigen::AlignedBox2d piece(upward(*lower));
        piece.extend(upward(*upper));
        if (piece.intersects(box)) {
            const SketchLine segment{upward(*lower), upward(*upper)};
            for (std::size_t i = properCrossings(segment, blade).size(); i > 0; --i)
                crossed.push_back(id);
        }
    }
    std::ranges::stable_sort(crossed, {}, [&](InternodeId id) { return index.axis(id); });
    std::vector<InternodeId> cuts;
    for (std::size_t i = 0; i < crossed.size();) {
        const InternodeId axis = index.axis(crossed[i]);
        std::size_t end = i;
        while (end < crossed.size() && index.axis(crossed[end]) == axis)
            ++end;
        const InternodeId cut = end - i > 1 ? axis : crossed[i];
        i = end;
        if (!tree.isRoot(cut)) {
            cuts.push_back(cut);
            continue;
        }
        // A trunk's first internode stays.
        for (InternodeId child = index.firstChild(cut); child != kNoInternode;
             child = index.nextSibling(child))
            cuts.push_back(child);
    }
    if (cuts != m_preview.cuts())
        m_preview.show(context(), std::move(cuts));
}

void SketchTool::paintInk(Overlay& overlay) const
{
    const Camera& camera = context().camera();
    const Vec3 foot = context().document().tree().rootPosition(0);
    std::vector<Vec3> ink;
    std::vector<Vec3> image;
    const float middle = foot.dot(camera.right());
    for (const QPointF& point : m_path) {
        ink.push_back(camera.onPlane(point, foot));
        image.push_back(ink.back() + 2.0F * (middle - ink.back().dot(camera.right())) * camera.right());
    }
    overlay.addInk(ink, kBrushColour, 2.4F);
    if (context().viewSettings().values().sketchMirror)
        overlay.addInk(image, kBrushColour, 1.6F, 5.0F);
}

/// What the stroke would become if it ended here, unless that is a branch.
void SketchTool::paintReading(Overlay& overlay) const
{
    const Camera& camera = context().camera();
    const Vec3 foot = context().document().tree().rootPosition(0);
    const Reading read = reading();
    std::vector<Vec3> line;
    for (const Eigen::Vector2d& pixel : read.line)
        line.push_back(camera.onPlane(downward(pixel), foot));
    QString name;
    switch (read.meaning) {
    case Meaning::Nothing:
    case Meaning::Branch:
        return;
    case Meaning::SecondSide:
        name = tr("Two sides of one branch");
        break;
    case Meaning::Leaf:
        name = tr("A leaf");
        break;
    case Meaning::Crown:
        name = tr("A crown");
        break;
    }
    if (read.meaning != Meaning::SecondSide)
        line.push_back(line.front());
    overlay.addInk(line, kPickedColour, 1.6F, 5.0F);
    overlay.addLabel({camera.onPlane(m_path.back(), foot), QPointF(16.0, 0.0), name, kPickedColour});
}

void SketchTool::paint(Overlay& overlay) const
{
    const Camera& camera = context().camera();
    if (m_isActive && m_isCutting) {
        m_preview.paint(context(), overlay, false);
        CutPreview::paintBlade(camera, m_path, overlay);
    } else if (m_isActive) {
        paintInk(overlay);
        paintReading(overlay);
    } else if (m_place && m_placeRevision == context().document().revision()) {
        const Vec3 place = positionOf(context().document().tree(), context().document().index(), *m_place);
        const float radius =
            std::max(kJoinRing / camera.pixelsPerMetre(std::max(camera.depth(place), Camera::kMinDistance)),
                     kRingInRadii * context().branchRadius(m_place->internode));
        overlay.addCircle(place, camera.right(), camera.up(), radius, kPickedColour, 2.0F);
        overlay.addLine(std::array{place, camera.onPlane(m_pointer, place)}, kPickedColour, 1.2F, 4.0F);
    }
}

QString SketchTool::tip() const
{
    return isSeedling()
               ? tr("Draw the trunk, then branches; two strokes side by side give a branch its width")
               : tr("Draw a branch from the wood; hold Shift and draw across branches to take them away");
}

} // namespace espalier
