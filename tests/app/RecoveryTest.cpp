// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/RecoverySheet.h"
#include "tests/support/FilesFixture.h"
#include "tests/support/SampleProject.h"
#include "tests/support/TestClasses.h"

#include <QAbstractButton>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// Safety copies after a crash, and their recovery.
class RecoveryTest : public test::FilesFixture {
    Q_OBJECT

private Q_SLOTS:
    void everyLeftover_isOfferedTheNewestFirst();
    void leftover_isOfferedBesideAFileThatIsOpened();
    void leftoverBroughtBack_staysUntilItHasACopyOfItsOwn();
    void damagedCopy_isKeptAsideAndNamedAtTheStart();
    void tornChanges_areKeptAsideIfNothingElseIsThere();
    void damagedOrigin_isNoName();
    void keys_pressTheButtonWithTheFocusAndEscapeChangesNothing();
    void copyDamagedSinceTheStart_isKeptAside();
    void damagedCopies_doNotReplaceEachOther();
    void discarded_goOnlyWhenTheSheetCloses();
    void pictures_showTheFileAndWhatWasDoneSince();
    void later_keepsThemAll();
    void offered_areNotOfferedToAnotherProgram();
    void broughtBack_asksBeforeItReplacesAFileChangedSince();
    void originsOfOlderVersions_areRead();
    void look_isBroughtBack();
    void partsOfOtherPrograms_areBroughtBack();

private:
    /// Leaves the files of a crash @p minutes ago: a tree of @p steps steps, opened from @p original.
    Tree crash(const char* name, const QString& original, int steps, int minutes);
    static QString copyPath(const char* name)
    {
        return Autosave::folder() + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".espalier");
    }
    static QStringList keptAside()
    {
        return QDir(Autosave::folder() + QStringLiteral("/unreadable"))
            .entryList({QStringLiteral("*.espalier")}, QDir::Files);
    }
    static RecoverySheet* sheetOf(const test::FilesWindow& window)
    {
        return window.widget.findChild<RecoverySheet*>();
    }
    /// What the sheet says of its trees; empty if there is no sheet.
    static QString offered(const test::FilesWindow& window)
    {
        QStringList texts;
        if (const RecoverySheet* sheet = sheetOf(window)) {
            for (const QLabel* label : sheet->findChildren<QLabel*>())
                texts.append(label->isVisible() ? label->text() : QString());
        }
        return texts.join(QLatin1Char('\n'));
    }
    /// Presses a button of the sheet; @p text is its accessible name, or its text.
    static void press(const test::FilesWindow& window, const QString& text)
    {
        const RecoverySheet* sheet = sheetOf(window);
        QVERIFY(sheet);
        for (QAbstractButton* button : sheet->findChildren<QAbstractButton*>()) {
            if ((button->accessibleName() == text || button->text() == text) && button->isEnabled()) {
                button->click();
                return;
            }
        }
        QFAIL(qPrintable(QStringLiteral("There is no button “%1”").arg(text)));
    }
};

