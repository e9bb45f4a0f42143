// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Actions.h"

#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QWidget>

namespace espalier {

const std::array<ActionEntry, static_cast<std::size_t>(ActionId::Count)>& Actions::table()
{
    using enum ActionId;
    using Group = ActionGroup;
    static const std::array<ActionEntry, static_cast<std::size_t>(Count)> entries{{
        {New, Group::File, "new", QT_TRANSLATE_NOOP("Actions", "New"),
         QT_TRANSLATE_NOOP("Actions", "Start with a seedling."), "Ctrl+N", "new"},
        {Open, Group::File, "open", QT_TRANSLATE_NOOP("Actions", "Open…"),
         QT_TRANSLATE_NOOP("Actions", "Open a project or a recipe."), "Ctrl+O", "open"},
        {Library, Group::File, "library", QT_TRANSLATE_NOOP("Actions", "Library"),
         QT_TRANSLATE_NOOP("Actions", "Species to start from, and the trees you keep."), "Ctrl+L", "library",
         true},
        {Save, Group::File, "save", QT_TRANSLATE_NOOP("Actions", "Save"),
         QT_TRANSLATE_NOOP("Actions", "Save the project."), "Ctrl+S", "save"},
        {SaveAs, Group::File, "saveAs", QT_TRANSLATE_NOOP("Actions", "Save As…"),
         QT_TRANSLATE_NOOP("Actions", "Save the project under another name."), "Ctrl+Shift+S", ""},
        {SaveRecipe, Group::File, "saveRecipe", QT_TRANSLATE_NOOP("Actions", "Save as Recipe…"),
         QT_TRANSLATE_NOOP("Actions",
                           "Save everything that was done to the tree, so that it can be done again."),
         "", ""},
        {Export, Group::File, "export", QT_TRANSLATE_NOOP("Actions", "Export…"),
         QT_TRANSLATE_NOOP("Actions",
                           "Write the tree for other programs: GLB, FBX, OBJ, or its skeleton as CSV."),
         "Ctrl+E", "export"},
        {SavePicture, Group::File, "savePicture", QT_TRANSLATE_NOOP("Actions", "Save Picture…"),
         QT_TRANSLATE_NOOP("Actions", "Save a picture of the tree, in any size and from any side."),
         "Ctrl+Shift+E", ""},
        {CopyPicture, Group::File, "copyPicture", QT_TRANSLATE_NOOP("Actions", "Copy Picture"),
         QT_TRANSLATE_NOOP("Actions", "Copy a picture of the tree, as it is shown now, to the clipboard."),
         "Ctrl+Shift+C", ""},
        {BringBack, Group::File, "bringBack", QT_TRANSLATE_NOOP("Actions", "Bring Trees Back…"),
         QT_TRANSLATE_NOOP("Actions", "See the trees that were not saved when Espalier ended."), "", ""},
        {Settings, Group::File, "settings", QT_TRANSLATE_NOOP("Actions", "Settings…"),
         QT_TRANSLATE_NOOP("Actions", "How Espalier looks, and how it responds to your hand."), "Ctrl+,", ""},
        {Quit, Group::File, "quit", QT_TRANSLATE_NOOP("Actions", "Quit"),
         QT_TRANSLATE_NOOP("Actions", "Leave Espalier."), "Ctrl+Q", ""},
        {Undo, Group::Edit, "undo", QT_TRANSLATE_NOOP("Actions", "Undo"),
         QT_TRANSLATE_NOOP("Actions", "Take back what you did last."), "Ctrl+Z", "undo"},
        {Redo, Group::Edit, "redo", QT_TRANSLATE_NOOP("Actions", "Redo"),
         QT_TRANSLATE_NOOP("Actions", "Do again what you took back."), "Ctrl+Shift+Z; Ctrl+Y", "redo"},
        {Another, Group::Edit, "another", QT_TRANSLATE_NOOP("Actions", "Another Like This"),
         QT_TRANSLATE_NOOP("Actions",
                           "See six other trees that the same strokes could have made, and take one."),
         "Shift+A", "another"},
        {Brush, Group::Tools, "brush", QT_TRANSLATE_NOOP("Actions", "Brush"),
         QT_TRANSLATE_NOOP(
             "Actions", "Drag from the tree outward: it grows into the space that the brush passes through."),
         "B", "brush", true},
        {Sketch, Group::Tools, "sketch", QT_TRANSLATE_NOOP("Actions", "Sketch"),
         QT_TRANSLATE_NOOP("Actions",
                           "Draw the trunk and its branches as lines, then give the drawing depth."),
         "S", "sketch", true},
        {Multiply, Group::Tools, "multiply", QT_TRANSLATE_NOOP("Actions", "Multiply"),
         QT_TRANSLATE_NOOP("Actions", "Tap a branch: it gets more branches like those it carries, or passes "
                                      "on to others what it carries."),
         "Shift+S", "multiply", true},
        {Move, Group::Tools, "move", QT_TRANSLATE_NOOP("Actions", "Move"),
         QT_TRANSLATE_NOOP("Actions",
                           "Drag a branch along the wood, around it, or to other wood, with all it carries."),
         "Shift+M", "move", true},
        {Reproduce, Group::Tools, "reproduce", QT_TRANSLATE_NOOP("Actions", "Reshape"),
         QT_TRANSLATE_NOOP("Actions",
                           "Draw a trunk and a silhouette: the same tree takes on this new shape."),
         "Shift+R", "reproduce", true},
        {Grow, Group::Tools, "grow", QT_TRANSLATE_NOOP("Actions", "Grow"),
         QT_TRANSLATE_NOOP(
             "Actions", "Press anywhere and hold: the tree grows on its own, competing for light and space."),
         "Shift+G", "grow", true},
        {Prune, Group::Tools, "prune", QT_TRANSLATE_NOOP("Actions", "Prune"),
         QT_TRANSLATE_NOOP("Actions", "Tap a branch to cut it off, or draw across all the branches to cut."),
         "P", "prune", true},
        {SelectBud, Group::Tools, "selectBud", QT_TRANSLATE_NOOP("Actions", "Bud"),
         QT_TRANSLATE_NOOP("Actions", "Tap a bud: from now on, only this bud grows, and what comes from it."),
         "U", "bud", true},
        {Bend, Group::Tools, "bend", QT_TRANSLATE_NOOP("Actions", "Bend"),
         QT_TRANSLATE_NOOP("Actions", "Pull a branch to bend it; tap it to pin it there."), "Shift+B", "bend",
         true},
        {Width, Group::Tools, "width", QT_TRANSLATE_NOOP("Actions", "Width"),
         QT_TRANSLATE_NOOP("Actions", "Tap a branch to fix its width, and drag the handle to change it."),
         "W", "width", true},
        {Twist, Group::Tools, "twist", QT_TRANSLATE_NOOP("Actions", "Twist"),
         QT_TRANSLATE_NOOP("Actions", "Drag along a branch, or around it, to twist its strands."), "T",
         "twist", true},
        {AddBuds, Group::Tools, "addBuds", QT_TRANSLATE_NOOP("Actions", "New Buds"),
         QT_TRANSLATE_NOOP("Actions", "Tap old wood: buds break through its bark, and grow into branches."),
         "Shift+U", "addBuds", true},
        {Profile, Group::Tools, "profile", QT_TRANSLATE_NOOP("Actions", "Profile"),
         QT_TRANSLATE_NOOP("Actions", "Tap a branch to see its cross-section, and draw its shape."),
         "Shift+P", "profile", true},
        {Lasso, Group::Tools, "lasso", QT_TRANSLATE_NOOP("Actions", "Lasso"),
         QT_TRANSLATE_NOOP("Actions",
                           "Draw the silhouette of a crown: the tree grows until it fills that shape."),
         "O", "lasso", true},
        {Invigorate, Group::Tools, "invigorate", QT_TRANSLATE_NOOP("Actions", "Invigorate"),
         QT_TRANSLATE_NOOP("Actions", "Press a branch and hold: it alone grows until you let go."), "V",
         "invigorate", true},
        {Reduce, Group::Tools, "reduce", QT_TRANSLATE_NOOP("Actions", "Reduce"),
         QT_TRANSLATE_NOOP("Actions",
                           "Press a branch and hold: its youngest growth disappears, step by step."),
         "R", "reduce", true},
        {GrowStep, Group::Tools, "growStep", QT_TRANSLATE_NOOP("Actions", "Grow One Step"),
         QT_TRANSLATE_NOOP("Actions", "Let the tree grow one step on its own."), "G", ""},
        {SmallerBrush, Group::Tools, "smallerBrush", QT_TRANSLATE_NOOP("Actions", "Smaller Brush"),
         QT_TRANSLATE_NOOP("Actions", "Make the brush smaller, even while brushing."), "[", ""},
        {LargerBrush, Group::Tools, "largerBrush", QT_TRANSLATE_NOOP("Actions", "Larger Brush"),
         QT_TRANSLATE_NOOP("Actions", "Make the brush larger, even while brushing."), "]", ""},
        {ToolRing, Group::Tools, "toolRing", QT_TRANSLATE_NOOP("Actions", "Tool Ring"),
         QT_TRANSLATE_NOOP("Actions", "Tools, undo and brush size in a ring around the pointer. Hold the "
                                      "key, and let go over the one you want."),
         "D", ""},
        {Cancel, Group::Tools, "cancel", QT_TRANSLATE_NOOP("Actions", "Cancel"),
         QT_TRANSLATE_NOOP("Actions", "Take back the stroke or the growth under way."), "Esc", ""},
        {FrameAll, Group::View, "frameAll", QT_TRANSLATE_NOOP("Actions", "Frame All"),
         QT_TRANSLATE_NOOP("Actions", "Show the whole tree."), "F", "frame"},
        {FrontView, Group::View, "frontView", QT_TRANSLATE_NOOP("Actions", "From the Front"),
         QT_TRANSLATE_NOOP("Actions", "Look at the tree from the front."), "1", ""},
        {SideView, Group::View, "sideView", QT_TRANSLATE_NOOP("Actions", "From the Side"),
         QT_TRANSLATE_NOOP("Actions", "Look at the tree from the side."), "3", ""},
        {TopView, Group::View, "topView", QT_TRANSLATE_NOOP("Actions", "From the Top"),
         QT_TRANSLATE_NOOP("Actions", "Look down at the tree."), "7", ""},
        {ThreeQuarterView, Group::View, "threeQuarterView", QT_TRANSLATE_NOOP("Actions", "Three-Quarter"),
         QT_TRANSLATE_NOOP("Actions", "Look at the tree from between the front and the side."), "0", ""},
        {Markers, Group::View, "markers", QT_TRANSLATE_NOOP("Actions", "Markers"),
         QT_TRANSLATE_NOOP("Actions", "Show the points of free space that the brush spreads."), "M",
         "markers", true},
        {Leaves, Group::View, "leaves", QT_TRANSLATE_NOOP("Actions", "Leaves"),
         QT_TRANSLATE_NOOP("Actions", "Show the leaves."), "L", "leaves", true},
        {Fibres, Group::View, "fibres", QT_TRANSLATE_NOOP("Actions", "Strand Lines"),
         QT_TRANSLATE_NOOP("Actions",
                           "Show the strands of the wood as lines, each branch in its own colour."),
         "Shift+F", "fibres", true},
        {Person, Group::View, "person", QT_TRANSLATE_NOOP("Actions", "Person for Scale"),
         QT_TRANSLATE_NOOP("Actions", "Show a person beside the tree, and how long a metre is."), "H",
         "person", true},
        {SecondView, Group::View, "secondView", QT_TRANSLATE_NOOP("Actions", "Second View"),
         QT_TRANSLATE_NOOP(
             "Actions",
             "Show the tree from the right, in a corner of the window; draw there, too, to give it depth."),
         "Shift+V", "secondView", true},
        {Architecture, Group::Window, "architecture", QT_TRANSLATE_NOOP("Actions", "Architecture"),
         QT_TRANSLATE_NOOP("Actions", "How the tree grows from now on."), "Ctrl+1", "", true},
        {BrushSheet, Group::Window, "brushSheet", QT_TRANSLATE_NOOP("Actions", "Brush"),
         QT_TRANSLATE_NOOP("Actions",
                           "Size of the brush, pressure of the pen, and what is shown while you brush."),
         "Ctrl+2", "", true},
        {LeafSheet, Group::Window, "leafSheet", QT_TRANSLATE_NOOP("Actions", "Leaves"),
         QT_TRANSLATE_NOOP("Actions", "What the leaves look like."), "Ctrl+3", "", true},
        {BranchSheet, Group::Window, "branchSheet", QT_TRANSLATE_NOOP("Actions", "Branches"),
         QT_TRANSLATE_NOOP("Actions", "How thick branches are, and their bark."), "Ctrl+4", "", true},
        {Background, Group::Window, "background", QT_TRANSLATE_NOOP("Actions", "Background"),
         QT_TRANSLATE_NOOP("Actions", "What is around the tree: background, ground, sun, reference picture."),
         "Ctrl+5", "", true},
        {History, Group::Window, "history", QT_TRANSLATE_NOOP("Actions", "History"),
         QT_TRANSLATE_NOOP("Actions", "Everything you did, step by step; click a step to go back to it."),
         "Ctrl+H", "history", true},
        {NextPane, Group::Window, "nextPane", QT_TRANSLATE_NOOP("Actions", "Focus Panels or Tree"),
         QT_TRANSLATE_NOOP("Actions", "Move the keyboard focus to the panels, or back to the tree."), "F6",
         ""},
        {HideInterface, Group::Window, "hideInterface", QT_TRANSLATE_NOOP("Actions", "Only the Tree"),
         QT_TRANSLATE_NOOP("Actions", "Hide everything but the tree; the same key brings everything back."),
         "Tab", "eye", true},
        {FullScreen, Group::Window, "fullScreen", QT_TRANSLATE_NOOP("Actions", "Full Screen"),
         QT_TRANSLATE_NOOP("Actions", "Fill the whole screen."), "F11", "fullscreen", true},
        {Help, Group::Window, "help", QT_TRANSLATE_NOOP("Actions", "Help"),
         QT_TRANSLATE_NOOP("Actions", "Help on the current tool, and on everything else."), "F1", "help"},
        {Report, Group::Window, "report", QT_TRANSLATE_NOOP("Actions", "Report a Problem…"),
         QT_TRANSLATE_NOOP("Actions", "Copy what a report should have: version, graphics and log."), "", ""},
    }};
    return entries;
}

std::span<const ActionId> Actions::tools()
{
    static constexpr std::array kTools{
        ActionId::Brush,     ActionId::Sketch,    ActionId::Lasso,      ActionId::Grow,
        ActionId::Prune,     ActionId::Bend,      ActionId::Move,       ActionId::Width,
        ActionId::Multiply,  ActionId::Reproduce, ActionId::Invigorate, ActionId::Reduce,
        ActionId::SelectBud, ActionId::Twist,     ActionId::AddBuds,    ActionId::Profile};
    return kTools;
}

std::span<const ActionId> Actions::sheets()
{
    static constexpr std::array kSheets{ActionId::Architecture, ActionId::BrushSheet, ActionId::LeafSheet,
                                        ActionId::BranchSheet, ActionId::Background};
    return kSheets;
}

QString Actions::groupTitle(ActionGroup group)
{
    switch (group) {
    case ActionGroup::File:
        return QCoreApplication::translate("Actions", "Files");
    case ActionGroup::Edit:
        return QCoreApplication::translate("Actions", "Edit");
    case ActionGroup::Tools:
        return QCoreApplication::translate("Actions", "Tools");
    case ActionGroup::View:
        return QCoreApplication::translate("Actions", "View");
    case ActionGroup::Window:
        return QCoreApplication::translate("Actions", "Window");
    case ActionGroup::Count:
        break;
    }
    return {};
}

Actions::Actions(QWidget& window) : QObject(&window)
{
    for (const ActionEntry& entry : table()) {
        auto* action = new QAction(&window);
        action->setObjectName(QString::fromLatin1(entry.name));
        action->setShortcuts(QKeySequence::listFromString(QString::fromLatin1(entry.shortcuts)));
        action->setShortcutContext(Qt::WindowShortcut);
        action->setAutoRepeat(entry.id == ActionId::SmallerBrush || entry.id == ActionId::LargerBrush ||
                              entry.id == ActionId::Undo || entry.id == ActionId::Redo);
        action->setCheckable(entry.checkable);
        if (*entry.icon != '\0')
            action->setIcon(icon(QString::fromLatin1(entry.icon)));
        window.addAction(action);
        m_actions[static_cast<std::size_t>(entry.id)] = action;
    }
    setTexts();
}

void Actions::setTexts()
{
    for (const ActionEntry& entry : table()) {
        QAction* action = (*this)[entry.id];
        action->setText(QCoreApplication::translate("Actions", entry.text));
        QString key = action->shortcut().toString(QKeySequence::NativeText);
        if (!key.isEmpty())
            key = QStringLiteral(" &nbsp;<span style='color:%1'>%2</span>")
                      .arg(theme::kBubbleKey.name(), key.toHtmlEscaped());
        action->setToolTip(QStringLiteral("<b>%1</b>%2<br>%3")
                               .arg(action->text().toHtmlEscaped(), key,
                                    QCoreApplication::translate("Actions", entry.tip).toHtmlEscaped()));
    }
}

} // namespace espalier
