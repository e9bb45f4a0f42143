// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/BendGesture.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// Bends branches (TreeSketch §3.3). A drag on a branch bends it from the place where it leaves its parent.
/// Taps place pins: the first is the base, which stays; the others hold the branch above it, and each can be
/// dragged. Several fingers on one branch do both at once: the lowest is the base.
class BendTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(BendTool)

public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    void tick(double now) override;
    bool takesFinger(const PointerSample& sample) const override;
    bool keyPressed(int key) override;
    void forget() override;
    void renumber(const NewNumbers& internodes) override;

    bool isActive() const override { return m_isDown; }
    bool wantsTicks() const override { return m_gesture != nullptr || m_isDown; }
    void paint(Overlay& overlay) const override;
    QCursor cursor() const override { return Qt::OpenHandCursor; }
    QString tip() const override;

private:
    using Pin = BranchBend::Handle;
    /// A pointer that holds the branch.
    struct Hand {
        int pointer;
        Pin pin;
        Vec3 grip;       ///< Place of the grip when the pointer was pressed, m
        QPointF pressed; ///< Place of the pointer at the press, px
        QPointF position;
    };

    bool isThere(const Pin& pin) const;
    Vec3 placeOf(const Pin& pin) const;
    const Pin* pinAt(const PointerSample& sample) const;
    std::optional<Pin> branchAt(const PointerSample& sample) const;
    InternodeId defaultBase(InternodeId id) const;
    InternodeId baseFor(const Pin& pin) const;
    void dropLostPins();
    void clearPins();
    void tap(const std::optional<Pin>& pin);
    void grip();
    void pull();
    void stop();
    void paintPath(Overlay& overlay, std::span<const InternodeId> path, const QColor& colour) const;
    Vec3 onBark(const Vec3& place, InternodeId id) const;

    std::optional<Pin> m_base;
    std::vector<Pin> m_pins; ///< Above the base, on one path
    std::optional<Pin> m_hovered;
    bool m_isDown = false;
    std::vector<Hand> m_hands;
    std::unique_ptr<BendGesture> m_gesture;
    std::vector<Vec3> m_pinnedAt; ///< Targets of the pins that no pointer drags, after those of the pointers
    bool m_isSettled = true;
};

} // namespace espalier
