// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/SetWidthOperation.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

WidthGesture::WidthGesture(TreeDocument& document, InternodeId id)
    : m_edit(document, [this] { finish(); }), m_id(id), m_place(id)
{
}

void WidthGesture::set(InternodeId place, double diameter)
{
    const Tree& tree = m_edit.document().tree();
    const auto isThere = [&](InternodeId id) { return id < tree.size() && tree.isAlive(id); };
    if (!m_edit.isActive() || std::isnan(diameter) || !isThere(m_id) || !isThere(place))
        return;
    // Each call replaces the one before: it starts at the tree before the drag.
    m_edit.takeBack();
    std::optional<float> after;
    if (diameter > 0.0)
        after =
            static_cast<float>(std::clamp(diameter, kLeastDiameter, static_cast<double>(kGreatestDiameter)));
    m_place = place;
    m_diameter = after;
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
    const auto operation = [this] {
        const TreeDocument& document = m_edit.document();
        SetWidthOperation width{InternodeReference::to(document, m_place),
                                m_diameter ? shortestDouble(*m_diameter) : 0.0};
        if (m_place != m_id)
            width.from = InternodeReference::to(document, m_id);
        return width;
    };
    commitRecorded(m_edit,
                   m_diameter ? QCoreApplication::translate("Commands", "Set Width")
                              : QCoreApplication::translate("Commands", "Remove Width"),
                   operation);
}

void setWidth(TreeDocument& document, InternodeId id, double diameter)
{
    WidthGesture gesture(document, id);
    gesture.set(diameter);
    gesture.finish();
}

} // namespace espalier
