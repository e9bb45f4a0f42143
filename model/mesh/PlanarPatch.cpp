// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/PlanarPatch.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// The sine of the least angle by which the outline turns at an ear.
constexpr double kFlat = 0.02;

double turnOf(const Vec2& a, const Vec2& b, const Vec2& c)
{
    return (double{b.x()} - double{a.x()}) * (double{c.y()} - double{a.y()}) -
           (double{b.y()} - double{a.y()}) * (double{c.x()} - double{a.x()});
}

std::uint64_t pairOf(std::uint32_t a, std::uint32_t b)
{
    return (std::uint64_t{a} << 32U) | b;
}

} // namespace

void PlanarPatch::EdgeSet::clear(std::size_t points)
{
    // Each point begins an edge of its outline and, in a triangulation, about two more.
    std::size_t size = 64;
    while (size < 6 * points)
        size *= 2;
    // A table that is far too large would take longer to clear.
    if (size > m_keys.size() || 8 * size < m_keys.size())
        m_keys.resize(size);
    std::ranges::fill(m_keys, kFree);
    m_count = 0;
}

std::size_t PlanarPatch::EdgeSet::placeOf(std::uint64_t key) const
{
    const std::size_t mask = m_keys.size() - 1;
    auto place = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 32U) & mask;
    while (m_keys[place] != kFree && m_keys[place] != key)
        place = (place + 1) & mask;
    return place;
}

void PlanarPatch::EdgeSet::insert(std::uint32_t a, std::uint32_t b)
{
    const std::uint64_t key = pairOf(std::min(a, b), std::max(a, b));
    const std::size_t place = placeOf(key);
    if (m_keys[place] == key)
        return;
    m_keys[place] = key;
    if (2 * ++m_count > m_keys.size())
        grow();
}

void PlanarPatch::EdgeSet::erase(std::uint32_t a, std::uint32_t b)
{
    const std::uint64_t key = pairOf(std::min(a, b), std::max(a, b));
    if (const std::size_t place = placeOf(key); m_keys[place] == key)
        m_keys[place] = kErased;
}

bool PlanarPatch::EdgeSet::contains(std::uint32_t a, std::uint32_t b) const
{
    const std::uint64_t key = pairOf(std::min(a, b), std::max(a, b));
    return m_keys[placeOf(key)] == key;
}

void PlanarPatch::EdgeSet::grow()
{
    const std::vector<std::uint64_t> keys = std::exchange(m_keys, std::vector(2 * m_keys.size(), kFree));
    m_count = 0;
    for (const std::uint64_t key : keys) {
        if (key == kFree || key == kErased)
            continue;
        m_keys[placeOf(key)] = key;
        ++m_count;
    }
}

void PlanarPatch::triangulate(std::span<const Outline> whole, std::span<const Outline> parts,
                              Triangles& triangles)
{
    triangles.clear();
    collect(whole, parts);
    joinEqualEdges(triangles);
    traceFaces();
    assignHoles(triangles);
    for (const Face& face : m_faces)
        clip(face, triangles);
}

void PlanarPatch::collect(std::span<const Outline> whole, std::span<const Outline> parts)
{
    m_points.clear();
    m_strands.clear();
    m_next.clear();
    m_before.clear();
    std::size_t points = 0;
    for (const std::span<const Outline> outlines : {whole, parts}) {
        for (const Outline& outline : outlines)
            points += outline.points.size();
    }
    m_edges.clear(points);
    const auto add = [&](const Outline& outline) {
        const auto first = static_cast<std::uint32_t>(m_points.size());
        const auto count = static_cast<std::uint32_t>(outline.points.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            noteEdge(first + i, first + (i + 1) % count);
            m_points.push_back(outline.points[i]);
            m_strands.push_back(outline.strands.empty() ? kNoStrand : outline.strands[i]);
            m_next.push_back(first + (i + 1) % count);
            m_before.push_back(first + (i + count - 1) % count);
        }
    };
    for (const Outline& outline : whole)
        add(outline);
    m_firstPart = static_cast<std::uint32_t>(m_points.size());
    for (const Outline& outline : parts)
        add(outline);
    m_partner.assign(m_points.size(), kNoStrand);
}

