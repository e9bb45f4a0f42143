// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/VaryTree.h"
#include "model/settings/ViewSettings.h"
#include "views/tools/ReproduceTool.h"

#include <QObject>

#include <functional>

namespace espalier {

class ReproducePopOut;

/// Gives the tree the figures that are drawn, and varies it when the pop-out asks for it, and again while
/// its controls are changed.
class ReproduceController : public QObject, public FigureTaking {
    Q_OBJECT

public:
    /// @p isBusy: something else changes the document. All outlive the controller.
    ReproduceController(TreeDocument& document, ViewSettings& settings, ReproducePopOut& popOut,
                        std::function<bool()> isBusy, std::function<void(const QString&)> tell);

    void expect(FigureStroke due, bool isSecond) override;
    QString take(TreeFigure figure) override;
    void refuse(const QString& why) override;

private:
    void vary();
    void tryVariation();
    void followSettings();
    void showState();

    TreeDocument& m_document;
    ViewSettings& m_settings;
    ReproducePopOut& m_popOut;
    std::function<bool()> m_isBusy;
    std::function<void(const QString&)> m_tell;
    VariationTrial m_trial;
    double m_triedNumber = 0.0; ///< ViewValues::variationNumber of the last trial, or 0
    double m_triedAmount = 0.0; ///< ViewValues::variation, likewise
};

} // namespace espalier
