// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/AddBuds.h"
#include "commands/BendGesture.h"
#include "commands/DocumentProject.h"
#include "commands/EraseTwigs.h"
#include "commands/KeepClear.h"
#include "commands/LassoGesture.h"
#include "commands/MultiplyBranch.h"
#include "commands/ParameterGesture.h"
#include "commands/PlaceLeaves.h"
#include "commands/PropagateBranch.h"
#include "commands/Prune.h"
#include "commands/SetParameters.h"
#include "commands/TimeGesture.h"
#include "commands/TwistGesture.h"
#include "commands/VaryTree.h"
#include "commands/WidthGesture.h"
#include "model/document/EditFollower.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/PlacedLeaves.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <functional>

namespace espalier::test {

/// What was undone or cancelled leaves no trace: a document that lived through any sequence of edits, undos,
/// redos, travels in time and cancelled gestures equals, byte for byte, one in which the undone and the
/// cancelled never happened; and so does one that plays the recipe of its history.
class UndoPropertyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anySequence_equalsTheOneWithoutWhatWasUndone();
    void follower_repeatsAnySequence();
    void undoneGrowth_neitherFillsTheFileNorTheMemory();
    void cancelledGesture_doesNotChangeWhatGrowsNext();
    void gestureAtAnEarlierMoment_isSavedAndReadAgain();
};

namespace {

using Action = std::function<void(TreeDocument&)>;

QByteArray packed(const TreeDocument& document)
{
    const Result<QByteArray> bytes = packProject(projectOf(document, QStringLiteral("Tree")));
    if (!bytes)
        qFatal("%s", qPrintable(bytes.error().message));
    return *bytes;
}

/// A document with random edits, undos and cancelled gestures, and the list of the edits that count.
class Undecided {
public:
    /// @p listener hears of all edits.
    explicit Undecided(std::uint64_t seed, EditListener listener = {})
        : m_random(seed, 0, 0, Purpose::ShootLength), m_seed(seed), m_isHeard(listener != nullptr)
    {
        TreeParameters parameters;
        parameters.growth.lateralsPerNode = 1 + below(2);
        parameters.growth.irregularity = 0.4;
        parameters.growth.shedding = 0.1;
        m_parameters = parameters;
        m_document.reset(m_seed, m_parameters);
        m_document.setEditListener(std::move(listener));
    }

    /// As it was before the first edit.
    void plant(TreeDocument& document) const { document.reset(m_seed, m_parameters); }

    void act()
    {
        switch (below(9)) {
        case 0:
        case 1:
            if (m_index > 0)
                goTo(m_index - 1);
            break;
        case 2:
            if (m_index < m_entries.size())
                goTo(m_index + 1);
            break;
        case 3:
            goTo(static_cast<std::size_t>(below(static_cast<int>(m_entries.size()) + 1)));
            break;
        case 4:
            m_document.interruptEdit();
            cancelSomething();
            break;
        default:
            m_document.interruptEdit();
            doSomething(randomAction());
        }
    }

    const TreeDocument& document()
    {
        m_document.interruptEdit();
        return m_document;
    }

    /// Performs only the edits that count.
    void replay(TreeDocument& document) const
    {
        plant(document);
        for (std::size_t i = 0; i < m_index; ++i) {
            for (const Action& action : m_entries[i])
                action(document);
        }
    }

private:
    int below(int count) { return static_cast<int>(m_random.bits() % static_cast<std::uint64_t>(count)); }
    InternodeId living()
    {
        for (;;) {
            const auto id = static_cast<InternodeId>(below(static_cast<int>(m_document.tree().size())));
            if (m_document.tree().isAlive(id))
                return id;
        }
    }
    std::size_t somewhere() const { return m_document.journal().size() + m_document.future().size(); }

