// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/project/Project.h"

#include <QByteArray>
#include <QSet>

#include <memory>
#include <vector>

namespace espalier {

/// How the history of a document, the future included, differs from what it was at an earlier time. A project
/// and a sequence of such changes are the same as a later project, and a change is as large as what was done
/// meanwhile.
///
/// Deltas have numbers: those of the project in the order of its journal, then the fresh ones of each change.
struct HistoryChange {
    std::uint32_t kept = 0; ///< Number of deltas that stay, from the first of the history on
    /// Numbers of the deltas that come after these, and that were part of the history before.
    std::vector<std::uint32_t> known;
    Journal fresh; ///< The deltas that come last, and are new
    /// By fresh delta: the rows and values that it brings; null if it brings none. Cells of rows may have the
    /// values that later deltas of the same change, or deltas of the tree, have given them.
    std::vector<std::shared_ptr<const TreeRows>> rows;
    std::uint32_t ahead = 0; ///< Number of the history's last deltas that lie ahead of the moment shown
    SceneLook look{};
};

/// The bytes of a change. @p written: hashes of the images that the project and earlier changes hold; those
/// of this change are added. Fails if the change is too large.
Result<QByteArray> packChange(const HistoryChange& change, QSet<QString>& written);

/// Hashes of all images that a project holds.
QSet<QString> imageHashes(const Project& project);

/// A project to which changes are made as they were in the document.
class HistoryReplay {
public:
    explicit HistoryReplay(Project project);

    /// Makes a change that packChange() has packed. After an error the project is not whole.
    Result<void> add(const QByteArray& packed);
    const Project& project() const { return m_project; }
    /// Checks the whole as a project file is checked, and returns it.
    Result<Project> finish();

private:
    Result<void> append(const std::shared_ptr<TreeDelta>& delta);

    Project m_project;
    Journal m_numbered;
    std::vector<ImageAsset> m_images;
};

} // namespace espalier
