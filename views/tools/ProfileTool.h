// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace espalier {

/// A cross-section of the tree in the world: what the tool shows of the chosen node.
struct ShownSection {
    Vec3 centre = Vec3::Zero();             ///< m
    Rotation frame = Rotation::Identity();  ///< +Y along the branch, X and Z in the section
    float radius = 0.01F;                   ///< m
    std::vector<std::vector<Vec3>> outline; ///< Closed lines of its profile, m; none without a profile
};

/// What the profile tool asks and tells.
class ProfileChoice {
public:
    virtual ~ProfileChoice() = default;
    /// The section of the chosen node; empty if none is chosen.
    virtual std::optional<ShownSection> section() const = 0;
    /// The user has tapped this internode's node.
    virtual void choose(InternodeId id) = 0;
    /// The user has tapped beside the tree.
    virtual void chooseNone() = 0;
};

/// Chooses the node whose cross-section the profile panel shows (Strands 2024 §5.3). A tap on a branch
/// chooses the node that is nearest to it; its section is drawn over the tree.
class ProfileTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(ProfileTool)

public:
    /// @p choice must outlive the tool.
    ProfileTool(ToolContext& context, ProfileChoice& choice) : Tool(context), m_choice(choice) {}

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override { cancel(); }
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    bool keyPressed(int key) override;

    bool isActive() const override { return m_isActive; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

private:
    void look(const PointerSample& sample);

    ProfileChoice& m_choice;
    bool m_isActive = false;
    std::optional<InternodeId> m_hovered; ///< The internode whose node is near the pointer
};

} // namespace espalier
