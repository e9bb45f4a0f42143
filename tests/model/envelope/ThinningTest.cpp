// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/Thinning.h"

#include "model/base/Random.h"
#include "model/envelope/DistanceTransform.h"
#include "model/envelope/EnvelopeField.h"
#include "tests/model/envelope/Silhouettes.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>

namespace espalier::test {

class ThinningTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void distanceTransform_isThatOfAllSites();
    void distanceTransform_withoutSites_isInfinite();
    void thinned_keepsComponentsAndHoles();
    void thinned_isOneNodeWide();
    void axes_turnWithTheShape();
    void thinned_keepsWhatItIsTold();
    void axes_ofABarAreItsMiddle();
    void axes_keepComponentsAndHoles();
};

namespace {

int components(const Mask& mask, std::uint8_t value, bool diagonal)
{
    Grid<std::uint8_t> seen(mask.width(), mask.height());
    int count = 0;
    for (int startY = 0; startY < mask.height(); ++startY) {
        for (int startX = 0; startX < mask.width(); ++startX) {
            if (mask(startX, startY) != value || seen(startX, startY) != 0)
                continue;
            ++count;
            std::vector<std::array<int, 2>> open{{startX, startY}};
            seen(startX, startY) = 1;
            while (!open.empty()) {
                const auto [x, y] = open.back();
                open.pop_back();
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        if (!diagonal && dx != 0 && dy != 0)
                            continue;
                        if (!mask.contains(x + dx, y + dy) || seen(x + dx, y + dy) != 0 ||
                            mask(x + dx, y + dy) != value)
                            continue;
                        seen(x + dx, y + dy) = 1;
                        open.push_back({x + dx, y + dy});
                    }
                }
            }
        }
    }
    return count;
}

/// Discs added and taken away at random, with a free margin.
Mask blob(std::uint32_t number)
{
    Random random(7, 0, number, Purpose::Texture);
    Mask mask(64, 56);
    for (int disc = 0; disc < 12; ++disc) {
        const double x = random.uniform(12.0, 52.0);
        const double y = random.uniform(12.0, 44.0);
        const double radius = random.uniform(2.0, 10.0);
        for (int j = 1; j + 1 < mask.height(); ++j)
            for (int i = 1; i + 1 < mask.width(); ++i)
                if (std::hypot(i - x, j - y) < radius)
                    mask(i, j) = disc % 3 != 2;
    }
    return mask;
}

Loop loopOf(const Points& points, double size, int margin)
{
    Eigen::AlignedBox2d box;
    for (const Vec2& point : points)
        box.extend(point.cast<double>());
    Loop loop;
    for (const Vec2& point : points)
        loop.emplace_back((point.cast<double>() - box.min()) * size / box.sizes().maxCoeff() +
                          Eigen::Vector2d(margin, margin));
    return loop;
}

EnvelopeField fieldOf(const Points& points, int size)
{
    const int nodes = size + 2 * kFieldMargin + 1;
    return inflate(std::vector<Loop>{loopOf(points, size, kFieldMargin)}, nodes, nodes);
}

Mask insideOf(const EnvelopeField& field)
{
    Mask mask(field.distance.width(), field.distance.height());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = field.distance[i] > 0.0F;
    return mask;
}

/// By 90 degrees.
Mask turned(const Mask& mask)
{
    Mask result(mask.height(), mask.width());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            result(mask.height() - 1 - y, x) = mask(x, y);
    return result;
}

double hausdorff(const Mask& first, const Mask& second)
{
    double worst = 0.0;
    for (const auto& [from, to] : {std::pair(&first, &second), std::pair(&second, &first)}) {
        Grid<double> cost(to->width(), to->height(), kNoSite);
        for (std::size_t i = 0; i < cost.size(); ++i)
            if ((*to)[i] != 0)
                cost[i] = 0.0;
        const DistanceTransform distances = distanceTransform(cost);
        for (std::size_t i = 0; i < cost.size(); ++i)
            if ((*from)[i] != 0)
                worst = std::max(worst, std::sqrt(distances.value[i]));
    }
    return worst;
}

int squares(const Mask& mask)
{
    int count = 0;
    for (int y = 0; y + 1 < mask.height(); ++y)
        for (int x = 0; x + 1 < mask.width(); ++x)
            count += mask(x, y) != 0 && mask(x + 1, y) != 0 && mask(x, y + 1) != 0 && mask(x + 1, y + 1) != 0;
    return count;
}

} // namespace

