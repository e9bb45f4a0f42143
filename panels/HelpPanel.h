// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/HelpBook.h"

class QLineEdit;
class QListWidget;
class QPushButton;

namespace espalier {

class HelpPage;

/// The help beside the tree: contents and search on the left, where there is room for them beside the page,
/// otherwise in its place. A page that names a recipe can be seen at work; the panel only asks for that.
class HelpPanel : public Bar {
    Q_OBJECT

public:
    explicit HelpPanel(QWidget* parent = nullptr);

    const HelpBook& book() const { return m_book; }
    /// A name that no page has shows the first page.
    void showPage(const QString& page);
    QString page() const;
    /// File of the recipe that the page shows its tool by; empty if it has none.
    QString recipe() const;

    /// How much of a window of that width it takes, px.
    static int widthIn(int windowWidth);

Q_SIGNALS:
    /// A recipe of the page shall be played.
    void recipeAsked(const QString& fileName);
    /// Somebody wants to be shown around.
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
    bool m_isContentsAsked = false; ///< In place of the page, where there is no room beside it
};

} // namespace espalier
