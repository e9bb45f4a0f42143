// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/document/TreeDocument.h"
#include "model/mesh/ShownStrands.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Makes the strands, or their fibres, for a window whenever the tree has come to rest, on a worker thread
/// from a copy of the tree. What has not changed since the last ones is taken over from them; fibres of a
/// tree whose wood is tubes are made anew. If the tree changes meanwhile, the work stops, and begins again
/// when the tree is at rest.
class StrandRunner : public QObject {
    Q_OBJECT

public:
    explicit StrandRunner(TreeDocument& document, QObject* parent = nullptr);
    /// Stops the work.
    ~StrandRunner() override;

    /// Asks for the strands of the tree as it is, if they are shown.
    void ask();
    /// Stops the work until the tree changes.
    void cancel();
    bool isRunning() const { return m_progress != nullptr; }
    /// Sets whether fibres are shown, also those of a tree whose wood is tubes, and asks for them.
    void setFibresShown(bool shown);
    /// Work that takes longer than this tells its progress, ms.
    void setPatience(int milliseconds);
    /// The last strands with a surface, or null.
    const std::shared_ptr<const StrandWood>& last() const { return m_last; }

Q_SIGNALS:
    /// The strands of the tree at the document's revision @p revision, which is still the present one.
    void meshed(const std::shared_ptr<const espalier::ShownStrands>& strands, quint64 revision);
    /// The finished share, 0...1, of work that takes long: it only rises, until work for another tree begins.
    void progressed(double share);
    /// The work that has told its progress has ended, or was stopped, and no other work follows at once.
    void ended();
    /// The work was stopped by cancel(): there are no strands of this tree.
    void cancelled();

private:
    void run();
    void stop();
    void endTelling();
    void receive(const std::shared_ptr<const ShownStrands>& strands, std::uint64_t revision);
    bool isWanted() const;

    TreeDocument& m_document;
    QTimer m_rest;
    QTimer m_tell;
    int m_patience = 0;
    bool m_fibresShown = false;
    bool m_isTold = false;                    ///< progressed() was emitted, and ended() will be
    QElapsedTimer m_since;                    ///< The work began
    std::shared_ptr<WorkProgress> m_progress; ///< Of the work that is under way, or null
    std::shared_ptr<const StrandWood> m_last;
};

} // namespace espalier
