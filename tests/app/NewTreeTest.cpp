// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/NewTree.h"

#include "model/settings/Lengths.h"
#include "panels/SizeChoices.h"
#include "panels/library/LibraryPanel.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"
#include "views/render/ScaleFigure.h"

#include <QCoreApplication>
#include <QImage>
#include <QPoint>
#include <QPushButton>
#include <QRect>
#include <QTest>

#include <cmath>

using namespace espalier;

/// The user begins new trees of several sizes at the real window.
class NewTreeTest : public test::WindowFixture {
    Q_OBJECT

public:
    NewTreeTest() : WindowFixture({1200, 800}) {}

private Q_SLOTS:
    void size_setsViewBrushAndInternodes_data();
    void size_setsViewBrushAndInternodes();
    void size_isKeptForNewTreesAndOfferedOnBlankPagesOnly();
    void startFromThis_opensAtTheTreesScaleWithItsNameAndBrush();
    void person_standsBesideTheTreeAndIsInNoPicture();
    void scaleBar_isRound();

private:
    SizeChoices& sizes() { return workspace().sizeChoices(); }
    /// Height of the world that the view shows at the seedling, m.
    double shownHeight();
    void click(const QWidget& widget);
    void choose(TreeSize size);
};

double NewTreeTest::shownHeight()
{
    const Camera& camera = viewport().mainCamera();
    return camera.viewSize().height() / double{camera.pixelsPerMetre(camera.depth(Vec3::Zero()))};
}

void NewTreeTest::click(const QWidget& widget)
{
    QVERIFY(widget.isVisible());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, widget.mapTo(m_window.get(), widget.rect().center()));
    QCoreApplication::processEvents();
}

void NewTreeTest::choose(TreeSize size)
{
    QTRY_VERIFY(sizes().isVisible());
    click(*sizes().findChildren<BarButton*>().at(static_cast<int>(size)));
}

void NewTreeTest::size_setsViewBrushAndInternodes_data()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < kTreeSizeCount; ++i)
        QTest::newRow(sizePreset(static_cast<TreeSize>(i)).key) << i;
}

void NewTreeTest::size_setsViewBrushAndInternodes()
{
    QFETCH(int, number);
    const auto size = static_cast<TreeSize>(number);
    const TreeSizePreset& preset = sizePreset(size);
    choose(size);
    QVERIFY(std::abs(shownHeight() - preset.viewHeight) < 0.01 * preset.viewHeight);
    QCOMPARE(m_window->viewSettings().values().brushRadius, preset.brushRadius);
    const TreeParameters& parameters = m_window->document().parameters();
    QCOMPARE(parameters.growth.internodeLength, preset.internodeLength);
    QCOMPARE(parameters.leaves.length, preset.leafLength);
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(m_window->document().index().livingCount(), 1U);
    // The whole tree shows: what is above ground, with a little room.
    const auto top = viewport().mainCamera().project(Vec3(0.0F, static_cast<float>(preset.height), 0.0F));
    QVERIFY(top && viewport().clearRect().contains(top->toPoint()));
    QVERIFY(parameters == parametersOfSize(size));
    QVERIFY(size != TreeSize::StreetTree || parameters == TreeParameters());
}

void NewTreeTest::size_isKeptForNewTreesAndOfferedOnBlankPagesOnly()
{
    choose(TreeSize::ForestTree);
    const double radius = 0.8;
    m_window->viewSettings().set(&ViewValues::brushRadius, radius);
    action(ActionId::New)->trigger();
    QCOMPARE(m_window->document().parameters(), parametersOfSize(TreeSize::ForestTree));
    QVERIFY(std::abs(shownHeight() - sizePreset(TreeSize::ForestTree).viewHeight) < 0.5);
    // What the user has set is not changed by a new tree of the same size.
    QCOMPARE(m_window->viewSettings().values().brushRadius, radius);
    QCOMPARE(Settings().treeSize(), TreeSize::ForestTree);
    QVERIFY(sizes().isVisible());

    QTest::keyClick(handle(), Qt::Key_G);
    QTRY_VERIFY(m_window->document().undoStack().count() == 1 && !m_window->growRunner().isRunning());
    QTRY_VERIFY(!sizes().isVisible());
    // Choosing a size would take the redo.
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_window->document().index().livingCount(), 1U);
    QVERIFY(!sizes().isVisible());
    QTest::keyClick(handle(), Qt::Key_N, Qt::ControlModifier);
    QTRY_VERIFY(sizes().isVisible());
}

