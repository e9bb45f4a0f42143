// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterEditor.h"
#include "panels/ParameterScale.h"
#include "panels/architecture/DiagramHandle.h"

#include <QPainterPath>
#include <QWidget>

#include <optional>
#include <vector>

namespace espalier {

/// A drawing of a part of the growth model, with handles that the user drags: by mouse, finger or keys (see
/// DiagramHandle). A drag is one undo step, put in force when the handle is released; Escape cancels it. A
/// double click on a handle restores its default, a double click beside the handles restores the defaults of
/// all. A press takes the nearest handle within 22 pixels.
class Diagram : public QWidget, private DiagramHandle::Owner {
    Q_OBJECT

public:
    ~Diagram() override;

    int handleCount() const { return static_cast<int>(m_handles.size()); }
    DiagramHandle& handle(int number) const { return *m_handles[static_cast<std::size_t>(number)]; }
    /// Where a handle is, px.
    QPointF handlePlace(int number) const;

    /// A short summary of what the parameters mean together; may be empty.
    virtual QString caption() const { return {}; }

    QSize sizeHint() const override { return {180, 150}; }
    QSize minimumSizeHint() const override { return {150, 130}; }

    /// Distance around a handle within which a press takes it, px.
    static constexpr double kReach = 22.0;

protected:
    explicit Diagram(ParameterEditor& editor, QWidget* parent = nullptr);

    /// Adds a handle for one parameter, or for several parameters together; assistive tools read and set the
    /// first of them. @p name: the parameter's name if empty.
    void addHandle(std::vector<const char*> keys, const QString& name = {});

    /// The place of the handle of that number for given parameters, px.
    virtual QPointF place(int number, const GrowthParameters& growth) const = 0;
    /// Sets the handle's parameters so that it comes as near as possible to the point @p to, px. On entry @p
    /// parameters are those at the beginning of the drag.
    virtual void pull(int number, const QPointF& to, TreeParameters& parameters) const = 0;
    /// Moves the handle for an arrow key that points along @p direction (a unit vector, y down).
    virtual void stride(int number, const QPointF& direction, ParameterScale::Stride stride,
                        TreeParameters& parameters) const;
    /// Draws all but the handles.
    virtual void draw(QPainter& painter, const GrowthParameters& growth) = 0;
    /// Whether the handle is drawn as a ring, so that the drawing below it stays visible.
    virtual bool isRing(int) const { return false; }
    /// Text of the bubble beside a dragged handle.
    virtual QString bubbleText(int number) const;

    const GrowthParameters& shown() const { return m_editor.shown().growth; }
    /// The parameters that the drawing's scale fits: while a handle is dragged those at the press, so that
    /// the handle stays under the finger.
    const GrowthParameters& fitted() const { return m_atPress ? m_atPress->growth : shown(); }
    bool isDragging() const override { return m_dragged >= 0; }

    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    // DiagramHandle::Owner
    double valueOf(const char* key) const override { return m_editor.value(key); }
    void setValueOf(const DiagramHandle& handle, const char* key, double value) override;
    void moveHandle(const DiagramHandle& handle, const QPointF& direction,
                    ParameterScale::Stride stride) override;
    void resetHandle(const DiagramHandle& handle) override;
    /// Cancels the drag under way.
    void drop() override;

    int handleAt(const QPointF& point) const;
    void follow();
    void reset(int number);
    /// Ends the drag under way and keeps its result.
    void letGo();
    void drawHandle(QPainter& painter, int number) const;
    void drawBubble(QPainter& painter, int number) const;

    ParameterEditor& m_editor;
    std::vector<DiagramHandle*> m_handles;
    std::optional<TreeParameters> m_atPress;
    QPointF m_press;      ///< px
    QPointF m_grip;       ///< From the pointer to the handle, px
    int m_dragged = -1;   ///< Number of the dragged handle, -1 for none
    bool m_moved = false; ///< The press has become a drag
    int m_hovered = -1;
};

} // namespace espalier
