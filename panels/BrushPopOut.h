// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/document/ViewSettings.h"
#include "panels/Bar.h"

class QLabel;

namespace espalier {

class RadiusSlider;
class Toggle;

/// What belongs to the brush in hand: its radius, whether a pen's pressure scales it, and whether its markers
/// show.
class BrushPopOut : public Bar {
    Q_OBJECT

public:
    BrushPopOut(const TreeDocument& document, ViewSettings& settings, QWidget* parent = nullptr);

private:
    void showValues();

    const TreeDocument& m_document;
    ViewSettings& m_settings;
    QLabel* m_number;
    QLabel* m_meaning;
    RadiusSlider* m_slider;
    Toggle* m_pressure;
    Toggle* m_markers;
};

} // namespace espalier
