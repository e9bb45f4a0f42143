// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/Coverage.h"

#include <algorithm>
#include <functional>

namespace espalier {

namespace {

constexpr int kLines = 8; ///< Number of lines along y in a node's square

struct Edge {
    double bottom; ///< y of the lower end
    double top;
    double x; ///< At the lower end
    double slope;
    int winding; ///< +1 upward, -1 downward
};

struct Crossing {
    double x;
    int winding;
};

/// The nodes that one loop fills.
struct Layer {
    Grid<float> filled;
    double area = 0.0;
    int left = 0; ///< The nodes outside [left, right) × [bottom, top) are empty
    int right = 0;
    int bottom = 0;
    int top = 0;
    int depth = 0;                   ///< Number of other loops that contain it
    std::vector<std::size_t> within; ///< The loops that contain it
};

std::vector<Edge> edgesFromBottom(const Loop& loop)
{
    std::vector<Edge> edges;
    edges.reserve(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector2d& from = loop[i];
        const Eigen::Vector2d& to = loop[(i + 1) % loop.size()];
        if (from.y() == to.y())
            continue;
        const Eigen::Vector2d& low = from.y() < to.y() ? from : to;
        const Eigen::Vector2d& high = from.y() < to.y() ? to : from;
        edges.push_back({low.y(), high.y(), low.x(), (high.x() - low.x()) / (high.y() - low.y()),
                         from.y() < to.y() ? 1 : -1});
    }
    std::ranges::sort(edges, {}, &Edge::bottom);
    return edges;
}

/// Adds one line from @p from to @p to (in nodes) to a row.
void fill(Grid<float>& filled, int row, double from, double to)
{
    const double limit = filled.width();
    const double begin = std::clamp(from + 0.5, 0.0, limit);
    const double end = std::clamp(to + 0.5, 0.0, limit);
    for (int x = static_cast<int>(begin); x < end; ++x) {
        const double part = std::min(end, x + 1.0) - std::max(begin, static_cast<double>(x));
        filled(x, row) += static_cast<float>(part / kLines);
    }
}

Layer filledBy(const Loop& loop, int width, int height)
{
    Layer layer{.filled = Grid<float>(width, height), .within = {}};
    const std::vector<Edge> edges = edgesFromBottom(loop);
    std::vector<Edge> active;
    std::vector<Crossing> crossings;
    std::size_t next = 0;
    for (int line = 0; line < height * kLines; ++line) {
        const double y = (line + 0.5) / kLines - 0.5;
        for (; next < edges.size() && edges[next].bottom <= y; ++next)
            active.push_back(edges[next]);
        std::erase_if(active, [&](const Edge& edge) { return edge.top <= y; });
        crossings.clear();
        for (const Edge& edge : active)
            crossings.push_back({edge.x + edge.slope * (y - edge.bottom), edge.winding});
        std::ranges::sort(crossings, {}, &Crossing::x);
        int winding = 0;
        double from = 0.0;
        for (const Crossing& crossing : crossings) {
            if (winding == 0)
                from = crossing.x;
            winding += crossing.winding;
            if (winding == 0)
                fill(layer.filled, line / kLines, from, crossing.x);
        }
    }

    layer.left = width;
    layer.bottom = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (layer.filled(x, y) <= 0.0F)
                continue;
            layer.area += double{layer.filled(x, y)};
            layer.left = std::min(layer.left, x);
            layer.right = std::max(layer.right, x + 1);
            layer.bottom = std::min(layer.bottom, y);
            layer.top = std::max(layer.top, y + 1);
        }
    }
    return layer;
}

bool liesIn(const Layer& inner, const Layer& outer)
{
    constexpr float kRounding = 1e-4F;
    if (inner.area >= outer.area || inner.left < outer.left || inner.right > outer.right ||
        inner.bottom < outer.bottom || inner.top > outer.top)
        return false;
    for (int y = inner.bottom; y < inner.top; ++y)
        for (int x = inner.left; x < inner.right; ++x)
            if (inner.filled(x, y) > outer.filled(x, y) + kRounding)
                return false;
    return true;
}

void nest(std::vector<Layer>& layers)
{
    std::ranges::stable_sort(layers, std::greater{}, &Layer::area);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        for (std::size_t outer = 0; outer < i; ++outer) {
            if (!liesIn(layers[i], layers[outer]))
                continue;
            layers[i].within.push_back(outer);
            layers[i].depth = std::max(layers[i].depth, layers[outer].depth + 1);
        }
    }
}

} // namespace

Grid<float> coverage(std::span<const Loop> loops, int width, int height)
{
    std::vector<Layer> layers;
    for (const Loop& loop : loops)
        layers.push_back(filledBy(loop, width, height));
    if (layers.size() == 1)
        return std::move(layers.front().filled);
    nest(layers);

    Grid<float> result(width, height);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Layer& solid = layers[i];
        if (solid.depth % 2 != 0)
            continue;
        std::vector<const Layer*> holes;
        for (const Layer& layer : layers)
            if (layer.depth == solid.depth + 1 && std::ranges::find(layer.within, i) != layer.within.end())
                holes.push_back(&layer);
        for (int y = solid.bottom; y < solid.top; ++y) {
            for (int x = solid.left; x < solid.right; ++x) {
                float taken = 0.0F;
                for (const Layer* hole : holes)
                    taken = std::max(taken, hole->filled(x, y));
                result(x, y) = std::max(result(x, y), solid.filled(x, y) - taken);
            }
        }
    }
    return result;
}

} // namespace espalier
