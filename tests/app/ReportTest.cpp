// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/Recipe.h"
#include "panels/ReportSheet.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QPushButton>
#include <QTest>

using namespace espalier;

/// What a user copies to report a problem.
class ReportTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void report_isCopiedWithTheRecipeIfWanted();
};

void ReportTest::report_isCopiedWithTheRecipeIfWanted()
{
    QTRY_VERIFY(viewport().isAtRest());
    m_window->growRunner().run(2);
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    action(ActionId::Report)->trigger();
    auto* sheet = m_window->findChild<ReportSheet*>();
    QVERIFY(sheet);
    QVERIFY(QTest::qWaitForWindowExposed(sheet));
    for (const char* fact : {"Espalier ", "Qt 6", "OpenGL", "internodes", "Log:"})
        QVERIFY2(sheet->text().contains(QLatin1String(fact)), fact);
    QVERIFY(!sheet->text().contains(QStringLiteral("\"op\"")));
    auto* copy = sheet->findChild<QPushButton*>(QStringLiteral("reportCopy"));
    QTest::mouseClick(copy, Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), sheet->text());

    auto* withRecipe = sheet->findChild<QCheckBox*>(QStringLiteral("reportRecipe"));
    QTest::mouseClick(withRecipe, Qt::LeftButton, {}, {10, withRecipe->height() / 2});
    QVERIFY(withRecipe->isChecked());
    const QString text = sheet->text();
    const QByteArray recipe = text.mid(text.indexOf(QStringLiteral("Recipe:\n")) + 8).toUtf8();
    const Result<Recipe> read = parseRecipe(recipe);
    QVERIFY2(read, read ? "" : qPrintable(read.error().message));
    QTest::mouseClick(copy, Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), text);
    sheet->close();
    m_window->document().undoStack().setClean();
}

static const test::TestClass<ReportTest> reportTest;

#include "ReportTest.moc"
