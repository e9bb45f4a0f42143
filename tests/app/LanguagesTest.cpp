// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"
#include "app/Language.h"
#include "app/MainWindow.h"
#include "app/Workspace.h"
#include "panels/HelpPanel.h"
#include "panels/Notice.h"
#include "panels/SettingsSheet.h"
#include "panels/Theme.h"
#include "tests/support/TestClasses.h"
#include "views/Viewport.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

namespace espalier {

/// The window in each of its languages.
class LanguagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void language_changesAtOnceAndKeepsAll();
    void language_changesWhileASamplePlays();
    void lettersWithoutAFont_areSaidAndEnglishIsOffered();
    void texts_haveRoom_data();
    void texts_haveRoom();
    void help_isWhole_data();
    void help_isWhole();
    void textsOfQt_areBuiltIn_data();
    void textsOfQt_areBuiltIn();
};

namespace {

QStringList languages()
{
    QStringList found;
    for (const QString& name :
         QDir(QStringLiteral(SOURCE_DIR "/translations")).entryList({QStringLiteral("*.ts")}))
        found << name.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
    return found;
}

/// The texts of @p window that are cut off, one line each.
QStringList cutOff(const QWidget& window)
{
    QStringList found;
    const auto check = [&](const QWidget& widget, const QString& text) {
        if (!text.isEmpty() && widget.isVisible() && widget.width() < widget.minimumSizeHint().width())
            found << QStringLiteral("%1 has %2 of %3 px")
                         .arg(text)
                         .arg(widget.width())
                         .arg(widget.minimumSizeHint().width());
    };
    for (const QLabel* label : window.findChildren<QLabel*>())
        check(*label, label->wordWrap() ? QString() : label->text());
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        if (!tool || tool->toolButtonStyle() == Qt::ToolButtonTextOnly)
            check(*button, button->text());
        // A text under an icon is shortened rather than cut off.
        else if (tool->isVisible() && tool->toolButtonStyle() == Qt::ToolButtonTextUnderIcon &&
                 tool->width() < tool->fontMetrics().horizontalAdvance(tool->text()))
            found << tool->text() + QStringLiteral(" is shortened");
    }
    return found;
}

/// All texts in @p window, also those for screen readers; of the history only the frame.
QStringList textsOf(const QWidget& window)
{
    QStringList texts{window.windowTitle()};
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        texts << widget->toolTip() << widget->accessibleName() << widget->whatsThis();
        if (const auto* label = qobject_cast<const QLabel*>(widget))
            texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            texts << button->text();
        if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
            for (int i = 0; i < box->count(); ++i)
                texts << box->itemText(i);
        }
        if (const auto* number = qobject_cast<const QDoubleSpinBox*>(widget))
            texts << number->text();
    }
    for (const QAction* action : window.findChildren<QAction*>())
        texts << action->text() << action->toolTip();
    texts.sort();
    texts.removeAll(QString());
    return texts;
}

/// Two steps of growth, an open sheet, the history and the help.
void workIn(MainWindow& window)
{
    window.resize(1280, 860);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.document().reset(4);
    for (int i = 0; i < 2; ++i) {
        window.growRunner().run(1);
        QTRY_VERIFY(!window.growRunner().isRunning());
    }
    for (const ActionId id :
         {ActionId::LeafSheet, ActionId::History, ActionId::Bend, ActionId::Help, ActionId::Settings})
        window.actions()[id]->trigger();
    window.workspace().viewport().setCamera(
        window.workspace().viewport().mainCamera().turnedTo(NamedView::Top));
    // Until the counts are right.
    QTest::qWait(300);
}

} // namespace

