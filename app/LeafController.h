// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/sketch/LeafSuggestions.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

namespace espalier {

class LeafChoices;
class Viewport;

/// Offers ways to go on after the user has placed a leaf, and does the chosen one. What is offered follows
/// the document; an edit that concerns no placed leaf ends it.
class LeafController : public QObject {
    Q_OBJECT

public:
    /// @p isBusy: something else changes the document. All outlive the controller.
    LeafController(TreeDocument& document, const Viewport& viewport, LeafChoices& choices,
                   std::function<bool()> isBusy);

    /// Whether the tool in hand places leaves; otherwise nothing is offered.
    void setShown(bool shown);

private:
    void follow(const TreeChange& change);
    void offer();
    void take(LeafEngine engine);

    TreeDocument& m_document;
    const Viewport& m_viewport;
    LeafChoices& m_choices;
    std::function<bool()> m_isBusy;
    QTimer m_timer; ///< Offers are computed when the document, and the camera, are at rest
    std::optional<BranchPlace> m_place; ///< Of the leaf that was edited last
    bool m_isShown = false;
};

} // namespace espalier
