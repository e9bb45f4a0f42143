// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/mesh/StrandWood.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Makes the strands, or their fibres, for a window whenever the tree has come to rest, on a worker thread
/// from a copy of the tree. Those of a tree that has changed meanwhile are dropped, and others are begun.
class StrandRunner : public QObject {
    Q_OBJECT

public:
    explicit StrandRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Asks for the strands of the tree as it is, if they are shown.
    void ask();
    /// Sets whether fibres are shown, also those of a tree whose wood is tubes, and asks for them.
    void setFibresShown(bool shown);
    bool isRunning() const { return m_isRunning; }

Q_SIGNALS:
    /// The strands of the tree at the document's revision @p revision, which is still the present one.
    void meshed(const std::shared_ptr<const espalier::StrandWood>& strands, quint64 revision);

private:
    void run();
    bool isWanted() const;

    TreeDocument& m_document;
    QTimer m_rest;
    bool m_isRunning = false;
    bool m_fibresShown = false;
};

} // namespace espalier