void ThinningTest::distanceTransform_isThatOfAllSites()
{
    for (std::uint32_t number = 0; number < 20; ++number) {
        Random random(3, 0, number, Purpose::Texture);
        Grid<double> cost(23, 17, kNoSite);
        const double share = random.uniform();
        for (std::size_t i = 0; i < cost.size(); ++i)
            if (random.uniform() < share)
                cost[i] = number % 2 == 0 ? 0.0 : random.uniform(-100.0, 20.0);
        cost(4, 5) = 1.0;
        const DistanceTransform transform = distanceTransform(cost);
        for (int y = 0; y < cost.height(); ++y) {
            for (int x = 0; x < cost.width(); ++x) {
                const auto from = [&](int site) {
                    const int dx = x - site % cost.width();
                    const int dy = y - site / cost.width();
                    return dx * dx + dy * dy + cost[static_cast<std::size_t>(site)];
                };
                double least = kNoSite;
                for (int site = 0; site < static_cast<int>(cost.size()); ++site)
                    least = std::min(least, from(site));
                QVERIFY(std::abs(transform.value(x, y) - least) < 1e-9);
                QVERIFY(std::abs(from(transform.site(x, y)) - least) < 1e-9);
            }
        }
    }
}

void ThinningTest::distanceTransform_withoutSites_isInfinite()
{
    const DistanceTransform transform = distanceTransform(Grid<double>(5, 4, kNoSite));
    for (std::size_t i = 0; i < transform.value.size(); ++i) {
        QCOMPARE(transform.value[i], kNoSite);
        QCOMPARE(transform.site[i], -1);
    }
}

void ThinningTest::thinned_keepsComponentsAndHoles()
{
    for (std::uint32_t number = 0; number < 200; ++number) {
        const Mask mask = blob(number);
        const Mask lines = thinned(mask);
        for (std::size_t i = 0; i < mask.size(); ++i)
            QVERIFY(lines[i] <= mask[i]);
        QCOMPARE(components(lines, 1, true), components(mask, 1, true));
        QCOMPARE(components(lines, 0, false), components(mask, 0, false));
    }
}

void ThinningTest::thinned_isOneNodeWide()
{
    int artefacts = 0;
    for (std::uint32_t number = 0; number < 200; ++number)
        artefacts += squares(thinned(blob(number)));
    qInfo("2 x 2 blocks left in 200 skeletons: %d", artefacts);
    QVERIFY(artefacts <= 20);
}

void ThinningTest::axes_turnWithTheShape()
{
    double worst = 0.0;
    for (const Points& points : {heart(), arch(), swan(), letterE(), letterS(), circle(1.0)}) {
        Loop loop = loopOf(points, 100.0, kFieldMargin);
        const EnvelopeField field = inflate(std::vector<Loop>{loop}, 107, 107);
        for (Eigen::Vector2d& point : loop)
            point = Eigen::Vector2d(106.0 - point.y(), point.x());
        const EnvelopeField other = inflate(std::vector<Loop>{loop}, 107, 107);
        worst = std::max(worst, hausdorff(turned(field.axes), other.axes));
    }
    qInfo("farthest between the axes of a shape and of the turned shape: %.2f nodes", worst);
    QVERIFY(worst <= 2.0);
}

void ThinningTest::thinned_keepsWhatItIsTold()
{
    const Mask mask = blob(1);
    Mask kept(mask.width(), mask.height());
    for (int y = 0; y < mask.height(); y += 7)
        for (int x = 0; x < mask.width(); x += 7)
            kept(x, y) = mask(x, y);
    const Mask lines = thinned(mask, kept);
    for (std::size_t i = 0; i < mask.size(); ++i)
        QVERIFY(lines[i] >= kept[i] && lines[i] <= mask[i]);
    QCOMPARE(components(lines, 1, true), components(mask, 1, true));
    QCOMPARE(components(lines, 0, false), components(mask, 0, false));
}

void ThinningTest::axes_ofABarAreItsMiddle()
{
    const EnvelopeField field = fieldOf({{0, 0}, {5, 0}, {5, 1}, {0, 1}}, 200);
    int corners = 0;
    for (int y = 0; y < field.axes.height(); ++y) {
        for (int x = 0; x < field.axes.width(); ++x) {
            if (field.axes(x, y) == 0)
                continue;
            const double fromEnd = std::min(x, 206 - x) - 3.0;
            const double fromMiddle = std::abs(y - 23.0);
            // The middle, and branches at 45 degrees into the corners.
            QVERIFY(fromEnd > 19.0 ? fromMiddle <= 1.0 : std::abs(fromEnd + fromMiddle - 20.0) <= 1.5);
            corners += fromEnd <= 3.0 ? 1 : 0;
        }
    }
    QVERIFY(corners >= 4);
}

void ThinningTest::axes_keepComponentsAndHoles()
{
    for (const Points& points : {heart(), arch(), swan(), letterE(), letterS(), circle(1.0)}) {
        const EnvelopeField field = fieldOf(points, 150);
        const Mask mask = insideOf(field);
        for (std::size_t i = 0; i < mask.size(); ++i)
            QVERIFY(field.axes[i] <= mask[i]);
        QCOMPARE(components(field.axes, 1, true), components(mask, 1, true));
        QCOMPARE(components(field.axes, 0, false), components(mask, 0, false));
        QVERIFY(squares(field.axes) <= 3);
    }
}

const TestClass<ThinningTest> thinningTest;

} // namespace espalier::test

#include "ThinningTest.moc"
