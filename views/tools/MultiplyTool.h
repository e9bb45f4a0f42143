// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <functional>
#include <optional>

namespace espalier {

/// More by example (Okabe 2005, 3.3 and 3.6): a tap on a branch gives it one more branch like those that it
/// carries; or, with ViewValues::passesOn, gives other branches what it carries. The branch under the pointer
/// shows.
class MultiplyTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(MultiplyTool)

public:
    /// @p refused is told why a tap did nothing.
    MultiplyTool(ToolContext& context, std::function<void(const QString& why)> refused)
        : Tool(context), m_refused(std::move(refused))
    {
    }

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

private:
    void aim(const PointerSample& sample);

    std::function<void(const QString& why)> m_refused;
    bool m_isDown = false;
    std::optional<InternodeId> m_axis; ///< Under the pointer
    std::uint64_t m_revision = 0;      ///< Of the tree that m_axis is in
};

} // namespace espalier