Tree RecoveryTest::crash(const char* name, const QString& original, int steps, int minutes)
{
    Tree tree;
    {
        test::FilesWindow window;
        if (!original.isEmpty())
            open(window, original);
        QSignalSpy written(&window.files->autosave(), &Autosave::written);
        window.grow(steps);
        if (!written.wait(30'000))
            return tree;
        tree = window.document.tree();
        leaveACopy(name);
    }
    for (const char* suffix : {".espalier", ".changes"}) {
        QFile file(copyPath(name).chopped(9) + QLatin1String(suffix));
        if (file.open(QIODevice::ReadWrite))
            file.setFileTime(QDateTime::currentDateTime().addSecs(-60 * minutes),
                             QFileDevice::FileModificationTime);
    }
    return tree;
}

void RecoveryTest::everyLeftover_isOfferedTheNewestFirst()
{
    {
        test::FilesWindow window;
        window.grow(1);
        save(window, path("oak.espalier"));
        save(window, path("elm.espalier"));
    }
    crash("a", path("oak.espalier"), 2, 30);
    const Tree elm = crash("b", path("elm.espalier"), 3, 10);
    const Tree unnamed = crash("c", {}, 4, 20);

    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("elm.espalier")), 30'000);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.document.tree() == elm, 30'000);
    QCOMPARE(window.files->file().fileName(), path("elm.espalier"));
    QVERIFY(window.files->file().isModified());

    // The others are there when this one is shown, and ask about it.
    QTRY_VERIFY_WITH_TIMEOUT(window.said().contains(QStringLiteral("2 other trees")), 30'000);
    window.press(QStringLiteral("Show"));
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("A tree that was never saved")), 30'000);
    answer(QMessageBox::Save);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.document.tree() == unnamed, 30'000);
    const Result<Project> saved = loadProject(path("elm.espalier"));
    QVERIFY(saved);
    QVERIFY(saved->tree == elm);

    QTRY_VERIFY_WITH_TIMEOUT(window.said().contains(QStringLiteral("Another tree")), 30'000);
    window.files->offerRecovery(Recovery::Occasion::Asked);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("oak.espalier")), 30'000);
    press(window, QStringLiteral("Discard oak.espalier"));
    press(window, QStringLiteral("Done"));
    QTRY_VERIFY(sheetOf(window) == nullptr);
    QVERIFY(!QFileInfo::exists(copyPath("a")));
    QVERIFY(Autosave::leftovers().empty());
    window.files->offerRecovery(Recovery::Occasion::Asked);
    QVERIFY2(window.said().contains(QStringLiteral("nothing to bring back")), qPrintable(window.said()));
}

void RecoveryTest::leftover_isOfferedBesideAFileThatIsOpened()
{
    {
        test::FilesWindow window;
        window.grow(1);
        save(window, path("oak.espalier"));
    }
    const Tree lost = crash("a", path("oak.espalier"), 2, 1);
    test::FilesWindow window;
    QSignalSpy opened(window.files.get(), &FileController::opened);
    window.files->openFile(path("oak.espalier"));
    window.files->offerRecovery(Recovery::Occasion::Start);
    QVERIFY(opened.wait(30'000));
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("oak.espalier")), 30'000);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.document.tree() == lost, 30'000);
}

