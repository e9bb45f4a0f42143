// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeMesh.h"

#include "model/envelope/Contours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {

namespace {

using Vertex = std::uint32_t;
constexpr Vertex kNoVertex = 0xffffffffU;

class Sewing {
public:
    Sewing(const Envelope& envelope, int stride)
        : m_envelope(envelope),
          m_field(envelope.field()),
          m_stride(stride),
          m_width((m_field.distance.width() - 1) / stride + 2),
          m_height((m_field.distance.height() - 1) / stride + 2),
          m_front(m_width, m_height, kNoVertex),
          m_back(m_width, m_height, kNoVertex),
          m_rightward(m_width, m_height, kNoVertex),
          m_upward(m_width, m_height, kNoVertex)
    {
    }

    EnvelopeMesh sew()
    {
        for (int y = 0; y + 1 < m_height; ++y)
            for (int x = 0; x + 1 < m_width; ++x)
                addSquare(x, y);
        return std::move(m_mesh);
    }

private:
    struct Corner {
        Vertex front;
        Vertex back;
    };
    struct Node {
        int x;
        int y;
    };

    /// Distance at a node; 0 beyond the field.
    double distance(Node node) const
    {
        const int x = node.x * m_stride;
        const int y = node.y * m_stride;
        return m_field.distance.contains(x, y) ? double{m_field.distance(x, y)} : -1.0;
    }
    bool isInside(Node node) const { return distance(node) > 0.0; }

    static Vec3 slope(const Grid<float>& grid, int x, int y)
    {
        const int left = std::max(x - 1, 0);
        const int right = std::min(x + 1, grid.width() - 1);
        const int below = std::max(y - 1, 0);
        const int above = std::min(y + 1, grid.height() - 1);
        return {0.5F * (grid(right, y) - grid(left, y)), 0.5F * (grid(x, above) - grid(x, below)), 0.0F};
    }

    Vertex add(double x, double y, double z, const Vec3& normal)
    {
        const float length = normal.norm();
        const Vec3 unit = length > 0.0F ? Vec3(normal / length) : Vec3(Vec3::UnitZ());
        m_mesh.positions.push_back(m_envelope.toWorld(x, y, z));
        m_mesh.normals.push_back(m_envelope.directionToWorld(unit));
        return static_cast<Vertex>(m_mesh.positions.size() - 1);
    }

    Corner atNode(Node node)
    {
        Vertex& front = m_front(node.x, node.y);
        Vertex& back = m_back(node.x, node.y);
        if (front == kNoVertex) {
            // The surface is squaredHeight(x, y) - z² = 0; its normal is the negative gradient of that
            // function.
            const int x = node.x * m_stride;
            const int y = node.y * m_stride;
            const float z = std::sqrt(m_field.squaredHeight(x, y));
            const Vec3 outward = -slope(m_field.squaredHeight, x, y);
            front = add(x, y, double{z}, outward + 2.0F * z * Vec3::UnitZ());
            back = add(x, y, double{-z}, outward - 2.0F * z * Vec3::UnitZ());
        }
        return {front, back};
    }

    /// The point where the outline crosses the edge from one node to the next, right of it or above.
    Corner onOutline(Node from, Node to)
    {
        const bool rightward = from.y == to.y;
        if (to.x < from.x || to.y < from.y)
            std::swap(from, to);
        Vertex& vertex = rightward ? m_rightward(from.x, from.y) : m_upward(from.x, from.y);
        if (vertex == kNoVertex) {
            // A minimum distance from the nodes, so that each triangle has an area.
            const double place = std::clamp(distance(from) / (distance(from) - distance(to)), 0.02, 0.98);
            const auto between = [&](int a, int b) { return m_stride * std::lerp(a, b, place); };
            const auto share = static_cast<float>(place);
            const auto fall = [&](Node node) {
                return Vec3(-slope(m_field.distance,
                                   std::min(node.x * m_stride, m_field.distance.width() - 1),
                                   std::min(node.y * m_stride, m_field.distance.height() - 1)));
            };
            vertex = add(between(from.x, to.x), between(from.y, to.y), 0.0,
                         (1.0F - share) * fall(from) + share * fall(to));
        }
        return {vertex, vertex};
    }

    void addSquare(int x, int y)
    {
        const std::array<Node, 4> nodes{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
        const std::array<bool, 4> inside{isInside(nodes[0]), isInside(nodes[1]), isInside(nodes[2]),
                                         isInside(nodes[3])};
        if (inside[0] && inside[1] && inside[2] && inside[3]) {
            addPolygon({atNode(nodes[0]), atNode(nodes[1]), atNode(nodes[2]), atNode(nodes[3])});
            return;
        }
        const double centre =
            distance(nodes[0]) + distance(nodes[1]) + distance(nodes[2]) + distance(nodes[3]);
        const auto sides = crossedSides(inside, centre > 0.0);
        const auto crossing = [&](int side) {
            return onOutline(nodes[static_cast<std::size_t>(side)],
                             nodes[static_cast<std::size_t>((side + 1) % 4)]);
        };
        // A part is the region left of the line: from where the line leaves the square around to where it
        // came in, and on along the other line if the square holds two lines that bound the same part.
        std::array<bool, 2> done{};
        for (std::size_t first = 0; first < sides.size(); ++first) {
            if (sides[first][0] < 0 || done[first])
                continue;
            std::vector<Corner> part;
            for (std::size_t line = first; !done[line];) {
                done[line] = true;
                part.push_back(crossing(sides[line][0]));
                part.push_back(crossing(sides[line][1]));
                int corner = (sides[line][1] + 1) % 4;
                while (inside[static_cast<std::size_t>((corner + 1) % 4)]) {
                    part.push_back(atNode(nodes[static_cast<std::size_t>(corner)]));
                    corner = (corner + 1) % 4;
                }
                part.push_back(atNode(nodes[static_cast<std::size_t>(corner)]));
                if (sides[1 - line][0] == corner)
                    line = 1 - line;
            }
            addPolygon(std::move(part));
        }
    }

    void addPolygon(std::vector<Corner> corners)
    {
        // The fan starts at a node: a triangle with all corners on the outline would be the same in front and
        // back.
        std::ranges::rotate(corners, std::ranges::find_if(corners, [](const Corner& corner) {
                                return corner.front != corner.back;
                            }));
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            addTriangle(corners[0].front, corners[i].front, corners[i + 1].front);
            addTriangle(corners[0].back, corners[i + 1].back, corners[i].back);
        }
    }

    void addTriangle(Vertex a, Vertex b, Vertex c)
    {
        m_mesh.triangles.insert(m_mesh.triangles.end(), {a, b, c});
    }

    const Envelope& m_envelope;
    const EnvelopeField& m_field;
    int m_stride;
    int m_width; ///< Width of the mesh's own lattice, one node more than needed
    int m_height;
    Grid<Vertex> m_front;
    Grid<Vertex> m_back;
    Grid<Vertex> m_rightward; ///< On the edge from a node to the next one rightward
    Grid<Vertex> m_upward;
    EnvelopeMesh m_mesh;
};

} // namespace

EnvelopeMesh envelopeMesh(const Envelope& envelope, int stride)
{
    EnvelopeMesh mesh = Sewing(envelope, std::clamp(stride, 1, 8)).sew();
    if (mesh.triangles.empty())
        mesh = Sewing(envelope, 1).sew();
    return mesh;
}

} // namespace espalier
