// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

WidthGesture::WidthGesture(TreeDocument& document, InternodeId id)
    : m_document(document), m_id(id), m_preview(document)
{
}

void WidthGesture::set(InternodeId place, double diameter)
{
    const auto lives = [&tree = m_document.tree()](InternodeId id) {
        return id < tree.size() && tree.isAlive(id);
    };
    if (m_preview.hasEnded() || std::isnan(diameter) || !lives(m_id) || !lives(place))
        return;
    // What is taken back first is what the next counts from.
    m_preview.show(TreeDelta::startingAt(m_document.tree()));
    const Tree& tree = m_document.tree();
    const auto after =
        diameter > 0.0
            ? static_cast<float>(std::clamp(diameter, kLeastDiameter, static_cast<double>(kGreatestDiameter)))
            : 0.0F;
    m_removes = after == 0.0F;
    TreeDelta delta = TreeDelta::startingAt(tree);
    const auto change = [&](InternodeId id, float wanted) {
        if (const float before = tree.widthConstraint(id); before != wanted)
            delta.widths.push_back({id, before, wanted});
    };
    if (place != m_id)
        change(m_id, 0.0F);
    change(place, after);
    m_preview.show(std::move(delta));
}

void WidthGesture::finish()
{
    m_preview.finish(m_removes ? QCoreApplication::translate("Commands", "Remove Width")
                               : QCoreApplication::translate("Commands", "Width"));
}

void setWidth(TreeDocument& document, InternodeId id, double diameter)
{
    WidthGesture gesture(document, id);
    gesture.set(diameter);
    gesture.finish();
}

} // namespace espalier
