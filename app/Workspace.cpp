// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Workspace.h"

#include "app/files/Library.h"
#include "app/files/Settings.h"
#include "model/mesh/TreeCounts.h"
#include "panels/AddBudsPopOut.h"
#include "panels/AnotherPanel.h"
#include "panels/BackgroundPanel.h"
#include "panels/BendPopOut.h"
#include "panels/BrushPanel.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPanel.h"
#include "panels/HistoryPanel.h"
#include "panels/LassoPopOut.h"
#include "panels/LeafChoices.h"
#include "panels/MultiplyPopOut.h"
#include "panels/Notice.h"
#include "panels/ParameterPanel.h"
#include "panels/ProfilePanel.h"
#include "panels/PrunePopOut.h"
#include "panels/ReproducePopOut.h"
#include "panels/RotationStrip.h"
#include "panels/SizeChoices.h"
#include "panels/SketchPopOut.h"
#include "panels/Theme.h"
#include "panels/TwistPopOut.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/library/LibraryPanel.h"
#include "views/Viewport.h"

#include <QLabel>
#include <QPushButton>

#include <cmath>
#include <utility>

namespace espalier {

namespace {

constexpr int kTopBarHeight = 50;
constexpr int kGap = 10;
constexpr int kStatusHeight = 60;
constexpr int kStatusMargin = 20;
/// Width that panes at the sides leave the tree at least, px.
constexpr int kLeastRoom = 200;
/// ms; the counts of a growing tree are not updated more often.
constexpr int kCountInterval = 200;

/// Whether two cameras show the same but for rounding: a flight does not end exactly where it leads.
bool isSameView(const Camera& camera, const Camera& other)
{
    constexpr float kRounding = 1e-3F;
    return (camera.target() - other.target()).norm() < kRounding * other.distance() &&
           std::abs(camera.distance() - other.distance()) < kRounding * other.distance() &&
           std::abs(camera.azimuth() - other.azimuth()) < kRounding &&
           std::abs(camera.elevation() - other.elevation()) < kRounding;
}

} // namespace

Workspace::Workspace(TreeDocument& document, ViewSettings& settings, const Actions& actions,
                     std::function<void(QMenu&)> fillRecentFiles, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_settings(settings),
      m_viewport(new Viewport(document, settings, this)),
      m_topBar(new TopBar(actions, std::move(fillRecentFiles), this)),
      m_sideBar(new SideBar(actions, this)),
      m_brushPopOut(new BrushPopOut(document, settings, this)),
      m_growPopOut(new GrowPopOut(document, this)),
      m_bendPopOut(new BendPopOut(settings, this)),
      m_lassoPopOut(new LassoPopOut(document, settings, this)),
      m_twistPopOut(new TwistPopOut(settings, this)),
      m_addBudsPopOut(new AddBudsPopOut(settings, this)),
      m_sketchPopOut(new SketchPopOut(settings, this)),
      m_multiplyPopOut(new MultiplyPopOut(settings, this)),
      m_reproducePopOut(new ReproducePopOut(settings, this)),
      m_prunePopOut(new PrunePopOut(settings, this)),
      m_profilePanel(new ProfilePanel(this)),
      m_architecture(new ArchitecturePanel(document, this)),
      m_brushSheet(new BrushPanel(document, settings, Preferences::kSoftest, Preferences::kFirmest, this)),
      m_background(new BackgroundPanel(settings, this)),
      m_history(new HistoryPanel(document.undoStack(), this)),
      m_leafChoices(new LeafChoices(this)),
      m_sizeChoices(new SizeChoices(this)),
      m_another(new AnotherPanel(this)),
      m_library(new LibraryPanel(libraryPicture, this)),
      m_help(new HelpPanel(this)),
      m_strip(new RotationStrip(this)),
      m_onlyOne(new QPushButton(tr("Only one bud grows  ✕"), this)),
      m_wayBack(new QPushButton(tr("Back to My Tree"), this)),
      m_notice(new Notice(this)),
      m_counts(new QLabel(this)),
      m_tip(new QLabel(this))
{
    m_sheets = {m_architecture, m_brushSheet, new ParameterPanel(document, ParameterSheet::Leaves, this),
                new ParameterPanel(document, ParameterSheet::Branches, this), m_background};
    connect(m_architecture, &ArchitecturePanel::sizeWanted, this, &Workspace::rearrange);
    connect(m_prunePopOut, &PrunePopOut::sizeWanted, this, &Workspace::rearrange);
    for (QLabel* label : {m_counts, m_tip}) {
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
        // Words over foliage stand on a veil.
        label->setProperty("overPicture", true);
    }
    m_tip->setObjectName(QStringLiteral("tip"));
    m_onlyOne->setObjectName(QStringLiteral("growAll"));
    m_onlyOne->setToolTip(tr("Let all buds grow again."));
    m_onlyOne->setMinimumHeight(theme::kTarget);
    connect(m_onlyOne, &QPushButton::clicked, this, [&document] { document.setCompetitors({}); });
    connect(&document, &TreeDocument::competitorsChanged, this, &Workspace::arrange);
    m_wayBack->setObjectName(QStringLiteral("wayBack"));
    m_wayBack->setToolTip(tr("Show your own tree again, as it was before this recipe was played."));
    m_wayBack->setMinimumHeight(theme::kTarget);
    connect(m_wayBack, &QPushButton::clicked, this, &Workspace::wayBackAsked);
    connect(m_viewport, &Viewport::cameraChanged, this,
            [this] { m_strip->setAzimuth(static_cast<double>(m_viewport->mainCamera().azimuth())); });
    connect(&settings, &ViewSettings::changed, this, &Workspace::followBackdrop);
    followBackdrop();
    connect(m_leafChoices, &LeafChoices::offerChanged, this, &Workspace::arrange);
    connect(m_notice, &Notice::resized, this, &Workspace::arrange);
    connect(m_notice, &Notice::closed, this, &Workspace::arrange);
    m_countTimer.setSingleShot(true);
    m_countTimer.setInterval(kCountInterval);
    connect(&m_countTimer, &QTimer::timeout, this, &Workspace::showCounts);
    connect(&document, &TreeDocument::changed, this, [this] {
        if (!m_countTimer.isActive())
            m_countTimer.start();
    });
    showCounts();
}

void Workspace::showPopOut(PopOut popOut)
{
    m_popOut = popOut;
    rearrange();
}

void Workspace::showSheet(int index)
{
    m_sheet = index;
    rearrange();
}

void Workspace::showHistory(bool shown)
{
    m_isHistoryShown = shown;
    rearrange();
}

void Workspace::showAnother(bool shown)
{
    m_isAnotherShown = shown;
    arrange();
}

void Workspace::showLibrary(bool shown)
{
    m_isLibraryShown = shown;
    arrange();
    if (shown)
        m_library->takeFocus();
    else
        m_viewport->setFocus();
}

void Workspace::showHelp(bool shown)
{
    m_isHelpShown = shown;
    rearrange();
}

void Workspace::rearrange()
{
    if (!m_viewport->isVisible()) {
        arrange();
        m_viewport->takeClearRect();
        return;
    }
    const QRect clear = m_viewport->clearRect();
    Beside beside{m_viewport->cameraAtRest(), clear, m_viewport->isTreeClear(), {}};
    // While the user leaves the view alone, it goes back to where it was before the first pane opened.
    if (m_beside && isSameView(beside.before, m_beside->shown))
        beside = *m_beside;
    arrange();
    if (m_viewport->clearRect() == clear)
        return;
    beside.shown = m_viewport->inRoom(beside.before, beside.clear, beside.wasTreeClear);
    m_viewport->flyTo(beside.shown);
    m_beside = beside;
    if (m_viewport->clearRect() == beside.clear)
        m_beside.reset();
}

void Workspace::showWayBack(bool shown)
{
    m_isWayBackShown = shown;
    arrange();
}

void Workspace::setToolsRight(bool right)
{
    m_areToolsRight = right;
    arrange();
}

void Workspace::setInterfaceHidden(bool hidden)
{
    m_isHidden = hidden;
    rearrange();
}

void Workspace::focusNextPane()
{
    QWidget* pane = m_sideBar;
    if (m_isHelpShown)
        pane = m_help;
    else if (m_sheet >= 0 && m_sheet < kSheetCount)
        pane = &sheet(m_sheet);
    if (m_isLibraryShown) {
        m_library->takeFocus();
        return;
    }
    if (!m_viewport->hasFocus() || !pane->isVisible()) {
        m_viewport->setFocus();
        return;
    }
    for (QWidget* widget : pane->findChildren<QWidget*>()) {
        if (widget->isEnabled() && widget->isVisible() && widget->focusPolicy() & Qt::TabFocus) {
            widget->setFocus(Qt::ShortcutFocusReason);
            return;
        }
    }
}

void Workspace::setBlank(bool blank)
{
    if (std::exchange(m_isBlank, blank) != blank)
        arrange();
}

void Workspace::setTip(const QString& tip)
{
    m_tip->setText(tip);
    arrange();
}

void Workspace::resizeEvent(QResizeEvent*)
{
    arrange();
    m_viewport->takeClearRect();
}

void Workspace::showCounts()
{
    const TreeCounts counts = countTree(m_document.tree(), m_document.index());
    m_counts->setText(counts.internodes == 1 ? tr("a seedling")
                                             : tr("%L1 internodes · %L2 leaves · step %L3")
                                                   .arg(counts.internodes)
                                                   .arg(counts.leaves)
                                                   .arg(counts.steps));
    arrange();
}

void Workspace::followBackdrop()
{
    const bool isLight = isBackdropLight(m_settings.values());
    for (QLabel* label : {m_counts, m_tip})
        theme::setTone(*label, isLight ? theme::Tone::OverLight : theme::Tone::OverDark);
    m_strip->setOverLight(isLight);
}

void Workspace::arrange()
{
    const bool shown = !m_isHidden && !m_isLibraryShown;
    m_viewport->setGeometry(rect());
    m_topBar->setGeometry(0, 0, width(), kTopBarHeight);
    m_topBar->setVisible(!m_isHidden);
    const int top = m_isHidden ? 0 : kTopBarHeight;
    m_library->setGeometry(0, top, width(), height() - top);
    m_library->setVisible(m_isLibraryShown);

    int y = kTopBarHeight + kGap;
    const int lowest = height() - kStatusHeight;
    // Everything else is placed to the left of the help.
    int right = width();
    if (m_isHelpShown && !m_isHidden) {
        const int helpWidth = HelpPanel::widthIn(width());
        right -= helpWidth + kGap;
        m_help->setGeometry(right, y, helpWidth, lowest - y);
    }
    m_help->setVisible(m_isHelpShown && shown);
    // Places are computed for tools on the left.
    const auto placed = [this, right](QRect place) {
        if (m_areToolsRight)
            place.moveLeft(right - place.x() - place.width());
        return place;
    };
    m_sideBar->fit(height() - Viewport::kStripHeight - y);
    const QRect tools(QPoint(kGap, y), m_sideBar->sizeHint());
    m_sideBar->setGeometry(placed(tools));
    m_sideBar->setVisible(shown);
    const int x = tools.right() + 1 + kGap;

    QRect sheetPlace;
    for (int i = 0; i < kSheetCount; ++i) {
        Bar& panel = sheet(i);
        panel.setVisible(shown && i == m_sheet);
        if (i != m_sheet)
            continue;
        const int room = right - x - kGap;
        if (&panel == m_architecture) {
            m_architecture->fit({room, height()});
            panel.move(placed(QRect(QPoint(x, y), panel.size())).topLeft());
        } else {
            const QSize wanted = panel.sizeHint();
            panel.setGeometry(placed({x, y, std::min(wanted.width(), room), wanted.height()}));
        }
        sheetPlace = panel.geometry();
        y = sheetPlace.bottom() + 1 + kGap;
    }

    const std::pair<QWidget*, PopOut> popOuts[] = {
        {m_brushPopOut, PopOut::Brush},       {m_growPopOut, PopOut::Grow},
        {m_bendPopOut, PopOut::Bend},         {m_lassoPopOut, PopOut::Lasso},
        {m_twistPopOut, PopOut::Twist},       {m_addBudsPopOut, PopOut::AddBuds},
        {m_profilePanel, PopOut::Profile},    {m_sketchPopOut, PopOut::Sketch},
        {m_multiplyPopOut, PopOut::Multiply}, {m_reproducePopOut, PopOut::Reproduce},
        {m_prunePopOut, PopOut::Prune}};
    const int lowestPopOut = height() - Viewport::kStripHeight - 4;
    QRect popOutPlace;
    for (const auto& [popOut, kind] : popOuts) {
        const int least = popOut->minimumSizeHint().height();
        const QSize size(popOut->sizeHint().width(),
                         std::clamp(lowestPopOut - y, least, popOut->sizeHint().height()));
        popOut->setGeometry(placed(QRect(QPoint(x, y), size)));
        // A small window has room for either a sheet or a pop-out; the brush's sheet has all controls of its
        // pop-out.
        const bool isOnSheet = popOut == m_brushPopOut && m_brushSheet->isVisibleTo(this);
        popOut->setVisible(shown && kind == m_popOut && !isOnSheet && y + least <= lowestPopOut);
        if (popOut->isVisibleTo(this))
            popOutPlace = popOut->geometry();
    }

    // The history is beside the sheet, or below a sheet that is as wide as the window.
    const QSize history = m_history->sizeHint();
    QRect historyPlace = placed({right - history.width() - kGap, kTopBarHeight + kGap, history.width(), 0});
    if (sheetPlace.right() + kGap >= historyPlace.left() && sheetPlace.left() - kGap <= historyPlace.right())
        historyPlace.moveTop(y);
    historyPlace.setHeight(std::min(history.height(), lowest - historyPlace.top()));
    m_history->setGeometry(historyPlace);
    m_history->setVisible(shown && m_isHistoryShown);
    // What could come next is beside the history.
    const QSize choices = m_leafChoices->sizeHint();
    const int choicesRight = (m_isHistoryShown ? history.width() + kGap : 0) + choices.width() + kGap;
    m_leafChoices->setGeometry(placed({right - choicesRight, y, choices.width(), choices.height()}));
    m_leafChoices->setVisible(shown && m_leafChoices->isOffering());
    // On a blank page the middle is free below the seedling, unless a notice is there.
    const QSize sizes = m_sizeChoices->sizeHint();
    const QRect sizesPlace({std::max((right - sizes.width()) / 2, x), lowest - sizes.height()}, sizes);
    m_sizeChoices->setGeometry(placed(sizesPlace));
    m_sizeChoices->setVisible(shown && m_isBlank && m_notice->isHidden() && sizesPlace.right() < right &&
                              !m_sizeChoices->geometry().intersects(sheetPlace) &&
                              !m_sizeChoices->geometry().intersects(popOutPlace));
    m_another->setPictureSize(AnotherPanel::pictureIn(size()));
    const QSize another = m_another->sizeHint();
    const int toolsRoom = m_areToolsRight ? 0 : x;
    m_another->setGeometry(toolsRoom + (right - x - another.width()) / 2,
                           kTopBarHeight + std::max((lowest - kTopBarHeight - another.height()) / 2, kGap),
                           another.width(), another.height());
    m_another->setVisible(shown && m_isAnotherShown);
    m_strip->setGeometry(0, height() - Viewport::kStripHeight, width(), Viewport::kStripHeight);
    m_strip->setVisible(shown);
    m_wayBack->adjustSize();
    m_wayBack->move((right - m_wayBack->width()) / 2, y);
    m_wayBack->setVisible(m_isWayBackShown && shown);
    m_onlyOne->adjustSize();
    m_onlyOne->move((right - m_onlyOne->width()) / 2,
                    m_wayBack->isHidden() ? y : m_wayBack->geometry().bottom() + 1 + kGap);
    m_onlyOne->setVisible(!m_isLibraryShown && !m_document.competitors().areAll());

    const int bottom = height() - Viewport::kStripHeight - 2;
    m_counts->adjustSize();
    m_tip->adjustSize();
    // Counts are on the side without a pop-out, the tip is on the side of the tools.
    QLabel* const left = m_areToolsRight ? m_counts : m_tip;
    QLabel* const farther = m_areToolsRight ? m_tip : m_counts;
    left->move(kStatusMargin, bottom - left->height());
    farther->move(width() - farther->width() - kStatusMargin, bottom - farther->height());
    m_counts->setVisible(shown);
    m_tip->setVisible(shown && !m_tip->text().isEmpty() && left->geometry().right() + kGap < farther->x() &&
                      !m_tip->geometry().intersects(popOutPlace));

    const int most = std::min(right - 2 * kGap, 860);
    m_notice->setMaximumWidth(most);
    m_notice->resize(std::min(m_notice->sizeHint().width(), most), 0);
    m_notice->resize(m_notice->width(),
                     std::max(m_notice->sizeHint().height(), m_notice->heightForWidth(m_notice->width())));
    m_notice->move((right - m_notice->width()) / 2, height() - m_notice->height() - 64);
    m_another->raise();
    m_library->raise();
    m_notice->raise();
    m_viewport->setFrameMargins(m_isHidden ? QMargins(0, kTopBarHeight, 0, kStatusHeight)
                                           : marginsBeside(right, sheetPlace));
}

QMargins Workspace::marginsBeside(int right, const QRect& sheetPlace) const
{
    QMargins margins(0, kTopBarHeight, width() - right, kStatusHeight);
    const bool isSheetOpen = m_sheet >= 0 && m_sheet < kSheetCount;
    const bool isProfileOpen = m_popOut == PopOut::Profile;
    if (!isSheetOpen && !isProfileOpen && !m_isHistoryShown && !m_isHelpShown)
        return margins;
    const auto room = [this](const QMargins& beside) { return rect().marginsRemoved(beside).size(); };
    // The history and the profile reach along the edge of the window, the others are small.
    const auto leaveAside = [&](const QRect& place) {
        QMargins wider = margins;
        if (place.center().x() < right / 2)
            wider.setLeft(std::max(margins.left(), place.right() + 1 + kGap));
        else
            wider.setRight(std::max(margins.right(), width() - place.left() + kGap));
        return wider;
    };
    // Tools, and an ordinary pop-out beside them: another tool moves nothing.
    const QRect& tools = m_sideBar->geometry();
    const int popOut = kGap + m_brushPopOut->sizeHint().width();
    const QMargins besideTools =
        leaveAside(m_areToolsRight ? tools.adjusted(-popOut, 0, 0, 0) : tools.adjusted(0, 0, popOut, 0));
    if (room(besideTools).width() >= kLeastRoom)
        margins = besideTools;
    if (isSheetOpen) {
        QMargins below = margins;
        below.setTop(sheetPlace.bottom() + 1);
        const QMargins aside = leaveAside(sheetPlace);
        const auto least = [](const QSize& size) { return std::min(size.width(), size.height()); };
        margins = least(room(aside)) > least(room(below)) ? aside : below;
    }
    for (const QWidget* pane : {static_cast<QWidget*>(m_history), static_cast<QWidget*>(m_profilePanel)}) {
        const bool isOpen = pane == m_history ? m_isHistoryShown : isProfileOpen;
        const QMargins aside = leaveAside(pane->geometry());
        if (isOpen && room(aside).width() >= kLeastRoom)
            margins = aside;
    }
    return margins;
}

} // namespace espalier
