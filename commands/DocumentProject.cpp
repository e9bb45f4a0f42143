// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DocumentProject.h"

#include "commands/EditTitle.h"

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

namespace {

/// The undo steps that the history of @p project tells of.
std::vector<RestoredStep> stepsOf(const Project& project)
{
    std::vector<RestoredStep> steps;
    const Journal& history = project.journal;
    for (std::size_t i = 0; i < history.size(); i = steps.back().deltas.end) {
        const JournalEdit edit = JournalEdit::at(history, i);
        steps.push_back({titleOfStep(project.tree, history, edit), edit});
    }
    if (project.ahead > 0)
        steps.push_back({titleOfGrowth(0), {history.size(), history.size()}});
    return steps;
}

} // namespace

PreparedTree prepared(Project project)
{
    std::vector<RestoredStep> steps = stepsOf(project);
    PreparedTree tree(std::move(project.tree), std::move(project.journal), project.ahead);
    tree.look = std::move(project.look);
    tree.steps = std::move(steps);
    return tree;
}

void showProject(TreeDocument& document, Project project)
{
    document.reset(prepared(std::move(project)));
}

} // namespace espalier
