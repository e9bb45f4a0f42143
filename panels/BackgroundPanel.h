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

/// Controls for the surroundings of the tree: the backdrop, the ground, the sun, a picture to draw after.
/// They are the document's, but not the tree's: a change shows at once, and is not undone.
class BackgroundPanel : public Bar {
    Q_OBJECT

public:
    explicit BackgroundPanel(ViewSettings& settings, QWidget* parent = nullptr);

    /// The row of that name ("view.sunElevation" and so on), or null.
    ViewRow* row(const char* key) const;
    /// The look that new documents have; one that is shown already need not be kept for them.
    void setLookOfNewTrees(const SceneLook& look);

Q_SIGNALS:
    /// The user wants to choose a picture to draw after.
    void pictureAsked();
    /// The user wants new documents to have the look that is shown.
    void lookForNewTreesAsked();

private:
    void addRow(QVBoxLayout& column, std::size_t field);
    QPushButton* addColour(QVBoxLayout& column, const char* name, const QString& toolTip,
                           QColor ViewValues::*colour);
    void addTracing(QVBoxLayout& column);
    void askForColour(QColor ViewValues::*colour);
    void showValues();

    ViewSettings& m_settings;
    QWidget* m_content;
    std::vector<ViewRow*> m_rows; ///< In the order of the fields in the .cpp
    QPushButton* m_colour = nullptr;
    QPushButton* m_topColour = nullptr;
    QPushButton* m_remove = nullptr;
    QLabel* m_tracingName = nullptr;
    QPushButton* m_useForNew = nullptr;
    SceneLook m_newLook;
};

} // namespace espalier
