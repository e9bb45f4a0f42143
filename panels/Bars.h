// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Actions.h"
#include "panels/Bar.h"

#include <array>
#include <functional>

class QLabel;
class QMenu;

namespace espalier {

/// The column of tools on the left.
class SideBar : public Bar {
    Q_OBJECT

public:
    explicit SideBar(const Actions& actions, QWidget* parent = nullptr);
};

/// The bar at the top: files on the left, sheets in the middle, what is shown on the right.
class TopBar : public Bar {
    Q_OBJECT

public:
    /// @p fillRecentFiles fills the menu of recent files each time before it shows.
    TopBar(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles, QWidget* parent = nullptr);

    /// Name of what is open, and whether it has changes that no file has.
    void setTitle(const QString& name, bool modified);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QMenu* makeMenu(const Actions& actions, std::function<void(QMenu&)> fillRecentFiles);
    void arrange();
    void showTitle();
    QString mark() const;
    int titleWidth() const; ///< px that it would like to have

    QLabel* m_title;
    /// Buttons that give way where the window is narrow; as kYielding in the .cpp.
    std::array<QWidget*, 4> m_yielding{};
    QString m_name;
    bool m_modified = false;
};

} // namespace espalier