void NewTreeTest::startFromThis_opensAtTheTreesScaleWithItsNameAndBrush()
{
    const auto start = [&](const char* recipe) {
        QTest::keyClick(handle(), Qt::Key_L, Qt::ControlModifier);
        LibraryPanel& library = workspace().library();
        QTRY_VERIFY(library.isVisible());
        library.showSection(LibraryPanel::Section::Species);
        const QString file = QStringLiteral(":/recipes/%1.json").arg(QLatin1String(recipe));
        QTRY_VERIFY((library.choose(file), library.chosen() == file));
        click(*library.findChild<QPushButton*>(QStringLiteral("start")));
        QTRY_VERIFY(!library.isVisible());
    };
    start("bonsai");
    QVERIFY2(shownHeight() < 2.0, qPrintable(QString::number(shownHeight())));
    QVERIFY(m_window->viewSettings().values().brushRadius < 0.3);
    QVERIFY(m_window->windowTitle().contains(QStringLiteral("Bonsai")));
    QVERIFY(m_window->files().file().fileName().isEmpty() && !m_window->isWindowModified());
    QVERIFY(!sizes().isVisible());
    start("oak");
    QVERIFY2(shownHeight() > 6.0 && shownHeight() < 14.0, qPrintable(QString::number(shownHeight())));
    QVERIFY(m_window->viewSettings().values().brushRadius > 0.4);
    QVERIFY(m_window->windowTitle().contains(QStringLiteral("Oak")));
}

void NewTreeTest::person_standsBesideTheTreeAndIsInNoPicture()
{
    choose(TreeSize::StreetTree);
    QTRY_VERIFY(viewport().isAtRest());
    const Camera& camera = viewport().mainCamera();
    const Vec3 foot = personPlace(Box3()) * camera.right();
    const QPointF low = *camera.project(foot);
    const QPointF high = *camera.project(foot + static_cast<float>(kPersonHeight) * Vec3::UnitY());
    const double height = low.y() - high.y();
    const QPoint chest = (high + 0.3 * (low - high)).toPoint();
    const QRect wide(chest - QPoint(static_cast<int>(height), 1), QSize(static_cast<int>(2.0 * height), 3));
    const auto shown = [&] { return viewport().grabFramebuffer(); };
    const QImage without = shown();
    const QImage picture = viewport().grabPicture();
    QTest::keyClick(handle(), Qt::Key_H);
    QVERIFY(m_window->viewSettings().values().personShown);
    const QImage with = shown();
    QVERIFY(with.pixelColor(chest) != without.pixelColor(chest));
    // As broad as a person: a shoulder's breadth, not a disc.
    int broad = 0;
    for (int x = wide.left(); x <= wide.right(); ++x)
        broad += with.pixelColor(x, chest.y()) != without.pixelColor(x, chest.y());
    QVERIFY2(broad > 0.2 * height && broad < 0.45 * height, qPrintable(QString::number(broad / height)));
    QCOMPARE(viewport().grabPicture(), picture);
    QTest::keyClick(handle(), Qt::Key_H);
    QVERIFY(!m_window->viewSettings().values().personShown);
    QCOMPARE(shown().pixelColor(chest), without.pixelColor(chest));
}

void NewTreeTest::scaleBar_isRound()
{
    QCOMPARE(scaleBarLength(1.3), 1.0);
    QCOMPARE(scaleBarLength(4.9), 2.0);
    QCOMPARE(scaleBarLength(5.0), 5.0);
    QCOMPARE(scaleBarLength(0.07), 0.05);
    setUnits(Units::Imperial);
    const double foot = scaleBarLength(1.6 * kFoot);
    const double inches = scaleBarLength(7.0 * kInch);
    setUnits(Units::Metric);
    QCOMPARE(foot, kFoot);
    QCOMPARE(inches, 6.0 * kInch);
    QCOMPARE(roundLengthText(2.0), QStringLiteral("2 m"));
    QCOMPARE(roundLengthText(1.75), QStringLiteral("1.75 m"));
    QCOMPARE(roundLengthText(0.5), QStringLiteral("50 cm"));
}

static const test::TestClass<NewTreeTest> newTreeTest;

#include "NewTreeTest.moc"