void PlanarPatch::joinEqualEdges(Triangles& triangles)
{
    m_ofParts.clear();
    for (std::uint32_t point = m_firstPart; point < m_points.size(); ++point) {
        if (m_strands[point] != kNoStrand && m_strands[m_next[point]] != kNoStrand)
            m_ofParts.emplace_back(pairOf(m_strands[point], m_strands[m_next[point]]), point);
    }
    std::ranges::sort(m_ofParts);
    for (std::uint32_t point = 0; point < m_firstPart; ++point) {
        const std::uint32_t next = m_next[point];
        if (m_strands[point] == kNoStrand || m_strands[next] == kNoStrand)
            continue;
        // Of equal edges the first one.
        const std::uint64_t edge = pairOf(m_strands[point], m_strands[next]);
        const auto found =
            std::ranges::lower_bound(m_ofParts, edge, {}, &std::pair<std::uint64_t, std::uint32_t>::first);
        if (found == m_ofParts.end() || found->first != edge || m_partner[found->second] != kNoStrand)
            continue;
        const std::uint32_t inner = found->second;
        m_partner[point] = inner;
        m_partner[inner] = point;
        triangles.push_back({point, next, inner});
        triangles.push_back({next, m_next[inner], inner});
        noteEdge(next, inner);
        noteEdge(point, inner);
        noteEdge(next, m_next[inner]);
    }
}

/// What is left between the joined edges: along the outlines of the whole forward, along those of the parts
/// backward, and across at the ends of joined edges.
void PlanarPatch::traceFaces()
{
    m_faces.clear();
    m_holes.clear();
    std::vector<bool> isDone(m_points.size(), false); // The edge that begins at the point
    const auto isWhole = [&](std::uint32_t edge) { return edge < m_firstPart; };
    // Edges of parts are passed from their end to their beginning.
    const auto startOf = [&](std::uint32_t edge) { return isWhole(edge) ? edge : m_next[edge]; };
    const auto follow = [&](std::uint32_t first) {
        Face face;
        std::uint32_t edge = first;
        do {
            isDone[edge] = true;
            face.push_back(startOf(edge));
            edge = isWhole(edge) ? m_next[edge] : m_before[edge];
            // Across joined edges, several of them where outlines visit a strand twice. They do not lead
            // around in a circle, since no two lead to the same edge.
            while (m_partner[edge] != kNoStrand) {
                face.push_back(startOf(edge));
                edge = isWhole(edge) ? m_before[m_partner[edge]] : m_next[m_partner[edge]];
            }
        } while (edge != first && !isDone[edge]);
        return face;
    };
    for (std::uint32_t point = 0; point < m_points.size(); ++point) {
        if (isDone[point] || m_partner[point] != kNoStrand)
            continue;
        Face face = follow(point);
        // A face that nothing joins to another outline, and that runs clockwise, is a hole in another face.
        const bool isAlone = std::ranges::all_of(face, [&](std::uint32_t p) {
            return (p < m_firstPart) == (face.front() < m_firstPart) && m_partner[p] == kNoStrand;
        });
        if (isAlone && areaOf(face) < 0.0)
            m_holes.push_back(std::move(face));
        else
            m_faces.push_back(std::move(face));
    }
}

/// Takes the pair of joined edges that is nearest to a point apart again, so that there is a face.
void PlanarPatch::openFaceNear(const Vec2& place, Triangles& triangles)
{
    std::uint32_t nearest = kNoStrand;
    float least = std::numeric_limits<float>::max();
    for (std::uint32_t point = 0; point < m_firstPart; ++point) {
        if (m_partner[point] == kNoStrand)
            continue;
        if (const float distance = (m_points[point] - place).squaredNorm(); distance < least) {
            least = distance;
            nearest = point;
        }
    }
    if (nearest == kNoStrand)
        return;
    const std::uint32_t next = m_next[nearest];
    const std::uint32_t inner = m_partner[nearest];
    std::erase(triangles, std::array{nearest, next, inner});
    std::erase(triangles, std::array{next, m_next[inner], inner});
    m_edges.erase(next, inner);
    m_faces.push_back({nearest, next, m_next[inner], inner});
}

