// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/StrandRunner.h"

#include "app/runners/Background.h"

namespace espalier {

namespace {
/// The tree is at rest if nothing has changed for this long, ms.
constexpr int kRestTime = 30;
} // namespace

StrandRunner::StrandRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestTime);
    connect(&m_rest, &QTimer::timeout, this, &StrandRunner::run);
    connect(&document, &TreeDocument::changed, this, &StrandRunner::ask);
}

bool StrandRunner::isWanted() const
{
    return m_fibresShown || m_document.parameters().wood.mesher == WoodMesherKind::Strands;
}

void StrandRunner::ask()
{
    if (isWanted())
        m_rest.start();
}

void StrandRunner::setFibresShown(bool shown)
{
    if (std::exchange(m_fibresShown, shown) != shown && shown)
        ask();
}

void StrandRunner::run()
{
    if (m_isRunning || !isWanted())
        return;
    m_isRunning = true;
    const std::uint64_t revision = m_document.revision();
    const bool withFibres = m_fibresShown;
    runInBackground(
        this,
        [tree = m_document.tree(), withFibres] {
            return std::make_shared<const StrandWood>(strandWood(tree, TreeIndex(tree), withFibres));
        },
        [this, revision, withFibres](const std::shared_ptr<const StrandWood>& strands) {
            m_isRunning = false;
            if (revision == m_document.revision())
                Q_EMIT meshed(strands, revision);
            if (revision != m_document.revision() || (m_fibresShown && !withFibres))
                ask();
        });
}

} // namespace espalier
