// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/EnvelopeView.h"

#include "model/envelope/EnvelopeSet.h"

#include <algorithm>

namespace espalier {

void EnvelopeView::show(std::span<const LassoStroke> strokes, int resolution)
{
    if (std::ranges::equal(strokes, m_strokes))
        return;
    m_strokes.assign(strokes.begin(), strokes.end());
    m_outlines.clear();
    m_mesh.reset();
    const Result<EnvelopeSet> set = EnvelopeSet::fromStrokes(m_strokes, {.resolution = resolution});
    if (!set)
        return;
    auto whole = std::make_shared<EnvelopeMesh>();
    for (const Envelope& envelope : set->envelopes()) {
        const EnvelopeMesh mesh = envelopeMesh(envelope);
        const auto first = static_cast<std::uint32_t>(whole->positions.size());
        whole->positions.insert(whole->positions.end(), mesh.positions.begin(), mesh.positions.end());
        whole->normals.insert(whole->normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (const std::uint32_t vertex : mesh.triangles)
            whole->triangles.push_back(first + vertex);
        for (std::vector<Vec3> line : envelope.outline()) {
            line.push_back(line.front());
            m_outlines.push_back(std::move(line));
        }
    }
    m_mesh = std::move(whole);
}

void EnvelopeView::paint(Overlay& overlay, const QColor& colour) const
{
    if (!m_mesh)
        return;
    overlay.addSurface({m_mesh, colour, 0.3F});
    QColor line = colour;
    line.setAlphaF(0.7F);
    for (const std::vector<Vec3>& outline : m_outlines)
        overlay.addLine(outline, line, 1.4F);
}

} // namespace espalier
