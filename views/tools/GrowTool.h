// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <QCoreApplication>

namespace espalier {

/// Growth that the Grow tool starts and stops; app implements it.
class HeldGrowth {
public:
    virtual ~HeldGrowth() = default;
    virtual bool isRunning() const = 0;
    /// Starts growth, until release(), end() or cancel().
    virtual void begin() = 0;
    /// Ends growth after the step that is being computed, and keeps it.
    virtual void release() = 0;
    /// Ends growth at once, and keeps what has grown.
    virtual void end() = 0;
    /// Ends growth at once and takes back what has grown.
    virtual void cancel() = 0;
};

/// Growth while the pointer is pressed anywhere in the view.
class GrowTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(GrowTool)

public:
    GrowTool(ToolContext& context, HeldGrowth& growth) : Tool(context), m_growth(growth) {}
    ~GrowTool() override { cancel(); }

    void begin(const PointerSample& sample) override;
    void move(const PointerSample&) override {}
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;

    bool isActive() const override { return m_holds; }
    QCursor cursor() const override { return Qt::PointingHandCursor; }
    QString tip() const override { return tr("Press and hold: the tree grows until you let go"); }

private:
    HeldGrowth& m_growth;
    bool m_holds = false;
};

} // namespace espalier
