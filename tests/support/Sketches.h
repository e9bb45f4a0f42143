// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace espalier::test {

/// One stroke of a crown as an untrained person draws it: 0…255, y down, whole numbers.
struct Sketch {
    QString name;
    std::vector<Vec2> points;
};

/// A crown of @p lobes bumps around the centre of the paper, drawn in @p points. It ends @p overshoot turns
/// beyond its start (negative: before it); @p phase and @p wobble (in radii) are the errors of the drawing.
inline Sketch drawnCrown(const QString& name, int lobes, int points, double overshoot, double phase,
                         double wobble)
{
    Sketch sketch{name, {}};
    for (int i = 0; i < points; ++i) {
        const double turn = (1.0 + overshoot) * i / (points - 1);
        const double angle = 2.0 * std::numbers::pi * turn;
        const double bump = 0.25 * std::abs(std::sin(0.5 * lobes * angle));
        const double error =
            wobble * (std::sin(2.3 * angle + phase) + 0.6 * std::sin(5.9 * angle + 2.0 * phase));
        const double radius = 0.75 + bump + error;
        sketch.points.emplace_back(
            static_cast<float>(std::round(127.0 + 110.0 * radius * std::cos(angle + phase))),
            static_cast<float>(std::round(127.0 + 80.0 * radius * std::sin(angle + phase))));
    }
    return sketch;
}

/// Crowns as people draw them: clouds and plain loops, ends that miss each other or cross, few points and
/// many.
inline std::vector<Sketch> drawnCrowns()
{
    return {
        drawnCrown(QStringLiteral("cloud, ends cross"), 7, 61, 0.02, 0.4, 0.03),
        drawnCrown(QStringLiteral("cloud, ends miss"), 5, 40, -0.02, 2.0, 0.04),
        drawnCrown(QStringLiteral("cloud of many lobes"), 11, 90, 0.01, 3.3, 0.02),
        drawnCrown(QStringLiteral("plain loop"), 0, 18, -0.01, 5.1, 0.05),
        drawnCrown(QStringLiteral("shaky loop"), 0, 48, 0.015, 1.2, 0.08),
        drawnCrown(QStringLiteral("few points"), 3, 13, 0.0, 4.4, 0.05),
    };
}

/// The largest stroke of each sketch in @p kind.ndjson (Quick, Draw! format) of the folder that the
/// environment variable ESPALIER_SKETCHES names; none if it is not set. Ends the test if the file cannot be
/// read.
inline std::vector<Sketch> givenSketches(const QString& kind)
{
    const QString folder = qEnvironmentVariable("ESPALIER_SKETCHES");
    if (folder.isEmpty())
        return {};
    QFile file(QDir(folder).filePath(kind + QStringLiteral(".ndjson")));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("ESPALIER_SKETCHES: %s cannot be read", qPrintable(file.fileName()));
    std::vector<Sketch> sketches;
    while (!file.atEnd()) {
        const QJsonArray strokes =
            QJsonDocument::fromJson(file.readLine()).object().value(QStringLiteral("drawing")).toArray();
        Sketch sketch{QStringLiteral("%1 %2").arg(kind).arg(sketches.size() + 1), {}};
        float size = 0.0F;
        for (const QJsonValue& stroke : strokes) {
            const QJsonArray x = stroke.toArray().at(0).toArray();
            const QJsonArray y = stroke.toArray().at(1).toArray();
            std::vector<Vec2> points;
            Eigen::AlignedBox2f box;
            for (qsizetype i = 0; i < x.size(); ++i) {
                points.emplace_back(static_cast<float>(x.at(i).toDouble()),
                                    static_cast<float>(y.at(i).toDouble()));
                box.extend(points.back());
            }
            if (box.sizes().prod() > size) {
                size = box.sizes().prod();
                sketch.points = std::move(points);
            }
        }
        sketches.push_back(std::move(sketch));
    }
    return sketches;
}

/// Whether the ends of @p points are at most @p share of its length apart.
inline bool isClosed(const std::vector<Vec2>& points, float share)
{
    float length = 0.0F;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return points.size() >= 3 && (points.front() - points.back()).norm() <= share * length;
}

} // namespace espalier::test
