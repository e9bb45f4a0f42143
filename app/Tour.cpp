// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Tour.h"

#include "app/Workspace.h"
#include "model/mesh/TreeCounts.h"
#include "panels/Actions.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPanel.h"
#include "panels/RotationStrip.h"
#include "panels/TourCard.h"
#include "views/Viewport.h"

#include <QGuiApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kCardInterval = 120; ///< ms
constexpr int kPause = 900;        ///< ms to see what came of it
constexpr int kLookAgain = 150;    ///< ms until the next look at whether the hand is still down
constexpr double kTurned = 0.2;    ///< rad; less is a trembling hand
constexpr int kBaseReach = 26;     ///< Of the ring around the base of the tree, px
constexpr double kWoodReach = 14;  ///< Of the ring around the trunk, px

constexpr int kLimbs = 3;                      ///< Strokes until the card of the limbs is done
constexpr std::uint32_t kTrunkInternodes = 8;  ///< A shorter trunk is none yet
constexpr std::uint32_t kCrownInternodes = 60; ///< A stroke that adds fewer has grown no crown
constexpr double kTourBrush = 0.11; ///< Radius of a brush for a crown, of the height that is visible

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
      m_card(new TourCard(&workspace)),
      m_brush(actions[ActionId::Brush])
{
    makeSteps(actions);
    watch(actions);
    connect(m_card, &TourCard::nextAsked, this, &Tour::next);
    connect(m_card, &TourCard::skipAsked, this, &Tour::stop);
    connect(m_card, &TourCard::watchAsked, this,
            [this] { Q_EMIT recipeAsked(m_steps[static_cast<std::size_t>(m_step)].recipe); });
    m_following.setInterval(kCardInterval);
    connect(&m_following, &QTimer::timeout, this, &Tour::follow);
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &Tour::goOn);
}

void Tour::makeSteps(const Actions& actions)
{
    const auto said = [](const QString& text) { return [text] { return text; }; };
    const auto at = [this](const QWidget* widget) { return [this, widget] { return placeOf(widget); }; };
    QAction* grow = actions[ActionId::Grow];
    m_steps.resize(HelpStep + 1);
    m_steps[TrunkStep] = {
        [this] { return isSeedling() ? tr("Draw a trunk") : tr("Draw a branch"); },
        [this] {
            return isSeedling() ? tr("Here is a seedling. <b>Press on it and draw a line upward</b>, to the "
                                     "middle of the picture or higher: it becomes the trunk.")
                                : tr("<b>Press on a branch and draw outward</b>: the line becomes a branch.");
        },
        [this] { return placeOfBase(); }, [this] { takeBrush(0.0); },
        [this] {
            // The trunk, and the person beside it
            const QRect base = placeOfBase();
            return base.adjusted(-2 * kBaseReach, -m_workspace.height() / 2, 5 * kBaseReach, 0);
        }};
    m_steps[LimbsStep] = {said(tr("Draw the limbs")),
                          said(tr("<b>Press on the trunk and draw outward and up</b>, to the left and to the "
                                  "right. Three limbs or four are enough.")),
                          [this] { return placeOfWood(); }, [this] { takeBrush(0.0); },
                          [this] {
                              const QRect trunk = placeOfWood();
                              return trunk.adjusted(-trunk.height(), -trunk.height() / 2, trunk.height(), 0);
                          }};
    m_steps[RadiusStep] = {
        said(tr("Small and large")),
        said(tr("A tiny brush draws a single branch, a large one grows a crown. <b>Drag the slider upward, "
                "or press&nbsp;]</b>; [ makes the brush smaller.")),
        at(m_workspace.findChild<BrushPopOut*>()), [this] { m_brush->trigger(); }};
    m_steps[CrownStep] = {said(tr("Grow a crown")),
                          said(tr("<b>Press on a limb and draw slowly along the limbs and around their "
                                  "ends</b>: twigs and leaves grow wherever the brush passes.")),
                          [this] { return placeOfWood(); },
                          [this] {
                              // What the user has just set holds, if a crown can be grown with it.
                              const double wanted = crownRadius();
                              takeBrush(std::clamp(m_settings.values().brushRadius, 0.7 * wanted,
                                                   std::min(1.5 * wanted, kMaxBrushRadius)));
                          },
                          [this] {
                              const int reach = placeOfWood().height() / 4;
                              return placeOfWood().adjusted(-reach, -reach, reach, -reach);
                          }};
    m_steps[ToolsStep] = {
        said(tr("Tools")),
        said(tr("Prune, bend, draw with a lasso: what a gardener needs is here. <b>Choose Grow</b>.")),
        at(m_workspace.findChild<SideBar*>()),
        {}};
    m_steps[TimeStep] = {
        said(tr("Back in time")),
        said(tr("<b>Drag this slider to the left</b>, and the tree ungrows; drag it back to the right, and "
                "the tree is there again.")),
        at(m_workspace.growPopOut().findChild<QSlider*>(QStringLiteral("time"))),
        [grow] { grow->trigger(); }};
    m_steps[TurnStep] = {
        said(tr("All around")),
        said(tr("<b>Drag along this edge</b>, and the tree turns, even while your other hand brushes. "
                "The right mouse button turns it as well.")),
        at(m_workspace.findChild<RotationStrip*>()), [this] { m_brush->trigger(); }};
    m_steps[SketchStep] = {
        said(tr("Draw a tree")),
        said(tr("<b>Choose Sketch</b> to draw a trunk and branches as on paper, and give the drawing depth. "
                "Watch how thirty strokes become a tree.")),
        at(buttonOf(m_workspace, actions[ActionId::Sketch])),
        {},
        {},
        kDrawnTree};
    m_steps[HelpStep] = {
        said(tr("When you wonder")),
        said(tr("<b>F1</b> or this button tells you about the tool in your hand. <b>Ctrl+Z</b> takes back "
                "whatever you did, so try things.")),
        at(buttonOf(m_workspace, actions[ActionId::Help])),
        {}};
}

