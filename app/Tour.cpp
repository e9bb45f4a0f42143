// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Tour.h"

#include "app/Workspace.h"
#include "panels/Actions.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPanel.h"
#include "panels/RotationStrip.h"
#include "panels/TourCard.h"
#include "views/Viewport.h"

#include <cmath>

namespace espalier {

namespace {

constexpr int kCardInterval = 120; ///< ms
constexpr int kPause = 900;        ///< ms to see what came of it
constexpr double kTurned = 0.2;    ///< rad; less is a trembling hand
constexpr int kBaseReach = 26;     ///< Of the ring around the base of the tree, px

/// Drawn from a blank page, with leaves.
constexpr QLatin1StringView kDrawnTree(":/docs/help/recipes/sketch.json");

/// The button of an action on a bar of @p workspace.
const QWidget* buttonOf(const QWidget& workspace, const QAction* action)
{
    for (const BarButton* button : workspace.findChildren<BarButton*>()) {
        if (button->defaultAction() == action)
            return button;
    }
    return nullptr;
}

} // namespace

Tour::Tour(Workspace& workspace, const Actions& actions, TreeDocument& document, ViewSettings& settings,
           QObject* parent)
    : QObject(parent),
      m_workspace(workspace),
      m_document(document),
      m_settings(settings),
      m_card(new TourCard(&workspace))
{
    makeSteps(actions);
    watch(actions);
    connect(m_card, &TourCard::nextAsked, this, &Tour::next);
    connect(m_card, &TourCard::skipAsked, this, &Tour::stop);
    connect(m_card, &TourCard::watchAsked, this,
            [this] { Q_EMIT recipeAsked(m_steps[static_cast<std::size_t>(m_step)].recipe); });
    m_following.setInterval(kCardInterval);
    connect(&m_following, &QTimer::timeout, this, &Tour::follow);
    m_pause.setInterval(kPause);
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &Tour::next);
}

void Tour::makeSteps(const Actions& actions)
{
    const auto said = [](const QString& text) { return [text] { return text; }; };
    const auto at = [this](const QWidget* widget) { return [this, widget] { return placeOf(widget); }; };
    QAction* brush = actions[ActionId::Brush];
    QAction* grow = actions[ActionId::Grow];
    m_steps.resize(HelpStep + 1);
    m_steps[BrushStep] = {
        tr("Brush a tree"),
        [this] {
            return m_document.index().livingCount() <= 1
                       ? tr("Here is a seedling. <b>Press on it and draw upward, slowly</b>; "
                            "let go when you like what grows.")
                       : tr("<b>Press on a branch and draw outward, slowly</b>; let go when you "
                            "like what grows.");
        },
        [this] { return placeOfBase(); }, [brush] { brush->trigger(); }};
    m_steps[RadiusStep] = {
        tr("Large and small"),
        said(tr("A large brush grows a crown, a tiny one draws a single branch. <b>Draw the slider, "
                "or press&nbsp;[&nbsp;and&nbsp;]</b>.")),
        at(m_workspace.findChild<BrushPopOut*>()), [brush] { brush->trigger(); }};
    m_steps[ToolsStep] = {
        tr("Tools"),
        said(tr("Prune, bend, draw with a lasso: what a gardener needs is here. <b>Take Grow</b>.")),
        at(m_workspace.findChild<SideBar*>()),
        {}};
    m_steps[TimeStep] = {
        tr("Back in time"),
        said(tr("<b>Draw this slider to the left</b>, and the tree ungrows; to the right, and it comes "
                "back and grows on.")),
        at(m_workspace.growPopOut().findChild<QSlider*>(QStringLiteral("time"))),
        [grow] { grow->trigger(); }};
    m_steps[TurnStep] = {
        tr("All around"),
        said(tr("<b>Draw along this edge</b>, and the tree turns, even while your other hand brushes. "
                "The right mouse button turns it as well.")),
        at(m_workspace.findChild<RotationStrip*>()), [brush] { brush->trigger(); }};
    m_steps[SketchStep] = {
        tr("Draw a tree"),
        said(tr("<b>Take Sketch</b> to draw a trunk and branches as on paper, and give the drawing depth. "
                "Watch how thirty strokes become a tree.")),
        at(buttonOf(m_workspace, actions[ActionId::Sketch])),
        {},
        kDrawnTree};
    m_steps[HelpStep] = {
        tr("When you wonder"),
        said(tr("<b>F1</b> or this button tells of the tool in your hand. <b>Ctrl+Z</b> takes back "
                "whatever you did, so try things.")),
        at(buttonOf(m_workspace, actions[ActionId::Help])),
        {}};
}

void Tour::watch(const Actions& actions)
{
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        if (index > m_undoIndex)
            did(BrushStep);
    });
    connect(&m_settings, &ViewSettings::changed, this, [this] {
        if (m_settings.values().brushRadius != m_radius)
            did(RadiusStep);
    });
    connect(actions[ActionId::Grow], &QAction::triggered, this, [this] { did(ToolsStep); });
    connect(&m_workspace.growPopOut(), &GrowPopOut::timeReleased, this, [this] { did(TimeStep); });
    connect(&m_workspace.viewport(), &Viewport::cameraChanged, this, [this] {
        const double turned = static_cast<double>(m_workspace.viewport().camera().azimuth()) - m_azimuth;
        if (std::abs(std::remainder(turned, 2.0 * std::numbers::pi)) > kTurned)
            did(TurnStep);
    });
    connect(actions[ActionId::Sketch], &QAction::triggered, this, [this] { did(SketchStep); });
    connect(actions[ActionId::Help], &QAction::triggered, this, [this] { did(HelpStep); });
}

void Tour::start(int step)
{
    showStep(step);
    m_following.start();
}

void Tour::stop()
{
    m_step = -1;
    m_pause.stop();
    m_following.stop();
    m_card->hide();
}

void Tour::showStep(int step)
{
    const Card& card = m_steps[static_cast<std::size_t>(step)];
    // A change that prepare() makes is not an action of the user.
    m_step = -1;
    m_pause.stop();
    if (card.prepare)
        card.prepare();
    m_step = step;
    m_undoIndex = m_document.undoStack().index();
    m_radius = m_settings.values().brushRadius;
    m_azimuth = static_cast<double>(m_workspace.viewport().camera().azimuth());
    m_card->setWords(card.title, card.text(), step + 1, stepCount(), !card.recipe.isEmpty());
    follow();
}

void Tour::next()
{
    if (!isRunning())
        return;
    if (m_step + 1 < stepCount())
        showStep(m_step + 1);
    else
        stop();
}

void Tour::did(Step step)
{
    if (m_step != step)
        return;
    // A user who opens the help wants to read it now.
    if (step == HelpStep)
        stop();
    else
        m_pause.start();
}

void Tour::follow()
{
    m_card->pointAt(m_steps[static_cast<std::size_t>(m_step)].target());
}

QRect Tour::placeOf(const QWidget* widget) const
{
    if (!widget || !widget->isVisible())
        return {};
    return {widget->mapTo(&m_workspace, QPoint()), widget->size()};
}

QRect Tour::placeOfBase() const
{
    const auto place = m_workspace.viewport().camera().project(Vec3::Zero());
    if (!place || !m_workspace.rect().contains(place->toPoint()))
        return {};
    return {place->toPoint() - QPoint(kBaseReach, kBaseReach), QSize(2 * kBaseReach, 2 * kBaseReach)};
}

} // namespace espalier
