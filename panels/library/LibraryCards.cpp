// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/library/LibraryCards.h"

#include "model/base/HandOver.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPointer>

#include <algorithm>
#include <memory>

namespace espalier {

namespace {

QString keyOf(const LibraryEntry& entry)
{
    return QStringLiteral("%1 %2").arg(entry.changed.toMSecsSinceEpoch()).arg(entry.fileName);
}

QString lineOf(const LibraryEntry& entry)
{
    return entry.line.isEmpty() ? QLocale().toString(entry.changed, QLocale::ShortFormat) : entry.line;
}

} // namespace

LibraryCards::LibraryCards(bool mayRename, PictureReader readPicture, QObject* parent)
    : QAbstractListModel(parent), m_mayRename(mayRename), m_readPicture(std::move(readPicture))
{
    m_readers.setMaxThreadCount(1);
}

LibraryCards::~LibraryCards()
{
    m_readers.clear();
    m_readers.waitForDone();
}

void LibraryCards::setEntries(std::vector<LibraryEntry> entries)
{
    if (entries == m_entries)
        return;
    beginResetModel();
    m_entries = std::move(entries);
    // Pictures that are being read will arrive; pictures of files that are gone are dropped.
    QHash<QString, Picture> kept;
    for (const LibraryEntry& entry : m_entries) {
        if (const auto known = m_pictures.constFind(keyOf(entry)); known != m_pictures.cend())
            kept.insert(known.key(), known.value());
    }
    m_pictures = std::move(kept);
    endResetModel();
}

int LibraryCards::rowOf(const QString& fileName) const
{
    const auto found = std::ranges::find(m_entries, fileName, &LibraryEntry::fileName);
    return found == m_entries.end() ? -1 : static_cast<int>(found - m_entries.begin());
}

int LibraryCards::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

QVariant LibraryCards::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const LibraryEntry& entry = m_entries[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return entry.name;
    case Qt::DecorationRole:
        return picture(entry).image;
    case Qt::ToolTipRole: {
        const QString problem = m_pictures.value(keyOf(entry)).problem;
        return problem.isEmpty() ? lineOf(entry) : problem;
    }
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1. %2").arg(entry.name, lineOf(entry));
    case LineRole:
        return lineOf(entry);
    case FileRole:
        return entry.fileName;
    case SearchRole:
        return QStringLiteral("%1\n%2").arg(entry.name, lineOf(entry));
    default:
        return {};
    }
}

bool LibraryCards::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const LibraryEntry& entry = m_entries[static_cast<std::size_t>(index.row())];
    if (value.toString() != entry.name)
        Q_EMIT renameAsked(entry.fileName, value.toString());
    return false;
}

Qt::ItemFlags LibraryCards::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return m_mayRename && index.isValid() ? usual | Qt::ItemIsEditable : usual;
}

const LibraryCards::Picture& LibraryCards::picture(const LibraryEntry& entry) const
{
    const QString key = keyOf(entry);
    if (const auto known = m_pictures.constFind(key); known != m_pictures.cend())
        return *known;
    // The first call starts the reading. data() is const, but the result is a change of this object.
    auto* self = const_cast<LibraryCards*>(this);
    m_readers.start([guard = QPointer<LibraryCards>(self), key, fileName = entry.fileName,
                     readPicture = m_readPicture, handOver = HandOver()] {
        handOver.take();
        auto read = std::make_shared<Result<QImage>>(readPicture(fileName));
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [guard, key, fileName, read = std::move(read), back = HandOver()]() mutable {
                back.take();
                if (guard)
                    guard->takePicture(key, fileName, *read);
                read.reset(); // Not by the other thread, which may be the last to leave this lambda
                back.give();
            },
            Qt::QueuedConnection);
    });
    return *m_pictures.insert(key, {});
}

void LibraryCards::takePicture(const QString& key, const QString& fileName, const Result<QImage>& read)
{
    const int row = rowOf(fileName);
    if (row < 0 || keyOf(m_entries[static_cast<std::size_t>(row)]) != key)
        return;
    m_pictures[key] = read ? Picture{*read, {}} : Picture{{}, read.error().message};
    const QModelIndex changed = index(row);
    Q_EMIT dataChanged(changed, changed, {Qt::DecorationRole, Qt::ToolTipRole});
}

void LibrarySearch::setWords(const QString& text)
{
    m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

bool LibrarySearch::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    const QString text = sourceModel()->index(row, 0, parent).data(LibraryCards::SearchRole).toString();
    return std::ranges::all_of(
        m_words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace espalier
