// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace espalier {

class ViewRow;

/// What is around the tree: what stands behind it, the ground, the sun, a picture to draw after. All of it
/// belongs to the view: it shows at once, and nothing of it is undone.
class BackgroundPanel : public Bar {
    Q_OBJECT

public:
    explicit BackgroundPanel(ViewSettings& settings, QWidget* parent = nullptr);

    /// The row of that name ("view.sunElevation" and so on), or null.
    ViewRow* row(const char* key) const;
    /// Shows the picture of that file behind the tree, in the place of the one before; none if empty. Says so
    /// if it cannot be read.
    void trace(const QString& file);

private:
    void addRow(QVBoxLayout& column, std::size_t field);
    QPushButton* addColour(QVBoxLayout& column, const char* name, const QString& toolTip,
                           QColor ViewValues::*colour);
    void addTracing(QVBoxLayout& column);
    void askForColour(QColor ViewValues::*colour);
    void askForTracing();
    void showValues();

    ViewSettings& m_settings;
    QWidget* m_content;
    std::vector<ViewRow*> m_rows; ///< As the fields, in the .cpp
    QPushButton* m_colour = nullptr;
    QPushButton* m_topColour = nullptr;
    QPushButton* m_remove = nullptr;
    QLabel* m_tracingName = nullptr;
    QString m_traced; ///< File that the label names
};

} // namespace espalier
