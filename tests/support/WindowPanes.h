// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/MainWindow.h"

#include <functional>
#include <vector>

namespace espalier::test {

/// All panes of the window, and how each is opened.
class WindowPanes {
public:
    struct Pane {
        const char* name;
        std::function<QWidget*()> open; ///< Does nothing if the pane is open
    };

    explicit WindowPanes(MainWindow& window) : m_window(window) {}

    std::vector<Pane> all();
    /// Opens the pane or pop-out of the action, unless it is open.
    void have(ActionId id);
    /// Selects the Brush tool and closes all panes.
    void shutAll();

private:
    QWidget* openSettings();

    MainWindow& m_window;
    bool m_areSpeciesThere = false;
};

} // namespace espalier::test
