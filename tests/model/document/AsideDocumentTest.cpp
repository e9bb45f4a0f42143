// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/AsideDocument.h"

#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class AsideDocumentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatComesBack_isTheSameToTheLastBit_data();
    void whatComesBack_isTheSameToTheLastBit();
    void limitOfUndo_comesBack();
    void exchangedTree_comesBack();
};

void AsideDocumentTest::whatComesBack_isTheSameToTheLastBit_data()
{
    QTest::addColumn<int>("undone");
    QTest::addColumn<bool>("travels");
    QTest::newRow("all done") << 0 << false;
    QTest::newRow("some undone") << 2 << false;
    QTest::newRow("all undone") << 4 << false;
    QTest::newRow("travelled back") << 0 << true;
}

void AsideDocumentTest::whatComesBack_isTheSameToTheLastBit()
{
    QFETCH(int, undone);
    QFETCH(bool, travels);
    TreeDocument document;
    for (int i = 0; i < 4; ++i)
        QVERIFY(grow(document, 3) > 0);
    QUndoStack& stack = document.undoStack();
    const DocumentState whole(document);
    stack.setIndex(3);
    stack.setClean();
    stack.setIndex(4 - undone);
    if (travels)
        travel(document, 4);
    SceneLook look;
    look.gridShown = true;
    document.setLook(look);
    const DocumentState before(document);
    const int count = stack.count();

    AsideDocument aside = AsideDocument::takenFrom(document);
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(indexFault(document), QString());
    QCOMPARE(stack.count(), 0);
    QVERIFY(stack.isClean());
    grow(document, 5);

    aside.bringBackTo(document);
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(stack.count(), count);
    QCOMPARE(stack.cleanIndex(), 3);
    QVERIFY(document.look() == look);
    // Its undo stack works both ways.
    if (travels)
        document.undo();
    while (stack.canRedo())
        document.redo();
    if (!travels)
        QCOMPARE(differenceFrom(whole, document), QString());
    while (stack.canUndo())
        document.undo();
    QVERIFY(document.journal().empty() && document.future().empty());
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(indexFault(document), QString());
    while (stack.canRedo())
        document.redo();
    QCOMPARE(differenceFrom(travels ? before : whole, document), QString());
}

void AsideDocumentTest::exchangedTree_comesBack()
{
    for (const bool isUndone : {false, true}) {
        TreeDocument document;
        grow(document, 3);
        const DocumentState before(document);
        TreeDocument another;
        another.reset(5);
        grow(another, 4);
        document.exchange(PreparedTree(another.tree(), another.journal()), QStringLiteral("Another"));
        const DocumentState exchanged(document);
        if (isUndone)
            document.undo();
        AsideDocument aside = AsideDocument::takenFrom(document);
        grow(document, 2);
        aside.bringBackTo(document);
        QCOMPARE(differenceFrom(isUndone ? before : exchanged, document), QString());
        if (isUndone)
            document.redo();
        QCOMPARE(differenceFrom(exchanged, document), QString());
        document.undo();
        QCOMPARE(differenceFrom(before, document), QString());
        document.redo();
        QCOMPARE(differenceFrom(exchanged, document), QString());
    }
}

void AsideDocumentTest::limitOfUndo_comesBack()
{
    TreeDocument document;
    for (int i = 0; i < 3; ++i)
        QVERIFY(grow(document, 1) > 0);
    AsideDocument aside = AsideDocument::takenFrom(document);
    document.undoStack().setUndoLimit(1);
    aside.bringBackTo(document);
    QCOMPARE(document.undoStack().undoLimit(), 0);
    QCOMPARE(document.undoStack().count(), 3);
}

static const TestClass<AsideDocumentTest> asideDocumentTest;

} // namespace espalier::test

#include "AsideDocumentTest.moc"
