// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"
#include "commands/DocumentProject.h"
#include "commands/SetParameters.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace espalier::test {

/// Strokes that arrive (StrokeEnd), quick and slow.
class BrushArrivalTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void line_arrives_data();
    void line_arrives();
    void corner_betweenTwoStepsOfGrowth_isDrawn();
    void line_farFromTheTree_arrives();
    void tapFarFromATree_growsNothing();
    void quickCrown_growsAsLongAsItsMarkersLive();
    void arrivedStroke_isReplayedToTheBit();
    void lateGrowth_isTheSame();
    void restAtTheEnd_isReplayedToTheBit();
};

namespace {

/// A trunk of two metres and a half, drawn as one axis.
void drawTrunk(TreeDocument& document)
{
    TreeParameters parameters;
    parameters.growth.irregularity = 0.4;
    document.reset(4, parameters);
    brush(document, strokeAlong(std::vector{Vec3(0.0F, 0.0F, 0.0F), Vec3(0.0F, 2.5F, 0.0F)}, 0.0F, 2.0));
    document.undoStack().clear();
}

/// A limb as a person draws it, from a trunk outward and up, in metres a second and events a second.
std::vector<BrushSample> limbStroke(double speed, double rate, float radius)
{
    std::vector<BrushSample> samples;
    constexpr double kLength = 2.2;
    const double duration = kLength / speed;
    const int count = std::max(1, static_cast<int>(duration * rate));
    for (int i = 0; i <= count; ++i) {
        const auto share = static_cast<float>(i) / static_cast<float>(count);
        samples.push_back({duration * static_cast<double>(share),
                           Vec3(2.0F * share, 1.2F + 0.3F * share + 0.6F * share * share, 0.0F), radius});
    }
    return samples;
}

float distanceToNodes(const TreeDocument& document, const Vec3& point)
{
    float nearest = std::numeric_limits<float>::infinity();
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id))
            nearest = std::min(nearest, (document.index().nodePosition(id) - point).norm());
    }
    return nearest;
}

void arrive(TreeDocument& document, std::span<const BrushSample> samples)
{
    BrushGesture gesture(document, samples.front(), {}, StrokeEnd::Arrives);
    for (const BrushSample& sample : samples.subspan(1))
        gesture.add(sample);
    gesture.finish();
}

/// Plays the document's recipe and compares the trees.
void verifyReplay(const TreeDocument& document)
{
    const Result<Recipe> recipe = recipeOf(projectOf(document, QStringLiteral("limb")));
    QVERIFY(recipe);
    TreeDocument replayed;
    RecipePlayer(replayed, *recipe).playAll();
    QVERIFY(replayed.tree() == document.tree());
}

} // namespace

void BrushArrivalTest::line_arrives_data()
{
    QTest::addColumn<double>("speed"); // m/s
    QTest::addColumn<double>("rate");  // Events a second
    QTest::addColumn<double>("radius");
    for (const double radius : {0.0, 0.03, 0.057, 0.09}) {
        for (const double speed : {0.5, 2.0, 5.0, 12.0, 50.0}) {
            for (const double rate : {15.0, 60.0, 250.0})
                QTest::addRow("%g m at %g m/s, %g Hz", radius, speed, rate) << speed << rate << radius;
        }
    }
}

void BrushArrivalTest::line_arrives()
{
    QFETCH(const double, speed);
    QFETCH(const double, rate);
    QFETCH(const double, radius);
    TreeDocument document;
    drawTrunk(document);
    const std::vector<BrushSample> samples = limbStroke(speed, rate, static_cast<float>(radius));
    arrive(document, samples);
    QCOMPARE(document.undoStack().count(), 1);
    const auto internode = static_cast<float>(document.parameters().growth.internodeLength);
    QVERIFY(distanceToNodes(document, samples.back().position) <=
            std::max(1.6F * internode, static_cast<float>(radius)));
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        for (const float share : {0.0F, 0.5F}) {
            const Vec3 point = samples[i].position + share * (samples[i + 1].position - samples[i].position);
            QVERIFY(distanceToNodes(document, point) < 2.5F * internode + static_cast<float>(radius));
        }
    }
}

void BrushArrivalTest::corner_betweenTwoStepsOfGrowth_isDrawn()
{
    TreeDocument document;
    drawTrunk(document);
    // There and back within two steps of growth.
    const Vec3 corner(0.9F, 1.3F, 0.0F);
    const std::array ends{Vec3(0.0F, 1.2F, 0.0F), corner, Vec3(0.3F, 2.1F, 0.0F)};
    std::vector<BrushSample> samples;
    for (int i = 0; i <= 16; ++i) {
        const float share = static_cast<float>(i % 9) / 8.0F;
        const bool isBack = i > 8;
        const float along = isBack ? static_cast<float>(i - 8) / 8.0F : share;
        const Vec3& from = ends[isBack ? 1 : 0];
        samples.push_back({0.005 * i, from + along * (ends[isBack ? 2 : 1] - from), 0.0F});
    }
    arrive(document, samples);
    QVERIFY2(distanceToNodes(document, corner) < 0.15F,
             qPrintable(QString::number(distanceToNodes(document, corner))));
    QVERIFY(distanceToNodes(document, ends[2]) < 0.15F);
}

