// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how long an event waits for the window at most, while the window works: "xvfb-run -s '-screen 0
// 1600x1000x24' build/release/bin/espalier_responsiveness_bench [INTERNODES]". OpenGL's time belongs to the
// graphics card and does not count: the functions that draw and send data do nothing here.
#include "app/MainWindow.h"
#include "commands/recipe/GrowOperation.h"
#include "panels/Theme.h"
#include "tests/bench/Crowns.h"
#include "views/Viewport.h"
#include "views/render/GlResources.h"

#include <QApplication>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <GL/gl.h>
#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <thread>
#include <vector>

namespace {

void doNothing() {}

} // namespace

/// Replaces the function of the OpenGL library, which Qt calls for every OpenGL function.
extern "C" __attribute__((visibility("default"))) void (*glXGetProcAddress(const GLubyte* name))()
{
    using Resolve = void (*(*)(const GLubyte*))();
    static const auto resolve = reinterpret_cast<Resolve>(dlsym(RTLD_NEXT, "glXGetProcAddress"));
    const auto* text = reinterpret_cast<const char*>(name);
    const auto is = [text](const char* prefix) {
        return std::strncmp(text, prefix, std::strlen(prefix)) == 0;
    };
    const bool draws = is("glDraw") && !is("glDrawBuffer");
    const bool sends = is("glBufferData") || is("glBufferSubData") || is("glTexSubImage3D");
    if (draws || sends || is("glBlitFramebuffer"))
        return &doNothing;
    return resolve(name);
}

namespace espalier {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBeat(3);
constexpr int kRecipeSteps = 40; ///< Of growth

/// Lets the window process events for a while.
void live(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Posts an event every few milliseconds, as a pen does, and records how long each waits.
class Heart : public QObject {
public:
    Heart()
        : m_thread([this](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  QCoreApplication::postEvent(this, new Beat);
                  std::this_thread::sleep_for(kBeat);
              }
          })
    {
    }

    std::vector<double> take() { return std::exchange(m_waits, {}); }

protected:
    void customEvent(QEvent* event) override
    {
        const Clock::duration wait = Clock::now() - static_cast<Beat*>(event)->posted;
        m_waits.push_back(std::chrono::duration<double, std::milli>(wait).count());
    }

private:
    struct Beat : QEvent {
        Beat() : QEvent(QEvent::User) {}
        Clock::time_point posted = Clock::now();
    };

    std::vector<double> m_waits; ///< ms
    std::jthread m_thread;
};

/// Notes the processor time that the longest event takes: what others do on the machine does not count.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (m_depth > 0)
            return QApplication::notify(receiver, event);
        ++m_depth;
        const double before = threadTime();
        const QByteArray name(receiver->metaObject()->className());
        const QEvent::Type type = event->type();
        const bool isHandled = QApplication::notify(receiver, event);
        const double took = 1000.0 * (threadTime() - before);
        --m_depth;
        if (took > m_longest) {
            m_longest = took;
            m_description = name + ' ' + QByteArray::number(type);
        }
        return isHandled;
    }

    /// ms
    double takeLongest() { return std::exchange(m_longest, 0.0); }
    /// The class of its receiver, and its type.
    const QByteArray& description() const { return m_description; }

private:
    static double threadTime()
    {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    int m_depth = 0;
    double m_longest = 0.0;
    QByteArray m_description;
};

class Bench {
public:
    Bench(TimedApplication& application, std::uint32_t internodes) : m_application(application)
    {
        m_window.resize(1440, 900);
        m_window.show();
        if (!QTest::qWaitForWindowExposed(&m_window))
            qFatal("There is no display.");
        test::growTo(m_window.document(), internodes);
        settle();
    }

