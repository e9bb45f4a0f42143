// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"
#include "panels/Bars.h"
#include "views/camera/Camera.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QPushButton;

namespace espalier {

class ArchitecturePanel;
class BackgroundPanel;
class Bar;
class AddBudsPopOut;
class AnotherPanel;
class BendPopOut;
class BrushPanel;
class BrushPopOut;
class GrowPopOut;
class HelpPanel;
class HistoryPanel;
class LassoPopOut;
class LeafChoices;
class LibraryPanel;
class MultiplyPopOut;
class Notice;
class ProfilePanel;
class PrunePopOut;
class ReproducePopOut;
class RotationStrip;
class SizeChoices;
class SketchPopOut;
class TwistPopOut;
class Viewport;

/// The tree from edge to edge, and over it the bars, the pop-out of the tool, one sheet of parameters, a
/// notice, and a line with counts.
class Workspace : public QWidget {
    Q_OBJECT

public:
    enum class PopOut {
        None,
        Brush,
        Grow,
        Bend,
        Lasso,
        Twist,
        AddBuds,
        Profile,
        Sketch,
        Multiply,
        Reproduce,
        Prune
    };
    static constexpr int kSheetCount = 5;

    Workspace(TreeDocument& document, ViewSettings& settings, const Actions& actions,
              std::function<void(QMenu&)> fillRecentFiles, QWidget* parent = nullptr);

    Viewport& viewport() { return *m_viewport; }
    TopBar& topBar() { return *m_topBar; }
    Notice& notice() { return *m_notice; }
    GrowPopOut& growPopOut() { return *m_growPopOut; }
    LassoPopOut& lassoPopOut() { return *m_lassoPopOut; }
    SketchPopOut& sketchPopOut() { return *m_sketchPopOut; }
    LeafChoices& leafChoices() { return *m_leafChoices; }
    AnotherPanel& another() { return *m_another; }
    SizeChoices& sizeChoices() { return *m_sizeChoices; }
    ReproducePopOut& reproducePopOut() { return *m_reproducePopOut; }
    ProfilePanel& profilePanel() { return *m_profilePanel; }
    Bar& sheet(int index) { return *m_sheets[static_cast<std::size_t>(index)]; }
    ArchitecturePanel& architecture() { return *m_architecture; }

    BrushPanel& brushSheet() { return *m_brushSheet; }
    BackgroundPanel& background() { return *m_background; }
    HistoryPanel& history() { return *m_history; }
    HelpPanel& help() { return *m_help; }
    LibraryPanel& library() { return *m_library; }

    void showPopOut(PopOut popOut);
    void showHistory(bool shown);
    /// Shows or hides other trees like this one.
    void showAnother(bool shown);
    /// Shows or hides the library, which covers all but the top bar and notices.
    void showLibrary(bool shown);
    /// Shows or hides the help beside the tree, which keeps the rest of the room.
    void showHelp(bool shown);
    bool isHelpShown() const { return m_isHelpShown; }
    /// Shows or hides the button that leads back to the user's own tree, which is set aside.
    void showWayBack(bool shown);
    /// Puts the bar of tools, and what opens beside it, on the right and the history on the left, or the
    /// other way round.
    void setToolsRight(bool right);
    /// Shows the sheet @p index, 0...kSheetCount - 1; any other number shows none.
    void showSheet(int index);
    /// Hides everything but the tree and notices.
    void setInterfaceHidden(bool hidden);
    /// Moves the keyboard focus to the help, to the open sheet or else to the tools; or back to the tree.
    void focusNextPane();
    /// Whether nothing has been done to the seedling, so that its size can still be chosen.
    void setBlank(bool blank);
    /// Shows a tool's advice in place of the counts; empty for none.
    void setTip(const QString& tip);

Q_SIGNALS:
    void wayBackAsked();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    /// The same, after a pane was opened or closed: the view makes room for it, or takes the room back.
    void rearrange();
    /// The margins of the viewport that panes cover, px: the help begins at @p right, the open sheet is at
    /// @p sheetPlace.
    QMargins marginsBeside(int right, const QRect& sheetPlace) const;
    void showCounts();
    /// Sets the colour of words over the picture so that they are legible on the backdrop.
    void followBackdrop();

    const TreeDocument& m_document;
    const ViewSettings& m_settings;
    Viewport* m_viewport;
    TopBar* m_topBar;
    SideBar* m_sideBar;
    BrushPopOut* m_brushPopOut;
    GrowPopOut* m_growPopOut;
    BendPopOut* m_bendPopOut;
    LassoPopOut* m_lassoPopOut;
    TwistPopOut* m_twistPopOut;
    AddBudsPopOut* m_addBudsPopOut;
    SketchPopOut* m_sketchPopOut;
    MultiplyPopOut* m_multiplyPopOut;
    ReproducePopOut* m_reproducePopOut;
    PrunePopOut* m_prunePopOut;
    ProfilePanel* m_profilePanel;
    ArchitecturePanel* m_architecture;
    BrushPanel* m_brushSheet;
    BackgroundPanel* m_background;
    std::array<Bar*, kSheetCount> m_sheets{};
    HistoryPanel* m_history;
    LeafChoices* m_leafChoices;
    SizeChoices* m_sizeChoices;
    AnotherPanel* m_another;
    LibraryPanel* m_library;
    HelpPanel* m_help;
    RotationStrip* m_strip;
    QPushButton* m_onlyOne; ///< Shown while one bud alone grows
    QPushButton* m_wayBack; ///< Shown while the user's own tree is set aside
    Notice* m_notice;
    QLabel* m_counts;
    QLabel* m_tip;
    QTimer m_countTimer;
    /// What the view showed before it made room for panes, and what it shows since then.
    struct Beside {
        Camera before;
        QRect clear; ///< The part of the viewport that was free
        bool wasTreeClear = false;
        Camera shown;
    };
    std::optional<Beside> m_beside;
    PopOut m_popOut = PopOut::Brush;
    int m_sheet = -1;
    bool m_isHidden = false;
    bool m_isBlank = false;
    bool m_isAnotherShown = false;
    bool m_isHistoryShown = false;
    bool m_isLibraryShown = false;
    bool m_areToolsRight = false;
    bool m_isHelpShown = false;
    bool m_isWayBackShown = false;
};

} // namespace espalier
