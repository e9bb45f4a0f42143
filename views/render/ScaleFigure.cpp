// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/ScaleFigure.h"

#include "model/settings/Lengths.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace espalier {

namespace {

constexpr double kLeastPerson = 6.0;   ///< px; a smaller person is a dot
constexpr double kPersonToRead = 46.0; ///< px, from which its height is written
constexpr double kFadesFrom = 0.75;    ///< Height of the person in views, from which it fades
constexpr double kFadesTo = 1.15;      ///< Where it has faded
constexpr float kSteepest = 1.2F;      ///< rad; from further above, a silhouette is no person
constexpr double kLongestBar = 130.0;  ///< px
constexpr double kBarMargin = 20.0;    ///< px
constexpr double kBarTick = 4.0;       ///< px
/// Beside the trunk, and beside a crown, m.
constexpr float kFromTrunk = 0.8F;
constexpr float kFromCrown = 0.35F;
/// Trees that are this high have their crowns beside a person; those, above, m.
constexpr float kLowTree = 2.2F;
constexpr float kHighTree = 4.5F;

/// Right half of the outline, from the neck down to between the legs: m to the right of the middle, m up.
constexpr std::array<std::array<double, 2>, 21> kHalfOutline{
    {{0.048, 1.52}, {0.075, 1.475}, {0.175, 1.44},  {0.215, 1.37}, {0.235, 1.22}, {0.262, 1.05},
     {0.272, 0.88}, {0.268, 0.77},  {0.235, 0.755}, {0.222, 0.88}, {0.205, 1.06}, {0.165, 1.22},
     {0.142, 1.08}, {0.168, 0.92},  {0.165, 0.72},  {0.135, 0.47}, {0.118, 0.24}, {0.095, 0.06},
     {0.15, 0.0},   {0.045, 0.0},   {0.012, 0.78}}};

/// A smooth line through @p points (Catmull-Rom).
void addSmooth(QPainterPath& path, std::span<const QPointF> points)
{
    path.lineTo(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const QPointF& before = points[i == 0 ? 0 : i - 1];
        const QPointF& after = points[std::min(i + 2, points.size() - 1)];
        path.cubicTo(points[i] + (points[i + 1] - before) / 6.0, points[i + 1] - (after - points[i]) / 6.0,
                     points[i + 1]);
    }
}

/// In metres, the feet at the origin, upward.
QPainterPath person()
{
    std::vector<QPointF> right;
    std::vector<QPointF> left;
    for (const auto& [x, y] : kHalfOutline) {
        right.emplace_back(x, y);
        left.emplace_back(-x, y);
    }
    std::ranges::reverse(left);
    QPainterPath body(left.back());
    addSmooth(body, right);
    addSmooth(body, left);
    body.closeSubpath();
    QPainterPath head;
    head.addEllipse(QPointF(0.0, 1.632), 0.084, kPersonHeight - 1.632);
    QPainterPath neck;
    neck.addRect(-0.047, 1.46, 0.094, 0.12);
    return body.united(head).united(neck);
}

QColor inkOver(bool light, double opacity)
{
    QColor colour = light ? QColor(0x2e, 0x36, 0x40) : QColor(0xc6, 0xd0, 0xdc);
    colour.setAlphaF(static_cast<float>(opacity));
    return colour;
}

double pixelLength(const QPointF& vector)
{
    return std::hypot(vector.x(), vector.y());
}

QFont smallFont(const QPainter& painter)
{
    QFont font = painter.font();
    font.setPointSizeF(0.88 * font.pointSizeF());
    return font;
}

} // namespace

float personPlace(const Box3& bounds)
{
    if (bounds.isEmpty())
        return kFromTrunk;
    const float reach = std::max(std::max(bounds.max().x(), -bounds.min().x()),
                                 std::max(bounds.max().z(), -bounds.min().z()));
    const float height = bounds.max().y();
    const float low = std::clamp((kHighTree - height) / (kHighTree - kLowTree), 0.0F, 1.0F);
    return std::max(kFromTrunk, low * (reach + kFromCrown));
}

