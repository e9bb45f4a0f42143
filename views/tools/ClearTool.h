// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/CutPreview.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <optional>

namespace espalier {

/// Keeps the lower part of a trunk or a branch clear: a drag up along it, or a tap, says up to where. What is
/// there falls, and no buds shoot there. A ring around the wood stays at the upper end; dragged, it moves
/// this end, down to the base to let buds shoot again.
class ClearTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(ClearTool)

public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    bool keyPressed(int key) override;

    bool isActive() const override { return m_isDown; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// Where the ring of an axis that is kept clear over @p length, m, is in the world.
    static Vec3 placeOn(const Tree& tree, const TreeIndex& index, InternodeId axis, float length);

private:
    /// An axis, and up to where it is to be clear.
    struct Aim {
        InternodeId axis;
        float length; ///< m
    };

    std::optional<Aim> aimAt(const PointerSample& sample) const;
    std::optional<InternodeId> ringAt(const PointerSample& sample) const;
    float lengthAt(InternodeId axis, const QPointF& screen) const;
    void aim(const std::optional<Aim>& wanted);
    void paintClear(Overlay& overlay, const Aim& clear, bool isLit) const;

    bool m_isDown = false;
    QPointF m_offset; ///< From the pointer to the place that it holds, px
    std::optional<Aim> m_aim;
    CutPreview m_preview;
};

} // namespace espalier
