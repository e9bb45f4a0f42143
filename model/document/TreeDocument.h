// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "model/growth/GrowthIndex.h"
#include "model/tree/Tree.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <QObject>
#include <QUndoStack>

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

/// A tree, its journal and its undo stack. Whoever changes the tree does so by deltas through this class;
/// whoever shows it listens to changed().
class TreeDocument : public QObject {
    Q_OBJECT

public:
    explicit TreeDocument(QObject* parent = nullptr);
    ~TreeDocument() override;

    const Tree& tree() const { return m_tree; }
    const TreeIndex& index() const { return m_index; }
    /// Not for other threads: it is brought up to date when it is asked for.
    const GrowthIndex& growthIndex() const
    {
        m_growthIndex.settle(m_tree, m_index);
        return m_growthIndex;
    }
    /// Brings it a part of the way, about so many nodes; returns whether it is up to date.
    bool prepareGrowthIndex(std::size_t nodes) const
    {
        return m_growthIndex.settleSome(m_tree, m_index, nodes);
    }
    const TreeParameters& parameters() const { return m_tree.parameters(); }
    /// All that was done up to the moment shown, first to last.
    const Journal& journal() const { return m_journal; }
    /// What lies ahead of the moment shown, after travelTo() an earlier one: the last of it first.
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
    /// Takes over a tree that was read from a file, with its journal; clears the undo stack.
    void reset(Tree tree, Journal journal);

    /// Applies @p delta and appends it to the journal.
    void apply(std::shared_ptr<TreeDelta> delta);
    /// Reverts the journal's last delta and takes it out.
    void revertLast();
    /// Goes back or forth in the tree's history, to where @p position deltas of it have been applied.
    /// Precondition: at most journal().size() + future().size().
    void travelTo(std::size_t position);
    /// Takes the future away, since another one begins, or puts it (back) in its place. The caller keeps it.
    Journal takeFuture() { return std::exchange(m_future, {}); }
    void setFuture(Journal future) { m_future = std::move(future); }
    /// See Tree::rememberParameters.
    std::uint32_t rememberParameters(const TreeParameters& parameters);
    /// See Tree::forgetLastParameters.
    void forgetLastParameters();

    /// See Tree::rememberLasso.
    std::uint32_t rememberLasso(const LassoStroke& stroke) { return m_tree.rememberLasso(stroke); }
    /// See Tree::forgetLassosFrom.
    void forgetLassosFrom(std::uint32_t count) { m_tree.forgetLassosFrom(count); }

    /// Bytes of the tree, its indices and its journal.
    std::size_t bytes() const;

Q_SIGNALS:
    void changed(const espalier::TreeChange& change);
    void competitorsChanged();
    void parametersHeld(bool held);

private:
    Tree m_tree;
    TreeIndex m_index;
    mutable GrowthIndex m_growthIndex;
    void tell(const TreeChange& change);

    Journal m_journal;
    Journal m_future;
    Competitors m_competitors;
    int m_parameterHolds = 0;
    QUndoStack m_undoStack;
};

} // namespace espalier
