// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

WidthGesture::WidthGesture(TreeDocument& document, InternodeId id)
    : m_edit(document, [this] { finish(); }), m_id(id)
{
}

void WidthGesture::set(InternodeId place, double diameter)
{
    const Tree& tree = m_edit.document().tree();
    const auto isThere = [&](InternodeId id) { return id < tree.size() && tree.isAlive(id); };
    if (!m_edit.isActive() || std::isnan(diameter) || !isThere(m_id) || !isThere(place))
        return;
    // What is taken back first is what the next counts from.
    m_edit.takeBack();
    std::optional<float> after;
    if (diameter > 0.0)
        after =
            static_cast<float>(std::clamp(diameter, kLeastDiameter, static_cast<double>(kGreatestDiameter)));
    m_removes = !after;
    TreeDelta delta = deltaStartingAt(tree);
    const auto change = [&](InternodeId id, const std::optional<float>& wanted) {
        if (const auto before = tree.content().sparse.width.at(id); before != wanted)
            delta.sparse.width.push_back({id, before, wanted});
    };
    if (place != m_id)
        change(m_id, {});
    change(place, after);
    m_edit.apply(std::move(delta));
}

void WidthGesture::finish()
{
    m_edit.commit(m_removes ? QCoreApplication::translate("Commands", "Remove Width")
                            : QCoreApplication::translate("Commands", "Width"));
}

void setWidth(TreeDocument& document, InternodeId id, double diameter)
{
    WidthGesture gesture(document, id);
    gesture.set(diameter);
    gesture.finish();
}

} // namespace espalier
