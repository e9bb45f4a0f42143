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

/// A drawing of a piece of the growth model's mathematics, with handles that a person drags: mouse, finger or
/// keys (see DiagramHandle). What a drag comes to is one undo step, put in force when the handle is let go;
/// Escape takes it back, a double click on a handle brings its default back, one beside the handles those of
/// all. A press takes the handle nearest to it within 22 pixels.
class Diagram : public QWidget, private DiagramHandle::Owner {
    Q_OBJECT

public:
    ~Diagram() override;

    int handleCount() const { return static_cast<int>(m_handles.size()); }
    DiagramHandle& handle(int number) const { return *m_handles[static_cast<std::size_t>(number)]; }
    /// Where a handle is, px.
    QPointF handlePlace(int number) const;

    /// In a word, what the parameters amount to; may be empty.
    virtual QString caption() const { return {}; }

    QSize sizeHint() const override { return {180, 150}; }
    QSize minimumSizeHint() const override { return {150, 130}; }

    /// Pixels around a handle that a finger hits.
    static constexpr double kReach = 22.0;

protected:
    explicit Diagram(ParameterEditor& editor, QWidget* parent = nullptr);

    /// Adds a handle for one parameter, or for several that it stands for together, the first of which is
    /// the one that assistive tools read and set. @p name: that of the parameter unless given.
    void addHandle(std::vector<const char*> keys, const QString& name = {});

    /// Where the handle of that number stands for parameters, px.
    virtual QPointF place(int number, const GrowthParameters& growth) const = 0;
    /// Sets what the handle stands for so that it comes as near as it can to the point @p to, px.
    /// @p parameters are those at the beginning of the drag.
    virtual void pull(int number, const QPointF& to, TreeParameters& parameters) const = 0;
    /// What an arrow key that points along @p direction (a unit vector, y down) makes of the handle.
    virtual void stride(int number, const QPointF& direction, ParameterScale::Stride stride,
                        TreeParameters& parameters) const;
    /// Draws all but the handles.
    virtual void draw(QPainter& painter, const GrowthParameters& growth) = 0;
    /// Whether the handle is a ring, for what it lies upon is to be seen.
    virtual bool isRing(int) const { return false; }
    /// What the value bubble at a dragged handle says.
    virtual QString bubbleText(int number) const;

    const GrowthParameters& shown() const { return m_editor.shown().growth; }
    /// The parameters that the drawing is made to fit: while a handle is dragged those at the press, so that
    /// it stays under the finger.
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
    // What handles ask for
    double valueOf(const char* key) const override { return m_editor.value(key); }
    void setValueOf(const DiagramHandle& handle, const char* key, double value) override;
    void moveHandle(const DiagramHandle& handle, const QPointF& direction,
                    ParameterScale::Stride stride) override;
    void resetHandle(const DiagramHandle& handle) override;
    /// Takes the drag that goes on back.
    void drop() override;

    int handleAt(const QPointF& point) const;
    void follow();
    void reset(int number);
    /// Ends the drag that goes on, wherever it has led.
    void letGo();
    void drawHandle(QPainter& painter, int number) const;
    void drawBubble(QPainter& painter, int number) const;

    ParameterEditor& m_editor;
    std::vector<DiagramHandle*> m_handles;
    std::optional<TreeParameters> m_atPress;
    QPointF m_press;      ///< px
    QPointF m_grip;       ///< From the pointer to the handle, px
    int m_dragged = -1;   ///< Number of the handle under the pressed pointer
    bool m_moved = false; ///< The press has become a drag
    int m_hovered = -1;
};

} // namespace espalier
