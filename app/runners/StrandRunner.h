// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/mesh/Mesh.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Makes the mesh of strands for a window whenever the tree has come to rest, on a worker thread from a copy
/// of the tree. A mesh of a tree that has changed meanwhile is dropped, and another one is begun.
class StrandRunner : public QObject {
    Q_OBJECT

public:
    explicit StrandRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Asks for a mesh of the tree as it is, if its wood is shown as strands.
    void ask();
    bool isRunning() const { return m_isRunning; }

Q_SIGNALS:
    /// The mesh of the tree at the document's revision @p revision, which is still the present one.
    void meshed(const std::shared_ptr<const espalier::TriangleMesh>& mesh, quint64 revision);

private:
    void run();

    TreeDocument& m_document;
    QTimer m_rest;
    bool m_isRunning = false;
};

} // namespace espalier
