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

/// Controls for the surroundings of the tree: the backdrop, the ground, the sun, a picture to draw after. All
/// of it belongs to the view: a change shows at once, and is not undone.
class BackgroundPanel : public Bar {
    Q_OBJECT

public:
    explicit BackgroundPanel(ViewSettings& settings, QWidget* parent = nullptr);

    /// The row of that name ("view.sunElevation" and so on), or null.
    ViewRow* row(const char* key) const;
    /// Shows the picture of that file behind the tree instead of the previous one; none if @p file is empty.
    /// Shows a notice if the file cannot be read.
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
    std::vector<ViewRow*> m_rows; ///< In the order of the fields in the .cpp
    QPushButton* m_colour = nullptr;
    QPushButton* m_topColour = nullptr;
    QPushButton* m_remove = nullptr;
    QLabel* m_tracingName = nullptr;
    QString m_traced; ///< File that the label names
};

} // namespace espalier
