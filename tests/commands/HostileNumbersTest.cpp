// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

/// For all values that a user can set, growth does not crash or hang, and gives every node a valid place.
class HostileNumbersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachParameter_atEitherEnd_growsSoundly_data();
    void eachParameter_atEitherEnd_growsSoundly();
    void manyParameters_atTheirEnds_growSoundly();
    void strokesOfAllSizesAndPlaces_growSoundly();
    void strokeOfManySamplesInOnePlace_growsSoundly();
};

namespace {

enum class End { Minimum, Maximum };

/// Sets the growth parameter of index @p which to its lowest or highest value.
void setToEnd(TreeParameters& parameters, int which, End end)
{
    int i = 0;
    visitParameters(parameters, [&]<class T>(const ParameterInfo& info, T& field) {
        if (i++ == which) {
            const double value = end == End::Minimum ? info.minimum : info.maximum;
            field = static_cast<T>(info.quantity == Quantity::Angle ? radians(value) : value);
        }
    });
}

int growthParameterCount()
{
    int count = 0;
    TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, auto&) {
        count += QLatin1String(info.key).startsWith(QLatin1String("growth.")) ? 1 : 0;
    });
    return count;
}

QString keyOf(int which)
{
    QString key;
    int i = 0;
    TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, auto&) {
        if (i++ == which)
            key = QString::fromLatin1(info.key);
    });
    return key;
}

/// A fault of the tree after a stroke and some steps without a brush; empty if there is none.
QString growAndJudge(const TreeParameters& parameters, std::uint64_t seed)
{
    TreeDocument document;
    document.reset(seed, parameters);
    brush(document, strokeAlong(std::vector{Vec3(0.0F, 0.3F, 0.0F), Vec3(0.3F, 0.9F, 0.1F)}, 0.4F, 1.0));
    grow(document, 3);
    const Tree& tree = document.tree();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!document.index().nodePosition(id).allFinite() ||
            std::abs(document.index().rotation(id).coeffs().norm() - 1.0F) > 1e-3F)
            return QStringLiteral("internode %1 is nowhere").arg(id);
        if (!(tree.vigour(id) >= 0.0F && tree.vigour(id) <= 1.0F))
            return QStringLiteral("the vigour of internode %1 is out of range").arg(id);
    }
    const Result<Tree> read = Tree::fromContent(tree.content());
    if (!read)
        return read.error().message;
    while (document.undoStack().canUndo())
        document.undoStack().undo();
    if (document.index().livingCount() != 1)
        return QStringLiteral("it cannot be undone");
    return {};
}

} // namespace

void HostileNumbersTest::eachParameter_atEitherEnd_growsSoundly_data()
{
    QTest::addColumn<int>("which");
    QTest::addColumn<bool>("isMaximum");
    for (int which = 0; which < growthParameterCount(); ++which) {
        for (const bool isMaximum : {false, true})
            QTest::addRow("%s %s", isMaximum ? "greatest" : "least", qPrintable(keyOf(which)))
                << which << isMaximum;
    }
}

void HostileNumbersTest::eachParameter_atEitherEnd_growsSoundly()
{
    QFETCH(int, which);
    QFETCH(bool, isMaximum);
    TreeParameters parameters;
    setToEnd(parameters, which, isMaximum ? End::Maximum : End::Minimum);
    QCOMPARE(growAndJudge(parameters, 1), QString());
}

void HostileNumbersTest::manyParameters_atTheirEnds_growSoundly()
{
    const int count = growthParameterCount();
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed, 0, 0, Purpose::ShootLength);
        TreeParameters parameters;
        QStringList changes;
        for (int which = 0; which < count; ++which) {
            if (random.uniform() < 0.5)
                continue;
            const End end = random.uniform() < 0.5 ? End::Minimum : End::Maximum;
            setToEnd(parameters, which, end);
            changes << (end == End::Minimum ? QStringLiteral("least %1") : QStringLiteral("greatest %1"))
                           .arg(keyOf(which));
        }
        const QString fault = growAndJudge(parameters, seed);
        QVERIFY2(fault.isEmpty(),
                 qPrintable(fault + QStringLiteral(": ") + changes.join(QStringLiteral(", "))));
    }
}

void HostileNumbersTest::strokesOfAllSizesAndPlaces_growSoundly()
{
    for (const float radius : {0.0F, 1e-6F, 0.05F, 0.5F, 5.0F, 100.0F}) {
        for (const Vec3& place : {Vec3(0.0F, 0.0F, 0.0F), Vec3(0.0F, -3.0F, 0.0F), Vec3(0.0F, 0.1F, 0.0F),
                                  Vec3(3.0F, 5.0F, -2.0F), Vec3(1000.0F, 1000.0F, -1000.0F)}) {
            TreeDocument document;
            brush(document,
                  strokeAlong(std::vector{place, Vec3(place + Vec3(0.5F, 0.5F, 0.0F))}, radius, 0.5));
            grow(document, 2);
            for (InternodeId id = 0; id < document.tree().size(); ++id)
                QVERIFY(document.index().nodePosition(id).allFinite());
            QCOMPARE(TreeIndex(document.tree()).livingCount(), document.index().livingCount());
        }
    }
}

void HostileNumbersTest::strokeOfManySamplesInOnePlace_growsSoundly()
{
    for (const float radius : {0.0F, 0.3F}) {
        TreeDocument document;
        const Vec3 place(0.0F, 0.1F, 0.0F); // where the seedling's bud is
        BrushGesture gesture(document, {0.0, place, radius});
        for (int i = 1; i <= 400; ++i)
            gesture.add({i * 0.001, place, radius});
        gesture.finish();
        for (InternodeId id = 0; id < document.tree().size(); ++id)
            QVERIFY(document.index().nodePosition(id).allFinite());
    }
}

const TestClass<HostileNumbersTest> hostileNumbersTest;

} // namespace espalier::test

#include "HostileNumbersTest.moc"
