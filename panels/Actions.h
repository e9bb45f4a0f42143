// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QCoreApplication>
#include <QObject>

#include <array>
#include <cstddef>
#include <span>

namespace espalier {

/// Everything that the user can start by a menu, a button or a key.
enum class ActionId {
    New,
    Open,
    Library,
    Save,
    SaveAs,
    SaveRecipe,
    Export,
    SavePicture,
    CopyPicture,
    BringBack,
    Settings,
    Quit,
    Undo,
    Redo,
    Another,
    Brush,
    Sketch,
    Multiply,
    Move,
    Reproduce,
    Grow,
    Prune,
    SelectBud,
    Bend,
    Width,
    Twist,
    AddBuds,
    Profile,
    Lasso,
    Invigorate,
    Reduce,
    GrowStep,
    SmallerBrush,
    LargerBrush,
    ToolRing,
    Cancel,
    FrameAll,
    FrontView,
    SideView,
    TopView,
    ThreeQuarterView,
    Markers,
    Leaves,
    Fibres,
    Person,
    SecondView,
    Architecture,
    BrushSheet,
    LeafSheet,
    BranchSheet,
    Background,
    History,
    NextPane,
    HideInterface,
    FullScreen,
    Help,
    Report,
    Count
};

enum class ActionGroup { File, Edit, Tools, View, Window, Count };

/// A row of the only table of actions. Menus, bars and shortcuts are made from it, and a tool's help page has
/// the action's name. Texts are untranslated; their context is "Actions".
struct ActionEntry {
    ActionId id;
    ActionGroup group;
    const char* name; ///< For tests, style and help; stable
    const char* text;
    const char* tip;
    const char* shortcuts; ///< Portable, separated by "; "
    const char* icon;      ///< "" for none
    bool checkable = false;
};

/// The program's actions, made from the table. They belong to a window, which handles their keys.
class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QWidget& window);
    /// Sets all texts in the current language.
    void setTexts();

    QAction* operator[](ActionId id) const { return m_actions[static_cast<std::size_t>(id)]; }

    static const std::array<ActionEntry, static_cast<std::size_t>(ActionId::Count)>& table();
    static QString groupTitle(ActionGroup group);
    /// The tools, in the order of the side bar; one of them is always the current one.
    static std::span<const ActionId> tools();
    /// The sheets that the top bar opens, in the order of the bar and of Workspace::sheet().
    static std::span<const ActionId> sheets();

private:
    std::array<QAction*, static_cast<std::size_t>(ActionId::Count)> m_actions{};
};

} // namespace espalier
