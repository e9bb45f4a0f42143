// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SketchController.h"

#include "model/sketch/FlatTree.h"
#include "panels/SketchPopOut.h"

namespace espalier {

SketchController::SketchController(TreeDocument& document, ViewSettings& settings, SketchPopOut& popOut,
                                   std::function<bool()> isBusy, std::function<void(const QString&)> tell)
    : m_document(document),
      m_settings(settings),
      m_popOut(popOut),
      m_isBusy(std::move(isBusy)),
      m_tell(std::move(tell)),
      m_trial(document)
{
    connect(&popOut, &SketchPopOut::depthAsked, this, [this] {
        m_seed = 1;
        giveDepth();
    });
    connect(&popOut, &SketchPopOut::otherDepthAsked, this, [this] {
        ++m_seed;
        giveDepth();
    });
    connect(&settings, &ViewSettings::changed, this, &SketchController::followSettings);
    connect(&document, &TreeDocument::changed, this, &SketchController::showState);
    showState();
}

DepthOptions SketchController::options() const
{
    const ViewValues& values = m_settings.values();
    return {.seed = m_seed,
            .secondTree = values.secondTree,
            .hullMagnification = values.depthHull,
            .lengthMagnification = values.depthLength,
            .angleMagnification = values.depthAngle};
}

void SketchController::refuse(const QString& why)
{
    m_tell(tr("%1.").arg(why.left(1).toUpper() + why.mid(1)));
}

void SketchController::giveDepth()
{
    if (m_isBusy())
        return;
    m_tried = options();
    if (const Result<void> given = m_trial.tryOut(m_tried); !given)
        refuse(given.error().message);
    showState();
}

void SketchController::followSettings()
{
    if (m_trial.isLast() && m_tried != options())
        giveDepth();
}

void SketchController::showState()
{
    const bool isGiven = m_trial.isLast();
    m_popOut.setDepth(!isGiven && m_document.index().livingCount() > 1 &&
                          isFlat(m_document.tree(), m_document.index()),
                      isGiven);
}

} // namespace espalier
