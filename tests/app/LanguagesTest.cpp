// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"
#include "app/SettingsSheet.h"
#include "app/Workspace.h"
#include "panels/Theme.h"

#include <QAbstractButton>
#include <QLabel>
#include <QToolButton>
#include <QTranslator>
#include <QtTest>

namespace espalier {

/// The window in each language that there is.
class LanguagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void texts_haveRoom_data();
    void texts_haveRoom();
    void help_isWhole_data();
    void help_isWhole();
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

/// What of @p window's texts is cut off, one line each.
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

} // namespace

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
        window.grab().save(QStringLiteral("languages-%1-%2.png").arg(language, QLatin1String(name)));
    }
    SettingsSheet settings({});
    settings.show();
    QVERIFY(QTest::qWaitForWindowExposed(&settings));
    for (const QString& text : cutOff(settings))
        cut << QStringLiteral("settings: ") + text;
    settings.grab().save(QStringLiteral("languages-%1-settings.png").arg(language));
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

} // namespace espalier

QTEST_MAIN(espalier::LanguagesTest)
#include "LanguagesTest.moc"
