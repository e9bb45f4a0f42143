// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QWidget>

#include <vector>

namespace espalier {

/// The widget for a diagram's handle that gets the keyboard focus and that assistive tools see: Tab goes to
/// the next handle, arrows move the handle in their direction (finely with Shift), + and - change its value,
/// the page keys change it coarsely, Home and End go to the limits, Delete restores the default. The diagram
/// draws the handle, and handles the pointer's events.
class DiagramHandle : public QWidget {
    Q_OBJECT

public:
    /// The functions of a diagram that its handles call.
    class Owner {
    public:
        virtual ~Owner() = default;
        /// Value of a parameter, in the surface unit.
        virtual double valueOf(const char* key) const = 0;
        /// Sets a parameter after a key press in @p handle.
        virtual void setValueOf(const DiagramHandle& handle, const char* key, double value) = 0;
        /// Moves the handle for an arrow key that points along @p direction (a unit vector, y down).
        virtual void moveHandle(const DiagramHandle& handle, const QPointF& direction,
                                ParameterScale::Stride stride) = 0;
        /// Restores the defaults of the handle's parameters.
        virtual void resetHandle(const DiagramHandle& handle) = 0;
        /// Whether a pointer drags a handle.
        virtual bool isDragging() const = 0;
        /// Cancels that drag.
        virtual void drop() = 0;
    };

    /// @p owner draws the handle. @p owner and @p parent must outlive it.
    DiagramHandle(QWidget& parent, Owner& owner, int number, std::vector<const char*> keys,
                  const QString& name);

    int number() const { return m_number; }

    const std::vector<const char*>& keys() const { return m_keys; }
    /// Scale of the handle's first parameter.
    const ParameterScale& scale() const { return m_scales.front(); }
    /// Value of the handle's first parameter, in the surface unit.
    double value() const;
    void setValue(double value);
    /// All parameters of the handle with names and units, for a screen reader.
    QString valueText() const;

    /// Tells assistive tools that the value has changed.
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