    /// Undoes and redoes: at once if a listener is to hear of it, otherwise in slices, some of them only when
    /// the next edit interrupts it.
    void goTo(std::size_t index)
    {
        m_index = index;
        if (m_isHeard) {
            while (m_document.undoStack().index() > static_cast<int>(index))
                m_document.undo();
            while (m_document.undoStack().index() < static_cast<int>(index))
                m_document.redo();
            return;
        }
        m_undo = std::make_unique<GradualUndo>(m_document, static_cast<int>(index));
        for (int slices = below(8); slices > 0 && m_undo->advance(std::chrono::milliseconds(0), 1);
             --slices) {
        }
    }

    /// A step of the stack is what lies between two indices; travels in a row, and what follows one, join.
    void doSomething(const Action& action)
    {
        const int before = m_document.undoStack().index();
        const std::uint64_t revision = m_document.revision();
        action(m_document);
        const int after = m_document.undoStack().index();
        if (after == before && m_document.revision() == revision)
            return;
        m_entries.resize(static_cast<std::size_t>(std::min(before, after)));
        if (after > before)
            m_entries.push_back({action});
        else if (after == before && before > 0)
            m_entries.back().push_back(action);
        m_index = m_entries.size();
    }

    Action randomAction()
    {
        const bool isLarge = m_document.index().livingCount() > 220;
        switch (below(isLarge ? 5 : 10)) {
        case 0:
            return [cut = living()](TreeDocument& document) { pruneBranches(document, std::span(&cut, 1)); };
        case 1:
            if (below(2) == 0) {
                const auto scope = below(2) == 0 ? TwistScope::Branch : TwistScope::Subtree;
                return [id = living(), scope, angle = 10.0 * (below(7) - 3)](TreeDocument& document) {
                    twistBranch(document, id, scope, angle);
                };
            }
            return [id = living(), diameter = m_random.uniform(-0.01, 0.1)](TreeDocument& document) {
                setWidth(document, id, diameter);
            };
        case 2: {
            const InternodeId id = living();
            const Vec3 target = m_document.index().nodePosition(id) + 0.2F * m_random.inBall();
            return [id, target](TreeDocument& document) {
                BendGesture gesture(document, 0, {{id, 1.0}});
                gesture.settleAt(std::span(&target, 1));
                gesture.finish();
            };
        }
        case 3: {
            TreeParameters parameters = m_document.parameters();
            parameters.growth.branchingAngle = radians(30 + 10 * below(4));
            return [parameters](TreeDocument& document) { setParameters(document, parameters); };
        }
        case 4:
            return [position = static_cast<std::size_t>(below(static_cast<int>(somewhere()) + 1))](
                       TreeDocument& document) { travel(document, position); };
        case 5:
            return lasso();
        case 6: {
            const std::vector<BrushSample> stroke =
                randomStroke(m_random, m_document.parameters().growth, 0.4);
            return [stroke](TreeDocument& document) { brush(document, stroke); };
        }
        case 7: {
            if (below(2) == 0)
                return copying();
            if (below(2) == 0)
                return clearing();
            const BudSpiral spiral{.internode = living(),
                                   .along = m_random.uniform(),
                                   .count = 1 + below(4),
                                   .spacing = 0.1 * m_random.uniform()};
            return [spiral](TreeDocument& document) { addBuds(document, spiral); };
        }
        case 8: {
            const std::uint32_t leaves = m_document.tree().placedLeaves().size();
            const InternodeId id = leaves > 0 && below(3) > 0
                                       ? m_document.tree().placedLeaves().internode[leaves - 1]
                                       : living();
            const auto along = static_cast<float>(m_random.uniform());
            if (below(2) == 0) {
                const LeafRow leaf = leafAround(id, along, m_random.uniform(0.0, 6.0));
                return [leaf](TreeDocument& document) { placeLeaf(document, leaf); };
            }
            const LeafEngine engine = kLeafEngines[static_cast<std::size_t>(below(5))];
            return [id, along, engine](TreeDocument& document) {
                arrangeLeaves(document, engine, {id, along});
            };
        }
        default:
            return [steps = 1 + below(2)](TreeDocument& document) { grow(document, steps); };
        }
    }

