// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/library/LibraryCards.h"

#include <array>

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;

namespace espalier {

class CardView;

/// The library as a sheet over the tree: species and the user's own trees, each section a grid of cards, with
/// a search. The panel only emits signals; LibraryController performs the work.
class LibraryPanel : public Bar {
    Q_OBJECT

public:
    enum class Section { Species, Trees };
    static constexpr std::size_t kSections = 2;

    explicit LibraryPanel(const PictureReader& readPicture, QWidget* parent = nullptr);

    void setEntries(Section section, std::vector<LibraryEntry> entries);
    void showSection(Section section);
    Section section() const { return m_section; }
    /// Shows a card and selects it.
    void choose(const QString& fileName);
    /// Begins to edit the name of the selected tree.
    void editName();
    /// The file of the selected card; empty for none.
    QString chosen() const;
    /// Sets whether the open tree can be saved now.
    void setMayKeep(bool may);
    /// Moves the keyboard focus to the cards.
    void takeFocus();

Q_SIGNALS:
    void openAsked(const QString& fileName);
    void startAsked(const QString& fileName);
    void keepAsked();
    void renameAsked(const QString& fileName, const QString& name);
    void duplicateAsked(const QString& fileName);
    void trashAsked(const QString& fileName);
    void closeAsked();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    LibraryCards& cards() { return *m_cards[static_cast<std::size_t>(m_section)]; }
    LibrarySearch& found() { return *m_found[static_cast<std::size_t>(m_section)]; }
    QLayout* makeHeader();
    QLayout* makeFooter();
    void fillMenu(QMenu& menu, const QString& fileName);
    void followChosen();
    void search(const QString& text);
    void showWhatIsThere();

    std::array<LibraryCards*, kSections> m_cards{};
    std::array<LibrarySearch*, kSections> m_found{};
    std::array<QAction*, kSections> m_tabs{};
    Section m_section = Section::Species;
    CardView* m_view;
    QLineEdit* m_search;
    QPushButton* m_keep;
    QLabel* m_empty; ///< Shows in place of the cards
    QLabel* m_name;
    QLabel* m_line;
    QPushButton* m_start;
    QPushButton* m_open;
};

} // namespace espalier
