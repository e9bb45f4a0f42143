// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/SketchedTree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace espalier {

namespace {

/// A branch that is not attached yet.
struct LooseBranch {
    SketchLine line;
    std::vector<double> radii;
    double nearest = std::numeric_limits<double>::infinity(); ///< Of an end, from the branches so far
};

/// The row of an id in rows that ascend by id, or the number of rows.
template <class Row>
std::size_t rowOf(const std::vector<Row>& rows, SketchId id)
{
    const auto found = std::ranges::lower_bound(rows, id, {}, &Row::id);
    return found != rows.end() && found->id == id ? static_cast<std::size_t>(found - rows.begin())
                                                  : rows.size();
}

void turnRound(SketchLine& line, std::vector<double>& radii)
{
    std::ranges::reverse(line);
    std::ranges::reverse(radii);
}

/// How far an end of a line is from another line.
double nearerEnd(const SketchLine& line, const SketchLine& from)
{
    return std::min(nearestPlace(from, line.front()).distance, nearestPlace(from, line.back()).distance);
}

double lowestHeight(const SketchLine& line)
{
    return std::ranges::min(line, {}, [](const Eigen::Vector2d& point) { return point.y(); }).y();
}

/// The index of the longest line among those that reach down into the lowest tenth of the drawing.
std::size_t trunkOf(const std::vector<LooseBranch>& loose)
{
    double bottom = std::numeric_limits<double>::infinity();
    double top = -bottom;
    for (const LooseBranch& branch : loose) {
        for (const Eigen::Vector2d& point : branch.line) {
            bottom = std::min(bottom, point.y());
            top = std::max(top, point.y());
        }
    }
    std::size_t trunk = 0;
    double longest = -1.0;
    for (std::size_t i = 0; i < loose.size(); ++i) {
        const double length = lengthOf(loose[i].line);
        if (lowestHeight(loose[i].line) <= bottom + 0.1 * (top - bottom) && length > longest) {
            trunk = i;
            longest = length;
        }
    }
    return trunk;
}

/// On which side of the line through two points a third lies; a point on the line counts as left.
bool isLeft(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d step = to - from;
    const Eigen::Vector2d offset = point - from;
    return step.x() * offset.y() - step.y() * offset.x() >= 0.0;
}

} // namespace

std::optional<TwoSidedBranch> twoSidedBranch(const SketchLine& first, const SketchLine& second,
                                             const StrokePairRule& rule)
{
    const double firstLength = lengthOf(first);
    const double secondLength = lengthOf(second);
    const double mean = 0.5 * (firstLength + secondLength);
    if (std::max(firstLength, secondLength) > rule.longest * std::min(firstLength, secondLength))
        return std::nullopt;
    const std::size_t count = std::max({first.size(), second.size(), std::size_t{8}});
    const SketchLine one = evenLine(first, count);
    SketchLine other = evenLine(second, count);
    if ((one.front() - other.front()).norm() + (one.back() - other.back()).norm() >
        (one.front() - other.back()).norm() + (one.back() - other.front()).norm())
        std::ranges::reverse(other);
    const double ends = std::max((one.front() - other.front()).norm(), (one.back() - other.back()).norm());
    if (ends > rule.farthestEnds * mean)
        return std::nullopt;
    TwoSidedBranch branch;
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double distance = (one[i] - other[i]).norm();
        sum += distance;
        branch.axis.emplace_back(0.5 * (one[i] + other[i]));
        branch.radii.push_back(0.5 * distance);
    }
    if (sum > rule.farthestMean * mean * static_cast<double>(count))
        return std::nullopt;
    return branch;
}

std::vector<double> properCrossings(const SketchLine& line, const SketchLine& stroke)
{
    constexpr double kTouch = 1e-9; // Share of a length
    const std::vector<double> lineShares = arcShares(line);
    const std::vector<double> strokeShares = arcShares(stroke);
    const auto isInside = [](double share) { return share > kTouch && share < 1.0 - kTouch; };
    std::vector<std::pair<double, double>> found; // Shares of line and stroke
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Eigen::Vector2d& a = line[i - 1];
        const Eigen::Vector2d& b = line[i];
        for (std::size_t j = 1; j < stroke.size(); ++j) {
            const Eigen::Vector2d& c = stroke[j - 1];
            const Eigen::Vector2d& d = stroke[j];
            if (isLeft(c, d, a) == isLeft(c, d, b) || isLeft(a, b, c) == isLeft(a, b, d))
                continue;
            const Eigen::Vector2d u = b - a;
            const Eigen::Vector2d v = d - c;
            const double area = u.x() * v.y() - u.y() * v.x();
            if (area == 0.0)
                continue;
            const Eigen::Vector2d w = c - a;
            const double onLine = (w.x() * v.y() - w.y() * v.x()) / area;
            const double onStroke = (w.x() * u.y() - w.y() * u.x()) / area;
            const double lineShare = lineShares[i - 1] + onLine * (lineShares[i] - lineShares[i - 1]);
            const double strokeShare =
                strokeShares[j - 1] + onStroke * (strokeShares[j] - strokeShares[j - 1]);
            if (isInside(lineShare) && isInside(strokeShare))
                found.emplace_back(lineShare, strokeShare);
        }
    }
    // Where a corner of one touches the other from the side that counts as right, both its segments cross.
    std::ranges::sort(found);
    std::vector<double> crossings;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i + 1 < found.size() && found[i + 1].first - found[i].first < kTouch &&
            std::abs(found[i + 1].second - found[i].second) < kTouch)
            ++i;
        else
            crossings.push_back(found[i].first);
    }
    return crossings;
}

