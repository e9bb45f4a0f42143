// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandLayouts.h"
#include "panels/ProfilePanel.h"
#include "views/tools/ProfileTool.h"

#include <QTimer>

#include <functional>

namespace espalier {

/// Leads the profile panel and the profile tool: which node is chosen, its layout, and the commands. Layouts
/// of the strands are made on a worker thread from a snapshot; the last one is shown meanwhile. A layout of a
/// tree that has changed since is dropped.
class ProfileController : public QObject, public ProfileChoice {
    Q_OBJECT

public:
    /// @p isBusy: whether a gesture or growth is changing the document. @p repaint draws the tool again. All
    /// must outlive the controller.
    ProfileController(TreeDocument& document, ProfilePanel& panel, std::function<bool()> isBusy,
                      std::function<void()> repaint);

    /// While shown, layouts follow the tree.
    void setShown(bool shown);
    std::optional<InternodeId> chosen() const { return m_chosen; }
    /// Whether the layout of the tree as it is now is shown.
    bool isUpToDate() const { return m_layouts != nullptr && m_layoutsStamp == m_stamp; }

    /// Drops the sketch under way, or else ends the wait for the other end of a copy or blend; returns
    /// false if there is neither.
    bool cancel();

    // ProfileChoice
    std::optional<ShownSection> section() const override;
    void choose(InternodeId id) override;
    void chooseNone() override;

private:
    void follow(const TreeChange& change);
    void work();
    void show(bool isOther);
    void preview();
    std::optional<std::uint32_t> nodeOfChosen() const;
    /// The chosen node and those up and down from it that have the same profile as it, or none like it, up to
    /// @p most, m.
    std::vector<InternodeId> stretchOfChosen(float most) const;
    void edit(const StrandProfile& profile);
    /// @p hadRoom: whether the document had room for what was asked for.
    void tellRoom(bool hadRoom);
    void step(bool up);
    void ask(ProfilePanel::Span span);
    /// Copies or blends between the node at which the user asked for it and @p id.
    void doSpan(InternodeId id);

    TreeDocument& m_document;
    ProfilePanel& m_panel;
    std::function<bool()> m_isBusy;
    std::function<void()> m_repaint;
    std::optional<InternodeId> m_chosen;
    std::optional<InternodeId> m_spanStart;
    std::shared_ptr<const StrandLayouts> m_layouts;
    std::uint64_t m_layoutsStamp = 0;
    std::uint64_t m_stamp = 1; ///< Of the tree's state; grows with each change
    bool m_isWorking = false;
    bool m_isShown = false;
    QTimer m_timer;
};

} // namespace espalier