void RecoveryTest::leftoverBroughtBack_staysUntilItHasACopyOfItsOwn()
{
    const Tree lost = crash("a", {}, 3, 1);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    QSignalSpy written(&window.files->autosave(), &Autosave::written);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.document.tree() == lost, 30'000);
    QVERIFY(written.count() > 0 || QFileInfo::exists(copyPath("a")));
    QVERIFY(written.count() > 0 || written.wait(30'000));
    QVERIFY(!QFileInfo::exists(copyPath("a")));
    QCOMPARE(copies().size(), 1);
    save(window, path("saved.espalier"));
    QTRY_VERIFY(copies().isEmpty());
}

void RecoveryTest::damagedCopy_isKeptAsideAndNamedAtTheStart()
{
    const QByteArray damaged = "PK half a tree";
    put(copyPath("a"), damaged);
    put(copyPath("a").chopped(9) + QStringLiteral(".origin"), path("oak.espalier").toUtf8());
    crash("b", {}, 2, 30);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    // The others are offered all the same.
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    press(window, QStringLiteral("Later"));
    QTRY_VERIFY_WITH_TIMEOUT(window.notice.isWarning(), 30'000);
    QCOMPARE(keptAside().size(), 1);
    const QString kept = Autosave::folder() + QStringLiteral("/unreadable/") + keptAside().constFirst();
    QVERIFY2(keptAside().constFirst().startsWith(QStringLiteral("oak ")), qPrintable(kept));
    QCOMPARE(bytesOf(kept), damaged);
    QVERIFY2(window.said().contains(kept), qPrintable(window.said()));
    QVERIFY2(window.said().contains(QStringLiteral("oak.espalier")), qPrintable(window.said()));
    QVERIFY(!QFileInfo::exists(copyPath("a")));
}

void RecoveryTest::tornChanges_areKeptAsideIfNothingElseIsThere()
{
    crash("a", {}, 3, 1);
    crash("b", {}, 3, 2);
    const auto tear = [](const char* name, qsizetype bytes) {
        const QString changes = copyPath(name).chopped(9) + QStringLiteral(".changes");
        put(changes, bytesOf(changes).chopped(bytes));
    };
    // Of one only the seedling is left; the other lacks what came last.
    tear("a", bytesOf(copyPath("a").chopped(9) + QStringLiteral(".changes")).size() - 60);
    put(copyPath("b").chopped(9) + QStringLiteral(".changes"),
        bytesOf(copyPath("b").chopped(9) + QStringLiteral(".changes")) + "ESC1 half");
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    QCOMPARE(keptAside().size(), 1);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.said().contains(QStringLiteral("what was done last")), 30'000);
    QVERIFY(window.document.tree().size() > 1);
}

void RecoveryTest::damagedOrigin_isNoName()
{
    crash("a", {}, 3, 1);
    put(copyPath("a").chopped(9) + QStringLiteral(".origin"), QByteArray::fromHex("8b00ff2f0ac3dd99"));
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    press(window, QStringLiteral("Later"));
}

void RecoveryTest::keys_pressTheButtonWithTheFocusAndEscapeChangesNothing()
{
    crash("a", {}, 2, 1);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    RecoverySheet* const sheet = sheetOf(window);
    QTRY_VERIFY(sheet->isActiveWindow());
    QPushButton* discard = nullptr;
    for (QPushButton* button : sheet->findChildren<QPushButton*>())
        discard = button->isCheckable() ? button : discard;
    discard->setFocus();
    QTest::keyClick(sheet, Qt::Key_Return);
    QVERIFY(discard->isChecked());
    QVERIFY(sheet->isVisible());
    QTest::keyClick(sheet, Qt::Key_Escape);
    QTRY_VERIFY(sheetOf(window) == nullptr);
    QCOMPARE(copies().size(), 1);
}

void RecoveryTest::copyDamagedSinceTheStart_isKeptAside()
{
    crash("a", {}, 2, 1);
    test::FilesWindow window;
    window.grow(1);
    const Tree before = window.document.tree();
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    put(copyPath("a"), "damaged by now");
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.notice.isWarning(), 30'000);
    QCOMPARE(keptAside().size(), 1);
    QCOMPARE(bytesOf(Autosave::folder() + QStringLiteral("/unreadable/") + keptAside().constFirst()),
             QByteArray("damaged by now"));
    QVERIFY2(window.said().contains(keptAside().constFirst()), qPrintable(window.said()));
    QVERIFY(window.document.tree() == before);
}

void RecoveryTest::damagedCopies_doNotReplaceEachOther()
{
    for (const char* name : {"a", "b", "c"})
        put(copyPath(name), QByteArray("damaged ") + name);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(window.notice.isWarning(), 30'000);
    QCOMPARE(keptAside().size(), 3);
    QVERIFY2(window.said().contains(QStringLiteral("3 safety copies")) &&
                 window.said().contains(Autosave::folder() + QStringLiteral("/unreadable")),
             qPrintable(window.said()));
}

void RecoveryTest::discarded_goOnlyWhenTheSheetCloses()
{
    crash("a", {}, 2, 1);
    crash("b", {}, 3, 2);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    const auto discards = sheetOf(window)->findChildren<QPushButton*>();
    QList<QPushButton*> discard;
    for (QPushButton* button : discards) {
        if (button->isCheckable())
            discard.append(button);
    }
    QCOMPARE(discard.size(), 2);
    discard[0]->click();
    discard[1]->click();
    QCOMPARE(discard[0]->text(), QStringLiteral("Keep"));
    QCOMPARE(copies().size(), 2);
    discard[1]->click();
    press(window, QStringLiteral("Done"));
    QTRY_COMPARE(copies(), QStringList{QStringLiteral("b.espalier")});
    QTRY_COMPARE(Autosave::leftovers().size(), std::size_t{1});
}

void RecoveryTest::pictures_showTheFileAndWhatWasDoneSince()
{
    {
        test::FilesWindow window;
        window.grow(2);
        save(window, path("oak.espalier"));
    }
    crash("a", path("oak.espalier"), 4, 1);
    QVERIFY(saveProject(test::sampleProject(30), path("oak.espalier")));
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    const auto pictures = [&window] {
        QList<QImage> images;
        if (const RecoverySheet* sheet = sheetOf(window)) {
            for (const QLabel* label : sheet->findChildren<QLabel*>()) {
                if (const QPixmap pixmap = label->pixmap(); !pixmap.isNull())
                    images.append(pixmap.toImage());
            }
        }
        return images;
    };
    QTRY_COMPARE_WITH_TIMEOUT(pictures().size(), 2, 30'000);
    QVERIFY(pictures()[0] != pictures()[1]);
    QVERIFY2(offered(window).contains(QStringLiteral("another program")), qPrintable(offered(window)));
    QCOMPARE(offered(window).count(QStringLiteral("internode")), 2);
    press(window, QStringLiteral("Later"));
}

void RecoveryTest::later_keepsThemAll()
{
    crash("a", {}, 2, 1);
    crash("b", {}, 3, 2);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    press(window, QStringLiteral("Later"));
    QTest::qWait(50);
    QVERIFY(window.notice.isHidden());
    QTRY_COMPARE(Autosave::leftovers().size(), std::size_t{2});
}

void RecoveryTest::offered_areNotOfferedToAnotherProgram()
{
    crash("a", {}, 2, 1);
    {
        test::FilesWindow window;
        window.files->offerRecovery(Recovery::Occasion::Start);
        QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
        QVERIFY(Autosave::leftovers().empty());
    }
    QCOMPARE(Autosave::leftovers().size(), std::size_t{1});
}

void RecoveryTest::broughtBack_asksBeforeItReplacesAFileChangedSince()
{
    test::FilesWindow other;
    other.grow(1);
    save(other, path("oak.espalier"));
    const Tree lost = crash("a", path("oak.espalier"), 2, 1);
    other.grow(1);
    save(other, path("oak.espalier"));
    const QByteArray bytes = bytesOf(path("oak.espalier"));

    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("oak.espalier")), 30'000);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.document.tree() == lost, 30'000);
    answer(QMessageBox::Cancel);
    window.files->save();
    QTRY_COMPARE_WITH_TIMEOUT(questions(), 1, 30'000);
    QCOMPARE(bytesOf(path("oak.espalier")), bytes);
}

void RecoveryTest::originsOfOlderVersions_areRead()
{
    put(copyPath("a"), "any");
    put(copyPath("a").chopped(9) + QStringLiteral(".origin"), "/home/ann/old oak.espalier");
    const std::vector<Leftover> leftovers = Autosave::leftovers();
    QCOMPARE(leftovers.size(), std::size_t{1});
    QCOMPARE(leftovers.front().original, QStringLiteral("/home/ann/old oak.espalier"));
    QVERIFY(!leftovers.front().content.exists());
    QCOMPARE(leftovers.front().displayName(), QStringLiteral("old oak.espalier"));
}

void RecoveryTest::look_isBroughtBack()
{
    SceneLook look;
    look.backdrop = Backdrop::Horizon;
    look.sunElevation = radians(12);
    {
        test::FilesWindow window;
        QSignalSpy written(&window.files->autosave(), &Autosave::written);
        // A look that has changed is a change that no file has, as one of the tree.
        window.document.setLook(look);
        QVERIFY(window.files->file().isModified());
        QVERIFY(written.wait(30'000));
        QCOMPARE(copies().size(), 1);
        leaveACopy("a");
        window.document.setLook({});
        QVERIFY(!window.files->file().isModified());
        QTRY_COMPARE(copies().size(), 1);
    }
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("never saved")), 30'000);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.document.look() == look, 30'000);
    QVERIFY(window.files->file().isModified());
}

void RecoveryTest::partsOfOtherPrograms_areBroughtBack()
{
    Project project = test::sampleProject(30);
    project.foreign.members = {{QStringLiteral("shot"), 7}};
    project.foreign.entries = {{"pipeline/notes.txt", "Ready for review"}};
    QVERIFY(saveProject(project, path("oak.espalier")));
    crash("a", path("oak.espalier"), 2, 1);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(offered(window).contains(QStringLiteral("oak.espalier")), 30'000);
    press(window, QStringLiteral("Bring Back"));
    QTRY_VERIFY_WITH_TIMEOUT(window.files->file().isModified(), 30'000);
    save(window, path("elm.espalier"));
    const Result<Project> saved = loadProject(path("elm.espalier"));
    QVERIFY(saved);
    QVERIFY(saved->foreign == project.foreign);
    window.files->startNew();
    QVERIFY(window.files->file().snapshot().foreign == ForeignParts());
}

static const test::TestClass<RecoveryTest> recoveryTest;

#include "RecoveryTest.moc"
