// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"
#include "panels/Actions.h"
#include "panels/HelpPage.h"
#include "panels/HelpPanel.h"
#include "panels/ParameterTexts.h"
#include "panels/Theme.h"
#include "tests/support/TestClasses.h"

#include <QApplication>
#include <QChar>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QIODevice>
#include <QImage>
#include <QLatin1Char>
#include <QLocale>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QUrl>

using namespace espalier;

namespace {

constexpr const char* kRoot = ":/docs/help/en";

QStringList pageNames()
{
    QStringList names;
    for (const QString& file : QDir(QString::fromLatin1(kRoot)).entryList({QStringLiteral("*.md")}))
        names.append(file.chopped(3));
    return names;
}

QString nameOf(ActionId id)
{
    return QString::fromLatin1(Actions::table()[static_cast<std::size_t>(id)].name);
}

QString read(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

/// The pages of the help: complete, correct and found by the program.
class HelpPagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { theme::apply(*qApp); }
    void contents_haveEveryPageAndNoOther();
    void pages_havePicturesAndNoDeadLinks_data();
    void pages_havePicturesAndNoDeadLinks();
    void subjects_haveAPageWithAPictureAndARecipe();
    void recipes_doSomethingInEachOperation_data();
    void recipes_doSomethingInEachOperation();
    void keysPage_hasEveryShortcut();
    void sheetPages_haveEveryParameter();
    void language_fallsBackToEnglish();
    void search_findsTitlesFirst();

private:
    HelpPanel& help() { return m_help; }
    template <class Widget>
    Widget* part(const char* name)
    {
        return help().findChild<Widget*>(QString::fromLatin1(name));
    }

    HelpPanel m_help;
};

void HelpPagesTest::contents_haveEveryPageAndNoOther()
{
    QStringList listed;
    for (const HelpBook::Section& section : help().book().contents()) {
        for (const HelpBook::Entry& entry : section.entries)
            listed.append(entry.page);
    }
    QCOMPARE(listed.value(0), HelpBook::kIndex);
    listed.sort();
    QCOMPARE(listed, pageNames());
}

void HelpPagesTest::pages_havePicturesAndNoDeadLinks_data()
{
    QTest::addColumn<QString>("page");
    for (const QString& name : pageNames())
        QTest::newRow(qPrintable(name)) << name;
}

void HelpPagesTest::pages_havePicturesAndNoDeadLinks()
{
    QFETCH(QString, page);
    help().showPage(page);
    QCOMPARE(help().page(), page);
    auto* shown = part<HelpPage>("helpPage");
    QVERIFY(shown->document()->begin().blockFormat().headingLevel() == 1);
    for (const QString& name : shown->pictures()) {
        const QString file = QLatin1Char(':') + shown->url().resolved(QUrl(name)).path();
        const QImage picture(file);
        QVERIFY2(!picture.isNull(), qPrintable(name));
        QVERIFY2(picture.width() <= 640 && QFileInfo(file).size() < 100'000, qPrintable(name));
    }
    for (const QString& link : shown->links()) {
        QString file = shown->url().resolved(QUrl(link)).path();
        QVERIFY2(QFile::exists(QStringLiteral(SOURCE_DIR) + file), qPrintable(link)); // As on the web
        file.replace(QStringLiteral("/resources/"), QStringLiteral("/"));
        QVERIFY2(QFile::exists(QLatin1Char(':') + file), qPrintable(link));
    }
}

void HelpPagesTest::subjects_haveAPageWithAPictureAndARecipe()
{
    std::vector<ActionId> subjects(Actions::tools().begin(), Actions::tools().end());
    for (const ActionId id :
         {ActionId::Architecture, ActionId::LeafSheet, ActionId::BranchSheet, ActionId::History})
        subjects.push_back(id);
    for (const ActionId id : subjects) {
        const QString page = nameOf(id);
        help().showPage(page);
        QVERIFY2(help().page() == page, qPrintable(page));
        QVERIFY2(!part<HelpPage>("helpPage")->pictures().isEmpty(), qPrintable(page));
        QVERIFY2(help().recipe().endsWith(QStringLiteral("/%1.json").arg(page)), qPrintable(help().recipe()));
        QVERIFY(part<QPushButton>("helpPlay")->isVisibleTo(&help()));
    }
}

void HelpPagesTest::recipes_doSomethingInEachOperation_data()
{
    QTest::addColumn<QString>("file");
    const QDir folder(QStringLiteral(":/docs/help/recipes"));
    QVERIFY(folder.entryList().size() > 10);
    for (const QString& name : folder.entryList())
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

void HelpPagesTest::recipes_doSomethingInEachOperation()
{
    QFETCH(QString, file);
    const Result<Recipe> recipe = readRecipe(file);
    QVERIFY2(recipe, recipe ? "" : qPrintable(recipe.error().message));
    QVERIFY(!recipe->name.isEmpty() && !recipe->description.isEmpty());
    TreeDocument document;
    RecipePlayer player(document, *recipe);
    for (std::size_t i = 0; i < recipe->operations.size(); ++i) {
        const Tree before = document.tree();
        player.playOperation();
        QVERIFY2(!(document.tree() == before), qPrintable(QStringLiteral("operations[%1]").arg(i)));
    }
    QVERIFY(player.isDone());
    QCOMPARE(player.warnings(), QStringList());
    QVERIFY(document.index().livingCount() > 100);
}

void HelpPagesTest::keysPage_hasEveryShortcut()
{
    const QStringList lines =
        read(QStringLiteral("%1/keys.md").arg(QString::fromLatin1(kRoot))).split(QLatin1Char('\n'));
    for (const ActionEntry& entry : Actions::table()) {
        QString text = QString::fromUtf8(entry.text).remove(QChar(0x2026));
        for (const QString& key : QString::fromLatin1(entry.shortcuts).split(QStringLiteral("; "))) {
            const bool isThere =
                key.isEmpty() || std::ranges::any_of(lines, [&](const QString& line) {
                    return line.contains(text) && line.contains(QLatin1Char('`') + key + QLatin1Char('`'));
                });
            QVERIFY2(
                isThere,
                qPrintable(
                    QStringLiteral("docs/help/en/keys.md lacks a line with \"%1\" and `%2`").arg(text, key)));
        }
    }
}

void HelpPagesTest::sheetPages_haveEveryParameter()
{
    for (const ParameterSection& section : parameterSections()) {
        const char* name = section.sheet == ParameterSheet::Architecture ? "architecture"
                           : section.sheet == ParameterSheet::Brush      ? "brush"
                           : section.sheet == ParameterSheet::Leaves     ? "leafSheet"
                                                                         : "branchSheet";
        const QString page =
            read(QStringLiteral("%1/%2.md").arg(QString::fromLatin1(kRoot), QString::fromLatin1(name)));
        for (const ParameterText& text : section.parameters) {
            QVERIFY2(page.contains(QString::fromUtf8(text.label)),
                     qPrintable(QStringLiteral("docs/help/en/%1.md says nothing of \"%2\"")
                                    .arg(QString::fromLatin1(name), QString::fromUtf8(text.label))));
        }
    }
}

void HelpPagesTest::language_fallsBackToEnglish()
{
    QTemporaryDir folder;
    QDir root(folder.path());
    const auto write = [&](const char* name, const QByteArray& text) {
        root.mkpath(QFileInfo(QString::fromLatin1(name)).path());
        QFile file(root.filePath(QString::fromLatin1(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write("en/index.md", "# Welcome\n\n- [Brush](brush.md)\n- [Prune](prune.md)\n");
    write("en/brush.md", "# Brush\n");
    write("en/prune.md", "# Prune\n");
    write("de/index.md", "# Willkommen\n\n- [Pinsel](brush.md)\n- [Schneiden](prune.md)\n");
    write("de/brush.md", "# Pinsel\n");
    const HelpBook german(QLocale(QStringLiteral("de_AT")), folder.path());
    QCOMPARE(german.title(QStringLiteral("brush")), QStringLiteral("Pinsel"));
    QVERIFY(german.url(QStringLiteral("brush")).path().endsWith(QStringLiteral("/de/brush.md")));
    QVERIFY(german.url(QStringLiteral("prune")).path().endsWith(QStringLiteral("/en/prune.md")));
    QVERIFY(german.url(QStringLiteral("none")).isEmpty());
    const HelpBook french(QLocale(QStringLiteral("fr_FR")), folder.path());
    QCOMPARE(french.title(QStringLiteral("index")), QStringLiteral("Welcome"));
}

void HelpPagesTest::search_findsTitlesFirst()
{
    const HelpBook& book = help().book();
    QCOMPARE(book.find(QStringLiteral("PRUNE")).value(0), QStringLiteral("prune"));
    QVERIFY(book.find(QStringLiteral("prune")).contains(QStringLiteral("keys")));
    QCOMPARE(book.find(QStringLiteral("apical  domin")).value(0), QStringLiteral("architecture"));
    QVERIFY(!book.find(QStringLiteral("rush")).contains(QStringLiteral("brush"))); // Only beginnings of words
    QVERIFY(book.find(QStringLiteral("zeppelin")).isEmpty());
}

static const test::TestClass<HelpPagesTest> helpPagesTest;

#include "HelpPagesTest.moc"