void PlanarPatch::assignHoles(Triangles& triangles)
{
    // From right to left, so that the line from a hole to the right meets no hole that is still apart.
    const auto rightmost = [&](const Face& hole) {
        return *std::ranges::max_element(hole, {}, [&](std::uint32_t p) { return m_points[p].x(); });
    };
    std::ranges::stable_sort(m_holes, std::greater(),
                             [&](const Face& hole) { return m_points[rightmost(hole)].x(); });
    if (m_faces.empty() && !m_holes.empty())
        openFaceNear(m_points[m_holes.front().front()], triangles);
    // An outline that crosses itself can run the wrong way around on the whole.
    if (m_faces.empty() && !m_holes.empty() && m_holes.front().front() < m_firstPart) {
        m_faces.push_back(std::move(m_holes.front()));
        m_holes.erase(m_holes.begin());
    }
    for (const Face& hole : m_holes) {
        const Vec2& point = m_points[rightmost(hole)];
        Face* home = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (Face& face : m_faces) {
            if (const double area = areaOf(face); area < least && contains(face, point)) {
                least = area;
                home = &face;
            }
        }
        if (home == nullptr && !m_faces.empty()) {
            // Outlines that cross: the face with the nearest point.
            double nearest = std::numeric_limits<double>::infinity();
            for (Face& face : m_faces) {
                for (const std::uint32_t p : face) {
                    if (const double distance = (m_points[p] - point).squaredNorm(); distance < nearest) {
                        nearest = distance;
                        home = &face;
                    }
                }
            }
        }
        if (home != nullptr)
            connectHole(*home, hole);
    }
}

/// Cuts the face along a line from its nearest suitable point to the hole, so that the hole becomes part of
/// it.
void PlanarPatch::connectHole(Face& face, const Face& hole)
{
    const auto crosses = [&](const Face& line, std::uint32_t a, std::uint32_t b) {
        const Vec2& p = m_points[a];
        const Vec2& q = m_points[b];
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::uint32_t c = line[i];
            const std::uint32_t d = line[(i + 1) % line.size()];
            if (c == a || c == b || d == a || d == b)
                continue;
            const Vec2& r = m_points[c];
            const Vec2& s = m_points[d];
            if ((turnOf(p, q, r) > 0.0) != (turnOf(p, q, s) > 0.0) &&
                (turnOf(r, s, p) > 0.0) != (turnOf(r, s, q) > 0.0))
                return true;
        }
        return false;
    };
    struct Line {
        double length;
        std::size_t onFace;
        std::size_t onHole;
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < face.size(); ++i) {
        for (std::size_t j = 0; j < hole.size(); ++j)
            lines.push_back({(m_points[face[i]] - m_points[hole[j]]).cast<double>().squaredNorm(), i, j});
    }
    std::ranges::sort(lines, [](const Line& a, const Line& b) { return a.length < b.length; });
    const Line* chosen = nullptr;
    for (const Line& line : lines) {
        const std::uint32_t a = face[line.onFace];
        const std::uint32_t b = hole[line.onHole];
        if (hasEdge(a, b))
            continue;
        if (chosen == nullptr)
            chosen = &line;
        // The line must leave the face's corner toward its inside.
        const Vec2& before = m_points[face[(line.onFace + face.size() - 1) % face.size()]];
        const Vec2& after = m_points[face[(line.onFace + 1) % face.size()]];
        const bool isConvex = turnOf(before, m_points[a], after) > 0.0;
        const bool leftOfIn = turnOf(before, m_points[a], m_points[b]) > 0.0;
        const bool leftOfOut = turnOf(m_points[a], after, m_points[b]) > 0.0;
        if (!(isConvex ? leftOfIn && leftOfOut : leftOfIn || leftOfOut))
            continue;
        if (!crosses(face, a, b) && !crosses(hole, a, b)) {
            chosen = &line;
            break;
        }
    }
    if (chosen == nullptr)
        chosen = &lines.front();
    Face joined(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(chosen->onFace) + 1);
    for (std::size_t j = 0; j <= hole.size(); ++j)
        joined.push_back(hole[(chosen->onHole + j) % hole.size()]);
    joined.insert(joined.end(), face.begin() + static_cast<std::ptrdiff_t>(chosen->onFace), face.end());
    noteEdge(face[chosen->onFace], hole[chosen->onHole]);
    face = std::move(joined);
}

