// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HistoryLimit.h"

#include "app/runners/Background.h"
#include "model/base/Parallel.h"
#include "model/document/HistorySnapshot.h"
#include "model/settings/Preferences.h"
#include "views/render/PreparedScene.h"

#include <optional>
#include <utility>

namespace espalier {

namespace {

constexpr int kInterval = 10'000; // ms from one look at the history to the next
constexpr int kRetry = 1'000;     // ms, while something else is at work

/// Strands of a tree for the same tree with other ids, so that they stay in sight.
std::shared_ptr<const ShownStrands> renumbered(const ShownStrands& strands, const NewNumbers& numbers,
                                               std::uint32_t count)
{
    auto same = std::make_shared<ShownStrands>(strands);
    if (strands.lines.empty())
        return same;
    same->lines.assign(count, {});
    for (InternodeId id = 0; id < strands.lines.size(); ++id) {
        if (numbers.isKept(id))
            same->lines[numbers[id]] = strands.lines[id];
    }
    return same;
}

} // namespace

struct HistoryLimit::Outcome {
    std::size_t bytes = 0;    ///< Of the history before it was shortened
    std::size_t rowBytes = 0; ///< See HistorySnapshot
    std::optional<ShortenedHistory> history{};
    std::shared_ptr<PreparedScene> scene{};
};

HistoryLimit::HistoryLimit(TreeDocument& document, std::function<bool()> isBusy, ShownStrandsNow strands,
                           QObject* parent)
    : QObject(parent),
      m_document(document),
      m_isBusy(std::move(isBusy)),
      m_strands(std::move(strands)),
      m_most(Preferences().undoBytes())
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &HistoryLimit::look);
    connect(&document, &TreeDocument::changed, this, &HistoryLimit::follow);
}

HistoryLimit::~HistoryLimit() = default;

void HistoryLimit::setMost(std::size_t bytes)
{
    if (bytes == m_most)
        return;
    m_most = bytes;
    m_bytes = kUnknown;
    m_isDue = true;
    m_timer.start(0);
}

void HistoryLimit::follow(const TreeChange& change)
{
    const TreeDelta* const delta = change.delta;
    m_isDue = true;
    if (!delta)
        m_bytes = kUnknown;
    else if (m_bytes != kUnknown)
        m_bytes += change.kind == TreeChange::Kind::Applied ? delta->bytes() + m_rowBytes * delta->died.size()
                                                            : m_rowBytes * delta->born.count;
    schedule();
}

void HistoryLimit::schedule()
{
    if (m_isDue && m_bytes > m_most && !m_isWorking && !m_timer.isActive())
        m_timer.start(kInterval);
}

bool HistoryLimit::isAtRest() const
{
    return !m_isBusy() && !m_document.edit() && !m_document.areParametersHeld();
}

void HistoryLimit::look()
{
    if (m_isWorking)
        return;
    if (!isAtRest()) {
        m_timer.start(kRetry);
        return;
    }
    m_isWorking = true;
    m_isDue = false;
    m_bytes = 0;
    runInBackground(
        this,
        [history = std::make_shared<HistorySnapshot>(m_document), strands = m_strands(),
         most = m_most]() mutable {
            Outcome outcome{.bytes = history->bytes(),
                            .rowBytes = history->rowBytes(),
                            .history = history->shortenedTo(most)};
            history.reset();
            if (outcome.history) {
                leavingOneThread([&outcome, &strands] {
                    PreparedTree& tree = outcome.history->document.tree;
                    tree.preparePicking();
                    outcome.scene = std::make_shared<PreparedScene>(
                        tree.tree, tree.index, tree.growthModel->space(),
                        strands ? renumbered(*strands, outcome.history->internodes, tree.tree.size())
                                : nullptr);
                });
            }
            return Result<Outcome>(std::move(outcome));
        },
        [this](Result<Outcome> outcome) {
            m_isWorking = false;
            // Without memory for it, the history stays as it is.
            if (outcome)
                take(std::move(*outcome));
            else
                m_bytes = kUnknown;
            schedule();
        });
}

void HistoryLimit::take(Outcome outcome)
{
    m_rowBytes = outcome.rowBytes;
    if (m_bytes != kUnknown)
        m_bytes += outcome.bytes;
    if (!outcome.history)
        return;
    if (!isAtRest() || outcome.history->revision != m_document.revision()) {
        m_isDue = true;
        return;
    }
    Q_EMIT scenePrepared(outcome.scene);
    if (!m_document.shorten(*outcome.history))
        return;
    // To free what there was takes long for a large tree.
    backgroundThreads().start(
        [before = std::make_shared<Outcome>(std::move(outcome))]() mutable { before.reset(); });
    Q_EMIT shortened();
}

} // namespace espalier
