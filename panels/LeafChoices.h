// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/LeafSuggestions.h"
#include "panels/Bar.h"

#include <QImage>

#include <array>

class QGridLayout;

namespace espalier {

/// Ways to go on with the leaves that the user has placed, as pictures: a click takes one
/// (suggestive interface; Okabe 2005, 3.5).
class LeafChoices : public Bar {
    Q_OBJECT

public:
    static constexpr int kPicture = 112; ///< px, the edge of a picture

    explicit LeafChoices(QWidget* parent = nullptr);

    /// The picture of each engine, in the order of kLeafEngines; those without one are not offered.
    void offer(const std::array<QImage, kLeafEngines.size()>& pictures);
    /// Whether anything is offered.
    bool isOffering() const { return m_isOffering; }

Q_SIGNALS:
    void chosen(espalier::LeafEngine engine);
    /// What is offered, and with it the wanted size, has changed.
    void offerChanged();

private:
    QGridLayout* m_grid;
    std::array<QToolButton*, kLeafEngines.size()> m_buttons{};
    bool m_isOffering = false;
};

} // namespace espalier