    void run()
    {
        MainWindow& w = m_window;
        std::printf("%-34s %9s %8s %8s %8s %8s %8s\n", "while", "internodes", "median", "99 %", "worst",
                    "> 50 ms", "event");
        QWidget& viewport = w.workspace().viewport();
        const QPoint middle = viewport.rect().center();

        w.actions()[ActionId::Grow]->trigger();
        measure("the tree grows", [&] {
            QTest::mousePress(&viewport, Qt::LeftButton, {}, middle);
            live(4000);
            QTest::mouseRelease(&viewport, Qt::LeftButton, {}, middle);
        });
        measure("that is undone", [&] {
            w.undoRunner().undo();
            live(500);
        });
        measure("all of it is undone", [&] {
            w.undoRunner().goTo(0);
            live(1500);
        });
        measure("all of it is redone", [&] {
            w.undoRunner().redo();
            live(1500);
        });
        for (const ActionId id :
             {ActionId::Architecture, ActionId::LeafSheet, ActionId::BranchSheet, ActionId::Background}) {
            measure(qPrintable(QStringLiteral("opens %1").arg(w.actions()[id]->text())), [&] {
                w.actions()[id]->trigger();
                live(300);
            });
        }
        w.actions()[ActionId::Architecture]->trigger();
        measure("grows, a panel is open", [&] {
            QTest::mousePress(&viewport, Qt::LeftButton, {}, {middle.x(), viewport.height() - 200});
            live(3000);
            QTest::mouseRelease(&viewport, Qt::LeftButton, {}, {middle.x(), viewport.height() - 200});
        });
        w.document().undoStack().undo();
        measure("a brush draws on it", [&] {
            w.actions()[ActionId::Brush]->trigger();
            drag(viewport, [&](double t) { return middle + QPoint(static_cast<int>(300.0 * t), -100); });
        });
        measure("a lasso is filled", [&] {
            w.actions()[ActionId::Lasso]->trigger();
            drag(viewport, [&](double t) {
                const double angle = 2.0 * std::numbers::pi * t;
                return middle + QPoint(static_cast<int>(200.0 * std::cos(angle)),
                                       static_cast<int>(200.0 * std::sin(angle)));
            });
            live(2500);
            w.actions()[ActionId::Cancel]->trigger();
        });
        QTemporaryDir folder;
        measure("it is saved", [&] {
            w.files().keepIn(folder.filePath(QStringLiteral("tree.espalier")));
            live(2500);
        });
        measure("it is opened", [&] {
            w.files().file().setUnmodified();
            bool isOpened = false;
            QObject::connect(
                &w.files(), &FileController::opened, &w, [&isOpened] { isOpened = true; },
                Qt::SingleShotConnection);
            w.files().openFile(folder.filePath(QStringLiteral("tree.espalier")));
            if (!QTest::qWaitFor([&] { return isOpened; }, 60'000))
                qFatal("The file was not opened.");
            live(1500);
        });
        measure("a recipe plays", [&] {
            Recipe recipe;
            recipe.operations.push_back(GrowOperation{.steps = kRecipeSteps});
            w.playRecipe(recipe, RecipeRunner::Pace::Hurried);
            if (!QTest::qWaitFor([&] { return !w.recipeRunner().isRunning(); }, 120'000))
                qFatal("The recipe did not end.");
        });
        measure("saved while it grows", [&] {
            w.growRunner().begin();
            w.files().keepIn(folder.filePath(QStringLiteral("tree.espalier")));
            live(2500);
            w.growRunner().end();
        });
    }

private:
    /// Moves the mouse for a second and a half.
    template <class Path>
    static void drag(QWidget& widget, Path&& path)
    {
        constexpr int kMoves = 100;
        QTest::mousePress(&widget, Qt::LeftButton, {}, path(0.0));
        for (int i = 1; i <= kMoves; ++i) {
            live(15);
            QTest::mouseMove(&widget, path(static_cast<double>(i) / kMoves));
        }
        QTest::mouseRelease(&widget, Qt::LeftButton, {}, path(1.0));
    }

    void settle() { live(1500); }

    template <class Work>
    void measure(const char* what, Work&& work)
    {
        settle();
        m_heart.take();
        m_application.takeLongest();
        work();
        live(300);
        std::vector<double> waits = m_heart.take();
        std::ranges::sort(waits);
        const auto late = std::ranges::count_if(waits, [](double wait) { return wait > 50.0; });
        std::printf("%-34s %9u %8.1f %8.1f %8.1f %8td %8.1f  %s\n", what,
                    m_window.document().index().livingCount(), test::median(waits),
                    waits[waits.size() * 99 / 100], waits.back(), late, m_application.takeLongest(),
                    m_application.description().constData());
        std::fflush(stdout);
    }

    TimedApplication& m_application;
    MainWindow m_window;
    Heart m_heart;
};

} // namespace

} // namespace espalier

int main(int argc, char** argv)
{
    using namespace espalier;
    QTemporaryDir home;
    for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
        qputenv(name, home.path().toLocal8Bit());
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    TimedApplication application(argc, argv);
    theme::apply(application, Preferences().look);
    Bench bench(application, argc > 1 ? static_cast<std::uint32_t>(QByteArray(argv[1]).toUInt()) : 95'000);
    bench.run();
}
