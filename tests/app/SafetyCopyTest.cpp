// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/SafetyCopy.h"

#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "commands/TimeGesture.h"
#include "model/document/Edit.h"
#include "tests/support/FaultyDisk.h"
#include "tests/support/FilesFixture.h"
#include "tests/support/OwnImages.h"
#include "tests/support/SampleProject.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

#include <sys/wait.h>
#include <unistd.h>

using namespace espalier;

/// What the safety copy of a document that is being edited holds.
class SafetyCopyTest : public test::FilesFixture {
    Q_OBJECT

private Q_SLOTS:
    void copy_followsAllThatIsDone();
    void change_isAddedAndTheProjectStays();
    void changeThatIsNotWhole_isLeftOut();
    void damagedChange_endsTheChanges();
    void changesOfAnotherProject_areIgnored();
    void openedFile_isTheBeginning();
    void fileChangedByAnother_isNotTheBeginning();
    void gestureAcrossASave_isKept();
    void cancelledLongGesture_leavesNoCopy();
    void leaving_keepsTheCopyAlsoOnAFullDisk();
    void copyThatWasTamperedWith_beginsAnew();
    void images_areWrittenOnce();
    void longGesture_isNotLost();
    void manyChanges_becomeANewProject();
    void fullDisk_isToldAndMadeGood();
    void copyWithoutChanges_isNotOffered();
    void lock_isFreeOnceItsProcessIsGone();

private:
    /// The copy of the one window that there is.
    static SafetyCopy onlyCopy()
    {
        return SafetyCopy::ofProject(Autosave::folder() + QLatin1Char('/') + copies().value(0));
    }
    /// Waits until the copy is up to date, and compares.
    static void compare(test::FilesWindow& window);
    static void waitForCopy(test::FilesWindow& window, const std::function<void()>& change);
};

void SafetyCopyTest::waitForCopy(test::FilesWindow& window, const std::function<void()>& change)
{
    QSignalSpy written(&window.files->autosave(), &Autosave::written);
    change();
    QVERIFY(written.count() > 0 || written.wait(30'000));
}

void SafetyCopyTest::compare(test::FilesWindow& window)
{
    const Result<Project> copy = onlyCopy().read();
    QVERIFY2(copy, copy ? "" : qPrintable(copy.error().message));
    const Project document = projectOf(window.document, copy->name);
    QVERIFY(copy->tree == document.tree);
    QCOMPARE(copy->ahead, document.ahead);
    QVERIFY(test::sameJournal(copy->journal, document.journal));
    QVERIFY(copy->look == document.look);
    QCOMPARE(*packProject(*copy), *packProject(document));
}

void SafetyCopyTest::copy_followsAllThatIsDone()
{
    test::FilesWindow window;
    QUndoStack& stack = window.document.undoStack();
    const auto travel = [&window](int position) {
        TimeGesture gesture(window.document);
        gesture.moveTo(static_cast<std::size_t>(position));
        gesture.finish();
    };
    SceneLook look;
    look.sunElevation = radians(20);
    const std::vector<std::function<void()>> deeds{
        [&] { window.grow(4); },
        [&] { window.grow(3); },
        [&] { stack.undo(); },
        [&] { stack.redo(); },
        [&] { stack.setIndex(1); },
        [&] { window.grow(2); },
        [&] { travel(3); },
        [&] { window.document.setLook(look); },
        [&] { window.grow(1); },
        [&] { stack.undo(); },
        [&] { travel(2); },
        [&] { travel(5); },
        [&] { window.document.exchange(prepared(test::sampleProject(40)), QStringLiteral("Another")); },
        [&] { window.grow(1); },
        [&] { stack.setIndex(stack.index() - 2); },
        [&] { stack.redo(); },
    };
    for (std::size_t i = 0; i < deeds.size(); ++i) {
        waitForCopy(window, deeds[i]);
        compare(window);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QStringLiteral("after deed %1").arg(i)));
    }
}