void Tour::watch(const Actions& actions)
{
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, &Tour::watchStrokes);
    connect(&m_settings, &ViewSettings::changed, this, [this] {
        if (m_settings.values().brushRadius != m_radius)
            did(RadiusStep);
    });
    connect(&m_document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (isRunning() && change.kind == TreeChange::Kind::Reset)
            QMetaObject::invokeMethod(this, &Tour::beginAgain, Qt::QueuedConnection);
    });
    connect(actions[ActionId::Grow], &QAction::triggered, this, [this] { did(ToolsStep); });
    connect(&m_workspace.growPopOut(), &GrowPopOut::timeReleased, this, [this] { did(TimeStep); });
    connect(&m_workspace.viewport(), &Viewport::cameraChanged, this, [this] {
        const double turned = static_cast<double>(m_workspace.viewport().mainCamera().azimuth()) - m_azimuth;
        if (std::abs(std::remainder(turned, 2.0 * std::numbers::pi)) > kTurned)
            did(TurnStep);
    });
    connect(actions[ActionId::Sketch], &QAction::triggered, this, [this] { did(SketchStep); });
    connect(actions[ActionId::Help], &QAction::triggered, this, [this] { did(HelpStep); });
}

void Tour::watchStrokes(int undoIndex)
{
    const std::uint32_t internodes = m_document.index().livingCount();
    const int strokes = undoIndex - m_undoIndex;
    if (strokes >= 1 && internodes >= kTrunkInternodes)
        did(TrunkStep);
    if (strokes >= kLimbs)
        did(LimbsStep);
    if (strokes >= 1 && internodes >= m_internodes + kCrownInternodes)
        did(CrownStep);
}

void Tour::beginAgain()
{
    if (!isRunning() || m_step > CrownStep || !isSeedling())
        return;
    // The size of the new tree brings a brush.
    if (const double radius = m_settings.values().brushRadius; radius > 0.0)
        m_radiusBefore = radius;
    showStep(TrunkStep);
}

void Tour::start(int step)
{
    m_radiusBefore = m_settings.values().brushRadius;
    showStep(step);
    m_following.start();
}

void Tour::stop()
{
    // The tour has made the brush thin. A user who leaves it before the card about the radius gets the former
    // radius back.
    if (isRunning() && m_step < RadiusStep && m_radiusBefore)
        m_settings.set(&ViewValues::brushRadius, *m_radiusBefore);
    m_radiusBefore.reset();
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
    m_internodes = m_document.index().livingCount();
    m_wood = treeBounds(m_document.tree(), m_document.index());
    m_radius = m_settings.values().brushRadius;
    m_azimuth = static_cast<double>(m_workspace.viewport().mainCamera().azimuth());
    m_card->setWords(card.title(), card.text(), step + 1, stepCount(), !card.recipe.isEmpty());
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

bool Tour::isHandDown() const
{
    return QGuiApplication::mouseButtons() != Qt::NoButton || m_workspace.viewport().isGestureActive();
}

void Tour::goOn()
{
    if (isHandDown())
        m_pause.start(kLookAgain);
    else
        next();
}

void Tour::did(Step step)
{
    if (m_step != step)
        return;
    // A user who opens the help wants to read it now.
    if (step == HelpStep)
        stop();
    else
        m_pause.start(kPause);
}

void Tour::follow()
{
    const Card& card = m_steps[static_cast<std::size_t>(m_step)];
    // A card that came while the user draws would be in the way, and so would a ring.
    if (m_workspace.viewport().isGestureActive() && m_card->isVisible()) {
        m_card->hideRing();
        return;
    }
    m_card->pointAt(card.target(), card.canvas ? card.canvas() : QRect());
}

void Tour::takeBrush(double radius)
{
    m_brush->trigger();
    m_settings.set(&ViewValues::brushRadius, radius);
}

double Tour::crownRadius() const
{
    const Camera& camera = m_workspace.viewport().mainCamera();
    const float depth = std::max(camera.depth(Vec3::Zero()), Camera::kMinDistance);
    return std::min(kTourBrush * camera.viewSize().height() /
                        static_cast<double>(camera.pixelsPerMetre(depth)),
                    kMaxBrushRadius);
}

bool Tour::isSeedling() const
{
    return m_document.index().livingCount() <= 1;
}

QRect Tour::placeOf(const QWidget* widget) const
{
    if (!widget || !widget->isVisible())
        return {};
    return {widget->mapTo(&m_workspace, QPoint()), widget->size()};
}

QRect Tour::placeOfBase() const
{
    const auto place = m_workspace.viewport().mainCamera().project(Vec3::Zero());
    if (!place || !m_workspace.rect().contains(place->toPoint()))
        return {};
    return {place->toPoint() - QPoint(kBaseReach, kBaseReach), QSize(2 * kBaseReach, 2 * kBaseReach)};
}

QRect Tour::placeOfWood() const
{
    QRectF place;
    for (int corner = 0; corner < 8; ++corner) {
        const auto point =
            m_workspace.viewport().mainCamera().project(m_wood.corner(static_cast<Box3::CornerType>(corner)));
        if (!point)
            return {};
        place = place.united(
            QRectF(*point - QPointF(kWoodReach, kWoodReach), QSizeF(2.0 * kWoodReach, 2.0 * kWoodReach)));
    }
    return place.toRect().intersected(m_workspace.rect());
}

} // namespace espalier
