// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/document/TreeDocument.h"
#include "model/mesh/StrandMesher.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Makes the mesh of strands for a window whenever the tree has come to rest, on a worker thread from a copy
/// of the tree. What has not changed since the last mesh is taken over from that one. If the tree changes
/// meanwhile, the work stops, and begins again when the tree is at rest.
class StrandRunner : public QObject {
    Q_OBJECT

public:
    explicit StrandRunner(TreeDocument& document, QObject* parent = nullptr);
    /// Stops the work.
    ~StrandRunner() override;

    /// Asks for a mesh of the tree as it is, if its wood is shown as strands.
    void ask();
    /// Stops the work until the tree changes.
    void cancel();
    bool isRunning() const { return m_progress != nullptr; }
    /// Work that takes longer than this tells its progress, ms.
    void setPatience(int milliseconds);
    /// The last mesh with what belongs to it, or null.
    const std::shared_ptr<const StrandWood>& last() const { return m_last; }

Q_SIGNALS:
    /// The mesh of the tree at the document's revision @p revision, which is still the present one.
    void meshed(const std::shared_ptr<const espalier::TriangleMesh>& mesh, quint64 revision);
    /// The finished share, 0...1, of work that takes long; each time, ended() follows at last.
    void progressed(double share);
    void ended();
    /// The work was stopped by cancel(): there is no mesh of this tree.
    void cancelled();

private:
    void run();
    void stop();
    void receive(std::shared_ptr<const StrandWood> wood, std::uint64_t revision);

    TreeDocument& m_document;
    QTimer m_rest;
    QTimer m_tell;
    int m_patience = 0;
    QElapsedTimer m_since;                    ///< The work began
    std::shared_ptr<WorkProgress> m_progress; ///< Of the work that is under way, or null
    std::shared_ptr<const StrandWood> m_last;
};

} // namespace espalier
