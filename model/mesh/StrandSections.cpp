// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandSections.h"

#include "model/base/LargePages.h"
#include "model/base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

constexpr std::size_t kSectionsPerTask = 64;
/// Taubin's smoothing of a loop: a step that shrinks and one that widens again.
constexpr float kShrink = 0.5F;
constexpr float kWiden = -0.52F;
constexpr float kMostSmoothings = 6.0F;
/// How far above a fork its branches have their first sections, in radii of the wood below.
constexpr float kEntryRadii = 1.5F;
/// The bark lies one strand radius outside the middles of strands, but by this share less with each further
/// loop of a section: where two loops have a strand in common, their vertices must not coincide.
constexpr float kLessMargin = 0.01F;
constexpr std::size_t kMostLessMargins = 20;

} // namespace

/// Writes the vertices of one node.
class StrandSections::Writer {
public:
    Writer(StrandSections& sections, std::uint32_t node)
        : m_sections(sections),
          m_layouts(sections.m_layouts),
          m_skeleton(sections.m_layouts.skeleton()),
          m_curves(sections.m_layouts),
          m_node(node),
          m_block(sections.m_blocks[node])
    {
    }

    void write()
    {
        const StrandTubes::Node& n = m_sections.m_tubes.nodes[m_node];
        for (std::size_t tube = 0; tube < n.tubes.size(); ++tube) {
            for (std::uint32_t i = m_block.firstSlices[tube]; i < m_block.firstSlices[tube + 1]; ++i)
                writeSlice(m_block.slices[i], &n.tubes[tube]);
        }
        for (Slice& slice : m_block.whole)
            writeSlice(slice, nullptr);
        if (m_block.hasApex)
            writeApex();
    }

private:
    /// Where a slice lies: between two nodes.
    struct Span {
        std::uint32_t lower;
        std::uint32_t upper;
        float t;
    };

    Span spanOf(const Slice& slice) const
    {
        const StrandNode& n = m_skeleton.nodes[m_node];
        if (slice.along <= 1.0F && !m_skeleton.isBase(m_node))
            return {n.parent, m_node, slice.along};
        // Above the node, or at a base: toward the thickest branch.
        const auto above = m_skeleton.childrenOf(m_node);
        const std::uint32_t next = *std::ranges::max_element(
            above, {}, [&](std::uint32_t child) { return m_skeleton.nodes[child].strands; });
        return {m_node, next, m_skeleton.isBase(m_node) ? slice.along : slice.along - 1.0F};
    }

    Vec3 pointOf(std::uint32_t strand, const Slice& slice) const
    {
        if (slice.along <= 1.0F && !m_skeleton.isBase(m_node))
            return pointOf(m_node, strand, slice.along);
        const std::uint32_t child = m_curves.childWith(m_node, strand);
        const float t = m_skeleton.isBase(m_node) ? slice.along : slice.along - 1.0F;
        return pointOf(child, strand - m_skeleton.nodes[child].offset, t);
    }
    /// On the way from the node below (0) to @p node (1), whose number the strand has.
    Vec3 pointOf(std::uint32_t node, std::uint32_t strand, float t) const
    {
        const Vec3 point = StrandCurves::point(m_curves.controls(node, strand), t);
        return m_layouts.reliefs().hasHollow(node) ? sunk(node, t, point) : point;
    }
    Vec3 sunk(std::uint32_t node, float t, const Vec3& point) const
    {
        const StrandNode& upper = m_skeleton.nodes[node];
        const StrandNode& lower = m_skeleton.nodes[upper.parent];
        const Vec3& below = m_layouts.centre(upper.parent);
        const Vec3 rise = m_layouts.centre(node) - below;
        const Rotation frame =
            Rotation::FromTwoVectors(upper.frame * up(), normalBetween(lower, upper, t)) * upper.frame;
        const Vec3 local = frame.conjugate() * (point - below - t * rise);
        const Vec2 shift = m_layouts.reliefs().sunk(
            node, {.t = t, .length = rise.norm(), .radius = lower.radius + t * (upper.radius - lower.radius)},
            Vec2(local.x(), local.z()));
        return point + frame * Vec3(shift.x(), 0.0F, shift.y());
    }

