// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/PictureSettings.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLayout;
class QSpinBox;

namespace espalier {

/// The dialog that asks what a picture of the tree is to be like, and whether it goes to a file or to the
/// clipboard.
class PictureSheet : public QDialog {
    Q_OBJECT

public:
    /// @p window: size of what the window shows of the tree, px.
    PictureSheet(const PictureSettings& settings, const QSize& window, QWidget* parent = nullptr);

    /// As the controls show it.
    PictureSettings settings() const;

Q_SIGNALS:
    /// The dialog has closed: the picture is to be saved.
    void saveAsked(const espalier::PictureSettings& settings);
    /// The dialog has closed: the picture is to be copied.
    void copyAsked(const espalier::PictureSettings& settings);

private:
    QLayout* makeSize();
    QLayout* makeButtons();
    void showSettings(const PictureSettings& settings);
    void showPreset();
    void findPreset();

    QSize m_window;
    bool m_isShowing = false;
    QComboBox* m_preset;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_view;
    QCheckBox* m_transparent;
    QCheckBox* m_shadow;
};

} // namespace espalier
