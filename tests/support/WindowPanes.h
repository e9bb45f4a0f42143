// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/MainWindow.h"

#include <functional>
#include <vector>

namespace espalier::test {

/// All that can be open in the window, and how it is opened.
class WindowPanes {
public:
    struct Pane {
        const char* name;
        std::function<QWidget*()> open; ///< Nothing happens to one that is open
    };

    explicit WindowPanes(MainWindow& window) : m_window(window) {}

    std::vector<Pane> all();
    /// Opens the sheet, or the pop-out of the tool, or whatever the action shows, unless it is open.
    void have(ActionId id);
    /// The brush is in hand, and nothing else is open.
    void shutAll();

private:
    QWidget* openSettings();

    MainWindow& m_window;
    bool m_areSpeciesThere = false;
};

} // namespace espalier::test
