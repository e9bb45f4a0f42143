// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/sketch/DepthInference.h"

#include <optional>

namespace espalier {

/// Gives a drawn tree depth (giveDepth()), as one undo step. Fails (Kind::Input), and changes nothing, as
/// that does.
Result<void> inferDepth(TreeDocument& document, const DepthOptions& options);

/// The depth of a drawn tree while its options are tried out: what is tried next takes the place of what was
/// tried last, on the tree and on the undo stack, as long as nothing else was done.
class DepthTrial {
public:
    explicit DepthTrial(TreeDocument& document) : m_document(document) {}

    /// Whether the last thing that was done is a trial, which the next one would replace.
    bool isLast() const { return m_revision == m_document.revision(); }
    /// Fails as inferDepth() does; then a trial before it stays.
    Result<void> tryOut(const DepthOptions& options);

private:
    TreeDocument& m_document;
    std::optional<std::uint64_t> m_revision; ///< Of the document after the last trial
};

} // namespace espalier
