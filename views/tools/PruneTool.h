// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <memory>

namespace espalier {

/// The tool that takes wood away. PruneMode, a value of the view, says how; it can be changed between
/// gestures.
class PruneTool : public Tool {
public:
    explicit PruneTool(ToolContext& context);

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override { hand().move(sample); }
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override { hand().hover(sample); }
    void leave() override;
    void wheel(double notches) override { hand().wheel(notches); }
    bool keyPressed(int key) override { return hand().keyPressed(key); }

    bool isActive() const override { return hand().isActive(); }
    void paint(Overlay& overlay) const override { hand().paint(overlay); }
    QString tip() const override { return hand().tip(); }

private:
    Tool& ofMode() const;
    /// The tool that a gesture is made with, or else that of the mode.
    Tool& hand() const { return m_held ? *m_held : ofMode(); }

    std::unique_ptr<Tool> m_cut;
    std::unique_ptr<Tool> m_clear;
    std::unique_ptr<Tool> m_eraser;
    Tool* m_held = nullptr;
};

} // namespace espalier
