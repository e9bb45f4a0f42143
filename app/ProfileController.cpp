// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ProfileController.h"

#include "app/runners/Background.h"
#include "commands/ProfileEdits.h"
#include "model/base/Parallel.h"
#include "model/strands/ProfileSlots.h"
#include "model/strands/SlotAssignment.h"

#include <algorithm>
#include <limits>

namespace espalier {

namespace {

/// ms; layouts of a tree that grows or is dragged are not made more often.
constexpr int kLayoutInterval = 60;
/// Branches above the section that have a colour of their own.
constexpr int kMostBranches = 40;
/// A sketch shapes the wood so far up and down, in its radii: within one node of thick wood it would hardly
/// be seen.
constexpr float kStretchRadii = 2.0F;

/// By strand of @p node: which of the branches that leave its axis further up it runs to; 0 for the axis.
std::vector<std::uint8_t> branchesOf(const StrandSkeleton& skeleton, std::uint32_t node)
{
    std::vector<std::uint8_t> branches(skeleton.nodes[node].strands, 0);
    std::uint32_t offset = 0;
    int branch = 0;
    while (skeleton.nodes[node].childCount > 0 && branch < kMostBranches) {
        const auto children = skeleton.childrenOf(node);
        const std::uint32_t main = *std::ranges::max_element(
            children, {}, [&](std::uint32_t child) { return skeleton.nodes[child].strands; });
        for (const std::uint32_t child : children) {
            if (child == main)
                continue;
            const StrandNode& other = skeleton.nodes[child];
            ++branch;
            std::fill_n(branches.begin() + offset + other.offset, other.strands,
                        static_cast<std::uint8_t>(branch));
        }
        offset += skeleton.nodes[main].offset;
        node = main;
    }
    return branches;
}

} // namespace

ProfileController::ProfileController(TreeDocument& document, ProfilePanel& panel,
                                     std::function<bool()> isBusy, std::function<void()> repaint)
    : m_document(document), m_panel(panel), m_isBusy(std::move(isBusy)), m_repaint(std::move(repaint))
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(kLayoutInterval);
    connect(&m_timer, &QTimer::timeout, this, &ProfileController::work);
    connect(&document, &TreeDocument::changed, this, &ProfileController::follow);
    connect(&panel, &ProfilePanel::edited, this, &ProfileController::edit);
    connect(&panel, &ProfilePanel::clearAsked, this, [this] { edit({}); });
    connect(&panel, &ProfilePanel::stepAsked, this, &ProfileController::step);
    connect(&panel, &ProfilePanel::spanAsked, this, &ProfileController::ask);
}

void ProfileController::setShown(bool shown)
{
    m_isShown = shown;
    if (shown && !isUpToDate())
        work();
}

void ProfileController::follow(const TreeChange& change)
{
    ++m_stamp;
    if (change.internodes) {
        for (std::optional<InternodeId>* chosen : {&m_chosen, &m_spanStart}) {
            if (*chosen)
                *chosen = (*change.internodes)[**chosen];
        }
    }
    if (!change.delta)
        m_layouts.reset();
    if (m_chosen && ((!change.delta && !change.internodes) || !m_document.tree().isAlive(*m_chosen)))
        chooseNone();
    if (m_isShown && m_chosen) {
        m_panel.canvas().setOld(true);
        if (!m_timer.isActive())
            m_timer.start();
    }
}

void ProfileController::work()
{
    if (m_isWorking || !m_isShown || !m_chosen || isUpToDate())
        return;
    m_isWorking = true;
    runInBackground(
        this,
        [tree = m_document.tree(), last = m_layouts] {
            return leavingOneThread([&] {
                const TreeIndex index(tree);
                return std::make_shared<const StrandLayouts>(tree, index, Widths(tree, index), last.get());
            });
        },
        [this, stamp = m_stamp](std::shared_ptr<const StrandLayouts> layouts) {
            m_isWorking = false;
            if (stamp == m_stamp) {
                m_layouts = std::move(layouts);
                m_layoutsStamp = stamp;
                show(false);
            } else if (!m_timer.isActive()) {
                m_timer.start();
            }
        });
}

