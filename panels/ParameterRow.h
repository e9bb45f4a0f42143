// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"
#include "panels/ParameterTexts.h"

#include <QTimer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace espalier {

/// One parameter to look at and to change: a slider below its name and its number, a switch, or a list of
/// choices. A gesture is whatever a person feels to be one change: a drag of the slider, a number typed, a
/// turn of the wheel.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    ParameterRow(const ParameterInfo& info, const ParameterText& text, QWidget* parent = nullptr);

    const char* key() const { return m_text.key; }
    /// In ParameterInfo's surface unit.
    double value() const { return m_value; }
    /// Shows @p value; no signal.
    void setValue(double value);

Q_SIGNALS:
    /// A person has changed the value; the gesture may go on.
    void edited(double value);
    /// The gesture that began with the first edited() is over.
    void gestureEnded();

protected:
    bool event(QEvent* event) override;

private:
    QLabel* makeLabel();
    void makeSlider();
    void makeSwitch();
    void makeChoice();
    QString labelText() const;
    QString toolTipText() const;
    void present(double value);
    void edit(double value);
    double valueAt(int position) const;
    int positionOf(double value) const;

    ParameterInfo m_info;
    ParameterText m_text;
    double m_value = 0.0;
    bool m_dragging = false;
    bool m_isPassingOn = false;
    /// Ends the gesture of a wheel or of a key, which has no end of its own.
    QTimer m_rest;
    QSlider* m_slider = nullptr;
    QDoubleSpinBox* m_number = nullptr;
    QCheckBox* m_switch = nullptr;
    QComboBox* m_choice = nullptr;
};

} // namespace espalier
