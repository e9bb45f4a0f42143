// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

class QSlider;

namespace espalier {

/// The controls for bending: how much branches resist bending and stretching.
class BendPopOut : public Bar {
    Q_OBJECT

public:
    explicit BendPopOut(ViewSettings& settings, QWidget* parent = nullptr);

private:
    QSlider* addSlider(const QString& name, const QString& label, const QString& toolTip,
                       double ViewValues::*weight);
    void showValues();

    ViewSettings& m_settings;
    QSlider* m_bending;
    QSlider* m_stretching;
};

} // namespace espalier