std::optional<std::uint32_t> ProfileController::nodeOfChosen() const
{
    if (!m_chosen || !m_layouts)
        return {};
    const std::vector<StrandNode>& nodes = m_layouts->skeleton().nodes;
    // Nodes ascend by their internodes.
    for (auto i = std::ranges::lower_bound(nodes, *m_chosen, {}, &StrandNode::internode);
         i != nodes.end() && i->internode == *m_chosen; ++i) {
        if (i->along == 1.0F)
            return static_cast<std::uint32_t>(i - nodes.begin());
    }
    return {};
}

void ProfileController::show(bool isOther)
{
    m_repaint();
    const std::optional<std::uint32_t> node = nodeOfChosen();
    if (!node)
        return;
    const float profileScale = m_layouts->profileScale(*node);
    const std::uint32_t strands = m_layouts->strandCount(*node);
    const float scale = profileScale > 0.0F ? profileScale : bundleRadius(strands);
    ProfileSection section;
    section.strandRadius = 1.0F / scale;
    for (std::uint32_t i = 0; i < strands; ++i)
        section.places.push_back(m_layouts->place(*node, i) / scale);
    section.branch = branchesOf(m_layouts->skeleton(), *node);
    const StrandProfile* const profile = m_document.tree().profileOf(*m_chosen);
    m_panel.canvas().showSection(section, profile ? *profile : StrandProfile(), isOther);
    m_panel.canvas().setOld(!isUpToDate());
    m_panel.describe(double{m_layouts->skeleton().nodes[*node].radius}, strands, profile != nullptr);
}

std::optional<ShownSection> ProfileController::section() const
{
    const std::optional<std::uint32_t> node = nodeOfChosen();
    if (!node)
        return {};
    const StrandNode& n = m_layouts->skeleton().nodes[*node];
    ShownSection section{
        .centre = m_layouts->centre(*node), .frame = n.frame, .radius = n.radius, .outline = {}};
    const StrandProfile* const profile = m_document.tree().profileOf(*m_chosen);
    const float scale = m_layouts->profileScale(*node);
    if (profile == nullptr || scale == 0.0F)
        return section;
    for (const StrandProfile::Loop& loop : profile->boundaries) {
        std::vector<Vec3>& line = section.outline.emplace_back();
        for (std::size_t i = 0; i <= loop.size(); ++i)
            line.push_back(m_layouts->world(*node, scale * loop[i % loop.size()]));
    }
    return section;
}

void ProfileController::choose(InternodeId id)
{
    if (!m_document.tree().isAlive(id))
        return;
    if (m_spanStart) {
        doSpan(id);
        return;
    }
    const bool isOther = m_chosen != id;
    m_chosen = id;
    if (isOther)
        m_panel.canvas().clear();
    show(isOther);
    work();
}

void ProfileController::chooseNone()
{
    m_spanStart.reset();
    m_chosen.reset();
    m_panel.setSpan(ProfilePanel::Span::None);
    m_panel.showNothing();
    m_repaint();
}

bool ProfileController::cancel()
{
    if (m_panel.canvas().cancelStroke())
        return true;
    if (!m_spanStart)
        return false;
    m_spanStart.reset();
    m_panel.setSpan(ProfilePanel::Span::None);
    return true;
}

std::vector<InternodeId> ProfileController::stretchOfChosen(float most) const
{
    std::vector<InternodeId> stretch{*m_chosen};
    const std::optional<std::uint32_t> chosen = nodeOfChosen();
    if (!chosen)
        return stretch;
    const StrandSkeleton& skeleton = m_layouts->skeleton();
    const auto profileAt = [&](InternodeId id) { return m_document.tree().content().sparse.profile.at(id); };
    const auto profile = profileAt(*m_chosen);
    // Adds the node that follows, at so many metres from the chosen one; false if the stretch ends before it.
    const auto add = [&](std::uint32_t node, float path) {
        const StrandNode& n = skeleton.nodes[node];
        if (n.along < 1.0F || 2 * n.strands < skeleton.nodes[*chosen].strands ||
            n.strands > 2 * skeleton.nodes[*chosen].strands)
            return false;
        if (profileAt(n.internode) != profile || path > most)
            return false;
        stretch.push_back(n.internode);
        return true;
    };
    const auto lengthTo = [&](std::uint32_t node) {
        return (skeleton.nodes[node].position - skeleton.nodes[skeleton.nodes[node].parent].position).norm();
    };
    float path = 0.0F;
    for (std::uint32_t node = *chosen; !skeleton.isBase(node);) {
        path += lengthTo(node);
        node = skeleton.nodes[node].parent;
        if (!add(node, path))
            break;
    }
    path = 0.0F;
    for (std::uint32_t node = *chosen; skeleton.nodes[node].childCount > 0;) {
        node = *std::ranges::max_element(skeleton.childrenOf(node), {},
                                         [&](std::uint32_t child) { return skeleton.nodes[child].strands; });
        path += lengthTo(node);
        if (!add(node, path))
            break;
    }
    return stretch;
}

