// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that makes what a person sees, and makes it anew in another language.
#include "app/MainWindow.h"
#include "app/Tour.h"
#include "panels/BrushPanel.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPanel.h"
#include "panels/HistoryPanel.h"
#include "panels/LassoPopOut.h"
#include "panels/Notice.h"
#include "panels/ParameterPanel.h"
#include "panels/RingMenu.h"
#include "panels/SettingsSheet.h"
#include "panels/SizeChoices.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/library/LibraryPanel.h"
#include "views/Viewport.h"
#include "views/tools/RecipeTool.h"

#include <QCursor>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>

namespace espalier {

namespace {

constexpr int kThumbnailEdge = 256;

/// Whether a font of the system has the letters of the language that the program speaks.
bool hasLetters()
{
    return QLocale().language() != QLocale::Japanese ||
           !QFontDatabase::families(QFontDatabase::Japanese).isEmpty();
}

} // namespace

QImage MainWindow::thumbnail()
{
    const QImage whole = m_workspace->viewport().grabPicture();
    const int edge = std::min(whole.width(), whole.height());
    // The tree is in the part of the view that panes leave free.
    const QPointF share = m_workspace->viewport().mainCamera().targetShare();
    const auto begin = [edge](int length, double at) {
        return std::clamp(static_cast<int>(length * at) - edge / 2, 0, length - edge);
    };
    const QRect middle(begin(whole.width(), share.x()), begin(whole.height(), share.y()), edge, edge);
    return whole.copy(middle).scaled(kThumbnailEdge, kThumbnailEdge, Qt::KeepAspectRatio,
                                     Qt::SmoothTransformation);
}

void MainWindow::makeInterface()
{
    m_workspace = std::make_unique<Workspace>(m_document, m_viewSettings, m_actions,
                                              [this](QMenu& menu) { m_files->fillRecentFiles(menu); });
    setCentralWidget(m_workspace.get());
    if (m_files) {
        m_files->setNotice(m_workspace->notice());
    } else {
        m_files = std::make_unique<FileController>(*this, m_document, m_settings, m_workspace->notice(),
                                                   [this] { return thumbnail(); });
        m_files->file().setLookOfNewTrees(m_settings.lookOfNewTrees());
    }
    m_library = std::make_unique<LibraryController>(m_workspace->library(), *m_files, m_workspace->notice(),
                                                    Library(m_settings.libraryFolder()));
    m_looks = std::make_unique<LookController>(
        m_document, m_settings, m_workspace->notice(), [this] { return isBusy(); }, *this);
    m_scene = std::make_unique<SceneController>(SceneController::Parts{.document = m_document,
                                                                       .file = m_files->file(),
                                                                       .viewSettings = m_viewSettings,
                                                                       .settings = m_settings,
                                                                       .panel = m_workspace->background(),
                                                                       .notice = m_workspace->notice(),
                                                                       .window = *this});
    m_pictures =
        std::make_unique<PictureController>(PictureController::Parts{.files = *m_files,
                                                                     .settings = m_settings,
                                                                     .viewSettings = m_viewSettings,
                                                                     .viewport = m_workspace->viewport(),
                                                                     .notice = m_workspace->notice(),
                                                                     .window = *this});
    connect(m_looks.get(), &LookController::pictureDropped, m_scene.get(), &SceneController::takePicture);
    for (int i = 0; i < Workspace::kSheetCount; ++i) {
        if (auto* sheet = qobject_cast<ParameterPanel*>(&m_workspace->sheet(i))) {
            connect(sheet, &ParameterPanel::imageAsked, m_looks.get(), &LookController::choose);
            connect(sheet, &ParameterPanel::imageDropped, m_looks.get(), &LookController::take);
        }
    }
    m_profiles = std::make_unique<ProfileController>(
        m_document, m_workspace->profilePanel(), [this] { return isBusy(); },
        [this] { m_workspace->viewport().update(); });
    m_sketching = std::make_unique<SketchController>(
        m_document, m_viewSettings, m_workspace->sketchPopOut(), [this] { return isBusy(); },
        [this](const QString& what) { m_workspace->notice().showInformation(what); });
    m_leaves = std::make_unique<LeafController>(m_document, m_workspace->viewport(),
                                                m_workspace->leafChoices(), [this] { return isBusy(); });
    m_reproducing = std::make_unique<ReproduceController>(
        m_document, m_viewSettings, m_workspace->reproducePopOut(), [this] { return isBusy(); },
        [this](const QString& what) { m_workspace->notice().showInformation(what); });
    connect(m_workspace.get(), &Workspace::wayBackAsked, this, &MainWindow::backToOwnTree);
    m_workspace->showWayBack(m_files->isAside());
    m_another = std::make_unique<AnotherController>(
        AnotherController::Parts{.document = m_document,
                                 .settings = m_viewSettings,
                                 .viewport = m_workspace->viewport(),
                                 .panel = m_workspace->another(),
                                 .notice = m_workspace->notice(),
                                 .isBusy = [this] { return isBusy(); },
                                 .show = [this](bool shown) { m_workspace->showAnother(shown); }});
    connect(m_actions[ActionId::Another], &QAction::triggered, m_another.get(), &AnotherController::toggle);
    SizeChoices& sizes = m_workspace->sizeChoices();
    connect(&sizes, &SizeChoices::sizeAsked, m_files.get(), qOverload<TreeSize>(&FileController::startNew));
    sizes.setSize(m_settings.treeSize());
    connectPopOuts();
    connectViewport();
    if (hasLetters())
        return;
    // In English, because the user could not read it otherwise.
    m_workspace->notice().ask(
        QStringLiteral(
            "No font of this system has Japanese letters, so they are shown as boxes. Install such a "
            "font, for example Noto Sans CJK, or use Espalier in English."),
        QStringLiteral("Use English"), QStringLiteral("Keep Japanese"), [this](bool isEnglish) {
            if (!isEnglish)
                return;
            Preferences preferences = m_preferences;
            preferences.language = QStringLiteral("en");
            prefer(preferences);
            if (auto* open = findChild<SettingsSheet*>())
                open->setPreferences(preferences);
        });
}

void MainWindow::makeHelp(bool isSample)
{
    m_help = std::make_unique<HelpController>(HelpController::Parts{.workspace = *m_workspace,
                                                                    .actions = m_actions,
                                                                    .document = m_document,
                                                                    .file = m_files->file(),
                                                                    .viewSettings = m_viewSettings,
                                                                    .recipeRunner = m_recipeRunner,
                                                                    .stage = *this,
                                                                    .settings = m_settings},
                                              isSample);
}

void MainWindow::remakeInterface()
{
    m_workspace->viewport().finishGesture();
    auto* sheet = findChild<SettingsSheet*>();
    const std::optional<QPoint> sheetPlace = sheet ? std::optional(sheet->pos()) : std::nullopt;
    const QString control = sheet && sheet->focusWidget() ? sheet->focusWidget()->objectName() : QString();
    delete sheet;
    const Camera camera = m_workspace->viewport().mainCamera();
    const double seedlingView = m_workspace->viewport().seedlingView();
    const QString helpPage = m_workspace->isHelpShown() ? m_workspace->help().page() : QString();
    const LibraryPanel::Section section = m_workspace->library().section();
    const bool isMoreShown = m_workspace->architecture().isMoreShown();
    const int tourStep = m_help->tour().step();
    const bool isSample = m_help->isSample();

    m_help.reset();
    m_library.reset();
    m_another.reset();
    m_looks.reset();
    m_scene.reset();
    m_pictures.reset();
    m_sketching.reset();
    m_leaves.reset();
    // The tool in hand refers to the profiles, or to what takes its figures.
    m_workspace.reset();
    m_profiles.reset();
    m_reproducing.reset();
    // What is made from now on takes its locale from the window.
    unsetLocale();
    m_actions.setTexts();
    makeInterface();
    makeHelp(isSample);

    if (m_recipeRunner.isRunning()) {
        Viewport& viewport = m_workspace->viewport();
        viewport.setTool(
            std::make_unique<RecipeTool>(viewport.toolContext(), [this] { return m_recipeRunner.moment(); }));
        updateTip();
    } else {
        takeTool();
    }
    m_workspace->growPopOut().setPlaying(m_timeRunner.isPlaying());
    m_workspace->lassoPopOut().setGrowing(m_lassoRunner.isRunning());
    m_workspace->architecture().showMore(isMoreShown);
    m_workspace->library().showSection(section);
    m_workspace->setInterfaceHidden(m_actions[ActionId::HideInterface]->isChecked());
    m_workspace->showHistory(m_actions[ActionId::History]->isChecked());
    if (m_actions[ActionId::Library]->isChecked()) {
        m_library->refresh();
        m_workspace->showLibrary(true);
    }
    showCheckedSheet();
    if (!helpPage.isEmpty()) {
        m_workspace->help().showPage(helpPage);
        m_workspace->showHelp(true);
    }
    suitHand();
    updateTitle();
    updateEnabled();
    m_workspace->show();
    m_workspace->viewport().setSeedlingView(seedlingView);
    m_workspace->viewport().setCamera(camera);
    if (tourStep >= 0)
        m_help->tour().start(tourStep);
    if (sheetPlace) {
        SettingsSheet& again = showSettings();
        again.move(*sheetPlace);
        if (auto* same = again.findChild<QWidget*>(control))
            same->setFocus();
    } else {
        m_workspace->viewport().setFocus();
    }
}

void MainWindow::connectPopOuts()
{
    GrowPopOut& growPopOut = m_workspace->growPopOut();
    connect(&growPopOut, &GrowPopOut::holdBegins, &m_growRunner, &GrowRunner::begin);
    connect(&growPopOut, &GrowPopOut::holdEnds, &m_growRunner, &GrowRunner::release);
    connect(&growPopOut, &GrowPopOut::stepsAsked, &m_growRunner, &GrowRunner::run);
    connect(&growPopOut, &GrowPopOut::timeMoved, &m_timeRunner, &TimeRunner::moveTo);
    connect(&growPopOut, &GrowPopOut::timeReleased, &m_timeRunner, &TimeRunner::release);
    connect(&growPopOut, &GrowPopOut::timeCancelled, &m_timeRunner, &TimeRunner::cancel);
    connect(&growPopOut, &GrowPopOut::playToggled, this,
            [this](bool plays) { plays ? m_timeRunner.play() : m_timeRunner.release(); });
    connect(&m_timeRunner, &TimeRunner::runningChanged, &growPopOut, [this, &growPopOut](bool runs) {
        growPopOut.setPlaying(m_timeRunner.isPlaying());
        if (!runs)
            growPopOut.stopDrag();
    });

    LassoPopOut& lassoPopOut = m_workspace->lassoPopOut();
    connect(&lassoPopOut, &LassoPopOut::regrowAsked, this, [this] {
        if (!isBusy())
            m_lassoRunner.regrow();
    });
    connect(&lassoPopOut, &LassoPopOut::removeAsked, this, [this] {
        if (!isBusy())
            removeEnvelopes(m_document);
    });
    connect(&lassoPopOut, &LassoPopOut::stopAsked, &m_lassoRunner, &LassoRunner::end);
    connect(&m_lassoRunner, &LassoRunner::runningChanged, &lassoPopOut, &LassoPopOut::setGrowing);
}

void MainWindow::connectViewport()
{
    Viewport& viewport = m_workspace->viewport();
    connect(&m_workspace->history(), &HistoryPanel::indexAsked, &m_undoRunner, &UndoRunner::goTo);
    // What a tool picks must be there when it changes the tree.
    connect(&viewport, &Viewport::toolAboutToBegin, &m_undoRunner, &UndoRunner::finish);
    connect(&m_strandRunner, &StrandRunner::meshed, &viewport, &Viewport::showStrands);
    connect(&m_strandRunner, &StrandRunner::cancelled, &viewport,
            [&viewport] { viewport.showStrands(nullptr, ~std::uint64_t{0}); });
    connect(&m_strandRunner, &StrandRunner::progressed, &m_workspace->notice(), [this](double share) {
        Notice& notice = m_workspace->notice();
        // Messages, questions and the progress of other tasks stay.
        if (notice.isHidden() || notice.showsProgressOf(m_strandRunner))
            notice.showProgress(m_strandRunner, tr("Building the wood from strands"), share,
                                [this] { m_strandRunner.cancel(); });
    });
    connect(&m_strandRunner, &StrandRunner::ended, &m_workspace->notice(),
            [this] { m_workspace->notice().finishProgress(m_strandRunner); });
    const auto showFibres = [this] { m_strandRunner.setFibresShown(m_viewSettings.values().fibresShown); };
    connect(&m_viewSettings, &ViewSettings::changed, &viewport, showFibres);
    showFibres();
    m_strandRunner.ask(); // The interface may be made anew around a tree with strands
    // An eraser or another hand's gesture must find the tree at rest.
    connect(&viewport, &Viewport::gestureActiveChanged, &m_lassoRunner, [this](bool active) {
        if (active)
            m_lassoRunner.end();
    });
    // A gesture ends a time-lapse that is playing, and begins at the moment that is shown.
    connect(&viewport, &Viewport::gestureActiveChanged, &m_timeRunner, &TimeRunner::release);
    // It also ends growth, unless it is the gesture that lets the tree grow: otherwise both would be one undo
    // step.
    connect(&viewport, &Viewport::gestureActiveChanged, this, [this, &viewport](bool active) {
        if (active && !(toolInHand() == ActionId::Grow && viewport.tool().isActive()))
            m_growRunner.end();
    });
    connect(&viewport, &Viewport::gestureActiveChanged, this, &MainWindow::updateEnabled);
    connect(&viewport, &Viewport::gestureActiveChanged, &m_heldToolKey, &HeldToolKey::setGestureActive);
    connect(&viewport, &Viewport::fingersTapped, this, [this](int fingers) {
        if (fingers == 2)
            m_actions[ActionId::Undo]->trigger();
        else if (fingers == 3)
            m_actions[ActionId::Redo]->trigger();
        else
            m_actions[ActionId::HideInterface]->trigger();
    });
    connect(&viewport, &Viewport::menuAsked, m_ringMenu, [this](const QPoint& place) {
        // The release of a button that is held would go to the ring.
        if (!isBusy() && QGuiApplication::mouseButtons() == Qt::NoButton)
            m_ringMenu->openAt(place);
    });
    QAction* ring = m_actions[ActionId::ToolRing];
    ring->setAutoRepeat(false);
    connect(ring, &QAction::triggered, m_workspace.get(), [this, ring, &viewport] {
        if (isBusy() || viewport.isPointerDown() || QGuiApplication::mouseButtons() != Qt::NoButton)
            return;
        const QPoint pointer = QCursor::pos();
        const bool isOverTree = viewport.clearRect().contains(viewport.mapFromGlobal(pointer));
        const QKeySequence keys = ring->shortcut();
        m_ringMenu->openAt(isOverTree ? pointer : viewport.mapToGlobal(viewport.clearRect().center()),
                           keys.isEmpty() ? 0 : keys[0].key());
    });
    connect(m_actions[ActionId::FrameAll], &QAction::triggered, &viewport, &Viewport::frameAll);
    const std::pair<ActionId, NamedView> views[] = {{ActionId::FrontView, NamedView::Front},
                                                    {ActionId::SideView, NamedView::Side},
                                                    {ActionId::TopView, NamedView::Top},
                                                    {ActionId::ThreeQuarterView, NamedView::ThreeQuarter}};
    for (const auto& [id, view] : views)
        connect(m_actions[id], &QAction::triggered, &viewport,
                [&viewport, side = view] { viewport.showFrom(side); });
    connect(m_actions[ActionId::HideInterface], &QAction::toggled, m_workspace.get(),
            &Workspace::setInterfaceHidden);
    connect(m_actions[ActionId::History], &QAction::toggled, m_workspace.get(), &Workspace::showHistory);
    connect(m_actions[ActionId::NextPane], &QAction::triggered, m_workspace.get(), &Workspace::focusNextPane);
    connect(&m_workspace->brushSheet(), &BrushPanel::pressureExponentEdited, this, [this](double exponent) {
        Preferences preferences = m_preferences;
        preferences.pressureExponent = exponent;
        prefer(preferences);
        if (auto* open = findChild<SettingsSheet*>())
            open->setPreferences(preferences);
    });
    QAction* library = m_actions[ActionId::Library];
    connect(&m_workspace->library(), &LibraryPanel::closeAsked, library,
            [library] { library->setChecked(false); });
}

} // namespace espalier
