// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

namespace espalier {

/// The controls for new buds: how many a tap adds, and how far apart.
class AddBudsPopOut : public Bar {
    Q_OBJECT

public:
    explicit AddBudsPopOut(ViewSettings& settings, QWidget* parent = nullptr);
};

} // namespace espalier