void LanguagesTest::language_changesAtOnceAndKeepsAll()
{
    const QStringList spoken{QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("ja")};
    QMap<QString, QStringList> expected;
    for (const QString& language : spoken) {
        Preferences preferences;
        preferences.language = language;
        Settings().setPreferences(preferences);
        speakLanguage(language);
        MainWindow window;
        workIn(window);
        expected[language] = textsOf(window);
        window.document().undoStack().setClean();
    }
    QVERIFY(expected[QStringLiteral("de")] != expected[QStringLiteral("en")]);

    speakLanguage(QStringLiteral("en"));
    Settings().setPreferences({.language = QStringLiteral("en")});
    MainWindow window;
    workIn(window);
    QUndoStack& stack = window.document().undoStack();
    const int steps = stack.count();
    const std::uint32_t size = window.document().tree().size();
    QVERIFY(steps == 2 && size > 2);
    const Camera camera = window.workspace().viewport().mainCamera();
    const QString page = window.workspace().help().page();
    const qsizetype objects = window.findChildren<QObject*>().size();
    for (const char* code : {"de", "ja", "en"}) {
        const QString language = QString::fromLatin1(code);
        auto* sheet = window.findChild<SettingsSheet*>();
        QVERIFY(sheet);
        auto* box = sheet->findChild<QComboBox*>(QStringLiteral("language"));
        box->setCurrentIndex(box->findData(language));
        QTRY_VERIFY(window.findChild<SettingsSheet*>() != nullptr &&
                    window.actions()[ActionId::Prune]->text() ==
                        QCoreApplication::translate("Actions", "Prune"));
        QTest::qWait(300);
        QCOMPARE(QLocale().name().left(2), language);
        QCOMPARE(textsOf(window), expected[language]);

        QVERIFY(window.actions()[ActionId::LeafSheet]->isChecked() &&
                window.workspace().sheet(2).isVisible());
        QVERIFY(window.actions()[ActionId::Bend]->isChecked());
        QVERIFY(window.workspace().isHelpShown());
        QCOMPARE(window.workspace().help().page(), page);
        QVERIFY(window.workspace().viewport().mainCamera() == camera);
        // The tree is the same, and so is its undo stack.
        QCOMPARE(stack.count(), steps);
        QCOMPARE(window.document().tree().size(), size);
        window.actions()[ActionId::Undo]->trigger();
        QCOMPARE(stack.index(), steps - 1);
        window.actions()[ActionId::Redo]->trigger();
        QCOMPARE(stack.index(), steps);
    }
    // Nothing is left of the interfaces before.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(window.findChildren<QObject*>().size(), objects);
    QVERIFY(qApp->findChildren<QTranslator*>().size() <= 2);
    stack.setClean();
    QSettings().clear();
}

void LanguagesTest::language_changesWhileASamplePlays()
{
    speakLanguage(QStringLiteral("en"));
    Settings().setPreferences({.language = QStringLiteral("en")});
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.help().playSample(QStringLiteral(":/docs/help/recipes/grow.json"));
    QVERIFY(window.recipeRunner().isRunning());
    window.actions()[ActionId::Settings]->trigger();
    auto* box = window.findChild<SettingsSheet*>()->findChild<QComboBox*>(QStringLiteral("language"));
    box->setCurrentIndex(box->findData(QStringLiteral("fr")));
    QTRY_COMPARE(window.actions()[ActionId::Prune]->text(), QCoreApplication::translate("Actions", "Prune"));
    QVERIFY(window.actions()[ActionId::Prune]->text() != QLatin1String("Prune"));
    // The recipe continues, and its tree still does not count as an unsaved change.
    QVERIFY(window.recipeRunner().isRunning());
    QVERIFY(!window.actions()[ActionId::Prune]->isEnabled());
    QTRY_VERIFY(window.document().undoStack().count() > 0 || window.recipeRunner().moment()->progress > 0.0);
    window.recipeRunner().stop();
    QVERIFY(window.document().undoStack().isClean());
    QVERIFY(window.actions()[ActionId::Prune]->isEnabled());
    speakLanguage(QStringLiteral("en"));
    QSettings().clear();
}

void LanguagesTest::lettersWithoutAFont_areSaidAndEnglishIsOffered()
{
    const bool hasFont = !QFontDatabase::families(QFontDatabase::Japanese).isEmpty();
    speakLanguage(QStringLiteral("ja"));
    Settings().setPreferences({.language = QStringLiteral("ja")});
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    Notice& notice = window.workspace().notice();
    QCOMPARE(notice.isVisible() && notice.text().contains(QStringLiteral("Japanese letters")), !hasFont);
    if (!hasFont) {
        for (auto* button : notice.findChildren<QPushButton*>()) {
            if (button->text() == QStringLiteral("Use English"))
                button->click();
        }
        QTRY_COMPARE(window.actions()[ActionId::Prune]->text(), QStringLiteral("Prune"));
        QCOMPARE(Settings().preferences().language, QStringLiteral("en"));
        QVERIFY(!window.workspace().notice().isVisible());
    }
    speakLanguage(QStringLiteral("en"));
    QSettings().clear();
}

