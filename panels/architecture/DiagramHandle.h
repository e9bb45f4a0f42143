// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QWidget>

#include <vector>

namespace espalier {

/// What the keyboard and assistive tools meet of a diagram's handle: Tab goes from one to the next, arrows
/// move it the way they point (finely with Shift), + and - change its value, the page keys coarsely, Home and
/// End lead to the limits, Delete brings the default back. The diagram draws it, and takes the pointer's
/// events.
class DiagramHandle : public QWidget {
    Q_OBJECT

public:
    /// What a handle asks of its diagram.
    class Owner {
    public:
        virtual ~Owner() = default;
        /// Of the parameter, in the surface unit.
        virtual double valueOf(const char* key) const = 0;
        /// Sets a parameter by a key of @p handle.
        virtual void setValueOf(const DiagramHandle& handle, const char* key, double value) = 0;
        /// Moves the handle as an arrow key that points along @p direction (a unit vector, y down) says.
        virtual void moveHandle(const DiagramHandle& handle, const QPointF& direction,
                                ParameterScale::Stride stride) = 0;
        /// Brings the defaults of the handle's parameters back.
        virtual void resetHandle(const DiagramHandle& handle) = 0;
        /// Whether a pointer drags a handle.
        virtual bool isDragging() const = 0;
        /// Takes that drag back.
        virtual void drop() = 0;
    };

    /// @p owner draws it, and outlives it, as does @p parent.
    DiagramHandle(QWidget& parent, Owner& owner, int number, std::vector<const char*> keys,
                  const QString& name);

    int number() const { return m_number; }

    const std::vector<const char*>& keys() const { return m_keys; }
    /// Of its first parameter.
    const ParameterScale& scale() const { return m_scales.front(); }
    /// Of its first parameter, in the surface unit.
    double value() const;
    void setValue(double value);
    /// All its parameters with names and units, to be read aloud.
    QString valueText() const;

    /// Tells assistive tools.
    void announce();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    Owner& m_owner;
    int m_number;
    std::vector<const char*> m_keys;
    std::vector<ParameterScale> m_scales;
    QString m_announced;
};

} // namespace espalier
