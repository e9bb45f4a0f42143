// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ReproduceController.h"

#include "commands/ReproduceTree.h"
#include "panels/ReproducePopOut.h"

namespace espalier {

ReproduceController::ReproduceController(TreeDocument& document, ViewSettings& settings,
                                         ReproducePopOut& popOut, std::function<bool()> isBusy,
                                         std::function<void(const QString&)> tell)
    : m_document(document),
      m_settings(settings),
      m_popOut(popOut),
      m_isBusy(std::move(isBusy)),
      m_tell(std::move(tell)),
      m_trial(document)
{
    connect(&popOut, &ReproducePopOut::otherAsked, this, &ReproduceController::vary);
    connect(&settings, &ViewSettings::changed, this, &ReproduceController::followSettings);
    connect(&document, &TreeDocument::changed, this, &ReproduceController::showState);
    expect(FigureStroke::Trunk, false);
    showState();
}

void ReproduceController::expect(FigureStroke due, bool isSecond)
{
    if (!isSecond)
        m_popOut.setHint(tr("Draw the new trunk, from its base to its tip."));
    else if (due == FigureStroke::Silhouette)
        m_popOut.setHint(tr("Now draw the silhouette of the crown around its tip."));
    else
        m_popOut.setHint(tr("Now draw the trunk, with its tip inside the silhouette."));
}

QString ReproduceController::take(TreeFigure figure)
{
    const Result<std::uint32_t> done = reproduceTree(m_document, std::move(figure));
    return done ? QString() : done.error().message;
}

void ReproduceController::refuse(const QString& why)
{
    m_tell(tr("%1.").arg(why.left(1).toUpper() + why.mid(1)));
}

void ReproduceController::vary()
{
    if (m_isBusy())
        return;
    // The same deviations a second time would only be larger.
    const double number = m_settings.values().variationNumber;
    if (number == m_triedNumber) {
        const bool isLast = m_trial.isLast();
        m_settings.set(&ViewValues::variationNumber, number < kMostVariations ? number + 1.0 : 1.0);
        if (isLast)
            return; // followSettings() has tried it
    }
    tryVariation();
}

void ReproduceController::tryVariation()
{
    const ViewValues& values = m_settings.values();
    m_triedNumber = values.variationNumber;
    m_triedAmount = values.variation;
    const Result<void> tried =
        m_trial.tryOut(static_cast<std::uint64_t>(values.variationNumber), values.variation);
    if (!tried)
        refuse(tried.error().message);
}

void ReproduceController::followSettings()
{
    const ViewValues& values = m_settings.values();
    const bool isOther = values.variationNumber != m_triedNumber || values.variation != m_triedAmount;
    if (isOther && m_trial.isLast() && !m_isBusy())
        tryVariation();
}

void ReproduceController::showState()
{
    m_popOut.setMayVary(m_document.index().livingCount() > 1);
}

} // namespace espalier
