// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/HelpBook.h"

class QLineEdit;
class QListWidget;
class QPushButton;

namespace espalier {

class HelpPage;

/// The help beside the tree: contents and search on the left, if there is room for them beside the page,
/// otherwise in its place. A page can name a recipe to play; the panel only emits a signal for that.
class HelpPanel : public Bar {
    Q_OBJECT

public:
    explicit HelpPanel(QWidget* parent = nullptr);

    const HelpBook& book() const { return m_book; }
    /// Shows a page; the first page if there is none of that name.
    void showPage(const QString& page);
    QString page() const;
    /// File of the recipe that shows the page's tool at work; empty if it has none.
    QString recipe() const;

    /// Width of the panel in a window of that width, px.
    static int widthIn(int windowWidth);

Q_SIGNALS:
    /// The user wants to play the page's recipe.
    void recipeAsked(const QString& fileName);
    /// The user wants to see the tour.
    void tourAsked();
    void closeAsked();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fillContents();
    void showContents(bool shown);
    void followLink(const QUrl& link);
    void followPage();
    void arrange();

    HelpBook m_book;
    HelpPage* m_page;
    QWidget* m_index;
    QLineEdit* m_search;
    QListWidget* m_list;
    QPushButton* m_play;
    BarButton* m_back;
    BarButton* m_contents;
    /// The contents show in place of the page, where there is no room beside it.
    bool m_isContentsAsked = false;
};

} // namespace espalier
