// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/WindowPanes.h"

#include "app/HelpController.h"
#include "app/Tour.h"
#include "panels/AddBudsPopOut.h"
#include "panels/BackgroundPanel.h"
#include "panels/BendPopOut.h"
#include "panels/BrushPanel.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPanel.h"
#include "panels/HistoryPanel.h"
#include "panels/LassoPopOut.h"
#include "panels/MultiplyPopOut.h"
#include "panels/Notice.h"
#include "panels/ParameterRow.h"
#include "panels/PrunePopOut.h"
#include "panels/ReproducePopOut.h"
#include "panels/RotationStrip.h"
#include "panels/SettingsSheet.h"
#include "panels/SizeChoices.h"
#include "panels/SketchPopOut.h"
#include "panels/TourCard.h"
#include "panels/TwistPopOut.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/library/LibraryPanel.h"
#include "panels/library/LibraryView.h"

#include <QPushButton>
#include <QTest>
#include <QWidget>

namespace espalier::test {

std::vector<WindowPanes::Pane> WindowPanes::all()
{
    const auto of = [this](ActionId id, QWidget& pane) {
        return [this, id, &pane] {
            have(id);
            return &pane;
        };
    };
    const auto pruning = [this](PruneMode mode) {
        return [this, mode]() -> QWidget* {
            have(ActionId::Prune);
            m_window.viewSettings().set(&ViewValues::pruneMode, mode);
            return m_window.workspace().findChild<PrunePopOut*>();
        };
    };
    return {
        {"tools", [this] { return m_window.workspace().findChild<SideBar*>(); }},
        {"bar at the top", [this] { return &m_window.workspace().topBar(); }},
        {"rotation strip", [this] { return m_window.workspace().findChild<RotationStrip*>(); }},
        {"architecture", of(ActionId::Architecture, m_window.workspace().architecture())},
        {"more of the architecture",
         [this] {
             have(ActionId::Architecture);
             m_window.workspace().architecture().showMore(true);
             return m_window.workspace()
                 .architecture()
                 .row("growth.shadowFalloff")
                 ->parentWidget()
                 ->parentWidget();
         }},
        {"brush's sheet", of(ActionId::BrushSheet, m_window.workspace().brushSheet())},
        {"leaves", of(ActionId::LeafSheet, m_window.workspace().sheet(2))},
        {"branches", of(ActionId::BranchSheet, m_window.workspace().sheet(3))},
        {"background", of(ActionId::Background, m_window.workspace().background())},
        {"brush's pop-out", of(ActionId::Brush, *m_window.workspace().findChild<BrushPopOut*>())},
        {"grow", of(ActionId::Grow, m_window.workspace().growPopOut())},
        {"bend", of(ActionId::Bend, *m_window.workspace().findChild<BendPopOut*>())},
        {"twist", of(ActionId::Twist, *m_window.workspace().findChild<TwistPopOut*>())},
        {"new buds", of(ActionId::AddBuds, *m_window.workspace().findChild<AddBudsPopOut*>())},
        {"sketch", of(ActionId::Sketch, m_window.workspace().sketchPopOut())},
        {"multiply", of(ActionId::Multiply, *m_window.workspace().findChild<MultiplyPopOut*>())},
        {"reproduce", of(ActionId::Reproduce, m_window.workspace().reproducePopOut())},
        {"cut", pruning(PruneMode::Cut)},
        {"keep clear", pruning(PruneMode::KeepClear)},
        {"erase", pruning(PruneMode::Erase)},
        {"thin out", pruning(PruneMode::Thin)},
        {"lasso", of(ActionId::Lasso, m_window.workspace().lassoPopOut())},
        {"history", of(ActionId::History, m_window.workspace().history())},
        {"help",
         [this]() -> QWidget* {
             if (!m_window.workspace().help().isVisible())
                 m_window.actions()[ActionId::Help]->trigger();
             m_window.workspace().help().showPage(QStringLiteral("prune"));
             m_window.workspace().help().showPage(QStringLiteral("brush"));
             return &m_window.workspace().help();
         }},
        {"library",
         [this]() -> QWidget* {
             have(ActionId::Library);
             // The species are read in the background.
             m_areSpeciesThere =
                 m_areSpeciesThere || QTest::qWaitFor([this] {
                     return m_window.workspace().library().findChild<CardView*>()->model()->rowCount() > 8;
                 });
             return &m_window.workspace().library();
         }},
        {"settings", [this] { return openSettings(); }},
        {"notice",
         [this]() -> QWidget* {
             if (!m_window.workspace().notice().isVisible())
                 m_window.workspace().notice().ask(QStringLiteral("Well?"), QStringLiteral("Yes"),
                                                   QStringLiteral("No"), [](bool) {});
             return &m_window.workspace().notice();
         }},
        {"tour",
         [this]() -> QWidget* {
             if (!m_window.help().tour().isRunning())
                 m_window.help().startTour();
             return m_window.workspace().findChild<TourCard*>();
         }},
        {"size of the new tree",
         [this]() -> QWidget* {
             m_window.workspace().setBlank(true);
             return &m_window.workspace().sizeChoices();
         }},
        {"one branch alone",
         [this]() -> QWidget* {
             m_window.document().setCompetitors({.node = 0});
             return m_window.workspace().findChild<QPushButton*>(QStringLiteral("growAll"));
         }},
    };
}

QWidget* WindowPanes::openSettings()
{
    auto* sheet = m_window.findChild<SettingsSheet*>();
    if (!sheet) {
        m_window.actions()[ActionId::Settings]->trigger();
        sheet = m_window.findChild<SettingsSheet*>();
    }
    sheet->activateWindow();
    (void)QTest::qWaitForWindowActive(sheet);
    return sheet;
}

void WindowPanes::have(ActionId id)
{
    if (!m_window.actions()[id]->isChecked())
        m_window.actions()[id]->trigger();
}

void WindowPanes::shutAll()
{
    delete m_window.findChild<SettingsSheet*>();
    m_window.help().tour().stop();
    m_window.workspace().showHelp(false);
    m_window.workspace().architecture().showMore(false);
    m_window.workspace().notice().finish();
    m_window.actions()[ActionId::HideInterface]->setChecked(false);
    for (const ActionId id : {ActionId::Library, ActionId::History})
        m_window.actions()[id]->setChecked(false);
    for (const ActionId id : Actions::sheets()) {
        if (m_window.actions()[id]->isChecked())
            m_window.actions()[id]->trigger();
    }
    m_window.actions()[ActionId::Brush]->trigger();
    m_window.activateWindow();
    (void)QTest::qWaitForWindowActive(&m_window);
}

} // namespace espalier::test
