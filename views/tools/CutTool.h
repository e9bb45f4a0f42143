// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/CutPreview.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <vector>

namespace espalier {

/// The secateurs (TreeSketch §3.3): a tap cuts a branch off at the branching point below; a stroke cuts every
/// branch that it crosses, or only those on the near side of the trunk. The branches that would fall are
/// shown before the cut.
class CutTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(CutTool)

public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;

    bool isActive() const override { return m_isActive; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

private:
    void aim(const PointerSample& sample);
    void cutAcross(const QPointF& from, const QPointF& to);
    void show(std::vector<InternodeId> cuts);
    void cut();

    bool m_isActive = false;
    bool m_isStroke = false; ///< The pointer has moved too far for a tap
    std::vector<QPointF> m_path;
    CutPreview m_preview;
};

} // namespace espalier