    static Vec3 normalBetween(const StrandNode& lower, const StrandNode& upper, float t)
    {
        const Vec3 sum = (1.0F - t) * (lower.frame * up()) + t * (upper.frame * up());
        return sum.squaredNorm() > 1e-6F ? Vec3(sum.normalized()) : Vec3(upper.frame * up());
    }
    /// The frame of a section between two: the normal turns from one to the other, and the twist goes on
    /// about it.
    static Rotation frameBetween(const StrandNode& lower, const StrandNode& upper, float t)
    {
        const Vec3 from = lower.frame * up();
        const Rotation carried = Rotation::FromTwoVectors(from, upper.frame * up()) * lower.frame;
        const Rotation rest = carried.conjugate() * upper.frame; // About +Y
        const float twist =
            std::remainder(2.0F * std::atan2(rest.y(), rest.w()), 2.0F * std::numbers::pi_v<float>);
        return Rotation::FromTwoVectors(from, normalBetween(lower, upper, t)) * lower.frame *
               Rotation(Eigen::AngleAxisf(t * twist, up()));
    }

    void writeSlice(Slice& slice, const StrandTube* tube)
    {
        const Span span = spanOf(slice);
        const StrandNode& lower = m_skeleton.nodes[span.lower];
        const StrandNode& upper = m_skeleton.nodes[span.upper];
        const Rotation frame = frameBetween(lower, upper, span.t);
        const float scale = m_layouts.scale(span.lower) +
                            span.t * (m_layouts.scale(span.upper) - m_layouts.scale(span.lower));
        slice.radius = radiusOf(slice, tube, span);
        for (std::size_t i = 0; i < slice.loops.size(); ++i) {
            const Loop& loop = slice.loops[i];
            const float margin =
                scale * (1.0F - kLessMargin * static_cast<float>(std::min(i, kMostLessMargins)));
            if (loop.hasStrands)
                writeLoop(slice, loop, frame * up(), margin);
            else
                writeRing(slice, loop, tube, frame);
        }
        const auto along = std::clamp(slice.along, 0.0F, 1.0F);
        const WoodOrigin origin{m_skeleton.nodes[m_node].internode,
                                originAlong(m_skeleton.isBase(m_node) ? 0.0F : along)};
        Vec3 sum = Vec3::Zero();
        const Loop& outer = slice.loops.front();
        for (std::uint32_t i = 0; i < outer.count; ++i)
            sum += toVec3(m_sections.m_vertices[outer.first + i].position);
        slice.centre = sum / static_cast<float>(outer.count);
        for (const Loop& loop : slice.loops)
            std::fill_n(m_sections.m_origins.begin() + loop.first, loop.count, origin);
    }

    /// The place on the node's internode at the share @p t of the way from the node below.
    float originAlong(float t) const
    {
        const StrandNode& n = m_skeleton.nodes[m_node];
        if (m_skeleton.isBase(m_node))
            return 0.0F;
        const StrandNode& below = m_skeleton.nodes[n.parent];
        const float from = below.internode == n.internode && n.parent != m_node ? below.along : 0.0F;
        return from + t * (n.along - from);
    }

    float radiusOf(const Slice& slice, const StrandTube* tube, const Span& span) const
    {
        const StrandNode& n = m_skeleton.nodes[m_node];
        if (tube == nullptr)
            return n.radius;
        const auto count =
            tube->strands.empty() ? n.strands : static_cast<std::uint32_t>(tube->strands.size());
        if (count < n.strands)
            return m_layouts.scale(m_node) * bundleRadius(count);
        const float from = m_sections.m_tubes.nodes[span.lower].continuesAbove
                               ? m_skeleton.nodes[span.lower].radius
                               : n.radius;
        return from + slice.along * (n.radius - from);
    }

