// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandMesher.h"

#include "model/mesh/StrandBark.h"
#include "model/mesh/StrandSurface.h"

#include <optional>

namespace espalier {

namespace {

/// Makes @p mesh and all of @p wood but its mesh and layouts; returns false if @p progress was cancelled.
bool makeMesh(const StrandLayouts& layouts, const TreeParameters& parameters, const WoodMeshOptions& options,
              const StrandWood* last, WorkProgress& progress, BranchMesh& mesh, StrandWood& wood)
{
    // A stage tells its progress up to this share of the whole, by the time that stages take.
    std::optional<WorkProgress::Part> stage;
    const auto nextUntil = [&](float share) {
        stage.reset();
        stage.emplace(progress, share);
        return !progress.isCancelled();
    };
    StrandReuse reuse(layouts, parameters.wood, options, last != nullptr ? &last->keys : nullptr,
                      last != nullptr ? &last->layouts->skeleton() : nullptr);
    if (!nextUntil(0.2F))
        return false;
    wood.tubes = strandTubes(layouts, parameters.wood, options, reuse,
                             last != nullptr ? &last->tubes : nullptr, progress);
    if (!nextUntil(0.5F))
        return false;
    StrandSections::Last lastSections;
    if (last != nullptr)
        lastSections = {&last->blocks, last->mesh.get(), last->raised};
    StrandSections sections(layouts, wood.tubes, parameters, reuse, lastSections, progress, mesh);
    if (!nextUntil(0.7F))
        return false;
    wood.triangles = triangulateStrands(layouts, wood.tubes, sections, reuse, lastSections,
                                        last != nullptr ? &last->triangles : nullptr, progress, mesh);
    if (!nextUntil(0.8F))
        return false;
    wood.raised = raiseFlatTriangles(mesh.indices, mesh.vertices);
    wood.isNearRaised = nodesNear(wood.raised, layouts, sections);
    // Normals of the last mesh are of no use where vertices were raised then, or are now.
    std::vector<std::uint8_t> isChanged = wood.isNearRaised;
    for (std::uint32_t node = 0; node < isChanged.size(); ++node) {
        if (reuse.has(node, StrandReach::Normals) && last->isNearRaised[reuse.before(node)] != 0)
            isChanged[node] = 1;
    }
    orientStrands(layouts, sections, wood.triangles, reuse, isChanged, progress, mesh);
    if (!nextUntil(0.9F))
        return false;
    removeVoids(layouts, wood.tubes, sections, wood.triangles, mesh);
    barkStrands(layouts, wood.tubes, sections, parameters, mesh);
    if (!nextUntil(1.0F))
        return false;
    wood.triangles.doubled = splitSeams(wood.triangles, mesh);
    wood.blocks = sections.takeBlocks();
    for (std::uint32_t node = 0; node < wood.blocks.size(); ++node)
        wood.taken += reuse.has(node, StrandReach::Triangles) ? 1 : 0;
    wood.keys = reuse.takeKeys();
    return !progress.isCancelled();
}

} // namespace

std::shared_ptr<const StrandWood> meshStrands(std::shared_ptr<const StrandLayouts> layouts,
                                              const TreeParameters& parameters,
                                              const WoodMeshOptions& options, const StrandWood* last,
                                              WorkProgress& progress)
{
    auto mesh = std::make_shared<BranchMesh>();
    auto wood = std::make_shared<StrandWood>();
    if (!makeMesh(*layouts, parameters, options, last, progress, *mesh, *wood))
        return nullptr;
    wood->mesh = std::move(mesh);
    wood->layouts = std::move(layouts);
    return wood;
}

BranchMesh meshStrands(const StrandLayouts& layouts, const TreeParameters& parameters,
                       const WoodMeshOptions& options)
{
    BranchMesh mesh;
    StrandWood wood;
    WorkProgress progress;
    makeMesh(layouts, parameters, options, nullptr, progress, mesh, wood);
    return mesh;
}

} // namespace espalier
