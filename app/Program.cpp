// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Program.h"

#include "app/Demo.h"
#include "app/HelpController.h"
#include "app/Language.h"
#include "app/Log.h"
#include "app/MainWindow.h"
#include "app/TerminationSignals.h"
#include "app/cli/BatchJob.h"
#include "app/cli/CommandLine.h"
#include "app/cli/Display.h"
#include "app/files/Settings.h"
#include "model/base/Memory.h"
#include "panels/Theme.h"
#include "views/Viewport.h"
#include "views/render/GlResources.h"

#include <QApplication>
#include <QDir>
#include <QIcon>
#include <QSysInfo>

#include <tbb/global_control.h>

#include <cstdio>
#include <cstdlib>
#include <optional>

namespace espalier {

namespace {

void nameProgram()
{
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier"));
    QCoreApplication::setApplicationVersion(QStringLiteral(ESPALIER_VERSION));
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Espalier"));
    QGuiApplication::setDesktopFileName(QStringLiteral("espalier"));
}

/// Prints only fatal messages of Qt: without a window, the standard error is for the program's own messages.
void onlyFatal(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    if (type == QtCriticalMsg || type == QtFatalMsg)
        complain(message);
    if (type == QtFatalMsg)
        std::abort();
}

ExitCode runWithoutWindow(const QStringList& arguments)
{
    const Result<CommandLine> line = parseCommandLine(arguments);
    if (!line) {
        complain(QCoreApplication::translate("Program", "%1; see espalier --help").arg(line.error().message));
        return kUsage;
    }
    switch (line->verb) {
    case CommandLine::Verb::Help:
        std::fputs(commandLineHelp().toUtf8().constData(), stdout);
        return kDone;
    case CommandLine::Verb::Version:
        std::printf("Espalier %s\n", ESPALIER_VERSION);
        return kDone;
    default:
        return runBatchJob(*line);
    }
}

int runWindow(const CommandLine& line, QApplication& application)
{
    std::optional<Recipe> demo;
    if (line.verb == CommandLine::Verb::Demo) {
        Result<Recipe> recipe = readRecipe(line.inputs.value(0, kDemoRecipe));
        if (!recipe) {
            complain(recipe.error().message);
            return kInputUnreadable;
        }
        demo = std::move(*recipe);
    }
    Log::open();
    Log::note(QStringLiteral("Espalier %1 begins: Qt %2, %3, %4, platform %5")
                  .arg(QStringLiteral(ESPALIER_VERSION), QString::fromLatin1(qVersion()),
                       QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(),
                       QGuiApplication::platformName()));
    Log::catchCrashes(
        QCoreApplication::translate("Program", "What you did is in a safety copy in %1; the next start "
                                               "offers it. The fault is described in %2.")
            .arg(QDir::toNativeSeparators(Autosave::folder()), QDir::toNativeSeparators(Log::fileName())));
    theme::apply(application, Settings().preferences().look);
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/espalier.svg")));
    MainWindow window;
    const TerminationSignals terminationSignals;
    QObject::connect(&terminationSignals, &TerminationSignals::asked, &window, &MainWindow::leaveAtOnce);
    window.show();
    Viewport& viewport = window.workspace().viewport();
    QObject::connect(
        &viewport, &QOpenGLWidget::frameSwapped, &viewport,
        [&viewport] { Log::note(viewport.glDescription()); }, Qt::SingleShotConnection);
    if (demo && isDisplayVirtual()) {
        demonstrateUnseen(window, *demo);
    } else if (demo) {
        window.playRecipe(*demo, RecipeRunner::Pace::OfTheHand);
    } else {
        // Recovery after a crash comes before the tour.
        if (line.inputs.isEmpty() && Autosave::leftovers().empty() && !isDisplayVirtual())
            window.help().startFirstTour();
        if (!line.inputs.isEmpty())
            window.files().openFile(line.inputs.constFirst());
        window.files().offerRecovery(Recovery::Occasion::Start);
    }
    const int code = QApplication::exec();
    Log::note(QStringLiteral("Espalier ends"));
    Log::close();
    return code;
}

} // namespace

int runProgram(int argc, char** argv)
{
    keepFreedMemory();
    nameProgram();
    QStringList arguments;
    for (int i = 1; i < argc; ++i) {
        arguments.append(QString::fromLocal8Bit(argv[i]));
        // Different names could otherwise become the same one.
        if (arguments.constLast().toLocal8Bit() != argv[i]) {
            complain(QStringLiteral("\"%1\" is not valid UTF-8; rename the file").arg(arguments.constLast()));
            return kUsage;
        }
    }
    const Result<CommandLine> line = parseCommandLine(arguments);

    std::optional<tbb::global_control> threads;
    if (line && line->threads > 0)
        threads.emplace(tbb::global_control::max_allowed_parallelism,
                        static_cast<std::size_t>(line->threads));

    const bool opensWindow = line && line->needsDisplay() && line->picture.isEmpty();
    if (!opensWindow)
        qInstallMessageHandler(onlyFatal);
    if (line && line->verb == CommandLine::Verb::Sketch && !line->needsDisplay()) {
        // Drawings are read with a painter, which wants an application with fonts, but no display.
        qputenv("QT_QPA_PLATFORM", "offscreen");
        QGuiApplication application(argc, argv);
        speakLanguage(Settings().preferences().language);
        return runWithoutWindow(arguments);
    }
    if (!line || !line->needsDisplay()) {
        QCoreApplication application(argc, argv);
        speakLanguage(Settings().preferences().language);
        return runWithoutWindow(arguments);
    }
    if (const QString problem = displayProblem(); !problem.isEmpty()) {
        complain(line->picture.isEmpty() ? problem : QStringLiteral("%1: %2").arg(line->picture, problem));
        return kOutputNotWritten;
    }
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    if (!opensWindow) {
        QGuiApplication application(argc, argv);
        speakLanguage(Settings().preferences().language);
        return runWithoutWindow(arguments);
    }
    Settings().scaleInterface();
    // A stroke has all the places of its pointer, also those that wait while a picture is drawn.
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication application(argc, argv);
    speakLanguage(Settings().preferences().language);
    return runWindow(*line, application);
}

} // namespace espalier
