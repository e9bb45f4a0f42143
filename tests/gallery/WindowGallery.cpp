// SPDX-License-Identifier: GPL-3.0-or-later
// Takes pictures of the real window with each of its panels, for a person to look at; scripts/gallery.sh runs
// it once for each size, theme, language and scale.
#include "app/HelpController.h"
#include "app/MainWindow.h"
#include "app/Tour.h"
#include "app/files/Outputs.h"
#include "panels/GrowPopOut.h"
#include "panels/Notice.h"
#include "panels/SettingsSheet.h"
#include "panels/Theme.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "views/Viewport.h"
#include "views/render/GlResources.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QLatin1Char>
#include <QLatin1String>
#include <QLocale>
#include <QMenu>
#include <QPoint>
#include <QPointF>
#include <QSettings>
#include <QSize>
#include <QSurfaceFormat>
#include <QTest>
#include <QTranslator>
#include <QWindow>

#include <cstdio>

using namespace espalier;

namespace {

class Photographer {
public:
    Photographer(const QSize& size, Look look)
    {
        Preferences preferences;
        preferences.look = look;
        Settings().setPreferences(preferences);
        Settings().setTourSeen(true);
        m_window = std::make_unique<MainWindow>();
        m_window->resize(size);
        m_window->show();
        m_window->activateWindow();
        if (!QTest::qWaitForWindowActive(m_window.get()))
            qFatal("the window does not come up");
        m_window->viewSettings().set(&ViewValues::shadowsShown, false);
    }
    ~Photographer() { m_window->files().file().setUnmodified(); }

    void takeAll()
    {
        shoot("empty");
        const Result<Recipe> recipe = readRecipe(QStringLiteral(":/recipes/bonsai.json"));
        if (!recipe)
            qFatal("%s", qPrintable(recipe.error().message));
        RecipePlayer(m_window->document(), *recipe).playAll();
        action(ActionId::FrameAll)->trigger();
        for (const ActionId id : Actions::sheets()) {
            action(id)->trigger();
            shoot(action(id)->objectName());
        }
        // Panels that are seldom open together.
        action(ActionId::Architecture)->trigger();
        action(ActionId::History)->trigger();
        shoot(QStringLiteral("architecture-history"));
        m_window->workspace().architecture().showMore(true);
        shoot(QStringLiteral("architecture-more"));
        m_window->workspace().architecture().showMore(false);
        action(ActionId::Architecture)->trigger();
        shoot(QStringLiteral("history"));
        action(ActionId::History)->trigger();
        for (const ActionId id : {ActionId::Grow, ActionId::Bend, ActionId::Lasso, ActionId::SelectBud}) {
            action(id)->trigger();
            shoot(action(id)->objectName());
        }
        shootAtWork();
        action(ActionId::Brush)->trigger();
        action(ActionId::Help)->trigger();
        shoot(QStringLiteral("help"));
        action(ActionId::LeafSheet)->trigger();
        shoot(QStringLiteral("help-leaves"));
        action(ActionId::LeafSheet)->trigger();
        (void)m_window->help().putAway();
        action(ActionId::Library)->trigger();
        shoot(QStringLiteral("library"));
        action(ActionId::Library)->trigger();
        m_window->workspace().setToolsRight(true);
        action(ActionId::Architecture)->trigger();
        action(ActionId::History)->trigger();
        shoot(QStringLiteral("right"));
        action(ActionId::History)->trigger();
        action(ActionId::Architecture)->trigger();
        m_window->workspace().setToolsRight(false);
        m_window->workspace().notice().showWarning(
            QStringLiteral("old-oak.espalier: journal/died: the column is shorter than the deltas say"));
        shoot(QStringLiteral("notice"));
        m_window->workspace().notice().finish();
        m_window->help().startTour();
        shoot(QStringLiteral("tour"));
        m_window->help().tour().stop();
        shootMenu();
        action(ActionId::Settings)->trigger();
        shoot(QStringLiteral("settings"));
    }

private:
    QAction* action(ActionId id) { return m_window->actions()[id]; }

