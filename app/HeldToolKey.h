// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include <optional>

class QAction;

namespace espalier {

class Actions;

/// Takes a tool for as long as its key is held, and then gives the former one back. A key that is only tapped
/// takes the tool for good. The object filters the application's events from its construction on.
class HeldToolKey : public QObject {
    Q_OBJECT

public:
    /// A key that was held this long, ms, while its tool was used gives the former tool back.
    static constexpr int kHeld = 250;
    /// The same for a tool that was not used.
    static constexpr int kHeldUnused = 700;

    explicit HeldToolKey(const Actions& actions, QObject* parent = nullptr);

    /// The former tool comes back only when a gesture is over.
    void setGestureActive(bool active);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Held {
        int key;
        QAction* taken;
        QAction* former;
        bool isUsed = false;
        bool isReleased = false;
    };

    QAction* toolInHand() const;
    void release();
    void giveBack();

    const Actions& m_actions;
    std::optional<Held> m_held;
    QElapsedTimer m_clock;
    bool m_isGestureActive = false;
};

} // namespace espalier
