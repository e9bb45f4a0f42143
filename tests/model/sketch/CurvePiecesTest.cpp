// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/CurvePieces.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier::test {

class CurvePiecesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void smoothCurve_hasEqualPieces();
    void scribble_isFollowedAtItsCorners();
    void shares_areThoseOfTheArcLength();
    void tinyPieces_areNotDivided();
};

namespace {

using Curve = std::vector<Eigen::Vector3d>;

Curve arc(int count)
{
    Curve curve;
    for (int i = 0; i <= count; ++i)
        curve.emplace_back(std::cos(0.01 * i), std::sin(0.01 * i), 0.2 * i / count);
    return curve;
}

/// Straight lines of about a quarter of a metre, with a corner after each.
Curve scribble(std::uint64_t seed, int corners)
{
    Random random(seed, 0, 0, Purpose::Texture);
    Curve curve{Eigen::Vector3d::Zero()};
    for (int i = 0; i < corners; ++i) {
        const double angle = random.uniform(0.0, 6.28);
        const Eigen::Vector3d step(std::cos(angle), std::sin(angle), 0.2 * random.normal());
        for (int j = 0; j < 5; ++j)
            curve.emplace_back(curve.back() + 0.05 * step);
    }
    return curve;
}

/// The greatest distance of the curve's points from any of the pieces.
double farthestFrom(const CurvePieces& pieces, const Curve& curve)
{
    double farthest = 0.0;
    for (const Eigen::Vector3d& point : curve) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < pieces.ends.size(); ++i) {
            const Eigen::Vector3d chord = pieces.ends[i] - pieces.ends[i - 1];
            const double share =
                std::clamp((point - pieces.ends[i - 1]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (point - pieces.ends[i - 1] - share * chord).norm());
        }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

} // namespace

void CurvePiecesTest::smoothCurve_hasEqualPieces()
{
    const Curve curve = arc(150);
    const CurvePieces pieces = curvePieces(curve, 0.1, 0.01);
    QCOMPARE(pieces.ends.size(), std::size_t{16});
    QCOMPARE(pieces.ends.front(), curve.front());
    QCOMPARE(pieces.ends.back(), curve.back());
    for (std::size_t i = 1; i < pieces.ends.size(); ++i)
        QVERIFY(std::abs(pieces.shares[i] - pieces.shares[i - 1] - 1.0 / 15.0) < 1e-12);
    // Finer where the chords ask for it, still equal.
    const CurvePieces fine = curvePieces(curve, 0.1, 1e-4);
    QVERIFY(fine.ends.size() > 25 && farthestFrom(fine, curve) <= 1e-4);
    QVERIFY(std::abs(fine.shares[1] * static_cast<double>(fine.ends.size() - 1) - 1.0) < 1e-12);
}

void CurvePiecesTest::scribble_isFollowedAtItsCorners()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Curve curve = scribble(seed, 60);
        const CurvePieces pieces = curvePieces(curve, 0.1, 1e-3);
        QVERIFY(pieces.ends.size() - 1 <= kMostCurvePieces);
        QVERIFY(farthestFrom(pieces, curve) <= 1e-3);
    }
}

void CurvePiecesTest::shares_areThoseOfTheArcLength()
{
    const Curve curve = scribble(4, 60);
    const CurvePieces pieces = curvePieces(curve, 0.1, 1e-3);
    QCOMPARE(pieces.shares.size(), pieces.ends.size());
    QCOMPARE(pieces.shares.front(), 0.0);
    QVERIFY(std::abs(pieces.shares.back() - 1.0) < 1e-9);
    const double length = curveLength(curve);
    // No corner lies within a piece, so the pieces are as long as the curve between their ends.
    for (std::size_t i = 1; i < pieces.ends.size(); ++i) {
        const double piece = (pieces.ends[i] - pieces.ends[i - 1]).norm();
        const double share = pieces.shares[i] - pieces.shares[i - 1];
        QVERIFY(share > 0.0 && std::abs(piece - share * length) <= 3e-3);
    }
}

void CurvePiecesTest::tinyPieces_areNotDivided()
{
    const Curve curve = scribble(2, 4);
    const CurvePieces pieces = curvePieces(curve, 0.001, 1e-9);
    QCOMPARE(pieces.ends.size(), static_cast<std::size_t>(std::round(curveLength(curve) / 0.001)) + 1);
}

const TestClass<CurvePiecesTest> curvePiecesTest;

} // namespace espalier::test

#include "CurvePiecesTest.moc"
