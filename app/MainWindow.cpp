// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/HistoryLimit.h"
#include "app/Language.h"
#include "app/Log.h"
#include "commands/recipe/JournalRecipe.h"
#include "panels/BrushPanel.h"
#include "panels/HelpPanel.h"
#include "panels/Notice.h"
#include "panels/ParameterPanel.h"
#include "panels/ReportSheet.h"
#include "panels/RingMenu.h"
#include "panels/SettingsSheet.h"
#include "panels/Theme.h"
#include "panels/library/LibraryPanel.h"
#include "views/Viewport.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QScreen>
#include <QSysInfo>

namespace espalier {

namespace {

QString droppedFile(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    const QString name = urls.size() == 1 ? urls.constFirst().toLocalFile() : QString();
    return FileController::canOpen(name) ? name : QString();
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_growRunner(m_document),
      m_lassoRunner(m_document),
      m_timeRunner(m_document),
      m_recipeRunner(m_document),
      m_undoRunner(m_document),
      m_strandRunner(m_document),
      m_actions(*this),
      m_focusKeeper(*this, [this] { return m_workspace ? &m_workspace->viewport() : nullptr; }),
      m_heldToolKey(m_actions),
      m_ringMenu(new RingMenu(m_actions, this))
{
    setMinimumSize(920, 680);
    setAcceptDrops(true);
    ViewValues view = m_settings.viewValues();
    view.isThemeLight = theme::isLight();
    m_viewSettings.setValues(view);
    // The program has its colours and its language already.
    const Preferences preferences = m_settings.preferences();
    m_preferences.look = preferences.look;
    m_preferences.language = preferences.language;
    m_preferences.units = preferences.units;
    setUnits(preferences.units);
    makeInterface();
    connectFiles();
    connectTools();
    connectView();
    connectLibrary();
    followDocument();
    limitHistory();
    apply(preferences);
    m_files->startNew();
    m_actions[ActionId::Brush]->trigger();
    updateTitle();
    updateEnabled();
    makeHelp(false);
    m_workspace->viewport().setFocus();
    if (!restoreGeometry(m_settings.windowGeometry()))
        resize(sizeHint().boundedTo(screen()->availableSize()));
}

MainWindow::~MainWindow()
{
    cancelAll();
    // What a file being written has to tell goes to parts of the window.
    m_files->file().waitForSaving();
    m_files->file().disconnect(this);
    // The stack tells of its own end, when what would listen has gone.
    m_document.undoStack().disconnect(this);
}

void MainWindow::connectFiles()
{
    // A stroke under the hand ends first. The controller asks about growth, which goes on until the answer. A
    // recipe that is playing may be left, but nothing half-played is kept.
    const auto leave = [this](ActionId id, void (FileController::*what)()) {
        connect(m_actions[id], &QAction::triggered, this, [this, what] {
            m_workspace->viewport().finishGesture();
            (m_files.get()->*what)();
        });
    };
    leave(ActionId::New, qOverload<>(&FileController::startNew));
    leave(ActionId::Open, &FileController::open);
    const auto keep = [this](ActionId id, const std::function<void()>& what) {
        connect(m_actions[id], &QAction::triggered, this, [this, what] {
            if (m_recipeRunner.isRunning())
                return;
            const auto keepNow = [this, what] {
                finishHand();
                what();
            };
            const bool wasFilling = m_lassoRunner.isRunning();
            m_workspace->viewport().finishGesture();
            // A lasso's stroke that has just ended fills its envelope first.
            if (m_lassoRunner.isRunning() && !wasFilling)
                connect(&m_lassoRunner, &LassoRunner::runningChanged, this, keepNow,
                        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
            else
                keepNow();
        });
    };
    keep(ActionId::Save, [this] { m_files->save(); });
    keep(ActionId::SaveAs, [this] { m_files->saveAs(); });
    keep(ActionId::SaveRecipe, [this] { m_files->saveAsRecipe(); });
    keep(ActionId::Export, [this] { m_files->exportTree(); });
    keep(ActionId::SavePicture, [this] { m_pictures->ask(); });
    keep(ActionId::Report, [this] { reportProblem(); });
    keep(ActionId::CopyPicture, [this] { m_pictures->copyShown(); });
    keep(ActionId::BringBack, [this] { m_files->offerRecovery(Recovery::Occasion::Asked); });
    connect(m_actions[ActionId::Settings], &QAction::triggered, this, [this] { showSettings(); });
    connect(m_actions[ActionId::Quit], &QAction::triggered, this, &QWidget::close);
    connect(m_files.get(), &FileController::aboutToAsk, this, [this] {
        m_workspace->viewport().finishGesture();
        m_undoRunner.finish();
    });
    m_files->setWorkInHand({.isUnderWay = [this] { return hasUnfinishedWork(); },
                            .finish =
                                [this] {
                                    m_recipeRunner.stop();
                                    finishHand();
                                }});
    connect(m_files.get(), &FileController::aboutToReplace, this, &MainWindow::cancelAll);
    connect(m_files.get(), &FileController::asideChanged, this,
            [this] { m_workspace->showWayBack(m_files->isAside()); });
    connect(m_files.get(), &FileController::newTreeBegins, this, [this](const NewTree& tree) {
        m_workspace->viewport().setSeedlingView(tree.viewHeight);
        // A tree like another has its size.
        m_offersSizes = tree.name.isEmpty();
        updateEnabled();
        if (tree.brushRadius > 0.0)
            m_viewSettings.set(&ViewValues::brushRadius, tree.brushRadius);
    });
    connect(m_files.get(), &FileController::scenePrepared, this,
            [this](const std::shared_ptr<PreparedScene>& scene) {
                if (scene)
                    m_workspace->viewport().expect(std::move(*scene));
            });
    connect(m_files.get(), &FileController::recipeOpened, this,
            [this](const Recipe& recipe) { playRecipe(recipe, RecipeRunner::Pace::Hurried); });
    connect(&m_files->file(), &DocumentFile::titleChanged, this, [this] {
        updateTitle();
        updateEnabled();
    });
}

void MainWindow::connectView()
{
    const std::pair<ActionId, bool ViewValues::*> switches[] = {
        {ActionId::Markers, &ViewValues::markersShown},
        {ActionId::Leaves, &ViewValues::leavesShown},
        {ActionId::Person, &ViewValues::personShown},
        {ActionId::SecondView, &ViewValues::secondViewShown},
        {ActionId::Fibres, &ViewValues::fibresShown}};
    for (const auto& [id, field] : switches) {
        QAction* action = m_actions[id];
        const auto show = [this, action, shown = field] {
            action->setChecked(m_viewSettings.values().*shown);
        };
        connect(action, &QAction::triggered, this,
                [this, shown = field](bool on) { m_viewSettings.set(shown, on); });
        connect(&m_viewSettings, &ViewSettings::changed, action, show);
        show();
    }

    auto* group = new QActionGroup(this);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (const ActionId id : Actions::sheets())
        group->addAction(m_actions[id]);
    connect(group, &QActionGroup::triggered, this, &MainWindow::showCheckedSheet);
    connect(m_actions[ActionId::FullScreen], &QAction::triggered, this, [this](bool on) {
        setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
    });
}

void MainWindow::connectLibrary()
{
    QAction* action = m_actions[ActionId::Library];
    connect(action, &QAction::toggled, this, [this](bool shown) {
        if (shown) {
            finishHand();
            m_library->refresh();
        }
        m_workspace->showLibrary(shown);
    });
    connect(m_actions[ActionId::Help], &QAction::triggered, action, [action] { action->setChecked(false); });
    connect(m_files.get(), &FileController::aboutToReplace, action, [action] { action->setChecked(false); });
}

void MainWindow::showCheckedSheet()
{
    const std::span<const ActionId> sheets = Actions::sheets();
    const auto checked =
        std::ranges::find_if(sheets, [this](ActionId id) { return m_actions[id]->isChecked(); });
    m_workspace->showSheet(checked == sheets.end() ? -1 : static_cast<int>(checked - sheets.begin()));
}

SettingsSheet& MainWindow::showSettings()
{
    m_workspace->viewport().finishGesture();
    if (auto* open = findChild<SettingsSheet*>()) {
        open->activateWindow();
        return *open;
    }
    auto* sheet = new SettingsSheet(m_preferences, this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setInterfaceScale(m_settings.interfaceScale());
    connect(sheet, &SettingsSheet::preferencesEdited, this, &MainWindow::prefer);
    connect(sheet, &SettingsSheet::interfaceScaleEdited, this,
            [this](int percent) { m_settings.setInterfaceScale(percent); });
    sheet->show();
    return *sheet;
}

void MainWindow::reportProblem()
{
    constexpr qsizetype kLogBytes = 20'000;
    m_workspace->viewport().finishGesture();
    const QScreen& screen = *this->screen();
    const Tree& tree = m_document.tree();
    const QStringList facts{
        QStringLiteral("Espalier %1, Qt %2")
            .arg(QStringLiteral(ESPALIER_VERSION), QString::fromLatin1(qVersion())),
        QStringLiteral("%1, %2, %3")
            .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(),
                 QGuiApplication::platformName()),
        m_workspace->viewport().glDescription(),
        QStringLiteral("Screen %1 × %2, scale %3; window %4 × %5")
            .arg(screen.size().width())
            .arg(screen.size().height())
            .arg(devicePixelRatioF())
            .arg(width())
            .arg(height()),
        QStringLiteral("Tree of %1 internodes, %2 of them living, with %3 steps of history")
            .arg(tree.size())
            .arg(m_document.index().livingCount())
            .arg(m_document.journal().size() + m_document.future().size()),
        QString(),
        QStringLiteral("Log:"),
        Log::tail(kLogBytes)};
    const auto recipe = [this] {
        const Result<Recipe> made = recipeOf(m_files->file().snapshot());
        return made ? QString::fromUtf8(writeRecipe(*made)) : made.error().message;
    };
    auto* sheet = new ReportSheet(facts.join(QLatin1Char('\n')), recipe, this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
}

void MainWindow::prefer(const Preferences& preferences)
{
    m_settings.setPreferences(preferences);
    apply(preferences);
}

void MainWindow::apply(const Preferences& preferences)
{
    const Preferences before = std::exchange(m_preferences, preferences);
    if (preferences.look != before.look) {
        theme::apply(*qApp, preferences.look);
        m_viewSettings.set(&ViewValues::isThemeLight, theme::isLight());
        m_workspace->help().showPage(m_workspace->help().page());
    }
    if (preferences.language != before.language)
        speakLanguage(preferences.language);
    setUnits(preferences.units);
    // The sheet of settings, which is made anew as well, is telling of it.
    if (preferences.language != before.language || preferences.units != before.units)
        QMetaObject::invokeMethod(this, &MainWindow::remakeInterface, Qt::QueuedConnection);
    suitHand();
    m_historyLimit->setMost(preferences.undoBytes());
    if (preferences.libraryFolder != before.libraryFolder)
        m_library->setFolder(m_settings.libraryFolder());
}

void MainWindow::suitHand()
{
    m_workspace->setToolsRight(m_preferences.areToolsRight);
    m_workspace->viewport().setMouseScheme(m_preferences.mouse);
    m_workspace->viewport().setPressureExponent(m_preferences.pressureExponent);
    m_workspace->viewport().setStabilising(m_preferences.stabilising);
    m_workspace->brushSheet().setPressureExponent(m_preferences.pressureExponent);
}

void MainWindow::followDocument()
{
    connect(&m_document, &TreeDocument::lookChanged, &m_viewSettings,
            [this] { m_viewSettings.setLook(m_document.look()); });
    connect(&m_viewSettings, &ViewSettings::changed, &m_document,
            [this] { m_document.setLook(m_viewSettings.values()); });
    connect(&m_document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        // A stack takes another limit while it is empty, as it is now.
        if (change.kind == TreeChange::Kind::Reset)
            m_document.undoStack().setUndoLimit(m_preferences.undoSteps);
    });
    QUndoStack& stack = m_document.undoStack();
    connect(m_actions[ActionId::Undo], &QAction::triggered, this, &MainWindow::undo);
    connect(m_actions[ActionId::Redo], &QAction::triggered, this, [this] {
        if (!isBusy())
            m_undoRunner.redo();
    });
    connect(&stack, &QUndoStack::indexChanged, this, &MainWindow::updateEnabled);
    connect(&stack, &QUndoStack::indexChanged, this, &MainWindow::updateTip);
    connect(&m_document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (change.kind == TreeChange::Kind::Reset)
            updateTip();
    });
}

void MainWindow::limitHistory()
{
    m_historyLimit = std::make_unique<HistoryLimit>(
        m_document,
        [this] {
            return isBusy() || m_files->file().isSaving() || m_workspace->viewport().isBetweenGestures();
        },
        [this] { return m_workspace->viewport().shownStrands(); });
    connect(m_historyLimit.get(), &HistoryLimit::scenePrepared, this,
            [this](const std::shared_ptr<PreparedScene>& scene) {
                m_workspace->viewport().expect(std::move(*scene));
            });
    connect(m_historyLimit.get(), &HistoryLimit::shortened, this, [this] {
        Notice& notice = m_workspace->notice();
        const auto tell = [this, &notice] {
            notice.showInformation(
                tr("The oldest steps of the history were dropped, so that it takes no more than %1 MB.")
                    .arg(m_preferences.undoMemory));
        };
        if (notice.isAsking())
            connect(&notice, &Notice::closed, this, tell,
                    static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
        else
            tell();
    });
}

void MainWindow::updateTitle()
{
    const DocumentFile& file = m_files->file();
    setWindowTitle(tr("%1[*] – Espalier").arg(file.displayName()));
    // Until a file is whole, nothing is saved.
    const bool isModified = file.isModified() || file.isSaving();
    setWindowModified(isModified);
    m_workspace->topBar().setTitle(file.displayName(), isModified);
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isActiveWindow() && m_files)
        m_files->lookAtDisk();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayLeave()) {
        event->ignore();
        return;
    }
    cancelAll();
    m_settings.setViewValues(m_viewSettings.values());
    m_settings.setWindowGeometry(saveGeometry());
    event->accept();
}

void MainWindow::leaveAtOnce()
{
    m_recipeRunner.stop();
    finishHand();
    m_document.interruptEdit();
    m_files->leave();
    m_settings.setViewValues(m_viewSettings.values());
    m_settings.setWindowGeometry(saveGeometry());
    QCoreApplication::exit();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedFile(*event->mimeData()).isEmpty() || !droppedImage(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    if (const QString image = droppedImage(*event->mimeData()); !image.isEmpty()) {
        event->acceptProposedAction();
        m_looks->askAndTake(image);
        return;
    }
    const QString name = droppedFile(*event->mimeData());
    if (name.isEmpty())
        return;
    event->acceptProposedAction();
    m_files->openFile(name);
}

} // namespace espalier
