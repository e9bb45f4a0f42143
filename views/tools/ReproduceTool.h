// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/TreeFigure.h"
#include "model/sketch/StrokeFit.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace espalier {

/// A stroke of a tree's new figure.
enum class FigureStroke { Trunk, Silhouette };

/// Does what ReproduceTool asks for; app implements it.
class FigureTaking {
public:
    virtual ~FigureTaking() = default;
    /// The next stroke that the tool waits for, and whether it would be the figure's second one.
    virtual void expect(FigureStroke due, bool isSecond) = 0;
    /// Gives the tree the figure. Returns why it cannot, without a full stop, or an empty text.
    virtual QString take(TreeFigure figure) = 0;
    /// Says why a stroke was not taken; @p why has no full stop.
    virtual void refuse(const QString& why) = 0;
};

/// The same tree in a new figure (Okabe 2005, 3.7 and figure 12): a stroke is the new trunk, another one the
/// silhouette of the new crown. A loop that comes first is the silhouette. Strokes lie in the upright plane
/// through the tree's foot that faces the viewer of the first one. They show until the tree takes the figure.
/// While the trunk is due, a line shows the present one, which ends where the tree's first axis does.
class ReproduceTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(ReproduceTool)

public:
    ReproduceTool(ToolContext& context, FigureTaking& figures);

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    bool keyPressed(int key) override;
    void forget() override;
    bool canTakeBack() const override { return m_first.has_value(); }
    void takeBack() override;

    bool isFreehand() const override { return true; }
    bool isActive() const override { return m_isActive; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// The stroke that the tool waits for.
    FigureStroke due() const;

private:
    /// A line in the plane of the drawing, m from the tree's foot, right and up.
    using FlatLine = std::vector<Vec2>;
    /// The stroke that is there already.
    struct First {
        FigureStroke stroke;
        FlatLine line;
        double azimuth; ///< Of the drawing's plane, °
    };

    Vec3 foot() const { return context().document().tree().rootPosition(0); }
    bool isSeedling() const;
    double azimuthOfView() const;
    /// Why strokes cannot be drawn on that plane in this view; empty if they can.
    QString viewFault(double azimuth) const;
    std::optional<FlatLine> onPlane(double azimuth) const;
    QString take();
    QString takeFirst(bool isLoop, FlatLine line, double azimuth);
    QString takeSecond(bool isLoop, FlatLine line);
    static QString trunkFault(const FlatLine& line);
    bool looksClosed() const;
    void paintTrunk(Overlay& overlay) const;

    FigureTaking& m_figures;
    bool m_isActive = false;
    std::vector<QPointF> m_path; ///< px
    double m_length = 0.0;       ///< Of m_path, px
    std::optional<First> m_first;
};

} // namespace espalier
