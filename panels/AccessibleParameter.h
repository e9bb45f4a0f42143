// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QAccessibleWidget>

#include <functional>

namespace espalier {

/// The accessible interface of a parameter's control: a slider with a value in the parameter's surface unit
/// and a text of the value with its unit.
class AccessibleParameter : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    struct Access {
        const ParameterScale& scale;
        std::function<double()> value;
        std::function<void(double)> setValue;
        std::function<QString()> text;
    };

    AccessibleParameter(QWidget* control, Access access)
        : QAccessibleWidget(control, QAccessible::Slider), m_access(std::move(access))
    {
    }

    void* interface_cast(QAccessible::InterfaceType type) override
    {
        if (type == QAccessible::ValueInterface)
            return static_cast<QAccessibleValueInterface*>(this);
        return QAccessibleWidget::interface_cast(type);
    }
    QString text(QAccessible::Text kind) const override
    {
        return kind == QAccessible::Value ? m_access.text() : QAccessibleWidget::text(kind);
    }
    QVariant currentValue() const override { return m_access.value(); }
    void setCurrentValue(const QVariant& value) override
    {
        m_access.setValue(m_access.scale.rounded(value.toDouble()));
    }
    QVariant maximumValue() const override { return m_access.scale.info().maximum; }
    QVariant minimumValue() const override { return m_access.scale.info().minimum; }
    QVariant minimumStepSize() const override
    {
        const double low = m_access.scale.info().minimum;
        return m_access.scale.stepped(low, 1, ParameterScale::Stride::Fine) - low;
    }

private:
    Access m_access;
};

} // namespace espalier
