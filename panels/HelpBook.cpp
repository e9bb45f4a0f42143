// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HelpBook.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>

namespace espalier {

namespace {

QString read(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Whether each of the words begins a word of the text.
bool hasAll(const QString& text, const QStringList& words)
{
    return std::ranges::all_of(words, [&](const QString& word) {
        static const QString kStart = QStringLiteral("(?<![\\w])");
        return text.contains(QRegularExpression(kStart + QRegularExpression::escape(word),
                                                QRegularExpression::CaseInsensitiveOption |
                                                    QRegularExpression::UseUnicodePropertiesOption));
    });
}

} // namespace

const QString HelpBook::kIndex = QStringLiteral("index");

HelpBook::HelpBook(const QLocale& locale, const QString& root) : m_root(root)
{
    for (QString language : locale.uiLanguages()) {
        // From the specific language to the general one: "de-AT", then "de".
        language.replace(QLatin1Char('-'), QLatin1Char('_'));
        m_languages << language << language.section(QLatin1Char('_'), 0, 0);
    }
    m_languages << QStringLiteral("en");
    m_languages.removeDuplicates();
    readContents();
}

QString HelpBook::fileName(const QString& page) const
{
    for (const QString& language : m_languages) {
        const QString name = QStringLiteral("%1/%2/%3.md").arg(m_root, language, page);
        if (!page.isEmpty() && QFile::exists(name))
            return name;
    }
    return {};
}

QUrl HelpBook::url(const QString& page) const
{
    const QString name = fileName(page);
    if (name.isEmpty())
        return {};
    return name.startsWith(QLatin1Char(':')) ? QUrl(QStringLiteral("qrc") + name) : QUrl::fromLocalFile(name);
}

void HelpBook::readContents()
{
    static const QRegularExpression kLink(QStringLiteral("^[-*] \\[([^\\]]+)\\]\\((\\w+)\\.md\\)"));
    static const QRegularExpression kHeading(QStringLiteral("^(#{1,2}) (.+)$"));
    for (const QString& line : read(fileName(kIndex)).split(QLatin1Char('\n'))) {
        if (const auto heading = kHeading.match(line); heading.hasMatch()) {
            m_contents.push_back({heading.captured(2), {}});
            if (heading.capturedLength(1) == 1)
                m_contents.back().entries.push_back({kIndex, heading.captured(2)});
        } else if (const auto link = kLink.match(line); link.hasMatch() && !m_contents.empty()) {
            m_contents.back().entries.push_back({link.captured(2), link.captured(1)});
        }
    }
    std::erase_if(m_contents, [](const Section& section) { return section.entries.empty(); });
}

QString HelpBook::title(const QString& page) const
{
    for (const Section& section : m_contents) {
        for (const Entry& entry : section.entries) {
            if (entry.page == page)
                return entry.title;
        }
    }
    return {};
}

QStringList HelpBook::find(const QString& words) const
{
    const QStringList sought = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    QStringList inTitle;
    QStringList inText;
    for (const Section& section : m_contents) {
        for (const Entry& entry : section.entries) {
            if (hasAll(entry.title, sought))
                inTitle.append(entry.page);
            else if (hasAll(read(fileName(entry.page)), sought))
                inText.append(entry.page);
        }
    }
    return inTitle + inText;
}

} // namespace espalier
