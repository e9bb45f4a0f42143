// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/EditEvent.h"
#include "model/document/NewNumbers.h"
#include "model/growth/GrowthModel.h"
#include "model/picking/PickIndex.h"
#include "model/scene/SceneLook.h"
#include "model/tree/Tree.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace espalier {

/// A change of the document's tree.
struct TreeChange {
    enum class Kind {
        Applied,    ///< delta was applied
        Reverted,   ///< delta was reverted
        Reset,      ///< another document's tree took its place; delta is null
        Exchanged,  ///< another tree with its history took its place, as an undo step; delta is null
        Renumbered, ///< the same tree got other ids, and a shorter history; delta is null
    };

    Kind kind = Kind::Reset;
    const TreeDelta* delta = nullptr;
    const NewNumbers* internodes = nullptr; ///< Only of Kind::Renumbered: the new ids by the old ones
};

class Edit;
struct AsideDocument;
struct PreparedTree;
struct RestoredStep;
struct ShortenedHistory;

/// A tree, its journal and its undo stack. An Edit is the one way to change it; views and panels listen to
/// changed().
class TreeDocument : public QObject {
    Q_OBJECT

public:
    explicit TreeDocument(QObject* parent = nullptr);
    ~TreeDocument() override;

    const Tree& tree() const { return m_tree; }
    const TreeIndex& index() const { return m_index; }
    /// The growth model, up to date; it grows by the model that the parameters in force name. Only for the
    /// document's thread, since the call may update the model.
    const GrowthModel& growthModel() const
    {
        m_growthModel->settle(m_tree, m_index);
        return *m_growthModel;
    }
    /// Updates the growth model by about @p nodes nodes; returns whether it is up to date.
    bool prepareGrowthModel(std::size_t nodes) const
    {
        return m_growthModel->settleSome(m_tree, m_index, nodes);
    }
    /// A model of the same kind for a copy of the tree.
    std::unique_ptr<GrowthModel> freshGrowthModel() const { return m_growthModel->fresh(); }
    /// The living nodes, for picking; brought up to date like growthModel().
    const PickIndex& pickIndex() const
    {
        m_pickIndex.settle(m_tree, m_index);
        return m_pickIndex;
    }
    const TreeParameters& parameters() const { return m_tree.parameters(); }
    /// All deltas up to the moment shown, first to last.
    const Journal& journal() const { return m_journal; }
    /// The deltas after the moment shown, if the document has travelled back; the last one first.
    const Journal& future() const { return m_future; }
    /// The buds that growth is limited to (selective growth, TreeSketch §3.2): all buds, or one bud and its
    /// descendants. This is a mode, not part of the tree; it ends when the bud's node dies.
    const Competitors& competitors() const { return m_competitors; }
    void setCompetitors(const Competitors& competitors);
    /// The surroundings of the tree. They are part of the document, but not of the tree: they are not in the
    /// journal, and a change of them is not undone.
    const SceneLook& look() const { return m_look; }
    /// Values out of range are set to the nearest limit. Emits lookChanged() if a value has changed.
    void setLook(const SceneLook& look);
    /// Whether the user is trying parameters out. Growth that runs by itself waits meanwhile, so that the
    /// trials are one undo step and only later growth uses them.
    bool areParametersHeld() const { return m_parameterHolds > 0; }
    /// Adds a hold of the parameters (true) or removes one; each caller removes what it added.
    void holdParameters(bool held);
    QUndoStack& undoStack() { return m_undoStack; }
    const QUndoStack& undoStack() const { return m_undoStack; }

    /// Replaces the tree by a seedling, in the default look of a scene; clears the undo stack.
    void reset(std::uint64_t seed, const TreeParameters& parameters = {});
    /// Replaces the tree by one that was read from a file, with its journal. The last @p ahead deltas of the
    /// journal become the future; clears the undo stack.
    void reset(Tree tree, Journal journal, std::size_t ahead = 0);
    /// The same; the undo stack then has the steps of @p prepared, as if they had just been done. What an
    /// edit had replaced or ended is not in the history; undo does not bring it back. Apart from these steps,
    /// the listeners of changed() and the old tree's destruction, in constant time.
    void reset(PreparedTree prepared);

    /// Exchanges the tree and its whole history, the future included, as one undo step named @p text, after
    /// ending the edit that is under way. Undo brings both back as they were.
    void exchange(PreparedTree prepared, const QString& text);

