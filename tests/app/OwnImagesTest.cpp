// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/OwnImages.h"

#include "panels/Notice.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QIODevice>
#include <QMimeData>
#include <QPoint>
#include <QPointF>
#include <QPushButton>
#include <QTest>
#include <QUrl>
#include <QWidget>

using namespace espalier;

/// Images of leaf and bark that the user drops on the window.
class OwnImagesTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void droppedImage_becomesLeafOrBark();
    void imageThatIsNone_isRefusedInOneSentence();
};

namespace {

void dropFile(QWidget& on, const QString& name)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(name)});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&on, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&on, &drop);
}

void writeTo(const QString& name, const QByteArray& content)
{
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}

} // namespace

void OwnImagesTest::droppedImage_becomesLeafOrBark()
{
    const TreeDocument& document = m_window->document();
    const QString leaf = m_folder->filePath(QStringLiteral("leaf.png"));
    const QString bark = m_folder->filePath(QStringLiteral("Oak_Color.png"));
    writeTo(leaf, test::pngOf(test::drawnLeaf(Qt::white)));
    writeTo(bark, test::pngOf(test::repeatingBark(64, 64)));
    writeTo(m_folder->filePath(QStringLiteral("Oak_NormalGL.png")), test::pngOf(test::repeatingBark(64, 32)));

    // On any place of the window: a dialog asks what the image is for.
    dropFile(*m_window, leaf);
    QVERIFY(notice().contains(QStringLiteral("leaf.png")));
    const auto* const yes = m_window->workspace().notice().findChild<QPushButton*>();
    QVERIFY(yes);
    QTest::mouseClick(const_cast<QPushButton*>(yes), Qt::LeftButton);
    QTRY_VERIFY(!document.parameters().leaves.image.isNull());
    QVERIFY(std::abs(document.parameters().leaves.aspect - 0.5) < 0.05);
    QCOMPARE(document.undoStack().count(), 1);

    // On the sheet of branches: the image becomes bark, with the images beside it.
    dropFile(m_window->workspace().sheet(3), bark);
    QTRY_VERIFY(!document.parameters().bark.image.isNull());
    QCOMPARE(document.parameters().bark.normalImage.name(), QStringLiteral("Oak_NormalGL.png"));
    QVERIFY(document.parameters().bark.roughnessImage.isNull());
    QCOMPARE(document.undoStack().count(), 2);
    m_window->document().undoStack().undo();
    QVERIFY(document.parameters().bark.image.isNull());
    QVERIFY(!document.parameters().leaves.image.isNull());
}

void OwnImagesTest::imageThatIsNone_isRefusedInOneSentence()
{
    const TreeParameters before = m_window->document().parameters();
    const QString name = m_folder->filePath(QStringLiteral("broken.png"));
    writeTo(name, "no image");
    dropFile(m_window->workspace().sheet(2), name);
    QTRY_VERIFY(m_window->workspace().notice().isWarning());
    QCOMPARE(notice(), QStringLiteral("broken.png: it is neither a PNG nor a JPEG image"));
    writeTo(name, test::pngOf(test::repeatingBark(64, 64)));
    dropFile(m_window->workspace().sheet(2), name);
    QTRY_VERIFY(notice().startsWith(QStringLiteral("broken.png: the leaf cannot be told apart")));
    QVERIFY(m_window->document().parameters() == before);
    QCOMPARE(m_window->document().undoStack().count(), 0);
}

static const test::TestClass<OwnImagesTest> ownImagesTest;

#include "OwnImagesTest.moc"
