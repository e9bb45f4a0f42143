// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Actions.h"
#include "panels/Bar.h"

#include <array>
#include <functional>
#include <vector>

class QGridLayout;
class QLabel;
class QMenu;

namespace espalier {

/// The tools on the left, in one column or in several.
class SideBar : public Bar {
    Q_OBJECT

public:
    explicit SideBar(const Actions& actions, QWidget* parent = nullptr);

    /// Puts the tools into as many columns as they need within @p height, px.
    void fit(int height);

private:
    void arrange(int columns);

    QGridLayout* m_grid;
    std::vector<BarButton*> m_tools;
    std::vector<BarButton*> m_steps; ///< Undo and redo, in a row of their own below the tools
    QWidget* m_line;
    int m_columns = 0;
};

/// The bar at the top: files on the left, sheets in the middle, what is shown on the right.
class TopBar : public Bar {
    Q_OBJECT

public:
    /// @p fillRecentFiles fills the menu of recent files each time before it shows.
    TopBar(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles, QWidget* parent = nullptr);

    /// Shows the name of the document, and whether it has changes that are in no file.
    void setTitle(const QString& name, bool modified);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QMenu* makeMenu(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles);
    void arrange();
    void showTitle();
    QString mark() const;
    int titleWidth() const; ///< Width of the whole title, px

    QLabel* m_title;
    /// Buttons that are hidden where the window is narrow, in the order of kYielding in the .cpp.
    std::array<QWidget*, 5> m_yielding{};
    QString m_name;
    bool m_modified = false;
};

} // namespace espalier
