// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QUrl>

#include <vector>

namespace espalier {

/// The pages of the help: Markdown files in a folder for each language, "en" and so on. A page is known by
/// its file's name without the suffix. Where a language lacks a page, the English one is read.
class HelpBook {
public:
    struct Entry {
        QString page;
        QString title;
    };
    struct Section {
        QString title;
        std::vector<Entry> entries;
    };

    /// The page with the table of contents, which says what there is and in which order.
    static const QString kIndex;

    /// @p root is a folder of languages.
    explicit HelpBook(const QLocale& locale = QLocale(), const QString& root = QStringLiteral(":/docs/help"));

    /// The links of the index page, under its headings.
    const std::vector<Section>& contents() const { return m_contents; }
    /// Where the page lies; empty if there is none of that name.
    QUrl url(const QString& page) const;
    /// Its name in the table of contents; empty if it is not there.
    QString title(const QString& page) const;
    /// Pages that have all of the words, in whole or as beginnings; those that have them in their title
    /// first.
    QStringList find(const QString& words) const;

private:
    QString fileName(const QString& page) const;
    void readContents();

    QString m_root;
    QStringList m_languages; ///< The person's, the best first, and English at the end
    std::vector<Section> m_contents;
};

} // namespace espalier
