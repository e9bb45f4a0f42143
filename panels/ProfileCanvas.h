// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/MedialAxis.h"
#include "model/tree/StrandProfile.h"

#include <QPixmap>
#include <QWidget>

#include <optional>
#include <span>
#include <vector>

class QPointerEvent;
class QTouchEvent;

namespace espalier {

/// The cross-section of a node, in the coordinates of its profile: seen from the branch's tip, +X to the
/// right and +Z (a profile's y) down.
struct ProfileSection {
    std::vector<Vec2> places;         ///< Of the strands
    std::vector<std::uint8_t> branch; ///< By strand: the branch that it runs to; 0 is the axis itself
    float strandRadius = 0.0F;        ///< Of all strands
};

/// Shows a cross-section with its strands, and lets the user sketch its profile with mouse, finger or pen.
class ProfileCanvas : public QWidget {
    Q_OBJECT

public:
    enum class Mode {
        Outline,   ///< A closed line adds an outline
        Attractor, ///< A straight drag adds an attractor
        Points,    ///< A drag moves a point of an outline or the end of an attractor
        Erase,     ///< A tap on a line removes it; so does a pen's eraser in every mode
    };

    explicit ProfileCanvas(QWidget* parent = nullptr);

    void setMode(Mode mode);
    Mode mode() const { return m_mode; }
    /// Shows a node's section and profile. Its first section, or another node's (@p isOther), is shown whole.
    void showSection(const ProfileSection& section, const StrandProfile& profile, bool isOther);
    /// Shows nothing.
    void clear();
    /// Strands are from an earlier state of the tree.
    void setOld(bool old);
    bool isEmpty() const { return !m_section; }
    /// Shows all of the section.
    void fit();
    /// Drops the stroke under way; returns false if there is none.
    bool cancelStroke();

    const StrandProfile& profile() const { return m_profile; }
    /// The faulty line that stays until the next stroke; empty if there is none.
    const StrandProfile::Loop& faultyLine() const { return m_faulty; }
    /// The place of a point of the profile on the widget, px, and the other way round.
    QPointF toWidget(const Vec2& point) const;
    Vec2 toProfile(const QPointF& place) const;

    QSize sizeHint() const override { return {300, 300}; }
    QSize minimumSizeHint() const override { return {180, 180}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return width; }

    /// Distance within which a tap finds a line or a point, px.
    static constexpr double kReach = 14.0;
    static constexpr double kFingerReach = 24.0;

Q_SIGNALS:
    /// The user has changed the profile. One without an outline takes it away.
    void edited(const StrandProfile& profile);
    /// A sentence about the last stroke, empty if all is well.
    void faultChanged(const QString& sentence);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// A point that can be moved: of an outline, or the end of an attractor.
    struct Point {
        bool isAttractor = false;
        std::size_t line = 0;
        std::size_t number = 0;
    };

    bool touchEvent(QTouchEvent* event);
    void begin(const QPointF& place, Mode mode, double reach);
    void move(const QPointF& place);
    void end();
    void drop();
    /// Whether the profile reaches beyond the canvas.
    bool isCutOff() const;
    void offer(StrandProfile profile, StrandProfile::Loop drawn);
    void setFault(const QString& sentence, StrandProfile::Loop line = {});
    std::optional<Point> pointAt(const QPointF& place, double reach) const;
    Vec2& at(const Point& point);
    void eraseAt(const QPointF& place, double reach);
    /// Draws again, the strands as well.
    void redraw();
    void paintStrands(QPainter& painter) const;
    void paintLines(QPainter& painter) const;

    Mode m_mode = Mode::Outline;
    std::optional<ProfileSection> m_section;
    StrandProfile m_profile;
    std::vector<MedialSegment> m_axis;
    bool m_isOld = false;
    QPixmap m_strands;     ///< The strands as they were drawn last; null if they must be drawn again
    double m_scale = 80.0; ///< px for the unit of the profile
    QPointF m_middle;      ///< The profile's origin, px from the widget's middle

    std::optional<Mode> m_stroke; ///< The mode of the stroke under way
    std::vector<Vec2> m_drawn;    ///< Of the stroke under way
    std::optional<Point> m_held;
    StrandProfile m_before; ///< At the press
    double m_reach = kReach;
    StrandProfile::Loop m_faulty;
    QPointF m_hover{-1e6, -1e6};
};

} // namespace espalier
