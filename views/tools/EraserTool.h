// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/SweptTwigs.h"
#include "views/tools/CutPreview.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <memory>

namespace espalier {

class Thinning;
class TwigRule;

/// A round brush before the tree that takes twigs and leaves behind it, however deep in the crown they are,
/// or a share of the twigs (PruneMode::Thin). It has the size of the brush that paints. What would go is
/// shown before the release.
class EraserTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(EraserTool)

public:
    explicit EraserTool(ToolContext& context);
    ~EraserTool() override;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    void wheel(double notches) override;

    bool isActive() const override { return m_isActive; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

private:
    bool thins() const;
    SweepPoint brushAt(const PointerSample& sample) const;
    void look(const SweepPoint& toward);
    void sweepTo(const SweepPoint& point);
    void showSwept();

    bool m_isActive = false;
    bool m_isShown = false; ///< The pointer is over the view
    SweepPoint m_brush;
    SweptTwigs m_twigs; ///< The stroke so far, or the brush that hovers
    Swept m_swept;
    std::unique_ptr<SeenWood> m_seen; ///< From the eye of the last sweep
    std::uint64_t m_revision = 0;     ///< Of the tree that the following are of
    std::unique_ptr<TwigRule> m_rule;
    std::unique_ptr<Thinning> m_thinning; ///< Null while the tool erases
    double m_ruleThickest = 0.0;
    double m_thinningShare = 0.0;
    CutPreview m_preview;
};

} // namespace espalier