void SafetyCopyTest::change_isAddedAndTheProjectStays()
{
    test::FilesWindow window;
    waitForCopy(window, [&] { window.grow(6); });
    const SafetyCopy copy = onlyCopy();
    const QByteArray project = bytesOf(copy.projectFile());
    const QByteArray changes = bytesOf(copy.changesFile());
    QVERIFY(!changes.isEmpty());
    waitForCopy(window, [&] { window.grow(1); });
    QCOMPARE(bytesOf(copy.projectFile()), project);
    const QByteArray more = bytesOf(copy.changesFile());
    QVERIFY(more.size() > changes.size());
    QVERIFY(more.startsWith(changes));
    compare(window);
}

void SafetyCopyTest::changeThatIsNotWhole_isLeftOut()
{
    test::FilesWindow window;
    waitForCopy(window, [&] { window.grow(3); });
    const Tree before = window.document.tree();
    const SafetyCopy copy = onlyCopy();
    const qsizetype whole = bytesOf(copy.changesFile()).size();
    waitForCopy(window, [&] { window.grow(1); });
    const QByteArray changes = bytesOf(copy.changesFile());
    for (qsizetype size = whole; size < changes.size(); size += 1 + (changes.size() - whole) / 50) {
        put(copy.changesFile(), changes.first(size));
        const Result<Project> project = copy.read();
        QVERIFY(project);
        QVERIFY(project->tree == before);
    }
    put(copy.changesFile(), changes);
    compare(window);
}

void SafetyCopyTest::damagedChange_endsTheChanges()
{
    test::FilesWindow window;
    waitForCopy(window, [&] { window.grow(3); });
    const Tree before = window.document.tree();
    const SafetyCopy copy = onlyCopy();
    const qsizetype whole = bytesOf(copy.changesFile()).size();
    waitForCopy(window, [&] { window.grow(1); });
    waitForCopy(window, [&] { window.grow(1); });
    QByteArray changes = bytesOf(copy.changesFile());
    changes[whole + 100] = static_cast<char>(changes[whole + 100] ^ 1);
    put(copy.changesFile(), changes);
    const Result<Project> project = copy.read();
    QVERIFY(project);
    QVERIFY(project->tree == before);
}

void SafetyCopyTest::changesOfAnotherProject_areIgnored()
{
    test::FilesWindow window;
    waitForCopy(window, [&] { window.grow(3); });
    const SafetyCopy copy = onlyCopy();
    const Project other = test::sampleProject(30);
    put(copy.projectFile(), *packProject(other));
    const Result<Project> project = copy.read();
    QVERIFY(project);
    QVERIFY(project->tree == other.tree);
}

