// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/StrandRunner.h"

#include "app/runners/Background.h"

#include <algorithm>

namespace espalier {

namespace {
/// The tree is at rest if nothing has changed for this long, ms.
constexpr int kRestTime = 30;
constexpr int kPatience = 500;

std::shared_ptr<const StrandWood> makeWood(const Tree& tree, const StrandWood* last, WorkProgress& progress)
{
    const TreeIndex index(tree);
    auto layouts = std::make_shared<const StrandLayouts>(
        tree, index, Widths(tree, index), last != nullptr ? last->layouts.get() : nullptr, &progress);
    if (progress.isCancelled())
        return nullptr;
    return meshStrands(std::move(layouts), tree.parameters(), {}, last, progress);
}
} // namespace

StrandRunner::StrandRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestTime);
    connect(&m_rest, &QTimer::timeout, this, &StrandRunner::run);
    setPatience(kPatience);
    connect(&m_tell, &QTimer::timeout, this, [this] {
        if (m_progress && m_since.elapsed() >= m_patience)
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

void StrandRunner::stop()
{
    m_rest.stop();
    if (m_progress)
        m_progress->cancel();
}

void StrandRunner::ask()
{
    stop(); // What is under way is of an earlier tree
    if (m_document.parameters().wood.mesher == WoodMesherKind::Strands)
        m_rest.start();
    else
        m_last.reset();
}

void StrandRunner::cancel()
{
    if (!isRunning() && !m_rest.isActive())
        return;
    stop();
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
        [tree = m_document.tree(), last = m_last, progress = m_progress] {
            return makeWood(tree, last.get(), *progress);
        },
        [this, revision](std::shared_ptr<const StrandWood> wood) { receive(std::move(wood), revision); });
}

void StrandRunner::receive(std::shared_ptr<const StrandWood> wood, std::uint64_t revision)
{
    const bool isWanted = !m_progress->isCancelled();
    m_progress.reset();
    m_tell.stop();
    Q_EMIT ended();
    if (!wood || !isWanted)
        return;
    m_last = std::move(wood);
    Q_EMIT meshed(m_last->mesh, revision);
}

} // namespace espalier