bool PlanarPatch::isEar(std::uint32_t corner, bool strict) const
{
    const Corner& c = m_corners[corner];
    const std::uint32_t a = m_corners[c.before].point;
    const std::uint32_t b = c.point;
    const std::uint32_t d = m_corners[c.after].point;
    if (a == d || a == b || b == d || hasEdge(a, d))
        return false;
    const Vec2& pa = m_points[a];
    const Vec2& pb = m_points[b];
    const Vec2& pd = m_points[d];
    const double turn = turnOf(pa, pb, pd);
    if (turn <= 0.0)
        return false;
    if (!strict)
        return true;
    if (turn < kFlat * double{(pb - pa).norm()} * double{(pd - pb).norm()})
        return false;
    for (std::uint32_t i = m_corners[c.after].after; i != c.before; i = m_corners[i].after) {
        const std::uint32_t p = m_corners[i].point;
        if (p == a || p == b || p == d)
            continue;
        const Vec2& place = m_points[p];
        if (turnOf(pa, pb, place) >= 0.0 && turnOf(pb, pd, place) >= 0.0 && turnOf(pd, pa, place) >= 0.0)
            return false;
    }
    return true;
}

void PlanarPatch::clip(const Face& face, Triangles& triangles)
{
    const auto count = static_cast<std::uint32_t>(face.size());
    if (count < 3)
        return;
    m_corners.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        m_corners[i] = {face[i], (i + count - 1) % count, (i + 1) % count, false};
    }
    // The shortest new edge of each ear; no ear: infinity.
    std::vector<double>& cost = m_cost;
    cost.resize(count);
    const auto measure = [&](std::uint32_t i) {
        const Corner& c = m_corners[i];
        cost[i] = isEar(i, true) ? (m_points[m_corners[c.before].point] - m_points[m_corners[c.after].point])
                                       .cast<double>()
                                       .squaredNorm()
                                 : std::numeric_limits<double>::infinity();
    };
    for (std::uint32_t i = 0; i < count; ++i)
        measure(i);
    for (std::uint32_t left = count; left > 3; --left) {
        auto best = static_cast<std::uint32_t>(std::ranges::min_element(cost) - cost.begin());
        // The diagonal may have come into being since the ear was measured.
        while (std::isfinite(cost[best]) && !isEar(best, false)) {
            cost[best] = std::numeric_limits<double>::infinity();
            best = static_cast<std::uint32_t>(std::ranges::min_element(cost) - cost.begin());
        }
        if (!std::isfinite(cost[best])) {
            // Outlines that cross have no ear left: any corner keeps the patch closed.
            std::uint32_t any = kNoStrand;
            best = kNoStrand;
            for (std::uint32_t i = 0; i < count && best == kNoStrand; ++i) {
                if (m_corners[i].isGone)
                    continue;
                if (isEar(i, false))
                    best = i;
                else if (!hasEdge(m_corners[m_corners[i].before].point, m_corners[m_corners[i].after].point))
                    any = i;
                else if (any == kNoStrand)
                    any = i;
            }
            if (best == kNoStrand)
                best = any;
        }
        Corner& corner = m_corners[best];
        Corner& before = m_corners[corner.before];
        Corner& after = m_corners[corner.after];
        triangles.push_back({before.point, corner.point, after.point});
        noteEdge(before.point, after.point);
        corner.isGone = true;
        cost[best] = std::numeric_limits<double>::infinity();
        before.after = corner.after;
        after.before = corner.before;
        measure(corner.before);
        measure(corner.after);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        if (m_corners[i].isGone)
            continue;
        const Corner& c = m_corners[i];
        triangles.push_back({m_corners[c.before].point, c.point, m_corners[c.after].point});
        break;
    }
}

double PlanarPatch::areaOf(const Face& face) const
{
    double twice = 0.0;
    for (std::size_t i = 0; i < face.size(); ++i)
        twice += turnOf(Vec2::Zero(), m_points[face[i]], m_points[face[(i + 1) % face.size()]]);
    return twice / 2.0;
}

bool PlanarPatch::contains(const Face& face, const Vec2& point) const
{
    bool inside = false;
    for (std::size_t i = 0, j = face.size() - 1; i < face.size(); j = i++) {
        const Vec2& a = m_points[face[i]];
        const Vec2& b = m_points[face[j]];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

void PlanarPatch::noteEdge(std::uint32_t a, std::uint32_t b)
{
    m_edges.insert(a, b);
}

bool PlanarPatch::hasEdge(std::uint32_t a, std::uint32_t b) const
{
    return m_edges.contains(a, b);
}

} // namespace espalier
