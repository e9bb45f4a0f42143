// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/ZipArchive.h"

#include <QJsonObject>

#include <vector>

namespace espalier {

/// What other programs have put into a project file: members of project.json and entries of the archive that
/// this program does not know. Saving keeps them.
struct ForeignParts {
    struct Entry {
        QByteArray name;
        QByteArray content;
        bool operator==(const Entry&) const = default;
    };
    QJsonObject members{};
    std::vector<Entry> entries{};
    bool operator==(const ForeignParts&) const = default;
};

/// The entries of @p archive whose folder, or whose name if they are in none, is not one of the project
/// format's. Sets @p isWhole to false if some are too large, too many, damaged or not named safely; these are
/// left out.
std::vector<ForeignParts::Entry> readForeignEntries(const ZipReader& archive, bool& isWhole);
/// Whether members of project.json can be kept: not many, and not deeply nested.
bool canKeepMembers(const QJsonObject& members);
void addForeignEntries(ZipWriter& archive, const std::vector<ForeignParts::Entry>& entries);

} // namespace espalier
