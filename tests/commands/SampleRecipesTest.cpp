// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QtTest>

namespace espalier::test {

/// The samples that the program comes with.
class SampleRecipesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void undoingAndRedoingAll_restoresTheDocument_data();
    void undoingAndRedoingAll_restoresTheDocument();
};

namespace {

QByteArray packed(const TreeDocument& document)
{
    const Result<QByteArray> content = packProject({document.tree(), document.journal(), {}, {}});
    return content ? *content : QByteArray();
}

} // namespace

void SampleRecipesTest::undoingAndRedoingAll_restoresTheDocument_data()
{
    QTest::addColumn<QString>("fileName");
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/recipes"));
    const QStringList names = folder.entryList({QStringLiteral("*.json")});
    QVERIFY(names.size() >= 16);
    for (const QString& name : names)
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

void SampleRecipesTest::undoingAndRedoingAll_restoresTheDocument()
{
    QFETCH(const QString, fileName);
    const Result<Recipe> recipe = readRecipe(fileName);
    QVERIFY2(recipe, qPrintable(recipe ? QString() : recipe.error().message));
    TreeDocument document;
    const RecipePlayer seedling(document, *recipe);
    const DocumentState empty(document);

    RecipePlayer player(document, *recipe);
    player.playAll();
    QCOMPARE(player.warnings(), QStringList());
    QVERIFY(document.index().livingCount() > 30);
    const DocumentState whole(document);
    const QByteArray file = packed(document);
    QVERIFY(!file.isEmpty());

    QUndoStack& stack = document.undoStack();
    while (stack.canUndo())
        stack.undo();
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(differenceFrom(empty, document), QString());
    QCOMPARE(indexFault(document), QString());

    while (stack.canRedo())
        stack.redo();
    QVERIFY(DocumentState(document) == whole);
    QCOMPARE(packed(document), file);
    QCOMPARE(indexFault(document), QString());
}

const TestClass<SampleRecipesTest> sampleRecipesTest;

} // namespace espalier::test

#include "SampleRecipesTest.moc"
