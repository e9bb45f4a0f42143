// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/SketchStroke.h"
#include "model/sketch/SketchedTree.h"
#include "views/tools/CutPreview.h"
#include "views/tools/EnvelopeFilling.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// The pencil (Okabe 2005, 3.2): a stroke becomes a branch of the one that it is nearest to, the first one
/// the trunk. As long as the tree is flat, strokes lie in its plane, seen from wherever; later in the plane
/// that is parallel to the screen and goes through their base. A loop is a leaf, or, if it is large, a crown
/// that the tree fills. Two strokes side by side are the two sides of one branch; its form is that of the
/// branches after it. With Shift, a pen's eraser or ViewValues::sketchCuts, a stroke takes away: what it
/// crosses once is cut there, what it crosses twice is erased.
class SketchTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(SketchTool)

public:
    /// @p refused is told why a stroke did not become a branch.
    SketchTool(ToolContext& context, EnvelopeFilling& filling,
               std::function<void(const QString& why)> refused)
        : Tool(context), m_filling(filling), m_refused(std::move(refused))
    {
    }

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;

    bool takesEraser() const override { return true; }
    bool isFreehand() const override { return true; }
    bool isActive() const override { return m_isActive; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// Where a stroke that began under the pointer would join the tree.
    const std::optional<BranchPlace>& shownPlace() const { return m_place; }

private:
    /// The plane that a stroke lies in.
    struct Plane {
        Vec3 origin = Vec3::Zero();
        Vec3 right = Vec3::UnitX();
        Vec3 up = Vec3::UnitY();
        bool isDrawing = true; ///< That of a flat tree
    };
    static inline const std::vector<float> kUsualForm{0.022F, 0.004F};
    /// What the last stroke drew, while a second side may follow.
    struct Side {
        SketchLine line; ///< px, up
        InternodeId branch = 0;
        std::optional<BranchPlace> base;
        Camera camera;
        std::uint64_t revision = 0; ///< Of the document
    };

    /// What a stroke is taken for.
    enum class Meaning { Nothing, Branch, SecondSide, Leaf, Crown };
    struct Reading {
        Meaning meaning = Meaning::Nothing;
        SketchLine line;           ///< px, up; of two sides the middle
        std::vector<double> radii; ///< Of two sides, px
    };

    bool isSeedling() const;
    Reading reading() const;
    bool isLarge(const SketchLine& outline) const;
    std::optional<Attachment> attachmentOf(const Eigen::Vector2d& first, const Eigen::Vector2d& last) const;
    Plane planeThrough(const Vec3& base) const;
    Vec3 onPlane(const Plane& plane, const Eigen::Vector2d& pixel) const;
    void draw();
    void drawBranch(Reading drawn, const std::optional<Side>& first);
    void drawLeaf(SketchLine outline);
    void drawCrown(const SketchLine& outline);
    void crossOut();
    std::vector<float> usualRadii(const std::optional<BranchPlace>& base, float length) const;
    void paintInk(Overlay& overlay) const;
    void paintReading(Overlay& overlay) const;

    EnvelopeFilling& m_filling;
    std::function<void(const QString& why)> m_refused;
    bool m_isActive = false;
    bool m_isCutting = false;
    std::vector<QPointF> m_path;
    QPointF m_pointer;
    std::optional<BranchPlace> m_place;
    std::uint64_t m_placeRevision = 0; ///< Of the tree that m_place is on
    std::optional<Side> m_last;
    /// Radii of the last two-sided branch in shares of its length, base to tip; before there is one, a taper.
    std::vector<float> m_form = kUsualForm;
    CutPreview m_preview;
};

} // namespace espalier
