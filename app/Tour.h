// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <functional>
#include <vector>

class QRect;
class QWidget;

namespace espalier {

class Actions;
class TourCard;
class TreeDocument;
class ViewSettings;
class Workspace;

/// Leads a newcomer through the first minute: each card points at something of the workspace, and the next
/// one comes when the person has used it, or presses Next.
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
    enum Step { BrushStep, RadiusStep, ToolsStep, TimeStep, TurnStep, SketchStep, HelpStep };
    struct Card {
        QString title;
        std::function<QString()> text;
        std::function<QRect()> target; ///< px of the workspace; empty if the widget is not visible
        std::function<void()> prepare; ///< Called before the card shows; may be empty
        QString recipe = {};           ///< File that shows what the card tells of; may be empty
    };

    void makeSteps(const Actions& actions);
    void watch(const Actions& actions);
    void showStep(int step);
    void next();
    /// The user has done what the card of @p step says; if that card shows, the next one comes.
    void did(Step step);
    void follow();
    QRect placeOf(const QWidget* widget) const;
    QRect placeOfBase() const;

    Workspace& m_workspace;
    TreeDocument& m_document;
    ViewSettings& m_settings;
    TourCard* m_card; ///< Child of the workspace
    std::vector<Card> m_steps;
    int m_step = -1;
    int m_undoIndex = 0;
    double m_radius = 0.0;  ///< Radius of the brush when its card came, m
    double m_azimuth = 0.0; ///< Azimuth of the camera when the card of the strip came, rad
    QTimer m_following;
    QTimer m_pause; ///< Time between the user's action and the next card
};

} // namespace espalier
