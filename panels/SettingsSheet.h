// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/Preferences.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLayout;
class QPushButton;
class QSlider;
class QSpinBox;

namespace espalier {

class PressureCurve;

/// The dialog of the preferences. Each change takes effect at once, so that there is no button to confirm.
class SettingsSheet : public QDialog {
    Q_OBJECT

public:
    explicit SettingsSheet(const Preferences& preferences, QWidget* parent = nullptr);

    const Preferences& preferences() const { return m_preferences; }
    /// Shows preferences that were changed elsewhere; emits no signal.
    void setPreferences(const Preferences& preferences);

    /// Sizes of the interface, in percent of the system's, the usual one first.
    static QList<int> scales() { return {100, 125, 150, 175, 200}; }
    /// Shows the size of the interface that the user has chosen, one of scales(); emits no signal.
    void setInterfaceScale(int percent);

Q_SIGNALS:
    void preferencesEdited(const espalier::Preferences& preferences);
    /// The interface shall have another size from the next start on.
    void interfaceScaleEdited(int percent);

private:
    QLayout* makeAppearance();
    QLayout* makeHand();
    QLayout* makeWork();
    QLabel* makeLabel(const QString& text, QWidget* buddy);
    QLabel* makeNote(const QString& text = {});
    QLayout* makeStabiliser();
    void display(const Preferences& preferences);
    /// Reads the preferences from the controls.
    void edit();
    /// Shows @p preferences, and emits a signal if they differ from those before.
    void take(const Preferences& preferences);
    void chooseFolder();

    Preferences m_preferences;
    bool m_isShowing = false;
    QComboBox* m_look;
    QComboBox* m_side;
    QComboBox* m_language;
    QComboBox* m_units;
    QComboBox* m_scale;
    PressureCurve* m_curve;
    QSlider* m_softness;
    QSlider* m_distance; ///< Of the stabiliser, px
    QSlider* m_delay;    ///< Of the stabiliser, hundredths of a second
    QLabel* m_distanceText;
    QLabel* m_delayText;
    QComboBox* m_mouse;
    QLabel* m_mouseNote;
    QSpinBox* m_undo;
    QSpinBox* m_undoMemory;
    QLabel* m_folder;
    QPushButton* m_defaults;
};

} // namespace espalier
