// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

class QPushButton;

namespace espalier {

/// The controls of the pencil: what strokes do, and the depth of the drawing.
class SketchPopOut : public Bar {
    Q_OBJECT

public:
    explicit SketchPopOut(ViewSettings& settings, QWidget* parent = nullptr);

    /// @p mayGive: the tree is a drawing without depth; @p isGiven: it has just got one, which can be chosen
    /// anew.
    void setDepth(bool mayGive, bool isGiven);

Q_SIGNALS:
    void depthAsked();
    /// Another choice between depths is asked for.
    void otherDepthAsked();

private:
    QPushButton* m_give;
    QPushButton* m_other;
};

} // namespace espalier