void paintPerson(QPainter& painter, const Camera& camera, float right, bool isOverLight)
{
    const Vec3 foot = right * camera.right();
    const auto place = camera.project(foot);
    const auto top = camera.project(foot + static_cast<float>(kPersonHeight) * Vec3::UnitY());
    const auto beside = camera.project(foot + camera.right());
    if (!place || !top || !beside || std::abs(camera.elevation()) > kSteepest)
        return;
    const QPointF up = (*top - *place) / kPersonHeight;
    const QPointF across = *beside - *place;
    const double height = pixelLength(*top - *place);
    const double share = height / camera.viewSize().height();
    const double strength = std::clamp((kFadesTo - share) / (kFadesTo - kFadesFrom), 0.0, 1.0);
    if (height < kLeastPerson || strength <= 0.0)
        return;
    static const QPainterPath silhouette = person();
    // A shadow, so that the person stands on the ground.
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, static_cast<int>(50.0 * strength)));
    const double wide = 0.3 * pixelLength(across);
    const double steep = static_cast<double>(std::abs(std::sin(camera.elevation())));
    painter.drawEllipse(*place, wide, std::max(wide * steep, 0.06 * wide));
    painter.save();
    painter.setTransform(QTransform(across.x(), across.y(), up.x(), up.y(), place->x(), place->y()), true);
    painter.setBrush(inkOver(isOverLight, 0.45 * strength));
    painter.drawPath(silhouette);
    painter.restore();
    if (height < kPersonToRead)
        return;
    painter.setFont(smallFont(painter));
    painter.setPen(inkOver(isOverLight, 0.7 * strength));
    painter.drawText(*top + QPointF(0.16 * pixelLength(across), painter.fontMetrics().ascent()),
                     lengthText(kPersonHeight));
}

double scaleBarLength(double most)
{
    if (!(most > 0.0))
        return 0.0;
    if (units() == Units::Imperial) {
        constexpr std::array kInches{0.5, 1.0, 2.0, 6.0};
        double length = kInches.front() * kInch;
        for (const double inches : kInches) {
            if (inches * kInch <= most)
                length = inches * kInch;
        }
        for (double feet = 1.0; feet * kFoot <= most; feet *= 10.0) {
            for (const double times : {1.0, 2.0, 5.0}) {
                if (times * feet * kFoot <= most)
                    length = times * feet * kFoot;
            }
        }
        return length;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0}) {
        if (times * decade <= most)
            return times * decade;
    }
    return decade;
}

void paintScaleBar(QPainter& painter, const Camera& camera, const QRect& clear, bool isOverLight)
{
    const float depth = camera.depth(Vec3::Zero());
    if (depth < Camera::kMinDistance)
        return;
    const auto pixels = static_cast<double>(camera.pixelsPerMetre(depth));
    const double length = scaleBarLength(kLongestBar / pixels);
    const double wide = pixels * length;
    if (wide < kBarTick)
        return;
    const QPointF right(clear.right() - kBarMargin, clear.bottom() - kBarMargin);
    const QPointF left = right - QPointF(wide, 0.0);
    const QPointF tick(0.0, kBarTick);
    painter.setPen(QPen(inkOver(isOverLight, 0.75), 1.4, Qt::SolidLine, Qt::FlatCap));
    painter.drawPolyline(QPolygonF{left - tick, left, right, right - tick});
    painter.setFont(smallFont(painter));
    painter.drawText(QRectF(left.x() - kLongestBar,
                            left.y() - 4.0 * kBarTick - painter.fontMetrics().height(),
                            wide + 2.0 * kLongestBar, painter.fontMetrics().height() + 2.0 * kBarTick),
                     Qt::AlignHCenter | Qt::AlignBottom, roundLengthText(length));
}

} // namespace espalier
