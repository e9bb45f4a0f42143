// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/GrowRunner.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

namespace espalier {

/// Growth under a hand that holds: press anywhere, and the tree grows until you let go.
class GrowTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(GrowTool)

public:
    GrowTool(ToolContext& context, GrowRunner& runner) : Tool(context), m_runner(runner) {}
    ~GrowTool() override { cancel(); }

    void begin(const PointerSample& sample) override;
    void move(const PointerSample&) override {}
    void end(const PointerSample& sample) override;
    void cancel() override;

    bool isActive() const override { return m_holds; }
    QCursor cursor() const override { return Qt::PointingHandCursor; }
    QString tip() const override { return tr("Press and hold: the tree grows until you let go."); }

private:
    GrowRunner& m_runner;
    bool m_holds = false;
};

} // namespace espalier