    /// Forgets the oldest part of the history, to free its memory: undo and time go back less far from now
    /// on. Returns false, and does nothing, if the tree has changed since @p shortened was made, or if an
    /// edit is under way. Otherwise @p shortened has the tree and the history from before then, so that a
    /// worker thread can free them.
    bool shorten(ShortenedHistory& shortened);

    /// The edit that is under way, or null.
    const Edit* edit() const { return m_edit; }
    /// A number that increases with every change of the tree.
    std::uint64_t revision() const { return m_revision; }
    /// Makes the owner of the edit that is under way end it, usually by a commit; cancels the edit if the
    /// owner does not. Ends paused work, too. To be called before the document is saved, replaced or closed.
    /// Undo and redo of this class call it themselves. Precondition: no listener of changed() is being
    /// called.
    void interruptEdit();
    /// Work that has committed its edit, and will begin another when no parameters are held any more.
    /// @p interrupted is called once, when an edit begins that is not a trial of parameters, or at
    /// interruptEdit(); it must end the work. An empty function says that there is no such work any more.
    void setPausedWork(std::function<void()> interrupted) { m_pausedWork = std::move(interrupted); }
    /// Calls interruptEdit(), then undo or redo of the stack. If an edit was interrupted and committed,
    /// undo() takes that one back.
    void undo();
    void redo();

    /// @p listener is called with each event that changes the tree from now on, except by reset() and by a
    /// GradualUndo; an empty one ends this.
    void setEditListener(EditListener listener) { m_editListener = std::move(listener); }

    /// Memory in bytes: of the tree, its indices, its journal and its future (without the rows in it).
    std::size_t bytes() const;

Q_SIGNALS:
    /// A delta was applied or reverted, or the tree was replaced. Tree, indices and journal are up to date.
    void changed(const espalier::TreeChange& change);
    void competitorsChanged();
    void lookChanged();
    /// The first hold of the parameters was added, or the last one was removed.
    void parametersHeld(bool held);

private:
    friend struct AsideDocument;
    friend class Edit;
    friend class EditCommand;

    /// How to end the edit that is under way; see Edit.
    struct EditHooks {
        std::function<void()> interrupted;
        std::function<void()> cancel;
    };

    void setEdit(const Edit* edit, EditHooks hooks = {});
    void interruptOpenEdit();
    void note(EditEvent event) const
    {
        if (m_editListener)
            m_editListener(std::move(event));
    }
    /// Applies @p delta and appends it to the journal.
    void apply(std::shared_ptr<TreeDelta> delta);
    /// Reverts the journal's last delta and takes it out.
    void revertLast();
    /// Sets everything but the look to @p prepared; clears the undo stack.
    void replaceBy(PreparedTree prepared);
    void restoreSteps(std::vector<RestoredStep> steps);
    void tellOfStack();
    /// Swaps everything with @p other.
    void swapWith(PreparedTree& other);
    void swapTree(PreparedTree& other);
    /// Goes back or forth in the history, to where @p position deltas of it have been applied.
    /// Precondition: position <= journal().size() + future().size().
    void travelTo(std::size_t position);
    /// The delta at @p position of the history, the future included.
    const std::shared_ptr<TreeDelta>& deltaAt(std::size_t position) const
    {
        return position < m_journal.size() ? m_journal[position]
                                           : m_future[m_future.size() - 1 - (position - m_journal.size())];
    }
    /// Removes the future and returns it, or sets it. EditCommand and Edit keep a future that has ended.
    Journal takeFuture() { return std::exchange(m_future, {}); }
    void setFuture(Journal future) { m_future = std::move(future); }
    void tell(const TreeChange& change);

    Tree m_tree;
    TreeIndex m_index;
    std::unique_ptr<GrowthModel> m_growthModel;
    const Edit* m_edit = nullptr;
    EditHooks m_editHooks;
    std::function<void()> m_pausedWork;
    bool m_isTelling = false; ///< Listeners of changed() are being called
    EditListener m_editListener;
    std::uint64_t m_revision = 0;
    Journal m_journal;
    Journal m_future;
    Competitors m_competitors;
    SceneLook m_look;
    int m_parameterHolds = 0;
    QUndoStack m_undoStack;
    mutable PickIndex m_pickIndex;
};

} // namespace espalier