    /// The overlays of the tools.
    void shootAtWork()
    {
        const QPoint middle = m_window->rect().center();
        const int reach = m_window->height() / 5;
        QWindow* handle = m_window->windowHandle();
        action(ActionId::Brush)->trigger();
        m_window->viewSettings().set(&ViewValues::brushRadius, 0.06); // Suits this small tree
        QTest::mousePress(handle, Qt::LeftButton, {}, middle + QPoint(reach, 0));
        for (int i = 0; i < 12; ++i)
            QTest::mouseMove(handle, middle + QPoint(reach + 5 * i, -4 * i), 20);
        shoot(QStringLiteral("at-work-brush"));
        QTest::keyClick(handle, Qt::Key_Escape);
        QTest::mouseRelease(handle, Qt::LeftButton, {}, middle);
        m_window->viewSettings().set(&ViewValues::brushRadius, ViewValues().brushRadius);
        action(ActionId::Lasso)->trigger();
        QTest::mousePress(handle, Qt::LeftButton, {}, middle + QPoint(0, reach));
        for (int i = 0; i < 30; ++i) {
            const double turn = 0.2 * i;
            QTest::mouseMove(handle,
                             middle + QPointF(reach * std::sin(turn), reach * std::cos(turn)).toPoint(), 5);
        }
        shoot(QStringLiteral("at-work-lasso"));
        QTest::keyClick(handle, Qt::Key_Escape);
        QTest::mouseRelease(handle, Qt::LeftButton, {}, middle);
        action(ActionId::Bend)->trigger();
        const QPoint trunk = placeOf(Vec3(0.0F, 0.06F, 0.0F));
        QTest::mousePress(handle, Qt::LeftButton, {}, trunk);
        for (int i = 0; i < 8; ++i)
            QTest::mouseMove(handle, trunk + QPoint(5 * i, 0), 10);
        shoot(QStringLiteral("at-work-bend"));
        QTest::keyClick(handle, Qt::Key_Escape);
        QTest::mouseRelease(handle, Qt::LeftButton, {}, trunk);
        for (const ActionId tool : {ActionId::Width, ActionId::Prune, ActionId::SelectBud}) {
            action(tool)->trigger();
            QTest::mouseMove(handle, trunk + QPoint(1, 1));
            QTest::mouseMove(handle, trunk);
            shoot(QStringLiteral("at-work-") + action(tool)->objectName());
        }
    }

    QPoint placeOf(const Vec3& point)
    {
        Viewport& viewport = m_window->workspace().viewport();
        return viewport.mapTo(m_window.get(),
                              viewport.mainCamera().project(point).value_or(QPointF()).toPoint());
    }

    void shootMenu()
    {
        auto* menu = m_window->workspace().topBar().findChild<QMenu*>();
        menu->popup(m_window->mapToGlobal(QPoint(8, 50)));
        shoot(QStringLiteral("menu"));
        menu->hide();
    }

    /// Takes the whole screen, because dialogs and menus are separate windows.
    void shoot(const QString& name)
    {
        QTest::qWait(250);
        (void)QTest::qWaitFor([this] { return m_window->workspace().viewport().isAtRest(); }, 2500);
        const QImage image = m_window->screen()->grabWindow(0).toImage();
        if (const Result<void> written = writePicture(image, name + QStringLiteral(".png")); !written)
            qFatal("%s", qPrintable(written.error().message));
        std::printf("%s\n", qPrintable(name));
        std::fflush(stdout);
    }

    std::unique_ptr<MainWindow> m_window;
};

} // namespace

int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-gallery"));
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 5 || !QDir::setCurrent(arguments[4])) {
        std::fprintf(stderr, "usage: window_gallery WIDTHxHEIGHT dark|light LANGUAGE FOLDER\n");
        return 2;
    }
    QSettings().clear();
    QTranslator translator;
    if (arguments[3] != QLatin1String("en")) {
        if (!translator.load(QStringLiteral(":/translations/espalier_%1.qm").arg(arguments[3])))
            qFatal("there is no language %s", qPrintable(arguments[3]));
        QCoreApplication::installTranslator(&translator);
        QLocale::setDefault(QLocale(arguments[3]));
    }
    const Look look = arguments[2] == QLatin1String("light") ? Look::Light : Look::Dark;
    theme::apply(application, look);
    const QStringList size = arguments[1].split(QLatin1Char('x'));
    Photographer(QSize(size.value(0).toInt(), size.value(1).toInt()), look).takeAll();
    return 0;
}
