// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QUrl>

#include <vector>

namespace espalier {

/// The pages of the help: Markdown files in a folder for each language, "en" and so on. A page's id is its
/// file name without the suffix. Where a language lacks a page, the English one is used.
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

    /// The page with the table of contents, which lists the pages in order.
    static const QString kIndex;

    /// @p root is the folder with a folder for each language.
    explicit HelpBook(const QLocale& locale = QLocale(), const QString& root = QStringLiteral(":/docs/help"));

    /// The links of the index page, under its headings.
    const std::vector<Section>& contents() const { return m_contents; }
    /// URL of the page's file; empty if there is no page of that name.
    QUrl url(const QString& page) const;
    /// Title of the page in the table of contents; empty if the page is not there.
    QString title(const QString& page) const;
    /// Pages that contain all of the words, in whole or as beginnings; pages that have them in the title come
    /// first.
    QStringList find(const QString& words) const;

private:
    QString fileName(const QString& page) const;
    void readContents();

    QString m_root;
    QStringList m_languages; ///< The user's languages, the preferred one first, and English at the end
    std::vector<Section> m_contents;
};

} // namespace espalier
