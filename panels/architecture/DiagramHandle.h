// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QWidget>

#include <vector>

namespace espalier {

class Diagram;

/// What the keyboard and assistive tools meet of a diagram's handle: Tab goes from one to the next, arrows
/// move it the way they point (finely with Shift), + and - change its value, the page keys coarsely, Home and
/// End lead to the limits, Delete brings the default back. The diagram draws it, and takes the pointer's
/// events.
class DiagramHandle : public QWidget {
    Q_OBJECT

public:
    DiagramHandle(Diagram& diagram, int number, std::vector<const char*> keys, const QString& name);

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
    Diagram& m_diagram;
    int m_number;
    std::vector<const char*> m_keys;
    std::vector<ParameterScale> m_scales;
    QString m_announced;
};

} // namespace espalier
