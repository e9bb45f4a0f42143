// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/SurfaceCheck.h"

#include "model/base/Parallel.h"
#include "model/mesh/Weld.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>

namespace espalier {

namespace {

/// A triangle has no area if it is smaller than this share of the squared diagonal of the surface's box.
constexpr double kLeastArea = 1e-12;
constexpr std::size_t kTrianglesPerLeaf = 4;
constexpr std::size_t kTrianglesPerBranch = 4096;

using Corners = std::array<std::uint32_t, 3>;

struct UnionFind {
    explicit UnionFind(std::size_t count) : root(count) { std::iota(root.begin(), root.end(), 0U); }
    std::uint32_t find(std::uint32_t i)
    {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        root[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::uint32_t> root;
};

struct HalfEdge {
    std::uint32_t low;
    std::uint32_t high;
    bool isForward; ///< From low to high
    std::uint32_t triangle;
};

void checkEdges(std::span<const Corners> triangles, std::size_t vertices, SurfaceFaults& faults,
                UnionFind& surfaces)
{
    std::vector<HalfEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k];
            const std::uint32_t b = triangles[t][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b, t});
        }
    }
    std::ranges::sort(edges, [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    // The corners of triangles at a vertex, joined across edges, are its fans.
    UnionFind corners(3 * triangles.size());
    const auto cornerOf = [&](std::uint32_t triangle, std::uint32_t vertex) {
        const auto place = std::ranges::find(triangles[triangle], vertex) - triangles[triangle].begin();
        return 3 * triangle + static_cast<std::uint32_t>(place);
    };
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
            ++end;
        if (end - i == 1)
            ++faults.openEdges;
        else if (end - i > 2 || edges[i].isForward == edges[i + 1].isForward)
            ++faults.nonManifoldEdges;
        for (std::size_t j = i + 1; j < end; ++j) {
            surfaces.join(edges[i].triangle, edges[j].triangle);
            for (const std::uint32_t vertex : {edges[i].low, edges[i].high})
                corners.join(cornerOf(edges[i].triangle, vertex), cornerOf(edges[j].triangle, vertex));
        }
        i = end;
    }
    std::vector<std::uint32_t> fan(vertices, std::numeric_limits<std::uint32_t>::max());
    std::vector<bool> isFaulty(vertices, false);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = triangles[t][k];
            const std::uint32_t own = corners.find(3 * t + k);
            if (fan[vertex] == std::numeric_limits<std::uint32_t>::max())
                fan[vertex] = own;
            else if (fan[vertex] != own && !isFaulty[vertex]) {
                isFaulty[vertex] = true;
                ++faults.nonManifoldVertices;
            }
        }
    }
}

/// Pairs of triangles that cross, found by a tree of boxes.
class IntersectionSearch {
public:
    IntersectionSearch(const TriangleMesh& mesh, std::span<const Corners> triangles)
        : m_mesh(mesh), m_triangles(triangles), m_order(triangles.size()), m_boxes(triangles.size())
    {
        std::iota(m_order.begin(), m_order.end(), 0U);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            for (const std::uint32_t corner : triangles[i])
                m_boxes[i].extend(at(corner).cast<float>());
        }
    }

    std::uint64_t count()
    {
        if (m_order.empty())
            return 0;
        m_nodes.resize(2 * std::bit_ceil(m_order.size() / kTrianglesPerLeaf + 1) + 2);
        build(1, 0, m_order.size());
        self(1);
        return m_count;
    }

