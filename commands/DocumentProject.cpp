// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DocumentProject.h"

namespace espalier {

Project projectOf(const TreeDocument& document, const QString& name)
{
    Project project{document.tree(), document.journal(), name, {}, 0, document.look()};
    const Journal& future = document.future();
    for (auto delta = future.rbegin(); delta != future.rend(); ++delta) {
        project.tree.apply(**delta);
        project.journal.push_back(*delta);
    }
    project.ahead = static_cast<std::uint32_t>(future.size());
    return project;
}

PreparedTree prepared(Project project)
{
    PreparedTree tree(std::move(project.tree), std::move(project.journal), project.ahead);
    tree.look = std::move(project.look);
    return tree;
}

void showProject(TreeDocument& document, Project project)
{
    document.reset(prepared(std::move(project)));
}

} // namespace espalier
