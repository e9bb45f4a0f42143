// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/Background.h"
#include "tests/support/Documents.h"
#include "tests/support/FilesFixture.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// A document is set aside while another tree is shown, and comes back with its file.
class AsideTest : public test::FilesFixture {
    Q_OBJECT

private Q_SLOTS:
    void savedTree_comesBackWithItsFileAndItsLook();
    void unsavedTree_staysUnsavedAndIsSafeFromACrash();
    void leaving_asksAboutTheTreeThatIsSetAside();
    void leaving_asksNothingAboutASavedOne();
    void comingBack_asksAboutChangesOfTheOtherTree();
};

void AsideTest::savedTree_comesBackWithItsFileAndItsLook()
{
    test::FilesWindow window;
    FileController& files = *window.files;
    SceneLook look;
    look.gridShown = true;
    window.grow();
    window.document.setLook(look);
    save(window, path("oak.espalier"));
    const test::DocumentState before(window.document);
    files.setAside();
    QVERIFY(files.isAside());
    QVERIFY(files.file().fileName().isEmpty() && !files.file().isModified());
    QCOMPARE(window.document.index().livingCount(), 1U);
    QVERIFY(!window.document.look().gridShown);

    QVERIFY(files.bringBack());
    QCOMPARE(test::differenceFrom(before, window.document), QString());
    QVERIFY(window.document.look() == look);
    QCOMPARE(files.file().fileName(), path("oak.espalier"));
    QVERIFY(!files.isAside() && !files.file().isModified());
    // Its file is known, so saving asks nothing.
    window.grow();
    QSignalSpy refused(&files.file(), &DocumentFile::saveRefused);
    save(window, path("oak.espalier"));
    QCOMPARE(refused.count(), 0);
    QVERIFY(loadProject(path("oak.espalier"))->tree == window.document.tree());
}

void AsideTest::unsavedTree_staysUnsavedAndIsSafeFromACrash()
{
    test::FilesWindow window;
    FileController& files = *window.files;
    window.grow();
    const Tree grown = window.document.tree();
    files.setAside();
    backgroundThreads().waitForDone();
    QCOMPARE(copies().size(), 1);
    const QString copy = Autosave::folder() + QLatin1Char('/') + copies().constFirst();
    QVERIFY(loadProject(copy)->tree == grown);
    // This program lives, so its copy is not offered to another one.
    QVERIFY(Autosave::leftovers().empty());
    // The other tree has a copy of its own.
    QSignalSpy written(&files.autosave(), &Autosave::written);
    window.grow(1);
    QVERIFY(written.wait(30'000));
    QCOMPARE(copies().size(), 2);
    QVERIFY(loadProject(copy)->tree == grown);

    answer(QMessageBox::Discard);
    QVERIFY(files.bringBack());
    QVERIFY(window.document.tree() == grown);
    QVERIFY(files.file().isModified());
    QTRY_COMPARE(copies().size(), 1);
    save(window, path("oak.espalier"));
    QTRY_VERIFY(copies().isEmpty());
}

void AsideTest::leaving_asksAboutTheTreeThatIsSetAside()
{
    test::FilesWindow window;
    FileController& files = *window.files;
    window.grow();
    const Tree grown = window.document.tree();
    files.setAside();
    answer(QMessageBox::Cancel);
    QVERIFY(!files.mayLeave());
    QCOMPARE(questions(), 1);
    // It is shown, so that the person sees what the question is about.
    QVERIFY(window.document.tree() == grown);
    QVERIFY(!files.isAside() && files.file().isModified());
}

void AsideTest::leaving_asksNothingAboutASavedOne()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    window.files->setAside();
    window.files->startNew();
    QCOMPARE(questions(), 0);
    QVERIFY(!window.files->isAside());
}

void AsideTest::comingBack_asksAboutChangesOfTheOtherTree()
{
    test::FilesWindow window;
    FileController& files = *window.files;
    window.grow();
    const Tree own = window.document.tree();
    files.setAside();
    window.grow(1);
    const Tree other = window.document.tree();
    answer(QMessageBox::Cancel);
    QVERIFY(!files.bringBack());
    QVERIFY(window.document.tree() == other && files.isAside());
    answer(QMessageBox::Discard);
    QVERIFY(files.bringBack());
    QVERIFY(window.document.tree() == own);
    QCOMPARE(questions(), 2);
}

static const test::TestClass<AsideTest> asideTest;

#include "AsideTest.moc"
