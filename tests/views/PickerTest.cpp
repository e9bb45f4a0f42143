// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Widths.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "views/tools/BudPicker.h"

#include <QTest>

#include <bit>
#include <set>

using namespace espalier;
using namespace espalier::test;

/// The picked branch or bud, compared with a search of every internode and every bud.
class PickerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void branch_isTheNearestOfAll();
    void buds_areAllWithinReach();

private:
    /// Calls @p check(scene, screen) for pointers all over views of a tree that is grown, pruned by undo and
    /// grown again.
    template <class Check>
    void forPointers(Check&& check);
};

namespace {

constexpr double kReach = 9.0; ///< px

/// The distance of the pointer from an internode's bark, px, and the depth of that place, m; nothing behind
/// the camera.
struct Off {
    double pixels;
    double depth;
};
std::optional<Off> offOf(const PickScene& scene, InternodeId id, const QPointF& screen)
{
    const Vec3 lower = scene.index.basePosition(scene.tree, id);
    const Vec3& upper = scene.index.nodePosition(id);
    const Camera& camera = scene.camera;
    const auto a = camera.project(lower);
    const auto b = camera.project(upper);
    if (!a || !b || std::min(camera.depth(lower), camera.depth(upper)) < Camera::kMinDistance / 2.0F)
        return std::nullopt;
    const QPointF way = *b - *a;
    const double along = std::clamp(
        QPointF::dotProduct(screen - *a, way) / std::max(QPointF::dotProduct(way, way), 1e-6), 0.0, 1.0);
    const QPointF nearest = *a + along * way;
    const double depth = camera.depth(lower) + along * (camera.depth(upper) - camera.depth(lower));
    const double bark = scene.radius(id) * camera.pixelsPerMetre(1.0F) / depth;
    const double distance = std::hypot(screen.x() - nearest.x(), screen.y() - nearest.y());
    return Off{std::max(0.0, distance - bark), depth - static_cast<double>(scene.radius(id))};
}

} // namespace

template <class Check>
void PickerTest::forPointers(Check&& check)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 300, 900);
        for (int round = 0; round < 3; ++round) {
            if (round == 1)
                document.undoStack().undo();
            if (round == 2)
                grow(document, 2);
            const Widths widths(document.tree(), document.index());
            const std::function<float(InternodeId)> radius = [&](InternodeId id) {
                return widths.radius(document.index(), id);
            };
            Box3 box;
            for (InternodeId id = 0; id < document.tree().size(); ++id) {
                if (document.tree().isAlive(id))
                    box.extend(document.index().nodePosition(id));
            }
            Camera camera;
            camera.setViewSize({800.0, 600.0});
            camera.setTarget(box.center());
            camera.setDistance(1.5F * std::max(box.sizes().maxCoeff(), 0.2F));
            camera.orbit(0.7F * static_cast<float>(round), 0.2F);
            const PickScene scene{document.tree(), document.index(), document.pickIndex(),
                                  radius,          radius(0),        camera};
            for (int i = 0; i < 120; ++i)
                check(scene, QPointF(800.0 * (i % 12 + 0.5) / 12.0, 600.0 * (i / 12 + 0.5) / 10.0));
        }
    }
}

void PickerTest::branch_isTheNearestOfAll()
{
    int hits = 0;
    forPointers([&](const PickScene& scene, const QPointF& screen) {
        std::optional<Off> best;
        for (InternodeId id = 0; id < scene.tree.size(); ++id) {
            const auto off = scene.tree.isAlive(id) ? offOf(scene, id, screen) : std::nullopt;
            if (off && off->pixels < kReach && (!best || off->pixels < best->pixels))
                best = off;
        }
        const auto picked = pickBranch(scene, screen, kReach);
        // At the limit of the reach rounding decides.
        if (best && best->pixels < kReach - 0.01)
            QVERIFY(picked.has_value());
        if (!picked)
            return;
        QVERIFY(best.has_value());
        ++hits;
        QVERIFY(scene.tree.isAlive(picked->id));
        const auto off = offOf(scene, picked->id, screen);
        // Of internodes within 3 px any may be picked.
        QVERIFY2(off && off->pixels <= best->pixels + 3.01,
                 qPrintable(QStringLiteral("%1 px, not %2").arg(off->pixels).arg(best->pixels)));
    });
    QVERIFY2(hits > 100, qPrintable(QString::number(hits)));
}

void PickerTest::buds_areAllWithinReach()
{
    int hits = 0;
    forPointers([&](const PickScene& scene, const QPointF& screen) {
        std::set<BudRef> within;
        std::set<BudRef> nearly;
        for (InternodeId id = 0; id < scene.tree.size(); ++id) {
            if (!scene.tree.isAlive(id))
                continue;
            for (unsigned rest = scene.tree.buds(id); rest != 0; rest &= rest - 1) {
                const BudRef bud{id, std::countr_zero(rest)};
                const auto place =
                    scene.camera.project(budPosition(scene.tree, scene.index, bud, scene.radius(id)));
                const double away =
                    place ? std::hypot(place->x() - screen.x(), place->y() - screen.y()) : 1e9;
                if (away < 3.0 * kReach - 0.01)
                    within.insert(bud);
                if (away < 3.0 * kReach + 0.01)
                    nearly.insert(bud);
            }
        }
        std::set<BudRef> picked;
        for (const PickedBud& bud : pickBuds(scene, screen, 3.0 * kReach))
            picked.insert(bud.bud);
        if (nearly.size() >= kMostPickedBuds)
            return;
        QVERIFY(std::ranges::includes(picked, within));
        QVERIFY(std::ranges::includes(nearly, picked));
        hits += picked.empty() ? 0 : 1;
    });
    QVERIFY2(hits > 100, qPrintable(QString::number(hits)));
}

static const TestClass<PickerTest> pickerTest;

#include "PickerTest.moc"