void SafetyCopyTest::openedFile_isTheBeginning()
{
    const QString name = path("large.espalier");
    QVERIFY(saveProject(test::sampleProject(8'000), name));
    test::FilesWindow window;
    open(window, name);
    waitForCopy(window, [&] { window.grow(1); });
    QCOMPARE(bytesOf(onlyCopy().projectFile()), bytesOf(name));
    QCOMPARE(onlyCopy().readOrigin().fileName, name);
    compare(window);
    // After saving, the next copy begins with what was saved.
    save(window, path("saved.espalier"));
    QTRY_VERIFY(copies().isEmpty());
    waitForCopy(window, [&] { window.grow(1); });
    QCOMPARE(bytesOf(onlyCopy().projectFile()), bytesOf(path("saved.espalier")));
    compare(window);
}

void SafetyCopyTest::fileChangedByAnother_isNotTheBeginning()
{
    const QString name = path("large.espalier");
    QVERIFY(saveProject(test::sampleProject(8'000), name));
    test::FilesWindow window;
    open(window, name);
    QVERIFY(saveProject(test::sampleProject(50, 4), name));
    waitForCopy(window, [&] { window.grow(1); });
    compare(window);
}

void SafetyCopyTest::gestureAcrossASave_isKept()
{
    const QString name = path("large.espalier");
    QVERIFY(saveProject(test::sampleProject(8'000), name));
    test::FilesWindow window;
    open(window, name);
    window.grow(1);
    QSignalSpy saved(&window.files->file(), &DocumentFile::saved);
    window.files->file().save(name, {});
    // The gesture begins before the file is there, and ends after it.
    GrowGesture gesture(window.document);
    gesture.step();
    QVERIFY(saved.wait(30'000));
    QTest::qWait(100);
    waitForCopy(window, [&] { gesture.finish(); });
    compare(window);
    waitForCopy(window, [&] { window.grow(1); });
    waitForCopy(window, [&] { window.document.undoStack().undo(); });
    waitForCopy(window, [&] { window.document.undoStack().redo(); });
    compare(window);
}

void SafetyCopyTest::cancelledLongGesture_leavesNoCopy()
{
    test::FilesWindow window;
    GrowGesture gesture(window.document);
    waitForCopy(window, [&] { gesture.step(); });
    QCOMPARE(copies().size(), 1);
    gesture.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(copies().isEmpty(), 10'000);
}

void SafetyCopyTest::leaving_keepsTheCopyAlsoOnAFullDisk()
{
    Tree before;
    Tree after;
    {
        test::FilesWindow window;
        waitForCopy(window, [&] { window.grow(3); });
        before = window.document.tree();
        window.grow(1);
        const test::FaultyDisk disk(Autosave::folder(), 0, ENOSPC);
        window.files->leave();
    }
    QCOMPARE(copies().size(), 1);
    const Result<Project> kept = onlyCopy().read();
    QVERIFY(kept);
    QVERIFY(kept->tree == before);
    {
        test::FilesWindow window;
        Autosave::discard(Autosave::leftovers().front());
        waitForCopy(window, [&] { window.grow(3); });
        window.grow(1);
        after = window.document.tree();
        window.files->leave();
    }
    QCOMPARE(copies().size(), 1);
    const Result<Project> whole = onlyCopy().read();
    QVERIFY(whole);
    QVERIFY(whole->tree == after);
    QVERIFY(QFileInfo(onlyCopy().changesFile()).size() > 0);
}

void SafetyCopyTest::copyThatWasTamperedWith_beginsAnew()
{
    test::FilesWindow window;
    waitForCopy(window, [&] { window.grow(3); });
    QVERIFY(QFile::remove(onlyCopy().changesFile()));
    waitForCopy(window, [&] { window.grow(1); });
    compare(window);
    waitForCopy(window, [&] { window.grow(1); });
    compare(window);
}

void SafetyCopyTest::images_areWrittenOnce()
{
    test::FilesWindow window;
    QImage noise(400, 400, QImage::Format_RGB32);
    std::uint32_t state = 1;
    for (int y = 0; y < noise.height(); ++y) {
        for (int x = 0; x < noise.width(); ++x) {
            state = state * 1664525U + 1013904223U;
            noise.setPixel(x, y, 0xff000000U | state >> 8U);
        }
    }
    const auto apply = [&window](const TreeParameters& parameters) {
        Edit edit(window.document);
        edit.apply(test::parameterChange(window.document.tree(), parameters));
        edit.commit(QStringLiteral("Leaf"));
    };
    TreeParameters parameters = window.document.parameters();
    parameters.leaves.image = ImageAsset(test::pngOf(noise), QStringLiteral("leaf.png"));
    waitForCopy(window, [&] { apply(parameters); });
    const qint64 first = QFileInfo(onlyCopy().changesFile()).size();
    QVERIFY(first > 100'000);
    parameters.growth.branchingAngle = radians(31);
    waitForCopy(window, [&] { apply(parameters); });
    QVERIFY(QFileInfo(onlyCopy().changesFile()).size() < first + 20'000);
    compare(window);
}

void SafetyCopyTest::longGesture_isNotLost()
{
    test::FilesWindow window;
    GrowGesture gesture(window.document);
    waitForCopy(window, [&] {
        for (int i = 0; i < 5; ++i)
            gesture.step();
    });
    const Result<Project> copy = onlyCopy().read();
    QVERIFY(copy);
    QVERIFY(copy->tree == window.document.tree());
    QVERIFY(copy->tree.size() > 1);
    waitForCopy(window, [&] { gesture.finish(); });
    compare(window);
}

void SafetyCopyTest::manyChanges_becomeANewProject()
{
    // Each change of a long stroke has an operation of some megabytes.
    test::FilesWindow window;
    const auto add = [&window](int number) {
        QByteArray noise(6 << 20, Qt::Uninitialized);
        std::uint32_t state = 17U + static_cast<std::uint32_t>(number);
        for (char& c : noise) {
            state = state * 1664525U + 1013904223U;
            c = static_cast<char>('#' + (state >> 24U) % 56U); // neither a quote nor a backslash
        }
        TreeParameters parameters = window.document.parameters();
        parameters.growth.branchingAngle += 0.001;
        Edit edit(window.document);
        edit.apply(test::parameterChange(window.document.tree(), parameters));
        edit.commit(QStringLiteral("Angle"), R"({"op":")" + noise + R"("})");
    };
    for (int i = 0; i < 4; ++i)
        waitForCopy(window, [&] { add(i); });
    const qint64 before = QFileInfo(onlyCopy().changesFile()).size();
    QVERIFY2(before > (16 << 20), qPrintable(QString::number(before)));
    waitForCopy(window, [&] { window.grow(2); });
    QVERIFY(QFileInfo(onlyCopy().changesFile()).size() < (1 << 20));
    compare(window);
    waitForCopy(window, [&] { window.document.undoStack().setIndex(2); });
    compare(window);
}

void SafetyCopyTest::fullDisk_isToldAndMadeGood()
{
    test::FilesWindow window;
    waitForCopy(window, [&] { window.grow(3); });
    const Tree before = window.document.tree();
    const SafetyCopy copy = onlyCopy();
    QSignalSpy failed(&window.files->autosave(), &Autosave::failed);
    {
        const test::FaultyDisk disk(Autosave::folder(), 0, ENOSPC);
        window.grow(1);
        QVERIFY(failed.wait(30'000));
        QVERIFY(failed.front().front().toString().contains(QStringLiteral("the disk is full")));
        const Result<Project> left = copy.read();
        QVERIFY(left);
        QVERIFY(left->tree == before);
    }
    waitForCopy(window, [&] { window.grow(1); });
    compare(window);
    QCOMPARE(failed.count(), 1);
}

void SafetyCopyTest::copyWithoutChanges_isNotOffered()
{
    const QString name = path("oak.espalier");
    QVERIFY(saveProject(test::sampleProject(30), name));
    // As a crash leaves it between the beginning of the copy and the first change.
    const SafetyCopy copy(Autosave::folder() + QStringLiteral("/a"));
    QDir().mkpath(Autosave::folder());
    QVERIFY(copy.writeOrigin({name, FileContent::of(name)}));
    QVERIFY(copy.copyProject(name, FileContent::of(name)));
    QCOMPARE(copies().size(), 1);
    test::FilesWindow window;
    window.files->offerRecovery(Recovery::Occasion::Start);
    QTRY_VERIFY_WITH_TIMEOUT(copies().isEmpty(), 30'000);
    QTest::qWait(50);
    QVERIFY(window.notice.isHidden());
}

void SafetyCopyTest::lock_isFreeOnceItsProcessIsGone()
{
    const QString name = path("a.lock");
    int told[2];
    QCOMPARE(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto lock = FileLock::taken(name);
        const char result = lock ? '1' : '0';
        if (::write(told[1], &result, 1) == 1)
            ::pause();
        ::_exit(0);
    }
    char result = 0;
    QCOMPARE(::read(told[0], &result, 1), ssize_t{1});
    QCOMPARE(result, '1');
    QVERIFY(!FileLock::taken(name));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    QVERIFY(FileLock::taken(name) != nullptr);
    ::close(told[0]);
    ::close(told[1]);
}

static const test::TestClass<SafetyCopyTest> safetyCopyTest;

#include "SafetyCopyTest.moc"
