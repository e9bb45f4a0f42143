// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ForeignParts.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

#include <algorithm>
#include <array>

namespace espalier {

namespace {

constexpr std::size_t kMostForeignEntries = 1000;
constexpr qsizetype kMostForeignBytes = 64 << 20; ///< Of all together
constexpr qsizetype kLongestName = 255;           // bytes
constexpr qsizetype kMostMemberBytes = 1 << 18;   ///< Compact
constexpr int kDeepestMember = 16;                ///< Indented text grows with the depth

/// The folders, and the entries in no folder, of all versions of the format.
constexpr std::array<QByteArrayView, 11> kOwnParts{"project.json", "look.json", "thumbnail.png", "internodes",
                                                   "leaves",       "sparse",    "kept",          "journal",
                                                   "assets",       "tree",      "lasso"};

bool isOwnPart(const QByteArray& name)
{
    const QByteArray part = name.split('/').constFirst().toLower();
    return std::ranges::find(kOwnParts, QByteArrayView(part)) != kOwnParts.end();
}

bool isSafeName(const QByteArray& name)
{
    const QList<QByteArray> parts = name.split('/');
    return !name.isEmpty() && name.size() <= kLongestName && name.isValidUtf8() && !name.contains('\\') &&
           !name.contains(':') &&
           std::ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; }) &&
           std::ranges::none_of(
               parts, [](const QByteArray& part) { return part.isEmpty() || part == "." || part == ".."; });
}

bool isShallow(const QJsonValue& value, int depth)
{
    const auto isShallowBelow = [depth](const auto& below) {
        return depth > 0 && std::all_of(below.begin(), below.end(), [depth](const QJsonValue& nested) {
                   return isShallow(nested, depth - 1);
               });
    };
    return value.isArray() ? isShallowBelow(value.toArray())
                           : !value.isObject() || isShallowBelow(value.toObject());
}

} // namespace

bool canKeepMembers(const QJsonObject& members)
{
    return isShallow(members, kDeepestMember) &&
           QJsonDocument(members).toJson(QJsonDocument::Compact).size() <= kMostMemberBytes;
}

std::vector<ForeignParts::Entry> readForeignEntries(const ZipReader& archive, bool& isWhole)
{
    isWhole = true;
    std::vector<ForeignParts::Entry> entries;
    QSet<QByteArray> names;
    qsizetype left = kMostForeignBytes;
    for (const QByteArray& name : archive.names()) {
        // Folders have entries of their own in the archives of some programs.
        if (isOwnPart(name) || name.endsWith('/'))
            continue;
        const bool isAllowed =
            isSafeName(name) && !names.contains(name) && entries.size() < kMostForeignEntries;
        Result<QByteArray> content =
            isAllowed ? archive.read(name.constData(), static_cast<std::uint64_t>(left)) : Error{};
        isWhole = isWhole && content;
        if (!content)
            continue;
        left -= content->size();
        names.insert(name);
        entries.push_back({name, std::move(*content)});
    }
    return entries;
}

void addForeignEntries(ZipWriter& archive, const std::vector<ForeignParts::Entry>& entries)
{
    for (const ForeignParts::Entry& entry : entries)
        archive.add(entry.name, entry.content, ZipWriter::Packing::Store); // zeros would look like a bomb
}

} // namespace espalier
