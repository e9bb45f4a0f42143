// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowGesture.h"

#include "commands/recipe/GrowOperation.h"

namespace espalier {

namespace {

class AutonomousGrowth : public GrowthProcess {
public:
    explicit AutonomousGrowth(Competitors competitors) : m_competitors(competitors) {}

    TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model) override
    {
        GrowthStepOptions options = GrowthStepOptions::of(tree.parameters().growth);
        options.competitors = m_competitors;
        return model.growFreely(tree, index, options, m_workspace);
    }

private:
    Competitors m_competitors;
    GrowthWorkspace m_workspace;
};

} // namespace

GrowGesture::GrowGesture(TreeDocument& document, Competitors competitors)
    : GrowthGesture(document, {}), m_only(BudReference::to(document, competitors))
{
    setProcess(std::make_unique<AutonomousGrowth>(competitors));
}

RecipeOperation GrowGesture::operation() const
{
    return GrowOperation{static_cast<int>(stepCount()), m_only};
}

} // namespace espalier
