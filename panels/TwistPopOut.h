// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

namespace espalier {

/// The control for twisting: whether a twist reaches all branches above.
class TwistPopOut : public Bar {
    Q_OBJECT

public:
    explicit TwistPopOut(ViewSettings& settings, QWidget* parent = nullptr);
};

} // namespace espalier
