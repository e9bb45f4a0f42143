// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/Envelope.h"

#include "model/base/Parallel.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

using Point3 = Eigen::Vector3d;

/// A shorter side leaves nothing to show or to fill, m.
constexpr double kShortestSide = 1e-6;
/// A smaller area, in squares of nodes, counts as none.
constexpr double kLeastArea = 9.0;
/// Attempts at one marker. One in two succeeds, so the limit is only reached with numbers at their limits.
constexpr int kAttempts = 1000;

Error envelopeError(const char* text)
{
    return {Error::Kind::Input, QCoreApplication::translate("Envelope", text)};
}

} // namespace

struct Envelope::Content {
    EnvelopeField field;
    Point3 corner; ///< World position of node (0, 0), m
    Point3 right;
    Point3 up;
    Point3 front;
    double spacing = 0.0; ///< m
    double volume = 0.0;  ///< m³
    Box3 bounds;
    /// Squares of nodes that the silhouette touches, by the index of their lower left node.
    std::vector<int> squares;
    /// Sums of the volumes of the boxes over those squares, up to and including each, spacing³.
    std::vector<double> boxes;
    int deepestX = 0;
    int deepestY = 0;

    Point3 toWorld(double x, double y, double z) const
    {
        return corner + spacing * (x * right + y * up + z * front);
    }

    /// The inverse of toWorld().
    Point3 placeOf(const Vec3& point) const
    {
        const Point3 offset = (point.cast<double>() - corner) / spacing;
        return {offset.dot(right), offset.dot(up), offset.dot(front)};
    }
    /// The square over which a place lies; none outside the grid.
    std::optional<GridPlace> squareOf(const Point3& place) const
    {
        const Grid<float>& distance = field.distance;
        if (!(place.x() >= 0.0 && place.y() >= 0.0 && place.x() < distance.width() - 1 &&
              place.y() < distance.height() - 1))
            return {};
        const int left = static_cast<int>(place.x());
        const int below = static_cast<int>(place.y());
        return GridPlace{left, below, place.x() - left, place.y() - below};
    }
    /// Squared height of the surface, spacing²; 0 beside the silhouette.
    double squaredHeightAt(const Point3& place) const
    {
        const std::optional<GridPlace> square = squareOf(place);
        return square ? field.squaredHeightAt(*square) : 0.0;
    }

    /// Height of the box over a square: the surface between the nodes is nowhere higher than at the highest
    /// of them.
    double boxHeight(int square) const
    {
        const int x = square % field.distance.width();
        const int y = square / field.distance.width();
        double highest = 0.0;
        for (const auto& [nodeX, nodeY] : {std::pair(x, y), {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) {
            const auto inside = double{field.distance(nodeX, nodeY)};
            highest = std::max(
                {highest, double{field.squaredHeight(nodeX, nodeY)}, inside > 0.0 ? inside * inside : 0.0});
        }
        return std::sqrt(highest);
    }

    void measure();
};

/// Computes volume, bounds and the data for sampling.
void Envelope::Content::measure()
{
    const int width = field.distance.width();
    const int height = field.distance.height();
    double sum = 0.0;
    double total = 0.0;
    for (int y = 0; y + 1 < height; ++y) {
        for (int x = 0; x + 1 < width; ++x) {
            const float nearest = std::max({field.distance(x, y), field.distance(x + 1, y),
                                            field.distance(x, y + 1), field.distance(x + 1, y + 1)});
            if (nearest <= 0.0F)
                continue;
            if (field.distance(x, y) > field.distance(deepestX, deepestY)) {
                deepestX = x;
                deepestY = y;
            }
            const int square = static_cast<int>(field.distance.index(x, y));
            const double rise = boxHeight(square);
            total += 2.0 * rise;
            squares.push_back(square);
            boxes.push_back(total);
            for (const double u : {0.25, 0.75})
                for (const double v : {0.25, 0.75})
                    sum += 0.5 * std::sqrt(field.squaredHeightAt({x, y, u, v}));
            for (const int cornerX : {x, x + 1})
                for (const int cornerY : {y, y + 1})
                    for (const double z : {-rise, rise})
                        bounds.extend(toWorld(cornerX, cornerY, z).cast<float>());
        }
    }
    volume = sum * spacing * spacing * spacing;
}

Result<Envelope> Envelope::fromStrokes(std::span<const LassoStroke> strokes, const EnvelopeOptions& options)
{
    if (strokes.empty())
        return envelopeError(QT_TRANSLATE_NOOP("Envelope", "There is no lasso stroke."));
    Content content;
    const LassoStroke& first = strokes.front();
    const Point3 origin = first.origin.cast<double>();
    content.right = first.right.cast<double>().normalized();
    content.front = content.right.cross(first.up.cast<double>()).normalized();
    content.up = content.front.cross(content.right);
    // Fails unless the vectors have length 1; comparisons with NaN fail too.
    if (!(std::abs(content.front.norm() - 1.0) < 1e-6 && std::abs(content.right.norm() - 1.0) < 1e-6 &&
          origin.allFinite()))
        return envelopeError(QT_TRANSLATE_NOOP("Envelope", "The lasso's drawing plane is not valid."));

    std::vector<Loop> loops;
    Eigen::AlignedBox2d box;
    for (const LassoStroke& stroke : strokes) {
        Loop loop;
        for (const Vec2& point : closedLoop(simplified(stroke.points))) {
            const Point3 offset = (stroke.origin.cast<double>() - origin) +
                                  double{point.x()} * stroke.right.cast<double>() +
                                  double{point.y()} * stroke.up.cast<double>();
            loop.emplace_back(content.right.dot(offset), content.up.dot(offset));
            if (!loop.back().allFinite())
                return envelopeError(
                    QT_TRANSLATE_NOOP("Envelope", "The lasso's drawing plane is not valid."));
        }
        if (loop.size() < 3)
            continue;
        for (const Eigen::Vector2d& point : loop)
            box.extend(point);
        loops.push_back(std::move(loop));
    }
    const double longest = loops.empty() ? 0.0 : box.sizes().maxCoeff();
    if (longest < kShortestSide)
        return envelopeError(QT_TRANSLATE_NOOP("Envelope", "The lasso is too small to enclose anything."));

    content.spacing = longest / std::clamp(options.resolution, 32, 1024);
    const Eigen::Vector2d corner = box.min().array() - kFieldMargin * content.spacing;
    content.corner = origin + corner.x() * content.right + corner.y() * content.up;
    for (Loop& loop : loops)
        for (Eigen::Vector2d& point : loop)
            point = (point - corner) / content.spacing;
    const auto nodes = [&](double side) {
        return static_cast<int>(std::ceil(side / content.spacing)) + 1 + 2 * kFieldMargin;
    };
    content.field = inflate(loops, nodes(box.sizes().x()), nodes(box.sizes().y()));
    const auto area = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < content.field.distance.size(); ++i)
            sum += content.field.distance[i] > 0.0F ? 1.0 : 0.0;
        return sum;
    };
    if (content.field.isEmpty() || area() < kLeastArea)
        return envelopeError(QT_TRANSLATE_NOOP("Envelope", "The lasso encloses no area."));