    /// @p margin: of the bark around the middles of strands, m.
    void writeLoop(const Slice& slice, const Loop& loop, const Vec3& axis, float margin)
    {
        const std::span<const std::uint32_t> strands = m_sections.strands(loop);
        m_points.clear();
        for (const std::uint32_t strand : strands)
            m_points.push_back(pointOf(strand, slice));
        smooth();
        const std::size_t count = m_points.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 along = m_points[(i + 1) % count] - m_points[(i + count - 1) % count];
            Vec3 outward = axis.cross(along);
            const float length = outward.norm();
            outward = length > 1e-9F ? Vec3(outward / length) : Vec3(Vec3::Zero());
            set(loop.first + static_cast<VertexIndex>(i), m_points[i] + margin * outward);
        }
    }

    void smooth()
    {
        const auto pairs = static_cast<int>(std::lround(kMostSmoothings * m_sections.m_smoothing));
        const std::size_t count = m_points.size();
        for (int i = 0; i < 2 * pairs; ++i) {
            const float weight = i % 2 == 0 ? kShrink : kWiden;
            m_moved.resize(count);
            for (std::size_t j = 0; j < count; ++j) {
                const Vec3 middle = 0.5F * (m_points[(j + 1) % count] + m_points[(j + count - 1) % count]);
                m_moved[j] = m_points[j] + weight * (middle - m_points[j]);
            }
            m_points.swap(m_moved);
        }
    }

    void writeRing(const Slice& slice, const Loop& loop, const StrandTube* tube, const Rotation& frame)
    {
        const StrandNode& n = m_skeleton.nodes[m_node];
        const bool isAll = tube == nullptr || tube->strands.empty();
        const auto count = isAll ? n.strands : static_cast<std::uint32_t>(tube->strands.size());
        Vec3 centre = Vec3::Zero();
        for (std::uint32_t i = 0; i < count; ++i)
            centre += pointOf(isAll ? i : tube->strands[i], slice) / static_cast<float>(count);
        const Vec3 x = frame * Vec3(Vec3::UnitX());
        const Vec3 z = frame * Vec3(Vec3::UnitZ());
        for (std::uint32_t i = 0; i < loop.count; ++i) {
            const float angle =
                2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(loop.count);
            set(loop.first + i, centre + slice.radius * (std::cos(angle) * x + std::sin(angle) * z));
        }
    }

    void writeApex()
    {
        if (m_skeleton.isBase(m_node)) {
            set(m_block.apex, m_block.whole.front().centre);
            m_sections.m_origins[m_block.apex] = {m_skeleton.nodes[m_node].internode, 0.0F};
            return;
        }
        const Slice& top = m_block.top();
        set(m_block.apex, top.centre + 0.5F * top.radius * (m_skeleton.nodes[m_node].frame * up()));
        m_sections.m_origins[m_block.apex] = {m_skeleton.nodes[m_node].internode, 1.0F};
    }

    /// Nothing lies below the ground.
    void set(VertexIndex vertex, const Vec3& position)
    {
        m_sections.m_vertices[vertex].position = {position.x(), std::max(position.y(), 0.0F), position.z()};
    }

    StrandSections& m_sections;
    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    StrandCurves m_curves;
    std::uint32_t m_node;
    Block& m_block;
    std::vector<Vec3> m_points;
    std::vector<Vec3> m_moved;
};

StrandSections::StrandSections(const StrandLayouts& layouts, const StrandTubes& tubes,
                               const TreeParameters& parameters, const StrandReuse& reuse, const Last& last,
                               WorkProgress& progress, BranchMesh& mesh)
    : m_layouts(layouts),
      m_tubes(tubes),
      m_smoothing(static_cast<float>(parameters.wood.smoothing)),
      m_blocks(tubes.nodes.size()),
      m_vertices(mesh.vertices),
      m_origins(mesh.origins)
{
    parallelFor(m_blocks.size(), kSectionsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            plan(static_cast<std::uint32_t>(i));
    });
    VertexIndex total = 0;
    for (Block& block : m_blocks) {
        block.first = total;
        total += block.count;
    }
    // The vertices that are doubled come to the end later. Unused room costs no memory.
    m_vertices.reserve(total + total / 2);
    m_origins.reserve(total + total / 2);
    wantLargePages(m_vertices.data(), m_vertices.capacity() * sizeof(MeshVertex));
    wantLargePages(m_origins.data(), m_origins.capacity() * sizeof(WoodOrigin));
    m_vertices.resize(total);
    m_origins.resize(total);
    WorkCount written(progress, m_blocks.size());
    parallelFor(m_blocks.size(), kSectionsPerTask, [&](std::size_t begin, std::size_t end) {
        if (progress.isCancelled())
            return;
        for (std::size_t i = begin; i < end; ++i) {
            Block& block = m_blocks[i];
            const auto shift = [&](std::vector<Slice>& slices) {
                for (Slice& slice : slices) {
                    for (Loop& loop : slice.loops)
                        loop.first += block.first;
                }
            };
            shift(block.slices);
            shift(block.whole);
            block.apex += block.first;
            if (const auto node = static_cast<std::uint32_t>(i); reuse.has(node, StrandReach::Positions))
                take(node, reuse, last);
            else
                Writer(*this, node).write();
        }
        written.add(end - begin);
    });
}

