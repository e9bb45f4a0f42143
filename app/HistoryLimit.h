// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <functional>
#include <memory>

namespace espalier {

class TreeDocument;
struct TreeChange;
struct PreparedScene;
struct ShownStrands;

/// Keeps the memory of a document's history within a limit: when it is exceeded, the oldest undo steps go,
/// and with them what only they could bring back (TreeDocument::shorten()). It looks and works in the
/// background, and puts the result in place at a moment at which nothing else happens; if the tree has
/// changed meanwhile, it tries again later.
class HistoryLimit : public QObject {
    Q_OBJECT

public:
    using ShownStrandsNow = std::function<std::shared_ptr<const ShownStrands>()>;

    /// @p isBusy: whether the user or the program is at work on the document. @p strands: those that are
    /// shown of it, or null.
    HistoryLimit(TreeDocument& document, std::function<bool()> isBusy, ShownStrandsNow strands,
                 QObject* parent = nullptr);
    ~HistoryLimit() override;

    /// @p bytes that the history may take.
    void setMost(std::size_t bytes);

Q_SIGNALS:
    /// The mesh of the tree under the ids that it is going to get.
    void scenePrepared(const std::shared_ptr<espalier::PreparedScene>& scene);
    /// The oldest part of the history is gone.
    void shortened();

private:
    struct Outcome;
    static constexpr std::size_t kUnknown = ~std::size_t{0};

    void follow(const TreeChange& change);
    void schedule();
    void look();
    void take(Outcome outcome);
    bool isAtRest() const;

    TreeDocument& m_document;
    std::function<bool()> m_isBusy;
    ShownStrandsNow m_strands;
    std::size_t m_most;
    QTimer m_timer;
    bool m_isWorking = false;
    bool m_isDue = false; ///< The history has changed since it was last looked at
    /// What the history takes at most: what it took when it was last looked at, and what has come since.
    std::size_t m_bytes = kUnknown;
    std::size_t m_rowBytes = 0; ///< See HistorySnapshot
};

} // namespace espalier
