// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

#include <array>
#include <vector>

class QPushButton;

namespace espalier {

/// The controls of pruning: how wood is taken away, and what that way needs.
class PrunePopOut : public Bar {
    Q_OBJECT

public:
    explicit PrunePopOut(ViewSettings& settings, QWidget* parent = nullptr);

Q_SIGNALS:
    /// Other controls show: the pop-out has another size.
    void sizeWanted();

private:
    struct Control {
        QWidget* row;
        std::vector<PruneMode> modes; ///< In which it shows
    };

    void showMode();

    ViewSettings& m_settings;
    std::array<QPushButton*, kPruneModeCount> m_modes{};
    std::vector<Control> m_controls;
};

} // namespace espalier
