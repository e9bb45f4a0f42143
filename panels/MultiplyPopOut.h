// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

namespace espalier {

/// The controls of more by example: what a tap on a branch does.
class MultiplyPopOut : public Bar {
    Q_OBJECT

public:
    explicit MultiplyPopOut(ViewSettings& settings, QWidget* parent = nullptr);
};

} // namespace espalier
