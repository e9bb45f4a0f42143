// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "panels/Bar.h"

class QLabel;
class QSpinBox;

namespace espalier {

/// Lets the tree grow on its own: for as long as a button is held, or for a number of steps. It only asks;
/// see its signals.
class GrowPopOut : public Bar {
    Q_OBJECT

public:
    GrowPopOut(const TreeDocument& document, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The button is down: at least one step, and more until holdEnds().
    void holdBegins();
    void holdEnds();
    void stepsAsked(int steps);

private:
    void showStep();

    const TreeDocument& m_document;
    QLabel* m_step;
    QSpinBox* m_count;
};

} // namespace espalier
