// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;

namespace espalier {

class ParameterNumber;
class ParameterSlider;

/// Shows and changes one value of the view, as a ParameterRow does for a parameter of the tree. A change is
/// not undone, so it shows at once and there are no gestures.
class ViewRow : public QWidget {
    Q_OBJECT

public:
    explicit ViewRow(const ParameterScale& scale, QWidget* parent = nullptr);

    const char* key() const { return m_scale.info().key; }
    /// The value in the surface unit.
    double value() const { return m_value; }
    /// Shows @p value; emits no signal.
    void setValue(double value);
    /// The value that a double click on the slider, or Del, brings back.
    void setUsual(double value) { m_usual = value; }

Q_SIGNALS:
    /// The user has changed the value.
    void edited(double value);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void edit(double value);

    ParameterScale m_scale;
    double m_value = 0.0;
    std::optional<double> m_usual;
    bool m_isTakenBack = false; ///< By a double click whose second press is held
    ParameterSlider* m_slider = nullptr;
    ParameterNumber* m_number = nullptr;
    QCheckBox* m_switch = nullptr;
    QComboBox* m_choice = nullptr;
};

} // namespace espalier
