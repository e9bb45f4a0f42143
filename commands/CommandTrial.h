// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/document/TreeDocument.h"

#include <functional>
#include <optional>

namespace espalier {

/// A command that is tried out with other values: what is tried next takes the place of what was tried last,
/// on the tree and on the undo stack, as long as nothing else was done.
class CommandTrial {
public:
    explicit CommandTrial(TreeDocument& document) : m_document(document) {}

    /// Whether the last thing that was done is a trial, which the next one would replace.
    bool isLast() const { return m_revision == m_document.revision(); }

protected:
    /// Calls @p perform with an edit of the tree before the last trial; it commits the edit, or fails. If it
    /// fails, a trial before it stays.
    Result<void> tryWith(const std::function<Result<void>(Edit&)>& perform);

private:
    TreeDocument& m_document;
    std::optional<std::uint64_t> m_revision; ///< Of the document after the last trial
};

} // namespace espalier
