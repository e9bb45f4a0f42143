// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

class QAction;
class QRect;
class QWidget;

namespace espalier {

class Actions;
class TourCard;
class TreeDocument;
class ViewSettings;
class Workspace;

/// Leads a newcomer through the first minutes: each card points at something of the workspace, and the next
/// one comes when the user has done what it says and has let go, or presses Next. The first cards lead to a
/// tree: a trunk, limbs and a crown.
class Tour : public QObject {
    Q_OBJECT

public:
    Tour(Workspace& workspace, const Actions& actions, TreeDocument& document, ViewSettings& settings,
         QObject* parent = nullptr);

    void start(int step = 0);
    void stop();
    bool isRunning() const { return m_step >= 0; }
    /// 0...stepCount() - 1, or -1 while it does not run.
    int step() const { return m_step; }
    int stepCount() const { return static_cast<int>(m_steps.size()); }

Q_SIGNALS:
    /// The person wants to watch a recipe of the program; the tour may go on with the next step after it.
    void recipeAsked(const QString& fileName);

private:
    enum Step {
        TrunkStep,
        LimbsStep,
        RadiusStep,
        CrownStep,
        ToolsStep,
        TimeStep,
        TurnStep,
        SketchStep,
        HelpStep
    };
    struct Card {
        std::function<QString()> title;
        std::function<QString()> text;
        std::function<QRect()> target; ///< px of the workspace; empty if the widget is not visible
        std::function<void()> prepare; ///< Called before the card shows; may be empty
        /// Where the user will draw, px of the workspace; empty if the card is not about drawing.
        std::function<QRect()> canvas = {};
        QString recipe = {}; ///< File that shows what the card tells of; may be empty
    };

    void makeSteps(const Actions& actions);
    void watch(const Actions& actions);
    void showStep(int step);
    void next();
    /// Shows the next card once the user has let go of everything.
    void goOn();
    bool isHandDown() const;
    /// The user has done what the card of @p step says; if that card shows, the next one comes.
    void did(Step step);
    /// Looks at what the strokes of the brush have come to.
    void watchStrokes(int undoIndex);
    void follow();
    /// After another tree has taken the place of the one that was being drawn.
    void beginAgain();
    /// Takes the brush with @p radius, m.
    void takeBrush(double radius);
    /// Radius of a brush for a crown, in proportion to what the viewport shows at the tree, m.
    double crownRadius() const;
    bool isSeedling() const;
    QRect placeOf(const QWidget* widget) const;
    QRect placeOfBase() const;
    /// Of what the tree was when the card came.
    QRect placeOfWood() const;

    Workspace& m_workspace;
    TreeDocument& m_document;
    ViewSettings& m_settings;
    TourCard* m_card; ///< Child of the workspace
    std::vector<Card> m_steps;
    int m_step = -1;
    // As they were when the card came
    int m_undoIndex = 0;
    std::uint32_t m_internodes = 0;
    Box3 m_wood;           ///< m
    double m_radius = 0.0; ///< Radius of the brush, m
    /// The radius that the user had set before the tour took a thin brush, m.
    std::optional<double> m_radiusBefore;
    QAction* m_brush;
    double m_azimuth = 0.0; ///< Azimuth of the camera when the card of the strip came, rad
    QTimer m_following;
    QTimer m_pause; ///< Time between the user's action and the next card
};

} // namespace espalier
