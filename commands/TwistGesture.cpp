// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TwistGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/TwistOperation.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

TwistGesture::TwistGesture(TreeDocument& document, InternodeId id, TwistScope scope)
    : m_edit(document, [this] { finish(); }), m_id(id), m_scope(scope)
{
}

void TwistGesture::set(double angle)
{
    constexpr double kStepsPerDegree = 100.0;
    if (!m_edit.isActive() || std::isnan(angle))
        return;
    const double most = TwistOperation::kMostAngle;
    m_angle = std::round(std::clamp(angle, -most, most) * kStepsPerDegree) / kStepsPerDegree + 0.0; // not -0
    const TreeDocument& document = m_edit.document();
    // Relative to the tree before the drag.
    m_edit.takeBack();
    m_edit.apply(twist(document.tree(), document.index(), m_id, m_scope, radians(m_angle)));
}

void TwistGesture::finish()
{
    const QString text = m_angle != 0.0 ? QCoreApplication::translate("Commands", "Twist")
                                        : QCoreApplication::translate("Commands", "Remove Twist");
    commitRecorded(m_edit, text, [this] {
        return TwistOperation{InternodeReference::to(m_edit.document(), m_id), m_angle, m_scope};
    });
}

void twistBranch(TreeDocument& document, InternodeId id, TwistScope scope, double angle)
{
    TwistGesture gesture(document, id, scope);
    gesture.set(angle);
    gesture.finish();
}

} // namespace espalier
