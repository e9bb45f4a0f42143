// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/InferDepth.h"
#include "model/settings/ViewSettings.h"

#include <QObject>

#include <functional>

namespace espalier {

class SketchPopOut;

/// Gives drawn trees depth when the pop-out asks for it, and again while its controls are changed.
class SketchController : public QObject {
    Q_OBJECT

public:
    /// @p isBusy: something else changes the document. All outlive the controller.
    SketchController(TreeDocument& document, ViewSettings& settings, SketchPopOut& popOut,
                     std::function<bool()> isBusy, std::function<void(const QString&)> tell);

    /// Says why a stroke, or depth, was refused; @p why has no full stop.
    void refuse(const QString& why);

private:
    void giveDepth();
    void followSettings();
    void showState();
    DepthOptions options() const;

    TreeDocument& m_document;
    ViewSettings& m_settings;
    SketchPopOut& m_popOut;
    std::function<bool()> m_isBusy;
    std::function<void(const QString&)> m_tell;
    DepthTrial m_trial;
    DepthOptions m_tried;
    std::uint64_t m_seed = 1;
};

} // namespace espalier
