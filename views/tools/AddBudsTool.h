// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/AdventitiousBuds.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace espalier {

/// Adds adventitious buds to old wood (Strands 2024 §5, figure 7). While the pointer is over a branch, or
/// down on it, rings show where the buds will be; the middle one is under the pointer. The release adds them.
class AddBudsTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(AddBudsTool)

public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override { cancel(); }
    void cancel() override;
    void hover(const PointerSample& sample) override { aim(sample); }
    void leave() override;

    bool isActive() const override { return m_isDown; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// Where the rings are shown.
    const std::vector<BarkBud>& shownBuds() const { return m_buds; }

private:
    std::optional<BudSpiral> spiralAt(const PointerSample& sample) const;
    void aim(const PointerSample& sample);

    bool m_isDown = false;
    std::optional<BudSpiral> m_spiral;
    std::vector<BarkBud> m_buds;
    std::uint64_t m_revision = 0; ///< Of the tree that m_buds are on
};

} // namespace espalier
