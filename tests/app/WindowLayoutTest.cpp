// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"
#include "app/MainWindow.h"
#include "commands/SetParameters.h"
#include "panels/HelpPanel.h"
#include "panels/PictureSheet.h"
#include "panels/RotationStrip.h"
#include "panels/SettingsSheet.h"
#include "panels/Sideways.h"
#include "panels/Theme.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/architecture/DiagramHandle.h"
#include "panels/library/LibraryPanel.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WidgetKinds.h"
#include "views/Viewport.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QImage>
#include <QLabel>
#include <QLatin1Char>
#include <QLatin1String>
#include <QMenu>
#include <QPixmap>
#include <QPoint>
#include <QRect>
#include <QScrollBar>
#include <QSettings>
#include <QSize>
#include <QTest>
#include <QWidget>

using namespace espalier;

/// Layout of the window: no widget lies over another one, and all are large enough for a finger.
class WindowLayoutTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { m_window.reset(); }
    void panes_overlapNothing_data();
    void panes_overlapNothing();
    void sheets_leaveTheTreeInView();
    void panes_leaveWhatWasSeenInView_data();
    void panes_leaveWhatWasSeenInView();
    void turnBesideHelp_keepsTheTreeInItsRoom();
    void targets_areLargeEnoughForAFinger();
    void title_isLegibleInASmallWindow();
    void icons_areCrispAtAnyScale();

private:
    QAction* action(ActionId id) { return m_window->actions()[id]; }
    Workspace& workspace() { return m_window->workspace(); }
    /// Opens each pane, and some of them together, and calls @p look each time.
    void visitAll(const std::function<void(const QByteArray& name)>& look);

    std::unique_ptr<MainWindow> m_window;
};

namespace {

/// Names two widgets that overlap; empty if none do. Cards in a scrolling sheet are compared at their places
/// in it.
QString overlapIn(const QWidget& parent)
{
    QList<QWidget*> shown;
    for (QWidget* widget : parent.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (widget->isVisible() && !widget->isWindow())
            shown << widget;
    }
    for (qsizetype i = 0; i < shown.size(); ++i) {
        for (qsizetype j = 0; j < i; ++j) {
            const QRect both = shown[i]->geometry().intersected(shown[j]->geometry());
            if (!both.isEmpty())
                return QStringLiteral("%1 \"%2\" over %3 \"%4\" by %5 x %6 px")
                    .arg(QLatin1String(shown[i]->metaObject()->className()), shown[i]->objectName(),
                         QLatin1String(shown[j]->metaObject()->className()), shown[j]->objectName())
                    .arg(both.width())
                    .arg(both.height());
        }
    }
    return {};
}

/// Whether the widget is meant to lie over others.
bool liesOver(const QWidget& widget)
{
    return qobject_cast<const Viewport*>(&widget) || qobject_cast<const LibraryPanel*>(&widget);
}

QString overlapOf(const Workspace& workspace)
{
    QList<const QWidget*> panes;
    for (const QWidget* widget : workspace.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!widget->isVisible() || widget->isWindow() || liesOver(*widget))
            continue;
        // Where words stand over the strip, only its lower edge turns the view.
        if (!workspace.rect().contains(widget->geometry()))
            return QLatin1String(widget->metaObject()->className()) +
                   QStringLiteral(" is cut off by the window");
        panes << widget;
    }
    for (qsizetype i = 0; i < panes.size(); ++i) {
        for (qsizetype j = 0; j < i; ++j) {
            if (panes[i]->geometry().intersects(panes[j]->geometry()))
                return QLatin1String(panes[i]->metaObject()->className()) + QStringLiteral(" over ") +
                       QLatin1String(panes[j]->metaObject()->className());
        }
    }
    // Every layout within panes, down to rows.
    for (const QWidget* pane : panes) {
        for (const QWidget* holder : pane->findChildren<QWidget*>()) {
            if (!holder->isVisible() || !holder->layout())
                continue;
            if (const QString overlap = overlapIn(*holder); !overlap.isEmpty())
                return overlap;
        }
    }
    return {};
}

} // namespace

void WindowLayoutTest::initTestCase()
{
    QSettings().clear();
    theme::apply(*qApp);
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1024, 700);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    // Only places matter, not pictures.
    m_window->setUpdatesEnabled(false);
}

void WindowLayoutTest::visitAll(const std::function<void(const QByteArray& name)>& look)
{
    const auto show = [&](std::initializer_list<ActionId> ids) {
        QByteArray name;
        for (const ActionId id : ids) {
            if (!action(id)->isChecked())
                action(id)->trigger();
            name += action(id)->objectName().toUtf8() + ' ';
        }
        QCoreApplication::processEvents();
        look(name);
        for (const ActionId id : ids) {
            const bool isTool = std::ranges::find(Actions::tools(), id) != Actions::tools().end();
            if (!isTool && action(id)->isChecked())
                action(id)->trigger();
        }
    };
    for (const ActionId tool : {ActionId::Brush, ActionId::Grow, ActionId::Bend, ActionId::Lasso}) {
        for (const ActionId sheet : Actions::sheets()) {
            show({tool, sheet});
            show({tool, sheet, ActionId::History});
        }
        show({tool, ActionId::History});
    }
    show({ActionId::Library});
    workspace().architecture().showMore(true);
    show({ActionId::Architecture});
    workspace().architecture().showMore(false);
    action(ActionId::Help)->trigger();
    for (const ActionId sheet : Actions::sheets())
        show({ActionId::Brush, sheet});
    (void)m_window->help().putAway();
}

