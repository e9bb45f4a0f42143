// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <functional>
#include <memory>

namespace espalier {

/// A call that changed a document: of an Edit, or of TreeDocument::undo() or redo(). Another document in the
/// same state becomes the same by the same calls (see EditFollower).
struct EditEvent {
    enum class Kind : std::uint8_t {
        Began,
        Resumed,
        Applied, ///< delta
        TookBackLast,
        ReplacedFrom, ///< position
        TravelledTo,  ///< position
        Committed,    ///< text, operation
        Cancelled,
        Undone,
        Redone,
    };

    Kind kind;
    /// A copy that no document shares, with the rows that it brings.
    std::unique_ptr<TreeDelta> delta = nullptr;
    std::size_t position = 0; ///< In the history
    QString text = {};
    QByteArray operation = {};
};

/// Is called with each event just before the document changes.
using EditListener = std::function<void(EditEvent)>;

} // namespace espalier
