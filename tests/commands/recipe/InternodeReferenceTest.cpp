// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/InternodeReference.h"

#include "commands/recipe/BrushStrokeOperation.h"
#include "commands/recipe/RecipePlayer.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QJsonDocument>
#include <QTest>

namespace espalier::test {

/// How a recipe names an internode, and how it is found again.
class InternodeReferenceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void number_namesTheRow();
    void key_isFoundBeforeThePlace();
    void place_isFoundWhereTheKeyIsGone();
    void whatIsNowhere_isNamed();
    void json_roundTrips();
    void wrongJson_isRefused_data();
    void wrongJson_isRefused();
    void editedPast_isStillFound_data();
    void editedPast_isStillFound();
};

void InternodeReferenceTest::number_namesTheRow()
{
    TreeDocument document;
    grow(document, 4);
    QCOMPARE(*InternodeReference(2U).resolve(document), 2U);
    const Result<InternodeId> none = InternodeReference(100'000U).resolve(document);
    QVERIFY(!none);
    QCOMPARE(none.error().message, QStringLiteral("there is no internode 100000"));
}

void InternodeReferenceTest::key_isFoundBeforeThePlace()
{
    TreeDocument document;
    growAtRandom(document, 3);
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (!document.tree().isAlive(id))
            continue;
        QCOMPARE(*InternodeReference::to(document, id).resolve(document), id);
        const InternodeReference elsewhere(document.tree().key(id), Vec3(100.0F, 100.0F, 100.0F));
        QCOMPARE(*elsewhere.resolve(document), id);
    }
}

void InternodeReferenceTest::place_isFoundWhereTheKeyIsGone()
{
    TreeDocument document;
    growAtRandom(document, 4);
    InternodeId tip = document.tree().size() - 1;
    while (!document.tree().isAlive(tip))
        --tip;
    const Vec3 beside = document.index().nodePosition(tip) + Vec3(0.0F, 1e-4F, 0.0F);
    QCOMPARE(*InternodeReference(InternodeKey{1}, beside).resolve(document), tip);
    QCOMPARE(*InternodeReference(std::nullopt, beside).resolve(document), tip);
}

void InternodeReferenceTest::whatIsNowhere_isNamed()
{
    const TreeDocument document;
    const Result<InternodeId> noKey =
        InternodeReference(InternodeKey{0xabcd}, std::nullopt).resolve(document);
    QVERIFY(!noKey);
    QCOMPARE(noKey.error().message, QStringLiteral("there is no internode with the key 000000000000abcd"));
    const Result<InternodeId> noPlace =
        InternodeReference(InternodeKey{0xabcd}, Vec3(1.5F, 20.0F, 0.0F)).resolve(document);
    QVERIFY(!noPlace);
    QCOMPARE(noPlace.error().message, QStringLiteral("there is no internode near (1.5, 20, 0) m"));
}

void InternodeReferenceTest::json_roundTrips()
{
    const InternodeReference references[] = {
        InternodeReference(17U), InternodeReference(InternodeKey{0xfedcba9876543210}, std::nullopt),
        InternodeReference(std::nullopt, Vec3(0.1F, 2.5F, -3.0F)),
        InternodeReference(InternodeKey{5}, Vec3(0.1F, 2.5F, -3.0F))};
    for (const InternodeReference& reference : references) {
        const Result<InternodeReference> read = InternodeReference::fromJson(reference.toJson());
        QVERIFY2(read, read ? "" : qPrintable(read.error().message));
        QVERIFY(*read == reference);
    }
}

void InternodeReferenceTest::wrongJson_isRefused_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* json, const char* message) {
        QTest::newRow(json) << QByteArray(json) << QString::fromLatin1(message);
    };
    row("[-1]", "a whole number from 0");
    row("[\"seven\"]", "a whole number from 0");
    row("[{}]", "a key");
    row("[{\"key\": \"12\"}]", "key: 16 hexadecimal digits");
    row("[{\"key\": \"zzzzzzzzzzzzzzzz\"}]", "key: 16 hexadecimal digits");
    row("[{\"at\": [1, 2]}]", "at: an array of three numbers");
    row("[{\"at\": [1, 2, 3], \"on\": 1}]", "");
}

void InternodeReferenceTest::wrongJson_isRefused()
{
    QFETCH(const QByteArray, json);
    QFETCH(const QString, message);
    const Result<InternodeReference> read =
        InternodeReference::fromJson(QJsonDocument::fromJson(json).array().first());
    QVERIFY(!read);
    QVERIFY2(read.error().message.contains(message), qPrintable(read.error().message));
}

void InternodeReferenceTest::editedPast_isStillFound_data()
{
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"candelabra", "cherry", "acacia"})
        QTest::newRow(sample) << QString::fromLatin1(sample);
}

/// Shifts the first stroke of a sample by 2 cm, and looks for references to branches all over the tree in the
/// changed tree. A branch is found if the internode lies at the same place, within a few internodes.
void InternodeReferenceTest::editedPast_isStillFound()
{
    QFETCH(const QString, sample);
    Result<Recipe> recipe = readRecipe(QStringLiteral(":/recipes/%1.json").arg(sample));
    QVERIFY(recipe);
    TreeDocument before;
    RecipePlayer(before, *recipe).playAll();
    // All branches of ten internodes or more, by their first internodes.
    std::vector<InternodeId> meant;
    for (InternodeId id = 1; id < before.tree().size(); ++id) {
        if (before.tree().isAlive(id) && before.index().axis(id) == id &&
            before.index().subtreeSize(id) >= 10)
            meant.push_back(id);
    }
    QVERIFY(meant.size() > 20);

    const auto* const first = recipe->operations.front().as<BrushStrokeOperation>();
    QVERIFY(first);
    BrushStrokeOperation shifted = *first;
    for (BrushSample& each : shifted.samples)
        each.position += Vec3(0.02F, 0.0F, 0.0F);
    recipe->operations.front() = shifted;
    TreeDocument after;
    RecipePlayer(after, *recipe).playAll();
    const float reach =
        InternodeReference::kReach * static_cast<float>(after.parameters().growth.internodeLength);
    std::size_t byKey = 0;
    std::size_t byPlace = 0;
    for (const InternodeId id : meant) {
        const Vec3 place = before.index().nodePosition(id);
        const Result<InternodeId> found = InternodeReference::to(before, id).resolve(after);
        if (!found)
            continue;
        const bool hasKey = after.tree().key(*found) == before.tree().key(id);
        if (hasKey)
            ++byKey;
        else if ((after.index().nodePosition(*found) - place).norm() <= reach)
            ++byPlace;
    }
    const std::size_t found = byKey + byPlace;
    qInfo("%s: of %zu branches %zu are found by key, %zu by place, %zu not", qPrintable(sample), meant.size(),
          byKey, byPlace, meant.size() - found);
    QVERIFY(10 * found >= 9 * meant.size());
}

const TestClass<InternodeReferenceTest> internodeReferenceTest;

} // namespace espalier::test

#include "InternodeReferenceTest.moc"
