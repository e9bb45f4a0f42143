// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/EnvelopeFilling.h"
#include "views/tools/EnvelopeView.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

namespace espalier {

/// The lasso (TreeSketch §3.2): a closed stroke draws the silhouette of the tree or of a part of it, in the
/// plane that is parallel to the screen and goes through the base of the tree, or through the branch at which
/// the stroke begins. When the stroke ends, the tree fills it; a press during that ends the filling and keeps
/// what has grown.
class LassoTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(LassoTool)

public:
    LassoTool(ToolContext& context, EnvelopeFilling& filling) : Tool(context), m_filling(filling) {}
    /// Ends filling and keeps what has grown.
    ~LassoTool() override { m_filling.end(); }

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void tick(double now) override;

    bool isFreehand() const override { return true; }
    bool isActive() const override { return m_isActive; }
    bool wantsTicks() const override { return m_isActive; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

private:
    void add(const QPointF& screen);

    EnvelopeFilling& m_filling;
    bool m_isActive = false;
    LassoStroke m_stroke;
    std::size_t m_previewed = 0; ///< Number of points of the stroke that the preview includes
    double m_previewTime = 0.0;  ///< s, of the samples' clock
    EnvelopeView m_preview;
    mutable EnvelopeView m_standing; ///< Made when it is painted
};

} // namespace espalier
