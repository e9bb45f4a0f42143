// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

namespace espalier {

/// The controls that are needed while brushing: the radius, whether a pen's pressure scales it, and whether
/// the markers show. The other ones are on the brush's sheet.
class BrushPopOut : public Bar {
    Q_OBJECT

public:
    BrushPopOut(const TreeDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
};

} // namespace espalier