void WindowLayoutTest::panes_overlapNothing_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("toolsRight");
    QTest::newRow("small") << QSize(1024, 700) << false;
    QTest::newRow("small, tools on the right") << QSize(1024, 700) << true;
    QTest::newRow("ordinary") << QSize(1600, 1000) << false;
}

void WindowLayoutTest::panes_overlapNothing()
{
    QFETCH(const QSize, size);
    QFETCH(const bool, toolsRight);
    m_window->resize(size);
    workspace().setToolsRight(toolsRight);
    QStringList found;
    visitAll([&](const QByteArray& name) {
        if (const QString overlap = overlapOf(workspace()); !overlap.isEmpty())
            found << QString::fromUtf8(name) + overlap;
    });
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    m_window->resize(1024, 700);
    workspace().setToolsRight(false);
}

void WindowLayoutTest::sheets_leaveTheTreeInView()
{
    m_window->resize(1440, 900);
    Viewport& viewport = workspace().viewport();
    test::growAtRandom(m_window->document(), 3, 200, 400);
    viewport.setCamera(viewport.framed(viewport.mainCamera()));
    for (const GrowthModelKind model : {GrowthModelKind::TreeSketch, GrowthModelKind::Vigour}) {
        TreeParameters parameters = m_window->document().parameters();
        parameters.growth.model = model;
        setParameters(m_window->document(), parameters);
        QVERIFY(viewport.isTreeClear());
        const Camera before = viewport.mainCamera();
        for (const ActionId sheet : {ActionId::Architecture, ActionId::LeafSheet, ActionId::BranchSheet}) {
            const QByteArray name = action(sheet)->objectName().toUtf8();
            action(sheet)->trigger();
            QCoreApplication::processEvents();
            const int index =
                static_cast<int>(std::ranges::find(Actions::sheets(), sheet) - Actions::sheets().begin());
            const Bar& panel = workspace().sheet(index);
            QVERIFY2(panel.isVisible() && panel.height() < 2 * m_window->height() / 5, name);
            QVERIFY2(workspace().rect().contains(panel.geometry()), name);
            // All of it, but the drawings of one model: these scroll.
            const auto* scrolled = panel.findChild<Sideways*>();
            const bool hasDrawings = sheet == ActionId::Architecture && model == GrowthModelKind::TreeSketch;
            QVERIFY2(hasDrawings || scrolled->horizontalScrollBar()->maximum() == 0,
                     name + ' ' + QByteArray::number(scrolled->horizontalScrollBar()->maximum()));
            QVERIFY2(scrolled->widget()->height() <= scrolled->viewport()->height(),
                     name + ' ' + QByteArray::number(scrolled->widget()->height()) + " px in " +
                         QByteArray::number(scrolled->viewport()->height()));
            QTRY_VERIFY2(viewport.isTreeClear(), name);
        }
        action(ActionId::BranchSheet)->trigger();
        QTRY_VERIFY((viewport.mainCamera().target() - before.target()).norm() < 0.01F &&
                    std::abs(viewport.mainCamera().distance() / before.distance() - 1.0F) < 0.01F);
    }
    m_window->resize(1024, 700);
    m_window->document().reset(1, TreeParameters());
}

void WindowLayoutTest::panes_leaveWhatWasSeenInView_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("pane");
    for (const QSize& size : {QSize(1024, 700), QSize(1600, 1000)}) {
        for (const ActionId pane : {ActionId::Architecture, ActionId::BrushSheet, ActionId::LeafSheet,
                                    ActionId::BranchSheet, ActionId::Background, ActionId::History})
            QTest::addRow("%s at %d px", qPrintable(action(pane)->objectName()), size.width())
                << size << static_cast<int>(pane);
    }
}

