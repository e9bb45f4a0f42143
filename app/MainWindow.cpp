// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/Language.h"
#include "panels/BrushPanel.h"
#include "panels/HelpPanel.h"
#include "panels/Notice.h"
#include "panels/ParameterPanel.h"
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
      m_actions(*this)
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
    // A stroke under the hand ends first. A recipe that is playing may be left, but nothing half-played is
    // kept.
    const auto leave = [this](ActionId id, void (FileController::*what)()) {
        connect(m_actions[id], &QAction::triggered, this, [this, what] {
            m_workspace->viewport().finishGesture();
            if (!isHandBusy())
                (m_files.get()->*what)();
        });
    };
    leave(ActionId::New, &FileController::startNew);
    leave(ActionId::Open, &FileController::open);
    const auto keep = [this](ActionId id, void (FileController::*what)()) {
        connect(m_actions[id], &QAction::triggered, this, [this, what] {
            if (m_recipeRunner.isRunning())
                return;
            const auto keepNow = [this, what] {
                finishHand();
                (m_files.get()->*what)();
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
    keep(ActionId::Save, &FileController::save);
    keep(ActionId::SaveAs, &FileController::saveAs);
    keep(ActionId::SaveRecipe, &FileController::saveAsRecipe);
    keep(ActionId::Export, &FileController::exportTree);
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
    connect(m_files.get(), &FileController::scenePrepared, this,
            [this](const std::shared_ptr<PreparedScene>& scene) {
                if (scene)
                    m_workspace->viewport().expect(std::move(*scene));
            });
    connect(m_files.get(), &FileController::recipeOpened, this,
            [this](const Recipe& recipe) { playRecipe(recipe, RecipeRunner::Pace::Hurried); });
    connect(&m_files->file(), &DocumentFile::titleChanged, this, &MainWindow::updateTitle);
}

void MainWindow::connectView()
{
    const std::pair<ActionId, bool ViewValues::*> switches[] = {
        {ActionId::Markers, &ViewValues::markersShown}, {ActionId::Leaves, &ViewValues::leavesShown}};
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
    connect(sheet, &SettingsSheet::preferencesEdited, this, &MainWindow::prefer);
    sheet->show();
    return *sheet;
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
    m_files->autosave().setInterval(preferences.autosaveInterval);
    if (preferences.libraryFolder != before.libraryFolder)
        m_library->setFolder(m_settings.libraryFolder());
}

void MainWindow::suitHand()
{
    m_workspace->setToolsRight(m_preferences.areToolsRight);
    m_workspace->viewport().setMouseScheme(m_preferences.mouse);
    m_workspace->viewport().setPressureExponent(m_preferences.pressureExponent);
    m_workspace->brushSheet().setPressureExponent(m_preferences.pressureExponent);
}

void MainWindow::followDocument()
{
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
}

<<<<<<< HEAD
/// What is under way becomes an undo step first, so that redo brings it back.
void MainWindow::undo()
{
    if (m_recipeRunner.isRunning())
        return;
    QUndoStack& stack = m_document.undoStack();
    const auto last = [&stack] { return stack.index() > 0 ? stack.command(stack.index() - 1) : nullptr; };
    const bool wasBusy = isHandBusy();
    const QUndoCommand* before = last();
    finishHand();
    // A gesture that has changed nothing yet is all that there was to undo.
    if (!wasBusy || last() != before)
        m_document.undo();
}

void MainWindow::playRecipe(const Recipe& recipe, RecipeRunner::Pace pace)
{
    cancelAll();
    Viewport& viewport = m_workspace->viewport();
    viewport.setTool(
        std::make_unique<RecipeTool>(viewport.toolContext(), [this] { return m_recipeRunner.player(); }));
    m_recipeRunner.start(recipe, pace);
    // A recipe may take back more than a person wants to.
    m_document.undoStack().setUndoLimit(0);
    m_files->file().forgetFile(recipe.name);
    m_files->autosave().clear();
    if (const Box3 strokes = strokeBounds(recipe); !strokes.isEmpty())
        viewport.setCamera(withHeadroom(viewport, strokes));
    updateEnabled();
    updateTip();
}

void MainWindow::showRecipeProgress()
{
    if (m_recipeRunner.isRunning() && m_recipeRunner.pace() == RecipeRunner::Pace::Hurried)
        m_workspace->notice().showProgress(tr("Growing %1").arg(m_files->file().displayName()),
                                           m_recipeRunner.player()->progress(), [this] { cancelAll(); });
}

void MainWindow::showRecipeWarnings()
{
    const QStringList warnings = m_recipeRunner.warnings();
    if (warnings.isEmpty())
        return;
    m_workspace->notice().showWarning(
        tr("%1 of %2 operations of the recipe found nothing to do, or not all that they name: %3")
            .arg(warnings.size())
            .arg(m_recipeRunner.operationCount())
            .arg(joinedFaults(warnings)));
}

void MainWindow::followRecipe()
{
    Viewport& viewport = m_workspace->viewport();
    viewport.update();
    if (m_followClock.isValid() && m_followClock.elapsed() < kFollowInterval)
        return;
    m_followClock.start();
    showRecipeProgress();
    const Box3 bounds = treeBounds(m_document.tree(), m_document.index());
    for (int corner = 0; corner < 8; ++corner) {
        const auto place = viewport.camera().project(bounds.corner(static_cast<Box3::CornerType>(corner)));
        if (!place || !QRectF(viewport.clearRect()).contains(*place)) {
            viewport.flyTo(withHeadroom(viewport, bounds));
            return;
        }
    }
}

bool MainWindow::isHandBusy() const
{
    return m_workspace->viewport().isGestureActive() || m_growRunner.isRunning() ||
           m_timeRunner.isRunning() || m_lassoRunner.isRunning();
}

bool MainWindow::mayLeave()
{
    m_workspace->viewport().finishGesture();
    return !isHandBusy() && m_files->mayLeave();
}

bool MainWindow::isBusy() const
{
    return isHandBusy() || m_recipeRunner.isRunning();
}

void MainWindow::finishHand()
{
    // A lasso's stroke begins to fill when it ends.
    m_workspace->viewport().finishGesture();
    m_growRunner.end();
    m_lassoRunner.end();
    m_timeRunner.release();
}

bool MainWindow::hasUnfinishedWork() const
{
    return m_document.edit() != nullptr && m_document.edit()->hasChanges();
}

void MainWindow::cancelAll()
{
    m_recipeRunner.stop();
    m_workspace->viewport().cancelGesture();
    m_growRunner.cancel();
    m_lassoRunner.cancel();
    m_timeRunner.cancel();
}

void MainWindow::cancel()
{
    if (isBusy()) {
        cancelAll();
        return;
    }
    if (m_workspace->viewport().keyForTool(Qt::Key_Escape))
        return;
    if (m_help->putAway())
        return;
    if (!m_document.competitors().areAll()) {
        m_document.setCompetitors({});
        return;
    }
    for (const ActionId id : Actions::sheets()) {
        if (m_actions[id]->isChecked())
            m_actions[id]->trigger();
    }
}

void MainWindow::updateEnabled()
{
    // Undo and redo are not shown disabled while a stroke is made: that would flicker.
    const QUndoStack& stack = m_document.undoStack();
    m_actions[ActionId::Undo]->setEnabled(stack.canUndo() || isHandBusy());
    m_actions[ActionId::Redo]->setEnabled(stack.canRedo());
    const bool isIdle = !m_recipeRunner.isRunning();
    for (const ActionId id : {ActionId::Save, ActionId::SaveAs, ActionId::SaveRecipe, ActionId::Export})
        m_actions[id]->setEnabled(isIdle);
    for (const ActionId id : Actions::tools())
        m_actions[id]->setEnabled(isIdle);
    // Only one thing at a time may change the document.
    m_workspace->viewport().setGrowing(m_growRunner.isRunning() || m_lassoRunner.isRunning() ||
                                       m_recipeRunner.isRunning());
    m_workspace->growPopOut().setEnabled(!m_recipeRunner.isRunning() &&
                                         !m_workspace->viewport().isGestureActive());
    // Parameters may change while the tree grows: growth knows how to wait for them.
    const bool isGrowing = m_growRunner.isRunning() || m_lassoRunner.isRunning();
    for (int i = 0; i < Workspace::kSheetCount; ++i) {
        // What changes the view or the hand alone is never in the way.
        Bar& sheet = m_workspace->sheet(i);
        if (&sheet != &m_workspace->background() && &sheet != &m_workspace->brushSheet())
            sheet.setEnabled(isGrowing || !isBusy());
    }
    m_workspace->brushSheet().setParametersEnabled(isGrowing || !isBusy());
    m_workspace->history().setEnabled(!isBusy());
    m_workspace->library().setMayKeep(!isBusy());
}

=======
>>>>>>> slices
void MainWindow::updateTitle()
{
    const DocumentFile& file = m_files->file();
    setWindowTitle(tr("%1[*] – Espalier").arg(file.displayName()));
    setWindowModified(file.isModified());
    m_workspace->topBar().setTitle(file.displayName(), file.isModified());
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isActiveWindow() && m_files)
        m_files->lookAtDisk();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    m_recipeRunner.stop();
    if (!m_files->mayLeave()) {
        event->ignore();
        return;
    }
    cancelAll();
    m_settings.setViewValues(m_viewSettings.values());
    m_settings.setWindowGeometry(saveGeometry());
    event->accept();
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