void LanguagesTest::initTestCase()
{
    QSettings().clear();
    theme::apply(*qApp);
    QCOMPARE(languages(), (QStringList{QStringLiteral("de"), QStringLiteral("fr"), QStringLiteral("ja"),
                                       QStringLiteral("pl")}));
}

void LanguagesTest::texts_haveRoom_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("en") << QString();
    for (const QString& language : languages())
        QTest::newRow(qPrintable(language)) << language;
}

void LanguagesTest::texts_haveRoom()
{
    QFETCH(const QString, language);
    QTranslator translator;
    if (!language.isEmpty()) {
        QVERIFY(translator.load(QStringLiteral(":/translations/espalier_%1.qm").arg(language)));
        QVERIFY(QCoreApplication::installTranslator(&translator));
    }
    const QString brush = QCoreApplication::translate("Actions", "Prune");
    QCOMPARE(brush == QLatin1String("Prune"), language.isEmpty());

    MainWindow window;
    window.resize(1024, 700);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QStringList cut;
    for (const char* name : {"architecture", "brushSheet", "leafSheet", "branchSheet", "background", "grow",
                             "bend", "lasso", "history", "library"}) {
        auto* action = window.findChild<QAction*>(QLatin1String(name));
        QVERIFY2(action, name);
        action->trigger();
        QCoreApplication::processEvents();
        for (const QString& text : cutOff(window))
            cut << QLatin1String(name) + QStringLiteral(": ") + text;
    }
    SettingsSheet settings({});
    settings.show();
    QVERIFY(QTest::qWaitForWindowExposed(&settings));
    for (const QString& text : cutOff(settings))
        cut << QStringLiteral("settings: ") + text;
    cut.removeDuplicates();
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QLatin1Char('\n'))));
}

void LanguagesTest::help_isWhole_data()
{
    QTest::addColumn<QString>("language");
    for (const QString& language : languages())
        QTest::newRow(qPrintable(language)) << language;
}

void LanguagesTest::help_isWhole()
{
    QFETCH(const QString, language);
    const QDir english(QStringLiteral(":/docs/help/en"));
    const QStringList pages = english.entryList();
    QVERIFY(pages.size() > 15);
    QCOMPARE(QDir(QStringLiteral(":/docs/help/%1").arg(language)).entryList(), pages);
    const auto linksIn = [](const QString& fileName) {
        QFile file(fileName);
        QStringList links;
        if (file.open(QIODevice::ReadOnly)) {
            static const QRegularExpression kLink(QStringLiteral("\\]\\(([^)]*)\\)"));
            QRegularExpressionMatchIterator each = kLink.globalMatch(QString::fromUtf8(file.readAll()));
            while (each.hasNext())
                links << each.next().captured(1);
        }
        links.sort();
        return links;
    };
    for (const QString& page : pages)
        QCOMPARE(linksIn(QStringLiteral(":/docs/help/%1/%2").arg(language, page)),
                 linksIn(english.filePath(page)));
}

void LanguagesTest::textsOfQt_areBuiltIn_data()
{
    help_isWhole_data();
}

void LanguagesTest::textsOfQt_areBuiltIn()
{
    QFETCH(QString, language);
    QTranslator translator;
    QVERIFY2(translator.load(QStringLiteral(":/translations/qtbase_%1.qm").arg(language)),
             "the program depends on translations of Qt that may not be installed");
    speakLanguage(QStringLiteral("en"));
    const auto cancel = [] { return QCoreApplication::translate("QPlatformTheme", "Cancel"); };
    QCOMPARE(cancel(), QStringLiteral("Cancel"));
    speakLanguage(language);
    QCOMPARE(cancel(), translator.translate("QPlatformTheme", "Cancel"));
    QVERIFY(cancel() != QStringLiteral("Cancel"));
    speakLanguage(QStringLiteral("en"));
}

static const test::TestClass<LanguagesTest> languagesTest;

} // namespace espalier

#include "LanguagesTest.moc"
