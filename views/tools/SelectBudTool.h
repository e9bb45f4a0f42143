// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <functional>
#include <utility>
#include <vector>

namespace espalier {

/// Chooses the bud that alone shall grow, with the branch that comes from it (selective growth, TreeSketch
/// §3.2 and figure 9). A tap on a bud chooses it, a tap elsewhere lets all buds grow again.
class SelectBudTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(SelectBudTool)

public:
    /// @p say: tells the user why a tap did nothing.
    SelectBudTool(ToolContext& context, std::function<void(const QString& why)> say)
        : Tool(context), m_say(std::move(say))
    {
    }

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
    void look(const PointerSample& sample);

    std::function<void(const QString&)> m_say;
    bool m_isActive = false;
    std::vector<PickedBud> m_buds; ///< Buds around the pointer, the nearest first
    bool m_isNear = false;         ///< Whether the first of them is under the pointer
};

} // namespace espalier