void BrushArrivalTest::line_farFromTheTree_arrives()
{
    for (const float radius : {0.0F, 0.05F, 0.4F}) {
        TreeDocument document;
        drawTrunk(document);
        const std::vector<BrushSample> samples =
            strokeAlong(std::vector{Vec3(1.5F, 2.0F, 0.0F), Vec3(2.0F, 3.0F, 0.0F)}, radius, 0.3);
        arrive(document, samples);
        QVERIFY2(distanceToNodes(document, samples.back().position) < 0.1F + radius,
                 qPrintable(QString::number(static_cast<double>(radius))));
    }
}

void BrushArrivalTest::tapFarFromATree_growsNothing()
{
    TreeDocument document;
    drawTrunk(document);
    arrive(document, limbStroke(2.0, 60.0, 0.0F));
    const Tree before = document.tree();
    const std::vector<BrushSample> tap{{0.0, Vec3(-2.0F, 3.0F, 0.0F), 0.3F},
                                       {0.15, Vec3(-2.0F, 3.0F, 0.0F), 0.3F}};
    arrive(document, tap);
    QVERIFY(document.tree() == before);
    // The same place is reached by a stroke.
    std::vector<BrushSample> stroke = tap;
    stroke.back().position.x() -= 0.3F;
    arrive(document, stroke);
    QVERIFY(distanceToNodes(document, tap.front().position) < 0.4F);
}

void BrushArrivalTest::quickCrown_growsAsLongAsItsMarkersLive()
{
    const std::vector<BrushSample> samples =
        strokeAlong(std::vector{Vec3(0.0F, 2.2F, 0.0F), Vec3(1.2F, 2.8F, 0.0F)}, 0.5F, 0.2);
    TreeDocument stopped;
    drawTrunk(stopped);
    const std::uint32_t trunk = stopped.tree().size();
    TreeDocument arrived;
    drawTrunk(arrived);
    brush(stopped, samples);
    arrive(arrived, samples);
    QVERIFY(2 * (arrived.tree().size() - trunk) > 3 * (stopped.tree().size() - trunk));
    QVERIFY(distanceToNodes(arrived, samples.back().position) < 0.5F);
}

void BrushArrivalTest::arrivedStroke_isReplayedToTheBit()
{
    for (const double speed : {1.0, 9.0}) {
        TreeDocument document;
        drawTrunk(document);
        arrive(document, limbStroke(speed, 60.0, 0.057F));
        const Result<Recipe> recipe = recipeOf(projectOf(document, QStringLiteral("limb")));
        QVERIFY(recipe);
        verifyReplay(document);
        // In the pace of a demonstration as well.
        TreeDocument paced;
        RecipePlayer player(paced, *recipe);
        while (!player.isDone())
            player.advance(0.013);
        QVERIFY(paced.tree() == document.tree());
    }
}

void BrushArrivalTest::lateGrowth_isTheSame()
{
    // A hand's samples, with a rest, on machines that grow at once, late, or only after the stroke.
    std::vector<BrushSample> samples = limbStroke(4.0, 60.0, 0.057F);
    BrushSample rested = samples.back();
    rested.time += 0.7;
    rested.position.y() += 0.2F;
    samples.push_back(rested);
    std::optional<Tree> first;
    for (const int load : {0, 1, 2, 3}) {
        TreeDocument document;
        drawTrunk(document);
        BrushGesture gesture(document, samples.front(), {}, StrokeEnd::Arrives);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const double pause = samples[i].time - samples[i - 1].time;
            for (double tick = 0.017 + 0.003 * load; load < 2 && tick < pause; tick += 0.02) {
                gesture.rest(samples[i - 1].time + tick);
                gesture.catchUp(std::chrono::seconds(1));
            }
            gesture.follow(samples[i]);
            if (load == 0)
                gesture.catchUp(std::chrono::seconds(1));
            else if (load == 2 && i % 5 == 0)
                gesture.catchUp(std::chrono::nanoseconds(1));
        }
        gesture.finish();
        QVERIFY(document.tree().size() > 45);
        if (!first)
            first = document.tree();
        QVERIFY(document.tree() == *first);
        verifyReplay(document);
    }
}

void BrushArrivalTest::restAtTheEnd_isReplayedToTheBit()
{
    TreeDocument document;
    drawTrunk(document);
    const std::vector<BrushSample> samples = limbStroke(2.0, 60.0, 0.3F);
    BrushGesture gesture(document, samples.front(), {}, StrokeEnd::Arrives);
    for (const BrushSample& sample : std::span(samples).subspan(1))
        gesture.follow(sample);
    gesture.catchUp(std::chrono::seconds(1));
    const std::uint32_t before = document.tree().size();
    gesture.rest(samples.back().time + 0.8);
    gesture.catchUp(std::chrono::seconds(1));
    QVERIFY(document.tree().size() > before);
    // Another edit ends it, without a sample of the hand.
    TreeParameters others = document.parameters();
    others.growth.irregularity = 0.3;
    setParameters(document, others);
    verifyReplay(document);
}

static const TestClass<BrushArrivalTest> brushArrivalTest;

} // namespace espalier::test

#include "BrushArrivalTest.moc"
