// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HeldToolKey.h"

#include "panels/Actions.h"

#include <QApplication>
#include <QKeyEvent>
#include <QShortcutEvent>

#include <algorithm>
#include <utility>

namespace espalier {

HeldToolKey::HeldToolKey(const Actions& actions, QObject* parent) : QObject(parent), m_actions(actions)
{
    qApp->installEventFilter(this);
}

QAction* HeldToolKey::toolInHand() const
{
    for (const ActionId id : Actions::tools()) {
        if (m_actions[id]->isChecked())
            return m_actions[id];
    }
    return nullptr;
}

bool HeldToolKey::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Shortcut) {
        const bool isTool = std::ranges::any_of(
            Actions::tools(), [&](ActionId id) { return static_cast<QObject*>(m_actions[id]) == watched; });
        auto* action = isTool ? static_cast<QAction*>(watched) : nullptr;
        QAction* former = toolInHand();
        if (action && action->isEnabled() && former && former != action) {
            m_held = Held{static_cast<const QShortcutEvent*>(event)->key()[0].key(), action, former};
            m_clock.start();
        }
    } else if (event->type() == QEvent::KeyRelease && m_held) {
        const auto* key = static_cast<const QKeyEvent*>(event);
        if (!key->isAutoRepeat() && key->key() == m_held->key && !m_held->isReleased)
            release();
    } else if (event->type() == QEvent::ApplicationDeactivate) {
        // The release would go elsewhere.
        m_held.reset();
    }
    return QObject::eventFilter(watched, event);
}

void HeldToolKey::setGestureActive(bool active)
{
    m_isGestureActive = active;
    if (!m_held)
        return;
    m_held->isUsed = true;
    // The end of the gesture is being told now.
    if (!active && m_held->isReleased)
        QMetaObject::invokeMethod(this, &HeldToolKey::giveBack, Qt::QueuedConnection);
}

void HeldToolKey::release()
{
    if (m_clock.elapsed() < (m_held->isUsed ? kHeld : kHeldUnused)) {
        m_held.reset();
        return;
    }
    m_held->isReleased = true;
    if (!m_isGestureActive)
        giveBack();
}

void HeldToolKey::giveBack()
{
    const std::optional<Held> held = std::exchange(m_held, std::nullopt);
    // Unless another tool was chosen meanwhile.
    if (held && held->taken->isChecked() && held->former->isEnabled())
        held->former->trigger();
}

} // namespace espalier
