// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/JsonReader.h"
#include "model/tree/Tree.h"

namespace espalier {

/// The content of project.json, for every version of the format.
struct ProjectDescription {
    int version = 0;
    QString name;
    std::uint64_t seed = 1;
    Step step = 0;
    std::uint32_t internodes = 1;
    std::uint32_t leaves = 0; ///< Placed ones; none in version 1
    std::uint32_t deltas = 0;
    std::uint32_t ahead = 0;
    std::uint32_t currentParameters = 0;
    std::vector<std::uint32_t> lassosInForce; ///< Empty in version 1
    QJsonObject imageNames;                   ///< By hash
    QJsonObject foreign;                      ///< Members of other programs; empty in version 1
};

/// project.json of a tree with a journal of @p deltas deltas, the last @p ahead of which lie ahead. @p
/// foreign: more members.
QByteArray describe(const QString& name, const Tree& tree, std::size_t deltas, std::uint32_t ahead,
                    const QJsonObject& foreign);

/// Reads the version of the format. Fails if the file is not a project, and for a version that a later
/// program wrote.
Result<int> readVersion(JsonReader& reader);
/// Reads the members that all versions have. The reader keeps faults.
void readCommon(JsonReader& reader, ProjectDescription& description);
/// Reads project.json of the current version.
Result<ProjectDescription> readDescription(JsonReader& reader);

/// A count within limits.
std::uint32_t readCount(JsonReader& reader, const char* key, std::uint32_t minimum, std::uint32_t maximum);

} // namespace espalier
