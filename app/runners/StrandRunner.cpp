// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/StrandRunner.h"

#include "app/runners/Background.h"
#include "model/mesh/WoodMesh.h"

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

void StrandRunner::ask()
{
    if (m_document.parameters().wood.mesher == WoodMesherKind::Strands)
        m_rest.start();
}

void StrandRunner::run()
{
    if (m_isRunning || m_document.parameters().wood.mesher != WoodMesherKind::Strands)
        return;
    m_isRunning = true;
    const std::uint64_t revision = m_document.revision();
    runInBackground(
        this,
        [tree = m_document.tree()] {
            const TreeIndex index(tree);
            return std::make_shared<const TriangleMesh>(meshWood(tree, index, Widths(tree, index)));
        },
        [this, revision](std::shared_ptr<const TriangleMesh> mesh) {
            m_isRunning = false;
            if (revision == m_document.revision())
                Q_EMIT meshed(mesh, revision);
            else
                ask();
        });
}

} // namespace espalier