const SketchedBranch* SketchedTree::branch(SketchId id) const
{
    const std::size_t row = rowOf(m_branches, id);
    return row < m_branches.size() ? &m_branches[row] : nullptr;
}

SketchedTree SketchedTree::ofBranches(std::vector<SketchedBranch> branches)
{
    SketchedTree tree;
    tree.m_next = branches.empty() ? 0 : branches.back().id + 1;
    tree.m_branches = std::move(branches);
    return tree;
}

SketchId SketchedTree::addBranch(SketchLine line, std::vector<double> radii)
{
    SketchedBranch added{.id = m_next++, .parent = std::nullopt, .along = 0.0, .line = {}, .radii = {}};
    if (m_branches.empty()) {
        if (line.back().y() < line.front().y())
            turnRound(line, radii);
    } else {
        const SketchedBranch* parent = nullptr;
        PlaceOnLine place;
        place.distance = std::numeric_limits<double>::infinity();
        bool isReversed = false;
        for (const SketchedBranch& branch : m_branches) {
            const PlaceOnLine front = nearestPlace(branch.line, line.front());
            const PlaceOnLine back = nearestPlace(branch.line, line.back());
            const bool isBackNearer = back.distance < front.distance;
            const PlaceOnLine& nearer = isBackNearer ? back : front;
            if (nearer.distance < place.distance) {
                parent = &branch;
                place = nearer;
                isReversed = isBackNearer;
            }
        }
        if (isReversed)
            turnRound(line, radii);
        const std::vector<double> shares = arcShares(line);
        const Eigen::Vector2d shift = place.point - line.front();
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            line[i] += (1.0 - shares[i]) * shift;
        line.front() = place.point;
        added.parent = parent->id;
        added.along = place.along;
    }
    added.line = std::move(line);
    added.radii = std::move(radii);
    m_branches.push_back(std::move(added));
    return m_branches.back().id;
}

void SketchedTree::addLeaf(SketchId id, SketchLine outline)
{
    const SketchedBranch* carrier = nullptr;
    PlaceOnLine place;
    place.distance = std::numeric_limits<double>::infinity();
    std::size_t base = 0;
    for (const SketchedBranch& branch : m_branches) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const PlaceOnLine here = nearestPlace(branch.line, outline[i]);
            if (here.distance < place.distance) {
                carrier = &branch;
                place = here;
                base = i;
            }
        }
    }
    std::ranges::rotate(outline, outline.begin() + static_cast<std::ptrdiff_t>(base));
    double reach = 0.0;
    for (const Eigen::Vector2d& point : outline)
        reach = std::max(reach, (point - outline.front()).norm());
    const Eigen::Vector2d from = outline.front();
    const Eigen::Vector2d shift = place.point - from;
    for (Eigen::Vector2d& point : outline) {
        const double share = reach > 0.0 ? (point - from).norm() / reach : 0.0;
        point += (1.0 - share) * shift;
    }
    outline.front() = place.point;
    m_leaves.push_back(
        {.id = id, .branch = carrier->id, .along = place.along, .outline = std::move(outline)});
}

std::optional<SketchId> SketchedTree::attach(const SketchStroke& stroke, const StrokePairRule& rule)
{
    const std::optional<FirstSide> first = std::exchange(m_firstSide, std::nullopt);
    if (stroke.kind == SketchStroke::Kind::Dot)
        return std::nullopt;
    if (stroke.kind == SketchStroke::Kind::Closed) {
        if (m_branches.empty())
            return std::nullopt;
        addLeaf(m_next, stroke.line);
        return m_next++;
    }
    if (first) {
        if (std::optional<TwoSidedBranch> pair = twoSidedBranch(first->line, stroke.line, rule)) {
            m_branches.pop_back();
            const SketchId next = std::exchange(m_next, first->branch);
            addBranch(std::move(pair->axis), std::move(pair->radii));
            m_next = next;
            return first->branch;
        }
    }
    const SketchId id = addBranch(stroke.line, {});
    m_firstSide = FirstSide{.branch = id, .line = stroke.line};
    return id;
}

SketchedTree SketchedTree::ofStrokes(std::span<const SketchStroke> strokes, const StrokePairRule& rule)
{
    std::vector<LooseBranch> loose;
    const SketchStroke* last = nullptr; // The open stroke before, unless it has its other side already
    for (const SketchStroke& stroke : strokes) {
        if (stroke.kind != SketchStroke::Kind::Open) {
            last = nullptr;
            continue;
        }
        std::optional<TwoSidedBranch> pair;
        if (last != nullptr)
            pair = twoSidedBranch(last->line, stroke.line, rule);
        if (pair) {
            loose.back().line = std::move(pair->axis);
            loose.back().radii = std::move(pair->radii);
        } else {
            loose.push_back({.line = stroke.line, .radii = {}});
        }
        last = pair ? nullptr : &stroke;
    }
    SketchedTree tree;
    if (loose.empty())
        return tree;
    for (std::size_t next = trunkOf(loose); !loose.empty();) {
        const SketchId id = tree.addBranch(std::move(loose[next].line), std::move(loose[next].radii));
        loose.erase(loose.begin() + static_cast<std::ptrdiff_t>(next));
        const SketchLine& line = tree.branch(id)->line;
        next = 0;
        for (std::size_t i = 0; i < loose.size(); ++i) {
            loose[i].nearest = std::min(loose[i].nearest, nearerEnd(loose[i].line, line));
            if (loose[i].nearest < loose[next].nearest)
                next = i;
        }
    }
    for (const SketchStroke& stroke : strokes) {
        if (stroke.kind == SketchStroke::Kind::Closed)
            tree.addLeaf(tree.m_next++, stroke.line);
    }
    return tree;
}

} // namespace espalier