private:
    struct Node {
        Box3 box;
        std::size_t begin = 0;
        std::size_t end = 0;
        bool isLeaf = true;
    };

    Eigen::Vector3d at(std::uint32_t vertex) const
    {
        return toVec3(m_mesh.vertices[vertex].position).cast<double>();
    }

    void build(std::size_t number, std::size_t begin, std::size_t end)
    {
        Node& node = m_nodes[number];
        node.begin = begin;
        node.end = end;
        for (std::size_t i = begin; i < end; ++i)
            node.box.extend(m_boxes[m_order[i]]);
        node.isLeaf = end - begin <= kTrianglesPerLeaf || 2 * number + 1 >= m_nodes.size();
        if (node.isLeaf)
            return;
        int axis = 0;
        node.box.sizes().maxCoeff(&axis);
        const std::size_t middle = (begin + end) / 2;
        const auto first = m_order.begin();
        std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
                         first + static_cast<std::ptrdiff_t>(middle),
                         first + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t a, std::uint32_t b) {
                             const float p = m_boxes[a].center()[axis];
                             const float q = m_boxes[b].center()[axis];
                             return p != q ? p < q : a < b;
                         });
        inParallel(
            end - begin, [&] { build(2 * number, begin, middle); },
            [&] { build(2 * number + 1, middle, end); });
    }

    template <class First, class Second>
    static void inParallel(std::size_t size, First&& first, Second&& second)
    {
        if (size > kTrianglesPerBranch) {
            espalier::inParallel(first, second);
            return;
        }
        first();
        second();
    }

    void self(std::size_t number)
    {
        const Node& node = m_nodes[number];
        if (node.isLeaf) {
            for (std::size_t i = node.begin; i < node.end; ++i) {
                for (std::size_t j = i + 1; j < node.end; ++j)
                    test(m_order[i], m_order[j]);
            }
            return;
        }
        inParallel(
            node.end - node.begin, [&] { self(2 * number); }, [&] { self(2 * number + 1); });
        pair(2 * number, 2 * number + 1);
    }

    void pair(std::size_t a, std::size_t b)
    {
        const Node& p = m_nodes[a];
        const Node& q = m_nodes[b];
        if (!p.box.intersects(q.box))
            return;
        if (p.isLeaf && q.isLeaf) {
            for (std::size_t i = p.begin; i < p.end; ++i) {
                for (std::size_t j = q.begin; j < q.end; ++j)
                    test(m_order[i], m_order[j]);
            }
        } else if (q.isLeaf || (!p.isLeaf && p.end - p.begin >= q.end - q.begin)) {
            pair(2 * a, b);
            pair(2 * a + 1, b);
        } else {
            pair(a, 2 * b);
            pair(a, 2 * b + 1);
        }
    }

    void test(std::uint32_t a, std::uint32_t b)
    {
        if (!m_boxes[a].intersects(m_boxes[b]))
            return;
        for (const std::uint32_t corner : m_triangles[a]) {
            if (std::ranges::find(m_triangles[b], corner) != m_triangles[b].end())
                return; // Neighbours
        }
        if (pierces(a, b) || pierces(b, a))
            ++m_count;
    }

    /// Whether an edge of triangle @p a passes through triangle @p b.
    bool pierces(std::uint32_t a, std::uint32_t b) const
    {
        const Eigen::Vector3d p = at(m_triangles[b][0]);
        const Eigen::Vector3d e = at(m_triangles[b][1]) - p;
        const Eigen::Vector3d f = at(m_triangles[b][2]) - p;
        const Eigen::Vector3d normal = e.cross(f);
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d from = at(m_triangles[a][k]) - p;
            const Eigen::Vector3d to = at(m_triangles[a][(k + 1) % 3]) - p;
            const double u = normal.dot(from);
            const double v = normal.dot(to);
            if (u * v >= 0.0)
                continue;
            const Eigen::Vector3d hit = from + u / (u - v) * (to - from);
            const double size = normal.squaredNorm();
            const double s = normal.dot(hit.cross(f)) / size;
            const double t = normal.dot(e.cross(hit)) / size;
            if (s > 0.0 && t > 0.0 && s + t < 1.0)
                return true;
        }
        return false;
    }

    const TriangleMesh& m_mesh;
    std::span<const Corners> m_triangles;
    std::vector<std::uint32_t> m_order;
    std::vector<Box3> m_boxes;
    std::vector<Node> m_nodes; ///< Node n has the children 2n and 2n + 1
    std::atomic<std::uint64_t> m_count = 0;
};

double signedVolume(const TriangleMesh& mesh, const Corners& corners)
{
    const auto at = [&](std::size_t k) -> Eigen::Vector3d {
        return toVec3(mesh.vertices[corners[k]].position).cast<double>();
    };
    return at(0).dot(at(1).cross(at(2))) / 6.0;
}

} // namespace

SurfaceFaults checkSurface(const TriangleMesh& mesh, bool withIntersections)
{
    SurfaceFaults faults;
    const std::vector<std::uint32_t> first = firstAtSamePlace(mesh.vertices);
    Box3 box;
    for (const MeshVertex& vertex : mesh.vertices)
        box.extend(toVec3(vertex.position));
    const double least = mesh.vertices.empty() ? 0.0 : kLeastArea * double{box.diagonal().squaredNorm()};
    std::vector<Corners> triangles;
    triangles.reserve(mesh.indices.size() / 3);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Corners corners{first[mesh.indices[i]], first[mesh.indices[i + 1]], first[mesh.indices[i + 2]]};
        const Eigen::Vector3d p = toVec3(mesh.vertices[corners[0]].position).cast<double>();
        const Eigen::Vector3d normal =
            (toVec3(mesh.vertices[corners[1]].position).cast<double>() - p)
                .cross(toVec3(mesh.vertices[corners[2]].position).cast<double>() - p);
        if (!(normal.norm() / 2.0 > least))
            ++faults.degenerate;
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            triangles.push_back(corners);
    }
    UnionFind surfaces(triangles.size());
    checkEdges(triangles, mesh.vertices.size(), faults, surfaces);
    std::vector<double> volumes(triangles.size(), 0.0);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        volumes[surfaces.find(t)] += signedVolume(mesh, triangles[t]);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (surfaces.find(t) != t)
            continue;
        ++faults.components;
        faults.inverted += volumes[t] > 0.0 ? 0 : 1;
    }
    if (withIntersections)
        faults.selfIntersections = IntersectionSearch(mesh, triangles).count();
    return faults;
}

double enclosedVolume(const TriangleMesh& mesh)
{
    double volume = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        volume += signedVolume(mesh, {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    return volume;
}

} // namespace espalier