void ProfileController::tellRoom(bool hadRoom)
{
    if (!hadRoom)
        m_panel.tell(tr("There is no room for more profiles."), true);
}

void ProfileController::edit(const StrandProfile& profile)
{
    if (!m_chosen || m_isBusy())
        return;
    if (profile.boundaries.empty()) {
        clearProfiles(m_document, stretchOfChosen(std::numeric_limits<float>::max()));
    } else {
        const std::optional<std::uint32_t> node = nodeOfChosen();
        const float radius = node ? m_layouts->skeleton().nodes[*node].radius : 0.0F;
        tellRoom(setProfile(m_document, stretchOfChosen(kStretchRadii * radius), profile));
    }
    preview();
}

/// Shows the strands in the new profile before the layouts of the whole tree are made.
void ProfileController::preview()
{
    const std::optional<std::uint32_t> node = nodeOfChosen();
    const StrandProfile* const profile = m_chosen ? m_document.tree().profileOf(*m_chosen) : nullptr;
    if (!node || profile == nullptr) {
        show(false);
        return;
    }
    const std::uint32_t strands = m_layouts->strandCount(*node);
    std::vector<Vec2> before;
    for (std::uint32_t i = 0; i < strands; ++i)
        before.push_back(m_layouts->place(*node, i));
    const ProfileSlots slots = profileSlots(*profile, strands);
    std::vector<std::uint32_t> chosen(strands);
    assignSlots(before, slots.places, chosen);
    ProfileSection section;
    section.strandRadius = 1.0F / slots.scale;
    for (const std::uint32_t slot : chosen)
        section.places.push_back(slots.places[slot] / slots.scale);
    section.branch = branchesOf(m_layouts->skeleton(), *node);
    m_panel.canvas().showSection(section, *profile, false);
    m_panel.describe(double{m_layouts->skeleton().nodes[*node].radius}, strands, true);
}

void ProfileController::step(bool up)
{
    if (!m_chosen)
        return;
    const InternodeId next =
        up ? m_document.index().mainChild(*m_chosen) : m_document.tree().parent(*m_chosen);
    if (next == kNoInternode)
        return;
    m_chosen = next;
    m_panel.canvas().clear();
    show(true);
    work();
}

void ProfileController::ask(ProfilePanel::Span span)
{
    if (span == ProfilePanel::Span::None && m_spanStart && m_chosen && m_chosen != m_spanStart) {
        doSpan(*m_chosen);
        return;
    }
    if (span == ProfilePanel::Span::None || !m_chosen)
        m_spanStart.reset();
    else
        m_spanStart = m_chosen;
    m_panel.setSpan(m_spanStart ? span : ProfilePanel::Span::None);
}

void ProfileController::doSpan(InternodeId id)
{
    const InternodeId start = *m_spanStart;
    const ProfilePanel::Span span = m_panel.span();
    const Tree& tree = m_document.tree();
    m_spanStart.reset();
    m_panel.setSpan(ProfilePanel::Span::None);
    const std::vector<InternodeId> path = branchBetween(tree, start, id);
    const StrandProfile* const profile = tree.isAlive(start) ? tree.profileOf(start) : nullptr;
    if (path.empty() || profile == nullptr) {
        m_panel.tell(tr("The two places are not on one branch."), true);
    } else if (m_isBusy()) {
        return;
    } else if (span == ProfilePanel::Span::Copy) {
        // The command may move the kept profiles.
        tellRoom(setProfile(m_document, path, StrandProfile(*profile)));
    } else if (const StrandProfile* const other = tree.profileOf(id); other == nullptr) {
        m_panel.tell(tr("The other place has no profile to blend with."), true);
    } else {
        tellRoom(blendProfiles(m_document, start, id, StrandProfile(*profile), StrandProfile(*other)));
    }
    m_chosen = start;
    show(true);
    work();
}

} // namespace espalier
