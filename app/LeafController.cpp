// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/LeafController.h"

#include "commands/PlaceLeaves.h"
#include "panels/LeafChoices.h"
#include "panels/LeafPicture.h"
#include "views/Viewport.h"

namespace espalier {

namespace {

/// ms; the pictures follow a camera that moves this often at most.
constexpr int kOfferInterval = 60;

} // namespace

LeafController::LeafController(TreeDocument& document, const Viewport& viewport, LeafChoices& choices,
                               std::function<bool()> isBusy)
    : m_document(document), m_viewport(viewport), m_choices(choices), m_isBusy(std::move(isBusy))
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(kOfferInterval);
    connect(&m_timer, &QTimer::timeout, this, &LeafController::offer);
    connect(&document, &TreeDocument::changed, this, &LeafController::follow);
    connect(&viewport, &Viewport::cameraChanged, this, [this] {
        if (m_choices.isOffering() && !m_timer.isActive())
            m_timer.start();
    });
    connect(&choices, &LeafChoices::chosen, this, &LeafController::take);
}

void LeafController::setShown(bool shown)
{
    m_isShown = shown;
    m_timer.start();
}

void LeafController::follow(const TreeChange& change)
{
    const LeafColumns& rows = m_document.tree().placedLeaves();
    const bool wasPlaced =
        change.delta && change.delta->bornLeaves.count > 0 && change.delta->born.count == 0;
    if (!wasPlaced) {
        m_place.reset();
    } else if (change.kind == TreeChange::Kind::Reverted || change.delta->bornLeaves.count == 1) {
        // The newest leaf that is left; after an arrangement, the place stays that of the user's own leaf.
        m_place.reset();
        for (LeafId row = rows.size(); row-- > 0 && !m_place;) {
            if (rows.death[row] == kNever)
                m_place = BranchPlace{rows.internode[row], rows.along[row]};
        }
    }
    if (m_isShown)
        m_timer.start();
}

void LeafController::offer()
{
    if (m_place && m_isBusy()) {
        m_timer.start();
        return;
    }
    std::array<QImage, kLeafEngines.size()> pictures;
    const Tree& tree = m_document.tree();
    if (m_isShown && m_place) {
        const LeafPictureStyle style{.right = m_viewport.mainCamera().right(),
                                     .up = m_viewport.mainCamera().up(),
                                     .edge = LeafChoices::kPicture,
                                     .pixelRatio = m_choices.devicePixelRatioF()};
        for (const LeafSuggestion& suggestion : suggestLeaves(tree, m_document.index(), *m_place))
            pictures[static_cast<std::size_t>(suggestion.engine)] =
                leafPicture(tree, m_document.index(), m_place->internode, suggestion.delta, style);
    }
    m_choices.offer(pictures);
}

void LeafController::take(LeafEngine engine)
{
    if (m_place && !m_isBusy())
        arrangeLeaves(m_document, engine, *m_place);
}

} // namespace espalier
