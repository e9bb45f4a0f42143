// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/StrandRunner.h"

#include "app/runners/Background.h"

#include <algorithm>

namespace espalier {

namespace {
/// The tree is at rest if nothing has changed for this long, ms.
constexpr int kRestTime = 30;
/// Work that takes longer tells its progress, ms: until then the window shows an earlier tree, and does not
/// say so.
constexpr int kPatience = 300;
} // namespace

StrandRunner::StrandRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestTime);
    connect(&m_rest, &QTimer::timeout, this, &StrandRunner::run);
    setPatience(kPatience);
    connect(&m_tell, &QTimer::timeout, this, [this] {
        if (!m_progress || (!m_isTold && m_since.elapsed() < m_patience))
            return;
        m_isTold = true;
        Q_EMIT progressed(double{m_progress->share()});
    });
    connect(&document, &TreeDocument::changed, this, &StrandRunner::ask);
}

StrandRunner::~StrandRunner()
{
    stop();
}

void StrandRunner::setPatience(int milliseconds)
{
    m_patience = milliseconds;
    m_tell.setInterval(std::max(1, milliseconds / 5));
}

void StrandRunner::setFibresShown(bool shown)
{
    if (std::exchange(m_fibresShown, shown) != shown && (shown || !isWanted()))
        ask();
}

bool StrandRunner::isWanted() const
{
    return m_fibresShown || m_document.parameters().wood.mesher == WoodMesherKind::Strands;
}

void StrandRunner::stop()
{
    m_rest.stop();
    m_tell.stop();
    if (m_progress)
        m_progress->cancel();
}

void StrandRunner::ask()
{
    stop(); // What is under way is of an earlier tree
    if (isWanted()) {
        m_rest.start();
    } else {
        m_last.reset();
        endTelling();
    }
}

/// Work that is stopped and begins again with another tree tells its progress on, so that the sign of it does
/// not come and go.
void StrandRunner::endTelling()
{
    if (!isRunning() && !m_rest.isActive() && std::exchange(m_isTold, false))
        Q_EMIT ended();
}

void StrandRunner::cancel()
{
    if (!isRunning() && !m_rest.isActive())
        return;
    stop();
    endTelling();
    Q_EMIT cancelled();
}

void StrandRunner::run()
{
    // The work that was stopped has not ended yet.
    if (isRunning()) {
        m_rest.start();
        return;
    }
    m_progress = std::make_shared<WorkProgress>();
    m_since.start();
    m_tell.start();
    const std::uint64_t revision = m_document.revision();
    runInBackground(
        this,
        [tree = m_document.tree(), withFibres = m_fibresShown, last = m_last, progress = m_progress] {
            return makeShownStrands(tree, withFibres, last.get(), *progress);
        },
        [this, revision](const std::shared_ptr<const ShownStrands>& strands) { receive(strands, revision); });
}

void StrandRunner::receive(const std::shared_ptr<const ShownStrands>& strands, std::uint64_t revision)
{
    const bool isCancelled = m_progress->isCancelled();
    m_progress.reset();
    m_tell.stop();
    endTelling();
    if (!strands || isCancelled)
        return;
    m_last = strands->wood;
    Q_EMIT meshed(strands, revision);
}

} // namespace espalier