    Action clearing()
    {
        if (below(2) == 0) {
            return [id = living(), length = 0.05F * static_cast<float>(below(8))](TreeDocument& document) {
                keepClear(document, id, length);
            };
        }
        const Vec3 place = m_document.index().nodePosition(living());
        const SweptTwigs twigs{.sweeps = {{Vec3(0.0F, 0.5F, 5.0F), {{place, 0.05F}}}},
                               .thickest = 0.3 * below(4)};
        if (below(2) == 0)
            return [twigs](TreeDocument& document) { eraseTwigs(document, {twigs}); };
        return [twigs](TreeDocument& document) { thinTwigs(document, {twigs, 0.5}); };
    }

    Action copying()
    {
        const auto seed = static_cast<std::uint64_t>(below(5));
        switch (below(3)) {
        case 0:
            return [id = living(), seed](TreeDocument& document) {
                (void)multiplyBranch(document, id, seed, 2);
            };
        case 1:
            return [id = living(), target = living(), replaces = below(2) == 0](TreeDocument& document) {
                (void)propagateBranch(document, {.reference = id,
                                                 .targets = Propagation::Targets::Listed,
                                                 .axes = {target},
                                                 .scaling = true,
                                                 .replaces = replaces});
            };
        default:
            return [seed](TreeDocument& document) { (void)varyTree(document, seed, 0.2); };
        }
    }

    Action lasso()
    {
        switch (below(3)) {
        case 0: {
            LassoStroke stroke;
            stroke.origin = Vec3(0.0F, 0.2F, 0.0F);
            const auto size = static_cast<float>(m_random.uniform(0.2, 0.4));
            stroke.points = {{-size, 0.0F}, {size, 0.05F}, {size, size}, {-size, size}};
            return [stroke](TreeDocument& document) { fill(LassoGesture::fill(document, stroke)); };
        }
        case 1:
            return [](TreeDocument& document) { fill(LassoGesture::regrow(document)); };
        default:
            return [](TreeDocument& document) { removeEnvelopes(document); };
        }
    }

    static void fill(LassoGesture::Begun begun)
    {
        if (!begun)
            return;
        for (int i = 0; i < 3 && (*begun)->step(); ++i) {
        }
        (*begun)->finish();
    }

    void cancelSomething()
    {
        switch (below(6)) {
        case 0: {
            const std::vector<BrushSample> stroke =
                randomStroke(m_random, m_document.parameters().growth, 0.3);
            BrushGesture gesture(m_document, stroke.front());
            for (const BrushSample& sample : stroke)
                gesture.add(sample);
            gesture.cancel();
            break;
        }
        case 1: {
            GrowGesture gesture(m_document);
            gesture.step();
            gesture.cancel();
            break;
        }
        case 2: {
            if (const LassoGesture::Begun begun = LassoGesture::regrow(m_document)) {
                (*begun)->step();
                (*begun)->cancel();
            }
            break;
        }
        case 3: {
            TimeGesture gesture(m_document);
            gesture.moveTo(static_cast<std::size_t>(below(static_cast<int>(somewhere()) + 1)));
            gesture.moveTo(somewhere() + 1);
            gesture.cancel();
            break;
        }
        case 4: {
            TwistGesture gesture(m_document, living(), TwistScope::Subtree);
            gesture.set(20.0);
            gesture.cancel();
            break;
        }
        default: {
            WidthGesture gesture(m_document, living());
            gesture.set(0.05);
            gesture.cancel();
        }
        }
    }

    Random m_random;
    std::uint64_t m_seed;
    bool m_isHeard;
    TreeParameters m_parameters;
    TreeDocument m_document;
    std::unique_ptr<GradualUndo> m_undo;
    std::vector<std::vector<Action>> m_entries; ///< As the undo stack
    std::size_t m_index = 0;
};

} // namespace