void WindowLayoutTest::panes_leaveWhatWasSeenInView()
{
    QFETCH(const QSize, size);
    QFETCH(const int, pane);
    QAction* opened = action(static_cast<ActionId>(pane));
    m_window->resize(size);
    Viewport& viewport = workspace().viewport();
    test::growAtRandom(m_window->document(), 3, 200, 400);
    // The crown fills the picture, and the trunk is out of it.
    Camera crown = viewport.framed(Camera());
    crown.setDistance(0.5F * crown.distance());
    viewport.setCamera(crown);
    QVERIFY(!viewport.isTreeClear());
    const Camera before = viewport.mainCamera();
    const QRectF clear = QRectF(viewport.clearRect()).adjusted(1.0, 1.0, -1.0, -1.0);
    const std::array corners{clear.topLeft(), clear.topRight(), clear.bottomLeft(), clear.bottomRight()};
    opened->trigger();
    const auto isSeen = [&](const QPointF& place) {
        const auto now = viewport.cameraAtRest().project(before.onPlane(place, before.target()));
        return now && QRectF(viewport.clearRect()).contains(*now);
    };
    QVERIFY(QRectF(viewport.clearRect()).size() != clear.adjusted(-1.0, -1.0, 1.0, 1.0).size());
    QVERIFY(std::ranges::all_of(corners, isSeen));
    for (int i = 0; i < Workspace::kSheetCount; ++i)
        QVERIFY(!workspace().sheet(i).isVisible() ||
                !workspace().sheet(i).geometry().intersects(viewport.clearRect()));
    // Closed again, the canvas is back.
    opened->trigger();
    QCOMPARE(viewport.cameraAtRest(), before);
    m_window->resize(1024, 700);
    m_window->document().reset(1, TreeParameters());
}

void WindowLayoutTest::turnBesideHelp_keepsTheTreeInItsRoom()
{
    m_window->resize(1440, 900);
    Viewport& viewport = workspace().viewport();
    test::growAtRandom(m_window->document(), 3, 200, 400);
    viewport.setCamera(viewport.framed(Camera()));
    action(ActionId::Help)->trigger();
    QVERIFY(viewport.isTreeClear());
    for (const NamedView side : {NamedView::Side, NamedView::ThreeQuarter, NamedView::Front}) {
        viewport.showFrom(side);
        const auto base = viewport.cameraAtRest().project(Vec3::Zero());
        QVERIFY(base && QRectF(viewport.clearRect()).contains(*base));
        QVERIFY(std::abs(base->x() - QRectF(viewport.clearRect()).center().x()) < 120.0);
    }
    (void)m_window->help().putAway();
    m_window->resize(1024, 700);
    m_window->document().reset(1, TreeParameters());
}

void WindowLayoutTest::targets_areLargeEnoughForAFinger()
{
    QStringList small;
    const auto measure = [&](QWidget& pane, const QByteArray& name) {
        for (const QWidget* widget : test::widgetsToWorkWith(pane)) {
            const QSize target = test::targetOf(*widget);
            const bool isStrip = qobject_cast<const RotationStrip*>(widget); // As long as the window
            if (!isStrip && (target.width() < theme::kTarget || target.height() < theme::kTarget))
                small << QStringLiteral("%1%2 \"%3\" %4 has %5 x %6 px")
                             .arg(QString::fromUtf8(name), QLatin1String(widget->metaObject()->className()),
                                  widget->objectName(), widget->accessibleName())
                             .arg(target.width())
                             .arg(target.height());
        }
    };
    visitAll([&](const QByteArray& name) { measure(workspace(), name); });
    SettingsSheet settings({});
    settings.show();
    QVERIFY(QTest::qWaitForWindowExposed(&settings));
    measure(settings, "settings ");
    PictureSheet picture({}, {800, 600});
    picture.show();
    QVERIFY(QTest::qWaitForWindowExposed(&picture));
    measure(picture, "picture ");
    QMenu* menu = workspace().topBar().findChild<QMenu*>();
    menu->popup(m_window->mapToGlobal(QPoint(8, 50)));
    for (QAction* entry : menu->actions()) {
        if (!entry->isSeparator() && menu->actionGeometry(entry).height() < theme::kTarget)
            small << QStringLiteral("menu: ") + entry->text();
    }
    menu->hide();
    small.removeDuplicates();
    QVERIFY2(small.isEmpty(), qPrintable(small.join(QLatin1Char('\n'))));
}

void WindowLayoutTest::title_isLegibleInASmallWindow()
{
    workspace().topBar().setTitle(QStringLiteral("The old oak.espalier"), true);
    const auto* title = workspace().topBar().findChild<QLabel*>();
    QVERIFY2(title->width() >= 100 && title->text().size() > 8, qPrintable(title->text()));
    for (const BarButton* button : workspace().topBar().findChildren<BarButton*>()) {
        if (button->isVisible())
            QVERIFY(button->width() >= button->sizeHint().width());
    }
}

void WindowLayoutTest::icons_areCrispAtAnyScale()
{
    // At three pixels to one the icon is drawn again, not magnified.
    const QPixmap pixmap = action(ActionId::Prune)->icon().pixmap(QSize(24, 24), 3.0);
    QCOMPARE(pixmap.size(), QSize(72, 72));
    const QImage magnified =
        action(ActionId::Prune)->icon().pixmap(QSize(24, 24), 1.0).toImage().scaled(72, 72);
    QVERIFY(pixmap.toImage() != magnified.convertToFormat(pixmap.toImage().format()));
}

static const test::TestClass<WindowLayoutTest> windowLayoutTest;

#include "WindowLayoutTest.moc"