    content.measure();
    const bool tooFar =
        std::numeric_limits<float>::epsilon() * content.corner.cwiseAbs().maxCoeff() > content.spacing;
    Envelope envelope(std::make_shared<const Content>(std::move(content)));
    if (tooFar || !envelope.contains(envelope.deepest()))
        return envelopeError(
            QT_TRANSLATE_NOOP("Envelope", "The lasso is too small for its distance from the origin."));
    return envelope;
}

bool Envelope::contains(const Vec3& point) const
{
    const Point3 place = m_content->placeOf(point);
    const double squaredHeight = m_content->squaredHeightAt(place);
    return squaredHeight > 0.0 && place.z() * place.z() <= squaredHeight;
}

bool Envelope::containsWithin(const Vec3& point, double margin) const
{
    const Content& content = *m_content;
    const Point3 place = content.placeOf(point);
    const double height = std::sqrt(content.squaredHeightAt(place));
    if (height == 0.0)
        return false;
    // In a round bar, that is the inner third of its width and depth.
    const double within = std::min(margin / content.spacing, 0.7 * height);
    return interpolate(content.field.distance, *content.squareOf(place)) >= within &&
           std::abs(place.z()) <= height - within;
}

double Envelope::riseAt(const Vec3& point) const
{
    return m_content->spacing * std::sqrt(m_content->squaredHeightAt(m_content->placeOf(point)));
}

double Envelope::volume() const
{
    return m_content->volume;
}

Box3 Envelope::bounds() const
{
    return m_content->bounds;
}

std::vector<std::vector<Vec3>> Envelope::outline() const
{
    std::vector<std::vector<Vec3>> lines;
    for (const Loop& loop : m_content->field.outlines) {
        std::vector<Vec3>& line = lines.emplace_back();
        line.reserve(loop.size());
        for (const Eigen::Vector2d& point : loop)
            line.push_back(toWorld(point.x(), point.y(), 0.0));
    }
    return lines;
}

std::vector<Vec3> Envelope::sampleUniform(std::size_t count, std::uint64_t seed, std::uint32_t step) const
{
    std::vector<Vec3> markers(count);
    parallelFor(count, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Random random(seed, step, static_cast<std::uint32_t>(i), Purpose::LassoMarker);
            std::optional<Vec3> marker;
            for (int attempt = 0; !marker && attempt < kAttempts; ++attempt)
                marker = propose(random);
            markers[i] = marker.value_or(deepest());
        }
    });
    return markers;
}

std::optional<Vec3> Envelope::propose(Random& random) const
{
    const Content& content = *m_content;
    const auto box = std::ranges::upper_bound(content.boxes, random.uniform() * content.boxes.back()) -
                     content.boxes.begin();
    const auto chosen = std::min(static_cast<std::size_t>(box), content.boxes.size() - 1);
    const int square = content.squares[chosen];
    const int width = content.field.distance.width();
    const double rise = content.boxHeight(square);
    const double x = square % width + random.uniform();
    const int row = square / width;
    const double y = row + random.uniform();
    const Vec3 point = toWorld(x, y, random.uniform(-rise, rise));
    // Tested after rounding, so that contains() returns the same for the marker.
    return contains(point) ? std::optional(point) : std::nullopt;
}

double Envelope::proposalVolume() const
{
    return m_content->boxes.back() * std::pow(m_content->spacing, 3);
}

Vec3 Envelope::deepest() const
{
    return toWorld(m_content->deepestX, m_content->deepestY, 0.0);
}

const EnvelopeField& Envelope::field() const
{
    return m_content->field;
}

double Envelope::spacing() const
{
    return m_content->spacing;
}

Vec3 Envelope::toWorld(double x, double y, double z) const
{
    return m_content->toWorld(x, y, z).cast<float>();
}

Vec3 Envelope::directionToWorld(const Vec3& inField) const
{
    return inField.x() * m_content->right.cast<float>() + inField.y() * m_content->up.cast<float>() +
           inField.z() * m_content->front.cast<float>();
}

} // namespace espalier
