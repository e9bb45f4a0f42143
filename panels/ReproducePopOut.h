// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"

class QLabel;
class QPushButton;

namespace espalier {

/// The controls of reproduction: which stroke is due, and variations of the tree.
class ReproducePopOut : public Bar {
    Q_OBJECT

public:
    explicit ReproducePopOut(ViewSettings& settings, QWidget* parent = nullptr);

    /// Shows what to draw next.
    void setHint(const QString& hint);
    /// @p may: there is a tree that can vary.
    void setMayVary(bool may);

Q_SIGNALS:
    /// Another variation is asked for.
    void otherAsked();

private:
    QLabel* m_hint;
    QPushButton* m_other;
};

} // namespace espalier
