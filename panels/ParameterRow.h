// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ParameterScale.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace espalier {

class LookChoice;
class ParameterEditor;
class ParameterNumber;
class ParameterSlider;

/// Shows and changes one parameter: a slider below its name and its number, a switch, or a list of choices. A
/// gesture is one change: a drag of the slider, a number typed, a turn of the wheel. Parameters whose effect
/// shows at once (leaves, widths, bark) are tried out while the slider moves; parameters of growth are put in
/// force when it rests. A double click restores the default, Escape cancels a drag.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    ParameterRow(ParameterEditor& editor, const ParameterText& text, QWidget* parent = nullptr);

    const char* key() const { return m_scale.info().key; }
    /// The value that shows, in ParameterInfo's surface unit.
    double value() const { return m_value; }
    /// The list of looks, or null if the row is not one.
    LookChoice* look() const { return m_look; }
    /// Shows the choice alone, below a heading that says the same as the label.
    void hideLabel();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* makeLabel();
    void makeSlider();
    void makeSwitch();
    void makeChoice();
    bool keyPressed(const QKeyEvent& event);
    void present();
    void follow();
    void edit(double value);
    void choose(double value);
    void chooseDrawn(int drawn);
    QString undoText(double value) const;
    void reset();

    ParameterEditor& m_editor;
    ParameterScale m_scale;
    double m_value = 0.0;
    bool m_isDragging = false;
    bool m_isTakenBack = false; ///< The drag was cancelled while the pointer is still down
    bool m_isPassingOn = false;
    ParameterSlider* m_slider = nullptr;
    ParameterNumber* m_number = nullptr;
    QCheckBox* m_switch = nullptr;
    QComboBox* m_choice = nullptr;
    LookChoice* m_look = nullptr; ///< The same widget as m_choice, if it is a list of looks
};

} // namespace espalier
