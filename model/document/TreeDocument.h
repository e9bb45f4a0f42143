// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthModel.h"
#include "model/picking/PickIndex.h"
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

/// What happened to the document's tree.
struct TreeChange {
    enum class Kind {
        Applied,  ///< delta was applied
        Reverted, ///< delta was reverted
        Reset,    ///< another tree stands here now; delta is null
    };

    Kind kind = Kind::Reset;
    const TreeDelta* delta = nullptr;
};

class Edit;
struct PreparedTree;

/// A tree, its journal and its undo stack. An Edit is the one way to change it; views and panels listen to
/// changed().
class TreeDocument : public QObject {
    Q_OBJECT

public:
    explicit TreeDocument(QObject* parent = nullptr);
    ~TreeDocument() override;

    const Tree& tree() const { return m_tree; }
    const TreeIndex& index() const { return m_index; }
    /// Not for other threads: it is brought up to date when it is asked for.
    const GrowthModel& growthModel() const
    {
        m_growthModel->settle(m_tree, m_index);
        return *m_growthModel;
    }
    /// Brings its index a part of the way, about @p nodes nodes; returns whether it is up to date.
    bool prepareGrowthModel(std::size_t nodes) const
    {
        return m_growthModel->settleSome(m_tree, m_index, nodes);
    }
    /// A model of the same kind for a copy of the tree.
    std::unique_ptr<GrowthModel> freshGrowthModel() const { return m_growthModel->fresh(); }
    /// From now on the tree grows by @p model, which is not null. What has grown stays.
    void setGrowthModel(std::unique_ptr<GrowthModel> model);
    /// Where the living nodes are; brought up to date like growthModel().
    const PickIndex& pickIndex() const
    {
        m_pickIndex.settle(m_tree, m_index);
        return m_pickIndex;
    }
    const TreeParameters& parameters() const { return m_tree.parameters(); }
    /// All that was done up to the moment shown, first to last.
    const Journal& journal() const { return m_journal; }
    /// What lies ahead of the moment shown, after a travel to an earlier one: the last of it first.
    const Journal& future() const { return m_future; }
    /// Which buds growth is limited to (selective growth, TreeSketch §3.2): all of them, or one bud and what
    /// comes of it. A mode, not part of the tree; it ends when its node dies.
    const Competitors& competitors() const { return m_competitors; }
    void setCompetitors(const Competitors& competitors);
    /// Whether hands are trying parameters out. What grows by itself waits meanwhile: the trials of a hand
    /// are one undo step, and only what grows afterwards is grown with them.
    bool areParametersHeld() const { return m_parameterHolds > 0; }
    /// One hand more or less.
    void holdParameters(bool held);
    QUndoStack& undoStack() { return m_undoStack; }
    const QUndoStack& undoStack() const { return m_undoStack; }

    /// Starts anew from a seedling; clears the undo stack.
    void reset(std::uint64_t seed, const TreeParameters& parameters = {});
    /// Takes over a tree that was read from a file, with its journal, whose last @p ahead deltas lie ahead of
    /// the moment to be shown; clears the undo stack.
    void reset(Tree tree, Journal journal, std::size_t ahead = 0);
    /// The same, in constant time but for those who listen to changed().
    void reset(PreparedTree prepared);

    /// The edit that is under way, or null.
    const Edit* edit() const { return m_edit; }
    /// Changes with every change of the tree.
    std::uint64_t revision() const { return m_revision; }
    /// Lets the owner of the edit that is under way end it, which keeps what was done unless the owner has
    /// reasons not to. To be called before the document is saved, replaced or closed, and before undo and
    /// redo.
    void interruptEdit();
    /// Undo and redo of the stack, after interruptEdit(). An interrupted edit is the step that undo() takes
    /// back.
    void undo();
    void redo();

    /// Bytes of the tree, its indices and its journal.
    std::size_t bytes() const;

Q_SIGNALS:
    /// An edit began or ended.
    void editChanged();
    void changed(const espalier::TreeChange& change);
    void competitorsChanged();
    void parametersHeld(bool held);

private:
    friend class Edit;
    friend class EditCommand;

    /// How to end the edit that is under way; see Edit.
    struct EditHooks {
        std::function<void()> interrupted;
        std::function<void()> cancel;
    };

    void setEdit(const Edit* edit, EditHooks hooks = {});
    /// Applies @p delta and appends it to the journal.
    void apply(std::shared_ptr<TreeDelta> delta);
    /// Reverts the journal's last delta and takes it out.
    void revertLast();
    /// Goes back or forth in the history, to where @p position deltas of it have been applied.
    /// Precondition: position <= journal().size() + future().size().
    void travelTo(std::size_t position);
    /// Takes the future away, since another one begins, or puts it (back) in its place. The caller keeps it.
    Journal takeFuture() { return std::exchange(m_future, {}); }
    void setFuture(Journal future) { m_future = std::move(future); }
    void tell(const TreeChange& change);

    Tree m_tree;
    TreeIndex m_index;
    std::unique_ptr<GrowthModel> m_growthModel;
    const Edit* m_edit = nullptr;
    EditHooks m_editHooks;
    std::uint64_t m_revision = 0;
    Journal m_journal;
    Journal m_future;
    Competitors m_competitors;
    int m_parameterHolds = 0;
    QUndoStack m_undoStack;
    mutable PickIndex m_pickIndex;
};

} // namespace espalier
