// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/EraserTool.h"

#include "commands/EraseTwigs.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "views/tools/BrushTool.h"

#include <algorithm>
#include <utility>

namespace espalier {

namespace {

/// Least radius of the brush on the screen, px.
constexpr float kLeastEraser = 5.0F;
/// Points of a stroke are this share of the radius apart, at least.
constexpr float kEraserStride = 0.2F;

const QColor kEraserColour(235, 104, 92);
const QColor kThinColour(240, 176, 92);

/// A place as recipes can have it.
Vec3 asRecorded(const Vec3& place)
{
    constexpr auto kFar = static_cast<float>(recipeLimits::kCoordinate);
    return withoutNegativeZeros(Vec3(place.cwiseMax(-kFar).cwiseMin(kFar)));
}

} // namespace

EraserTool::EraserTool(ToolContext& context) : Tool(context) {}

EraserTool::~EraserTool() = default;

bool EraserTool::thins() const
{
    return context().viewSettings().values().pruneMode == PruneMode::Thin;
}

SweepPoint EraserTool::brushAt(const PointerSample& sample) const
{
    const Camera& camera = context().camera();
    const ViewValues& view = context().viewSettings().values();
    const bool scales = sample.device == PointerDevice::Pen && view.pressureScales && m_isActive;
    const double radius = view.brushRadius * (scales ? BrushTool::radiusShare(sample.pressure) : 1.0);
    const float least = kLeastEraser / camera.pixelsPerMetre(camera.distance());
    return {asRecorded(camera.onPlane(sample.position, camera.target())),
            std::max(static_cast<float>(radius), least)};
}

/// Begins a sweep with the brush at @p toward: the tree as the camera sees it now.
void EraserTool::look(const SweepPoint& toward)
{
    const TreeDocument& document = context().document();
    const ViewValues& view = context().viewSettings().values();
    const Vec3 eye = asRecorded(context().camera().position());
    m_twigs.thickest = view.eraserThickest;
    m_twigs.depth = view.prunesThrough ? SweepDepth::All : SweepDepth::NearSide;
    m_twigs.sweeps.push_back({eye, {toward}});
    m_seen =
        std::make_unique<SeenWood>(document.tree(), document.index(), eye, toward.position, m_twigs.depth);
    const bool isOld = m_revision != document.revision() || !m_rule || m_ruleThickest != m_twigs.thickest;
    if (isOld) {
        m_revision = document.revision();
        m_ruleThickest = m_twigs.thickest;
        m_rule = std::make_unique<TwigRule>(document.tree(), document.index(), m_twigs.thickest);
        m_thinning.reset();
    }
    if (!thins()) {
        m_thinning.reset();
    } else if (!m_thinning || m_thinningShare != view.thinShare) {
        m_thinningShare = view.thinShare;
        m_thinning = std::make_unique<Thinning>(document.tree(), document.index(), *m_rule, view.thinShare);
    }
    m_swept.add(m_seen->under(toward, toward));
    showSwept();
}

void EraserTool::showSwept()
{
    m_preview.show(context(), m_thinning ? m_thinning->cuts(m_swept) : erasedTwigs(m_swept, *m_rule));
}

void EraserTool::sweepTo(const SweepPoint& point)
{
    Sweep& sweep = m_twigs.sweeps.back();
    if (sweep.eye != asRecorded(context().camera().position())) {
        look(point);
        return;
    }
    const SweepPoint& last = sweep.path.back();
    if ((point.position - last.position).norm() < kEraserStride * point.radius && point.radius <= last.radius)
        return;
    m_swept.add(m_seen->under(last, point));
    sweep.path.push_back(point);
    showSwept();
}

void EraserTool::begin(const PointerSample& sample)
{
    leave();
    m_isActive = true;
    m_isShown = true;
    m_brush = brushAt(sample);
    look(m_brush);
}

void EraserTool::move(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    m_brush = brushAt(sample);
    // What grew meanwhile, or was undone, is not what the stroke began on.
    if (m_revision == context().document().revision())
        sweepTo(m_brush);
    context().requestRepaint();
}

void EraserTool::end(const PointerSample& sample)
{
    // A pen's last sample has no pressure: the sample before it counts.
    if (sample.device != PointerDevice::Pen)
        move(sample);
    finish();
    if (sample.device != PointerDevice::Finger)
        hover(sample);
}

void EraserTool::finish()
{
    if (!m_isActive)
        return;
    SweptTwigs twigs = std::exchange(m_twigs, {});
    const bool isThinning = m_thinning != nullptr;
    const double share = m_thinningShare;
    cancel();
    if (isThinning)
        thinTwigs(context().document(), {std::move(twigs), share});
    else
        eraseTwigs(context().document(), {std::move(twigs)});
}

void EraserTool::cancel()
{
    m_isActive = false;
    leave();
}

void EraserTool::hover(const PointerSample& sample)
{
    leave();
    m_isShown = true;
    m_brush = brushAt(sample);
    look(m_brush);
}

void EraserTool::leave()
{
    m_isShown = false;
    m_twigs = {};
    m_swept = {};
    m_seen.reset();
    m_preview.show(context(), {});
}

void EraserTool::wheel(double notches)
{
    ViewSettings& settings = context().viewSettings();
    settings.set(&ViewValues::brushRadius, steppedBrushRadius(settings.values().brushRadius, notches));
    m_brush.radius =
        std::max(static_cast<float>(settings.values().brushRadius),
                 kLeastEraser / context().camera().pixelsPerMetre(context().camera().distance()));
    context().requestRepaint();
}

void EraserTool::paint(Overlay& overlay) const
{
    m_preview.paint(context(), overlay, false);
    if (!m_isShown)
        return;
    const Camera& camera = context().camera();
    const QColor& colour = m_thinning ? kThinColour : kEraserColour;
    const LeafColumns& leaves = context().document().tree().placedLeaves();
    if (!m_thinning && !m_swept.leaves.empty() && m_swept.leaves.back() < leaves.size() &&
        m_revision == context().document().revision()) {
        const Tree& tree = context().document().tree();
        const TreeIndex& index = context().document().index();
        std::vector<Vec3> places;
        for (const LeafId leaf : m_swept.leaves) {
            const InternodeId on = leaves.internode[leaf];
            places.push_back(index.nodePosition(on) -
                             (1.0F - leaves.along[leaf]) * tree.length(on) * index.heading(on));
        }
        overlay.addDots(places, colour, 5.0F);
    }
    overlay.addSphere({m_brush.position, m_brush.radius, colour, m_isActive ? 0.12F : 0.05F});
    overlay.addCircle(m_brush.position, camera.right(), camera.up(), m_brush.radius, colour, 1.6F);
}

QString EraserTool::tip() const
{
    return thins() ? tr("Brush over twigs to thin them evenly; those to be removed turn red")
                   : tr("Brush over twigs and leaves to take them away, however deep in the crown they are");
}

} // namespace espalier