void UndoPropertyTest::anySequence_equalsTheOneWithoutWhatWasUndone()
{
    bool isNumber = false;
    const int asked = qEnvironmentVariableIntValue("ESPALIER_SEQUENCES", &isNumber);
    const auto sequences = static_cast<std::uint64_t>(isNumber ? asked : 1000);
    for (std::uint64_t seed = 1; seed <= sequences; ++seed) {
        Undecided hand(seed);
        for (int i = 0; i < 16; ++i)
            hand.act();
        TreeDocument straight;
        hand.replay(straight);
        const DocumentState wanted(straight);
        const QString difference = differenceFrom(wanted, hand.document());
        // The replay has no steps to be redone, and the same index.
        QVERIFY2(difference.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(difference)));
        QVERIFY2(packed(hand.document()) == packed(straight),
                 qPrintable(QStringLiteral("seed %1").arg(seed)));
        if (seed % 4 != 0)
            continue;
        const QString fault = replayFault(hand.document());
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(fault)));
    }
}

void UndoPropertyTest::follower_repeatsAnySequence()
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        std::vector<EditEvent> events;
        Undecided hand(seed, [&events](EditEvent event) { events.push_back(std::move(event)); });
        TreeDocument document;
        hand.plant(document);
        EditFollower follower(document);
        for (int i = 0; i < 16; ++i) {
            hand.act();
            follower.add(std::exchange(events, {}));
            if (follower.isWaiting())
                follower.advance(std::chrono::milliseconds(0));
        }
        const DocumentState wanted(hand.document());
        follower.add(std::exchange(events, {}));
        while (follower.isWaiting())
            follower.advance(std::chrono::milliseconds(0));
        const QString difference = differenceFrom(wanted, document);
        QVERIFY2(difference.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(difference)));
        QCOMPARE(document.undoStack().count(), hand.document().undoStack().count());
        QCOMPARE(document.undoStack().undoText(), hand.document().undoStack().undoText());
        QCOMPARE(document.undoStack().redoText(), hand.document().undoStack().redoText());
        QVERIFY(packed(document) == packed(hand.document()));
    }
}

void UndoPropertyTest::undoneGrowth_neitherFillsTheFileNorTheMemory()
{
    TreeDocument document;
    document.reset(1);
    grow(document, 8);
    const qsizetype size = packed(document).size();
    const DocumentState before(document);
    std::size_t bytes = 0;
    for (int i = 0; i < 20; ++i) {
        grow(document, 3);
        document.undo();
        // The indices' lists of noted changes reach their final capacity with the second round: its growth
        // settles the changes of the undo before it as well.
        if (i == 1)
            bytes = document.bytes();
    }
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(packed(document).size(), size);
    QVERIFY(document.bytes() <= bytes + bytes / 20);
}

void UndoPropertyTest::cancelledGesture_doesNotChangeWhatGrowsNext()
{
    TreeDocument straight;
    straight.reset(5);
    grow(straight, 6);
    TreeDocument document;
    document.reset(5);
    grow(document, 3);
    BrushGesture gesture(document, {0.0, Vec3(0.0F, 0.5F, 0.0F), 0.4F});
    gesture.add({0.5, Vec3(0.3F, 0.8F, 0.1F), 0.4F});
    gesture.cancel();
    grow(document, 3);
    QVERIFY(document.tree().content().internodes.key == straight.tree().content().internodes.key);
}

void UndoPropertyTest::gestureAtAnEarlierMoment_isSavedAndReadAgain()
{
    TreeDocument document;
    document.reset(2);
    grow(document, 6);
    travel(document, 3);
    QVERIFY(!document.future().empty());
    // In the middle of the gesture, and after it.
    BrushGesture gesture(document, {0.0, Vec3(0.0F, 0.3F, 0.0F), 0.3F});
    gesture.add({0.4, Vec3(0.2F, 0.5F, 0.1F), 0.3F});
    const Result<Project> during = unpackProject(packed(document));
    QVERIFY2(during, during ? "" : qPrintable(during.error().message));
    gesture.finish();
    const Result<Project> after = unpackProject(packed(document));
    QVERIFY2(after, after ? "" : qPrintable(after.error().message));
    document.undo();
    QCOMPARE(document.journal().size(), std::size_t{6});
    QVERIFY(document.future().empty());
}

const TestClass<UndoPropertyTest> undoPropertyTest;

} // namespace espalier::test

#include "UndoPropertyTest.moc"