/// Chooses the slices of a node and numbers their vertices from 0.
void StrandSections::plan(std::uint32_t node)
{
    Block& block = m_blocks[node];
    const StrandSkeleton& skeleton = m_layouts.skeleton();
    const StrandTubes::Node& n = m_tubes.nodes[node];
    const auto addSlice = [&](std::vector<Slice>& slices, const BundleOutline& outline, int sides,
                              float along) {
        Slice& slice = slices.emplace_back();
        slice.along = along;
        const auto add = [&](std::uint32_t count, const SectionLoop* loop) {
            Loop& made = slice.loops.emplace_back();
            made.first = block.count;
            made.count = count;
            made.node = node;
            made.hasStrands = loop != nullptr;
            made.firstStrand = static_cast<std::uint32_t>(block.strands.size());
            if (loop != nullptr)
                block.strands.insert(block.strands.end(), loop->strands.begin(), loop->strands.end());
            block.count += count;
        };
        if (outline.isRing())
            add(static_cast<std::uint32_t>(sides), nullptr);
        // The first loop of a slice goes around wood.
        for (const bool cavities : {false, true}) {
            for (const SectionLoop& loop : outline.loops) {
                if (loop.isCavity() == cavities)
                    add(static_cast<std::uint32_t>(loop.strands.size()), &loop);
            }
        }
    };
    const bool isBase = skeleton.isBase(node);
    if (!isBase) {
        const StrandTubes::Node& below = m_tubes.nodes[skeleton.nodes[node].parent];
        const int first = below.continuesAbove ? 1 : below.joined + 1;
        const int last = n.continuesBelow ? n.steps - 1 : std::max(n.steps - 1, first);
        const auto steps = static_cast<float>(n.steps);
        // Branches part where they are clear of the thickness of the wood below, not halfway to their next
        // node.
        const std::uint32_t support = skeleton.nodes[node].parent;
        const float length = (m_layouts.centre(node) - m_layouts.centre(support)).norm();
        const float entry =
            static_cast<float>(below.joined) / steps +
            std::max(kEntryRadii * skeleton.nodes[support].radius / std::max(length, 1e-6F), 0.02F);
        for (const StrandTube& tube : n.tubes) {
            block.firstSlices.push_back(static_cast<std::uint32_t>(block.slices.size()));
            for (int step = first; step <= last; ++step) {
                const bool isLower = 2 * step < n.steps || (step == first && !below.continuesAbove);
                float along = static_cast<float>(step) / steps;
                if (step == first && !below.continuesAbove)
                    along = std::min(along, entry);
                addSlice(block.slices, isLower ? tube.below : tube.above, tube.sides, std::min(along, 0.98F));
            }
        }
    }
    block.firstSlices.push_back(static_cast<std::uint32_t>(block.slices.size()));
    addSlice(block.whole, n.whole, n.ringSides, isBase ? 0.0F : 1.0F);
    if (n.joined > 0) {
        const auto steps = static_cast<float>(m_tubes.nodes[skeleton.childrenOf(node).front()].steps);
        for (int step = 1; step <= n.joined; ++step)
            addSlice(block.whole, n.whole, n.ringSides,
                     (isBase ? 0.0F : 1.0F) + static_cast<float>(step) / steps);
    }
    block.hasApex = skeleton.nodes[node].childCount == 0 || (isBase && m_layouts.isDisc(node));
    if (block.hasApex)
        block.apex = block.count++;
}

/// Takes what write() would write from the last mesh.
void StrandSections::take(std::uint32_t node, const StrandReuse& reuse, const Last& last)
{
    Block& block = m_blocks[node];
    const Block& old = (*last.blocks)[reuse.before(node)];
    const auto measure = [](std::vector<Slice>& slices, const std::vector<Slice>& before) {
        for (std::size_t i = 0; i < slices.size(); ++i) {
            slices[i].centre = before[i].centre;
            slices[i].radius = before[i].radius;
        }
    };
    measure(block.slices, old.slices);
    measure(block.whole, old.whole);
    std::copy_n(last.mesh->vertices.begin() + old.first, block.count, m_vertices.begin() + block.first);
    for (auto i = std::ranges::lower_bound(last.raised, old.first, {}, &RaisedVertex::vertex);
         i != last.raised.end() && i->vertex < old.first + block.count; ++i)
        m_vertices[i->vertex - old.first + block.first].position = i->before;
    std::copy_n(last.mesh->origins.begin() + old.first, block.count, m_origins.begin() + block.first);
}

std::vector<Vec2> StrandSections::plane(const Loop& loop) const
{
    std::vector<Vec2> points;
    const std::span<const Vec2> places = m_layouts.places(loop.node);
    for (const std::uint32_t strand : strands(loop))
        points.push_back(places[strand]);
    return points;
}

} // namespace espalier
