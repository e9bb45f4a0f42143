// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/library/LibraryEntry.h"

#include <QAbstractListModel>
#include <QHash>
#include <QSortFilterProxyModel>
#include <QThreadPool>

#include <vector>

namespace espalier {

/// Entries of the library as cards with pictures. A worker thread reads a picture when it is requested for
/// the first time; dataChanged() follows when it is there.
class LibraryCards : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        LineRole = Qt::UserRole, ///< A description or a date
        FileRole,                ///< LibraryEntry::fileName
        SearchRole,              ///< All text that a search reads
    };

    /// @p mayRename: whether names can be edited. An edit emits renameAsked() and changes nothing here.
    LibraryCards(bool mayRename, PictureReader readPicture, QObject* parent = nullptr);
    /// Waits for the picture that is being read.
    ~LibraryCards() override;

    void setEntries(std::vector<LibraryEntry> entries);
    /// Row of a card; -1 if there is none.
    int rowOf(const QString& fileName) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    /// DecorationRole is a QImage, null as long as there is none.
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    void renameAsked(const QString& fileName, const QString& name);

private:
    struct Picture {
        QImage image;
        QString problem; ///< Why there is no picture; empty if nothing is wrong
    };

    const Picture& picture(const LibraryEntry& entry) const;
    void takePicture(const QString& key, const QString& fileName, const Result<QImage>& read);

    std::vector<LibraryEntry> m_entries;
    bool m_mayRename;
    PictureReader m_readPicture;
    /// Pictures by file and time of change; empty while they are being read.
    mutable QHash<QString, Picture> m_pictures;
    mutable QThreadPool m_readers;
};

/// The cards that contain all words of a search, in upper or lower case.
class LibrarySearch : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setWords(const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QStringList m_words;
};

} // namespace espalier
